"""The seam profile beside the curve: what it says, what it paints, and what leaves it."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import pytest
from qgis.PyQt.QtCore import QPoint
from qgis.PyQt.QtGui import QColor
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication
from seam_inspector.plugin.seams.charts.profile_painter import ShownProfile, bin_words, level_colour, summary_words
from seam_inspector.plugin.seams.desk.charts.chart_widgets import ProfileChart
from seam_inspector.plugin.seams.desk.charts.curves_tab import ProfilePanel
from seam_inspector.plugin.seams.measure import messages
from seam_inspector.plugin.seams.measure.judgement.verdicts import Judgement, Ratios, Verdict
from seam_inspector.plugin.toolkit.desk.theme import chart_style

from tests.qgis.scenes import PIXEL
from tests.qgis.seams.desk.profile.profile_desk import PROFILE, ProfileSession, result
from tests.qgis.seams.desk.session_desk import settle


@pytest.fixture
def session(qgis_app: QApplication) -> ProfileSession:
    return ProfileSession()


@pytest.fixture
def panel(session: ProfileSession) -> Iterator[ProfilePanel]:
    panel = ProfilePanel(session)
    panel.resize(500, 320)
    panel.show()
    settle()
    yield panel
    panel.close()
    panel.deleteLater()


def chart_pixel(chart: ProfileChart, distance_m: float, kept: float) -> QColor:
    placed = chart.painter()
    return chart.grab().toImage().pixelColor(round(placed.x_of(distance_m)), round(placed.y_of(kept)))


def is_drawn(chart: ProfileChart, distance_m: float, kept: float, colour: QColor) -> bool:
    """Whether a line of a colour runs there, a pixel up or down: it lies between pixels, where fonts make it."""
    placed, image = chart.painter(), chart.grab().toImage()
    x, y = round(placed.x_of(distance_m)), round(placed.y_of(kept))
    return any(near(image.pixelColor(x, y + off), colour) for off in (-1, 0, 1))


def near(colour: QColor, other: QColor) -> bool:
    return max(abs(a - b) for a, b in zip(colour.getRgb()[:3], other.getRgb()[:3])) < 60


def test_it_paints_what_is_kept_at_every_distance_its_interval_and_the_limit(panel: ProfilePanel) -> None:
    chart = panel.chart
    style = chart_style(chart)
    line, limit, back = QColor(level_colour(1, style)), QColor(style.limit), QColor(style.background)
    assert is_drawn(chart, 4 * PIXEL, 0.5, line)
    assert is_drawn(chart, 12 * PIXEL, 0.8, line)
    assert is_drawn(chart, 200 * PIXEL, 1.0, line)
    inside, outside = chart_pixel(chart, 11 * PIXEL, 0.86), chart_pixel(chart, 11 * PIXEL, 0.95)
    assert not near(inside, line)
    assert inside != back
    assert outside == back
    image, y = chart.grab().toImage(), round(chart.painter().y_of(0.7))
    row = [image.pixelColor(x, y) for x in range(300, 340)]
    # thinner where it lies on two rows of pixels
    dashes = [record for record in row if abs(record.hue() - limit.hue()) < 5 and record.saturation() > 100]
    assert 0 < len(dashes) < len(row)


def test_the_mixture_is_a_quiet_line(panel: ProfilePanel) -> None:
    bins = (replace(PROFILE.bins[0], mixture=0.4), replace(PROFILE.bins[1], mixture=0.1), *PROFILE.bins[2:])
    mixed = replace(PROFILE, bins=bins, feather_width_px=15.0)
    panel.show_profile(ShownProfile(mixed, PIXEL, 0.7))
    shown = panel.chart.shown
    assert shown is not None
    placed = panel.chart.painter()
    points = placed.mixture
    assert points[0] == pytest.approx((placed.axes.left(), placed.y_of(0.4)))
    assert [y for _, y in points[1:]] == pytest.approx([placed.y_of(0.4), placed.y_of(0.1), placed.y_of(0.1)])
    assert bin_words(shown, shown.bins(1)[0]).endswith(", 40 % other image")
    assert summary_words(shown).endswith("in 1.6 m")  # the strip that is judged, however wide the feather
    drawn = panel.chart.grab().toImage()
    panel.show_profile(ShownProfile(PROFILE, PIXEL, 0.7))
    assert panel.chart.grab().toImage() != drawn
    assert not panel.chart.painter().mixture


def test_the_mouse_points_at_a_bin_and_its_words_are_said(panel: ProfilePanel) -> None:
    messages: list[object] = []
    panel.chart.pointed.connect(messages.append)
    placed = panel.chart.painter()
    QTest.mouseMove(panel.chart, QPoint(round(placed.x_of(12 * PIXEL)), 60))
    settle()
    assert messages == [PROFILE.bins[1]]
    assert panel._status.text() == "0.80 to 1.60 m: 80 % kept (70 to 90 %)"
    QTest.mouseMove(panel.chart, QPoint(round(placed.x_of(30 * PIXEL)), 60))  # nothing was measured there
    settle()
    assert messages[-1] is None
    assert panel._status.text().startswith("56 % kept (51 to 62 %)")


@pytest.mark.parametrize(
    ("selected", "name", "pending", "words"),
    [
        ([], None, False, ""),  # which the curves' place says, as the next ones
        ([2], None, False, ""),
        ([2], None, True, ""),
        ([1], "curve", True, ""),
        ([1], "reason", False, ""),
        ([1, 2], None, False, "Select one window to see its seam profile."),
    ],
)
def test_words_where_there_is_no_profile(
    panel: ProfilePanel, session: ProfileSession, selected: list[int], name: str | None, pending: bool, words: str
) -> None:
    nothing = Judgement(Verdict.NOT_COMPARABLE, Ratios((None,) * 3, None), messages.TOO_LITTLE_GROUND())
    results = {
        "curve": replace(result(), explanation=None),
        "reason": replace(result(), explanation=None, judgement=nothing), None: None,
    }  # fmt: skip
    session.results = {1: results[name]} if results[name] is not None else {}
    session.is_measuring = pending
    session.select(selected)
    settle()
    assert panel._pages.currentWidget() is panel._text
    assert panel._text.text() == words
    assert not panel._save.isEnabled()


def test_a_profile_that_comes_later_is_shown(panel: ProfilePanel, session: ProfileSession) -> None:
    session.results[1] = replace(result(), explanation=None)
    session.is_measuring = True
    session.resultArrived.emit(1)
    settle()
    assert panel._pages.currentWidget() is panel._text
    session.results[1] = result()
    session.resultArrived.emit(1)
    settle()
    assert panel._pages.currentWidget() is panel.chart
    assert panel.chart.shown.profile == PROFILE
