"""``make demo DATA=folder``: a folder of one's own rasters is inspected, in a process of its own."""
from __future__ import annotations

import csv
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from qgis.core import QgsVectorLayer

from tests.numbers.synthetic import orthoimage, write_plain, write_raster
from tests.qgis.scenes import Scene, layer, line, saved


@pytest.fixture
def folder(scene: Scene, tmp_path: Path) -> Path:
    """The scene with its seam, and rasters that are no orthoimages of it: labels, a mask, heights, a picture."""
    made = tmp_path / "data"
    made.mkdir()
    for path in (scene.mosaic, scene.west, scene.east):
        shutil.copy(path, made)
    grey = orthoimage((256, 512))[0]
    labels = np.where(np.arange(512) < 256, 1, 2).astype(np.uint8) * np.ones((256, 1), np.uint8)
    write_raster(made / "source_label.tif", labels)
    write_raster(made / "coloured_label.tif", np.stack([labels, 50 * labels, 100 - labels]))
    write_raster(made / "heights.tif", grey.astype(np.float32))
    write_plain(made / "sketch.png", grey)
    (made / "broken.tif").write_bytes(b"II*\0")
    saved(layer("LineString", [line((200, 0), (300, 256))]), made / "seamlines.gpkg")
    return made


def demo(repository: Path, folder: Path, output: Path, *options: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "PYTHONPATH": str(repository / "build" / "plugins")}
    return subprocess.run(
        [sys.executable, "-m", "demo.run", "--output", str(output), "--data", str(folder), *options],
        cwd=repository, env=environment, capture_output=True, text=True, timeout=300, check=False,
    )  # fmt: skip


def rasters_of_curves(output: Path) -> set[str]:
    with open(output / "curves.csv", newline="", encoding="utf-8") as file:
        return {row["raster"] for row in csv.DictReader(file) if row["role"] == "source"}


def count(output: Path, name: str) -> int:
    return int(QgsVectorLayer(f"{output / 'windows.gpkg'}|layername={name}", name, "ogr").featureCount())


@pytest.mark.usefixtures("qgis_app")
def test_a_folder_of_ones_own(repository: Path, folder: Path, tmp_path: Path) -> None:
    finished = demo(repository, folder, tmp_path / "out")
    assert finished.returncode == 0, finished.stdout + finished.stderr
    assert (count(tmp_path / "out", "placed"), count(tmp_path / "out", "inspected")) == (2, 2)
    assert rasters_of_curves(tmp_path / "out") - {"composite"} == {"west.tif", "east.tif"}
    left_out = "broken.tif, coloured_label.tif, heights.tif, sketch.png, source_label.tif"
    assert f"No orthoimages of mosaic.tif: {left_out}\n" in finished.stdout
    assert "2 windows placed along 1 seams." in finished.stdout
    assert (tmp_path / "out" / "curves.png").stat().st_size > 0
    again = demo(repository, folder, tmp_path / "out")
    assert again.returncode == 0, again.stdout + again.stderr


@pytest.mark.usefixtures("qgis_app")
def test_an_algorithms_own_error_is_shown(repository: Path, folder: Path, tmp_path: Path) -> None:
    saved(layer("LineString", []), folder / "seamlines.gpkg")
    finished = demo(repository, folder, tmp_path / "out")
    assert finished.returncode != 0
    assert "The seamline layer holds no line and no polygon" in finished.stdout
    assert "placewindows failed." in finished.stderr
    assert "Traceback" not in finished.stderr


@pytest.mark.usefixtures("qgis_app")
@pytest.mark.release
def test_brighton(repository: Path, data_folder: Path, tmp_path: Path) -> None:
    finished = demo(repository, data_folder / "seams" / "brighton", tmp_path, "--spacing", "40")
    assert finished.returncode == 0, finished.stdout + finished.stderr
    for mosaic in ("mosaic_feather0p4m", "mosaic_hardseam"):
        assert count(tmp_path / mosaic, "inspected") == count(tmp_path / mosaic, "placed") > 0
        assert "source_label.tif" not in rasters_of_curves(tmp_path / mosaic)
        assert f"No orthoimages of {mosaic}.tif: source_label.tif\n" in finished.stdout
