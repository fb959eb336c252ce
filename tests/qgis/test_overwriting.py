"""No algorithm writes over one of its inputs: every output of every algorithm, and every name that a file can have."""
from __future__ import annotations

import gc
import shutil
from pathlib import Path
from types import FrameType

import numpy as np
import pytest
from osgeo import gdal, ogr
from qgis.core import (
    QgsProcessingFeatureSourceDefinition,
    QgsProcessingOutputLayerDefinition,
    QgsProject,
    QgsProperty,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import QUrl
from seam_inspector.plugin.imagery import file_identity

from tests.numbers.disks import names_of
from tests.numbers.synthetic import write_raster
from tests.qgis.runs import algorithm, assert_refused, assert_sentence, run, run_unchecked
from tests.qgis.scenes import SHARP, Scene, layer, line, saved, windows

pytestmark = pytest.mark.usefixtures("provider")

REFUSED = "which belongs to an input; choose another file"


def test_what_is_refused_holds_nothing_that_qgis_deletes(tmp_path: Path) -> None:
    """QGIS keeps what an algorithm raises; parameters of a model in its frames made the next one crash."""
    path = write_raster(tmp_path / "image.tif", np.full((8, 8), 9, np.uint8))
    for name, values in (("inspect_mosaic", {"mosaic": path}), ("simulatebayer", {"RASTER": path})):
        job = algorithm(name)
        output = job.destinationParameterDefinitions()[0].name()
        assert_sentence(run_unchecked(name, **values, **{output: path}).complaint, REFUSED)
        gc.collect()
        frames = [item for item in gc.get_objects() if isinstance(item, FrameType)]
        assert not [frame for frame in frames if frame.f_code is file_identity.check_outputs.__code__]


# --- the names of a file -----------------------------------------------------------------------------------------


@pytest.fixture
def image(tmp_path: Path) -> Path:
    """A raster that is its algorithm's only input, with files beside it."""
    path = Path(write_raster(tmp_path / "image.tif", np.full((3, 16, 16), 9, np.uint8)))
    (tmp_path / "image.tfw").write_text("0.1\n0\n0\n-0.1\n400000\n5800000\n")
    (tmp_path / "image.tif.aux.xml").write_text("<PAMDataset/>")
    return path


def test_a_file_is_known_by_every_name(image: Path) -> None:
    before = image.read_bytes()
    for name in names_of(image):
        for output in (name, QgsProperty.fromExpression(f"'{name}'"), QgsProcessingOutputLayerDefinition(name)):
            assert_refused("simulatebayer", REFUSED, RASTER=str(image), OUTPUT=output)
        assert_refused("enhancephoto", REFUSED, PHOTO=name, OUTPUT=str(image))
    assert image.read_bytes() == before


def test_the_sources_of_an_index_are_kept(scene: Scene, tmp_path: Path) -> None:
    for path in (scene.west, scene.east):
        shutil.copy(path, tmp_path / path.name)
    locations = ("string", ["west.tif", "east.tif"])
    made = saved(windows(SHARP, SHARP, location=locations), tmp_path / "index.gpkg")
    given = {"WINDOWS": windows(SHARP), "SOURCE_INDEX": made}
    for name in ("west.tif", "east.tif", "index.gpkg"):
        before = (tmp_path / name).read_bytes()
        assert_refused("report", REFUSED, **given, OUTPUT=str(tmp_path / name))
        assert (tmp_path / name).read_bytes() == before


# --- tables ------------------------------------------------------------------------------------------------------


def observations(path: Path) -> str:
    passes = {"height": ("double", [3000.0, 3100.0]), "grd": ("double", [33.0, 35.0])}
    return saved(layer("NoGeometry", [None] * 2, **passes), path)


@pytest.fixture
def database(tmp_path: Path) -> str:
    """A GeoPackage with two tables, ``passes`` and ``others``."""
    path = tmp_path / "all.gpkg"
    for number, name in enumerate(("passes", "others")):
        single = observations(tmp_path / f"{name}.gpkg")
        how = {"accessMode": "append"} if number else {}
        gdal.VectorTranslate(str(path), single, format="GPKG", layerName=name, **how)
    return str(path)


def test_a_table_may_join_its_input_in_a_geopackage(database: str) -> None:
    given = {"OBSERVATIONS": f"{database}|layername=passes"}
    outcome = run("minimumheight", OUTPUT=f"ogr:dbname='{database}' table=\"heights\"", **given)
    assert outcome.complaint is None
    assert QgsVectorLayer(given["OBSERVATIONS"], "passes", "ogr").featureCount() == 2
    assert QgsVectorLayer(f"{database}|layername=heights", "heights", "ogr").featureCount() == 1
    first = run("minimumheight", OBSERVATIONS=database, OUTPUT=f"ogr:dbname='{database}' table=\"others\"")
    assert first.complaint is None  # the first table is read where none is named


def test_a_table_never_takes_the_place_of_its_input(database: str, project: QgsProject) -> None:
    shown = QgsVectorLayer(f"{database}|layername=passes", "shown", "ogr")
    project.addMapLayer(shown)
    selected = QgsProcessingFeatureSourceDefinition(shown.id(), True)
    for given in (f"{database}|layername=passes", f"{database}|layerid=0", database, shown, shown.id(), selected):
        for output in (f"ogr:dbname='{database}' table=\"passes\"", database, database.removesuffix(".gpkg")):
            assert_refused("minimumheight", REFUSED, OBSERVATIONS=given, OUTPUT=output)
    assert shown.featureCount() == 2


def test_the_parts_of_a_shapefile_are_kept(tmp_path: Path) -> None:
    table = str(tmp_path / "passes.dbf")
    gdal.VectorTranslate(table, observations(tmp_path / "made.gpkg"), format="ESRI Shapefile")
    assert_refused("minimumheight", REFUSED, OBSERVATIONS=table, OUTPUT=str(tmp_path / "passes.shp"))
    lines = saved(layer("LineString", [line((0, 0), (9, 9))]), tmp_path / "lines.shp")
    image = write_raster(tmp_path / "image.tif", np.full((8, 8), 9, np.uint8))
    for ending in (".shp", ".dbf", ".prj"):
        output = str(Path(lines).with_suffix(ending))
        assert_refused("measureresolution", REFUSED, RASTER=image, GROUPS=lines, REPORT=output)


def test_delimited_text_is_a_file_too(tmp_path: Path) -> None:
    path = tmp_path / "passes.csv"
    path.write_text("height,grd\n3000,33\n", encoding="utf-8")
    for given in (str(path), f"delimitedtext://file://{path}?type=csv"):
        assert_refused("minimumheight", REFUSED, OBSERVATIONS=given, OUTPUT=str(path))
    assert path.read_text(encoding="utf-8") == "height,grd\n3000,33\n"


# --- several outputs ---------------------------------------------------------------------------------------------


def test_two_outputs_are_two_files(tmp_path: Path) -> None:
    given = {"OBSERVATIONS": observations(tmp_path / "passes.gpkg")}
    same = "written to the same file"
    both = {"OUTPUT": str(tmp_path / "a.csv"), "HEIGHTS": str(tmp_path / "." / "a.csv")}
    assert_refused("minimumheight", same, **given, **both)
    both = {"OUTPUT": str(tmp_path / "a.shp"), "HEIGHTS": str(tmp_path / "a.dbf")}
    assert_refused("minimumheight", same, **given, **both)
    tables = [f"ogr:dbname='{tmp_path / 'made.gpkg'}' table=\"{name}\"" for name in ("one", "two")]
    assert_refused("minimumheight", same, **given, OUTPUT=tables[0], HEIGHTS=tables[0])
    assert run("minimumheight", **given, OUTPUT=tables[0], HEIGHTS=tables[1]).complaint is None


def seamlines_file(folder: Path) -> Path:
    """A GeoPackage with a line."""
    path = folder / "seam.gpkg"
    dataset = gdal.GetDriverByName("GPKG").Create(str(path), 0, 0, 0, gdal.GDT_Unknown)
    lines = dataset.CreateLayer("seamlines", geom_type=ogr.wkbLineString)
    feature = ogr.Feature(lines.GetLayerDefn())
    feature.SetGeometry(ogr.CreateGeometryFromWkt("LINESTRING (400000 5799999, 400001 5799999)"))
    lines.CreateFeature(feature)
    del feature, lines, dataset
    return path


def test_the_layers_of_a_virtual_dataset_are_kept(image: Path, tmp_path: Path) -> None:
    seam, virtual = seamlines_file(tmp_path), tmp_path / "lines.vrt"
    for source in (f'<SrcDataSource relativeToVRT="1">{seam.name}<', f"<SrcDataSource>{seam}<"):
        layer = f'<OGRVRTLayer name="seamlines">{source}/SrcDataSource></OGRVRTLayer>'
        virtual.write_text(f"<OGRVRTDataSource>{layer}</OGRVRTDataSource>")
        given = {"SEAMLINES": str(virtual), "MOSAIC": str(image), "SIDE": 7}
        assert_refused("placewindows", REFUSED, **given, OUTPUT=str(seam))
        assert_refused("placewindows", REFUSED, **given, OUTPUT=str(virtual))


def test_the_layers_of_a_query_are_kept(image: Path, tmp_path: Path, project: QgsProject) -> None:
    seam = seamlines_file(tmp_path)
    lines = QgsVectorLayer(str(seam), "lines", "ogr")
    project.addMapLayer(lines)
    by_name, by_id = (f'?query=select * from "{name}"' for name in (lines.name(), lines.id()))
    brought_along = f"?layer=ogr:{QUrl.toPercentEncoding(str(seam)).data().decode()}:s:UTF-8&query=select * from s"
    for address in (by_name, by_id, brought_along):
        queried = QgsVectorLayer(address.replace(" ", "%20"), "queried", "virtual")
        assert queried.isValid()
        assert_refused("placewindows", REFUSED, SEAMLINES=queried, MOSAIC=str(image), SIDE=7, OUTPUT=str(seam))
