"""What is inspected: mosaic, sources, seamlines and how; folded to one line once there is a window."""
from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

from qgis.core import Qgis, QgsMapLayer, QgsMapLayerProxyModel, QgsProject
from qgis.gui import QgsCollapsibleGroupBoxBasic, QgsDoubleSpinBox, QgsSpinBox
from qgis.PyQt.QtCore import Qt, pyqtSignal
from qgis.PyQt.QtGui import QShowEvent
from qgis.PyQt.QtWidgets import QComboBox, QGridLayout, QLabel, QSizePolicy, QVBoxLayout, QWidget

from ....imagery import limits as imagery_limits
from ....imagery.errors import WARNING, SettingsError
from ....toolkit.connections import Connections
from ....toolkit.desk.widgets import LayerBox, SummaryBox, single_shot, vectors_without
from ....toolkit.layers import other_systems
from ....toolkit.project_settings import unmodified
from ....toolkit.translation import filled, sentence, shown_metres, tr
from ...measure import limits, messages
from ...measure.limits import DENSITIES
from ...measure.planning.window_placing import fitting_side_m, window_side_px
from ...measure.window_records import REFERENCES
from ...tables.input_layers import CELL_FIELD, LOCATION_FIELD
from ...words import shown_side
from .sources import SourceList, Suggesting

if TYPE_CHECKING:
    from ..session import Session
    from .project_inputs import Inputs

_TOGETHER_MS = 300  # layers that are added within this time are looked at once
_Filter = QgsMapLayerProxyModel.Filter


class InputsPanel(QWidget):
    """Shows the session's inputs and changes them."""

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._session = session
        self._is_following = False
        self._was_folded = False
        self.suggesting = Suggesting(session, self)
        self._suggester = single_shot(self, self._suggest_layers, _TOGETHER_MS)
        self._table_fields()
        self._lay_out()
        self._connections = Connections(
            (session.inputsChanged, self.refresh),
            (QgsProject.instance().cleared, self.suggesting.forget_choices),
            (QgsProject.instance().layersAdded, self._take_layers),
            (QgsProject.instance().layersRemoved, self.refresh),
            (QgsProject.instance().layerTreeRoot().nameChanged, self._summarize),
            (session.windowsChanged, self._fold_once),
        )
        self.refresh()

    def close(self) -> bool:
        """Stop following session and project."""
        self._connections.close()
        self._suggester.stop()
        return bool(super().close())

    def refresh(self, *_: object) -> None:
        """Show the session's inputs."""
        self.suggesting.follow()
        inputs = self._session.inputs
        self._is_following = True
        try:
            self.index.leave_out(vectors_without(LOCATION_FIELD))
            self.mosaic.show_layer(inputs.mosaic)
            self.sources.show_sources(inputs.mosaic, inputs.sources, self.suggesting.reasons)
            self.index.show_layer(inputs.source_index)
            self.seamlines.show_layer(inputs.seamlines)
            self.windows.show_layer(inputs.windows)
            show_value(self.side, inputs.side_m)
            self.more.show_inputs(inputs)
        finally:
            self._is_following = False
        self._show_doubts()
        self._fit_side()
        self._show_side()
        self._summarize()
        if not inputs.mosaic:  # another project
            self._was_folded = False
            self.box.fold(False)

    # What the operator changes

    def _take(self, field: str, value: Any) -> None:
        """Another value of a field of ``Inputs``."""
        if not self._is_following:
            self._session.set_inputs(replace(self._session.inputs, **{field: value}))

    # Following the project

    def _take_layers(self, _added: list[QgsMapLayer]) -> None:
        self._suggester.start()
        self.refresh()

    def _summarize(self, *_: object) -> None:
        self.box.set_summary(*self._summary())

    def _suggest_layers(self) -> None:
        if self.isVisible():
            self.suggesting.suggest_layers()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._suggester.start()

    def _show_doubts(self) -> None:
        inputs, project = self._session.inputs, QgsProject.instance()
        chosen = other_systems(map(project.mapLayer, (inputs.mosaic, *inputs.sources)))
        self.doubts.setText(" ".join(map(sentence, chosen)))
        self.doubts.setVisible(bool(self.doubts.text()))

    def _fold_once(self) -> None:
        """With the first window there is other work to do."""
        if not self._was_folded and self._session.windows():
            self._was_folded = True
            self.box.fold(True)

    def _missing(self) -> str:
        """What is to be set still, in words; empty when nothing is."""
        inputs, project = self._session.inputs, QgsProject.instance()
        if not inputs.mosaic:
            return tr("choose the mosaic")
        if not any(project.mapLayer(name) is not None for name in (*inputs.sources, inputs.source_index)):
            return tr("check the sources")
        return ""

    # What is shown

    def _summary(self) -> tuple[str, str, str]:
        """``ortho_2024``, `` · 8 sources · seamlines``, and why nothing can be inspected with these."""
        inputs, project = self._session.inputs, QgsProject.instance()
        if not inputs.mosaic:
            return filled(tr("Inputs: {missing}"), missing=self._missing()), "", ""
        count = sum(project.mapLayer(source) is not None for source in inputs.sources)
        problem = self._session.problem() if self._session.mosaic_layer() is not None else None
        parts = [""]
        if problem is not None and problem != messages.NO_SOURCES_GIVEN():  # it is not the sources that are missing
            parts.append(tr("opening ...") if problem.level is WARNING else tr("can't be used"))
        counted = tr("1 source") if count == 1 else filled(tr("{count} sources"), count=count)
        if count or len(parts) == 1:
            parts.append(self._missing() or counted)
        if count < len(inputs.sources):
            parts.append(filled(tr("{count} missing"), count=len(inputs.sources) - count))
        if project.mapLayer(inputs.source_index) is not None:
            parts.append(tr("source index"))
        if project.mapLayer(inputs.seamlines) is not None:
            parts.append(tr("seamlines"))
        return self.mosaic.currentText(), " · ".join(parts), sentence(problem) if problem is not None else ""

    def _fit_side(self) -> None:
        """A side that the mosaic has no room for, or too few pixels, gives way to one that suits it, and the spacing to
        twice that."""
        inputs, grid = self._session.inputs, self._session.mosaic_grid()
        if grid is None:
            return
        fitting = fitting_side_m(grid, inputs.placing)
        if fitting != inputs.side_m:
            with unmodified(QgsProject.instance()):
                self._session.set_inputs(replace(inputs, side_m=fitting, spacing_m=2 * fitting))
            asked, side, spacing = map(shown_metres, (inputs.side_m, fitting, 2 * fitting))
            text = tr("{asked} m does not fit this mosaic: {side} m now, a window every {spacing} m")
            said = filled(text, asked=asked, side=side, spacing=spacing)
            self._session.messageRaised.emit(said, int(Qgis.MessageLevel.Info))

    def _show_side(self) -> None:
        """What becomes of the side: pixels, and the metres that these span."""
        inputs, grid = self._session.inputs, self._session.mosaic_grid()
        text, tip = "", ""
        if grid is not None:
            try:
                pixels = window_side_px(grid, inputs.placing)
                metres = pixels * grid.ground_sample_distance
                text = filled(tr("{pixels} px, {metres} m"), pixels=pixels, metres=shown_side(metres))
                tip = tr("The smallest power of two of the mosaic's pixels that spans at least the given metres")
                if pixels < limits.MEASURABLE_SIDE_PX:
                    few = tr("few windows below {pixels} px can be measured")
                    text, tip = f"{text} (!)", filled(few, pixels=limits.MEASURABLE_SIDE_PX)
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
        self.side.setDecimals(2)  # 15.4 m would need twice the pixels of 15.36 m, 512 of 3 cm
        self.side.setToolTip(tr("Minimum side of a clicked or placed window, in metres"))
        self.side_px = QLabel(self.box)
        self.doubts = QLabel(self)
        self.doubts.setTextFormat(Qt.TextFormat.PlainText)
        self.doubts.setWordWrap(True)
        self.doubts.setVisible(False)
        self.more = MoreBox(self.box)
        self.mosaic.chosen.connect(self.suggesting.choose_mosaic)
        self.sources.changed.connect(partial(self._take, "sources"))
        self.sources.suggestionWanted.connect(self.suggesting.take_suggested)
        self.index.chosen.connect(partial(self._take, "source_index"))
        self.seamlines.chosen.connect(self.suggesting.choose_seamlines)
        self.windows.chosen.connect(partial(self._take, "windows"))
        self.side.valueChanged.connect(partial(self._take, "side_m"))
        self.more.changed.connect(self._take)

    def _lay_out(self) -> None:
        grid = QGridLayout(self.box)
        grid.setColumnStretch(1, 2)
        grid.setColumnStretch(2, 1)
        grid.setVerticalSpacing(3)
        add_field(grid, 0, tr("&Mosaic"), self.mosaic)
        grid.addWidget(self.sources, 1, 0, 1, 3)
        add_field(grid, 2, tr("Source &index"), self.index)
        add_field(grid, 3, tr("Seam&lines"), self.seamlines)
        add_field(grid, 4, tr("&Windows"), self.windows)
        add_field(grid, 5, tr("Window si&de"), self.side, self.side_px)
        grid.addWidget(self.more, 6, 0, 1, 3)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.box)
        layout.addWidget(self.doubts)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Maximum)
        before_more = (self.index, self.seamlines, self.windows, self.side, self.more)
        order = (self.box, self.mosaic, *self.sources.fields, *before_more, *self.more.boxes.values())
        for before, after in zip(order, order[1:]):
            QWidget.setTabOrder(before, after)


class MoreBox(QgsCollapsibleGroupBoxBasic):
    """Folded until it is asked for."""

    changed = pyqtSignal(str, object)  # the name of a field of ``Inputs`` and its new value

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("More"), parent)
        self.setToolTip(
            tr("Spacing of placed windows, wavelet, levels, the limit of a significant loss and what it is compared "
               "with, seam cells, how a whole mosaic is scanned")
        )
        references = (tr("the seam"), tr("the composite"), tr("the sources (paper)"))
        densities = (tr("along the seams"), tr("every pixel"))
        self.cells = LayerBox(QgsMapLayerProxyModel.Filter.PolygonLayer, tr("none"), self)
        levels = QgsSpinBox(self)
        levels.setRange(imagery_limits.MIN_LEVELS, imagery_limits.MAX_LEVELS)
        levels.setClearValue(imagery_limits.DEFAULT_LEVELS)
        levels.setKeyboardTracking(False)
        corridor = metres_box(0, 10, self)
        corridor.setMinimum(0)
        corridor.setSpecialValueText(tr("whole mosaic"))
        fields: tuple[tuple[str, str, QWidget, str], ...] = (
            ("spacing_m", tr("S&pacing"), metres_box(limits.STANDARD_SPACING_M, 50, self),
             tr("Metres along the seam from one placed window to the next")),
            ("wavelet", tr("Wa&velet"), _word_box(zip(imagery_limits.WAVELETS, imagery_limits.WAVELETS), self),
             tr("An orthogonal wavelet of PyWavelets; the Coiflet of order 3 is the one of Pyka's papers.")),
            ("levels", tr("L&evels"), levels,
             tr("Steps of the decomposition. Level 1 holds the finest detail, each further one detail twice as "
                "coarse.")),
            ("reference", tr("Verdict &by"), _word_box(zip(REFERENCES, references), self),
             tr("What decides the verdict: what is kept along the seam; the whole window against the hard cut of the "
                "sources; or each source's whole clip, as in Pyka's papers")),
            ("min_kept", tr("Least &kept"), _share_box(limits.MAX_SIGNIFICANT_KEPT, self),
             tr("By the seam, a loss is significant when by the best estimate at most this share of the finest detail "
                "is kept along it, and some loss is certain")),
            ("max_ratio", tr("Largest &ratio"), _share_box(imagery_limits.MAX_SIGNIFICANT_RATIO, self),
             tr("By the sources or their composite, a loss is significant when the mosaic keeps at most this share of "
                "their detail at level 1")),
            ("cells", tr("Seam &cells"), self.cells,
             tr("Polygons that say in a field 'source' which orthoimage the mosaic was cut from; without them that is "
                "found from the pixels")),
            ("density", tr("Sca&n"), _word_box(zip(DENSITIES, densities), self),
             tr("What a scan of the whole mosaic measures: everything along the seams and samples elsewhere, in about "
                "the time that reading takes, or everything everywhere")),
            ("piece_m", tr("Se&am pieces"), metres_box(limits.STANDARD_PIECE_M, 5, self),
             tr("Metres of seam that a scan measures and judges as one")),
            ("corridor_m", tr("C&orridor"), corridor, tr("Metres that a scan reads on either side of the seamlines")),
        )  # fmt: skip
        self.boxes = {name: box for name, _, box, _ in fields}
        """Boxes by the fields of ``Inputs``, in tab order."""
        layout = QGridLayout(self)
        layout.setContentsMargins(0, 4, 0, 0)
        layout.setVerticalSpacing(3)
        layout.setColumnStretch(1, 1)
        for row, (name, label, box, tip) in enumerate(fields):
            box.setToolTip(tip)
            add_field(layout, row, label, box)
            if isinstance(box, LayerBox):
                box.chosen.connect(partial(self.changed.emit, name))
            elif isinstance(box, QComboBox):
                box.activated.connect(lambda _place, name=name, box=box: self.changed.emit(name, box.currentData()))
            else:
                box.valueChanged.connect(partial(self.changed.emit, name))
        self.setCollapsed(True)

    def show_inputs(self, inputs: Inputs) -> None:
        """Show the values of the inputs; ``changed`` is emitted for those that differ."""
        self.cells.leave_out(vectors_without(CELL_FIELD))
        for name, box in self.boxes.items():
            show_value(box, getattr(inputs, name))


def _word_box(words: Iterable[tuple[str, str]], parent: QWidget) -> QComboBox:
    """A choice of words: as the inputs have them, and as the operator reads them."""
    box = QComboBox(parent)
    for word, text in words:
        box.addItem(text, word)
    return box


def _share_box(usual: float, parent: QWidget) -> QgsDoubleSpinBox:
    box = metres_box(usual, 0.05, parent)
    box.setRange(0.01, 0.99)
    box.setDecimals(2)
    box.setSuffix("")
    return box


def metres_box(usual: float, step: float, parent: QWidget) -> QgsDoubleSpinBox:
    """A box for a length that is taken when it is complete, not digit by digit."""
    box = QgsDoubleSpinBox(parent)
    box.setRange(0.1, 99_999)
    box.setDecimals(1)
    box.setSingleStep(step)
    box.setSuffix(" m")
    box.setClearValue(usual)
    box.setKeyboardTracking(False)
    return box


def show_value(box: QWidget, value: Any) -> None:
    """A layer, word or number; where a number is there already its box is left alone: another may be being typed."""
    if isinstance(box, LayerBox):
        box.show_layer(value)
    elif isinstance(box, QComboBox):
        box.setCurrentIndex(box.findData(value))
    elif box.value() != value:
        box.setValue(int(value) if isinstance(box, QgsSpinBox) else value)


def add_field(grid: QGridLayout, row: int, text: str, *fields: QWidget) -> None:
    """A row of a form: the label with its shortcut, and what it names."""
    label = QLabel(text)
    label.setBuddy(fields[0])
    label.setToolTip(fields[0].toolTip())
    grid.addWidget(label, row, 0)
    for column, field in enumerate(fields, start=1):
        grid.addWidget(field, row, column, 1, 1 if len(fields) > 1 else 2)
