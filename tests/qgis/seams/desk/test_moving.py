"""Windows of a project without a file: in the profile under a lock, and beside the project once it is saved."""
from __future__ import annotations

import os
from pathlib import Path

import pytest
from qgis.core import QgsVectorLayer
from seam_inspector.plugin.seams.tables.window_file import count_windows

from tests.qgis.scenes import Scene
from tests.qgis.seams.desk.session_desk import SHARP_WINDOW, Desk, settle


@pytest.fixture
def unsaved(desk: Desk, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Desk:
    """A desk in a project without a file or folder."""
    monkeypatch.setattr("seam_inspector.plugin.seams.desk.window_home.unsaved_folder", lambda: tmp_path)
    desk.project.setPresetHomePath("")
    return desk


@pytest.mark.parametrize("is_edited", [False, True])
def test_the_folder_is_named_and_the_windows_move_at_the_first_saving(
    unsaved: Desk, tmp_path: Path, is_edited: bool
) -> None:
    desk, home = unsaved, tmp_path / "project"
    home.mkdir()
    (home / "windows.gpkg").write_text("somebody else's")
    fids = [desk.add(), desk.add(SHARP_WINDOW)]
    assert desk.messages == [
        "Windows are stored in your profile until the project is saved, then beside it. Now they are in {}."
        .format(tmp_path / "windows.gpkg")
    ]
    if is_edited:
        desk.layer().startEditing()
    desk.session.judge(fids, "visible")
    desk.session.select(fids[:1])
    before = [(row.window_id, row.verdict, row.ratios, row.observer, row.stale) for row in desk.session.windows()]
    assert desk.project.write(str(home / "project.qgz"))
    settle()
    assert desk.messages[1:] == [f"The windows moved beside the project, to {home / 'windows_2.gpkg'}."]
    assert [path.name for path in tmp_path.iterdir() if path.is_file()] == []
    assert (home / "windows.gpkg").read_text() == "somebody else's"
    now = [(row.window_id, row.verdict, row.ratios, row.observer, row.stale) for row in desk.session.windows()]
    assert now == before
    assert [desk.session.row(fid).window_id for fid in desk.session.selected()] == [1]  # type: ignore[union-attr]
    desk.undo()  # steps move with them
    assert [row.observer for row in desk.session.windows()] == ["", ""]
    desk.session.judge([desk.rows()[1].fid], "invisible")
    assert desk.project.write()
    desk.project.clear()
    assert desk.project.read(str(home / "project.qgz"))
    desk.wait_for_opening()
    assert {number: row.observer for number, row in desk.rows().items()} == {1: "invisible", 2: ""}
    assert all(desk.session.result(row.fid) is not None for row in desk.session.windows())
    saved = QgsVectorLayer(f"{home / 'windows_2.gpkg'}|layername=windows", "saved", "ogr")
    assert sorted(feature["observer"] or "" for feature in saved.getFeatures()) == ["", "invisible"]


def test_where_they_can_not_be_moved_they_stay_and_it_is_said(
    unsaved: Desk, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    desk, home = unsaved, tmp_path / "project"
    home.mkdir()
    desk.add()
    monkeypatch.setattr(
        "seam_inspector.plugin.seams.desk.window_home.free_path", lambda *_: home / "no" / "folder.gpkg"
    )
    assert desk.project.write(str(home / "project.qgz"))
    assert desk.messages[-1].startswith(f"The layer Windows of mosaic stays in {tmp_path / 'windows.gpkg'}")
    assert [row.verdict for row in desk.session.windows()] == ["significant"]


def discard(desk: Desk, scene: Scene) -> None:
    """The next project without a file."""
    desk.project.clear()
    settle()
    desk.lay_out(scene)
    desk.set(desk.inputs())
    settle()


def test_what_discarded_projects_leave_does_not_come_back_and_goes(
    unsaved: Desk, scene: Scene, tmp_path: Path
) -> None:
    desk = unsaved
    desk.session.remove([desk.add()])
    discard(desk, scene)
    desk.session.judge([desk.add()], "visible")
    assert [path.name for path in sorted(tmp_path.glob("windows*.lock"))] == ["windows_2.gpkg.lock"]
    discard(desk, scene)
    assert desk.session.windows() == []
    assert [path.name for path in sorted(tmp_path.glob("windows*"))] == ["windows.gpkg", "windows_2.gpkg"]
    past = (tmp_path / "windows.gpkg").stat().st_mtime - 3600
    for path in tmp_path.glob("windows*"):
        os.utime(path, (past, past))
    discard(desk, scene)
    assert count_windows(tmp_path / "windows_2.gpkg") == 1  # for a month
    assert not (tmp_path / "windows.gpkg").exists()
    os.utime(tmp_path / "windows_2.gpkg", (0, 0))
    discard(desk, scene)
    assert not list(tmp_path.glob("windows*"))
