"""What holds for every format on the shelf."""

import pytest

from plusedit.document.design import Design
from plusedit.io.formats import FormatError, Loaded, formats
from tests.designs import a_design, contents

every_format = pytest.mark.parametrize("file_format", formats.values(), ids=list(formats))


def test_no_two_formats_share_a_suffix():
    suffixes = [suffix for entry in formats.values() for suffix in entry.suffixes]
    assert sorted(suffixes) == sorted(set(suffixes))


@every_format
def test_suffixes_are_lower_case_and_begin_with_a_dot(file_format):
    assert file_format.suffixes
    assert all(suffix[0] == "." and suffix == suffix.lower() for suffix in file_format.suffixes)


@every_format
def test_it_has_a_title(file_format):
    assert file_format.title


@every_format
def test_what_is_written_can_be_read(file_format):
    loaded = file_format.read(file_format.write(a_design()), "drawing")
    assert isinstance(loaded, Loaded)
    assert len(loaded.design) >= 1
    if file_format.keeps_all:
        assert contents(loaded.design) == contents(a_design())


@every_format
def test_writing_the_same_design_gives_the_same_bytes(file_format):
    assert file_format.write(a_design()) == file_format.write(a_design())


@every_format
def test_an_empty_design_is_written_or_refused_in_a_sentence(file_format):
    try:
        data = file_format.write(Design())
    except FormatError as error:
        assert str(error)
    else:
        assert data


@every_format
@pytest.mark.parametrize(
    "garbage",
    [b"", b"\x00", b"\xff\xfe\x00", b"garbage", b"<", b"{", b"[" * 5000, b"<a>" * 5000],
    ids=range(8),
)
def test_garbage_is_refused_with_the_name_of_the_file(file_format, garbage):
    with pytest.raises(FormatError, match=r"^drawing: "):
        file_format.read(garbage, "drawing")
