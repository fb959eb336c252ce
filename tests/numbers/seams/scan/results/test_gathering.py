"""From blocks to what a scan tells."""
from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import Callable

import numpy as np
import pytest
from osgeo import gdal, ogr
from scipy import ndimage
from seam_inspector.plugin.imagery.errors import SettingsError
from seam_inspector.plugin.seams.measure.blocks.block_grid import BLOCK_PX, LABELS, UNITS, ScanSettings
from seam_inspector.plugin.seams.measure.blocks.scan_block import LACKING, BlockScan
from seam_inspector.plugin.seams.measure.judgement.verdicts import Verdict
from seam_inspector.plugin.seams.measure.profile.cell_table import CellTable, MixtureTable
from seam_inspector.plugin.seams.measure.scan.loss_raster import NODATA as NO_LOSS
from seam_inspector.plugin.seams.measure.scan.scan_request import ScanRequest, scan_request
from seam_inspector.plugin.seams.measure.scan.scan_result import ScanResult
from seam_inspector.plugin.seams.measure.scan.whole_scan import whole_scan
from seam_inspector.plugin.seams.measure.seam_cells import UNKNOWN
from seam_inspector.plugin.seams.measure.seamlines.given_seams import GivenSeams, SidedSeam
from seam_inspector.plugin.seams.measure.workers import Workers

from tests.numbers.seams.scan.blocks.scenes import NODATA, SIDE, Scene, as_bytes, beside, blended, images, scene
from tests.numbers.seams.scan.whole_scan_lives import scanned

SEAM = 400
FEATHER_PX = 33
PIECE_M = 25.0
GSD = 0.1


def request_of(case: Scene, seams: tuple[SidedSeam, ...] = (), **settings: object) -> ScanRequest:
    given = GivenSeams(seams, (), ()) if seams else None
    return scan_request(case.mosaic, case.sources, ScanSettings(**settings), given)[0]  # type: ignore[arg-type]


def result_of(folder: Path, case: Scene, seams: tuple[SidedSeam, ...] = (), **settings: object) -> ScanResult:
    return scanned(request_of(case, seams, **settings), folder / "loss.tif")[1]


def picture(folder: Path) -> np.ndarray:
    """Picture of losses, (bands, rows, columns)."""
    dataset = gdal.Open(str(folder / "loss.tif"))
    return np.asarray(dataset.ReadAsArray())


def distance_px(result: ScanResult, case: Scene, column: float) -> float:
    """The largest of any vertex from a seam along a column."""
    grid = case.mosaic.grid
    columns = [(piece.piece.vertices[:, 0] - grid.left) / grid.pixel_width for piece in result.pieces]
    return float(np.abs(np.concatenate(columns) - column).max())


@pytest.mark.parametrize("density", ["seams", "full"])
def test_a_hard_cut_has_no_failed_metre(tmp_path: Path, density: str) -> None:
    given = images()
    case = scene(tmp_path, blended(*given, beside(SEAM)), given)
    result = result_of(tmp_path, case, density=density)
    assert result.seam_metres == pytest.approx(SIDE * GSD, rel=0.02)
    assert result.failed_metres == 0
    assert {piece.verdict for piece in result.pieces} == {Verdict.PRESERVED}
    assert result.worst_kept == pytest.approx(1, abs=0.06)
    assert all(piece.low < 1 < piece.high for piece in result.pieces)
    assert all(piece.band_width_m == 0 for piece in result.pieces)
    assert all(0 <= piece.visibility < 0.5 for piece in result.pieces)
    assert distance_px(result, case, SEAM) < 2


@pytest.mark.parametrize("density", ["seams", "full"])
def test_a_feathered_mosaic_fails_along_its_seam(tmp_path: Path, density: str) -> None:
    given = images()
    case = scene(tmp_path, blended(*given, beside(SEAM, FEATHER_PX)), given)
    result = result_of(tmp_path, case, density=density)
    assert result.seam_metres == pytest.approx(SIDE * GSD, rel=0.02)
    assert all(piece.high < 1 for piece in result.pieces)
    assert {piece.verdict for piece in result.pieces} <= {Verdict.SIGNIFICANT, Verdict.REDUCED}
    assert distance_px(result, case, SEAM) < 3
    widths = [piece.band_width_m for piece in result.pieces]
    assert np.median(widths) == pytest.approx(0.6 * FEATHER_PX * GSD, rel=0.4)
    assert all(0.7 < piece.visibility < 2 for piece in result.pieces)
    loss = picture(tmp_path)[0]
    low = np.unique(np.argwhere((loss < 0.85) & (loss != NO_LOSS))[:, 1])
    assert set(low) <= {(SEAM - FEATHER_PX) // 32, SEAM // 32, (SEAM + FEATHER_PX) // 32}


def unsharp(strength: float, sigma: float) -> Callable[[np.ndarray], np.ndarray]:
    return lambda plane: plane + strength * (plane - ndimage.gaussian_filter(plane, sigma))


AFTERWARDS: dict[str, Callable[[np.ndarray], np.ndarray]] = {
    "sharpened": unsharp(0.7, 1.0),
    "sharpened much": unsharp(1.5, 1.0),
    "sharpened beyond any filter that is looked for": unsharp(1.0, 2.0),
    "gain": lambda plane: 60 + 0.6 * plane,
    "noise": lambda plane: plane + 4 * np.random.default_rng(0).standard_normal(plane.shape),
    "blurred": lambda plane: ndimage.gaussian_filter(plane, 0.5),
}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("change", "density"),
    [*((change, "seams") for change in AFTERWARDS), ("sharpened much", "full"), ("noise", "full")],
)
def test_what_was_done_to_the_whole_mosaic_is_no_loss_and_hides_none(
    tmp_path: Path, change: str, density: str
) -> None:
    """Samples of the ground and what is measured pixel by pixel expect the same of it."""
    given = images()
    means = []
    for width in (0, FEATHER_PX):
        folder = tmp_path / str(width)
        folder.mkdir()
        made = AFTERWARDS[change](blended(*given, beside(SEAM, width)).astype(float))
        pieces = result_of(folder, scene(folder, as_bytes(made), given), density=density).pieces
        means.append(float(np.mean([piece.least_kept for piece in pieces])))
    assert means[0] == pytest.approx(1, abs=0.03)
    assert means[1] < 0.8


def test_pieces_name_both_sources_and_polygons_cover_the_mosaic(tmp_path: Path) -> None:
    given = images()
    case = scene(tmp_path, blended(*given, beside(SEAM)), given)
    result = result_of(tmp_path, case)
    names = [source.ref.name for source in case.sources]
    grid = case.mosaic.grid
    for piece in result.pieces:
        (x, y), (_, last) = piece.piece.vertices[[0, -1]]
        left, right = (piece.left, piece.right) if last > y else (piece.right, piece.left)
        assert [left, right] == names, (x, y)
    shapes = {polygon.source: ogr.CreateGeometryFromWkb(polygon.wkb) for polygon in result.polygons}
    areas = {source: shape.GetArea() for source, shape in shapes.items()}
    whole = grid.columns * grid.rows * grid.pixel_width * grid.pixel_height
    assert areas == pytest.approx({0: whole * SEAM / SIDE, 1: whole * (1 - SEAM / SIDE)}, rel=0.01)


def test_a_seam_along_the_border_of_two_blocks_is_found_by_looking_again(tmp_path: Path) -> None:
    """The patches of either block alone are of one source."""
    shape = (384, 2560)
    given = images(shape)
    case = scene(tmp_path, blended(*given, beside(BLOCK_PX + 1, FEATHER_PX, shape)), given)
    result = result_of(tmp_path, case)
    assert result.seam_metres == pytest.approx(shape[0] * GSD, rel=0.03)
    assert distance_px(result, case, BLOCK_PX + 1) < 3
    assert all(piece.high < 1 for piece in result.pieces)
    loss = picture(tmp_path)[0]
    beside_border = loss[:, [BLOCK_PX // 32 - 1, BLOCK_PX // 32]]
    assert ((beside_border > 0) & (beside_border < 0.97)).mean() > 0.8


def test_a_seam_across_two_blocks_is_one(tmp_path: Path) -> None:
    shape = (384, 2560)
    given = images(shape)
    weight = beside(190, FEATHER_PX, shape[::-1]).T
    result = result_of(tmp_path, scene(tmp_path, blended(*given, weight), given))
    assert {piece.piece.seam_id for piece in result.pieces} == {1}
    assert result.seam_metres == pytest.approx(shape[1] * GSD, rel=0.02)
    kept = [piece.least_kept for piece in result.pieces]
    assert None not in kept
    assert max(kept) < 0.9


@pytest.mark.parametrize("which", ["mosaic", "source"])
def test_a_raster_that_is_rewritten_while_it_is_scanned_is_told_and_all_is_measured_again(
    tmp_path: Path, which: str
) -> None:
    given = images()
    case = scene(tmp_path, blended(*given, beside(SEAM)), given)
    request = request_of(case)
    path = Path(case.mosaic.ref.path if which == "mosaic" else case.sources[1].ref.path)
    with whole_scan(request, tmp_path / "loss.tif") as scan, ThreadPoolExecutor(1) as executor:
        for number, _ in enumerate(scan.steps(Workers(executor, 2))):
            if number:
                continue
            before, held = path.stat(), bytearray(path.read_bytes())
            held[-1] ^= 1
            path.write_bytes(held)
            os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))
        with pytest.raises(SettingsError, match=f"While the mosaic was scanned {path.name} changed"):
            scan.result(str(tmp_path / "loss.tif"))
    assert not (tmp_path / "loss.tif").exists()
    with whole_scan(request, tmp_path / "loss.tif") as scan:
        assert "The scan starts from the beginning" in str(scan.notice)


def test_a_seam_beside_missing_pixels_is_no_worse_for_it(tmp_path: Path) -> None:
    given = images()
    made = blended(*given, beside(SEAM))
    made[:, SEAM + 110 :] = NODATA
    result = result_of(tmp_path, scene(tmp_path, made, given))
    assert {piece.verdict for piece in result.pieces} == {Verdict.PRESERVED}
    assert result.worst_kept == pytest.approx(1, abs=0.06)


def test_bad_places_come_first_among_the_worst(tmp_path: Path) -> None:
    given = images()
    wide, hard = blended(*given, beside(SEAM, 60)), blended(*given, beside(SEAM))
    made = np.where(np.arange(SIDE)[:, np.newaxis] < SIDE / 2, hard, wide)
    result = result_of(tmp_path, scene(tmp_path, made, given), piece_m=12.0)
    first = result.worst[0].window
    assert first.row + first.height / 2 > SIDE / 2
    assert [window.window_id for window in result.worst] == list(range(1, len(result.worst) + 1))


UTM_SCALE = 0.9996
"""Scale of lengths on the map where the scene lies, on the central meridian of its zone (Snyder 1987)."""


def given_seam(case: Scene, column: float, left: str | None = None, right: str | None = None) -> SidedSeam:
    """From top to bottom."""
    grid = case.mosaic.grid
    xs = [grid.left + column * grid.pixel_width] * 2
    return SidedSeam(np.column_stack([xs, [grid.top, grid.top - grid.rows * grid.pixel_height]]), left, right)


@pytest.mark.parametrize("width", [0, FEATHER_PX])
def test_given_seams_are_judged_as_those_that_are_found(tmp_path: Path, width: int) -> None:
    given = images()
    case = scene(tmp_path, blended(*given, beside(SEAM, width)), given)
    traced = result_of(tmp_path, case)
    along_given = result_of(tmp_path, case, (given_seam(case, SEAM),))
    assert along_given.seam_metres == pytest.approx(SIDE * GSD / UTM_SCALE)
    assert np.mean([piece.least_kept for piece in along_given.pieces]) == pytest.approx(
        np.mean([piece.least_kept for piece in traced.pieces]), abs=0.04
    )
    assert {piece.verdict for piece in along_given.pieces} <= (
        {Verdict.PRESERVED} if not width else {Verdict.SIGNIFICANT, Verdict.REDUCED}
    )
    names = [source.ref.name for source in case.sources]
    assert {(piece.right, piece.left) for piece in along_given.pieces} == {tuple(names)}  # walked downwards


def test_the_picture_of_given_seams_names_sources_everywhere(tmp_path: Path) -> None:
    given = images()
    case = scene(tmp_path, blended(*given, beside(SEAM)), given)
    result_of(tmp_path, case, (given_seam(case, SEAM),))
    source = picture(tmp_path)[3]
    assert (source[:, : SEAM // 32] == 1).all()
    assert (source[:, SEAM // 32 + 1 :] == 2).all()


def block(labels: np.ndarray | None = None, **arrays: np.ndarray) -> BlockScan:
    """A block of nothing but what is given."""
    nothing = BlockScan(
        (0, 0), (0, 1), np.full((16, 16), UNKNOWN, np.uint8), *np.zeros((2, UNITS, UNITS), bool),
        np.full((LABELS, LABELS), UNKNOWN, np.uint8) if labels is None else labels,
        *np.full((3, 128, 128), np.nan, np.float32), CellTable.empty(3), MixtureTable.empty(3),
        np.full((UNITS, UNITS), LACKING, np.int16),
    )
    return replace(nothing, **arrays)
