"""The plugin's zip is installed into an empty profile by QGIS's own installer, and used.

Parameters: ``package`` (the zip), ``block`` (folder), ``side_m``, ``screenshots`` (folder).
"""
from __future__ import annotations

from pathlib import Path

import pyplugin_installer
from qgis.core import Qgis, QgsApplication
from qgis.utils import plugins

from demo.desk import Desk


def play(desk: Desk) -> None:
    """Nothing of the plugin is there before; what QGIS notes of it afterwards is in the report."""
    noted: list[str] = []

    def note(text: str, tag: str, level: Qgis.MessageLevel) -> None:
        if level in (Qgis.MessageLevel.Warning, Qgis.MessageLevel.Critical):
            noted.append(f"{tag}: {text}")

    QgsApplication.messageLog().messageReceived.connect(note)
    assert "seam_inspector" not in plugins
    pyplugin_installer.instance().installFromZipFile(desk.parameters["package"])
    assert "seam_inspector" in plugins
    import seam_inspector

    home = (Path(QgsApplication.qgisSettingsDirPath()) / "python" / "plugins").resolve()
    assert home in Path(seam_inspector.__file__).resolve().parents, seam_inspector.__file__
    desk.report["tooltip"] = desk.plugin.desk("seamInspectorAction").action.toolTip()
    desk.set_up(Path(desk.parameters["block"]), desk.parameters["side_m"], 2 * desk.parameters["side_m"])
    desk.dock.place.trigger()
    desk.wait(lambda: desk.session.windows() and not desk.session.is_busy, 60, "windows placed")
    desk.dock.inspect.trigger()
    desk.wait(lambda: all(row.verdict for row in desk.session.windows()), 120, "all inspected")
    desk.wait_for_work()
    desk.report["verdicts"] = [row.verdict for row in desk.session.windows()]
    desk.report["provider"] = QgsApplication.processingRegistry().providerById("seaminspector") is not None
    desk.screenshot(Path(desk.parameters["screenshots"]) / "installed.png")
    desk.report["noted"] = noted
