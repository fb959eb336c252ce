"""From the files of a delivery to its decision: checkdelivery, the model of three steps, the desk's entry."""
from __future__ import annotations

import re
import shutil
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest
from osgeo import gdal
from qgis.core import QgsGeometry, QgsRectangle, QgsVectorLayer

from tests.numbers.acceptance.public_schemas import faults
from tests.pages import outline
from tests.qgis.runs import run
from tests.qgis.scenes import layer
from tests.qgis.seams.scan_scenes import Files, drawn_seam, write_scene

pytestmark = pytest.mark.usefixtures("provider")


@pytest.fixture(scope="module")
def scene(tmp_path_factory: pytest.TempPathFactory) -> Files:
    return write_scene(tmp_path_factory.mktemp("scene"), width=24.0)


@pytest.fixture(scope="module")
def folder(scene: Files, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return in_sheets(scene, tmp_path_factory.mktemp("delivered"))


def in_sheets(files: Files, folder: Path) -> Path:
    """The mosaic in two sheets, west and east."""
    for name, column in (("sheet_a", 0), ("sheet_b", 350)):
        gdal.Translate(str(folder / f"{name}.tif"), files.mosaic, srcWin=[column, 0, 350, 520])
    return folder


def ordered(folder: Path, *more: str) -> QgsVectorLayer:
    """The sheets, and others east of them."""
    boxes = []
    for path in sorted(folder.glob("*.tif")):
        left, step, _, top, _, down = gdal.Open(str(path)).GetGeoTransform()
        boxes.append((left, top + 520 * down, left + 350 * step, top))
    boxes += [(box[0] + 1000, box[1], box[2] + 1000, box[3]) for box in boxes[: len(more)]]
    names = [path.stem for path in sorted(folder.glob("*.tif"))]
    outlines = [QgsGeometry.fromRect(QgsRectangle(*box)) for box in boxes]
    return layer("Polygon", outlines, sheet=("string", [*names, *more]))


def test_a_folder_becomes_sheets_and_a_mosaic(folder: Path, tmp_path: Path, scene: Files) -> None:
    made = run("checkdelivery", FOLDER=str(folder), VRT=str(tmp_path / "all.vrt"), PATTERN="sheet_?.tif")
    assert made.complaint is None
    assert (made.results["SHEET_COUNT"], made.results["COMPLETE"]) == (2, 1)
    assert made.column("sheet") == ["sheet_a", "sheet_b"]
    assert (gdal.Open(str(tmp_path / "all.vrt")).ReadAsArray() == gdal.Open(scene.mosaic).ReadAsArray()).all()


def test_numbers_of_sheets_that_lost_their_zeros_name_them(folder: Path, tmp_path: Path) -> None:
    for name, number in (("sheet_a", "0007"), ("sheet_b", "0010")):
        shutil.copy(folder / f"{name}.tif", tmp_path / f"{number}.TIF")
    outlines = [feature.geometry() for feature in ordered(folder).getFeatures()]
    checked = run("checkdelivery", FOLDER=str(tmp_path), SHEETS=layer("Polygon", outlines, sheet=("integer", [7, 10])))
    assert checked.results["COMPLETE"] == 1
    assert [Path(path).name for path in checked.column("location")] == ["0007.TIF", "0010.TIF"]


def test_one_call_goes_from_the_folder_to_the_record(folder: Path, scene: Files, tmp_path: Path) -> None:
    wanted = {"accept:report": "decision.html", "accept:quality": "quality.xml", "accept:failures": "failures.gpkg",
              "accept:decided_sheets": "sheets.gpkg", "check:mosaic": "all.vrt", "scan:loss": "loss.tif",
              "scan:seams": "seams.gpkg"}  # fmt: skip
    made = run(
        "accept_delivery", folder=str(folder), sheets=ordered(folder, "sheet_z"), sources=scene.sources, piece=20.0,
        contract="12/2026", **{name: str(tmp_path / file) for name, file in wanted.items()},
    )  # fmt: skip
    assert made.complaint is None
    assert all((tmp_path / file).is_file() for file in wanted.values())
    page = outline((tmp_path / "decision.html").read_text(encoding="utf-8"))
    assert "12/2026" in page.words
    assert ["sheet_z", "the file is missing"] in page.rows
    parts = {row[0]: row[1:] for row in page.rows if len(row) == 3}
    assert parts["completeness and form of the files"] == ["1 finding", "sheets with findings: 1 of 3"]
    assert parts["radiometry"][0] == "Not checked"
    assert "Its orthoimages, cut hard" in page.captions
    text = (tmp_path / "quality.xml").read_text(encoding="utf-8")
    assert faults(text) == []
    measures = {item.get("id"): "".join(item.itertext()) for item in ET.fromstring(text).iterfind(".//*[@id]")}
    assert "sheet_z: the file is missing." in measures["files"]


def decided(folder: Path, sheets: object, files: Files, out: Path) -> str:
    """The decision's headline, by the model."""
    out.mkdir()
    made = run(
        "accept_delivery", folder=str(folder), sheets=sheets, sources=files.sources, seamlines=drawn_seam(), piece=20.0,
        **{"check:mosaic": str(out / "all.vrt"), "check:checked_sheets": str(out / "sheets.gpkg"),
           "scan:seams": str(out / "seams.gpkg")},
    )  # fmt: skip
    assert made.complaint is None
    notices = (*made.log.infos, *made.log.warnings)
    return next(item for item in notices if re.match("(Accepted|Rejected|Undecided) by", item))


@pytest.fixture(scope="module")
def sound(tmp_path_factory: pytest.TempPathFactory) -> tuple[Files, Path]:
    """A hard cut, and it in two sheets."""
    made = write_scene(tmp_path_factory.mktemp("sound"))
    return made, in_sheets(made, tmp_path_factory.mktemp("delivered_sound"))


def test_what_nobody_ordered_hides_nothing(sound: tuple[Files, Path], scene: Files, tmp_path: Path) -> None:
    """A feathered delivery under a hard cut of all of it."""
    cut, _ = sound
    feathered = tmp_path / "feathered"
    feathered.mkdir()
    index = ordered(in_sheets(scene, feathered))
    alone = decided(feathered, index, scene, tmp_path / "alone")
    assert alone.startswith("Rejected")
    shutil.copy(cut.mosaic, feathered / "zz_overview.tif")
    assert decided(feathered, index, scene, tmp_path / "hidden") == alone
    mosaic = gdal.Open(str(tmp_path / "hidden" / "all.vrt"))
    assert (mosaic.ReadAsArray() == gdal.Open(scene.mosaic).ReadAsArray()).all()


def test_sheets_that_hide_others_leave_it_open(sound: tuple[Files, Path], scene: Files, tmp_path: Path) -> None:
    """An ordered sheet that reaches over all seams of another one, which are the same there or worse."""
    files, folder = sound
    for name, hidden, outcome in (("same", files.mosaic, "Accepted"), ("other", scene.mosaic, "Undecided")):
        (tmp_path / name).mkdir()
        gdal.Translate(str(tmp_path / name / "sheet_a.tif"), hidden, srcWin=[0, 0, 350, 520])
        gdal.Translate(str(tmp_path / name / "sheet_b.tif"), files.mosaic, srcWin=[150, 0, 550, 520])
        headline = decided(tmp_path / name, ordered(folder), files, tmp_path / f"{name} out")
        assert headline.startswith(outcome)
        assert ("differ from others" in headline) == ("sheet_a, sheet_b" in headline) == (name == "other")


def test_sheets_that_are_missing_or_damaged_leave_it_open(sound: tuple[Files, Path], tmp_path: Path) -> None:
    files, folder = sound
    headline = decided(folder, ordered(folder, "sheet_z"), files, tmp_path / "missing")
    assert headline.startswith("Undecided")
    assert "missing in the mosaic that was scanned: 1 (sheet_z)" in headline
    shutil.copytree(folder, tmp_path / "damaged")
    gdal.Translate(
        str(tmp_path / "damaged" / "sheet_b.tif"), str(folder / "sheet_b.tif"),
        creationOptions=["TILED=YES", "COMPRESS=JPEG", "JPEG_QUALITY=95", "BLOCKXSIZE=64", "BLOCKYSIZE=64"],
    )
    held = (tmp_path / "damaged" / "sheet_b.tif").read_bytes()
    (tmp_path / "damaged" / "sheet_b.tif").write_bytes(held[:-2000])
    headline = decided(tmp_path / "damaged", ordered(folder), files, tmp_path / "out")
    assert headline.startswith("Undecided")
    assert "whose pixels can't all be read: 1 (sheet_b)" in headline
