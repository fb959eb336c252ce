"""The checkable list of the project's rasters as sources."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Optional

from qgis.core import QgsProject
from qgis.PyQt.QtCore import QModelIndex, QSize, Qt, pyqtSignal
from qgis.PyQt.QtGui import QPalette
from qgis.PyQt.QtWidgets import (
    QAbstractItemView,
    QGridLayout,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QSizePolicy,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QToolButton,
    QWidget,
)

from ....toolkit.desk.layer_box import missing_text
from ....toolkit.desk.theme import blended, readable_on, readable_palette
from ....toolkit.desk.widgets import plain_tip
from ....toolkit.translation import filled, sentence, tr
from ...measure.inputs.raster_facts import Suitability
from .source_suggestions import file_rasters

_ID, _REASON, _FAINT = (Qt.ItemDataRole.UserRole + place for place in range(3))
_FAINT_SHARE = 0.65  # of the words' colour, where a raster is no source
_FEWEST_ROWS = 4  # seen without scrolling

Sources = tuple[str, ...]
Standings = Callable[[str], Optional["Suitability"]]


@dataclass(frozen=True)
class _Entry:
    """One line of the list."""

    layer_id: str
    text: str
    tip: str
    is_missing: bool = False
    reason: str = ""  # why it is not suggested


class _Names(QStyledItemDelegate):
    """Cuts long names in their middle, as they often differ at their end only, and reasons at their end.

    What is no source is faint, and can be read all the same in whatever theme QGIS has.
    """

    def initStyleOption(self, option: QStyleOptionViewItem, index: QModelIndex) -> None:
        super().initStyleOption(option, index)
        has_reason = bool(index.data(_REASON))
        option.textElideMode = Qt.TextElideMode.ElideRight if has_reason else Qt.TextElideMode.ElideMiddle
        palette = readable_palette(self.parent())
        text, back = palette.color(QPalette.ColorRole.Text), palette.color(QPalette.ColorRole.Base)
        if index.data(_FAINT):
            text = readable_on(back, blended(text, back, _FAINT_SHARE))
        option.palette.setColor(QPalette.ColorRole.Text, text)

    def sizeHint(self, option: QStyleOptionViewItem, index: QModelIndex) -> QSize:
        """With some air between the boxes, which Qt 6 does without."""
        return super().sizeHint(option, index).expandedTo(QSize(0, option.fontMetrics.height() + 2))


class SourceList(QWidget):
    """The rasters of the project but the mosaic; sources that are missing stay in it until they are unchecked."""

    changed = pyqtSignal(tuple)  # the operator chose other sources: their layers' ids
    suggestionWanted = pyqtSignal()  # the operator wants the suggested sources, and no others

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._entries: list[_Entry] = []
        self._is_following = False
        self.list = QListWidget(self)
        self.suggested = self._button(
            tr("suggested"), tr("Tick only the rasters that may be sources of this mosaic")
        )
        self.none = self._button(tr("none"), tr("Untick all rasters and remove missing ones"))
        self.list.setToolTip(
            tr("The orthoimages that the mosaic was made from. The reason stands beside each one that is left out; "
               "tick it to use it anyway. Untick a missing one to remove it from the inputs.")
        )
        self.list.setAccessibleName(tr("Sources"))
        self.list.setItemDelegate(_Names(self.list))
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.list.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.list.setUniformItemSizes(True)
        self.list.setMinimumHeight(round((_FEWEST_ROWS + 0.5) * 1.3 * self.fontMetrics().height()))
        self.list.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Ignored)
        label = QLabel(tr("&Sources"), self)
        label.setBuddy(self.list)
        layout = QGridLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setHorizontalSpacing(2)
        layout.setVerticalSpacing(2)
        layout.setColumnStretch(0, 1)
        for column, widget in enumerate((label, self.suggested, self.none)):
            layout.addWidget(widget, 0, column)
        layout.addWidget(self.list, 1, 0, 1, 3)
        layout.setRowStretch(1, 1)
        self.list.itemChanged.connect(self._tell)
        self.suggested.clicked.connect(self.suggestionWanted)
        self.none.clicked.connect(self._check_none)

    def fields(self) -> tuple[QWidget, ...]:
        """In tab order."""
        return self.suggested, self.none, self.list

    def show_sources(self, mosaic_id: str, sources: Sources, standing: Standings) -> None:
        """Show the rasters of the project with the sources checked; ``standing`` says which are suggested."""
        entries = _entries(mosaic_id, sources, standing)
        chosen = set(sources)
        self._is_following = True
        try:
            if entries != self._entries:  # else the list keeps where it was scrolled to
                self._entries = entries
                self._fill()
            for row in range(self.list.count()):
                item = self.list.item(row)
                is_source = item.data(_ID) in chosen
                item.setCheckState(Qt.CheckState.Checked if is_source else Qt.CheckState.Unchecked)
                is_plain = is_source or not item.data(_REASON)
                item.setData(_FAINT, not is_plain or item.font().italic())
        finally:
            self._is_following = False
        standings = [standing(entry.layer_id) for entry in entries]
        self.suggested.setEnabled(any(standing is not None and standing.is_suggested for standing in standings))
        self.none.setEnabled(bool(sources))

    def checked(self) -> Sources:
        """Layer ids of the checked rasters, missing ones included."""
        items = [self.list.item(row) for row in range(self.list.count())]
        return tuple(item.data(_ID) for item in items if item.checkState() == Qt.CheckState.Checked)

    def _fill(self) -> None:
        scrolled = self.list.verticalScrollBar().value()
        self.list.clear()
        for entry in self._entries:
            item = QListWidgetItem(entry.text, self.list)
            item.setData(_ID, entry.layer_id)
            item.setToolTip(plain_tip(entry.tip))
            item.setFlags(item.flags() | Qt.ItemFlag.ItemIsUserCheckable)
            font = item.font()
            font.setItalic(entry.is_missing)
            item.setFont(font)
            item.setData(_REASON, entry.reason)
        self.list.verticalScrollBar().setValue(scrolled)

    def _button(self, text: str, tip: str) -> QToolButton:
        button = QToolButton(self)
        button.setText(text)
        button.setToolTip(tip)
        button.setAutoRaise(True)
        button.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        return button

    def _check_none(self) -> None:
        self.changed.emit(())

    def _tell(self, _item: QListWidgetItem) -> None:
        if not self._is_following:
            self.changed.emit(self.checked())


def _entries(mosaic_id: str, sources: Sources, standing: Standings) -> list[_Entry]:
    """Missing sources first, then the suggested ones, last those that are left out, each by name."""
    rasters = [layer for layer in file_rasters() if layer.id() != mosaic_id]
    there = {layer.id() for layer in rasters}
    entries = []
    for source in sources:
        if source not in there and source != mosaic_id:
            layer = QgsProject.instance().mapLayer(source)
            name = filled(tr("missing: {name}"), name=layer.name()) if layer is not None else missing_text(source)
            tip = filled(tr("Not in the project any more, or its file can't be opened: {name}"), name=source)
            entries.append(_Entry(source, name, tip, is_missing=True))
    fit: list[_Entry] = []
    unfit: list[_Entry] = []
    for layer in rasters:
        suitability = standing(layer.id())
        reason = sentence(suitability.reason) if suitability is not None and suitability.reason is not None else ""
        text = f"{layer.name()} \u2013 {reason}" if reason else layer.name()
        tip = "\n".join(filter(None, (reason, layer.source())))
        (unfit if reason else fit).append(_Entry(layer.id(), text, tip, reason=reason))
    return [*entries, *fit, *unfit]
