"""A box that folds to one line, which says what is in it."""
from __future__ import annotations

from qgis.gui import QgsCollapsibleGroupBoxBasic
from qgis.PyQt.QtCore import QSize, Qt, pyqtSignal
from qgis.PyQt.QtGui import QFontMetrics, QResizeEvent, QShowEvent
from qgis.PyQt.QtWidgets import QWidget

from .tooltips import plain_tip


class SummaryBox(QgsCollapsibleGroupBoxBasic):
    """A collapsible box whose title is cut to its width instead of widening it."""

    foldedByHand = pyqtSignal()
    """The operator folded or unfolded it."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.spared_width = 0
        """Pixels of the content's least width that another arrangement of it can do without."""
        self._name = self._rest = ""
        self._is_folding = False
        self._is_unapplied = False
        self.collapsedStateChanged.connect(self._tell)

    def set_summary(self, name: str, rest: str = "", problem: str = "") -> None:
        """The title, of which the name is cut first, and what is wrong, for the tooltip."""
        self._name, self._rest = name, rest
        self.setToolTip(plain_tip("\n".join(filter(None, (name + rest, problem)))))
        self._cut()

    def fold(self, folded: bool) -> None:
        """Fold or unfold it, now or, where it is hidden, when it is shown next."""
        if folded != self.isCollapsed():
            self._is_unapplied = not self.isVisible()
            self._set_folded(folded)

    def showEvent(self, event: QShowEvent) -> None:
        self._is_folding = True  # the base class tells its state when it is first shown
        super().showEvent(event)
        self._is_folding = False
        if self._is_unapplied:  # the base class only notes the state of a hidden box, and never comes back to it
            self._is_unapplied = False
            folded = self.isCollapsed()
            self._set_folded(not folded)
            self._set_folded(folded)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._cut()

    def minimumSizeHint(self) -> QSize:
        return QSize(self._content_width(), super().minimumSizeHint().height())

    def sizeHint(self) -> QSize:
        return QSize(self._content_width(), super().sizeHint().height())

    def _content_width(self) -> int:
        layout = self.layout()
        if layout is None or self.isCollapsed():
            return 0
        return layout.totalMinimumSize().width() - self.spared_width

    def _set_folded(self, folded: bool) -> None:
        self._is_folding = True
        self.setCollapsed(folded)
        self._is_folding = False

    def _tell(self, _folded: bool) -> None:
        if not self._is_folding:
            self.foldedByHand.emit()

    def _cut(self) -> None:
        font = self.font()
        font.setBold(True)  # as QGIS writes titles
        metrics = QFontMetrics(font)
        room = self.width() - 2 * metrics.height()  # less the arrow
        least = metrics.averageCharWidth() * 8
        name_room = max(room - metrics.horizontalAdvance(self._rest), least)
        title = metrics.elidedText(self._name, Qt.TextElideMode.ElideMiddle, name_room) + self._rest
        title = metrics.elidedText(title, Qt.TextElideMode.ElideRight, room).replace("&", "&&")
        if title != self.title():
            self.setTitle(title)
