"""Mosaic, source index and seamlines that the project offers just one of."""
from __future__ import annotations

import re
from collections import defaultdict
from dataclasses import replace

from qgis.core import QgsProject, QgsRasterLayer, QgsVectorLayer, QgsWkbTypes

from ....imagery.errors import SeamInspectorError
from ....imagery.grids import extents_meet
from ....toolkit.layers import box_extent, transformed_extent
from ...measure.inputs.raster_facts import RasterFacts, likely_mosaic
from ...measure.scan.lines.seam_fields import seam_fields
from ...tables.source_index import LOCATION_FIELD
from .project_inputs import Inputs
from .raster_layers import facts_of, file_rasters

_SEAM_NAMES = re.compile(r"seam|cut_?line|mosai[ck]|nahtlinie|szwy|mozaik|graphe", re.IGNORECASE)
_OF_RESULTS = {"kept_1", "verdict", "window_id", "ratio_1"}  # fields of what scans and inspections write


def with_likely_mosaic(inputs: Inputs) -> Inputs:
    """The mosaic where none is chosen: the one raster that others of the project are suitable sources of."""
    if inputs.mosaic or inputs.sources:
        return inputs
    by_system: defaultdict[str, list[QgsRasterLayer]] = defaultdict(list)
    for layer in file_rasters():
        by_system[layer.crs().authid() or layer.crs().toWkt()].append(layer)
    likely = (likely_mosaic(_facts_in_one_system(rasters)) for rasters in by_system.values() if len(rasters) > 2)
    found = {name for name in likely if name is not None}
    return replace(inputs, mosaic=found.pop()) if len(found) == 1 else inputs


def _facts_in_one_system(rasters: list[QgsRasterLayer]) -> list[RasterFacts]:
    return [replace(one, is_mosaic=False) for one in facts_of(rasters, rasters[0])]


def with_likely_vectors(inputs: Inputs) -> Inputs:
    """Seamlines, and without any source their index, where none is chosen and one layer on the mosaic looks like it."""
    mosaic = QgsProject.instance().mapLayer(inputs.mosaic)
    if not isinstance(mosaic, QgsRasterLayer):
        return inputs
    vectors = [one for one in QgsProject.instance().mapLayers().values() if isinstance(one, QgsVectorLayer)]
    vectors = [one for one in vectors if one.isValid()]
    if not inputs.seamlines:
        lines = _on(mosaic, [one for one in vectors if _are_seams(one, QgsWkbTypes.GeometryType.LineGeometry)])
        cells = _on(mosaic, [one for one in vectors if _are_seams(one, QgsWkbTypes.GeometryType.PolygonGeometry)])
        inputs = replace(inputs, seamlines=_only(lines or cells))
    if not inputs.source_index and not inputs.sources:
        inputs = replace(inputs, source_index=_only(_on(mosaic, [one for one in vectors if _is_index(one)])))
    return inputs


def _only(found: list[QgsVectorLayer]) -> str:
    return str(found[0].id()) if len(found) == 1 else ""


def _on(mosaic: QgsRasterLayer, found: list[QgsVectorLayer]) -> list[QgsVectorLayer]:
    return [one for one in found if _meets(one, mosaic)]


def _is_index(layer: QgsVectorLayer) -> bool:
    is_polygons = layer.geometryType() == QgsWkbTypes.GeometryType.PolygonGeometry
    return is_polygons and LOCATION_FIELD in layer.fields().names()


def _are_seams(layer: QgsVectorLayer, kind: QgsWkbTypes.GeometryType) -> bool:
    """By its name or, of lines, by fields that say what lies on either side."""
    names = layer.fields().names()
    if layer.geometryType() != kind or _OF_RESULTS.intersection(names) or _is_index(layer):
        return False
    if _SEAM_NAMES.search(layer.name()):
        return True
    is_lines = kind == QgsWkbTypes.GeometryType.LineGeometry
    return is_lines and bool(seam_fields([dict.fromkeys(names, "x")]).left)


def _meets(layer: QgsVectorLayer, mosaic: QgsRasterLayer) -> bool:
    box = layer.extent()
    if box.isNull():
        return False
    try:
        extent = transformed_extent(box_extent(box), layer.crs(), mosaic.crs(), QgsProject.instance())
    except SeamInspectorError:
        return False
    return extents_meet(extent, box_extent(mosaic.extent()))
