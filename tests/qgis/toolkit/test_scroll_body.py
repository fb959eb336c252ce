"""The dock's content on a low screen."""
from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from qgis.PyQt.QtCore import QPoint, QPointF, Qt
from qgis.PyQt.QtGui import QWheelEvent
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication, QComboBox, QLabel, QSpinBox, QVBoxLayout, QWidget
from seam_inspector.plugin.toolkit.desk.widgets import ScrollBody


@pytest.fixture
def body(qgis_app: QApplication) -> Iterator[ScrollBody]:
    content: Any = QWidget()  # with its fields
    layout = QVBoxLayout(content)
    content.number, content.choice, content.label = QSpinBox(), QComboBox(), QLabel("high")
    content.choice.addItems(["a", "b", "c"])
    content.label.setMinimumSize(380, 900)
    for widget in (content.number, content.choice, content.label):
        layout.addWidget(widget)
    made = ScrollBody(content)
    made.show()
    QTest.qWait(1)
    yield made
    made.close()
    made.deleteLater()


def turn(widget: QWidget) -> None:
    """The wheel over a widget, as Qt hands it on until somebody takes it."""
    middle, down = QPointF(widget.rect().center()), QPoint(0, -120)
    event = QWheelEvent(
        middle, QPointF(widget.mapToGlobal(middle.toPoint())), QPoint(), down, Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier, Qt.ScrollPhase.NoScrollPhase, False,
    )  # fmt: skip
    QApplication.sendEvent(widget, event)


def test_it_scrolls_where_there_is_no_room_and_is_never_too_narrow(body: ScrollBody) -> None:
    assert body.minimumSizeHint().height() < 300
    body.resize(500, 1000)
    QTest.qWait(1)
    assert body.verticalScrollBar().maximum() == 0
    assert body.minimumSizeHint().width() >= 380
    body.resize(500, 400)
    QTest.qWait(1)
    assert body.verticalScrollBar().maximum() > 0
    turn(body.viewport())
    assert body.verticalScrollBar().value() > 0
    body.resize(body.minimumSizeHint().width(), 400)
    QTest.qWait(1)
    assert body.widget().label.width() >= 380


def test_the_wheel_changes_only_what_has_the_focus(body: ScrollBody) -> None:
    content: Any = body.widget()
    for field, value in ((content.number, content.number.value), (content.choice, content.choice.currentIndex)):
        field.clearFocus()
        before = value()
        turn(field)
        assert value() == before
        assert field.focusPolicy() == Qt.FocusPolicy.StrongFocus
    content.number.setValue(5)
    body.activateWindow()
    content.number.setFocus()
    if content.number.hasFocus():
        turn(content.number)
        assert content.number.value() == 4
