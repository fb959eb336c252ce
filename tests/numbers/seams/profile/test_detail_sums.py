"""Sums of detail over cells and distances from the seam, by plain geometry."""
from __future__ import annotations

import numpy as np
import pytest
from seam_inspector.plugin.imagery.wavelets import detail_components
from seam_inspector.plugin.seams.measure.profile.cell_table import CELL_PX, EDGES_PX, FARTHEST, CellTable
from seam_inspector.plugin.seams.measure.profile.detail_sums import (
    MeetingSources,
    detail_sums,
    seam_geometry,
    seam_samples,
)
from seam_inspector.plugin.seams.measure.seam_cells import UNKNOWN

from tests.numbers.synthetic import texture

LEVELS, WAVELET = 3, "coif3"
SHAPE = (128, 160)


def marked(values: np.ndarray) -> list[np.ndarray]:
    """Details whose energies are given at the finest level and nothing at the others: (rows, columns) of that level."""
    rows, columns = values.shape
    details = [np.zeros((3, 2, rows >> r, columns >> r)) for r in range(LEVELS)]
    details[0][1] = np.sqrt(values)
    return details


def of_marked(details: list[np.ndarray], labels: np.ndarray) -> CellTable:
    return detail_sums(details, MeetingSources(labels.astype(np.uint8)))[0]


def test_what_is_unknown_takes_no_part_nor_do_its_neighbours() -> None:
    gap = np.s_[32:80, 96:144]
    labels = np.broadcast_to((np.arange(SHAPE[1]) >= 64).astype(np.uint8), SHAPE).copy()
    labels[gap] = UNKNOWN
    energies = np.zeros((64, 80))
    energies[16:40, 48:72] = 1e6  # of the gap itself
    energies[13, 50] = energies[30, 45] = 1e6  # 5 px beside it
    sums = of_marked(marked(energies), labels)
    assert sums.mm[0].sum() == 0
    grown = np.zeros(SHAPE, bool)
    grown[32 - 8 : 80 + 8, 96 - 8 : 144 + 8] = True
    assert sums.area[0].sum() == (~grown).sum()
    energies[10, 50] = 1.0  # 12 px beside it
    assert of_marked(marked(energies), labels).mm[0].sum() == pytest.approx(1)


def test_the_border_of_what_is_unknown_is_no_seam() -> None:
    labels = np.zeros(SHAPE, np.uint8)
    labels[:, 64:96] = UNKNOWN
    geometry = seam_geometry(labels)
    assert not seam_samples(labels)[0].any()
    assert set(np.unique(geometry.bins)) == {FARTHEST, len(EDGES_PX)}
    labels[:, 96:] = 1  # two sources, and between them ground that neither explains
    assert not seam_samples(labels)[0].any()


def test_what_lies_beyond_whole_cells_is_known_to_them() -> None:
    """A seam, a hole and a third source in a rim narrower than a cell."""
    shape = (CELL_PX * 4 + 8, CELL_PX * 5 + 8)
    labels = np.zeros(shape, np.uint8)
    labels[:, -4:], labels[-4:] = 1, 2
    planes = np.stack([25 * texture(shape, 1.2, seed) for seed in range(5)]).astype(np.float32)
    shares = {number: np.full((9, 11), 1 / 3, np.float32) for number in range(3)}
    sources = MeetingSources(labels, (0, 1, 2), shares)
    cells, beside = detail_sums(list(detail_components(planes, WAVELET, 3)), sources)
    assert (cells.row.max(), cells.column.max()) == (3, 4)
    assert cells.bin[cells.column == 4].min() < FARTHEST
    assert set(beside.other.tolist()) == {1, 2}
