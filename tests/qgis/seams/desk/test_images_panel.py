"""The selected window on two maps: the mosaic, and its hard cut or a source, in one look and moving as one."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import pytest
from qgis.core import QgsProject, QgsRasterLayer
from seam_inspector.plugin.seams.desk.images.images_panel import ImagesPanel

from tests.qgis.scenes import PIXEL
from tests.qgis.seams.desk.session_desk import SHARP_WINDOW, Desk, settle, wait_until


@pytest.fixture
def panel(desk: Desk) -> Iterator[ImagesPanel]:
    """The panel of a desk with one window that is inspected and selected."""
    desk.set(desk.inputs())
    desk.session.select([desk.add()])
    made = ImagesPanel(desk.session)
    made.resize(640, 360)
    made.show()
    settle()
    yield made
    made.close()
    made.deleteLater()


def compared(panel: ImagesPanel) -> QgsRasterLayer:
    """The layer beside the mosaic, once it is there."""
    wait_until(lambda: panel.compared.layer is not None and panel.other.layers(), "for what stands beside the mosaic")
    layer = panel.other.layers()[0]
    assert layer is panel.compared.layer
    return layer


def choose(panel: ImagesPanel, name: str) -> None:
    panel.choice.setCurrentIndex(panel.choice.findText(name))
    panel.choice.activated.emit(panel.choice.currentIndex())


def words(panel: ImagesPanel) -> list[str]:
    """What the two maps say they show."""
    return [item.outline._items.label.text() for item in (panel.mosaic, panel.other)]


def test_the_mosaic_stands_beside_the_hard_cut_and_any_source(panel: ImagesPanel, desk: Desk) -> None:
    """In the mosaic's look, and never in the project."""
    assert [panel.choice.itemText(i) for i in range(panel.choice.count())] == [
        "hard cut of the sources", "west.tif", "east.tif"
    ]
    desk.mosaic.renderer().setOpacity(0.5)
    assert panel.mosaic.layers() == [desk.mosaic]
    assert compared(panel).renderer().opacity() == 0.5
    assert words(panel) == ["mosaic", "hard cut of the sources"]
    assert panel.other.layers()[1] is desk.mosaic  # around the window
    choose(panel, "east.tif")
    assert compared(panel).source().endswith("east.tif")
    assert panel.other.layers() == [panel.compared.layer]
    assert words(panel) == ["mosaic", "east.tif"]
    assert panel.compared.layer.id() not in QgsProject.instance().mapLayers()


def test_it_is_looked_at_at_2x_and_both_maps_move_as_one(panel: ImagesPanel) -> None:
    settle(0.3)
    for item in (panel.mosaic, panel.other):
        assert item.mapUnitsPerPixel() == pytest.approx(PIXEL / 2, rel=1e-6)
    panel.other.setExtent(panel.other.extent().scaled(3))
    assert panel.mosaic.mapUnitsPerPixel() == pytest.approx(1.5 * PIXEL, rel=1e-6)
    centre = panel.mosaic.center()
    panel.mosaic.setCenter(type(centre)(centre.x() + 5, centre.y()))
    assert panel.other.center().x() == pytest.approx(centre.x() + 5)


def test_what_was_chosen_stays_chosen_in_the_next_window(panel: ImagesPanel, desk: Desk) -> None:
    choose(panel, "west.tif")
    before = panel.mosaic.center()
    desk.session.select([desk.add(SHARP_WINDOW)])
    settle(0.3)
    assert panel.choice.currentText() == "west.tif"
    assert panel.status.text() == "Window 2"
    assert panel.mosaic.center() != before


def test_lost_detail_lies_over_both_where_it_is_asked_for(panel: ImagesPanel, desk: Desk) -> None:
    assert not panel.mosaic.loss.pictures
    desk.session.lost_detail.setChecked(True)
    assert len(panel.mosaic.loss.pictures) == len(panel.other.loss.pictures) == 1
    desk.session.lost_detail.setChecked(False)
    assert not panel.other.loss.pictures


def test_without_a_window_a_mosaic_or_a_source_it_says_so(panel: ImagesPanel, desk: Desk) -> None:
    desk.session.set_inputs(replace(desk.session.inputs, sources=()))
    wait_until(panel._hint.isVisible, "for the sources to go")
    assert "source" in panel._hint.text()
    assert not panel.choice.isEnabled()
    desk.session.select([])
    settle()
    assert "Select a window" in panel._hint.text()
    QgsProject.instance().removeMapLayer(desk.mosaic.id())
    settle()
    assert panel._hint.isVisible()
