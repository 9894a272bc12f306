"""Items drawn with OpenGL 3.3 core, in whatever context is current."""
