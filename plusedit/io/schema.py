"""The JSON Schema of design files, as it ships with the program."""

from pathlib import Path

SCHEMA = Path(__file__).with_name("design.schema.json")


def schema_text() -> str:
    """The schema, as text."""
    return SCHEMA.read_text(encoding="utf-8")
