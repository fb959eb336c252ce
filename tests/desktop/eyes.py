"""What is wrong with the looks of a dock: nothing here knows how the dock was made."""
from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from qgis.PyQt.QtCore import QPoint, QRect, Qt
from qgis.PyQt.QtGui import QImage
from qgis.PyQt.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractScrollArea,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QHeaderView,
    QLabel,
    QLineEdit,
    QPushButton,
    QTabBar,
    QTableView,
    QWidget,
)

_CONTROLS = (QAbstractButton, QComboBox, QLineEdit, QAbstractSpinBox, QAbstractItemView)
_WHOLES = (QComboBox, QLineEdit, QAbstractSpinBox, QAbstractItemView, QTabBar)  # their parts are their own affair
_FRAMES = (  # of Qt and QGIS
    "qt_dockwidget_floatbutton", "qt_dockwidget_closebutton", "qt_toolbar_ext_button", "collapseButton"
)  # fmt: skip


def contrasts(dock: QWidget) -> dict[str, float]:
    """Contrasts of words that the dock draws in ways of its own with what they stand on, as WCAG 2.1 counts them."""
    ratios = {}
    for name, widget, box in _words(dock):
        seen = box.translated(widget.mapTo(dock, QPoint()))  # alone, a widget has no background but its own
        ratios[name] = round(_contrast(dock, seen), 1)
    return ratios


def _words(dock: QWidget) -> Iterator[tuple[str, QWidget, QRect]]:
    for widget in dock.findChildren(QWidget):
        if not widget.isVisible():
            continue
        if isinstance(widget, QLabel) and widget.text():
            yield f"label {widget.text()}", widget, widget.rect()
        elif isinstance(widget, QPushButton) and widget.isEnabled():
            yield f"button {widget.text()}", widget, widget.rect().adjusted(widget.width() // 3, 5, -5, -5)
        elif isinstance(widget, QTableView):
            yield from _headings(widget)


def _headings(table: QTableView) -> Iterator[tuple[str, QWidget, QRect]]:
    header = table.horizontalHeader()
    for column in range(header.count()):
        if not table.isColumnHidden(column):
            left, width = header.sectionViewportPosition(column), header.sectionSize(column)
            title = table.model().headerData(column, Qt.Orientation.Horizontal)
            yield f"heading {title}", header.viewport(), QRect(left + 1, 1, width - 4, header.height() - 4)


def _contrast(widget: QWidget, box: QRect) -> float:
    """The strongest one in a part of a widget with the colour that most of it has."""
    shades, counts = np.unique(_colours(widget, box).reshape(-1, 3), axis=0, return_counts=True)
    luminances = _luminance(shades)
    back = luminances[counts.argmax()]
    return float(np.max((np.maximum(back, luminances) + 0.05) / (np.minimum(back, luminances) + 0.05)))


def _colours(widget: QWidget, box: QRect) -> np.ndarray:
    """Blue, green and red of the pixels in a part of a widget, row by row."""
    image = widget.grab(box).toImage().convertToFormat(QImage.Format.Format_RGB32)
    if image.isNull():  # out of sight
        return np.empty((0, 0, 3), np.uint8)
    bits = image.constBits()
    bits.setsize(image.sizeInBytes())
    return np.frombuffer(bits, np.uint8).reshape(image.height(), image.width(), 4)[..., :3].copy()


def _luminance(colours: np.ndarray) -> np.ndarray:
    shares = colours / 255
    linear = np.where(shares <= 0.04045, shares / 12.92, ((shares + 0.055) / 1.055) ** 2.4)
    return linear @ (0.0722, 0.7152, 0.2126)


def cut_headings(table: QTableView) -> list[str]:
    """Headings that look otherwise where there is more room for them."""
    header, model = table.horizontalHeader(), table.model()
    shown = [column for column in range(header.count()) if not table.isColumnHidden(column)]
    sizes = {column: header.sectionSize(column) for column in shown}
    narrow = {column: _inked_columns(header, column) for column in shown}
    faults = []
    for column in shown:
        for other in shown:
            table.setColumnHidden(other, other != column)
        header.resizeSection(column, 2 * sizes[column])
        if abs(_inked_columns(header, column) - narrow[column]) > 2:
            faults.append(str(model.headerData(column, Qt.Orientation.Horizontal)))
    for column in shown:
        table.setColumnHidden(column, False)
        header.resizeSection(column, sizes[column])
    return faults


def _inked_columns(header: QHeaderView, column: int) -> int:
    """Columns of pixels in which something is written; the background may change from row to row."""
    left, width = header.sectionViewportPosition(column), header.sectionSize(column)
    colours = _colours(header.viewport(), QRect(left + 2, 2, width - 5, header.height() - 5)).astype(int)
    lightness = (colours.max(axis=2) + colours.min(axis=2)) // 2
    backs = np.array([np.bincount(row).argmax() for row in lightness])
    return int((abs(lightness - backs[:, None]) > 40).any(axis=0).sum())


def without_tooltip(dock: QWidget) -> list[str]:
    """Controls that don't say what they are for, in sight or not."""
    faults = [name_of(widget) for widget in dock.findChildren(QWidget) if _is_control(widget) and not widget.toolTip()]
    for bar in dock.findChildren(QTabBar):
        faults += [f"tab {bar.tabText(tab)}" for tab in range(bar.count()) if not bar.tabToolTip(tab)]
    return faults


def _is_control(widget: QWidget) -> bool:
    if not isinstance(widget, _CONTROLS) or widget.objectName() in _FRAMES:
        return False
    around = widget.parentWidget()
    while around is not None:
        if isinstance(around, _WHOLES):
            return False
        around = around.parentWidget()
    return not widget.isWindow()


def tab_stops(dock: QWidget) -> list[QWidget]:
    """What Tab leads to, in its order, from the one furthest up."""
    stops, widget = [], dock.nextInFocusChain()
    while widget is not dock:
        takes = bool(widget.focusPolicy() & Qt.FocusPolicy.TabFocus) and widget.focusProxy() is None
        if takes and widget.isVisible() and widget.isEnabled() and dock.isAncestorOf(widget):
            stops.append(widget)
        widget = widget.nextInFocusChain()
    first = min(range(len(stops)), key=lambda stop: _top(dock, stops[stop]))
    return stops[first:] + stops[:first]


def steps_up(dock: QWidget) -> list[str]:
    """Steps of Tab that go up, but into a column to the right, or to the left in a row."""
    faults = []
    stops = [stop for stop in tab_stops(dock) if not stop.visibleRegion().isEmpty()]  # else it is scrolled there
    for before, after in zip(stops, stops[1:]):
        down = _top(dock, after) - _top(dock, before)
        across = after.mapTo(dock, QPoint()).x() - before.mapTo(dock, QPoint()).x()
        if across >= before.width():
            continue
        is_same_row = abs(down) < min(before.height(), after.height()) / 2
        if (across < 0) if is_same_row else (down < 0):
            faults.append(f"{name_of(before)} > {name_of(after)}")
    return faults


def _top(dock: QWidget, widget: QWidget) -> int:
    return widget.mapTo(dock, QPoint()).y()


def without_focus_mark(dock: QWidget) -> list[str]:
    """What Tab leads to and looks with the focus as without."""
    faults, before = [], QApplication.focusWidget()
    for stop in tab_stops(dock):
        stop.clearFocus()
        QApplication.processEvents()
        without = stop.grab().toImage()
        stop.setFocus(Qt.FocusReason.TabFocusReason)
        QApplication.processEvents()
        if stop.hasFocus() and stop.grab().toImage() == without:
            faults.append(name_of(stop))
    if before is not None:
        before.setFocus()
    return faults


def name_of(widget: QWidget) -> str:
    """For a list of what is wrong."""
    text = getattr(widget, "text", str)() if not isinstance(widget, QAbstractScrollArea) else ""
    return f"{type(widget).__name__} {widget.objectName() or text or widget.accessibleName()}".strip()
