"""The desk's Help button and QGIS's Help menu show how to begin."""
from __future__ import annotations

from typing import Any

import pytest
from qgis.core import QgsProject
from qgis.gui import QgisInterface
from qgis.PyQt.QtCore import QUrl
from qgis.PyQt.QtWidgets import QMenu
from seam_inspector.plugin.toolkit import resources

from tests.qgis.plugin_lives import action_of, started


@pytest.fixture
def opened(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The headings of the pages that a browser was asked for."""
    headings: list[str] = []

    class Browser:
        @staticmethod
        def openUrl(address: QUrl) -> bool:
            with open(address.toLocalFile(), encoding="utf-8") as page:
                headings.append(page.read().partition("<title>")[2].partition("</title>")[0])
            return True

    monkeypatch.setattr(resources, "QDesktopServices", Browser)
    return headings


def test_the_desk_has_a_help_button(plugin: Any, opened: list[str]) -> None:
    action_of(plugin).trigger()
    plugin.desk("seamInspectorAction").dock.help.trigger()
    assert opened == ["The first inspection in five minutes"]


def test_the_help_menu_has_an_entry_as_long_as_the_plugin_is_there(
    qgis_iface: QgisInterface, project: QgsProject, opened: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    menu = QMenu()
    monkeypatch.setattr(qgis_iface, "pluginHelpMenu", lambda: menu, raising=False)
    made = started(qgis_iface)
    (entry,) = menu.actions()
    entry.trigger()
    made.unload()
    assert opened == ["The first inspection in five minutes"]
    assert menu.actions() == []
