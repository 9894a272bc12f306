"""Isophotes: bands between lines along which the light falls at the same angle, pixel by pixel.

They do not depend on where the eye is. With 18 of them a band is five degrees wide.
"""

from plusedit.scene.overlays import Setting, overlay

isophotes = overlay(
    "isophotes",
    title="Isophotes",
    order=78,
    shortcut="F8",
    group="Surface analysis",
    stripes="isophotes",
    settings=(
        Setting("count", "Bands", 18.0, 1.0, 200.0),
        Setting("height", "Light above the ground, °", 50.0, 1.0, 90.0),
        Setting("bearing", "Light turned from x, °", 240.0, 1.0, 360.0),
    ),
)
