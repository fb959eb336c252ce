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

from ...imagery.errors import SettingsError
from ..resources import help_url
from ..translation import sentence
from .overwriting import refuse_overwriting


class ReadyModel(QgsProcessingModelAlgorithm):
    """Its steps know only their own inputs: one step could write over what the model was given for another."""

    def createInstance(self) -> QgsProcessingAlgorithm:
        copy = ReadyModel()
        copy.loadVariant(self.toVariant())
        copy.setProvider(self.provider())
        copy.setSourceFilePath(self.sourceFilePath())
        return copy

    def helpUrl(self) -> str:
        return help_url(self.name())

    def checkParameterValues(self, parameters: dict[str, Any], context: QgsProcessingContext) -> tuple[bool, str]:
        try:
            refuse_overwriting(self, parameters, context)
        except SettingsError as error:
            return False, sentence(error.message)
        return super().checkParameterValues(parameters, context)

    def prepareAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> bool:
        try:
            refuse_overwriting(self, parameters, context)
        except SettingsError as error:
            raise QgsProcessingException(sentence(error.message)) from None
        return super().prepareAlgorithm(parameters, context, feedback)
