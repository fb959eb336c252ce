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
    assert "Space: strip_1.tif" in text(panel)
    hover(panel.large)
    press(desk)
    assert shown(panel) == "strip_1.tif"
    screen = painted(panel.large)
    assert np.array_equal(screen[INSIDE], expected(noise(1), screen.shape, 2)[INSIDE])
    release(desk)
    assert shown(panel) == "mosaic.tif"


def test_a_click_chooses_the_source_and_it_stays_chosen(panel: ImagesPanel, desk: QWidget, session: Session) -> None:
    first, second = panel.strip.buttons
    assert first.isChecked()
    second.click()
    assert (first.isChecked(), second.isChecked()) == (False, True)
    assert "Space: strip_2.tif" in text(panel)
    session.select([2])
    session.arrive(2, make_pictures(3))
    hover(panel.large)
    press(desk)
    assert shown(panel) == "strip_2.tif"
    release(desk)
    session.arrive(2, make_pictures(1))  # the chosen one does not cover this window
    assert "Space: strip_1.tif" in text(panel)


def test_the_composite_is_named_so(panel: ImagesPanel, session: Session) -> None:
    mosaic, *sources = make_pictures(1)
    session.arrive(1, (mosaic, *sources, ClipPicture("composite", False, noise(9), is_composite=True)))
    panel.strip.buttons[-1].click()
    assert panel.strip.buttons[-1].text() == "composite"
    assert "Space: composite" in text(panel)


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
