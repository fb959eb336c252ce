"""What QGIS sees of the plugin: its provider, its models, its styles, and how it comes and goes."""
from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from osgeo import gdal
from qgis.core import (
    QgsProcessingModelAlgorithm,
    QgsProcessingProvider,
    QgsProject,
    QgsVectorLayer,
)

from tests.qgis.runs import Log, algorithm, assert_refused, assert_sentence, run
from tests.qgis.scenes import BLURRED, SHARP, Scene, layer, line, windows
from tests.qgis.test_contract import NAMES

IDS = {f"seaminspector:{name}" for name in NAMES}
VERDICTS = ["significant", "reduced", "preserved", "not_comparable"]
SEAM = ((200, 0), (300, 256))


def seam() -> QgsVectorLayer:
    return layer("LineString", [line(*SEAM)])


# --- the provider ----------------------------------------------------------------------------------------------


def test_what_the_provider_offers(provider: QgsProcessingProvider) -> None:
    assert {algorithm.id() for algorithm in provider.algorithms()} == IDS
    assert provider.name() == "Seam Inspector"
    assert not provider.icon().isNull()
    assert os.path.isfile(provider.svgIconPath())


def test_the_guide_names_what_the_provider_offers(repository: Path, provider: QgsProcessingProvider) -> None:
    page = (repository / "docs" / "algorithms" / "index.md").read_text(encoding="utf-8")
    named = re.findall(r"^\| \[(.+)\]\((\w+)\.md\) \| `(seaminspector:\w+)` \|", page, re.MULTILINE)
    assert sorted(named) == sorted((job.displayName(), job.name(), job.id()) for job in provider.algorithms())


# --- start-up, in a QGIS of its own ----------------------------------------------------------------------------

START = """
import sys
BEFORE
from qgis.core import QgsApplication
application = QgsApplication([], False)
application.initQgis()
qgis_own = set(sys.modules)
from seam_inspector import classFactory
plugin = classFactory(None)
plugin.initProcessing()
registry = QgsApplication.processingRegistry()
AFTER
plugin.unload()
application.exitQgis()
"""


def in_a_new_qgis(repository: Path, settings: Path, before: str, after: str) -> str:
    """What Python says in a QGIS without interface that loads nothing but our plugin."""
    code = START.replace("BEFORE", before).replace("AFTER", after)
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "QGIS_CUSTOM_CONFIG_PATH": str(settings)}
    environment["PYTHONPATH"] = str(repository / "build" / "plugins")
    finished = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, env=environment, timeout=300, check=False
    )
    assert finished.returncode == 0, finished.stderr
    assert "Traceback" not in finished.stderr
    return finished.stdout.strip()


def test_start_up_imports_nothing_heavy(repository: Path, tmp_path: Path) -> None:
    heavy = {"pywt", "scipy", "matplotlib", "distributed", "dask", "numpy"}
    after = "print(len(registry.providerById('seaminspector').algorithms()), "
    after += f"sorted({heavy} & (set(sys.modules) - qgis_own)))"
    assert in_a_new_qgis(repository, tmp_path, "", after) == f"{len(IDS)} []"


def test_load_unload_load_leaves_the_registry_as_it_was(repository: Path, tmp_path: Path) -> None:
    after = """
from qgis.PyQt.QtCore import QObject
def offered():
    return [provider.id() for provider in registry.providers()], [one.id() for one in registry.algorithms()]
loaded = offered()
children = len(application.findChildren(QObject))
plugin.initProcessing()  # QGIS may ask twice
assert offered() == loaded
plugin.unload()
assert registry.algorithmById("seaminspector:inspectwindows") is None
before = offered()
for _ in range(3):
    plugin = classFactory(None)
    plugin.initProcessing()
    assert offered() == loaded
    plugin.unload()
    plugin.unload()
    assert offered() == before
assert len(application.findChildren(QObject)) <= children
print(loaded, before)
"""
    ours = sorted(IDS)
    said = in_a_new_qgis(repository, tmp_path, "", after)
    assert all(repr(our) in said.split("([]")[0] for our in ours)
    assert said.endswith("([], [])")


# --- models ----------------------------------------------------------------------------------------------------


@pytest.mark.usefixtures("provider")
def test_the_ready_model_is_valid_and_runs(scene: Scene, repository: Path) -> None:
    model = QgsProcessingModelAlgorithm()
    assert model.fromFile(str(repository / "resources" / "models" / "inspect_mosaic.model3"))
    for ready in (model, algorithm("inspect_mosaic")):
        assert ready.validate() == (True, [])
        names = {definition.name() for definition in ready.parameterDefinitions()}
        assert {"seamlines", "mosaic", "sources", "source_index", "side", "spacing", "levels"} <= names
    outcome = run(
        "inspect_mosaic", seamlines=seam(), mosaic=str(scene.mosaic), sources=scene.sources, side=6.4, spacing=6.4
    )
    assert outcome.complaint is None
    for table in ("curves", "pairs", "profiles"):
        assert outcome.rows(f"inspect:{table}")
    assert "significant" in outcome.column("verdict", "inspect:windows")


@pytest.mark.usefixtures("provider")
@pytest.mark.parametrize(
    ("parameters", "words"),
    [
        ({"side": 0}, r"'Window side \(metres\)' is 0; give 0\.01 or more"),
        ({"sources": []}, "No sources are given"),
        ({"side": 100}, "The window layer is empty"),  # no window fits this mosaic
    ],
)
def test_the_ready_model_fails_with_our_sentence(scene: Scene, parameters: dict[str, Any], words: str) -> None:
    given = {"seamlines": seam(), "mosaic": str(scene.mosaic), "sources": scene.sources, "side": 6.4, "spacing": 6.4}
    log = Log()
    assert run("inspect_mosaic", log, **{**given, **parameters}).complaint is not None
    assert_sentence(log.errors[0], words)
    assert "Traceback" not in "".join(log.errors)


# --- layers ----------------------------------------------------------------------------------------------------


@pytest.fixture
def loading(provider: QgsProcessingProvider, qgis_processing: None, monkeypatch: pytest.MonkeyPatch) -> None:
    """Results are loaded into the project; newer QGIS wants to show them in a real layer tree, or in none."""
    monkeypatch.setattr("processing.gui.Postprocessing.iface", None, raising=False)


@pytest.mark.usefixtures("loading")
def test_outputs_come_into_the_project_once_and_in_their_styles(
    scene: Scene, project: QgsProject, repository: Path
) -> None:
    import processing

    inspect = {"WINDOWS": windows(SHARP, BLURRED), "MOSAIC": str(scene.mosaic), "SOURCES": scene.sources}
    place = {"SEAMLINES": seam(), "MOSAIC": str(scene.mosaic), "SIDE": 6.4, "SPACING": 6.4}
    temporary = dict.fromkeys(("OUTPUT", "CURVES", "PAIRS", "PROFILES"), "TEMPORARY_OUTPUT")
    for count in (1, 2):  # the second run meets what the first one left
        inspected = processing.runAndLoadResults("seaminspector:inspectwindows", {**inspect, **temporary})
        placed = processing.runAndLoadResults("seaminspector:placewindows", {**place, "OUTPUT": "TEMPORARY_OUTPUT"})
        assert len(project.mapLayers()) == 5 * count
        loaded = project.mapLayer(inspected["OUTPUT"])
        assert loaded.renderer().type() == "categorizedSymbol"
        assert loaded.renderer().classAttribute() == "verdict"
        assert [category.value() for category in loaded.renderer().categories()][:4] == VERDICTS
        assert loaded.labelsEnabled()
        plain = QgsVectorLayer("Polygon", "plain", "memory")
        assert plain.loadNamedStyle(str(repository / "resources" / "styles" / "placed_windows.qml"))[1]
        assert project.mapLayer(placed["OUTPUT"]).renderer().dump() == plain.renderer().dump()


@pytest.mark.usefixtures("provider")
@pytest.mark.parametrize("parameter", ["mosaic", "sources"])
def test_what_must_not_be_opened_is_refused_before_qgis_loads_it(
    scene: Scene, tmp_path: Path, parameter: str
) -> None:
    path = tmp_path / "made.vrt"
    gdal.BuildVRT(str(path), [str(scene.mosaic)]).FlushCache()
    path.write_text(re.sub('Size="[0-9]+"', f'Size="{2**31 - 1}"', path.read_text(), count=2))
    given = {"seamlines": seam(), "mosaic": str(scene.mosaic), "sources": scene.sources, "side": 6.4, "spacing": 6.4}
    given[parameter] = [str(path)] if parameter == "sources" else str(path)
    assert_refused("inspect_mosaic", r"made\.vrt claims 2147483647 x 2147483647 px", **given)
