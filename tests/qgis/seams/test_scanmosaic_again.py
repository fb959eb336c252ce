"""A scan that was stopped goes on with the same output, and nothing half-written is taken for whole."""
from __future__ import annotations

import errno
import os
import re
import signal
import sqlite3
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from osgeo import ogr
from seam_inspector.plugin.imagery.records import RecordFiles
from seam_inspector.plugin.seams.measure import messages
from seam_inspector.plugin.seams.measure.scan import loss_raster
from seam_inspector.plugin.toolkit.algorithms.run import Run as AlgorithmRun

from tests.qgis.runs import Log, Run, assert_sentence, run
from tests.qgis.seams.scan_scenes import Files, images, write_scene

pytestmark = pytest.mark.usefixtures("provider")

SHAPE = 300, 6200  # 4 blocks in a row
JOURNAL = ["loss.tif.scan"]
LAYERS = ("SEAMS", "CELLS", "WORST")
DATE = re.compile(r"\d{4}-\d\d-\d\dT[\d:.]+Z")


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> Files:
    return write_scene(tmp_path_factory.mktemp("long"), images(SHAPE, bands=1), width=16.0)


def outputs(folder: Path) -> dict[str, str]:
    folder.mkdir(exist_ok=True)
    return {"LOSS": str(folder / "loss.tif"), **{name: str(folder / f"{name}.gpkg") for name in LAYERS}}


def scan(files: Files, folder: Path, log: Log | None = None, **more: Any) -> Run:
    return run("scanmosaic", log, **files.given(**outputs(folder), **more))


def contents(folder: Path) -> dict[str, list[str]]:
    """The features of each layer as text."""
    items = {}
    for name in LAYERS:
        dataset = ogr.Open(str(folder / f"{name}.gpkg"))
        items[name] = [feature.ExportToJson() for feature in dataset.GetLayer(0)]
    return items


def tables(path: Path) -> list[str]:
    """All that a GeoPackage holds but when it was last changed. Its header tells of QGIS, which may have it open."""
    database = sqlite3.connect(f"{path.as_uri()}?immutable=1", uri=True)
    try:
        return [DATE.sub("", line) for line in database.iterdump()]
    finally:
        database.close()


@pytest.fixture(scope="module")
def whole(provider: None, files: Files, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The results of a scan that nothing disturbed."""
    folder = tmp_path_factory.mktemp("whole")
    ended = scan(files, folder)
    assert ended.complaint is None
    assert ended.results["SEAM_METRES"] > 25
    return folder


def assert_like(folder: Path, whole: Path) -> None:
    assert (folder / "loss.tif").read_bytes() == (whole / "loss.tif").read_bytes()
    assert contents(folder) == contents(whole)
    for name in LAYERS:
        assert tables(folder / f"{name}.gpkg") == tables(whole / f"{name}.gpkg")
    assert {path.name for path in folder.iterdir()} == {path.name for path in whole.iterdir()}


class StopAt(Log):
    """Cancels when so much is done, in per cent."""

    def __init__(self, share: float) -> None:
        super().__init__()
        self.progressChanged.connect(lambda done: self.cancel() if done >= share else None)


@pytest.mark.parametrize("share", [1.0, 50.0, 92.0, 93.0])
def test_cancelled_it_keeps_what_is_done_and_goes_on(
    files: Files, whole: Path, tmp_path: Path, share: float
) -> None:
    log = StopAt(share)
    stopped = scan(files, tmp_path, log)
    assert stopped.results == {}
    assert any("continues from here" in said for said in log.infos)
    assert sorted(path.name for path in tmp_path.iterdir()) == JOURNAL
    again = scan(files, tmp_path)
    assert any("continues where it stopped" in said for said in again.log.infos)
    assert_like(tmp_path, whole)


def died(work: Any) -> None:
    """Do work in a process of its own, which kills itself in the middle of it."""
    child = os.fork()
    if not child:
        try:
            work()
        finally:
            os._exit(1)
    assert os.waitpid(child, 0)[1] == signal.SIGKILL


@pytest.mark.skipif(os.name == "nt", reason="no SIGKILL")
@pytest.mark.parametrize("feature", [1, 2, 3, 4, 5])
def test_killed_while_layers_are_written_it_goes_on(
    files: Files, whole: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, feature: int
) -> None:
    count = sum(map(len, contents(whole).values()))
    assert count >= 4
    left = [count if feature == 5 else feature]
    write = AlgorithmRun.write

    def dying(self: AlgorithmRun, sink: Any, features: Any) -> None:
        def counted() -> Iterator[Any]:
            for feature in features:
                left[0] -= 1
                if not left[0]:
                    os.kill(os.getpid(), signal.SIGKILL)
                yield feature

        write(self, sink, counted())

    def work() -> None:
        monkeypatch.setattr(AlgorithmRun, "write", dying)
        scan(files, tmp_path)

    died(work)
    assert (tmp_path / "loss.tif.scan").exists()
    again = scan(files, tmp_path)
    assert again.complaint is None
    assert_like(tmp_path, whole)


@pytest.mark.skipif(os.name == "nt", reason="no SIGKILL")
def test_killed_while_the_picture_is_written_there_is_none(
    files: Files, whole: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def work() -> None:
        monkeypatch.setattr(
            loss_raster.LossRaster, "close", lambda *_: os.kill(os.getpid(), signal.SIGKILL)
        )
        scan(files, tmp_path)

    died(work)
    left = {path.name for path in tmp_path.iterdir() if not path.name.startswith(".")}
    assert left == {*JOURNAL}
    assert scan(files, tmp_path).complaint is None
    assert_like(tmp_path, whole)


def test_a_changed_setting_or_input_starts_anew_and_says_so(files: Files, tmp_path: Path) -> None:
    (tmp_path / "own").mkdir()
    other_scene = write_scene(tmp_path / "own", images(SHAPE, bands=1))
    results = tmp_path / "results"
    scan(other_scene, results, StopAt(1.0))
    changed = scan(other_scene, results, StopAt(1.0), CELL=64)
    assert changed.log.warnings == [str(messages.SCAN_ANEW())]
    os.utime(other_scene.west, ns=(1, 1))
    touched = scan(other_scene, results, CELL=64)
    assert touched.log.warnings == [str(messages.SCAN_ANEW())]
    assert touched.complaint is None
    assert not (results / "loss.tif.scan").exists()


def test_a_full_disk_keeps_the_blocks_that_are_done(
    files: Files, whole: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    save = RecordFiles.save

    def full(self: RecordFiles, name: str, payload: bytes, is_synced: bool = False) -> None:
        if name == "block 0 2":
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        save(self, name, payload, is_synced)

    with monkeypatch.context() as patched:
        patched.setattr(RecordFiles, "save", full)
        failed = scan(files, tmp_path)
    assert_sentence(failed.complaint, r"\(No space left on device\). What was measured is saved \(blocks done: [1-9]")
    assert sorted(path.name for path in tmp_path.iterdir()) == JOURNAL
    again = scan(files, tmp_path)
    assert any("continues where it stopped" in said for said in again.log.infos)
    assert_like(tmp_path, whole)


def test_a_source_that_is_deleted_while_the_scan_runs_costs_its_blocks_only(
    files: Files, tmp_path: Path
) -> None:
    west, east = images(SHAPE, bands=1)
    written = write_scene(tmp_path, [west, east], name="m")

    class Deleting(Log):
        def __init__(self) -> None:
            super().__init__()
            self.progressChanged.connect(lambda _: Path(written.west).unlink(missing_ok=True))

    log = Deleting()
    ended = run("scanmosaic", log, **written.given(LOSS=str(tmp_path / "loss.tif")))
    assert ended.complaint is None
    assert sum("does not exist" in line for line in log.warnings) <= 1, log.warnings
