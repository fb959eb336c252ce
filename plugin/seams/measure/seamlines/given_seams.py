"""Seams as producers deliver them: lines with what lies left and right, or polygons of what each part was made from."""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import chain

import numpy as np

from ....imagery import lines as seamlines
from ....imagery import messages as imagery_messages
from ....imagery.errors import Message, SeamlineError, SeamsElsewhereError
from ....imagery.grids import Grid
from .. import messages
from ..seam_cells import Cell, meant_sources
from .seam_features import SeamFeature, gathered, owner_name, said, seam_fields
from .seam_pieces import SidedSeam

_NAMED = 3  # ambiguous names that are told


@dataclass(frozen=True, eq=False)
class GivenSeams:
    """What a layer of seams says."""

    seams: tuple[SidedSeam, ...]
    """Longest first."""
    cells: tuple[Cell, ...]
    """The polygons that name their orthoimage."""
    notices: tuple[Message, ...]
    """What is wrong with it or lacks in it, and is left out or assumed."""
    dates: Mapping[str, str] = field(default_factory=dict)
    """When what lies beside the seams was taken, by its name; of those only that are said to be of one date."""


def given_seams(
    features: Iterable[SeamFeature], grid: Grid, source_field: str = "", paths: Sequence[str] = ()
) -> GivenSeams:
    """The seams that a layer's lines and polygons describe inside the mosaic's grid, and what lies beside them.

    ``source_field``: see ``seam_fields``. ``paths``: of the sources; a name that fits several of them tells nothing.
    Borders between polygons of one source are no seams, and what lies between two overlapping or gaping polygons has
    none. Raises SettingsError when the layer has no such field, SeamsElsewhereError when it lies elsewhere or the
    mosaic in one polygon, SeamlineError when it is empty, spans far more than a mosaic can, or holds no seam.
    """
    held = list(features)
    rows = [attributes for attributes, _ in held]
    fields = seam_fields(rows, source_field)
    names = {said(row.get(name)) for row in rows for name in fields.naming}
    meant = meant_sources(names - {""}, [(path,) for path in paths])
    ambiguous = {name for name, places in meant.items() if len(places) > 1}
    pieces = gathered(held, fields, grid, ambiguous)
    network = _Network(grid)
    owners, sides = [owner for _, owner in pieces.rings], [of_line for _, of_line in pieces.lines]
    if owners:
        network.add_polygons([ring for ring, _ in pieces.rings], owners)
    if sides:
        network.add_lines([line for line, _ in pieces.lines], sides)
    named = any(map(owner_name, chain(owners, *sides)))

    def longest_first(seam: SidedSeam) -> tuple[float, float, float]:
        return -round(seam.length / grid.pixel_width, 3), seam.vertices[0, 0], seam.vertices[0, 1]

    seams = sorted(network.seams(), key=longest_first)
    if not seams and not sides and len({*owners}) == 1:
        raise SeamsElsewhereError(messages.SEAMS_PART_NOTHING())
    if not seams:
        raise SeamlineError(
            imagery_messages.SEAMLINES_APART() if pieces.rings else imagery_messages.SEAMLINES_TOO_SHORT()
        )
    notices = [
        *([messages.SEAM_FEATURES_BROKEN(count=pieces.broken).as_warning()] if pieces.broken else []),
        *([messages.SEAM_POLYGONS_REPAIRED(count=pieces.repaired)] if pieces.repaired else []),
        *([messages.SEAMS_NAMED_BY(fields=", ".join(fields.naming))] if fields.naming and not source_field else []),
    ]
    if fields.names_by_date and named and pieces.rings:
        notices.append(messages.SEAMS_NAMED_BY_DATE(field=fields.date))
    elif not named and not ambiguous:
        notices.append(messages.SEAMS_UNNAMED())
    if ambiguous:
        ambiguous_names = ", ".join(sorted(ambiguous)[:_NAMED])
        notices.append(messages.SEAM_SOURCES_AMBIGUOUS(count=len(ambiguous), names=ambiguous_names))
    dates = {name: next(iter(days)) for name, days in pieces.dates.items() if len(days) == 1}
    return GivenSeams(tuple(seams), tuple(pieces.cells), tuple(notices), dates)


class _Network:
    """Straight pieces between common nodes, each with what lies on either side of it."""

    def __init__(self, grid: Grid) -> None:
        xmin, ymin, _, _ = grid.extent
        self._origin, self._size = complex(xmin, ymin), grid.pixel_width
        self._parts: list[tuple[np.ndarray, np.ndarray, np.ndarray, list[str]]] = []

    def add_polygons(self, rings: Sequence[np.ndarray], owners: Sequence[str]) -> None:
        """The borders that have one owner on their left and another on their right."""
        names, owner = np.unique(owners, return_inverse=True)
        ends, ring = seamlines.line_pieces(rings)
        shift, ends = self._in_pixels(ends)
        nodes, pairs, low, high = seamlines.borders(ends, owner[ring])
        # Two owners on one side overlap there: the line is inside one of them, and no border.
        border = (low == high).all(axis=0) & (low[0] != low[1])
        self._parts.append((nodes + shift, pairs[border], low[:, border].T, [str(name) for name in names]))

    def add_lines(self, lines: Sequence[np.ndarray], sides: Sequence[tuple[str, str]]) -> None:
        """Lines, those up to half a pixel apart as one."""
        names, side = np.unique(np.array(sides), return_inverse=True)
        side = side.reshape(-1, 2)
        ends, line = seamlines.line_pieces(lines)
        shift, ends = self._in_pixels(ends)
        nodes, edges, piece = seamlines.network(ends, seamlines.SNAP_PX)
        pairs, pair = seamlines.undirected(edges, len(nodes))
        first = np.full(len(pairs), len(edges))
        np.minimum.at(first, pair, np.arange(len(edges)))
        of_pair = side[line[piece[first]]]
        backward = edges[first, 0] > edges[first, 1]
        of_pair[backward] = of_pair[backward, ::-1]
        self._parts.append((nodes + shift, pairs, of_pair, [str(name) for name in names]))

    def seams(self) -> Iterator[SidedSeam]:
        """The longest paths through pieces that part the same two owners."""
        for nodes, pairs, sides, names in self._parts:
            group = sides.min(axis=1) * len(names) + sides.max(axis=1)
            order = np.argsort(group, kind="stable")
            for chosen in np.split(order, np.flatnonzero(np.diff(group[order])) + 1):
                if len(chosen):
                    yield from self._of_group(nodes, pairs[chosen], sides[chosen], names)

    def _of_group(
        self, nodes: np.ndarray, pairs: np.ndarray, sides: np.ndarray, names: Sequence[str]
    ) -> Iterator[SidedSeam]:
        used, local = np.unique(pairs, return_inverse=True)
        key = local.reshape(-1, 2) @ (len(used), 1)  # ascending, as the pairs and the nodes in each are
        places = nodes[used]
        for seam, walk in seamlines.seam_paths(places, local.reshape(-1, 2)):
            low, high = np.sort([walk[:-1], walk[1:]], axis=0)
            edge_sides = sides[np.searchsorted(key, low * len(used) + high)]
            edge_sides = np.where((walk[:-1] == low)[:, np.newaxis], edge_sides, edge_sides[:, ::-1])
            first, other = int(edge_sides[0].min()), int(edge_sides[0].max())
            weight = abs(np.diff(places[walk]))
            is_left = weight[edge_sides[:, 0] == first].sum() * 2 >= weight.sum()
            left, right = (first, other) if is_left else (other, first)
            named = (owner_name(names[side]) or None for side in (left, right))
            yield SidedSeam(seamlines.as_xy(seam * self._size + self._origin), *named)

    def _in_pixels(self, ends: np.ndarray) -> tuple[complex, np.ndarray]:
        """Places in pixels, none of them negative, and what has to be added to have them from the mosaic's corner."""
        ends = (ends - self._origin) / self._size
        seamlines.check_extent(ends)
        shift = complex(np.floor(ends.real.min()), np.floor(ends.imag.min()))
        return shift, ends - shift
