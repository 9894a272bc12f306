"""Icons of one family, drawn in the color of the text, whatever the theme.

The files under assets/icons use `currentColor`; here it becomes a color of the palette. What
shows an icon is told its name by `set_icon`, so that `refresh_icons` can redraw all of them.
"""

from functools import lru_cache

from PySide6.QtCore import QByteArray, QObject, QRectF, Qt
from PySide6.QtGui import (
    QAction,
    QColor,
    QGuiApplication,
    QIcon,
    QImage,
    QPainter,
    QPalette,
    QPixmap,
)
from PySide6.QtWidgets import QAbstractButton

from plusedit.resources import icon_file

SIDE = 24  # logical pixels of the grid on which the icons are drawn
SHARPNESS = 3  # pixmaps are drawn for screens up to so many pixels per logical pixel
NAME = "icon_name"  # the property that remembers which icon a thing shows


def icon(name: str, *, checkable: bool = False) -> QIcon:
    """The icon of that name in the colors of the palette now; empty if there is no such file.

    One that is `checkable` takes the accent color while it is on.
    """
    source = _source(name)
    if not source:
        return QIcon()
    palette = QGuiApplication.palette()
    text = palette.color(QPalette.ColorRole.WindowText)
    accent = palette.color(QPalette.ColorRole.Highlight)
    faint = palette.color(QPalette.ColorGroup.Disabled, QPalette.ColorRole.WindowText)
    result = QIcon()
    colors = [(QIcon.Mode.Normal, QIcon.State.Off, text)]
    if checkable:
        colors.append((QIcon.Mode.Normal, QIcon.State.On, accent))
    else:
        colors.append((QIcon.Mode.Disabled, QIcon.State.Off, faint))
    for mode, state, color in colors:
        result.addPixmap(QPixmap.fromImage(_image(source, color.name())), mode, state)
    return result


def set_icon(target: QAction | QAbstractButton, name: str) -> None:
    """Show that icon on `target`, now and after a change of theme."""
    target.setProperty(NAME, name)
    target.setIcon(icon(name, checkable=target.isCheckable()))


def refresh_icons(root: QObject) -> None:
    """Draw the icons of everything below `root` in the colors of the palette now."""
    targets: list[QAction | QAbstractButton] = [*root.findChildren(QAction)]
    targets += root.findChildren(QAbstractButton)
    for target in targets:
        if name := target.property(NAME):
            target.setIcon(icon(name, checkable=target.isCheckable()))


def tinted(name: str, color: QColor, side: int = 16) -> QPixmap:
    """The icon in one color, `side` logical pixels wide; empty if there is no such file."""
    source = _source(name)
    return QPixmap.fromImage(_image(source, color.name(), side)) if source else QPixmap()


@lru_cache(maxsize=256)
def _source(name: str) -> str:
    try:
        return icon_file(name).read_text(encoding="utf-8")
    except OSError:
        return ""


@lru_cache(maxsize=512)
def _image(source: str, color: str, side: int = SIDE) -> QImage:
    # An image, not a pixmap: what is cached outlives the application, and pixmaps may not.
    from PySide6.QtSvg import QSvgRenderer  # loaded with the first icon, not with the program

    renderer = QSvgRenderer(QByteArray(source.replace("currentColor", color).encode()))
    image = QImage(side * SHARPNESS, side * SHARPNESS, QImage.Format.Format_ARGB32_Premultiplied)
    image.fill(Qt.GlobalColor.transparent)
    painter = QPainter(image)
    renderer.render(painter, QRectF(image.rect()))
    painter.end()
    image.setDevicePixelRatio(SHARPNESS)
    return image
