"""The memory of a scan does not grow with the number of its blocks."""
from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from tests.numbers.synthetic import UTM33, orthoimage, wkt, write_raster

pytestmark = pytest.mark.release

SIDE = 2048  # side of the tile that is repeated, px: a block
PROGRAM = """
import re, sys
from pathlib import Path
from tests.numbers.seams.scan.whole_scan_lives import request_of, scanned
result = scanned(request_of(*sys.argv[2:]), Path(sys.argv[1]))[1]
peak = re.search(r"VmHWM:\\s+(\\d+)", Path("/proc/self/status").read_text())
print(int(peak.group(1)) // 1024, len(result.pieces))
"""
MOST_MORE_MB = 30  # memory of the largest scan beyond that of the smaller one: what is kept of longer seams, and noise


def repeated(path: Path, times: int) -> str:
    """A VRT that shows a raster as often along both sides."""
    parts = "".join(
        f'<SimpleSource><SourceFilename relativeToVRT="1">{path.name}</SourceFilename><SourceBand>1</SourceBand>'
        f'<SrcRect xOff="0" yOff="0" xSize="{SIDE}" ySize="{SIDE}"/><DstRect xOff="{column * SIDE}" '
        f'yOff="{row * SIDE}" xSize="{SIDE}" ySize="{SIDE}"/></SimpleSource>'
        for row in range(times) for column in range(times)
    )
    system = wkt(UTM33).replace("&", "&amp;").replace('"', "&quot;")
    made = path.with_name(f"{path.stem}_{times}.vrt")
    made.write_text(
        f'<VRTDataset rasterXSize="{times * SIDE}" rasterYSize="{times * SIDE}"><SRS>{system}</SRS>'
        f'<GeoTransform>500000, 0.1, 0, 5000000, 0, -0.1</GeoTransform><VRTRasterBand dataType="Byte" band="1">{parts}'
        "</VRTRasterBand></VRTDataset>", encoding="utf-8",
    )
    return str(made)


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="the peak of memory is read from /proc")
def test_memory_is_the_same_for_few_blocks_and_many(tmp_path: Path) -> None:
    west, east = (orthoimage((SIDE, SIDE), bands=1, seed=seed) for seed in (1, 2))
    seam = 600 + 90 * np.sin(np.arange(SIDE) / 300)
    mosaic = np.where(np.arange(SIDE) < seam[:, np.newaxis], west, east)
    for name, pixels in (("mosaic", mosaic), ("west", west), ("east", east)):
        write_raster(tmp_path / f"{name}.tif", pixels, options=["TILED=YES"])
    peaks = {}
    for times in (2, 4):
        files = [repeated(tmp_path / f"{name}.tif", times) for name in ("mosaic", "west", "east")]
        ended = subprocess.run(
            [sys.executable, "-c", PROGRAM, str(tmp_path / "loss.tif"), *files],
            env={**os.environ, "GDAL_CACHEMAX": "64", "MALLOC_ARENA_MAX": "1"},  # holes between threads' are noise
            capture_output=True, text=True, timeout=300, check=True,
        )
        peaks[times], pieces = map(int, ended.stdout.split()[-2:])
        assert pieces >= times * times * 8
    assert peaks[4] < peaks[2] + MOST_MORE_MB, peaks
    assert peaks[4] < 600, peaks
