"""The view of the windows' table: widths from the font and the room there is, keys, a hint when it is empty."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from qgis.PyQt.QtCore import QEvent, QItemSelection, QModelIndex, QPoint, QSize, Qt, pyqtSignal
from qgis.PyQt.QtGui import QFontMetrics, QKeyEvent, QKeySequence, QPainter, QPaintEvent, QPalette, QResizeEvent
from qgis.PyQt.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QMenu,
    QStyle,
    QStyleOptionHeader,
    QTableView,
    QWidget,
)

from ....toolkit.desk.theme import ReadableItems, readable_palette
from ....toolkit.translation import tr
from ...cause_words import cause_word
from ...measure.causes import Cause
from ...verdict_words import VERDICTS, observer_word, verdict_word
from .column_choice import ColumnChoice, columns_menu, load_choice, save_choice
from .windows_columns import CAUSE, PAPER, TableColumn
from .windows_filter import WindowsFilter
from .windows_model import WindowsModel

Widths = tuple[int, int, int]
"""Of a column, px: with words cut short, with all of them, with air."""
_LEAST, _NATURAL, _AIRY = range(3)
_GIVING_WAY = ("sources", "remark_2", "remark", "confidence_2", "confidence", "ratio")


class WindowsTable(QTableView):
    """Whole rows are selected. Delete and Enter are the table's own while it has the focus."""

    removeRequested = pyqtSignal()
    copyRequested = pyqtSignal()
    zoomRequested = pyqtSignal()

    def __init__(self, windows: WindowsModel, shown: WindowsFilter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.hint = ""
        """What is said in the middle of an empty table."""
        self._windows = windows
        self._shown = shown
        self._has_stale = False
        self._choice = load_choice()
        self._blind: frozenset[str] | None = None  # columns that tell nothing; None: all may be seen
        self.setModel(shown)
        self.setItemDelegate(ReadableItems(self))
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.setAlternatingRowColors(True)
        self.setShowGrid(False)
        self.setWordWrap(False)
        self.setTabKeyNavigation(False)
        self.setSortingEnabled(True)
        self.sortByColumn(0, Qt.SortOrder.AscendingOrder)
        self.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.verticalHeader().hide()
        self.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        header = self.horizontalHeader()
        header.setStretchLastSection(True)
        header.setHighlightSections(False)
        header.setTextElideMode(Qt.TextElideMode.ElideRight)
        header.setMinimumSectionSize(1)
        header.sortIndicatorChanged.connect(self.fit)  # the arrow needs room in its column
        header.setSectionsMovable(True)
        header.sectionMoved.connect(self._keep_order)
        header.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        header.customContextMenuRequested.connect(self._show_columns_menu)
        shown.modelReset.connect(self.show_sorting)
        self._put_in_order()
        self.fit()

    def selected_rows(self) -> list[int]:
        """In ascending order."""
        ranges = self.selectionModel().selection()
        return sorted({row for each in ranges for row in range(each.top(), each.bottom() + 1)})

    def selected_fids(self) -> list[int]:
        """From top to bottom."""
        fids = self._shown.fids()
        return [fids[row] for row in self.selected_rows()]

    def rows_selection(self, rows: list[int]) -> QItemSelection:
        """Rows, in ascending order, as a selection."""
        selection = QItemSelection()
        first = 0
        for place, row in enumerate(rows):
            if place + 1 == len(rows) or rows[place + 1] != row + 1:
                selection.select(self._shown.index(rows[first], 0), self._shown.index(row, 0))
                first = place + 1
        return selection

    def is_in_sight(self, row: int) -> bool:
        """Whether the row is in the visible part of the table."""
        rect = self.visualRect(self._shown.index(row, 0))
        return rect.top() >= 0 and rect.bottom() < max(self.viewport().height(), rect.height())

    def visible_columns(self) -> list[TableColumn]:
        """Those that are seen, from left to right."""
        header, columns = self.horizontalHeader(), self._windows.columns
        sections = (header.logicalIndex(place) for place in range(header.count()))
        return [columns[section] for section in sections if not self.isColumnHidden(section)]

    def set_fewest_rows(self, rows: int) -> None:
        """Show at least so many; 0: as few as there is room for."""
        around = self.horizontalHeader().sizeHint().height() + 2 * self.frameWidth()
        self.setMinimumHeight(around + rows * self.verticalHeader().defaultSectionSize() if rows else 0)

    def set_blind(self, own: frozenset[str] | None) -> None:
        """Show no other columns than these, by their fields, whatever was chosen; None: all that were chosen."""
        if own != self._blind:
            self._blind = own
            self._windows.is_blind = own is not None
            self.fit()

    def fit(self) -> None:
        """Widths and heights for this font, these columns and this much room."""
        metrics = QFontMetrics(self.font())
        side = metrics.ascent()
        self.setIconSize(QSize(side, side))
        self.verticalHeader().setDefaultSectionSize(metrics.height() + metrics.height() // 3)
        self._has_stale = self._windows.has_stale
        room, columns, chosen = self.viewport().width(), self._windows.columns, self._chosen()
        if chosen is not None:
            hidden = {section for section, column in enumerate(columns) if column.field not in chosen}
            short, widths = False, [self._widths(column, metrics, False) for column in columns]
        else:
            hidden, short, widths = self._choose(metrics, room)
        self._windows.set_short_titles(short)
        for section in range(len(widths)):
            self.setColumnHidden(section, section in hidden)
        shown = [section for section in range(len(widths)) if section not in hidden]
        if chosen is not None:
            for section in shown:
                self.setColumnWidth(section, int(widths[section][_NATURAL]))
            return
        shown = [section for section in shown if columns[section].name != "reason"]  # they take what is left
        cause = columns.index(CAUSE)
        least, natural, airy = (sum(sizes) for sizes in zip(*(widths[section] for section in shown)))
        for section in shown:
            smallest, normal, largest = widths[section]
            if room < natural and cause in shown:  # that alone gives way
                size = normal if section != cause else room - natural + normal
            elif room < least:  # the verdict's word ends in an ellipsis; its chip is still seen
                size = smallest - (least - room) * (self._windows.columns[section].name == "verdict")
            elif room < natural:
                size = smallest + (room - least) / (natural - least) * (normal - smallest)
            else:
                share = min(1.0, (room - natural) / max(airy - natural, 1))
                size = normal + share * (largest - normal)
            self.setColumnWidth(section, int(size))

    def _choose(self, metrics: QFontMetrics, room: int) -> tuple[set[int], bool, list[Widths]]:
        """Which columns are hidden, whether headings are short, and the columns' widths.

        Reasons give way first, then the ratios beyond level 1 and the paper's flag, then the causes.
        """
        columns = self._windows.columns
        reason, cause = next(place for place, one in enumerate(columns) if one.name == "reason"), columns.index(CAUSE)
        off = set(range(reason + 1, len(columns)))  # for the operator to choose
        coarser = {section for section, column in enumerate(columns) if column.level > 1 or column == PAPER}
        long, brief = ([self._widths(column, metrics, short) for column in columns] for short in (False, True))

        def needed(widths: list[Widths], size: int, without: set[int]) -> int:
            return sum(sizes[size] for section, sizes in enumerate(widths) if section not in without)

        if room >= needed(long, _AIRY, off):
            return off, False, long
        for hidden in ({reason, *off}, {reason, *off, *coarser}):
            for widths, short, size in ((long, False, _NATURAL), (brief, True, _NATURAL), (brief, True, _LEAST)):
                if room >= needed(widths, _NATURAL, {*hidden, cause}) + widths[cause][size]:
                    return hidden, short, widths
        hidden = {reason, cause, *off}
        if room < needed(brief, _NATURAL, hidden):
            hidden |= coarser
        for name in _GIVING_WAY:
            if room < needed(brief, _NATURAL, hidden):  # so that a verdict's word is never cut
                hidden |= {place for place, one in enumerate(columns) if one.name == name}
        short = room < needed(long, _NATURAL, hidden)
        return hidden, short, brief if short else long

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if event.oldSize().width() != event.size().width():
            self.fit()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.StyleChange):
            self.fit()

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ShortcutOverride and _is_own(event):
            event.accept()  # else QGIS's own action on this key would compete for it
            return True
        return bool(super().event(event))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if not _is_own(event):
            super().keyPressEvent(event)
        elif event.matches(QKeySequence.StandardKey.Copy):
            self.copyRequested.emit()
        elif event.matches(QKeySequence.StandardKey.Delete):
            self.removeRequested.emit()
        else:
            self.zoomRequested.emit()

    def dataChanged(self, first: QModelIndex, last: QModelIndex, roles: Sequence[int] = ()) -> None:
        """Paint the rows that changed, and no others as Qt 5 does."""
        if self._has_stale != self._windows.has_stale:
            self.fit()  # a verdict's words are longer then
        top = self.rowViewportPosition(first.row())
        bottom = self.rowViewportPosition(last.row()) + self.rowHeight(last.row())
        self.viewport().update(0, top, self.viewport().width(), bottom - top)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self.hint and self._shown.rowCount() == 0:
            painter = QPainter(self.viewport())
            painter.setPen(readable_palette(self).color(QPalette.ColorRole.PlaceholderText))
            margin = self.fontMetrics().height()
            room = self.viewport().rect().adjusted(margin, 0, -margin, 0)
            painter.drawText(room, int(Qt.AlignmentFlag.AlignCenter) | int(Qt.TextFlag.TextWordWrap), self.hint)
            painter.end()

    def _widths(self, column: TableColumn, metrics: QFontMetrics, short: bool) -> Widths:
        style, em = self.style(), metrics.horizontalAdvance("m")
        margins = 2 * (style.pixelMetric(QStyle.PixelMetric.PM_FocusFrameHMargin, None, self) + 1) + em // 2
        title = self._heading_width(column.title(short), column == self._windows.sorted_by)
        chip = self.iconSize().width() + em // 2

        def width(*texts: str) -> int:
            return max(map(metrics.horizontalAdvance, texts)) + margins

        if column.name in ("reason", "causes"):
            return 20 * em, 20 * em, 20 * em
        if column.name in ("remark", "remark_2"):
            return 8 * em, 10 * em, 12 * em
        if column.name == "verdict":
            words = [verdict_word(verdict) for verdict in VERDICTS]
            changed = [tr("{verdict}, changed").format(verdict=word) for word in words[:3]]
            natural, airy = chip + width(*words), chip + width(*changed)
            least = natural = airy if self._has_stale else natural
        elif column.name == "cause":
            natural = width(*(cause_word(cause.value) for cause in Cause))
            least, airy = width(cause_word(Cause.FEATHERING.value)), natural + em
        elif column == PAPER:
            natural = width(*(verdict_word(verdict) for verdict in VERDICTS))
            least, airy = natural, natural + em
        elif column.name in ("observer", "observer_2"):
            natural = width(*map(observer_word, ("visible", "invisible", "unsure")))
            least, airy = natural, natural + em
        else:
            natural = width({"window_id": "000", "sources": "00", "kept": "100.9 %"}.get(column.name, "0.00"))
            least, airy = natural, natural + em
        return max(least, title), max(natural, title), max(airy, title) + em

    def _heading_width(self, title: str, is_sorted: bool) -> int:
        """That shows all of a heading, with what the style or a theme's style sheet puts around it."""
        header = self.horizontalHeader()
        option = QStyleOptionHeader()
        option.initFrom(header)
        option.orientation = Qt.Orientation.Horizontal
        option.text = title
        if is_sorted:
            option.sortIndicator = QStyleOptionHeader.SortIndicator.SortDown
        style, metrics = header.style(), header.fontMetrics()
        least = style.sizeFromContents(QStyle.ContentsType.CT_HeaderSection, option, QSize(), header).width()
        needed = metrics.horizontalAdvance(title + "n") + 2 * style.pixelMetric(QStyle.PixelMetric.PM_HeaderMargin)
        if is_sorted:
            needed += 2 * style.pixelMetric(QStyle.PixelMetric.PM_HeaderMarkSize)
        return max(int(least), int(needed))  # the style's own word is too little in Fusion

    def show_sorting(self) -> None:
        """The arrow may stand on another column, or on none, after the order or the columns changed."""
        header, column = self.horizontalHeader(), self._windows.sorted_by
        blocked = header.blockSignals(True)
        section = -1 if column is None else self._windows.columns.index(column)
        header.setSortIndicator(section, self._windows.sort_order)
        header.blockSignals(blocked)
        self._put_in_order()
        self.fit()

    # Columns that the operator chose

    def _chosen(self) -> frozenset[str] | None:
        """The fields of the columns to be seen; None where they are those there is room for."""
        if self._blind is not None:
            return self._blind
        known = {column.field for column in self._windows.columns}.intersection(self._choice.shown)
        return frozenset(known) or None

    def _put_in_order(self) -> None:
        """Move the columns to where the operator had them; unknown ones stay where they come."""
        header, columns = self.horizontalHeader(), self._windows.columns
        places = {field: place for place, field in enumerate(self._choice.order)}
        known = iter(sorted((one for one in columns if one.field in places), key=lambda one: places[one.field]))
        wanted = [next(known) if one.field in places else one for one in columns]
        blocked = header.blockSignals(True)
        for place, column in enumerate(wanted):
            header.moveSection(header.visualIndex(columns.index(column)), place)
        header.blockSignals(blocked)

    def _keep_order(self, *_: int) -> None:
        header, columns = self.horizontalHeader(), self._windows.columns
        order = tuple(columns[header.logicalIndex(place)].field for place in range(header.count()))
        self._choice = replace(self._choice, order=order)
        save_choice(self._choice)
        self.fit()

    def _choose_columns(self, fields: tuple[str, ...]) -> None:
        self._take_choice(replace(self._choice, shown=fields))

    def _reset_columns(self) -> None:
        self._take_choice(ColumnChoice())

    def _take_choice(self, choice: ColumnChoice) -> None:
        self._choice = choice
        save_choice(choice)
        self._put_in_order()
        self.fit()

    def _show_columns_menu(self, place: QPoint) -> None:
        if self._blind is None:
            self.columns_menu().popup(self.horizontalHeader().mapToGlobal(place))

    def columns_menu(self) -> QMenu:
        """Which columns are seen."""
        visible = [column.field for column in self.visible_columns()]
        menu = columns_menu(self._windows.columns, visible, self._choose_columns, self._reset_columns, self)
        menu.aboutToHide.connect(menu.deleteLater)
        return menu


def _is_own(event: QKeyEvent) -> bool:
    enter = event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter)
    keys = (QKeySequence.StandardKey.Delete, QKeySequence.StandardKey.Copy)
    return any(map(event.matches, keys)) or (
        enter and event.modifiers() in (Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.KeypadModifier)
    )
