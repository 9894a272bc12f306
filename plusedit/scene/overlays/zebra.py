"""Zebra stripes: the bands of a striped room in a mirror, pixel by pixel.

Where they break off the surface has an edge, where they bend sharply its curvature jumps. They
move with the eye.
"""

from plusedit.scene.overlays import Setting, overlay

zebra = overlay(
    "zebra",
    title="Zebra stripes",
    order=76,
    shortcut="F6",
    group="Surface analysis",
    stripes="zebra",
    settings=(Setting("count", "Stripes", 12.0, 1.0, 200.0),),
)
