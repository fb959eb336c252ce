"""Windows of the desk by a field of theirs: which belong together."""
from __future__ import annotations

from qgis.core import QgsFeatureRequest, QgsFieldProxyModel, QgsVectorLayer
from qgis.gui import QgsFieldComboBox
from qgis.PyQt.QtCore import QSignalBlocker
from qgis.PyQt.QtWidgets import QComboBox, QWidget

from ...toolkit.attribute_values import text
from ...toolkit.desk.tooltips import rich_tip
from ...toolkit.translation import tr


class FieldBox(QgsFieldComboBox):
    """Which field of the windows they are grouped by; its first entry is none."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFilters(
            QgsFieldProxyModel.Filter.String | QgsFieldProxyModel.Filter.Int | QgsFieldProxyModel.Filter.LongLong
        )
        self.setAllowEmptyFieldName(True)
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(8)
        self.setToolTip(rich_tip(tr(
            "Field that windows are grouped by, as land use or scale: the range of all windows with the selected "
            "window's value stands behind its curves. Empty: no groups."
        )))  # fmt: skip

    def follow(self, layer: QgsVectorLayer | None) -> None:
        """Offer the fields of this layer; the choice stays where it has such a field."""
        if layer is self.layer():
            return
        chosen = self.currentField()
        blocker = QSignalBlocker(self)
        self.setLayer(layer)
        self.setField(chosen)
        blocker.unblock()


def windows_alike(layer: QgsVectorLayer | None, field: str, fid: int) -> tuple[str, list[int]] | None:
    """A window's value in a field, and the feature ids of all windows that have it, its own among them.

    None where windows are not grouped, or this one has no value.
    """
    if layer is None or layer.fields().lookupField(field) < 0:
        return None
    request = QgsFeatureRequest().setFlags(QgsFeatureRequest.Flag.NoGeometry)
    request.setSubsetOfAttributes([field], layer.fields())
    values = {feature.id(): text(feature[field]) for feature in layer.getFeatures(request)}
    value = values.get(fid, "")
    return (value, [one for one, other in values.items() if other == value]) if value else None
