"""The detail of one window against its sources: what profile, picture of losses and causes are made from; and the
picture of where it lost detail, smooth enough that sound ground is even."""
from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from scipy import ndimage

from ....imagery.wavelets import placed_components
from ..following.boxes import enlarged, in_squares
from ..following.expected_mosaic import ExpectedMosaic
from ..limits import SHARPNESS_TOLERANCE
from ..seam_cells import UNKNOWN, present
from .cell_table import CELL_PX, EDGES_PX, MIXED_BINS, CellTable, MixtureTable
from .detail_sums import (
    MeetingSources,
    compared_planes,
    detail_sums,
    energy_of_rounding,
    explained_samples,
    seam_samples,
)
from .ground import LevelGround, grounds
from .seam_profile import SeamProfile
from .seam_sums import SeamSums


@dataclass(frozen=True, eq=False)
class WindowDetail:
    """Detail of a window and of the ground that was read around it."""

    finest: np.ndarray
    """(3, planes, rows / 2, columns / 2): of the mosaic, of its hard cut, and of that unfiltered."""
    cells: CellTable
    mixture: MixtureTable
    inside: tuple[slice, slice]
    """Rows and columns of the cells that are judged; those around are ground alone."""
    of_rounding: float
    """Most energy of detail that rounding leaves, a pixel, DN squared (``energy_of_rounding``)."""

    def judged_inside(self, rows: slice, columns: slice) -> WindowDetail:
        """This detail, of which these pixels are judged."""
        rows, columns = (slice(part.start // CELL_PX, part.stop // CELL_PX) for part in (rows, columns))
        return replace(self, inside=(rows, columns))

    @cached_property
    def ground(self) -> list[LevelGround | None]:
        """Ground far from any seam, by level; None where there is too little."""
        return grounds(self.cells)

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
        cells = self.cells.whole
        far = cells.chosen((cells.bin >= np.searchsorted(EDGES_PX, reach)) & cells.are_within(self.inside))
        made[far.row, far.column] = True
        return made[rows, columns]

    @property
    def has_seam(self) -> bool:
        """Whether two sources meet in the window; those that meet beside it are no seam of its."""
        return bool((self.judged.bin == 0).any())

    @cached_property
    def profile(self) -> SeamProfile | None:
        """A window is a scan of one piece; None without a seam, or with too little to be measured."""
        return self._profiles(np.zeros(len(self.cells), np.intp))[0] if self.has_seam else None

    def by_pair(self) -> tuple[SeamProfile, ...]:
        """Profiles of the seams between each two sources that can be measured; none where all are of one pair. A cell
        is of the pair of most of its pixels."""
        seam, whole = self.mixture, self.cells.whole
        codes = np.minimum(seam.source, seam.other).astype(np.intp) << 8 | np.maximum(seam.source, seam.other)
        pairs, pair = np.unique(codes, return_inverse=True)
        if len(pairs) < 2:
            return ()
        place = np.searchsorted(whole.keys, seam.keys) * len(pairs) + pair
        areas = np.bincount(place, seam.products[0, 0], len(whole) * len(pairs)).reshape(-1, len(pairs))
        of_cell = np.where(areas.any(axis=1), areas.argmax(axis=1), -1)
        profiles = tuple(filter(None, self._profiles(of_cell[self.cells.cell])))
        return profiles if len(profiles) > 1 else ()

    def _profiles(self, piece: np.ndarray) -> list[SeamProfile | None]:
        """Profiles of the pieces that the cells' rows are of, (n,), -1 for none, as far as they lie in the window."""
        sums = SeamSums(int(piece.max()) + 1, self.cells.levels)
        sums.add(self.cells, self.mixture, self.ground, np.where(self.cells.are_within(self.inside), piece, -1))
        profiles = [strip.profile for strip in sums.profiles()]
        return [each if each is not None and each.energy[0] > self.of_rounding else None for each in profiles]


def window_detail(mosaic: np.ndarray, expected: ExpectedMosaic, wavelet: str, levels: int) -> WindowDetail:
    """Detail of a window, from planes (rows, columns) float32, both multiples of 2^R."""
    planes = compared_planes(mosaic, expected)
    count = len(planes)
    if expected.unfiltered is not expected.plane:
        planes = np.concatenate([planes, expected.unfiltered[np.newaxis]])
    details = list(placed_components(planes, wavelet, levels))
    of_rounding = energy_of_rounding(mosaic)
    cells, mixture = detail_sums(details, MeetingSources.of(expected), of_rounding)
    kept = [0, 1, *range(count, len(planes))]
    rows, columns = (slice(0, length // CELL_PX) for length in mosaic.shape)
    return WindowDetail(details[0][:, kept], cells, mixture, (rows, columns), of_rounding)


LOSS_CELL_PX = 8
"""Side of a cell of the picture."""
SAMPLE_PX = 2
"""A coefficient of the finest level stands for so many pixels either way."""
_SMOOTH_CELLS = 1.0  # standard deviation: with less, sound ground shows spots; with more, a narrow feather fades
_SMOOTH_ROUGH_CELLS = 2.5
"""Standard deviation where the ground itself is rough, as compression leaves it."""
_ROUGH = 0.04  # scatter of log kept over the ground: 0.00 as cut, 0.02 with noise of 5 DN, 0.1 and more after JPEG
_SURE = 2.5  # standard deviations of that scatter: less far below 1, a cell may have kept all
_LEAST_EXPLAINED = 0.5  # of a cell, for it to be told


@dataclass(frozen=True, eq=False)
class LossPicture:
    """kept_1 of every cell of a window."""

    kept: np.ndarray
    """At least 1 where what seems lost may be the scatter of the ground around, which compression leaves rough.
    (rows, columns) float32 from the window's upper left, NaN where nothing can be told. Where the window is no
    multiple of the cell, the last row and column reach beyond it."""
    cell_px: int = LOSS_CELL_PX
    """Side of a cell, pixels of the mosaic."""
    seam: np.ndarray = field(default_factory=lambda: np.empty((0, 2), np.uint16))
    """(n, 2) uint16, row and column of the squares of ``SAMPLE_PX`` in which sources meet."""


def loss_picture(
    detail: WindowDetail, labels: np.ndarray, inside: tuple[slice, slice] | None = None
) -> LossPicture | None:
    """Picture of a window's losses; None where there is too little ground to compare with.

    ``labels``, (rows, columns) uint8: the source of every pixel of the window and what was read around it, ``UNKNOWN``
    where none explains it. ``inside``: rows and columns of the window in that; all where None.
    """
    ground, cells = detail.ground[0], detail.cells.whole
    if ground is None:
        return None
    far, is_ground = cells.chosen(ground.is_far(cells)), np.zeros([length // CELL_PX for length in labels.shape], bool)
    is_ground[far.row, far.column] = True
    explained = explained_samples(labels)
    energies = [np.einsum("dij,dij->ij", plane, plane) for plane in detail.finest.swapaxes(0, 1)]
    mosaic, source, area = (_in_cells(plane * explained) for plane in (*energies[:2], np.ones_like(explained)))
    energy = _over_neighbours(source) / np.maximum(_over_neighbours(area) * SAMPLE_PX**2, 1)  # of some CELL_PX
    expected = source * ground.amplitude(energy)
    known = area >= _LEAST_EXPLAINED * _in_cells(np.ones_like(explained))
    is_ground = known & enlarged(is_ground, CELL_PX // LOSS_CELL_PX, known.shape)
    for smooth_cells in (_SMOOTH_CELLS, _SMOOTH_ROUGH_CELLS):
        smooth, smooth_expected = (ndimage.gaussian_filter(cell, smooth_cells) for cell in (mosaic, expected))
        is_measurable = known & (smooth_expected > 0)
        kept = np.full(known.shape, np.nan, np.float32)
        np.divide(smooth, smooth_expected, out=kept, where=is_measurable, casting="same_kind")
        around = kept[is_ground & is_measurable & (kept > 0)]
        scatter = float(np.log(around).std()) if around.size else 0.0
        if scatter <= _ROUGH:
            break
    may_be_all = kept * np.exp(_SURE * scatter) >= 1
    kept[may_be_all] = np.maximum(kept[may_be_all], 1)
    rows, columns = inside or (slice(0, labels.shape[0]), slice(0, labels.shape[1]))
    own_cells = tuple(slice(part.start // LOSS_CELL_PX, -(-part.stop // LOSS_CELL_PX)) for part in (rows, columns))
    samples = tuple(slice(part.start // SAMPLE_PX, part.stop // SAMPLE_PX) for part in (rows, columns))
    kept, labels = kept[own_cells], labels[rows, columns]
    _lower_to_sources(kept, expected[own_cells], energies[0][samples], energies[-1][samples], labels)
    return LossPicture(kept, seam=np.argwhere(seam_samples(labels)[0]).astype(np.uint16))


def _lower_to_sources(
    kept: np.ndarray, expected: np.ndarray, mosaic_energy: np.ndarray, cut_energy: np.ndarray, labels: np.ndarray
) -> None:
    """In place, what is kept of the ground becomes what is kept of each source: where one is followed, all that is lost
    is what is missing of it, be it blurred alone or moved.

    ``mosaic_energy``, ``cut_energy``: of the mosaic's finest coefficients, and of those of its hard cut, unfiltered.
    """
    middle = labels[LOSS_CELL_PX // 2 :: LOSS_CELL_PX, LOSS_CELL_PX // 2 :: LOSS_CELL_PX]
    followed = np.full(kept.shape, UNKNOWN, np.uint8)
    followed[: middle.shape[0], : middle.shape[1]] = middle
    samples = labels[::SAMPLE_PX, ::SAMPLE_PX]
    for number in present(labels):
        where = (followed == number) & ~np.isnan(kept)
        mosaic_total, cut_total = (
            float(energy[samples == number].sum(dtype=np.float64)) for energy in (mosaic_energy, cut_energy)
        )
        most_1, weights = np.minimum(kept[where], 1), expected[where]
        around = float(most_1 @ weights)
        if cut_total <= 0 or around <= 0:
            continue
        lowered = mosaic_total / cut_total * float(weights.sum()) / around
        if lowered < (1 - SHARPNESS_TOLERANCE) ** 2:
            kept[where] = most_1 * np.float32(lowered)


def _in_cells(samples: np.ndarray) -> np.ndarray:
    """Sums over the cells, float64; those at the end are smaller where they don't fit."""
    side = LOSS_CELL_PX // SAMPLE_PX
    padded = np.pad(samples.astype(np.float32, copy=False), [(0, -length % side) for length in samples.shape])
    return in_squares(padded, side).sum(axis=1).sum(axis=2, dtype=np.float64)


def _over_neighbours(cells: np.ndarray) -> np.ndarray:
    """Means over a cell and half of those beside it."""
    for axis in (0, 1):
        cells = ndimage.convolve1d(cells, (0.25, 0.5, 0.25), axis=axis)
    return cells
