"""From the desk to a decision: the form of an algorithm, filled in with what the desk and its last scan have.

What it makes is signed, handed on or kept with the delivery: the form suggests files for it beside the project.
"""
from __future__ import annotations

import os
from itertools import chain, count
from pathlib import Path
from typing import Any

from qgis.core import (
    QgsApplication,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterRasterDestination,
    QgsProject,
    QgsRasterLayer,
)

from ...imagery.errors import RasterError
from ...imagery.gdal_paths import local_file
from ...toolkit.layers import layer_path, layer_ref
from ..tables.scan_layers import SEAMS, is_picture
from .inputs.project_inputs import Inputs
from .mosaic_scans import file_stem, worst_layer

DECISION, WHOLE_WAY = "seaminspector:acceptmosaic", "seaminspector:accept_delivery"
"""The decision on a scan, and the way there from the files."""
_RECORD = "quality"
"""Ends the name of the output that the form makes only when it is asked for, and the catalogue takes."""


def offered_form(project: QgsProject, inputs: Inputs) -> tuple[str, dict[str, Any]]:
    """Which algorithm leads to a decision, and what its form begins with."""
    worst = worst_layer(project, inputs.mosaic)
    sources = {"SOURCES": list(inputs.sources), "SOURCE_INDEX": inputs.source_index or None}
    mosaic = _mosaic_file(project, inputs)
    if worst is None or not layer_path(worst):
        return WHOLE_WAY, {
            **{name.lower(): value for name, value in sources.items()}, "seamlines": inputs.seamlines or None,
            **_suggested(WHOLE_WAY, project, mosaic, mosaic),
        }  # fmt: skip
    file = Path(layer_path(worst))
    pictures = (
        layer for layer in project.mapLayers().values()
        if isinstance(layer, QgsRasterLayer) and layer.isValid() and is_picture(layer)
    )  # fmt: skip
    loss = next((layer for layer in pictures if Path(layer.source()).parent == file.parent), None)
    return DECISION, {
        "SEAMS": [f"{file}|layername={SEAMS.name}"], "MOSAIC": [inputs.mosaic], **sources,
        "LOSS": [] if loss is None else [loss.id()], "WINDOWS": inputs.windows or None,
        **_suggested(DECISION, project, mosaic, file),
    }  # fmt: skip


def open_form(project: QgsProject, inputs: Inputs) -> None:
    """Show it."""
    import processing

    processing.execAlgorithmDialog(*offered_form(project, inputs))


def _suggested(name: str, project: QgsProject, mosaic: Path | None, scan: Path | None) -> dict[str, str]:
    """Files for what the form makes, beside the project; where that has none, beside the ``scan``, else the mosaic.

    All have one number, by which none of them takes the place of an earlier one.
    """
    algorithm = QgsApplication.processingRegistry().createAlgorithmById(name)
    profile = Path(QgsApplication.qgisSettingsDirPath())  # where scans of projects without a file lie, and nobody looks
    beside = [one.parent for one in (scan, mosaic) if one is not None and one.parent != profile]
    places = [*([Path(project.homePath())] if project.homePath() else ()), *beside, Path.home()]
    folder = next((one for one in places if one.is_dir() and os.access(one, os.W_OK)), None)
    if algorithm is None or folder is None:
        return {}
    stem = file_stem(project.baseName() or "delivery" if mosaic is None else mosaic.name)
    wanted = [
        one for one in algorithm.destinationParameterDefinitions()
        if (one.createByDefault() or one.name().lower().endswith(_RECORD))
        # among its sheets a picture of losses would be taken for one that nobody ordered
        and not (isinstance(one, QgsProcessingParameterRasterDestination) and mosaic and folder == mosaic.parent)
    ]
    for number in chain([""], (f"_{number}" for number in count(2))):
        files = {one.name(): folder / f"{stem}_{_called(one, number)}" for one in wanted}
        beside_them = [file.with_name(f"{file.stem}_pictures") for file in files.values()]
        if not any(map(os.path.lexists, (*files.values(), *beside_them))):
            break
    return {output: str(file) for output, file in files.items()}


def _called(output: QgsProcessingParameterDefinition, number: str) -> str:
    """``failures_2.gpkg``: failures have notes and pictures beside them, which not every format of features takes."""
    is_layer = isinstance(output, QgsProcessingParameterFeatureSink)
    ending = "gpkg" if is_layer else output.defaultFileExtension()
    return f"{output.name().rpartition(':')[2].lower()}{number}.{ending}"


def _mosaic_file(project: QgsProject, inputs: Inputs) -> Path | None:
    """None for one that is no file of this machine."""
    layer = project.mapLayer(inputs.mosaic)
    try:
        path = local_file(layer_ref(layer).path) if isinstance(layer, QgsRasterLayer) else ""
    except RasterError:
        return None
    return Path(path) if path and os.path.isfile(path) else None
