"""A sheet of a mosaic with its neighbours: measured as in the whole, and counted alone."""
from __future__ import annotations

import math
import shutil
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal, ogr
from seam_inspector import Block, SettingsError, inspect_window, open_block, scan
from seam_inspector.plugin.imagery.open_raster import describe
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.imagery.seam_totals import MOSAIC_FILES
from seam_inspector.plugin.seams.measure.window import inspection

from tests.made_once import the_small_block
from tests.numbers.conftest import MakeRaster


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The mosaic of a generated block, 120 x 100 m, also in two sheets side by side."""
    folder = tmp_path_factory.mktemp("sheets") / "block"
    shutil.copytree(the_small_block(tmp_path_factory).mosaic.parent, folder)
    whole = gdal.Open(str(folder / "mosaic.tif"))
    half = whole.RasterXSize // 2
    for name, first in (("west", 0), ("east", half)):
        gdal.Translate(str(folder / f"{name}.tif"), whole, srcWin=[first, 0, half, whole.RasterYSize])
    return folder


def sheet(folder: Path, name: str, **options: object) -> Block:
    orthoimages = sorted(folder.glob("strip*.tif"))
    return open_block(folder / f"{name}.tif", orthoimages, keep_copies=True, **options)  # type: ignore[arg-type]


def test_sheets_with_their_neighbours_add_up_to_the_whole(folder: Path) -> None:
    lines = folder / "seamlines.gpkg"
    whole, sheets = scan(sheet(folder, "mosaic"), seamlines=lines), {}
    for name in ("west", "east"):
        opened = sheet(folder, name, neighbours=[folder / "west.tif", folder / "east.tif"])
        result = sheets[name] = scan(opened, seamlines=lines)
        xmin, _, xmax, _ = describe(RasterRef(str(folder / f"{name}.tif"))).extent
        for piece in result.pieces:
            assert xmin - piece.piece.length_m / 2 < piece.piece.vertices[0][0] < xmax + piece.piece.length_m / 2
        area = sum(ogr.CreateGeometryFromWkb(polygon.wkb).Area() for polygon in result.polygons)
        assert area <= 60 * 100 + 1
        assert str(folder / f"{name}.tif") in result.told[MOSAIC_FILES]
        assert result.told[MOSAIC_FILES].count(".tif") == 1
        places = "; ".join(result.told.get(key, "") for key in ("unseen_at", "hidden_at"))
        assert all(xmin - 8 <= float(place.split()[0]) <= xmax + 8 for place in places.split("; ") if place)
    of_sheets = [str(piece.kept) for result in sheets.values() for piece in result.pieces]
    assert sorted(of_sheets) == sorted(str(piece.kept) for piece in whole.pieces)
    seen = [result.told.get("unseen_metres", "0") for result in sheets.values()]
    assert math.fsum(map(float, seen)) == pytest.approx(float(whole.told.get("unseen_metres", "0")), abs=8)


@pytest.mark.parametrize("column", [0, 150, 300])
def test_a_sheet_begins_where_a_block_of_the_whole_does(
    make_raster: MakeRaster, monkeypatch: pytest.MonkeyPatch, column: int
) -> None:
    monkeypatch.setattr(inspection, "NEIGHBOURS_PX", 64)
    paths = [make_raster(f"{left}.tif", np.ones((40, 150)), gsd=1, origin=(left, 5e6)) for left in (500, 650, 800)]
    west, _, east, _ = open_block(paths[column // 150], neighbours=paths).mosaic.extent
    assert west == 500 + max(0, column // 64 - 1) * 64
    assert east == min(950, 500 + (-(-(column + 150) // 64) + 1) * 64)
    far = make_raster("far.tif", np.ones((40, 150)), gsd=1, origin=(9000, 5e6))
    assert open_block(paths[0], neighbours=far).mosaic == open_block(paths[0]).mosaic


def test_a_window_reaches_into_a_neighbour(folder: Path) -> None:
    whole, west = sheet(folder, "mosaic"), sheet(folder, "west", neighbours=folder / "east.tif")
    x, y = 60 + whole.mosaic.extent[0], 50 + whole.mosaic.extent[1]
    in_whole, in_sheet = (inspect_window(block.window_at(x, y, 25)) for block in (whole, west))
    assert in_sheet.profile is not None
    assert in_sheet.profile.kept == in_whole.profile.kept


@pytest.mark.parametrize("options", [{"width": 300, "height": 500}, {"bandList": [3, 2, 1]}, {"dstSRS": "EPSG:4326"}])
def test_a_sheet_of_another_grid_system_or_order_of_bands_is_refused(
    folder: Path, tmp_path: Path, options: dict[str, object]
) -> None:
    (gdal.Warp if "dstSRS" in options else gdal.Translate)(f"{tmp_path}/other.tif", f"{folder}/east.tif", **options)
    with pytest.raises(SettingsError, match="does not lie on the pixel grid of west"):
        sheet(folder, "west", neighbours=[tmp_path / "other.tif"])


def test_seams_without_orthoimages_count_in_the_sheet_that_holds_them(folder: Path) -> None:
    lines, sheets = folder / "seamlines.gpkg", [folder / "west.tif", folder / "east.tif"]
    results = [scan(open_block(path, neighbours=sheets), seamlines=lines) for path in sheets]
    whole = scan(open_block(folder / "mosaic.tif"), seamlines=lines)
    assert math.fsum(result.seam_metres for result in results) == pytest.approx(whole.seam_metres, abs=1)
    for path, result in zip(sheets, results):
        xmin, _, xmax, _ = describe(RasterRef(str(path))).extent
        assert 0 < len(result.worst) <= len(result.pieces)
        for piece in (part.piece for part in (*result.pieces, *result.stretches)):
            assert xmin - piece.length_m / 2 < piece.vertices[0][0] < xmax + piece.length_m / 2
