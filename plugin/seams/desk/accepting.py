"""From the desk to a decision: what the desk and the project's scans have for it, and files for what it makes.

That is signed, handed on or kept with the delivery: it lies beside the project.
"""
from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import count
from pathlib import Path
from typing import Any

from qgis.core import (
    QgsApplication,
    QgsProject,
    QgsRasterLayer,
)

from ...imagery.errors import RasterError
from ...imagery.gdal_paths import local_file
from ...toolkit.layers import layer_path, layer_ref
from ..tables.scan_layers import SEAMS, is_picture
from .inputs.project_inputs import Inputs
from .mosaic_scans import file_stem, worst_layer

DECISION = "seaminspector:acceptmosaic"
_FILES = {"REPORT": "report.html", "DEFECTS": "defects.gpkg", "QUALITY": "quality.xml"}
"""What a decision makes; failures have notes and pictures beside them, which not every format of features takes."""


@dataclass(frozen=True)
class DeliveredScan:
    """The last scan of a mosaic of the project."""

    words: str  # what its mosaic is called
    mosaic: str  # id of the mosaic's layer
    seams: str  # its pieces of seam, as QGIS opens them
    loss: str  # id of its picture of losses; empty where the project has none


def delivered_scans(project: QgsProject, first: str) -> list[DeliveredScan]:
    """Scans of the project's mosaics, that of the mosaic ``first`` first."""
    scans = []
    rasters = [layer for layer in project.mapLayers().values() if isinstance(layer, QgsRasterLayer) and layer.isValid()]
    for mosaic in sorted(rasters, key=lambda raster: (raster.id() != first, raster.name())):
        worst = worst_layer(project, mosaic.id())
        if worst is not None and layer_path(worst):
            file = Path(layer_path(worst))
            beside = (raster for raster in rasters if Path(raster.source()).parent == file.parent)
            loss = next(filter(is_picture, beside), None)
            seams = f"{file}|layername={SEAMS.name}"
            scans.append(DeliveredScan(mosaic.name(), mosaic.id(), seams, "" if loss is None else loss.id()))
    return scans


def decision_values(inputs: Inputs, scans: Sequence[DeliveredScan]) -> dict[str, Any]:
    """What a decision on scans begins with, but for its outputs."""
    return {
        "SEAMS": [scan.seams for scan in scans], "MOSAIC": [scan.mosaic for scan in scans],
        "SOURCES": list(inputs.sources), "SOURCE_INDEX": inputs.source_index or None,
        "LOSS": [scan.loss for scan in scans if scan.loss], "WINDOWS": inputs.windows or None,
    }


def suggested_files(project: QgsProject, inputs: Inputs) -> dict[str, str]:
    """Files for what a decision makes, beside the project; where that has none, beside the scan, else the mosaic.

    All have one number, by which none of them takes the place of an earlier one.
    """
    mosaic, worst = _mosaic_file(project, inputs), worst_layer(project, inputs.mosaic)
    scan = Path(layer_path(worst)) if worst is not None and layer_path(worst) else None
    profile = Path(QgsApplication.qgisSettingsDirPath())  # where scans of projects without a file lie, and nobody looks
    beside = [file.parent for file in (scan, mosaic) if file is not None and file.parent != profile]
    places = [*([Path(project.homePath())] if project.homePath() else ()), *beside, Path.home()]
    folder = next((place for place in places if place.is_dir() and os.access(place, os.W_OK)), None)
    stem = file_stem(project.baseName() or "delivery" if mosaic is None else mosaic.name)
    return {} if folder is None else _unused({name: folder / f"{stem}_{file}" for name, file in _FILES.items()})


def _unused(files: Mapping[str, Path]) -> dict[str, str]:
    """The files, all with the first number by which none of them is there, nor its pictures: ``report_2.html``."""
    for number in count(1):
        ending = f"_{number}" if number > 1 else ""
        counted = {output: file.with_name(f"{file.stem}{ending}{file.suffix}") for output, file in files.items()}
        there = (os.path.lexists(path) for file in counted.values() for path in (file, pictures_beside(file)))
        if not any(there):
            break
    return {output: str(file) for output, file in counted.items()}


def pictures_beside(failures: Path) -> Path:
    """The folder with the pictures of a layer of failures."""
    return failures.with_name(f"{failures.stem}_pictures")


def _mosaic_file(project: QgsProject, inputs: Inputs) -> Path | None:
    """None for one that is no file of this machine."""
    layer = project.mapLayer(inputs.mosaic)
    try:
        path = local_file(layer_ref(layer).path) if isinstance(layer, QgsRasterLayer) else ""
    except RasterError:
        return None
    return Path(path) if path and os.path.isfile(path) else None
