"""What the dock is told of a target: its bars, its reference group, and what its distances and amplitudes mean."""
from __future__ import annotations

from collections.abc import Mapping

from qgis.PyQt.QtCore import QObject, pyqtSignal
from qgis.PyQt.QtWidgets import QComboBox, QDoubleSpinBox, QFormLayout, QHBoxLayout, QSpinBox, QWidget

from ...toolkit.translation import tr
from ..measure import target as limits
from ..measure.target import BAR, COARSEST, CYCLE, GROUP, Target


class TargetSettings(QObject):
    """The boxes of a target."""

    changed = pyqtSignal()
    """Another target is set."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.bars = whole_box(limits.DEFAULT_BARS, limits.MIN_BARS)
        self.reference_group = whole_box(limits.DEFAULT_REFERENCE_GROUP)
        self.reference_grd = QDoubleSpinBox()
        self.reference_grd.setRange(0.01, 100000)
        self.reference_grd.setSuffix(tr(" cm"))
        self.reference_grd.setValue(limits.DEFAULT_REFERENCE_GRD_CM)
        self.grd_of = choice_box({CYCLE: tr("bar and gap"), BAR: tr("one bar")})
        self.full_amplitude = choice_box({GROUP: tr("of the group"), COARSEST: tr("of the coarsest group")})
        self.bars.setToolTip(tr("How many bars each group of the target has."))
        self.reference_group.setToolTip(tr("Number of the group whose distance is known. Higher numbers are finer."))
        self.reference_grd.setToolTip(tr("Distance of the reference group: the width of what is chosen beside it."))
        self.grd_of.setToolTip(tr(
            "What a distance is the width of: a bar and a gap together, as resolution is defined, or one bar, as some "
            "targets and reports count."
        ))
        self.full_amplitude.setToolTip(tr(
            "What the amplitude has to be half of: the group's own bars against plain gaps, or the full amplitude of "
            "the coarsest group, which is stricter."
        ))
        for number in (self.bars, self.reference_group, self.reference_grd):
            number.valueChanged.connect(lambda *_: self.changed.emit())
        for choice in (self.grd_of, self.full_amplitude):
            choice.currentIndexChanged.connect(lambda *_: self.changed.emit())

    def target(self) -> Target:
        """As it is set."""
        return Target(
            self.bars.value(), self.reference_group.value(), self.reference_grd.value(),
            grd_of=self.grd_of.currentData(), full_amplitude=self.full_amplitude.currentData(),
        )

    def add_to(self, form: QFormLayout) -> None:
        """Its rows."""
        form.addRow(tr("Bars"), self.bars)
        form.addRow(tr("Reference"), row(self.reference_group, self.reference_grd, self.grd_of))
        form.addRow(tr("Full amplitude"), self.full_amplitude)


def whole_box(value: int, least: int = -999) -> QSpinBox:
    """A box for a number of groups or bars."""
    box = QSpinBox()
    box.setRange(least, 999)
    box.setValue(value)
    return box


def choice_box(words: Mapping[str, str]) -> QComboBox:
    """A choice of values by their words."""
    box = QComboBox()
    for value, word in words.items():
        box.addItem(word, value)
    return box


def row(*widgets: QWidget) -> QWidget:
    """Widgets beside each other."""
    made, layout = QWidget(), QHBoxLayout()
    layout.setContentsMargins(0, 0, 0, 0)
    for widget in widgets:
        layout.addWidget(widget, 1)
    made.setLayout(layout)
    return made
