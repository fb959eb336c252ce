"""Files of ours: their reference system, their values, and what is refused."""
from __future__ import annotations

import sqlite3
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import pytest
from osgeo import gdal
from qgis.core import NULL, QgsCoordinateReferenceSystem, QgsGeometry, QgsVectorLayer, QgsWkbTypes
from seam_inspector.plugin.imagery.errors import WindowLayerError
from seam_inspector.plugin.imagery.reference_systems import same_system
from seam_inspector.plugin.toolkit.geopackages import write_table
from seam_inspector.plugin.toolkit.table_fields import feature, table_fields

from tests.numbers.synthetic import UTM33, wkt
from tests.qgis.emptied import emptied_system
from tests.qgis.runs import assert_sentence

pytestmark = pytest.mark.usefixtures("qgis_app")

FIELDS = table_fields(("number", "integer"), ("share", "real"), ("word", "text"))
LINE = QgsWkbTypes.Type.LineString
SYSTEMS = [UTM33, 2180, 4326, 5514, "ESRI:102003", "+proj=lcc +lat_1=50 +lat_2=52 +lon_0=19.1 +ellps=bessel +type=crs"]


@pytest.fixture(autouse=True)
def _forgotten() -> Iterator[None]:
    """What was emptied is of one test."""
    yield
    QgsCoordinateReferenceSystem.invalidateCache()


def system_in(path: Path) -> str:
    dataset = gdal.OpenEx(str(path))
    return str(dataset.GetLayer(0).GetSpatialRef().ExportToWkt(["FORMAT=WKT2_2019"]))


@pytest.mark.parametrize("system", SYSTEMS)
def test_a_file_has_its_system_whatever_qgis_knows_of_it(tmp_path: Path, system: str | int) -> None:
    """QGIS's writer would leave it out where a thread that asked for it first has ended."""
    path, text = tmp_path / "a.gpkg", wkt(system)
    emptied_system(text)
    assert write_table(path, "lines", FIELDS, LINE, text) is None
    assert same_system(text, system_in(path))


def test_tables_and_values_are_as_they_were_given(tmp_path: Path) -> None:
    path = tmp_path / "a.gpkg"
    rows = [
        feature(FIELDS, [1, 0.1, "zażółć"], QgsGeometry.fromWkt("LINESTRING(0 0, 1 2)")),
        feature(FIELDS, [NULL, None, ""]),
    ]
    for name in ("first", "second"):
        assert write_table(path, name, FIELDS, LINE, wkt(UTM33), rows) is None
    layer = QgsVectorLayer(f"{path}|layername=second", "second", "ogr")
    assert layer.fields().names() == ["fid", "number", "share", "word"]
    item, other = layer.getFeatures()
    assert item.attributes()[1:] == [1, 0.1, "zażółć"]
    assert item.geometry().asWkt() == "LineString (0 0, 1 2)"
    assert other.attributes()[1:] == [NULL, NULL, ""]
    assert not other.hasGeometry()
    assert QgsVectorLayer(f"{path}|layername=first", "first", "ogr").featureCount() == 2


def test_another_system_in_the_file_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "a.gpkg"
    assert write_table(path, "first", FIELDS, LINE, wkt(UTM33)) is None
    with closing(sqlite3.connect(path)) as database, database:
        database.execute(
            "CREATE TRIGGER other AFTER INSERT ON gpkg_geometry_columns BEGIN"
            " UPDATE gpkg_geometry_columns SET srs_id = 0 WHERE table_name = NEW.table_name; END"
        )
    with pytest.raises(WindowLayerError) as raised:
        write_table(path, "second", FIELDS, LINE, wkt(UTM33))
    assert_sentence(str(raised.value), path.name)


def test_a_new_file_with_another_system_is_not_left(tmp_path: Path) -> None:
    with pytest.raises(WindowLayerError) as raised:
        write_table(tmp_path / "a.gpkg", "lines", FIELDS, LINE, "nothing that means any")
    assert_sentence(str(raised.value), "a.gpkg")
    assert not list(tmp_path.iterdir())
