"""Polygon meshes and the smooth surfaces that their faces span.

A mesh as it was read is cleaned and parted (`repair`), given parameters (`maps`), and becomes a
RaG+ surface: every face is a control plane. Words of these modules: a *corner* is one place of a
vertex in one face, numbered face after face; a *half-edge* is the side of a face that leaves a
corner.
"""
