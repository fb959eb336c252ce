"""Windows of a project without a file: a folder that is named, moved beside the project when it is saved."""
from __future__ import annotations

from pathlib import Path

import pytest
from qgis.core import QgsProject, QgsVectorLayer

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
    (tmp_path / "windows.gpkg.results").unlink()
    (tmp_path / "windows.gpkg.results").mkdir()
    taken = home / "windows.gpkg"
    taken.write_text("somebody else's")
    assert desk.project.write(str(home / "project.qgz"))
    assert taken.read_text() == "somebody else's"
    assert Path(desk.layer().source().split("|")[0]) == home / "windows_2.gpkg"


def test_windows_of_a_project_that_was_never_saved_are_found_after_a_crash(
    unsaved: Desk, scene: Scene, project: QgsProject, tmp_path: Path
) -> None:
    desk = unsaved
    fid = desk.add()
    desk.session.judge([fid], "visible")
    settle(0.1)
    held = {path: path.read_bytes() for path in tmp_path.glob("windows.gpkg*")}
    desk.layer().rollBack()
    found: list[Path] = []
    desk.session.windowsFound.connect(found.append)
    project.clear()
    settle()
    assert found == []
    for path, content in held.items():  # as the crash would have left them
        path.write_bytes(content)
    project.clear()
    wait_until(lambda: found, "for what was left")
    assert found == [tmp_path / "windows.gpkg"]
    desk.mosaic, desk.sources = desk.raster(scene.mosaic), [desk.raster(scene.west), desk.raster(scene.east)]
    desk.session.open_windows(found[0])
    (row,) = desk.session.windows()
    assert (row.verdict, row.observer) == ("significant", "visible")
    assert desk.messages[-1].startswith("QGIS ended without saving; the changes of")
