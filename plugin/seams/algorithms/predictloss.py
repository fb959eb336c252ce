"""``seaminspector:predictloss``: what feathering would cost, before there is a mosaic."""
from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from qgis.core import QgsCoordinateReferenceSystem, QgsProcessingFeatureSource, QgsWkbTypes
from qgis.PyQt.QtCore import QT_TR_NOOP

from ...imagery.errors import RasterError, SettingsError
from ...toolkit import messages
from ...toolkit.algorithms import parameters as common
from ...toolkit.algorithms.base import SeamInspectorAlgorithm
from ...toolkit.algorithms.raster_lists import WindowFeatures
from ...toolkit.algorithms.run import Run
from ...toolkit.translation import tr
from ..measure.limits import COSINE, RAMPS
from .block_parameters import check_sources, gathered_sources, given_sources

if TYPE_CHECKING:
    from ..measure.planning.loss_forecast import ForecastRequest, ForecastSettings
    from ..measure.source_images import Source

WINDOWS, WIDTH, RAMP, SEAMLINES = "WINDOWS", "WIDTH", "RAMP", "SEAMLINES"
OUTPUT, PAIRS = "OUTPUT", "PAIRS"
WINDOW_COUNT, NOT_COMPARABLE_COUNT = "WINDOW_COUNT", "NOT_COMPARABLE_COUNT"


class PredictLoss(SeamInspectorAlgorithm):
    """How much detail a 50:50 feather of the sources would leave in each window."""

    ID = "predictloss"
    NAME = QT_TR_NOOP("Predict loss by feathering")
    HELP = QT_TR_NOOP(
        "Predicts, before any mosaic is made, how much detail feathering would cost in each window. Where two images "
        "are blended half and half, the part of their detail that they do not share cancels: with rho the agreement "
        "of their detail coefficients, (1 + rho) / 2 of its variance is left. Images that lie 1 px apart can lose "
        "half of their finest detail this way. The smallest ratio over the pairs of sources says where feathering "
        "will hurt, so that the seam can go elsewhere, the images be registered better, or the feather made narrower."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.addDescribed(common.features(WINDOWS, tr("Windows"), common.POLYGON), tr(
            "Rectangles where seams are to run, in any reference system. The rectangle around each is measured, "
            "snapped to the pixels of the finest source that covers it."
        ))
        self.addDescribed(*common.sources())
        self.addDescribed(*common.source_index())
        self.addDescribed(*common.wavelet())
        self.addDescribed(*common.levels())
        self.addDescribed(common.real(WIDTH, tr("Width of the feather (metres)"), 0, 0, optional=True), tr(
            "Full width, from where only one image counts to where only the other does. What such a feather would "
            "leave in the whole window and in its own strip is in window_kept and strip_kept. 0 or empty: only the "
            "middle of the feather is predicted, where both images weigh the same."
        ))
        self.addDescribed(common.choice(RAMP, tr("Ramp of the feather"), RAMPS, COSINE, optional=True), tr(
            "How the weights of the two images change across the feather: in a straight line, as half a wave of the "
            "cosine, or as a mask smoothed by a Gaussian. The full width of the Gaussian is 4 sigma, from weights of "
            "0.02 to 0.98."
        ))
        self.addDescribed(common.features(SEAMLINES, tr("Seamlines"), common.LINE, common.POLYGON, optional=True), tr(
            "Lines along which the images are to be joined, or polygons with such borders, where they are known. "
            "Elsewhere the seam is assumed to run straight through the middle of its window, and the prediction is the "
            "mean over the directions it may have."
        ), advanced=True)
        self.addDescribed(common.result(OUTPUT, tr("Predicted windows"), common.POLYGON), tr(
            "The rectangles as measured, in the sources' reference system, with the smallest ratio over the pairs."
        ))
        self.addDescribed(common.result(PAIRS, tr("Source pairs"), common.TABLE, optional=True), tr(
            "Each pair of sources of a window: agreement of their detail, expected ratio, shift between them."
        ))
        self.addNumbers({WINDOW_COUNT: tr("Windows"), NOT_COMPARABLE_COUNT: tr("Windows that can't be compared")})

    def check(self, run: Run) -> None:
        self._settings(run).check()
        check_sources(run)

    def prepare_run(self, run: Run) -> None:
        self._given = given_sources(run)

    def execute(self, run: Run) -> dict[str, Any]:
        from ...toolkit import layers
        from ...toolkit.algorithms.window_notices import WindowNotices
        from ...toolkit.executors import open_executor
        from ...toolkit.table_fields import column_features, column_fields, column_values, feature
        from ..measure.planning.loss_forecast import forecast_window, not_foretold
        from ..measure.workers import Workers, in_order
        from ..tables.result_tables import FORECAST_COLUMNS, FORECAST_PAIR_COLUMNS

        self.check(run)
        settings = self._settings(run)
        levels = settings.levels
        windows = run.source(WINDOWS)
        if windows.featureCount() == 0:
            raise SettingsError(messages.NO_WINDOWS())
        crs, wkt = self._system(windows, run)
        sources = gathered_sources(run, self._given, crs, wkt)
        drawn = WindowFeatures(windows, crs, run)
        requests = self._requests(drawn, sources, self._seamlines(run, crs), wkt, settings)

        count = not_comparable = 0
        notices = WindowNotices()
        with open_executor() as (executor, ahead):
            fields = column_fields(FORECAST_COLUMNS, levels)
            output, output_id = run.sink(OUTPUT, fields, QgsWkbTypes.Type.Polygon, crs)
            pairs, pairs_id = run.optional_sink(PAIRS, column_fields(FORECAST_PAIR_COLUMNS, levels))
            workers = Workers(executor, ahead, run.is_cancelled)
            for forecast in in_order(requests, forecast_window, not_foretold, workers):
                geometry, _ = drawn.taken(forecast.window_id)
                if forecast.extent is not None:
                    geometry = layers.rectangle(forecast.extent)
                run.write(output, [feature(fields, column_values(FORECAST_COLUMNS, forecast, levels), geometry)])
                of_pairs = ((forecast, pair) for pair in forecast.pairs)
                run.write(pairs, column_features(FORECAST_PAIR_COLUMNS, of_pairs, levels))
                notices.add(forecast.window_id, [*forecast.notices, forecast.reason])
                count += 1
                not_comparable += forecast.reason is not None
                run.progress(count / drawn.count)
        run.tell(*notices.messages())
        run.tell(*drawn.notices())
        run.style(output_id, "predicted_windows")
        return {OUTPUT: output_id, PAIRS: pairs_id, WINDOW_COUNT: count, NOT_COMPARABLE_COUNT: not_comparable}

    def _system(self, windows: QgsProcessingFeatureSource, run: Run) -> tuple[QgsCoordinateReferenceSystem, str]:
        """The reference system of the first source that can be read, else the index layer's, else the windows'."""
        from ...imagery.open_raster import describe, placed
        from ...toolkit import layers
        from ...toolkit.reference_systems import known_system

        for ref in self._given.refs:
            with suppress(RasterError):  # it is named when the sources are gathered
                raster = placed(describe(ref))
                return layers.mosaic_crs(raster), raster.wkt
        crs = known_system(windows.sourceCrs())
        if run.parameters.get(common.SOURCE_INDEX):
            index = known_system(run.source(common.SOURCE_INDEX).sourceCrs())
            crs = index if index.isValid() else crs
        return crs, layers.system_wkt(crs)

    def _settings(self, run: Run) -> ForecastSettings:
        from ..measure.planning.loss_forecast import ForecastSettings

        return ForecastSettings(*run.decomposition(), run.real(WIDTH), run.text(RAMP) or COSINE)

    def _seamlines(self, run: Run, crs: QgsCoordinateReferenceSystem) -> tuple[bytes, ...] | None:
        """Seamlines that are known, in the windows' reference system; None where the parameter is not given."""
        from ...toolkit import layers

        if not run.parameters.get(SEAMLINES):
            return None
        lines = run.source(SEAMLINES)
        transform = run.transform(lines, crs)
        geometries = (layers.line_wkb(feature, transform) for feature in layers.features(lines))
        return tuple(wkb for wkb in geometries if wkb is not None)

    @staticmethod
    def _requests(
        drawn: WindowFeatures, sources: list[Source], seamlines: tuple[bytes, ...] | None, wkt: str,
        settings: ForecastSettings,
    ) -> Iterator[ForecastRequest]:
        from ..measure.planning.loss_forecast import ForecastRequest
        from ..measure.source_images import covers

        for window in drawn.windows():
            extent = window.extent
            covering = () if extent is None else tuple(source for source in sources if covers(source.extent, extent))
            yield ForecastRequest(window.window_id, covering, extent, wkt, settings, seamlines, window.reason)
