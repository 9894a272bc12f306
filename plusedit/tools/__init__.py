"""The shelf of tools: each module here is one, and registers itself with `tools.register`."""
