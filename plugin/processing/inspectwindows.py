"""``seaminspector:inspectwindows``: the main job."""
from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsFeature,
    QgsGeometry,
    QgsProcessing,
    QgsProcessingContext,
    QgsProcessingFeatureSource,
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterNumber,
    QgsProcessingParameterString,
    QgsWkbTypes,
)
from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP

from ..adapters.resources import style_path
from ..adapters.text import sentence, tr
from ..core import messages, thresholds
from ..core.errors import RasterError, SettingsError, WindowError
from . import parameters as common
from .base import SeamInspectorAlgorithm

if TYPE_CHECKING:
    from ..core.inspection import Block, Settings, WindowRequest
    from ..core.messages import Message
    from ..core.rasters import RasterRef

WINDOWS, MAX_RATIO, SCHEDULER = "WINDOWS", "MAX_RATIO", "SCHEDULER"
OUTPUT, CURVES, PAIRS = "OUTPUT", "CURVES", "PAIRS"
WINDOW_COUNT, SIGNIFICANT_COUNT, NOT_COMPARABLE_COUNT = "WINDOW_COUNT", "SIGNIFICANT_COUNT", "NOT_COMPARABLE_COUNT"


class InspectWindows(SeamInspectorAlgorithm):
    """How much detail a mosaic kept in each window, against each of its sources."""

    ID = "inspectwindows"
    NAME = QT_TRANSLATE_NOOP("@default", "Inspect windows")
    HELP = QT_TRANSLATE_NOOP(
        "@default",
        "Measures how much local contrast a mosaic kept in each window. The mosaic and every source that covers the "
        "window are clipped and decomposed by wavelets; the share of the variance that each level of detail has in "
        "the mosaic is divided by its share in the source. At level 1, the finest, a ratio of 0.5 or less against "
        "every source is a significant loss, one below 1 reduced, else the detail is preserved (Pyka 2010)."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        polygon, table = QgsProcessing.SourceType.TypeVectorPolygon, QgsProcessing.SourceType.TypeVector
        self.addDescribed(
            QgsProcessingParameterFeatureSource(WINDOWS, tr("Windows"), [polygon]),
            tr(
                "Rectangles on the mosaic in any reference system, drawn or placed along the seamlines. What is "
                "measured is the rectangle around each, snapped to the mosaic's pixels."
            ),
        )
        self.addDescribed(*common.mosaic())
        self.addDescribed(*common.sources())
        self.addDescribed(*common.source_index())
        self.addDescribed(*common.wavelet())
        self.addDescribed(*common.levels())
        self.addDescribed(
            QgsProcessingParameterNumber(
                MAX_RATIO,
                tr("Largest ratio of a significant loss"),
                QgsProcessingParameterNumber.Type.Double,
                thresholds.MAX_SIGNIFICANT_RATIO,
                minValue=0,
                maxValue=1,
            ),
            tr("A window is significant when its ratio at level 1 is this or less."),
            advanced=True,
        )
        self.addDescribed(
            QgsProcessingParameterString(SCHEDULER, tr("Dask scheduler"), optional=True),
            tr(
                "Address of a Dask scheduler (tcp://host:8786) whose workers see the rasters under the same paths. "
                "Empty: all cores of this machine."
            ),
            advanced=True,
        )
        self.addDescribed(
            QgsProcessingParameterFeatureSink(OUTPUT, tr("Inspected windows"), polygon),
            tr("The rectangles as measured, with their verdict and ratios: the largest over the sources."),
        )
        self.addDescribed(
            QgsProcessingParameterFeatureSink(CURVES, tr("Curves"), table, optional=True, createByDefault=True),
            tr("Relative variance of every component, for each window, raster and band."),
        )
        self.addDescribed(
            QgsProcessingParameterFeatureSink(PAIRS, tr("Pairs"), table, optional=True, createByDefault=True),
            tr("The mosaic against each single source: ratios, similarity, sub-pixel offset."),
        )
        self.addOutput(QgsProcessingOutputNumber(WINDOW_COUNT, tr("Windows")))
        self.addOutput(QgsProcessingOutputNumber(SIGNIFICANT_COUNT, tr("Windows with a significant loss")))
        self.addOutput(QgsProcessingOutputNumber(NOT_COMPARABLE_COUNT, tr("Windows that can't be compared")))

    def check(self, parameters: dict[str, Any], context: QgsProcessingContext) -> None:
        self._settings(parameters, context).check()
        self.describe_mosaic(parameters, context)
        if not common.raster_values(parameters, common.SOURCES, context) and not parameters.get(common.SOURCE_INDEX):
            raise SettingsError(messages.NO_SOURCES_GIVEN())

    def prepare(self, parameters: dict[str, Any], context: QgsProcessingContext) -> None:
        from ..adapters.layers import raster_ref

        self._mosaic = self.describe_mosaic(parameters, context)
        self._sources: list[RasterRef] = []
        self._left_out: list[Message] = []
        for value in common.raster_values(parameters, common.SOURCES, context):
            try:
                self._sources.append(raster_ref(value, context))
            except RasterError as error:
                self._left_out.append(error.message)
        self._index_path = common.index_path(self, parameters, common.SOURCE_INDEX, context)

    def execute(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        from ..adapters import layers, tables
        from ..adapters.executors import open_executor
        from ..core.contrast import Verdict
        from ..core.inspection import inspect_windows

        settings = self._settings(parameters, context)
        settings.check()
        windows = self.source(parameters, WINDOWS, context)
        if windows.featureCount() == 0:
            raise SettingsError(messages.NO_WINDOWS())
        block = self._block(parameters, context, feedback)
        grid, crs = block.mosaic.grid, layers.mosaic_crs(block.mosaic)
        drawn = _DrawnWindows(windows, block, crs, settings, context, feedback)

        verdicts: Counter[Verdict] = Counter()
        warned: set[str] = set()  # a raster that can't be compared is named once, not in every window
        with open_executor(self.parameterAsString(parameters, SCHEDULER, context)) as (executor, ahead):
            # Only now, with nothing in the way of new results, are old ones overwritten.
            table = QgsWkbTypes.Type.NoGeometry, QgsCoordinateReferenceSystem()
            output, output_id = self.sink(
                parameters, OUTPUT, context, tables.window_fields(settings.levels), QgsWkbTypes.Type.Polygon, crs
            )
            curves, curves_id = self.optional_sink(parameters, CURVES, context, tables.curve_fields(), *table)
            pairs, pairs_id = self.optional_sink(
                parameters, PAIRS, context, tables.pair_fields(settings.levels), *table
            )
            for result in inspect_windows(drawn.requests(), executor, ahead, feedback.isCanceled):
                geometry, observer = drawn.taken(result.window_id)
                if result.window is not None:
                    geometry = layers.rectangle(grid.window_extent(result.window))
                self.write(output, [tables.window_feature(result, geometry, observer)])
                self.write(curves, tables.curve_features(result))
                self.write(pairs, tables.pair_features(result))
                for warning in map(sentence, result.notices):
                    if warning not in warned:
                        feedback.pushWarning(warning)
                    warned.add(warning)
                if result.judgement.reason is not None:
                    feedback.pushInfo(f"{result.window_id}: {sentence(result.judgement.reason)}")
                verdicts[result.judgement.verdict] += 1
                feedback.setProgress(100 * sum(verdicts.values()) / drawn.count)
        if drawn.renumbered:
            feedback.pushWarning(sentence(messages.WINDOWS_RENUMBERED(count=drawn.renumbered)))
        feedback.pushInfo(", ".join(f"{verdict.value}: {verdicts[verdict]}" for verdict in Verdict))
        self.style(output_id, style_path("windows"), context)
        results = {
            OUTPUT: output_id,
            CURVES: curves_id,
            PAIRS: pairs_id,
            WINDOW_COUNT: sum(verdicts.values()),
            SIGNIFICANT_COUNT: verdicts[Verdict.SIGNIFICANT],
            NOT_COMPARABLE_COUNT: verdicts[Verdict.NOT_COMPARABLE],
        }
        return {name: value for name, value in results.items() if value is not None}

    def _settings(self, parameters: dict[str, Any], context: QgsProcessingContext) -> Settings:
        from ..core.inspection import Settings

        return Settings(
            self.parameterAsString(parameters, common.WAVELET, context),
            self.parameterAsInt(parameters, common.LEVELS, context),
            self.parameterAsDouble(parameters, MAX_RATIO, context),
        )

    def _block(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> Block:
        from ..adapters import layers
        from ..core.inspection import make_block

        indexed = []
        if parameters.get(common.SOURCE_INDEX):
            index = self.source(parameters, common.SOURCE_INDEX, context)
            crs = layers.mosaic_crs(self._mosaic)
            transform = QgsCoordinateTransform(index.sourceCrs(), crs, context.transformContext())
            names = index.fields().names()
            indexed = layers.indexed_sources(layers.features(index), names, self._index_path, transform)
        for notice in self._left_out:
            feedback.pushWarning(sentence(notice))
        block, notices = make_block(self._mosaic, self._sources, indexed)
        for notice in notices:
            feedback.pushWarning(sentence(notice))
        return block


class _DrawnWindows:
    """The features of the window layer, read one by one; what a result needs of them is kept until it is taken."""

    def __init__(
        self,
        windows: QgsProcessingFeatureSource,
        block: Block,
        crs: QgsCoordinateReferenceSystem,
        settings: Settings,
        context: QgsProcessingContext,
        feedback: QgsProcessingFeedback,
    ) -> None:
        self.count = windows.featureCount()
        self.renumbered = 0
        """How many windows had no number of their own."""
        self._windows, self._block, self._settings = windows, block, settings
        self._transform = QgsCoordinateTransform(windows.sourceCrs(), crs, context.transformContext())
        self._names = set(windows.fields().names())
        self._waiting: dict[int, tuple[QgsGeometry | None, str | None]] = {}
        self._numbers = self._given_numbers()
        self._last = max(self._numbers, default=0)

    def requests(self) -> Iterator[WindowRequest]:
        """One request per feature, in the layer's order."""
        from ..adapters import layers
        from ..core.inspection import WindowRequest, window_request

        for feature in layers.features(self._windows):
            number = self._number(feature)
            geometry: QgsGeometry | None = None
            try:
                outline = layers.window_geometry(feature, self._transform)
                geometry = layers.rectangle(layers.extent(outline))
                request = window_request(self._block, number, layers.extent(outline), self._settings)
            except WindowError as error:
                request = WindowRequest(number, self._block.mosaic, (), None, self._settings, error.message)
            observer = (feature["observer"] or None) if "observer" in self._names else None
            self._waiting[number] = geometry, observer
            yield request

    def taken(self, window_id: int) -> tuple[QgsGeometry | None, str | None]:
        """The rectangle as drawn and the observer's word of a window whose result has come."""
        return self._waiting.pop(window_id)

    def _given_numbers(self) -> set[int]:
        from ..adapters import layers

        if "window_id" not in self._names:
            return set()
        numbers = (common.whole_number(feature["window_id"]) for feature in layers.features(self._windows))
        return {number for number in numbers if number is not None}

    def _number(self, feature: QgsFeature) -> int:
        """The feature's own number when it is the first to have it, else the next free one."""
        own = common.whole_number(feature["window_id"]) if "window_id" in self._names else None
        if own is not None and own in self._numbers:
            self._numbers.remove(own)
            return own
        self.renumbered += "window_id" in self._names
        self._last += 1
        return self._last

