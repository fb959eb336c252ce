"""What is opened, by which drivers, where a path leads, and what declares more than memory holds."""
from __future__ import annotations

import os
import re
import sqlite3
import threading
import time
import zipfile
from contextlib import closing
from pathlib import Path
from xml.sax.saxutils import escape

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery import gdal_paths, limits
from seam_inspector.plugin.imagery.documents import document_bytes, json_document
from seam_inspector.plugin.imagery.errors import RasterError
from seam_inspector.plugin.imagery.gdal_paths import holds_only_tables, is_layer_file, vrt_parts
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import OpenRaster
from seam_inspector.plugin.imagery.rasters import RasterRef

from tests.numbers.synthetic import write_raster

VRT = (
    '<VRTDataset rasterXSize="64" rasterYSize="64"><VRTRasterBand dataType="Byte" band="1">{}'
    "</VRTRasterBand></VRTDataset>"
)
SOURCE = "<SimpleSource><SourceFilename>{}</SourceFilename><SourceBand>1</SourceBand></SimpleSource>"


def refusal(path: Path | str) -> str:
    """What is said of a raster that is opened and read in another thread: it must not wait for anything."""
    said: list[str] = []

    def look() -> None:
        try:
            OpenRaster(RasterRef(str(path))).read(PixelWindow(0, 0, 8, 8))
        except RasterError as error:
            said.append(str(error))

    thread = threading.Thread(target=look, daemon=True)
    thread.start()
    thread.join(20)
    assert not thread.is_alive(), "it waits"
    return said[0]


def test_pipes_and_devices_are_not_opened(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.tif")
    for path in (tmp_path / "pipe.tif", "/dev/zero", "/proc/self/mem", "/vsistdin/"):
        assert "is a device, a pipe or memory" in refusal(path)
    for path in ("MEM:::DATAPOINTER=1,PIXELS=64,LINES=64", '<GDAL_WMS><Service name="TMS"/></GDAL_WMS>', "PG:dbname=x"):
        assert "a service or a database" in refusal(path)

def vrt(*sources: str, times: int = 0) -> str:
    """A VRT of sources; inside so many others, each of them in the name of the next one's source."""
    text = VRT.format("".join(SOURCE.format(escape(source)) for source in sources))
    return vrt(text, times=times - 1) if times else text


def packed_twice(folder: Path, inner: str) -> str:
    """A VRT in an archive in an archive, which names by its place there another one with this text."""
    with zipfile.ZipFile(folder / "inner.zip", "w") as file:
        outer = vrt("../inner.vrt").replace("<SourceFilename>", "<SourceFilename relativeToVRT='1'>")
        file.writestr("a/outer.vrt", outer)
        file.writestr("inner.vrt", inner)
    with zipfile.ZipFile(folder / "outer.zip", "w") as file:
        file.write(folder / "inner.zip", "b/inner.zip")
    return f"/vsizip/{{/vsizip/{{{folder}/outer.zip}}/b/inner.zip}}/a/outer.vrt"


def test_sound_ways_to_a_raster_stay_open(tmp_path: Path) -> None:
    pixels = np.arange(64 * 64, dtype=np.uint8).reshape(1, 64, 64)
    path = write_raster(tmp_path / "a.tif", pixels)
    with zipfile.ZipFile(tmp_path / "a.zip", "w") as file:
        file.write(path, "a.tif")
        file.writestr("a.vrt", vrt("a.tif").replace("<SourceFilename>", "<SourceFilename relativeToVRT='1'>"))
    archive = f"/vsizip/{tmp_path}/a.zip"
    inside = [f"{archive}/a.tif", f"{archive}/a.vrt", packed_twice(tmp_path, vrt(path))]
    for way in (f"vrt://{path}?bands=1", f"GTIFF_DIR:1:{path}", *inside, vrt(str(path), times=2)):
        np.testing.assert_array_equal(OpenRaster(RasterRef(way)).read(PixelWindow(0, 0, 64, 64)).bands, pixels)


@pytest.mark.parametrize(("name", "text", "driver"), [
    ("a.xml", '<GDAL_WMS><Service name="TMS"><ServerUrl>file://{pipe}</ServerUrl></Service></GDAL_WMS>', "WMS"),
    ("a.mrf", '<MRF_META><Raster><Size x="64" y="64"/><DataFile>{pipe}</DataFile></Raster></MRF_META>', "MRF"),
    ("a.ers", 'DatasetHeader Begin\n\tDataFile = "{pipe}"\nDatasetHeader End\n', "ERS"),
])  # fmt: skip
def test_formats_that_name_other_files_are_not_used(tmp_path: Path, name: str, text: str, driver: str) -> None:
    (tmp_path / name).write_text(text.format(pipe=tmp_path / "pipe"))
    assert f"is read by GDAL's driver {driver}" in refusal(tmp_path / name)


@pytest.mark.parametrize(("driver", "options"), [
    ("netCDF", []), ("Rasterlite", ["DRIVER=GTiff"]), ("HFA", []), ("ENVI", []), ("GPKG", ["TILE_FORMAT=PNG"]),
])  # fmt: skip
def test_formats_that_lead_nowhere_are_read(tmp_path: Path, driver: str, options: list[str]) -> None:
    if gdal.GetDriverByName(driver) is None:
        pytest.skip("GDAL 3.11 and newer write no Rasterlite")
    pixels = np.random.default_rng(3).integers(1, 255, (1, 64, 64), np.uint8)
    given = write_raster(tmp_path / "a.tif", pixels)
    gdal.Translate(str(tmp_path / "a.made"), given, format=driver, creationOptions=options)
    np.testing.assert_array_equal(
        OpenRaster(RasterRef(str(tmp_path / "a.made"))).read(PixelWindow(0, 0, 64, 64)).bands, pixels
    )


def test_what_an_index_names_starts_at_its_folder(tmp_path: Path) -> None:
    (tmp_path / "10:00.tif").touch()
    inside = {"a.tif": "a.tif", "b/../a.tif": "a.tif", "10:00.tif": "10:00.tif"}
    assert [gdal_paths.path_from(str(tmp_path), inner) for inner in inside] == [
        str(tmp_path / inner) for inner in inside.values()
    ]  # fmt: skip
    for whole in ("/a.tif", "D:\\a.tif", "GPKG:a.gpkg:b", "/vsicurl/http://a/b.tif", "http://a/b.tif", "vrt://a.tif"):
        assert gdal_paths.path_from(str(tmp_path), whole) == whole


@pytest.mark.parametrize("unit", ["<SourceFilename ", "<SourceFilename>a.tif</SourceFilename>", "<a>"])
def test_what_a_long_vrt_names_is_found_soon(tmp_path: Path, unit: str) -> None:
    path = tmp_path / "a.vrt"
    path.write_text(f"<VRTDataset>{unit * 100_000}</VRTDataset>")
    start = time.monotonic()
    vrt_parts(str(path))
    assert time.monotonic() - start < 5


def holding(path: Path, *statements: str) -> Path:
    with closing(sqlite3.connect(path)) as database:
        for statement in statements:
            database.execute(statement)
        database.commit()
    return path


ENDLESS = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT i AS window_id, i AS verdict FROM n"


@pytest.mark.parametrize("statement", [
    f"CREATE VIEW windows AS {ENDLESS}", "CREATE VIRTUAL TABLE windows USING fts5(a, content='b')",
])  # fmt: skip
def test_databases_that_never_end_are_not_read(tmp_path: Path, statement: str) -> None:
    sound = holding(tmp_path / "a.gpkg", "CREATE TABLE b (a, c)", "CREATE INDEX i ON b (a)")
    assert holds_only_tables(sound)
    assert not holds_only_tables(holding(sound, statement))
    assert not holds_only_tables(tmp_path)


def test_files_of_marks_are_tables_and_lead_nowhere(tmp_path: Path) -> None:
    source = f"<SrcDataSource>{tmp_path}/b.csv</SrcDataSource>"
    (tmp_path / "a.csv").write_text(f"<OGRVRTDataSource>{source}</OGRVRTDataSource>")
    (tmp_path / "b.csv").write_text("mark,x\n1,2\n")
    assert [is_layer_file(tmp_path / name) for name in ("a.csv", "b.csv")] == [False, True]


OPENING = re.compile(
    r"\b(gdal\.Open(Ex)?|gdal\.BuildVRT|ogr\.Open|sqlite3\.connect|json\.loads?|XMLParser|fromstring|minidom"
    r"|QgsVectorLayer|QgsRasterLayer|mapLayerFromString)\(|expat\.P"
)
OPENED_BY = {
    "documents.py": {"json.loads", "expat.P"}, "gdal_paths.py": {"gdal.OpenEx", "sqlite3.connect"},
    "window_layer.py": {"QgsVectorLayer"}, "outputs.py": {"mapLayerFromString"},
    "fit_files.py": {"json.loads"}, "open_raster.py": {"gdal.BuildVRT"}, "delivered_files.py": {"gdal.BuildVRT"},
    "layers.py": {"mapLayerFromString"}, "delivery_layers.py": {"mapLayerFromString", "QgsVectorLayer"},
    "mark_tables.py": {"QgsVectorLayer"}, "line_layers.py": {"QgsVectorLayer"}, "hard_cut.py": {"QgsRasterLayer"},
    "mosaic_scans.py": {"QgsVectorLayer", "QgsRasterLayer"}, "accept_page.py": {"QgsVectorLayer"},  # made by ourselves
    "sensor_parameters.py": {"QgsVectorLayer"}, "parameters.py": {"QgsRasterLayer"},  # empty ones in memory
}  # fmt: skip


def test_nobody_else_opens_data_or_reads_documents() -> None:
    """Data of others are opened by what stands in gdal_paths.py, and read by documents.py."""
    openers: dict[str, set[str]] = {}
    for module in Path(gdal_paths.__file__).parents[1].rglob("*.py"):
        for match in OPENING.finditer(module.read_text(encoding="utf-8")):
            openers.setdefault(module.name, set()).add(match.group().rstrip("("))
    assert openers == OPENED_BY


def test_vrts_in_a_ring_are_read_no_further_than_once(tmp_path: Path) -> None:
    for number in range(5):
        (tmp_path / f"{number}.vrt").write_text(VRT.format(SOURCE.format(tmp_path / f"{(number + 1) % 5}.vrt")))
    assert vrt_parts(str(tmp_path / "4.vrt")) == (str(tmp_path / "0.vrt"),)
    assert refusal(tmp_path / "0.vrt").endswith(".")


def test_blocks_beyond_all_memory_are_refused(tmp_path: Path) -> None:
    create, options = gdal.GetDriverByName("GTiff").Create, ["SPARSE_OK=TRUE", "TILED=YES", "COMPRESS=DEFLATE"]
    huge = [*options, "BLOCKXSIZE=32768", "BLOCKYSIZE=32768"]
    create(str(tmp_path / "block.tif"), 40_000, 40_000, 1, gdal.GDT_Byte, huge).FlushCache()
    assert "blocks of 32768 x 32768 px, which no memory holds" in refusal(tmp_path / "block.tif")


def test_no_more_is_read_at_once_than_memory_holds(tmp_path: Path) -> None:
    create, options = gdal.GetDriverByName("GTiff").Create, ["SPARSE_OK=TRUE", "TILED=YES", "COMPRESS=DEFLATE"]
    create(str(tmp_path / "large.tif"), 40_000, 40_000, 1, gdal.GDT_Byte, options).FlushCache()
    large = OpenRaster(RasterRef(str(tmp_path / "large.tif")))
    with pytest.raises(RasterError, match=r"40000 x 40000 px of large\.tif are too many to be read at once"):
        large.read(PixelWindow(0, 0, 40_000, 40_000))
    assert large.read(PixelWindow(0, 0, 40_000, 40_000), (10, 10)).bands.shape == (1, 10, 10)
    path = tmp_path / "endless.vrt"
    path.write_text(VRT.format("").replace('"64"', '"2147483647"'))
    assert "claims 2147483647 x 2147483647 px" in refusal(path)


@pytest.mark.parametrize("value", [1e38, -3.4e38, np.inf, np.nan])
def test_values_that_no_measurement_has_are_invalid(tmp_path: Path, value: float) -> None:
    pixels = np.full((1, 64, 64), 7, np.float32)
    pixels[0, 3, 5] = value
    block = OpenRaster(RasterRef(write_raster(tmp_path / "a.tif", pixels))).read(PixelWindow(0, 0, 64, 64))
    assert np.argwhere(~block.valid).tolist() == [[3, 5]]
    assert np.finfo(np.float32).max > limits.LARGEST_VALUE**2 * 1e6


def test_documents_have_an_end(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.json")
    for path in (tmp_path / "pipe.json", Path("/dev/zero"), Path("/proc/self/mem"), tmp_path):
        with pytest.raises(OSError, match=r"a device or a pipe|directory"):
            document_bytes(path)
    for text in ("[" * 200_000 + "]" * 200_000, "{", "[1,"):
        with pytest.raises(ValueError, match=r"nested too deeply|Expecting"):
            json_document(text)
