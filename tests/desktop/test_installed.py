"""The plugin's zip in an empty profile of the real QGIS, as a stranger installs it: the desktop, then qgis_process."""
from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import pytest

from tests.desktop.conftest import played
from tests.qgis.qgis_processes import PROGRAM
from tests.releases import built, cloned

pytestmark = pytest.mark.slow

SIDE_M = 25.0
ENGLISH = "Inspect how much detail a mosaic kept along its seams"


@pytest.fixture(scope="module")
def package(repository: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The zip that SEAM_INSPECTOR_PACKAGE names, where another machine made it, or one of the last commit."""
    made = os.environ.get("SEAM_INSPECTOR_PACKAGE")
    if made:
        return Path(made).resolve()
    return built(cloned(repository, tmp_path_factory.mktemp("clone") / "seam-inspector"), "make_package")


def test_a_stranger_installs_and_uses_it(package: Path, small_block: Path, tmp_path: Path, screenshots: Path) -> None:
    """With the translation that the zip brings, and without a word in QGIS's log.

    What the desk does by itself is cancelled and not asked about when QGIS closes.
    """
    parameters = {"package": package, "block": small_block, "side_m": SIDE_M, "screenshots": screenshots}
    run = played("installed", tmp_path, parameters, locale="pl", linked=False)
    assert "A dialog keeps QGIS" not in run.output, run.output
    assert run.report["provider"]
    assert set(run.report["verdicts"]) & {"significant", "reduced", "preserved"}
    assert run.report["tooltip"] != ENGLISH
    assert [line for line in run.report["noted"] if is_ours(line)] == []
    if PROGRAM is not None:
        use_from_the_command_line(PROGRAM, tmp_path / "profiles", small_block, tmp_path / "placed.gpkg")


def is_ours(noted: str) -> bool:
    """Whether a line of QGIS's log is about the plugin; with Python 3.14 QGIS's own installer is told of old ways."""
    is_own_code = "plugins/seam_inspector/" in noted or noted.startswith("Seam Inspector")
    return is_own_code or ("python" in noted.lower() and "DeprecationWarning" not in noted)


def use_from_the_command_line(program: str, profiles: Path, block: Path, output: Path) -> None:
    """The profile has the plugin enabled, since the desktop installed it."""
    settings = {"QT_QPA_PLATFORM": "offscreen", "QGIS_CUSTOM_CONFIG_PATH": str(profiles)}
    unwanted = ("PYTHONPATH", "QGIS_PLUGINPATH")
    environment = {name: value for name, value in os.environ.items() if name not in unwanted} | settings
    command = [
        program, "--json", "run", "seaminspector:placewindows",
        f"--SEAMLINES={block}/seamlines.gpkg|layername=seamlines", f"--MOSAIC={block}/mosaic.tif",
        f"--SIDE={SIDE_M}", f"--SPACING={2 * SIDE_M}", f"--OUTPUT={output}",
    ]  # fmt: skip
    run = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=300, check=False)
    assert run.returncode == 0, run.stdout + run.stderr
    assert "Traceback" not in run.stdout + run.stderr
    assert json.loads(run.stdout[run.stdout.index("{") :])["results"]["OUTPUT"] == str(output)
    assert output.exists()
