"""The tables of a scan, one entry per column. The field names are contracts; layers and plain rows are made of them."""
from __future__ import annotations

import numpy as np

from ....imagery.records import Column, Row, rows_of
from .gathering import ScanResult
from .judged_pieces import JudgedPiece

GEOMETRY = "geometry"
"""In plain rows, where a layer has lines."""

SEAM_COLUMNS: tuple[Column[JudgedPiece], ...] = (
    Column("seam_id", "integer", lambda one: one.piece.seam_id),
    Column("station", "real", lambda one: one.piece.station_m),
    Column("left_source", "text", lambda one: one.left),
    Column("right_source", "text", lambda one: one.right),
    Column("left_date", "text", lambda one: one.left_date),
    Column("right_date", "text", lambda one: one.right_date),
    Column("length", "real", lambda one: one.piece.length_m),
    Column("kept", "real", lambda one: one.kept, by_level=True),
    Column("kept_low", "real", lambda one: one.low),
    Column("kept_high", "real", lambda one: one.high),
    Column("band_width", "real", lambda one: one.band_width_m),
    Column("feather_width", "real", lambda one: one.feather_width_m),
    Column("visibility", "real", lambda one: one.visibility),
    Column("verdict", "text", lambda one: one.verdict.value),
    Column("reason", "text", lambda one: one.reason),
)
"""SEAMS: one line per piece of seam."""

CELL_COLUMNS: tuple[Column[str], ...] = (Column("source", "text", lambda name: name),)
"""CELLS: one polygon per source."""


def seam_rows(result: ScanResult) -> list[Row]:
    """One row per piece of seam: what it kept with its 95 % interval, widths (m), verdict.

    The fields are those of the layer SEAMS (docs/reference/tables.md), and ``geometry``: the line as WKT in the
    mosaic's reference system.
    """
    levels = max((len(one.kept) for one in result.pieces if one.kept), default=1)
    rows = rows_of(SEAM_COLUMNS, result.pieces, levels)
    return [{**row, GEOMETRY: _line_wkt(one.piece.vertices)} for row, one in zip(rows, result.pieces)]


def _line_wkt(vertices: np.ndarray) -> str:
    return f"LINESTRING ({', '.join(f'{x!r} {y!r}' for x, y in vertices.tolist())})"
