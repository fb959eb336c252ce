"""The desk's keys: on the map and in the desk, those that judge only while windows are judged; none where somebody
types or edits the map."""
from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from qgis.core import QgsLayerTreeModel, QgsProject
from qgis.gui import QgsLayerTreeView, QgsMapCanvas, QgsMapTool
from qgis.PyQt.QtCore import QEvent, Qt
from qgis.PyQt.QtGui import QKeyEvent, QKeySequence
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import (
    QAction,
    QApplication,
    QComboBox,
    QDockWidget,
    QLineEdit,
    QListWidget,
    QMainWindow,
    QPushButton,
    QSpinBox,
    QTableWidget,
    QTextEdit,
    QTreeWidget,
    QVBoxLayout,
    QWidget,
)
from seam_inspector.plugin.seams.desk.desk_keys import DeskKeys
from seam_inspector.plugin.seams.desk.windows.windows_panel import WindowsPanel

from tests.qgis.seams.desk.windows_session import Show, WindowsSession, window

UP_MS = 80  # a key that is not pressed again in this time is up


class _Editing(QgsMapTool):
    def flags(self) -> Any:  # named otherwise in Qt 5 and 6
        return QgsMapTool.Flag.EditTool


class _Desk:
    """A main window with a desk and all that may have the focus, and a record of the keys that were taken."""

    def __init__(self) -> None:
        self.window = QMainWindow()
        self.body = body = QWidget()
        layout = QVBoxLayout(body)
        self.line, self.text, self.number, self.choice = QLineEdit(), QTextEdit(), QSpinBox(), QComboBox()
        self.button, self.tree, self.chart = QPushButton("next"), QTreeWidget(), QWidget()
        self.chart.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.panel = WindowsPanel(WindowsSession([window(1)]))  # type: ignore[arg-type]
        self.table = self.panel.table
        for widget in (
            self.line, self.text, self.number, self.choice, self.button, self.tree, self.chart, self.panel,
        ):  # fmt: skip
            layout.addWidget(widget)
        self.canvas = QgsMapCanvas()
        self.window.setCentralWidget(self.canvas)
        dock = QDockWidget("the desk")
        dock.setWidget(body)
        self.window.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, dock)
        self.shortcut = QAction("of QGIS", self.window)
        self.shortcut.setShortcut(QKeySequence(Qt.Key.Key_V))
        self.shortcut.triggered.connect(lambda: self.taken.append("QGIS"))
        self.window.addAction(self.shortcut)
        self.taken: list[str] = []
        self.is_judging = self.has_windows = True
        self.keys = DeskKeys(body, self.window, self.canvas)
        self.keys.set_actions(
            {
                name: self._say(word) for name, word in (
                    ("visible", "V"), ("next", "N"), ("flicker", "held"), ("take back", "Backspace"), ("layout", "J"),
                )
            },
            {"flicker": self._let_go},
            lambda: self.is_judging,
        )
        self.keys.listen(True)

    def _say(self, word: str) -> Callable[[], bool]:
        def say() -> bool:
            if self.has_windows:
                self.taken.append(word)
            return self.has_windows

        return say

    def _let_go(self, seconds: float) -> None:
        self.taken.append("let go")
        self.held_s = seconds

    def press(self, widget: QWidget, key: Qt.Key = Qt.Key.Key_V) -> list[str]:
        """What takes a key where a widget has the focus."""
        widget.setFocus()
        assert QApplication.focusWidget() is widget
        self.taken.clear()
        QTest.keyClick(widget, key)
        QTest.qWait(UP_MS)
        return list(self.taken)


@pytest.fixture
def desk(show: Show) -> Iterator[_Desk]:
    made = _Desk()
    show(made.window)
    made.window.activateWindow()
    QTest.qWaitForWindowActive(made.window)
    yield made
    made.keys.close()
    made.panel.close()


def test_letters_judge_on_the_map_and_in_the_desk_and_no_shortcut_is_ambiguous(desk: _Desk) -> None:
    for widget in (desk.canvas, desk.table, desk.button, desk.chart):
        assert desk.press(widget) == ["V"]
        assert desk.press(widget, Qt.Key.Key_N) == ["N"]
        assert desk.press(widget, Qt.Key.Key_Backspace) == ["Backspace"]


def test_space_works_on_the_map_and_in_the_table_and_presses_buttons(desk: _Desk) -> None:
    desk.is_judging = False
    pressed: list[bool] = []
    desk.button.clicked.connect(pressed.append)
    assert desk.press(desk.button, Qt.Key.Key_Space) == []
    assert pressed
    assert desk.press(desk.tree, Qt.Key.Key_Space) == []
    for widget in (desk.canvas, desk.table):
        assert desk.press(widget, Qt.Key.Key_Space) == ["held", "let go"]
    desk.taken.clear()
    QTest.keyRelease(desk.table, Qt.Key.Key_Space)
    QTest.qWait(UP_MS)
    assert desk.taken == []


@pytest.mark.parametrize("is_told", [False, True])
def test_a_held_key_that_repeats_as_pairs_is_held(desk: _Desk, is_told: bool) -> None:
    """X repeats keys by releases and presses within 3 ms, which Qt calls repetitions or does not."""
    desk.canvas.setFocus()
    for key, taken in ((Qt.Key.Key_Space, ["held"]), (Qt.Key.Key_V, ["V"])):
        desk.taken.clear()
        QTest.keyPress(desk.canvas, key)
        for _ in range(6):
            for kind in (QEvent.Type.KeyRelease, QEvent.Type.KeyPress):
                nothing = Qt.KeyboardModifier.NoModifier
                QApplication.sendEvent(desk.canvas, QKeyEvent(kind, key, nothing, "", is_told))
                QTest.qWait(2)
            QTest.qWait(25)
        QTest.qWait(UP_MS)
        assert desk.taken == taken
        QTest.keyRelease(desk.canvas, key)
        QTest.qWait(UP_MS)
    assert desk.press(desk.canvas) == ["V"]


def test_a_key_tapped_twice_while_the_interface_is_busy_is_tapped_twice(desk: _Desk) -> None:
    """No timer ends meanwhile."""
    desk.canvas.setFocus()
    QTest.keyClick(desk.canvas, Qt.Key.Key_V)
    time.sleep(UP_MS / 1000)
    QTest.keyClick(desk.canvas, Qt.Key.Key_V)
    assert desk.taken == ["V", "V"]


def test_a_held_key_is_let_go_of_when_another_application_is_used(desk: _Desk) -> None:
    desk.canvas.setFocus()
    QTest.keyPress(desk.canvas, Qt.Key.Key_Space)
    QApplication.instance().applicationStateChanged.emit(Qt.ApplicationState.ApplicationInactive)
    assert desk.taken == ["held", "let go"]


def test_a_tool_that_edits_the_map_keeps_its_keys(desk: _Desk) -> None:
    tool = _Editing(desk.canvas)
    desk.canvas.setMapTool(tool)
    assert "V" not in desk.press(desk.table)


def test_with_nothing_to_judge_the_key_stays_with_the_desk_and_does_nothing(desk: _Desk) -> None:
    """Backspace would go to QGIS, which removes the window."""
    desk.has_windows = False
    reached: list[int] = []
    desk.canvas.keyPressed.connect(lambda event: reached.append(event.key()))
    for key in (Qt.Key.Key_V, Qt.Key.Key_Backspace):
        assert desk.press(desk.canvas, key) == []
    assert reached == []


def test_a_key_that_has_nothing_to_do_is_the_map_s_while_nothing_is_judged(desk: _Desk) -> None:
    desk.has_windows = desk.is_judging = False
    reached: list[int] = []
    for signal in (desk.canvas.keyPressed, desk.canvas.keyReleased):
        signal.connect(lambda event: reached.append(event.key()))
    for key in (Qt.Key.Key_Space, Qt.Key.Key_Backspace):
        desk.press(desk.canvas, key)
        assert reached == [key, key]  # pressed and released
        reached.clear()


def test_other_keys_are_left_alone(desk: _Desk) -> None:
    desk.table.setFocus()
    QTest.keyClick(desk.table, Qt.Key.Key_V, Qt.KeyboardModifier.ControlModifier)
    QTest.keyClick(desk.table, Qt.Key.Key_Q)
    assert desk.taken == []


@pytest.mark.parametrize("kind", [QListWidget, QTableWidget, QTreeWidget, QgsLayerTreeView, QWidget])
def test_other_docks_keep_the_letters_that_find_a_row(desk: _Desk, kind: type[QWidget]) -> None:
    dock, widget = QDockWidget("of another plugin, or of QGIS"), kind()
    widget.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
    if kind is QgsLayerTreeView:
        widget.setModel(QgsLayerTreeModel(QgsProject.instance().layerTreeRoot(), widget))
    dock.setWidget(widget)
    desk.window.addDockWidget(Qt.DockWidgetArea.LeftDockWidgetArea, dock)
    for key in (Qt.Key.Key_V, Qt.Key.Key_J, Qt.Key.Key_X, Qt.Key.Key_Space, Qt.Key.Key_Backspace):
        assert not {"V", "J", "X", "held", "Backspace"} & {*desk.press(widget, key)}
