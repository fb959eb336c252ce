"""The base of all our algorithms: names, help, and errors as one clear sentence.

Their groups in the toolbox are here too; each name, not translated, is its group's id.
"""
from __future__ import annotations

import sys
from collections.abc import Mapping
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


class _Checked:
    """What our algorithms and models share: their help, and values that are refused by one clear sentence."""

    def helpUrl(self: Any) -> str:
        return help_url(self.name())

    def prepareAlgorithm(
        self: Any, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> bool:
        try:
            with gdal_silenced():
                self._refuse(parameters, context)  # models and scripts may not have checked the values
                self.prepare_run(Run(self, parameters, context, feedback))
                return bool(super().prepareAlgorithm(parameters, context, feedback))  # type: ignore[misc]
        except SeamInspectorError as error:
            raise _for_qgis(error) from None

    def checkParameterValues(self: Any, parameters: dict[str, Any], context: QgsProcessingContext) -> tuple[bool, str]:
        try:
            with gdal_silenced():
                self.check(self._refuse(parameters, context))
                return super().checkParameterValues(self.for_check(parameters), context)  # type: ignore[misc]
        except SeamInspectorError as error:
            return False, sentence(error.message)
        except QgsProcessingException as error:
            return False, str(error)

    def check(self, run: Run) -> None:
        """Raise SeamInspectorError for values that QGIS's own check would refuse without saying why."""

    def prepare_run(self, run: Run) -> None:
        """Take from layers what the work needs of them, in plain data: this runs in their thread, the work may not."""

    def for_check(self: Any, parameters: dict[str, Any]) -> dict[str, Any]:
        """The values for QGIS's own check."""
        return common.without_layers(self, parameters)

    def _refuse(self: Any, parameters: dict[str, Any], context: QgsProcessingContext) -> Run:
        """The run of the values, to be looked at further. Raises SeamInspectorError for what no algorithm takes."""
        common.check_values(self, self.for_check(parameters), context)
        common.check_files(self, parameters)
        refuse_outputs(self, parameters, context)
        return Run(self, parameters, context)


class SeamInspectorAlgorithm(_Checked, QgsProcessingAlgorithm):
    """An algorithm says its id, names and help in class attributes and does its work in ``execute``."""

    ID: str
    NAME: str
    GROUP = SEAM_INSPECTION
    HELP: str
    DRAWN: tuple[str, ...] = (common.CHART, common.REPORT)  # outputs with charts, which need matplotlib
    PAGES: tuple[str, ...] = (common.REPORT,)  # outputs that are made from templates, likewise

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
        for name, title in titles.items():
            self.addOutput(QgsProcessingOutputNumber(name, title))

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

    def execute(self, run: Run) -> dict[str, Any]:
        """The work; raises SeamInspectorError for what the user can mend. A result that there is not may be None."""
        raise NotImplementedError

    def _refuse(self, parameters: dict[str, Any], context: QgsProcessingContext) -> Run:
        charts, pages = (any(parameters.get(name) for name in names) for names in (self.DRAWN, self.PAGES))
        if missing := missing_packages_sentence(charts, pages):
            raise QgsProcessingException(missing)
        return super()._refuse(parameters, context)


def _for_qgis(error: SeamInspectorError) -> QgsProcessingException:
    """The exception for QGIS, which never lets go of one: frames that hang on it would keep parameters of models, which
    are deleted, and whatever QGIS makes in their place later would be taken for them, and crash."""
    error.with_traceback(None).__context__ = None
    return QgsProcessingException(sentence(error.message))


_TITLES, _HELP = ("description", "component_description", "model_group"), "help"


class ReadyModel(_Checked, QgsProcessingModelAlgorithm):
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

    def processAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        with gdal_silenced():
            return dict(super().processAlgorithm(self._with_defaults(parameters), context, feedback))

    def _with_defaults(self, parameters: dict[str, Any]) -> dict[str, Any]:
        """The values with the model's own defaults for those that scripts leave out, where QGIS takes those of its
        steps, and temporary outputs for what other steps need."""
        inputs = (definition for definition in self.parameterDefinitions() if not definition.isDestination())
        known = {definition.name(): value for definition in inputs if (value := definition.defaultValue()) is not None}
        steps = self.childAlgorithms()
        taken = {
            (source.outputChildId(), source.outputName())
            for step in steps.values() for several in step.parameterSources().values() for source in several
        }  # fmt: skip
        needed = {
            f"{step_id}:{name}": QgsProcessing.TEMPORARY_OUTPUT
            for step_id, step in steps.items() for name, output in step.modelOutputs().items()
            if (step_id, output.childOutputName()) in taken
        }  # fmt: skip
        given = {name: value for name, value in parameters.items() if name not in needed or value is not None}
        return {**known, **needed, **given}

    def _refuse(self, parameters: dict[str, Any], context: QgsProcessingContext) -> Run:
        common.check_rasters(self, parameters)
        return super()._refuse(parameters, context)


def _translated(content: Any, is_text: bool = False) -> Any:
    """A model's content with what people read of it translated: all of its help, and titles."""
    if isinstance(content, dict):
        texts = {key for key, value in content.items() if key == _HELP or (key in _TITLES and isinstance(value, str))}
        return {key: _translated(value, is_text or key in texts) for key, value in content.items()}
    return tr(content) if is_text and isinstance(content, str) and content else content
