"""Results are in the windows file and are there on reopening, and nothing is shown that is not of a window."""
from __future__ import annotations

import os
import sqlite3
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.qgis.scenes import outline
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
        items, had = desk.session.result(row.fid), before[number]
        assert items == had
        assert items is not had
        assert items is not None
        assert had is not None
        assert items.profile == had.profile
        assert (items.loss is None) == (had.loss is None)
        if items.loss is not None and had.loss is not None:
            np.testing.assert_allclose(items.loss.kept, had.loss.kept, rtol=6e-4)
    with closing(sqlite3.connect(tmp_path / "windows.gpkg")) as file:
        assert file.execute("SELECT sum(length(record)) FROM results").fetchone()[0] < 30_000


def test_what_changed_is_stale_after_reopening_as_before(desk: Desk, tmp_path: Path) -> None:
    fid = desk.add()
    desk.add(SHARP_WINDOW)
    desk.move(fid, outline((320, 96, 128, 128)))
    reopen(desk, tmp_path)
    rows = desk.rows()
    assert [rows[number].stale for number in (1, 2)] == [True, False]
    desk.session.set_inputs(replace(desk.session.inputs, wavelet="db4"))
    assert all(row.stale for row in desk.session.windows())
    assert desk.session.result(rows[2].fid) is not None


def test_values_of_another_inspection_get_no_result_of_ours(desk: Desk) -> None:
    fid, layer = desk.add(), desk.layer()
    layer.startEditing()
    layer.changeAttributeValue(fid, layer.fields().indexOf("ratio_1"), 0.123)
    assert desk.session.result(fid) is None
    assert desk.rows()[1].stale


@pytest.mark.parametrize("damage", ["garbage", "cut", "gone"])
def test_what_cannot_be_read_is_measured_again(desk: Desk, tmp_path: Path, damage: str) -> None:
    desk.add()
    assert desk.project.write(str(tmp_path / "project.qgz"))
    desk.project.clear()
    settle()
    with closing(sqlite3.connect(tmp_path / "windows.gpkg")) as file:
        (held,) = file.execute("SELECT record FROM results").fetchone()
        made = {"garbage": held[:200] + os.urandom(len(held) - 200), "cut": held[: len(held) // 2], "gone": None}
        file.execute("UPDATE results SET record = ?", [made[damage]])
        file.commit()
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
    assert not any("windows" in message for message in desk.messages)
