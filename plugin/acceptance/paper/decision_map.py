"""The map of a decision, drawn by QGIS in the styles of its layers: sheets by their verdicts, seams by what became of
them, failures by their numbers, with coordinates, a scale bar and north."""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

import numpy as np
from qgis.core import (
    QgsCategorizedSymbolRenderer,
    QgsCoordinateReferenceSystem,
    QgsFeature,
    QgsFields,
    QgsGeometry,
    QgsLineString,
    QgsLineSymbol,
    QgsMapRendererCustomPainterJob,
    QgsMapSettings,
    QgsMemoryProviderUtils,
    QgsRendererCategory,
    QgsVectorLayer,
    QgsWkbTypes,
)
from qgis.PyQt.QtCore import QBuffer, QIODevice, QPointF, QRectF, QSize, Qt
from qgis.PyQt.QtGui import QColor, QFont, QImage, QPainter, QPen

from ...imagery.grids import middle_of
from ...imagery.records import Column
from ...imagery.reference_systems import metres_per_unit
from ...imagery.seam_totals import PieceState
from ...toolkit.charts.chart_style import round_below
from ...toolkit.layer_styles import load_style
from ...toolkit.layers import box_extent
from ...toolkit.painting import painting
from ...toolkit.reference_systems import reference_system
from ...toolkit.table_fields import column_features, column_fields
from ...toolkit.translation import formatted, tr
from ..measure.decision import DecidedPiece, Decision, Defect
from .defect_files import DEFECT_COLUMNS, defect_features
from .sheet_layer import SHEET_COLUMNS, extent_of_all, sheet_features

STATE_COLOURS = {
    PieceState.NO_DETAIL: "#b9bec4", PieceState.PASSED: "#57606a", PieceState.NOT_MEASURED: "#56b4e9",
    PieceState.FAILED: "#8e0152",
}  # fmt: skip
MAP_PX, _MOST_ROWS, _LEAST_ROWS, _DPI = 1400, 1300, 330, 210
"""Columns, most and least rows of the picture, which is 170 mm wide on paper."""
_STRIP_PX, _INSET_PX = 64, 10  # below the map, for scale bar and north; of letters and marks from its edge
_MARGIN = 0.04  # of the longer side
_TICKS, _LETTERS_PT = 4, 6.0  # coordinates along the longer side
_STATE: tuple[Column[DecidedPiece], ...] = (Column("state", "text", lambda decided: decided.state.value),)


def decision_map(decision: Decision, defects: Sequence[Defect]) -> bytes | None:
    """A JPEG, ``MAP_PX`` wide; None without seams."""
    if not decision.pieces:
        return None
    box = extent_of_all(decision.delivery)
    box.grow(max(box.width(), box.height()) * _MARGIN)
    rows = int(np.clip(MAP_PX * box.height() / box.width(), _LEAST_ROWS, _MOST_ROWS))
    image = QImage(MAP_PX, rows + _STRIP_PX, QImage.Format.Format_RGB32)
    image.fill(Qt.GlobalColor.white)
    for set_dots in (image.setDotsPerMeterX, image.setDotsPerMeterY):
        set_dots(round(_DPI / 0.0254))
    settings, layers = QgsMapSettings(), [*_layers(decision, defects)]
    settings.setLayers(layers)  # all of one system, so that the map needs none
    settings.setExtent(box)
    settings.setOutputSize(QSize(MAP_PX, rows))
    settings.setOutputDpi(_DPI)
    bounds = box_extent(settings.visibleExtent())
    with painting(image) as painter:
        QgsMapRendererCustomPainterJob(settings, painter).renderSynchronously()
        font = QFont(painter.font())
        font.setPointSizeF(_LETTERS_PT)
        painter.setFont(font)
        _draw_coordinates(painter, settings)
        metres = settings.mapUnitsPerPixel() * metres_per_unit(decision.delivery.wkt, middle_of(bounds))[0]
        _draw_scale_bar(painter, rows, metres)
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    image.save(buffer, "JPG", 88)
    return bytes(buffer.data())


def _layers(decision: Decision, defects: Sequence[Defect]) -> Iterator[QgsVectorLayer]:
    """The topmost first."""
    crs, lines = reference_system(decision.delivery.wkt), QgsWkbTypes.Type.MultiLineString
    failures = _layer(column_fields(DEFECT_COLUMNS), lines, crs, defect_features(defects, {}))
    load_style(failures, "defects")
    yield failures
    features = [*column_features(_STATE, decision.pieces)]
    for feature, decided in zip(features, decision.pieces):
        feature.setGeometry(QgsGeometry(QgsLineString(*decided.piece.vertices.T.tolist())))
    seams = _layer(column_fields(_STATE), QgsWkbTypes.Type.LineString, crs, features)
    seams.setRenderer(QgsCategorizedSymbolRenderer("state", [
        QgsRendererCategory(state.value, QgsLineSymbol.createSimple({"line_color": colour, "line_width": "0.4"}), "")
        for state, colour in STATE_COLOURS.items()
    ]))  # fmt: skip
    yield seams
    sheets = _layer(column_fields(SHEET_COLUMNS), QgsWkbTypes.Type.MultiPolygon, crs, sheet_features(decision))
    load_style(sheets, "decided_sheets")
    if len(decision.sheets) > 1:
        yield sheets


def _layer(
    fields: QgsFields, kind: QgsWkbTypes.Type, crs: QgsCoordinateReferenceSystem, features: Iterable[QgsFeature]
) -> QgsVectorLayer:
    layer = QgsMemoryProviderUtils.createMemoryLayer("", fields, kind, crs)
    layer.dataProvider().addFeatures(list(features))
    return layer


def _draw_coordinates(painter: QPainter, settings: QgsMapSettings) -> None:
    """Draw a frame, and round coordinates within its lower and left edges."""
    size, (left, bottom, right, top) = settings.outputSize(), box_extent(settings.visibleExtent())
    pixels = settings.mapToPixel()
    painter.setPen(QPen(QColor(STATE_COLOURS[PieceState.PASSED]), 2))
    painter.drawRect(1, 1, size.width() - 2, size.height() - 2)
    painter.setBackgroundMode(Qt.BGMode.OpaqueMode)
    painter.setBackground(QColor(255, 255, 255, 190))
    step = round_below(max(right - left, top - bottom) / _TICKS)
    for low, high, place, inwards in (
        (left, right, lambda x: pixels.transform(x, bottom).toQPointF(), QPointF(0, -_INSET_PX)),
        (bottom, top, lambda y: pixels.transform(left, y).toQPointF(), QPointF(_INSET_PX, 0)),
    ):  # fmt: skip
        for value in np.arange(np.ceil(low / step) + 1, np.floor(high / step)) * step:
            painter.drawLine(place(value), place(value) + inwards)
            painter.drawText(place(value) + QPointF(_INSET_PX, -_INSET_PX), formatted(value, ".0f"))


def _draw_scale_bar(painter: QPainter, rows: int, metres: float) -> None:
    """Draw a round length below the map on the left, north on the right; ``metres``: of a pixel."""
    length = round_below(0.25 * MAP_PX * metres)
    words = formatted(length / 1000, "g") + " km" if length >= 1000 else formatted(length, "g") + " m"
    painter.fillRect(QRectF(_INSET_PX, rows + _INSET_PX, length / metres, _INSET_PX / 2), Qt.GlobalColor.black)
    painter.setPen(Qt.GlobalColor.black)
    painter.drawText(_INSET_PX, rows + _STRIP_PX - _INSET_PX, words)
    painter.drawText(MAP_PX - 6 * _INSET_PX, rows + _STRIP_PX - 2 * _INSET_PX, "\u2191 " + tr("N"))
