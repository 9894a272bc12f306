"""Edits of every kind, by the label that undo says."""

import numpy as np

from plusedit.commands.base import Together
from plusedit.commands.bearing import SetBearing
from plusedit.commands.curves import (
    ChangeFamily,
    ChangeOrder,
    CloseSmoothly,
    MakeTangent,
    PassThrough,
    SetBasisField,
    SetClosed,
    SetMagnitude,
    SetView,
)
from plusedit.commands.lines import (
    MovePoints,
    ResetDirections,
    ReverseDirections,
    Rotate,
    ScaleDirections,
    SetAngle,
    SetCoordinate,
    SetDirection,
    SetLength,
    SetWeight,
    SoftMove,
    Transform,
    Turn,
)
from plusedit.commands.multiples import Multiply
from plusedit.commands.pulling import Pull
from plusedit.commands.shapes import (
    AddShapes,
    AppendLine,
    DeleteLines,
    DeleteShapes,
    Duplicate,
    InsertLine,
    Rename,
    Reorder,
    ReverseCurves,
    SetLocked,
    SetStyle,
    SetVisible,
)
from plusedit.commands.surfaces import (
    Balance,
    ChangeFamilyOf,
    ChangeOrderOf,
    DeletePlanes,
    ExtractBoundary,
    ExtractCurve,
    InsertRow,
    PassThroughSurface,
    ReverseWay,
    SetBasisFieldOf,
    SetClosedOf,
    TangentCorners,
    TangentToCornerPlanes,
    Transpose,
)
from plusedit.document.shape import Style
from tests.commands.known import A, B, known

LINES = {A: (1, 2)}
BY = np.array([0.5, -0.25])
QUARTER = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])

EDITS = {
    "Move 2 control lines": MovePoints(LINES, BY),
    "Softly move 2 control lines": SoftMove(LINES, BY, 2.0),
    "Set x of 2 control lines": SetCoordinate(LINES, 0, 3.0),
    "Set weight of 2 control lines": SetWeight(LINES, 2.0),
    "Mirror 2 control lines": Transform(LINES, np.diag([-1.0, 1.0]), np.zeros(2), "Mirror"),
    "Rotate 2 control lines": Turn(LINES, 0.5),
    "Rotate control line": Rotate({A: (2,)}, QUARTER),
    "Stretch 2 control lines": ScaleDirections(LINES, 2.0),
    "Set direction": SetDirection(A, 1, np.array([1.0, 0.5])),
    "Set angle of 2 control lines": SetAngle(LINES, 0.5),
    "Set length of 2 control lines": SetLength(LINES, 0.5),
    "Reverse 2 control lines": ReverseDirections(LINES),
    "Reset control line": ResetDirections({A: (2,)}),
    "Delete 2 control lines": DeleteLines(LINES),
    "Delete shape": DeleteShapes((A,)),
    "Duplicate shape": Duplicate((A,), BY),
    "Small multiples of shape": Multiply((A,)),
    "Set style of shape": SetStyle((A,), Style("#ff0000")),
    "Insert control line": InsertLine(A, 0.4),
    "Add control line": AppendLine(A, True, np.array([6.0, 1.0])),
    "Reverse curve": ReverseCurves((A,)),
    "Set s": SetMagnitude({A: 3.0}),
    "Change family of curve": ChangeFamily((A,), "rag"),
    "Change order of curve": ChangeOrder((A,), 3),
    "Close curve": SetClosed((A,), True),
    "Set knots of curve": SetBasisField((A,), "knots", [0, 0, 0, 0, 0.3, 0.6, 1, 1, 1, 1]),
    "Smoothly close curve": CloseSmoothly((A,)),
    "Make ends tangent of curve": MakeTangent((A,)),
    "Pass through the points of curve": PassThrough((A,)),
    "Pull curve": Pull(A, (0.4,), np.array([1.0, 2.0, 0.0])),
}
"""Each acts on the shape A, a curve, alone and changes it."""

PLANES = {A: (6, 7)}
ROW = {A: (5, 6, 7, 8, 9)}
TILT = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
LIFT = np.array([0.5, -0.25, 1.0])

SURFACE_EDITS = {
    "Move 2 control planes": MovePoints(PLANES, LIFT),
    "Softly move control plane": SoftMove({A: (7,)}, LIFT, 1.5),
    "Set z of 2 control planes": SetCoordinate(PLANES, 2, 3.0),
    "Set weight of 2 control planes": SetWeight(PLANES, 2.0),
    "Mirror 2 control planes": Transform(PLANES, np.diag([-1.0, 1.0, 1.0]), np.zeros(3), "Mirror"),
    "Turn 20 control planes": Transform({A: tuple(range(20))}, TILT, LIFT, "Turn"),
    "Rotate 2 control planes": Rotate(PLANES, TILT),
    "Rotate control plane": Turn({A: (6,)}, 0.5, (0, 2)),
    "Stretch 2 control planes": ScaleDirections(PLANES, 2.0, "v"),
    "Set direction": SetDirection(A, 6, LIFT, "u"),
    "Reset direction": SetDirection(A, 7, None, "v"),
    "Set angle of 2 control planes": SetAngle(PLANES, 0.5, (1, 2)),
    "Set azimuth of 2 control planes": SetBearing(PLANES, azimuth=0.5),
    "Set length of 2 control planes": SetLength(PLANES, 0.5),
    "Reverse 2 control planes": ReverseDirections(PLANES),
    "Reset control plane": ResetDirections({A: (7,)}),
    "Delete row": DeleteLines(ROW),
    "Delete column": DeletePlanes({A: (1, 6, 11, 16)}),
    "Delete row and column": DeletePlanes({A: (*range(6), 10, 15)}),
    "Insert row": InsertRow(A, "u", 0.4),
    "Insert column": InsertRow(A, "v", 0.4),
    "Delete shape": DeleteShapes((A,)),
    "Duplicate shape": Duplicate((A,), LIFT),
    "Small multiples of shape": Multiply((A,)),
    "Set style of shape": SetStyle((A,), Style("#ff0000")),
    "Set s": SetMagnitude({A: 3.0}),
    "Transpose surface": Transpose((A,)),
    "Reverse u of surface": ReverseWay((A,), "u"),
    "Reverse v of surface": ReverseWay((A,), "v"),
    "Change family along u of surface": ChangeFamilyOf((A,), "u", "rag"),
    "Change order along v of surface": ChangeOrderOf((A,), "v", 3),
    "Close surface along u": SetClosedOf((A,), "u", True),
    "Set knots along v of surface": SetBasisFieldOf((A,), "v", "knots", [0] * 4 + [0.3] + [1] * 4),
    "Make corners tangent of surface": TangentCorners((A,)),
    "Touch corner planes of surface": TangentToCornerPlanes((A,)),
    "Pass through the points of surface": PassThroughSurface((A,)),
    "Pull surface": Pull(A, (0.4, 0.7), np.array([1.0, 2.0, 0.5]), "both"),
    "Balance u and v of surface": Balance((A,)),
    "Extract curve of constant u": ExtractCurve(A, "u", 0.25),
    "Extract edges of surface": ExtractBoundary((A,)),
}
"""Each acts on the shape A, a surface, alone, or makes others of it."""

OTHERS = {
    "Add shape": AddShapes((("new", known()[B]),)),
    "Draw curve": AddShapes((("new", known()[B]),), "Draw curve"),
    "Rename to Bow": Rename(A, "Bow"),
    "Hide shape": SetVisible((A,), False),
    "Lock shape": SetLocked((A,), True),
    "Reorder shapes": Reorder((B, A)),
    "Change view": SetView({"grid": False}),
    "Both": Together("Both", (MovePoints(LINES, BY), DeleteLines({A: (0,)}))),
}
"""Those that a locked shape need not refuse, or that act on more."""
