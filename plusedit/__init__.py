"""PlusEdit: free-form curves and surfaces shaped by control lines and control planes.

The library is `plusedit.geometry`; it needs numpy, and numba where it samples surfaces quickly, and
knows neither files nor windows.
"""

__version__ = "0.3.1"
