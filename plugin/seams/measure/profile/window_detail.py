"""The detail of one window against its sources: what profile, picture of losses and causes are made from."""
from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ....imagery.wavelets import placed_components
from ..following.expected_mosaic import ExpectedMosaic
from .cell_table import CELL_PX, EDGES_PX, MIXED_BINS, CellTable, MixtureTable, WholeCells, whole_cells
from .detail_sums import compared_planes, detail_sums, numbers_of
from .ground import LevelGround, grounds
from .seam_profile import SeamProfile
from .seam_sums import SeamSums

_EDGE_CELLS = 1
"""In which periodic wavelets show what lies at the other edge of all that was read."""


@dataclass(frozen=True, eq=False)
class WindowDetail:
    """Of a window and the ground that was read around it."""

    finest: np.ndarray
    """(3, planes, rows / 2, columns / 2): of the mosaic, of its hard cut, and of that unfiltered."""
    cells: CellTable
    mixture: MixtureTable
    inside: tuple[slice, slice]
    """Rows and columns of the cells that are judged; those around are ground alone."""

    @cached_property
    def whole(self) -> WholeCells:
        """The cells, all bins of each together."""
        return whole_cells(self.cells)

    @cached_property
    def ground(self) -> list[LevelGround | None]:
        """By level; where there is enough of it without the edge, at which another source than at the other edge may be
        followed."""
        end_row, end_column = (int(one.max(initial=0)) + 1 - _EDGE_CELLS for one in (self.cells.row, self.cells.column))
        inner = grounds(self.cells.within((slice(_EDGE_CELLS, end_row), slice(_EDGE_CELLS, end_column))))
        return inner if all(inner) else [one or more for one, more in zip(inner, grounds(self.cells, self.whole))]

    @property
    def judged(self) -> CellTable:
        """The window's own cells."""
        return self.cells.within(self.inside)

    def unmixed(self) -> np.ndarray:
        """The window's cells that lie wholly beyond what its seams mix, (rows, columns) bool; all without a seam."""
        rows, columns = self.inside
        made = np.zeros((rows.stop, columns.stop), bool)
        reach = 0.0 if self.profile is None else (self.profile.feather_width_px or 0.0) / 2
        if reach >= EDGES_PX[MIXED_BINS]:  # it does not end where it is looked for
            return made[rows, columns]
        far = self.whole.nearest >= np.searchsorted(EDGES_PX, reach)
        row, column = self.whole.row, self.whole.column
        within = far & (row < rows.stop) & (column < columns.stop)
        made[row[within], column[within]] = True
        return made[rows, columns]

    @property
    def has_seam(self) -> bool:
        """Whether two sources meet in the window; those that meet beside it are no seam of its."""
        return bool((self.judged.bin == 0).any())

    @cached_property
    def profile(self) -> SeamProfile | None:
        """A window is a scan of one piece; None without a seam, or with too little to be measured."""
        whole = self.whole
        rows, columns = self.inside
        judged = (whole.row >= rows.start) & (whole.row < rows.stop)
        judged &= (whole.column >= columns.start) & (whole.column < columns.stop)
        sums = SeamSums(1, self.cells.levels)
        sums.add(self.cells, self.mixture, whole, self.ground, np.where(judged, 0, -1))
        return sums.profiles()[0].profile if self.has_seam else None


def window_detail(
    mosaic: np.ndarray, expected: ExpectedMosaic, valid: Mapping[int, np.ndarray], wavelet: str, levels: int,
    inside: tuple[slice, slice] | None = None,
) -> WindowDetail:
    """Of planes (rows, columns) float32, both multiples of 2^R.

    ``valid``: (rows, columns) bool, pixels that a source has, of those that don't have all. ``inside``: rows and
    columns of the pixels that are judged; all where None.
    """
    planes = compared_planes(mosaic, expected)
    count = len(planes)
    if expected.unfiltered is not expected.plane:
        planes = np.concatenate([planes, expected.unfiltered[np.newaxis]])
    details = list(placed_components(planes, wavelet, levels))
    cells, mixture = detail_sums(details, expected.labels, numbers_of(expected), valid, expected.is_filtered)
    kept = [0, 1, *range(count, len(planes))]
    rows, columns = inside or (slice(0, mosaic.shape[0]), slice(0, mosaic.shape[1]))
    own = slice(rows.start // CELL_PX, rows.stop // CELL_PX), slice(columns.start // CELL_PX, columns.stop // CELL_PX)
    return WindowDetail(details[0][:, kept], cells, mixture, own)
