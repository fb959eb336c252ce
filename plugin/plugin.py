"""Wires the plugin into QGIS and out again."""
from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.core import Qgis, QgsApplication
from qgis.gui import QgisInterface
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtGui import QIcon
from qgis.PyQt.QtWidgets import QAction

from .adapters.packages import missing_packages_sentence
from .adapters.resources import icon_path
from .adapters.text import Translation, tr
from .processing.provider import SeamInspectorProvider

if TYPE_CHECKING:
    from .gui.bar_dock import BarDock
    from .gui.dock import InspectionDock


class SeamInspectorPlugin:
    """What QGIS loads and unloads."""

    def __init__(self, iface: QgisInterface | None) -> None:
        self._iface = iface
        self._provider: SeamInspectorProvider | None = None
        self._translation = Translation()
        self._action: QAction | None = None
        self._dock: InspectionDock | None = None
        self._bar_action: QAction | None = None
        self._bar_dock: BarDock | None = None

    def initProcessing(self) -> None:
        """Register the provider; all that qgis_process asks for, which has no interface."""
        if self._provider is None:
            self._provider = SeamInspectorProvider()
            QgsApplication.processingRegistry().addProvider(self._provider)

    def initGui(self) -> None:
        assert self._iface is not None
        self.initProcessing()
        self._action = QAction(QIcon(icon_path()), tr("Seam Inspector"), self._iface.mainWindow())
        self._action.setObjectName("seamInspectorAction")
        self._action.setToolTip(tr("Inspect how much detail a mosaic kept along its seams"))
        self._action.setCheckable(True)
        self._action.triggered.connect(self._show_dock)
        self._iface.addRasterToolBarIcon(self._action)
        # not by addPluginToRasterMenu: it makes a menu of one entry, and QGIS keeps that after the entry is removed
        self._iface.rasterMenu().addAction(self._action)
        self._bar_action = QAction(QIcon(icon_path("bar_group")), tr("Bar groups"), self._iface.mainWindow())
        self._bar_action.setObjectName("seamInspectorBarAction")
        self._bar_action.setToolTip(tr("Draw lines across the groups of a bar target and watch their profiles"))
        self._bar_action.setCheckable(True)
        self._bar_action.triggered.connect(self._show_bar_dock)
        self._iface.addRasterToolBarIcon(self._bar_action)
        self._iface.rasterMenu().addAction(self._bar_action)

    def unload(self) -> None:
        if self._iface is not None and self._dock is not None:
            self._dock.visibilityChanged.disconnect(self._dock_shown)
            self._dock.close_desk()
            self._iface.removeDockWidget(self._dock)
            self._dock.deleteLater()
            self._dock = None
        if self._iface is not None and self._bar_dock is not None:
            self._bar_dock.visibilityChanged.disconnect(self._bar_dock_shown)
            self._bar_dock.close_desk()
            self._iface.removeDockWidget(self._bar_dock)
            self._bar_dock.deleteLater()
            self._bar_dock = None
        if self._iface is not None and self._bar_action is not None:
            self._iface.removeRasterToolBarIcon(self._bar_action)
            self._iface.rasterMenu().removeAction(self._bar_action)
            self._bar_action.deleteLater()
            self._bar_action = None
        if self._iface is not None and self._action is not None:
            self._iface.removeRasterToolBarIcon(self._action)
            self._iface.rasterMenu().removeAction(self._action)
            self._action.deleteLater()
            self._action = None
        if self._provider is not None:
            QgsApplication.processingRegistry().removeProvider(self._provider)
            self._provider = None
        self._translation.remove()

    def _show_dock(self, shown: bool) -> None:
        """The dock, made on first use so that QGIS starts without loading what it needs."""
        assert self._iface is not None
        assert self._action is not None
        if self._explained_missing(self._action):
            return
        if self._dock is None:
            from .gui.dock import InspectionDock

            self._dock = InspectionDock(self._iface)
            self._iface.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, self._dock)
            width = self._dock.standard_width
            self._iface.mainWindow().resizeDocks([self._dock], [width], Qt.Orientation.Horizontal)
            self._dock.visibilityChanged.connect(self._dock_shown)
        self._dock.setUserVisible(shown)

    def _dock_shown(self, visible: bool) -> None:
        if self._action is not None and self._dock is not None:
            self._action.setChecked(self._dock.isVisible())

    def _show_bar_dock(self, shown: bool) -> None:
        """The dock of bar groups, made on first use too."""
        assert self._iface is not None
        assert self._bar_action is not None
        if self._explained_missing(self._bar_action):
            return
        if self._bar_dock is None:
            from .gui.bar_dock import BarDock

            self._bar_dock = BarDock(self._iface)
            self._iface.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, self._bar_dock)
            self._bar_dock.visibilityChanged.connect(self._bar_dock_shown)
        self._bar_dock.setUserVisible(shown)

    def _bar_dock_shown(self, visible: bool) -> None:
        if self._bar_action is not None and self._bar_dock is not None:
            self._bar_action.setChecked(self._bar_dock.isVisible())

    def _explained_missing(self, action: QAction) -> bool:
        """Whether a package is missing; the message bar tells which."""
        assert self._iface is not None
        missing = missing_packages_sentence(desk=True)
        if missing:
            action.setChecked(False)
            self._iface.messageBar().pushMessage(tr("Seam Inspector"), missing, Qgis.MessageLevel.Warning, 0)
        return bool(missing)
