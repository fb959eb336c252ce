"""The menu of the selected rows of the windows' table."""
from __future__ import annotations

from collections.abc import Callable
from functools import partial

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtGui import QKeySequence
from qgis.PyQt.QtWidgets import QAction, QMenu, QWidget

from ....imagery.statistics import INVISIBLE, UNSURE, VISIBLE
from ....toolkit.translation import tr


def rows_menu(
    parent: QWidget,
    *,
    zoom: Callable[[], None],
    inspect: Callable[[], None],
    judge: Callable[[str], None],
    copy: Callable[[], None],
    save_csv: Callable[[], None],
    remove: Callable[[], None],
) -> QMenu:
    """The menu of the selected rows. Its shortcuts are only told there: the table takes the keys itself."""
    menu = QMenu(parent)
    menu.setToolTipsVisible(True)
    for entry in (
        (tr("Zoom to window"), "mActionZoomToSelected", zoom,
         tr("Shows the window with one image pixel on 2 x 2 pixels of the screen."), Qt.Key.Key_Return),
        (tr("Inspect again"), "mActionRefresh", inspect, tr("Measures the selected windows anew."), None),
        None,
        (tr("Judge visible"), "mActionShowAllLayers", partial(judge, VISIBLE),
         tr("The loss of detail can be seen at 2x magnification."), None),
        (tr("Judge invisible"), "mActionHideAllLayers", partial(judge, INVISIBLE),
         tr("The loss of detail can't be seen at 2x magnification."), None),
        (tr("Judge not sure"), "mActionHelpContents", partial(judge, UNSURE),
         tr("It can't be said. The window counts as not judged in all results."), None),
        (tr("Take judgement back"), "mActionUndo", partial(judge, ""),
         tr("The selected windows are not judged yet."), None),
        None,
        (tr("Copy rows"), "mActionEditCopy", copy,
         tr("The selected rows with their headings, for a spreadsheet."), QKeySequence.StandardKey.Copy),
        (tr("Save as CSV ..."), "mActionFileSaveAs", save_csv,
         tr("All windows that are shown, with all of their numbers."), None),
        None,
        (tr("Remove"), "mActionDeleteSelected", remove,
         tr("Removes the selected windows; undo brings them back."), Qt.Key.Key_Delete),
    ):
        if entry is None:
            menu.addSeparator()
            continue
        text, icon, slot, tip, key = entry
        action = QAction(QgsApplication.getThemeIcon(f"/{icon}.svg"), text, menu)
        action.setToolTip(tip)
        if key is not None:
            action.setShortcut(QKeySequence(key))
            action.setShortcutContext(Qt.ShortcutContext.WidgetShortcut)
        action.triggered.connect(slot if not isinstance(slot, partial) else partial(_without_state, slot))
        menu.addAction(action)
    return menu


def _without_state(slot: Callable[[], None], _checked: bool = False) -> None:
    slot()
