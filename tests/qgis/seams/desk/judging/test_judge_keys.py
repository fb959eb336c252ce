"""The keys that judge: wherever the focus is, but not where somebody types or edits the map."""
from __future__ import annotations

from collections.abc import Iterator

import pytest
from qgis.gui import QgsLayerTreeView, QgsMapCanvas, QgsMapTool
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtGui import QKeySequence
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import (
    QAction,
    QApplication,
    QComboBox,
    QDialog,
    QDockWidget,
    QLineEdit,
    QListWidget,
    QMainWindow,
    QPushButton,
    QSpinBox,
    QTableWidget,
    QTextEdit,
    QToolBar,
    QTreeWidget,
    QVBoxLayout,
    QWidget,
)
from seam_inspector.plugin.seams.desk.desk_keys import DeskKeys

from tests.qgis.seams.desk.windows_session import Show


class _Desk:
    """A main window with a desk and all that may have the focus, and a record of the keys that were taken."""

    def __init__(self) -> None:
        self.window = QMainWindow()
        self.body = body = QWidget()
        layout = QVBoxLayout(body)
        self.line, self.text, self.number, self.choice = QLineEdit(), QTextEdit(), QSpinBox(), QComboBox()
        self.button, self.tree = QPushButton("next"), QTreeWidget()
        for widget in (self.line, self.text, self.number, self.choice, self.button, self.tree):
            layout.addWidget(widget)
        self.window.setCentralWidget(body)
        self.shortcut = QAction("of QGIS", self.window)
        self.shortcut.setShortcut(QKeySequence(Qt.Key.Key_V))
        self.shortcut.triggered.connect(lambda: self.taken.append("QGIS"))
        self.window.addAction(self.shortcut)
        self.taken: list[str] = []
        self.editing = False
        self.has_windows = True
        self.keys = DeskKeys(body, self.window, self)  # type: ignore[arg-type]  # which has the map's tool
        self.keys.set_actions(
            {"visible": self._judge, "next": self._next, "flicker": self._hold}, {"flicker": self._let_go}
        )
        self.keys.listen(True)

    def mapTool(self) -> _Desk:
        return self

    def flags(self) -> _Desk:
        return self

    def __and__(self, flag: object) -> bool:
        return self.editing and flag == QgsMapTool.Flag.EditTool

    def _judge(self) -> bool:
        if self.has_windows:
            self.taken.append("V")
        return self.has_windows

    def _hold(self) -> bool:
        self.taken.append("held")
        return True

    def _let_go(self) -> None:
        self.taken.append("let go")

    def _next(self) -> bool:
        self.taken.append("N")
        return True

    def press(self, widget: QWidget, key: Qt.Key = Qt.Key.Key_V) -> list[str]:
        """What takes a key where a widget has the focus."""
        widget.setFocus()
        assert QApplication.focusWidget() is widget
        self.taken.clear()
        QTest.keyClick(widget, key)
        return list(self.taken)


@pytest.fixture
def desk(show: Show) -> Iterator[_Desk]:
    made = _Desk()
    show(made.window)
    made.window.activateWindow()
    QTest.qWaitForWindowActive(made.window)
    yield made
    made.keys.close()


def test_keys_work_wherever_the_focus_is_and_no_shortcut_is_ambiguous(desk: _Desk) -> None:
    for widget in (desk.button, desk.tree):
        assert desk.press(widget) == ["V"]
        assert desk.press(widget, Qt.Key.Key_N) == ["N"]


def test_keys_of_the_map_are_a_button_s_where_that_has_the_focus(desk: _Desk) -> None:
    pressed: list[bool] = []
    desk.button.clicked.connect(pressed.append)
    assert desk.press(desk.button, Qt.Key.Key_Space) == []
    assert pressed
    assert desk.press(desk.tree, Qt.Key.Key_Space) == []
    desk.tree.clearFocus()
    desk.window.setFocus()
    desk.taken.clear()
    QTest.keyPress(desk.window, Qt.Key.Key_Space)
    assert desk.taken == ["held"]
    QTest.keyRelease(desk.window, Qt.Key.Key_Space)
    assert desk.taken == ["held", "let go"]
    QTest.keyRelease(desk.window, Qt.Key.Key_Space)
    assert desk.taken == ["held", "let go"]


def test_text_fields_keep_their_letters(desk: _Desk) -> None:
    for widget in (desk.line, desk.text, desk.number, desk.choice):
        assert "V" not in desk.press(widget)
    assert (desk.line.text(), desk.text.toPlainText()) == ("v", "v")


def test_a_tool_that_edits_the_map_keeps_its_keys(desk: _Desk) -> None:
    desk.editing = True
    assert "V" not in desk.press(desk.tree)


def test_another_window_keeps_its_keys(desk: _Desk, show: Show) -> None:
    dialog = QDialog()
    button = QPushButton("close", dialog)
    show(dialog)
    dialog.activateWindow()
    QTest.qWaitForWindowActive(dialog)
    assert desk.press(button) == []


def test_with_nothing_to_judge_the_key_is_somebody_else_s(desk: _Desk) -> None:
    desk.has_windows = False
    assert "V" not in desk.press(desk.tree)


def test_other_keys_are_left_alone(desk: _Desk) -> None:
    desk.tree.setFocus()
    QTest.keyClick(desk.tree, Qt.Key.Key_V, Qt.KeyboardModifier.ControlModifier)
    QTest.keyClick(desk.tree, Qt.Key.Key_X)
    assert desk.taken == []


def test_out_of_sight_it_takes_nothing(desk: _Desk) -> None:
    desk.keys.listen(False)
    assert "V" not in desk.press(desk.tree)


@pytest.mark.parametrize("of_another", [QListWidget, QTableWidget])
def test_lists_of_other_docks_keep_the_letters_that_find_a_row(desk: _Desk, of_another: type[QWidget]) -> None:
    dock, found = QDockWidget("of another plugin"), of_another()
    dock.setWidget(found)
    desk.window.addDockWidget(Qt.DockWidgetArea.LeftDockWidgetArea, dock)
    assert "V" not in desk.press(found)


@pytest.mark.parametrize("kind", [QgsMapCanvas, QgsLayerTreeView, QListWidget])
def test_keys_work_on_the_map_in_the_layer_tree_and_the_desk_s_own_lists(desk: _Desk, kind: type[QWidget]) -> None:
    dock, found = QDockWidget("of QGIS"), kind()
    if kind is QListWidget:
        desk.body.layout().addWidget(found)
        found.show()
    else:
        dock.setWidget(found)
        desk.window.addDockWidget(Qt.DockWidgetArea.LeftDockWidgetArea, dock)
    assert desk.press(found) == ["V"]


def test_keys_work_where_a_toolbar_or_the_main_window_has_the_focus(desk: _Desk) -> None:
    bar, button = QToolBar(), QPushButton("of a toolbar")
    bar.addWidget(button)
    desk.window.addToolBar(bar)
    bar.show()
    QApplication.processEvents()
    desk.window.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
    for widget in (button, desk.window):
        assert desk.press(widget) == ["V"]
