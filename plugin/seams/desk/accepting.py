"""From the desk to a decision: the form of an algorithm, filled in with what the desk and its last scan have.

What it makes is signed, handed on or kept with the delivery: the form suggests files for it beside the project.
"""
from __future__ import annotations

import os
import re
from collections.abc import Mapping
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
    form = made_form(project, inputs)
    if form is not None:
        form.show()  # shown before, it does not lock QGIS
        form.exec()
        form.close()  # it goes once its run is over


def made_form(project: QgsProject, inputs: Inputs) -> QgsProcessingAlgorithmDialogBase | None:
    """The form, which gives what it makes new names once a run has used them. None without the algorithm."""
    import processing

    name, values = offered_form(project, inputs)
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
