"""Seams of producers through QGIS: files, reference systems, attributes of all types."""
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal, ogr, osr
from qgis.core import QgsCoordinateReferenceSystem, QgsCoordinateTransform, QgsProject, QgsVectorLayer
from seam_inspector.plugin.imagery.grids import Grid
from seam_inspector.plugin.seams.measure.seamlines.given_seams import GivenSeams, given_seams
from seam_inspector.plugin.seams.tables.input_layers import seam_features

from tests.numbers.seams.scan.lines.test_given_seams import length, mosaic_elements, northward
from tests.qgis.runs import run
from tests.qgis.scenes import windows
from tests.qgis.seams.scan_scenes import write_scene


def given_by(path: str, epsg: int, grid: Grid) -> GivenSeams:
    layer = QgsVectorLayer(path, "seams", "ogr")
    assert layer.isValid()
    target = QgsCoordinateReferenceSystem.fromEpsgId(epsg)
    transform = QgsCoordinateTransform(layer.crs(), target, QgsProject.instance())
    features, notice = seam_features(layer.getFeatures(), layer.fields().names(), transform)
    assert notice is None
    return given_seams(features, grid)


def test_seam_polygons_of_naip_in_degrees_with_dates(tmp_path: Path) -> None:
    """Two exposures of one day and one of another, in NAD83 degrees, over a mosaic in UTM."""
    grid = Grid(500000.0, 4400200.0, 0.6, 0.6, 1000, 500)
    degrees, metres = osr.SpatialReference(), osr.SpatialReference()
    degrees.ImportFromEPSG(4269)
    metres.ImportFromEPSG(26913)
    for system in (degrees, metres):
        system.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    to_degrees = osr.CoordinateTransformation(metres, degrees)
    dataset = gdal.GetDriverByName("ESRI Shapefile").Create(str(tmp_path / "seams.shp"), 0, 0, 0, gdal.GDT_Unknown)
    layer = dataset.CreateLayer("seams", degrees, ogr.wkbPolygon)
    layer.CreateField(ogr.FieldDefn("SDATE", ogr.OFTDate))
    for left, right, day in ((0, 200, 4), (200, 400, 4), (400, 600, 11)):
        ring = ogr.Geometry(ogr.wkbLinearRing)
        for x, y in ((left, -100), (right, -100), (right, 200), (left, 200), (left, -100)):
            ring.AddPoint_2D(500000 + x, 4400000 + y)
        polygon = ogr.Geometry(ogr.wkbPolygon)
        polygon.AddGeometry(ring)
        polygon.Transform(to_degrees)
        row = ogr.Feature(layer.GetLayerDefn())
        row.SetField("SDATE", 2016, 7, day, 0, 0, 0.0, 0)
        row.SetGeometry(polygon)
        layer.CreateFeature(row)
    del layer, dataset
    given = given_by(str(tmp_path / "seams.shp"), 26913, grid)
    sides = sorted(northward(seam) for seam in given.seams)
    assert sides == [("2016-07-04", "2016-07-04"), ("2016-07-04", "2016-07-11")]
    for seam in given.seams:
        assert length(seam) == pytest.approx(300, abs=0.1)
        assert np.ptp(seam.vertices[:, 0]) < 0.1
    assert "'SDATE'" in str(given.notices[0])


def test_mosaic_elements_of_inspire(tmp_path: Path) -> None:
    path = mosaic_elements(tmp_path, ["2011-5864726", "2011-5864727"])
    given = given_by(str(path), 2180, Grid(500000, 600200, 0.1, 0.1, 4000, 2000))
    assert [northward(seam) for seam in given.seams] == [("2011-5864726", "2011-5864727")]
    assert [cell.source for cell in given.cells] == ["2011-5864726", "2011-5864727"]
    assert [notice.values for notice in given.notices] == [{"fields": "imageSourceReference"}]


@pytest.mark.usefixtures("provider")
def test_what_a_shapefile_cuts_is_told_and_read_back(tmp_path: Path) -> None:
    """Names of fields have ten letters there, and those of numbered fields become others."""
    files = write_scene(tmp_path)
    seams, cells, inspected = (str(tmp_path / f"{name}.shp") for name in ("seams", "cells", "inspected"))
    scanned = run("scanmosaic", **files.given(SEAMS=seams, CELLS=cells, WORST=str(tmp_path / "worst.gpkg")))
    messages = [text for text in scanned.log.warnings if "ten letters" in text]
    assert ["left_source, right_source, feather_width" in text for text in messages] == [True]
    window = windows((150, 100, 256, 256))
    of_windows = run("inspectwindows", MOSAIC=files.mosaic, SOURCES=files.sources, WINDOWS=window, OUTPUT=inspected)
    assert any("composite_ratio_2" in text for text in of_windows.log.warnings)
    again = run("scanmosaic", **files.given(SEAMLINES=seams))
    assert {(row["left_source"], row["right_source"]) for row in again.rows("SEAMS")} <= {
        ("west.tif", "east.tif"), ("east.tif", "west.tif")
    }  # fmt: skip
    for record in (scanned, of_windows, again):
        record.close()
