"""What overlays draw of meshes and takes a while: found beside, and kept with the surface.

Windows never wait for it: until it is found they draw what was known before the last change.
"""

from weakref import WeakKeyDictionary

from plusedit.geometry.mesh.foundation import Foundation
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.scene.overlays import Numbers, Overlay

Key = tuple[str, tuple[float, ...]]

_FOUND: "WeakKeyDictionary[MeshSurface, dict[Key, object]]" = WeakKeyDictionary()
_LATEST: "WeakKeyDictionary[Foundation, dict[str, object]]" = WeakKeyDictionary()


def findings(entry: Overlay, surface: MeshSurface, numbers: Numbers) -> object:
    """What the overlay needs to know of that surface, found if need be; in whatever thread."""
    kept, key = _FOUND.setdefault(surface, {}), _key(entry, numbers)
    if key not in kept:
        found = entry.find_of_mesh(surface, numbers)
        kept[key] = _LATEST.setdefault(surface.foundation, {})[entry.name] = found
    return kept[key]


def has_findings(entry: Overlay, surface: MeshSurface, numbers: Numbers) -> bool:
    """Whether that is known of just that surface."""
    return _key(entry, numbers) in _FOUND.get(surface, {})


def known_findings(entry: Overlay, surface: MeshSurface, numbers: Numbers) -> object:
    """The same, or that before the last change; None while there is neither."""
    kept = _FOUND.get(surface, {}).get(_key(entry, numbers))
    return _LATEST.get(surface.foundation, {}).get(entry.name) if kept is None else kept


def _key(entry: Overlay, numbers: Numbers) -> Key:
    return entry.name, tuple(numbers[name] for name in entry.finds_by)
