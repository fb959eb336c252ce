"""From the desk to a decision: what the desk and the project's scans have for it, and the form of its algorithm.

What it makes is signed, handed on or kept with the delivery: the form suggests files for it beside the project.
"""
from __future__ import annotations

import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
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
from qgis.gui import QgsProcessingAlgorithmDialogBase

from ...imagery.atomic_files import unfinished_name
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
_in_forms: dict[int, dict[str, str]] = {}
"""Suggestions by form, of forms that are open or whose runs go on."""


@dataclass(frozen=True)
class DeliveredScan:
    """The last scan of a mosaic of the project."""

    words: str
    """What its mosaic is called."""
    mosaic: str
    """Id of the mosaic's layer."""
    seams: str
    """Its pieces of seam, as QGIS opens them."""
    loss: str
    """Id of its picture of losses; empty where the project has none."""


def delivered_scans(project: QgsProject, first: str) -> list[DeliveredScan]:
    """Scans of the project's mosaics, that of the mosaic ``first`` first."""
    found = []
    rasters = [one for one in project.mapLayers().values() if isinstance(one, QgsRasterLayer) and one.isValid()]
    for mosaic in sorted(rasters, key=lambda one: (one.id() != first, one.name())):
        worst = worst_layer(project, mosaic.id())
        if worst is not None and layer_path(worst):
            file = Path(layer_path(worst))
            loss = next((one for one in rasters if Path(one.source()).parent == file.parent and is_picture(one)), None)
            seams = f"{file}|layername={SEAMS.name}"
            found.append(DeliveredScan(mosaic.name(), mosaic.id(), seams, "" if loss is None else loss.id()))
    return found


def decision_values(inputs: Inputs, scans: Sequence[DeliveredScan]) -> dict[str, Any]:
    """What a decision on scans begins with, but for its outputs."""
    return {
        "SEAMS": [scan.seams for scan in scans], "MOSAIC": [scan.mosaic for scan in scans],
        "SOURCES": list(inputs.sources), "SOURCE_INDEX": inputs.source_index or None,
        "LOSS": [scan.loss for scan in scans if scan.loss], "WINDOWS": inputs.windows or None,
    }


def offered_form(
    project: QgsProject, inputs: Inputs, values: Mapping[str, Any] | None = None
) -> tuple[str, dict[str, Any]]:
    """Which algorithm leads to a decision, and what its form begins with; ``values``: those of a decision on scans."""
    own = [scan for scan in delivered_scans(project, inputs.mosaic) if scan.mosaic == inputs.mosaic]
    if values is None and own:
        values = decision_values(inputs, own)
    if values is not None:
        return DECISION, {**values, **suggested_files(DECISION, project, inputs)}
    return WHOLE_WAY, {
        "sources": list(inputs.sources), "source_index": inputs.source_index or None,
        "seamlines": inputs.seamlines or None, **suggested_files(WHOLE_WAY, project, inputs),
    }


def open_form(project: QgsProject, inputs: Inputs, values: Mapping[str, Any] | None = None) -> None:
    """Show it."""
    form = made_form(project, inputs, values)
    if form is not None:
        form.show()  # shown before, it does not lock QGIS
        form.exec()
        form.close()  # it goes once its run is over


def made_form(
    project: QgsProject, inputs: Inputs, given: Mapping[str, Any] | None = None
) -> QgsProcessingAlgorithmDialogBase | None:
    """The form, which gives what it makes new names once a run has used them. None without the algorithm."""
    import processing

    name, values = offered_form(project, inputs, given)
    form = processing.createAlgorithmDialog(name, values)
    if form is None:
        return None
    outputs = [one.name() for one in form.algorithm().destinationParameterDefinitions()]
    key = id(form)

    def name_anew(is_successful: bool, results: dict[str, Any]) -> None:
        made = {one: Path(str(results.get(one) or "")) for one in outputs}
        if is_successful:
            renamed = _unused({one: file for one, file in made.items() if file.is_file()})
            _in_forms.setdefault(key, {}).update(renamed)
            form.setParameters(renamed)

    _in_forms[key] = {one: values[one] for one in outputs if one in values}
    form.algorithmFinished.connect(name_anew)
    form.destroyed.connect(lambda: _in_forms.pop(key, None))
    return form


def suggested_files(name: str, project: QgsProject, inputs: Inputs) -> dict[str, str]:
    """Files for what an algorithm makes, beside the project; where that has none, beside the scan, else the mosaic.

    All have one number, by which none of them takes the place of an earlier one.
    """
    algorithm = QgsApplication.processingRegistry().createAlgorithmById(name)
    mosaic, worst = _mosaic_file(project, inputs), worst_layer(project, inputs.mosaic)
    scan = Path(layer_path(worst)) if worst is not None and layer_path(worst) else None
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
    return _unused({one.name(): folder / f"{stem}_{_called(one)}" for one in wanted})


def _called(output: QgsProcessingParameterDefinition) -> str:
    """``failures.gpkg``: failures have notes and pictures beside them, which not every format of features takes."""
    is_layer = isinstance(output, QgsProcessingParameterFeatureSink)
    ending = "gpkg" if is_layer else output.defaultFileExtension()
    return f"{output.name().rpartition(':')[2].lower()}.{ending}"


def _unused(files: Mapping[str, Path]) -> dict[str, str]:
    """The files, all counted on until none of them is there, being written, or in a form."""
    for more in count():
        counted = {output: _counted_on(file, more) for output, file in files.items()}
        if not any(map(_is_taken, counted.values())):
            break
    return {output: str(file) for output, file in counted.items()}


def _counted_on(file: Path, more: int) -> Path:
    """``report_2.html`` after ``report.html``; four digits are a year."""
    stem, number = re.fullmatch(r"(.*?)(?:_(\d{1,3}))?", file.stem, re.DOTALL).groups()  # type: ignore[union-attr]
    return file.with_name(f"{stem}_{int(number or 1) + more}{file.suffix}") if more else file


def _is_taken(file: Path) -> bool:
    pictures = file.with_name(f"{file.stem}_pictures")
    being_written = chain.from_iterable(file.parent.glob(f"{unfinished_name(one)}*") for one in (file, pictures))
    in_forms = chain.from_iterable(suggested.values() for suggested in _in_forms.values())
    return os.path.lexists(file) or os.path.lexists(pictures) or any(being_written) or str(file) in in_forms


def _mosaic_file(project: QgsProject, inputs: Inputs) -> Path | None:
    """None for one that is no file of this machine."""
    layer = project.mapLayer(inputs.mosaic)
    try:
        path = local_file(layer_ref(layer).path) if isinstance(layer, QgsRasterLayer) else ""
    except RasterError:
        return None
    return Path(path) if path and os.path.isfile(path) else None
