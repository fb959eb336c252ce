"""From the desk to a decision: the form of an algorithm, filled in with what the desk and its last scan have."""
from __future__ import annotations

from pathlib import Path
from typing import Any

from qgis.core import QgsProject, QgsRasterLayer

from ...toolkit.layers import layer_path
from ..tables.scan_layers import SEAMS, is_picture
from .inputs.project_inputs import Inputs
from .mosaic_scans import worst_layer

DECISION, WHOLE_WAY = "seaminspector:acceptmosaic", "seaminspector:accept_delivery"
"""The decision on a scan, and the way there from the files."""


def offered_form(project: QgsProject, inputs: Inputs) -> tuple[str, dict[str, Any]]:
    """Which algorithm leads to a decision, and what its form begins with."""
    worst = worst_layer(project, inputs.mosaic)
    sources = {"SOURCES": list(inputs.sources), "SOURCE_INDEX": inputs.source_index or None}
    if worst is None or not layer_path(worst):
        return WHOLE_WAY, {
            **{name.lower(): value for name, value in sources.items()}, "seamlines": inputs.seamlines or None
        }
    file = Path(layer_path(worst))
    pictures = (
        layer for layer in project.mapLayers().values()
        if isinstance(layer, QgsRasterLayer) and layer.isValid() and is_picture(layer)
    )  # fmt: skip
    loss = next((layer for layer in pictures if Path(layer.source()).parent == file.parent), None)
    return DECISION, {
        "SEAMS": [f"{file}|layername={SEAMS.name}"], "MOSAIC": [inputs.mosaic], **sources,
        "LOSS": [] if loss is None else [loss.id()], "WINDOWS": inputs.windows or None,
    }  # fmt: skip


def open_form(project: QgsProject, inputs: Inputs) -> None:
    """Show it."""
    import processing

    processing.execAlgorithmDialog(*offered_form(project, inputs))
