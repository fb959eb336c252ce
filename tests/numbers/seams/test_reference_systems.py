"""A seam of 24.6 m is that long, and keeps the same, in whatever reference system, by whatever rows and zone."""
from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.acceptance.measure.acceptance_rules import limit_rules
from seam_inspector.plugin.acceptance.measure.deciding import decide
from seam_inspector.plugin.acceptance.measure.decision import AcceptanceOutcome
from seam_inspector.plugin.acceptance.measure.delivered_rows import make_delivery
from seam_inspector.plugin.imagery.errors import SeamInspectorWarning, SettingsError
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.seams.measure.scan.scan_result import ScanResult, seam_rows
from seam_inspector.plugin.seams.measure.scan.whole_scan import scan
from seam_inspector.plugin.seams.measure.window.inspection import Block, inspect_window, open_block
from seam_inspector.plugin.seams.measure.window.window_result import WindowResult

from tests.numbers.clips import STRETCHING, metres_by_arcs
from tests.numbers.seams.scan.blocks.scenes import images
from tests.numbers.synthetic import ORIGIN, UTM33, GeoTransform, wkt, write_raster

ROWS, COLUMNS = 248, 320
LENGTH = 24.6  # m, of the seam on the ground
PIXEL = LENGTH / ROWS
PLAIN: GeoTransform = (*ORIGIN[:1], PIXEL, 0.0, ORIGIN[1], 0.0, -PIXEL)
FEATHERED, HARD = 40, 0  # px


def pixels(feather: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A mosaic with a seam down its middle and its two orthoimages, (rows, columns)."""
    first, second = (image[:ROWS, :COLUMNS] for image in images())
    return blended(first, second, feather), first, second


def blended(first: np.ndarray, second: np.ndarray, feather: int) -> np.ndarray:
    """From one to another along columns, by a linear feather of a full width or by a hard cut."""
    place = np.arange(COLUMNS) + 0.5 - COLUMNS / 2
    weight = np.clip(place / feather + 0.5, 0, 1) if feather else place > 0
    return np.rint((1 - weight) * first + weight * second).astype(np.uint8)


def block_at(folder: Path, place: GeoTransform, system: int | str, feather: int = FEATHERED) -> Block:
    """A mosaic of ``pixels`` and its orthoimages as files."""
    paths = [
        write_raster(folder / f"{name}.tif", image, geotransform=place, system=wkt(system))
        for name, image in zip(("mosaic", "a", "b"), pixels(feather))
    ]
    return open_block(paths[0], paths[1:])


def placed(system: int | str, longitude: float, latitude: float) -> GeoTransform:
    """The place of pixels of a length on the ground."""
    (x, y), east, north = metres_by_arcs(system, longitude, latitude)
    across, down = PIXEL / east, PIXEL / north
    return x - COLUMNS / 2 * across, across, 0.0, y + ROWS / 2 * down, 0.0, -down


def kept(result: ScanResult) -> list[float | None]:
    return [piece.kept[0] for piece in result.pieces]


@pytest.mark.parametrize(("system", "longitude", "latitude"), STRETCHING.values(), ids=STRETCHING.keys())
def test_a_seam_has_the_length_that_it_has_on_the_ground(
    tmp_path: Path, system: int | str, longitude: float, latitude: float
) -> None:
    block = block_at(tmp_path, placed(system, longitude, latitude), system)
    result = scan(block)
    assert result.seam_metres == pytest.approx(LENGTH, abs=0.02)
    assert result.failed_metres == result.seam_metres
    (tmp_path / "plain").mkdir()
    plain = scan(block_at(tmp_path / "plain", PLAIN, UTM33))
    assert kept(result) == pytest.approx(kept(plain), abs=0.002)
    assert result.pieces[0].band_width_m == pytest.approx(plain.pieces[0].band_width_m, rel=0.01)
    for run, outcome in ((30.0, AcceptanceOutcome.ACCEPTED), (20.0, AcceptanceOutcome.REJECTED)):
        decision = decide(make_delivery({"sheet": seam_rows(result)}, block.mosaic.wkt), limit_rules(0.7, 1.0, run))
        assert decision.outcome is outcome
        assert decision.whole.failed_m == pytest.approx(LENGTH, abs=0.02)
    xmin, ymin, xmax, ymax = block.mosaic.extent
    window = block.window_at((xmin + xmax) / 2, (ymin + ymax) / 2, side_m=12.0).window
    assert (window.width, window.height) == (128, 128)


def test_the_system_that_is_given_holds_whatever_files_name(tmp_path: Path) -> None:
    place = placed(3857, 7.0, 46.85)
    right = kept(scan(block_at(tmp_path, place, 3857)))
    wrong = [
        write_raster(tmp_path / f"{name}.tif", image, geotransform=place, system=UTM33)
        for name, image in zip(("mosaic", "a", "b"), pixels(FEATHERED))
    ]
    with pytest.warns(SeamInspectorWarning) as warned:
        block = open_block(wrong[0], wrong[1:], crs="EPSG:3857")
    assert sorted(str(warning.message).partition(" ")[0] for warning in warned) == ["a.tif", "b.tif", "mosaic.tif"]
    assert all("EPSG:3857" in str(warning.message) and f"EPSG:{UTM33}" in str(warning.message) for warning in warned)
    result = scan(block)
    assert kept(result) == pytest.approx(right)
    assert result.seam_metres == pytest.approx(LENGTH, abs=0.02)
    with pytest.raises(SettingsError, match="'EPSG:0' is not a projected or geographic coordinate reference system"):
        open_block(wrong[0], wrong[1:], crs="EPSG:0")


def inspected(mosaic: str, sources: Sequence[str]) -> WindowResult:
    block = open_block(mosaic, sources)
    whole = PixelWindow(0, 0, COLUMNS, ROWS)
    return inspect_window(block.window(block.mosaic.grid.window_extent(whole)))


@pytest.mark.parametrize("feather", [FEATHERED, HARD])
def test_rows_that_run_north_change_nothing(tmp_path: Path, feather: int) -> None:
    mosaic, first, second = pixels(feather)
    south_up = (PLAIN[0], PIXEL, 0.0, PLAIN[3] - LENGTH, 0.0, PIXEL)
    path, a, b = (
        write_raster(tmp_path / f"{name}.tif", image, geotransform=PLAIN)
        for name, image in (("mosaic", mosaic), ("a", first), ("b", second))
    )
    turned = write_raster(tmp_path / "turned.tif", second[::-1], geotransform=south_up)
    whole = write_raster(tmp_path / "turned_mosaic.tif", mosaic[::-1], geotransform=south_up)
    expected = inspected(path, [a, b])
    for upturned in (inspected(path, [a, turned]), inspected(whole, [a, b])):
        assert upturned.judgement == expected.judgement
        assert upturned.notices == ()
        assert upturned.profile.kept == expected.profile.kept
    assert kept(scan(open_block(path, [a, turned]))) == kept(scan(open_block(path, [a, b])))


@pytest.mark.parametrize("feather", [FEATHERED, HARD])
def test_an_orthoimage_of_the_neighbouring_zone_takes_part_in_windows_as_in_scans(
    tmp_path: Path, feather: int
) -> None:
    _, first, second = pixels(feather)
    place = (715000.0, *PLAIN[1:])  # near the edge of the zone
    a, b = (write_raster(tmp_path / f"{n}.tif", data, geotransform=place) for n, data in (("a", first), ("b", second)))
    there, back = str(tmp_path / "neighbour.tif"), str(tmp_path / "back.tif")
    size = {"xRes": PIXEL, "yRes": PIXEL, "resampleAlg": "cubic", "dstNodata": 0}
    gdal.Warp(there, b, dstSRS="EPSG:32634", **size)
    bounds = (place[0], place[3] - LENGTH, place[0] + COLUMNS * PIXEL, place[3])
    gdal.Warp(back, there, dstSRS=f"EPSG:{UTM33}", outputBounds=bounds, **size)
    warped = gdal.Open(back).ReadAsArray()
    mixed = np.where(warped == 0, first, blended(first, warped, feather))
    path = write_raster(tmp_path / "mosaic.tif", mixed, geotransform=place)
    result, scanned = inspected(path, [a, there]), scan(open_block(path, [a, there]))
    assert result.notices == ()
    assert result.profile.kept[0] == pytest.approx(1 if feather == HARD else 0.52, abs=0.06)
    assert kept(scanned) == pytest.approx([result.profile.kept[0]], abs=0.05)


def test_more_seams_than_outlines_allow_are_told_and_not_listed(tmp_path: Path) -> None:
    """A mosaic that changes its source every 32 px."""
    first, second = images(detail_dn=20.0)
    row, column = np.indices(first.shape) // 32
    paths = [
        write_raster(tmp_path / f"{name}.tif", image)
        for name, image in (("mosaic", np.where((row + column) % 2, first, second)), ("a", first), ("b", second))
    ]
    result = scan(open_block(paths[0], paths[1:]))
    assert result.pieces == ()
    # Two squares of 102.4 m, and 0.0004 more on the ground.
    (said,) = (str(notice) for notice in result.notices if "outlines are only 820 m long" in str(notice))
    assert "as after warping by nearest neighbour" in said
