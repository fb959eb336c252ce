"""The legend below the curves: a list whose entries show and hide their curve."""
from __future__ import annotations

from collections.abc import Collection, Sequence

from qgis.PyQt.QtCore import QModelIndex, QRectF, QSize, Qt, pyqtSignal
from qgis.PyQt.QtGui import QColor, QIcon, QKeyEvent, QPixmap, QResizeEvent
from qgis.PyQt.QtWidgets import (
    QAbstractItemView,
    QFrame,
    QListView,
    QListWidget,
    QListWidgetItem,
    QStyle,
    QStyleOptionViewItem,
    QWidget,
)

from ....toolkit.charts.chart_style import ChartStyle
from ....toolkit.desk.theme import ReadableItems, blended, plain_icon
from ....toolkit.desk.widgets import plain_tip
from ....toolkit.painting import painting
from ....toolkit.translation import tr
from ...charts.chart_curves import ChartCurve, Key, numbered
from ...charts.curves_painter import PenStyle, curve_look, paint_piece

_KEY = Qt.ItemDataRole.UserRole
_HIDDEN_SHARE = 0.55  # of the text's colour: fainter, and still to be read
_SHOWN_CHARACTERS = 20  # of a name, elided in its middle, so that two of them fit into a narrow dock
_MOST_ACROSS = 4  # names in a row; more are hard to scan


class CurvesLegend(QListWidget):
    """One entry per curve: a piece of its line and its name. Hidden ones are grey and stay in the list."""

    toggled = pyqtSignal(object)  # key of a curve to show or hide

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setTextElideMode(Qt.TextElideMode.ElideMiddle)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setSelectionMode(QAbstractItemView.SelectionMode.NoSelection)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setUniformItemSizes(True)
        self.setResizeMode(QListView.ResizeMode.Adjust)
        self.setFlow(QListView.Flow.LeftToRight)
        self.setWrapping(True)
        self.setItemDelegate(_Entries(self))
        self.setToolTip(tr("Click an entry to hide its curve or to show it again"))
        self.itemClicked.connect(self._toggle)
        self._shown: object = None

    def entry_size(self) -> QSize:
        """Size of each entry: a share of the width."""
        room = self.maximumViewportSize().width() - self._kept_free()
        return QSize(room // self._columns(room), round(1.1 * self.fontMetrics().height()))

    def height_within(self, width: int, most: int) -> int:
        """Height of the rows that the entries fill in this width; only whole rows, and at least one."""
        around, entry = self.height() - self.viewport().height(), self.entry_size().height()
        rows = -(-self.count() // self._columns(width - around - self._kept_free()))
        return max(1, min(rows, (most - around) // entry)) * entry + around + 2

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.scheduleDelayedItemsLayout()

    def _kept_free(self) -> int:
        """Width kept free: Qt leaves room for a scroll bar where there is none, and breaks rows that reach into it."""
        return int(self.style().pixelMetric(QStyle.PixelMetric.PM_ScrollBarExtent, None, self)) + 4

    def _columns(self, width: int) -> int:
        return max(1, min(width // max(self._entry_width(), 1), self.count(), _MOST_ACROSS))

    def _entry_width(self) -> int:
        """Piece and longest name, within reason."""
        metrics = self.fontMetrics()
        names = (self.item(row).text() for row in range(self.count()))
        widest = max((metrics.horizontalAdvance(name) for name in names), default=0)
        text = min(widest, _SHOWN_CHARACTERS * metrics.averageCharWidth())
        return text + self.iconSize().width() + metrics.height()

    def show_curves(
        self, curves: Sequence[ChartCurve], hidden: Collection[Key], style: ChartStyle, has_limit: bool
    ) -> None:
        """Fill the list; ``hidden`` holds the keys of those to grey."""
        shown = (tuple(curves), frozenset(hidden), style, has_limit, self.font().key())
        if shown == self._shown:
            return
        self._shown = shown
        line = self.fontMetrics().height()
        self.setIconSize(QSize(int(1.6 * line), line))
        keys: list[object] = [*(curve.key for curve in curves), *([None] if has_limit else [])]
        if keys != [self.item(row).data(_KEY) for row in range(self.count())]:
            self.clear()
            for curve in curves:
                item = QListWidgetItem(curve.label, self)
                item.setData(_KEY, curve.key)
            if has_limit:
                item = QListWidgetItem(tr("limit"), self)
                item.setToolTip(
                    tr("On or below this line a loss is significant by curves: against the sources (paper), or their "
                       "composite")
                )
        for row, (number, curve) in enumerate(numbered(curves)):
            self._look(self.item(row), curve, number, curve.key in hidden, style)
        if has_limit:
            self.item(len(curves)).setIcon(self._piece(QColor(style.limit), Qt.PenStyle.SolidLine, 0.15, 0))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in (Qt.Key.Key_Space, Qt.Key.Key_Return, Qt.Key.Key_Enter) and self.currentItem():
            self._toggle(self.currentItem())
        else:
            super().keyPressEvent(event)

    def _look(self, item: QListWidgetItem, curve: ChartCurve, number: int, is_hidden: bool, style: ChartStyle) -> None:
        colour, line = curve_look(curve, number, style)
        font = item.font()
        font.setBold(curve.is_mosaic)
        item.setFont(font)
        text, ground = QColor(style.text), QColor(style.background)
        item.setData(Qt.ItemDataRole.ForegroundRole, blended(text, ground, _HIDDEN_SHARE) if is_hidden else None)
        width, radius = (0.22, 0.3) if curve.is_mosaic else (0.11, 0.19)
        piece = blended(text, ground, 0.3) if is_hidden else QColor(colour)
        item.setIcon(self._piece(piece, line, width, radius))
        click = tr("Click to show this curve") if is_hidden else tr("Click to hide this curve")
        label = curve.label
        if curve.is_composite:
            label = tr("What a hard cut of the sources along the seam, levelled to the mosaic's tone, would have")
        item.setToolTip(plain_tip(f"{label}\n{click}"))

    def _piece(self, colour: QColor, line: PenStyle, width: float, radius: float) -> QIcon:
        """A piece of a line with one of its points, sizes in heights of the icon."""
        size, ratio = self.iconSize(), self.devicePixelRatioF()
        pixmap = QPixmap(size * ratio)
        pixmap.setDevicePixelRatio(ratio)
        pixmap.fill(Qt.GlobalColor.transparent)
        with painting(pixmap) as painter:
            paint_piece(painter, QRectF(0, 0, size.width(), size.height()), colour, line, width, radius)
        return plain_icon(pixmap)

    def _toggle(self, item: QListWidgetItem) -> None:
        if item.data(_KEY) is not None:
            self.toggled.emit(item.data(_KEY))


class _Entries(ReadableItems):
    def __init__(self, legend: CurvesLegend) -> None:
        super().__init__(legend)
        self._legend = legend

    def sizeHint(self, option: QStyleOptionViewItem, index: QModelIndex) -> QSize:
        return self._legend.entry_size()
