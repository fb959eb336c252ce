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
    owners, sides = [owner for _, owner in pieces.rings], [of_line for _, of_line in pieces.lines]
    networks = [_of_polygons([ring for ring, _ in pieces.rings], owners, grid)] if owners else []
    networks += [_of_lines([line for line, _ in pieces.lines], sides, grid)] if sides else []
    named = any(map(owner_name, chain(owners, *sides)))
    seams = list(chain.from_iterable(_seams(network, grid) for network in networks))
    seams.sort(key=lambda seam: (-round(seam.length / grid.pixel_width, 3), *seam.vertices[0].tolist()))
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


_Network = tuple[np.ndarray, np.ndarray, np.ndarray, list[str]]
"""Nodes in pixels from the mosaic's corner; pairs of them that straight pieces join, (n, 2), the lower number first and
ascending; what lies left and right of each, (n, 2); and the names of that."""


def _of_polygons(rings: Sequence[np.ndarray], owners: Sequence[str], grid: Grid) -> _Network:
    """The borders that have one owner on their left and another on their right."""
    names, owner = np.unique(owners, return_inverse=True)
    ends, ring = seamlines.line_pieces(rings)
    shift, ends = _in_pixels(ends, grid)
    nodes, pairs, low, high = seamlines.borders(ends, owner[ring])
    # Two owners on one side overlap there: the line is inside one of them, and no border.
    border = (low == high).all(axis=0) & (low[0] != low[1])
    return nodes + shift, pairs[border], low[:, border].T, [str(name) for name in names]


def _of_lines(lines: Sequence[np.ndarray], sides: Sequence[tuple[str, str]], grid: Grid) -> _Network:
    """Lines, those up to half a pixel apart as one."""
    names, side = np.unique(np.array(sides), return_inverse=True)
    ends, line = seamlines.line_pieces(lines)
    shift, ends = _in_pixels(ends, grid)
    nodes, edges, piece = seamlines.network(ends, seamlines.SNAP_PX)
    pairs, pair = seamlines.undirected(edges, len(nodes))
    _, first = np.unique(pair, return_index=True)
    of_pair = side.reshape(-1, 2)[line[piece[first]]]
    backward = edges[first, 0] > edges[first, 1]
    of_pair[backward] = of_pair[backward, ::-1]
    return nodes + shift, pairs, of_pair, [str(name) for name in names]


def _seams(network: _Network, grid: Grid) -> Iterator[SidedSeam]:
    """The longest paths through pieces that part the same two owners."""
    nodes, pairs, sides, names = network
    group = sides.min(axis=1) * len(names) + sides.max(axis=1)
    order = np.argsort(group, kind="stable")
    for chosen in np.split(order, np.flatnonzero(np.diff(group[order])) + 1):
        used, local = np.unique(pairs[chosen], return_inverse=True)
        local, places, of_pair = local.reshape(-1, 2), nodes[used], sides[chosen]
        key = local @ (len(used), 1)
        for seam, walk in seamlines.seam_paths(places, local):
            low, high = np.sort([walk[:-1], walk[1:]], axis=0)
            edge_sides = of_pair[np.searchsorted(key, low * len(used) + high)]
            edge_sides = np.where((walk[:-1] == low)[:, np.newaxis], edge_sides, edge_sides[:, ::-1])
            first, other = int(edge_sides[0].min()), int(edge_sides[0].max())
            weight = abs(np.diff(places[walk]))
            is_left = weight[edge_sides[:, 0] == first].sum() * 2 >= weight.sum()
            left, right = (first, other) if is_left else (other, first)
            named = (owner_name(names[side]) or None for side in (left, right))
            yield SidedSeam(seamlines.as_xy(seam * grid.pixel_width + _corner(grid)), *named)


def _in_pixels(ends: np.ndarray, grid: Grid) -> tuple[complex, np.ndarray]:
    """Places in pixels, none of them negative, and what has to be added to have them from the mosaic's corner."""
    ends = (ends - _corner(grid)) / grid.pixel_width
    seamlines.check_extent(ends)
    shift = complex(np.floor(ends.real.min()), np.floor(ends.imag.min()))
    return shift, ends - shift


def _corner(grid: Grid) -> complex:
    return complex(*grid.extent[:2])
