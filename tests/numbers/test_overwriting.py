"""Nothing that is written from Python takes the place of an input: every function that writes, every name of a file."""
from __future__ import annotations

import ast
import dataclasses
import inspect
import os
import re
import shutil
import warnings
import zipfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any
from xml.sax.saxutils import escape, unescape

import numpy as np
import pytest
import seam_inspector
from osgeo import gdal
from seam_inspector import MendSettings, ScanResult, SeamInspectorError, mend, open_block, scan, write_scan
from seam_inspector.plugin.imagery.file_identity import DataPlace, check_outputs, refuse_overwriting
from seam_inspector.plugin.imagery.open_raster import describe
from seam_inspector.plugin.imagery.raster_writer import WrittenBands, raster_writer
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure.mending.mending import MendRequest, mending
from seam_inspector.plugin.seams.measure.source_images import Source
from seam_inspector.plugin.sensors.measure.orthorectification import OrthoRequest, orthorectify

from tests.made_once import the_small_block
from tests.numbers.disks import names_of
from tests.numbers.synthetic import write_raster
from tools import python_pages

BELONGS = "which belongs to an input; choose another file"
READ = {
    "open_block mosaic", "open_block sources", "open_block cells", "open_block neighbours", "scan seamlines",
    "load_acceptance_rules path", "mend seams", "decide sheets", "decide mosaics",
}  # fmt: skip
"""Paths that the interface takes to read, or tells."""
WORDS = {
    "AcceptanceRules.limit check", "AcceptanceRules.rule check", "clip_curves wavelet", "measure_noise names",
    "measure_noise wavelet", "mend which", "Message.worded fill", "Message.worded translate",
}  # fmt: skip
"""Texts that are no paths."""


def texts_and_paths() -> Iterator[str]:
    """Each function, method or field of the interface with what it takes that may name a file."""
    for entry in python_pages.entries():
        named = getattr(seam_inspector, entry.name)
        if isinstance(entry.node, ast.FunctionDef):
            yield from taken(entry.name, named)
            continue
        for member in dataclasses.fields(named) if dataclasses.is_dataclass(named) else ():
            if re.search(r"Path|\bIO\b", str(member.type)):
                yield f"{entry.name} {member.name}"
        for name, member in vars(named).items():
            method = getattr(member, "__func__", member)
            if not name.startswith("_") and inspect.isfunction(method):
                yield from taken(f"{entry.name}.{name}", method)


def taken(name: str, function: Callable[..., Any]) -> Iterator[str]:
    for parameter in inspect.signature(function).parameters.values():
        if re.search(r"Path|\bstr\b|\bIO\b", str(parameter.annotation)):
            yield f"{name} {parameter.name}"


@dataclasses.dataclass(frozen=True)
class Writer:
    """A function that writes, with inputs of its own."""

    inputs: tuple[Path, ...]
    write: Callable[[str], object]


def of_scan(folder: Path, factory: pytest.TempPathFactory) -> Writer:
    """One of the orthoimages is a copy of the mosaic, which the block leaves out."""
    for path in the_small_block(factory).mosaic.parent.iterdir():
        shutil.copy(path, folder)
    copy = Path(shutil.copy(folder / "mosaic.tif", folder / "sheet.tif"))
    sources, lines = sorted(folder.glob("strip*.tif")), f"{folder}/seamlines.gpkg|layername="
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        block = open_block(folder / "mosaic.tif", [*sources, copy], f"{lines}cells")
    inputs = (folder / "mosaic.tif", sources[-1], copy, folder / "seamlines.gpkg")
    return Writer(inputs, lambda path: scan(block, seamlines=f"{lines}seamlines", loss=path))


def of_results(folder: Path, factory: pytest.TempPathFactory) -> Writer:
    """What is made of a scan: its GeoPackage and the mended mosaic."""
    given = of_scan(folder, factory)
    block, seams = open_block(given.inputs[0], sorted(folder.glob("strip*.tif"))), str(given.inputs[-1])
    result = ScanResult((), (), (), told={"seamlines_file": seams})

    def write(output: str) -> None:
        calls = [lambda: write_scan(output, result, block), lambda: mend(block, seams, output)]
        for call in calls:
            with pytest.raises(SeamInspectorError, match=BELONGS) as raised:
                call()
        raise raised.value

    inputs = [path for path in given.inputs if path.name != "sheet.tif"]
    return Writer(tuple(inputs), write)


def of_orthorectify(folder: Path, _: pytest.TempPathFactory) -> Writer:
    paths = [write_raster(folder / f"{name}.tif", np.full((8, 8), 9, np.uint8)) for name in ("image", "part", "dem")]
    nothing: Any = None  # what is not looked at before
    image, dem = RasterRef(paths[0], parts=(paths[1],)), RasterRef(paths[2])
    return Writer(tuple(map(Path, paths)), lambda path: orthorectify(
        OrthoRequest(image, nothing, "", nothing, dem, "ellipsoid", None, Path(path))
    ))  # fmt: skip


def of_raster_writer(folder: Path, _: pytest.TempPathFactory) -> Writer:
    """What the product writes pixel by pixel: enhanced photos, what a Bayer camera saw, orthoimages of photos."""
    path = write_raster(folder / "image.tif", np.full((8, 8), 9, np.uint8))

    def write(output: str) -> None:
        with raster_writer(output, describe(RasterRef(path)), WrittenBands(1, np.dtype(np.uint8))) as writer:
            writer.write(0, np.zeros((1, 8, 8), np.uint8))

    return Writer((Path(path),), write)


def of_mending(folder: Path, _: pytest.TempPathFactory) -> Writer:
    (folder / "patches").mkdir()
    mosaic = write_raster(folder / "mosaic.tif", np.full((8, 8), 9, np.uint8))
    source = write_raster(folder / "patches" / "patch_0001.tif", np.full((8, 8), 9, np.uint8))  # of another mending
    given = Source(RasterRef(source), describe(RasterRef(source)).extent)
    request = MendRequest(describe(RasterRef(mosaic)), (given,), (), MendSettings())

    def write(output: str) -> None:
        pairs = [(f"{folder}/made", output), (f"{folder}/patches", f"{folder}/new.vrt")]
        for patches, mended in pairs:
            with pytest.raises(SeamInspectorError, match=BELONGS) as raised, mending(request, patches, mended):
                pass
        raise raised.value

    return Writer((Path(mosaic), Path(source)), write)


WRITTEN = {"scan loss": of_scan, **dict.fromkeys(("write_scan path", "mend mended", "mend patches"), of_results)}
WRITERS = {
    "scan loss": of_scan, "results": of_results, "orthorectify": of_orthorectify, "raster_writer": of_raster_writer,
    "mending": of_mending,
}  # fmt: skip


def test_every_path_of_the_interface_is_known_as_read_or_written() -> None:
    """One that is written belongs to ``WRITTEN``: the tests below then hold what is done with it."""
    assert set(texts_and_paths()) == READ | WORDS | WRITTEN.keys()


@pytest.fixture(params=[pytest.param("scan loss", marks=pytest.mark.slow), *sorted(WRITERS.keys() - {"scan loss"})])
def writer(request: pytest.FixtureRequest, tmp_path: Path, tmp_path_factory: pytest.TempPathFactory) -> Writer:
    return WRITERS[request.param](tmp_path, tmp_path_factory)


@pytest.mark.slow
def test_nothing_takes_the_place_of_an_input(writer: Writer) -> None:
    for path in writer.inputs:
        before = path.read_bytes()
        for name in names_of(path):
            with pytest.raises(SeamInspectorError, match=BELONGS):
                writer.write(name)
            assert path.read_bytes() == before


def test_a_name_that_cannot_be_written_is_refused_before_anything_is_measured(
    tmp_path: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    mosaic = the_small_block(tmp_path_factory).mosaic
    block, result = open_block(mosaic), ScanResult((), (), ())

    def measured(share: float) -> None:
        raise AssertionError(share)

    for write, ending in (
        (lambda path: write_scan(path, result, block), ".gpkg"),
        (lambda path: scan(block, loss=path, progress=measured), ".tif"),
        (lambda path: mend(block, tmp_path / "none.gpkg", path, progress=measured), ".vrt"),
    ):  # fmt: skip
        (folder := tmp_path / f"folder{ending}").mkdir(exist_ok=True)
        (foreign := tmp_path / f"foreign{ending}").write_text("mine")
        replaced = [str(foreign)] if ending in (".gpkg", ".tif") else []
        for path in (str(folder), " ", "/dev/null", f"{tmp_path}/none/a{ending}", f"{tmp_path}/a.other", *replaced):
            with pytest.raises(SeamInspectorError, match=r"can't be written|not a file|that ending|holds other data"):
                write(path)
        assert foreign.read_text() == "mine"


@pytest.mark.slow
def test_a_scan_is_written_over_a_scan_and_no_other_layers(
    tmp_path: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    mosaic = the_small_block(tmp_path_factory).mosaic
    block = open_block(mosaic, sorted(mosaic.parent.glob("strip*.tif")))
    result, path, loss = scan(block), tmp_path / "seams.gpkg", tmp_path / "loss.tif"
    for _ in range(2):
        write_scan(path, result, block)
        scan(block, loss=loss)
    gdal.VectorTranslate(str(path), str(path), accessMode="update", layers=["seams"], layerName="mine")
    shutil.copy(block.mosaic.ref.path, loss)
    for write in (lambda: write_scan(path, result, block), lambda: scan(block, loss=loss)):
        with pytest.raises(SeamInspectorError, match="holds other data"):
            write()
    assert gdal.OpenEx(str(path)).GetLayerByName("mine") is not None


@pytest.fixture
def image(tmp_path: Path) -> Path:
    return Path(write_raster(tmp_path / "image.tif", np.full((16, 16), 9, np.uint8)))


def refused(output: object, *inputs: object) -> bool:
    try:
        refuse_overwriting({"loss": str(output)}, map(str, inputs))
    except SeamInspectorError as error:
        return "'loss' would be written over" in str(error)
    return False


def test_what_virtual_rasters_are_made_of_belongs_to_them(image: Path, tmp_path: Path) -> None:
    inner, outer = str(tmp_path / "inner.vrt"), str(tmp_path / "outer.vrt")
    gdal.BuildVRT(inner, [str(image)]).FlushCache()
    gdal.BuildVRT(outer, [inner]).FlushCache()
    inline = Path(inner).read_text("utf-8").replace('relativeToVRT="1">', f'relativeToVRT="0">{tmp_path}/')
    for given in (outer, f"vrt://{outer}?bands=1", inline):
        assert refused(image, given)
    assert refused(inner, outer)
    assert not refused(outer, inner)


SOURCE = "<SourceFilename>{}</SourceFilename>"
VRT = f'<VRTDataset rasterXSize="16" rasterYSize="16">{SOURCE}</VRTDataset>'
RELATIVE = VRT.replace("<SourceFilename", "<SourceFilename RelativeToVRT='1'")


def zipped(folder: Path, name: str, text: str) -> str:
    """The path of a text in an archive."""
    with zipfile.ZipFile(folder / f"{name}.zip", "w") as file:
        file.writestr(name, text)
    return f"/vsizip/{folder}/{name}.zip/{name}"


@pytest.mark.parametrize("write", [
    lambda name, at: VRT.format(name), lambda name, at: VRT.format(escape(VRT.format(name))),
    lambda name, at: VRT.format(f"<![CDATA[{unescape(name)}]]>"), lambda name, at: VRT.format(f"&#47;{name[1:]}"),
    lambda name, at: VRT.format(f"vrt://{name}?bands=1"), lambda name, at: VRT.format(f"GTIFF_DIR:1:{name}"),
    lambda name, at: VRT.format(f"/vsisubfile/0_9,{name}"), lambda name, at: VRT.format(f"\n  {name}"),
    lambda name, at: VRT.format(name).replace("<SourceFilename>", "<sourcefilename SHARED = '0'>"),
    lambda name, at: VRT.format(f"<Metadata domain='x'><MDI key='X_DATASET'>{name}</MDI></Metadata>"),
    lambda name, at: VRT.format(f"<Transformer><DEMPath>{name}</DEMPath></Transformer>"),
    lambda name, at: VRT.format(zipped(at, "inner.vrt", VRT.format(name))),
    lambda name, at: RELATIVE.format(name.rpartition("/")[2]),
    lambda name, at: RELATIVE.format("GTIFF_DIR:1:" + name.rpartition("/")[2]),
])  # fmt: skip
@pytest.mark.parametrize("given", ["file", "text", "vrt://", "zip"])
def test_what_a_vrt_names_belongs_to_it_however_it_is_written(
    tmp_path: Path, write: Callable[[str, Path], str], given: str
) -> None:
    image = Path(write_raster(tmp_path / "a]& b.tif", np.full((16, 16), 9, np.uint8)))
    text, path = write(escape(str(image)), tmp_path), tmp_path / "made.vrt"
    if "'1'" in text and given in ("text", "zip"):
        return  # has no folder, or another one
    path.write_text(text)
    assert refused(image, {
        "file": str(path), "text": text, "vrt://": f"vrt://{path}", "zip": zipped(tmp_path, "made", text)
    }[given])  # fmt: skip


def test_a_name_of_bytes_that_are_no_text_belongs_to_its_vrt(tmp_path: Path) -> None:
    image = os.fsencode(tmp_path) + b"/a\xff\xe9.tif"
    Path(os.fsdecode(image)).write_bytes(b"II*")
    (tmp_path / "made.vrt").write_bytes(VRT.encode().replace(b"{}", image))
    assert refused(os.fsdecode(image), tmp_path / "made.vrt")


def test_an_archive_is_the_file_of_what_lies_in_it(image: Path, tmp_path: Path) -> None:
    archive = shutil.make_archive(str(tmp_path / "packed"), "zip", image.parent, image.name)
    for given in (f"/vsizip/{archive}/image.tif", f"/vsizip/{{{archive}}}/image.tif"):
        assert refused(archive, given)
    assert refused(image, f"/vsisubfile/0_100,{image}")
    with pytest.raises(SeamInspectorError, match="is not a file on a disk"):
        refuse_overwriting({"loss": f"/vsizip/{archive}/loss.tif"}, ())


def test_a_table_of_a_database_is_a_part_of_its_file(image: Path, tmp_path: Path) -> None:
    path = str(tmp_path / "all.gpkg")
    gdal.Translate(path, str(image), format="GPKG", creationOptions=["RASTER_TABLE=photo"])
    given = f"GPKG:{path}:photo"
    assert gdal.Open(given) is not None
    assert refused(path, given)
    for table, meets in (("photo", True), ("others", False)):
        outputs = [("table", DataPlace(path, table))]
        if meets:
            with pytest.raises(SeamInspectorError, match=BELONGS):
                check_outputs(outputs, [DataPlace(given)])
        else:
            check_outputs(outputs, [DataPlace(given)])
    assert refused(image, f"GTIFF_DIR:1:{image}")


def test_what_goes_with_an_older_raster_is_kept_where_it_is_an_input(tmp_path: Path, image: Path) -> None:
    overviews = Path(shutil.copy(image, tmp_path / "older.tif.ovr"))
    assert refused(tmp_path / "older.tif", overviews)


def test_older_results_and_others_beside_an_input_may_be_replaced(image: Path, tmp_path: Path) -> None:
    older = shutil.copy(image, tmp_path / "older.tif")
    for output in (older, tmp_path / "image_2.tif", tmp_path / "image.html", tmp_path / "image_rpc.txt"):
        assert not refused(output, image)
