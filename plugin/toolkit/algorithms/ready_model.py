"""A ready model of resources/models, which keeps its inputs as the algorithms do."""
from __future__ import annotations

from typing import Any

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeedback,
    QgsProcessingModelAlgorithm,
)

from ...imagery.errors import SeamInspectorError
from ...imagery.gdal_calls import gdal_silenced
from ..resources import help_url
from ..translation import sentence, tr
from .outputs import refuse_impossible, refuse_overwriting
from .parameters import check_files, check_rasters, without_rasters

_TITLES, _HELP = ("description", "component_description", "model_group"), "help"


class ReadyModel(QgsProcessingModelAlgorithm):
    """Its steps know only their own inputs: one step could write over what the model was given for another."""

    def createInstance(self) -> QgsProcessingAlgorithm:
        copy = ReadyModel()
        copy.loadVariant(self.toVariant())
        copy.setProvider(self.provider())
        copy.setSourceFilePath(self.sourceFilePath())
        return copy

    def displayName(self) -> str:
        return tr(model_title(self.name()))

    def fromFile(self, path: str) -> bool:
        """In the user's language: names, help and the group."""
        return super().fromFile(path) and self.loadVariant(_translated(self.toVariant()))

    def helpUrl(self) -> str:
        return help_url(self.name())

    def checkParameterValues(self, parameters: dict[str, Any], context: QgsProcessingContext) -> tuple[bool, str]:
        try:
            self._refuse(parameters, context)
        except SeamInspectorError as error:
            return False, sentence(error.message)
        with gdal_silenced():
            return super().checkParameterValues(without_rasters(self, parameters), context)

    def prepareAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> bool:
        try:
            self._refuse(parameters, context)
        except SeamInspectorError as error:
            raise QgsProcessingException(sentence(error.message)) from None
        with gdal_silenced():
            return super().prepareAlgorithm(parameters, context, feedback)

    def processAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        with gdal_silenced():
            return dict(super().processAlgorithm(parameters, context, feedback))

    def _refuse(self, parameters: dict[str, Any], context: QgsProcessingContext) -> None:
        """Raise SeamInspectorError for what no step is to be asked for."""
        refuse_impossible(self, parameters, context)
        check_files(self, parameters)
        check_rasters(self, parameters)
        refuse_overwriting(self, parameters, context)


def model_title(name: str) -> str:
    """What a model is called in the toolbox: ``inspect_mosaic`` is ``Inspect mosaic``."""
    return name.replace("_", " ").capitalize()


def _translated(content: Any, is_help: bool = False) -> Any:
    """A model's content with what people read of it translated."""
    if isinstance(content, dict):
        return {
            key: _translated(value, is_help or key == _HELP) if isinstance(value, dict) or is_help or key == _HELP
            else tr(value) if key in _TITLES and value else value
            for key, value in content.items()
        }  # fmt: skip
    return tr(content) if is_help and isinstance(content, str) and content else content
