"""What the tests of table and judging share."""
from __future__ import annotations

from collections.abc import Iterator

import pytest
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication, QWidget
from seam_inspector.plugin.seams.desk.windows.windows_panel import WindowsPanel

from tests.qgis.seams.desk.scan_scene import ScanScene, make_scan_scene
from tests.qgis.seams.desk.windows_session import ROWS, Show, WindowsSession


@pytest.fixture(scope="module")
def scan_scene(tmp_path_factory: pytest.TempPathFactory) -> ScanScene:
    return make_scan_scene(tmp_path_factory.mktemp("scan"))


@pytest.fixture
def session() -> WindowsSession:
    return WindowsSession(ROWS)


@pytest.fixture
def show(qgis_app: QApplication) -> Iterator[Show]:
    """Shows a widget until the test is over."""
    shown: list[QWidget] = []

    def show_widget(widget: QWidget) -> QWidget:
        shown.append(widget)
        widget.show()
        QTest.qWait(1)
        return widget

    yield show_widget
    for widget in shown:
        widget.close()
        widget.deleteLater()


@pytest.fixture
def panel(session: WindowsSession, show: Show) -> WindowsPanel:
    panel = WindowsPanel(session)
    panel.resize(600, 300)
    show(panel)
    return panel
