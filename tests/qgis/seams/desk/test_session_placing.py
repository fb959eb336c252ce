"""What the desk tells after it placed windows: one short sentence, and the rest in the log."""
from __future__ import annotations

import sqlite3
from contextlib import closing
from pathlib import Path

import pytest
from qgis.core import Qgis, QgsCoordinateReferenceSystem, QgsGeometry
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.seams.words import shown_side
from seam_inspector.plugin.toolkit.layers import layer_path, system_wkt

from tests.numbers.synthetic import write_raster
from tests.qgis.emptied import emptied_system
from tests.qgis.scenes import UTM33, Box, layer, line, whole, windows
from tests.qgis.seams.desk.session_desk import Desk, wait_for_tasks

_WHOLE = line((256, 0), (256, 256))
_BAR_CHARACTERS = 110  # about what the message bar shows of a sentence


def place(desk: Desk, lines: list[QgsGeometry]) -> str:
    """What is told once windows are placed along some lines."""
    seams = layer("LineString", lines)
    desk.project.addMapLayer(seams)
    desk.session.set_inputs(desk.inputs(seamlines=seams.id()))
    wait_for_tasks()
    desk.messages.clear()
    desk.session.place_windows()
    desk.wait()
    assert len(desk.messages) == 1
    assert len(desk.messages[0]) < _BAR_CHARACTERS or not desk.session.windows()
    return desk.messages[0]


def test_placing_twice_doubles_nothing(desk: Desk) -> None:
    said = place(desk, [_WHOLE])
    assert said.startswith(f"Windows placed along the seams: {len(desk.session.windows())}; places taken before: 0.")
    assert desk.levels[-1] == Qgis.MessageLevel.Success
    before = {row.window_id: row.extent for row in desk.session.windows()}
    desk.layer().commitChanges(False)  # files may round coordinates
    said = place(desk, [_WHOLE])
    assert said == f"Windows placed along the seams: 0; places taken before: {len(before)}."
    assert {row.window_id: row.extent for row in desk.session.windows()} == before
    desk.session.remove([min(row.fid for row in desk.session.windows())])
    said = place(desk, [_WHOLE])
    assert said.startswith(f"Windows placed along the seams: 1; places taken before: {len(before) - 1}.")
    assert sorted(row.extent for row in desk.session.windows()) == sorted(before.values())


@pytest.mark.parametrize(
    ("judged", "places", "numbers"),
    [
        ((0, 0, 64, 64), [(16, 0, 64, 64), (0, 40, 64, 64)], [1, 2]),  # most of the first was judged
        ((0, 0, 128, 128), [(8, 8, 64, 64), (60, 56, 64, 64)], [1, 1]),  # both lie in it
        ((32, 32, 64, 64), [(0, 0, 128, 128)], [2]),  # of which a quarter was judged
    ],
)
def test_a_place_of_a_scan_is_the_judged_window_that_holds_most_of_it(
    desk: Desk, judged: Box, places: list[Box], numbers: list[int]
) -> None:
    desk.session.judge([desk.add(PixelWindow(*judged))], "visible")
    count = len(places)
    worst = windows(
        *places, window_id=("integer", list(range(count))), seam_id=("integer", [1] * count),
        station=("double", [0.0] * count),
    )  # fmt: skip
    taken: list[list[int]] = []
    desk.session.placesTaken.connect(taken.append)
    desk.session.take_places(worst)
    desk.wait()
    (fids,) = taken
    assert [desk.session.row(fid).window_id for fid in fids] == numbers  # type: ignore[union-attr]
    grid = desk.session.mosaic_grid()
    assert grid is not None
    assert f", {shown_side(places[0][2] * grid.ground_sample_distance)} m wide;" in desk.messages[-1]


def test_no_window_is_drawn_where_the_mosaic_has_no_pixels(desk: Desk, tmp_path: Path) -> None:
    pixels = whole(Path(desk.mosaic.source()))
    pixels[..., :70, :] = 0
    desk.mosaic = desk.raster(Path(write_raster(tmp_path / "holed.tif", pixels, nodata=0)))
    desk.set(desk.inputs())
    desk.session.add_window(PixelWindow(0, 0, 128, 128))
    desk.wait()
    assert desk.messages == ["No window there: pixels are missing. Draw a smaller one beside the edge."]
    assert desk.session.window_layer() is None
    desk.session.add_window(PixelWindow(0, 72, 128, 128))
    desk.wait()
    assert len(desk.session.windows()) == 1


@pytest.mark.slow
def test_windows_lie_in_the_mosaics_system_when_a_thread_has_emptied_qgis_s(desk: Desk) -> None:
    """The task that opened the mosaic was the first to ask for its system, and ended 30 s later."""
    emptied = emptied_system(system_wkt(desk.mosaic.crs()))
    assert not emptied.toWkt()
    try:
        desk.session.place_windows()
        desk.wait()
        made = desk.layer()
        with closing(sqlite3.connect(made.source().partition("|")[0])) as file:
            assert file.execute("SELECT srs_id FROM gpkg_geometry_columns").fetchall() == [(UTM33,)]
        assert made.crs().toWkt()
        desk.session.inspect_pending()
        desk.wait()
        assert all(row.verdict for row in desk.session.windows())
    finally:
        QgsCoordinateReferenceSystem.invalidateCache()


def test_windows_whose_file_is_missing_are_not_begun_anew(desk: Desk) -> None:
    desk.session.add_window(PixelWindow(0, 0, 128, 128))
    desk.wait()
    path = Path(layer_path(desk.layer()))
    desk.layer().setDataSource(str(path.with_name("moved.gpkg")), "windows", "ogr")
    desk.messages.clear()
    desk.session.add_window(PixelWindow(64, 64, 128, 128))
    desk.wait()
    assert "moved.gpkg" in desk.messages[0]
    assert [file.name for file in path.parent.glob("*.gpkg")] == [path.name]
