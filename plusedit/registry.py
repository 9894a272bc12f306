"""Shelves: packages in which every module is one entry and registers itself.

Adding a basis family, a tool, an overlay, a format or a panel is adding one file. A shelf holds
entries only; what they share lies beside it.
"""

import importlib
import pkgutil
from collections.abc import Callable, Iterator, Mapping
from typing import Generic, TypeVar

T = TypeVar("T")


class Registry(Mapping[str, T], Generic[T]):
    """The entries of one shelf by name, in the order of their names.

    The modules of `package` are imported at the first look, not before: importing the package
    itself costs nothing and can't run in a circle.
    """

    def __init__(self, package: str) -> None:
        self._package = package
        self._entries: dict[str, T] = {}
        self._is_filled = False

    def register(self, name: str) -> Callable[[T], T]:
        """A decorator that puts what it decorates on the shelf. ValueError if `name` is taken."""

        def put(entry: T) -> T:
            if name in self._entries:
                raise ValueError(f"{self._package}: the name {name!r} is taken")
            self._entries[name] = entry
            return entry

        return put

    def __getitem__(self, name: str) -> T:
        """The entry of that name. KeyError lists the names there are."""
        entries = self._filled()
        if name not in entries:
            raise KeyError(f"no {name!r} in {self._package}; there are: {', '.join(entries)}")
        return entries[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._filled())

    def __len__(self) -> int:
        return len(self._filled())

    def _filled(self) -> dict[str, T]:
        if not self._is_filled:
            package = importlib.import_module(self._package)
            for module in pkgutil.iter_modules(package.__path__):
                importlib.import_module(f"{self._package}.{module.name}")
            self._entries = dict(sorted(self._entries.items()))
            self._is_filled = True
        return self._entries
