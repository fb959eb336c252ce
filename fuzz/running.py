"""Running an algorithm as QGIS does, with all that it says kept."""
from __future__ import annotations

import threading
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from qgis.core import (
    QgsApplication,
    QgsFeatureRequest,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProject,
)

from fuzz import desk

PATIENCE_SECONDS = 25.0
READERS = {desk.NAME: desk.ReadDesk}
"""What reads and is no algorithm of ours."""
ENDINGS = {"sink": ".gpkg", "rasterDestination": ".tif"}


class Log(QgsProcessingFeedback):
    """What an algorithm said, in its order."""

    def __init__(self) -> None:
        super().__init__(False)
        self.errors: list[str] = []
        self.others: list[str] = []

    def reportError(self, error: str, fatalError: bool = False) -> None:
        self.errors.append(error)

    def pushWarning(self, warning: str) -> None:
        self.others.append(warning)

    def pushInfo(self, info: str) -> None:
        self.others.append(info)


@dataclass
class Outcome:
    """How a run ended."""

    worked: bool
    refusal: str = ""
    """Why the values were refused before anything was done."""
    errors: list[str] = field(default_factory=list)
    others: list[str] = field(default_factory=list)

    @property
    def said(self) -> list[str]:
        return [one for one in (self.refusal, *self.errors, *self.others) if one]


def created(name: str) -> QgsProcessingAlgorithm:
    """A new one of our algorithms, or of what reads as one."""
    made = READERS[name]().create() if name in READERS else (
        QgsApplication.processingRegistry().createAlgorithmById(f"seaminspector:{name}")
    )
    assert made is not None, name
    return made


def run(name: str, values: dict[str, Any], checked: bool = True, patience: float = PATIENCE_SECONDS) -> Outcome:
    """Check the values, unless a model would not, and run; cancelled after so many seconds."""
    job, log, context = created(name), Log(), QgsProcessingContext()
    context.setProject(QgsProject.instance())
    context.setInvalidGeometryCheck(QgsFeatureRequest.InvalidGeometryCheck.GeometryAbortOnInvalid)
    if checked:
        acceptable, why = job.checkParameterValues(values, context)
        if not acceptable:
            return Outcome(False, why or "(nothing)", log.errors, log.others)
    stop = threading.Timer(patience, log.cancel)  # what takes long has to heed it
    stop.start()
    try:
        _, worked = job.run(values, context, log)
    finally:
        stop.cancel()
    context.temporaryLayerStore().removeAllMapLayers()
    return Outcome(bool(worked), "", log.errors, log.others)


def outputs(name: str, folder: Path) -> dict[str, str]:
    """A file in a folder for each output."""
    job, made = created(name), {}
    for definition in job.destinationParameterDefinitions():
        ending = ENDINGS.get(definition.type()) or "." + definition.defaultFileExtension()
        made[definition.name()] = str(folder / (definition.name().replace(":", "_") + ending))
    return made
