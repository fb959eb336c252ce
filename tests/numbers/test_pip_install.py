"""`pip install .`: machines that only measure, such as a cluster's workers, get what needs no QGIS."""
from __future__ import annotations

import os
import pickle
import subprocess
import venv
from pathlib import Path

import pytest
from seam_inspector.plugin.imagery.open_raster import describe, describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure.source_images import Source
from seam_inspector.plugin.seams.measure.window.inspection import Block, inspect_window, window_request
from seam_inspector.plugin.seams.measure.window.window_request import InspectionSettings
from seam_inspector.plugin.seams.measure.window.window_result import WindowResult
from seam_inspector.plugin.toolkit.executors import measuring_modules

from tests.numbers.conftest import MakeRaster
from tests.numbers.synthetic import orthoimage

pytestmark = pytest.mark.release

IMPORT_ALL = """
import importlib, pkgutil, sys
import seam_inspector
for module in pkgutil.walk_packages(seam_inspector.__path__, "seam_inspector."):
    importlib.import_module(module.name)
assert not [name for name in ("qgis", "PyQt5", "PyQt6", "matplotlib") if name in sys.modules]
print(seam_inspector.__file__)
"""
MEASURE = """
import pickle, sys
request = pickle.load(sys.stdin.buffer)
from seam_inspector.plugin.seams.measure.window.inspection import inspect_window
pickle.dump(inspect_window(request), sys.stdout.buffer)
"""
NO_BUILD_TOOL = ("No matching distribution found for hatchling", "Could not find a version that satisfies")


@pytest.fixture(scope="module")
def installed(repository: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The Python of a fresh environment, which sees the system's GDAL and numpy and has the package by pip."""
    folder = tmp_path_factory.mktemp("worker") / "venv"
    venv.create(folder, system_site_packages=True, with_pip=True)
    python = folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    command = [str(python), "-m", "pip", "install", "--quiet", "--no-deps", str(repository)]
    made = subprocess.run(command, capture_output=True, text=True, check=False, env=environment())
    if made.returncode and any(words in made.stderr for words in NO_BUILD_TOOL):
        pytest.skip("pip reaches no registry that has hatchling")
    assert made.returncode == 0, made.stderr
    return python


def environment() -> dict[str, str]:
    """Without the paths by which the tests find the checkout."""
    return {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}


def run(python: Path, code: str, given: bytes = b"") -> bytes:
    done = subprocess.run(
        [str(python), "-I", "-c", code], input=given, capture_output=True, check=False, env=environment(),
        cwd=python.parent,
    )
    assert done.returncode == 0, done.stderr.decode()
    return done.stdout


def test_all_that_is_installed_is_imported_without_qgis(installed: Path) -> None:
    place = Path(run(installed, IMPORT_ALL).decode().strip())
    assert installed.parents[1] in place.parents


def test_the_wheel_holds_what_a_cluster_is_given(installed: Path, repository: Path) -> None:
    home = Path(run(installed, "import seam_inspector; print(seam_inspector.__path__[0])").decode().strip())
    given = {path.relative_to(repository) for path in measuring_modules(repository / "plugin")}
    given |= {path.relative_to(repository) for path in (repository / "python").glob("*.py")}
    given |= {Path("plugin/toolkit/executors.py"), Path("plugin/toolkit/messages.py")}
    given |= {Path("__init__.py"), Path("plugin/__init__.py")}
    assert {path.relative_to(home) for path in home.rglob("*.py")} == given
    assert Path("plugin/seams/measure/window/inspection.py") in given


def test_requests_and_results_pass_between_plugin_and_package(installed: Path, make_raster: MakeRaster) -> None:
    seeds = {"mosaic.tif": 1, "same.tif": 1, "other.tif": 2}
    mosaic, *others = (RasterRef(make_raster(name, orthoimage((256, 256), seed=seed))) for name, seed in seeds.items())
    block = Block(describe_mosaic(mosaic), tuple(Source(ref, describe(ref).extent) for ref in others))
    request = window_request(block, 7, block.mosaic.extent, InspectionSettings())
    found = pickle.loads(run(installed, MEASURE, pickle.dumps(request)))
    assert isinstance(found, WindowResult)
    expected = inspect_window(request)
    assert found.judgement == expected.judgement
    assert found.source_count == 2


def test_the_version_is_the_plugins(installed: Path, repository: Path) -> None:
    code = "from importlib.metadata import version; print(version('seam-inspector'))"
    lines = (repository / "metadata.txt").read_text(encoding="utf-8").splitlines()
    assert f"version={run(installed, code).decode().strip()}" in lines
