"""One large picture that Space flips, and the small ones that choose what it flips to."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from qgis.PyQt.QtGui import QColor
from qgis.PyQt.QtWidgets import QApplication, QWidget
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.seams.clip_pictures import ClipPicture
from seam_inspector.plugin.seams.desk.images.images_panel import ImagesPanel
from seam_inspector.plugin.seams.desk.images.picture_strip import PictureStrip, distinct
from seam_inspector.plugin.seams.measure.profile.window_detail import LossPicture

from tests.qgis.seams.desk.images.images_desk import (
    Session,
    expected,
    hover,
    make_pictures,
    noise,
    open_desk,
    painted,
    press,
    release,
    text,
)

INSIDE = (slice(5, -5), slice(5, -5))  # of the frame around a flipped view


@pytest.fixture
def desk(session: Session) -> Iterator[QWidget]:
    desk = open_desk(session, side_by_side=False)
    yield desk
    desk.close()
    desk.deleteLater()


def shown(panel: ImagesPanel) -> str:
    assert panel.large.shown is not None
    return panel.large.shown.raster


def test_the_mosaic_is_large_and_space_shows_the_first_source(panel: ImagesPanel, desk: QWidget) -> None:
    assert shown(panel) == "mosaic.tif"
    assert panel.large.hint == "Space: strip_1.tif"
    hover(panel.large)
    press(desk)
    assert shown(panel) == "strip_1.tif"
    screen = painted(panel.large)
    assert np.array_equal(screen[INSIDE], expected(noise(1), screen.shape, 2)[INSIDE])
    release(desk)
    assert shown(panel) == "mosaic.tif"


def test_a_click_chooses_the_source_and_it_stays_chosen(panel: ImagesPanel, desk: QWidget, session: Session) -> None:
    _composite, first, second = panel.strip.buttons
    assert first.isChecked()
    second.click()
    assert (first.isChecked(), second.isChecked()) == (False, True)
    assert panel.large.hint == "Space: strip_2.tif"
    session.select([2])
    session.arrive(2, make_pictures(3))
    hover(panel.large)
    press(desk)
    assert shown(panel) == "strip_2.tif"
    release(desk)
    session.arrive(2, make_pictures(1))  # the chosen one does not cover this window
    assert panel.large.hint == "Space: strip_1.tif"


def test_the_source_that_covers_most_comes_first(panel: ImagesPanel, session: Session) -> None:
    mosaic, first, second = make_pictures()
    session.arrive(1, (mosaic, replace(first, covered=0.4), second))
    assert panel.large.hint == "Space: strip_2.tif"


def test_the_composite_is_made_when_it_is_chosen(panel: ImagesPanel, desk: QWidget, session: Session) -> None:
    hover(panel.large)
    panel.strip.buttons[0].click()
    assert "reading" in text(panel)
    press(desk)
    assert shown(panel) == "mosaic.tif"
    release(desk)
    made = ClipPicture("composite", False, noise(9), is_composite=True)
    session.composites[1] = (made,)
    session.picturesArrived.emit(1)
    assert panel.large.hint == "Space: composite"
    press(desk)
    assert panel.large.shown is made
    release(desk)
    session.composites[2] = ()  # of the next window there is none
    session.select([2])
    session.arrive(2, make_pictures())
    assert "no source explains it" in text(panel)
    assert panel.strip.buttons[0].isChecked()


def test_lost_detail_is_painted_over_the_window(panel: ImagesPanel, session: Session) -> None:
    pixels = np.full((384, 384, 3), 90, np.uint8)
    session.arrive(1, (ClipPicture("mosaic.tif", True, pixels, inside=PixelWindow(160, 160, 64, 64)),))
    kept = np.ones((8, 8), np.float32)
    kept[:, :4] = 0.3
    session.losses[1] = LossPicture(kept)
    session.resultArrived.emit(1)
    bare = painted(panel.large)
    assert (bare == 90).mean() > 0.9
    session.loss_view.show(not session.loss_view.is_shown)
    with_loss = painted(panel.large)
    changed = np.argwhere(abs(with_loss.astype(int) - bare).max(axis=2) > 20)
    middle = [side // 2 for side in bare.shape[:2]]
    assert changed.min(axis=0) == pytest.approx([middle[0] - 64, middle[1] - 64], abs=2)
    assert changed.max(axis=0) == pytest.approx([middle[0] + 64, middle[1]], abs=2)
    wanted = [0.4 * 90 + 0.6 * colour for colour in (163, 0, 38)]
    assert with_loss[middle[0], middle[1] - 20].tolist() == pytest.approx(wanted, abs=2)
    session.loss_view.show(not session.loss_view.is_shown)
    assert np.array_equal(painted(panel.large), bare)


@pytest.mark.parametrize(
    ("names", "wanted"),
    [
        (["DJI_0025_ortho.tif", "DJI_0031_ortho.tif"], ["0025", "0031"]),
        (["west.tif", "east.tif"], ["west", "east"]),
        (["a/1.tif", "b.tif"], ["a/1", "b"]),
        (["only.tif"], ["only.tif"]),
        (["same.tif", "same.tif"], ["same.tif", "same.tif"]),
    ],
)
def test_labels_tell_what_names_do_not_share(names: list[str], wanted: list[str]) -> None:
    assert distinct(names) == wanted


def test_side_by_side_and_back_keeps_the_pictures(panel: ImagesPanel) -> None:
    panel.bar.side_by_side.click()
    QApplication.processEvents()
    assert [view.shown.raster for view in panel.views if view.shown] == ["mosaic.tif", "strip_1.tif", "strip_2.tif"]
    assert all(view.isVisible() for view in panel.views)
    panel.bar.side_by_side.click()
    QApplication.processEvents()
    assert panel.large.isVisible()
    assert shown(panel) == "mosaic.tif"


def test_the_strip_lies_along_the_longer_side(panel: ImagesPanel, desk: QWidget) -> None:
    for size, upright in (((900, 400), True), ((420, 700), False)):
        desk.resize(*size)
        QApplication.processEvents()
        assert (panel.strip.x() > panel.large.geometry().right()) == upright
        assert (panel.strip.y() > panel.large.geometry().bottom()) == (not upright)
        assert panel.large.width() * panel.large.height() > 2 * panel.strip.width() * panel.strip.height()


def test_the_stretch_is_kept_in_the_inputs(panel: ImagesPanel, session: Session) -> None:
    box = panel.bar.stretch
    assert box.currentText() == "As delivered"
    box.setCurrentIndex(2)
    box.activated.emit(2)
    assert session.inputs.stretch == "window"
    session.set_inputs(replace(session.inputs, stretch="common"))
    assert box.currentText() == "One stretch"


def test_a_small_window_is_outlined_in_the_ground_around_it(panel: ImagesPanel, session: Session) -> None:
    pixels = np.full((384, 384, 3), 90, np.uint8)
    session.arrive(1, (ClipPicture("mosaic.tif", True, pixels, inside=PixelWindow(160, 160, 64, 64)),))
    screen = panel.large.grab(panel.large.image_rect()).toImage()
    middle = panel.large.image_rect().width() / 2, panel.large.image_rect().height() / 2
    row = [QColor(screen.pixel(x, round(middle[1]))).lightness() for x in range(screen.width())]
    bright = [x for x, value in enumerate(row) if value > 200]
    assert len(bright) == 2
    assert bright[1] - bright[0] == pytest.approx(2 * 64, abs=2)
    assert sum(bright) / 2 == pytest.approx(middle[0], abs=2)
    assert row[round(middle[0])] == 90


def test_buttons_are_as_wide_as_their_names_ask_for(qgis_app: QApplication) -> None:
    """Whatever font and style put around them, up to a width; longer names are shortened in the middle."""
    strip, least = PictureStrip(), PictureStrip().minimumHeight()
    pictures = make_pictures()
    widths = []
    for letters in range(1, 21):
        strip.show_pictures([replace(pictures[0], raster=f"{end}{'m' * letters}") for end in "ab"])
        assert len({button.width() for button in strip.buttons}) == 1
        for button in strip.buttons:
            assert button.width() >= button.minimumSizeHint().width() - 1, button.text()
        widths.append(strip.buttons[1].width())
    assert "\u2026" in strip.buttons[1].text()
    assert widths == sorted(widths)
    assert widths[0] < widths[-1]
    strip.stand(True)
    assert strip.minimumWidth() >= widths[-1]
    assert strip.minimumHeight() < least
