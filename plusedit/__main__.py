"""`python -m plusedit`, `plusedit` and `plusedit-gui`."""
