"""What a scan saw beside its seams: borders that no seam tells of, ground without an orthoimage or pixels."""
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.imagery.grids import Grid
from seam_inspector.plugin.imagery.open_raster import describe
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure.blocks.block_grid import UNIT_PX, UNITS, BlockGrid, ScanSettings
from seam_inspector.plugin.seams.measure.blocks.scan_block import EMPTY, LACKING, NOT_LOOKED
from seam_inspector.plugin.seams.measure.scan.followed_ground import FollowedGround
from seam_inspector.plugin.seams.measure.scan.scan_result import ScanResult
from seam_inspector.plugin.seams.measure.seamlines.seam_pieces import SeamPiece, SidedSeam

from tests.numbers.seams.scan.blocks.scenes import NODATA, SIDE, Scene, as_bytes, beside, blended, images, scene
from tests.numbers.seams.scan.results.test_gathering import GSD, SEAM, given_seam, result_of

PIECE_M = 25.0
SIDE_M = SIDE * GSD


def ground_of(units: np.ndarray, lines: list[list[tuple[float, float]]] | None = None) -> FollowedGround:
    """Units as they are given; ``lines``: columns and rows of their vertices, in units."""
    grid = Grid(0.0, 0.0, GSD, GSD, units.shape[1] * UNIT_PX, units.shape[0] * UNIT_PX)
    size = [-(-length // UNITS) * UNITS for length in units.shape]
    whole = np.full(size, EMPTY, np.int32)
    whole[: units.shape[0], : units.shape[1]] = units
    paths = [np.array(line, float) * UNIT_PX * GSD * (1, -1) for line in lines or []]
    pieces = [SeamPiece(1, 0.0, float(np.hypot(*np.diff(path, axis=0).T).sum()), path, None, None) for path in paths]
    return FollowedGround(whole, BlockGrid(grid), pieces, PIECE_M)


def halves(rows: int = 40, columns: int = 40) -> np.ndarray:
    """Units of two sources that meet in the middle."""
    units = np.zeros((rows, columns), int)
    units[:, columns // 2 :] = 1
    return units


def test_a_border_without_a_seam_is_told_with_its_length_and_place() -> None:
    (border,) = ground_of(halves()).unseen
    assert border.metres == pytest.approx(40 * UNIT_PX * GSD)
    assert (border.x, border.y) == (pytest.approx(20 * UNIT_PX * GSD, abs=4), pytest.approx(-20 * UNIT_PX * GSD, abs=4))


@pytest.mark.parametrize("covering", [LACKING, EMPTY])
@pytest.mark.parametrize("width", [1, 2, 5])
def test_a_strip_between_two_sources_hides_their_border(covering: int, width: int) -> None:
    units = halves()
    units[:, 20 : 20 + width] = covering
    ground = ground_of(units)
    assert sum(border.metres for border in ground.unseen) == pytest.approx(40 * UNIT_PX * GSD, rel=0.05)
    assert bool(ground.hidden) == (covering == LACKING)
    assert (ground.empty > 0) == (covering == EMPTY)


def test_scatter_is_not_unexplained_and_what_holds_a_piece_is() -> None:
    units = np.zeros((200, 200), int)
    units[::7, ::5] = LACKING
    assert ground_of(units).unexplained == 0
    units[50:60, 50:60] = LACKING
    assert ground_of(units).unexplained == pytest.approx(100 / units.size, rel=0.05)


def test_borders_of_ground_without_an_orthoimage_count_where_no_seam_is_known() -> None:
    """A part of 60 by 40 units, along three sides of which seams are given."""
    units = np.zeros((200, 200), int)
    units[50:90, 60:120] = LACKING
    corners = [(60, 90), (60, 50), (120, 50), (120, 90)]
    around, beside_seams = (
        float(ground_of(units, lines).told["unexplained_border"]) for lines in ([], [corners])
    )
    unit_m = UNIT_PX * GSD
    assert around == pytest.approx(np.pi / 4 * 200 * unit_m, abs=0.1)
    assert beside_seams == pytest.approx(np.pi / 4 * 60 * unit_m, rel=0.2)


def test_what_was_not_read_is_told() -> None:
    units = halves(200, 200)
    units[:, 50:] = NOT_LOOKED
    ground = ground_of(units)
    assert ground.unseen == []
    assert ground.looked == pytest.approx(50 / 200)


def test_a_border_in_ground_that_was_not_read_is_told_as_that() -> None:
    units = halves()
    units[:, 18:22] = NOT_LOOKED
    ground = ground_of(units)
    assert (ground.unseen, ground.looked) == ([], pytest.approx(36 / 40))


def metres(result: ScanResult, name: str) -> float:
    return float(result.told.get(f"{name}_metres", 0))


def spoilt(kind: str, width: int) -> np.ndarray:
    """A sound mosaic of two images, and a strip along its seam in which that can't be seen any more."""
    made = blended(*images(), beside(SEAM))
    strip = np.s_[:, SEAM - width // 2 : SEAM + width // 2]
    blurred = ndimage.gaussian_filter(made.astype(float), 4)
    noisy = 120 + 25 * np.random.default_rng(99).standard_normal(made.shape)
    spoiling = {"blurred": as_bytes(blurred), "noisy": as_bytes(noisy), "cut out": np.full_like(made, NODATA)}
    made[strip] = spoiling[kind][strip]
    return made


@pytest.mark.slow
@pytest.mark.parametrize(
    ("kind", "width"),
    [("blurred", 200), ("noisy", 24), ("noisy", 100), ("cut out", 32), ("cut out", 120)],
)
def test_a_strip_that_covers_a_seam_is_told_with_its_place(tmp_path: Path, kind: str, width: int) -> None:
    result = result_of(tmp_path, scene(tmp_path, spoilt(kind, width), images()))
    assert result.seam_metres + metres(result, "unseen") == pytest.approx(SIDE_M, rel=0.1)
    assert metres(result, "unseen") > 0.25 * SIDE_M
    assert (metres(result, "hidden") > 0) == (kind != "cut out")
    assert ("nodata_at" in result.told) == (kind == "cut out")
    x, y, across, down = map(float, result.told["unseen_at"].split(";")[0].split())
    left, _, _, top = describe(RasterRef(str(tmp_path / "mosaic.tif"))).extent
    assert x - left == pytest.approx(SEAM * GSD, abs=(width / 2 + 2 * UNIT_PX) * GSD)
    assert 0 < top - y < SIDE_M
    assert max(across, down) > 0.1 * SIDE_M
    assert any("where no seam is measured" in str(notice) for notice in result.notices)


@pytest.mark.slow
def test_a_strip_so_narrow_that_its_sides_are_told_is_measured_and_fails(tmp_path: Path) -> None:
    result = result_of(tmp_path, scene(tmp_path, spoilt("blurred", 24), images()))
    assert result.failed_metres == pytest.approx(SIDE_M, rel=0.1)


@pytest.mark.slow
@pytest.mark.parametrize("given", [False, True])
@pytest.mark.parametrize("feather", [0, 33])
def test_a_sound_mosaic_and_a_feathered_one_hide_nothing(tmp_path: Path, given: bool, feather: int) -> None:
    case = scene(tmp_path, blended(*images(), beside(SEAM, feather)), images())
    facts = result_of(tmp_path, case, (given_seam(case, SEAM),) if given else ()).told
    aside = "mosaic_files", "source_files", "metres", "system", *ScanSettings().told
    seen = {name: text for name, text in facts.items() if name not in aside}
    assert seen == {"seams": "given" if given else "found", "unexplained": "0.0000"} | (
        {"unchanged_metres": "0.0"} if given else {}
    )


@pytest.mark.slow
def test_an_outline_with_a_collar_hides_nothing(tmp_path: Path) -> None:
    made = blended(*images(), beside(SEAM))
    row, column = np.indices(made.shape)
    made[(row < 40) | (column < 90) | (column + row > 1800) | (row - column > 700)] = NODATA
    facts = result_of(tmp_path, scene(tmp_path, made, images())).told
    assert "unseen_metres" not in facts
    assert "nodata_inside" not in facts


WIDE = (1024, 2560)


def of_three(folder: Path) -> Scene:
    """Three images side by side."""
    first, second, third = images(WIDE, 3)
    made = blended(first, second, beside(700, 0, WIDE))
    return scene(folder, blended(made, third, beside(1700, 0, WIDE)), (first, second, third))


@pytest.mark.slow
def test_a_seam_that_is_left_out_of_the_seamlines_is_seen(tmp_path: Path) -> None:
    case = of_three(tmp_path)
    whole: tuple[SidedSeam, ...] = given_seam(case, 700), given_seam(case, 1700)
    assert metres(result_of(tmp_path, case, whole), "unseen") == 0
    lacking = result_of(tmp_path, case, whole[:1])
    assert metres(lacking, "unseen") == pytest.approx(WIDE[0] * GSD, rel=0.1)
    assert metres(lacking, "unchanged") == 0


@pytest.mark.slow
def test_a_line_that_is_no_seam_is_no_seam(tmp_path: Path) -> None:
    case = scene(tmp_path, blended(*images(), beside(SEAM)), images())
    named = given_seam(case, SEAM), given_seam(case, SEAM + 300, "source_0.tif", "source_1.tif")
    assert metres(result_of(tmp_path, case, named), "unchanged") == pytest.approx(SIDE_M, rel=0.01)
    unnamed = result_of(tmp_path, case, (given_seam(case, SEAM), given_seam(case, SEAM + 300)))
    assert (metres(unnamed, "unchanged"), unnamed.seam_metres) == (0, pytest.approx(SIDE_M, rel=0.01))
    assert [notice.values["metres"] for notice in unnamed.notices] == [pytest.approx(SIDE_M, rel=0.01)]


def test_a_line_beside_its_seam_is_its_line(tmp_path: Path) -> None:
    case = scene(tmp_path, blended(*images(), beside(SEAM)), images())
    assert metres(result_of(tmp_path, case, (given_seam(case, SEAM + 30),)), "unchanged") == 0
