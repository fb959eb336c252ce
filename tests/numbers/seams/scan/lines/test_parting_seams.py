"""What of given seams can be one: it lies between two orthoimages, away from the border of the mosaic's pixels."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from osgeo import ogr
from seam_inspector.plugin.imagery.errors import SeamlineError
from seam_inspector.plugin.seams.measure.blocks.block_grid import ScanSettings
from seam_inspector.plugin.seams.measure.scan.scan_request import ScanRequest, scan_request
from seam_inspector.plugin.seams.measure.seamlines.given_seams import given_seams
from seam_inspector.plugin.seams.measure.seamlines.seam_features import SeamFeature

from tests.numbers.seams.scan.blocks.scenes import Scene, beside, blended, images, scene

SIDE, SEAM = 512, 200
COLLAR = [(60, 40), (470, 90), (440, 500), (25, 450)]
"""Corners of a mosaic that was cut out along a slanting outline, columns and rows."""
WHOLE = [(0, 0), (SIDE, 0), (SIDE, SIDE), (0, SIDE)]

Corners = Sequence[tuple[float, float]]


def on_outline(folder: Path, outline: Corners) -> Scene:
    """A mosaic of two orthoimages that has pixels within an outline."""
    given = images((SIDE, SIDE))
    made = blended(*given, beside(SEAM, 0, (SIDE, SIDE)))
    row, column = np.indices(made.shape) + 0.5
    for (x, y), (x_next, y_next) in zip(outline, [*outline[1:], outline[0]]):
        made[(x_next - x) * (row - y) < (y_next - y) * (column - x)] = 0
    return scene(folder, made, given)


def halves(case: Scene, outline: Corners, kind: int, **fields: str) -> list[SeamFeature]:
    """The parts west and east of the seam: as polygons, or closed lines as QGIS's "Polygons to lines" makes them."""
    whole = geometry(case, outline)
    made = []
    for left, right in ((-9, SEAM), (SEAM, SIDE + 9)):
        part = whole.Intersection(geometry(case, [(left, -9), (right, -9), (right, SIDE + 9), (left, SIDE + 9)]))
        made.append((fields, bytes(ogr.ForceTo(part, kind).ExportToWkb())))
    return made


def geometry(case: Scene, corners: Corners) -> ogr.Geometry:
    ring, polygon = ogr.Geometry(ogr.wkbLinearRing), ogr.Geometry(ogr.wkbPolygon)
    for column, row in [*corners, corners[0]]:
        ring.AddPoint_2D(*case.mosaic.grid.to_map(column, row))
    polygon.AddGeometry(ring)
    return polygon


def requested(case: Scene, features: Sequence[SeamFeature]) -> tuple[ScanRequest, str]:
    """The scan, and what is told."""
    given = given_seams(features, case.mosaic.grid, paths=[source.ref.path for source in case.sources])
    request, notices = scan_request(case.mosaic, case.sources, ScanSettings(piece_m=100.0), given)
    return request, " ".join(map(str, notices))


def metres(request: ScanRequest) -> float:
    return sum(piece.length_m for piece in request.pieces)


@pytest.mark.parametrize("outline", [WHOLE, COLLAR], ids=["whole", "collar"])
@pytest.mark.parametrize("with_sources", [True, False])
def test_outlines_as_lines_give_the_seams_of_the_polygons(
    tmp_path: Path, outline: Corners, with_sources: bool
) -> None:
    case = on_outline(tmp_path, outline)
    case = case if with_sources else replace(case, sources=())
    lines, notices = requested(case, halves(case, outline, ogr.wkbLineString))
    polygons, _ = requested(case, halves(case, outline, ogr.wkbPolygon))
    assert metres(lines) == pytest.approx(metres(polygons), rel=0.03)
    assert bool(lines.sources) == with_sources, "an outline doesn't lie on two orthoimages"
    assert "along the border of its pixels" in notices


def test_a_small_hole_beside_a_line_is_no_border(tmp_path: Path) -> None:
    given = images((SIDE, SIDE))
    made = blended(*given, beside(SEAM, 0, (SIDE, SIDE)))
    made[100:130, SEAM : SEAM + 30] = 0
    case = scene(tmp_path, made, given)
    request, _ = requested(case, line(case))
    assert metres(request) == pytest.approx(SIDE * case.mosaic.ground_sample_distance)


def line(case: Scene, **fields: str) -> list[SeamFeature]:
    """The seam as a line."""
    path = ogr.Geometry(ogr.wkbLineString)
    for row in (0, SIDE):
        path.AddPoint_2D(*case.mosaic.grid.to_map(SEAM, row))
    return [(fields, bytes(path.ExportToWkb()))]


@pytest.mark.parametrize("names", [("a.tif", "a.tif"), ("source_0.tif", "Source_0"), ("source_0", "x/source_0.jp2")])
def test_a_line_with_one_image_on_both_sides_is_no_seam(tmp_path: Path, names: tuple[str, str]) -> None:
    case = on_outline(tmp_path, WHOLE)
    features = line(case, left="source_0.tif", right="source_1.tif")
    within = line(case, left=names[0], right=names[1])
    within = [(fields, bytes(moved(wkb, case).ExportToWkb())) for fields, wkb in within if wkb is not None]
    request, _ = requested(case, [*features, *within])
    assert metres(request) == pytest.approx(SIDE * case.mosaic.ground_sample_distance)
    with pytest.raises(SeamlineError, match="separates two orthoimages"):
        requested(case, within)


def moved(wkb: bytes, case: Scene) -> ogr.Geometry:
    """A line 100 px to the right."""
    path = ogr.CreateGeometryFromWkb(wkb)
    for number in range(path.GetPointCount()):
        path.SetPoint_2D(number, path.GetX(number) + 100 * case.mosaic.grid.pixel_width, path.GetY(number))
    return path
