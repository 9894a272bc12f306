"""The shelf of overlays: what can be drawn about a shape besides the shape itself."""
