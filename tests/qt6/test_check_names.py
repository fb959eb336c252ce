"""The checker of names finds what Qt 6 took away, and leaves alone what it has."""
from __future__ import annotations

import pytest

from tools.qt6.check_names import CHECKOUT, Names, complaints, files


@pytest.fixture(scope="module")
def names() -> Names:
    return Names()


def last_complaints(source: str, names: Names) -> str:
    """What is told of the last line, in one text."""
    last = len(source.splitlines())
    return "; ".join(text for line, text in complaints(source, names) if line == last)


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ("from PyQt5.QtCore import Qt", "import from qgis.PyQt"),
        ("import sip", "import qgis.PyQt's"),
        ("from qgis.PyQt.QtWidgets import QUndoStack", "QtWidgets.QUndoStack is not there"),
        ("from qgis.PyQt.QtWidgets import QDesktopWidget", "is not there"),
        ("from qgis.PyQt.QtCore import QRegExp", "is not there"),
        ("from qgis.PyQt.QtCore import Qt\nQt.LeftButton", "Qt.MouseButton.LeftButton"),
        ("from qgis.PyQt import QtCore\nQtCore.Qt.AlignLeft", "QtCore.Qt.AlignmentFlag.AlignLeft"),
        ("from qgis.PyQt import QtCore\nQtCore.QVariant.Int", "QtCore.QVariant.Int is not there"),
        ("from qgis.PyQt.QtGui import QPalette\nQPalette.ColorRole.Background", "Background is not there"),
        ("from qgis.PyQt.QtGui import QPainter as P\nhint = P.Antialiasing", "P.RenderHint.Antialiasing"),
        ("from qgis.PyQt.QtCore import Qt\nkey = Qt.Key\nkey.Key_Nowhere", "is not there"),
        ("from qgis.PyQt.QtWidgets import QFrame\nself.setFrameShape(self.NoFrame)", "through an instance"),
        ("from qgis.PyQt.QtWidgets import QMessageBox\nbox.Ok", "through an instance"),
        ("dialog.exec_()", "Qt 6 has exec()"),
        ("layout.setMargin(3)", "setContentsMargins"),
        ("def at(event: QMouseEvent):\n    return event.globalPos()", "globalPosition"),
        ("def at(event: QMouseEvent):\n    return event.x()", "Qt 6's QMouseEvent has no x()"),
        ("def at(event: QDropEvent | None):\n    return event.pos()", "Qt 6's QDropEvent has no pos()"),
        ("def at(event: QtGui.QWheelEvent):\n    return event.delta()", "no delta()"),
        ("metrics = QFontMetrics(font)\nmetrics.width('a')", "no width()"),
        ("self.fontMetrics().width('a')", "no width()"),
        ("box.activated[str].connect(take)", "textActivated"),
        ("from qgis.PyQt.QtCore import Qt\nint(Qt.MouseButton.LeftButton)", "no number in PyQt6"),
        ("from qgis.PyQt.QtCore import Qt\nQt.ItemFlag.ItemIsEnabled | 2", "a flag and a number"),
        ("from qgis.PyQt.QtCore import Qt\nQt.CheckState.Checked | Qt.CheckState.Unchecked", "is no flag"),
        ("from qgis.PyQt.QtCore import Qt\nQt.KeyboardModifier.ControlModifier + Qt.Key.Key_Z", "joined by |"),
        ("from qgis.PyQt.QtCore import Qt\nstate == 1 or 2 == Qt.CheckState.Checked", "never equal"),
    ],
)
def test_what_qt_6_took_away_is_told(source: str, expected: str, names: Names) -> None:
    assert expected in last_complaints(source, names)


@pytest.mark.parametrize(
    "source",
    [
        "from qgis.PyQt.QtWidgets import QAction, QActionGroup, QShortcut",
        "from qgis.PyQt.QtCore import Qt\nQt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop",
        "from qgis.PyQt.QtCore import Qt\nif event.key() == Qt.Key.Key_Z and int(Qt.Key.Key_Z) > 3: pass",
        "from qgis.PyQt.QtCore import Qt\nQt.ItemDataRole.UserRole + 1",
        "from qgis.PyQt.QtCore import Qt\nstyles = Qt.ToolButtonStyle\nstyles.ToolButtonIconOnly",
        "from qgis.core import QgsProcessing\none, kind = 1, QgsProcessing.SourceType\nkind.Raster",
        "def at(event: QMouseEvent):\n    return event.pos()",
        "def at(event: QEvent):\n    return isinstance(event, QHelpEvent) and event.globalPos()",
        "def at(rect: QRect):\n    return rect.x()",
        "import subprocess\ndef run() -> subprocess.CompletedProcess[str]: ...",
        "from osgeo import gdal\ngdal.GetDriverByName('MEM').Create('', 1, 1)",
    ],
)
def test_what_qt_6_has_is_left_alone(source: str, names: Names) -> None:
    assert complaints(source, names) == []


def test_every_file_is_looked_at() -> None:
    paths = {path.relative_to(CHECKOUT).as_posix() for path in files(CHECKOUT)}
    assert {"__init__.py", "plugin/plugin.py", "demo/run.py", "tests/qt6/under_qt6.py"} <= paths
    assert len(paths) > 700
