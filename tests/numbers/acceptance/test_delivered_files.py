"""Files of a delivery with planted faults: each is found, and nothing else."""
from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal, ogr
from seam_inspector.plugin.acceptance.measure import messages
from seam_inspector.plugin.acceptance.measure.delivered_files import (
    CheckedSheet,
    OrderedForm,
    OrderedSheet,
    build_mosaic,
    checked_sheets,
    fitting,
)

from tests.numbers.synthetic import write_raster

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
          epsg: int = 32633, nodata: float | None = None) -> OrderedSheet:
    path = write_raster(folder / f"{name}.tif", pixels() if made is None else made, size,
                        (LEFT + place * SIDE, TOP), system=epsg, nodata=nodata)
    return OrderedSheet(name, path, outline(place), system())


def findings(sheets: list[OrderedSheet], form: OrderedForm | None = None) -> dict[str, list[str]]:
    found = checked_sheets(sheets, form or OrderedForm(), lambda share: True)
    assert found is not None
    return {one.sheet.name: [str(finding) for finding in one.findings] for one in found}


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
    found = findings([*sound, *planted.values()])
    assert not any(found[one.name] for one in sound)
    words = {
        "missing": "the file is missing", "coarse": "its pixels are 2 m instead of 1 m",
        "grey": "it has 1 bands instead of 3", "deep": "its pixels are uint16 instead of uint8",
        "holed": "8.33% of its outline has no data", "short": "43.75% of its outline has no data",
        "extra": "it was not ordered",
    }  # fmt: skip
    assert {name: found[name] for name in words} == {name: [one] for name, one in words.items()}
    assert found["elsewhere"][0] == "its reference system is another one"
    assert len(found["broken"]) == 1


def test_names_are_held_against_the_pattern(sound: list[OrderedSheet]) -> None:
    found = findings(sound, OrderedForm(pattern="ortho_0[0-2].tif"))
    assert [len(found[one.name]) for one in sound] == [0, 0, 0, 1]


def test_no_data_outside_of_the_outline_is_no_fault(tmp_path: Path) -> None:
    made = pixels()
    made[:, :, 30:] = 0
    one = sheet(tmp_path, "half", 0, made, nodata=0)
    narrow = OrderedSheet("half", one.path, outline(0, 30.0), one.wkt)
    assert findings([narrow]) == {"half": []}
    assert findings([one], OrderedForm(most_missing=0.5)) == {"half": []}


def test_an_outline_that_gdal_can_not_read_is_told(tmp_path: Path) -> None:
    one = sheet(tmp_path, "bent", 0)
    assert findings([replace(one, outline=one.outline[:40])])["bent"] == [str(messages.MISSING_UNKNOWN())]


def test_a_mosaic_is_made_of_the_sheets_that_fit(tmp_path: Path, sound: list[OrderedSheet]) -> None:
    found: list[CheckedSheet] | None = checked_sheets(
        [*sound, sheet(tmp_path, "deep", 4, pixels(kind="uint16"))], OrderedForm(), lambda share: True
    )
    assert found is not None
    build_mosaic(str(tmp_path / "all.vrt"), fitting(found))
    made = gdal.Open(str(tmp_path / "all.vrt"))
    assert (made.RasterXSize, made.RasterYSize, made.RasterCount) == (4 * SIDE, SIDE, 3)


def test_it_can_be_stopped(sound: list[OrderedSheet]) -> None:
    assert checked_sheets(sound, OrderedForm(), lambda share: share < 0.5) is None
