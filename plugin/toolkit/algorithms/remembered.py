"""Words that a form offers again the next time: contract, producer, client. Scripts get what they give, and no more."""
from __future__ import annotations

from collections.abc import Iterable

from qgis.core import QgsProcessingParameterDefinition, QgsProcessingParameterString, QgsSettings

from .run import Run

_KEY = "seam_inspector/remembered/{}"


def remembered_text(name: str, title: str) -> QgsProcessingParameterDefinition:
    """A text that may be empty; the form begins with what was given last."""
    return with_last_value(QgsProcessingParameterString(name, title, optional=True))


def with_last_value(definition: QgsProcessingParameterDefinition) -> QgsProcessingParameterDefinition:
    """The parameter, in the form of which stands what was given for its name last, where that is remembered; those of
    models are written small."""
    if last := QgsSettings().value(_KEY.format(definition.name().upper()), ""):
        definition.setGuiDefaultValueOverride(last)
    return definition


def remember(run: Run, names: Iterable[str]) -> None:
    """Keep what was given for these parameters, also where that was nothing; what was not given stays."""
    for name in names:
        if name in run.parameters:
            QgsSettings().setValue(_KEY.format(name), run.text(name))
