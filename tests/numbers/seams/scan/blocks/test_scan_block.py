"""One block: what is measured of it, in whatever state its files are."""
from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.records import record_of
from seam_inspector.plugin.seams.measure.blocks.block_grid import LABEL_PX, UNIT_PX, UNITS
from seam_inspector.plugin.seams.measure.blocks.scan_block import scan_block
from seam_inspector.plugin.seams.measure.profile.cell_table import CELL_PX, EDGES_PX, CellTable
from seam_inspector.plugin.seams.measure.seam_cells import UNKNOWN

from tests.numbers.seams.scan.blocks.scenes import NODATA, SIDE, Scene, beside, blended, images, measured, scene
from tests.numbers.synthetic import placed_wavedec

SEAM = 400  # column


@pytest.fixture(scope="module")
def hard(tmp_path_factory: pytest.TempPathFactory) -> Scene:
    """A hard cut of two images along a column."""
    given = images()
    return scene(tmp_path_factory.mktemp("hard"), blended(*given, beside(SEAM)), given)


def true_labels() -> np.ndarray:
    """One in ``LABEL_PX`` pixels."""
    middles = np.arange(0, SIDE, LABEL_PX) + LABEL_PX / 2 + 0.5
    return np.broadcast_to((middles > SEAM).astype(np.uint8), (SIDE // LABEL_PX, SIDE // LABEL_PX))


def by_cell(cells: CellTable, name: str) -> np.ndarray:
    """Sums of level 1 over all bins, (rows, columns) of the mosaic's cells."""
    sums = np.zeros((SIDE // CELL_PX, SIDE // CELL_PX))
    np.add.at(sums, (cells.row, cells.column), getattr(cells, name)[0])
    return sums


INSIDE = np.s_[1:-1, 1:-1]  # cells but for those at the mosaic's edge, where PyWavelets goes on at the opposite one


@pytest.mark.parametrize("density", ["seams", "full"])
def test_no_cell_counts_twice_and_all_energy_is_what_pywavelets_finds(hard: Scene, density: str) -> None:
    cells = measured(hard.request(density=density)).cells
    area, mm = by_cell(cells, "area"), by_cell(cells, "mm")
    assert area.max() == CELL_PX**2
    assert set(np.unique(area[INSIDE])) <= {0, CELL_PX**2}
    if density == "full":
        assert (area[INSIDE] > 0).all()
    energy = np.square(placed_wavedec(blended(*images(), beside(SEAM)), "coif3", 1)[1]).sum(axis=0)
    expected = energy.reshape(SIDE // CELL_PX, CELL_PX // 2, -1, CELL_PX // 2).sum(axis=(1, 3))
    known = area[INSIDE] > 0
    assert mm[INSIDE][known] == pytest.approx(expected[INSIDE][known], rel=2e-3)


def test_the_same_request_gives_the_same_bytes(hard: Scene) -> None:
    assert record_of(measured(hard.request())) == record_of(measured(hard.request()))


def test_blocks_side_by_side_measure_as_one(tmp_path: Path) -> None:
    """A part in full density is the same wherever blocks begin."""
    given = images()
    case = scene(tmp_path, blended(*given, beside(SEAM, 33)), given)
    whole = measured(case.request(density="full")).cells
    request = case.request(density="full")
    parts = [measured(replace(request, window=PixelWindow(column, row, 512, 512))).cells
             for row in (0, 512) for column in (0, 512)]
    joined = CellTable.joined(parts)
    assert (by_cell(joined, "area") == by_cell(whole, "area")).all()
    assert by_cell(joined, "mm")[INSIDE] == pytest.approx(by_cell(whole, "mm")[INSIDE], rel=2e-3)
    near = [float(cells.mm[0, cells.bin < 4].sum() / cells.cc[0, cells.bin < 4].sum())
            for cells in (whole, parts[0], parts[2])]
    assert near[1:] == pytest.approx([near[0]] * 2, abs=0.04)


@pytest.mark.parametrize("density", ["seams", "full"])
@pytest.mark.parametrize("side", [16, 24, 100])
def test_a_hole_in_the_mosaic_is_no_loss(tmp_path: Path, side: int, density: str) -> None:
    """However small a share of the block it is: 16 px of 1,000 are 0.03 %."""
    given = images()
    made = blended(*given, beside(SEAM))
    hole = np.s_[640 : 640 + side, 384 : 384 + side]
    made[hole] = NODATA
    request = scene(tmp_path, made, given).request(density=density)
    result = measured(replace(request, window=PixelWindow(128, 128, 768, 768)))
    cells = result.cells
    assert len(cells)
    strip = EDGES_PX.index(8)
    beyond = cells.chosen((cells.bin >= strip) & (cells.cc[0] > 0.05 * cells.cc[0].max()))  # but for the cut's edge
    assert (beyond.mm[0] / beyond.cc[0]).min() > 0.7
    near = cells.chosen(cells.bin < strip)
    assert near.mm[0].sum() / near.cc[0].sum() > 0.98
    first = (640 - 128) // LABEL_PX, (384 - 128) // LABEL_PX
    count = side // LABEL_PX
    assert (result.labels[first[0] : first[0] + count, first[1] : first[1] + count] == UNKNOWN).all()


def test_a_source_that_is_gone_costs_no_more_than_itself(tmp_path: Path) -> None:
    given = images()
    case = scene(tmp_path, blended(*given, beside(SEAM)), given)
    Path(case.sources[1].ref.path).unlink()
    result = scan_block(case.request())
    assert [case.sources[1].ref.name in str(notice) for notice in result.notices] == [True]
    left = SEAM // LABEL_PX
    assert (result.labels[: SIDE // LABEL_PX, :left - 4] == 0).all()
    assert (result.labels[: SIDE // LABEL_PX, left + 40 :] == UNKNOWN).mean() > 0.9


@pytest.mark.parametrize("broken", ["gone", "cut off"])
def test_a_mosaic_that_cannot_be_read_is_told_and_nothing_is_raised(tmp_path: Path, broken: str) -> None:
    given = images((256, 256))
    case = scene(tmp_path, given[0], given)
    path = Path(case.mosaic.ref.path)
    if broken == "gone":
        path.unlink()
    else:
        path.write_bytes(path.read_bytes()[:3000])
    result = scan_block(case.request())
    assert len(result.notices) == 1
    assert case.mosaic.ref.name in str(result.notices[0])
    assert (result.labels == UNKNOWN).all()


def test_only_what_is_wanted_is_measured_densely(hard: Scene) -> None:
    wanted = np.zeros((UNITS, UNITS), bool)
    wanted[:8, 10:14] = True
    result = scan_block(hard.request(wanted=wanted))
    assert (result.dense == wanted).all()
    cells = result.cells
    assert (cells.row < 16).all()
    assert ((cells.column >= 20) & (cells.column < 28)).all()
    rows = 8 * UNIT_PX // LABEL_PX
    assert (result.labels[:rows, 80:112] == true_labels()[:rows, 80:112]).mean() > 0.998
    assert (np.delete(result.labels[:rows], np.s_[80:112], axis=1) == UNKNOWN).all()
