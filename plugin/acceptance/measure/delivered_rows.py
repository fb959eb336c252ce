"""Rows of seams, as a scan makes them -> the pieces of a delivery; layers of QGIS are read in ``seam_layers``."""
from __future__ import annotations

import math
import warnings
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from osgeo import ogr
from scipy.spatial import cKDTree

from ...imagery.errors import Message, SeamInspectorWarning, SettingsError
from ...imagery.gdal_calls import gdal_silenced
from ...imagery.lines import points_at, vertex_stations
from ...imagery.reference_systems import is_geographic, metres_per_unit, transform_points, utm_wkt
from . import messages
from .delivery import DeliveredPiece, Delivery, in_order
from .failure_networks import TOUCHING
from .measured_pieces import NO_VERDICT

MOST_KEPT = 3.0  # a seam that was sharpened keeps more than 1; shares of three times that are none
_OTHER_LENGTH = 1.1  # times the line's: feet, kilometres, or the length of something else


SeamRow = Mapping[str, object]
_NUMBERS, _SIDES = ("kept_low", "kept_high", "band_width"), ("left_source", "right_source", "left_date", "right_date")


@dataclass
class LayerDoubts:
    """Of one layer, piece by piece."""

    sheet: str
    rows: int = 0
    """That were looked at."""
    without_line: int = 0
    kept: list[float] = field(default_factory=list)
    claimed: list[float] = field(default_factory=list)
    """Of pieces with a verdict: where the scan has none, its interval is too wide, any number may stand."""
    words: list[str] = field(default_factory=list)
    """That stand where numbers should."""
    lengths: list[tuple[float, float]] = field(default_factory=list)
    """In the field and along the line, metres, where they differ."""

    def see_kept(self, written: str, kept: float | None, verdict: str = "") -> float | None:
        """What counts of a piece's ``kept_1``, as it is ``written`` and as a number: nothing below 0."""
        if kept is None:
            if written and written.lower() not in ("nan", "inf", "-inf"):
                self.words.append(written)
            return None
        self.kept.append(kept)
        if verdict != NO_VERDICT:
            self.claimed.append(kept)
        return kept if kept >= 0 else None

    def see_length(self, length: float, line: float) -> None:
        """A length from the field, beside that of the line."""
        if line > 0 and not 1 / _OTHER_LENGTH <= length / line <= _OTHER_LENGTH:
            self.lengths.append((length, line))

    def piece(self, sheet: str, row: SeamRow, line: np.ndarray, drawn_m: float) -> DeliveredPiece | None:
        """A row's piece; None where it has no line or no length. ``line``: its (n, 2) vertices, ``drawn_m`` long."""
        self.rows += 1
        length = _number(row.get("length"))
        if length is None or length <= 0:
            length = drawn_m
        else:
            self.see_length(length, drawn_m)
        if not (len(line) > 1 and np.isfinite(line).all() and math.isfinite(length) and length > 0):
            self.without_line += 1
            return None
        verdict = _text(row.get("verdict"))
        kept = self.see_kept(_text(row.get("kept_1")), _number(row.get("kept_1")), verdict)
        station, low, high, width = (_number(row.get(name)) for name in ("station", *_NUMBERS))
        left, right, left_date, right_date = (_text(row.get(name)) for name in _SIDES)
        return DeliveredPiece(
            0, sheet, _text(row.get("seam_id")), station, length, kept, low, high, width, verdict,
            _text(row.get("reason")), line, left, right, left_date, right_date,
        )  # fmt: skip

    def told(self) -> Iterator[Message]:
        """Raises SettingsError where the layer's ``kept_1`` are no shares."""
        if self.kept and (middle := float(np.median(self.kept))) > MOST_KEPT:
            raise SettingsError(messages.KEPT_NO_SHARES(name=self.sheet, value=middle))
        if self.words:
            yield messages.KEPT_NO_NUMBERS(count=len(self.words), name=self.sheet, value=self.words[0])
        if negative := sum(kept < 0 for kept in self.kept):
            yield messages.KEPT_NEGATIVE(count=negative, name=self.sheet)
        if large := sum(kept > MOST_KEPT for kept in self.claimed):
            yield messages.KEPT_LARGE(count=large, name=self.sheet, value=max(self.claimed))
        if self.lengths:
            length, line = max(self.lengths, key=lambda pair: abs(np.log(pair[0] / pair[1])))
            yield messages.LENGTHS_DIFFER(count=len(self.lengths), name=self.sheet, length=length, line=line)
        if self.without_line:
            yield messages.PIECES_WITHOUT_LENGTH(name=self.sheet, count=self.without_line)
        if not self.rows:
            yield messages.LAYER_EMPTY(name=self.sheet)


_DIGITS = 3  # of coordinates, to which lines are the same
_PLACES = (0.1, 0.3, 0.5, 0.7, 0.9)  # of a piece: away from its ends, where others begin
_NEAR = 1.2  # steps: two lines that lie a step apart, with points at every step
_NEIGHBOURS = 12
_MOST_POINTS = 2000  # of one piece


def without_copies(pieces: Sequence[DeliveredPiece]) -> tuple[list[DeliveredPiece], int]:
    """Pieces each once, and how many are left out: the same line, drawn either way, that kept the same.

    One that was drawn for a sample stays so.
    """
    kept: dict[object, DeliveredPiece] = {}
    for piece in pieces:
        line = np.round(piece.vertices, _DIGITS) + 0.0
        key = min(line.tobytes(), line[::-1].tobytes()), piece.kept_1
        first = kept.setdefault(key, piece)
        if first.sample_number is None and piece.sample_number is not None:
            kept[key] = replace(first, sample_number=piece.sample_number)
    return list(kept.values()), len(pieces) - len(kept)


def overlap(pieces: Sequence[DeliveredPiece], unit_m: float = 1.0) -> tuple[float, tuple[str, ...]] | None:
    """Metres that pieces which are not the same and yet lie on each other count too much, and the sheets of these.

    None where it is less than a typical piece's half.
    """
    typical = float(np.median([piece.length_m for piece in pieces]))
    step = TOUCHING * typical
    points, owners, asked, askers = [], [], [], []
    for number, piece in enumerate(pieces):
        along = vertex_stations(piece.vertices * unit_m)
        count = int(min(np.ceil(along[-1] / step) + 1, _MOST_POINTS))
        points.append(points_at(piece.vertices * unit_m, along, np.linspace(0, along[-1], count)))
        owners.append(np.full(count, number))
        asked.append(points_at(piece.vertices * unit_m, along, np.array(_PLACES) * along[-1]))
        askers.append(np.full(len(_PLACES), number))
    owner, asker = np.concatenate(owners), np.concatenate(askers)
    _, near = cKDTree(np.concatenate(points)).query(
        np.concatenate(asked), _NEIGHBOURS, distance_upper_bound=_NEAR * step
    )
    near_owner = np.append(owner, -1)[near]
    others = np.array([len({*row} - {-1, own}) for row, own in zip(near_owner.tolist(), asker.tolist())])
    lengths = np.array([piece.length_m for piece in pieces])
    too_many = lengths[asker] / len(_PLACES) * others / (others + 1)
    if too_many.sum() < typical / 2:
        return None
    sheets = dict.fromkeys(pieces[number].sheet for number in asker[others > 0].tolist())
    return float(too_many.sum()), tuple(sheets)


def make_delivery(sheets: Mapping[str, Iterable[SeamRow]], wkt: str) -> Delivery:
    """A delivery of what scans found, to be decided on.

    ``sheets``: by a name each, the rows of ``seam_rows``, or those of a layer SEAMS however they are read: mappings
    with ``kept_1``, ``kept_low``, ``kept_high``, ``length`` (m), ``verdict`` and so on, and ``geometry``, the line as
    WKT. None, NaN and fields that lack mean that nothing is known. ``wkt``: the reference system of all lines; those
    in degrees are moved to their UTM zone.

    What is left out or doubtful is told by a SeamInspectorWarning each. Raises SettingsError where there is no piece, a
    sheet has no ``kept_1``, or values there are no shares.
    """
    given = {sheet: list(rows) for sheet, rows in sheets.items()}
    lines = {sheet: [_vertices(row) for row in rows] for sheet, rows in given.items()}
    first = next((line for of_sheet in lines.values() for line in of_sheet if len(line)), None)
    if first is None:
        raise SettingsError(messages.LAYERS_EMPTY())
    if wkt and is_geographic(wkt):
        target = utm_wkt(*first[0].tolist())
        lines = {sheet: [transform_points(line, wkt, target) for line in of_sheet] for sheet, of_sheet in lines.items()}
        wkt = target
    unit_m = metres_per_unit(wkt, 0.0)[0]
    pieces: list[DeliveredPiece] = []
    told: list[Message] = []
    for sheet, rows in given.items():
        if rows and not any("kept_1" in row for row in rows):
            raise SettingsError(messages.LAYER_WITHOUT_KEPT(name=sheet))
        doubts = LayerDoubts(sheet)
        for row, line in zip(rows, lines[sheet]):
            drawn_m = float(vertex_stations(line)[-1]) * unit_m if len(line) else 0.0
            if (piece := doubts.piece(sheet, row, line, drawn_m)) is not None:
                pieces.append(piece)
        told += doubts.told()
    delivery, doubled = united_delivery(pieces, wkt, unit_m)
    for notice in [*told, *doubled]:
        warnings.warn(str(notice), SeamInspectorWarning, stacklevel=2)
    return delivery


def united_delivery(
    pieces: Sequence[DeliveredPiece], wkt: str, unit_m: float, lot_size: int | None = None
) -> tuple[Delivery, list[Message]]:
    """The pieces of all sheets in order, each once, and what is told of those that lie on each other."""
    once, copies = without_copies(in_order(pieces))
    told = [messages.PIECES_TWICE(count=copies)] if copies else []
    if doubled := overlap(once, unit_m):
        told.append(messages.SEAMS_OVERLAP(metres=doubled[0], sheets=", ".join(doubled[1])))
    return Delivery(in_order(once), wkt, unit_m, lot_size=lot_size), told


def _vertices(row: SeamRow) -> np.ndarray:
    """(n, 2), n >= 2, of a row's line; empty where it has none."""
    with gdal_silenced():
        try:
            line = ogr.CreateGeometryFromWkt(_text(row.get("geometry")))
        except RuntimeError:  # where GDAL's exceptions are on
            line = None
    points = None if line is None else line.GetPoints(2)
    vertices = np.array(points if points else [], float).reshape(-1, 2)
    usable = len(vertices) > 1 and np.isfinite(vertices).all() and np.ptp(vertices, axis=0).any()
    return vertices if usable else np.empty((0, 2))


def _number(value: object) -> float | None:
    """A finite number."""
    try:
        found = float(str(value))
    except ValueError:
        return None
    return found if math.isfinite(found) else None


def _text(value: object) -> str:
    """Empty for what is not known; whole numbers without a point, as tables with gaps make them floats."""
    if value is None or (isinstance(value, float) and math.isnan(value)):
        return ""
    return str(int(value)) if isinstance(value, float) and value.is_integer() else str(value)
