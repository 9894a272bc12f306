"""The shelf of docks."""
