"""Fixtures for all tests."""

import os
import tempfile

import pytest
from hypothesis import HealthCheck, settings

from plusedit.document.session import Session
from plusedit.tools.pull import PullShape
from tests.designs import DOCUMENT, a_design

# A slow or busy machine is no failure, and the same examples every time make failures repeatable.
settings.register_profile(
    "plusedit",
    deadline=None,
    derandomize=True,
    max_examples=25,
    database=None,
    suppress_health_check=[HealthCheck.too_slow],
)
settings.load_profile("plusedit")

# Nothing that a person has set or kept is read or written by tests.
HOME = tempfile.TemporaryDirectory(prefix="plusedit-tests-", ignore_cleanup_errors=True)
os.environ["XDG_STATE_HOME"] = f"{HOME.name}/state"
os.environ["XDG_CONFIG_HOME"] = f"{HOME.name}/config"
os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")


def pytest_unconfigure():
    HOME.cleanup()


@pytest.fixture(autouse=True)
def usual_pull(monkeypatch):
    """What the pull tool changes is remembered, but not from test to test."""
    monkeypatch.setattr(PullShape, "change", "points")


@pytest.fixture
def design():
    """A B-spline+ named wing behind a Bezier+ named bow."""
    return a_design()


@pytest.fixture
def session(design):
    """A session that has just opened the design."""
    return Session(design)


@pytest.fixture
def document(tmp_path):
    """A file with curves, a surface, a mesh, and keys that nobody knows."""
    path = tmp_path / "bow.json"
    path.write_bytes(DOCUMENT)
    return path
