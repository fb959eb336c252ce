"""Windows that are to be inspected again, whatever was changed, undone or saved since."""
from __future__ import annotations

from dataclasses import replace

import pytest
from qgis.core import QgsCoordinateReferenceSystem

from tests.qgis.scenes import SHARP, Scene, layer, outline
from tests.qgis.seams.desk.session_desk import BLURRED_WINDOW, SHARP_WINDOW, Desk, settle, wait_until


@pytest.mark.parametrize(
    "change",
    [
        {"wavelet": "db4"}, {"levels": 2}, {"max_ratio": 0.3}, {"min_kept": 0.6}, {"sources": ()},
        {"reference": "composite"},
    ],
)
def test_another_input_makes_inspected_windows_stale(desk: Desk, change: dict[str, object]) -> None:
    desk.add()
    if "sources" in change:
        change = {"sources": desk.session.inputs.sources[:1]}
    before = desk.session.inputs
    for inputs in (replace(before, **change), before, replace(before, **change)):  # type: ignore[arg-type]
        desk.set(inputs)
        assert desk.rows()[1].stale == (inputs != before)
    desk.session.inspect_pending()
    desk.wait()
    assert not desk.rows()[1].stale


def test_windows_are_still_stale_when_one_comes_back_to_their_layer(desk: Desk) -> None:
    desk.add()
    layer_id, sources = desk.layer().id(), desk.session.inputs.sources
    desk.session.set_inputs(replace(desk.session.inputs, sources=sources[:1]))
    for other in ("", layer_id):
        desk.session.set_inputs(replace(desk.session.inputs, windows=other))
    assert desk.rows()[1].stale
    desk.session.set_inputs(replace(desk.session.inputs, sources=sources))
    assert not desk.rows()[1].stale  # those that it was measured by


def test_a_window_that_is_moved_becomes_stale_alone_until_it_is_back(desk: Desk) -> None:
    fid, other = desk.add(), desk.add(SHARP_WINDOW)
    before = desk.layer().getFeature(fid).geometry()
    desk.move(fid, outline((200, 64, 128, 128)))
    assert [desk.session.row(item).stale for item in (fid, other)] == [True, False]  # type: ignore[union-attr]
    desk.move(fid, before)
    assert not any(row.stale for row in desk.session.windows())
    desk.move(fid, outline((200, 64, 128, 128)))
    desk.session.inspect([fid])
    desk.wait()
    assert not any(row.stale for row in desk.session.windows())


def test_the_result_of_another_place_is_stale_where_the_window_comes_back(desk: Desk) -> None:
    fid = desk.add()
    before = desk.layer().getFeature(fid).geometry()
    desk.move(fid, outline(SHARP))
    desk.session.inspect([fid])
    desk.wait()
    for shape, is_stale in ((None, False), (before, True), (outline(SHARP), False)):
        if shape is not None:
            desk.move(fid, shape)
        assert (desk.rows()[1].verdict, desk.rows()[1].stale) == ("preserved", is_stale)


# Layers that change


def test_another_data_source_or_reference_system_makes_inspected_windows_stale(desk: Desk, scene: Scene) -> None:
    desk.add()
    source, path = desk.sources[0], desk.sources[0].source()
    source.setDataSource(str(scene.mosaic), "other", "gdal")
    assert desk.rows()[1].stale
    source.setDataSource(path, "west", "gdal")
    assert not desk.rows()[1].stale
    crs = source.crs()
    source.setCrs(QgsCoordinateReferenceSystem("EPSG:32634"))
    assert desk.rows()[1].stale
    desk.wait_for_opening()
    source.setCrs(crs)
    assert not desk.rows()[1].stale
    desk.mosaic.setDataSource(str(scene.east), "other", "gdal")
    desk.wait_for_opening()
    assert desk.rows()[1].stale
    desk.session.take_windows()  # they were asked about, as the mosaic is another
    desk.session.inspect_pending()
    desk.wait()
    assert desk.session.result(desk.rows()[1].fid).clips[0].raster == "east.tif"  # type: ignore[union-attr]


def test_an_edited_source_index_makes_inspected_windows_stale(desk: Desk, scene: Scene) -> None:
    whole = outline((0, 0, 512, 256))
    paths = ("string", [str(scene.west), str(scene.east)])
    index = layer("Polygon", [whole, whole], location=paths, remark=("string", ["", ""]))
    desk.project.addMapLayer(index)
    desk.set(desk.inputs(sources=(), source_index=index.id()))
    desk.add()
    assert desk.rows()[1].sources == 2
    index.startEditing()
    index.changeAttributeValue(1, 1, "a note")
    settle(0.8)
    desk.wait_for_opening()
    assert not desk.rows()[1].stale  # nothing that counts has changed
    index.deleteFeature(2)
    wait_until(lambda: desk.rows()[1].stale)
    assert len(desk.session.block().sources_over(BLURRED_WINDOW)) == 1
    index.undoStack().undo()
    wait_until(lambda: not desk.rows()[1].stale)
    assert len(desk.session.block().sources_over(BLURRED_WINDOW)) == 2
    desk.project.removeMapLayers([index.id()])
    wait_until(lambda: desk.rows()[1].stale)


def test_seam_cells_decide_and_make_inspected_windows_stale(desk: Desk) -> None:
    desk.add()
    cells = layer("Polygon", [outline((0, 0, 512, 256))], source=("string", ["west"]))
    desk.project.addMapLayer(cells)
    desk.set(replace(desk.session.inputs, cells=cells.id()))
    block = desk.session.block()
    assert block is not None
    assert [cell.source for cell in block.cells] == ["west"]
    wait_until(lambda: desk.rows()[1].stale)
    desk.session.inspect_pending()
    desk.wait()
    row = desk.rows()[1]
    result = desk.session.result(row.fid)
    assert result is not None
    against_west = result.pairs[0].ratios.detail[0]  # the composite is the western source alone, but for its tone
    assert row.composite_ratio == pytest.approx(against_west, rel=0.02)
    cells.startEditing()
    cells.changeAttributeValue(1, 0, "east")
    wait_until(lambda: desk.rows()[1].stale)
    cells.rollBack()
    wait_until(lambda: not desk.rows()[1].stale)
    desk.project.removeMapLayers([cells.id()])
    wait_until(lambda: desk.rows()[1].stale)
