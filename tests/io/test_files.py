"""Loading and saving: the right format, all or nothing, a sentence for whatever is in the way."""

import errno
import os
import socket
import stat
from pathlib import Path

import pytest

from plusedit.document.design import Design
from plusedit.io import files
from plusedit.io.files import check_apart, load, read_file, replacing, save, write_file
from plusedit.io.formats import FormatError
from tests.designs import DOCUMENT, a_design, contents

posix = pytest.mark.skipif(os.name != "posix", reason="pipes, links and permissions of Unix")


def refused(act, *arguments):
    with pytest.raises(FormatError) as told:
        act(*arguments)
    assert str(told.value).isprintable()
    return str(told.value)


def failing(code):
    """A function that fails as the system does."""

    def fail(*_arguments, **_options):
        raise OSError(code, os.strerror(code))

    return fail


def names_in(folder):
    return sorted(path.name for path in folder.iterdir())


@pytest.mark.parametrize("name", ["bow.json", "bow.plus.json", "BOW.JSON", "bow v2 é.json"])
def test_what_is_saved_can_be_loaded(tmp_path, name):
    save(a_design(), tmp_path / name)
    assert contents(load(tmp_path / name).design) == contents(a_design())


def test_saving_leaves_nothing_else_behind(tmp_path):
    save(a_design(), tmp_path / "bow.json")
    save(Design(), tmp_path / "bow.json")
    assert names_in(tmp_path) == ["bow.json"]


def test_a_path_can_be_a_string(document):
    assert len(load(str(document)).design) == 4


def test_an_unknown_suffix_names_the_known_ones(tmp_path):
    known = "known are .csv, .dat, .json, .plus.json, .pts, .svg, .txt"
    assert refused(save, Design(), tmp_path / "bow.xyz").endswith(f'".xyz" is not known; {known}')
    assert refused(save, Design(), tmp_path / "bow").endswith(f"has no suffix; {known}")
    (tmp_path / "bow.obj").write_bytes(b"")
    assert refused(load, tmp_path / "bow.obj").startswith('bow.obj: suffix ".obj" is not known')


def test_a_missing_file_is_missing(tmp_path):
    assert refused(load, tmp_path / "bow.json") == "bow.json: there is no such file"


def test_a_folder_is_no_file(tmp_path):
    folder = tmp_path / "bow.json"
    folder.mkdir()
    assert refused(load, folder) == "bow.json: is a folder"
    assert refused(save, Design(), folder) == "bow.json: is a folder"


def test_a_folder_that_is_missing_is_named(tmp_path):
    assert "there is no folder" in refused(save, Design(), tmp_path / "no" / "bow.json")


def test_a_file_in_place_of_a_folder_is_told(tmp_path):
    (tmp_path / "file").write_bytes(b"")
    assert "there is no such folder" in refused(load, tmp_path / "file" / "bow.json")


@pytest.mark.parametrize("name", ["bow\0.json", "b" * 300 + ".json"])
def test_an_impossible_name_is_refused(tmp_path, name):
    refused(load, tmp_path / name)
    refused(save, Design(), tmp_path / name)
    assert names_in(tmp_path) == []


def test_a_name_with_a_line_break_leaves_the_sentence_on_one_line(tmp_path):
    refused(load, tmp_path / "bow\n\x1b[2J.json")


@posix
def test_a_pipe_is_not_waited_for(tmp_path):
    os.mkfifo(tmp_path / "bow.json")
    assert refused(load, tmp_path / "bow.json").endswith("is no plain file, but a device or a pipe")
    assert refused(save, Design(), tmp_path / "bow.json").endswith("a device or a pipe")


@posix
def test_a_device_is_not_read(tmp_path):
    (tmp_path / "bow.json").symlink_to("/dev/zero")
    assert refused(load, tmp_path / "bow.json").endswith("is no plain file, but a device or a pipe")
    assert refused(save, Design(), tmp_path / "bow.json").endswith("a device or a pipe")


@posix
def test_a_socket_is_not_read(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with socket.socket(socket.AF_UNIX) as listening:
        listening.bind("bow.json")
        refused(load, "bow.json")
        refused(save, Design(), "bow.json")


@posix
def test_a_link_that_leads_to_itself_is_told(tmp_path):
    loop = tmp_path / "bow.json"
    loop.symlink_to(loop)
    assert refused(load, loop) == "bow.json: is a link that leads to itself"
    assert refused(save, Design(), loop) == "bow.json: is a link that leads to itself"
    assert loop.is_symlink()


@posix
def test_saving_through_a_link_replaces_what_it_leads_to(tmp_path):
    (tmp_path / "far").mkdir()
    real, link = tmp_path / "far" / "real.json", tmp_path / "bow.json"
    real.write_bytes(b"old")
    link.symlink_to(real)
    save(a_design(), link)
    assert link.is_symlink()
    assert contents(load(real).design) == contents(a_design())


@posix
def test_saving_through_a_link_to_nothing_makes_what_it_leads_to(tmp_path):
    (tmp_path / "bow.json").symlink_to(tmp_path / "real.json")
    save(a_design(), tmp_path / "bow.json")
    assert (tmp_path / "real.json").is_file()


@posix
@pytest.mark.parametrize("mode", [0o600, 0o644, 0o664])
def test_permissions_stay_as_they_are(tmp_path, mode):
    path = tmp_path / "bow.json"
    path.write_bytes(b"old")
    path.chmod(mode)
    save(a_design(), path)
    assert stat.S_IMODE(path.stat().st_mode) == mode


@posix
def test_a_new_file_has_the_usual_permissions(tmp_path):
    before = os.umask(0o027)
    try:
        save(a_design(), tmp_path / "bow.json")
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "bow.json").stat().st_mode) == 0o640


def test_a_write_protected_file_stays(document, monkeypatch):
    monkeypatch.setattr(os, "access", lambda *_: False)
    assert refused(save, Design(), document).endswith("the file is write-protected")
    assert document.read_bytes() == DOCUMENT


@pytest.mark.parametrize("step", ["fsync", "open", "write"])
@pytest.mark.parametrize(
    ("code", "why"),
    [
        (errno.ENOSPC, "the disk is full"),
        (errno.EACCES, "permission denied"),
        (errno.EIO, "input/output error"),
    ],
)
def test_a_save_that_fails_leaves_the_old_file_and_nothing_else(
    document, monkeypatch, step, code, why
):
    if step == "write":
        monkeypatch.setattr(Path, "replace", failing(code))
    else:
        monkeypatch.setattr(files.os, step, failing(code))
    assert refused(save, a_design(), document) == f"bow.json: {why}"
    assert document.read_bytes() == DOCUMENT
    assert names_in(document.parent) == ["bow.json"]


def test_an_interrupted_save_leaves_the_old_file_and_nothing_else(document, monkeypatch):
    def interrupted(_descriptor):
        raise KeyboardInterrupt

    monkeypatch.setattr(files.os, "fsync", interrupted)
    with pytest.raises(KeyboardInterrupt):
        save(a_design(), document)
    assert document.read_bytes() == DOCUMENT
    assert names_in(document.parent) == ["bow.json"]


def test_a_design_that_can_not_be_written_leaves_the_old_file(document):
    impossible = Design(view={"zoom": float("inf")})
    assert refused(save, impossible, document).startswith("bow.json: the design can't be written")
    assert document.read_bytes() == DOCUMENT


@posix
@pytest.mark.skipif(os.name == "posix" and os.geteuid() == 0, reason="root may do everything")
def test_without_permission_it_says_so(document):
    document.chmod(0)
    assert refused(load, document) == "bow.json: permission denied"
    document.parent.chmod(0o500)
    refused(save, Design(), document.parent / "new.json")


def test_a_file_that_may_not_be_read_is_told(document, monkeypatch):
    monkeypatch.setattr(files.os, "open", failing(errno.EACCES))
    assert refused(load, document) == "bow.json: permission denied"


def test_a_result_does_not_take_the_place_of_what_it_is_made_from(document):
    check_apart(document.with_name("new.json"), document)
    document.with_name("link").symlink_to(document)
    told = refused(check_apart, document.with_name("link"), document)
    assert told == "link: is read from and can't be written to"


def test_a_result_in_a_folder_that_may_not_be_looked_into_is_told(document, monkeypatch):
    monkeypatch.setattr(Path, "exists", failing(errno.EACCES))
    told = refused(check_apart, document.with_name("out.json"), document)
    assert told == "out.json: permission denied"


def test_a_file_that_is_too_large_is_not_read(tmp_path):
    path = tmp_path / "bow.json"
    with path.open("wb") as file:
        file.truncate(3 * 2**30)
    assert refused(load, path) == "bow.json: is too large: more than 256 MB are not read"


def test_bytes_come_back_as_they_were_written(tmp_path):
    write_file(bytes(range(256)), tmp_path / "anything")
    assert read_file(tmp_path / "anything") == bytes(range(256))


def test_a_stream_that_is_not_written_to_its_end_leaves_the_old_file(document):
    def begin():
        with replacing(document) as stream:
            stream.write(b"half")
            raise FormatError("there is no more")

    assert refused(begin) == "bow.json: there is no more"
    assert document.read_bytes() == DOCUMENT
    assert names_in(document.parent) == ["bow.json"]


def test_a_stream_becomes_the_file_at_its_end(document):
    with replacing(document) as stream:
        for piece in (b"one", b"two"):
            stream.write(piece)
        assert document.read_bytes() == DOCUMENT
    assert document.read_bytes() == b"onetwo"
    assert names_in(document.parent) == ["bow.json"]
