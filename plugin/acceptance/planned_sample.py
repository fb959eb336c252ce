"""A sample of the pieces of seam -> its table and windows."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import starmap

import numpy as np
from qgis.core import QgsGeometry, QgsLineString, QgsWkbTypes

from ..imagery import limits
from ..imagery.errors import SettingsError
from ..imagery.grids import PixelWindow, standard_side_px, standard_window
from ..imagery.rasters import Raster
from ..imagery.records import Column
from ..imagery.reference_systems import transform_points
from ..imagery.seam_totals import SYSTEM, TOTALS_DOMAIN, PieceState, RowTotals, profile_text
from ..toolkit import layers
from ..toolkit.algorithms.run import Run
from ..toolkit.reference_systems import reference_system
from ..toolkit.table_fields import LARGEST_WHOLE, column_fields, column_values, feature, whole_number
from ..toolkit.translation import tr
from .measure import messages
from .measure.delivered_rows import united_settings
from .measure.delivery import NUMBERS, TEXTS, DeliveredPiece, Delivery, Seal


def sampled_window(mosaic: Raster, piece: DeliveredPiece, wkt: str, side_m: float) -> PixelWindow:
    """A standard window around the middle of a piece, moved inside the mosaic.

    Raises SettingsError for a side that can't be, or is longer than the mosaic, and where that does not show the piece;
    RasterError where this has no place in its system.
    """
    grid = mosaic.grid
    side = standard_side_px(grid, side_m)
    if side > min(grid.columns, grid.rows):
        raise SettingsError(messages.MOSAIC_SMALLER_THAN_WINDOW(pixels=side, side=side_m))
    if side < limits.MIN_SIDE_PX:
        raise SettingsError(messages.WINDOW_SIDE_TOO_SHORT(side=side_m, pixels=side, least=limits.MIN_SIDE_PX))
    x, y = piece.middle
    if wkt:
        x, y = transform_points(np.array([piece.middle]), wkt, mosaic.wkt)[0].tolist()
    xmin, ymin, xmax, ymax = grid.extent
    if not (xmin <= x <= xmax and ymin <= y <= ymax):
        raise SettingsError(messages.SEAM_OFF_MOSAIC())
    return standard_window(grid, x, y, side).moved_into(grid.columns, grid.rows)


@dataclass(frozen=True, eq=False)
class SampledItem:
    order: int  # place in the order of drawing, from 1
    piece: DeliveredPiece
    lot_size: int


_DRAWN: tuple[Column[SampledItem], ...] = (
    Column("sample", "integer", lambda item: item.order),
    Column("lot_size", "integer", lambda item: item.lot_size),
)
_SEAM: Column[SampledItem] = Column("seam_id", "integer", lambda item: whole_number(item.piece.seam_id, LARGEST_WHOLE))


def _number(name: str, attribute: str) -> Column[SampledItem]:
    return Column(name, "real", lambda item: getattr(item.piece, attribute))


def _text(name: str) -> Column[SampledItem]:
    return Column(name, "text", lambda item: getattr(item.piece, name) or None)


PIECE_COLUMNS: tuple[Column[SampledItem], ...] = (
    Column("sheet", "text", lambda item: item.piece.sheet),
    Column("seam_id", "text", lambda item: item.piece.seam_id),
    *_DRAWN, *starmap(_number, NUMBERS.items()), *map(_text, TEXTS),
    Column("profile", "text", lambda item: profile_text(item.piece.profile) or None),
    Column("state", "text", lambda item: None if item.piece.has_detail else PieceState.NO_DETAIL.value),
)
"""Columns of a sample, like those of the scan's SEAMS, so that acceptmosaic takes it."""

WINDOW_COLUMNS: tuple[Column[SampledItem], ...] = (
    Column("window_id", "integer", lambda item: item.order),
    _SEAM,
    Column("station", "real", lambda item: None if item.piece.station_m is None else (
        item.piece.station_m + item.piece.length_m / 2
    )),
    Column("sheet", "text", lambda item: item.piece.sheet),
    *_DRAWN,
)
"""Columns of a sample's windows, as ``placewindows`` writes them, with the sheet."""


def write_sample(
    run: Run, output: str, sample: Sequence[DeliveredPiece], delivery: Delivery, on: tuple[Raster, float] | None
) -> str | None:
    """The layer, as pieces, or as windows ``on`` a mosaic, of a side in metres; ``output``: the parameter's name.

    ``delivery``: what the sample was drawn of, with the size of the lot. Pieces are sealed where all that they were
    drawn of is.
    """
    wkt, lot_size = delivery.wkt, delivery.lot_size or 0
    items = [SampledItem(order, piece, lot_size) for order, piece in enumerate(sample, 1)]
    if on is not None:
        mosaic, side_m = on
        crs, columns, kind = layers.mosaic_crs(mosaic), WINDOW_COLUMNS, QgsWkbTypes.Type.Polygon
        windows = [sampled_window(mosaic, piece, wkt, side_m) for piece in sample]
        outlines = [layers.rectangle(mosaic.grid.window_extent(window)) for window in windows]
    else:
        crs, columns = reference_system(wkt), PIECE_COLUMNS
        kind = QgsWkbTypes.Type.LineString
        outlines = [QgsGeometry(QgsLineString(*piece.vertices.T.tolist())) for piece in sample]
    fields = column_fields(columns)
    sink, destination = run.sink(output, fields, kind, crs)
    run.write(sink, (
        feature(fields, column_values(columns, item), outline) for item, outline in zip(items, outlines)
    ))  # fmt: skip
    run.title(destination, tr("Sample (pieces)") if on is None else tr("Sample (windows)"))
    run.style(destination, "" if on is None else "placed_windows")
    if on is None and all(layer.seal is Seal.WHOLE for layer in delivery.layers):
        names = [column.name for column in columns]
        rows = [dict(zip(names, column_values(columns, item))) for item in items]
        run.close()
        totals = RowTotals(zip(rows, (piece.vertices for piece in sample)))
        run.note(destination, TOTALS_DOMAIN, totals.sealed({**united_settings(delivery.layers), SYSTEM: wkt}))
    return destination
