"""The tab with the curves of the selected window, and its seam profile beside them."""
from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.PyQt.QtCore import QSize, Qt
from qgis.PyQt.QtGui import QResizeEvent
from qgis.PyQt.QtWidgets import QSplitter, QWidget

from ....imagery.limits import judged_band
from ....toolkit.desk.theme import ChartPanel
from ....toolkit.desk.widgets import ClippedLabel, rich_tip
from ....toolkit.translation import filled, tr
from ...charts.curves_painter import Chart, window_curves
from ...charts.profile_painter import ShownProfile, bin_words, summary_words
from .chart_widgets import CurvesChart, PictureButton, ProfileChart, curves_picture, profile_picture

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ...measure.window.window_result import WindowResult
    from ..session import Session


_TOGETHER_MS = 150  # changes that come within this time are drawn once


class _SavedChart(ChartPanel):
    """A chart that follows the session; below it what is said of it, and a button that saves its picture."""

    def __init__(self, session: Session, chart: QWidget) -> None:
        super().__init__()
        self._session, self._status, self._save = session, ClippedLabel(2), PictureButton()
        self._save.notified.connect(session.messageRaised)
        self._status.setContentsMargins(*[self.fontMetrics().height() // 6] * 4)
        self._pages.addWidget(chart)
        self._lay_out(self._status, self._save)


class CurvesPanel(_SavedChart):
    """Curves of one window; words where there is nothing to draw."""

    def __init__(self, session: Session) -> None:
        super().__init__(session, chart := CurvesChart())
        self._chart = chart
        self._chart.setToolTip(rich_tip(tr(
            "The composite is what a hard cut of the sources along the seam, levelled to the mosaic's tone, would "
            "have. On or below the limit a loss is significant by curves."
        )))
        self.shown: Sequence[WindowResult] = ()  # what the chart is asked to draw
        session.selectionChanged.connect(self._refresh_now)
        session.inputsChanged.connect(self._refresh_now)
        session.windowsChanged.connect(self._refresh_soon)
        session.progressChanged.connect(self._on_progress)
        session.liveChanged.connect(self._refresh_now)
        session.curvesArrived.connect(self._on_result)
        session.resultArrived.connect(self._on_result)

    # when to draw

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
        if not self.isVisible():
            return
        live = self._session.live
        result, missing = shown_window(self._session)
        if live is not None:
            size = {"columns": live.window.width, "rows": live.window.height}
            self._draw(live.clips, filled(tr("Live: {columns} x {rows} px"), **size))
            self._save.offer(None)
        elif result is not None:
            chart = self._draw(result, self._title(result))
            self._save.offer(curves_picture(f"window_{result.window_id}_curves", chart))
        else:
            self._show_no_curves(missing)

    def _draw(self, result: WindowResult, title: str) -> Chart:
        band = judged_band(result.clips[0].curves)
        curves = window_curves(result, band, self._session.inputs.reference)
        chart = Chart(tuple(curves), self._session.inputs.max_ratio)
        self._pages.setCurrentWidget(self._chart)
        self._chart.setEnabled(True)
        self._chart.show_chart(chart)
        self.shown = [result]
        self._status.setText(title)
        return chart

    def _title(self, result: WindowResult) -> str:
        """What is drawn, and how many of the table's sources have no curve, since they end in the window."""
        row, ending = next(map(self._session.row, self._session.selected()), None), 0
        if row is not None and not self._session.is_pending(row.fid):
            ending = (row.sources or 0) - sum(clip.role == "source" for clip in result.clips)
        text = tr("Window {number}; {count} more {count:source covers|sources cover} a part")
        return filled(text if ending > 0 else tr("Window {number}"), number=result.window_id, count=ending)

    def _show_no_curves(self, why: str) -> None:
        """The chart before stays, faint, while there are some to come."""
        self.shown = ()
        self._save.offer(None)
        if self._pages.currentWidget() is self._chart and any(map(self._session.is_pending, self._session.selected())):
            self._chart.setEnabled(False)
            self._status.setText(why)
        else:
            self._text.setText(why)
            self._pages.setCurrentWidget(self._text)
            self._status.setText("")


def shown_window(session: Session) -> tuple[WindowResult | None, str]:
    """What there is of the selected window, if it can be compared; else why not."""
    selected = session.selected()
    clips = session.clips(selected[0]) if len(selected) == 1 else None
    if clips is not None and clips.is_compared and clips.clips:
        return clips, ""
    return None, _why_nothing(session, selected)


def _why_nothing(session: Session, selected: Sequence[int]) -> str:
    if not selected:
        return tr("Select a window in the table or on the map, or draw one.")
    if len(selected) > 1:
        return tr("Select one window to see its curves.")
    result, row = session.result(selected[0]), session.row(selected[0])
    if result is None and session.is_pending(selected[0]):
        return tr("Measuring ...")
    if row is None or (result is None and not row.verdict):
        return tr("Not inspected yet")
    if result is not None or not (row.is_compared or row.stale):
        return tr("This window can't be compared.")  # its sentence says why
    return tr("The curves are not saved with the project. Inspect again to see them.")


class ProfilePanel(_SavedChart):
    """Chart and a line of words. Looks anew once it comes into sight."""

    def __init__(self, session: Session) -> None:
        super().__init__(session, chart := ProfileChart())
        self.chart = chart
        self.chart.pointed.connect(self._say)
        self.chart.setToolTip(
            tr("How much of the finest detail is kept, by the distance from the seam, relative to the ground around")
        )
        for signal in (
            session.selectionChanged, session.inputsChanged, session.windowsChanged, session.resultArrived,
            session.liveChanged,
        ):  # fmt: skip
            signal.connect(self._refresh_now)

    def show_profile(self, shown: ShownProfile) -> None:
        """Show any place's profile, as while the mouse is dragged; the next ``refresh`` shows the selected window's
        again."""
        self.chart.show_profile(shown)
        self._pages.setCurrentWidget(self.chart)
        self._say()

    def refresh(self) -> None:
        """Show a clicked piece's, the selected window's, or that of the window under the mouse while it is moved."""
        live, piece, min_kept = self._session.live, self._session.piece, self._session.inputs.min_kept
        if piece is not None and piece.profile is not None:
            self.chart.setEnabled(True)
            self.show_profile(piece.profile)
            self._offer(None)
            return
        self.chart.setEnabled(live is None or live.profile is not None)  # else it is another window's
        if live is not None:
            if live.profile is not None:
                self.show_profile(ShownProfile(live.profile, live.clips.ground_sample_distance, min_kept))
            self._offer(None)
            return
        selected = self._session.selected()
        result = self._session.result(selected[0]) if len(selected) == 1 else None
        profile = result.profile if result is not None else None
        if result is not None and profile is not None:
            pixel_m = result.ground_sample_distance
            self.show_profile(ShownProfile(profile, pixel_m, min_kept, ground_left=result.ground_left))
        else:
            why, result = None if result is None else result.explanation, None
            words = "" if why is None or why.has_seam else tr("No seam runs through this window.")
            self._text.setText(tr("Select one window to see its seam profile.") if len(selected) > 1 else words)
            self._pages.setCurrentWidget(self._text)
            self._say()
        self._offer(result)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._say()

    def _refresh(self) -> None:
        if self.isVisible():
            self.refresh()

    def _offer(self, result: WindowResult | None) -> None:
        """What can be saved from now on."""
        shown = self.chart.shown if result is not None else None
        self._save.offer(None if shown is None or result is None else profile_picture(
            f"window_{result.window_id}_profile", shown))

    def _say(self, *_: object) -> None:
        """What the mouse points at, else what is kept beside the seam."""
        shown = self.chart.shown if self._pages.currentWidget() is self.chart else None
        words = ""
        if shown is not None:
            bin_ = self.chart.pointed_bin
            words = bin_words(shown, bin_) if bin_ is not None else summary_words(shown)
            live, piece = self._session.live, self._session.piece
            if live is not None and (piece is None or piece.profile is None):  # its profile may be still to come
                words = tr("Live: ") + words if live.profile is not None else ""
        self._status.setText(words)


class CurvesAndProfile(QSplitter):
    """Both panels, one above the other, or side by side where there is too little height; their border can be moved."""

    def __init__(self, session: Session) -> None:
        super().__init__(Qt.Orientation.Vertical)
        self.curves, self.profile = CurvesPanel(session), ProfilePanel(session)
        self.setChildrenCollapsible(False)
        for panel in (self.curves, self.profile):
            self.addWidget(panel)

    def minimumSizeHint(self) -> QSize:
        sizes = [panel.minimumSizeHint() for panel in (self.curves, self.profile)]
        width = self.handleWidth() + sum(size.width() for size in sizes)
        return QSize(width, max(size.height() for size in sizes))

    def resizeEvent(self, event: QResizeEvent) -> None:
        stacked = self.handleWidth() + sum(self.widget(place).minimumSizeHint().height() for place in range(2))
        is_high = event.size().height() >= stacked
        orientation = Qt.Orientation.Vertical if is_high else Qt.Orientation.Horizontal
        if orientation != self.orientation():
            self.setOrientation(orientation)
            self.setSizes([1000, 1000])
        super().resizeEvent(event)
