"""Surfaces made: simple bodies, and surfaces from curves.

Every function gives back a plus surface whose control planes can be edited like any other's: their
directions run along the surface. Surfaces from curves reproduce those curves, with the s that the
curves have; plane curves lie in z = 0.
"""
