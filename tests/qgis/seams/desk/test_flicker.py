"""The hard cut in place of the mosaic: held and tapped, and off the map with its window, judging and project."""
from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from qgis.core import QgsProject
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtWidgets import QWidget
from seam_inspector.plugin.seams.desk.swipe.flicker import Flicker

from tests.qgis.plugin_lives import action_of
from tests.qgis.scenes import Scene
from tests.qgis.seams.desk.session_desk import Desk, wait_until


class _Map:
    def __init__(self, desk: Desk) -> None:
        desk.set(desk.inputs())
        self.desk, self.fid = desk, desk.add()
        desk.session.select([self.fid])
        self.canvas, self.owner = QgsMapCanvas(), QWidget()
        self.canvas.setLayers([desk.mosaic])
        self.canvas.setExtent(desk.mosaic.extent())
        self.before = len(self.canvas.scene().items())
        self.flicker = Flicker(self.canvas, desk.session, self.owner)

    def on_map(self) -> int:
        """Canvas items in sight that were not there."""
        return sum(item.isVisible() for item in self.canvas.scene().items()) - self.before

    def tap(self) -> None:
        assert self.flicker.press()
        self.flicker.release(0.1)


@pytest.fixture
def map_(desk: Desk) -> Iterator[_Map]:
    made = _Map(desk)
    yield made
    made.flicker.close()


def test_held_it_is_shown_until_the_key_is_up_and_tapped_until_the_next_tap(map_: _Map) -> None:
    assert map_.flicker.press()
    assert map_.on_map() == 1
    map_.flicker.release(0.5)
    assert map_.on_map() == 0
    map_.tap()
    assert map_.on_map() == 1
    map_.tap()
    assert map_.on_map() == 0


def test_nothing_of_it_is_left_in_a_new_project(map_: _Map) -> None:
    map_.tap()
    wait_until(lambda: not map_.flicker.swipe.is_drawing, "for the hard cut")
    QgsProject.instance().clear()
    assert map_.on_map() == 0
    wait_until(lambda: not map_.flicker.swipe.is_on, "for its end")
    assert len(map_.canvas.scene().items()) == map_.before


def test_it_goes_with_the_mosaic(map_: _Map) -> None:
    map_.tap()
    QgsProject.instance().removeMapLayer(map_.desk.mosaic.id())
    assert map_.on_map() == 0


def test_another_layer_is_no_reason_to_hide_it(map_: _Map) -> None:
    map_.tap()
    map_.desk.raster(Path(map_.desk.sources[0].source()))
    assert map_.on_map() == 1


@pytest.mark.slow
def test_what_lies_on_the_map_goes_with_judging_and_with_the_desk(plugin: Any, scene: Scene, tmp_path: Path) -> None:
    action_of(plugin).trigger()
    dock = plugin.desk("seamInspectorAction").dock
    dock.setFloating(True)
    dock.show()
    desk = Desk(scene, tmp_path)
    desk.session.close()
    desk.session = dock.session
    desk.set(desk.inputs())
    dock.session.select([desk.add()])
    layout, swipe = dock.layout_of_judging.action, dock.flicker.swipe
    layout.trigger()
    assert dock.flicker.press()
    dock.flicker.release(0.1)
    assert swipe.is_shown
    layout.trigger()
    assert not swipe.is_shown
    dock.swiping.action.trigger()
    dock.session.loss_view.show(True)
    dock.draw.trigger()
    assert dock.draw.isChecked()
    assert dock.flicker.press()
    dock.hide()
    assert not swipe.is_shown
    assert not dock.swiping.swipe.is_on
    assert not dock.session.loss_view.is_shown
    assert not dock.draw.isChecked()
