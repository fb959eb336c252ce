"""Wires the plugin into QGIS and out again."""
from __future__ import annotations

from typing import Callable

from qgis.core import Qgis, QgsApplication, QgsSettings
from qgis.gui import QgisInterface, QgsDockWidget
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtGui import QIcon
from qgis.PyQt.QtWidgets import QAction

from .provider import SeamInspectorProvider
from .toolkit.packages import broken_package_sentence, missing_packages_sentence
from .toolkit.resources import icon_path, show_first_page
from .toolkit.translation import Translation, tr


class SeamInspectorPlugin:
    """What QGIS loads and unloads."""

    def __init__(self, iface: QgisInterface | None) -> None:
        self._iface = iface
        self._provider: SeamInspectorProvider | None = None
        self._translation = Translation()
        self._desks: list[Desk] = []
        self._help: QAction | None = None

    def initProcessing(self) -> None:
        """Register the provider; all that qgis_process asks for, which has no interface."""
        if self._provider is None:
            self._provider = SeamInspectorProvider()
            QgsApplication.processingRegistry().addProvider(self._provider)

    def initGui(self) -> None:
        assert self._iface is not None
        self.initProcessing()
        for make, icon, name, words, tooltip in (
            (_inspection_dock, "seam_inspector", "seamInspectorAction", tr("Seam Inspector"),
             tr("Inspect how much detail a mosaic kept along its seams")),
            (_bar_dock, "bar_group", "seamInspectorBarAction", tr("Bar groups"),
             tr("Draw lines across the groups of a bar target and watch their profiles")),
        ):  # fmt: skip
            action = QAction(QIcon(icon_path(icon)), words, self._iface.mainWindow())
            action.setObjectName(name)
            action.setToolTip(tooltip)
            self._desks.append(Desk(self._iface, action, make))
        book = QgsApplication.getThemeIcon("/mActionHelpContents.svg")
        self._help = QAction(book, tr("Seam Inspector"), self._iface.mainWindow())
        self._help.setToolTip(tr("The first inspection in five minutes, and a page for every algorithm"))
        self._help.triggered.connect(lambda: show_first_page())
        self._iface.pluginHelpMenu().addAction(self._help)

    def unload(self) -> None:
        while self._desks:
            self._desks.pop().remove()
        if self._help is not None and self._iface is not None:
            self._iface.pluginHelpMenu().removeAction(self._help)
            self._help.deleteLater()
            self._help = None
        if self._provider is not None:
            QgsApplication.processingRegistry().removeProvider(self._provider)
            self._provider = None
        self._translation.remove()

    def desk(self, name: str) -> Desk:
        """The desk whose action has this object name."""
        return next(desk for desk in self._desks if desk.action.objectName() == name)


class Desk:
    """A button in the raster toolbar and menu, and its dock, made on first use: QGIS starts without what it needs."""

    def __init__(
        self, iface: QgisInterface, action: QAction, make: Callable[[QgisInterface], QgsDockWidget]
    ) -> None:
        self._iface, self._make = iface, make
        self.action = action
        self._key = f"SeamInspector/{action.objectName()}_open"
        self.dock: QgsDockWidget | None = None
        action.setCheckable(True)
        action.triggered.connect(self._show)
        iface.initializationCompleted.connect(self._reopen)
        iface.addRasterToolBarIcon(action)
        # not by addPluginToRasterMenu: it makes a menu of one entry, and QGIS keeps that after the entry is removed
        iface.rasterMenu().addAction(action)

    def _reopen(self) -> None:
        """Show the dock where it was open when QGIS was closed."""
        if self.dock is None and QgsSettings().value(self._key, False, type=bool):
            self._show(True)

    def remove(self) -> None:
        """Leave nothing behind."""
        self._iface.initializationCompleted.disconnect(self._reopen)
        if self.dock is not None:
            self.dock.openedStateChanged.disconnect(self._remember)
            self.dock.close_desk()
            self._iface.removeDockWidget(self.dock)
            self.dock.deleteLater()
            self.dock = None
        self._iface.removeRasterToolBarIcon(self.action)
        self._iface.rasterMenu().removeAction(self.action)
        self.action.deleteLater()

    def _show(self, shown: bool) -> None:
        if self.dock is None:
            why_not = missing_packages_sentence()
            if not why_not:
                try:
                    self.dock = self._make(self._iface)
                except ImportError as error:
                    why_not = broken_package_sentence(error)
                    if not why_not:
                        raise
            if self.dock is None:
                self.action.setChecked(False)
                warning = Qgis.MessageLevel.Warning
                self._iface.messageBar().pushMessage(tr("Seam Inspector"), why_not, warning, 0)  # until it is read
                return
            self._iface.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, self.dock)
            width = max(420, 46 * self.dock.fontMetrics().averageCharWidth())  # nothing is cut off
            self._iface.mainWindow().resizeDocks([self.dock], [width], Qt.Orientation.Horizontal)
            self.dock.setToggleVisibilityAction(self.action)
            self.dock.openedStateChanged.connect(self._remember)
        self.dock.setUserVisible(shown)
        self._remember(shown)

    def _remember(self, is_open: bool) -> None:
        """For the next start; that QGIS hides all as it ends says nothing."""
        QgsSettings().setValue(self._key, is_open)


def _inspection_dock(iface: QgisInterface) -> QgsDockWidget:
    from .seams.desk.dock import InspectionDock

    return InspectionDock(iface)


def _bar_dock(iface: QgisInterface) -> QgsDockWidget:
    from .resolution.desk.bar_dock import BarDock

    return BarDock(iface)
