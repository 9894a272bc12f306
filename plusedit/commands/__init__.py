"""Edits as values: pure functions from design to design, each with a name for the Undo menu."""
