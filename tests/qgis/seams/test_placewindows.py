"""``seaminspector:placewindows`` through QGIS."""
from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from qgis.core import QgsGeometry, QgsPointXY, QgsVectorLayer

from tests.numbers.synthetic import UTM33, write_raster
from tests.qgis.runs import Run, run
from tests.qgis.scenes import COLUMNS, PIXEL, ROWS, Scene, at, layer, line, moved, pixel_box, whole

pytestmark = pytest.mark.usefixtures("provider")

SIDE = 6.4  # m: 64 px
BEND = ((200, 0), (240, 90), (300, 150), (280, 256))  # a seam from the top of the mosaic to its bottom


def seamlines(*geometries: QgsGeometry | None, epsg: int | None = UTM33) -> QgsVectorLayer:
    return layer("LineString", geometries, epsg)


def cells(*polygons: Sequence[tuple[float, float]]) -> QgsVectorLayer:
    """Polygons by their corners on the mosaic's grid."""
    return layer("Polygon", [QgsGeometry.fromPolygonXY([[QgsPointXY(*at(*xy)) for xy in ring]]) for ring in polygons])


def place(scene: Scene, **parameters: Any) -> Run:
    given = {"SEAMLINES": seamlines(line(*BEND)), "MOSAIC": str(scene.mosaic), "SIDE": SIDE, "SPACING": SIDE}
    return run("placewindows", **{**given, **parameters})


def boxes(placed: Run) -> list[tuple[float, ...]]:
    assert placed.complaint is None
    return [pixel_box(feature.geometry()) for feature in placed.features()]


def assert_on_pixels(placed: Run, side_px: int) -> None:
    """Windows are squares of whole pixels of the mosaic, inside it."""
    for column, row, width, height in boxes(placed):
        assert (width, height) == (side_px, side_px)
        assert column == int(column)
        assert row == int(row)
        assert 0 <= column <= COLUMNS - side_px
        assert 0 <= row <= ROWS - side_px


def assert_on_seam(placed: Run, seam: QgsGeometry) -> None:
    """Windows are centred on the seam, to half a pixel each way, at their stations along it."""
    for feature in placed.features():
        centre = feature.geometry().centroid()
        assert centre.distance(seam) <= PIXEL * math.sqrt(0.5) + 1e-6
        along = seam.lineLocatePoint(centre)
        assert feature["station"] == pytest.approx(along, abs=PIXEL) or feature["station"] == pytest.approx(
            seam.length() - along, abs=PIXEL
        )


# --- the contract ----------------------------------------------------------------------------------------------


def test_windows_lie_on_the_seam_and_on_the_pixels(scene: Scene) -> None:
    placed = place(scene)
    assert_on_pixels(placed, 64)
    assert_on_seam(placed, line(*BEND))
    assert placed.column("window_id") == list(range(1, len(placed.features()) + 1))
    assert set(placed.column("seam_id")) == {1}
    assert len(placed.features()) == 5  # 29.1 m at 6.4 m
    assert any("5 windows" in info for info in placed.log.infos)


# --- kinds of seamlines ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("epsg", [4326, 3857, 25833, 2180])
def test_seamlines_in_another_reference_system(scene: Scene, epsg: int) -> None:
    placed = place(scene, SEAMLINES=seamlines(moved(line(*BEND), epsg), epsg=epsg))
    assert placed.layer().crs().authid() == f"EPSG:{UTM33}"
    expected = np.array(sorted(boxes(place(scene))))
    np.testing.assert_allclose(sorted(boxes(placed)), expected, atol=1)  # a tenth of a millimetre can turn a rounding


def test_polygons_have_windows_where_they_touch(scene: Scene) -> None:
    west = [(0, 0), *BEND, (0, 256)]
    east = [(512, 0), *BEND, (512, 256)]
    placed = place(scene, SEAMLINES=cells(west, east))
    assert_on_pixels(placed, 64)
    assert_on_seam(placed, line(*BEND))
    assert sorted(boxes(placed)) == sorted(boxes(place(scene)))


# --- what is in the way ----------------------------------------------------------------------------------------


def test_windows_are_moved_off_nodata_or_dropped_and_the_log_says_so(scene: Scene, tmp_path: Path) -> None:
    pixels = whole(scene.mosaic)
    pixels[:, :, :60] = 0  # a collar in the west, and a strip
    pixels[:, :, 250:330] = 0
    collar = write_raster(tmp_path / "collar.tif", pixels, nodata=0)
    seam = line((0, 128), (512, 128))
    placed = place(scene, SEAMLINES=seamlines(seam), MOSAIC=collar, SPACING=8.0)
    assert len(placed.features()) > 2
    assert_on_pixels(placed, 64)
    assert_on_seam(placed, seam)
    for column, row, width, height in boxes(placed):
        clip = pixels[0, int(row) : int(row + height), int(column) : int(column + width)]
        assert (clip == 0).mean() <= 0.001
    untouched = place(scene, SEAMLINES=seamlines(seam), SPACING=8.0)
    assert not untouched.log.warnings
    there = set(placed.column("station")) - set(untouched.column("station"))
    assert there, "no window was moved"
    assert len(placed.features()) < len(untouched.features())
    (warning,) = placed.log.warnings
    assert warning.startswith("Places along the seams without a window")


# --- bad input -------------------------------------------------------------------------------------------------


def test_metres_are_metres_on_a_geographic_mosaic(tmp_path: Path) -> None:
    height = 0.1 / 111_230  # degrees of latitude for 0.1 m, at 50 degrees
    width = height / math.cos(math.radians(50))
    middle = 19 + 150 * width
    pixels = np.random.default_rng(0).integers(1, 255, (300, 300), dtype=np.uint8)
    mosaic = write_raster(
        tmp_path / "degrees.tif", pixels, system=4326, geotransform=(19.0, width, 0.0, 50.0, 0.0, -height)
    )
    seam = QgsGeometry.fromWkt(f"LINESTRING({middle!r} 50, {middle!r} {50 - 300 * height!r})")
    placed = run("placewindows", SEAMLINES=seamlines(seam, epsg=4326), MOSAIC=mosaic, SIDE=6.3, SPACING=10.0)
    assert placed.layer().crs().authid() == "EPSG:4326"
    assert len(placed.features()) == 3
    assert np.diff(placed.column("station")) == pytest.approx(10.0)
    assert {round(feature.geometry().boundingBox().height() / height, 3) for feature in placed.features()} == {64}
