"""A scan goes on where it stopped only with the same inputs: the fingerprint changes with each of them."""
from __future__ import annotations

import os
import subprocess
import sys
import zipfile
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery.open_raster import describe
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef
from seam_inspector.plugin.seams.measure.blocks.block_grid import ScanSettings
from seam_inspector.plugin.seams.measure.scan import block_runs
from seam_inspector.plugin.seams.measure.scan.block_runs import ScanInputs
from seam_inspector.plugin.seams.measure.source_images import Source

from tests.numbers.conftest import MakeRaster
from tests.numbers.synthetic import orthoimage
from tests.work import calls_of

SETTINGS = ScanSettings()
EXTENT = (0.0, 0.0, 10.0, 10.0)
LINE = np.array([[0.0, 0.5], [1.0, 2.0]])


@pytest.fixture
def files(make_raster: MakeRaster) -> dict[str, str]:
    """A mosaic, a source, one in an archive and a VRT of another one; by what they are."""
    made = {name: make_raster(f"{name}.tif", orthoimage((64, 64))) for name in ("mosaic", "plain", "inner", "part")}
    folder = Path(made["mosaic"]).parent
    with zipfile.ZipFile(folder / "archive.zip", "w") as archive:
        archive.write(made["inner"], "inner.tif")
    gdal.BuildVRT(str(folder / "of & parts.vrt"), [made["part"]]).FlushCache()
    made["bare"], made["wld"] = str(folder / "bare.png"), str(folder / "bare.wld")
    gdal.Translate(made["bare"], made["part"])
    Path(made["bare"] + ".aux.xml").unlink()
    made["archive"] = f"/vsizip/{folder}/archive.zip/inner.tif"
    made["vrt"] = str(folder / "of & parts.vrt")
    return made


def mosaic_of(files: dict[str, str]) -> Raster:
    return describe(RasterRef(files["mosaic"]))


def taken(files: dict[str, str], settings: ScanSettings = SETTINGS, seams: object = (LINE,)) -> str:
    sources = [Source(RasterRef(files[name]), EXTENT) for name in ("plain", "archive", "vrt", "bare")]
    return ScanInputs(mosaic_of(files), sources).fingerprint(settings, seams)  # type: ignore[arg-type]


def rewrite(path: str) -> None:
    """With its size and time kept."""
    before, held = os.stat(path), bytearray(Path(path).read_bytes())
    held[-1] ^= 1
    Path(path).write_bytes(held)
    os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))


def touch(path: str) -> None:
    os.utime(path, ns=(1, os.stat(path).st_mtime_ns + 1))


@pytest.mark.parametrize(
    "change",
    [
        lambda files: touch(files["mosaic"]),
        lambda files: Path(files["mosaic"] + ".msk").write_bytes(b"x"),
        lambda files: touch(files["plain"]),
        lambda files: touch(str(Path(files["plain"]).parent / "archive.zip")),
        lambda files: touch(files["part"]),
        lambda files: Path(files["part"]).unlink(),
        lambda files: rewrite(files["mosaic"]),
        lambda files: rewrite(files["part"]),
        lambda files: Path(files["wld"]).write_text("1\n0\n0\n-1\n0\n0\n"),
    ],
)
def test_it_changes_with_every_file(files: dict[str, str], change: Callable[[dict[str, str]], None]) -> None:
    before = taken(files)
    assert taken(files) == before
    change(files)
    assert taken(files) != before


def test_it_changes_with_settings_seams_version_and_the_order_of_the_sources(
    files: dict[str, str], monkeypatch: pytest.MonkeyPatch
) -> None:
    before = taken(files)
    assert taken(files, ScanSettings(piece_m=26)) != before
    moved = LINE + [[0, 0], [0, 1e-9]]
    for seams in ((moved,), (LINE, LINE), (LINE[:1], LINE[1:]), (LINE.astype(np.float32),), (), (b"", "", 0)):
        assert taken(files, seams=seams) != before
    refs = [Source(RasterRef(files[name]), EXTENT) for name in ("plain", "part")]
    mosaic = mosaic_of(files)
    first, second = (ScanInputs(mosaic, some).fingerprint(None) for some in (refs, refs[::-1]))
    assert first != second
    moved_mosaic = replace(mosaic, geotransform=(25.0, *mosaic.placement[1:]))
    first, second = (ScanInputs(placed, refs).fingerprint(None) for placed in (mosaic, moved_mosaic))
    assert first != second
    monkeypatch.setattr(block_runs, "plugin_version", lambda: "0")
    assert taken(files) != before


@pytest.mark.slow
def test_another_process_finds_the_same(files: dict[str, str]) -> None:
    code = f"""
from tests.numbers.seams.scan.test_scan_fingerprint import taken
print(taken({files!r}))
"""
    process = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert process.stdout.strip() == taken(files)


@pytest.mark.release
def test_a_thousand_sources_cost_some_calls_each_and_no_remote_one_is_opened(
    make_raster: MakeRaster, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = make_raster("mosaic.tif", orthoimage((64, 64)))
    links = [tmp_path / f"{number}.tif" for number in range(100)]
    for link in links:
        os.link(path, link)
    sources = [Source(RasterRef(str(link)), EXTENT) for link in links for _ in range(8)]
    sources += [Source(RasterRef(f"/vsicurl/http://192.0.2.1/{n}.tif"), EXTENT) for n in range(200)]
    mosaic, opened, opens = describe(RasterRef(path)), set[str](), gdal.OpenEx
    monkeypatch.setattr(gdal, "OpenEx", lambda name, *more: opened.add(name) or opens(name, *more))
    assert calls_of(lambda: ScanInputs(mosaic, sources).fingerprint(SETTINGS)) < 400 * len(sources)
    assert len(opened) == len(links) + 1
