"""Differences between QGIS versions, all of them here."""
from __future__ import annotations

from typing import Any

from qgis.core import Qgis, QgsField, QgsRasterLayer, QgsTask
from qgis.PyQt import QtCore

PALETTE, ALPHA = 2, 6  # roles of bands, as ``band_roles`` gives them
_KINDS = {"integer": ("Int", "Int"), "real": ("Double", "Double"), "text": ("String", "QString")}
SILENT_TASK = getattr(QgsTask.Flag, "Silent", None)  # the flag of a task whose end QGIS does not tell, from 3.26 on


def field(name: str, kind: str) -> QgsField:
    """A field of kind ``integer``, ``real`` or ``text``."""
    variant, meta = _KINDS[kind]
    if Qgis.QGIS_VERSION_INT >= 33800:  # QVariant's types are deprecated from here on, and gone with Qt 6
        return QgsField(name, getattr(QtCore.QMetaType.Type, meta))
    return QgsField(name, getattr(QtCore.QVariant, variant))


def band_roles(layer: QgsRasterLayer, most: int) -> list[int]:
    """The roles of the first bands of a raster layer: numbers here, an enum from QGIS 3.30 on."""
    provider = layer.dataProvider()
    roles = (provider.colorInterpretation(band) for band in range(1, min(layer.bandCount(), most) + 1))
    return [int(getattr(role, "value", role)) for role in roles]


def layer_filters(kinds: Any) -> Any:
    """Kinds of layers as boxes take them: joined by | they are a bare number from QGIS 3.34 on, which warns."""
    flags = getattr(Qgis, "LayerFilters", None)
    return kinds if flags is None else flags(kinds)
