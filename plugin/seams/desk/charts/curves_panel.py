"""The tab with the curves of the selected windows."""
from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtGui import QResizeEvent
from qgis.PyQt.QtWidgets import QComboBox, QHBoxLayout, QSplitter, QToolButton, QWidget

from ....toolkit.desk.chart_panel import ChartPanel
from ....toolkit.desk.theme import chart_style
from ....toolkit.desk.widgets import ClippedLabel, plain_tip, single_shot
from ....toolkit.translation import BAND_ORDER, band_title, filled, sentence, tr
from ...charts.chart_curves import (
    Chart,
    ChartCurve,
    Key,
    bands_of,
    mean_curves,
    point_words,
    significance_limit,
    window_curves,
)
from .chart_pictures import PictureButton, curves_picture
from .chart_widgets import CurvesChart
from .curves_legend import CurvesLegend

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ...measure.window.live_window import LiveWindow
    from ...measure.window.window_result import WindowCurves
    from ..session import Session

_TOGETHER_MS = 150  # results of many selected windows that come within this time are drawn once
_PATIENCE_MS = 400  # that a chart of another window stays as it is while the next one is measured
_WIDE_CHARACTERS = 85  # a panel narrower than that has the legend below the chart
_MAX_LEGEND_SHARE = 0.3  # of the panel, until the user moves the border


class CurvesPanel(ChartPanel):
    """Curves of one window, or mean and range of several; words where there is nothing to draw."""

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._hidden: set[Key] = set()
        self._colours: dict[str, int] = {}
        self._band = ""  # the user's choice, kept while other windows lack it
        self._idle_text = ""
        self.shown: Sequence[WindowCurves] = ()
        """What the chart is asked to draw."""
        self._legend_width = 0
        self._border_moved = False
        self._dimmer = single_shot(self, self._dim, _PATIENCE_MS)
        self._build()
        session.selectionChanged.connect(self._refresh_now)
        session.inputsChanged.connect(self._refresh_now)
        session.windowsChanged.connect(self._refresh_soon)
        session.progressChanged.connect(self._on_progress)
        session.liveChanged.connect(self._refresh_now)
        session.curvesArrived.connect(self._on_result)
        session.resultArrived.connect(self._on_result)

    # widgets

    def _build(self) -> None:
        self._bands = QComboBox()
        self._bands.setToolTip(tr("Band whose curves are drawn; the verdict is that of luminance, or of the only band"))
        self._bands.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContents)
        self._fill_bands([BAND_ORDER[0]])
        self._bands.activated.connect(self._on_band_chosen)
        self._logarithmic = QToolButton()
        self._logarithmic.setText(tr("log"))
        self._logarithmic.setToolTip(tr("Logarithmic axis, which shows the fine levels; off: linear axis"))
        self._logarithmic.setCheckable(True)
        self._logarithmic.setChecked(True)
        self._logarithmic.setAutoRaise(True)
        self._logarithmic.toggled.connect(self._refresh_now)
        self._save = PictureButton()
        self._save.told.connect(self._session.messageRaised)
        self._splitter = QSplitter(Qt.Orientation.Horizontal)
        self._splitter.setChildrenCollapsible(False)
        self._splitter.splitterMoved.connect(self._on_border_moved)
        self._chart = CurvesChart()
        self._chart.pointed.connect(self._on_pointed)
        self._legend = CurvesLegend()
        self._legend.toggled.connect(self._on_toggled)
        self._legend.soloed.connect(self._on_soloed)
        self._legend.entered.connect(self._chart.mark)
        self._splitter.addWidget(self._chart)
        self._splitter.addWidget(self._legend)
        self._splitter.setStretchFactor(0, 1)
        self._splitter.setStretchFactor(1, 0)
        self._pages.addWidget(self._splitter)
        self._status = ClippedLabel(1)
        self._status.setContentsMargins(*[self.fontMetrics().height() // 6] * 4)
        tools = QHBoxLayout()
        tools.addWidget(self._bands)
        tools.addWidget(self._logarithmic)
        tools.addStretch()
        tools.addWidget(self._save)
        self._lay_out(tools, self._status)
        self.setTabOrder(self._save, self._legend)

    # when to draw

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit_legend()
        self._show_point()

    def _refresh_soon(self) -> None:
        if not self._timer.isActive():
            self._timer.start(_TOGETHER_MS)

    def _on_result(self, fid: int) -> None:
        selected = self._session.selected()
        if selected == [fid]:
            self._refresh_now()
        elif fid in selected:
            self._refresh_soon()

    def _on_progress(self, _done: int, _asked: int) -> None:
        if self._pages.currentWidget() is self._text:
            self._refresh_soon()

    def _refresh(self) -> None:
        """Only changes are drawn."""
        if not self.isVisible():
            return
        live = self._session.live
        results, missing = selected_windows(self._session) if live is None else ([live.clips], "")
        if not results:
            if self._shows_chart and any(map(self._session.is_pending, self._session.selected())):
                self._wait_for_curves(missing)
            else:
                self._show_text(missing)
            return
        if live is None:
            self._fill_bands(bands_of(results))
            self._idle_text = _title(self._session, results)
            self._draw(results, self._curves(results, self._bands.currentData()))
        else:
            self._idle_text = _live_title(live)
            self._draw(results, self._curves(results, next(iter(live.clips.clips[0].curves))))

    @property
    def _shows_chart(self) -> bool:
        return bool(self._pages.currentWidget() is self._splitter)

    def _wait_for_curves(self, words: str) -> None:
        """The chart before stays meanwhile, faint when it takes long."""
        self._idle_text, self.shown = words, ()
        self._save.offer(None)
        if not self._dimmer.isActive():
            self._dimmer.start()
        self._show_point()

    def _dim(self) -> None:
        if not self.shown:
            self._chart.setEnabled(False)

    def _fill_bands(self, names: list[str]) -> None:
        if names != [self._bands.itemData(row) for row in range(self._bands.count())]:
            self._bands.clear()
            for name in names:
                self._bands.addItem(band_title(name), name)
        self._bands.setCurrentIndex(max(self._bands.findData(self._band), 0))

    def _curves(self, results: list[WindowCurves], band: str) -> tuple[ChartCurve, ...]:
        if len(results) > 1:
            return tuple(mean_curves(results, band))
        for clip in results[0].clips[1:]:
            self._colours.setdefault(clip.raster, len(self._colours))
        return tuple(window_curves(results[0], band, self._colours, self._session.inputs.reference))

    def _draw(self, results: list[WindowCurves], curves: tuple[ChartCurve, ...]) -> None:
        hidden = frozenset(self._hidden & {curve.key for curve in curves})
        chart = Chart(curves, self._session.inputs.max_ratio, self._logarithmic.isChecked(), hidden)
        style = chart_style(self._legend)  # one sheet with it
        has_limit = significance_limit(curves, chart.max_ratio) is not None
        self._legend.show_curves(curves, hidden, style, has_limit)
        self._pages.setCurrentWidget(self._splitter)  # first, or its parts find their sizes after they are drawn
        self._fit_legend()
        self._dimmer.stop()
        self._chart.setEnabled(True)
        self._chart.show_chart(chart)
        self.shown = results
        band = self._bands.currentData()
        which = f"window_{results[0].window_id}" if len(results) == 1 else f"{len(results)}_windows"
        title = f"{self._idle_text} ({band_title(band)})"
        self._save.offer(curves_picture(f"{which}_{band}", chart, title) if self._session.live is None else None)
        self._show_point()

    def _show_text(self, text: str) -> None:
        self._text.setText(text)
        self._pages.setCurrentWidget(self._text)
        self.shown = []
        self._idle_text = ""
        self._save.offer(None)
        self._show_point()

    def _fit_legend(self) -> None:
        """Beside the chart where there is room, else below it.

        As wide as the longest name so far, so that the axes seldom move from window to window.
        """
        is_wide = self.width() > _WIDE_CHARACTERS * self.fontMetrics().averageCharWidth()
        orientation = Qt.Orientation.Horizontal if is_wide else Qt.Orientation.Vertical
        if orientation != self._splitter.orientation():
            self._splitter.setOrientation(orientation)
            self._border_moved = False
        self._legend.set_across(not is_wide)
        if self._border_moved:
            return
        width, height = self._pages.width(), self._pages.height()
        if is_wide:
            self._legend_width = max(self._legend_width, self._legend.sizeHint().width())
            whole, size = width, min(self._legend_width, int(width * _MAX_LEGEND_SHARE))
        else:
            whole, size = height, self._legend.height_within(width, int(height * _MAX_LEGEND_SHARE))
        self._splitter.setSizes([whole - size - self._splitter.handleWidth(), size])

    # what the user does

    def _on_band_chosen(self, index: int) -> None:
        self._band = self._bands.itemData(index)
        self._refresh_now()

    def _on_border_moved(self, _position: int, _index: int) -> None:
        self._border_moved = True

    def _on_toggled(self, key: Key) -> None:
        self._hidden ^= {key}
        self._refresh_now()

    def _on_soloed(self, key: Key | None) -> None:
        chart = self._chart.chart
        self._hidden.clear()
        if key is not None and chart is not None:
            self._hidden |= {curve.key for curve in chart.curves if not curve.is_mosaic and curve.key != key}
        self._refresh_now()

    def _on_pointed(self, point: tuple[int, int] | None) -> None:
        chart = self._chart.chart
        if chart is not None:
            self._legend.mark(chart.curves[point[0]].key if point else None)
        self._show_point()

    def _show_point(self) -> None:
        """The values under the mouse, the name elided where there is no room for it, but never the values."""
        chart = self._chart.chart
        point = self._chart.point
        if chart is None or point is None or self._pages.currentWidget() is not self._splitter:
            self._status.setText(self._idle_text)
            return
        name, words = point_words(chart.curves, *point)
        metrics = self._status.fontMetrics()
        width = self._status.contentsRect().width()
        room = max(width - metrics.horizontalAdvance(words + " "), metrics.horizontalAdvance("0" * 7))
        self._status.setText(metrics.elidedText(name, Qt.TextElideMode.ElideMiddle, room) + words)
        self._status.setToolTip(plain_tip(name + words))


def selected_windows(session: Session) -> tuple[list[WindowCurves], str]:
    """What there is of the selected windows that can be compared; without any, why not."""
    selected = session.selected()
    found = [result for result in map(session.clips, selected) if result is not None]
    usable = [result for result in found if result.is_compared and result.clips]
    return usable, "" if usable else _why_nothing(session, selected)


def _title(session: Session, results: Sequence[WindowCurves]) -> str:
    """Which windows are drawn."""
    selected = session.selected()
    if len(results) > 1 and len(results) < len(selected):
        template = tr("{count} of the {selected} selected windows: mean and range")
        return filled(template, count=len(results), selected=len(selected))
    if len(results) > 1:
        return filled(tr("{count} windows: mean and range"), count=len(results))
    text = filled(tr("Window {number}"), number=results[0].window_id)
    row = session.row(selected[0]) if len(selected) == 1 else None
    if row is not None and row.stale:
        text += tr(", out of date: inspect it again")
    return text


def _live_title(live: LiveWindow) -> str:
    """Which window is drawn while it is being moved."""
    template = tr("Live, {band}: {columns} x {rows} px under the mouse")
    band = band_title(next(iter(live.clips.clips[0].curves)))
    return filled(template, band=band, columns=live.window.width, rows=live.window.height)


def _why_nothing(session: Session, selected: Sequence[int]) -> str:
    if not selected:
        return tr("Select a window in the table or on the map, or draw one.")
    found = [result for result in map(session.result, selected) if result is not None]
    if found and len(selected) > 1:
        return tr("None of the selected windows can be compared.")
    if found:
        reason = found[0].judgement.reason
        return sentence(reason) if reason else tr("This window can't be compared.")
    if any(map(session.is_pending, selected)):
        return tr("Measuring ...")
    rows = [row for row in map(session.row, selected) if row is not None]
    if len(rows) == 1 and rows[0].verdict and not rows[0].is_compared and rows[0].reason and not rows[0].stale:
        return rows[0].reason
    if any(row.verdict for row in rows):
        return tr("The curves are not kept with the project. Inspect again to see them.")
    return tr("Not inspected yet")
