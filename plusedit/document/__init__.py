"""The design as data: immutable designs, what is selected, the history, the session."""
