"""A raster is known again by all of its files, whatever they are called, and by bytes from all over them."""
from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery.file_identity import content_of, known_states

from tests.numbers.conftest import MakeRaster
from tests.numbers.synthetic import orthoimage
from tests.range_server import serving


@pytest.fixture
def part(make_raster: MakeRaster) -> Path:
    return Path(make_raster("part.tif", orthoimage((64, 64))))


def virtual(part: Path, name: str) -> Path:
    path = part.with_name(name)
    gdal.BuildVRT(str(path), [str(part)]).FlushCache()
    return path


def nested(part: Path, name: str) -> Path:
    """A VRT of a VRT that is called ``name``."""
    inner, outer = virtual(part, name), part.with_name("outer.vrt")
    text = inner.read_text(encoding="utf-8")
    outer.write_text(text.replace(part.name, inner.name), encoding="utf-8")
    return outer


def names(path: Path) -> set[str]:
    return {os.path.basename(file) for file in known_states([str(path)])}


def write_statistics(path: Path) -> None:
    """Write statistics as QGIS does when it shows a raster."""
    dataset = gdal.Open(str(path))
    dataset.GetRasterBand(1).ComputeStatistics(False)
    dataset.GetRasterBand(1).GetDefaultHistogram(force=True)


@pytest.mark.parametrize("make", [virtual, nested])
@pytest.mark.parametrize("name", ["inner.vrt", "inner.tif", "inner.xml"])
def test_a_vrt_is_what_it_names_whatever_it_is_called(
    part: Path, make: Callable[[Path, str], Path], name: str
) -> None:
    path = make(part, name)
    assert names(path) == {"part.tif", name, path.name}
    before = known_states([str(path)])
    write_statistics(path)
    write_statistics(part.with_name(name))
    assert "STATISTICS" in path.read_text(encoding="utf-8")
    assert known_states([str(path)]) == before
    held = bytearray(part.read_bytes())
    held[-1] ^= 1
    part.write_bytes(held)
    assert known_states([str(path)]) != before


def test_no_server_is_asked_for_the_parts_of_a_vrt(part: Path) -> None:
    path = virtual(part, "all.tif")
    with serving(part.parent) as server:
        text = path.read_text(encoding="utf-8").replace('relativeToVRT="1">part.tif', f">{server.vsi('part.tif')}")
        path.write_text(text, encoding="utf-8")
        assert names(path) == {"all.tif"}
        assert not server.answers


def copied(driver: str, part: Path, name: str, *options: str) -> Path:
    path = part.with_name(name)
    gdal.GetDriverByName(driver).CreateCopy(str(path), gdal.Open(str(part)), options=options)
    return path


@pytest.mark.parametrize(
    ("driver", "name", "beside", "options"),
    [
        ("HFA", "a.img", "a.ige", ["USE_SPILL=YES"]),
        ("ENVI", "a.dat", "a.hdr", []),
        ("EHdr", "a.bil", "a.hdr", []),
        ("PNG", "a.png", "a.wld", ["WORLDFILE=YES"]),
        ("GTiff", "a.tif", "a.tfw", ["TFW=YES", "PROFILE=BASELINE"]),
    ],
)
def test_the_files_that_a_raster_consists_of_are_in_its_identity(
    part: Path, driver: str, name: str, beside: str, options: list[str]
) -> None:
    path = copied(driver, part, name, *options)
    path.with_name(name + ".aux.xml").unlink(missing_ok=True)  # with the place, too
    before, content = known_states([str(path)]), content_of(str(path))
    assert names(path) >= {name, beside}
    write_statistics(path)
    dataset = gdal.Open(str(path))
    dataset.BuildOverviews("NEAREST", [2])
    del dataset
    assert known_states([str(path)]) == before
    with open(path.with_name(beside), "ab") as file:
        file.write(b"\n")
    assert content_of(str(path)) != content
    outer = virtual(path, "all.vrt")
    assert names(outer) >= {name, beside, "all.vrt"}


LARGE = 70_000_000


@pytest.mark.parametrize(("size", "changed"), [(300_000, 1), (2_000_000, 1), (LARGE, 1_000_000)])
def test_a_change_is_seen_wherever_it_is(tmp_path: Path, size: int, changed: int) -> None:
    """Each byte of a small file, what is as long as a short seam of a large one."""
    path = tmp_path / "a.tif"
    with open(path, "wb") as file:
        file.truncate(size)
    before = content_of(str(path))
    for place in (0, size // 7, size // 2, size - changed):
        with open(path, "r+b") as file:
            file.seek(place)
            file.write(b"\1" * changed)
        assert content_of(str(path)) != before
        with open(path, "r+b") as file:
            file.seek(place)
            file.write(bytes(changed))
    assert content_of(str(path)) == before


@pytest.mark.parametrize("band", [slice(240, 270), slice(100, 130), slice(480, 512)])
def test_a_level_seam_through_tiles_that_keep_pace_with_the_looks_is_seen(tmp_path: Path, band: slice) -> None:
    """Each tile of 512 px holds two looks: at the same places in all of them most rows would never be looked at."""
    tiles = np.zeros((250, 512, 512), np.uint8)
    path = tmp_path / "a.tif"
    tiles.tofile(path)
    before = content_of(str(path))
    tiles[:, band] = 1
    tiles.tofile(path)
    assert content_of(str(path)) != before
