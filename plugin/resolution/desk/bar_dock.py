"""The dock of bar groups: draw a line across the bars of each group and watch its profile."""
from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Optional

from qgis.core import (
    QgsApplication,
    QgsGeometry,
    QgsMapLayerProxyModel,
    QgsPointXY,
    QgsProject,
    QgsRasterLayer,
    QgsVectorLayer,
)
from qgis.gui import QgisInterface
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtGui import QResizeEvent
from qgis.PyQt.QtWidgets import (
    QBoxLayout,
    QComboBox,
    QDoubleSpinBox,
    QFormLayout,
    QHBoxLayout,
    QSpinBox,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ...imagery.errors import Message, SeamInspectorError
from ...imagery.open_raster import describe_north_up
from ...imagery.rasters import Raster, RasterRef
from ...toolkit.background_tasks import BackgroundTasks, Cancelled, Job, Outcome
from ...toolkit.desk.tool_dock import ToolDock, bar_level
from ...toolkit.desk.widgets import ClippedLabel, LayerBox, vectors_without
from ...toolkit.layers import layer_ref, mosaic_crs, transformed_place
from ...toolkit.reference_systems import transformation
from ...toolkit.translation import sentence, tr
from .. import line_layers
from ..distance_words import verdict_text
from ..line_layers import GROUP, drawn_lines, pixel_segment
from ..measure import messages
from ..measure import target as limits
from ..measure.bar_groups import TargetResolution, judge_lines
from ..measure.bars import BarLine, MeasuredLine, measure_line
from ..measure.profiles import Segment
from ..measure.target import DIRECTIONS, Target
from .bar_profile import BarProfile
from .bar_tool import BarTool

if TYPE_CHECKING:
    from ..measure.bar_groups import GroupResult


class TargetSettings:
    """The fields of a target."""

    def __init__(self, changed: Callable[[], None]) -> None:
        """``changed``: called when another target is set."""
        self.bars = whole_box(limits.DEFAULT_BARS, limits.MIN_BARS)
        self.reference_group = whole_box(limits.DEFAULT_REFERENCE_GROUP)
        self.reference_grd = QDoubleSpinBox()
        self.reference_grd.setRange(0.01, 100000)
        self.reference_grd.setSuffix(tr(" cm"))
        self.reference_grd.setValue(limits.DEFAULT_REFERENCE_GRD_CM)
        self.grd_of = choice_box(limits.DISTANCES, tr("bar and gap"), tr("one bar"))
        self.full_amplitude = choice_box(limits.FULL_AMPLITUDES, tr("of the group"), tr("of the coarsest group"))
        self.bars.setToolTip(tr("How many bars each group of the target has."))
        self.reference_group.setToolTip(tr("Number of the group whose distance is known. Higher numbers are finer."))
        self.reference_grd.setToolTip(tr("Distance of the reference group: the width of what is chosen beside it."))
        self.grd_of.setToolTip(tr(
            "What a distance measures: a bar and a gap together, as resolution is defined, or one bar, as some targets "
            "and reports count."
        ))
        self.full_amplitude.setToolTip(tr(
            "What the amplitude has to be half of: the group's own bars against plain gaps, or the full amplitude of "
            "the coarsest group, which is stricter."
        ))
        for number in (self.bars, self.reference_group, self.reference_grd):
            number.valueChanged.connect(lambda *_: changed())
        for choice in (self.grd_of, self.full_amplitude):
            choice.currentIndexChanged.connect(lambda *_: changed())

    def target(self) -> Target:
        return Target(
            self.bars.value(), self.reference_group.value(), self.reference_grd.value(),
            grd_of=self.grd_of.currentData(), full_amplitude=self.full_amplitude.currentData(),
        )

    def add_to(self, form: QFormLayout) -> None:
        form.addRow(tr("Bars"), self.bars)
        form.addRow(tr("Reference"), row(self.reference_group, self.reference_grd, self.grd_of))
        form.addRow(tr("Full amplitude"), self.full_amplitude)


def whole_box(value: int, least: int = -999) -> QSpinBox:
    box = QSpinBox()
    box.setRange(least, 999)
    box.setValue(value)
    return box


def choice_box(values: Sequence[str], *words: str) -> QComboBox:
    box = QComboBox()
    for value, word in zip(values, words):
        box.addItem(word, value)
    return box


def row(*widgets: QWidget) -> QWidget:
    """A widget of others beside each other."""
    box = QWidget()
    layout = QHBoxLayout(box)
    layout.setContentsMargins(0, 0, 0, 0)
    for widget in widgets:
        layout.addWidget(widget, 1)
    return box


MeasuredLines = dict[tuple[Optional["Segment"], int, float], MeasuredLine]  # by place, bars in a group, width


def image_job(ref: RasterRef) -> Job:
    """Opens an image; yields the Raster, or the Message why it can't be used."""

    def job(_cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        try:
            yield 1.0, describe_north_up(ref)
        except SeamInspectorError as error:
            yield 1.0, error.message

    return job


def bar_job(
    raster: Raster, line: BarLine, others: Sequence[BarLine], known: MeasuredLines, target: Target, width: float
) -> Job:
    """Measures one line and judges it with the others of its target; yields the TargetResolution, the line's own last.

    ``known``: what was measured before, to which the others are added.
    """

    def job(cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        measured = []
        for other in others:
            key = other.segment, target.bars, width
            if key not in known:
                known[key] = measure_line(raster, other, target.bars, width)
            measured.append(replace(known[key], line=other))
            if cancelled():
                return
        measured.append(measure_line(raster, line, target.bars, width))
        if not cancelled():
            yield 1.0, judge_lines(raster, measured, target)

    return job


_Filter = QgsMapLayerProxyModel.Filter


class BarDock(ToolDock):
    """The dock; it owns the map tool, the profile and the tasks."""

    def __init__(self, iface: QgisInterface) -> None:
        super().__init__(iface, tr("Bar groups"), "SeamInspectorBarDock")
        self._background = BackgroundTasks(self)
        self._raster: Raster | None = None  # the image, once it is open
        self._waiting: BarLine | None = None  # the newest line, while an older one is measured
        self._shown: BarLine | None = None  # the line whose profile is to be seen, or soon will be
        self._measured: MeasuredLines = {}  # the layer's lines on this image, as far as they were measured
        self.results: tuple[GroupResult, ...] = ()
        tool = BarTool(self._canvas)
        self._offer_tool(
            tool, "bar_group", tr("Draw a line across the bars of the group: drag, or click at both ends.")
        )
        self.image = LayerBox(_Filter.RasterLayer, tr("no image"))
        self.image.only_files()
        self.lines = LayerBox(_Filter.LineLayer, tr("new layer"))
        self.settings = TargetSettings(self._target_changed)
        self.group = whole_box(1)
        self.direction = choice_box(DIRECTIONS, tr("along"), tr("across"))
        self.profile = BarProfile()
        self.verdict = ClippedLabel(6)
        self._lay_out()
        self.image.layerChanged.connect(self._image_changed)
        self.direction.currentIndexChanged.connect(self._take_next)
        tool.moved.connect(self._line_moved)
        tool.drawn.connect(self._line_drawn)
        tool.cancelled.connect(self._line_cancelled)
        self._background.ended.connect(self._task_ended)
        self._background.failed.connect(self._warn)
        project = QgsProject.instance()
        project.layersAdded.connect(self._offer_bar_lines)
        self._offer_bar_lines()
        self._image_changed()

    def close_desk(self) -> None:
        super().close_desk()
        QgsProject.instance().layersAdded.disconnect(self._offer_bar_lines)
        self._background.close()

    def line_layer(self) -> QgsVectorLayer | None:
        """The layer that lines are added to; None until there is one."""
        layer = self.lines.currentLayer()
        return layer if isinstance(layer, QgsVectorLayer) else None

    def _offer_bar_lines(self, *_: object) -> None:
        """Layers of other lines, such as seams or contours, are none that groups could be added to."""
        self.lines.leave_out(vectors_without(GROUP))

    # the line

    def _line_moved(self, start: QgsPointXY, end: QgsPointXY) -> None:
        line = self._bar_line(start, end)
        if line is not None:
            self._measure(line)

    def _line_drawn(self, start: QgsPointXY, end: QgsPointXY) -> None:
        raster, line = self._raster, self._bar_line(start, end)
        if raster is None or line is None:
            return
        self._measure(line)
        try:
            layer = self.line_layer() or self._new_layer(raster)
            map_crs = self._canvas.mapSettings().destinationCrs()
            transform = transformation(map_crs, layer.crs(), QgsProject.instance().transformContext())
            shape = QgsGeometry.fromPolylineXY([start, end])
            line_layers.add_bar_line(layer, shape, transform, self.group.value(), self.direction.currentData())
        except SeamInspectorError as error:
            self._warn(error.message)
            return
        layer.triggerRepaint()
        self.group.setValue(self.group.value() + 1)

    def _target_changed(self) -> None:
        if self._shown is not None:
            self._measure(self._shown)

    def _line_cancelled(self) -> None:
        self._waiting = self._shown = None
        self.results = ()
        self.profile.show_results([], self.settings.target().criterion)
        self.verdict.setText(self.draw.toolTip())

    def _new_layer(self, raster: Raster) -> QgsVectorLayer:
        folder = Path(QgsProject.instance().homePath() or QgsApplication.qgisSettingsDirPath())
        layer = line_layers.create_bar_layer(raster.wkt, folder)
        QgsProject.instance().addMapLayer(layer)
        self.lines.show_layer(layer.id())
        return layer

    def _take_next(self) -> None:
        """The next number of the direction, where its lines have numbers."""
        following = line_layers.next_group(self.line_layer(), self.direction.currentData())
        if following is not None:
            self.group.setValue(following)

    def _bar_line(self, start: QgsPointXY, end: QgsPointXY) -> BarLine | None:
        """A line of the map in pixels of the image; None without image or where the map has no place on it."""
        if self._raster is None:
            return None
        map_crs, crs = self._canvas.mapSettings().destinationCrs(), mosaic_crs(self._raster)
        ends = [place for point in (start, end) if (place := transformed_place(point, map_crs, crs)) is not None]
        if len(ends) < 2 or ends[0] == ends[1]:
            return None
        return BarLine(self.group.value(), self.direction.currentData(), pixel_segment(ends, self._raster.grid))

    # measuring, in the background

    def _measure(self, line: BarLine) -> None:
        """Measure a line as soon as the one before is done; those between are left out."""
        if self._raster is None:
            return
        self._shown = line
        if self._background.is_under_way(_KEY):
            self._waiting = line
            return
        self._waiting = None
        others = [
            other for other in drawn_lines(self.line_layer(), self._raster.grid, mosaic_crs(self._raster))
            if (other.group, other.direction) != (line.group, line.direction)
        ]
        width = limits.DEFAULT_BAR_WIDTH_PX
        job = bar_job(self._raster, line, others, self._measured, self.settings.target(), width)
        self._background.start(tr("Measure a bar group"), job, self._take, _KEY)

    def _task_ended(self, key: object, outcome: Outcome) -> None:
        if key == _IMAGE_KEY and any(outcome):
            self.image.show_layer("")  # cancelled in QGIS, or failed, which a message told
            self._image_changed()
        elif self._waiting is not None:
            self._measure(self._waiting)

    def _take(self, resolution: object) -> None:
        assert isinstance(resolution, TargetResolution)
        last = resolution.results[-1].measured  # the line itself, after the others of its target
        self.results = tuple(result for result in resolution.results if result.measured is last)
        self.profile.show_results(self.results, self.settings.target().criterion)
        self.verdict.setText(verdict_text(self.results, resolution))

    def _image_changed(self) -> None:
        """Open the image, in the background: it may lie on a slow network."""
        self._background.abandon()  # what is under way is of the image before
        self._raster = self._waiting = self._shown = None
        self._measured = {}
        self.draw.setEnabled(False)
        layer = self.image.currentLayer()
        if not isinstance(layer, QgsRasterLayer):
            self._refuse(messages.NO_BAR_IMAGE())
            return
        try:
            job = image_job(layer_ref(layer))
        except SeamInspectorError as error:
            self._refuse(error.message)
            return
        self.verdict.setText(tr("Reading the pictures ..."))
        self._background.start(tr("Read pictures"), job, self._take_image, _IMAGE_KEY)

    def _take_image(self, image: object) -> None:
        if isinstance(image, Raster):
            self._raster = image
            self.draw.setEnabled(True)
            self.verdict.setText(self.draw.toolTip())
        else:
            assert isinstance(image, Message)
            self._refuse(image)

    def _refuse(self, why: Message) -> None:
        """Put the tool away and show why there is no image to draw on."""
        self._leave_tool()
        self.verdict.setText(sentence(why))

    # widgets

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Side by side when the dock is wide, one above the other when it is narrow."""
        super().resizeEvent(event)
        ways = QBoxLayout.Direction
        self._sides.setDirection(ways.LeftToRight if self.width() > 1.4 * self.height() else ways.TopToBottom)

    def _warn(self, message: Message) -> None:
        self._show_message(sentence(message), bar_level(message))

    def _lay_out(self) -> None:
        button = QToolButton()
        button.setDefaultAction(self.draw)
        button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.group.setToolTip(tr("Number of the group that is drawn next; it goes up by one with every line."))
        form = QFormLayout()
        form.setContentsMargins(0, 0, 0, 0)
        form.addRow(tr("Image"), self.image)
        form.addRow(tr("Lines"), self.lines)
        self.settings.add_to(form)
        form.addRow(tr("Group"), row(self.group, self.direction, button))
        settings = QVBoxLayout()
        settings.addLayout(form)
        settings.addStretch()
        shown = QVBoxLayout()
        shown.addWidget(self.profile, 1)
        shown.addWidget(self.verdict)
        self._sides = QBoxLayout(QBoxLayout.Direction.TopToBottom)
        self._sides.setContentsMargins(4, 2, 4, 4)
        self._sides.setSpacing(6)
        self._sides.addLayout(settings)
        self._sides.addLayout(shown, 1)
        body = QWidget()
        body.setLayout(self._sides)
        self.setWidget(body)


_KEY, _IMAGE_KEY = "bar group", "image"
