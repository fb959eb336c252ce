"""The checkable list of the project's rasters as sources."""
from __future__ import annotations

from dataclasses import dataclass

from qgis.core import QgsMapLayer, QgsProject, QgsRasterLayer
from qgis.PyQt.QtCore import Qt, pyqtSignal
from qgis.PyQt.QtWidgets import (
    QAbstractItemView,
    QGridLayout,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QSizePolicy,
    QToolButton,
    QWidget,
)

from ....imagery.errors import SeamInspectorError
from ....toolkit.desk.layer_box import missing_text
from ....toolkit.layers import box_extent, transformed_extent
from ....toolkit.translation import tr
from ...tables.scan_layers import is_picture

_ID = Qt.ItemDataRole.UserRole
_FEWEST_ROWS = 4  # seen without scrolling

Sources = tuple[str, ...]


@dataclass(frozen=True)
class _Entry:
    """One line of the list."""

    layer_id: str
    text: str
    tip: str
    is_missing: bool = False
    is_apart: bool = False
    """It does not overlap the mosaic."""


class SourceList(QWidget):
    """The rasters of the project but the mosaic; sources that are missing stay in it until they are unchecked."""

    changed = pyqtSignal(tuple)
    """The operator chose other sources: their layers' ids."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._mosaic_id = ""
        self._entries: list[_Entry] = []
        self._is_following = False
        self.list = QListWidget(self)
        self.all = self._button(tr("all"), tr("Check all rasters that overlap the mosaic"))
        self.none = self._button(tr("none"), tr("Check no raster; missing ones are removed"))
        self.list.setToolTip(
            tr("The orthoimages that the mosaic was made from. Uncheck a missing one to remove it from the inputs.")
        )
        self.list.setAccessibleName(tr("Sources"))
        self.list.setTextElideMode(Qt.TextElideMode.ElideMiddle)  # names often differ at their end only
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.list.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.list.setUniformItemSizes(True)
        self.list.setMinimumHeight(round((_FEWEST_ROWS + 0.5) * 1.3 * self.fontMetrics().height()))
        self.list.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Ignored)
        label = QLabel(tr("&Sources"), self)
        label.setBuddy(self.list)
        layout = QGridLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setHorizontalSpacing(2)
        layout.setVerticalSpacing(2)
        layout.setColumnStretch(0, 1)
        for column, widget in enumerate((label, self.all, self.none)):
            layout.addWidget(widget, 0, column)
        layout.addWidget(self.list, 1, 0, 1, 3)
        layout.setRowStretch(1, 1)
        self.list.itemChanged.connect(self._tell)
        self.all.clicked.connect(self._check_all)
        self.none.clicked.connect(self._check_none)

    def fields(self) -> tuple[QWidget, ...]:
        """In tab order."""
        return self.all, self.none, self.list

    def show_sources(self, mosaic_id: str, sources: Sources) -> None:
        """Show the rasters of the project with the sources checked."""
        self._mosaic_id = mosaic_id
        entries = _entries(mosaic_id, sources)
        self._is_following = True
        try:
            if entries != self._entries:  # else the list keeps where it was scrolled to
                self._entries = entries
                self._fill()
            for row in range(self.list.count()):
                item = self.list.item(row)
                is_source = item.data(_ID) in sources
                item.setCheckState(Qt.CheckState.Checked if is_source else Qt.CheckState.Unchecked)
        finally:
            self._is_following = False
        self.all.setEnabled(any(not entry.is_missing for entry in entries))
        self.none.setEnabled(bool(sources))

    def checked(self) -> Sources:
        """Layer ids of the checked rasters, missing ones included."""
        items = [self.list.item(row) for row in range(self.list.count())]
        return tuple(item.data(_ID) for item in items if item.checkState() == Qt.CheckState.Checked)

    def _fill(self) -> None:
        scrolled = self.list.verticalScrollBar().value()
        self.list.clear()
        for entry in self._entries:
            item = QListWidgetItem(entry.text, self.list)
            item.setData(_ID, entry.layer_id)
            item.setToolTip(entry.tip)
            item.setFlags(item.flags() | Qt.ItemFlag.ItemIsUserCheckable)
            font = item.font()
            font.setItalic(entry.is_missing)
            item.setFont(font)
            if entry.is_missing or entry.is_apart:
                item.setForeground(self.palette().placeholderText())
        self.list.verticalScrollBar().setValue(scrolled)

    def _button(self, text: str, tip: str) -> QToolButton:
        button = QToolButton(self)
        button.setText(text)
        button.setToolTip(tip)
        button.setAutoRaise(True)
        button.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        return button

    def _check_all(self) -> None:
        missing = tuple(entry.layer_id for entry in self._entries if entry.is_missing)
        wanted = tuple(entry.layer_id for entry in self._entries if not (entry.is_missing or entry.is_apart))
        self.changed.emit(tuple(source for source in missing if source in self.checked()) + wanted)

    def _check_none(self) -> None:
        self.changed.emit(())

    def _tell(self, _item: QListWidgetItem) -> None:
        if not self._is_following:
            self.changed.emit(self.checked())


def overlapping(mosaic_id: str, rasters: list[QgsRasterLayer]) -> Sources:
    """Ids of the rasters that overlap the mosaic and may be its sources: files, not the mosaic's own, with colour
    when it has colour (so that no elevation model is taken)."""
    mosaic = QgsProject.instance().mapLayer(mosaic_id)
    if not isinstance(mosaic, QgsRasterLayer):
        return ()
    found = (layer for layer in rasters if layer.source() != mosaic.source() and _overlap(layer, mosaic))
    return tuple(layer.id() for layer in found if (layer.bandCount() >= 3) == (mosaic.bandCount() >= 3))


def file_rasters() -> list[QgsRasterLayer]:
    """The project's rasters that GDAL reads from files, by name; pictures of losses are none of them."""
    found = filter(_is_file, QgsProject.instance().mapLayers().values())
    return sorted(found, key=lambda layer: (layer.name().casefold(), layer.id()))


def _is_file(layer: QgsMapLayer) -> bool:
    is_raster = isinstance(layer, QgsRasterLayer) and layer.isValid() and layer.providerType() == "gdal"
    return is_raster and not is_picture(layer)


def _overlap(layer: QgsRasterLayer, mosaic: QgsRasterLayer) -> bool:
    project = QgsProject.instance()
    try:
        xmin, ymin, xmax, ymax = transformed_extent(box_extent(layer.extent()), layer.crs(), mosaic.crs(), project)
    except SeamInspectorError:
        return False
    box = mosaic.extent()
    across = min(xmax, box.xMaximum()) - max(xmin, box.xMinimum())
    down = min(ymax, box.yMaximum()) - max(ymin, box.yMinimum())
    return bool(across > 0 and down > 0)


def _entries(mosaic_id: str, sources: Sources) -> list[_Entry]:
    """Missing sources first, then the rasters of the project but the mosaic."""
    rasters = [layer for layer in file_rasters() if layer.id() != mosaic_id]
    there = {layer.id() for layer in rasters}
    entries = []
    for source in sources:
        if source not in there and source != mosaic_id:
            layer = QgsProject.instance().mapLayer(source)
            name = tr("missing: {name}").format(name=layer.name()) if layer is not None else missing_text(source)
            tip = tr("Not in the project any more, or its file can't be opened: {name}").format(name=source)
            entries.append(_Entry(source, name, tip, is_missing=True))
    mosaic = QgsProject.instance().mapLayer(mosaic_id)
    for layer in rasters:
        is_apart = isinstance(mosaic, QgsRasterLayer) and not _overlap(layer, mosaic)
        tip = tr("does not overlap the mosaic: {path}") if is_apart else "{path}"
        entries.append(_Entry(layer.id(), layer.name(), tip.format(path=layer.source()), is_apart=is_apart))
    return entries
