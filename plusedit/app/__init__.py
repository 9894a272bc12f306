"""The program: window, menus, files, settings."""
