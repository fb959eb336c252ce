"""Which windows are selected, told to the map's style as a variable."""
from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.gui import QgsMapCanvas

if TYPE_CHECKING:
    from ..session import Session

SELECTED = "seam_inspector_selected"
"""Of the map: its keys are a layer's id and a feature's, with a space between (resources/styles/windows.qml)."""


class SelectedWindows:
    """Keeps the variable until ``close``.

    The style does not ask ``is_selected()``: that looks into the layer from the threads that draw the map, and QGIS
    before 3.30 crashes when another window is selected, or the layer goes, while they do.
    """

    def __init__(self, canvas: QgsMapCanvas, session: Session) -> None:
        self._canvas, self._session = canvas, session
        session.selectionChanged.connect(self._tell)
        session.windowsChanged.connect(self._tell)  # equal ids of another layer, too
        self._tell()

    def close(self) -> None:
        """Take the variable away."""
        self._session.selectionChanged.disconnect(self._tell)
        self._session.windowsChanged.disconnect(self._tell)
        self._canvas.expressionContextScope().removeVariable(SELECTED)

    def _tell(self) -> None:
        layer = self._session.window_layer()
        keys = {f"{layer.id()} {fid}": True for fid in self._session.selected()} if layer is not None else {}
        self._canvas.expressionContextScope().setVariable(SELECTED, keys)
