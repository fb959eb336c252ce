"""What all our algorithms share: names, help, and errors as one clear sentence."""
from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, Optional

from qgis.core import (
    QgsFeature,
    QgsFeatureSink,
    QgsMapLayer,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeatureSource,
    QgsProcessingFeedback,
    QgsProcessingLayerPostProcessorInterface,
    QgsProcessingOutputNumber,
    QgsProcessingParameterDefinition,
)
from qgis.PyQt import sip
from qgis.PyQt.QtGui import QIcon

from ...imagery.errors import CancelledError, SeamInspectorError, SettingsError
from ..packages import missing_packages_sentence
from ..resources import icon_path
from ..translation import sentence, tr
from . import groups
from . import parameters as common
from .feedback import tell
from .overwriting import refuse_overwriting

if TYPE_CHECKING:
    from ...imagery.rasters import Raster

Sink = tuple[Optional[QgsFeatureSink], Optional[str]]


class SeamInspectorAlgorithm(QgsProcessingAlgorithm):
    """An algorithm says its id, names and help in class attributes and does its work in ``execute``."""

    ID: str
    NAME: str
    GROUP = groups.SEAM_INSPECTION
    HELP: str
    RASTER_LISTS: tuple[str, ...] = (common.SOURCES,)
    """Parameters with many rasters, which are opened one by one and not by QGIS."""
    DRAWN: tuple[str, ...] = (common.CHART, common.REPORT)
    """Outputs with charts: where they are asked for, the package that draws them has to be there."""
    PAGES: tuple[str, ...] = (common.REPORT,)
    """Outputs that are made from templates, likewise."""

    def name(self) -> str:
        return self.ID

    def displayName(self) -> str:
        return tr(self.NAME)

    def group(self) -> str:
        return tr(self.GROUP)

    def groupId(self) -> str:
        return self.GROUP  # a model has its group's name for an id, and belongs to the same group

    def shortHelpString(self) -> str:
        described = (
            f"<b>{definition.description()}</b>: {definition.help()}"
            for definition in self.parameterDefinitions()
            if definition.help()
        )
        return "".join(f"<p>{paragraph}</p>" for paragraph in (tr(self.HELP), *described))

    def icon(self) -> QIcon:
        return QIcon(icon_path())

    def createInstance(self) -> QgsProcessingAlgorithm:
        return type(self)()

    def canExecute(self) -> tuple[bool, str]:
        missing = missing_packages_sentence()
        return not missing, missing

    def addDescribed(
        self, definition: QgsProcessingParameterDefinition, description: str, advanced: bool = False
    ) -> None:
        """Add a parameter with its help."""
        definition.setHelp(description)
        if advanced:
            definition.setFlags(definition.flags() | QgsProcessingParameterDefinition.Flag.FlagAdvanced)
        self.addParameter(definition)

    def addNumbers(self, titles: Mapping[str, str]) -> None:
        """Add numbers to the results, by name."""
        for name, title in titles.items():
            self.addOutput(QgsProcessingOutputNumber(name, title))

    def prepareAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> bool:
        missing = self._missing_packages(parameters)
        if missing:
            raise QgsProcessingException(missing)
        try:
            refuse_overwriting(self, parameters, context)  # models and scripts may not have checked the values
            self.prepare(parameters, context)
        except SeamInspectorError as error:
            raise QgsProcessingException(sentence(error.message)) from None
        return True

    def processAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        self._sinks: list[QgsFeatureSink] = []
        try:
            results = self.execute(parameters, context, feedback)
        except CancelledError as stopped:
            tell(feedback, stopped.message)
            return {}
        except SeamInspectorError as error:
            raise QgsProcessingException(sentence(error.message)) from None
        finally:
            for sink in self._sinks:  # a layer is whole only without its sink, which a frame or a cycle may still hold
                sip.delete(sink)
        return {name: value for name, value in results.items() if value is not None}

    def prepare(self, parameters: dict[str, Any], context: QgsProcessingContext) -> None:
        """Take from layers what the work needs of them, in plain data: this runs in their thread, the work may not."""

    def execute(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        """The work; raises SeamInspectorError for what the user can mend. A result that there is not may be None."""
        raise NotImplementedError

    def checkParameterValues(self, parameters: dict[str, Any], context: QgsProcessingContext) -> tuple[bool, str]:
        missing = self._missing_packages(parameters)
        if missing:
            return False, missing
        try:
            refuse_overwriting(self, parameters, context)
            self.check(parameters, context)
        except SeamInspectorError as error:
            return False, sentence(error.message)
        return super().checkParameterValues(self.for_check(parameters), context)

    def for_check(self, parameters: dict[str, Any]) -> dict[str, Any]:
        """What QGIS's own check is given.

        It would load every raster of a list, and refuse them all, without a reason, for one that can't be opened; an
        empty list is all right with it.
        """
        return {name: [] if name in self.RASTER_LISTS else value for name, value in parameters.items()}

    def check(self, parameters: dict[str, Any], context: QgsProcessingContext) -> None:
        """Raise SeamInspectorError for values that QGIS's own check would refuse without saying why."""

    def _missing_packages(self, parameters: dict[str, Any]) -> str:
        """What lacks for the outputs asked for; empty when nothing does."""
        charts, pages = (any(parameters.get(name) for name in names) for names in (self.DRAWN, self.PAGES))
        return missing_packages_sentence(charts, pages)

    def decomposition(self, parameters: dict[str, Any], context: QgsProcessingContext) -> tuple[str, int]:
        """The values of WAVELET and LEVELS."""
        return (
            self.parameterAsString(parameters, common.WAVELET, context),
            self.parameterAsInt(parameters, common.LEVELS, context),
        )

    def describe_mosaic(self, parameters: dict[str, Any], context: QgsProcessingContext) -> Raster:
        """The raster of the parameter MOSAIC."""
        from ...imagery.open_raster import describe_mosaic

        return describe_mosaic(common.required_raster(parameters, common.MOSAIC, context))

    def describe_north_up(self, parameters: dict[str, Any], name: str, context: QgsProcessingContext) -> Raster:
        """The raster of a parameter, which may lie anywhere."""
        from ...imagery.open_raster import describe_north_up

        return describe_north_up(common.required_raster(parameters, name, context))

    def source(
        self, parameters: dict[str, Any], name: str, context: QgsProcessingContext
    ) -> QgsProcessingFeatureSource:
        """The features of a parameter that has to be there."""
        source = self.parameterAsSource(parameters, name, context)
        if source is None:
            raise QgsProcessingException(self.invalidSourceError(parameters, name))
        return source

    def sink(self, parameters: dict[str, Any], name: str, context: QgsProcessingContext, *layout: Any) -> Sink:
        """Where features go, and its destination; ``layout``: fields, and geometry type and reference system if any."""
        sink, destination = self.parameterAsSink(parameters, name, context, *layout)
        if sink is None:
            raise QgsProcessingException(self.invalidSinkError(parameters, name))
        self._sinks.append(sink)
        return sink, destination

    def optional_sink(
        self, parameters: dict[str, Any], name: str, context: QgsProcessingContext, *layout: Any
    ) -> Sink:
        """Like ``sink``; nothing when the output is not wanted."""
        return self.sink(parameters, name, context, *layout) if parameters.get(name) else (None, None)

    def file_path(self, parameters: dict[str, Any], name: str, context: QgsProcessingContext) -> Path | None:
        """Where an output file goes; None when it is not wanted."""
        path = self.parameterAsFileOutput(parameters, name, context) if parameters.get(name) else ""
        return Path(path) if path else None

    def check_chart(self, parameters: dict[str, Any], context: QgsProcessingContext) -> None:
        """Raise SettingsError for a chart whose ending can't be drawn."""
        path = self.file_path(parameters, common.CHART, context)
        if path is not None:
            from ..charts.figure_files import check_figure_path

            check_figure_path(path)

    def save(
        self,
        parameters: dict[str, Any],
        name: str,
        context: QgsProcessingContext,
        feedback: QgsProcessingFeedback,
        write: Callable[[Path], object],
    ) -> dict[str, Any]:
        """Write an output file by ``write(path)`` where it is wanted: its name and path for the results.

        There is none when ``write`` says False, having nothing to write, or when the file can't be written; that is
        told, and does not cost what was measured.
        """
        path = self.file_path(parameters, name, context)
        try:
            if path is not None and write(path) is not False:
                return {name: str(path)}
        except SettingsError as error:
            tell(feedback, error.message)
        return {}

    @staticmethod
    def write(sink: QgsFeatureSink | None, features: Iterable[QgsFeature]) -> None:
        """Add features at once, so that they stay whatever comes after."""
        if sink is None:
            return
        for feature in features:
            if not sink.addFeature(feature, QgsFeatureSink.Flag.FastInsert):
                raise QgsProcessingException(sink.lastError() or tr("A result can't be written; is the disk full?"))

    def style(self, destination: str | None, style: str, context: QgsProcessingContext) -> None:
        """Give a layer that will be loaded a style."""
        if destination and context.willLoadLayerOnCompletion(destination):
            context.layerToLoadOnCompletionDetails(destination).setPostProcessor(_styler(style))


class _Styler(QgsProcessingLayerPostProcessorInterface):
    """Gives a layer its style once it is there."""

    def __init__(self, style: str) -> None:
        super().__init__()
        self._style = style

    def postProcessLayer(
        self, layer: QgsMapLayer, context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> None:
        layer.loadNamedStyle(self._style)
        layer.triggerRepaint()


_stylers: set[_Styler] = set()


def _styler(style: str) -> _Styler:
    """A new one for each layer: QGIS deletes it with the context of its run, and until then does not keep it alive."""
    for one in list(_stylers):
        if sip.isdeleted(one):
            _stylers.discard(one)
    styler = _Styler(style)
    _stylers.add(styler)
    return styler
