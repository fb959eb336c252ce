"""Records in folders: what was saved is there, whatever ends the process or spoils the files."""
from __future__ import annotations

import os
import tempfile
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from seam_inspector.plugin.imagery.errors import SettingsError
from seam_inspector.plugin.imagery.records import RecordFiles, RecordFolder

KIND = "Tests"
SAVED = {"a": b"third", "b": b"second", "c": b""}


def filled(path: Path, of: str = "") -> RecordFolder:
    folder = RecordFolder(path, KIND, of)
    for name, payload in (("a", b"first"), ("b", b"second"), ("a", b"third"), ("c", b"")):
        folder.files.save(name, payload)
    return folder


def held(path: Path) -> dict[str, bytes | None]:
    files = RecordFiles(path)
    return {name: files.load(name) for name in files.names}


def test_the_last_payload_of_a_name_counts(tmp_path: Path) -> None:
    folder = filled(tmp_path / "records")
    folder.files.forget("b")
    folder.files.forget("b")
    folder.close()
    assert held(tmp_path / "records") == {"a": b"third", "c": b""}
    assert folder.files.load("b") is None
    folder = RecordFolder(tmp_path / "records", KIND)
    folder.remove()
    assert os.listdir(tmp_path) == []


@given(st.integers(0, 5), st.integers(1, 255) | st.none())
def test_no_damage_brings_a_payload_that_nobody_saved(place: int, change: int | None) -> None:
    """A flipped bit, or the end that a failing power took."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "records"
        filled(path).close()
        whole = bytearray((path / "b").read_bytes())
        if change is None:
            del whole[place:]
        else:
            whole[place] ^= change
        (path / "b").write_bytes(whole)
        with pytest.raises(OSError, match="Input/output error"):
            RecordFiles(path).load("b")


def test_one_process_at_a_time_and_of_one_thing(tmp_path: Path) -> None:
    path = tmp_path / "records"
    folder = filled(path, "one thing")
    with pytest.raises(SettingsError, match="another QGIS has it open"):
        RecordFolder(path, KIND)
    folder.close()
    (path / ".unfinished-1").write_bytes(b"what a process left that died")
    with pytest.raises(SettingsError, match="something else is there"):
        RecordFolder(path, "Others")
    same = RecordFolder(path, KIND, "one thing")
    same.close()
    assert (same.was_of, held(path)) == ("one thing", SAVED)
    assert sorted(os.listdir(path)) == [".about", ".lock", "a", "b", "c"]
    other = RecordFolder(path, KIND, "another thing")
    other.close()
    assert (other.was_of, held(path)) == ("one thing", {})
    assert sorted(os.listdir(path)) == [".about", ".lock"]


@pytest.mark.parametrize("left", [[], [".lock"], [".lock", ".unfinished-1"]])
def test_a_folder_whose_process_died_as_it_made_it_is_begun(tmp_path: Path, left: list[str]) -> None:
    path = tmp_path / "records"
    path.mkdir()
    for name in left:
        (path / name).touch()
    folder = filled(path)
    assert (folder.was_of, held(path)) == (None, SAVED)
    folder.close()


def test_a_folder_of_somebody_else_is_left_as_it_is(tmp_path: Path) -> None:
    (tmp_path / "mine").write_bytes(b"mine")
    with pytest.raises(SettingsError, match="something else is there"):
        RecordFolder(tmp_path, KIND)
    assert os.listdir(tmp_path) == ["mine"]


def another(path: Path, kind: str) -> None:
    """What somebody who hands over a folder can put there by the name of one that we keep."""
    if kind == "pipe":
        os.mkfifo(path)
    elif kind == "file":
        path.write_bytes(b"theirs")
    else:
        path.symlink_to(path.with_name("outside"))


@pytest.mark.skipif(os.name == "nt", reason="links and pipes of POSIX")
@pytest.mark.parametrize("kind", ["link", "link to nothing", "pipe", "file"])
def test_what_is_no_folder_of_its_own_is_neither_opened_nor_waited_for(tmp_path: Path, kind: str) -> None:
    path, outside = tmp_path / "records", tmp_path / "outside"
    if kind == "link":
        filled(outside, "of another version, which would be begun anew").close()
    another(path, kind)
    with pytest.raises(SettingsError, match="something else is there"):
        RecordFolder(path, KIND)
    assert os.path.lexists(path)
    assert held(outside) == (SAVED if kind == "link" else {})


@pytest.mark.skipif(os.name == "nt", reason="links and pipes of POSIX")
@pytest.mark.parametrize("name", ["a", ".about", ".lock"])
@pytest.mark.parametrize("kind", ["link", "pipe"])
def test_links_and_pipes_among_the_records_lead_nowhere(tmp_path: Path, name: str, kind: str) -> None:
    path, outside = tmp_path / "records", tmp_path / "outside"
    filled(path).close()
    outside.write_bytes(b"mine")
    (path / name).unlink()
    if kind == "pipe":
        os.mkfifo(path / name)
    else:
        (path / name).symlink_to(outside)
    try:
        folder = RecordFolder(path, KIND, "another thing")
    except OSError:
        assert name != "a"
    else:
        assert name == "a" or (name, kind) == (".lock", "pipe")
        folder.files.save("a", b"payload")
        folder.remove()
        assert not path.exists()
    assert outside.read_bytes() == b"mine"
