"""The seam profile of the selected window, and the tab that holds it beside the curves."""
from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.PyQt.QtCore import QEvent, QObject, Qt, pyqtSignal
from qgis.PyQt.QtGui import QColor, QIcon, QPixmap, QResizeEvent, QShowEvent
from qgis.PyQt.QtWidgets import QHBoxLayout, QScrollArea, QSplitter, QToolButton, QVBoxLayout, QWidget

from ....toolkit.desk.chart_panel import ChartPanel
from ....toolkit.desk.theme import chart_style
from ....toolkit.desk.widgets import ClippedLabel, single_shot
from ....toolkit.translation import filled, tr
from ...charts.profile_painter import bin_words, level_colour, summary_words
from .chart_widgets import PictureButton, ProfileChart, profile_picture
from .curves_panel import CurvesPanel

if TYPE_CHECKING:
    from ...measure.profile.seam_profile import SeamProfile
    from ...measure.window.window_result import WindowResult
    from ..session import Session

_WIDE_CHARACTERS = 75  # a tab wider than that has room for two charts side by side
_SPARE_LINES = 1  # that the dock's sentence may be longer for another window, without the charts moving to and fro


class ProfilePanel(ChartPanel):
    """Chart, levels to choose, and a line of words. Looks anew once it comes into sight."""

    followed = pyqtSignal(object)  # the WindowResult whose profile is shown; None for none

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._result: WindowResult | None = None
        self.chart = ProfileChart()
        self.chart.pointed.connect(self._say)
        self._levels: list[QToolButton] = []
        self._build()
        for signal in (
            session.selectionChanged, session.inputsChanged, session.windowsChanged, session.resultArrived,
            session.liveChanged,
        ):  # fmt: skip
            signal.connect(self._refresh_now)

    @property
    def words(self) -> str:
        """What is said in the chart's place; empty while there is one."""
        return str(self._text.text()) if self._pages.currentWidget() is self._text else ""

    def show_profile(self, profile: SeamProfile, pixel_m: float, min_kept: float, ground_left: float = 1.0) -> None:
        """Show any place's profile, as while the mouse is dragged; the next ``refresh`` shows the selected window's
        again."""
        self._fill_levels(len(profile.kept))
        self.chart.show_profile(profile, pixel_m, min_kept, ground_left)
        self._pages.setCurrentWidget(self.chart)
        self._say()

    def refresh(self) -> None:
        """Show the selected window's, or that of the window under the mouse while that is being moved."""
        live = self._session.live
        self.chart.setEnabled(live is None or live.profile is not None)  # else it is another window's
        if live is not None:
            if live.profile is not None:
                self.show_profile(live.profile, live.ground_sample_distance, self._session.inputs.min_kept)
            self._follow(None)  # the map's distances are the selected window's
            return
        selected = self._session.selected()
        result = self._session.result(selected[0]) if len(selected) == 1 else None
        profile = result.profile if result is not None else None
        if result is not None and profile is not None:
            pixel_m, min_kept = result.ground_sample_distance, self._session.inputs.min_kept
            self.show_profile(profile, pixel_m, min_kept, result.ground_left)
        else:
            result = None
            self._text.setText(self._why_nothing(selected))
            self._pages.setCurrentWidget(self._text)
            self._say()
        self._follow(result)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._say()

    def _build(self) -> None:
        self._pages.addWidget(self.chart)
        self._status = ClippedLabel(1)
        self._status.setContentsMargins(*[self.fontMetrics().height() // 6] * 4)
        self.chart.setToolTip(
            tr("How much of the finest detail is kept, by the distance from the seam, relative to the ground around")
        )
        self._save = PictureButton()
        self._save.notified.connect(self._session.messageRaised)
        self._tools = QHBoxLayout()
        self._tools.addStretch()
        self._tools.addWidget(self._save)
        self._lay_out(self._tools, self._status)
        self._fill_levels(3)

    def _fill_levels(self, count: int) -> None:
        """A button for each level; the finest is pressed at first."""
        while len(self._levels) > count:
            self._levels.pop().deleteLater()
        while len(self._levels) < count:
            level = len(self._levels) + 1
            button = QToolButton()
            button.setText(str(level))
            button.setCheckable(True)
            button.setChecked(level == 1)
            button.setAutoRaise(True)
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
            tip = tr("Show level {level}; 1 is the finest. The finest that is shown has its 95 % interval.")
            button.setToolTip(filled(tip, level=level))
            button.toggled.connect(self._choose_levels)
            self._levels.append(button)
            self._tools.insertWidget(level - 1, button)
        for before, after in zip(self._levels, [*self._levels[1:], self._save]):
            QWidget.setTabOrder(before, after)
        self._colour_levels()

    def _colour_levels(self) -> None:
        style, side = chart_style(self), self.fontMetrics().ascent()
        for level, button in enumerate(self._levels, 1):
            swatch = QPixmap(side, max(side // 4, 3))
            swatch.fill(QColor(level_colour(level, style)))
            button.setIcon(QIcon(swatch))

    def _choose_levels(self) -> None:
        self.chart.show_levels(
            frozenset(level for level, button in enumerate(self._levels, 1) if button.isChecked()) or frozenset({1})
        )
        self.refresh()

    def _refresh(self) -> None:
        if self.isVisible():
            self._colour_levels()
            self.refresh()

    def _why_nothing(self, selected: list[int]) -> str:
        """Words that stand neither in the place of the curves nor in the window's sentence."""
        if len(selected) > 1:
            return tr("Select one window to see its seam profile.")
        result = self._session.result(selected[0]) if selected else None
        if result is None or result.explanation is None or result.judgement.reason is not None:
            return ""
        if not result.explanation.has_seam:
            return tr("There is no seam in the window.")
        return tr("There is too little ground around the seam to compare with. Take a larger window.")

    def _follow(self, result: WindowResult | None) -> None:
        """What can be saved and pointed at on the map from now on."""
        if result is not self._result:
            self._result = result
            self.followed.emit(result)
        shown = self.chart.shown if result is not None else None
        self._save.offer(None if shown is None or result is None else profile_picture(
            f"window_{result.window_id}_profile", shown))

    def _say(self, *_: object) -> None:
        """What the mouse points at, else what is kept beside the seam; in short where there is no room for it all."""
        shown = self.chart.shown if self._pages.currentWidget() is self.chart else None
        words = [""]
        if shown is not None:
            bin_ = self.chart.pointed_bin
            words = bin_words(shown, bin_) if bin_ is not None else summary_words(shown)
            if (live := self._session.live) is not None:  # nothing is said while its profile is still to come
                words = [tr("Live: ") + text for text in words] if live.profile is not None else [""]
        self._status.setText(words[0], shorter=words[1:])


class CurvesAndProfile(QWidget):
    """Both panels; the border between them can be moved."""

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.curves = CurvesPanel(session)
        self.profile = ProfilePanel(session)
        self._scroll: QScrollArea | None = None
        self._arranger = single_shot(self, self._arrange)  # when all around it have their new sizes
        self._splitter = QSplitter(Qt.Orientation.Vertical)
        self._splitter.setChildrenCollapsible(False)
        for panel in (self.curves, self.profile):
            self._splitter.addWidget(panel)
            self._splitter.setStretchFactor(self._splitter.count() - 1, 1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._splitter)

    @property
    def is_side_by_side(self) -> bool:
        """How they stand."""
        return bool(self._splitter.orientation() == Qt.Orientation.Horizontal)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._arranger.start()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        around = self.parentWidget()
        while around is not None and not isinstance(around, QScrollArea):
            around = around.parentWidget()
        if around is not None and self._scroll is None:
            self._scroll = around
            around.viewport().installEventFilter(self)
        self._arranger.start()

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Resize:
            self._arranger.start()
        return False

    def _arrange(self) -> None:
        is_wide = self.width() > _WIDE_CHARACTERS * self.fontMetrics().averageCharWidth()
        orientation = Qt.Orientation.Horizontal if is_wide or self._is_low() else Qt.Orientation.Vertical
        if orientation != self._splitter.orientation():
            self._splitter.setOrientation(orientation)
            self._splitter.setSizes([1000, 1000])

    def _is_low(self) -> bool:
        """Whether the dock has no room for one chart below the other, so that it would have to be scrolled."""
        scroll = self._scroll
        if scroll is None or scroll.widget() is None:
            return False
        others = scroll.widget().minimumSizeHint().height() - self.minimumSizeHint().height()
        stacked = sum(panel.minimumSizeHint().height() for panel in (self.curves, self.profile))
        spare = _SPARE_LINES * self.fontMetrics().height() if self.is_side_by_side else 0
        return bool(scroll.viewport().height() - others < stacked + self._splitter.handleWidth() + spare)
