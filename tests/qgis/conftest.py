"""What the tests inside QGIS share."""
from __future__ import annotations

import importlib
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from qgis.core import QgsApplication, QgsProcessingProvider, QgsProject

importlib.invalidate_caches()  # QGIS looked for plugins before the package's link was there

from tests.qgis.scenes import Scene, make_scene  # noqa: E402
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


@pytest.fixture(scope="session")
def scene(tmp_path_factory: pytest.TempPathFactory) -> Scene:
    """A mosaic and its two orthoimages."""
    return make_scene(tmp_path_factory.mktemp("scene"))


@pytest.fixture(scope="module")
def provider(qgis_app: QgsApplication) -> Iterator[QgsProcessingProvider]:
    """Our provider, offered as the plugin offers it in qgis_process: without an interface."""
    plugin = importlib.import_module("seam_inspector").classFactory(None)
    plugin.initProcessing()
    yield QgsApplication.processingRegistry().providerById("seaminspector")
    plugin.unload()


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
