"""Running our algorithms as QGIS does: the parameters are checked, the log and the results kept."""
from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any

from qgis.core import (
    NULL,
    QgsApplication,
    QgsFeature,
    QgsFeatureRequest,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingUtils,
    QgsProject,
    QgsVectorLayer,
)


class Log(QgsProcessingFeedback):
    """What an algorithm said."""

    def __init__(self) -> None:
        super().__init__(False)
        self.errors: list[str] = []
        self.warnings: list[str] = []
        self.infos: list[str] = []

    def reportError(self, error: str, fatalError: bool = False) -> None:
        self.errors.append(error)

    def pushWarning(self, warning: str) -> None:
        self.warnings.append(warning)

    def pushInfo(self, info: str) -> None:
        self.infos.append(info)


@dataclass(frozen=True)
class Run:
    """How a run ended."""

    results: dict[str, Any]
    log: Log
    context: QgsProcessingContext
    complaint: str | None = None  # why the algorithm refused the parameters or failed; None when it succeeded

    def close(self) -> None:
        """Let go of its layers: those of a run that tests share would else outlive QGIS, and crash."""
        self.context.temporaryLayerStore().removeAllMapLayers()

    def layer(self, name: str = "OUTPUT") -> QgsVectorLayer:
        """A layer among the results."""
        items = QgsProcessingUtils.mapLayerFromString(self.results[name], self.context)
        assert items is not None
        return items

    def features(self, name: str = "OUTPUT") -> list[QgsFeature]:
        """The features of a layer among the results."""
        return list(self.layer(name).getFeatures())

    def rows(self, name: str = "OUTPUT") -> list[dict[str, Any]]:
        """The attributes of a layer among the results, NULL as None."""
        return [
            {key: None if value == NULL else value for key, value in zip(row.fields().names(), row.attributes())}
            for row in self.features(name)
        ]

    def column(self, field: str, name: str = "OUTPUT") -> list[Any]:
        """The values of one field."""
        return [row[field] for row in self.rows(name)]


def algorithm(name: str) -> QgsProcessingAlgorithm:
    """A new one of our algorithms, from the registry."""
    created = QgsApplication.processingRegistry().createAlgorithmById(f"seaminspector:{name}")
    assert created is not None
    return created


def run(name: str | QgsProcessingAlgorithm, log: Log | None = None, **parameters: Any) -> Run:
    """Check the parameters and run; outputs go to memory unless they are named."""
    job = algorithm(name) if isinstance(name, str) else name
    return _run(job, log or Log(), parameters, checked=True)


def run_unchecked(name: str, log: Log | None = None, **parameters: Any) -> Run:
    """Run without a check of the parameters, as a model does with its steps."""
    return _run(algorithm(name), log or Log(), parameters, checked=False)


def _run(job: QgsProcessingAlgorithm, log: Log, parameters: dict[str, Any], checked: bool) -> Run:
    context = QgsProcessingContext()
    context.setProject(QgsProject.instance())
    context.setInvalidGeometryCheck(QgsFeatureRequest.InvalidGeometryCheck.GeometryAbortOnInvalid)  # as QGIS sets it
    for definition in job.destinationParameterDefinitions():
        parameters.setdefault(definition.name(), "TEMPORARY_OUTPUT")
    if checked:
        acceptable, why = job.checkParameterValues(parameters, context)
        if not acceptable:
            return Run({}, log, context, why)
    results, succeeded = job.run(parameters, context, log)
    return Run(results, log, context, None if succeeded else "\n".join(log.errors))


def assert_refused(name: str, words: str, **parameters: Any) -> None:
    """Both the check of the parameters and a run without it end with one sentence that holds the words (a pattern)."""
    for outcome in (run(name, **parameters), run_unchecked(name, **parameters)):
        assert_sentence(outcome.complaint, words)


def assert_sentence(text: str | None, words: str) -> None:
    """A text is one sentence for the user, no traceback, and holds the words (a pattern)."""
    assert text is not None, "nothing was said"
    assert re.search(words, text), text
    assert "Traceback" not in text
    assert "Error:" not in text.replace("OGR error:", ""), text
    assert "\n" not in text.strip()
    assert text.endswith(".") or text.startswith("Could not "), text  # the latter are QGIS's own
