"""Wires the plugin into QGIS and out again."""
from __future__ import annotations

from qgis.core import QgsApplication
from qgis.gui import QgisInterface

from .adapters.text import Translation
from .processing.provider import SeamInspectorProvider


class SeamInspectorPlugin:
    """What QGIS loads and unloads."""

    def __init__(self, iface: QgisInterface | None) -> None:
        self._iface = iface
        self._provider: SeamInspectorProvider | None = None
        self._translation = Translation()

    def initProcessing(self) -> None:
        """Register the provider; all that qgis_process asks for, which has no interface."""
        if self._provider is None:
            self._provider = SeamInspectorProvider()
            QgsApplication.processingRegistry().addProvider(self._provider)

    def initGui(self) -> None:
        self.initProcessing()

    def unload(self) -> None:
        if self._provider is not None:
            QgsApplication.processingRegistry().removeProvider(self._provider)
            self._provider = None
        self._translation.remove()
