"""Which seams are cut anew: pieces of a scan, those that follow each other as one run."""
from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ....imagery.errors import SettingsError
from ....imagery.grids import Grid, PixelWindow
from ....imagery.lines import as_xy, is_line, line_points, points_at, read_geometry, simple_parts, vertex_stations
from ....imagery.seam_totals import STRETCH, PieceState
from ..limits import ALL, FAILED, REDUCED
from ..scan.lines.seam_features import SeamFeature
from ..scan.lines.seam_pieces import SeamPiece
from ..scan.scan_result import JudgedPiece
from ..verdicts import Verdict
from . import messages

LONGEST_PX = 1024.0
"""Of a run, so that memory does not grow with the seams; a single piece may be longer."""


@dataclass(frozen=True, eq=False)
class ScannedPiece:
    """A piece of seam with what a scan says of it."""

    piece: SeamPiece
    """What lies beside it by the names of the orthoimages."""
    kept: float | None
    """kept_1; None where it was not measured."""
    state: str
    """One of ``PieceState``."""
    verdict: str
    """One of ``Verdict``."""
    width_m: float = 0.0
    """Of its band or feather, whichever is wider, as far as that is known."""

    def is_wanted(self, what: str) -> bool:
        """Whether it is one of ``limits.MENDED_SEAMS``."""
        has_failed = self.state == PieceState.FAILED.value
        has_lost = has_failed or self.verdict in (Verdict.SIGNIFICANT.value, Verdict.REDUCED.value)
        return {FAILED: has_failed, REDUCED: has_lost, ALL: True}[what]


FIELDS = ("seam_id", "station", "left_source", "right_source", "length", "kept_1", "state", "verdict")
"""Of the layer that a scan writes."""


def given_pieces(features: Iterable[SeamFeature], names: Sequence[str]) -> list[ScannedPiece]:
    """The pieces of a scan's layer SEAMS, its outlines in the mosaic's reference system.

    Raises SettingsError for a layer without the fields of a scan, or with none of its pieces.
    """
    missing = [name for name in FIELDS if name not in names]
    if missing:
        raise SettingsError(messages.NOT_OF_A_SCAN(fields=", ".join(missing)))
    found = []
    for number, (row, wkb) in enumerate(features, 1):
        parts = [] if wkb is None else [part for part in simple_parts(read_geometry(wkb, number)) if is_line(part)]
        values = [_number(row[name]) for name in ("seam_id", "station", "length", "kept_1")]
        if row.get("level") == STRETCH or len(parts) != 1 or parts[0].GetPointCount() < 2 or None in values[:3]:
            continue
        points = line_points(parts[0])
        if not np.isfinite(points).all():
            continue
        seam_id, station, length, kept = values
        sides = str(row["left_source"]) or None, str(row["right_source"]) or None
        piece = SeamPiece(int(seam_id or 0), station or 0.0, length or 0.0, as_xy(points), *sides)
        width = max(_number(row.get(name)) or 0.0 for name in ("band_width", "feather_width"))
        found.append(ScannedPiece(piece, kept, str(row["state"]), str(row["verdict"]), width))
    if not found:
        raise SettingsError(messages.NO_PIECES())
    return open_pieces(found)


def scanned_pieces(
    pieces: Iterable[JudgedPiece], is_wanted: Callable[[np.ndarray], bool] = lambda vertices: True
) -> list[ScannedPiece]:
    """Those of a scan itself; those that are not wanted, by their vertices, count as such that passed."""
    found = []
    for one in pieces:
        piece = replace(one.piece, left=one.left, right=one.right)
        verdict, state, kept = one.verdict.value, one.state.value, one.least_kept
        if not is_wanted(piece.vertices):
            verdict, state = Verdict.PRESERVED.value, PieceState.PASSED.value
        width = max(one.band_width_m or 0.0, one.feather_width_m or 0.0)
        found.append(ScannedPiece(piece, kept, state, verdict, width))
    return open_pieces(found)


def _number(value: object) -> float | None:
    try:
        found = float(str(value))
    except ValueError:
        return None
    return found if math.isfinite(found) else None


@dataclass(frozen=True, eq=False)
class SeamRun:
    """Pieces of one seam that follow each other, to be cut anew as one."""

    numbers: tuple[int, ...]
    """Of its pieces, among all."""
    piece: SeamPiece
    """All of it."""
    sides: tuple[int, int]
    """Numbers of the sources on the left and on the right hand."""
    kept: float | None
    """What its pieces kept, the mean by their length; None where none was measured."""
    width_m: float = 0.0
    """Of the widest of their bands and feathers."""

    def window(self, grid: Grid) -> PixelWindow:
        """The pixels around it."""
        places = grid.to_pixels(self.piece.vertices)
        first, last = np.floor(places.min(axis=0)).astype(int), np.ceil(places.max(axis=0)).astype(int)
        return PixelWindow(*first.tolist(), *(last - first).tolist())


def open_pieces(pieces: Sequence[ScannedPiece]) -> list[ScannedPiece]:
    """The same with rings, which begin where they end, in two halves."""
    found = []
    for one in pieces:
        piece = one.piece
        along = vertex_stations(piece.vertices)
        if (piece.vertices[0] != piece.vertices[-1]).any() or len(along) < 4:
            found.append(one)
            continue
        middle = points_at(piece.vertices, along, along[-1:] / 2)
        place = int(np.searchsorted(along, along[-1] / 2))
        halves = np.concatenate([piece.vertices[:place], middle]), np.concatenate([middle, piece.vertices[place:]])
        half = piece.length_m / 2
        for vertices, station in zip(halves, (piece.station_m, piece.station_m + half)):
            found.append(replace(one, piece=replace(piece, vertices=vertices, length_m=half, station_m=station)))
    return found


def seam_runs(
    pieces: Sequence[ScannedPiece], what: str, numbers: Mapping[str, int], ground_sample_distance: float
) -> tuple[list[SeamRun], float]:
    """The runs of one of ``limits.MENDED_SEAMS``, and the metres of such pieces whose orthoimages are not known.

    ``numbers``: of the sources, by what the pieces call them.
    """
    runs: list[SeamRun] = []
    unnamed = 0.0
    wanted = [number for number, one in enumerate(pieces) if one.is_wanted(what)]
    wanted.sort(key=lambda number: (pieces[number].piece.seam_id, pieces[number].piece.station_m))
    for number in wanted:
        one = pieces[number]
        left, right = (numbers.get(str(side)) for side in (one.piece.left, one.piece.right))
        if left is None or right is None or left == right:
            unnamed += one.piece.length_m
            continue
        alone = SeamRun((number,), one.piece, (left, right), one.kept, one.width_m)
        joined = _joined(runs[-1], alone, LONGEST_PX * ground_sample_distance) if runs else None
        if joined is None:
            runs.append(alone)
        else:
            runs[-1] = joined
    return runs, unnamed


def _joined(first: SeamRun, second: SeamRun, longest_m: float) -> SeamRun | None:
    """Two as one, where the second one goes on where the first ends; None where it doesn't, or both are too long."""
    one, other = first.piece, second.piece
    length = one.length_m + other.length_m
    goes_on = first.sides == second.sides and np.allclose(one.vertices[-1], other.vertices[0], rtol=0, atol=1e-6)
    is_ring = np.allclose(one.vertices[0], other.vertices[-1], rtol=0, atol=1e-6)
    if not goes_on or is_ring or one.seam_id != other.seam_id or length > longest_m:
        return None
    measured = [(run.kept, run.piece.length_m) for run in (first, second) if run.kept is not None]
    kept = sum(kept * metres for kept, metres in measured) / sum(metres for _, metres in measured) if measured else None
    whole = replace(one, vertices=np.concatenate([one.vertices, other.vertices[1:]]), length_m=length)
    width = max(first.width_m, second.width_m)
    return SeamRun(first.numbers + second.numbers, whole, first.sides, kept, width)
