"""Orthoimages that come in overlapping strips or tiles tell of a mosaic what they tell undivided."""
from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import OpenRaster, describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure import messages
from seam_inspector.plugin.seams.measure.blocks.block_grid import ScanSettings
from seam_inspector.plugin.seams.measure.scan.scan_request import scan_request
from seam_inspector.plugin.seams.measure.scan.whole_scan import scan
from seam_inspector.plugin.seams.measure.source_images import gather_sources, whole_images
from seam_inspector.plugin.seams.measure.window.inspection import inspect_window, make_block, window_request
from seam_inspector.plugin.seams.measure.window.measured_window import InspectionSettings

from tests.numbers.conftest import MakeRaster
from tests.numbers.synthetic import ORIGIN, orthoimage

SIDE = 768
CROWD = 12


@pytest.fixture
def photos(make_raster: MakeRaster) -> list[str]:
    """A mosaic and the two photos it is of, with collars without data; its seam is crooked, and feathered in part."""
    first, second = (orthoimage((SIDE, SIDE), seed=seed) for seed in (1, 2))
    rows, columns = np.mgrid[:SIDE, :SIDE]
    beyond = columns - SIDE / 2 - 60 * np.sin(rows / 90)
    weight = np.clip(beyond / np.where(rows < SIDE / 2, 40, 0.1) + 0.5, 0, 1)
    mosaic = np.rint((1 - weight) * first + weight * second).astype(np.uint8)
    first[:, columns > 600 + rows / 8] = 0
    second[:, columns < 160 - rows / 8] = 0
    images = {"mosaic.tif": mosaic, "a.tif": first, "b.tif": second}
    return [make_raster(name, image, nodata=0) for name, image in images.items()]


def parts_of(path: str, folder: Path, rows: int, columns: int, overlap: int) -> list[str]:
    """A raster cut in parts of so many pixels that overlap."""
    opened, parts = gdal.Open(path), []
    for row in range(0, SIDE - overlap, rows - overlap):
        for column in range(0, max(SIDE - overlap, 1), columns - overlap):
            parts.append(str(folder / f"{Path(path).stem}_{row}_{column}.tif"))
            place = [column, row, min(columns, SIDE - column), min(rows, SIDE - row)]
            gdal.Translate(parts[-1], opened, srcWin=place)
    return parts


def joined(mosaic: str, paths: Sequence[str]) -> list[tuple[str, ...]]:
    """The names of what is one."""
    raster = describe_mosaic(RasterRef(mosaic))
    sources, _ = gather_sources(map(RasterRef, paths), (), raster.wkt, raster.ref)
    return [tuple(Path(path).name for path in image.ref.paths) for image in whole_images(raster, sources)[0]]


@pytest.mark.slow
@pytest.mark.parametrize(("rows", "columns"), [(200, SIDE + 40), (120, 200)])
def test_a_scan_and_a_window_tell_the_same_of_photos_in_parts(
    photos: list[str], tmp_path: Path, rows: int, columns: int
) -> None:
    mosaic, *whole = photos
    parts = [part for path in whole for part in parts_of(path, tmp_path, rows, columns, 40)]
    raster = describe_mosaic(RasterRef(mosaic))
    results = []
    for paths in (whole, parts):
        block, _ = make_block(raster, map(RasterRef, paths))
        scanned = scan(block, ScanSettings(piece_m=10))
        extent = raster.grid.window_extent(PixelWindow(128, 128, 512, 512))
        results.append((scanned, inspect_window(window_request(block, 1, extent, InspectionSettings()))))
    (scanned, window), (of_parts, window_of_parts) = results
    assert [piece.piece.length_m for piece in of_parts.pieces] == [piece.piece.length_m for piece in scanned.pieces]
    assert [piece.kept for piece in of_parts.pieces] == [piece.kept for piece in scanned.pieces]
    assert {piece.verdict for piece in scanned.pieces} == {piece.verdict for piece in of_parts.pieces}
    assert [notice.template for notice in of_parts.notices].count(messages.ONE_IMAGE_IN_PARTS.template) == 2
    assert window_of_parts.source_count == 2
    np.testing.assert_allclose(window_of_parts.profile.kept, window.profile.kept, rtol=1e-6)
    assert messages.ONE_IMAGE_IN_PARTS.template in [notice.template for notice in window_of_parts.notices]


def test_an_image_in_parts_is_read_as_its_pixels_are(photos: list[str], tmp_path: Path) -> None:
    parts = parts_of(photos[1], tmp_path, 300, 300, 20)
    whole, of_parts = OpenRaster(RasterRef(photos[1])), OpenRaster(RasterRef(parts[0], parts=tuple(parts[1:])))
    expected, joined = whole.read(whole.raster.whole), of_parts.read(of_parts.raster.whole)
    np.testing.assert_array_equal(joined.valid, expected.valid)
    np.testing.assert_array_equal(joined.bands, expected.bands)
    assert of_parts.raster.grid == whole.raster.grid


def test_seams_may_name_any_part(photos: list[str], tmp_path: Path) -> None:
    mosaic, first, second = photos
    parts = parts_of(first, tmp_path, 200, SIDE + 40, 40)
    raster = describe_mosaic(RasterRef(mosaic))
    sources, _ = gather_sources(map(RasterRef, [*parts, second]), (), raster.wkt, raster.ref)
    request, _ = scan_request(raster, sources, ScanSettings())
    names = [Path(part).stem for part in parts]
    assert request.numbers_named([*names, "b", "a"]) == ({**dict.fromkeys(names, 0), "b": 1, "a": 0}, None)


def test_images_of_one_ground_and_places_stay_apart(photos: list[str], make_raster: MakeRaster) -> None:
    mosaic, first, second = photos
    pixels = gdal.Open(first).ReadAsArray()
    noisy = make_raster("noisy.tif", np.maximum(pixels, 1) + (np.arange(SIDE) % 9 == 0).astype(np.uint8), nodata=0)
    plain = [make_raster(f"plain_{name}.tif", np.full_like(pixels, 90), nodata=0) for name in "ab"]
    moved = make_raster("moved.tif", pixels, nodata=0, origin=(ORIGIN[0] + 0.03, ORIGIN[1]))
    paths = [first, second, noisy, *plain, moved]
    assert joined(mosaic, paths) == [(Path(path).name,) for path in paths]


def test_parts_with_another_order_of_bands_stay_apart(make_raster: MakeRaster, tmp_path: Path) -> None:
    """The bands of parts that are one image are read by their numbers in the first of them."""
    mosaic = make_raster("mosaic.tif", orthoimage((SIDE, SIDE), seed=1))
    first, second = parts_of(mosaic, tmp_path, 400, SIDE + 32, 32)
    turned = gdal.Translate(str(tmp_path / "turned.tif"), second, bandList=[3, 2, 1]).GetDescription()
    assert joined(mosaic, [first, second]) == [(Path(first).name, Path(second).name)]
    assert joined(mosaic, [first, turned]) == [(Path(first).name,), ("turned.tif",)]


@pytest.mark.release
def test_many_sources_over_all_of_a_mosaic_are_told_apart(make_raster: MakeRaster) -> None:
    """Each is followed in one cell of a patchwork only."""
    side, down, across = 1152, 3, 4
    rows, columns = (np.arange(side) * count // side for count in (down, across))
    cell = rows[:, np.newaxis] * across + columns
    images = [orthoimage((side, side), seed=seed) for seed in range(CROWD)]
    mosaic = np.choose(cell, images)
    paths = [make_raster(f"{number:02}.tif", image) for number, image in enumerate(images)]
    block, _ = make_block(describe_mosaic(RasterRef(make_raster("mosaic.tif", mosaic))), map(RasterRef, paths))
    seams = scan(block, ScanSettings(piece_m=10))
    planted_m = 0.1 * side * (down - 1 + across - 1)
    assert sum(piece.piece.length_m for piece in seams.pieces) == pytest.approx(planted_m, rel=0.03)
    assert {name for piece in seams.pieces for name in (piece.left, piece.right)} == {Path(path).name for path in paths}
