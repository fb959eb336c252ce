"""Where things are kept that go with a window layer: beside its file, under the file's name."""
from __future__ import annotations

from pathlib import Path

from qgis.core import QgsProviderRegistry, QgsVectorLayer

from ....toolkit import layers as layers

UNSAVED, RESULTS = ".unsaved", ".results"
"""What comes after the name of a layer's file: for what is not saved in it yet, and for the results of its windows."""


def path_beside(layer: QgsVectorLayer, ending: str) -> Path | None:
    """The file that goes with a layer; None for a layer that has none itself."""
    path = Path(layers.layer_path(layer) or ".")
    if not path.is_file():
        return None
    name = QgsProviderRegistry.instance().decodeUri("ogr", layer.source()).get("layerName") or path.stem
    part = "" if name == path.stem else f".{name}"
    return path.with_name(f"{path.name}{part}{ending}")
