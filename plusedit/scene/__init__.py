"""What is drawn, as data: no Qt, so that windows, pictures and tests see the same."""
