"""Files of a delivery with planted faults: each is found, and nothing else."""
from __future__ import annotations

import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal, ogr
from seam_inspector.plugin.acceptance.measure import messages
from seam_inspector.plugin.acceptance.measure.delivered_files import (
    OrderedForm,
    OrderedSheet,
    build_mosaic,
    checked_sheets,
    fitting,
)
from seam_inspector.plugin.acceptance.measure.delivery import SheetState

from tests.numbers.synthetic import orthoimage, write_raster

LEFT, TOP, SIDE = 500_000.0, 5_400_000.0, 60
HOLE = (slice(10, 20), slice(20, 50))  # 300 of 3600 pixels


def outline(place: int, side: float = SIDE) -> bytes:
    x = LEFT + place * SIDE
    box = f"POLYGON(({x} {TOP},{x + side} {TOP},{x + side} {TOP - side},{x} {TOP - side},{x} {TOP}))"
    return bytes(ogr.CreateGeometryFromWkt(box).ExportToWkb())


def pixels(bands: int = 3, kind: str = "uint8", side: int = SIDE) -> np.ndarray:
    return np.full((bands, side, side), 100, kind)


def system() -> str:
    from osgeo import osr

    made = osr.SpatialReference()
    made.ImportFromEPSG(32633)
    return str(made.ExportToWkt())


def sheet(folder: Path, name: str, place: int, made: np.ndarray | None = None, size: float = 1.0,
          epsg: int | str = 32633, nodata: float | None = None) -> OrderedSheet:
    path = write_raster(folder / f"{name}.tif", pixels() if made is None else made, size,
                        (LEFT + place * SIDE, TOP), system=epsg, nodata=nodata)
    return OrderedSheet(name, path, outline(place), system())


def findings(sheets: list[OrderedSheet], form: OrderedForm | None = None) -> dict[str, list[str]]:
    results = checked_sheets(sheets, form or OrderedForm(), lambda share: True)
    assert results is not None
    return {result.sheet.name: [str(finding) for finding in result.findings] for result in results}


@pytest.fixture
def sound(tmp_path: Path) -> list[OrderedSheet]:
    return [sheet(tmp_path, f"ortho_0{place}", place) for place in range(4)]


def test_a_sound_delivery_has_no_findings(sound: list[OrderedSheet]) -> None:
    assert not any(findings(sound, OrderedForm(1.0, system(), 3, "uint8", "ortho_??.tif")).values())


def test_each_planted_fault_is_found_at_its_sheet(tmp_path: Path, sound: list[OrderedSheet]) -> None:
    hole = pixels()
    hole[(slice(None), *HOLE)] = 0
    planted = {
        "missing": OrderedSheet("missing", "", outline(4), system()),
        "coarse": sheet(tmp_path, "coarse", 5, pixels(side=30), 2.0),
        "elsewhere": sheet(tmp_path, "elsewhere", 6, epsg=32634),
        "grey": sheet(tmp_path, "grey", 7, pixels(1)),
        "deep": sheet(tmp_path, "deep", 8, pixels(kind="uint16")),
        "holed": sheet(tmp_path, "holed", 9, hole, nodata=0),
        "short": sheet(tmp_path, "short", 10, pixels(side=45)),
        "extra": OrderedSheet("extra", sound[0].path, None, "", is_ordered=False),
    }
    (tmp_path / "broken.tif").write_bytes(b"II*\0")
    planted["broken"] = OrderedSheet("broken", str(tmp_path / "broken.tif"), outline(11), system())
    faults = findings([*sound, *planted.values()])
    assert not any(faults[ordered.name] for ordered in sound)
    words = {
        "missing": "the file is missing", "coarse": "its pixels are 2 m instead of 1 m",
        "grey": "it has 1 bands instead of 3", "deep": "its pixels are uint16 instead of uint8",
        "holed": "8.33% of its outline has no data", "short": "43.75% of its outline has no data",
        "extra": "it was not ordered",
    }  # fmt: skip
    assert {name: faults[name] for name in words} == {name: [word] for name, word in words.items()}
    assert faults["elsewhere"][0].startswith("its reference system is EPSG:32634")
    assert "instead of EPSG:32633" in faults["elsewhere"][0]
    assert len(faults["broken"]) == 1


def test_a_system_with_heights_is_that_of_its_horizontal_part(tmp_path: Path, sound: list[OrderedSheet]) -> None:
    with_heights = sheet(tmp_path, "heights", 4, epsg="EPSG:32633+5773")
    results = checked_sheets([*sound, with_heights], OrderedForm(wkt=system()), lambda share: True)
    assert results is not None
    assert not any(result.findings for result in results)
    assert {result.state for result in results} == {SheetState.SHOWN}
    build_mosaic(str(tmp_path / "mosaic.vrt"), fitting(results))
    assert gdal.Open(str(tmp_path / "mosaic.vrt")).RasterXSize == 5 * SIDE


def test_no_data_outside_of_the_outline_is_no_fault(tmp_path: Path) -> None:
    made = pixels()
    made[:, :, 30:] = 0
    half = sheet(tmp_path, "half", 0, made, nodata=0)
    narrow = OrderedSheet("half", half.path, outline(0, 30.0), half.wkt)
    assert findings([narrow]) == {"half": []}
    assert findings([half], OrderedForm(most_missing=0.5)) == {"half": []}


def test_an_outline_that_gdal_can_not_read_is_told(tmp_path: Path) -> None:
    bent = sheet(tmp_path, "bent", 0)
    assert findings([replace(bent, outline=bent.outline[:40])])["bent"] == [str(messages.MISSING_UNKNOWN())]


def states(sheets: list[OrderedSheet]) -> dict[str, str]:
    results = checked_sheets(sheets, OrderedForm(), lambda share: True)
    assert results is not None
    return {result.sheet.name: result.state.value for result in results}


def extra(ordered: OrderedSheet) -> OrderedSheet:
    return replace(ordered, outline=None, is_ordered=False)


def test_what_was_not_ordered_is_no_part_of_the_mosaic(tmp_path: Path, sound: list[OrderedSheet]) -> None:
    """However large its picture, and however many such files there are."""
    overview = pixels(side=4 * SIDE)
    others = [extra(sheet(tmp_path, f"zz_{number}", 0, overview.astype("uint16"))) for number in range(6)]
    others.append(extra(sheet(tmp_path, "zz_overview", 0, overview // 2)))
    results = checked_sheets([*others, *sound], OrderedForm(), lambda share: True)
    assert [result.sheet.name for result in fitting(results)] == [ordered.name for ordered in sound]
    assert {str(result.findings[0]) for result in results[: len(others)]} == {"it was not ordered"}
    assert not any(result.findings for result in results[len(others) :])
    assert states([*others, *sound]) == {
        **{other.name: "not_ordered" for other in others}, **{ordered.name: "shown" for ordered in sound}
    }


def test_the_form_of_most_sheets_makes_the_mosaic_whatever_comes_first(
    tmp_path: Path, sound: list[OrderedSheet]
) -> None:
    odd = sheet(tmp_path, "a_first", 4, pixels(kind="uint16"))
    results = checked_sheets([odd, *sound], OrderedForm(), lambda share: True)
    assert results is not None
    assert [result.sheet.name for result in fitting(results)] == [ordered.name for ordered in sound]
    assert states([odd, *sound, OrderedSheet("gone", "", outline(5), system())]) == {
        "a_first": "left_out", "gone": "left_out", **{ordered.name: "shown" for ordered in sound}
    }


def wide(folder: Path, name: str, column: int, scene: np.ndarray, **more: object) -> OrderedSheet:
    """70 columns of a scene, of which the next sheet shows 10 as well."""
    path = write_raster(folder / f"{name}.tif", scene[:, :, column : column + 70], 1.0, (LEFT + column, TOP), **more)
    return OrderedSheet(name, path, None, system())


@pytest.mark.parametrize("options", [["COMPRESS=DEFLATE"], ["COMPRESS=JPEG", "JPEG_QUALITY=75", "TILED=YES"]])
def test_sheets_that_hide_each_other_are_named(tmp_path: Path, options: list[str]) -> None:
    scene, other = (orthoimage((64, 256), seed=seed) for seed in (1, 2))
    more = {"system": 32633, "options": options}
    alike = [wide(tmp_path, f"s{column}", column, scene, **more) for column in (0, 60, 120)]
    assert not any(findings(alike).values())
    assert set(states(alike).values()) == {"shown"}
    odd = [*alike, wide(tmp_path, "t180", 180, other, **more)]
    assert findings(odd) == {
        "s0": [], "s60": [], "s120": ["it does not show the same as t180 where they overlap"],
        "t180": ["it does not show the same as s120 where they overlap"],
    }
    assert states(odd) == {"s0": "shown", "s60": "shown", "s120": "overlaps", "t180": "overlaps"}


def test_pixels_without_data_hide_nothing(tmp_path: Path) -> None:
    scene = orthoimage((64, 256), seed=1)
    holed = scene.copy()
    holed[:, :, 60:70] = 0
    more = {"system": 32633, "nodata": 0}
    pair = [wide(tmp_path, "s0", 0, scene, **more), wide(tmp_path, "s60", 60, holed, **more)]
    assert states(pair) == {"s0": "shown", "s60": "shown"}


def test_sheets_on_other_pixels_that_overlap_are_named(tmp_path: Path) -> None:
    scene = orthoimage((64, 256), seed=1)
    first = wide(tmp_path, "s0", 0, scene, system=32633)
    path = write_raster(tmp_path / "aside.tif", scene[:, :, 60:130], 1.0, (LEFT + 60.5, TOP), system=32633)
    beside = write_raster(tmp_path / "beside.tif", scene[:, :, 60:130], 1.0, (LEFT + 69.5, TOP + 300), system=32633)
    sheets = [first, *(OrderedSheet(Path(name).stem, name, None, system()) for name in (path, beside))]
    assert states(sheets) == {"s0": "overlaps", "aside": "overlaps", "beside": "shown"}


@pytest.mark.parametrize("compression", ["JPEG", "DEFLATE", "NONE"])
def test_a_truncated_sheet_is_a_finding(tmp_path: Path, compression: str) -> None:
    options = [f"COMPRESS={compression}", "TILED=YES", "BLOCKXSIZE=64", "BLOCKYSIZE=64"]
    path = Path(write_raster(tmp_path / "cut.tif", orthoimage((256, 256)), 1.0, (LEFT, TOP), options=options))
    truncated = OrderedSheet("cut", str(path), outline(0, 256), system())
    assert findings([truncated]) == {"cut": []}
    held = path.read_bytes()
    path.write_bytes(held[: len(held) * 2 // 3])
    (fault,) = findings([truncated])["cut"]
    assert "cut.tif" in fault
    assert states([truncated]) == {"cut": "damaged"}


def test_a_damaged_tile_is_a_finding(tmp_path: Path) -> None:
    """The file is as long as before and says nothing of it."""
    options = ["COMPRESS=JPEG", "TILED=YES", "BLOCKXSIZE=64", "BLOCKYSIZE=64"]
    path = Path(write_raster(tmp_path / "cut.tif", orthoimage((256, 256)), 1.0, (LEFT, TOP), options=options))
    held = bytearray(path.read_bytes())
    dataset = gdal.Open(str(path))
    offset = int(dataset.GetRasterBand(1).GetMetadataItem("BLOCK_OFFSET_2_2", "TIFF"))
    del dataset
    held[offset + 200 : offset + 900] = bytes(700)
    path.write_bytes(held)
    damaged = OrderedSheet("cut", str(path), outline(0, 256), system())
    assert "cut.tif is damaged in columns" in findings([damaged])["cut"][0]


def sparse(path: Path, side: int, filled: int) -> str:
    """A TIFF with blocks in its upper left corner only, and no word of nodata."""
    options = ["TILED=YES", "COMPRESS=JPEG", "SPARSE_OK=TRUE", "BIGTIFF=YES"]
    made = gdal.GetDriverByName("GTiff").Create(str(path), side, side, 3, gdal.GDT_Byte, options)
    made.SetGeoTransform((LEFT, 1.0, 0, TOP, 0, -1.0))
    made.SetProjection(system())
    made.WriteArray(np.full((3, filled, filled), 100, np.uint8), 0, 0)
    return str(path)


def test_a_sheet_that_is_mostly_empty_is_a_finding_in_a_second(tmp_path: Path) -> None:
    path = sparse(tmp_path / "vast.tif", 400_000, 512)
    begin = time.process_time()
    faults = findings([OrderedSheet("vast", path, None, ""), OrderedSheet("again", path, None, "")])
    assert time.process_time() - begin < 4  # two of them, and whether they hide each other
    assert faults == {name: ["100.00% of its outline has no data"] for name in ("vast", "again")}


def test_blocks_that_a_file_does_not_have_are_no_data(tmp_path: Path) -> None:
    """Outside of the outline they do no harm."""
    path = sparse(tmp_path / "corner.tif", 1024, 512)
    assert findings([OrderedSheet("corner", path, outline(0, 512), system())]) == {"corner": []}
    assert findings([OrderedSheet("corner", path, outline(0, 640), system())]) == {
        "corner": ["36.00% of its outline has no data"]
    }
    assert findings([OrderedSheet("corner", path, None, system())]) == {"corner": ["75.00% of its outline has no data"]}
