"""The legend beside the curves: a list whose entries show and hide their curve."""
from __future__ import annotations

from collections.abc import Collection, Sequence

from qgis.PyQt.QtCore import QEvent, QPoint, QPointF, QSize, Qt, pyqtSignal
from qgis.PyQt.QtGui import QBrush, QColor, QIcon, QKeyEvent, QPainter, QPalette, QPen, QPixmap
from qgis.PyQt.QtWidgets import QAbstractItemView, QFrame, QListWidget, QListWidgetItem, QMenu, QWidget

from ..adapters.charts import ChartStyle, source_look
from ..adapters.curves import ChartCurve
from ..adapters.text import tr

_PENS = {
    "-": Qt.PenStyle.SolidLine,
    "--": Qt.PenStyle.DashLine,
    ":": Qt.PenStyle.DotLine,
    "-.": Qt.PenStyle.DashDotLine,
}
_KEY = Qt.ItemDataRole.UserRole
_SHOWN_CHARACTERS = 26  # of a name; a longer one is elided in its middle


class CurvesLegend(QListWidget):
    """One entry per curve: a piece of its line and its name. Hidden ones are grey and stay in the list."""

    toggled = pyqtSignal(object)  # key of a curve to show or hide
    soloed = pyqtSignal(object)  # key of the only curve to show beside the mosaic; None: show all
    entered = pyqtSignal(object)  # key of the curve under the mouse, or None

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setTextElideMode(Qt.TextElideMode.ElideMiddle)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setSelectionMode(QAbstractItemView.SelectionMode.NoSelection)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setUniformItemSizes(True)
        self.setMouseTracking(True)
        self.setToolTip(tr("Click an entry to hide its curve or to show it again; right click for more"))
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.itemClicked.connect(self._toggle)
        self.itemEntered.connect(self._enter)
        self.customContextMenuRequested.connect(self._open_menu)
        self._shown: object = None

    def sizeHint(self) -> QSize:
        """As wide as the names, within reason."""
        metrics = self.fontMetrics()
        names = (self.item(row).text() for row in range(self.count()))
        widest = max((metrics.horizontalAdvance(name) for name in names), default=0)
        text = min(widest, _SHOWN_CHARACTERS * metrics.averageCharWidth())
        return QSize(text + self.iconSize().width() + 2 * metrics.height(), 6 * metrics.height())

    def minimumSizeHint(self) -> QSize:
        """Room for a line's piece and the start of a name."""
        return QSize(5 * self.fontMetrics().height(), 3 * self.fontMetrics().height())

    def show_curves(
        self, curves: Sequence[ChartCurve], hidden: Collection[tuple[bool, str]], style: ChartStyle, has_limit: bool
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
                    tr("On or below this line the mosaic has lost significantly against the least sharp source")
                )
        for row, curve in enumerate(curves):
            self._look(self.item(row), curve, row, curve.key in hidden, style)
        if has_limit:
            self.item(len(curves)).setIcon(self._piece(QColor(style.limit), Qt.PenStyle.SolidLine, 0.15, 0))
        self.updateGeometry()

    def mark(self, key: tuple[bool, str] | None) -> None:
        """Underline the entry of the curve that the mouse points at in the chart."""
        for row in range(self.count()):
            item = self.item(row)
            font = item.font()
            if font.underline() != (key is not None and item.data(_KEY) == key):
                font.setUnderline(not font.underline())
                item.setFont(font)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in (Qt.Key.Key_Space, Qt.Key.Key_Return, Qt.Key.Key_Enter) and self.currentItem():
            self._toggle(self.currentItem())
        else:
            super().keyPressEvent(event)

    def leaveEvent(self, event: QEvent) -> None:
        self.entered.emit(None)
        super().leaveEvent(event)

    def _look(self, item: QListWidgetItem, curve: ChartCurve, row: int, is_hidden: bool, style: ChartStyle) -> None:
        group = QPalette.ColorGroup.Disabled if is_hidden else QPalette.ColorGroup.Active
        text = self.palette().color(group, QPalette.ColorRole.Text)
        if curve.is_mosaic:
            colour, line = style.text, "-"
        else:
            colour, line = source_look(row - 1 if curve.colour is None else curve.colour, style)
        font = item.font()
        font.setBold(curve.is_mosaic)
        item.setFont(font)
        item.setForeground(QBrush(text))
        width, radius = (0.22, 0.3) if curve.is_mosaic else (0.11, 0.19)
        item.setIcon(self._piece(text if is_hidden else QColor(colour), _PENS[line], width, radius))
        click = tr("Click to show this curve") if is_hidden else tr("Click to hide this curve")
        item.setToolTip(f"{curve.label}\n{click}")

    def _piece(self, colour: QColor, pen: Qt.PenStyle, width: float, radius: float) -> QIcon:
        """A piece of a line with one of its points, sizes in heights of the icon."""
        size, ratio = self.iconSize(), self.devicePixelRatioF()
        pixmap = QPixmap(size * ratio)
        pixmap.setDevicePixelRatio(ratio)
        pixmap.fill(Qt.GlobalColor.transparent)
        height, middle = size.height(), size.height() / 2
        painter = QPainter(pixmap)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(colour, width * height, pen, Qt.PenCapStyle.FlatCap))
        painter.drawLine(QPointF(0, middle), QPointF(size.width(), middle))
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(colour)
        painter.drawEllipse(QPointF(size.width() / 2, middle), radius * height, radius * height)
        painter.end()
        icon = QIcon()
        for mode in (QIcon.Mode.Normal, QIcon.Mode.Selected, QIcon.Mode.Active):
            icon.addPixmap(pixmap, mode)
        return icon

    def _toggle(self, item: QListWidgetItem) -> None:
        if item.data(_KEY) is not None:
            self.toggled.emit(item.data(_KEY))

    def _enter(self, item: QListWidgetItem) -> None:
        self.entered.emit(item.data(_KEY))

    def _open_menu(self, position: QPoint) -> None:
        item = self.itemAt(position)
        menu = QMenu(self)
        is_source = item is not None and item.data(_KEY) is not None and not item.data(_KEY)[0]
        alone = menu.addAction(tr("Show only this source")) if is_source else None
        everything = menu.addAction(tr("Show all curves"))
        chosen = menu.exec(self.mapToGlobal(position))
        menu.deleteLater()
        if chosen is not None and chosen in (alone, everything):
            self.soloed.emit(item.data(_KEY) if chosen == alone else None)
