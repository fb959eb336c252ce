"""The images panel: what it shows and when, and the mosaic flipped over the source under the mouse."""
from __future__ import annotations

import numpy as np
import pytest
from qgis.PyQt.QtCore import QEvent, Qt
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication, QLineEdit, QPushButton, QScrollArea, QWidget
from seam_inspector.plugin.seams.desk.images.images_panel import ImagesPanel

from tests.qgis.seams.desk.images.images_desk import (
    Session,
    expected,
    hover,
    leave,
    make_pictures,
    names,
    noise,
    painted,
    press,
    release,
    send_key,
    text,
)

# --- what is shown -----------------------------------------------------------------------------------------------


def test_hint_when_nothing_is_selected(desk: QWidget, session: Session) -> None:
    panel = desk.findChild(ImagesPanel)
    assert "Select a window" in text(panel)
    assert panel.views == []
    assert session.asked == []


def test_the_window_that_was_selected_is_not_named_any_more(desk: QWidget, session: Session) -> None:
    panel = desk.findChild(ImagesPanel)
    session.select([1])
    assert "Window" in panel.bar.status.text()
    session.select([])
    assert "Select a window" in text(panel)
    assert panel.bar.status.text() == ""


def test_reading_until_the_pictures_arrive(desk: QWidget, session: Session) -> None:
    panel = desk.findChild(ImagesPanel)
    session.select([2])
    assert "Reading" in text(panel)
    session.arrive(3, make_pictures())
    assert "Reading" in text(panel)
    session.arrive(2, make_pictures())
    assert names(panel) == ["mosaic.tif", "strip_1.tif", "strip_2.tif"]
    assert "Window 2" in text(panel)


def test_a_missing_mosaic_is_named(desk: QWidget, session: Session) -> None:
    session.mosaic = None
    session.select([1])
    assert "Choose the mosaic" in text(desk.findChild(ImagesPanel))


def test_a_window_without_any_picture_says_so(desk: QWidget, session: Session) -> None:
    session.ready[1] = ()
    session.select([1])
    panel = desk.findChild(ImagesPanel)
    assert "No picture" in text(panel)
    assert "reading" not in text(panel)


def test_the_mosaic_alone(desk: QWidget, session: Session) -> None:
    session.ready[1] = make_pictures(0)
    session.select([1])
    panel = desk.findChild(ImagesPanel)
    assert names(panel) == ["mosaic.tif"]
    assert "no source" in text(panel)


def test_the_next_window_dims_the_last_ones_pictures(panel: ImagesPanel, session: Session) -> None:
    before = painted(panel.views[0])
    session.select([2])
    assert "reading" in text(panel)
    assert painted(panel.views[0]).std() < 0.5 * before.std()
    session.arrive(2, make_pictures(3))
    assert len(names(panel)) == 4
    assert np.array_equal(painted(panel.views[0]), expected(noise(0), painted(panel.views[0]).shape, 2))


def test_the_first_of_several_windows(desk: QWidget, session: Session) -> None:
    session.ready = {2: make_pictures(1), 3: make_pictures(2)}
    session.select([2, 3])
    assert len(desk.findChild(ImagesPanel).views) == 2


def test_out_of_sight_nothing_is_read(desk: QWidget, session: Session) -> None:
    panel = desk.findChild(ImagesPanel)
    panel.hide()
    session.select([1])
    session.windowsChanged.emit()
    assert session.asked == []
    panel.show()
    assert session.asked == [1]


def test_changed_windows_are_read_again(panel: ImagesPanel, session: Session) -> None:
    del session.ready[1]
    session.windowsChanged.emit()
    assert "reading" in text(panel)


@pytest.mark.parametrize(("count", "width", "columns"), [(2, 420, 2), (3, 420, 2), (3, 1000, 3)])
def test_columns_follow_the_width(desk: QWidget, session: Session, count: int, width: int, columns: int) -> None:
    session.ready[1] = make_pictures(count - 1)
    session.select([1])
    desk.resize(width, 480 if width < 1000 else 340)
    QApplication.processEvents()
    panel = desk.findChild(ImagesPanel)
    assert len({view.x() for view in panel.views}) == columns
    assert len({(view.width(), view.height()) for view in panel.views}) == 1
    assert all(view.geometry().right() < panel.width() for view in panel.views)


def test_no_column_is_narrower_than_its_views_may_be(desk: QWidget, session: Session) -> None:
    session.ready[1] = make_pictures(7)
    session.select([1])
    panel = desk.findChild(ImagesPanel)
    least = panel.views[0].minimumSizeHint().width()  # as the system's font asks for
    desk.resize(3 * least - 10, 480)
    QApplication.processEvents()
    assert len({view.x() for view in panel.views}) == 2
    assert len({(view.width(), view.height()) for view in panel.views}) == 1
    assert all(least <= view.width() and view.geometry().right() < panel.width() for view in panel.views)


def test_many_views_are_scrolled_not_shrunk(desk: QWidget, session: Session) -> None:
    session.ready[1] = make_pictures(11)
    session.select([1])
    desk.resize(420, 480)
    QApplication.processEvents()
    panel = desk.findChild(ImagesPanel)
    bar = panel.findChild(QScrollArea).verticalScrollBar()
    assert bar.maximum() > 0
    assert all(view.height() >= view.minimumSizeHint().height() for view in panel.views)
    assert all(view.geometry().right() < panel.width() - bar.width() for view in panel.views)


# --- flipping ----------------------------------------------------------------------------------------------------


def test_space_flips_the_view_under_the_mouse(panel: ImagesPanel, desk: QWidget) -> None:
    button = desk.findChild(QPushButton)
    clicks: list[bool] = []
    button.clicked.connect(clicks.append)
    hover(panel.views[1])
    press(button)
    assert names(panel) == ["mosaic.tif", "mosaic.tif", "strip_2.tif"]
    screen = painted(panel.views[1])
    inside = (slice(5, -5), slice(5, -5))  # of the frame
    assert np.array_equal(screen[inside], expected(noise(0), screen.shape, 2)[inside])
    for _ in range(3):
        release(button, repeated=True)
        press(button, repeated=True)
    assert names(panel)[1] == "mosaic.tif"
    leave(panel.views[1])
    hover(panel.views[2])
    assert names(panel) == ["mosaic.tif", "strip_1.tif", "mosaic.tif"]
    release(button)
    assert names(panel) == ["mosaic.tif", "strip_1.tif", "strip_2.tif"]
    assert clicks == []
    assert QApplication.focusWidget() is button


def test_held_space_does_not_flicker_where_x_repeats_it(panel: ImagesPanel, desk: QWidget) -> None:
    shown: list[str] = []
    hover(panel.views[1])
    press(desk)
    for _ in range(5):
        send_key(desk, QEvent.Type.KeyRelease)
        shown.append(names(panel)[1])
        QTest.qWait(3)
        press(desk)
        QTest.qWait(25)
    QTest.qWait(80)
    assert {*shown, names(panel)[1]} == {"mosaic.tif"}
    release(desk)
    assert names(panel)[1] == "strip_1.tif"


def test_space_elsewhere_is_left_alone(panel: ImagesPanel, desk: QWidget) -> None:
    button, clicks = desk.findChild(QPushButton), []
    button.clicked.connect(clicks.append)
    QTest.keyClick(button, Qt.Key.Key_Space)
    hover(panel.views[1])
    leave(panel.views[1])
    QTest.keyClick(button, Qt.Key.Key_Space)
    assert len(clicks) == 2


def test_space_pressed_elsewhere_ends_there(panel: ImagesPanel, desk: QWidget) -> None:
    button, clicks = desk.findChild(QPushButton), []
    button.clicked.connect(clicks.append)
    press(button)
    hover(panel.views[1])
    release(button)
    assert len(clicks) == 1


def test_space_can_be_typed(panel: ImagesPanel, desk: QWidget) -> None:
    field = desk.findChild(QLineEdit)
    field.setFocus()
    hover(panel.views[1])
    QTest.keyClicks(field, "a b")
    assert field.text() == "a b"
    assert names(panel)[1] == "strip_1.tif"


def test_space_flips_the_view_with_the_focus(panel: ImagesPanel) -> None:
    view = panel.views[2]
    view.setFocus(Qt.FocusReason.TabFocusReason)
    press(view)
    assert names(panel)[2] == "mosaic.tif"
    release(view)
    assert names(panel)[2] == "strip_2.tif"


def test_a_held_key_is_forgotten_out_of_sight(panel: ImagesPanel, desk: QWidget) -> None:
    button, clicks = desk.findChild(QPushButton), []
    button.clicked.connect(clicks.append)
    hover(panel.views[1])
    press(button)
    panel.hide()
    release(button)
    QTest.keyClick(button, Qt.Key.Key_Space)
    assert len(clicks) == 1
    panel.show()
    assert names(panel)[1] == "strip_1.tif"


def test_a_held_key_is_forgotten_when_another_application_is_used(panel: ImagesPanel, desk: QWidget) -> None:
    hover(panel.views[1])
    press(desk)
    QApplication.instance().applicationStateChanged.emit(Qt.ApplicationState.ApplicationInactive)
    assert names(panel)[1] == "strip_1.tif"


def test_a_dropped_view_under_the_mouse(panel: ImagesPanel, session: Session, desk: QWidget) -> None:
    hover(panel.views[2])
    press(desk)
    session.arrive(1, make_pictures(1))
    QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    assert names(panel) == ["mosaic.tif", "strip_1.tif"]
    release(desk)


def test_without_a_mosaic_nothing_flips(panel: ImagesPanel, session: Session, desk: QWidget) -> None:
    session.arrive(1, make_pictures()[1:])
    hover(panel.views[0])
    press(desk)
    assert names(panel) == ["strip_1.tif", "strip_2.tif"]
    release(desk)
