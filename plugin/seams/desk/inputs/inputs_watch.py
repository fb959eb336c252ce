"""Follows the layers that the inputs name: their data sources, reference systems and, where they count, features."""
from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from qgis.core import QgsMapLayer, QgsProject, QgsVectorLayer
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ....toolkit.desk.widgets import single_shot
from .project_inputs import Inputs

_TOGETHER_MS = 500  # edits that come within this time are one


class InputsWatch(QObject):
    """Tells what may have changed; whether it really has is for others to find out."""

    layersChanged = pyqtSignal()
    """A layer has another data source or reference system; of the windows only the system counts here."""
    indexEdited = pyqtSignal()
    """The features of the source index, or of the seam cells, are others."""
    seamlinesEdited = pyqtSignal()
    """The seamlines are others."""

    def __init__(self, project: QgsProject, parent: QObject) -> None:
        super().__init__(parent)
        self._project = project
        self._followed: tuple[dict[str, QgsMapLayer], str, str, str, str] = ({}, "", "", "", "")
        self._index_timer = single_shot(self, self.indexEdited, _TOGETHER_MS)
        self._seamlines_timer = single_shot(self, self.seamlinesEdited, _TOGETHER_MS)

    def follow(self, inputs: Inputs) -> None:
        """Follow the layers of these inputs that are there, and no others."""
        ids = (inputs.mosaic, *inputs.sources, inputs.source_index, inputs.seamlines, inputs.windows, inputs.cells)
        layers = {layer_id: layer for layer_id in ids if (layer := self._project.mapLayer(layer_id)) is not None}
        followed = layers, inputs.windows, inputs.source_index, inputs.seamlines, inputs.cells
        if followed != self._followed:
            self._let_go()
            self._followed = followed
            for signal, slot in self._signals():
                signal.connect(slot)

    def leave(self, ids: Iterable[str]) -> None:
        """These layers are about to be deleted."""
        if not self._followed[0].keys().isdisjoint(ids):
            self._let_go()

    def close(self) -> None:
        """Let go of all layers and tell nothing more."""
        self._let_go()
        self._index_timer.stop()
        self._seamlines_timer.stop()

    def _let_go(self) -> None:
        for signal, slot in self._signals():
            signal.disconnect(slot)
        self._followed = ({}, "", "", "", "")

    def _signals(self) -> list[tuple[Any, Any]]:
        """Made anew each time: a signal that is kept crashes once its layer is deleted."""
        layers, windows, index, seamlines, cells = self._followed
        return [
            *((layer.dataSourceChanged, self._changed) for name, layer in layers.items() if name != windows),
            *((layer.crsChanged, self._changed) for layer in layers.values()),
            *_edits(layers.get(index), self._index_edited),
            *_edits(layers.get(cells), self._index_edited),
            *_edits(layers.get(seamlines), self._seamlines_edited),
        ]

    def _changed(self, *_: object) -> None:
        self.layersChanged.emit()

    def _index_edited(self, *_: object) -> None:
        self._index_timer.start()

    def _seamlines_edited(self, *_: object) -> None:
        self._seamlines_timer.start()


def _edits(layer: QgsMapLayer | None, slot: Any) -> list[tuple[Any, Any]]:
    """All that can change a layer's features; the edit buffer counts."""
    if not isinstance(layer, QgsVectorLayer):
        return []
    signals = (
        layer.featureAdded, layer.featureDeleted, layer.geometryChanged, layer.attributeValueChanged,
        layer.afterCommitChanges, layer.afterRollBack, layer.dataChanged, layer.subsetStringChanged,
    )  # fmt: skip
    return [(signal, slot) for signal in signals]
