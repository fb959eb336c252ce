"""What the algorithms on lists of rasters share: their parameters, and the rasters and windows behind them."""
from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsCoordinateTransform,
    QgsProcessing,
    QgsProcessingContext,
    QgsProcessingFeatureSource,
    QgsProcessingFeedback,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterMultipleLayers,
)

from ..adapters.packages import missing_packages_sentence
from ..adapters.text import sentence, tr
from ..core import messages
from ..core.errors import RasterError, SettingsError, WindowError
from . import parameters as common
from .base import SeamInspectorAlgorithm

if TYPE_CHECKING:
    from ..core.drawn_windows import DrawnWindow
    from ..core.messages import Message
    from ..core.rasters import RasterRef

RASTERS, WINDOWS, REPORT = "RASTERS", "WINDOWS", "REPORT"


class RasterListAlgorithm(SeamInspectorAlgorithm):
    """An algorithm that measures single images, each for itself, on windows or as a whole."""

    RASTER_LISTS: tuple[str, ...] = (RASTERS,)

    def canExecute(self) -> tuple[bool, str]:
        missing = missing_packages_sentence(desk=True)  # with charts and reports
        return not missing, missing

    def check(self, parameters: dict[str, Any], context: QgsProcessingContext) -> None:
        if not common.raster_values(parameters, RASTERS, context):
            raise SettingsError(messages.NO_RASTERS())

    def prepare(self, parameters: dict[str, Any], context: QgsProcessingContext) -> None:
        self.left_out: list[Message] = []
        """About rasters that can't be used at all."""
        self.refs = {name: list(self._refs(parameters, name, context)) for name in self.RASTER_LISTS}
        """The rasters by parameter."""

    def addRasters(self, name: str, words: str, description: str, optional: bool = False) -> None:
        """Add a parameter of several rasters."""
        rasters = QgsProcessingParameterMultipleLayers(
            name, words, QgsProcessing.SourceType.TypeRaster, optional=optional
        )
        self.addDescribed(rasters, description)

    def addWindows(self, description: str) -> None:
        """Add the parameter WINDOWS."""
        polygon = QgsProcessing.SourceType.TypeVectorPolygon
        self.addDescribed(
            QgsProcessingParameterFeatureSource(WINDOWS, tr("Windows"), [polygon], optional=True), description
        )

    def addFile(self, name: str, words: str, filters: str, description: str) -> None:
        """Add an optional output file."""
        file = QgsProcessingParameterFileDestination(name, words, filters, optional=True, createByDefault=False)
        self.addDescribed(file, description)

    def require_rasters(self, usable: Iterable[object]) -> None:
        """Raise SettingsError, with the reasons, when no raster is left."""
        from ..core import thresholds

        if not list(usable):
            why = tuple(self.left_out[: thresholds.MAX_REASONS])
            raise SettingsError(messages.NO_RASTER_USABLE(why=why) if why else messages.NO_RASTERS())

    def drawn_windows(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> list[DrawnWindow] | None:
        """The windows that were given, those without a usable outline named in the log; None when none were."""
        if not parameters.get(WINDOWS):
            return None
        source = self.source(parameters, WINDOWS, context)
        windows = list(_windows(source, feedback))
        if not windows:
            raise SettingsError(messages.NO_WINDOWS())
        return windows

    def say(self, notices: Iterable[Message], feedback: QgsProcessingFeedback) -> None:
        """Put each notice into the log once."""
        for warning in dict.fromkeys(map(sentence, notices)):
            feedback.pushWarning(warning)

    def save(self, feedback: QgsProcessingFeedback, path: Path | None, write: Any) -> str | None:
        """Write an output file by ``write(path)``; a failure is said and does not cost the other results."""
        if path is None:
            return None
        try:
            write(path)
        except SettingsError as error:
            feedback.reportError(sentence(error.message))
            return None
        return str(path)

    def _refs(self, parameters: dict[str, Any], name: str, context: QgsProcessingContext) -> Iterator[RasterRef]:
        from ..adapters.layers import raster_ref

        for value in common.raster_values(parameters, name, context):
            try:
                yield raster_ref(value, context)
            except RasterError as error:
                self.left_out.append(error.message)


def _windows(source: QgsProcessingFeatureSource, feedback: QgsProcessingFeedback) -> Iterator[DrawnWindow]:
    from ..adapters import layers
    from ..core.drawn_windows import DrawnWindow

    wkt = layers.system_wkt(source.sourceCrs())
    numbered = "window_id" in source.fields().names()
    given = [common.whole_number(feature["window_id"]) if numbered else None for feature in layers.features(source)]
    free = max((number for number in given if number is not None), default=0)
    taken: set[int] = set()
    for own, feature in zip(given, layers.features(source)):
        number = own
        if number is None or number in taken:
            free += 1
            number = free
        taken.add(number)
        try:
            outline = layers.window_geometry(feature, QgsCoordinateTransform())
        except WindowError as error:
            feedback.pushWarning(f"{number}: {sentence(error.message)}")
            continue
        yield DrawnWindow(number, layers.extent(outline), wkt)
