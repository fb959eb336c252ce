"""A sound cut that ends at the ground of an orthoimage that was not given."""
from __future__ import annotations

from pathlib import Path

import numpy as np
from osgeo import ogr, osr
from scipy import ndimage
from seam_inspector import ScanSettings, open_block, scan
from seam_inspector.plugin.imagery.seam_totals import PieceState

from tests.numbers.synthetic import write_raster

PIXEL, LEFT, TOP = 0.1, 500000.0, 5500000.0
ROWS, COLUMNS, END = 640, 1280, 900  # at which the ground of the missing image begins


def test_pieces_that_reach_a_missing_orthoimage_neither_pass_nor_fail(tmp_path: Path) -> None:
    random = np.random.default_rng(3)
    ground = 128 + ndimage.gaussian_filter(random.normal(0, 200, (ROWS, COLUMNS)), 4)
    images = [ground + random.normal(0, 20, ground.shape) for _ in "abc"]
    row, column = np.mgrid[:ROWS, :COLUMNS]
    labels = np.where(column >= END, 2, (row >= ROWS // 2).astype(int))
    paths = {name: str(tmp_path / f"{name}.tif") for name in ("a", "b", "mosaic")}
    for path, plane in zip(paths.values(), (*images[:2], np.choose(labels, images))):
        write_raster(path, plane.clip(1, 255).round().astype(np.uint8)[np.newaxis], PIXEL, (LEFT, TOP))
    corners = {
        "a": (0, 0, END, ROWS // 2), "b": (0, ROWS // 2, END, ROWS), "c": (END, 0, COLUMNS, ROWS),
    }  # fmt: skip
    seamlines = tmp_path / "seamlines.gpkg"
    system = osr.SpatialReference()
    system.ImportFromEPSG(32633)
    dataset = ogr.GetDriverByName("GPKG").CreateDataSource(str(seamlines))
    layer = dataset.CreateLayer("seamlines", system, ogr.wkbPolygon)
    layer.CreateField(ogr.FieldDefn("source", ogr.OFTString))
    for name, (west, north, east, south) in corners.items():
        feature = ogr.Feature(layer.GetLayerDefn())
        feature.SetField("source", name)
        x, y = (LEFT + PIXEL * side for side in (west, east)), (TOP - PIXEL * side for side in (north, south))
        (x0, x1), (y1, y0) = x, y
        outline = f"POLYGON(({x0} {y0},{x1} {y0},{x1} {y1},{x0} {y1},{x0} {y0}))"
        feature.SetGeometry(ogr.CreateGeometryFromWkt(outline))
        layer.CreateFeature(feature)
    dataset = layer = None
    block = open_block(paths["mosaic"], [paths["a"], paths["b"]])
    result = scan(block, ScanSettings(piece_m=15.0), seamlines=seamlines)
    sides = {"a.tif", "b.tif"}
    between = {part.piece.vertices[:, 0].max(): part for part in result.pieces if {part.left, part.right} == sides}
    *others, last = (between[x] for x in sorted(between))
    assert len(others) > 3
    assert {piece.state for piece in others} == {PieceState.PASSED}
    assert last.state is PieceState.NOT_MEASURED
    assert "none shows what the mosaic does" in str(last.reason)
    assert result.told["not_given"] == "c"
