"""Breakages one after the other, and what is broken packed into something else: what a guard of each alone may miss."""
from __future__ import annotations

import shutil
import zipfile
from dataclasses import replace
from pathlib import Path

from seam_inspector.plugin.imagery.gdal_paths import is_endless

from fuzz.breakages.broken import BREAKAGES, FILES, RASTERS, Broken, breakage


def _again(broken: Broken, times: int) -> str | None:
    """What is given after some breakages, each of what the one before has made."""
    given: str | None = None
    for _ in range(times):
        ending = broken.path.suffix.lower()
        fitting = [
            one for one in BREAKAGES.values()
            if ending in one.endings and not one.grows and one.breaks.__module__ != __name__
        ]
        if not fitting or not broken.path.is_file():
            break
        made = broken.random.choice(fitting).breaks(broken)
        given = made if isinstance(made, str) else given
        if isinstance(made, str):
            if "\0" in made or len(made) > 200 or not Path(made).is_file() or not made.startswith(str(broken.folder)):
                break
            broken = replace(broken, path=Path(made))
    return given


@breakage(*FILES)
def twice(broken: Broken) -> str | None:
    return _again(broken, broken.random.choice((2, 2, 3)))


@breakage(*RASTERS)
def packed(broken: Broken) -> str:
    """In an archive, a VRT, or several of them in each other; but for pipes and devices, which VRTs may lead to."""
    path = _again(broken, broken.random.choice((0, 1, 1, 2))) or str(broken.path)
    return path if is_endless(path) else wrapped(broken, path)


def wrapped(broken: Broken, path: str) -> str:
    """A path in one to three of those, each in the one before."""
    for number in range(broken.random.choice((1, 2, 3))):
        path = broken.random.choice((_zipped, _in_vrt, _inline, _by_vrt))(broken, path, number)
    return path


def _zipped(broken: Broken, path: str, number: int) -> str:
    archive = broken.renamed(f"packed{number}.zip")
    with zipfile.ZipFile(archive, "w") as file:
        if "\0" not in path and len(path) < 200 and Path(path).is_file() and path.startswith(str(broken.folder)):
            file.write(path, Path(path).name)
            return f"/vsizip/{archive}/{Path(path).name}"
        file.writestr("inner.vrt", _vrt(path))
    return f"/vsizip/{broken.random.choice(('', '{'))}{archive}/inner.vrt".replace("{" + str(archive), f"{{{archive}}}")


def _in_vrt(broken: Broken, path: str, number: int) -> str:
    made = broken.renamed(f"outer{number}.vrt")
    made.write_text(_vrt(path), encoding="utf-8", errors="surrogateescape")
    return str(made)


def _inline(broken: Broken, path: str, number: int) -> str:
    return _vrt(path)


def _by_vrt(broken: Broken, path: str, number: int) -> str:
    if not Path(path[:200].partition("\0")[0]).is_file():
        return f"vrt://{path}"
    copy = broken.renamed(f"copy{number}" + broken.random.choice(("].tif", "<.tif", ">.tif", "&amp;.tif", " '\".tif")))
    shutil.copy(path.partition("\0")[0], copy)
    return f"vrt://{copy}"


def _vrt(path: str) -> str:
    """Names a path, written as XML wants it."""
    for sign, written in (("&", "&amp;"), ("<", "&lt;"), (">", "&gt;"), ("\0", "")):
        path = path.replace(sign, written)
    return (
        '<VRTDataset rasterXSize="256" rasterYSize="256"><GeoTransform>400000,0.1,0,5000000,0,-0.1</GeoTransform>'
        '<VRTRasterBand dataType="Byte" band="1"><SimpleSource>'
        f"<SourceFilename>{path}</SourceFilename><SourceBand>1</SourceBand>"
        "</SimpleSource></VRTRasterBand></VRTDataset>"
    )
