"""Which columns the operator chose to see, and in which order; the same in every project."""
from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from functools import partial

from qgis.core import QgsSettings
from qgis.PyQt.QtWidgets import QMenu, QWidget

from ....toolkit.translation import filled, tr
from .windows_columns import TableColumn

_KEY = "SeamInspector/window_columns"


@dataclass(frozen=True)
class ColumnChoice:
    """Columns by their fields."""

    shown: tuple[str, ...] = ()
    """Empty: those that there is room for."""
    order: tuple[str, ...] = ()
    """From left to right; empty: as they come."""


def load_choice() -> ColumnChoice:
    """What was chosen last; nothing where that can't be understood."""
    try:
        stored = json.loads(QgsSettings().value(_KEY, "") or "{}")
        return ColumnChoice(*(tuple(map(str, stored.get(name, ()))) for name in ("shown", "order")))
    except (ValueError, TypeError, AttributeError):
        return ColumnChoice()


def save_choice(choice: ColumnChoice) -> None:
    """For the next time."""
    QgsSettings().setValue(_KEY, json.dumps(asdict(choice)))


def columns_menu(
    columns: Sequence[TableColumn],
    visible: Sequence[str],
    choose: Callable[[tuple[str, ...]], None],
    reset: Callable[[], None],
    parent: QWidget,
) -> QMenu:
    """A menu with a tick at each visible column; ``choose`` is told the fields that shall be seen."""

    def toggle(field: str, shown: bool) -> None:
        wanted = {*visible, field} if shown else {*visible} - {field}
        choose(tuple(column.field for column in columns if column.field in wanted))

    menu = QMenu(parent)
    menu.setToolTipsVisible(True)
    for column in columns:
        action = menu.addAction(_menu_title(column))
        action.setToolTip(column.title_tip())
        action.setCheckable(True)
        action.setChecked(column.field in visible)
        action.setEnabled(list(visible) != [column.field])  # one has to stay
        action.triggered.connect(partial(toggle, column.field))
    menu.addSeparator()
    action = menu.addAction(tr("As there is room"))
    action.setToolTip(tr("The usual columns in their usual order, as many as there is room for."))
    action.triggered.connect(lambda *_: reset())
    return menu


def _menu_title(column: TableColumn) -> str:
    return filled(tr("ratio {level}"), level=column.level) if column.level > 1 else column.title()
