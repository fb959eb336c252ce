"""The base of all our algorithms: names, help, and errors as one clear sentence.

Their groups in the toolbox are here too; each name, not translated, is its group's id.
"""
from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from qgis.core import (
    QgsProcessing,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeedback,
    QgsProcessingModelAlgorithm,
    QgsProcessingOutputNumber,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFileDestination,
)
from qgis.PyQt.QtCore import QT_TR_NOOP
from qgis.PyQt.QtGui import QIcon

from ...imagery.errors import CancelledError, SeamInspectorError
from ...imagery.gdal_calls import gdal_silenced
from .. import messages
from ..packages import missing_packages_sentence
from ..resources import help_url, icon_path
from ..translation import sentence, tr
from . import parameters as common
from .outputs import refuse_outputs
from .run import Run

SEAM_INSPECTION = QT_TR_NOOP("Seam inspection")
IMAGE_QUALITY = QT_TR_NOOP("Image quality")
GROUND_RESOLUTION = QT_TR_NOOP("Ground resolution")
INTERIOR_ORIENTATION = QT_TR_NOOP("Interior orientation of photos")
SATELLITE_IMAGES = QT_TR_NOOP("Satellite images")


class SeamInspectorAlgorithm(QgsProcessingAlgorithm):
    """An algorithm says its id, names and help in class attributes and does its work in ``execute``."""

    ID: str
    NAME: str
    GROUP = SEAM_INSPECTION
    HELP: str
    RASTER_LISTS: tuple[str, ...] = (common.SOURCES,)  # parameters with many rasters, which QGIS is not to open
    DRAWN: tuple[str, ...] = (common.CHART, common.REPORT)  # outputs with charts, which need matplotlib
    PAGES: tuple[str, ...] = (common.REPORT,)  # outputs that are made from templates, likewise
    NAMED_BY_FORMAT: tuple[str, ...] = ()  # output files whose ending has to be one that is offered, beside pages

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

    def helpUrl(self) -> str:
        return help_url(self.ID)

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
        for name, title in titles.items():
            self.addOutput(QgsProcessingOutputNumber(name, title))

    def prepareAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> bool:
        missing = self._missing_packages(parameters)
        if missing:
            raise QgsProcessingException(missing)
        try:
            with gdal_silenced():
                self._refuse(parameters, context)  # models and scripts may not have checked the values
                self.prepare(Run(self, parameters, context, feedback))
        except SeamInspectorError as error:
            raise _for_qgis(error) from None
        return True

    def processAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        run = Run(self, parameters, context, feedback)
        with gdal_silenced():
            try:
                try:
                    results = self.execute(run)
                except BaseException:
                    run.close(has_failed=True)
                    raise
                run.close()
                return run.available(results)
            except CancelledError as stopped:
                run.tell(stopped.message)
                return {}
            except SeamInspectorError as error:
                raise _for_qgis(error) from None
            except Exception:
                # Whether QGIS has forgotten the plugin's modules since, or loaded them anew: what was not imported
                # before can't be had any more.
                known = getattr(sys.modules.get(__name__), SeamInspectorAlgorithm.__name__, None)
                if known is SeamInspectorAlgorithm:
                    raise
                raise QgsProcessingException(sentence(messages.UNLOADED())) from None

    def checkParameterValues(self, parameters: dict[str, Any], context: QgsProcessingContext) -> tuple[bool, str]:
        missing = self._missing_packages(parameters)
        if missing:
            return False, missing
        try:
            with gdal_silenced():
                self.check(self._refuse(parameters, context))
        except SeamInspectorError as error:
            return False, sentence(error.message)
        with gdal_silenced():
            return super().checkParameterValues(self.for_check(parameters), context)

    def _refuse(self, parameters: dict[str, Any], context: QgsProcessingContext) -> Run:
        """The run of the values, to be looked at further. Raises SeamInspectorError for what no algorithm takes."""
        pages = [name for name in self.PAGES if self.parameterDefinition(name) is not None]
        common.check_values(self, self.for_check(parameters), context)
        return _refused(self, [*pages, *self.NAMED_BY_FORMAT], parameters, context)

    def check(self, run: Run) -> None:
        """Raise SeamInspectorError for values that QGIS's own check would refuse without saying why."""

    def prepare(self, run: Run) -> None:
        """Take from layers what the work needs of them, in plain data: this runs in their thread, the work may not."""

    def execute(self, run: Run) -> dict[str, Any]:
        """The work; raises SeamInspectorError for what the user can mend. A result that there is not may be None."""
        raise NotImplementedError

    def for_check(self, parameters: dict[str, Any]) -> dict[str, Any]:
        """The values for QGIS's own check."""
        return common.without_rasters(self, parameters, self.RASTER_LISTS)

    def _missing_packages(self, parameters: dict[str, Any]) -> str:
        """A sentence on packages that lack for the outputs asked for; empty when none does."""
        charts, pages = (any(parameters.get(name) for name in names) for names in (self.DRAWN, self.PAGES))
        return missing_packages_sentence(charts, pages)


def _for_qgis(error: SeamInspectorError) -> QgsProcessingException:
    """The exception for QGIS, which never lets go of one: frames that hang on it would keep parameters of models, which
    are deleted, and whatever QGIS makes in their place later would be taken for them, and crash."""
    error.with_traceback(None).__context__ = None
    return QgsProcessingException(sentence(error.message))


_TITLES, _HELP = ("description", "component_description", "model_group"), "help"


class ReadyModel(QgsProcessingModelAlgorithm):
    """A model that comes with the plugin, its values checked as a whole: a step knows only its inputs, and could write
    over what the model was given for another."""

    def createInstance(self) -> QgsProcessingAlgorithm:
        copy = ReadyModel()
        copy.loadVariant(self.toVariant())
        copy.setProvider(self.provider())
        copy.setSourceFilePath(self.sourceFilePath())
        for definition in copy.parameterDefinitions():
            common.with_last_value(definition)
        return copy

    def displayName(self) -> str:
        return tr(self.name().replace("_", " ").capitalize())  # ``inspect_mosaic`` is ``Inspect mosaic``

    def fromFile(self, path: str) -> bool:
        """Load the model with names, help and group in the user's language."""
        return super().fromFile(path) and self.loadVariant(_translated(self.toVariant()))

    def helpUrl(self) -> str:
        return help_url(self.name())

    def checkParameterValues(self, parameters: dict[str, Any], context: QgsProcessingContext) -> tuple[bool, str]:
        try:
            self._refuse(parameters, context)
        except SeamInspectorError as error:
            return False, sentence(error.message)
        with gdal_silenced():
            return super().checkParameterValues(common.without_rasters(self, parameters), context)

    def prepareAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> bool:
        try:
            self._refuse(parameters, context)
        except SeamInspectorError as error:
            raise _for_qgis(error) from None
        with gdal_silenced():
            return super().prepareAlgorithm(parameters, context, feedback)

    def processAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        with gdal_silenced():
            return dict(super().processAlgorithm(self._with_defaults(parameters), context, feedback))

    def _with_defaults(self, parameters: dict[str, Any]) -> dict[str, Any]:
        """The values with the model's own defaults for those that scripts leave out, where QGIS takes those of its
        steps, and temporary outputs for what is made whether asked for or not."""
        inputs = (definition for definition in self.parameterDefinitions() if not definition.isDestination())
        known = {definition.name(): value for definition in inputs if (value := definition.defaultValue()) is not None}
        needed = dict.fromkeys(self._always_made(), QgsProcessing.TEMPORARY_OUTPUT)
        given = {name: value for name, value in parameters.items() if name not in needed or value is not None}
        return {**known, **needed, **given}

    def _always_made(self) -> Iterator[str]:
        """Names of the model's outputs that are not optional, or that other steps need."""
        for wanted in self.destinationParameterDefinitions():
            if not wanted.flags() & QgsProcessingParameterDefinition.Flag.FlagOptional:
                yield wanted.name()
        steps = self.childAlgorithms()
        taken = {
            (source.outputChildId(), source.outputName())
            for step in steps.values() for several in step.parameterSources().values() for source in several
        }  # fmt: skip
        for step_id, step in steps.items():
            for name, of_model in step.modelOutputs().items():
                if (step_id, of_model.childOutputName()) in taken:
                    yield f"{step_id}:{name}"

    def _refuse(self, parameters: dict[str, Any], context: QgsProcessingContext) -> None:
        """Raise SeamInspectorError for what no step is to be asked for."""
        common.check_rasters(self, parameters)
        common.check_values(self, parameters, context)
        files = [
            definition.name() for definition in self.destinationParameterDefinitions()
            if isinstance(definition, QgsProcessingParameterFileDestination)
        ]  # fmt: skip
        _refused(self, files, parameters, context)


def _refused(
    algorithm: QgsProcessingAlgorithm, named: Iterable[str], parameters: dict[str, Any], context: QgsProcessingContext
) -> Run:
    """The run of the values. Raises SettingsError for what no algorithm takes, and for output files among those named
    whose ending says something else than is written."""
    common.check_files(algorithm, parameters)
    refuse_outputs(algorithm, parameters, context)
    run = Run(algorithm, parameters, context)
    run.check_endings(named)
    return run


def _translated(content: Any, is_help: bool = False) -> Any:
    """A model's content with what people read of it translated."""
    if isinstance(content, dict):
        return {
            key: _translated(value, is_help or key == _HELP) if isinstance(value, dict) or is_help or key == _HELP
            else tr(value) if key in _TITLES and value else value
            for key, value in content.items()
        }  # fmt: skip
    return tr(content) if is_help and isinstance(content, str) and content else content
