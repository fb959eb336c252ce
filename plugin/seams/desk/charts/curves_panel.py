"""The tab with the curves of the selected window."""
from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtGui import QResizeEvent
from qgis.PyQt.QtWidgets import QComboBox, QHBoxLayout, QWidget

from ....toolkit.desk.chart_panel import ChartPanel
from ....toolkit.desk.widgets import ClippedLabel, plain_tip, rich_tip, single_shot
from ....toolkit.translation import BAND_ORDER, band_title, filled, sentence, tr
from ...charts.chart_curves import (
    Chart,
    ChartCurve,
    bands_of,
    point_words,
    window_curves,
)
from .chart_widgets import CurvesChart, PictureButton, curves_picture

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ...measure.window.explained_window import LiveWindow
    from ...measure.window.window_result import WindowCurves
    from ..session import Session

_TOGETHER_MS = 150  # changes that come within this time are drawn once
_PATIENCE_MS = 400  # that a chart of another window stays as it is while the next one is measured


class CurvesPanel(ChartPanel):
    """Curves of one window; words where there is nothing to draw."""

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._colours: dict[str, int] = {}
        self._band = ""  # the user's choice, kept while other windows lack it
        self._idle_text = ""
        self.shown: Sequence[WindowCurves] = ()  # what the chart is asked to draw
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
        self._save = PictureButton()
        self._save.notified.connect(self._session.messageRaised)
        self._chart = CurvesChart()
        self._chart.pointed.connect(self._show_point)
        self._chart.setToolTip(rich_tip(tr(
            "The composite is what a hard cut of the sources along the seam, levelled to the mosaic's tone, would "
            "have. On or below the limit a loss is significant by curves."
        )))
        self._pages.addWidget(self._chart)
        self._status = ClippedLabel(1)
        self._status.setContentsMargins(*[self.fontMetrics().height() // 6] * 4)
        tools = QHBoxLayout()
        tools.addWidget(self._bands)
        tools.addStretch()
        tools.addWidget(self._save)
        self._lay_out(tools, self._status)

    # when to draw

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._show_point()

    def _refresh_soon(self) -> None:
        if not self._timer.isActive():
            self._timer.start(_TOGETHER_MS)

    def _on_result(self, fid: int) -> None:
        if self._session.selected() == [fid]:
            self._refresh_now()

    def _on_progress(self, _done: int, _asked: int) -> None:
        if self._pages.currentWidget() is self._text:
            self._refresh_soon()

    def _refresh(self) -> None:
        """Only changes are drawn."""
        if not self.isVisible():
            return
        live = self._session.live
        result, missing = shown_window(self._session) if live is None else (live.clips, "")
        if result is None:
            if self._shows_chart and any(map(self._session.is_pending, self._session.selected())):
                self._wait_for_curves(missing)
            else:
                self._show_text(missing)
        elif live is None:
            self._fill_bands(bands_of(result))
            self._idle_text = _title(self._session, result)
            self._draw(result, self._curves(result, self._bands.currentData()))
        else:
            self._idle_text = _live_title(live)
            self._draw(result, self._curves(result, next(iter(live.clips.clips[0].curves))))

    @property
    def _shows_chart(self) -> bool:
        return bool(self._pages.currentWidget() is self._chart)

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

    def _curves(self, result: WindowCurves, band: str) -> tuple[ChartCurve, ...]:
        for clip in result.clips[1:]:
            self._colours.setdefault(clip.raster, len(self._colours))
        return tuple(window_curves(result, band, self._colours, self._session.inputs.reference))

    def _draw(self, result: WindowCurves, curves: tuple[ChartCurve, ...]) -> None:
        chart = Chart(curves, self._session.inputs.max_ratio)
        self._pages.setCurrentWidget(self._chart)
        self._dimmer.stop()
        self._chart.setEnabled(True)
        self._chart.show_chart(chart)
        self.shown = [result]
        band = self._bands.currentData()
        title, name = f"{self._idle_text} ({band_title(band)})", f"window_{result.window_id}_{band}"
        self._save.offer(curves_picture(name, chart, title) if self._session.live is None else None)
        self._show_point()

    def _show_text(self, text: str) -> None:
        self._text.setText(text)
        self._pages.setCurrentWidget(self._text)
        self.shown = []
        self._idle_text = ""
        self._save.offer(None)
        self._show_point()

    # what the user does

    def _on_band_chosen(self, index: int) -> None:
        self._band = self._bands.itemData(index)
        self._refresh_now()

    def _show_point(self, *_: object) -> None:
        """The values under the mouse, the name elided where there is no room for it, but never the values."""
        chart = self._chart.chart
        point = self._chart.point
        if chart is None or point is None or not self._shows_chart:
            self._status.setText(self._idle_text)
            return
        name, words = point_words(chart.curves, *point)
        metrics = self._status.fontMetrics()
        width = self._status.contentsRect().width()
        room = max(width - metrics.horizontalAdvance(words + " "), metrics.horizontalAdvance("0" * 7))
        self._status.setText(metrics.elidedText(name, Qt.TextElideMode.ElideMiddle, room) + words)
        self._status.setToolTip(plain_tip(name + words))


def shown_window(session: Session) -> tuple[WindowCurves | None, str]:
    """What there is of the selected window, if it can be compared; else why not."""
    selected = session.selected()
    clips = session.clips(selected[0]) if len(selected) == 1 else None
    if clips is not None and clips.is_compared and clips.clips:
        return clips, ""
    return None, _why_nothing(session, selected)


def _title(session: Session, result: WindowCurves) -> str:
    """The window that is drawn."""
    text = filled(tr("Window {number}"), number=result.window_id)
    row = session.row(session.selected()[0])
    return text + tr(", out of date: inspect it again") if row is not None and row.stale else text


def _live_title(live: LiveWindow) -> str:
    """The window that is drawn while it is being moved."""
    template = tr("Live, {band}: {columns} x {rows} px under the mouse")
    band = band_title(next(iter(live.clips.clips[0].curves)))
    return filled(template, band=band, columns=live.window.width, rows=live.window.height)


def _why_nothing(session: Session, selected: Sequence[int]) -> str:
    if not selected:
        return tr("Select a window in the table or on the map, or draw one.")
    if len(selected) > 1:
        return tr("Select one window to see its curves.")
    result, row = session.result(selected[0]), session.row(selected[0])
    if result is not None:
        reason = result.judgement.reason
        return sentence(reason) if reason else tr("This window can't be compared.")
    if session.is_pending(selected[0]):
        return tr("Measuring ...")
    if row is None or not row.verdict:
        return tr("Not inspected yet")
    if not row.is_compared and row.reason and not row.stale:
        return row.reason
    return tr("The curves are not saved with the project. Inspect again to see them.")
