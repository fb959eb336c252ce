"""``seaminspector:scanmosaic`` by the real ``qgis_process``, which is killed once."""
from __future__ import annotations

import json
import signal
import subprocess
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from osgeo import gdal
from qgis.core import QgsVectorLayer

from tests.qgis.qgis_processes import NEEDED, PROGRAM, environment
from tests.qgis.runs import assert_sentence
from tests.qgis.seams.scan_scenes import Files, images, write_scene

pytestmark = [pytest.mark.slow, NEEDED]

Started = Callable[..., "subprocess.Popen[str]"]
PATIENCE_SECONDS = 60


@pytest.fixture(scope="module")
def start(repository: Path, tmp_path_factory: pytest.TempPathFactory) -> Started:
    """Starts qgis_process with settings of its own, in which the plugin is enabled."""
    own = environment(repository, tmp_path_factory.mktemp("settings"))

    def call(*arguments: str) -> subprocess.Popen[str]:
        return subprocess.Popen(
            [str(PROGRAM), *arguments], env=own, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
        )

    call("plugins", "enable", "seam_inspector").communicate(timeout=PATIENCE_SECONDS)
    return call


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> Files:
    """Files of a mosaic of 8 blocks."""
    return write_scene(tmp_path_factory.mktemp("long"), images((600, 15000), bands=1), width=16.0)


def arguments(files: Files, folder: Path) -> list[str]:
    folder.mkdir()
    return [
        "run", "--json", "seaminspector:scanmosaic", f"--MOSAIC={files.mosaic}",
        *(f"--SOURCES={path}" for path in files.sources), "--PIECE=20", f"--LOSS={folder / 'loss.tif'}",
        *(f"--{name}={folder / name}.gpkg" for name in ("SEAMS", "CELLS", "WORST")),
    ]


def test_it_goes_on_where_it_was_killed(start: Started, files: Files, tmp_path: Path) -> None:
    whole = start(*arguments(files, tmp_path / "whole"))
    said, errors = whole.communicate(timeout=PATIENCE_SECONDS)
    assert whole.returncode == 0, errors
    results = json.loads(said[said.index("{") :])["results"]
    assert results["SEAM_METRES"] > 50, errors
    assert results["FAILED_METRES"] <= results["SEAM_METRES"]
    asked = arguments(files, tmp_path / "killed")
    journal = tmp_path / "killed" / "loss.tif.scan"
    first = start(*asked)
    deadline = time.monotonic() + PATIENCE_SECONDS
    while not list(journal.glob("block*")) and time.monotonic() < deadline:
        time.sleep(0.005)
    first.send_signal(signal.SIGKILL)
    first.communicate()
    assert journal.exists()
    said, errors = start(*asked).communicate(timeout=PATIENCE_SECONDS)
    assert "goes on where it stopped" in said + errors
    assert json.loads(said[said.index("{") :])["results"]["SEAM_METRES"] == results["SEAM_METRES"]
    ours, theirs = (tmp_path / name / "loss.tif" for name in ("killed", "whole"))
    assert ours.read_bytes() == theirs.read_bytes()
    assert gdal.Open(str(ours)).RasterCount == 5
    for name in ("SEAMS", "CELLS", "WORST"):
        rows = [[feature.attributes() for feature in QgsVectorLayer(str(folder / f"{name}.gpkg"), name, "ogr")
                 .getFeatures()] for folder in (ours.parent, theirs.parent)]
        assert rows[0] == rows[1]
        assert rows[0]


def test_bad_input_ends_with_a_sentence(start: Started, files: Files, tmp_path: Path) -> None:
    run = start(*arguments(files, tmp_path / "none"), "--CELL=48")
    said, errors = run.communicate(timeout=PATIENCE_SECONDS)
    assert run.returncode != 0
    (sentence,) = {row.replace("ERROR:", "").strip() for row in errors.splitlines() if "48" in row}
    assert_sentence(sentence, "no cells of 48 pixels")
    assert "Traceback" not in said + errors
    assert list((tmp_path / "none").iterdir()) == []
