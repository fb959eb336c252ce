"""Seams that are cut anew: pieces of a scan, those that follow each other as one run."""
from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Callable

import numpy as np

from ....imagery.errors import SettingsError
from ....imagery.lines import as_xy, is_line, line_points, read_geometry, simple_parts, vertex_stations
from ....imagery.seam_totals import MOST_KEPT, STRETCH, PieceState, possible
from .. import messages
from ..judgement.verdicts import Verdict
from ..limits import ALL, FAILED, MENDED_SEAMS, REDUCED
from ..seamlines.seam_features import SeamFeature
from ..seamlines.seam_pieces import SeamPiece, cut_at, joined_pieces

LONGEST_PX = 1024.0
"""Longest run, so that memory does not grow with the seams; a single piece may be longer."""
FIELDS = ("seam_id", "station", "left_source", "right_source", "length", "kept_1", "state", "verdict")
"""Fields of the layer that a scan writes."""


@dataclass(frozen=True)
class SeamRun:
    """A piece of seam as a scan tells of it, or several that follow each other and are cut anew as one."""

    piece: SeamPiece
    """Its course, and what lies beside it by the names of the orthoimages."""
    kept: float | None
    """kept_1, the mean by length; None where it was not measured."""
    is_wanted: bool
    """Whether it is to be cut anew."""
    width_m: float
    """Width of the widest of its bands and feathers, as far as that is known."""
    numbers: tuple[int, ...] = ()
    """Numbers of its pieces, among all."""
    sides: tuple[int, int] = (0, 0)
    """Numbers of the sources on the left and on the right hand."""
    span: tuple[float, float] = (-math.inf, math.inf)
    """Stations of a part of its pieces, metres along the seam."""


def check_what(what: str) -> None:
    """Raise SettingsError for seams that are none of ``limits.MENDED_SEAMS``."""
    if what not in MENDED_SEAMS:
        raise SettingsError(messages.CHOICE_UNKNOWN(name="which", value=what, known=", ".join(MENDED_SEAMS)))


def given_pieces(
    features: Iterable[SeamFeature], names: Sequence[str], what: str,
    is_near: Callable[[np.ndarray], bool] = lambda vertices: True,
) -> list[SeamRun]:
    """The pieces of a scan's layer SEAMS, its outlines in the mosaic's reference system.

    ``what``: one of ``limits.MENDED_SEAMS``; of those only such as are ``is_near`` by their vertices are wanted. Raises
    SettingsError for a layer without the fields of a scan, or with none of its pieces.
    """
    check_what(what)
    missing = [name for name in FIELDS if name not in names]
    if missing:
        raise SettingsError(messages.NOT_OF_A_SCAN(fields=", ".join(missing)))
    every = [verdict.value for verdict in Verdict]
    lost = {FAILED: [], REDUCED: [Verdict.SIGNIFICANT.value, Verdict.REDUCED.value], ALL: every}[what]
    runs: list[SeamRun] = []
    for number, (row, wkb) in enumerate(features, 1):
        parts = [] if wkb is None else [part for part in simple_parts(read_geometry(wkb, number)) if is_line(part)]
        seam_id, station, length, kept, *widths = (
            _number(row.get(name)) for name in ("seam_id", "station", "length", "kept_1", "band_width", "feather_width")
        )
        if row.get("level") == STRETCH or len(parts) != 1 or parts[0].GetPointCount() < 2:
            continue
        points = as_xy(line_points(parts[0]))
        if seam_id is None or station is None or length is None or not np.isfinite(points).all():
            continue
        left, right = (str(row[name] or "") or None for name in ("left_source", "right_source"))
        wanted = row["state"] == PieceState.FAILED.value or row["verdict"] in lost
        piece = SeamPiece(int(seam_id), station, length, points, left, right)
        wide = max(width or 0.0 for width in widths)
        run = SeamRun(piece, possible(kept, MOST_KEPT), wanted and is_near(points), wide)
        is_ring = len(points) > 3 and (points[0] == points[-1]).all()  # which is cut in two halves
        runs += [part_of(run, 0, length / 2), part_of(run, length / 2, length)] if is_ring else [run]
    if not runs:
        raise SettingsError(messages.NO_PIECES())
    return runs


def _number(value: object) -> float | None:
    try:
        number = float(str(value))
    except ValueError:
        return None
    return number if math.isfinite(number) else None


def part_of(run: SeamRun, first_m: float, last_m: float, metres: np.ndarray | float = 1.0) -> SeamRun:
    """What lies between two places, metres from its start; ``metres``: of a map unit, along both axes."""
    piece = run.piece
    along = vertex_stations(piece.vertices * metres)
    along *= piece.length_m / along[-1]
    (vertices,) = cut_at(piece.vertices, along, np.array([first_m, last_m]))
    station, length = piece.station_m + first_m, last_m - first_m
    return replace(run, piece=replace(piece, vertices=vertices, station_m=station, length_m=length))


def seam_runs(
    pieces: Sequence[SeamRun], numbers: Mapping[str, int], ground_sample_distance: float
) -> tuple[list[SeamRun], list[SeamRun]]:
    """The runs of the wanted pieces, and the wanted pieces whose orthoimages are not known.

    ``numbers``: of the sources, by what the pieces call them.
    """
    runs: list[SeamRun] = []
    unnamed: list[SeamRun] = []
    wanted = [number for number, piece in enumerate(pieces) if piece.is_wanted]
    wanted.sort(key=lambda number: (pieces[number].piece.seam_id, pieces[number].piece.station_m))
    for number in wanted:
        run = pieces[number]
        left, right = (numbers.get(str(side)) for side in (run.piece.left, run.piece.right))
        if left is None or right is None or left == right:
            unnamed.append(run)
            continue
        alone = replace(run, numbers=(number,), sides=(left, right))
        if runs and _goes_on(runs[-1], alone, LONGEST_PX * ground_sample_distance):
            runs[-1] = _joined(runs[-1], alone)
        else:
            runs.append(alone)
    return runs, unnamed


def _goes_on(first: SeamRun, second: SeamRun, longest_m: float) -> bool:
    """Whether the second one begins where the first ends, and both together are no ring and not too long."""
    piece, other = first.piece, second.piece
    meets, is_ring = (
        np.allclose(end, start, rtol=0, atol=1e-6)
        for end, start in ((piece.vertices[-1], other.vertices[0]), (other.vertices[-1], piece.vertices[0]))
    )
    is_one = piece.seam_id == other.seam_id and first.sides == second.sides
    return is_one and bool(meets) and not is_ring and piece.length_m + other.length_m <= longest_m


def _joined(first: SeamRun, second: SeamRun) -> SeamRun:
    measured = [(run.kept, run.piece.length_m) for run in (first, second) if run.kept is not None]
    kept = sum(kept * metres for kept, metres in measured) / sum(metres for _, metres in measured) if measured else None
    return replace(
        first, piece=joined_pieces([first.piece, second.piece]), kept=kept, width_m=max(first.width_m, second.width_m),
        numbers=first.numbers + second.numbers,
    )
