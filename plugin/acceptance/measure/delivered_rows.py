"""Rows of seams, as a scan makes them -> the pieces of a delivery; layers of QGIS are read in ``seam_layers``."""
from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from osgeo import ogr
from scipy.spatial import cKDTree

from ...imagery.errors import Message, SeamInspectorWarning, SettingsError
from ...imagery.file_identity import states_in, states_text
from ...imagery.gdal_calls import gdal_silenced
from ...imagery.grids import Extent
from ...imagery.lines import points_at, vertex_stations
from ...imagery.reference_systems import is_geographic, same_coordinates, transform_points, utm_wkt
from ...imagery.seam_totals import (
    METRES,
    MOSAIC_FILES,
    MOST_KEPT,
    SOURCE_FILES,
    STANDARD_LEAST_KEPT,
    STRETCH,
    SYSTEM,
    PieceState,
    RowTotals,
    possible_kept,
    profile_of,
    sealed_failed_m,
)
from . import messages
from .delivery import DeliveredLayer, DeliveredPiece, Delivery, Seal, extent_of, in_order, metres_in_unit
from .failure_runs import TOUCHING
from .measured_pieces import NO_VERDICT, state_of

_SAME_PLACE = 1e-9  # of coordinates, millimetres: a system that a file holds in other words
_LACKING_M = 0.05  # below it lengths are rounded
_OTHER_LENGTH = 1.1  # times the line's: feet, kilometres, or the length of something else


SeamRow = Mapping[str, object]
_NUMBERS, _SIDES = ("kept_low", "kept_high", "band_width"), ("left_source", "right_source", "left_date", "right_date")


@dataclass
class LayerDoubts:
    """What is doubtful in one layer, gathered piece by piece."""

    sheet: str
    rows: int = 0  # that were looked at
    pieces: int = 0  # that they made
    metres: float = 0.0  # metres of these pieces
    without_line: int = 0
    without_line_m: float = 0.0  # what the field says of these, metres
    kept: list[float] = field(default_factory=list)
    impossible: list[str] = field(default_factory=list)  # what stands where shares should
    lengths: list[tuple[float, float]] = field(default_factory=list)
    """In the field and along the line, metres, where they differ."""
    along: dict[str, list[tuple[float, float]]] = field(default_factory=dict)  # stations and lengths by seam, metres
    totals: RowTotals = field(default_factory=RowTotals)  # totals of all rows, as their scan counted them
    extent: Extent | None = None  # extent of the first line, as its layer has it
    failed_m: float = 0.0  # metres that fail as the scan fails them, by what the rows say of what is kept

    def see_kept(self, written: str, kept: float | None, verdict: str = "") -> float | None:
        """What counts of a piece's ``kept_1``, as it is ``written`` and as a number: nothing that is no share.

        Where the scan has no verdict its interval is too wide, and any number may stand.
        """
        if kept is None:
            is_share = written.lower() in ("", "nan", "inf", "-inf")
        else:
            self.kept.append(kept)
            is_share = kept >= 0 and (kept <= MOST_KEPT or verdict == NO_VERDICT)
        if not is_share:
            self.impossible.append(written)
        return None if kept is None else possible_kept(kept)

    def see_length(self, length: float, line: float) -> None:
        """A length from the field, beside that of the line."""
        if line > 0 and not 1 / _OTHER_LENGTH <= length / line <= _OTHER_LENGTH:
            self.lengths.append((length, line))

    def piece(
        self, sheet: str, row: SeamRow, line: np.ndarray, drawn_m: float, scanned: np.ndarray | None = None
    ) -> DeliveredPiece | None:
        """A row's piece; None where it has no line or no length, or is a stretch of pieces. ``line``: its (n, 2)
        vertices, ``drawn_m`` long; ``scanned``: those of the line as its layer has it, where that is another."""
        self.rows += 1
        placed = line if scanned is None else scanned
        self.totals.add(row, placed)
        if self.extent is None and is_line(placed):
            self.extent = extent_of([placed])
        if _text(row.get("level")) == STRETCH:
            return None
        length = _number(row.get("length"))
        if length is None or length <= 0:
            length = drawn_m
        else:
            self.see_length(length, drawn_m)
        seam_id, station = _text(row.get("seam_id")), _number(row.get("station"))
        if seam_id and station is not None:
            self.along.setdefault(f"{sheet}\t{seam_id}", []).append((station, length))
        if not (is_line(line) and length > 0):
            self.without_line += 1
            self.without_line_m += length if math.isfinite(length) else 0.0
            return None
        verdict = _text(row.get("verdict"))
        kept = self.see_kept(_text(row.get("kept_1")), _number(row.get("kept_1")), verdict)
        low, high, width = (_number(row.get(name)) for name in _NUMBERS)
        left, right, left_date, right_date = (_text(row.get(name)) for name in _SIDES)
        piece = DeliveredPiece(
            0, sheet, seam_id, station, length, kept, low, high, width, verdict, _text(row.get("reason")), line, left,
            right, left_date, right_date, has_detail=_text(row.get("state")) != PieceState.NO_DETAIL.value,
            visibility=_number(row.get("visibility")), profile=profile_of(_text(row.get("profile"))),
        )  # fmt: skip
        self.pieces += 1
        self.metres += length
        self.failed_m += length * (state_of(piece, STANDARD_LEAST_KEPT) is PieceState.FAILED)
        return piece

    def layer(self, notes: Mapping[str, str], wkt: str = "", is_asked: bool = True) -> DeliveredLayer:
        """What it is, by what stands beside its rows; ``wkt``: its reference system; ``is_asked``: whether it has to be
        sealed."""
        scanned_failed_m = sealed_failed_m(notes)
        settings = {} if scanned_failed_m is None else {**notes}
        total = _number(notes.get(METRES))
        lacking = self.without_line_m + sum(self._gaps()) if total is None else total - self.metres
        lacking = lacking if lacking > _LACKING_M else 0.0
        hidden = 0.0 if scanned_failed_m is None else scanned_failed_m - self.failed_m - lacking
        seal = self._seal(notes, wkt) if settings else Seal.MISSING if is_asked else Seal.NOT_ASKED
        return DeliveredLayer(
            self.sheet, seal, lacking, settings, self.totals.digest, hidden if hidden > _LACKING_M else 0.0,
            not self.pieces and (seal not in (Seal.WHOLE, Seal.NOT_ASKED) or total != 0),
        )  # fmt: skip

    def _seal(self, notes: Mapping[str, str], wkt: str) -> Seal:
        if not self.totals.is_sealed_by(notes):
            return Seal.BROKEN
        system, extent = notes.get(SYSTEM, ""), self.extent
        if wkt and system and extent:
            is_same = same_coordinates(wkt, system, extent, _SAME_PLACE * max(map(abs, extent)))
        else:
            is_same = wkt == system
        return Seal.WHOLE if is_same else Seal.OTHER_SYSTEM

    def _gaps(self) -> Iterator[float]:
        """Between the stations of pieces that should follow each other, metres."""
        for pieces in self.along.values():
            pieces.sort()
            for (station, length), (following, _) in zip(pieces, pieces[1:]):
                if (gap := following - station - length) > length / 2:
                    yield gap

    def told(self, notes: Mapping[str, str]) -> Iterator[Message]:
        """What is doubtful, by what stands beside rows, too. Raises SettingsError where ``kept_1`` are no shares."""
        if self.kept and (middle := float(np.median(self.kept))) > MOST_KEPT:
            raise SettingsError(messages.KEPT_NO_SHARES(name=self.sheet, value=middle))
        if self.impossible:
            yield messages.KEPT_IMPOSSIBLE(count=len(self.impossible), name=self.sheet, value=self.impossible[0])
        if self.lengths:
            length, line = max(self.lengths, key=lambda pair: abs(np.log(pair[0] / pair[1])))
            yield messages.LENGTHS_DIFFER(count=len(self.lengths), name=self.sheet, length=length, line=line)
        if self.without_line:
            yield messages.PIECES_WITHOUT_LENGTH(name=self.sheet, count=self.without_line)
        if not self.rows and _number(notes.get(METRES)) != 0:
            yield messages.LAYER_EMPTY(name=self.sheet)


def is_line(vertices: np.ndarray) -> bool:
    """Whether (n, 2) vertices are those of a line that leads anywhere."""
    return bool(len(vertices) > 1 and np.isfinite(vertices).all() and (vertices != vertices[0]).any())


_DIGITS = 3  # of coordinates, to which lines are the same
_PLACES = (0.1, 0.3, 0.5, 0.7, 0.9)  # of a piece: away from its ends, where others begin
_NEAR = 1.2  # steps: two lines that lie a step apart, with points at every step
_NEIGHBOURS = 12
_MOST_POINTS = 2000  # of one piece
_PIECES_AT_ONCE = 5000  # whose points are held


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
    point_of = _points_of([piece.vertices * unit_m for piece in pieces])
    asker = np.repeat(np.arange(len(pieces)), len(_PLACES))
    asked, drawn_m = point_of(asker, np.tile(_PLACES, len(pieces)))
    counts = np.clip(np.ceil(drawn_m / step) + 1, 2, _MOST_POINTS).astype(int)
    others = np.zeros(len(asked), int)
    for first in range(0, len(pieces), _PIECES_AT_ONCE):
        point_counts = counts[first : first + _PIECES_AT_ONCE]
        number = np.repeat(np.arange(len(point_counts)), point_counts)
        place = np.arange(point_counts.sum()) - np.repeat(np.cumsum(point_counts) - point_counts, point_counts)
        tree = cKDTree(point_of(first + number, place / (point_counts - 1)[number])[0])
        within = ((asked > tree.mins - _NEAR * step) & (asked < tree.maxes + _NEAR * step)).all(axis=1)
        _, near = tree.query(asked[within], _NEIGHBOURS, distance_upper_bound=_NEAR * step)
        owner = np.append(first + number, -1)
        nearest = np.sort(owner[near])
        is_first = np.diff(nearest, prepend=-2) != 0
        others[within] += (is_first & (nearest != -1) & (nearest != asker[within, np.newaxis])).sum(axis=1)
    lengths = np.array([piece.length_m for piece in pieces])
    too_many = lengths[asker] / len(_PLACES) * others / (others + 1)
    if too_many.sum() < typical / 2:
        return None
    sheets = dict.fromkeys(pieces[number].sheet for number in asker[others > 0].tolist())
    return float(too_many.sum()), tuple(sheets)


def _points_of(lines: Sequence[np.ndarray]) -> Callable[[np.ndarray, np.ndarray], tuple[np.ndarray, np.ndarray]]:
    """From numbers of lines, (n, 2) each, and shares of their lengths to the points there; with all lengths."""
    vertices, last = np.concatenate(lines), np.cumsum([len(line) for line in lines]) - 1
    steps = np.hypot(*np.diff(vertices, axis=0).T)
    steps[last[:-1]] = 1.0  # from line to line
    along = np.concatenate([[0.0], np.cumsum(steps)])
    starts = along[np.concatenate([[0], last[:-1] + 1])]
    lengths = along[last] - starts
    return lambda number, share: (points_at(vertices, along, starts[number] + share * lengths[number]), lengths)


def make_delivery(
    sheets: Mapping[str, Iterable[SeamRow]], wkt: str, told: Mapping[str, Mapping[str, str]] | None = None,
    sealed: Collection[str] = (),
) -> Delivery:
    """A delivery of what scans found, to be decided on.

    ``sheets``: by a name each, the rows of ``seam_rows``, or those of a layer SEAMS however they are read: mappings
    with ``kept_1``, ``kept_low``, ``kept_high``, ``length`` (m), ``verdict`` and so on, and ``geometry``, the line as
    WKT. None, NaN and fields that lack mean that nothing is known. ``wkt``: the reference system of all lines; those
    in degrees are moved to their UTM zone. ``told``: by sheet what its scan tells of the ground and of all its metres
    (``ScanResult.told``); without it nothing is known of seams that are in no row, and gaps between pieces of a seam
    count as pieces that lack. ``sealed``: sheets that have to be as their scans sealed them, by what is ``told``.

    A sheet without rows leaves the decision open, unless its scan tells of 0 metres.

    What is left out or doubtful is told by a SeamInspectorWarning each. Raises SettingsError where there is no piece, a
    sheet has no ``kept_1``, or values there are no shares.
    """
    given = {sheet: list(rows) for sheet, rows in sheets.items()}
    lines = {sheet: [_vertices(row) for row in rows] for sheet, rows in given.items()}
    first = next((line for of_sheet in lines.values() for line in of_sheet if len(line)), None)
    if first is None:
        raise SettingsError(messages.LAYERS_EMPTY())
    as_scanned, own_wkt = lines, wkt
    if wkt and is_geographic(wkt):
        target = utm_wkt(*first[0].tolist())
        lines = {sheet: [transform_points(line, wkt, target) for line in of_sheet] for sheet, of_sheet in lines.items()}
        wkt = target
    unit_m = metres_in_unit([line for of_sheet in lines.values() for line in of_sheet if len(line)], wkt)
    pieces: list[DeliveredPiece] = []
    notices: list[Message] = []
    layers: list[DeliveredLayer] = []
    for sheet, rows in given.items():
        if rows and not any("kept_1" in row for row in rows):
            raise SettingsError(messages.LAYER_WITHOUT_KEPT(name=sheet))
        doubts = LayerDoubts(sheet)
        for row, line, scanned in zip(rows, lines[sheet], as_scanned[sheet]):
            drawn_m = float(vertex_stations(line)[-1]) * unit_m if len(line) else 0.0
            if (piece := doubts.piece(sheet, row, line, drawn_m, scanned)) is not None:
                pieces.append(piece)
        said = (told or {}).get(sheet, {})
        notices += doubts.told(said)
        layers.append(replace(doubts.layer(said, own_wkt, sheet in sealed), settings=said))
    delivery, doubled = united_delivery(pieces, wkt, layers=layers)
    for notice in [*notices, *doubled]:
        warnings.warn(str(notice), SeamInspectorWarning, stacklevel=3)  # of who decides
    return delivery


def united_delivery(
    pieces: Sequence[DeliveredPiece], wkt: str, lot_size: int | None = None, layers: Sequence[DeliveredLayer] = ()
) -> tuple[Delivery, list[Message]]:
    """The pieces of all sheets in order, each once, and what is told of those that lie on each other or lack.

    Raises SettingsError where there is none.
    """
    if not pieces:
        raise SettingsError(messages.LAYERS_EMPTY())
    once, copies = without_copies(in_order(pieces))
    notices = [messages.PIECES_TWICE(count=copies)] if copies else []
    if doubled := overlap(once, metres_in_unit((piece.vertices for piece in once), wkt)):
        notices.append(messages.SEAMS_OVERLAP(metres=doubled[0], sheets=", ".join(doubled[1])))
    delivery = Delivery(
        in_order(once) if copies else tuple(once), wkt, lot_size=lot_size, layers=tuple(layers),
        doubled_m=doubled[0] if doubled else 0.0,
    )  # fmt: skip
    if delivery.lacking_m:
        lacking = [layer for layer in layers if layer.lacking_m]
        notices += [messages.LAYER_LACKS_SEAMS(name=layer.name, metres=layer.lacking_m) for layer in lacking]
    return delivery, notices


_SUMMED = ("unexplained_border", "unseen_metres", "hidden_metres", "unchanged_metres")
"""Metres that several scans have together, also where they have the same number of them."""


def united_settings(layers: Sequence[DeliveredLayer]) -> dict[str, str]:
    """What a layer of pieces of several says of how they were measured, and of which files."""
    settings: dict[str, str] = {}
    for name in dict.fromkeys(name for layer in layers for name in layer.settings):
        values = [layer.settings[name] for layer in layers if name in layer.settings]
        if name not in _SUMMED:
            values = list(dict.fromkeys(values))
        settings[name] = ", ".join(values)
        if name in (MOSAIC_FILES, SOURCE_FILES) and len(values) > 1:
            settings[name] = states_text([file for value in values for file in states_in(value)])
    return settings


def with_settings(delivery: Delivery, scans: Sequence[Mapping[str, str]]) -> Delivery:
    """What pictures of losses say of how seams were measured, for the layers that don't say it themselves; one for all
    of these, or one for each layer in their order."""
    if not scans or len(scans) not in (1, len(delivery.layers)):
        return delivery
    every = [*scans] * len(delivery.layers) if len(scans) == 1 else scans
    layers = (replace(layer, settings={**said, **layer.settings}) for layer, said in zip(delivery.layers, every))
    return replace(delivery, layers=tuple(layers))


def _vertices(row: SeamRow) -> np.ndarray:
    """(n, 2), n >= 2, of a row's line; empty where it has none."""
    with gdal_silenced():
        try:
            line = ogr.CreateGeometryFromWkt(_text(row.get("geometry")))
        except RuntimeError:  # where GDAL's exceptions are on
            line = None
    points = None if line is None else line.GetPoints(2)
    vertices = np.array(points if points else [], float).reshape(-1, 2)
    return vertices if is_line(vertices) else np.empty((0, 2))


def _number(value: object) -> float | None:
    try:
        number = float(str(value))
    except ValueError:
        return None
    return number if math.isfinite(number) else None


def _text(value: object) -> str:
    """Empty for what is not known; whole numbers without a point, as tables with gaps make them floats."""
    if value is None or (isinstance(value, float) and math.isnan(value)):
        return ""
    return str(int(value)) if isinstance(value, float) and value.is_integer() else str(value)
