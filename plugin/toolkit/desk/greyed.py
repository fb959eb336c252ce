"""Actions that say why they are grey."""
from __future__ import annotations

from qgis.PyQt.QtWidgets import QAction

_TIP = "seam_inspector_tip"


def allow(action: QAction, why_not: str = "") -> None:
    """Enable an action; with a reason against it, grey it and hang the reason on its tooltip."""
    if action.property(_TIP) is None:
        action.setProperty(_TIP, action.toolTip())
    tip = str(action.property(_TIP))
    action.setEnabled(not why_not)
    action.setToolTip(f"{tip}\n\n{why_not}" if why_not else tip)
