"""Rows of seams, as a scan makes them -> the pieces of a delivery; layers of QGIS are read in ``seam_layers``."""
from __future__ import annotations

import math
import warnings
from collections.abc import Iterable, Mapping, Sequence

import numpy as np
from osgeo import ogr

from ...imagery.errors import Message, SeamInspectorWarning, SettingsError
from ...imagery.gdal_calls import gdal_silenced
from ...imagery.lines import vertex_stations
from ...imagery.reference_systems import is_geographic, metres_per_unit, transform_points, utm_wkt
from . import messages
from .delivery import DeliveredPiece, Delivery, in_order
from .layer_doubts import LayerDoubts
from .overlaps import overlap, without_copies

SeamRow = Mapping[str, object]


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
        found, doubts = _pieces(sheet, rows, lines[sheet], unit_m)
        pieces += found
        told += doubts
    once, copies = without_copies(in_order(pieces))
    if copies:
        told.append(messages.PIECES_TWICE(count=copies))
    if doubled := overlap(once, unit_m):
        told.append(messages.SEAMS_OVERLAP(metres=doubled.metres, sheets=", ".join(doubled.sheets)))
    for notice in told:
        warnings.warn(str(notice), SeamInspectorWarning, stacklevel=2)
    return Delivery(in_order(once), wkt, unit_m)


def _pieces(
    sheet: str, rows: Sequence[SeamRow], lines: Sequence[np.ndarray], unit_m: float
) -> tuple[list[DeliveredPiece], list[Message]]:
    if not rows:
        return [], [messages.LAYER_EMPTY(name=sheet)]
    if not any("kept_1" in row for row in rows):
        raise SettingsError(messages.LAYER_WITHOUT_KEPT(name=sheet))
    doubts = LayerDoubts(sheet)
    found = [_piece(sheet, row, line, unit_m, doubts) for row, line in zip(rows, lines) if len(line)]
    told = list(doubts.told())
    if len(found) < len(rows):
        told.append(messages.PIECES_WITHOUT_LENGTH(name=sheet, count=len(rows) - len(found)))
    return found, told


def _piece(sheet: str, row: SeamRow, line: np.ndarray, unit_m: float, doubts: LayerDoubts) -> DeliveredPiece:
    drawn, length = float(vertex_stations(line)[-1]) * unit_m, _number(row.get("length"))
    if length is None or length <= 0:
        length = drawn
    else:
        doubts.see_length(length, drawn)
    verdict = _text(row.get("verdict"))
    kept = doubts.see_kept(_text(row.get("kept_1")), _number(row.get("kept_1")), verdict)
    low, high, width = (_number(row.get(name)) for name in ("kept_low", "kept_high", "band_width"))
    left, right, *dates = (_text(row.get(name)) for name in ("left_source", "right_source", "left_date", "right_date"))
    return DeliveredPiece(
        0, sheet, _text(row.get("seam_id")), _number(row.get("station")), length, kept, low, high, width,
        verdict, _text(row.get("reason")), line, left, right, dates[0], dates[1],
    )  # fmt: skip


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
