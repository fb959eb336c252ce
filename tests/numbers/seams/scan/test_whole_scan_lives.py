"""A scan that was stopped in any way goes on, and ends as if nothing had been."""
from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from tests.numbers.synthetic import orthoimage, write_raster

pytestmark = pytest.mark.release

ROWS, COLUMNS = 2100, 8200  # 2 x 5 blocks, the last ones small


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    """A mosaic of one band, cut hard out of two images along a crooked line that runs across, and the two."""
    folder = tmp_path_factory.mktemp("large")
    north, south = (np.tile(orthoimage((ROWS, COLUMNS // 4), bands=1, seed=seed), (1, 1, 4)) for seed in (1, 2))
    seam = ROWS / 2 + 90 * np.sin(np.arange(COLUMNS) / 300)
    mosaic = np.where(np.arange(ROWS)[:, np.newaxis] < seam, north, south)
    options = ["TILED=YES"]
    return [write_raster(folder / f"{name}.tif", pixels, options=options)
            for name, pixels in (("mosaic", mosaic), ("north", north), ("south", south))]


@pytest.mark.skipif(os.name == "nt", reason="no SIGKILL")
def test_killed_eight_times_it_ends_with_the_same_bytes(files: list[str], tmp_path: Path) -> None:
    undisturbed, killed = tmp_path / "undisturbed.tif", tmp_path / "killed.tif"
    first, second = (
        subprocess.run(
            [sys.executable, "-m", "tests.numbers.seams.scan.whole_scan_lives", str(loss), "1", lives, *files],
            capture_output=True, text=True, timeout=300, check=True, env={**os.environ, "OPENBLAS_NUM_THREADS": "1"},
        ).stdout.splitlines()
        for loss, lives in ((undisturbed, "0"), (killed, "8"))
    )
    assert len(first) == 4
    assert first[1].count("Verdict") > 30
    assert second[-3:] == first[1:]
    assert sum("continues where it stopped" in line for line in second) >= 4, second[:-3]
    assert killed.read_bytes() == undisturbed.read_bytes()
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted(
        f"{name}{ending}" for name in ("killed.tif", "undisturbed.tif") for ending in ("", ".aux.xml")
    )
