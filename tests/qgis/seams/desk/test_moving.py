"""Windows of a project without a file: a folder that is named, moved beside the project when it is saved."""
from __future__ import annotations

import os
import shutil
from pathlib import Path

import pytest
from qgis.core import QgsVectorLayer
from qgis.gui import QgsMessageBar
from qgis.PyQt.QtWidgets import QPushButton
from seam_inspector.plugin.seams.desk.dock import FoundMessage
from seam_inspector.plugin.seams.tables.window_layer import count_windows

from tests.qgis.scenes import Scene
from tests.qgis.seams.desk.session_desk import SHARP_WINDOW, Desk, settle, wait_until


@pytest.fixture
def unsaved(desk: Desk, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Desk:
    """A desk in a project without a file or folder."""
    monkeypatch.setattr("seam_inspector.plugin.seams.desk.keeping.unsaved_folder", lambda: tmp_path)
    desk.project.setPresetHomePath("")
    return desk


def test_the_folder_is_named_and_the_windows_move_at_the_first_saving(unsaved: Desk, tmp_path: Path) -> None:
    desk, home = unsaved, tmp_path / "project"
    home.mkdir()
    fids = [desk.add(), desk.add(SHARP_WINDOW)]
    assert desk.messages == [
        f"Until the project is saved its windows are in {tmp_path / 'windows.gpkg'}; they move beside the project then."
    ]
    desk.session.judge(fids, "visible")
    settle(0.1)
    assert (tmp_path / "windows.gpkg.unsaved").exists()
    desk.session.select(fids[:1])
    before = [(row.window_id, row.verdict, row.ratios, row.observer, row.stale) for row in desk.session.windows()]
    assert desk.project.write(str(home / "project.qgz"))
    settle()
    assert desk.messages[1:] == [f"The windows moved beside the project, to {home / 'windows.gpkg'}."]
    assert sorted(path.name for path in tmp_path.iterdir() if path.is_file()) == []
    assert desk.layer().isEditable()
    now = [(row.window_id, row.verdict, row.ratios, row.observer, row.stale) for row in desk.session.windows()]
    assert now == before
    assert [desk.session.row(fid).window_id for fid in desk.session.selected()] == [1]  # type: ignore[union-attr]
    desk.session.judge([desk.rows()[1].fid], "invisible")
    settle(0.1)
    assert (home / "windows.gpkg.unsaved").exists()
    assert desk.project.write()
    desk.project.clear()
    assert desk.project.read(str(home / "project.qgz"))
    desk.wait_for_opening()
    assert {number: row.observer for number, row in desk.rows().items()} == {1: "invisible", 2: "visible"}
    wait_until(
        lambda: all(desk.session.result(row.fid) is not None for row in desk.session.windows()), "for what was measured"
    )
    saved = QgsVectorLayer(f"{home / 'windows.gpkg'}|layername=windows", "saved", "ogr")
    assert sorted(feature["observer"] for feature in saved.getFeatures()) == ["invisible", "visible"]


def test_where_they_can_not_be_moved_they_stay_and_it_is_said(unsaved: Desk, tmp_path: Path) -> None:
    desk, home = unsaved, tmp_path / "project"
    home.mkdir()
    desk.add()
    shutil.rmtree(tmp_path / "windows.gpkg.results")
    (tmp_path / "windows.gpkg.results").write_text("somebody else's")
    taken = home / "windows.gpkg"
    taken.write_text("somebody else's")
    assert desk.project.write(str(home / "project.qgz"))
    assert taken.read_text() == "somebody else's"
    assert Path(desk.layer().source().split("|")[0]) == home / "windows_2.gpkg"


def crash(desk: Desk, folder: Path) -> None:
    """What is on the disk stays as it is; then QGIS starts anew."""
    settle(0.1)
    held = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    if desk.layer().isEditable():
        desk.layer().rollBack()
    desk.project.clear()
    settle()
    for path, content in held.items():
        path.parent.mkdir(exist_ok=True)
        path.write_bytes(content)
    desk.project.clear()
    settle()


def open_block(desk: Desk, scene: Scene) -> None:
    desk.lay_out(scene)
    desk.set(desk.inputs())


def discard(desk: Desk, scene: Scene) -> None:
    """The next project without a file."""
    if desk.layer().isEditable():
        desk.layer().rollBack()
    desk.project.clear()
    settle()
    open_block(desk, scene)


@pytest.mark.parametrize("discarded", [0, 1, 2])
@pytest.mark.parametrize("is_saved", [False, True])
def test_windows_of_any_project_that_was_never_saved_are_offered_after_a_crash(
    unsaved: Desk, scene: Scene, tmp_path: Path, discarded: int, is_saved: bool
) -> None:
    desk = unsaved
    for _ in range(discarded):
        desk.session.judge([desk.add()], "unsure")
        discard(desk, scene)
    found: list[Path] = []
    desk.session.windowsFound.connect(lambda path, message: found.append(path))
    desk.session.judge([desk.add(), desk.add(SHARP_WINDOW)], "visible")
    if is_saved:  # the layer, which empties its edits, and not the project
        assert desk.layer().commitChanges()
    crash(desk, tmp_path)
    windows = tmp_path / (f"windows_{discarded + 1}.gpkg" if discarded else "windows.gpkg")
    assert set(found) == {windows}
    open_block(desk, scene)
    desk.session.open_windows(windows)
    desk.wait_for_opening()
    assert [(row.verdict, row.observer) for row in desk.session.windows()] == [
        ("significant", "visible"), ("preserved", "visible")
    ]
    assert all(desk.session.result(row.fid) is not None for row in desk.session.windows())
    found.clear()
    discard(desk, scene)
    assert not found


def test_the_windows_of_two_crashes_are_offered_one_after_the_other(
    unsaved: Desk, scene: Scene, tmp_path: Path
) -> None:
    desk, bar = unsaved, QgsMessageBar()
    for _ in range(2):
        desk.session.judge([desk.add()], "visible")
        crash(desk, tmp_path)
        open_block(desk, scene)
    offer = FoundMessage(bar, desk.session.open_windows, bar)
    desk.session.windowsFound.connect(offer.show)
    desk.project.clear()
    said = []
    for _ in range(2):
        settle(0.1)
        said.append(bar.currentItem().text())
        bar.currentItem().findChild(QPushButton).click()
        assert [row.observer for row in desk.session.windows()] == ["visible"]
        desk.layer().commitChanges()
        desk.project.clear()
    assert [name in text for name, text in zip(("windows_2.gpkg", "windows.gpkg"), said)] == [True, True]
    offer.close()


def test_what_discarded_projects_leave_empty_goes(unsaved: Desk, scene: Scene, tmp_path: Path) -> None:
    desk = unsaved
    desk.add()
    discard(desk, scene)
    desk.session.judge([desk.add()], "visible")
    assert desk.layer().commitChanges()
    assert [path.name for path in sorted(tmp_path.glob("windows*.gpkg"))] == ["windows.gpkg", "windows_2.gpkg"]
    for path in tmp_path.iterdir():
        os.utime(path, (0, 0))
    discard(desk, scene)
    settle()
    assert [path.name for path in tmp_path.iterdir() if path.name.startswith("windows.gpkg")] == []
    assert count_windows(tmp_path / "windows_2.gpkg") == 1


@pytest.mark.parametrize("folder", ["project", "moved"])
@pytest.mark.parametrize("name", ["project.qgz", "renamed.qgz"])
def test_what_was_judged_comes_back_into_a_project_that_was_moved_or_renamed(
    unsaved: Desk, tmp_path: Path, folder: str, name: str
) -> None:
    """It was saved before its windows were made, and never with them."""
    desk, home, moved = unsaved, tmp_path / "project", tmp_path / folder
    home.mkdir()
    (home / "windows.gpkg").write_text("somebody else's")
    assert desk.project.write(str(home / "project.qgz"))
    desk.session.judge([desk.add()], "visible")
    crash(desk, home)
    (home / "project.qgz").rename(home / name)
    home.rename(moved)
    assert desk.project.read(str(moved / name))
    wait_until(desk.session.windows, "for the windows")
    desk.wait_for_opening()
    (row,) = desk.session.windows()
    assert (row.verdict, row.observer) == ("significant", "visible")
    assert desk.session.result(row.fid) is not None
    assert Path(desk.layer().source().split("|")[0]) == moved / "windows_2.gpkg"


def test_results_move_with_the_windows_of_a_second_project(unsaved: Desk, scene: Scene, tmp_path: Path) -> None:
    desk, home = unsaved, tmp_path / "project"
    home.mkdir()
    desk.add()
    discard(desk, scene)
    desk.add()
    assert desk.project.write(str(home / "project.qgz"))
    settle()
    assert {path.name for path in home.glob("*.results")} == {"windows.gpkg.results"}
    desk.project.clear()
    assert desk.project.read(str(home / "project.qgz"))
    desk.wait_for_opening()
    (row,) = desk.session.windows()
    assert desk.session.result(row.fid) is not None
