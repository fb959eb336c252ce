"""The inputs that are seldom changed: spacing, wavelet, levels, limits, verdict, seam cells, how to scan."""
from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from qgis.core import QgsMapLayerProxyModel
from qgis.gui import QgsCollapsibleGroupBoxBasic, QgsDoubleSpinBox, QgsSpinBox
from qgis.PyQt.QtCore import pyqtSignal
from qgis.PyQt.QtWidgets import QComboBox, QGridLayout, QLabel, QWidget

from ....imagery import limits as imagery_limits
from ....toolkit.desk.layer_box import LayerBox, vectors_without
from ....toolkit.translation import tr
from ...measure import limits
from ...measure.limits import DENSITIES
from ...measure.window_records import REFERENCES
from ...tables.input_layers import CELL_FIELD

if TYPE_CHECKING:
    from .project_inputs import Inputs


class MoreBox(QgsCollapsibleGroupBoxBasic):
    """Folded until it is asked for."""

    changed = pyqtSignal(str, object)
    """The name of a field of ``Inputs`` and its new value."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("More"), parent)
        self.setToolTip(
            tr("Spacing of placed windows, wavelet, levels, the limit of a significant loss and what it is taken "
               "against, seam cells, how a whole mosaic is scanned")
        )
        self.spacing = metres_box(limits.STANDARD_SPACING_M, 50, self)
        self.spacing.setToolTip(tr("Metres along the seam from one placed window to the next"))
        self.wavelet = QComboBox(self)
        self.wavelet.addItems(imagery_limits.WAVELETS)
        self.wavelet.setToolTip(
            tr("An orthogonal wavelet of PyWavelets; the Coiflet of order 3 is the one of Pyka's papers.")
        )
        self.levels = QgsSpinBox(self)
        self.levels.setRange(imagery_limits.MIN_LEVELS, imagery_limits.MAX_LEVELS)
        self.levels.setClearValue(imagery_limits.DEFAULT_LEVELS)
        self.levels.setKeyboardTracking(False)
        self.levels.setToolTip(
            tr("Steps of the decomposition. Level 1 holds the finest detail, each further one detail twice as coarse.")
        )
        self.min_kept = self._share_box(
            limits.MAX_SIGNIFICANT_KEPT,
            tr("By the seam, a loss is significant when at most this share of the finest detail is kept along it"),
        )
        self.max_ratio = self._share_box(
            imagery_limits.MAX_SIGNIFICANT_RATIO,
            tr("By the sources or their composite, a loss is significant when the mosaic keeps at most this share of "
               "their detail at level 1"),
        )
        self.reference = QComboBox(self)
        for reference, text in zip(REFERENCES, (tr("the seam"), tr("the composite"), tr("the sources (paper)"))):
            self.reference.addItem(text, reference)
        self.reference.setToolTip(
            tr("What the verdict is taken by: what is kept along the seam; the whole window against the hard cut of "
               "the sources; or each source's whole clip, as in Pyka's papers")
        )
        self.cells = LayerBox(QgsMapLayerProxyModel.Filter.PolygonLayer, tr("none"), self)
        self.cells.setToolTip(
            tr("Polygons that say in a field 'source' which orthoimage the mosaic was cut from; without them that is "
               "found from the pixels")
        )
        self.density = QComboBox(self)
        for density, text in zip(DENSITIES, (tr("along the seams"), tr("every pixel"))):
            self.density.addItem(text, density)
        self.density.setToolTip(
            tr("What a scan of the whole mosaic measures: everything along the seams and samples elsewhere, in about "
               "the time that reading takes, or everything everywhere")
        )
        self.piece = metres_box(limits.STANDARD_PIECE_M, 5, self)
        self.piece.setToolTip(tr("Metres of seam that a scan measures and judges as one"))
        self.corridor = metres_box(0, 10, self)
        self.corridor.setMinimum(0)
        self.corridor.setSpecialValueText(tr("whole mosaic"))
        self.corridor.setToolTip(tr("Metres that a scan reads on either side of the seamlines"))
        layout = QGridLayout(self)
        layout.setContentsMargins(0, 4, 0, 0)
        layout.setVerticalSpacing(3)
        layout.setColumnStretch(1, 1)
        add_field(layout, 0, tr("S&pacing"), self.spacing)
        add_field(layout, 1, tr("Wa&velet"), self.wavelet)
        add_field(layout, 2, tr("L&evels"), self.levels)
        add_field(layout, 3, tr("Verdict &by"), self.reference)
        add_field(layout, 4, tr("Least &kept"), self.min_kept)
        add_field(layout, 5, tr("Largest &ratio"), self.max_ratio)
        add_field(layout, 6, tr("Seam &cells"), self.cells)
        add_field(layout, 7, tr("Sca&n"), self.density)
        add_field(layout, 8, tr("Se&am pieces"), self.piece)
        add_field(layout, 9, tr("C&orridor"), self.corridor)
        self.setCollapsed(True)
        self.spacing.valueChanged.connect(partial(self.changed.emit, "spacing_m"))
        self.wavelet.activated.connect(self._choose_wavelet)
        self.levels.valueChanged.connect(partial(self.changed.emit, "levels"))
        self.min_kept.valueChanged.connect(partial(self.changed.emit, "min_kept"))
        self.max_ratio.valueChanged.connect(partial(self.changed.emit, "max_ratio"))
        self.reference.activated.connect(self._choose_reference)
        self.cells.chosen.connect(partial(self.changed.emit, "cells"))
        self.density.activated.connect(self._choose_density)
        self.piece.valueChanged.connect(partial(self.changed.emit, "piece_m"))
        self.corridor.valueChanged.connect(partial(self.changed.emit, "corridor_m"))

    def _share_box(self, default: float, tip: str) -> QgsDoubleSpinBox:
        box = QgsDoubleSpinBox(self)
        box.setRange(0.01, 0.99)
        box.setSingleStep(0.05)
        box.setClearValue(default)
        box.setKeyboardTracking(False)
        box.setToolTip(tip)
        return box

    def fields(self) -> tuple[QWidget, ...]:
        """In tab order."""
        return (
            self.spacing, self.wavelet, self.levels, self.reference, self.min_kept, self.max_ratio, self.cells,
            self.density, self.piece, self.corridor,
        )

    def show_inputs(self, inputs: Inputs) -> None:
        """Show the values of the inputs; ``changed`` is emitted for those that differ."""
        show_value(self.spacing, inputs.spacing_m)
        show_value(self.levels, inputs.levels)
        show_value(self.min_kept, inputs.min_kept)
        show_value(self.max_ratio, inputs.max_ratio)
        self.wavelet.setCurrentIndex(self.wavelet.findText(inputs.wavelet))
        self.reference.setCurrentIndex(self.reference.findData(inputs.reference))
        self.density.setCurrentIndex(self.density.findData(inputs.density))
        show_value(self.piece, inputs.piece_m)
        show_value(self.corridor, inputs.corridor_m)
        self.cells.leave_out(vectors_without(CELL_FIELD))
        self.cells.show_layer(inputs.cells)

    def _choose_wavelet(self, _index: int) -> None:
        self.changed.emit("wavelet", self.wavelet.currentText())

    def _choose_reference(self, _index: int) -> None:
        self.changed.emit("reference", self.reference.currentData())

    def _choose_density(self, _index: int) -> None:
        self.changed.emit("density", self.density.currentData())


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


def show_value(box: QgsDoubleSpinBox | QgsSpinBox, value: float) -> None:
    """Set a number; where it is there already the box is left alone, for another may be being typed."""
    if box.value() != value:
        if isinstance(box, QgsSpinBox):
            box.setValue(int(value))
        else:
            box.setValue(value)


def add_field(grid: QGridLayout, row: int, text: str, *fields: QWidget) -> None:
    """A row of a form: the label with its shortcut, and what it names."""
    label = QLabel(text)
    label.setBuddy(fields[0])
    label.setToolTip(fields[0].toolTip())
    grid.addWidget(label, row, 0)
    for column, field in enumerate(fields, start=1):
        grid.addWidget(field, row, column, 1, 1 if len(fields) > 1 else 2)
