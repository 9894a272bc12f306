"""Reflection lines: straight lamps along the x axis of the world in a mirror, pixel by pixel.

They stay where they are while the eye moves, so they flow over the surface as over a car that one
walks around.
"""

from plusedit.scene.overlays import Setting, overlay

reflections = overlay(
    "reflections",
    title="Reflection lines",
    order=77,
    shortcut="F7",
    group="Surface analysis",
    stripes="reflection",
    settings=(Setting("count", "Lines", 18.0, 1.0, 200.0),),
)
