"""Makes the small pictures of the examples: run `python assets/make_pictures.py` with a display.

The start page shows them. Drawn there and then, those of large meshes would keep it waiting.
"""

from dataclasses import replace

from plusedit.app.main import make_application
from plusedit.app.start_page import PICTURE
from plusedit.app.thumbnails import without_words
from plusedit.document.design import Design
from plusedit.io.files import load
from plusedit.resources import example_files, picture_of_example
from plusedit.scene.options import options_of, view_tree
from plusedit.scene.overlays import overlays
from plusedit.scene.theme import THEMES
from plusedit.views.opengl import opengl_problem
from plusedit.views.picture import image_of
from plusedit.views.space_picture import space_image_of

# Twice what the start page has on a usual screen, so that lines are finer, and sharp on fine ones.
SIZE = (2 * PICTURE.width(), 2 * PICTURE.height())


def main() -> None:
    """Write one picture for each example and theme, in place of those that are there."""
    _application = make_application(["make_pictures"])
    if opengl_problem():
        raise SystemExit(opengl_problem())
    for path in example_files():
        design = without_words(load(path).design)
        if design.is_spatial:
            design = bare(design)
        for name, theme in THEMES.items():
            draw = space_image_of if design.is_spatial else image_of
            image = draw(design, SIZE, theme, transparent=True)
            target = picture_of_example(path, name)
            target.parent.mkdir(exist_ok=True)
            image.save(str(target))
            print(target.name)


def bare(design: Design) -> Design:
    """The design with nothing but its shapes, and colors where they are the point of it."""
    own = options_of(design.view)
    colored = frozenset(name for name in own.overlays if name in overlays and overlays[name].colors)
    shown = replace(own, overlays=colored, handles="none", isolines=False, ground=False)
    return replace(design, view=view_tree(shown, old=design.view))


if __name__ == "__main__":
    main()
