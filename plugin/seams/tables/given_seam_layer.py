"""Layers of seams as producers deliver them, in whatever reference system."""
from __future__ import annotations

from collections.abc import Iterable, Sequence

from qgis.core import QgsCoordinateTransform, QgsFeature
from qgis.PyQt.QtCore import QDate, QDateTime, Qt

from ...imagery.errors import Message, WindowError
from ...toolkit.layers import line_wkb
from ...toolkit.table_fields import is_known, text
from ..measure.scan import messages
from ..measure.scan.lines.seam_features import SeamFeature


def seam_features(
    rows: Iterable[QgsFeature], names: Sequence[str], transform: QgsCoordinateTransform
) -> tuple[list[SeamFeature], Message | None]:
    """Attributes and outlines of a layer in the mosaic's system, and how many can't be transformed."""
    features: list[SeamFeature] = []
    lost = 0
    for row in rows:
        try:
            wkb = line_wkb(row, transform)
        except WindowError:
            lost += 1
            continue
        features.append(({name: _plain(value) for name, value in zip(names, row.attributes())}, wkb))
    return features, messages.SEAM_FEATURES_NOT_TRANSFORMED(count=lost) if lost else None


def _plain(value: object) -> str:
    """What an attribute says, dates as 2019-07-04."""
    if isinstance(value, (QDate, QDateTime)):
        return str(value.toString(Qt.DateFormat.ISODate))
    if isinstance(value, (list, tuple)):  # elements that a GML file repeats
        return ", ".join(_plain(one) for one in value)
    return text(value) if is_known(value) else ""
