"""The look of the whole program: a palette and a short style sheet made from a theme.

Fusion draws the controls; the style sheet only takes away frames within frames and sets
spacing on the 4 px grid. The drawing stays the brightest thing on the screen.
"""

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QFont, QGuiApplication, QPalette
from PySide6.QtWidgets import QApplication

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
    application.setPalette(palette_of(theme))
    application.setStyleSheet(style_sheet(theme))
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
    faint = QColor(theme.color("quiet"))
    faint.setAlpha(140)
    for each in (role.WindowText, role.Text, role.ButtonText):
        palette.setColor(group.Disabled, each, faint)
    return palette


def on_accent(theme: Theme) -> QColor:
    """The color of text on the accent: white on the dark accent, nearly black on the light one."""
    return QColor("#FFFFFF") if theme is LIGHT else QColor("#0E1420")


def tinted_accent(theme: Theme, strength: float) -> str:
    """The accent mixed into the panel color by `strength`, from 0 to 1, as "#rrggbb"."""
    accent, panel = QColor(theme.color("accent")), QColor(theme.color("panel"))
    channels = [
        round(a * strength + b * (1.0 - strength))
        for a, b in zip(accent.getRgb()[:3], panel.getRgb()[:3], strict=True)
    ]
    return QColor(*channels).name()


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
    colors["soft"] = tinted_accent(theme, 0.14)
    colors["softer"] = tinted_accent(theme, 0.08)
    colors["on_accent"] = on_accent(theme).name()
    sheet = SHEET
    for name, color in colors.items():
        sheet = sheet.replace(f"@{name};", f"{color};").replace(f"@{name} ", f"{color} ")
    return sheet


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
QMenu::indicator { width: 14px; height: 14px; margin-left: 8px; }
QToolBar { background: @window; border: none; border-bottom: 1px solid @border;
    padding: 4px 8px; spacing: 4px; }
QToolBar#magnitude { border-bottom: none; border-top: 1px solid @border; padding: 4px 12px; }
QToolBar::separator { background: @border; width: 1px; margin: 6px 4px; }
QToolButton { border: none; border-radius: 6px; padding: 4px; background: transparent; }
QToolButton:hover { background: @softer; }
QToolButton:checked { background: @soft; color: @accent; }
QToolButton:pressed { background: @soft; }
QToolButton:focus { background: @softer; }
QToolButton::menu-indicator { image: none; }
QDockWidget { font-weight: 600; }
QDockWidget::title { background: @window; padding: 8px 12px 4px 12px; text-align: left; }
QDockWidget > QWidget { background: @window; }
QStatusBar { background: @window; border-top: 1px solid @border; }
QStatusBar::item { border: none; }
QStatusBar QLabel, QLabel[quiet="true"] { color: @quiet; }
QLabel[wrong="true"] { color: @classical; }
QLabel[title="true"] { font-weight: 600; }
QLineEdit { background: @panel; border: 1px solid @border; border-radius: 4px;
    padding: 3px 6px; selection-background-color: @accent; selection-color: @on_accent; }
QLineEdit:hover { border-color: @quiet; }
QLineEdit:focus { border-color: @accent; }
QLineEdit:disabled { background: @window; color: @quiet; }
QLineEdit[wrong="true"] { border-color: @classical; }
QComboBox { background: @panel; border: 1px solid @border; border-radius: 4px;
    padding: 3px 8px; min-height: 18px; }
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
QTreeView::item:selected, QListView::item:selected, QTableView::item:selected {
    background: @soft; color: @text; }
QTreeView::item:hover, QListView::item:hover { background: @softer; }
QTableView { gridline-color: @window; }
QTableView QLineEdit, QTreeView QLineEdit { border-radius: 0; padding: 0 2px; }
QHeaderView { background: @panel; }
QHeaderView::section { background: @panel; color: @quiet; border: none;
    border-bottom: 1px solid @border; padding: 4px 6px; }
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
QToolTip { background: @panel; color: @text; border: 1px solid @border; padding: 4px 8px; }
QFrame[rule="true"] { background: @border; border: none; max-height: 1px; min-height: 1px; }
QWidget[panel="true"] { background: @panel; border-top: 1px solid @border; }
QWidget[card="true"] { background: @panel; border: 1px solid @border; border-radius: 8px; }
QWidget[card="true"]:hover { border-color: @accent; }
QWidget[card="true"]:focus { border-color: @accent; }
QWidget[note="true"] { background: @soft; border-bottom: 1px solid @border; }
"""
