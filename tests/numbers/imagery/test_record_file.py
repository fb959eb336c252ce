"""Files of records: what was saved is there, whatever ends the process or spoils the file."""
from __future__ import annotations

import os
import threading
from pathlib import Path

import pytest
from seam_inspector.plugin.imagery.errors import SettingsError
from seam_inspector.plugin.imagery.records.record_file import RecordFile
from seam_inspector.plugin.imagery.records.record_keeper import RecordKeeper

MAGIC = b"Tests, 2\n"


def filled(path: Path) -> RecordFile:
    file = RecordFile(path, MAGIC)
    for key, payload in (("a", b"first"), ("b", b"second"), ("a", b"third"), ("c", b"fourth")):
        file.save(key, payload)
    return file


def test_the_last_payload_of_a_key_counts_and_an_empty_one_is_none(tmp_path: Path) -> None:
    file = filled(tmp_path / "records")
    file.save("b", b"")
    file.close()
    file = RecordFile(tmp_path / "records", MAGIC)
    assert dict(file.items()) == {"a": b"third", "c": b"fourth"}
    assert file.load("b") is None
    assert not file.is_damaged


def test_a_file_that_is_cut_anywhere_keeps_what_is_whole_and_takes_more(tmp_path: Path) -> None:
    path = tmp_path / "records"
    file = filled(path)
    file.close()
    whole = path.read_bytes()
    for length in range(len(whole)):
        path.write_bytes(whole[:length])
        file = RecordFile(path, MAGIC)
        held = dict(file.items())
        assert held.items() <= {("a", b"first"), ("b", b"second"), ("a", b"third"), ("c", b"fourth")}
        file.save("d", b"more")
        file.close()
        file = RecordFile(path, MAGIC)
        assert dict(file.items()) == {**held, "d": b"more"}
        file.close()


def test_a_damaged_payload_is_as_if_it_were_not_there(tmp_path: Path) -> None:
    path = tmp_path / "records"
    filled(path).close()
    path.write_bytes(path.read_bytes().replace(b"second", b"sXcond"))
    assert dict(RecordFile(path, MAGIC).items()) == {"a": b"third", "c": b"fourth"}


def test_a_flipped_bit_costs_its_own_record_alone_and_cuts_nothing_off(tmp_path: Path) -> None:
    path, keys = tmp_path / "records", [f"key {i}" for i in range(4)]
    file, ends = RecordFile(path, MAGIC), [len(MAGIC)]
    for i, key in enumerate(keys):
        file.save(key, bytes([i]) * 36)
        ends.append(file.size)
    file.close()
    whole = path.read_bytes()
    for place in range(len(MAGIC), len(whole)):
        hurt = next(i for i, end in enumerate(ends[1:]) if place < end)
        for bit in range(8):
            path.write_bytes(whole[:place] + bytes([whole[place] ^ 1 << bit]) + whole[place + 1 :])
            file = RecordFile(path, MAGIC)
            file.save("more", b"saved later")
            file.close()
            assert path.stat().st_size > len(whole) or hurt == 3  # as if it had not been written whole
            file = RecordFile(path, MAGIC)
            expected = {key: bytes([i]) * 36 for i, key in enumerate(keys) if i != hurt}
            assert dict(file.items()) == {**expected, "more": b"saved later"}, (place, bit)
            file.close()


def test_records_behind_a_damaged_place_are_found_wherever_they_begin(tmp_path: Path) -> None:
    path, ground = tmp_path / "records", bytes(range(256)) * 4096  # as much as is searched in one step
    for length in (len(ground) - 40, len(ground) - 2, len(ground)):
        file = RecordFile(path, MAGIC)
        file.save("large", ground[:length])
        file.save("next", b"behind it")
        file.close()
        content = bytearray(path.read_bytes())
        content[len(MAGIC) : len(MAGIC) + 16] = b"\xff" * 16
        path.write_bytes(content)
        file = RecordFile(path, MAGIC)
        assert dict(file.items()) == {"next": b"behind it"}
        assert file.is_damaged
        file.remove()


def test_one_process_at_a_time_and_no_other_kind_of_file(tmp_path: Path) -> None:
    path, other = tmp_path / "records", tmp_path / "other"
    file = filled(path)
    with pytest.raises(SettingsError):
        RecordFile(path, MAGIC)
    file.close()
    other.write_bytes(b"somebody else's")
    with pytest.raises(SettingsError):
        RecordFile(other, MAGIC)
    with pytest.raises(SettingsError):
        RecordFile(path, b"Tests, 3\n")
    assert other.read_bytes() == b"somebody else's"
    assert RecordFile(path, b"Tests, 3\n", replaced=b"Tests, ").keys == []


def test_a_keeper_does_in_turn_what_it_is_asked_and_says_why_it_can_not(tmp_path: Path) -> None:
    told: list[object] = []
    keeper = RecordKeeper(tmp_path / "records", MAGIC, told.append)
    assert keeper.all() == {}
    assert not keeper.path.exists()
    for turn in range(100):
        keeper.save(str(turn % 10), lambda turn=turn: b"%d" % turn)
    assert keeper.load("7") == b"97"
    keeper.close()
    keeper = RecordKeeper(tmp_path / "records", MAGIC, told.append)
    assert len(keeper.all()) == 10
    keeper.remove()
    keeper.flush()
    assert not keeper.path.exists()
    keeper.close()
    assert told == []
    (tmp_path / "folder").mkdir()
    keeper = RecordKeeper(tmp_path / "folder", MAGIC, told.append)
    keeper.save("a", lambda: b"b")
    keeper.close()
    assert len(told) == 1


def test_a_file_of_what_counts_no_more_is_written_anew(tmp_path: Path) -> None:
    keeper = RecordKeeper(tmp_path / "records", MAGIC, print)
    for turn in range(10):
        keeper.save("a", lambda turn=turn: bytes([turn]) * 2**18)
    keeper.save("b", lambda: b"small")
    keeper.flush()
    before = keeper.path.stat().st_size
    keeper.compact()
    assert keeper.all() == {"a": bytes([9]) * 2**18, "b": b"small"}
    assert keeper.path.stat().st_size < before / 5
    keeper.close()


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
        RecordFile(path, MAGIC)
    assert outside.exists() == (kind == "link")
    assert kind != "link" or outside.read_bytes() == b"\0" * 100_000
    told: list[object] = []
    keeper = RecordKeeper(path, MAGIC, told.append)
    keeper.save("a", lambda: b"payload")
    keeper.remove()
    keeper.close()
    assert len(told) == 1
    assert os.path.lexists(path)


def test_who_waits_for_a_while_only_goes_on_while_the_disk_is_busy(tmp_path: Path) -> None:
    keeper, disk = RecordKeeper(tmp_path / "records", MAGIC, pytest.fail), threading.Event()

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
