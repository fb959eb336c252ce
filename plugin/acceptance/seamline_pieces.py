"""Layers of seams with and without a scan -> pieces: plain seamlines are cut."""
from __future__ import annotations

from collections.abc import Sequence

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCoordinateTransformContext,
    QgsFeatureRequest,
)

from ..imagery.errors import Message, SeamlineError, SettingsError, WindowError
from ..imagery.lines import find_seams
from ..toolkit import layers
from .measure import messages
from .measure.delivery import DeliveredPiece, Delivery, in_order
from .measure.inspection_plan import cut_pieces
from .seam_layers import SeamLayer, common_system, metres_in_unit, read_delivery

_STEP = 0.01  # of a piece: raster steps up to that are straightened where no mosaic says how large they are
_OF_SCAN = "kept_1"


def with_cut_seamlines(
    seams: Sequence[SeamLayer], transforms: QgsCoordinateTransformContext, sheet_field: str, piece_m: float,
    step_m: float | None,
) -> tuple[Delivery, list[Message]]:
    """All pieces, and what is to be told; ``step_m``: pixel of the mosaic, where it is known.

    Raises SettingsError where there are none.
    """
    crs = common_system(seams, transforms)
    scanned = [layer for layer in seams if _OF_SCAN in layer.fields]
    pieces: list[DeliveredPiece] = []
    told: list[Message] = []
    lot_size = None
    if scanned:
        read, told = read_delivery(scanned, transforms, sheet_field, crs)
        pieces, lot_size = list(read.pieces), read.lot_size
    for layer in seams:
        if layer not in scanned:
            cut = _cut(layer, crs, transforms, piece_m, step_m or _STEP * piece_m)
            if not cut:
                told.append(messages.LAYER_EMPTY(name=layer.sheet))
            pieces += cut
    if not pieces:
        raise SettingsError(messages.LAYERS_EMPTY())
    return Delivery(in_order(pieces), layers.system_wkt(crs), metres_in_unit(crs), lot_size=lot_size), told


def _cut(
    layer: SeamLayer, crs: QgsCoordinateReferenceSystem, transforms: QgsCoordinateTransformContext, piece_m: float,
    step_m: float,
) -> list[DeliveredPiece]:
    transform, unit = QgsCoordinateTransform(layer.crs, crs, transforms), metres_in_unit(crs)
    try:
        lines = [layers.line_wkb(row, transform) for row in layer.source.getFeatures(QgsFeatureRequest())]
    except WindowError:
        raise SettingsError(messages.NOT_TRANSFORMED(name=layer.sheet)) from None
    try:
        return cut_pieces(find_seams(lines, step_m / unit), layer.sheet, piece_m, unit) if any(lines) else []
    except SeamlineError as error:
        raise SettingsError(error.message) from None
