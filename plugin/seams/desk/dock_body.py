"""How the desk's parts share the dock: low or high, narrow or wide."""
from __future__ import annotations

from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtWidgets import QBoxLayout, QSplitter, QToolBar, QVBoxLayout, QWidget

from ...toolkit.desk.widgets import ScrollBody
from .judge_bar import JudgeBar
from .windows.windows_panel import WindowsPanel

_HIGH_LINES = 44  # of text: from this height on there is room for more windows, and for a long sentence
_FEWEST_ROWS = 6  # of windows: fewer show no neighbours of the one that is judged
_SHARES = [2000, 3000]  # of the windows and the tabs; Qt fits them to the room there is


class DockBody(QWidget):
    """Inputs, toolbar, windows and tabs, which scroll on a low screen; judgement and progress, always in sight."""

    def __init__(
        self, inputs: QWidget, toolbar: QToolBar, windows: WindowsPanel, tabs: QWidget, judge: JudgeBar,
        progress: QWidget,
    ) -> None:
        super().__init__()
        self._head = QBoxLayout(QBoxLayout.Direction.TopToBottom)
        self._head.setSpacing(3)
        self._head.addWidget(inputs, 1)
        self._head.addWidget(toolbar)
        self._head.setAlignment(toolbar, Qt.AlignmentFlag.AlignTop)
        self._splitter = QSplitter(Qt.Orientation.Vertical)
        side = QWidget()
        self._side = QVBoxLayout(side)
        self._side.setContentsMargins(0, 0, 0, 0)
        self._side.setSpacing(3)
        self._side.addWidget(windows, 1)
        for widget, share in ((side, 2), (tabs, 3)):
            self._splitter.addWidget(widget)
            self._splitter.setStretchFactor(self._splitter.count() - 1, share)
        self._splitter.setChildrenCollapsible(False)
        upper = QWidget()
        layout = QVBoxLayout(upper)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(3)
        layout.addLayout(self._head)
        layout.addWidget(self._splitter, 1)
        self.scrolled = ScrollBody(upper)
        self._windows, self._judge, self._whole = windows, judge, QVBoxLayout(self)
        self._whole.setContentsMargins(4, 2, 4, 4)
        self._whole.setSpacing(3)
        self._whole.addWidget(self.scrolled, 1)
        self._whole.addWidget(progress)
        self._place_judge(is_wide=False)

    def _place_judge(self, is_wide: bool) -> None:
        (self._side if is_wide else self._whole).insertWidget(1, self._judge)

    def arrange(self, is_wide: bool) -> None:
        """A wide dock is mostly a low one: the tabs have its whole height, beside windows and judgement."""
        is_high = not is_wide and self.height() > _HIGH_LINES * self.fontMetrics().height()
        self._windows.table.set_fewest_rows(0 if is_wide else _FEWEST_ROWS)
        self._judge.set_high(is_high)
        orientation = Qt.Orientation.Horizontal if is_wide else Qt.Orientation.Vertical
        if orientation == self._splitter.orientation():
            return
        self._splitter.setOrientation(orientation)
        self._splitter.setSizes(_SHARES)
        direction = QBoxLayout.Direction
        self._head.setDirection(direction.LeftToRight if is_wide else direction.TopToBottom)
        self._place_judge(is_wide)
