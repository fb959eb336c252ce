"""What is inspected: mosaic, sources, seamlines and how; folded to one line once it is set."""
from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any, Callable

from qgis.core import QgsMapLayer, QgsMapLayerProxyModel, QgsProject
from qgis.PyQt.QtCore import pyqtSignal
from qgis.PyQt.QtGui import QResizeEvent
from qgis.PyQt.QtWidgets import QApplication, QGridLayout, QLabel, QSizePolicy, QVBoxLayout, QWidget

from ....imagery import limits as imagery_limits
from ....imagery.errors import SettingsError
from ....imagery.message import WARNING
from ....toolkit.desk.layer_box import LayerBox, vectors_without
from ....toolkit.desk.summary_box import SummaryBox
from ....toolkit.translation import sentence, tr
from ...measure.window_placing import window_side_px
from ...tables.source_index import LOCATION_FIELD
from .more_box import MoreBox, add_field, metres_box, show_value
from .source_list import SourceList, file_rasters, overlapping

if TYPE_CHECKING:
    from ..session import Session

_WIDE_CHARACTERS = 95  # from this width on the sources stand beside the other inputs
_Filter = QgsMapLayerProxyModel.Filter


class InputsPanel(QWidget):
    """Shows the session's inputs and changes them."""

    _chosen = pyqtSignal(str, object)
    """The name of a field of ``Inputs`` and its new value."""

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._is_following = False
        self._may_fold = True  # until it was folded once, or the operator did it
        self._had_mosaic = False
        self._is_wide: bool | None = None
        self._table_fields()
        self._lay_out()
        self._connections: list[tuple[Any, Callable[..., None]]] = [
            (session.inputsChanged, self.refresh),
            (QgsProject.instance().layersAdded, self._take_layers),
            (QgsProject.instance().layersRemoved, self._layers_removed),
            (QApplication.instance().focusChanged, self._focus_moved),
        ]
        for signal, slot in self._connections:
            signal.connect(slot)
        self.refresh()

    def close(self) -> bool:
        """Stop following session, project and focus."""
        while self._connections:
            signal, slot = self._connections.pop()
            signal.disconnect(slot)
        return bool(super().close())

    def refresh(self) -> None:
        """Show the session's inputs."""
        inputs = self._session.inputs
        self._is_following = True
        try:
            self.index.leave_out(vectors_without(LOCATION_FIELD))
            self.mosaic.show_layer(inputs.mosaic)
            self.sources.show_sources(inputs.mosaic, inputs.sources)
            self.index.show_layer(inputs.source_index)
            self.seamlines.show_layer(inputs.seamlines)
            self.windows.show_layer(inputs.windows)
            show_value(self.side, inputs.side_m)
            self.more.show_inputs(inputs)
        finally:
            self._is_following = False
        self._show_side()
        self.box.set_summary(*self._summary())
        self._fold_when_set()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._arrange()

    # What the operator changes

    def _take(self, field: str, value: object) -> None:
        self._change(**{field: value})

    def _change(self, **changes: Any) -> None:
        if not self._is_following:
            self._session.set_inputs(replace(self._session.inputs, **changes))

    def _choose_mosaic(self, layer_id: str) -> None:
        """Another mosaic of the same block keeps its sources; a new block gets all that overlap."""
        inputs = self._session.inputs
        if layer_id == inputs.mosaic:
            return
        suggested = overlapping(layer_id, file_rasters())
        kept = tuple(source for source in inputs.sources if source != layer_id)
        self._change(mosaic=layer_id, sources=kept if not layer_id or set(kept) & set(suggested) else suggested)

    # Following the project

    def _take_layers(self, added: list[QgsMapLayer]) -> None:
        """New rasters become sources as long as the operator left the choice to us: all that overlap."""
        inputs, rasters = self._session.inputs, file_rasters()
        ids = {layer.id() for layer in added}
        before = overlapping(inputs.mosaic, [layer for layer in rasters if layer.id() not in ids])
        after = overlapping(inputs.mosaic, rasters)
        if inputs.mosaic not in ids and set(inputs.sources) == set(before) != set(after):
            self._change(sources=after)
        self.refresh()

    def _layers_removed(self, _ids: list[str]) -> None:
        self.refresh()

    # Folding

    def _fold_when_set(self) -> None:
        """Fold once mosaic and sources are there, but not under the operator's hands."""
        inputs = self._session.inputs
        if self._had_mosaic and not inputs.mosaic:  # a new project
            self.box.fold(False)
            self._may_fold = True
        self._had_mosaic = bool(inputs.mosaic)
        is_set = self._session.mosaic_grid() is not None and bool(inputs.sources or inputs.source_index)
        if is_set and self._may_fold and not self._holds(QApplication.focusWidget()):
            self.box.fold(True)
            self._may_fold = False

    def _folded_by_hand(self) -> None:
        self._may_fold = False

    def _focus_moved(self, _before: QWidget | None, now: QWidget | None) -> None:
        if now is not None:
            self._fold_when_set()

    def _holds(self, widget: QWidget | None) -> bool:
        """Whether a widget belongs to this panel; its drop-down lists do, though they are windows."""
        while widget is not None and widget is not self:
            widget = widget.parentWidget()
        return widget is self

    # What is shown

    def _summary(self) -> tuple[str, str, str]:
        """``ortho_2024``, `` · 8 sources · seamlines``, and why nothing can be inspected with these."""
        inputs, project = self._session.inputs, QgsProject.instance()
        if not inputs.mosaic:
            return tr("Inputs: choose the mosaic"), "", ""
        count = sum(project.mapLayer(source) is not None for source in inputs.sources)
        problem = self._session.problem() if self._session.mosaic_layer() is not None else None
        parts = [""]
        if problem is not None and problem.level is WARNING:
            parts.append(tr("opening ..."))
        elif problem is not None and count:  # it is not the sources that are missing
            parts.append(tr("can't be used"))
        parts.append(tr("1 source") if count == 1 else tr("{count} sources").format(count=count))
        if count < len(inputs.sources):
            parts.append(tr("{count} missing").format(count=len(inputs.sources) - count))
        if project.mapLayer(inputs.source_index) is not None:
            parts.append(tr("source index"))
        if project.mapLayer(inputs.seamlines) is not None:
            parts.append(tr("seamlines"))
        return self.mosaic.currentText(), " · ".join(parts), sentence(problem) if problem is not None else ""

    def _show_side(self) -> None:
        """What becomes of the side: pixels, and the metres that these span."""
        inputs, grid = self._session.inputs, self._session.mosaic_grid()
        text = tip = ""
        if grid is not None:
            try:
                pixels = window_side_px(grid, inputs.side_m, inputs.spacing_m, inputs.levels)
                text = tr("{pixels} px, {metres:.1f} m").format(
                    pixels=pixels, metres=pixels * grid.ground_sample_distance
                )
                tip = tr("The smallest power of two of the mosaic's pixels that spans at least the given metres")
            except SettingsError as error:
                text, tip = tr("too short"), sentence(error.message)
        self.side_px.setText(text)
        self.side_px.setToolTip(tip)

    def _table_fields(self) -> None:
        self.box = SummaryBox(self)
        self.mosaic = LayerBox(_Filter.RasterLayer, tr("choose the mosaic"), self.box)
        self.mosaic.only_files()
        self.mosaic.setToolTip(tr("The orthophoto mosaic under inspection: north-up, a file that GDAL reads"))
        self.sources = SourceList(self.box)
        self.index = LayerBox(_Filter.PolygonLayer, tr("none"), self.box)
        self.index.setToolTip(
            tr("A tile index of orthoimages as gdaltindex writes it, for blocks with too many sources to load: "
               "polygons with the field 'location'")
        )
        self.seamlines = LayerBox(_Filter.LineLayer | _Filter.PolygonLayer, tr("none"), self.box)
        self.seamlines.setToolTip(
            tr("The mosaic's seams, or the polygons of its sources: windows are placed along them, and a click near "
               "one is moved onto it")
        )
        self.windows = LayerBox(_Filter.PolygonLayer, tr("new layer"), self.box)
        self.windows.setToolTip(tr("The polygon layer that holds the windows; a new one is made with the first window"))
        self.side = metres_box(imagery_limits.STANDARD_SIDE_M, 10, self.box)
        self.side.setToolTip(tr("Metres that a clicked or placed window spans at least"))
        self.side_px = QLabel(self.box)
        self.more = MoreBox(self.box)
        self.box.foldedByHand.connect(self._folded_by_hand)
        self.mosaic.chosen.connect(self._choose_mosaic)
        self.sources.changed.connect(partial(self._chosen.emit, "sources"))
        self.index.chosen.connect(partial(self._chosen.emit, "source_index"))
        self.seamlines.chosen.connect(partial(self._chosen.emit, "seamlines"))
        self.windows.chosen.connect(partial(self._chosen.emit, "windows"))
        self.side.valueChanged.connect(partial(self._chosen.emit, "side_m"))
        self.more.changed.connect(self._chosen)
        self._chosen.connect(self._take)

    def _lay_out(self) -> None:
        self._grid = QGridLayout(self.box)
        self._grid.setColumnStretch(1, 2)
        self._grid.setColumnStretch(2, 1)
        self._grid.setVerticalSpacing(3)
        add_field(self._grid, 0, tr("&Mosaic"), self.mosaic)
        add_field(self._grid, 2, tr("Source &index"), self.index)
        add_field(self._grid, 3, tr("Seam&lines"), self.seamlines)
        add_field(self._grid, 4, tr("&Windows"), self.windows)
        add_field(self._grid, 5, tr("Window si&de"), self.side, self.side_px)
        self._grid.addWidget(self.more, 6, 0, 1, 3)
        self._grid.setRowStretch(7, 1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.box)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Maximum)
        self._arrange()
        before_more = (self.index, self.seamlines, self.windows, self.side, self.more)
        order = (self.box, self.mosaic, *self.sources.fields(), *before_more, *self.more.fields())
        for before, after in zip(order, order[1:]):
            QWidget.setTabOrder(before, after)

    def _arrange(self) -> None:
        """The sources below the mosaic, or beside everything where there is room."""
        is_wide = self.width() > _WIDE_CHARACTERS * self.fontMetrics().averageCharWidth()
        if is_wide != self._is_wide:
            self._is_wide = is_wide
            self._grid.addWidget(self.sources, *((0, 3, 8, 1) if is_wide else (1, 0, 1, 3)))
            self._grid.setColumnStretch(3, 4 if is_wide else 0)
            aside = self.sources.minimumSizeHint().width() + self._grid.horizontalSpacing()
            self.box.spared_width = aside if is_wide else 0  # so that the panel can get narrow again
            self.box.updateGeometry()
