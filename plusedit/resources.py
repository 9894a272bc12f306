"""Where the files that ship with the program lie: icons and examples."""

from functools import cache
from pathlib import Path


@cache
def assets() -> Path:
    """The folder of icons and examples: inside an installed package, else in the source tree."""
    package = Path(__file__).parent
    installed = package / "assets"
    return installed if installed.is_dir() else package.parent / "assets"


def icon_file(name: str) -> Path:
    """The SVG file of the icon of that name; it need not exist."""
    return assets() / "icons" / f"{name}.svg"


def example_files() -> list[Path]:
    """The shipped designs, in the order of their names."""
    return sorted((assets() / "examples").glob("*.json"))


def picture_of_example(path: Path, theme: str) -> Path:
    """The small picture of a shipped design in the theme of that name; it need not exist."""
    return path.parent / "pictures" / f"{path.stem}_{theme}.png"


def is_shipped(path: Path) -> bool:
    """Whether a file is one of those that ship with the program, which are not to be changed."""
    return assets().resolve() in path.resolve().parents
