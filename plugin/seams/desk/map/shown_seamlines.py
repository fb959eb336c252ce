"""Seamlines and a scan's layers on the map, which cover the very pixels that are judged."""
from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from qgis.core import QgsLayerTreeNode, QgsProject

from ..scan.scan_group import worst_layer

if TYPE_CHECKING:
    from ..session import Session


def toggle_seamlines(session: Session) -> bool:
    """Take the seamlines and what a scan found off the map, or put them on it again; False where there are none."""
    nodes = list(_covering(session))
    is_shown = any(node.isVisible() for node in nodes)
    for node in nodes:
        if is_shown:
            node.setItemVisibilityChecked(False)
        else:
            node.setItemVisibilityCheckedParentRecursive(True)
    return bool(nodes)


def _covering(session: Session) -> Iterator[QgsLayerTreeNode]:
    """The seamlines, and the group that the last scan of the mosaic left."""
    project = QgsProject.instance()
    root = project.layerTreeRoot()
    if (seamlines := root.findLayer(session.inputs.seamlines)) is not None:
        yield seamlines
    worst = worst_layer(project, session.inputs.mosaic)
    node = None if worst is None else root.findLayer(worst.id())
    if node is not None and node.parent() not in (None, root):
        yield node.parent()
