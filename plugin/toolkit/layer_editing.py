"""Changes of a layer through its edit buffer: steps that undo takes back, and quiet ones that are no steps."""
from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager

from qgis.core import QgsVectorLayer, QgsVectorLayerEditPassthrough, QgsVectorLayerUndoCommandChangeAttribute

from ..imagery.errors import WindowLayerError
from . import messages


def start_editing(layer: QgsVectorLayer) -> None:
    """Raises WindowLayerError when the layer can't be edited."""
    if layer.readOnly() or not (layer.isEditable() or layer.startEditing()):
        raise WindowLayerError(messages.WINDOW_LAYER_READ_ONLY(name=layer.name()))


@contextmanager
def edit_step(layer: QgsVectorLayer, name: str) -> Iterator[None]:
    """Changes to the layer that are undone together; within another step they are a part of it.

    Raises WindowLayerError when the layer can't be edited.
    """
    start_editing(layer)
    if layer.isEditCommandActive():
        yield
        return
    layer.beginEditCommand(name)
    try:
        yield
    except BaseException:
        layer.destroyEditCommand()
        raise
    layer.endEditCommand()


def change_quietly(layer: QgsVectorLayer, changes: Mapping[int, Mapping[str, object]], name: str) -> None:
    """Change values, by feature id and field, without a step of undo; fields that the layer lacks are left out.

    What undo and redo have in store stays as it is: these are no deeds of the operator. The changes are saved and
    rolled back with the others. Where QGIS writes each change to the database at once they are a step called ``name``.

    Raises WindowLayerError when the layer can't be edited.
    """
    start_editing(layer)
    buffer, fields = layer.editBuffer(), layer.fields()
    found = {fid: [(index, value) for key, value in values.items() if (index := fields.indexOf(key)) >= 0]
             for fid, values in changes.items()}  # fmt: skip
    if isinstance(buffer, QgsVectorLayerEditPassthrough):
        with edit_step(layer, name):
            for fid, values in found.items():
                for index, value in values:
                    layer.changeAttributeValue(fid, index, value)
        return
    added = set(buffer.addedFeatures()) if any(fid < 0 for fid in found) else set()
    for fid, values in found.items():
        if fid < 0 and fid not in added:  # QGIS would look no further
            continue
        for index, value in values:
            QgsVectorLayerUndoCommandChangeAttribute(buffer, fid, index, value, None).redo()
    if not layer.isModified():
        layer.undoStack().resetClean()  # so that QGIS asks before it forgets them
        layer.layerModified.emit()


def forget_quiet_changes(layer: QgsVectorLayer) -> None:
    """After the layer was saved or rolled back: QGIS does it only where there was a step of undo."""
    if layer.undoStack().count() == 0:
        layer.undoStack().setClean()
