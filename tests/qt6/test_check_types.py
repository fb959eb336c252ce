"""mypy against PyQt6 and QGIS 4 finds wrong names, arguments and what is deprecated; the rules leave out the rest."""
from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from tools.qt6.check_types import CHECKOUT, Known, complaints, is_accepted, known_classes

PLANTED = """
from qgis.core import QgsField, QgsFieldProxyModel, QgsProcessing, QgsProject, QgsRasterLayer, QgsVectorLayer
from qgis.gui import QgsFieldComboBox
from qgis.PyQt.QtCore import QPoint, QRectF, Qt, QMetaType
from qgis.PyQt.QtGui import QMouseEvent, QFontMetrics
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QLabel, QUndoStack


def mistakes(event: QMouseEvent, label: QLabel, layer: QgsRasterLayer, metrics: QFontMetrics) -> None:
    event.globalPos()
    label.setAlignment(Qt.AlignLeft)
    label.setAlignment(4)
    label.AlignLeft
    QRectF().translate(QPoint(1, 1))
    metrics.width("a")
    layer.dataProvider().noSuchMethod()
    QgsProject.instance().addMapLayers(layer)
    QgsField("a", "text")
    QgsProcessing.TypeVektor
    QgsVectorLayer("a", "b", "c").featureAdded.conect(print)
    layer.setRefreshOnNotifyEnabled(1, 2)
    layer.setAutoRefreshEnabled(True)


def right(layer: QgsVectorLayer, box: QgsFieldComboBox, label: QLabel) -> None:
    box.setFilters(QgsFieldProxyModel.Filter.Int | QgsFieldProxyModel.Filter.String)
    label.setAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop)
    layer.dataProvider().addAttributes([QgsField("a", QMetaType.Type.Int)])
    kind: QgsProcessing.SourceType = QgsProcessing.SourceType.TypeVectorPolygon
    QTest.qWait(3)
"""


@pytest.fixture(scope="module")
def known() -> Known:
    return known_classes(CHECKOUT)


def test_planted_mistakes_are_told_and_nothing_else(tmp_path: Path, known: Known) -> None:
    planted = tmp_path / "planted.py"
    planted.write_text(PLANTED, encoding="utf-8")
    run = subprocess.run(
        [sys.executable, "-m", "mypy", "--config-file", "tools/qt6/mypy.ini", planted],
        cwd=CHECKOUT, capture_output=True, text=True, check=False,
    )  # fmt: skip
    text = "\n".join(complaints(run.stdout.splitlines(), known))
    lines = {int(line.split(":")[1]) for line in text.splitlines()}
    sources = PLANTED.splitlines()
    first, last = (sources.index(line) for line in sources if line.startswith("def "))
    wanted = {first + 2 + place for place in range(last - first - 3)} | {7}  # the import of QUndoStack
    assert lines == wanted, text
    assert '"QMouseEvent" has no attribute "globalPos"' in text
    assert "setAutoRefreshEnabled is deprecated" in text


@pytest.mark.parametrize(
    "message",
    [
        '"QEvent" has no attribute "key"  [attr-defined]',  # a QKeyEvent, as its type said
        '"QCoreApplication" has no attribute "focusChanged"  [attr-defined]',
        '"QgsMapLayer" has no attribute "getFeatures"  [attr-defined]',
        'Argument 1 to "is_picture" has incompatible type "QgsMapLayer"; expected "QgsRasterLayer"  [arg-type]',
        'Argument 1 to "Plugin" has incompatible type "object"; expected "QgisInterface | None"  [arg-type]',
        'Need type annotation for "found"  [var-annotated]',
    ],
)
def test_what_mypy_cannot_know_is_left_out(message: str, known: Known) -> None:
    assert is_accepted(message, known)


@pytest.mark.parametrize(
    "message",
    [
        '"QEvent" has no attribute "keys"  [attr-defined]',
        '"type[QgsProject]" has no attribute "getFeatures"  [attr-defined]',
        'Module "qgis.core" has no attribute "QgsNothing"  [attr-defined]',
        'Argument 1 to "setValue" of "QSpinBox" has incompatible type "float"; expected "int"  [arg-type]',
        'Argument 1 to "f" has incompatible type "QgsRasterLayer"; expected "QgsVectorLayer"  [arg-type]',
    ],
)
def test_what_is_wrong_is_kept(message: str, known: Known) -> None:
    assert not is_accepted(message, known)
