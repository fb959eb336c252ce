"""The Python interface: what ``from seam_inspector import ...`` gives, and what the guide says of it."""
from __future__ import annotations

import ast
import inspect
import json
import math
import pickle
import re
import shutil
import subprocess
import sys
import warnings
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import seam_inspector
from osgeo import gdal, ogr, osr
from seam_inspector import (
    Block,
    InspectionSettings,
    RasterError,
    ScanResult,
    ScanSettings,
    SeamInspectorError,
    SeamInspectorWarning,
    SettingsError,
    limit_rules,
    mend,
    open_block,
    scan,
    seam_rows,
    window_rows,
    write_scan,
)
from seam_inspector.plugin.acceptance.measure.deciding import decide
from seam_inspector.plugin.acceptance.measure.delivered_rows import make_delivery
from seam_inspector.python import command_line

from tests.made_once import the_small_block
from tests.numbers.disks import full_disk
from tools import python_pages

LOADED = """
import json, sys
import seam_inspector
before = sorted(sys.modules)
from seam_inspector import *
import seam_inspector.python.command_line
names = sorted({*globals()} - {"json", "sys", "seam_inspector", "before"})
json.dump([names, before, sorted(sys.modules)], sys.stdout)
"""
HEAVY = {"numpy", "scipy", "pywt", "osgeo"}
NEVER = {"qgis", "PyQt5", "PyQt6", "matplotlib", "pandas"}
EMPTY = ScanResult((), (), ())
METRES = 'LOCAL_CS["here",UNIT["metre",1]]'


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A generated block of 120 x 100 m."""
    return the_small_block(tmp_path_factory).mosaic.parent


@pytest.fixture(scope="module")
def block(folder: Path) -> Block:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        return open_block(folder / "mosaic.tif", sorted(folder.glob("strip*.tif")))


@pytest.fixture(scope="module")
def scanned(block: Block) -> ScanResult:
    return scan(block)


@pytest.mark.slow
def test_importing_costs_nothing_and_no_name_brings_qgis() -> None:
    run = subprocess.run([sys.executable, "-c", LOADED], capture_output=True, text=True, check=True)
    names, before, after = json.loads(run.stdout)
    assert not (HEAVY | NEVER) & {name.partition(".")[0] for name in before}
    assert not NEVER & {name.partition(".")[0] for name in after}
    public = [name for name in names if not name.startswith("_")]
    assert public == sorted(seam_inspector.__all__)
    assert public == [name for name in dir(seam_inspector) if not name.startswith("_")]
    assert {entry.name for entry in python_pages.entries()} == {*public}


@pytest.mark.parametrize("entry", python_pages.entries(), ids=lambda entry: entry.name)
def test_a_name_is_typed_and_documented(entry: python_pages.Entry) -> None:
    assert getattr(seam_inspector, entry.name).__name__ == entry.name
    assert entry.line.endswith(".")
    assert python_pages.example(entry.name)
    if isinstance(entry.node, ast.FunctionDef):
        signature = inspect.signature(getattr(seam_inspector, entry.name))
        assert signature.return_annotation is not inspect.Signature.empty
        assert all(parameter.annotation is not inspect.Parameter.empty for parameter in signature.parameters.values())
    else:
        assert [called for called, _, words in python_pages.members(entry) if not words and entry.name != "Cause"] == []


def test_all_types_that_the_reference_names_can_be_imported() -> None:
    page = python_pages.REFERENCE.read_text("utf-8")
    types = re.findall(r"^\| `.*?` \| `(.*?)` \|", page, re.MULTILINE)
    signatures = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    assert not python_pages.unnamed_types() & {*re.findall(r"\w+", " ".join([*types, *signatures]))}


def test_the_reference_and_the_notebook_are_made_anew() -> None:
    """`make help-pages` makes them."""
    assert python_pages.REFERENCE.read_text("utf-8") == python_pages.reference()
    assert python_pages.NOTEBOOK.read_text("utf-8") == python_pages.notebook()


def test_the_first_steps_agree_with_themselves() -> None:
    """What failed in the scan is what the decision counts, and a window's worst piece is what the window tells by its
    seam or by its ratio."""
    *_, scanned, _, decided = ([float(number) for number in re.findall(r"\d+(?:\.\d+)?", text)]
                                   for text in python_pages.printed())  # fmt: skip
    (_, failed), (counted, measured, longest) = scanned, decided
    assert failed == counted
    assert longest <= counted <= measured
    rows = [line.split()[2:] for line in python_pages.printed()[-2].splitlines()[1:]]
    assert len(rows) == 4
    assert all(float(piece) == pytest.approx(min(float(kept), float(ratio)), abs=0.2) for kept, ratio, _, piece in rows)


def test_a_system_may_be_a_number_an_object_or_none(folder: Path) -> None:
    class System:
        def to_wkt(self) -> str:
            system = osr.SpatialReference()
            system.ImportFromEPSG(2180)
            return str(system.ExportToWkt())

    of_mosaic = open_block(folder / "mosaic.tif").mosaic.wkt
    systems = (None, "", 2180, np.int64(2180), System())
    taken = {open_block(folder / "mosaic.tif", crs=system).mosaic.wkt for system in systems}
    assert taken == {of_mosaic}


def test_exceptions_of_osr_and_integers_of_numpy_are_no_hindrance(block: Block, folder: Path) -> None:
    osr.UseExceptions()
    try:
        opened = open_block(folder / "mosaic.tif", sorted(folder.glob("strip*.tif")))
    finally:
        osr.DontUseExceptions()
    settings = InspectionSettings(levels=np.int64(3))
    xmin, ymin, xmax, ymax = opened.mosaic.extent
    window = opened.window_at((xmin + xmax) / 2, (ymin + ymax) / 2, 30, settings)
    assert seam_inspector.inspect_window(window).judgement is not None


def test_a_mosaic_that_no_mending_made_is_not_replaced(
    block: Block, folder: Path, scanned: ScanResult, tmp_path: Path
) -> None:
    theirs = tmp_path / "theirs.vrt"
    gdal.BuildVRT(str(theirs), [str(folder / "mosaic.tif")])
    before = theirs.read_bytes()
    with pytest.raises(SettingsError, match="holds other data"):
        seam_inspector.mend(block, scanned, theirs)
    assert theirs.read_bytes() == before
    with pytest.raises(SettingsError, match="not a file on a disk"):
        mend(block, scanned, tmp_path / "mended.vrt", patches="/vsimem/patches")
    assert seam_inspector.decide({1: scanned}, seam_inspector.limit_rules()).outcome is not None


@pytest.mark.slow
def test_progress_never_runs_backwards(block: Block, folder: Path, tmp_path: Path) -> None:
    scanning: list[float] = []
    result = seam_inspector.scan(block, seamlines=folder / "seamlines.gpkg", progress=scanning.append)
    mending: list[float] = []
    seam_inspector.mend(block, result, tmp_path / "mended.vrt", progress=mending.append)
    for shares in (scanning, mending):
        assert len(shares) > 1
        assert shares == sorted(set(shares))
        assert shares[-1] == 1


def test_results_are_the_same_after_a_journey(block: Block, scanned: ScanResult, tmp_path: Path) -> None:
    """Into another process and back: also where sentences say by how much a limit is exceeded."""
    decision = seam_inspector.decide({"a": scanned}, seam_inspector.limit_rules(max_share=0.0001))
    results = [scanned, decision, tuple(mend(block, scanned, tmp_path / "mended.vrt"))]
    travelled = pickle.loads(pickle.dumps(results))
    assert travelled == results
    assert [*map(hash, travelled)] == [*map(hash, results)]
    assert replace(scanned, pieces=scanned.pieces[1:]) != scanned
    back = travelled[1]
    assert [str(sentence) for sentence in back.sentences] == [str(sentence) for sentence in decision.sentences]
    assert "%" in " ".join(map(str, decision.sentences))


def test_a_value_of_no_measurements_may_be_named_beside_those_of_the_files(folder: Path, tmp_path: Path) -> None:
    path = tmp_path / "margin.tif"
    made = gdal.GetDriverByName("GTiff").CreateCopy(str(path), gdal.Open(str(folder / "mosaic.tif")))
    for number in range(1, made.RasterCount + 1):
        made.GetRasterBand(number).WriteArray(np.full((made.RasterYSize, 200), 77, np.uint8))
    made = None
    sources = sorted(folder.glob("strip*.tif"))

    def inspected(nodata: float | None) -> str:
        opened = open_block(path, sources, nodata=nodata)
        left, bottom, right, top = opened.mosaic.extent
        middle = left + 100 * (right - left) / opened.mosaic.grid.columns
        result = seam_inspector.inspect_window(opened.window_at(middle, (bottom + top) / 2, side_m=10))
        return " ".join(map(str, (result.judgement.reason, *result.notices)))

    assert "are invalid in the window" not in inspected(None)
    assert "are invalid in the window" in inspected(77)
    with pytest.raises(SettingsError, match="nodata"):
        open_block(path, sources, nodata="white")


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda block: open_block(None), "mosaic is None"),
        (lambda block: open_block(block.mosaic.ref.path, None), "sources is None"),
        (lambda block: open_block(block.mosaic.ref.path, [None]), "sources is None"),
        (lambda block: block.window_at(math.nan, 0.0), "x is nan"),
        (lambda block: block.window_at(0.0, math.inf), "y is inf"),
        (lambda block: block.window(block.mosaic.extent, ScanSettings()), "give InspectionSettings"),
        (lambda block: block.window(block.mosaic.extent, InspectionSettings(levels=3.5)), "levels is 3.5"),
        (lambda block: scan(block, InspectionSettings()), "give ScanSettings"),
        (lambda block: scan(block, ScanSettings(levels="3")), "levels is '3'; give a whole number"),
        (lambda block: scan(block, ScanSettings(piece_m="25")), "piece_m is '25'; give a finite number"),
        (lambda block: limit_rules(min_kept="0.7"), "min_kept is '0.7'"),
        (lambda block: limit_rules(min_kept=1.5), "min_kept"),
        (lambda block: limit_rules(max_run_m=-1), "max_run_m"),
        (lambda block: open_block(block.mosaic.ref.path, crs="EPSG:5773"), "not a projected or geographic"),
        (lambda block: open_block(block.mosaic.ref.path, crs=3.5), "not a projected or geographic"),
        (lambda block: block.window((1, 2, 3), window_id=7), r"Window 7 is not a rectangle; give \(xmin"),
        (lambda block: block.window("corner", window_id=7), "Window 7 is not a rectangle"),
        (lambda block: block.window((0, 0, "a", 1), window_id=7), "Window 7 is not a rectangle"),
        (lambda block: seam_inspector.decide({"a": None}, limit_rules()), r"sheets\['a'\] is None"),
        (lambda block: seam_inspector.decide([block], limit_rules()), "give Mapping"),
        (lambda block: seam_inspector.decide({}, limit_rules()), "no seam to decide on"),
        (lambda block: seam_inspector.decide({}, limit_rules(), lot_size=90), "lot size or seed is for a plan"),
        (lambda block: seam_inspector.decide({}, limit_rules(), lot_size="x"), "lot_size is 'x'"),
        (lambda block: scan(block, seamlines=block), "seamlines is Block; give str"),
        (lambda block: mend(block, block, "mended.vrt"), "seams is Block; give ScanResult"),
        (lambda block: mend(block, EMPTY, "m.vrt", InspectionSettings()), "give MendSettings"),
        (lambda block: scan(block, cancelled=3), "cancelled is int, which can't be called"),
        (lambda block: mend(block, EMPTY, "mended.vrt", progress="bar"), "progress is str, which can't be called"),
        (lambda block: seam_inspector.inspect_windows([], block, cancelled=True), "cancelled is bool"),
        (lambda block: scan(block, executor=3), "int is not an executor"),
        (lambda block: scan(block.mosaic.ref.path), r"block is .*; give Block of open_block\(\.\.\.\)\."),
        (lambda block: block.window(block.mosaic.extent, InspectionSettings(min_kept=70)), "^min_kept is 70; give"),
        (lambda block: window_rows([EMPTY]), r"results\[0\] is ScanResult; give WindowResult"),
        (lambda block: seam_rows([EMPTY]), "result is list; give ScanResult"),
        (lambda block: scan(block, ScanSettings(piece_m=True)), "piece_m is True; give a finite number"),
        (lambda block: open_block(block.mosaic.ref.path, nodata=True), "nodata is True"),
        (lambda block: write_scan("seams.gpkg", EMPTY, block), "of another mosaic than mosaic.tif"),
        (lambda block: window_rows([]).to_geodataframe(), "has no lines"),
    ],
)
def test_what_is_of_another_type_is_told(block: Block, call: Callable[[Block], object], words: str) -> None:
    with pytest.raises(SettingsError, match=words):
        call(block)


@pytest.mark.parametrize("has_picture", [True, False])
def test_only_a_scan_with_a_picture_is_said_to_go_on(block: Block, tmp_path: Path, has_picture: bool) -> None:
    loss, looks = tmp_path / "loss.tif" if has_picture else "", iter([False, False])
    with pytest.raises(seam_inspector.CancelledError) as error:
        scan(block, loss=loss, cancelled=lambda: next(looks, True))
    assert ("continues" in str(error.value)) is has_picture
    assert ("continues where it stopped" in " ".join(map(str, scan(block, loss=loss).notices))) is has_picture


def test_what_is_left_out_is_a_warning(folder: Path, tmp_path: Path) -> None:
    with pytest.warns(SeamInspectorWarning, match=r"none\.tif") as warned:
        block = open_block(folder / "mosaic.tif", [folder / "strip1_0141.tif", tmp_path / "none.tif"])
    assert len(warned) == 1
    assert warned[0].filename == __file__
    assert [source.ref.name for source in block.sources] == ["strip1_0141.tif"]


@pytest.mark.parametrize("has_sources", [True, False])
def test_a_scan_goes_along_seamlines(block: Block, folder: Path, tmp_path: Path, has_sources: bool) -> None:
    scanned = block if has_sources else open_block(folder / "mosaic.tif")
    with ThreadPoolExecutor(1) as executor:
        result = scan(scanned, seamlines=folder / "seamlines.gpkg", loss=tmp_path / "loss.tif", executor=executor)
    with pytest.raises(seam_inspector.WorkersLostError, match="executor was shut down"):
        scan(block, executor=executor)
    assert 250 < result.seam_metres < 320
    assert gdal.Open(str(tmp_path / "loss.tif")).RasterCount == 5
    rows = seam_rows(result)
    pieces = [row for row in rows if row["level"] == "piece"]
    assert sum(row["length"] for row in pieces) == pytest.approx(result.seam_metres)
    assert len(rows) - len(pieces) == len(result.stretches)
    assert {row["left_source"] for row in rows} <= {path.name for path in folder.glob("strip*.tif")}
    line = ogr.CreateGeometryFromWkt(rows[0]["geometry"])
    assert line.Length() == pytest.approx(rows[0]["length"], rel=0.01)


@pytest.mark.slow
def test_seams_that_cannot_be_mended_are_left_with_a_reason(
    block: Block, scanned: ScanResult, folder: Path, tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    failed = scanned.failed_metres
    moved = replace(scanned, pieces=tuple(
        replace(part, piece=replace(part.piece, vertices=part.piece.vertices + 5000)) for part in scanned.pieces
    ))
    for sources, seams, words in (
        ([], scanned, "not name two of the given"), ([block.sources[0].ref.path], scanned, "not name two of the given"),
        ([source.ref.path for source in block.sources], moved, "not lie on this mosaic"),
    ):  # fmt: skip
        caplog.clear()
        made = mend(open_block(folder / "mosaic.tif", sources), seams, tmp_path / "mended.vrt")
        assert {mended.outcome for mended in made} == {"left"}
        assert all(words in str(mended.reason) for mended in made)
        assert sum(mended.run.piece.length_m for mended in made) == pytest.approx(failed)
        assert words in caplog.text


@pytest.mark.parametrize(("settings", "which", "words"), [
    ({"width_m": 0}, "all", "0 m wide"), ({"width_m": -2}, "all", "-2 m wide"), ({"width_m": np.nan}, "all", "is nan"),
    ({"width_m": np.inf}, "all", "width_m is inf"), ({"blend_px": -1}, "all", "blend of -1"),
    ({"blend_px": 2.5}, "all", "is 2.5"), ({"blend_px": 99}, "all", "blend of 99"), ({}, "x", "which can't be 'x'"),
])  # fmt: skip
def test_settings_of_mending_are_checked(
    block: Block, scanned: ScanResult, tmp_path: Path, settings: dict[str, float], which: str, words: str
) -> None:
    with pytest.raises(SeamInspectorError, match=words):
        mend(block, scanned, tmp_path / "mended.vrt", seam_inspector.MendSettings(**settings), which=which)  # type: ignore[arg-type]
    assert not list(tmp_path.glob("mended*.vrt"))


def test_seamlines_that_are_none_are_told(block: Block, folder: Path, tmp_path: Path) -> None:
    (tmp_path / "text.gpkg").write_text("no vectors")
    for path, words in (
        (tmp_path / "none.gpkg", "does not exist"), (tmp_path / "text.gpkg", "No seamlines"),
        (f"{folder}/seamlines.gpkg|layername=other", "No seamlines"),
    ):  # fmt: skip
        with pytest.raises(SeamInspectorError, match=words):
            scan(block, seamlines=path)


def test_seamlines_may_lie_in_another_system_and_have_dates(folder: Path, tmp_path: Path) -> None:
    moved = str(tmp_path / "cells.gpkg")
    gdal.VectorTranslate(
        moved, f"{folder}/seamlines.gpkg", SQLStatement="SELECT geom, source AS cliche FROM cells", dstSRS="EPSG:4326",
        layerName="cells", reproject=True,
    )  # fmt: skip
    dataset = ogr.Open(moved, 1)
    layer = dataset.GetLayer(0)
    layer.CreateField(ogr.FieldDefn("acquisition_date", ogr.OFTDate))
    for feature in list(layer):
        feature.SetField("acquisition_date", 2019, 7, 4, 0, 0, 0, 0)
        layer.SetFeature(feature)
    del feature, layer, dataset
    result = scan(open_block(folder / "mosaic.tif"), seamlines=moved)
    assert 250 < result.seam_metres < 320
    assert {piece.left_date for piece in result.pieces} == {"2019-07-04"}


def test_what_names_no_system_lies_in_that_of_the_mosaic(block: Block, folder: Path, tmp_path: Path) -> None:
    class Places(list):  # type: ignore[type-arg]
        crs = None

    with pytest.warns(SeamInspectorWarning, match="The windows name no reference system"):
        (result,) = seam_inspector.inspect_windows(Places([block.mosaic.extent]), block)
    assert result.window.width == block.mosaic.columns // 8 * 8
    for name in ("lines.gpkg", "lines.shp"):
        gdal.VectorTranslate(f"{tmp_path}/{name}", f"{folder}/seamlines.gpkg", options="seamlines -a_srs None")
        result = scan(open_block(folder / "mosaic.tif"), seamlines=tmp_path / name)
        assert f"{name} names no reference system" in str(result.notices[0])
        assert 250 < result.seam_metres < 320


def test_a_sheet_without_any_seam_counts_for_nothing_beside_others(block: Block, folder: Path, tmp_path: Path) -> None:
    pytest.importorskip("pandas")
    gdal.Translate(f"{tmp_path}/sheet.tif", block.mosaic.ref.path, srcWin=[0, 0, 100, 100])
    sheet = open_block(tmp_path / "sheet.tif", [source.ref.path for source in block.sources], keep_copies=True)
    full = scan(block, seamlines=f"{folder}/seamlines.gpkg")
    for layer, words in (("seamlines", "None of the 7 features"), ("cells", "within one orthoimage")):
        empty = scan(sheet, seamlines=f"{folder}/seamlines.gpkg|layername={layer}")
        write_scan(tmp_path / f"{layer}.gpkg", empty, sheet)
        assert (empty.seam_metres, empty.told["seams"], len(empty.polygons)) == (0, "given", 1)
        assert words in str(empty.notices[0])
        assert empty.to_dataframe().empty
        for given in (empty, tmp_path / f"{layer}.gpkg"):
            rules = limit_rules(0.01, 1, 500, 0)
            assert seam_inspector.decide({"full": full, "empty": given}, rules).accepted
            with pytest.raises(SettingsError, match="no seam to decide on"):
                seam_inspector.decide({"empty": given}, rules)


def test_what_is_written_is_what_was_scanned(block: Block, tmp_path: Path) -> None:
    """Whatever the block says: parts of one orthoimage were scanned as one, and with which settings the scan knows."""
    first, *others = (source.ref.path for source in block.sources)
    size, parts = gdal.Open(first), [f"{tmp_path}/{name}.tif" for name in "ab"]
    for path, row in zip(parts, (0, 300)):
        gdal.Translate(path, size, srcWin=[0, row, size.RasterXSize, (400, size.RasterYSize - 300)[row > 0]])
    opened = open_block(block.mosaic.ref.path, [*parts, *others])
    result = scan(opened, ScanSettings(levels=4, piece_m=20))
    write_scan(tmp_path / "seams.gpkg", result, opened)
    written = gdal.OpenEx(f"{tmp_path}/seams.gpkg")
    names = [feature["source"] for feature in written.GetLayerByName("source_cells")]
    assert names == ["a.tif", *(Path(path).name for path in others)]
    assert "kept_4" in [field.GetName() for field in written.GetLayerByName("seams").schema]
    assert written.GetLayerByName("seams").GetMetadata("SEAM_INSPECTOR")["piece_m"] == "20"
    other, copy = open_block(first), Path(shutil.copy(block.mosaic.ref.path, tmp_path))
    with pytest.raises(SettingsError, match=r"another mosaic than strip1_0141\.tif"):
        write_scan(tmp_path / "other.gpkg", result, other)
    for seams in (result, tmp_path / "seams.gpkg"):
        with pytest.raises(SettingsError, match=r"another mosaic than strip1_0141\.tif"):
            mend(other, seams, tmp_path / "mended.vrt")
    assert mend(open_block(copy, others), tmp_path / "seams.gpkg", tmp_path / "mended.vrt")
    with full_disk(20_000), pytest.raises(RasterError, match="choose another folder, or make room on the disk"):
        write_scan(tmp_path / "full.gpkg", result, opened)


def piece(kept: object, number: int, **others: object) -> dict[str, object]:
    line = f"LINESTRING ({25 * number} 0, {25 * number + 25} 0)"
    return {"seam_id": 1.0, "station": 25.0 * number, "length": 25.0, "kept_1": kept, "geometry": line, **others}


def test_rows_in_memory_need_no_seal_but_say_nothing_of_other_seams() -> None:
    rows = [piece(0.9, place) for place in range(9)]
    words = "seams that are in no row are unknown: one."
    for facts, is_said in ((None, True), ({"one": {}}, True), ({"one": {"unexplained": "0.0"}}, False)):
        decision = decide(make_delivery({"one": rows}, METRES, facts), limit_rules())
        assert decision.accepted
        assert any(words in str(sentence) for sentence in decision.sentences) is is_said


@pytest.mark.parametrize(("metres", "lacking"), [("225.0", 0), ("300.0", 75)])
def test_what_the_scan_told_of_its_metres_says_whether_rows_lack(metres: str, lacking: float) -> None:
    """A seamline that leaves the mosaic and comes back has a gap between its stations."""
    rows = [piece(0.9, place + 4 * (place > 4)) for place in range(9)]
    facts = {"one": {"unexplained": "0.0", "metres": metres}}
    assert make_delivery({"one": rows}, METRES, facts).lacking_m == lacking
    assert decide(make_delivery({"one": rows}, METRES, facts), limit_rules()).accepted is (None if lacking else True)


def test_a_delivery_of_nothing_is_refused_and_a_row_without_line_is_told() -> None:
    for sheets, words in (
        ({}, "empty"), ({"one": []}, "empty"), ({"one": [{"geometry": "LINESTRING (0 0, 1 0)"}]}, "kept_1"),
    ):  # fmt: skip
        with pytest.raises(SeamInspectorError, match=words):
            make_delivery(sheets, METRES)
    with pytest.warns(SeamInspectorWarning, match="left out"):
        delivery = make_delivery({"one": [piece(0.9, 0), piece(0.9, 1, geometry="nowhere")]}, METRES)
    assert len(delivery.pieces) == 1


def test_a_delivery_in_degrees_is_moved_to_metres() -> None:
    degrees = osr.SpatialReference()
    degrees.ImportFromEPSG(4326)
    row = piece(0.9, 0, geometry="LINESTRING (20 50, 20.001 50)", length=71.7)
    delivery = make_delivery({"one": [row]}, degrees.ExportToWkt())
    assert "UTM" in delivery.wkt
    assert delivery.pieces[0].vertices[0] == pytest.approx([428333.55, 5539109.82], abs=0.5)


@pytest.mark.parametrize(("command", "column"), [("scan", 1), ("accept", 1), ("inspect", 2), ("mend", 3)])
def test_help_has_the_exit_codes_of_the_page(capsys: pytest.CaptureFixture[str], command: str, column: int) -> None:
    rows = re.findall(r"^\| (\d) \| (.*) \| (.*) \|(.*)\|$", python_pages.COMMANDS.read_text("utf-8"), re.MULTILINE)
    codes = [f"{row[0]} {row[column].strip()}" for row in rows if row[column].strip()]
    assert len(codes) in (3, 4)
    with pytest.raises(SystemExit, match="0"):
        command_line.main([command, "--help"])
    assert " ".join(capsys.readouterr().out.split()).endswith(f"Exit codes: {'; '.join(codes)}.")


@pytest.mark.parametrize("name", ["window_rows", "profile_rows", "curve_rows", "pair_rows"])
def test_a_table_without_rows_has_its_columns(block: Block, name: str) -> None:
    pytest.importorskip("pandas")
    table = getattr(seam_inspector, name)
    xmin, ymin, _, _ = block.mosaic.extent
    full = table([seam_inspector.inspect_window(block.window_at(xmin + 80, ymin + 75, side_m=50))])
    assert full
    assert table([]).to_dataframe().dtypes.to_dict() == full.to_dataframe().dtypes.to_dict()
