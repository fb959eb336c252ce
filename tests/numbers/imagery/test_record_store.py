"""Stores of records: what was saved is there, whatever ends the process or spoils the file."""
from __future__ import annotations

import contextlib
import os
import shutil
import sqlite3
import tempfile
import threading
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from seam_inspector.plugin.imagery.errors import SettingsError
from seam_inspector.plugin.imagery.record_store import RecordKeeper, RecordStore

from tests.numbers.disks import full_disk

KIND = "Tests, 2"


def filled(path: Path) -> RecordStore:
    store = RecordStore(path, KIND)
    for key, payload in (("a", b"first"), ("b", b"second"), ("a", b"third"), ("c", b"")):
        store.save(key, payload)
    return store


def test_the_last_payload_of_a_key_counts_in_the_place_of_the_first(tmp_path: Path) -> None:
    store = filled(tmp_path / "records")
    assert store.load("b") == b"second"
    store.forget("b")
    store.close()
    store = RecordStore(tmp_path / "records", KIND)
    assert list(store.items()) == [("a", b"third"), ("c", b"")]
    assert list(store.keys) == ["a", "c"]
    assert store.load("b") is None
    store.close()
    assert os.listdir(tmp_path) == ["records"]


def test_what_a_process_left_that_died_is_there(tmp_path: Path) -> None:
    """At any moment: what is copied while a store is open is what a killed process leaves. Where the power fails,
    what was written ahead may end anywhere beyond what was synced; it never ends before it.
    """
    store = filled(tmp_path / "records")
    store.sync()
    synced = (tmp_path / "records-wal").stat().st_size
    store.save("d", b"x" * 100_000)
    (tmp_path / "left").mkdir()
    for one in ("records", "records-wal"):
        shutil.copy(tmp_path / one, tmp_path / "left" / one)
    store.close()
    whole = (tmp_path / "left" / "records-wal").read_bytes()
    for length in (0, 31, 5000, synced, synced + 31, 60_000, len(whole) - 1, len(whole)):
        (tmp_path / "left" / "records-wal").write_bytes(whole[:length])
        shutil.copytree(tmp_path / "left", tmp_path / str(length))
        store = RecordStore(tmp_path / str(length) / "records", KIND)
        held = dict(store.items())
        store.close()
        if length >= synced:
            last = {"d": b"x" * 100_000} if length == len(whole) else {}
            assert held == {"a": b"third", "b": b"second", "c": b"", **last}
        else:  # whole saves, the earlier ones first
            assert list(held.items()) in [list(one.items()) for one in _AS_SAVED]


_AS_SAVED: list[dict[str, bytes]] = [
    {},
    {"a": b"first"},
    {"a": b"first", "b": b"second"},
    {"a": b"third", "b": b"second"},
]


def test_a_damaged_payload_is_as_if_it_were_not_there(tmp_path: Path) -> None:
    path = tmp_path / "records"
    filled(path).close()
    path.write_bytes(path.read_bytes().replace(b"second", b"sXcond"))
    assert dict(RecordStore(path, KIND).items()) == {"a": b"third", "c": b""}


@given(st.integers(0, 2**16), st.integers(1, 255))
def test_no_flipped_bit_brings_a_payload_that_nobody_saved(place: int, change: int) -> None:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "records"
        filled(path).close()
        whole = bytearray(path.read_bytes())
        whole[place % len(whole)] ^= change
        path.write_bytes(whole)
        try:
            store = RecordStore(path, KIND)
        except (SettingsError, OSError):
            return  # it says so
        with suppress(OSError):
            assert dict(store.items()).items() <= {("a", b"third"), ("b", b"second"), ("c", b"")}
        store.close()


def test_one_process_at_a_time_and_no_other_kind_of_file(tmp_path: Path) -> None:
    path, other, database = tmp_path / "records", tmp_path / "other", tmp_path / "database"
    file = filled(path)
    with pytest.raises(SettingsError, match="another QGIS has it open"):
        RecordStore(path, KIND)
    file.close()
    other.write_bytes(b"somebody else's")
    with contextlib.closing(sqlite3.connect(database)) as others:
        others.execute("CREATE TABLE theirs (number INTEGER)")
    before = database.read_bytes()
    for foreign in (other, database):
        with pytest.raises(SettingsError, match="something else"):
            RecordStore(foreign, KIND, replaced="Tests, ")
    with pytest.raises(SettingsError, match="something else"):
        RecordStore(path, "Tests, 3")
    assert other.read_bytes() == b"somebody else's"
    assert database.read_bytes() == before
    store = RecordStore(path, "Tests, 3", replaced="Tests, ")
    assert not store.keys
    store.close()
    other.write_bytes(b"Tests, 1\nas they were before they were databases")
    assert not RecordStore(other, KIND, replaced="Tests, ").keys


def test_a_view_by_one_of_our_names_is_not_read(tmp_path: Path) -> None:
    """It may never end, and nobody chose the file."""
    path = tmp_path / "records"
    endless = "WITH RECURSIVE n(key) AS (SELECT 1 UNION ALL SELECT key + 1 FROM n) SELECT key, key AS number FROM n"
    with contextlib.closing(sqlite3.connect(path)) as database:
        database.execute("CREATE TABLE about (kind TEXT)")
        database.execute("INSERT INTO about VALUES (?)", (KIND,))
        database.execute(f"CREATE VIEW records AS {endless}")
        database.commit()
    for replaced in (None, "Tests, "):
        with pytest.raises(SettingsError, match="something else"):
            RecordStore(path, KIND, replaced)


def test_a_keeper_does_in_turn_what_it_is_asked_and_says_why_it_can_not(tmp_path: Path) -> None:
    told: list[object] = []
    keeper = RecordKeeper(tmp_path / "records", KIND, told.append)
    assert keeper.all() == {}
    assert not keeper.path.exists()
    for turn in range(100):
        keeper.save(str(turn % 10), lambda turn=turn: b"%d" % turn)
    assert keeper.load("7") == b"97"
    keeper.close()
    keeper = RecordKeeper(tmp_path / "records", KIND, told.append)
    assert len(keeper.all()) == 10
    keeper.remove()
    keeper.flush()
    assert not keeper.path.exists()
    keeper.close()
    assert told == []
    (tmp_path / "folder").mkdir()
    keeper = RecordKeeper(tmp_path / "folder", KIND, told.append)
    keeper.save("a", lambda: b"b")
    keeper.close()
    assert len(told) == 1


def test_payloads_that_count_no_more_take_no_room(tmp_path: Path) -> None:
    store = RecordStore(tmp_path / "records", KIND)
    for turn in range(10):
        store.save("a", bytes([turn]) * 2**18)
    store.close()
    assert (tmp_path / "records").stat().st_size < 3 * 2**18


def test_a_store_that_is_removed_as_it_is_opened_is_made_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path, connect, ended = tmp_path / "records", sqlite3.connect, []

    def connect_before_the_other_ended(*given: Any, **named: Any) -> sqlite3.Connection:
        database = connect(*given, **named)
        database.execute("SELECT * FROM sqlite_master").fetchall()  # opens the file
        if not ended:
            ended.append(True)
            path.unlink()
        return database

    monkeypatch.setattr(sqlite3, "connect", connect_before_the_other_ended)
    filled(path).close()
    assert dict(RecordStore(path, KIND).items()) == {"a": b"third", "b": b"second", "c": b""}


def another(path: Path, kind: str) -> None:
    """What somebody who hands over a folder can put there by the name of a file that we keep."""
    if kind == "pipe":
        os.mkfifo(path)
    elif kind == "folder":
        path.mkdir()
    else:
        path.symlink_to(path.with_name("outside"))


@pytest.mark.skipif(os.name == "nt", reason="links and pipes of POSIX")
@pytest.mark.parametrize("kind", ["link", "link to nothing", "pipe", "folder"])
def test_what_is_no_file_of_its_own_is_neither_opened_nor_waited_for(tmp_path: Path, kind: str) -> None:
    path, outside = tmp_path / "records", tmp_path / "outside"
    if kind == "link":
        outside.write_bytes(b"\0" * 100_000)  # as an image of a disk begins; of ours it would be one that was cut off
    another(path, kind)
    with pytest.raises(OSError, match=r"."):
        RecordStore(path, KIND)
    assert outside.exists() == (kind == "link")
    assert kind != "link" or outside.read_bytes() == b"\0" * 100_000
    told: list[object] = []
    keeper = RecordKeeper(path, KIND, told.append)
    keeper.save("a", lambda: b"payload")
    keeper.remove()
    keeper.close()
    assert len(told) == 1
    assert os.path.lexists(path)


def test_where_there_is_no_room_for_the_first_record_nothing_is_left(tmp_path: Path) -> None:
    path = tmp_path / "records"
    with full_disk(1), pytest.raises(OSError, match=r"."):
        RecordStore(path, KIND)
    assert list(tmp_path.iterdir()) == []


def test_who_waits_for_a_while_only_goes_on_while_the_disk_is_busy(tmp_path: Path) -> None:
    keeper, disk = RecordKeeper(tmp_path / "records", KIND, pytest.fail), threading.Event()

    def payload() -> bytes:
        disk.wait()
        return b"late"

    keeper.wait(0)  # nothing was asked yet
    keeper.save("a", payload)
    keeper.wait(0.01)
    assert not disk.is_set()
    disk.set()
    keeper.wait(60)
    assert keeper.load("a") == b"late"
    keeper.close()
