"""Files: formats, and saving that never leaves half a file."""
