"""Windows of the mosaic that the project was not saved with come back with it."""
from __future__ import annotations

import os
import sqlite3
from contextlib import closing
from pathlib import Path

import pytest

from tests.qgis.scenes import Scene
from tests.qgis.seams.desk.session_desk import SHARP_WINDOW, Desk, settle


@pytest.fixture
def left(desk: Desk, tmp_path: Path) -> Desk:
    """Windows that were judged in a project that was saved before them and then left."""
    home = tmp_path / "project"
    home.mkdir()
    desk.project.setPresetHomePath("")
    assert desk.project.write(str(home / "project.qgz"))
    desk.session.judge([desk.add(), desk.add(SHARP_WINDOW)], "visible")
    desk.project.clear()
    settle()
    return desk


def read_again(desk: Desk, project: Path) -> None:
    assert desk.project.read(str(project))
    desk.wait_for_opening()
    settle(0.1)


@pytest.mark.parametrize("folder", ["project", "moved"])
@pytest.mark.parametrize("name", ["project.qgz", "renamed.qgz"])
def test_windows_that_the_project_was_not_saved_with_are_back(
    left: Desk, tmp_path: Path, folder: str, name: str
) -> None:
    desk, moved = left, tmp_path / folder
    (tmp_path / "project" / "project.qgz").rename(tmp_path / "project" / name)
    (tmp_path / "project").rename(moved)
    read_again(desk, moved / name)
    assert [message for message in desk.messages if "windows" in message] == [
        f"Windows of this mosaic were restored. The project lacked them; they are in {moved / 'windows.gpkg'}."
    ]
    assert [(row.observer, row.stale) for row in desk.session.windows()] == [("visible", False)] * 2
    assert all(desk.session.result(row.fid) is not None for row in desk.session.windows())


def test_nothing_comes_back_that_the_project_knows_or_let_go_or_of_another_mosaic(
    left: Desk, scene: Scene, tmp_path: Path
) -> None:
    desk, home = left, tmp_path / "project"
    read_again(desk, home / "project.qgz")
    layer = desk.layer()
    desk.project.removeMapLayer(layer.id())
    settle()
    assert desk.session.windows() == []
    os.utime(home / "windows.gpkg", (0, 0))
    assert desk.project.write()
    read_again(desk, home / "project.qgz")
    assert desk.session.windows() == []
    os.utime(home / "windows.gpkg")
    mosaic = desk.session.mosaic_layer()
    assert mosaic is not None
    mosaic.setDataSource(str(scene.west), "another", "gdal")
    desk.wait_for_opening()
    settle()
    assert desk.session.windows() == []
    assert len([message for message in desk.messages if "windows" in message]) == 1


ENDLESS = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT i AS {}, i AS {}, i AS {} FROM n"


def test_a_view_that_never_ends_beside_a_project_is_not_read(desk: Desk, tmp_path: Path) -> None:
    """Nobody chose the file: opening the project must not wait for it."""
    desk.project.setPresetHomePath("")
    assert desk.project.write(str(tmp_path / "project.qgz"))
    with closing(sqlite3.connect(tmp_path / "windows.gpkg")) as database:
        database.execute(f"CREATE VIEW windows AS {ENDLESS.format('window_id', 'verdict', 'observer')}")
        database.commit()
    later = (tmp_path / "project.qgz").stat().st_mtime + 10
    os.utime(tmp_path / "windows.gpkg", (later, later))
    desk.project.clear()
    read_again(desk, tmp_path / "project.qgz")
    assert desk.session.windows() == []
