"""Help: what plus curves and surfaces are, and what mouse and keys do; keys as they are now."""

from collections.abc import Callable
from html import escape
from itertools import groupby
from pathlib import Path

from PySide6.QtWidgets import QDialog, QTextBrowser, QVBoxLayout, QWidget

from plusedit.app.actions import ActionTable
from plusedit.app.facts import ANCHOR, facts_page, follow

IDEA = """
<h2>What a plus curve is</h2>
<p>A Bézier or B-spline curve blends <i>points</i>. A plus curve blends <i>straight lines</i>:
each control line has a point P and a direction d, and over the parameter u it runs as
L(u) = P + s (u − x) d, where x is the parameter at which the line has the most to say.
The curve is the weighted mean of all lines, C(u) = Σ L(u) b(u).</p>
<p>The <b>magnitude s</b> says how much directions count. At s = 0 it is the classical curve of
the control points. As s grows the curve is drawn towards its control points and takes on the
directions of the lines; s*, marked on the slider, is where it comes closest to the points.
Beyond, it overshoots. The slider shows s in units of L, the length of the control polygon.</p>
<p>A direction that you have not touched is <b>automatic</b> (hollow grips): it follows the
neighboring points. Turn a grip and it is yours (solid); double-click the grip and it is automatic
again.</p>
<h2>What a plus surface is</h2>
<p>A plus surface blends <i>planes</i>. Each control plane has a point P and two directions: over
the parameters u and v it runs as L(u, v) = P + s ((u − x) d<sup>u</sup> + (v − y) d<sup>v</sup>).
In the views it is a small square with two grips: turn the yellow one to lead the surface along u,
the magenta one along v, or turn the whole plane by a ring of the gizmo that a selected plane
shows. Each direction can be open or closed: a sheet, a tube, a torus.</p>
<h2>What becomes of a mesh</h2>
<p>Each face of a polygon mesh is a control plane as well; blended by Gaussians over the parameters
they make one smooth surface. The <b>smoothness S</b> says how wide the Gaussians are, in radii of
the faces: ¼ shows the faces, 4 and more leaves large forms only. Select faces to move and turn
their planes, or to make the surface sharper or smoother there alone. A direction is automatic
while it is the face's own.</p>
"""

MOUSE = (
    ("Click", "Select a point, grip or curve; Shift adds, Alt goes through what lies below"),
    ("Drag a point", "Move it. Ctrl snaps to the grid, Shift keeps to the longer axis"),
    ("Drag a grip", "Turn the line. Ctrl snaps to 15°, Shift is a tenth as fast, Alt stretches"),
    ("Drag on empty ground", "Select by a box"),
    ("Double-click a grip", "Back to the automatic direction"),
    ("Type a number while dragging", "Set it exactly; Tab goes to the next, Enter accepts"),
    ("Escape or right click while dragging", "Everything as before"),
    ("Wheel", "Zoom at the pointer"),
    ("Middle drag, or Space and drag", "Pan"),
    ("Right click", "Menu of what is selected"),
    ("3D: middle drag, or Alt and drag", "Turn the view; Shift pans, Ctrl zooms"),
    ("3D: click an end of the axes in the corner", "Look from that side"),
    (
        "3D: drag a point",
        "Move it in the plane of the screen; X, Y, Z keep to an axis, with Shift "
        "to the plane across it",
    ),
    ("3D: drag an arrow or a ring", "Move along it, turn about it"),
    ("O while dragging a point", "Soft move: neighbors follow; the wheel, or [ and ], set how far"),
    ("Double-click an edge of a net", "Select that row of control planes"),
    (
        "Click on a selected mesh",
        "Select the face there, a control plane like any other; Shift or Ctrl adds, Escape goes "
        "back to the whole mesh. Delete leaves faces alone: Reset planes takes edits back",
    ),
    ("Drag a selected face", "Move it; on other faces Shift or Ctrl and drag selects by a box"),
    (
        "Parameters: click or drag a box",
        "Select faces of the mesh, which the other views show as control planes",
    ),
    (
        "Parameters: drag A, B, C or D",
        "Lay the corners of a pillow on other vertices; the mesh is laid out anew",
    ),
    ("Double-click the s slider", "Measure L anew and go back to s = L / 2"),
)


class HelpWindow(QDialog):
    """A page to read beside the work; it does not block the window."""

    def __init__(
        self, table: ActionTable, parent: QWidget | None, open_file: Callable[[Path], object]
    ) -> None:
        """`open_file` is for links to designs."""
        super().__init__(parent)
        self.setWindowTitle("PlusEdit help")
        self.page = QTextBrowser()
        self.page.setOpenLinks(False)
        self.page.anchorClicked.connect(lambda url: follow(url.toString(), open_file))
        self.page.setAccessibleName("help")
        self.page.document().setDocumentMargin(24)
        self.page.setHtml(page_of(table))
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.page)
        self.resize(620, 680)

    def show_facts(self) -> None:
        """Turn to what the paper says, and what is true."""
        self.page.scrollToAnchor(ANCHOR)


def page_of(table: ActionTable) -> str:
    """The whole help as HTML."""
    return f"{IDEA}<h2>Mouse</h2>{rows_of(MOUSE)}<h2>Keys</h2>{keys_of(table)}{facts_page()}"


def rows_of(rows: "tuple[tuple[str, str], ...] | list[tuple[str, str]]") -> str:
    """Two columns: what is done, and what comes of it."""
    lines = [
        f'<tr><td style="padding: 3px 24px 3px 0"><b>{escape(act)}</b></td>'
        f'<td style="padding: 3px 0">{escape(effect)}</td></tr>'
        for act, effect in rows
    ]
    return f'<table cellspacing="0">{"".join(lines)}</table>'


def keys_of(table: ActionTable) -> str:
    """A table for each menu, of the actions that have a shortcut now."""
    entries = [entry for entry in table if table.keys_text(entry.name)]
    by_menu = sorted(entries, key=lambda entry: entry.menu.split("/")[0])
    parts = []
    for menu, members in groupby(by_menu, key=lambda entry: entry.menu.split("/")[0]):
        rows = [(table.keys_text(entry.name), entry.title.rstrip("…")) for entry in members]
        parts.append(f"<h3>{escape(menu or 'Elsewhere')}</h3>{rows_of(rows)}")
    return "".join(parts)
