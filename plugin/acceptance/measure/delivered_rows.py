"""Rows of seams, as scans write them -> the pieces of a delivery; layers of QGIS are read in ``delivery_layers``."""
from __future__ import annotations

import math
import warnings
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from osgeo import ogr

from ...imagery import reference_systems, seam_totals
from ...imagery.errors import Message, RasterError, SeamInspectorWarning, SettingsError
from ...imagery.file_identity import states_in, states_text
from ...imagery.gdal_calls import gdal_silenced
from ...imagery.lines import vertex_stations
from . import messages
from .delivery import NUMBERS, TEXTS, DeliveredLayer, DeliveredPiece, Delivery, Seal, extent_of, in_order, unit_metres

_SAME_PLACE = 1e-9  # of coordinates, millimetres: a system that a file holds in other words
_LACKING_M = 0.05  # below it lengths are rounded
_DIGITS = 3  # of coordinates, to which lines are the same

SeamRow = Mapping[str, object]
"""A row's fields by name; None, NaN and fields that lack mean that nothing is known."""


@dataclass(frozen=True)
class ScannedLayer:
    """A layer of seams as a scan left it, or so one hopes."""

    sheet: str  # its name; each layer has one of its own
    rows: Iterable[tuple[SeamRow, np.ndarray]]  # each with the (n, 2) vertices of its line; read once
    wkt: str  # the reference system of the lines
    notes: Mapping[str, str]  # what its scan wrote beside its rows: totals, settings, files and their seal
    is_sealed: bool = True  # whether it has to be as its scan sealed it
    address: str = ""  # what it is read from, in words for people


def read_layers(scanned: Sequence[ScannedLayer]) -> tuple[Delivery, list[Message]]:
    """All pieces in order, in one reference system and each once, and what is to be told.

    Raises SettingsError where there is none, or a layer has no place in the system of the first one.
    """
    pieces: list[Sequence[DeliveredPiece]] = []
    layers: list[DeliveredLayer] = []
    notices: list[Message] = []
    for layer in scanned:
        of_layer, read, doubtful = _read(layer)
        pieces.append(of_layer)
        layers.append(read)
        notices += doubtful
    if not any(pieces):
        raise SettingsError(messages.LAYERS_EMPTY())
    wkt = _common_system(scanned, pieces)
    if reference_systems.is_geographic(scanned[0].wkt) and not reference_systems.is_geographic(wkt):
        notices.append(messages.PLACES_IN(system=reference_systems.system_name(wkt)))
    placed = [piece for layer, of_layer in zip(scanned, pieces) for piece in _placed(of_layer, layer, wkt)]
    unit_m = unit_metres((piece.vertices for piece in placed), wkt)
    measured = (
        piece if piece.length_m else replace(piece, length_m=unit_m * float(vertex_stations(piece.vertices)[-1]))
        for piece in placed
    )
    once = _without_copies(in_order(measured))
    if copies := len(placed) - len(once):
        notices.append(messages.PIECES_TWICE(count=copies))
    lot_size = max(layer.lot_size for layer in layers) if any(piece.sample_number for piece in once) else 0
    return Delivery(in_order(once), wkt, (), lot_size or None, layers=tuple(layers)), notices


def _read(layer: ScannedLayer) -> tuple[Sequence[DeliveredPiece], DeliveredLayer, list[Message]]:
    """A layer's pieces, with lines as it has them, whether it is as its scan left it, and what is doubtful."""
    totals, pieces, notices = seam_totals.RowTotals(), list[DeliveredPiece](), list[Message]()
    count = without_line = lot_size = 0
    for row, line in layer.rows:
        count += 1
        totals.add(row, line)
        lot_size = max(lot_size, int(_number(row.get("lot_size")) or 0))
        if _text(row.get("level")) == seam_totals.STRETCH:
            continue
        if not is_line(line):
            without_line += 1
            continue
        pieces.append(_piece(row, line, layer.sheet))
    total = _number(layer.notes.get(seam_totals.METRES))
    if without_line:
        notices.append(messages.PIECES_WITHOUT_LENGTH(name=layer.sheet, count=without_line))
    if not count and total != 0:
        notices.append(messages.LAYER_EMPTY(name=layer.sheet))
    lacking = 0.0 if total is None else total - sum(piece.length_m for piece in pieces)
    seal = _seal(layer, totals, pieces)
    is_blank = not pieces and (seal not in (Seal.WHOLE, Seal.NOT_ASKED) or total != 0)
    return pieces, DeliveredLayer(
        layer.sheet, seal, lacking if lacking > _LACKING_M else 0.0, layer.notes, totals.digest, lot_size, is_blank
    ), notices


def _seal(layer: ScannedLayer, totals: seam_totals.RowTotals, pieces: Sequence[DeliveredPiece]) -> Seal:
    if not layer.is_sealed:
        return Seal.NOT_ASKED
    if (is_sealed := totals.is_sealed_by(layer.notes)) is None:
        return Seal.MISSING
    system = layer.notes.get(seam_totals.SYSTEM, "")
    is_same = layer.wkt == system
    if layer.wkt and system and pieces:
        extent = extent_of([pieces[0].vertices])
        is_same = reference_systems.same_coordinates(layer.wkt, system, extent, _SAME_PLACE * max(map(abs, extent)))
    return Seal.WHOLE if is_same and is_sealed else Seal.BROKEN


def _piece(row: SeamRow, line: np.ndarray, sheet: str) -> DeliveredPiece:
    """A row's piece, numbered 0; of no length where the row says none."""
    values: dict[str, Any] = {attribute: _number(row.get(name)) for name, attribute in NUMBERS.items()}
    values.update({name: _text(row.get(name)) for name in TEXTS})
    sample = _number(row.get("sample"))
    return DeliveredPiece(**{
        **values, "number": 0, "sheet": _text(row.get("sheet")) or sheet, "seam_id": _text(row.get("seam_id")),
        "length_m": max(values["length_m"] or 0.0, 0.0),
        "band_width_m": max(filter(None, (values["band_width_m"], values["feather_width_m"])), default=None),
        "kept_1": seam_totals.possible(values["kept_1"], seam_totals.MOST_KEPT),
        "vertices": line, "sample_number": None if sample is None else int(sample),
        "profile": seam_totals.profile_of(_text(row.get("profile"))),
        "has_detail": _text(row.get("state")) != seam_totals.PieceState.NO_DETAIL.value,
    })  # fmt: skip


def _common_system(scanned: Sequence[ScannedLayer], pieces: Sequence[Sequence[DeliveredPiece]]) -> str:
    """The first system that is not in degrees; the UTM zone of the first piece where all are."""
    systems = [layer.wkt for layer in scanned]
    flat = next((wkt for wkt in systems if not (wkt and reference_systems.is_geographic(wkt))), None)
    if flat is not None:
        return flat
    number, first = next((number, of_layer[0]) for number, of_layer in enumerate(pieces) if of_layer)
    middle = _placed([first], scanned[number], _DEGREES)[0].middle
    return reference_systems.utm_wkt(*middle)


_DEGREES = "EPSG:4326"


def _placed(pieces: Sequence[DeliveredPiece], layer: ScannedLayer, wkt: str) -> Sequence[DeliveredPiece]:
    """Pieces of a layer in another reference system."""
    if not pieces or reference_systems.same_system(layer.wkt, wkt):
        return pieces
    lines = [piece.vertices for piece in pieces]
    try:
        moved = reference_systems.transform_points(np.concatenate(lines), layer.wkt, wkt)
    except RasterError:
        raise SettingsError(messages.NOT_TRANSFORMED(name=layer.sheet)) from None
    parts = np.split(moved, np.cumsum([len(line) for line in lines[:-1]]))
    return [replace(piece, vertices=part) for piece, part in zip(pieces, parts)]


def is_line(vertices: np.ndarray) -> bool:
    """Whether (n, 2) vertices are those of a line that leads anywhere."""
    return bool(len(vertices) > 1 and np.isfinite(vertices).all() and (vertices != vertices[0]).any())


def _without_copies(pieces: Sequence[DeliveredPiece]) -> list[DeliveredPiece]:
    """Pieces each once: the same line, drawn either way, that kept the same. One that was drawn for a sample stays so.
    """
    kept: dict[object, DeliveredPiece] = {}
    for piece in pieces:
        line = np.round(piece.vertices, _DIGITS) + 0.0
        key = min(line.tobytes(), line[::-1].tobytes()), piece.kept_1
        first = kept.setdefault(key, piece)
        if first.sample_number is None and piece.sample_number is not None:
            kept[key] = replace(first, sample_number=piece.sample_number)
    return list(kept.values())


def make_delivery(
    sheets: Mapping[str, Iterable[SeamRow]], wkt: str, told: Mapping[str, Mapping[str, str]] | None = None,
    sealed: Collection[str] = (),
) -> Delivery:
    """A delivery of what scans found, to be decided on.

    ``sheets``: by a name each, the rows of ``seam_rows``, or those of a layer SEAMS however they are read: mappings
    with ``kept_1``, ``kept_low``, ``kept_high``, ``length`` (m), ``verdict`` and so on, and ``geometry``, the line as
    WKT. ``wkt``: the reference system of all lines; those in degrees are moved to their UTM zone. ``told``: by sheet
    what its scan tells of the ground and of all its metres (``ScanResult.told``); without it nothing is known of seams
    that are in no row. ``sealed``: sheets that have to be as their scans sealed them, by what is ``told``.

    A sheet without rows leaves the decision open, unless its scan tells of 0 metres.

    What is left out or doubtful is told by a SeamInspectorWarning each. Raises SettingsError where there is no piece,
    or a sheet has no ``kept_1``.
    """
    layers = []
    for sheet, given in sheets.items():
        rows = list(given)
        if rows and not any("kept_1" in row for row in rows):
            raise SettingsError(messages.LAYER_WITHOUT_KEPT(name=sheet))
        lines = ((row, _vertices(row)) for row in rows)
        layers.append(ScannedLayer(sheet, lines, wkt, (told or {}).get(sheet, {}), sheet in sealed))
    delivery, notices = read_layers(layers)
    for notice in notices:
        warnings.warn(str(notice), SeamInspectorWarning, stacklevel=3)  # of who decides
    return delivery


_SUMMED = ("unexplained_border", "unseen_metres", "hidden_metres", "unchanged_metres", "mixed_metres")
"""Metres that several scans have together, also where they have the same number of them."""


def united_settings(layers: Sequence[DeliveredLayer]) -> dict[str, str]:
    """What a layer of pieces of several says of how they were measured, and of which files."""
    settings: dict[str, str] = {}
    for name in dict.fromkeys(name for layer in layers for name in layer.settings):
        values = [layer.settings[name] for layer in layers if name in layer.settings]
        if name not in _SUMMED:
            values = list(dict.fromkeys(values))
        settings[name] = ", ".join(values)
        if name in (seam_totals.MOSAIC_FILES, seam_totals.SOURCE_FILES) and len(values) > 1:
            settings[name] = states_text([file for value in values for file in states_in(value)])
    return settings


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
