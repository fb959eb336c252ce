"""The map of a report's windows, drawn by QGIS in the style that they have in the desk, over their mosaic."""
from __future__ import annotations

import math
from collections.abc import Sequence
from contextlib import suppress

from qgis.core import (
    QgsExpressionContext,
    QgsExpressionContextUtils,
    QgsMapRendererCustomPainterJob,
    QgsMapSettings,
    QgsMemoryProviderUtils,
    QgsPointXY,
    QgsVectorLayer,
    QgsWkbTypes,
)
from qgis.PyQt.QtCore import QBuffer, QIODevice, QRectF, QSize, Qt
from qgis.PyQt.QtGui import QColor, QImage, QPainter

from ...imagery.clips import read_overview
from ...imagery.errors import RasterError
from ...imagery.grids import middle_of
from ...imagery.rasters import Raster
from ...imagery.reference_systems import metres_per_unit
from ...toolkit.charts.chart_style import round_below
from ...toolkit.layer_styles import load_style
from ...toolkit.layers import box_extent, rectangle
from ...toolkit.painting import painting
from ...toolkit.reference_systems import reference_system
from ...toolkit.table_fields import feature, table_fields
from ...toolkit.translation import formatted
from ..clip_pictures import bytes_picture
from ..measure.window_records import WindowRecord

MAP_PX = 1300
"""Columns of the picture, which is 170 mm wide."""
_LEAST_ROWS, _MOST_ROWS, _DPI = 200, 1000, 190
_STRIP_PX, _INSET_PX = 54, 8  # below the map, for its scale bar, and around that
_MARGIN = 0.06  # of the longer side, around all windows


def window_map(records: Sequence[WindowRecord], wkt: str, mosaic: Raster | None) -> bytes | None:
    """A JPEG, ``MAP_PX`` wide; None where no window has a place."""
    layer = _layer([record for record in records if record.extent is not None], wkt)
    box = layer.extent()
    if box.isEmpty():
        return None
    box.grow(_MARGIN * max(box.width(), box.height()))
    rows = round(min(max(MAP_PX * box.height() / box.width(), _LEAST_ROWS), _MOST_ROWS))
    settings = QgsMapSettings()
    settings.setLayers([layer])
    settings.setDestinationCrs(layer.crs())
    settings.setExtent(box)
    settings.setOutputSize(QSize(MAP_PX, rows))
    settings.setOutputDpi(_DPI)
    settings.setBackgroundColor(QColor(0, 0, 0, 0))
    context = QgsExpressionContext()
    context.appendScope(QgsExpressionContextUtils.mapSettingsScope(settings))
    settings.setExpressionContext(context)
    image = QImage(MAP_PX, rows + _STRIP_PX, QImage.Format.Format_RGB32)
    image.fill(Qt.GlobalColor.white)
    with painting(image) as painter:
        if mosaic is not None:
            _draw_mosaic(painter, settings, mosaic)
        QgsMapRendererCustomPainterJob(settings, painter).renderSynchronously()
        _draw_scale_bar(painter, settings, wkt)
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    image.save(buffer, "JPG", 85)
    return bytes(buffer.data())


def _layer(records: Sequence[WindowRecord], wkt: str) -> QgsVectorLayer:
    fields = table_fields(("window_id", "integer"), ("verdict", "text"), ("observer", "text"), ("loss", "real"))
    crs = reference_system(wkt)
    layer = QgsMemoryProviderUtils.createMemoryLayer("", fields, QgsWkbTypes.Type.Polygon, crs)
    layer.dataProvider().addFeatures([
        feature(fields, [row.window_id, row.verdict or None, row.observer, row.loss], rectangle(row.extent))
        for row in records if row.extent is not None
    ])  # fmt: skip
    layer.updateExtents()
    load_style(layer, "windows")
    return layer


def _draw_mosaic(painter: QPainter, settings: QgsMapSettings, mosaic: Raster) -> None:
    """Draw what can be read of it soon; without it the windows stand on plain paper."""
    with suppress(RasterError):
        overview = read_overview(mosaic, box_extent(settings.visibleExtent()), MAP_PX)
        if overview is not None:
            block, (left, bottom, right, top) = overview
            pixels = bytes_picture(block.bands, mosaic.has_luminance, block.valid)
            rows, columns = pixels.shape[:2]
            picture = QImage(pixels.tobytes(), columns, rows, 3 * columns, QImage.Format.Format_RGB888).copy()
            corners = (settings.mapToPixel().transform(QgsPointXY(*place)) for place in ((left, top), (right, bottom)))
            painter.drawImage(QRectF(*(corner.toQPointF() for corner in corners)), picture)


def _draw_scale_bar(painter: QPainter, settings: QgsMapSettings, wkt: str) -> None:
    """Draw a round length below the map; none in a system whose units have no length."""
    per_unit = metres_per_unit(wkt, middle_of(box_extent(settings.visibleExtent())))[0]
    if not 0 < per_unit < math.inf:
        return
    metres, top = settings.mapUnitsPerPixel() * per_unit, settings.outputSize().height() + _INSET_PX
    length = round_below(0.25 * MAP_PX * metres)
    words = formatted(length / 1000, "g") + " km" if length >= 1000 else formatted(length, "g") + " m"
    painter.fillRect(QRectF(_INSET_PX, top, length / metres, _INSET_PX / 2), Qt.GlobalColor.black)
    font = painter.font()
    font.setPixelSize(_STRIP_PX // 2)
    painter.setFont(font)
    painter.drawText(_INSET_PX, top + _STRIP_PX - 2 * _INSET_PX, words)
