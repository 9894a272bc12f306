"""`plusedit schema`."""

import json

from plusedit.__main__ import main
from plusedit.io.schema import schema_text


def test_it_prints_the_schema_that_ships(capsys):
    assert main(["schema"]) == 0
    printed = capsys.readouterr().out
    assert printed == schema_text()
    assert json.loads(printed)["$schema"] == "https://json-schema.org/draft/2020-12/schema"
