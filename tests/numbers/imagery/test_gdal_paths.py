"""What must not be opened: devices, pipes, memory, and VRTs that lead there; what declares more than memory holds."""
from __future__ import annotations

import os
import re
import sqlite3
import threading
import zipfile
from collections.abc import Callable
from contextlib import closing
from pathlib import Path
from typing import Any
from xml.sax.saxutils import escape

import numpy as np
import pytest
from osgeo import gdal, ogr
from seam_inspector.plugin.imagery import gdal_paths, limits
from seam_inspector.plugin.imagery.documents import document_bytes, json_document
from seam_inspector.plugin.imagery.errors import RasterError
from seam_inspector.plugin.imagery.gdal_calls import gdal_settings
from seam_inspector.plugin.imagery.gdal_paths import check_raster_path, holds_only_tables, is_layer_file, vrt_parts
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
    assert "pipe.tif is a device, a pipe or memory" in refusal(tmp_path / "pipe.tif")
    for path in ("/dev/zero", "/proc/self/mem", "/vsistdin/", "MEM:::DATAPOINTER=1,PIXELS=64,LINES=64"):
        assert "is a device, a pipe or memory" in refusal(path)


MEMORY = "MEM:::DATAPOINTER=1,PIXELS=64,LINES=64"


def zipped(path: Path, name: str, text: str) -> str:
    """The path of a text in an archive."""
    with zipfile.ZipFile(path, "w") as file:
        file.writestr(name, text)
    return f"/vsizip/{path}/{name}"


def vrt(*sources: str, times: int = 0) -> str:
    """A VRT of sources, escaped; inside so many others, each of them in the name of the next one's source."""
    text = VRT.format("".join(SOURCE.format(escape(one)) for one in sources))
    return vrt(text, times=times - 1) if times else text


@pytest.mark.parametrize("made", [
    lambda at: vrt(str(at / "pi]pe")), lambda at: vrt(str(at / "pi<pe")), lambda at: vrt(f"vrt://{at}/pipe?bands=1"),
    lambda at: vrt(str(at / "pipe"), times=1), lambda at: vrt(str(at / "pipe"), times=3),
    lambda at: vrt(MEMORY, times=2),
    lambda at: vrt("&#77;EM:::&#68;ATAPOINTER=1,PIXELS=64,LINES=64", times=1).replace("&amp;#", "&#"),
    lambda at: f'<?xml version="1.0"?><!-- a > b -->{vrt(str(at / "pipe"))}',
    lambda at: vrt(str(at / "pipe")).replace("<SourceFilename>", "<SourceFilename shared='a > b'>"),
    lambda at: vrt("pipe").replace("<SourceFilename>", "<sourcefilename RELATIVETOVRT=' 01x'>"),
    lambda at: VRT.format(f"<Overview><SourceFilename>{at}/pipe</SourceFilename></Overview>"),
    lambda at: VRT.format(f"<Metadata domain='x'><MDI key='X_DATASET'>{at}/pipe</MDI></Metadata>"),
    lambda at: VRT.format(f"<Transformer><RPCTransformer><DEMPath>{at}/pipe</DEMPath></RPCTransformer></Transformer>"),
    lambda at: vrt(zipped(at / "in.zip", "a.vrt", vrt(str(at / "pipe")))),
    lambda at: vrt(zipped(at / "in.zip", "a.vrt", vrt(MEMORY))),
    lambda at: vrt(f"/vsizip/vsigzip/{at}/pipe"), lambda at: vrt(f"/vsisubfile/0_9,{at}/pipe"),
    lambda at: vrt("/vsisparse/a"),
    lambda at: vrt(f"GTIFF_DIR:1:{at}/pipe"), lambda at: vrt(f"DERIVED_SUBDATASET:AMPLITUDE:{at}/pipe"),
    lambda at: vrt(f"/vsicurl/file://{at}/pipe"), lambda at: vrt(f"/vsicurl?url=file%3A%2F%2F{at}/pipe"),
    lambda at: vrt('<GDAL_WMS><Service name="TMS"/></GDAL_WMS>'), lambda at: vrt("PG:dbname=x"),
    lambda at: vrt('{"a": 1}'),
])  # fmt: skip
@pytest.mark.parametrize("given", ["file", "text", "zip", "vrt://"])
def test_no_vrt_leads_there_however_it_is_written(tmp_path: Path, made: Callable[[Path], str], given: str) -> None:
    """In a file, as the raster's path itself, in an archive, or by the address of a VRT."""
    for name in ("pipe", "pi]pe", "pi<pe"):
        os.mkfifo(tmp_path / name)
    text = made(tmp_path)
    path = tmp_path / "made.vrt"
    path.write_text(text)
    if given == "zip":
        text = text.replace("RELATIVETOVRT=' 01x'>", f">{tmp_path}/")
    if given == "text":
        text = text[text.index("<VRTDataset") :].replace("RELATIVETOVRT=' 01x'>", f">{tmp_path}/")
    paths = {
        "file": str(path), "text": text, "zip": zipped(tmp_path / "out.zip", "made.vrt", text), "vrt://": f"vrt://{path}"
    }  # fmt: skip
    assert "is a VRT that leads to" in refusal(paths[given])


def packed_twice(folder: Path, inner: str) -> str:
    """A VRT in an archive in an archive, which names by its place there another one with this text."""
    with zipfile.ZipFile(folder / "inner.zip", "w") as file:
        outer = vrt("../inner.vrt").replace("<SourceFilename>", "<SourceFilename relativeToVRT='1'>")
        file.writestr("a/outer.vrt", outer)
        file.writestr("inner.vrt", inner)
    with zipfile.ZipFile(folder / "outer.zip", "w") as file:
        file.write(folder / "inner.zip", "b/inner.zip")
    return f"/vsizip/{{/vsizip/{{{folder}/outer.zip}}/b/inner.zip}}/a/outer.vrt"


@pytest.mark.parametrize("is_named", [False, True])
@pytest.mark.parametrize("how", ["once", "twice"])
def test_names_by_a_place_in_an_archive_lead_nowhere(tmp_path: Path, how: str, is_named: bool) -> None:
    """Given itself, or named by a VRT."""
    os.mkfifo(tmp_path / "pipe")
    for target in (str(tmp_path / "pipe"), MEMORY):
        twice = packed_twice(tmp_path, vrt(target))
        path = twice if how == "twice" else f"/vsizip/{tmp_path}/inner.zip/a/outer.vrt"
        (tmp_path / "named.vrt").write_text(vrt(path))
        assert "is a VRT that leads to" in refusal(tmp_path / "named.vrt" if is_named else path)
    (tmp_path / "pipe").unlink()
    twice = packed_twice(tmp_path, vrt(write_raster(tmp_path / "sound.tif", np.ones((1, 64, 64), np.uint8))))
    for path in (twice, f"/vsizip/{tmp_path}/inner.zip/a/outer.vrt"):
        assert OpenRaster(RasterRef(path)).read(PixelWindow(0, 0, 64, 64)).bands.all()


def test_a_name_of_bytes_that_are_no_text_leads_nowhere(tmp_path: Path) -> None:
    pipe = os.fsencode(tmp_path) + b"/pipe\xff\xe9.tif"
    os.mkfifo(pipe)
    path = tmp_path / "made.vrt"
    path.write_bytes(vrt("NAME").encode().replace(b"NAME", pipe))
    assert "made.vrt is a VRT that leads to" in refusal(path)
    os.unlink(pipe)
    (tmp_path / "a.tif.aux.xml").write_bytes(bytes(range(1, 256)))
    OpenRaster(RasterRef(write_raster(tmp_path / "a.tif", np.zeros((1, 64, 64), np.uint8))))


def test_sound_ways_to_a_raster_stay_open(tmp_path: Path) -> None:
    pixels = np.arange(64 * 64, dtype=np.uint8).reshape(1, 64, 64)
    path = write_raster(tmp_path / "a.tif", pixels)
    with zipfile.ZipFile(tmp_path / "a.zip", "w") as file:
        file.write(path, "a.tif")
        file.writestr("a.vrt", vrt("a.tif").replace("<SourceFilename>", "<SourceFilename relativeToVRT='1'>"))
    archive = f"/vsizip/{tmp_path}/a.zip"
    inside = [f"{archive}/a.tif", f"{archive}/a.vrt"]
    for way in (f"vrt://{path}?bands=1", f"GTIFF_DIR:1:{path}", *inside, vrt(str(path), times=2)):
        np.testing.assert_array_equal(OpenRaster(RasterRef(way)).read(PixelWindow(0, 0, 64, 64)).bands, pixels)


@pytest.mark.parametrize("ending", [".ovr", ".msk", ".aux.xml"])
def test_a_pipe_beside_a_raster_is_not_opened(tmp_path: Path, ending: str) -> None:
    path = write_raster(tmp_path / "a.tif", np.zeros((1, 64, 64), np.uint8))
    os.mkfifo(f"{path}{ending}")
    assert refusal(path).startswith(f"{path}{ending} lies beside a.tif and is a device or a pipe")
    whole = tmp_path / "b.vrt"
    whole.write_text(vrt(str(path)))
    assert f"{path}{ending} lies beside b.vrt" in refusal(whole)


def imagine(at: Path, option: str, value: str, ending: str) -> Path:
    """An Erdas Imagine file whose other part is called differently, and is a pipe."""
    write_raster(at / "a.tif", np.zeros((1, 512, 512), np.uint8))
    with gdal_settings(HFA_USE_RRD="YES"):
        gdal.Translate(str(at / "a.img"), str(at / "a.tif"), format="HFA", creationOptions=[f"{option}={value}"])
        gdal.Open(str(at / "a.img"), gdal.GA_Update).BuildOverviews("NEAREST", [2])
    (at / f"a{ending}").unlink()
    (at / "a.img").write_bytes((at / "a.img").read_bytes().replace(f"a{ending}".encode(), f"b{ending}".encode()))
    os.mkfifo(at / f"b{ending}")
    return at / "a.img"


@pytest.mark.parametrize(("option", "value", "ending"), [("USE_SPILL", "YES", ".ige"), ("COMPRESSED", "NO", ".rrd")])
def test_parts_of_an_imagine_file_have_an_end(tmp_path: Path, option: str, value: str, ending: str) -> None:
    assert "is a device or a pipe" in refusal(imagine(tmp_path, option, value, ending))


@pytest.mark.parametrize("name", ["summary.txt", "METADATA.DIM", "RPC-a.txt"])
def test_metadata_of_other_names_has_an_end(tmp_path: Path, name: str) -> None:
    """GDAL's readers of satellites' metadata look for some that are not called like the image."""
    path = write_raster(tmp_path / "IMG-a.tif", np.zeros((1, 64, 64), np.uint8))
    os.mkfifo(tmp_path / name)
    assert refusal(path).startswith(f"{tmp_path / name} lies beside IMG-a.tif")


@pytest.mark.parametrize("to", [MEMORY, "{pipe}"])
@pytest.mark.parametrize("ending", [".ovr", ".OVR", ".msk", ".ovr.ovr", ".ovr.aux.xml"])
@pytest.mark.parametrize("packed", [False, True])
def test_what_lies_beside_leads_nowhere(tmp_path: Path, to: str, ending: str, packed: bool) -> None:
    """Overviews, masks and metadata may be VRTs or name others, also beside each other and in an archive."""
    pipe = tmp_path / "elsewhere" / "pipe"
    pipe.parent.mkdir()
    os.mkfifo(pipe)
    path = write_raster(tmp_path / "a.tif", np.zeros((1, 64, 64), np.uint8))
    named = to.format(pipe=pipe)
    overview = f'<Metadata domain="OVERVIEWS"><MDI key="OVERVIEW_FILE">{named}</MDI></Metadata>'
    text = f"<PAMDataset>{overview}</PAMDataset>" if ending.endswith(".xml") else vrt(named)
    between = [Path(f"{path}.ovr")] if ending.count(".") > 1 else []
    for one in between:
        write_raster(one, np.zeros((1, 32, 32), np.uint8))
    beside = Path(f"{path}{ending}")
    beside.write_text(text)
    if packed:
        with zipfile.ZipFile(tmp_path / "a.zip", "w") as file:
            for one in (path, beside, *between):
                file.write(one, Path(one).name)
    assert f"that lead to {named}" in refusal(f"/vsizip/{tmp_path}/a.zip/a.tif" if packed else path)


def test_overviews_named_inside_an_image_lead_nowhere(tmp_path: Path) -> None:
    pipe = tmp_path / "elsewhere" / "pipe"
    pipe.parent.mkdir()
    os.mkfifo(pipe)
    path = write_raster(tmp_path / "a.tif", np.zeros((1, 64, 64), np.uint8))
    gdal.Open(str(path), gdal.GA_Update).SetMetadataItem("OVERVIEW_FILE", str(pipe), "OVERVIEWS")
    assert f"that lead to {pipe}" in refusal(path)


@pytest.mark.parametrize("named", ["{pipe}", MEMORY, ":::BASE:::pipe"])
def test_auxiliary_data_name_no_overviews_that_never_end(tmp_path: Path, named: str) -> None:
    path = write_raster(tmp_path / "a.tif", np.zeros((1, 64, 64), np.uint8))
    os.mkfifo(tmp_path / "pipe")
    overview = f'<MDI key="OVERVIEW_FILE">{named.format(pipe=tmp_path / "pipe")}</MDI>'
    Path(f"{path}.aux.xml").write_text(f'<PAMDataset><Metadata domain="OVERVIEWS">{overview}</Metadata></PAMDataset>')
    assert "has metadata, overviews or a mask that lead to" in refusal(path)


@pytest.mark.parametrize(("name", "text", "driver"), [
    ("a.xml", '<GDAL_WMS><Service name="TMS"><ServerUrl>file://{pipe}</ServerUrl></Service></GDAL_WMS>', "WMS"),
    ("a.mrf", '<MRF_META><Raster><Size x="64" y="64"/><DataFile>{pipe}</DataFile></Raster></MRF_META>', "MRF"),
    ("a.ers", 'DatasetHeader Begin\n\tDataFile = "{pipe}"\nDatasetHeader End\n', "ERS"),
])  # fmt: skip
def test_formats_that_name_other_files_are_not_used(tmp_path: Path, name: str, text: str, driver: str) -> None:
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / name).write_text(text.format(pipe=tmp_path / "pipe"))
    assert f"is read by GDAL's driver {driver}" in refusal(tmp_path / name)
    (tmp_path / "b.vrt").write_text(vrt(str(tmp_path / name)))
    assert f"b.vrt is a VRT that leads to {tmp_path / name}" in refusal(tmp_path / "b.vrt")


def test_what_is_looked_at_of_a_vrt_grows_with_its_size_alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Elements that never end, many names, elements in elements: of twice the bytes twice the names."""
    steps: list[int] = []
    plain = gdal_paths._places

    def counted(*of: Any) -> Any:
        steps.append(1)
        return plain(*of)

    monkeypatch.setattr(gdal_paths, "_places", counted)
    for kind in ("<SourceFilename ", "<SourceFilename>a.tif</SourceFilename>", "<a>", "<SourceFilename>&lt;"):
        counts = []
        for times in (2000, 4000):
            path = tmp_path / f"{len(kind)}_{times}.vrt"
            path.write_text(f"<VRTDataset>{kind * times}</VRTDataset>")
            steps.clear()
            vrt_parts(str(path))
            counts.append(len(steps))
        assert counts[1] in (0, 2 * counts[0])


def test_a_vrt_of_very_many_elements_is_not_parsed(tmp_path: Path) -> None:
    path = tmp_path / "a.vrt"
    path.write_text(f"<VRTDataset>{'<a/>' * 4_000_001}</VRTDataset>")
    assert "a.vrt is a VRT of more than" in refusal(path)


def test_names_of_very_many_colons_are_no_files(tmp_path: Path) -> None:
    """Any part between two of them may be a file's name."""
    for name in ("ab:" * 1000, "GTIFF_DIR:1:" + "a:" * 1000):
        (tmp_path / "a.vrt").write_text(vrt(name).replace("<SourceFilename>", "<SourceFilename relativeToVRT='1'>"))
        assert "a.vrt is a VRT that leads to" in refusal(tmp_path / "a.vrt")


def holding(path: Path, *statements: str) -> Path:
    with closing(sqlite3.connect(path)) as database:
        for statement in statements:
            database.execute(statement)
        database.commit()
    return path


ENDLESS = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT i AS window_id, i AS verdict FROM n"


@pytest.mark.parametrize("statement", [
    f"CREATE VIEW windows AS {ENDLESS}", "CREATE VIRTUAL TABLE windows USING fts5(a, content='b')",
    f"CREATE TRIGGER a AFTER INSERT ON b BEGIN INSERT INTO b {ENDLESS.replace('AS verdict', '')}; END",
])  # fmt: skip
def test_databases_that_never_end_are_not_read(tmp_path: Path, statement: str) -> None:
    sound = holding(tmp_path / "a.gpkg", "CREATE TABLE b (a, c)", "CREATE INDEX i ON b (a)")
    assert holds_only_tables(sound)
    assert not holds_only_tables(holding(sound, statement))
    assert not holds_only_tables(tmp_path)


def test_a_geopackage_of_gdal_holds_only_tables(tmp_path: Path) -> None:
    made = gdal.GetDriverByName("GPKG").Create(str(tmp_path / "a.gpkg"), 0, 0, 0, gdal.GDT_Unknown)
    made.CreateLayer("a", geom_type=ogr.wkbPolygon)
    made = None
    assert holds_only_tables(tmp_path / "a.gpkg")
    assert is_layer_file(tmp_path / "a.gpkg")


def test_files_of_marks_are_tables_and_lead_nowhere(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    source = f"<SrcDataSource>{tmp_path}/pipe</SrcDataSource>"
    (tmp_path / "a.csv").write_text(f"<OGRVRTDataSource>{source}</OGRVRTDataSource>")
    (tmp_path / "b.csv").write_text("mark,x\n1,2\n")
    assert [is_layer_file(tmp_path / name) for name in ("a.csv", "b.csv", "pipe")] == [False, True, False]


OPENING = re.compile(
    r"\b(gdal\.Open(Ex)?|gdal\.BuildVRT|ogr\.Open|sqlite3\.connect|json\.loads?|XMLParser|fromstring|minidom"
    r"|QgsVectorLayer|QgsRasterLayer|mapLayerFromString)\(|expat\.P"
)
OPENED_BY = {
    "documents.py": {"json.loads", "expat.P"}, "gdal_paths.py": {"gdal.OpenEx", "sqlite3.connect"},
    "window_layer.py": {"sqlite3.connect", "QgsVectorLayer"},
    "keeping.py": {"sqlite3.connect"}, "outputs.py": {"sqlite3.connect", "mapLayerFromString"},
    "fit_files.py": {"json.loads"}, "open_raster.py": {"gdal.BuildVRT"}, "delivered_files.py": {"gdal.BuildVRT"},
    "layers.py": {"mapLayerFromString"}, "delivery_layers.py": {"mapLayerFromString", "QgsVectorLayer"},
    "mark_tables.py": {"QgsVectorLayer"}, "line_layers.py": {"QgsVectorLayer"}, "swiped_layer.py": {"QgsRasterLayer"},
    "mosaic_scans.py": {"QgsVectorLayer", "QgsRasterLayer"},
    "sensor_parameters.py": {"QgsVectorLayer"}, "parameters.py": {"QgsRasterLayer"},  # empty ones in memory
}  # fmt: skip


def test_nobody_else_opens_data_or_reads_documents() -> None:
    """Who does is told in gdal_paths.py, and does it by what stands there and in documents.py."""
    found: dict[str, set[str]] = {}
    for module in Path(gdal_paths.__file__).parents[1].rglob("*.py"):
        for one in OPENING.finditer(module.read_text(encoding="utf-8")):
            found.setdefault(module.name, set()).add(one.group().rstrip("("))
    assert found == OPENED_BY


@pytest.mark.parametrize("inside", [
    SOURCE.format("MEM:::DATAPOINTER=1,PIXELS=64,LINES=64"),
    SOURCE.format("&#77;em:::datapointer=1,PIXELS=64,LINES=64"),
    SOURCE.format("<![CDATA[/dev/zero]]>"), SOURCE.format("/vsistdin/"), SOURCE.format("{pipe}"),
    SOURCE.format("{inner}"), "<SourceFilename relativeToVRT='1'>pipe.tif</SourceFilename>",
])  # fmt: skip
def test_no_vrt_leads_there(tmp_path: Path, inside: str) -> None:
    os.mkfifo(tmp_path / "pipe.tif")
    inner = tmp_path / "inner.xml"  # a VRT by what it says, not by its name
    inner.write_text(VRT.format(SOURCE.format("/dev/urandom")))
    path = tmp_path / "made.vrt"
    path.write_text(VRT.format(inside.format(pipe=tmp_path / "pipe.tif", inner=inner)))
    assert "made.vrt is a VRT that leads to" in refusal(path)


def test_vrts_in_a_ring_are_read_no_further_than_once(tmp_path: Path) -> None:
    for number in range(5):
        (tmp_path / f"{number}.vrt").write_text(VRT.format(SOURCE.format(tmp_path / f"{(number + 1) % 5}.vrt")))
    assert vrt_parts(str(tmp_path / "4.vrt")) == (str(tmp_path / "0.vrt"),)
    assert refusal(tmp_path / "0.vrt").endswith(".")


@pytest.mark.parametrize(("depth", "times"), [(20, 2), (6, 10)])
def test_vrts_that_name_each_other_a_million_times_are_refused(tmp_path: Path, depth: int, times: int) -> None:
    (tmp_path / "0.tif").write_bytes(b"II*")
    inner = tmp_path / "0.tif"
    for number in range(depth):
        outer = tmp_path / f"{number}.vrt"
        outer.write_text(VRT.format(SOURCE.format(inner) * times))
        inner = outer
    with pytest.raises(RasterError, match=r"is a VRT of more than 300000 files"):
        check_raster_path(str(inner), inner.name)


def test_vrts_of_vrts_with_many_bands_name_each_file_once(tmp_path: Path) -> None:
    """Six levels of 16 bands: each band is read from one file, however often that is named."""
    (tmp_path / "0.tif").write_bytes(b"II*")
    inner = tmp_path / "0.tif"
    for number in range(6):
        outer = tmp_path / f"{number}.vrt"
        band = VRT.format(SOURCE.format(inner)).replace("<VRTDataset", "<a").replace("</VRTDataset>", "</a>")
        outer.write_text(f"<VRTDataset>{band * 16}</VRTDataset>")
        inner = outer
    check_raster_path(str(inner), inner.name)


def test_what_stays_as_it_is_is_looked_at_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A mosaic of ten thousand files is opened for every window."""
    parts = [tmp_path / f"{number}.tif" for number in range(20)]
    for part in parts:
        part.write_bytes(b"II*")
    mosaic = tmp_path / "mosaic.vrt"
    mosaic.write_text(VRT.format("".join(SOURCE.format(part) for part in parts)))
    check_raster_path(str(mosaic), "mosaic.vrt")
    with monkeypatch.context() as patch:
        for module, name in ((os.path, "realpath"), (gdal_paths, "_document")):
            patch.setattr(module, name, lambda *path: pytest.fail("it is looked at again"))
        check_raster_path(str(mosaic), "mosaic.vrt")
    parts[7].unlink()
    parts[7].symlink_to("/dev/zero")
    with pytest.raises(RasterError, match=r"mosaic\.vrt is a VRT that leads to .*7\.tif"):
        check_raster_path(str(mosaic), "mosaic.vrt")


def test_a_part_that_changed_is_looked_at_though_its_size_and_time_are_as_before(tmp_path: Path) -> None:
    mosaic, inner = tmp_path / "mosaic.vrt", tmp_path / "inner.vrt"
    mosaic.write_text(VRT.format(SOURCE.format(inner)))
    inner.write_text(VRT.format(SOURCE.format("/old/null")))
    before = inner.stat()
    check_raster_path(str(mosaic), "mosaic.vrt")
    inner.write_text(VRT.format(SOURCE.format("/dev/null")))
    os.utime(inner, ns=(before.st_atime_ns, before.st_mtime_ns))
    with pytest.raises(RasterError, match="leads to /dev/null"):
        check_raster_path(str(mosaic), "mosaic.vrt")


def test_bands_and_blocks_beyond_all_memory_are_refused(tmp_path: Path) -> None:
    create, options = gdal.GetDriverByName("GTiff").Create, ["SPARSE_OK=TRUE", "TILED=YES", "COMPRESS=DEFLATE"]
    huge = [*options, "BLOCKXSIZE=32768", "BLOCKYSIZE=32768"]
    create(str(tmp_path / "block.tif"), 40_000, 40_000, 1, gdal.GDT_Byte, huge).FlushCache()
    assert "blocks of 32768 x 32768 px, which are too large" in refusal(tmp_path / "block.tif")
    create(str(tmp_path / "bands.tif"), 64, 64, 2000, gdal.GDT_Byte, options).FlushCache()
    assert "has 2000 bands and 1024 are the most" in refusal(tmp_path / "bands.tif")


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
