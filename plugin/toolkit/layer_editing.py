"""Changes of a layer through its edit buffer, so that undo takes them back."""
from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from qgis.core import QgsVectorLayer

from ..imagery.errors import WindowLayerError
from . import messages


def start_editing(layer: QgsVectorLayer) -> None:
    """Raises WindowLayerError when the layer can't be edited."""
    if layer.readOnly() or not (layer.isEditable() or layer.startEditing()):
        raise WindowLayerError(messages.WINDOW_LAYER_READ_ONLY(name=layer.name()))


@contextmanager
def edit_step(layer: QgsVectorLayer, name: str) -> Iterator[None]:
    """Changes to the layer that are undone together. Raises WindowLayerError when it can't be edited."""
    start_editing(layer)
    layer.beginEditCommand(name)
    try:
        yield
    except BaseException:
        layer.destroyEditCommand()
        raise
    layer.endEditCommand()
