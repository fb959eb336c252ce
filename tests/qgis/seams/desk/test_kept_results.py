"""Results are kept beside the window layer and are there on reopening, and nothing is shown that is not of a window."""
from __future__ import annotations

import os
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from qgis.core import QgsVectorLayer
from seam_inspector.plugin.imagery.record_store import RecordFiles
from seam_inspector.plugin.seams.desk.keeping import _KIND

from tests.qgis.scenes import BLURRED, SHARP, outline, saved, windows
from tests.qgis.seams.desk.session_desk import SHARP_WINDOW, Desk, settle


def reopen(desk: Desk, path: Path) -> None:
    """Save the project with its windows, close it, open it again."""
    project = str(path / "project.qgz")
    assert desk.project.write(project)
    desk.project.clear()
    desk.project.setPresetHomePath("")
    assert desk.project.read(project)
    desk.wait_for_opening()
    settle()


def test_results_are_there_on_reopening(desk: Desk, tmp_path: Path) -> None:
    for window in (None, SHARP_WINDOW):
        desk.add(*[window] if window else [])
    before = {number: desk.session.result(row.fid) for number, row in desk.rows().items()}
    reopen(desk, tmp_path)
    assert not desk.session.is_busy
    for number, row in desk.rows().items():
        found, had = desk.session.result(row.fid), before[number]
        assert found == had
        assert found is not had
        assert found is not None
        assert had is not None
        assert found.profile == had.profile
        assert (found.loss is None) == (had.loss is None)
        if found.loss is not None and had.loss is not None:
            np.testing.assert_allclose(found.loss.kept, had.loss.kept, rtol=6e-4)
    (folder,) = tmp_path.glob("*.results")
    assert sum(path.stat().st_size for path in folder.iterdir()) < 30_000


def test_a_layer_that_is_removed_and_added_again_finds_its_results(desk: Desk) -> None:
    desk.add()
    assert desk.layer().commitChanges()
    source = desk.layer().source()
    desk.project.removeMapLayers([desk.layer().id()])
    desk.use(QgsVectorLayer(source, "again", "ogr"))
    assert desk.session.result(desk.rows()[1].fid) is not None


def test_what_changed_is_stale_after_reopening_as_before(desk: Desk, tmp_path: Path) -> None:
    fid = desk.add()
    desk.add(SHARP_WINDOW)
    desk.layer().changeGeometry(fid, outline((320, 96, 128, 128)))
    reopen(desk, tmp_path)
    rows = desk.rows()
    assert [rows[number].stale for number in (1, 2)] == [True, False]
    desk.session.set_inputs(replace(desk.session.inputs, wavelet="db4"))
    assert all(row.stale for row in desk.session.windows())
    assert desk.session.result(rows[2].fid) is not None


def test_values_of_another_inspection_get_no_result_of_ours(desk: Desk, tmp_path: Path) -> None:
    desk.add()
    reopen(desk, tmp_path)
    layer = desk.layer()
    layer.startEditing()
    (fid,) = [row.fid for row in desk.session.windows()]
    layer.changeAttributeValue(fid, layer.fields().indexOf("ratio_1"), 0.123)
    assert desk.session.result(fid) is None


@pytest.mark.parametrize("damage", ["garbage", "cut", "older", "gone"])
def test_what_cannot_be_read_is_measured_again(desk: Desk, tmp_path: Path, damage: str) -> None:
    desk.add()
    assert desk.project.write(str(tmp_path / "project.qgz"))
    desk.project.clear()
    (folder,) = tmp_path.glob("*.results")
    held = (folder / "1").read_bytes()
    if damage == "garbage":
        (folder / "1").write_bytes(held[:200] + os.urandom(len(held) - 200))
    elif damage == "cut":
        (folder / "1").write_bytes(held[: len(held) // 2])
    elif damage == "older":
        RecordFiles(folder).save(".about", f"{_KIND}\n1".encode())
    else:
        shutil.rmtree(folder)
    desk.project.setPresetHomePath("")
    assert desk.project.read(str(tmp_path / "project.qgz"))
    desk.wait_for_opening()
    (row,) = desk.session.windows()
    assert desk.session.result(row.fid) is None
    desk.session.inspect([row.fid])
    desk.wait()
    assert desk.session.result(row.fid) is not None
    reopen(desk, tmp_path)
    assert desk.session.result(desk.rows()[1].fid) is not None
    assert not any("kept" in told or "QGIS ended" in told for told in desk.messages)


def test_a_folder_that_cannot_be_written_to_is_told_once(desk: Desk, tmp_path: Path) -> None:
    path = saved(windows(BLURRED, SHARP), tmp_path / "given.gpkg")
    for ending in ("given.results", "given.unsaved"):
        (tmp_path / f"given.gpkg.{ending}").write_text("somebody else's")
    desk.use(QgsVectorLayer(path, "given", "ogr"))
    desk.session.inspect_pending()
    desk.wait()
    settle(0.1)
    assert all(row.verdict for row in desk.session.windows())
    assert len(desk.messages) == 2
    assert any(told.startswith("Curves and pictures of the windows can't be kept in") for told in desk.messages)
    assert any(told.startswith("Your verdicts are safe only once you save the layer") for told in desk.messages)


def test_a_layer_in_no_file_says_once_that_nothing_is_kept(desk: Desk) -> None:
    desk.use(windows(BLURRED, SHARP))
    desk.session.inspect_pending()
    desk.wait()
    assert desk.messages == []
    for row in desk.session.windows():
        desk.session.judge([row.fid], "visible")
    (told,) = desk.messages
    assert told.startswith("The windows in made are in no file: they and their verdicts are lost when QGIS ends.")


def test_shapefiles_are_kept_too(desk: Desk, tmp_path: Path) -> None:
    path = saved(windows(BLURRED), tmp_path / "given.shp")
    desk.use(QgsVectorLayer(path, "given", "ogr"))
    desk.session.inspect_pending()
    desk.wait()
    desk.session.judge([row.fid for row in desk.session.windows()], "visible")
    settle(0.1)
    assert (tmp_path / "given.shp.unsaved").exists()
    reopen(desk, tmp_path)
    assert not (tmp_path / "given.shp.unsaved").exists()
    (row,) = desk.session.windows()
    assert (row.verdict, row.observer) == ("significant", "visible")
    assert desk.session.result(row.fid) is not None
