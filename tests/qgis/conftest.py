"""What the tests inside QGIS share."""
from __future__ import annotations

import importlib
import sys
from collections.abc import Iterator

import pytest
from qgis.core import QgsApplication, QgsProcessingProvider, QgsProject

from tests.qgis.scenes import Scene, make_scene

importlib.invalidate_caches()  # QGIS looked for plugins before the package's link was there

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
def project(qgis_app: QgsApplication) -> Iterator[QgsProject]:
    """The project, empty again after the test: layers that outlive QGIS crash it at its end."""
    yield QgsProject.instance()
    QgsProject.instance().clear()
