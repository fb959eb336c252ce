"""Widgets of the docks: content on a low screen, a tool bar that fits, and what can be read in any theme."""
from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from qgis.core import QgsApplication
from qgis.PyQt.QtCore import QPoint, QPointF, QRect, Qt
from qgis.PyQt.QtGui import QColor, QPalette, QWheelEvent
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QAction, QApplication, QComboBox, QLabel, QSpinBox, QTabWidget, QVBoxLayout, QWidget
from seam_inspector.plugin.toolkit.desk.theme import contrast, readable_palette
from seam_inspector.plugin.toolkit.desk.widgets import ClippedLabel, FittingToolBar, ScrollBody


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


ICON, WORDS = Qt.ToolButtonStyle.ToolButtonIconOnly, Qt.ToolButtonStyle.ToolButtonTextBesideIcon
BARE = Qt.ToolButtonStyle.ToolButtonTextOnly


@pytest.fixture
def bar(qgis_app: QApplication) -> Iterator[FittingToolBar]:
    icon = QgsApplication.getThemeIcon("/mActionStart.svg")
    actions = [QAction(icon, words) for words in ("Draw", "Place along the seams", "Inspect", "Report")]
    made = FittingToolBar(actions, worded=[actions[2], actions[1]])
    made.show()
    yield made
    made.deleteLater()
    actions.clear()  # kept until here


def styles(bar: FittingToolBar, width: int) -> list[Qt.ToolButtonStyle]:
    bar.resize(width, 40)
    QApplication.processEvents()
    return [bar.widgetForAction(action).toolButtonStyle() for action in bar.actions()]


def test_words_go_one_after_another_and_come_back(bar: FittingToolBar) -> None:
    whole = bar.sizeHint().width()
    assert styles(bar, whole + 5) == [ICON, WORDS, WORDS, ICON]
    assert styles(bar, whole - 10) == [ICON, BARE, WORDS, ICON]
    assert styles(bar, whole - 70) == [ICON, ICON, BARE, ICON]
    assert styles(bar, whole // 3) == [ICON, ICON, ICON, ICON]
    assert bar.sizeHint().width() == whole  # what it would like, whatever it has
    assert styles(bar, whole + 5) == [ICON, WORDS, WORDS, ICON]


def test_the_keyboard_reaches_every_button(bar: FittingToolBar) -> None:
    policies = {bar.widgetForAction(action).focusPolicy() for action in bar.actions()}
    assert policies == {Qt.FocusPolicy.TabFocus}


READABLE = 3.0
# as Night Mapping has it: colours for QGIS's kinds of widgets, dark on nothing for all others
SHEET = """
QWidget { background: transparent; }
QLabel { color: #aaaaaa; }
QTabWidget, QAbstractScrollArea { color: #aaaaaa; background-color: #323232; }
"""


@pytest.fixture
def night(qgis_app: QApplication) -> Iterator[None]:
    before, sheet = QApplication.palette(), qgis_app.styleSheet()
    dark = QPalette(before)
    for role in (QPalette.ColorRole.WindowText, QPalette.ColorRole.Text):
        dark.setColor(role, QColor("#111111"))
    dark.setColor(QPalette.ColorRole.Base, QColor("#222222"))
    QApplication.setPalette(dark)
    qgis_app.setStyleSheet(SHEET)
    yield
    qgis_app.setStyleSheet(sheet)
    QApplication.setPalette(before)


def ink(widget: QWidget, box: QRect) -> float:
    """The strongest contrast in a part of a widget with its lower right corner, where nothing is written."""
    image = widget.grab(box).toImage()
    back = image.pixelColor(image.width() - 1, image.height() - 1)
    colours = {image.pixel(x, y) for x in range(image.width()) for y in range(image.height())}
    return max(contrast(QColor(colour), back) for colour in colours)


@pytest.mark.parametrize(
    ("colour", "other", "ratio"), [("#000000", "#ffffff", 21), ("#777777", "#ffffff", 4.48), ("#123456", "#123456", 1)]
)
def test_contrast_is_that_of_wcag(colour: str, other: str, ratio: float) -> None:
    assert contrast(QColor(colour), QColor(other)) == pytest.approx(ratio, abs=0.01)
    assert contrast(QColor(other), QColor(colour)) == pytest.approx(ratio, abs=0.01)


def test_without_a_readable_palette_around_it_is_the_widget_s_own(qgis_app: QApplication) -> None:
    widget = QWidget()
    assert readable_palette(widget) == widget.palette()


@pytest.mark.usefixtures("night")
def test_sentences_in_a_theme_of_style_sheets() -> None:
    """Also those that come long after the theme."""
    tabs, label = QTabWidget(), ClippedLabel(1)
    label.setText("Detail at level 1 is 83 %")
    tabs.resize(600, 400)
    tabs.show()
    QApplication.processEvents()
    tabs.addTab(label, "sentence")
    tabs.setCurrentWidget(label)
    QApplication.processEvents()
    assert ink(label, label.rect()) > READABLE
    tabs.deleteLater()


@pytest.mark.usefixtures("night")
def test_a_theme_that_changes_is_followed(qgis_app: QApplication) -> None:
    tabs, label = QTabWidget(), ClippedLabel(1)
    tabs.addTab(label, "sentence")
    tabs.show()
    assert readable_palette(label).color(QPalette.ColorRole.Text).name() == "#aaaaaa"
    qgis_app.setStyleSheet(SHEET.replace("#aaaaaa", "#112233").replace("#323232", "#eeeeee"))
    assert readable_palette(label).color(QPalette.ColorRole.Text).name() == "#112233"
    tabs.deleteLater()
