"""Windows that were saved, but not the project with them, are not lost from sight."""
from __future__ import annotations

import os
import sqlite3
from contextlib import closing
from pathlib import Path

import pytest
from qgis.core import Qgis
from qgis.gui import QgsMessageBar
from qgis.PyQt.QtWidgets import QPushButton
from seam_inspector.plugin.seams.desk.dock import FoundMessage
from seam_inspector.plugin.toolkit.project_settings import load_settings

from tests.qgis.seams.desk.session_desk import SHARP_WINDOW, Desk, settle, wait_until


@pytest.fixture
def left(desk: Desk, tmp_path: Path) -> Desk:
    """Windows that were judged and saved by QGIS itself, in a project that was saved before them and then left."""
    home = tmp_path / "project"
    home.mkdir()
    desk.project.setPresetHomePath("")
    assert desk.project.write(str(home / "project.qgz"))
    desk.session.judge([desk.add(), desk.add(SHARP_WINDOW)], "visible")
    assert desk.layer().commitChanges()
    desk.project.clear()
    settle()
    return desk


def read_again(desk: Desk, home: Path) -> None:
    assert desk.project.read(str(home / "project.qgz"))
    settle(0.1)


def test_windows_that_the_project_was_not_saved_with_are_offered(left: Desk, tmp_path: Path) -> None:
    desk, home, bar = left, tmp_path / "project", QgsMessageBar()
    found = FoundMessage(bar, desk.session.open_windows, bar)
    desk.session.windowsFound.connect(found.show)
    for _ in range(2):  # the project is left without saving once more
        read_again(desk, home)
        wait_until(bar.currentItem, "for the offer")
        item = bar.currentItem()
        assert item.text() == "windows.gpkg beside this project holds 2 windows that the project does not know."
        assert item.level() == Qgis.MessageLevel.Warning
        item.findChild(QPushButton).click()
        desk.wait_for_opening()
        assert [row.observer for row in desk.session.windows()] == ["visible", "visible"]
        assert all(desk.session.result(row.fid) is not None for row in desk.session.windows())
        desk.project.clear()
        settle()
    found.close()


def test_nothing_is_offered_of_what_the_project_knows_or_let_go(left: Desk, tmp_path: Path) -> None:
    desk, home = left, tmp_path / "project"
    found: list[Path] = []
    desk.session.windowsFound.connect(lambda path, message: found.append(path))
    read_again(desk, home)
    assert found == [home / "windows.gpkg"]
    desk.session.open_windows(found.pop())
    assert desk.project.write()
    read_again(desk, home)
    assert found == []
    assert len(desk.session.windows()) == 2
    desk.project.removeMapLayer(desk.layer().id())
    settle()
    os.utime(home / "windows.gpkg", (0, 0))
    assert desk.project.write()
    (home / "windows_2.gpkg").write_text("somebody else's")
    os.utime(home / "windows_2.gpkg")
    read_again(desk, home)
    assert found == []


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
    found: list[object] = []
    desk.session.windowsFound.connect(lambda *of: found.append(of))
    read_again(desk, tmp_path)
    assert found == []


@pytest.mark.parametrize("text", ["[" * 100_000 + "]" * 100_000, "{", "9" * 10_000, "[]"])
def test_settings_of_a_project_that_nobody_understands_are_none(desk: Desk, text: str) -> None:
    desk.project.writeEntry("SeamInspector", "key", text)
    assert load_settings(desk.project, "key") == {}


@pytest.mark.parametrize("stale", [["--5", "\u00b2", "1"], "--5", "\u00b2", 7, {"a": 1}, [[]]], ids=str)
def test_marks_of_others_in_a_layer_are_no_marks(desk: Desk, stale: object) -> None:
    desk.add()
    layer = desk.layer()
    layer.setCustomProperty("seam_inspector/stale", stale)
    watch = desk.session._watch
    watch.watch(None)
    watch.watch(layer)
    marked = {number for number, row in desk.rows().items() if row.stale}
    assert marked == ({1} if isinstance(stale, list) and "1" in stale else set())
