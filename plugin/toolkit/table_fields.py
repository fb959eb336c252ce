"""Fields of tables and features from plain values."""
from __future__ import annotations

from qgis.core import QgsFeature, QgsFields, QgsGeometry

from .version_differences import field


def feature(fields: QgsFields, values: list[object], geometry: QgsGeometry | None = None) -> QgsFeature:
    """A feature with all of its attributes."""
    row = QgsFeature(fields)
    row.setAttributes(values)
    if geometry is not None:
        row.setGeometry(geometry)
    return row


def table_fields(*columns: tuple[str, str]) -> QgsFields:
    """Fields of these names and kinds (``integer``, ``real`` or ``text``)."""
    fields = QgsFields()
    for name, kind in columns:
        fields.append(field(name, kind))
    return fields
