"""Small widgets that docks share, and what widgets lack: timers, tooltips, reasons for being grey, a question."""
from __future__ import annotations

import re
from collections.abc import Sequence
from html import escape
from itertools import chain
from typing import Any

from qgis.core import QgsProject, QgsProviderRegistry, QgsVectorLayer
from qgis.gui import QgsCollapsibleGroupBoxBasic, QgsMapLayerComboBox
from qgis.PyQt import QtGui, QtWidgets
from qgis.PyQt.QtCore import QEvent, QObject, QSize, Qt, QTimer, pyqtSignal
from qgis.PyQt.QtGui import QDropEvent, QFontMetrics, QMouseEvent, QResizeEvent, QShowEvent

from ..translation import filled, tr
from ..version_differences import layer_filters

QUndoStack: Any = getattr(QtWidgets, "QUndoStack", None) or QtGui.QUndoStack
QUndoCommand: Any = getattr(QtWidgets, "QUndoCommand", None) or QtGui.QUndoCommand
"""Qt 5 has both among its widgets, Qt 6 does not."""


def is_confirmed(widget: QtWidgets.QWidget, question: str) -> bool:
    """Whether the user says yes; no is what Enter says."""
    yes, no = QtWidgets.QMessageBox.StandardButton.Yes, QtWidgets.QMessageBox.StandardButton.No
    return bool(QtWidgets.QMessageBox.question(widget, tr("Seam Inspector"), question, yes | no, no) == yes)


_TIP = "seam_inspector_tip"


def allow(action: QtWidgets.QAction, why_not: str = "") -> None:
    """Enable an action; with a reason against it, grey it and hang the reason on its tooltip."""
    if action.property(_TIP) is None:
        action.setProperty(_TIP, action.toolTip())
    tip = str(action.property(_TIP))
    action.setEnabled(not why_not)
    action.setToolTip(f"{tip}\n\n{why_not}" if why_not else tip)


def single_shot(parent: QObject, slot: Any, wait_ms: int = 0) -> QTimer:
    """Calls a slot, or emits a signal, once after each ``start``; one more ``start`` begins the waiting anew."""
    timer = QTimer(parent)
    timer.setSingleShot(True)
    timer.setInterval(wait_ms)
    timer.timeout.connect(slot)
    return timer


def rich_tip(text: str, *lines: str) -> str:
    """Qt breaks the lines of a tooltip only when it is rich text; ``lines`` stand below it."""
    below = f"<p>{'<br>'.join(map(escape, lines))}</p>" if lines else ""
    return f"<p>{escape(text)}</p>{below}"


def plain_tip(text: str) -> str:
    """A tooltip of names that others gave: its lines as they are, whatever markup Qt would see in them."""
    first, *lines = text.splitlines() or [""]
    return rich_tip(first, *lines) if "<" in text or "&" in text else text


_WRAPPED = int(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter) | int(Qt.TextFlag.TextWordWrap)


class ClippedLabel(QtWidgets.QLabel):
    """Plain text on at most so many lines, as high as they are whatever it says, so that nothing around it jumps;
    of a range of lines as high as it needs.

    What does not fit ends in an ellipsis; the tooltip tells all of it, which a click shows at once.
    """

    def __init__(self, lines: int, parent: QtWidgets.QWidget | None = None, most: int = 0) -> None:
        """``most``: lines, where the height follows the text."""
        super().__init__(parent)
        self._fewest, self._most = lines, max(lines, most)
        self._text = ""
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setWordWrap(True)
        self.setMinimumWidth(10 * self.fontMetrics().averageCharWidth())
        self.setSizePolicy(QtWidgets.QSizePolicy.Policy.Ignored, QtWidgets.QSizePolicy.Policy.Fixed)
        self._fit()

    def text(self) -> str:
        """The whole text."""
        return self._text

    def setText(self, text: str, tip: str = "") -> None:
        """Say something else; ``tip``: more than that, as rich text, for the tooltip."""
        self.setToolTip(tip or (rich_tip(text) if text else ""))
        if text != self._text:
            self._text = text
            self.setAccessibleName(text)
            self._fit()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if event.oldSize().width() != event.size().width():
            self._fit()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        QtWidgets.QToolTip.showText(self.mapToGlobal(event.pos()), self.toolTip(), self)

    def _fit(self) -> None:
        """Take as many lines as the text needs, and as there may be, and show what they have room for."""
        lines = self._fewest if self._text or self._fewest == self._most else 1
        while lines < self._most and not self._fits(self._text, lines):
            lines += 1
        shown = self._text
        if not self._fits(shown, lines):
            shortest, longest = 0, len(shown)
            while longest - shortest > 1:
                middle = (shortest + longest) // 2
                if self._fits(shown[:middle].rstrip() + "…", lines):
                    shortest = middle
                else:
                    longest = middle
            shown = shown[:shortest].rstrip() + "…"
        super().setText(with_units(shown))
        margins = self.contentsMargins()
        self.setFixedHeight(_height(self.fontMetrics(), lines) + margins.top() + margins.bottom())
        self.setCursor(Qt.CursorShape.ArrowCursor if shown == self._text else Qt.CursorShape.PointingHandCursor)

    def _fits(self, text: str, lines: int) -> bool:
        width, metrics = self.contentsRect().width(), self.fontMetrics()
        needed = metrics.boundingRect(0, 0, width, 10000, _WRAPPED, with_units(text))
        return needed.height() <= _height(metrics, lines) and needed.width() <= width


def with_units(text: str) -> str:
    """The text without line breaks between a number and its unit."""
    return re.sub(r"(?<=\d) (?=(?:%|m²|m|px)(?!\w))", "\u00a0", text)


def _height(metrics: QFontMetrics, lines: int) -> int:
    return metrics.boundingRect(0, 0, 10000, 10000, _WRAPPED, "\n".join("X" * lines)).height()


_STYLES = Qt.ToolButtonStyle


class FittingToolBar(QtWidgets.QToolBar):
    """A tool bar that fits: of the ``worded`` actions the last ones lose their icons first, and then their words, for
    an icon; the others are icons throughout."""

    def __init__(self, actions: Sequence[QtWidgets.QAction], worded: Sequence[QtWidgets.QAction]) -> None:
        super().__init__()
        side = self.fontMetrics().height() + 3
        self.setIconSize(QSize(side, side))
        self.setToolButtonStyle(_STYLES.ToolButtonIconOnly)
        self.addActions(actions)
        self._worded = [self.widgetForAction(action) for action in worded]
        for action in actions:
            self.widgetForAction(action).setFocusPolicy(Qt.FocusPolicy.TabFocus)  # a toolbar takes it from them
        self._whole = 0
        self._fit()

    def sizeHint(self) -> QSize:
        """The size with all words."""
        return QSize(self._whole, super().sizeHint().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.LanguageChange) and hasattr(self, "_whole"):
            self._fit()

    def _fit(self) -> None:
        for button in self._worded:
            button.setToolButtonStyle(_STYLES.ToolButtonTextBesideIcon)
        self._whole = super().sizeHint().width()
        for style in (_STYLES.ToolButtonTextOnly, _STYLES.ToolButtonIconOnly):
            for button in reversed(self._worded):
                if super().sizeHint().width() <= self.width():
                    return
                button.setToolButtonStyle(style)


_FIELDS = QtWidgets.QComboBox, QtWidgets.QAbstractSpinBox
_FEWEST_LINES = 12  # of the font, that a dock can be made as low as


class CornerTabs(QtWidgets.QTabWidget):
    """Tabs whose bar is no lower than the widget in their corner, which Qt cuts to the bar's height."""

    def __init__(self) -> None:
        super().__init__()
        self.setTabBar(_CornerTabBar(self))


class _CornerTabBar(QtWidgets.QTabBar):
    def tabSizeHint(self, index: int) -> QSize:
        size, tabs = super().tabSizeHint(index), self.parentWidget()
        corner = tabs.cornerWidget() if isinstance(tabs, QtWidgets.QTabWidget) else None
        if corner is None:
            return size
        overlap = self.style().pixelMetric(QtWidgets.QStyle.PixelMetric.PM_TabBarBaseOverlap, None, self)
        return size.expandedTo(QSize(0, corner.sizeHint().height() + overlap))


class ScrollBody(QtWidgets.QScrollArea):
    """Scrolls up and down only; never narrower than its content. The wheel leaves unfocused fields as they are."""

    def __init__(self, content: QtWidgets.QWidget) -> None:
        super().__init__()
        self.setFrameShape(QtWidgets.QFrame.Shape.NoFrame)
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setWidget(content)
        content.setAutoFillBackground(False)
        self.viewport().setAutoFillBackground(False)
        for field in chain(*map(content.findChildren, _FIELDS)):
            field.setFocusPolicy(Qt.FocusPolicy.StrongFocus)  # not by the wheel
            field.installEventFilter(self)
        content.installEventFilter(self)

    def minimumSizeHint(self) -> QSize:
        least = self.widget().minimumSizeHint()
        lines = _FEWEST_LINES * self.fontMetrics().height()
        bar = self.style().pixelMetric(QtWidgets.QStyle.PixelMetric.PM_ScrollBarExtent, None, self)
        return QSize(least.width() + (bar if self.verticalScrollBar().isVisible() else 0), min(least.height(), lines))

    def sizeHint(self) -> QSize:
        return self.widget().sizeHint()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        is_field = isinstance(watched, _FIELDS)  # and not the scroll bar, which Qt has us filter
        if is_field and event.type() == QEvent.Type.Wheel and not watched.hasFocus():
            event.ignore()
            return True
        if event.type() == QEvent.Type.LayoutRequest and watched is self.widget():
            self.updateGeometry()
        return bool(super().eventFilter(watched, event))


class SummaryBox(QgsCollapsibleGroupBoxBasic):
    """A collapsible box whose title is cut to its width instead of widening it."""

    def __init__(self, parent: QtWidgets.QWidget | None = None) -> None:
        super().__init__(parent)
        self._name = self._rest = ""
        self._is_unapplied = False

    def set_summary(self, name: str, rest: str = "", problem: str = "") -> None:
        """The title, of which the name is cut first, and what is wrong, for the tooltip."""
        self._name, self._rest = name, rest
        self.setToolTip(plain_tip("\n".join(filter(None, (name + rest, problem)))))
        self._cut()

    def fold(self, folded: bool) -> None:
        """Fold or unfold it, now or, where it is hidden, when it is shown next."""
        if folded != self.isCollapsed():
            self._is_unapplied = not self.isVisible()
            self.setCollapsed(folded)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        if self._is_unapplied:  # the base class only notes the state of a hidden box, and never comes back to it
            self._is_unapplied = False
            folded = self.isCollapsed()
            self.setCollapsed(not folded)
            self.setCollapsed(folded)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._cut()

    def minimumSizeHint(self) -> QSize:
        return QSize(self._content_width(), super().minimumSizeHint().height())

    def sizeHint(self) -> QSize:
        return QSize(self._content_width(), super().sizeHint().height())

    def _content_width(self) -> int:
        layout = self.layout()
        return 0 if layout is None or self.isCollapsed() else int(layout.totalMinimumSize().width())

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


_UUID = re.compile(r"_[0-9a-f]{8}(_[0-9a-f]{4}){3}_[0-9a-f]{12}$")  # what QGIS hangs on a name to make it an id


def missing_text(layer_id: str) -> str:
    """Text for a layer that is not in the project: by the name it had when it was loaded."""
    return filled(tr("missing: {name}"), name=_UUID.sub("", layer_id))


def vectors_without(field: str) -> list[QgsVectorLayer]:
    """The project's vector layers that lack a field."""
    layers = QgsProject.instance().mapLayers().values()
    return [layer for layer in layers if isinstance(layer, QgsVectorLayer) and field not in layer.fields().names()]


class LayerBox(QgsMapLayerComboBox):
    """Layers of the project, none, or one that is missing.

    When its layer is removed the base class goes on to the next one and emits ``layerChanged`` as for a choice.
    """

    chosen = pyqtSignal(str)  # the operator chose a layer, by its id, or none

    def __init__(self, filters: Any, nothing: str, parent: QtWidgets.QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFilters(layer_filters(filters))
        self.setAllowEmptyLayer(True, nothing)
        self.setMinimumContentsLength(8)  # a long name must not widen the dock
        self.setSizeAdjustPolicy(self.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self._left_out: set[str] = set()
        self._missing = ""  # the last item, which stands for a layer that can't be chosen
        self.activated.connect(self._tell)

    def show_layer(self, layer_id: str) -> None:
        """Show a layer by its id, whether it is there or not."""
        layer = QgsProject.instance().mapLayer(layer_id) if layer_id else None
        self._show_missing(missing_text(layer_id) if layer_id and layer is None else "")
        if layer is not None:
            self.setLayer(layer)
            if self.currentLayer() is not layer:
                self._show_missing(filled(tr("can't be used: {name}"), name=layer.name()))
        elif not layer_id:
            self.setCurrentIndex(0)

    def leave_out(self, layers: Sequence[QgsVectorLayer]) -> None:
        """Offer these layers no more."""
        ids = {layer.id() for layer in layers}
        if ids != self._left_out:
            self._left_out = ids
            self.setExceptedLayerList(list(layers))

    def only_files(self) -> None:
        """Offer only rasters that GDAL reads: pixels from a service can't be measured."""
        self.setExcludedProviders([name for name in QgsProviderRegistry.instance().providerList() if name != "gdal"])

    def dropEvent(self, event: QDropEvent) -> None:
        super().dropEvent(event)
        self._tell()

    def _show_missing(self, text: str) -> None:
        if text != self._missing:
            self._missing = text
            self.setAdditionalItems([text] if text else [])
        if text:
            self.setCurrentIndex(self.count() - 1)

    def _tell(self, *_: object) -> None:
        layer = self.currentLayer()
        if layer is not None:
            self.chosen.emit(layer.id())
        elif self.currentIndex() == 0:
            self.chosen.emit("")
