"""Without PyWavelets: the plugin loads, says what is missing, and works once QGIS has started with it."""
from __future__ import annotations

import sys

from qgis.core import Qgis
from qgis.PyQt.QtWidgets import QAction
from qgis.utils import iface, loadPlugin, startPlugin, unloadPlugin

from demo.desk import Desk

NAME = "seam_inspector"


def play(desk: Desk) -> None:
    """What the message bar says is in the report."""
    assert "pywt" not in sys.modules  # nothing has needed it yet
    sys.modules["pywt"] = None  # type: ignore[assignment]
    restart()
    button().trigger()
    desk.pause(0.3)
    bar = iface.messageBar()
    desk.report["messages"] = [item.text() for item in bar.items()]
    desk.report["is_warning"] = bar.currentItem().level() == Qgis.MessageLevel.Warning
    assert desk.dock is None
    assert not button().isChecked()
    bar.clearWidgets()
    del sys.modules["pywt"]
    restart()
    desk.open_dock()
    desk.report["messages_after"] = [item.text() for item in bar.items()]


def restart() -> None:
    """What QGIS does with a plugin when it starts."""
    assert unloadPlugin(NAME)
    assert loadPlugin(NAME)
    assert startPlugin(NAME)


def button() -> QAction:
    """The plugin's, in the toolbar."""
    return next(action for action in iface.rasterToolBar().actions() if action.objectName() == "seamInspectorAction")
