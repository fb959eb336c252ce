"""OUTPUT of planinspection: a sample as pieces of seam, or as windows. The field names are contracts."""
from __future__ import annotations

from dataclasses import dataclass

from ..imagery.grids import PixelWindow
from ..toolkit.attribute_values import whole_number
from ..toolkit.table_fields import Column
from .measure.delivery import DeliveredPiece


@dataclass(frozen=True, eq=False)
class SampledItem:
    """A piece that was drawn."""

    order: int
    """As the how-manieth, from 1."""
    piece: DeliveredPiece
    lot_size: int
    window: PixelWindow | None = None
    """Around its middle, on the mosaic's grid."""


_DRAWN: tuple[Column[SampledItem], ...] = (
    Column("sample", "integer", lambda one: one.order),
    Column("lot_size", "integer", lambda one: one.lot_size),
)
_SEAM: Column[SampledItem] = Column("seam_id", "integer", lambda one: whole_number(one.piece.seam_id))

PIECE_COLUMNS: tuple[Column[SampledItem], ...] = (
    Column("sheet", "text", lambda one: one.piece.sheet),
    Column("seam_id", "text", lambda one: one.piece.seam_id),
    Column("station", "real", lambda one: one.piece.station_m),
    *_DRAWN,
    Column("left_source", "text", lambda one: one.piece.left_source or None),
    Column("right_source", "text", lambda one: one.piece.right_source or None),
    Column("left_date", "text", lambda one: one.piece.left_date or None),
    Column("right_date", "text", lambda one: one.piece.right_date or None),
    Column("length", "real", lambda one: one.piece.length_m),
    Column("kept_1", "real", lambda one: one.piece.kept_1),
    Column("kept_low", "real", lambda one: one.piece.kept_low),
    Column("kept_high", "real", lambda one: one.piece.kept_high),
    Column("band_width", "real", lambda one: one.piece.band_width_m),
    Column("verdict", "text", lambda one: one.piece.verdict or None),
    Column("reason", "text", lambda one: one.piece.reason or None),
)
"""As the scan's SEAMS, so that acceptmosaic takes it."""

WINDOW_COLUMNS: tuple[Column[SampledItem], ...] = (
    Column("window_id", "integer", lambda one: one.order),
    _SEAM,
    Column("station", "real", lambda one: None if one.piece.station_m is None else (
        one.piece.station_m + one.piece.length_m / 2
    )),
    Column("sheet", "text", lambda one: one.piece.sheet),
    *_DRAWN,
)
"""As ``placewindows`` writes them, with the sheet."""
