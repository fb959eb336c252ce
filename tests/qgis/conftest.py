"""What the tests inside QGIS share."""
from __future__ import annotations

import importlib
import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from osgeo import gdal, osr
from qgis.core import QgsApplication, QgsCoordinateReferenceSystem, QgsProcessingProvider, QgsProject
from qgis.gui import QgisInterface, QgsMapCanvas
from qgis.PyQt.QtCore import QLocale

importlib.invalidate_caches()  # QGIS looked for plugins before the package's link was there

from tests.numbers.synthetic import UTM33, write_plain, write_raster  # noqa: E402
from tests.qgis.photos.photo_scenes import make_photo  # noqa: E402
from tests.qgis.plugin_lives import started  # noqa: E402
from tests.qgis.resolution.bar_scenes import make_bar_scene  # noqa: E402
from tests.qgis.scenes import Scene, layer, line, make_scene, saved  # noqa: E402
from tests.qgis.seams.desk.session_desk import Desk, wait_for_tasks  # noqa: E402

_raised: list[BaseException] = []

# Qt aborts the process when a slot raises and the hook is Python's own.
sys.excepthook = lambda kind, error, trace: _raised.append(error)


@pytest.fixture(autouse=True)
def slot_errors() -> Iterator[list[BaseException]]:
    """What Qt slots raised during the test. It fails the test, unless the test takes it off the list."""
    _raised.clear()
    yield _raised
    if _raised:
        raise _raised[0]


@pytest.fixture(scope="module", autouse=True)
def _reference_systems(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """A module leaves GDAL and QGIS with reference systems that they know, in every thread: those that come after it in
    the same process fail else, at places that tell nothing of it."""
    yield
    path = write_raster(tmp_path_factory.mktemp("systems") / "known.tif", np.zeros((8, 8), np.uint8))
    with ThreadPoolExecutor(1) as other:
        texts = [gdal.Open(path).GetProjection(), other.submit(lambda: gdal.Open(path).GetProjection()).result()]
    systems = [QgsCoordinateReferenceSystem.fromWkt(text).authid() for text in texts]
    assert systems == [f"EPSG:{UTM33}"] * 2, (texts, osr.GetPROJSearchPaths(), gdal.GetLastErrorMsg())


@pytest.fixture(scope="session", autouse=True)
def _geographic_system(qgis_app: QgsApplication) -> None:
    """QGIS's window asks for it as it starts. Where a thread that draws is the first to ask and then ends, QGIS 3.22
    transforms nothing from or to it any more in that process."""
    assert QgsCoordinateReferenceSystem("EPSG:4326").isValid()


@pytest.fixture(scope="session", autouse=True)
def _undrawn_map(qgis_app: QgsApplication, qgis_canvas: QgsMapCanvas) -> None:
    """Nobody sees it. QGIS ends the drawing before it closes a project, as the threads that draw share the styles of
    layers and crash when these go meanwhile; a project that a test clears knows of no map.
    """
    qgis_canvas.setRenderFlag(False)


@pytest.fixture(scope="session")
def scene(tmp_path_factory: pytest.TempPathFactory) -> Scene:
    """A mosaic and its two orthoimages."""
    return make_scene(tmp_path_factory.mktemp("scene"))


@pytest.fixture(scope="session")
def given(scene: Scene, tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """Inputs of every algorithm, as files."""
    folder = tmp_path_factory.mktemp("given")
    bars, photo = make_bar_scene(folder), make_photo(folder, seed=3, rotation=1.2)
    pixels = np.random.default_rng(1).integers(0, 255, (40, 60)).astype(np.uint8)
    places = [(column, row) for row in (2, 14, 26, 38) for column in (5, 30, 55)]
    heights = [10.0 * (7 * number % 5) for number in range(len(places))]
    points = (f"{c},{r},{500000 + c - 0.1 * z},{5000000 - r},{z}" for (c, r), z in zip(places, heights))
    (folder / "gcps.csv").write_text("\n".join(["column,row,x,y,z", *points]) + "\n", encoding="utf-8")
    return {
        "mosaic": str(scene.mosaic),
        "sources": scene.sources,
        "seams": saved(layer("LineString", [line((200, 0), (300, 256))]), folder / "seams.gpkg"),
        "target": bars.path,
        "bars": saved(bars.lines(), folder / "bars.gpkg"),
        "photo": str(photo.photo),
        "calibration": str(photo.calibration),
        "image": write_plain(folder / "image.tif", pixels),
        "gcps": f"delimitedtext://file://{folder}/gcps.csv?xField=x&yField=y&zField=z&crs=EPSG:{UTM33}",
    }


@pytest.fixture(scope="module")
def provider(qgis_app: QgsApplication) -> Iterator[QgsProcessingProvider]:
    """Our provider, offered as the plugin offers it in qgis_process: without an interface."""
    plugin = importlib.import_module("seam_inspector").classFactory(None)
    plugin.initProcessing()
    yield QgsApplication.processingRegistry().providerById("seaminspector")
    plugin.unload()


@pytest.fixture
def plugin(qgis_iface: QgisInterface, project: QgsProject) -> Iterator[Any]:
    """The plugin as QGIS starts it."""
    made = started(qgis_iface)
    yield made
    made.unload()
    wait_for_tasks()


@pytest.fixture
def desk(scene: Scene, project: QgsProject, tmp_path: Path) -> Iterator[Desk]:
    """A session on the scene, without windows."""
    made = Desk(scene, tmp_path)
    made.set(made.inputs())
    yield made
    made.session.close()
    wait_for_tasks()
    project.clear()


@pytest.fixture
def project(qgis_app: QgsApplication) -> Iterator[QgsProject]:
    """The project, empty again after the test: layers that outlive QGIS crash it at its end."""
    yield QgsProject.instance()
    QgsProject.instance().clear()


@pytest.fixture
def commas(qgis_app: QgsApplication) -> Iterator[None]:
    """Numbers are written as in Poland."""
    before = QLocale()
    QLocale.setDefault(QLocale("pl_PL"))
    assert QLocale().toString(0.5) == "0,5"
    yield
    QLocale.setDefault(before)


@pytest.fixture
def polish(monkeypatch: pytest.MonkeyPatch, qgis_app: QgsApplication) -> Iterator[None]:
    """QGIS and the plugin speak Polish."""
    monkeypatch.setattr(QgsApplication, "locale", staticmethod(lambda: "pl"))
    translation = importlib.import_module("seam_inspector.plugin.toolkit.translation").Translation()
    yield
    translation.remove()
