"""Linked views: every image pixel a square on the screen, and all views move as one."""
from __future__ import annotations

import gc
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from qgis.PyQt.QtCore import QEvent, QPoint, QPointF, Qt
from qgis.PyQt.QtGui import QColor, QMouseEvent, QPalette
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication, QToolButton
from seam_inspector.plugin.seams.clip_pictures import ClipPicture
from seam_inspector.plugin.seams.desk.images.images_panel import ImagesPanel

from tests.qgis.seams.desk.images.images_desk import (
    SIDE,
    Session,
    expected,
    hover,
    leave,
    make_pictures,
    noise,
    painted,
    turn_wheel,
)

# --- pixels ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("zoom", [1, 2, 4, 8])
def test_a_pixel_is_a_square_on_the_screen(panel: ImagesPanel, session: Session, zoom: int) -> None:
    session.arrive(1, make_pictures(side=1024))
    panel.viewport.set_zoom(float(zoom))
    for view in panel.views:
        screen = painted(view)
        assert view.picture is not None
        assert np.array_equal(screen, expected(view.picture.pixels, screen.shape, zoom))


def test_all_of_a_large_window_is_drawn_from_means(panel: ImagesPanel, session: Session) -> None:
    pixels = noise(0, 1024)
    reduced = tuple(np.full((side, side, 3), 100, np.uint8) for side in (512, 256))
    session.arrive(1, (ClipPicture("mosaic.tif", True, pixels, reduced=reduced),))
    panel.viewport.set_zoom(0.25)
    assert np.unique(painted(panel.views[0])[150:200, 300:350]).tolist() == [100]


def test_a_sources_offset_is_drawn(panel: ImagesPanel, session: Session) -> None:
    """Half a pixel at 8x is four on the screen: flipping must not make the ground jump."""
    pixels = noise(7)
    session.arrive(1, (ClipPicture("mosaic.tif", True, pixels), ClipPicture("a.tif", False, pixels, 0.5, -0.25)))
    panel.viewport.set_zoom(8.0)
    mosaic, source = (painted(view) for view in panel.views)
    assert np.array_equal(source[2:, :-4], mosaic[:-2, 4:])


def test_the_image_keeps_its_array(panel: ImagesPanel, session: Session) -> None:
    session.ready.clear()
    wanted = expected(noise(1), painted(panel.views[1]).shape, 2)
    gc.collect()
    _filler = [np.zeros((SIDE, SIDE, 3), np.uint8) for _ in range(20)]
    assert np.array_equal(painted(panel.views[1]), wanted)


def test_two_screen_pixels_at_twofold_desktop_scaling(repository: Path) -> None:
    """The scaling of a process is set when it starts."""
    code = (
        "import sys; sys.path.insert(0, 'build/plugins'); sys.path.insert(0, '.')\n"
        "from qgis.core import QgsApplication\n"
        "app = QgsApplication([], True)\n"
        "from tests.qgis.seams.desk.images import images_desk as t\n"
        "t.QgsSettings().setValue('SeamInspector/images_side_by_side', True)\n"
        "session = t.Session(); session.ready[1] = t.make_pictures(); session.chosen = [1]\n"
        "panel = t.ImagesPanel(session); panel.resize(500, 300); panel.show(); app.processEvents()\n"
        "assert panel.devicePixelRatioF() == 2\n"
        "for view in panel.views:\n"
        "    screen = t.painted(view)\n"
        "    assert screen.shape[1] == 2 * view.width()\n"
        "    assert t.np.array_equal(screen, t.expected(view.picture.pixels, screen.shape, 2))\n"
        "print('same'); panel.close()\n"
    )
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "QT_SCALE_FACTOR": "2"}
    finished = subprocess.run(
        [sys.executable, "-c", code], cwd=repository, env=environment, capture_output=True, text=True, check=False
    )
    assert "same" in finished.stdout, finished.stderr


@pytest.mark.parametrize("dark", [False, True])
def test_names_can_be_read_in_both_themes(panel: ImagesPanel, dark: bool) -> None:
    palette = QPalette(QColor("#303030" if dark else "#f0f0f0"))
    panel.setPalette(palette)
    view = panel.views[1]
    strip = view.grab().toImage()
    height = view.image_rect().top()
    greys = {strip.pixelColor(x, y).lightness() for x in range(view.width()) for y in range(height)}
    assert max(greys) - min(greys) > 120


# --- moving about ------------------------------------------------------------------------------------------------


def test_drag_moves_all_views(panel: ImagesPanel) -> None:
    before = [painted(view) for view in panel.views]
    view, start = panel.views[1], panel.views[1].image_rect().center()
    for kind, moved in ((QEvent.Type.MouseButtonPress, 0), (QEvent.Type.MouseMove, 10), (QEvent.Type.MouseMove, 30)):
        left, at = Qt.MouseButton.LeftButton, start + QPoint(moved, -2 * moved // 3)
        QApplication.sendEvent(view, QMouseEvent(kind, QPointF(at), left, left, Qt.KeyboardModifier.NoModifier))
    QTest.mouseRelease(view, Qt.MouseButton.LeftButton)
    for view, old in zip(panel.views, before):
        assert np.array_equal(painted(view)[:-20, 30:], old[20:, :-30])


def test_nothing_beyond_the_window_is_shown(panel: ImagesPanel) -> None:
    panel.viewport.pan(1e6, 1e6)
    assert panel.viewport.origin() == pytest.approx((0, 0))
    panel.viewport.pan(-1e6, -1e6)
    width, height = panel.viewport.screen
    assert panel.viewport.origin() == pytest.approx((width - 2 * SIDE, height - 2 * SIDE))


def test_the_wheel_zooms_around_the_mouse(panel: ImagesPanel) -> None:
    view, at = panel.views[1], panel.views[1].image_rect().center() + QPoint(40, 25)
    hover(view, at)
    held = panel.viewport.cursor
    assert held is not None
    for wanted in (4, 8, 8):
        turn_wheel(view, 1, at)
        assert panel.viewport.scale == wanted
        assert panel.viewport.cursor == pytest.approx(held)
    turn_wheel(view, -0.5, at)
    assert panel.viewport.scale == 8
    turn_wheel(view, -0.5, at)
    assert panel.viewport.scale == 4
    turn_wheel(view, -3, at)
    fitting = min(panel.viewport.screen) / SIDE
    assert panel.viewport.scale == pytest.approx(fitting)
    assert panel.viewport.zoom is None
    turn_wheel(view, 1, at)
    assert panel.viewport.scale == 1


def test_buttons(panel: ImagesPanel) -> None:
    out, into, everything, best = panel.bar.findChildren(QToolButton)[1:]
    assert all(button.toolTip() for button in (out, into, everything, best))
    for button, scale in ((into, 4), (best, 2), (out, 1), (best, 2), (best, 2)):
        button.click()
        assert panel.viewport.scale == scale
        assert best.isChecked() == (scale == 2)
    everything.click()
    assert panel.viewport.zoom is None
    assert everything.isChecked()


def test_another_window_keeps_zoom_and_centre(panel: ImagesPanel, session: Session) -> None:
    panel.viewport.set_zoom(4.0)
    panel.viewport.pan(50, 30)
    centre = panel.viewport.centre
    session.select([2])
    session.arrive(2, make_pictures(side=256))
    assert (panel.viewport.zoom, panel.viewport.centre) == (4.0, centre)


def test_keys_move_the_view_with_the_focus(panel: ImagesPanel) -> None:
    view = panel.views[0]
    view.setFocus(Qt.FocusReason.TabFocusReason)
    left = panel.viewport.origin()[0]
    QTest.keyClick(view, Qt.Key.Key_Right)
    assert panel.viewport.origin()[0] < left
    QTest.keyClick(view, Qt.Key.Key_Plus)
    assert panel.viewport.scale == 4
    QTest.keyClick(view, Qt.Key.Key_Minus)
    assert panel.viewport.scale == 2


def test_the_cursor_is_in_all_views(panel: ImagesPanel) -> None:
    bare = [painted(view) for view in panel.views]
    hover(panel.views[1])
    for view, old in zip(panel.views, bare):
        image = view.grab(view.image_rect()).toImage()
        middle = view.image_rect().center() - view.image_rect().topLeft()
        arm = view.fontMetrics().height() * 2 // 3
        assert all(image.pixelColor(middle + QPoint(x, 0)).lightness() > 220 for x in (-arm, arm))
        assert image.pixelColor(middle) == QColor(*old[middle.y(), middle.x()].tolist())
    leave(panel.views[1])
    assert panel.viewport.cursor is None
