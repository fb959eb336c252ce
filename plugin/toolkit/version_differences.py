"""Differences between QGIS versions, all of them here."""
from __future__ import annotations

from qgis.core import Qgis, QgsField, QgsTask
from qgis.PyQt import QtCore

_KINDS = {"integer": ("Int", "Int"), "real": ("Double", "Double"), "text": ("String", "QString")}
SILENT_TASK = getattr(QgsTask.Flag, "Silent", None)
"""The flag of a task whose end QGIS does not tell, from 3.26 on."""


def field(name: str, kind: str) -> QgsField:
    """A field of kind ``integer``, ``real`` or ``text``."""
    variant, meta = _KINDS[kind]
    if Qgis.QGIS_VERSION_INT >= 33800:  # QVariant's types are deprecated from here on, and gone with Qt 6
        return QgsField(name, getattr(QtCore.QMetaType.Type, meta))
    return QgsField(name, getattr(QtCore.QVariant, variant))
