"""The look of the whole program: a palette and a short style sheet made from a theme.

Fusion draws the controls; the style sheet only takes away frames within frames and sets
spacing on the 4 px grid. The drawing stays the brightest thing on the screen.
"""

import re
from pathlib import Path

from PySide6.QtCore import QStandardPaths, Qt
from PySide6.QtGui import QColor, QFont, QGuiApplication, QPalette
from PySide6.QtWidgets import QApplication

from plusedit.resources import icon_file
from plusedit.scene.theme import DARK, LIGHT, THEMES, Theme

SCHEMES = {
    "system": Qt.ColorScheme.Unknown,
    "light": Qt.ColorScheme.Light,
    "dark": Qt.ColorScheme.Dark,
}


def theme_for(look: str) -> Theme:
    """The theme that "light", "dark" or "system" stands for on this desktop now."""
    if look in THEMES:
        return THEMES[look]
    is_dark = QGuiApplication.styleHints().colorScheme() == Qt.ColorScheme.Dark
    return DARK if is_dark else LIGHT


def apply_look(application: QApplication, look: str) -> Theme:
    """Give the whole program that look; the theme that it came to."""
    QGuiApplication.styleHints().setColorScheme(SCHEMES[look])
    theme = theme_for(look)
    sheet = style_sheet(theme)
    if sheet != application.styleSheet():
        application.setPalette(palette_of(theme))
        application.setStyleSheet(sheet)
    return theme


def palette_of(theme: Theme) -> QPalette:
    """The colors of a theme in Qt's roles."""
    role, group = QPalette.ColorRole, QPalette.ColorGroup
    palette = QPalette()
    for name, roles in {
        "window": (role.Window, role.AlternateBase),
        "panel": (role.Base, role.Button, role.ToolTipBase, role.Light, role.Midlight),
        "border": (role.Mid, role.Dark),
        "text": (role.WindowText, role.Text, role.ButtonText, role.ToolTipText, role.BrightText),
        "quiet": (role.PlaceholderText,),
        "accent": (role.Highlight, role.Link, role.Accent),
    }.items():
        for each in roles:
            palette.setColor(each, QColor(theme.color(name)))
    palette.setColor(role.HighlightedText, on_accent(theme))
    palette.setColor(role.Shadow, QColor(0, 0, 0, 60))
    faint = mixed(theme.color("quiet"), theme.color("window"), 0.5)
    for each in (role.WindowText, role.Text, role.ButtonText):
        palette.setColor(group.Disabled, each, faint)
    return palette


def on_accent(theme: Theme) -> QColor:
    """The color of text on the accent: white on the dark accent, nearly black on the light one."""
    return QColor("#FFFFFF") if theme is LIGHT else QColor("#0E1420")


def mixed(color: str, ground: str, share: float) -> QColor:
    """`share` of one color, from 0 to 1, in another."""
    channels = [
        round(a * share + b * (1.0 - share))
        for a, b in zip(
            QColor(color).getRgb()[:3],  # type: ignore[index]
            QColor(ground).getRgb()[:3],  # type: ignore[index]
            strict=True,
        )
    ]
    return QColor(*channels)


def tinted_file(name: str, color: str) -> str:
    """The path of an icon in one color, for style sheets, which take colors from files only.

    Empty if there is no such icon or nowhere to write.
    """
    place = QStandardPaths.StandardLocation.GenericCacheLocation
    file = Path(QStandardPaths.writableLocation(place)) / "plusedit" / f"{name}-{color[1:]}.svg"
    try:
        source = icon_file(name).read_text(encoding="utf-8").replace("currentColor", color)
        if not file.exists() or file.read_text(encoding="utf-8") != source:
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(source, encoding="utf-8")
    except OSError:
        return ""
    return file.as_posix()


def tabular(font: QFont) -> QFont:
    """The same font with figures of one width, so that changing numbers stand still."""
    figures = QFont(font)
    # Qt before 6.7 has no features; figures of most interface fonts are tabular anyway.
    if hasattr(QFont, "Tag"):
        figures.setFeature(QFont.Tag("tnum"), 1)
    return figures


def style_sheet(theme: Theme) -> str:
    """The style sheet of the whole program in the colors of `theme`."""
    colors = {name: theme.color(name) for name in theme.colors}
    accent, panel = theme.color("accent"), theme.color("panel")
    colors["soft"] = mixed(accent, panel, 0.14).name()
    colors["softer"] = mixed(accent, panel, 0.08).name()
    colors["on_accent"] = on_accent(theme).name()
    colors["arrow"] = f'url("{tinted_file("down", theme.color("quiet"))}")'
    colors["check"] = f'url("{tinted_file("check", colors["on_accent"])}")'
    colors["dash"] = f'url("{tinted_file("dash", colors["on_accent"])}")'
    colors["tick"] = f'url("{tinted_file("check", theme.color("text"))}")'
    return re.sub(r"@([a-z_]+)", lambda match: colors[match[1]], SHEET)


SHEET = """
QMainWindow, QDialog { background: @window; }
QMainWindow::separator { background: @border; width: 1px; height: 1px; }
QMainWindow::separator:hover { background: @accent; }
QMenuBar { background: @window; border-bottom: 1px solid @border; padding: 2px 4px; }
QMenuBar::item { padding: 4px 8px; border-radius: 4px; background: transparent; }
QMenuBar::item:selected { background: @soft; color: @text; }
QMenu { background: @panel; border: 1px solid @border; padding: 4px; }
QMenu::item { padding: 4px 24px 4px 28px; border-radius: 4px; }
QMenu::item:selected { background: @soft; color: @text; }
QMenu::item:disabled { color: @quiet; }
QMenu::separator { height: 1px; background: @border; margin: 4px 8px; }
QMenu::icon { padding-left: 8px; }
QMenu::indicator { width: 16px; height: 16px; margin-left: 6px; }
QMenu::indicator:checked { image: @tick; }
QToolBar { background: @window; border: none; border-bottom: 1px solid @border;
    padding: 4px 8px; spacing: 4px; }
QToolBar#magnitude { border-bottom: none; border-top: 1px solid @border; }
QToolBar::separator { background: @border; width: 1px; margin: 6px 4px; }
QToolButton { border: none; border-radius: 6px; padding: 4px; background: transparent; }
QToolButton:hover { background: @softer; }
QToolButton:checked { background: @soft; color: @accent; }
QToolButton:pressed { background: @soft; }
QToolButton:focus { background: @softer; }
QToolButton::menu-indicator { image: none; }
QToolButton[field="true"] { background: @panel; border: 1px solid @border; border-radius: 4px;
    padding: 1px 6px; min-height: 16px; }
QToolButton[field="true"]:hover { border-color: @quiet; }
QToolButton[field="true"]:focus { border-color: @accent; }
QDockWidget { font-weight: 600; }
QDockWidget > QWidget { background: @window; }
QStatusBar { background: @window; border-top: 1px solid @border; }
QStatusBar::item { border: none; }
QStatusBar QLabel, QLabel[quiet="true"] { color: @quiet; }
QLabel[wrong="true"] { color: @classical; }
QLabel[title="true"] { font-weight: 600; }
QLabel[dock="true"] { font-weight: 600; padding: 8px 12px; }
QLineEdit { background: @panel; border: 1px solid @border; border-radius: 4px;
    padding: 2px 6px; min-height: 18px; selection-background-color: @accent;
    selection-color: @on_accent; }
QLineEdit:hover { border-color: @quiet; }
QLineEdit:focus { border-color: @accent; }
QLineEdit:disabled { background: @window; color: @quiet; }
QLineEdit[wrong="true"] { border-color: @classical; }
QComboBox { background: @panel; border: 1px solid @border; border-radius: 4px;
    padding: 2px 4px 2px 8px; min-height: 18px; }
QComboBox::drop-down { border: none; width: 20px; }
QComboBox::down-arrow { image: @arrow; width: 14px; height: 14px; }
QComboBox QAbstractItemView { background: @panel; border: 1px solid @border; padding: 4px;
    selection-background-color: @soft; selection-color: @text; outline: none; }
QCheckBox { spacing: 8px; }
QCheckBox::indicator, QTableView::indicator { width: 14px; height: 14px; border-radius: 4px;
    border: 1px solid @border; background: @panel; }
QCheckBox::indicator:hover, QTableView::indicator:hover { border-color: @quiet; }
QCheckBox::indicator:focus { border-color: @accent; }
QCheckBox::indicator:checked, QTableView::indicator:checked { background: @accent;
    border-color: @accent; image: @check; }
QCheckBox::indicator:indeterminate { background: @accent; border-color: @accent; image: @dash; }
QSpinBox { background: @panel; border: 1px solid @border; border-radius: 4px;
    padding: 2px 6px; min-height: 18px; }
QSpinBox:focus { border-color: @accent; }
QSpinBox::up-button, QSpinBox::down-button { width: 0; border: none; }
QComboBox:hover { border-color: @quiet; }
QComboBox:focus { border-color: @accent; }
QComboBox:disabled { background: @window; color: @quiet; }
QPushButton { background: @panel; border: 1px solid @border; border-radius: 6px;
    padding: 5px 16px; }
QPushButton:hover { border-color: @quiet; background: @softer; }
QPushButton:focus { border-color: @accent; }
QPushButton:pressed { background: @soft; }
QPushButton:disabled { color: @quiet; background: @window; }
QPushButton:default, QPushButton[primary="true"] { background: @accent; border-color: @accent;
    color: @on_accent; font-weight: 600; }
QPushButton[link="true"] { border: none; background: transparent; padding: 2px 4px;
    text-align: left; color: @accent; }
QPushButton[link="true"]:hover { text-decoration: underline; }
QTreeView, QTableView, QListView, QTextBrowser { background: @panel; border: none;
    outline: none; selection-background-color: @soft; selection-color: @text; }
QDockWidget QTreeView, QDockWidget QTableView { border-top: 1px solid @border; }
QTreeView::item { min-height: 26px; }
QTreeView::item:hover, QListView::item:hover { background: @softer; }
QTreeView::item:selected, QListView::item:selected, QTableView::item:selected {
    background: @soft; color: @text; }
QTableView { gridline-color: @window; }
QTableView QLineEdit, QTreeView QLineEdit, QListView QLineEdit { border-radius: 2px;
    padding: 0 2px; min-height: 0; }
QTableView::item { padding: 0 6px; }
QHeaderView { background: @panel; }
QHeaderView::section { background: @panel; color: @quiet; border: none;
    border-bottom: 1px solid @border; padding: 4px 6px; }
QTableView[dense="true"]::item { padding: 0; }
QTableView[dense="true"] QHeaderView::section:horizontal { padding: 4px 2px; }
QScrollArea { border: none; background: transparent; }
QScrollBar:vertical { background: transparent; width: 10px; margin: 0; }
QScrollBar:horizontal { background: transparent; height: 10px; margin: 0; }
QScrollBar::handle { background: @border; border-radius: 3px; margin: 2px;
    min-height: 24px; min-width: 24px; }
QScrollBar::handle:hover { background: @quiet; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QTabBar::tab { padding: 6px 12px; color: @quiet; border: none; background: transparent; }
QTabBar::tab:selected { color: @text; border-bottom: 2px solid @accent; }
QTabWidget::pane { border: none; border-top: 1px solid @border; }
QDialogButtonBox, QMessageBox { dialogbuttonbox-buttons-have-icons: 0; }
QWidget[framed="true"] { background: @panel; border: 1px solid @border; border-radius: 8px; }
QAbstractScrollArea::corner { background: transparent; border: none; }
QToolTip { background: @panel; color: @text; border: 1px solid @border; padding: 4px 8px; }
QFrame[rule="true"] { background: @border; border: none; max-height: 1px; min-height: 1px; }
QWidget[panel="true"] { background: @panel; border-top: 1px solid @border; }
QWidget[card="true"] { background: @panel; border: 1px solid @border; border-radius: 8px; }
QWidget[card="true"]:hover { border-color: @accent; }
QWidget[card="true"]:focus { border-color: @accent; }
QWidget[note="true"] { background: @soft; border-bottom: 1px solid @border; }
"""
