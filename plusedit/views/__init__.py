"""Qt from here on: canvases and docks."""
