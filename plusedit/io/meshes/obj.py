"""Wavefront OBJ: text with polygons, texture coordinates by corner, and groups."""

from plusedit.io.fields import within
from plusedit.io.mesh_cleaning import cleaned
from plusedit.io.mesh_file import MeshFile
from plusedit.io.mesh_text import plain_text, without_comments
from plusedit.io.mesh_words import blocks
from plusedit.io.meshes import register
from plusedit.io.obj_reading import ObjReading


class WavefrontObj:
    """Faces as they stand; lines, points and free-form curves are left out."""

    title = "Wavefront OBJ"
    suffixes = (".obj",)

    def read(self, data: bytes, name: str) -> MeshFile:
        """The polygons of all objects and groups together."""
        with within(name):
            text = without_comments(plain_text(data, "an OBJ file"))
            # A line goes on after a backslash; the tab stands for the line that is lost.
            text = text.replace(b"\\\n", b" \v") + b"\n"
            reading = ObjReading()
            for words in blocks(text):
                reading.add(words)
            read = reading.mesh()
            if len(read.sizes) and read.sizes[-1] < 3 and data[-1:] not in (b"\n", b"\r", b"\0"):
                read.notes.append("the last line is not ended: the file may be cut off")
            return cleaned(read)


register("obj")(WavefrontObj())
