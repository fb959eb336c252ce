"""Seams as producers deliver them: which line parts what, and what is wrong with a layer, told and not fatal."""
from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal, ogr
from seam_inspector.plugin.imagery.errors import SeamlineError, SettingsError
from seam_inspector.plugin.imagery.gdal_calls import gdal_silenced
from seam_inspector.plugin.imagery.grids import Grid
from seam_inspector.plugin.seams.measure.seamlines.given_seams import GivenSeams, SidedSeam, given_seams
from seam_inspector.plugin.seams.measure.seamlines.seam_features import (
    DATE_FIELDS,
    DATE_SIDE_FIELDS,
    SIDE_FIELDS,
    SOURCE_FIELDS,
    SeamFeature,
    SeamFields,
    read_seam_features,
    seam_fields,
)

from tests.numbers.synthetic import UTM33, wkt

GRID = Grid(0.0, 200.0, 0.1, 0.1, 4000, 2000)  # 400 x 200 m

def line(*places: tuple[float, float], **fields: object) -> SeamFeature:
    return fields, wkb(f"LINESTRING ({', '.join(f'{x} {y}' for x, y in places)})")


def polygon(*places: tuple[float, float], **fields: object) -> SeamFeature:
    return fields, wkb(f"POLYGON (({', '.join(f'{x} {y}' for x, y in [*places, places[0]])}))")


def box(left: float, bottom: float, right: float, top: float, **fields: object) -> SeamFeature:
    return polygon((left, bottom), (right, bottom), (right, top), (left, top), **fields)


def wkb(text: str) -> bytes:
    return bytes(ogr.CreateGeometryFromWkt(text).ExportToIsoWkb())


def length(seam: SidedSeam) -> float:
    return float(np.hypot(*np.diff(seam.vertices, axis=0).T).sum())


def northward(seam: SidedSeam) -> tuple[str | None, str | None]:
    """What lies west and east of a seam that runs from south to north or back."""
    return (seam.left, seam.right) if seam.vertices[-1, 1] > seam.vertices[0, 1] else (seam.right, seam.left)


def notices_of(given: GivenSeams) -> str:
    return " ".join(map(str, given.notices))


def test_borders_of_polygons_part_the_sources_they_name() -> None:
    given = given_seams([box(0, 0, 100, 200, source="a.tif"), box(100, 0, 400, 200, source="b.tif")], GRID)
    (seam,) = given.seams
    assert length(seam) == pytest.approx(200)
    assert northward(seam) == ("a.tif", "b.tif")
    assert [cell.source for cell in given.cells] == ["a.tif", "b.tif"]
    assert given.cells[1].extent == (100, 0, 400, 200)
    assert [notice.values for notice in given.notices] == [{"fields": "source"}], "it is said which field was taken"


def test_an_island_has_a_ring_with_its_source_inside() -> None:
    hole = wkb("POLYGON ((0 0, 400 0, 400 200, 0 200, 0 0), (50 50, 50 90, 90 90, 90 50, 50 50))")
    given = given_seams([({"source": "sea"}, hole), box(50, 50, 90, 90, source="island")], GRID)
    (ring,) = given.seams
    assert (ring.vertices[0] == ring.vertices[-1]).all()
    assert (ring.left, ring.right) == ("island", "sea")  # counter-clockwise


def test_overlaps_have_no_seam() -> None:
    given = given_seams(
        [box(0, 0, 110, 200, source="a"), box(100, 0, 250, 200, source="b"), box(250, 0, 400, 200, source="c")], GRID
    )
    assert [northward(seam) for seam in given.seams] == [("b", "c")]


def test_gaps_have_no_seams_and_narrow_slits_are_bridged() -> None:
    given = given_seams(
        [
            box(0, 0, 100, 200, source="a"),
            box(100.04, 0, 400, 90, source="b"),  # less than half a pixel off
            polygon((100, 90), (400, 90), (400, 200), (100, 200), (100, 180), (120, 180), (120, 160), (100, 160),
                    source="c"),
        ],
        GRID,
    )  # fmt: skip
    pairs = {("".join(sorted((str(seam.left), str(seam.right)))), round(length(seam))) for seam in given.seams}
    assert pairs == {("ab", 90), ("bc", 300), ("ac", 70), ("ac", 20)}


def test_polygons_that_cross_themselves_are_repaired() -> None:
    bow = polygon((0, 0), (100, 0), (100, 200), (0, 200), (0, 60), (20, 60), (20, 40), (-5, 40), source="a")
    given = given_seams([bow, box(100, 0, 400, 200, source="b")], GRID)
    eight = polygon((0, 0), (100, 200), (100, 0), (0, 200), source="a")
    crossed = given_seams([eight, box(100, 0, 400, 200, source="b")], GRID)
    assert length(given.seams[0]) == pytest.approx(200)
    assert sum(map(length, crossed.seams)) == pytest.approx(200)
    assert "outline crosses itself, repaired: 1" in notices_of(crossed)


def test_polygons_without_names_have_seams_without() -> None:
    given = given_seams([box(0, 0, 100, 200), box(100, 0, 400, 90), box(100, 90, 400, 200)], GRID)
    assert {(seam.left, seam.right) for seam in given.seams} == {(None, None)}
    assert [round(length(seam)) for seam in given.seams] == [300, 110, 90], "each of two polygons, and no third one"
    assert given.cells == ()
    assert "names no orthoimages" in notices_of(given)


def test_polygons_with_dates_alone_are_called_by_them() -> None:
    """Seam polygons of NAIP: parts of one day are different exposures."""
    given = given_seams(
        [
            box(0, 0, 100, 200, SDATE="2016-07-04"),
            box(100, 0, 200, 200, SDATE="2016-07-04"),
            box(200, 0, 400, 200, SDATE="2016-08-11"),
        ],
        GRID,
    )
    assert [northward(seam) for seam in given.seams] == [("2016-07-04", "2016-07-04"), ("2016-07-04", "2016-08-11")]
    assert given.dates == {"2016-07-04": "2016-07-04", "2016-08-11": "2016-08-11"}
    assert given.cells == ()
    assert "'SDATE'" in notices_of(given)


def test_dates_beside_names_are_kept_and_name_nothing() -> None:
    given = given_seams(
        [box(0, 0, 100, 200, image="a", IDATE="2016-07-04"), box(100, 0, 200, 200, image="a", IDATE="2016-07-05"),
         box(200, 0, 300, 200, image="b", IDATE="2016-07-11"), box(300, 0, 400, 200, image="c", IDATE="")], GRID
    )  # fmt: skip
    assert {frozenset((seam.left, seam.right)) for seam in given.seams} == {frozenset("ab"), frozenset("bc")}
    assert given.dates == {"b": "2016-07-11"}, "two dates of one source are none"
    assert [notice.values for notice in given.notices] == [{"fields": "image"}]


@pytest.mark.parametrize("names", [("left_src", "right_src"), ("Left", "Right"), ("ImgLeft", "imgRight"), ("L", "R")])
def test_lines_tell_left_and_right(names: tuple[str, str]) -> None:
    given = given_seams([line((100, 0), (100, 200), **dict(zip(names, ("a", "b"))))], GRID)
    assert northward(given.seams[0]) == ("a", "b")
    turned = given_seams([line((100, 200), (100, 0), **dict(zip(names, ("b", "a"))))], GRID)
    assert northward(turned.seams[0]) == ("a", "b")


def test_pieces_are_joined_as_far_as_they_part_the_same_sources() -> None:
    steps = [(100 + 10 * i, 100) for i in range(21)]
    pieces = [
        line(*(steps[i : i + 2] if i % 3 else steps[i : i + 2][::-1]),
             left=("a" if i % 3 else "b"), right=("b" if i % 3 else "a"))
        for i in range(12)
    ] + [line(*steps[i : i + 2], left="a", right="c") for i in range(12, 20)]  # fmt: skip
    given = given_seams(pieces, GRID)
    assert [(seam.left, seam.right) for seam in given.seams] == [("a", "b"), ("a", "c")]
    assert [length(seam) for seam in given.seams] == pytest.approx([120, 80])


def test_one_broken_feature_costs_itself_alone() -> None:
    broken = ({"source": "c"}, b"\x01\x03\x00\x00\x00\xff")
    ring = ogr.Geometry(ogr.wkbLineString)
    for x in (0.0, float("nan"), 5.0):
        ring.AddPoint_2D(x, x)
    nowhere = ({"source": "c"}, bytes(ring.ExportToWkb()))
    given = given_seams(
        [broken, nowhere, box(0, 0, 100, 200, source="a"), ({}, None), box(100, 0, 400, 200, source="b")], GRID
    )
    assert len(given.seams) == 1
    assert "can't be read, left out: 2" in notices_of(given)


def test_what_lies_elsewhere_takes_no_part() -> None:
    far = [box(1000 + 10 * i, 0, 1010 + 10 * i, 10, source=str(i)) for i in range(5)]
    given = given_seams([*far, box(0, 0, 100, 200, source="a"), box(100, 0, 900, 200, source="b")], GRID)
    assert [cell.source for cell in given.cells] == ["a", "b"]
    with pytest.raises(SeamlineError, match=r"None of the 5 features .* check the reference systems"):
        given_seams(far, GRID)


@pytest.mark.parametrize(
    ("features", "match"),
    [
        ([], "holds no line"),
        ([({}, None)], "holds no line"),
        ([({}, wkb("POINT (1 1)"))], "no line and no polygon"),
        ([line((1, 1), (1, 1))], "shorter than a pixel"),
        ([line((1, 1), (1e9, 1))], "check the reference systems"),
    ],
)
def test_layers_without_seams_are_refused(features: list[SeamFeature], match: str) -> None:
    with pytest.raises(SeamlineError, match=match):
        given_seams(features, GRID)


def test_metres_in_a_geojson_of_degrees_lie_elsewhere(tmp_path: Path) -> None:
    """GeoJSON is in degrees where it says nothing else; GDAL finds no place for such numbers."""
    geometry = {"type": "LineString", "coordinates": [[500000, 5000000], [500100, 5000100]]}
    path = tmp_path / "seams.geojson"
    path.write_text(json.dumps({"type": "Feature", "properties": {}, "geometry": geometry}))
    with pytest.raises(SeamlineError, match=r"None of the 1 features .* check the reference systems"):
        read_seam_features(str(path), wkt(UTM33))


@pytest.mark.parametrize(
    ("row", "expected"),
    [
        ({"label": 3, "source": "a.tif"}, SeamFields(source="source")),
        ({"CLICHE": "19FD", "DATE": "2019/07/04"}, SeamFields(source="CLICHE", date="DATE")),
        ({"gml_id": "x", "name": "part 1", "imageSourceReference": "u"}, SeamFields(source="imageSourceReference")),
        ({"Image_ID": 12, "SDATE": "20160704"}, SeamFields(source="Image_ID", date="SDATE")),
        ({"image": None, "FileName": "b.tif"}, SeamFields(source="FileName")),
        ({"phenomenonTime|beginPosition": "2016"}, SeamFields(date="phenomenonTime|beginPosition")),
        ({"left_src": "a", "right_src": "b"}, SeamFields(left="left_src", right="right_src")),
        ({"left_src": "a", "right_src": ""}, SeamFields()),
        (
            {"left_source": "a", "right_source": "b", "left_date": "2016-07-04", "right_date": "2016-07-11"},
            SeamFields("", "left_source", "right_source", "", "left_date", "right_date"),
        ),
        ({"OBJECTID": 7, "Shape_Area": 3.0}, SeamFields()),
    ],
)
def test_fields_of_producers_are_known(row: dict[str, object], expected: SeamFields) -> None:
    assert seam_fields([row]) == expected


PAIRED = [*SIDE_FIELDS, *DATE_SIDE_FIELDS]


@pytest.mark.parametrize("name", [*SOURCE_FIELDS, *DATE_FIELDS])
def test_shapefiles_cut_each_name_of_a_polygon_s_field(tmp_path: Path, name: str) -> None:
    written = written_names(tmp_path, name, "Shape_Area")
    assert {field for field in vars(seam_fields([dict.fromkeys(written, "x")])).values() if field} == {written[0]}


@pytest.mark.parametrize("names", PAIRED, ids="/".join)
def test_shapefiles_cut_each_pair_of_a_line_s_fields(tmp_path: Path, names: tuple[str, str]) -> None:
    written = written_names(tmp_path, *names)
    fields = seam_fields([dict.fromkeys(written, "x")])
    assert written in ([fields.left, fields.right], [fields.left_date, fields.right_date])


def written_names(folder: Path, *names: str) -> list[str]:
    """What a shapefile makes of the names of its fields."""
    dataset = gdal.GetDriverByName("ESRI Shapefile").Create(str(folder / "a.shp"), 0, 0, 0, gdal.GDT_Unknown)
    layer = dataset.CreateLayer("a", geom_type=ogr.wkbPolygon)
    with gdal_silenced():
        for name in names:
            layer.CreateField(ogr.FieldDefn(name, ogr.OFTString))
    return [layer.GetLayerDefn().GetFieldDefn(number).GetName() for number in range(len(names))]


def test_a_field_can_be_chosen() -> None:
    rows = [{"source": "x", "BLOCK": "b1", "von": "1", "bis": "2"}]
    assert seam_fields(rows, "BLOCK") == SeamFields(source="BLOCK")
    assert seam_fields(rows, "von, bis") == SeamFields(left="von", right="bis")
    with pytest.raises(SettingsError, match=r"no field 'block'.*: source, BLOCK, von, bis"):
        seam_fields(rows, "block")


def features_of(path: Path, layer: str = "") -> list[SeamFeature]:
    dataset = gdal.OpenEx(str(path), gdal.OF_VECTOR)
    rows = dataset.GetLayerByName(layer) if layer else dataset.GetLayer(0)
    return [(dict(row.items()), bytes(row.GetGeometryRef().ExportToIsoWkb())) for row in rows]


MOSAIC_ELEMENTS = """<?xml version="1.0" encoding="UTF-8"?>
<gml:FeatureCollection xmlns:gml="http://www.opengis.net/gml/3.2" xmlns:oi="http://inspire.ec.europa.eu/schemas/oi/3.0">
{}</gml:FeatureCollection>"""
MOSAIC_ELEMENT = """<gml:featureMember><oi:SingleMosaicElement gml:id="m{number}">
<oi:inspireId><Identifier><localId>part-{number}</localId><namespace>PL</namespace></Identifier></oi:inspireId>
<oi:phenomenonTime><gml:TimePeriod gml:id="t{number}"><gml:beginPosition>2016-07-0{number}</gml:beginPosition>
<gml:endPosition>2016-07-0{number}</gml:endPosition></gml:TimePeriod></oi:phenomenonTime>
<oi:geometry><gml:MultiSurface srsName="urn:ogc:def:crs:EPSG::2180" gml:id="g{number}"><gml:surfaceMember>
<gml:Polygon gml:id="p{number}"><gml:exterior><gml:LinearRing><gml:posList>{places}</gml:posList></gml:LinearRing>
</gml:exterior></gml:Polygon></gml:surfaceMember></gml:MultiSurface></oi:geometry>
<oi:imageSourceReference>{reference}</oi:imageSourceReference></oi:SingleMosaicElement></gml:featureMember>
"""


def mosaic_elements(folder: Path, references: Sequence[str]) -> Path:
    """Two halves of a mosaic of 400 x 200 m at (500000, 600000) of EPSG:2180, northing first as its authority says."""
    elements = []
    for number, reference in enumerate(references, start=1):
        x = 500000 + 200 * (number - 1)
        ring = [(x, 600000), (x + 200, 600000), (x + 200, 600200), (x, 600200), (x, 600000)]
        places = " ".join(f"{north} {east}" for east, north in ring)
        elements.append(MOSAIC_ELEMENT.format(number=number, places=places, reference=reference))
    path = folder / "mosaic_elements.gml"
    path.write_text(MOSAIC_ELEMENTS.format("".join(elements)), encoding="utf-8")
    return path


def test_mosaic_elements_of_inspire(tmp_path: Path) -> None:
    path = mosaic_elements(tmp_path, ["http://land.data.gov.uk/id/imagery/2011-5864726", "2011-5864727"])
    given = given_seams(features_of(path), Grid(500000, 600200, 0.1, 0.1, 4000, 2000))
    (seam,) = given.seams
    assert northward(seam) == ("http://land.data.gov.uk/id/imagery/2011-5864726", "2011-5864727")
    assert length(seam) == pytest.approx(200)
