"""Seams from whatever lines and polygons a production line leaves behind."""
from __future__ import annotations

import struct
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from osgeo import gdal, ogr
from seam_inspector.plugin.imagery.errors import SeamlineError
from seam_inspector.plugin.imagery.lines import Seam, find_seams, polygon_rings, read_geometry

ORIGIN = np.array([576000.0, 5188000.0])


def wkb(text: str) -> bytes:
    return bytes(ogr.CreateGeometryFromWkt(text).ExportToIsoWkb())


def line(points: Sequence[Sequence[float]]) -> bytes:
    return wkb(f"LINESTRING ({', '.join(f'{x!r} {y!r}' for x, y in np.asarray(points).tolist())})")


def polygon(*rings: Sequence[Sequence[float]]) -> bytes:
    closed = [np.asarray([*ring, ring[0]], dtype=float).tolist() for ring in rings]
    texts = [", ".join(f"{x!r} {y!r}" for x, y in ring) for ring in closed]
    return wkb(f"POLYGON (({'), ('.join(texts)}))")


def box(left: float, bottom: float, right: float, top: float) -> list[tuple[float, float]]:
    return [(left, bottom), (right, bottom), (right, top), (left, top)]


def pieces(path: np.ndarray) -> list[bytes]:
    """Each piece of a path as a feature of its own."""
    return [line(path[index : index + 2]) for index in range(len(path) - 1)]


def staircase(width: int, height: int) -> np.ndarray:
    """The raster edge along a straight line from (0, 0) to (width, height), in steps of one pixel."""
    columns = np.arange(width)
    rows = np.round((columns + 0.5) * height / width)
    steps = [(0.0, 0.0)]
    for column, row in zip(columns, rows):
        while steps[-1][1] != row:
            steps.append((column, steps[-1][1] + np.sign(row - steps[-1][1])))
        steps.append((column + 1.0, row))
    while steps[-1][1] != height:
        steps.append((width, steps[-1][1] + np.sign(height - steps[-1][1])))
    return np.array(steps)


def raster_edges(labels: np.ndarray) -> list[bytes]:
    """One line per pixel side between two labels."""
    beside = [((x + 1, -y), (x + 1, -y - 1)) for y, x in np.argwhere(labels[:, 1:] != labels[:, :-1]).tolist()]
    below = [((x, -y - 1), (x + 1, -y - 1)) for y, x in np.argwhere(labels[1:] != labels[:-1]).tolist()]
    return [line(edge) for edge in beside + below]


def raster_polygons(labels: np.ndarray) -> list[bytes]:
    """What gdal_polygonize makes of labels."""
    raster = gdal.GetDriverByName("MEM").Create("", labels.shape[1], labels.shape[0], 1, gdal.GDT_Int32)
    raster.SetGeoTransform((0, 1, 0, 0, 0, -1))
    raster.GetRasterBand(1).WriteArray(labels)
    source = ogr.GetDriverByName("Memory").CreateDataSource("")
    layer = source.CreateLayer("polygons")
    gdal.Polygonize(raster.GetRasterBand(1), None, layer, -1)
    return [bytes(feature.GetGeometryRef().ExportToWkb()) for feature in layer]


def layer_wkb(path: Path, layer: str) -> list[bytes]:
    source = ogr.Open(str(path))
    return [bytes(feature.GetGeometryRef().ExportToWkb()) for feature in source.GetLayerByName(layer)]


def total(seams: Sequence[Seam]) -> float:
    return sum(float(np.hypot(*np.diff(seam.vertices, axis=0).T).sum()) for seam in seams)


def assert_same(ones: Sequence[Seam], others: Sequence[Seam]) -> None:
    assert [seam.seam_id for seam in ones] == [seam.seam_id for seam in others]
    for line, other in zip(ones, others):
        np.testing.assert_allclose(line.vertices, other.vertices, atol=1e-6)


@given(st.randoms(use_true_random=False), st.integers(20, 200), st.integers(0, 200))
def test_pieces_in_any_order_direction_and_number_of_copies_are_one_seam(random, width: int, height: int) -> None:
    path = staircase(width, height) * 0.03 + ORIGIN
    parts = [path[index : index + 2] for index in range(len(path) - 1)]
    parts += random.choices(parts, k=10)
    random.shuffle(parts)
    shuffled = [line(part[::-1] if random.random() < 0.5 else part) for part in parts]
    assert_same(find_seams(shuffled, 0.03), find_seams([line(path)], 0.03))


def test_a_seam_does_not_turn_back_at_a_branch() -> None:
    seams = find_seams([line([(0, 0), (100, end)]) for end in (-9, 0, 9)], 1.0)
    assert len(seams) == 3


def test_a_sliver_of_a_third_source_does_not_chop_a_seam() -> None:
    labels = np.zeros((40, 300), dtype=np.int32)
    labels[20:] = 1
    labels[18:22, 140:160] = 2
    first, second = find_seams(raster_edges(labels), 1.0)
    assert total([first]) == pytest.approx(300, rel=0.02)
    assert total([second]) < 30


def test_longest_first_and_from_west_to_east() -> None:
    seams = find_seams([line([(0, 90), (10, 90)]), line([(70, 0), (0, 0)]), line([(5, 60), (5, 20)])], 1.0)
    assert [seam.seam_id for seam in seams] == [1, 2, 3]
    assert [total([seam]) for seam in seams] == pytest.approx([70, 40, 10])
    assert [seam.vertices[0].tolist() for seam in seams] == [[0, 0], [5, 20], [0, 90]]


@pytest.mark.parametrize(
    "text",
    [
        "LINESTRING Z (0 0 7, 50 0 8)",
        "LINESTRING M (0 0 7, 50 0 8)",
        "LINESTRING ZM (0 0 7 1, 50 0 8 2)",
        "MULTILINESTRING ((0 0, 20 0), (50 0, 20 0))",
        "MULTILINESTRING ZM ((0 0 1 1, 20 0 1 1), (50 0 1 1, 20 0 1 1))",
        "GEOMETRYCOLLECTION (POINT (3 3), GEOMETRYCOLLECTION (LINESTRING (0 0, 50 0)), LINESTRING EMPTY)",
        "COMPOUNDCURVE ((0 0, 20 0), (20 0, 50 0))",
        "MULTICURVE ((0 0, 20 0), COMPOUNDCURVE ((20 0, 50 0)))",
    ],
)
def test_every_kind_of_line_is_read(text: str) -> None:
    (seam,) = find_seams([None, b"", wkb("LINESTRING EMPTY"), wkb("POINT (1 1)"), wkb(text)], 1.0)
    assert total([seam]) == pytest.approx(50)


@given(arrays(np.int32, st.tuples(st.integers(2, 12), st.integers(2, 12)), elements=st.integers(1, 3)))
def test_polygons_and_lines_of_the_same_raster_give_the_same_seams(labels: np.ndarray) -> None:
    assume(len(np.unique(labels)) > 1)
    blocks = np.kron(labels, np.ones((3, 3), dtype=np.int32))  # a pixel alone straightens to nothing
    assert_same(find_seams(raster_polygons(blocks), 1.0), find_seams(raster_edges(blocks), 1.0))


@pytest.mark.parametrize("gap", [0.45, 0.2, -0.2, -0.45])
@pytest.mark.parametrize("step", [1, 2])
def test_gaps_and_overlaps_of_half_a_pixel_are_bridged(gap: float, step: int) -> None:
    border = np.array([(100, 0), (104, 25), (100, 50), (96, 75), (100, 100)], dtype=float)
    halfway = (border[1:] + border[:-1]) / 2
    other = np.insert(border, [1, 2, 3, 4], halfway, axis=0)[::-step] + (gap, 0)
    left, right = [(0, 0), *border.tolist(), (0, 100)], [(200, 100), *other.tolist(), (200, 0)]
    (seam,) = find_seams([polygon(left), polygon(right)], 1.0)
    assert total([seam]) == pytest.approx(np.hypot(*np.diff(border, axis=0).T).sum(), rel=0.02)


@given(st.integers(0, 2**32 - 1))
def test_cells_digitised_apart_have_their_common_lines_as_seams(seed: int) -> None:
    random = np.random.default_rng(seed)
    cells = []
    for left, bottom in [(0, 0), (200, 0), (0, 150), (200, 150)]:
        corners = np.array([*box(left, bottom, left + 200, bottom + 150), (left, bottom)], dtype=float)
        sides = [np.linspace(*ends, random.integers(2, 80), endpoint=False) for ends in zip(corners[:-1], corners[1:])]
        outline = np.concatenate(sides)
        cells.append(polygon(outline + random.uniform(-0.15, 0.15, outline.shape)))
    assert total(find_seams(cells, 1.0)) == pytest.approx(700, rel=0.02)


def test_the_outline_of_the_block_is_no_seam_even_when_a_polygon_is_there_twice() -> None:
    left, right = polygon(box(0, 0, 50, 50)), polygon(box(50, 0, 90, 50))
    (seam,) = find_seams([left, right, left, right], 1.0)
    assert total([seam]) == pytest.approx(50)


@pytest.mark.parametrize(
    "text",
    [
        "POLYGON ZM ((50 0 1 1, 90 0 1 1, 90 50 1 1, 50 50 1 1, 50 0 1 1))",
        "CURVEPOLYGON (COMPOUNDCURVE ((50 50, 50 0), CIRCULARSTRING (50 0, 75 25, 50 50)))",
        "MULTISURFACE (((50 0, 90 0, 90 50, 50 50, 50 0)))",
        "TRIANGLE ((50 0, 90 0, 50 50, 50 0))",
        "TIN Z (((50 0 1, 90 0 1, 50 50 1, 50 0 1)))",
    ],
)
def test_every_kind_of_polygon_is_read(text: str) -> None:
    (seam,) = find_seams([polygon(box(0, 0, 50, 50)), wkb(text)], 1.0)
    assert total([seam]) == pytest.approx(50)


@pytest.mark.parametrize(
    ("geometries", "sentence"),
    [
        ([], "holds no line"),
        ([None, b"", wkb("LINESTRING EMPTY")], "holds no line"),
        ([wkb("POINT (1 1)"), wkb("MULTIPOINT (1 1, 2 2)")], "no line and no polygon"),
        ([line([(5, 5), (5, 5)])], "shorter than a pixel"),
        ([line([(15.2, 60.1), (15.20004, 60.10002)])], "shorter than a pixel"),
        ([polygon(box(0, 0, 50, 50))], "share a border"),
        ([polygon(box(0, 0, 50, 50)), polygon(box(52, 0, 90, 50))], "share a border"),
        ([polygon(box(0, 0, 50, 50)), polygon(box(50, 50, 90, 90))], "share a border"),
        ([polygon(box(0, 0, 50, 50)), polygon(box(20, 20, 90, 90))], "share a border"),
        ([line([(0, 0), (9, 9)]), b"no geometry"], "feature 2"),
        ([line([(0, 0), (9, 9)])[:-8]], "feature 1"),
        ([line([(0, 0), (1e12, 9)])], "reference systems"),
    ],
)
def test_a_layer_without_seams_says_what_to_do(geometries: Sequence[bytes], sentence: str) -> None:
    with pytest.raises(SeamlineError, match=sentence):
        find_seams(geometries, 1.0)


def test_coordinates_that_are_no_numbers_are_refused() -> None:
    geometry = bytearray(line([(0, 0), (9, 9)]))
    geometry[-8:] = np.array([np.nan]).tobytes()
    with pytest.raises(SeamlineError, match="not numbers"):
        find_seams([bytes(geometry)], 1.0)


def test_a_polygon_with_corners_that_are_no_numbers_is_refused_before_geos_dies_of_it() -> None:
    corners = np.array([[-np.inf, 5e6], [5e6, np.inf], [5e6, np.nan], [np.inf, np.nan]])
    wkb = struct.pack("<BIII", 1, ogr.wkbPolygon, 1, len(corners)) + corners.tobytes()
    with pytest.raises(SeamlineError, match="feature 7"):
        list(polygon_rings(read_geometry(wkb, 7), 7))


def test_brighton_lines_and_polygons_tell_the_same(data_folder: Path) -> None:
    path = data_folder / "seams" / "brighton" / "seamlines.gpkg"
    from_lines = find_seams(layer_wkb(path, "seamlines"), 0.03)
    assert_same(find_seams(layer_wkb(path, "source_polygons"), 0.03), from_lines)
    assert len(from_lines) == 15  # of 11,571 pieces
    raw = 11571 * 0.03
    assert raw / np.sqrt(2) < total(from_lines) < 0.8 * raw  # most of it runs at 45 degrees
