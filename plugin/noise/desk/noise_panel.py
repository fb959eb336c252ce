"""The tab with the random noise of the selected window, on the mosaic or on one of the sources over it."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

from qgis.core import QgsFeatureRequest, QgsFieldProxyModel, QgsVectorLayer
from qgis.gui import QgsFieldComboBox
from qgis.PyQt.QtCore import QSignalBlocker, Qt
from qgis.PyQt.QtGui import QCloseEvent, QHideEvent
from qgis.PyQt.QtWidgets import QComboBox, QHBoxLayout, QLabel, QWidget

from ...imagery import messages as imagery_messages
from ...imagery.clips import DrawnWindow, pixels_under
from ...imagery.errors import Message, SeamInspectorError
from ...imagery.grids import PixelWindow
from ...imagery.limits import DEFAULT_LEVELS
from ...imagery.open_raster import describe
from ...imagery.rasters import RasterRef
from ...toolkit.background_tasks import BackgroundTasks, Cancelled, Job
from ...toolkit.charts.chart_style import chart_missing
from ...toolkit.desk.chart_panel import MatplotlibPanel
from ...toolkit.desk.tabs import InspectedWindows, WindowOnRasters
from ...toolkit.desk.widgets import ClippedLabel, plain_tip, rich_tip
from ...toolkit.table_fields import text
from ...toolkit.translation import band_title, filled, sentence, tr
from ..measure.band_noise import noisiest_band
from ..measure.group_noise import ClipNoise, measure_window
from ..measure.window_choice import NOISE_WINDOWS
from ..noise_summary import NO_GROUP, CurveGroup, band_curve, band_lines, noise_sentence

if TYPE_CHECKING:
    from ...toolkit.background_tasks import Outcome
    from .noise_chart import NoiseChart

def noise_job(ref: RasterRef, drawn: DrawnWindow) -> Job:
    """Measures a window on the raster's own pixels, as the noise check does; yields the ClipNoise, or the Message why
    there is none."""

    def measured() -> ClipNoise | Message:
        try:
            window = pixels_under(drawn, describe(ref), DEFAULT_LEVELS)
            return imagery_messages.NOT_COVERED(name=ref.name) if window is None else measure_window(ref, window)
        except SeamInspectorError as error:
            return error.message

    def job(cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        if not cancelled():
            yield 1.0, measured()

    return job


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
            "Field that windows are grouped by, such as land use or scale: the range of all windows with the selected "
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


_Key = tuple[RasterRef, DrawnWindow]
_LOADING_MS = 100  # between looks whether matplotlib is there
_MOST_KEPT = 500  # results, for going back and forth


@dataclass(frozen=True)
class _Alike:
    """The windows of the selected one's group."""

    value: str
    """In the field that they are grouped by."""
    ref: RasterRef
    fids: frozenset[int]
    keys: tuple[_Key, ...]
    """Keys of as many as a noise check chooses on an image."""


def _drawn(request: WindowOnRasters, window: PixelWindow) -> DrawnWindow:
    mosaic = request.mosaic
    return DrawnWindow(request.window_id, mosaic.grid.window_extent(window), mosaic.wkt)


class NoisePanel(MatplotlibPanel):
    """Measures the first selected window, in the background and only while the panel is in sight."""

    def __init__(self, session: InspectedWindows, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._background = BackgroundTasks(self)
        self._background.ended.connect(self._ended)
        self._results: dict[_Key, ClipNoise | Message] = {}
        self._wanted: _Key | None = None
        self._refs: list[RasterRef] = []  # of the box's entries, the mosaic's first
        self._source: RasterRef | None = None  # the user's choice, kept while it does not cover a window
        self._chart: NoiseChart | None = None
        self._alike: _Alike | None = None
        self._build()
        session.selectionChanged.connect(self._refresh_now)
        session.windowsChanged.connect(self._forget_groups)
        session.inputsChanged.connect(self._forget)

    # Parts

    def _build(self) -> None:
        self._rasters = QComboBox()
        self._rasters.setToolTip(tr("Raster whose noise is measured: the mosaic, or a source that covers the window"))
        self._rasters.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self._rasters.setMinimumContentsLength(12)
        self._rasters.setEnabled(False)
        self._rasters.activated.connect(self._on_raster_chosen)
        self._field = FieldBox()
        self._field.fieldChanged.connect(self._forget_groups)
        self._window = QLabel()
        self._words = ClippedLabel(2)
        top = QHBoxLayout()
        top.addWidget(self._rasters, 1)
        top.addWidget(QLabel(tr("Group by")))
        top.addWidget(self._field)
        top.addWidget(self._window)
        self._lay_out(top, self._words)

    def _fill_rasters(self, request: WindowOnRasters) -> None:
        refs = [request.mosaic.ref, *(source.ref for source in request.sources)]
        if refs != self._refs:
            self._refs = refs
            self._rasters.clear()
            for ref in refs:
                self._rasters.addItem(ref.name)
                self._rasters.setItemData(self._rasters.count() - 1, plain_tip(ref.path), Qt.ItemDataRole.ToolTipRole)
            self._rasters.setItemText(0, filled(tr("{name} (mosaic)"), name=refs[0].name))
        self._rasters.setEnabled(True)
        self._rasters.setCurrentIndex(refs.index(self._source) if self._source in refs else 0)

    # When to measure

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self._wanted = None
        self._background.cancel_others(set())

    def closeEvent(self, event: QCloseEvent) -> None:
        """For good: the dock goes."""
        self._timer.stop()
        self._background.close()
        super().closeEvent(event)

    def _on_raster_chosen(self, index: int) -> None:
        self._source = self._refs[index] if index else None
        self._refresh_now()

    def _forget(self) -> None:
        """There may be something else in the files."""
        self._results.clear()
        self._refresh_now()

    def _forget_groups(self, *_: object) -> None:
        """Windows came, went or changed their values, or are grouped by another field."""
        self._alike = None
        self._refresh_now()

    def _refresh(self) -> None:
        """Show what was measured, or have it measured."""
        if not self.isVisible():
            return
        self._field.follow(self._session.window_layer())
        selected = self._session.selected()
        request = self._session.request(selected[0]) if selected else None
        self._wanted = None
        if request is None:
            self._background.cancel_others(set())
            self._window.setText("")
            self._rasters.setEnabled(False)
            self._say(self._why_nothing(bool(selected)))
            return
        self._window.setText(filled(tr("Window {number}"), number=request.window_id))
        self._fill_rasters(request)
        if request.window is None:
            self._background.cancel_others(set())
            self._say(sentence(request.reason) if request.reason else "")
            return
        ref = self._refs[self._rasters.currentIndex()]
        self._wanted = key = ref, _drawn(request, request.window)
        self._find_alike(selected[0], ref)
        alike = self._alike.keys if self._alike is not None else ()
        self._background.cancel_others({key, *alike})
        if key not in self._results:
            self._measure(key)
            self._say_measuring()
            return
        self._show(self._results[key])
        missing = next((one for one in alike if one not in self._results), None)
        if missing is not None:  # one after the other, so that what is selected next comes first
            self._measure(missing)

    def _measure(self, key: _Key) -> None:
        if not self._background.is_under_way(key):
            self._background.start(tr("Measure the noise"), noise_job(*key), partial(self._take, key), key)

    def _find_alike(self, fid: int, ref: RasterRef) -> None:
        """The windows of the selected one's group, as they are measured on the raster."""
        field = self._field.currentField()
        known = self._alike
        if known is not None and known.ref == ref and fid in known.fids:
            return
        self._alike = None
        found = windows_alike(self._session.window_layer(), field, fid) if field else None
        if found is None:
            return
        value, fids = found
        some = sorted(fids, key=lambda one: one != fid)[:NOISE_WINDOWS]
        requests = [one for one in map(self._session.request, some) if one is not None]
        keys = tuple((ref, _drawn(one, one.window)) for one in requests if one.window is not None)
        self._alike = _Alike(value, ref, frozenset(fids), keys)

    def _group(self, band: str) -> CurveGroup:
        """A band's curves in the windows like the selected one, as far as they are measured."""
        if self._alike is None:
            return NO_GROUP
        found = [self._results[key] for key in self._alike.keys if key in self._results]
        curves = [curve for one in found if isinstance(one, ClipNoise) and (curve := band_curve(one, band)) is not None]
        words = tr("{value}: {band} of {count} of {all} windows")
        count, most = len(curves), len(self._alike.keys)
        return filled(words, value=self._alike.value, band=band_title(band), count=count, all=most), tuple(curves)

    def _why_nothing(self, is_selected: bool) -> str:
        if not is_selected:
            return tr("Select a window, in the table or on the map, to see its noise.")
        problem = self._session.problem()
        return sentence(problem) if problem is not None else ""

    def _take(self, key: _Key, result: Any) -> None:
        while len(self._results) >= _MOST_KEPT:
            del self._results[next(iter(self._results))]
        self._results[key] = result
        if key == self._wanted or (self._alike is not None and key in self._alike.keys):
            self._refresh_now()

    def _ended(self, key: object, outcome: Outcome) -> None:
        """A task that was cancelled in QGIS, or failed, must not leave us waiting."""
        is_awaited = key == self._wanted and self._wanted is not None and self._wanted not in self._results
        if is_awaited and not self._background.is_under_way(key):
            stopped = tr("The measurement was stopped. Select the window again to measure it.")
            self._say(sentence(outcome.message) if outcome.message is not None else stopped)

    # What is shown

    def _say(self, text: str) -> None:
        """Words in place of the chart."""
        self._text.setText(text)
        self._words.setText("")
        self._pages.setCurrentWidget(self._text)

    def _say_measuring(self) -> None:
        """The chart of before stays in place, dimmed, so that nothing flickers."""
        if self._chart is None or self._pages.currentWidget() is not self._chart:
            self._say(tr("Measuring ..."))
            return
        self._chart.setEnabled(False)
        self._words.setText(tr("Measuring ..."))

    def _show(self, result: ClipNoise | Message) -> None:
        reason = result if isinstance(result, Message) else result.reason
        if isinstance(result, Message) or reason is not None:
            self._say(sentence(reason) if reason is not None else "")
            return
        words = noise_sentence(result.bands)
        if result.bands[noisiest_band(result.bands)].sigma is None:
            self._say(words)
            return
        if self._chart is None and self._loader.is_alive():
            self._timer.start(_LOADING_MS)
            return
        try:
            from ...toolkit.desk.theme import chart_style
            from .noise_chart import NoiseChart
        except ImportError:
            self._say(f"{words}\n\n{chart_missing()}")
            return
        if self._chart is None:
            self._chart = NoiseChart(self._pages)
            self._chart.setToolTip(rich_tip(tr(
                "Relative variance of the details by level, 1 the finest. Only the bold curve is judged. The red bar "
                "at a level stands as high as the bold curve does one level before: in an image with little noise "
                "the curve rises above it. Where the bold curve is in the red, below the bar, noise lifted the finer "
                "level."
            )))  # fmt: skip
            self._pages.addWidget(self._chart)
        self._chart.setEnabled(True)
        self._chart.show_bands(result.bands, chart_style(self._chart), self._group(noisiest_band(result.bands)))
        self._words.setText(words, rich_tip(words, *band_lines(result.bands)))
        self._pages.setCurrentWidget(self._chart)
