"""What the ground of a whole mosaic follows, unit by unit, held against its seams: ground that no source explains or
that has no pixels, and borders between sources that no seam tells of.

A border runs midway between the nearest units of two sources. Where these lie side by side that is where it is; across
a strip that was blurred or cut out it has to be somewhere between the two: a seam that crosses the way from one to the
other tells of it.

And whether a mosaic lies beside all its orthoimages by one shift, where it matches none of them.
"""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy import ndimage

from ....imagery.errors import RasterError
from ....imagery.grids import standard_window
from ....imagery.lines import points_along
from ....imagery.shifts import find_shift
from ..blocks.block_grid import UNIT_PX, BlockGrid
from ..blocks.block_pixels import BlockPixels
from ..blocks.scan_block import EMPTY, LACKING, NOT_LOOKED, PLAIN
from ..following.boxes import square_shares
from ..following.placed_sources import FARTHEST_FILTERED_PX
from ..profile.seam_profile import LEAST_SEAM_PX
from ..seamlines.seam_pieces import SeamPiece
from .scan_request import SHORTEST_PIECE_PX, ScanRequest

LEAST_UNEXPLAINED = 0.03
"""Least share of the ground that no source explains, to be told."""
LEAST_PART = 0.01
"""Least share of the ground in a part without a source: a missing orthoimage leaves whole parts, chance scatter."""
WIDEST_GAP_PX = 256
"""A strip without pixels that is wider parts two areas; a narrower one may hide a seam, and is no outline."""
_AT_SEAM_PX, _ON_SEAM_PX = 32, 8  # borders that lie so near a seam are its own; what a seam crosses
_OPPOSITE = 0.85  # of the way across a gap and back, from bank to bank: at a corner of the outline both are near
_TILE = 32  # units: a border's length is that of straight lines across so many
_PLACES = 3  # that are told, the largest first


@dataclass(frozen=True)
class GroundPlace:
    """A part of the ground."""

    x: float
    """Its middle, ``x`` and ``y``, map units."""
    y: float
    width_m: float
    """From west to east."""
    height_m: float
    metres: float = 0.0
    """Length of border between two sources in it."""

    def __str__(self) -> str:
        """Text of the place as layers have it."""
        return f"{self.x:.10g} {self.y:.10g} {self.width_m:.0f} {self.height_m:.0f}"


class FollowedGround:
    """The units of a mosaic, and the pieces of its seams."""

    def __init__(self, units: np.ndarray, blocks: BlockGrid, pieces: Iterable[SeamPiece], piece_m: float) -> None:
        """``units``: (rows, columns) int of whole blocks, as ``BlockScan.ground``, with numbers of all sources."""
        self._grid, self._piece_m = blocks.grid, piece_m
        self._unit_m, self._shortest_m = (
            length * self._grid.ground_sample_distance for length in (UNIT_PX, SHORTEST_PIECE_PX)
        )
        self._rows, self._columns = (-(-length // UNIT_PX) for length in (self._grid.rows, self._grid.columns))
        self._units = units[: self._rows, : self._columns]
        # What is too short to be measured tells nothing of a border, be there a piece of it every few metres.
        least_m = LEAST_SEAM_PX * self._grid.ground_sample_distance
        long = [piece for piece in pieces if piece.length_m >= least_m]
        paths = [self._grid.to_pixels(piece.vertices) for piece in long]
        self._on_seam = self._marked(paths)
        # Beside a seam, not beyond its end, which no other shares: there it may have been cut off.
        ends = np.concatenate([np.zeros((0, 2)), *(path[[0, -1]] for path in paths)])
        _, which, count = np.unique(np.rint(ends), axis=0, return_inverse=True, return_counts=True)
        along = self._on_seam & ~self._marked([end[np.newaxis] for end in ends[count[which.ravel()] == 1]])
        self._at_seam = self._on_seam | ndimage.maximum_filter(along, 2 * _AT_SEAM_PX // UNIT_PX + 1)

    def _marked(self, paths: Sequence[np.ndarray]) -> np.ndarray:
        """Units that lines run through, bool; columns and rows of their vertices in pixels."""
        marked = np.zeros((self._rows, self._columns), bool)
        for path in paths:
            points = points_along(path, _ON_SEAM_PX)
            for aside in (0, -_ON_SEAM_PX, _ON_SEAM_PX):
                column, row = ((points + aside) // UNIT_PX).astype(int).T
                marked[row.clip(0, self._rows - 1), column.clip(0, self._columns - 1)] = True
        return marked

    @property
    def told(self) -> Mapping[str, str]:
        """What layers and pictures say of it; metres, shares of 1, and places as ``GroundPlace`` writes them."""
        notes = {"unexplained": f"{self.unexplained:.4f}"}
        if self.looked < 1:
            notes["looked_at"] = f"{self.looked:.4f}"
        if self.unexplained >= LEAST_UNEXPLAINED:
            # Its border with what follows a source: as much seam may be there, where none is known. By the sides of
            # units, whose staircases are 4 / pi times as long as lines of any direction (Cauchy).
            lacks, followed = self._lacking & ~self._at_seam, self._units >= 0
            sides = sum(
                np.count_nonzero(first[:-1] & other[1:]) for first, other in
                ((lacks, followed), (followed, lacks), (lacks.T, followed.T), (followed.T, lacks.T))
            )
            notes["unexplained_border"] = f"{np.pi / 4 * float(sides) * self._unit_m:.1f}"
        if self.empty:
            notes["nodata_inside"] = f"{self.empty:.6f}"
        for name, borders in (("unseen", self.unseen), ("hidden", self.hidden)):
            if borders:
                notes[f"{name}_metres"] = f"{sum(border.metres for border in borders):.1f}"
                notes[f"{name}_longest"] = f"{borders[0].metres:.1f}"
        for name, places in (
            ("unexplained", self.unexplained_places), ("nodata", self._places(self._inside)),
            ("unseen", self.unseen), ("hidden", self.hidden),
        ):
            if places:
                notes[f"{name}_at"] = "; ".join(map(str, places[:_PLACES]))
        return notes

    @property
    def looked(self) -> float:
        """Share of the mosaic that was looked at."""
        count = np.count_nonzero(self._units != EMPTY)
        return 1 - np.count_nonzero(self._units == NOT_LOOKED) / count if count else 0.0

    @property
    def unexplained(self) -> float:
        """Share of the ground with texture that follows no source, in parts that are no scatter."""
        total = np.count_nonzero((self._units >= 0) | (self._units == LACKING))
        return np.count_nonzero(self._lacking) / total if total else 0.0

    @property
    def unexplained_places(self) -> list[GroundPlace]:
        """Its parts, the largest first."""
        return self._places(self._lacking)

    @property
    def empty(self) -> float:
        """Share of the mosaic within its outline that has no pixels."""
        count = np.count_nonzero(self._inside)
        return count / (count + np.count_nonzero(self._units != EMPTY)) if count else 0.0

    @cached_property
    def unseen(self) -> list[GroundPlace]:
        """Borders between two sources that no seam tells of, in places that could hide the shortest piece that can be
        measured, the longest first."""
        return self._border_places(hidden=False)

    @cached_property
    def hidden(self) -> list[GroundPlace]:
        """Borders that ground hides which no source explains."""
        return self._border_places(hidden=True)

    @cached_property
    def _lacking(self) -> np.ndarray:
        """Units, bool, in parts large enough to hold a piece whichever way it runs, or much of the mosaic."""
        lacks = self._units == LACKING
        parts, _ = ndimage.label(lacks)
        sizes = np.bincount(parts.ravel())
        sizes[0] = 0
        total = np.count_nonzero((self._units >= 0) | lacks)
        is_part = sizes >= np.maximum(min(LEAST_PART * total, (self._piece_m / self._unit_m) ** 2), 1)
        return np.asarray(is_part[parts])

    @cached_property
    def _inside(self) -> np.ndarray:
        """Units without pixels, bool, that no way as wide as a gap leads to from outside."""
        empty = self._units == EMPTY
        if not empty.any():
            return empty
        reach = WIDEST_GAP_PX // 2 // UNIT_PX
        around = np.pad(empty, reach + 1, constant_values=True)
        wide, _ = ndimage.label(ndimage.distance_transform_edt(np.pad(around, 1, constant_values=True)) > reach)
        outside = ndimage.distance_transform_edt(wide != wide[0, 0]) <= reach
        inside = empty & ~outside[reach + 2 : -reach - 2, reach + 2 : -reach - 2]
        parts, _ = ndimage.label(inside)
        sizes = np.bincount(parts.ravel())
        touching = np.unique(parts[ndimage.binary_dilation(empty & ~inside) & inside])
        sizes[touching[sizes[touching] < reach**2]] = 0  # corners of the outline
        sizes[0] = 0
        return np.asarray(sizes[parts] > 0)

    def _places(self, mask: np.ndarray) -> list[GroundPlace]:
        """The parts of some units, the largest first."""
        parts, _ = ndimage.label(mask, np.ones((3, 3)))
        order = np.argsort(-np.bincount(parts.ravel())[1:], kind="stable")
        boxes = ndimage.find_objects(parts)
        return [self._place(parts, int(number) + 1, boxes[number]) for number in order[:_PLACES]]

    def _place(
        self, parts: np.ndarray, number: int, box: tuple[slice, slice], metres: float = 0.0
    ) -> GroundPlace:
        """The unit in the middle of a part, and how far it reaches."""
        inside = ndimage.distance_transform_edt(np.pad(parts[box] == number, 1))
        deepest = np.argwhere(inside == inside.max())
        row, column = (deepest[len(deepest) // 2] + [side.start - 0.5 for side in box]) * UNIT_PX
        x, y = self._grid.to_map(float(column), float(row))
        down, across = (side.stop - side.start for side in box)
        return GroundPlace(x, y, across * self._unit_m, down * self._unit_m, metres)

    @cached_property
    def _borders(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Sides between units where the source changes and no seam tells of it: (n, 2) the unit above or to the left,
        whether the other one lies below, and whether the ground there hides it."""
        units, known = self._units, self._units >= 0
        if not known.any() or (units == units[0, 0]).all():
            return np.empty((0, 2), int), np.empty(0, bool), np.empty(0, bool)
        away, nearest = ndimage.distance_transform_edt(~known, return_indices=True)
        label = units[tuple(nearest)]
        borders = []
        for axis in (0, 1):
            first = np.argwhere(np.diff(label, axis=axis) != 0)
            other = first + (1 - axis, axis)
            above, below = tuple(first.T), tuple(other.T)
            way = away[above] + away[below] + 1
            from_, to = (np.column_stack([part[place] for part in nearest]) for place in (above, below))
            kinds = np.stack([units[above], units[below]])
            gap, lacks = ((kinds == kind).any(axis=0) for kind in (EMPTY, LACKING))
            straight = np.hypot(*(from_ - to).T) + 1 >= _OPPOSITE * way  # to a unit
            is_real = ~np.isin(kinds, (PLAIN, NOT_LOOKED)).any(axis=0)
            is_real &= ~gap | straight & (lacks | (way <= WIDEST_GAP_PX / UNIT_PX + 1))
            is_real &= ~((way <= 1) & (self._at_seam[above] | self._at_seam[below]))
            hides = lacks & ~gap
            is_real[is_real] = ~self._crossed(from_[is_real], to[is_real])
            borders.append((first[is_real], np.full(np.count_nonzero(is_real), axis == 0), hides[is_real]))
        first, is_below, hidden = (np.concatenate(parts) for parts in zip(*borders))
        return first, is_below, hidden

    def _crossed(self, start: np.ndarray, stop: np.ndarray) -> np.ndarray:
        """Whether a seam crosses the way from one unit to another, (n,) bool."""
        steps = 2 * np.ceil(np.hypot(*(stop - start).T)).astype(int)
        number = np.repeat(np.arange(len(steps)), steps + 1)
        place = np.arange(len(number)) - np.repeat(np.cumsum(steps + 1) - steps - 1, steps + 1)
        share = (place / np.maximum(steps, 1)[number])[:, np.newaxis]
        row, column = np.rint(start[number] + share * (stop - start)[number]).astype(int).T
        return np.bincount(number, self._on_seam[row, column], len(steps)) > 0

    def _border_places(self, hidden: bool) -> list[GroundPlace]:
        first, is_below, hides = self._borders
        if hidden:
            first, is_below = first[hides], is_below[hides]
        if not len(first):
            return []
        mask = np.zeros(self._units.shape, bool)
        mask[tuple(first.T)] = True
        mask[tuple((first + np.column_stack([is_below, ~is_below])).T)] = True
        # What is interrupted by less than a piece is one place.
        near = ndimage.distance_transform_edt(~mask) <= self._piece_m / self._unit_m / 2
        parts, count = ndimage.label(near, np.ones((3, 3)))
        parts[~mask] = 0
        part = parts[tuple(first.T)]
        tile = first // _TILE @ (self._columns // _TILE + 1, 1)
        _, group = np.unique(np.column_stack([part, tile]), axis=0, return_inverse=True)
        group = group.ravel()
        length = np.hypot(np.bincount(group, is_below), np.bincount(group, ~is_below)) * self._unit_m
        of_part = np.zeros(len(length), int)
        of_part[group] = part
        metres = np.bincount(of_part, length, count + 1)
        boxes = ndimage.find_objects(parts)
        order = np.argsort(-metres, kind="stable")[: np.count_nonzero(metres >= self._shortest_m)].tolist()
        return [self._place(parts, number, boxes[number - 1], float(metres[number])) for number in order]


LEAST_BESIDE = 0.1
"""Least share of the ground that no source explains, to be looked at: less may be what a seam or a building hides."""
_SIDE_PX, _STEP_PX = 1024, 4  # of what is compared at one place; sides of the squares whose means are
_LEAST_SHIFTS, _LEAST_AGREEING = 3, 0.75  # relief moves single ones by as much; share of the shifts
_SAME = 0.5  # of its length: shifts that differ by less are one, whatever the relief adds


def common_shift(request: ScanRequest, places: Sequence[GroundPlace]) -> tuple[float, float] | None:
    """Metres to the east and to the north by which a mosaic lies beside its orthoimages, as most of these agree at some
    places; None where they don't, or where it is so little that a filter tells it."""
    shifts = np.array([shift for place in places for shift in _shifts_at(request, place)]).reshape(-1, 2)
    if len(shifts) < _LEAST_SHIFTS:
        return None
    grid, middle = request.mosaic.grid, np.median(shifts, axis=0)
    agreeing = np.hypot(*(shifts - middle).T) < _SAME * np.hypot(*middle)
    if np.hypot(*middle) <= FARTHEST_FILTERED_PX or agreeing.mean() < _LEAST_AGREEING:
        return None
    x, y = middle.tolist()
    return x * grid.pixel_width * grid.metres_x, -y * grid.pixel_height * grid.metres_y


def _shifts_at(request: ScanRequest, place: GroundPlace) -> Iterator[tuple[float, float]]:
    """Pixels by which the mosaic lies to the right of and below each source around a place."""
    grid = request.mosaic.grid
    window = standard_window(grid, place.x, place.y, _SIDE_PX).moved_into(grid.columns, grid.rows)
    window = window.cut_to(grid.columns, grid.rows)
    refs = [request.sources[i].ref for i in request.footprints.meeting(grid.window_extent(window))]
    try:
        planes = BlockPixels(request.mosaic, refs, window, None).part(window, range(len(refs)))
    except RasterError:  # which the blocks told
        return
    mosaic = square_shares(planes.mosaic.plane, _STEP_PX)
    for source in planes.sources.values():
        valid = None if source.valid is None else square_shares(source.valid, _STEP_PX) == 1
        if (shift := find_shift(mosaic, square_shares(source.plane, _STEP_PX), valid)) is not None:
            yield _STEP_PX * shift.x, _STEP_PX * shift.y
