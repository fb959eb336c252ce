"""Widgets of ``qgis.gui`` as the widgets of Qt that they stand on, and names of the others."""
from __future__ import annotations

from qgis.PyQt.QtCore import pyqtSignal
from qgis.PyQt.QtGui import QKeyEvent
from qgis.PyQt.QtWidgets import (
    QComboBox,
    QDockWidget,
    QDoubleSpinBox,
    QGraphicsItem,
    QGraphicsView,
    QGroupBox,
    QLineEdit,
    QSpinBox,
    QTreeView,
    QWidget,
)

from .placeholders import placeholder


class QgsCollapsibleGroupBoxBasic(QGroupBox):
    collapsedStateChanged = pyqtSignal(bool)
    _is_collapsed = False

    def setCollapsed(self, collapsed: bool) -> None:
        self._is_collapsed = collapsed
        self.collapsedStateChanged.emit(collapsed)

    def isCollapsed(self) -> bool:
        return self._is_collapsed


class QgsFilterLineEdit(QLineEdit):
    def setShowSearchIcon(self, visible: bool) -> None:
        pass

    def setShowClearButton(self, visible: bool) -> None:
        pass


class QgsDockWidget(QDockWidget):
    pass


class QgsSpinBox(QSpinBox):
    def setClearValue(self, value: int) -> None:
        pass

    def setShowClearButton(self, shown: bool) -> None:
        pass


class QgsDoubleSpinBox(QDoubleSpinBox):
    def setClearValue(self, value: float) -> None:
        pass

    def setShowClearButton(self, shown: bool) -> None:
        pass


class QgsMapCanvas(QGraphicsView):
    keyPressed = pyqtSignal(object)
    keyReleased = pyqtSignal(object)

    def mapTool(self) -> None:
        return None

    def keyPressEvent(self, event: QKeyEvent) -> None:
        self.keyPressed.emit(event)

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        self.keyReleased.emit(event)


class QgsMapCanvasItem(QGraphicsItem):
    pass


_BASES = {
    "QgsMapLayerComboBox": QComboBox, "QgsFieldComboBox": QComboBox, "QgsLayerTreeView": QTreeView,
    "QgsMessageBar": QWidget, "QgsMessageBarItem": QWidget,
}  # fmt: skip


def __getattr__(name: str) -> type:
    if not name.startswith(("Qgs", "Qgis")):
        raise AttributeError(name)
    made = placeholder(name, _BASES.get(name, object))
    globals()[name] = made
    return made
