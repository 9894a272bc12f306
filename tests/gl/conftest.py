"""OpenGL to draw with, on a real display."""

import pytest

from plusedit.views.gl.context import context_for_pictures
from plusedit.views.gl.functions import Functions
from tests.gl.easel import Easel


@pytest.fixture
def gl(qapp):
    """The functions of a context that is current."""
    with context_for_pictures() as functions:
        yield functions


@pytest.fixture
def alive(monkeypatch):
    """The objects on the card that were made and not freed, by kind and name."""
    there = set()
    make, free = Functions.made, Functions.delete

    def made(self, kind):
        name = make(self, kind)
        there.add((kind, name))
        return name

    def delete(self, kind, name):
        there.remove((kind, name))
        free(self, kind, name)

    monkeypatch.setattr(Functions, "made", made)
    monkeypatch.setattr(Functions, "delete", delete)
    return there


@pytest.fixture
def easel(gl):
    """An artist and a picture; no error of OpenGL may be left when it is put away."""
    made = Easel(gl)
    yield made
    made.put_away()
