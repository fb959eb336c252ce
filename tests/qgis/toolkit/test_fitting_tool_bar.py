"""Words beside icons as long as there is room, then words alone, then icons."""
from __future__ import annotations

from collections.abc import Iterator

import pytest
from qgis.core import QgsApplication
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtWidgets import QAction, QApplication
from seam_inspector.plugin.toolkit.desk.widgets import FittingToolBar

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
