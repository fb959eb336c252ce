"""The algorithms and the model from the command line, by the real ``qgis_process``."""
from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest
from qgis.core import QgsCoordinateTransformContext, QgsVectorFileWriter, QgsVectorLayer
from seam_inspector.plugin.sensors.measure.rpc import write_rpc

from tests.numbers.sensors.sensor_scenes import made_rational, places
from tests.qgis.qgis_processes import NEEDED, PROGRAM, environment
from tests.qgis.runs import assert_sentence
from tests.qgis.scenes import Scene, layer, line

pytestmark = [pytest.mark.slow, NEEDED]

Finished = subprocess.CompletedProcess[str]
Process = Callable[..., Finished]


@pytest.fixture(scope="module")
def qgis_process(repository: Path, tmp_path_factory: pytest.TempPathFactory) -> Process:
    """Runs qgis_process with settings of its own, in which the plugin is enabled."""
    variables = environment(repository, tmp_path_factory.mktemp("settings"))

    def call(*arguments: str) -> Finished:
        return subprocess.run(
            [str(PROGRAM), *arguments], env=variables, capture_output=True, text=True, timeout=300, check=False
        )

    assert "seam_inspector" in call("plugins", "enable", "seam_inspector").stdout
    return call


@pytest.fixture(scope="module")
def seamlines(scene: Scene, tmp_path_factory: pytest.TempPathFactory) -> str:
    """A seam down the middle of the scene, as a file."""
    path = str(tmp_path_factory.mktemp("seams") / "seams.gpkg")
    drawn = layer("LineString", [line((200, 0), (300, 256))])
    QgsVectorFileWriter.writeAsVectorFormatV3(
        drawn, path, QgsCoordinateTransformContext(), QgsVectorFileWriter.SaveVectorOptions()
    )
    return path


@pytest.fixture(scope="module")
def inspected(qgis_process: Process, scene: Scene, seamlines: str, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the tables that the model of the plugin gives of windows along the seam."""
    folder = tmp_path_factory.mktemp("inspected")
    run = qgis_process(
        "run", "seaminspector:inspect_mosaic", *model_inputs(scene, seamlines),
        *(f"--inspect:{name}={folder / name}.gpkg" for name in ("windows", "curves", "pairs")),
    )
    assert run.returncode == 0, run.stderr
    return folder


def model_inputs(scene: Scene, seamlines: str) -> list[str]:
    sources = [f"--sources={path}" for path in scene.sources]
    return [f"--seamlines={seamlines}", f"--mosaic={scene.mosaic}", *sources, "--side=6.4", "--spacing=6.4"]


def verdicts(path: Path | str) -> list[str]:
    opened = QgsVectorLayer(str(path), "result", "ogr")
    assert opened.isValid()
    return [feature["verdict"] for feature in opened.getFeatures()]


def test_list_and_help(qgis_process: Process) -> None:
    said = qgis_process("list")
    assert said.returncode == 0
    for name in ("placewindows", "inspectwindows", "predictloss", "inspect_mosaic"):
        assert f"seaminspector:{name}" in said.stdout
    described = qgis_process("help", "seaminspector:inspectwindows").stdout
    names = "MOSAIC SOURCES SOURCE_INDEX WAVELET LEVELS REFERENCE CELLS MIN_KEPT MAX_RATIO DIRECTIONS SCHEDULER".split()
    for name in ("WINDOWS", *names, "OUTPUT", "CURVES", "PAIRS", "PROFILES"):
        assert f"\n{name}: " in described
    assert "SIGNIFICANT_COUNT" in described


def test_place_and_inspect(qgis_process: Process, scene: Scene, seamlines: str, tmp_path: Path) -> None:
    """A source that is missing does not stop the run."""
    names = ("placed.gpkg", "inspected.gpkg", "curves.csv", "profiles.csv")
    placed, inspected, curves, profiles = (tmp_path / name for name in names)
    run = qgis_process(
        "run", "seaminspector:placewindows", f"--SEAMLINES={seamlines}", f"--MOSAIC={scene.mosaic}",
        "--SIDE=6.4", "--SPACING=6.4", f"--OUTPUT={placed}",
    )
    assert run.returncode == 0, run.stderr
    assert QgsVectorLayer(str(placed), "placed", "ogr").featureCount() == 4
    run = qgis_process(
        "run", "--json", "seaminspector:inspectwindows", f"--WINDOWS={placed}", f"--MOSAIC={scene.mosaic}",
        "--SOURCES=/nowhere/lost.tif", *(f"--SOURCES={path}" for path in scene.sources),
        "--WAVELET=db4", "--LEVELS=2", f"--OUTPUT={inspected}",
        f"--CURVES={curves}", f"--PROFILES={profiles}", "--REFERENCE=sources", "--MIN_KEPT=0.6",
    )
    assert run.returncode == 0, run.stderr
    assert "lost.tif is left out: /nowhere/lost.tif does not exist" in run.stdout + run.stderr
    results = json.loads(run.stdout[run.stdout.index("{") :])["results"]
    assert results["WINDOW_COUNT"] == 4
    assert verdicts(inspected) == ["reduced"] * 3 + ["significant"]
    assert results["SIGNIFICANT_COUNT"] == 1
    assert profiles.read_text(encoding="utf-8").splitlines()[0] == "window_id,level,distance,kept,low,high,area,mixture"
    header, *rows = curves.read_text(encoding="utf-8").splitlines()
    assert header == "window_id,raster,role,band,component,level,relative_variance,variance"
    assert len(rows) == 4 * 4 * 4 * 3  # windows, rasters with the composite, bands, components


def test_the_model_by_its_id(inspected: Path) -> None:
    result = verdicts(inspected / "windows.gpkg")
    assert (result[0], result[-1], len(result)) == ("preserved", "significant", 4)
    assert QgsVectorLayer(str(inspected / "curves.gpkg"), "curves", "ogr").featureCount() == 4 * 4 * 4 * 4
    assert QgsVectorLayer(str(inspected / "pairs.gpkg"), "pairs", "ogr").featureCount() == 4 * 3 * 4


def test_the_models_file(
    qgis_process: Process, scene: Scene, seamlines: str, inspected: Path, tmp_path: Path, repository: Path
) -> None:
    file, result = repository / "resources" / "models" / "inspect_mosaic.model3", tmp_path / "windows.gpkg"
    run = qgis_process("run", str(file), *model_inputs(scene, seamlines), f"--inspect:windows={result}")
    assert run.returncode == 0, run.stderr
    assert verdicts(result) == verdicts(inspected / "windows.gpkg")


def test_bad_input_ends_with_a_sentence_and_a_failure(
    qgis_process: Process, scene: Scene, seamlines: str, tmp_path: Path
) -> None:
    for name, arguments, words in (
        ("inspectwindows", [f"--WINDOWS={seamlines}", f"--MOSAIC={scene.mosaic}"], "No sources are given"),
        (  # found while it runs, the other before
            "inspectwindows",
            [f"--WINDOWS={seamlines}", f"--MOSAIC={scene.mosaic}", f"--SOURCES={scene.west}", "--SCHEDULER=nowhere"],
            "Dask",
        ),
    ):
        run = qgis_process("run", f"seaminspector:{name}", *arguments, f"--OUTPUT={tmp_path / 'out.gpkg'}")
        assert run.returncode != 0
        said = [row.replace("ERROR:", "").strip() for row in run.stderr.splitlines() if re.search(words, row)]
        assert said, run.stderr
        assert_sentence(said[0], words)
        assert "Traceback" not in run.stdout + run.stderr
        assert not (tmp_path / "out.gpkg").exists()


def test_every_sensor_model_is_fitted_with_the_libraries_that_qgis_has(qgis_process: Process, tmp_path: Path) -> None:
    ground, rpc = places(16, 3), made_rational(3, 5, 0.001)
    write_rpc(rpc, tmp_path / "vendor_RPC.TXT")
    image = rpc.project(ground) + [3.5, -1.25]
    members = [
        {"type": "Feature", "properties": {"column": column, "row": row},
         "geometry": {"type": "Point", "coordinates": position}}
        for (column, row), position in zip(image.tolist(), ground.tolist())
    ]  # fmt: skip
    points, table = tmp_path / "gcps.geojson", tmp_path / "models.csv"
    points.write_text(json.dumps({"type": "FeatureCollection", "features": members}), encoding="utf-8")
    run = qgis_process(
        "run", "--json", "seaminspector:comparesensormodels", f"--GCPS={points}", f"--OUTPUT={table}",
        f"--IMAGE_RPC={tmp_path / 'vendor_RPC.TXT'}",
    )
    assert run.returncode == 0, run.stderr
    results = json.loads(run.stdout[run.stdout.index("{") :])["results"]
    assert results["RECOMMENDED"] == "rpc_bias shift"
    assert re.search(r"^pushbroom,.*[1-9]", table.read_text(encoding="utf-8"), re.M)
