"""``seaminspector:predictloss``: what feathering would cost, before there is a mosaic."""
from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessing,
    QgsProcessingContext,
    QgsProcessingFeatureSource,
    QgsProcessingFeedback,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFeatureSource,
    QgsWkbTypes,
)
from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP

from ...imagery import messages as imagery_messages
from ...imagery.errors import RasterError, SettingsError
from ...toolkit import messages as toolkit_messages
from ...toolkit.algorithms import parameters as common
from ...toolkit.algorithms.base import SeamInspectorAlgorithm
from ...toolkit.algorithms.feedback import TellOnce, tell
from ...toolkit.algorithms.window_features import WindowFeatures
from ...toolkit.resources import style_path
from ...toolkit.translation import tr
from ..measure import messages
from .block_parameters import check_sources, given_sources, indexed_sources

if TYPE_CHECKING:
    from ..measure.loss_forecast import ForecastRequest
    from ..measure.source_images import Source

WINDOWS, OUTPUT, PAIRS = "WINDOWS", "OUTPUT", "PAIRS"
WINDOW_COUNT, NOT_COMPARABLE_COUNT = "WINDOW_COUNT", "NOT_COMPARABLE_COUNT"


class PredictLoss(SeamInspectorAlgorithm):
    """How much detail a 50:50 feather of the sources would leave in each window."""

    ID = "predictloss"
    NAME = QT_TRANSLATE_NOOP("@default", "Predict loss by feathering")
    HELP = QT_TRANSLATE_NOOP(
        "@default",
        "Says before any mosaic is made how much detail feathering would cost in each window. Where two images are "
        "blended half and half, the part of their detail that they do not share cancels: with rho the agreement of "
        "their detail coefficients, (1 + rho) / 2 of its variance is left. Images that lie 1 px apart can lose half "
        "of their finest detail this way. The smallest ratio over the pairs of sources says where feathering will "
        "hurt, so that the seam can go elsewhere, the images be registered better, or the feather made narrower."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        polygon, table = QgsProcessing.SourceType.TypeVectorPolygon, QgsProcessing.SourceType.TypeVector
        self.addDescribed(
            QgsProcessingParameterFeatureSource(WINDOWS, tr("Windows"), [polygon]),
            tr(
                "Rectangles where seams are to run, in any reference system. What is measured is the rectangle around "
                "each, snapped to the pixels of the finest source that covers it."
            ),
        )
        self.addDescribed(*common.sources())
        self.addDescribed(*common.source_index())
        self.addDescribed(*common.wavelet())
        self.addDescribed(*common.levels())
        self.addDescribed(
            QgsProcessingParameterFeatureSink(OUTPUT, tr("Predicted windows"), polygon),
            tr("The rectangles as measured, in the sources' reference system, with the smallest ratio over the pairs."),
        )
        self.addDescribed(
            QgsProcessingParameterFeatureSink(PAIRS, tr("Source pairs"), table, optional=True, createByDefault=True),
            tr("Every two sources of a window: agreement of their detail, ratio to be expected, shift between them."),
        )
        self.addNumbers({WINDOW_COUNT: tr("Windows"), NOT_COMPARABLE_COUNT: tr("Windows that can't be compared")})

    def check(self, parameters: dict[str, Any], context: QgsProcessingContext) -> None:
        from ...imagery.wavelets import check_decomposition

        check_decomposition(*self.decomposition(parameters, context))
        check_sources(parameters, context)

    def prepare(self, parameters: dict[str, Any], context: QgsProcessingContext) -> None:
        self._given = given_sources(self, parameters, context)

    def execute(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        from ...toolkit import layers
        from ...toolkit.executors import open_executor
        from ...toolkit.table_fields import column_feature, column_fields
        from ..measure.loss_forecast import forecast_window, not_foretold
        from ..measure.window_runs import in_order
        from ..tables.result_tables import FORECAST_COLUMNS, FORECAST_PAIR_COLUMNS, forecast_pair_features

        wavelet, levels = self.decomposition(parameters, context)
        self.check(parameters, context)
        windows = self.source(parameters, WINDOWS, context)
        if windows.featureCount() == 0:
            raise SettingsError(toolkit_messages.NO_WINDOWS())
        once = TellOnce(feedback)
        crs, wkt = self._system(windows, parameters, context)
        sources = self._sources(parameters, crs, wkt, context, once)
        drawn = WindowFeatures(windows, crs, context)
        requests = self._requests(drawn, sources, wkt, wavelet, levels)

        count = not_comparable = 0
        with open_executor() as (executor, ahead):
            polygons = column_fields(FORECAST_COLUMNS, levels), QgsWkbTypes.Type.Polygon, crs
            output, output_id = self.sink(parameters, OUTPUT, context, *polygons)
            table = column_fields(FORECAST_PAIR_COLUMNS, levels)
            pairs, pairs_id = self.optional_sink(parameters, PAIRS, context, table)
            for forecast in in_order(requests, forecast_window, not_foretold, executor, ahead, feedback.isCanceled):
                geometry, _observer = drawn.taken(forecast.window_id)
                if forecast.extent is not None:
                    geometry = layers.rectangle(forecast.extent)
                self.write(output, [column_feature(FORECAST_COLUMNS, forecast, levels, geometry)])
                self.write(pairs, forecast_pair_features(forecast))
                once.tell(forecast.notices)
                if forecast.reason is not None:
                    tell(feedback, imagery_messages.ABOUT(what=forecast.window_id, why=forecast.reason))
                count += 1
                not_comparable += forecast.reason is not None
                feedback.setProgress(100 * count / drawn.count)
        if drawn.renumbered:
            tell(feedback, messages.WINDOWS_RENUMBERED(count=drawn.renumbered))
        self.style(output_id, style_path("predicted_windows"), context)
        return {OUTPUT: output_id, PAIRS: pairs_id, WINDOW_COUNT: count, NOT_COMPARABLE_COUNT: not_comparable}

    def _system(
        self, windows: QgsProcessingFeatureSource, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> tuple[QgsCoordinateReferenceSystem, str]:
        """The reference system of the first source that can be read, else the index layer's, else the windows'."""
        from ...imagery.open_raster import describe_placed
        from ...toolkit import layers

        for ref in self._given.refs:
            with suppress(RasterError):  # it is named when the sources are gathered
                raster = describe_placed(ref)
                return layers.mosaic_crs(raster), raster.wkt
        crs = windows.sourceCrs()
        if parameters.get(common.SOURCE_INDEX):
            index = self.source(parameters, common.SOURCE_INDEX, context)
            crs = index.sourceCrs() if index.sourceCrs().isValid() else crs
        return crs, layers.system_wkt(crs)

    def _sources(
        self,
        parameters: dict[str, Any],
        crs: QgsCoordinateReferenceSystem,
        wkt: str,
        context: QgsProcessingContext,
        once: TellOnce,
    ) -> list[Source]:
        from ..measure.source_images import gather_sources

        indexed = indexed_sources(self, parameters, context, self._given, crs)
        once.tell(self._given.left_out)
        sources, notices = gather_sources(self._given.refs, indexed, wkt)
        once.tell(notices)
        return sources

    @staticmethod
    def _requests(
        drawn: WindowFeatures, sources: list[Source], wkt: str, wavelet: str, levels: int
    ) -> Iterator[ForecastRequest]:
        from ..measure.loss_forecast import ForecastRequest, forecast_request

        for window in drawn.windows():
            if window.extent is None:
                yield ForecastRequest(window.window_id, (), None, wkt, wavelet, levels, window.reason)
            else:
                yield forecast_request(sources, window.window_id, window.extent, wkt, wavelet, levels)
