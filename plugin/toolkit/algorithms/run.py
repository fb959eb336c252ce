"""One run of an algorithm: what its parameters hold, and where its results and messages go."""
from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsFeature,
    QgsFeatureSink,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeatureSource,
    QgsProcessingFeedback,
    QgsProcessingOutputLayerDefinition,
    QgsProperty,
    QgsVectorLayer,
)

from ...imagery.errors import Level, RasterError, SettingsError
from .. import messages
from ..layer_styles import layer_styler
from ..translation import sentence
from . import parameters as common
from .feature_sinks import FeatureSinks, Sink
from .outputs import is_file, output_text, table_place

if TYPE_CHECKING:
    from ...imagery.errors import Message
    from ...imagery.rasters import Raster, RasterRef

_DBASE = (".shp", ".dbf")  # whose tables are dBASE's
_DBASE_LETTERS = 10  # of a field's name in one


class Run:
    """The parameters of a run, read by their names, and its results and messages."""

    def __init__(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext,
        feedback: QgsProcessingFeedback | None = None,
    ) -> None:
        self.parameters, self.context = parameters, context
        self.feedback = QgsProcessingFeedback() if feedback is None else feedback
        self._algorithm = algorithm
        self._sinks = FeatureSinks()
        self._messages: set[str] = set()  # that ``tell_once`` has shown
        self._styles: dict[str, str] = {}  # of layers, by their destinations

    def close(self, has_failed: bool = False) -> dict[str, Message]:
        """Make layers whole; why some are not, by their destinations. Once is enough."""
        self._sinks.close(has_failed, self.is_cancelled())
        for destination, (path, said) in self._sinks.beside.items():
            self._load_from(destination, path)
            self.tell(said)
        return self._sinks.lost

    def available(self, results: dict[str, Any]) -> dict[str, Any]:
        """The results of a closed run that there are; tells of the others.

        Raises SettingsError where all layers are lost.
        """
        lost, beside = self._sinks.lost, self._sinks.beside
        if lost and not self._sinks.has_whole:
            raise SettingsError(next(iter(lost.values())))
        self.tell(*lost.values())
        written = {name: value for name, value in results.items() if value is not None and value not in lost}
        return {name: beside[value][0] if value in beside else value for name, value in written.items()}

    # values

    def text(self, name: str) -> str:
        return str(self._algorithm.parameterAsString(self.parameters, name, self.context))

    def word(self, name: str) -> str:
        return str(self._algorithm.parameterAsEnumString(self.parameters, name, self.context))

    def whole(self, name: str) -> int:
        return int(self._algorithm.parameterAsInt(self.parameters, name, self.context))

    def real(self, name: str) -> float:
        return float(self._algorithm.parameterAsDouble(self.parameters, name, self.context))

    def flag(self, name: str) -> bool:
        return bool(self._algorithm.parameterAsBool(self.parameters, name, self.context))

    def crs(self, name: str) -> QgsCoordinateReferenceSystem:
        return self._algorithm.parameterAsCrs(self.parameters, name, self.context)

    def path(self, name: str) -> str:
        return str(self._algorithm.parameterAsFile(self.parameters, name, self.context))

    def decomposition(self) -> tuple[str, int]:
        return self.text(common.WAVELET), self.whole(common.LEVELS)

    # rasters, to be asked in their layers' thread

    def raster_value(self, name: str) -> object:
        """A raster parameter as it was given: a layer, a layer's id, or a path."""
        value = self.parameters.get(name)
        return value.valueAsString(self.context.expressionContext())[0] if isinstance(value, QgsProperty) else value

    def raster(self, name: str) -> RasterRef | None:
        """The file of a raster parameter; None when it is not given."""
        from ..layers import raster_ref

        value = self.raster_value(name)
        return raster_ref(value, self.context) if value else None

    def required_raster(self, name: str) -> RasterRef:
        """The file of a raster parameter that has to be there: raises RasterError when it is not given."""
        ref = self.raster(name)
        if ref is None:
            raise RasterError(messages.NOT_A_RASTER_LAYER(name=name))
        return ref

    def raster_values(self, name: str) -> list[object]:
        """A parameter of several rasters as it was given; nothing is loaded."""
        value = self.raster_value(name)
        if value is None or value == "":
            return []
        return list(value) if isinstance(value, (list, tuple)) else [value]

    def raster_refs(self, name: str) -> tuple[list[RasterRef], list[Message]]:
        """The files of a parameter of several rasters, and why others have none."""
        from ..layers import raster_ref

        refs: list[RasterRef] = []
        left_out: list[Message] = []
        for value in self.raster_values(name):
            try:
                refs.append(raster_ref(value, self.context))
            except RasterError as error:
                left_out.append(error.message.as_warning())
        return refs, left_out

    def mosaic(self) -> Raster:
        from ...imagery.open_raster import describe_mosaic

        return self._told(describe_mosaic(self.required_raster(common.MOSAIC)))

    def north_up(self, name: str) -> Raster:
        """The raster of a parameter, which may lie anywhere."""
        from ...imagery.open_raster import describe_north_up

        return self._told(describe_north_up(self.required_raster(name)))

    def _told(self, raster: Raster) -> Raster:
        """A raster of which is told once what was settled otherwise than its file says."""
        self.tell_once(raster.notices)
        return raster

    # features

    def vector_layer(self, name: str) -> QgsVectorLayer | None:
        return self._algorithm.parameterAsVectorLayer(self.parameters, name, self.context)

    def source(self, name: str) -> QgsProcessingFeatureSource:
        """The features of a parameter that has to be there."""
        source = self._algorithm.parameterAsSource(self.parameters, name, self.context)
        if source is None:
            raise QgsProcessingException(self._algorithm.invalidSourceError(self.parameters, name))
        return source

    def transform(
        self, source: QgsProcessingFeatureSource, crs: QgsCoordinateReferenceSystem
    ) -> QgsCoordinateTransform:
        """The transformation from a layer's reference system to another. Raises WindowError when PROJ has none."""
        from ..reference_systems import transformation

        return transformation(source.sourceCrs(), crs, self.context.transformContext())

    # results

    def sink(self, name: str, *layout: Any) -> Sink:
        """The sink of an output of features, and its destination.

        ``layout``: fields, and geometry type and reference system if there are any.
        """
        text = output_text(self.parameters.get(name), self.context)
        place = table_place(text) if text and is_file(text) else None
        if place is not None and place.path.lower().endswith(_DBASE):
            cut = [field for field in layout[0].names() if len(field) > _DBASE_LETTERS]
            self.tell(*([messages.FIELD_NAMES_CUT(path=place.path, names=", ".join(cut))] if cut else []))

        def make(path: str | None) -> Sink:
            given = dict(self.parameters)
            if path is not None:
                given[name] = QgsProcessingOutputLayerDefinition(given[name])
                given[name].sink = QgsProperty.fromValue(path)
            sink, destination = self._algorithm.parameterAsSink(given, name, self.context, *layout)
            if sink is None:
                raise QgsProcessingException(self._algorithm.invalidSinkError(self.parameters, name))
            if path is None or place is None:
                return sink, destination
            self._load_from(destination, place.path)
            return sink, place.path

        return self._sinks.open(make, place)

    def _load_from(self, destination: str, path: str) -> None:
        """Load a layer that will be loaded from another place."""
        layers = self.context.layersToLoadOnCompletion()
        if destination not in layers:
            return
        was = layers.pop(destination)
        moved = QgsProcessingContext.LayerDetails(was.name, was.project, was.outputName, was.layerTypeHint)
        moved.forceName = was.forceName
        self.context.setLayersToLoadOnCompletion({**layers, path: moved})  # which deletes who would have styled it
        self.style(path, self._styles.get(destination, ""))

    def optional_sink(self, name: str, *layout: Any) -> Sink:
        """The sink of an output and its destination; (None, None) when it is not wanted."""
        return self.sink(name, *layout) if self.parameters.get(name) else (None, None)

    def write(self, sink: QgsFeatureSink | None, features: Iterable[QgsFeature]) -> None:
        """Add features at once, so that they stay whatever comes after; nothing where the output is not wanted."""
        if sink is not None:
            self._sinks.write(sink, features)

    def style(self, destination: str | None, style: str) -> None:
        """Give a layer that will be loaded a style of ours."""
        if not destination or not style:
            return
        self._styles[destination] = style
        if self.context.willLoadLayerOnCompletion(destination):
            self.context.layerToLoadOnCompletionDetails(destination).setPostProcessor(layer_styler(style))

    def note(self, destination: str | None, domain: str, notes: Mapping[str, str]) -> bool:
        """Write words beside the rows of a layer that is closed; False where it has no place for them."""
        from ..layers import write_layer_notes

        if not destination:
            return True
        path = self._sinks.beside[destination][0] if destination in self._sinks.beside else destination
        layer = self.context.getMapLayer(path)  # one in memory
        return write_layer_notes(path if layer is None else layer, domain, notes)

    def title(self, destination: str | None, title: str) -> None:
        """Name a layer that will be loaded, where the output's own name would not tell it from others."""
        if destination and self.context.willLoadLayerOnCompletion(destination):
            self.context.layerToLoadOnCompletionDetails(destination).name = title

    def layer_path(self, name: str) -> str:
        return str(self._algorithm.parameterAsOutputLayer(self.parameters, name, self.context))

    def file_path(self, name: str) -> Path | None:
        """Path of an output file; None when it is not wanted."""
        wanted = self.parameters.get(name)
        path = self._algorithm.parameterAsFileOutput(self.parameters, name, self.context) if wanted else ""
        return Path(path) if path else None

    def save(self, name: str, write: Callable[[Path], object]) -> dict[str, Any]:
        """Write an output file by ``write(path)`` where it is wanted: its name and path for the results.

        There is none when ``write`` says False, having nothing to write, when the run was cancelled, or when the file
        can't be written; that is told, and does not cost what was measured.
        """
        path = None if self.is_cancelled() else self.file_path(name)
        try:
            if path is not None and write(path) is not False:
                return {name: str(path)}
        except SettingsError as error:
            self.feedback.reportError(sentence(error.message))
        return {}

    # telling

    def tell(self, *messages: Message) -> None:
        """Tell messages as information, warnings or errors; the run goes on."""
        to = self.feedback
        push = {Level.INFO: to.pushInfo, Level.WARNING: to.pushWarning, Level.ERROR: to.reportError}
        for message in messages:
            push[message.level](sentence(message))

    def tell_once(self, messages: Iterable[Message]) -> None:
        """Tell those that were not told so before: a raster that can't be compared is not named in every window."""
        for message in messages:
            if (text := str(message)) not in self._messages:
                self.tell(message)
            self._messages.add(text)

    def is_cancelled(self) -> bool:
        return bool(self.feedback.isCanceled())

    def progress(self, share: float) -> None:
        self.feedback.setProgress(100 * share)

    def goes_on(self, share: float) -> bool:
        """Tell how much is done, 0 to 1; whether the user wants more."""
        self.progress(share)
        return not self.is_cancelled()
