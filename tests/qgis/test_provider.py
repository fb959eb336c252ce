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
    QgsProcessing,
    QgsProcessingModelAlgorithm,
    QgsProcessingModelChildAlgorithm,
    QgsProcessingModelChildParameterSource,
    QgsProcessingModelOutput,
    QgsProcessingModelParameter,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterMultipleLayers,
    QgsProcessingParameterRasterLayer,
    QgsProcessingProvider,
    QgsProject,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import QSize

from tests.qgis.runs import Log, Run, algorithm, assert_refused, assert_sentence, run
from tests.qgis.scenes import BLURRED, SHARP, Scene, layer, line, pixel_box, windows

GROUPS = {
    "Seam inspection": (
        "placewindows",
        "inspectwindows",
        "scanmosaic",
        "mendseams",
        "checkdelivery",
        "planinspection",
        "acceptmosaic",
        "predictloss",
        "calibratethreshold",
        "report",
        "inspect_mosaic",
        "accept_delivery",
    ),
    "Image quality": ("checknoise", "checkradiometry"),
    "Ground resolution": ("measureresolution", "minimumheight", "simulatebayer"),
    "Interior orientation of photos": ("interiororientation", "comparemarks", "enhancephoto"),
    "Satellite images": (
        "fitsensormodel", "comparesensormodels", "orthorectify", "orthorectifyphotos", "planpoints",
    ),
}
NAMES = [name for names in GROUPS.values() for name in names]
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
    assert sorted(named) == sorted((one.displayName(), one.name(), one.id()) for one in provider.algorithms())


def test_every_algorithm_says_what_it_does(provider: QgsProcessingProvider) -> None:
    assert len({one.groupId() for one in provider.algorithms()}) == len(GROUPS)  # else the toolbox shows one twice
    for one in provider.algorithms():
        assert one.name() in GROUPS[one.group()]
        assert one.displayName()
        assert len(one.shortHelpString()) > 80
        assert one.canExecute() == (True, "")
        assert one.create().id() == one.id()


@pytest.mark.parametrize("name", NAMES)
def test_every_parameter_has_help(provider: QgsProcessingProvider, name: str) -> None:
    definitions = provider.algorithm(name).parameterDefinitions()
    assert [definition.name() for definition in definitions if not definition.help()] == []


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


def test_without_pywavelets_it_loads_and_explains(repository: Path, tmp_path: Path) -> None:
    after = "print(len(registry.providerById('seaminspector').algorithms()), *registry.createAlgorithmById("
    after += "'seaminspector:inspectwindows').canExecute(), sep='|')"
    count, can, sentence = in_a_new_qgis(repository, tmp_path, "sys.modules['pywt'] = None", after).split("|")
    assert (count, can) == (str(len(IDS)), "False")
    assert_sentence(sentence, "PyWavelets")


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


def from_input(name: str) -> list[QgsProcessingModelChildParameterSource]:
    return [QgsProcessingModelChildParameterSource.fromModelParameter(name)]


def fixed(value: object) -> list[QgsProcessingModelChildParameterSource]:
    return [QgsProcessingModelChildParameterSource.fromStaticValue(value)]


def drawn_model() -> QgsProcessingModelAlgorithm:
    """Our two algorithms as a user joins them in the modeler."""
    model = QgsProcessingModelAlgorithm("drawn", "tests")
    for definition in (
        QgsProcessingParameterFeatureSource("seams", "seams"),
        QgsProcessingParameterRasterLayer("mosaic", "mosaic"),
        QgsProcessingParameterMultipleLayers("sources", "sources", QgsProcessing.SourceType.TypeRaster),
    ):
        model.addModelParameter(definition, QgsProcessingModelParameter(definition.name()))
    place = QgsProcessingModelChildAlgorithm("seaminspector:placewindows")
    place.setChildId("place")
    for name, sources in {
        "SEAMLINES": from_input("seams"), "MOSAIC": from_input("mosaic"),
        "SIDE": fixed(6.4), "SPACING": fixed(6.4), "LEVELS": fixed(2),
    }.items():
        place.addParameterSources(name, sources)
    model.addChildAlgorithm(place)
    inspect = QgsProcessingModelChildAlgorithm("seaminspector:inspectwindows")
    inspect.setChildId("inspect")
    for name, sources in {
        "WINDOWS": [QgsProcessingModelChildParameterSource.fromChildOutput("place", "OUTPUT")],
        "MOSAIC": from_input("mosaic"), "SOURCES": from_input("sources"),
        "WAVELET": fixed("db2"), "LEVELS": fixed(2), "MAX_RATIO": fixed(0.4),
    }.items():
        inspect.addParameterSources(name, sources)
    output = QgsProcessingModelOutput("inspected", "inspected")
    output.setChildId("inspect")
    output.setChildOutputName("OUTPUT")
    inspect.setModelOutputs({"inspected": output})
    model.addChildAlgorithm(inspect)
    return model


def direct(scene: Scene, levels: int = 3, **parameters: Any) -> Run:
    """Both steps of the model one by one."""
    placed = run(
        "placewindows", SEAMLINES=seam(), MOSAIC=str(scene.mosaic), SIDE=6.4, SPACING=6.4, LEVELS=levels
    )
    return run(
        "inspectwindows", WINDOWS=placed.layer(), MOSAIC=str(scene.mosaic), SOURCES=scene.sources, LEVELS=levels,
        **parameters,
    )


@pytest.mark.usefixtures("provider")
def test_a_model_of_our_algorithms_is_valid_and_runs(scene: Scene) -> None:
    model = drawn_model()
    assert model.validate() == (True, [])
    again = QgsProcessingModelAlgorithm()
    assert again.loadVariant(model.toVariant())
    assert again.validate() == (True, [])
    expected = direct(scene, levels=2, WAVELET="db2", MAX_RATIO=0.4)
    for one in (model, again):
        outcome = run(one, seams=seam(), mosaic=str(scene.mosaic), sources=scene.sources)
        assert outcome.complaint is None
        (name,) = (key for key in outcome.results if key.endswith("inspected"))
        assert outcome.rows(name) == expected.rows()
        assert len(outcome.rows(name)) == 4


@pytest.mark.usefixtures("provider")
def test_the_ready_model_is_valid_and_runs(scene: Scene, repository: Path) -> None:
    model = QgsProcessingModelAlgorithm()
    assert model.fromFile(str(repository / "resources" / "models" / "inspect_mosaic.model3"))
    for one in (model, algorithm("inspect_mosaic")):
        assert one.validate() == (True, [])
        names = {definition.name() for definition in one.parameterDefinitions()}
        assert {"seamlines", "mosaic", "sources", "source_index", "side", "spacing", "levels"} <= names
    outcome = run(
        "inspect_mosaic", seamlines=seam(), mosaic=str(scene.mosaic), sources=scene.sources, side=6.4, spacing=6.4
    )
    assert outcome.complaint is None
    expected = direct(scene)
    tables = {"windows": "OUTPUT", "curves": "CURVES", "pairs": "PAIRS", "profiles": "PROFILES"}
    for name, table in tables.items():
        assert outcome.rows(f"inspect:{name}") == expected.rows(table)
    assert [pixel_box(feature.geometry()) for feature in outcome.features("inspect:windows")] == [
        pixel_box(feature.geometry()) for feature in expected.features()
    ]
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


@pytest.mark.usefixtures("loading")
def test_the_models_windows_are_styled_too(scene: Scene, project: QgsProject) -> None:
    import processing

    given = {"seamlines": seam(), "mosaic": str(scene.mosaic), "sources": scene.sources, "side": 6.4, "spacing": 6.4}
    outputs = dict.fromkeys(("inspect:windows", "inspect:curves", "inspect:pairs"), "TEMPORARY_OUTPUT")
    results = processing.runAndLoadResults("seaminspector:inspect_mosaic", {**given, **outputs})
    assert len(project.mapLayers()) == 3
    assert project.mapLayer(results["inspect:windows"]).renderer().type() == "categorizedSymbol"


@pytest.mark.usefixtures("provider")
def test_the_style_of_verdicts_loads_on_the_output(scene: Scene, repository: Path, tmp_path: Path) -> None:
    outcome = run(
        "inspectwindows", WINDOWS=windows(SHARP, BLURRED, (0, 0, 9, 9)), MOSAIC=str(scene.mosaic),
        SOURCES=scene.sources, OUTPUT=str(tmp_path / "inspected.gpkg"),
    )
    loaded = outcome.layer()
    message, worked = loaded.loadNamedStyle(str(repository / "resources" / "styles" / "windows.qml"))
    assert worked, message
    renderer = loaded.renderer()
    categories = {category.value(): category for category in renderer.categories()}
    assert list(categories)[:4] == VERDICTS
    assert all(category.label() and category.symbol() for category in categories.values())
    drawn = [category.symbol().asImage(QSize(32, 32)) for category in categories.values()]
    assert all(one != other for index, one in enumerate(drawn) for other in drawn[:index])
    for row in outcome.rows():
        assert renderer.categoryIndexForValue(row["verdict"]) == VERDICTS.index(row["verdict"])


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
