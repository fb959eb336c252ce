"""Sources of the mosaic: which of the project's rasters are suggested and why others are not, and the list of them."""
from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

from qgis.core import Qgis, QgsCoordinateReferenceSystem, QgsProject, QgsRasterLayer, QgsVectorLayer, QgsWkbTypes
from qgis.PyQt.QtCore import QObject, Qt, pyqtSignal
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

from ....imagery.errors import Message, SeamInspectorError
from ....imagery.grids import Extent, extents_meet
from ....toolkit.desk.theme import ReadableItems
from ....toolkit.desk.widgets import missing_text, plain_tip
from ....toolkit.layers import box_extent, transformed_extent
from ....toolkit.project_settings import unmodified
from ....toolkit.translation import filled, sentence, tr
from ....toolkit.version_differences import ALPHA, PALETTE, band_roles
from ...measure.inputs.raster_facts import COLOURS, RasterFacts, likely_mosaic, suitable_by_header
from ...measure.seamlines.seam_features import seam_fields
from ...tables.input_layers import LOCATION_FIELD
from ...tables.scan_layers import is_picture
from ..window_home import MADE_FOR
from .project_inputs import Inputs, load_inputs

if TYPE_CHECKING:
    from ..session import Session


Sources = tuple[str, ...]


def suitabilities(mosaic_id: str, rasters: Sequence[QgsRasterLayer]) -> dict[str, Message | None]:
    """Why rasters are no sources of a mosaic among them, by layer id, by their headers and where they lie."""
    mosaic = QgsProject.instance().mapLayer(mosaic_id)
    if not isinstance(mosaic, QgsRasterLayer):
        return {}
    facts = {raster.key: raster for raster in facts_of(rasters, mosaic)}
    seen_from = facts.pop(mosaic_id, None)
    return {} if seen_from is None else suitable_by_header(seen_from, list(facts.values()))


class Suggesting(QObject):
    """Sets mosaic, sources and seamlines that the operator has not chosen."""

    def __init__(self, session: Session, parent: QObject) -> None:
        super().__init__(parent)
        self._session = session
        self._key: object = None  # of the rasters that were looked at
        self.reasons: dict[str, Message | None] = {}
        """Why rasters are not suggested, by layer id; None for those that are."""
        self._suggested: Sources = ()  # when it was looked last
        self._mosaic = ""  # for which
        self.forget_choices()

    def forget_choices(self) -> None:
        """Another project, in which the operator has chosen nothing."""
        self._is_mosaic_chosen = self._are_seamlines_chosen = False

    def follow(self) -> None:
        """Inputs or layers may be others: sources that were those suggested become what is suggested now."""
        inputs, project = self._session.inputs, QgsProject.instance()
        is_same, before = inputs.mosaic == self._mosaic, self._suggested
        self._note(inputs.mosaic)
        missing = tuple(source for source in inputs.sources if project.mapLayer(source) is None)
        are_suggested = set(inputs.sources).difference(missing) == set(before).difference(missing)
        is_index_enough = not inputs.sources and bool(inputs.source_index)
        is_there = is_same and project.mapLayer(inputs.mosaic) is not None
        if is_there and are_suggested and not is_index_enough and set(before) != set(self._suggested):
            with unmodified(project):
                self._session.set_inputs(replace(inputs, sources=(*missing, *self._suggested)))

    def choose_mosaic(self, layer_id: str) -> None:
        """The operator's choice. Another mosaic of the same block keeps its sources, a new block gets the suggested."""
        inputs = self._session.inputs
        if layer_id == inputs.mosaic:
            return
        self._is_mosaic_chosen = True
        self._note(layer_id)
        kept = tuple(source for source in inputs.sources if source != layer_id)
        is_kept = not layer_id or bool(set(kept) & set(self._suggested))
        self._session.set_inputs(replace(inputs, mosaic=layer_id, sources=kept if is_kept else self._suggested))
        self.suggest_layers()

    def choose_seamlines(self, layer_id: str) -> None:
        """The operator's choice."""
        self._are_seamlines_chosen = True
        self._session.set_inputs(replace(self._session.inputs, seamlines=layer_id))

    def take_suggested(self) -> None:
        """The operator wants the suggested sources."""
        self._note(self._session.inputs.mosaic)
        self._session.set_inputs(replace(self._session.inputs, sources=self._suggested))

    def suggest_layers(self) -> None:
        """Mosaic and seamlines where the project has one candidate each, and the operator has said nothing of them."""
        inputs = self._session.inputs
        if load_inputs(QgsProject.instance()) != inputs:  # a project is just being read
            return
        suggested = inputs if self._is_mosaic_chosen else with_likely_mosaic(inputs)
        if suggested.mosaic != inputs.mosaic:
            self._note(suggested.mosaic)
            suggested = replace(suggested, sources=self._suggested)
        if not self._are_seamlines_chosen and not suggested.seamlines:
            suggested = replace(suggested, seamlines=likely_seamlines(suggested.mosaic))
        if suggested != inputs:
            with unmodified(QgsProject.instance()):
                self._session.set_inputs(suggested)

    def _note(self, mosaic_id: str) -> None:
        rasters = file_rasters()
        key = mosaic_id, [(layer.id(), layer.source(), layer.crs().authid()) for layer in rasters]
        if key == self._key:
            return
        self._key, self._mosaic, self.reasons = key, mosaic_id, suitabilities(mosaic_id, rasters)
        self._suggested = tuple(name for name, reason in self.reasons.items() if reason is None)


_SEAM_NAMES = re.compile(r"seam|cut_?line|mosai[ck]|nahtlinie|szwy|mozaik|graphe", re.IGNORECASE)
_ANY_NAME = {"", "name", "localid"}  # fields of polygons of all kinds
_OTHERS = {"kept_1", "verdict", "window_id", "ratio_1", LOCATION_FIELD}  # fields of results, and of a source index


def with_likely_mosaic(inputs: Inputs) -> Inputs:
    """The mosaic where none is chosen: the one raster that others of the project are suitable sources of."""
    if inputs.mosaic or inputs.sources:
        return inputs
    by_system: defaultdict[str, list[QgsRasterLayer]] = defaultdict(list)
    for layer in file_rasters():
        by_system[layer.crs().authid() or layer.crs().toWkt()].append(layer)
    likely = (
        likely_mosaic([replace(facts, is_mosaic=False) for facts in facts_of(rasters, rasters[0])])
        for rasters in by_system.values() if len(rasters) > 2
    )
    names = {name for name in likely if name is not None}
    return replace(inputs, mosaic=names.pop()) if len(names) == 1 else inputs


def likely_seamlines(mosaic_id: str) -> str:
    """The one layer on the mosaic that looks like its seams, by its name or by fields that say what lies on either
    side, or which orthoimage a polygon is filled from; empty where there is none, or more."""
    mosaic = QgsProject.instance().mapLayer(mosaic_id)
    vectors = [layer for layer in QgsProject.instance().mapLayers().values() if isinstance(layer, QgsVectorLayer)]
    likely = [vector for vector in vectors if _are_seams(vector)] if isinstance(mosaic, QgsRasterLayer) else []
    on_mosaic = [vector for vector in likely if _meets(vector, mosaic)]
    return str(on_mosaic[0].id()) if len(on_mosaic) == 1 else ""


def _are_seams(layer: QgsVectorLayer) -> bool:
    names, kind = layer.fields().names(), layer.geometryType()
    kinds = QgsWkbTypes.GeometryType.LineGeometry, QgsWkbTypes.GeometryType.PolygonGeometry
    if not layer.isValid() or kind not in kinds or _OTHERS.intersection(names) or layer.customProperty(MADE_FOR):
        return False
    fields = seam_fields([dict.fromkeys(names, "x")])
    has_owners = kind == kinds[1] and fields.source.lower() not in _ANY_NAME
    return bool(_SEAM_NAMES.search(layer.name()) or fields.left or has_owners)


def _meets(layer: QgsVectorLayer, mosaic: QgsRasterLayer) -> bool:
    box = layer.extent()
    if box.isNull():
        return False
    try:
        extent = transformed_extent(box_extent(box), layer.crs(), mosaic.crs(), QgsProject.instance())
    except SeamInspectorError:
        return False
    return extents_meet(extent, box_extent(mosaic.extent()))


_MOST_BANDS = 16  # whose roles are asked for


def file_rasters() -> list[QgsRasterLayer]:
    """The project's rasters that GDAL reads from files, by name; pictures of losses are none of them."""
    every = QgsProject.instance().mapLayers().values()
    rasters = (layer for layer in every if isinstance(layer, QgsRasterLayer) and layer.isValid())
    from_files = (raster for raster in rasters if raster.providerType() == "gdal" and not is_picture(raster))
    return sorted(from_files, key=lambda layer: (layer.name().casefold(), layer.id()))


def facts_of(layers: Sequence[QgsRasterLayer], mosaic: QgsRasterLayer) -> list[RasterFacts]:
    """Facts of some layers, seen from the mosaic; no file is opened for it."""
    crs = mosaic.crs()
    known: dict[str, bool] = {}
    return [_facts(layer, mosaic, crs, known) for layer in layers]


def _facts(
    layer: QgsRasterLayer, mosaic: QgsRasterLayer, crs: QgsCoordinateReferenceSystem, known: dict[str, bool]
) -> RasterFacts:
    layer_crs = layer.crs()
    name = layer_crs.authid() or layer_crs.toWkt()
    same = known.setdefault(name, layer_crs == crs)
    extent = box_extent(layer.extent()) if same else _extent_on(layer, crs)
    size = 0.0
    if extent is not None and layer.width() and layer.height():
        size = ((extent[2] - extent[0]) * (extent[3] - extent[1]) / (layer.width() * layer.height())) ** 0.5
    return RasterFacts(
        layer.id(), layer.name(), extent if size > 0 else None, size or 1.0, _bands(layer), _pixel_type(layer), same,
        layer.id() == mosaic.id() or layer.source() == mosaic.source(),
    )


def _extent_on(layer: QgsRasterLayer, crs: QgsCoordinateReferenceSystem) -> Extent | None:
    if not layer.crs().isValid() or not crs.isValid():
        return None
    try:
        return transformed_extent(box_extent(layer.extent()), layer.crs(), crs, QgsProject.instance())
    except SeamInspectorError:
        return None


def _bands(layer: QgsRasterLayer) -> int:
    """Rasters that hold measurements."""
    roles = band_roles(layer, _MOST_BANDS)
    if roles == [PALETTE] and layer.dataProvider().colorTable(1):
        return COLOURS
    return int(layer.bandCount()) - roles.count(ALPHA)


def _pixel_type(layer: QgsRasterLayer) -> str:
    provider = layer.dataProvider()
    kind, bits = provider.dataType(1), 8 * provider.dataTypeSize(1)
    is_float = kind in (Qgis.DataType.Float32, Qgis.DataType.Float64)
    return tr("floating point") if is_float else filled(tr("{bits} bit"), bits=bits)


_ID, _IS_OUT = (Qt.ItemDataRole.UserRole + place for place in range(2))
_FEWEST_ROWS = 4  # seen without scrolling


class _Entry(NamedTuple):
    """One line of the list."""

    layer_id: str
    text: str
    tip: str
    is_out: bool = False  # whether it is not suggested


class SourceList(QWidget):
    """The rasters of the project but the mosaic; sources that are missing stay in it until they are unchecked."""

    changed = pyqtSignal(tuple)  # the operator chose other sources: their layers' ids
    suggestionWanted = pyqtSignal()  # the operator wants the suggested sources, and no others

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._entries: list[_Entry] = []
        self._is_following = False
        self.list = QListWidget(self)
        self.suggested = self._button(
            tr("suggested"), tr("Tick only the rasters that may be sources of this mosaic")
        )
        self.none = self._button(tr("none"), tr("Untick all rasters and remove missing ones"))
        self.list.setToolTip(
            tr("The orthoimages that the mosaic was made from. The reason stands beside each one that is left out; "
               "tick it to use it anyway. Untick a missing one to remove it from the inputs.")
        )
        self.list.setAccessibleName(tr("Sources"))
        self.list.setItemDelegate(ReadableItems(self.list))
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
        for column, widget in enumerate((label, self.suggested, self.none)):
            layout.addWidget(widget, 0, column)
        layout.addWidget(self.list, 1, 0, 1, 3)
        layout.setRowStretch(1, 1)
        self.list.itemChanged.connect(self._tell)
        self.suggested.clicked.connect(self.suggestionWanted)
        self.none.clicked.connect(lambda *_: self.changed.emit(()))
        self.fields = self.suggested, self.none, self.list  # in tab order

    def show_sources(self, mosaic_id: str, sources: Sources, reasons: Mapping[str, Message | None]) -> None:
        """Show the rasters of the project with the sources checked; ``reasons`` why some are not suggested."""
        entries = _entries(mosaic_id, sources, reasons)
        chosen = set(sources)
        self._is_following = True
        try:
            if entries != self._entries:  # else the list keeps where it was scrolled to
                self._entries = entries
                self.list.clear()
                for entry in entries:
                    item = QListWidgetItem(entry.text, self.list)
                    item.setData(_ID, entry.layer_id)
                    item.setData(_IS_OUT, entry.is_out)
                    item.setToolTip(plain_tip(entry.tip))
                    item.setFlags(item.flags() | Qt.ItemFlag.ItemIsUserCheckable)
            for row in range(self.list.count()):
                item = self.list.item(row)
                is_source = item.data(_ID) in chosen
                item.setCheckState(Qt.CheckState.Checked if is_source else Qt.CheckState.Unchecked)
                font = item.font()
                font.setItalic(item.data(_IS_OUT) and not is_source)
                item.setFont(font)
        finally:
            self._is_following = False
        suggested = (layer_id for layer_id, reason in reasons.items() if reason is None)
        self.suggested.setEnabled(not {entry.layer_id for entry in entries}.isdisjoint(suggested))
        self.none.setEnabled(bool(sources))

    def checked(self) -> Sources:
        """Layer ids of the checked rasters, missing ones included."""
        items = [self.list.item(row) for row in range(self.list.count())]
        return tuple(item.data(_ID) for item in items if item.checkState() == Qt.CheckState.Checked)

    def _button(self, text: str, tip: str) -> QToolButton:
        button = QToolButton(self)
        button.setText(text)
        button.setToolTip(tip)
        button.setAutoRaise(True)
        button.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        return button

    def _tell(self, _item: QListWidgetItem) -> None:
        if not self._is_following:
            self.changed.emit(self.checked())


def _entries(mosaic_id: str, sources: Sources, reasons: Mapping[str, Message | None]) -> list[_Entry]:
    """Missing sources first, then the suggested ones, last those that are left out, each by name."""
    rasters = [layer for layer in file_rasters() if layer.id() != mosaic_id]
    there = {layer.id() for layer in rasters}
    entries = []
    for source in sources:
        if source not in there and source != mosaic_id:
            layer = QgsProject.instance().mapLayer(source)
            name = filled(tr("missing: {name}"), name=layer.name()) if layer is not None else missing_text(source)
            tip = filled(tr("Not in the project any more, or its file can't be opened: {name}"), name=source)
            entries.append(_Entry(source, name, tip))
    fit: list[_Entry] = []
    unfit: list[_Entry] = []
    for layer in rasters:
        why = reasons.get(layer.id())
        reason = "" if why is None else sentence(why)
        text = f"{layer.name()} \u2013 {reason}" if reason else layer.name()
        tip = "\n".join(filter(None, (reason, layer.source())))
        (unfit if reason else fit).append(_Entry(layer.id(), text, tip, bool(reason)))
    return [*entries, *fit, *unfit]
