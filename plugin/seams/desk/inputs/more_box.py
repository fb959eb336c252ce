"""The inputs that are seldom changed: spacing, wavelet, levels, limits, verdict, seam cells, how to scan."""
from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from typing import TYPE_CHECKING, Any

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
                box.activated.connect(partial(self._choose_word, name))
            else:
                box.valueChanged.connect(partial(self.changed.emit, name))
        self.setCollapsed(True)

    def show_inputs(self, inputs: Inputs) -> None:
        """Show the values of the inputs; ``changed`` is emitted for those that differ."""
        self.cells.leave_out(vectors_without(CELL_FIELD))
        for name, box in self.boxes.items():
            show_value(box, getattr(inputs, name))

    def _choose_word(self, name: str, _index: int) -> None:
        self.changed.emit(name, self.boxes[name].currentData())


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
