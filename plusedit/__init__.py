"""PlusEdit: free-form curves shaped by control lines, as an editor and as a library.

The library is `plusedit.geometry`; it needs numpy alone and knows neither files nor windows.
"""

__version__ = "0.1.0"
