"""A layer combo box that can show a layer that vanished, and tells the operator's choices from its own."""
from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

from qgis.core import QgsProject, QgsProviderRegistry, QgsVectorLayer
from qgis.gui import QgsMapLayerComboBox
from qgis.PyQt.QtCore import pyqtSignal
from qgis.PyQt.QtGui import QDropEvent
from qgis.PyQt.QtWidgets import QWidget

from ..translation import filled, tr
from ..version_differences import layer_filters

_UUID = re.compile(r"_[0-9a-f]{8}(_[0-9a-f]{4}){3}_[0-9a-f]{12}$")  # what QGIS hangs on a name to make it an id


def missing_text(layer_id: str) -> str:
    """Text for a layer that is not in the project: by the name it had when it was loaded."""
    return filled(tr("missing: {name}"), name=_UUID.sub("", layer_id))


def vectors_without(field: str) -> list[QgsVectorLayer]:
    """The project's vector layers that lack a field."""
    layers = QgsProject.instance().mapLayers().values()
    return [layer for layer in layers if isinstance(layer, QgsVectorLayer) and field not in layer.fields().names()]


class LayerBox(QgsMapLayerComboBox):
    """Layers of the project, none, or one that is missing.

    When its layer is removed the base class goes on to the next one and emits ``layerChanged`` as for a choice.
    """

    chosen = pyqtSignal(str)  # the operator chose a layer, by its id, or none

    def __init__(self, filters: Any, nothing: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFilters(layer_filters(filters))
        self.setAllowEmptyLayer(True, nothing)
        self.setMinimumContentsLength(8)  # a long name must not widen the dock
        self.setSizeAdjustPolicy(self.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self._left_out: set[str] = set()
        self._missing = ""  # the last item, which stands for a layer that can't be chosen
        self.activated.connect(self._tell)

    def show_layer(self, layer_id: str) -> None:
        """Show a layer by its id, whether it is there or not."""
        layer = QgsProject.instance().mapLayer(layer_id) if layer_id else None
        self._show_missing(missing_text(layer_id) if layer_id and layer is None else "")
        if layer is not None:
            self.setLayer(layer)
            if self.currentLayer() is not layer:
                self._show_missing(filled(tr("can't be used: {name}"), name=layer.name()))
        elif not layer_id:
            self.setCurrentIndex(0)

    def leave_out(self, layers: Sequence[QgsVectorLayer]) -> None:
        """Offer these layers no more."""
        ids = {layer.id() for layer in layers}
        if ids != self._left_out:
            self._left_out = ids
            self.setExceptedLayerList(list(layers))

    def only_files(self) -> None:
        """Offer only rasters that GDAL reads: pixels from a service can't be measured."""
        self.setExcludedProviders([name for name in QgsProviderRegistry.instance().providerList() if name != "gdal"])

    def dropEvent(self, event: QDropEvent) -> None:
        super().dropEvent(event)
        self._tell()

    def _show_missing(self, text: str) -> None:
        if text != self._missing:
            self._missing = text
            self.setAdditionalItems([text] if text else [])
        if text:
            self.setCurrentIndex(self.count() - 1)

    def _tell(self, *_: object) -> None:
        layer = self.currentLayer()
        if layer is not None:
            self.chosen.emit(layer.id())
        elif self.currentIndex() == 0:
            self.chosen.emit("")
