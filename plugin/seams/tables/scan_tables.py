"""The layers of a scan, one entry per column. The field names are contracts."""
from __future__ import annotations

from ...toolkit.table_fields import Column
from ..measure.scan.results.judged_pieces import JudgedPiece
from .window_fields import reason_words

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
    Column("reason", "text", lambda one: reason_words(one.reason)),
)
"""SEAMS: one line per piece of seam."""

CELL_COLUMNS: tuple[Column[str], ...] = (Column("source", "text", lambda name: name),)
"""CELLS: one polygon per source."""
