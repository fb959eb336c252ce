"""The hard cut in place of the mosaic: held and tapped, and off the map with its window, judging and project."""
from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from qgis.core import QgsProject
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtWidgets import QWidget
from seam_inspector.plugin.seams.desk.map.hard_cut import Flicker

from tests.qgis.plugin_lives import action_of
from tests.qgis.scenes import Scene
from tests.qgis.seams.desk.session_desk import SHARP_WINDOW, Desk, wait_until


class _Map:
    def __init__(self, desk: Desk) -> None:
        desk.set(desk.inputs())
        self.desk, self.fid = desk, desk.add()
        desk.session.select([self.fid])
        self.canvas, self.owner = QgsMapCanvas(), QWidget()
        self.canvas.setLayers([desk.mosaic])
        self.canvas.setExtent(desk.mosaic.extent())
        self.flicker = Flicker(self.canvas, desk.session, self.owner)

    def names(self) -> list[str]:
        """Layers on the map, the topmost first, the hard cut as such."""
        cut = self.flicker.hard_cut.layer
        return ["hard cut" if layer is cut else layer.name() for layer in self.canvas.layers()]

    def wait_for_cut(self) -> None:
        wait_until(lambda: self.flicker.hard_cut.layer is not None, "for the hard cut")

    def tap(self) -> None:
        assert self.flicker.press()
        self.flicker.release(0.1)


@pytest.fixture
def map_(desk: Desk) -> Iterator[_Map]:
    made = _Map(desk)
    yield made
    made.flicker.close()


def test_held_it_is_shown_until_the_key_is_up_and_tapped_until_the_next_tap(map_: _Map) -> None:
    mosaic = map_.desk.mosaic.name()
    assert map_.flicker.press()
    assert map_.names() == [mosaic]
    map_.wait_for_cut()
    assert map_.names() == ["hard cut", mosaic]
    map_.flicker.release(0.5)
    assert map_.names() == [mosaic]
    map_.tap()
    assert map_.names() == ["hard cut", mosaic]
    map_.tap()
    assert map_.names() == [mosaic]


def test_it_lies_above_rasters_and_below_lines_in_the_mosaic_s_look(map_: _Map) -> None:
    """Also when QGIS sets the map's layers anew."""
    seamlines, mosaic, source = map_.desk.session.window_layer(), map_.desk.mosaic, map_.desk.sources[0]
    mosaic.renderer().setOpacity(0.5)
    map_.tap()
    map_.wait_for_cut()
    map_.canvas.setLayers([seamlines, source, mosaic])
    wait_until(lambda: len(map_.names()) == 4, "for the hard cut on the map again")
    assert map_.names() == [seamlines.name(), "hard cut", source.name(), mosaic.name()]
    assert map_.flicker.hard_cut.layer.renderer().opacity() == 0.5
    assert map_.flicker.hard_cut.layer.id() not in QgsProject.instance().mapLayers()


def test_the_next_window_begins_with_the_mosaic_and_its_hard_cut_lies_ready(map_: _Map) -> None:
    map_.tap()
    map_.wait_for_cut()
    first = map_.flicker.hard_cut.layer
    map_.desk.session.select([map_.desk.add(SHARP_WINDOW)])
    assert map_.names() == [map_.desk.mosaic.name()]
    wait_until(lambda: map_.flicker.hard_cut.layer not in (None, first), "for the next hard cut")
    assert not map_.flicker.is_shown


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
    layout, flicker = dock.judging.action, dock.flicker
    layout.trigger()
    assert dock.flicker.press()
    dock.flicker.release(0.1)
    assert flicker.is_shown
    layout.trigger()
    assert not flicker.is_shown
    dock.session.lost_detail.setChecked(True)
    dock.draw.trigger()
    assert dock.draw.isChecked()
    assert dock.flicker.press()
    dock.hide()
    assert not flicker.is_shown
    assert not dock.session.lost_detail.isChecked()
    assert not dock.draw.isChecked()
    node = desk.project.layerTreeRoot().findLayer(desk.layer().id())
    assert node.isVisible()
    dock.judging.model.change(is_blind=True)
    assert not node.isVisible()  # whose colours and labels tell what was found
    dock.judging.leave()
    assert not node.isVisible()
    dock.judging.model.change(is_blind=False)
    assert node.isVisible()
