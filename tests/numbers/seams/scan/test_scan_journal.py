"""What a scan has measured is on disk, whole, whatever ends its process; another scan's is never taken for it."""
from __future__ import annotations

import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from seam_inspector.plugin.imagery.errors import INFO, Message, SettingsError
from seam_inspector.plugin.imagery.records import RecordFiles, RecordFolder
from seam_inspector.plugin.seams.measure import messages
from seam_inspector.plugin.seams.measure.scan.block_runs import FIRST_LOOK, held, open_journal, save

from tests.numbers.disks import full_disk

PRINT = "a fingerprint"
RESULTS = {"block 0 0": b"first", "block 0 1": b"", "border 0 1": bytes(range(256)) * 50}


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "loss.tif.scan"


def contents(journal: RecordFolder) -> dict[str, bytes]:
    return {name: journal.files.load(name) or b"" for name in journal.files.names}


def written(path: Path, results: dict[str, bytes] = RESULTS) -> Path:
    journal, _ = open_journal(path, PRINT)
    for key, payload in results.items():
        save(journal.files, key, payload)
    journal.close()
    return path


def reopened(path: Path, fingerprint: str = PRINT) -> tuple[dict[str, bytes], Message | None]:
    journal, notice = open_journal(path, fingerprint)
    records = contents(journal)
    journal.close()
    return records, notice


def sentence(notice: Message | None) -> str | None:
    return None if notice is None else notice.template


def test_what_was_saved_is_there(path: Path) -> None:
    journal, notice = open_journal(path, PRINT)
    assert notice is None
    for key, payload in RESULTS.items():
        save(journal.files, key, payload)
        assert journal.files.load(key) == payload
    save(journal.files, "block 0 0", b"anew")
    assert journal.files.load("block 0 0") == b"anew"
    assert journal.files.load("never") is None
    journal.close()
    records, notice = reopened(path)
    assert records == {**RESULTS, "block 0 0": b"anew"}
    assert str(notice) == "The work continues where it stopped; parts that are done already: 3."
    assert notice.level is INFO


def test_nothing_of_another_scan_is_kept(path: Path) -> None:
    records, notice = reopened(written(path), "anything else")
    assert records == {}
    assert notice == messages.SCAN_ANEW()
    assert reopened(path)[1] == messages.SCAN_ANEW()  # the other one's is the journal's now


def test_a_damaged_record_is_measured_again(path: Path) -> None:
    damaged = written(path) / "block 0 0"
    whole = bytearray(damaged.read_bytes())
    whole[1] ^= 4
    damaged.write_bytes(whole)
    files = RecordFiles(damaged.parent)
    with pytest.raises(OSError, match="Input/output error"):
        files.load("block 0 0")
    with pytest.raises(SettingsError, match=r"can't be read any more .*; start it again"):
        held(FIRST_LOOK, files, (0, 0))
    assert reopened(path)[0] == {key: payload for key, payload in RESULTS.items() if key != "block 0 0"}


@pytest.mark.parametrize("kind", ["file", "folder", "another scan through a link"])
def test_what_is_of_somebody_else_is_left_as_it_is(path: Path, kind: str) -> None:
    theirs = path.with_name("outside")
    if kind == "file":
        path.write_bytes(b"II*\0 a picture, perhaps the only one")
    elif kind == "folder":
        path.mkdir()
        (path / "block 0 0").write_bytes(b"mine")
    else:
        path.symlink_to(written(theirs))
    for _ in range(2):
        with pytest.raises(SettingsError, match="something else is there"):
            open_journal(path, "another fingerprint")
    assert not path.is_file() or path.read_bytes() == b"II*\0 a picture, perhaps the only one"
    assert kind != "folder" or (path / "block 0 0").read_bytes() == b"mine"
    assert not theirs.exists() or reopened(theirs)[0] == RESULTS


def test_a_full_disk_keeps_what_was_saved_and_says_how_to_go_on(path: Path) -> None:
    journal, _ = open_journal(path, PRINT)
    save(journal.files, "block 0", b"x" * 1000)
    with full_disk(100_000):
        with pytest.raises(SettingsError) as caught:
            save(journal.files, "block 1", b"y" * 200_000)
        save(journal.files, "block 2", b"z" * 1000)  # a small one still finds room
    assert str(caught.value) == (
        f"{path} can't be written (File too large). What was measured is saved (blocks done: 1); make room on "
        "the disk and start it again with the same output to go on."
    )
    save(journal.files, "block 1", b"y" * 200_000)
    journal.close()
    assert reopened(path)[0] == {"block 0": b"x" * 1000, "block 2": b"z" * 1000, "block 1": b"y" * 200_000}


WRITER = """
import sys
from pathlib import Path
from seam_inspector.plugin.seams.measure.scan.block_runs import open_journal, save
journal, _ = open_journal(Path(sys.argv[1]), sys.argv[2])
print("open", flush=True)
done = len(journal.files.names)
while True:
    save(journal.files, str(done), str(done).encode() * (1 + done % 30_000))
    done += 1
    print(done, flush=True)
"""


def start(path: Path) -> subprocess.Popen[str]:
    writer = subprocess.Popen([sys.executable, "-c", WRITER, str(path), PRINT], stdout=subprocess.PIPE, text=True)
    assert writer.stdout.readline() == "open\n"
    return writer


@pytest.mark.slow
def test_another_scan_is_refused_until_the_first_one_ends_or_dies(path: Path) -> None:
    journal, _ = open_journal(path, PRINT)
    with pytest.raises(SettingsError, match="another QGIS has it open"):
        open_journal(path, PRINT)  # in this process
    journal.close()
    writer = start(path)
    with pytest.raises(SettingsError, match="another QGIS has it open"):
        open_journal(path, "another fingerprint")
    writer.kill()
    writer.communicate()
    open_journal(path, PRINT)[0].close()


@pytest.mark.release
def test_killed_at_random_moments_it_has_all_that_was_told_to_be_done(path: Path) -> None:
    rng = random.Random(1)
    for _ in range(10):
        writer = start(path)
        time.sleep(rng.uniform(0, 0.08))
        writer.send_signal(signal.SIGKILL)
        numbers = writer.communicate()[0].split()
        records, notice = reopened(path)
        assert len(records) >= (int(numbers[-1]) if numbers else 0)
        assert sentence(notice) in (None, messages.GOES_ON.template)
        assert records == {str(n): str(n).encode() * (1 + n % 30_000) for n in range(len(records))}
    assert records


def test_a_journal_by_somebody_else_names_no_file(tmp_path: Path) -> None:
    """Its fingerprint is words: nothing is opened, made or deleted by it, nor through a link among its blocks."""
    outside = tmp_path / "outside"
    outside.write_bytes(b"mine")
    folder = tmp_path / "handed over"
    folder.mkdir()
    path = written(folder / "loss.tif.scan")
    (path / "block 9 9").symlink_to(outside)
    assert set(reopened(path)[0]) == set(RESULTS)
    for fingerprint in (str(outside), "version=../outside mosaic=../outside"):
        journal, _ = open_journal(path, fingerprint)
        save(journal.files, "block 9 9", b"overwritten")
        journal.remove()
    assert list(folder.iterdir()) == []
    assert outside.read_bytes() == b"mine"
