"""``seaminspector:placewindows``: windows along seamlines."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsProcessing,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFeatureSource,
    QgsWkbTypes,
)
from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP

from ...imagery import limits as imagery_limits
from ...toolkit.algorithms import parameters as common
from ...toolkit.algorithms.base import SeamInspectorAlgorithm
from ...toolkit.algorithms.feedback import tell
from ...toolkit.resources import style_path
from ...toolkit.translation import tr
from ..measure import limits

if TYPE_CHECKING:
    from ...imagery.grids import PixelWindow

SEAMLINES, SIDE, SPACING, OUTPUT = "SEAMLINES", "SIDE", "SPACING", "OUTPUT"


class PlaceWindows(SeamInspectorAlgorithm):
    """Standard windows along the seams of a mosaic."""

    ID = "placewindows"
    NAME = QT_TRANSLATE_NOOP("@default", "Place windows along seamlines")
    HELP = QT_TRANSLATE_NOOP(
        "@default",
        "Places square windows of about 100 m along the seamlines of a mosaic, ready to be inspected. A window's "
        "side is the smallest power of two of pixels that spans the length asked for, and its edges are pixel "
        "edges of the mosaic. Windows that would stick out of the mosaic are moved along their seam; the log names "
        "those that had to be dropped."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        line, polygon = QgsProcessing.SourceType.TypeVectorLine, QgsProcessing.SourceType.TypeVectorPolygon
        self.addDescribed(
            QgsProcessingParameterFeatureSource(SEAMLINES, tr("Seamlines"), [line, polygon]),
            tr(
                "Lines, or polygons of which each is filled from one orthoimage: where two touch there is a seam. "
                "Fragments and pixel staircases are joined and straightened first."
            ),
        )
        self.addDescribed(*common.mosaic())
        self.addDescribed(
            common.real(SIDE, tr("Window side (metres)"), imagery_limits.STANDARD_SIDE_M, 0.01),
            tr("What a window spans at least: 100 m at 0.10 m pixels gives 1024 pixels, 102.4 m."),
        )
        self.addDescribed(
            common.real(SPACING, tr("Spacing (metres)"), limits.STANDARD_SPACING_M, 0.01),
            tr("Distance between the centres of neighbouring windows, measured along the seam."),
        )
        self.addDescribed(*common.levels())
        self.addDescribed(
            QgsProcessingParameterFeatureSink(
                OUTPUT, tr("Windows"), QgsProcessing.SourceType.TypeVectorPolygon
            ),
            tr("The windows, with the number of their seam and their station along it in metres."),
        )

    def check(self, parameters: dict[str, Any], context: QgsProcessingContext) -> None:
        from ..measure.window_placing import window_side_px

        window_side_px(self.describe_mosaic(parameters, context).grid, *self._measures(parameters, context))

    def prepare(self, parameters: dict[str, Any], context: QgsProcessingContext) -> None:
        self._mosaic = self.describe_mosaic(parameters, context)

    def execute(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        from ...imagery.lines.seamlines import find_seams
        from ...imagery.open_raster import OpenRaster
        from ...toolkit import layers
        from ...toolkit.table_fields import column_feature, column_fields
        from ..measure.window_placing import place_windows
        from ..tables.result_tables import PLACED_COLUMNS

        seamlines = self.source(parameters, SEAMLINES, context)
        mosaic = self._mosaic
        crs = layers.mosaic_crs(mosaic)
        transform = common.transform(seamlines, crs, context)
        seams = find_seams(
            (layers.line_wkb(feature, transform) for feature in layers.features(seamlines)), mosaic.grid.pixel_width
        )
        source = OpenRaster(mosaic.ref)

        def is_valid(window: PixelWindow) -> bool:
            return not feedback.isCanceled() and source.is_valid(window)

        placement = place_windows(seams, mosaic.grid, *self._measures(parameters, context), is_valid)
        if not feedback.isCanceled():
            tell(feedback, *placement.dropped)
        sink, destination = self.sink(
            parameters, OUTPUT, context, column_fields(PLACED_COLUMNS), QgsWkbTypes.Type.Polygon, crs
        )
        for done, placed in enumerate(placement.windows, 1):
            if feedback.isCanceled():
                break
            geometry = layers.rectangle(mosaic.grid.window_extent(placed.window))
            self.write(sink, [column_feature(PLACED_COLUMNS, placed, geometry=geometry)])
            feedback.setProgress(100 * done / len(placement.windows))
        feedback.pushInfo(
            tr("{windows} windows placed along {seams} seams.").format(
                windows=len(placement.windows), seams=len(seams)
            )
        )
        self.style(destination, style_path("placed_windows"), context)
        return {OUTPUT: destination}

    def _measures(self, parameters: dict[str, Any], context: QgsProcessingContext) -> tuple[float, float, int]:
        """Side and spacing in metres, and the levels."""
        return (
            self.parameterAsDouble(parameters, SIDE, context),
            self.parameterAsDouble(parameters, SPACING, context),
            self.parameterAsInt(parameters, common.LEVELS, context),
        )
