"""Parts of a block measured pixel by pixel, and the ground between seams."""
from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.wavelets import placed_components
from seam_inspector.plugin.seams.measure.blocks.block_grid import LABEL_PX, UNIT_PX
from seam_inspector.plugin.seams.measure.blocks.block_parts import (
    BLOCK_MARGIN_PX,
    DensePart,
    PartRequest,
    guesses,
    measure_part,
    measure_plain,
)
from seam_inspector.plugin.seams.measure.blocks.patches import look_at_squares
from seam_inspector.plugin.seams.measure.profile.cell_table import CELL_PX, EDGES_PX, FARTHEST, CellTable
from seam_inspector.plugin.seams.measure.profile.detail_sums import MeetingSources, detail_sums
from seam_inspector.plugin.seams.measure.seam_cells import UNKNOWN

from tests.numbers.seams.scan.blocks.scenes import (
    NODATA,
    SHAPE,
    SIDE,
    Scene,
    as_bytes,
    beside,
    blended,
    images,
    scene,
)
from tests.numbers.synthetic import placed_wavedec, texture

WAVELET, LEVELS = "coif3", 3
WINDOW = PixelWindow(256, 128, 320, 640)
SEAM = 400


def measured(one: Scene, numbers: tuple[int, ...] = (0, 1), window: PixelWindow = WINDOW) -> DensePart:
    return measure_part(one.pixels(), PartRequest(window, numbers), WAVELET, LEVELS)


def sums_by_cell(table: CellTable, name: str, level: int = 0) -> np.ndarray:
    """(rows, columns) of the mosaic's cells."""
    found = np.zeros((SIDE // CELL_PX, SIDE // CELL_PX))
    np.add.at(found, (table.row, table.column), getattr(table, name)[level])
    return found


def kept(table: CellTable, near: int, far: int) -> float:
    own = (table.bin >= EDGES_PX.index(near)) & (table.bin < EDGES_PX.index(far))
    return float(table.mm[0, own].sum() / table.cc[0, own].sum())


def true_cells(made: np.ndarray, given: Sequence[np.ndarray], labels: np.ndarray) -> CellTable:
    """Cells of the whole mosaic at once, by labels that are known."""
    planes = np.stack([made, np.choose(labels, given), *given]).astype(np.float32)
    return detail_sums(list(placed_components(planes, WAVELET, LEVELS)), MeetingSources(labels, (0, 1)))[0]


LABELS_TRUE = (np.indices(SHAPE)[1] + 0.5 > SEAM).astype(np.uint8)


@pytest.mark.parametrize("width", [0, 13, 33, 66])
def test_a_part_finds_what_the_whole_mosaic_at_once_says_with_known_labels(tmp_path: Path, width: int) -> None:
    given = images()
    made = blended(*given, beside(SEAM, width))
    part = measured(scene(tmp_path, made, given))
    expected = true_cells(made, given, LABELS_TRUE).within((slice(8, 48), slice(16, 36)))
    assert sums_by_cell(part.cells, "area").sum() == WINDOW.width * WINDOW.height
    own = np.s_[8:48, 16:36]
    assert sums_by_cell(part.cells, "mm")[own] == pytest.approx(sums_by_cell(expected, "mm")[own], rel=1e-3)
    for near, far in ((0, 8), (8, 16), (16, 32), (64, 128)):
        assert kept(part.cells, near, far) == pytest.approx(kept(expected, near, far), abs=0.05)
    labels = LABELS_TRUE[128:768, 256:576][LABEL_PX // 2 :: LABEL_PX, LABEL_PX // 2 :: LABEL_PX]
    assert (part.labels == labels).mean() > 0.998
    assert part.unexplained < 0.02


@pytest.mark.parametrize("change", ["sharpened", "gain", "noise"])
def test_beside_a_feather_a_part_keeps_less_than_the_ground_whatever_came_over_all(
    tmp_path: Path, change: str
) -> None:
    given = images()
    made = blended(*given, beside(SEAM, 33)).astype(float)
    if change == "sharpened":
        made += 0.8 * (made - ndimage.gaussian_filter(made, 1.0))
    elif change == "gain":
        made = 70 + 0.6 * (made - 120)
    else:
        made += 4 * np.random.default_rng(2).standard_normal(SHAPE)
    table = measured(scene(tmp_path, as_bytes(made), given)).cells
    assert kept(table, 0, 8) / kept(table, 64, 128) < 0.85
    assert kept(table, 48, 64) / kept(table, 64, 128) == pytest.approx(1, abs=0.08)


def test_what_none_of_the_sources_explains_is_told(tmp_path: Path) -> None:
    given = images()
    made = blended(given[0], as_bytes(120 + 30 * texture(SHAPE, 1.2, 98)), beside(SEAM))
    part = measured(scene(tmp_path, made, given))
    stranger = 1 - (SEAM - WINDOW.column) / WINDOW.width
    assert part.unexplained == pytest.approx(stranger, abs=0.12)
    assert (part.labels[:, (SEAM - WINDOW.column) // LABEL_PX + 8 :] == UNKNOWN).mean() > 0.8


@pytest.mark.parametrize("end", [480, 528, 560])
def test_where_the_mosaic_ends_nothing_is_measured_and_nothing_is_learned(tmp_path: Path, end: int) -> None:
    """What fills it there has no detail, and made the composite beside it 7 % too strong."""
    given = images()
    made = blended(*given, beside(SEAM))
    made[:, end:] = NODATA
    part = measured(scene(tmp_path, made, given))
    assert part.cells.column.max() == end // CELL_PX - 1
    assert kept(part.cells, 0, 8) == pytest.approx(1, abs=0.02)
    assert kept(part.cells, 16, 32) == pytest.approx(1, abs=0.02)
    labels = part.labels[:, (end - WINDOW.column) // LABEL_PX :]
    assert (labels == UNKNOWN).all()


def test_parts_that_are_clear_almost_nowhere_are_guesses() -> None:
    labels = np.zeros((64, 64), np.uint8)
    labels[:, 32:] = 1
    clear = np.ones(labels.shape, bool)
    assert not guesses(labels, clear).any()
    clear[:, 32:] = False
    clear[:8, 32:] = True  # an eighth
    assert guesses(labels, clear)[:, 32:].all()
    assert not guesses(labels, clear)[:, :32].any()
    clear[:32, 32:] = True
    assert not guesses(labels, clear).any()
    labels[:, 32:] = UNKNOWN
    clear[:, 32:] = False
    assert not guesses(labels, clear).any()


def plain_of(one: Scene, dense: np.ndarray | None = None, levels: int = LEVELS) -> CellTable:
    pixels = one.pixels(margin_px=BLOCK_MARGIN_PX)
    look = look_at_squares(pixels, WAVELET, levels)
    wanted = np.zeros((SIDE // UNIT_PX, SIDE // UNIT_PX), bool) if dense is None else dense
    return measure_plain(pixels, look, wanted, WAVELET, levels)


@pytest.mark.parametrize("levels", [1, 3, 4])
def test_even_ground_has_pywavelets_energies_at_the_finest_level_alone(tmp_path: Path, levels: int) -> None:
    given = images()
    table = plain_of(scene(tmp_path, given[0], given), levels=levels)
    assert len(table) == (SIDE // CELL_PX) ** 2
    assert (table.bin == FARTHEST).all()
    assert (table.area[0] == CELL_PX**2).all()
    assert not np.stack([table.area, table.mm, table.cc, table.mc])[:, 1:].any()
    energy = np.square(placed_wavedec(given[0], WAVELET, 1)[1]).sum(axis=0)
    side = CELL_PX // 2
    expected = energy.reshape(SIDE // CELL_PX, side, -1, side).sum(axis=(1, 3))
    inside = np.s_[2:-2, 2:-2]  # beyond which PyWavelets goes on at the opposite edge
    found = sums_by_cell(table, "mm", 0)[inside]
    assert found == pytest.approx(expected[inside], rel=5e-3, abs=1e-3 * expected.mean())
    tolerance = 1e-2 * expected.mean()
    for name in ("cc", "mc"):
        assert sums_by_cell(table, name, 0)[inside] == pytest.approx(found, rel=0.02, abs=tolerance)
