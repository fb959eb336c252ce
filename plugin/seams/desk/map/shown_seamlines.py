"""Seamlines on the map, which cover the very pixels that are judged."""
from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.core import QgsProject

if TYPE_CHECKING:
    from ..session import Session


def toggle_seamlines(session: Session) -> bool:
    """Take the seamlines off the map, or put them on it again; False where there are none."""
    node = QgsProject.instance().layerTreeRoot().findLayer(session.inputs.seamlines)
    if node is None:
        return False
    if node.isVisible():
        node.setItemVisibilityChecked(False)
    else:
        node.setItemVisibilityCheckedParentRecursive(True)
    return True
