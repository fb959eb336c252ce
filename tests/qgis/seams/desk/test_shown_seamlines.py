"""One key takes the seamlines off the map while windows are judged, and puts them back."""
from __future__ import annotations

from types import SimpleNamespace

from qgis.core import QgsProject, QgsRasterLayer
from seam_inspector.plugin.seams.desk.judging_desk import over_the_mosaic, toggle_seamlines

from tests.qgis.scenes import Scene, layer, line


def test_seamlines_go_and_come_back(project: QgsProject) -> None:
    seams, other = (layer("LineString", [line((0, 0), (9, 9))]) for _ in range(2))
    group = project.layerTreeRoot().addGroup("given")
    for item in (seams, other):
        project.addMapLayer(item, False)
        group.addLayer(item)
    session = SimpleNamespace(inputs=SimpleNamespace(seamlines=seams.id(), mosaic=""))
    node, beside = (project.layerTreeRoot().findLayer(item.id()) for item in (seams, other))
    assert toggle_seamlines(session)  # type: ignore[arg-type]
    assert (node.isVisible(), beside.isVisible()) == (False, True)
    assert toggle_seamlines(session)  # type: ignore[arg-type]
    assert node.isVisible()
    group.setItemVisibilityChecked(False)
    assert toggle_seamlines(session)  # type: ignore[arg-type]
    assert node.isVisible()


def test_without_seamlines_the_key_is_somebody_else_s(project: QgsProject) -> None:
    assert not toggle_seamlines(SimpleNamespace(inputs=SimpleNamespace(seamlines="", mosaic="")))  # type: ignore[arg-type]


def test_what_a_scan_found_goes_with_them(project: QgsProject) -> None:
    """Its squares and lines tell the eye what to find."""
    worst, windows = (layer("Polygon", []) for _ in range(2))
    worst.setCustomProperty("seam_inspector/made_for", "the mosaic")
    worst.setCustomProperty("seam_inspector/scanned", "2026-01-01")
    group = project.layerTreeRoot().addGroup("scan")
    project.addMapLayer(worst, False)
    group.addLayer(worst).setItemVisibilityChecked(False)
    project.addMapLayer(windows)
    session = SimpleNamespace(inputs=SimpleNamespace(seamlines="", mosaic="the mosaic"))
    assert toggle_seamlines(session)  # type: ignore[arg-type]
    assert not group.isVisible()
    assert project.layerTreeRoot().findLayer(windows.id()).isVisible()
    assert toggle_seamlines(session)  # type: ignore[arg-type]
    assert group.isVisible()
    assert not project.layerTreeRoot().findLayer(worst.id()).itemVisibilityChecked()


def test_rasters_over_the_mosaic_would_be_judged_in_its_place(project: QgsProject, scene: Scene) -> None:
    below, mosaic, above = (QgsRasterLayer(str(path), path.stem) for path in (scene.west, scene.mosaic, scene.east))
    lines = layer("LineString", [])
    for item in (below, mosaic, lines, above):
        project.addMapLayer(item)
    session = SimpleNamespace(inputs=SimpleNamespace(seamlines="", mosaic=mosaic.id()))
    assert [node.layerId() for node in over_the_mosaic(session)] == [above.id()]  # type: ignore[arg-type]
