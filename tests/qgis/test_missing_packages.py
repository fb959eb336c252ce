"""Without a package that it needs the plugin loads, says what to do, and works as soon as the package is there."""
from __future__ import annotations

import importlib
import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from qgis.core import Qgis, QgsProcessingProvider, QgsProject
from qgis.gui import QgisInterface
from seam_inspector.plugin.toolkit import packages

from tests.qgis.runs import algorithm, assert_refused, assert_sentence

Told = list[tuple[str, Any]]
NAMES = {"pywt": "PyWavelets", "scipy": "scipy"}
DRAWN = (
    ("acceptmosaic", "REPORT"),
    ("calibratethreshold", "CHART"),
    ("checknoise", "CHART"),
    ("checknoise", "REPORT"),
    ("checkradiometry", "REPORT"),
    ("comparesensormodels", "REPORT"),
    ("fitsensormodel", "REPORT"),
    ("measureresolution", "CHART"),
    ("measureresolution", "REPORT"),
)
"""Algorithms and their files with charts."""
PAGES = (
    *(drawn for drawn in DRAWN if drawn[1] != "CHART"), ("report", "OUTPUT"), ("interiororientation", "REPORT"),
    ("acceptmosaic", "QUALITY"), ("mendseams", "REPORT"),
)  # fmt: skip
"""Algorithms and their pages."""
DRAWING = """acceptance.paper.acceptance_report
resolution.charts resolution.report seams.charts.calibration_chart noise.charts
noise.report radiometry.report toolkit.charts.figure_files""".split()
"""Modules that can't be imported without matplotlib."""
WRITING = """acceptance.paper.quality_document
noise.report photos.report radiometry.report resolution.report seams.report.inspection_report
sensors.report toolkit.pages.templates""".split()
"""Modules that can't be imported without jinja2."""


@pytest.fixture
def start(qgis_iface: QgisInterface, project: QgsProject) -> Iterator[Callable[[], Any]]:
    """Loads the plugin, as QGIS does when it starts."""
    loaded: list[Any] = []

    def load() -> Any:
        for plugin in loaded:
            plugin.unload()
        loaded[:] = [importlib.import_module("seam_inspector").classFactory(qgis_iface)]
        loaded[0].initGui()
        return loaded[0]

    yield load
    for plugin in loaded:
        plugin.unload()


@pytest.fixture
def bar(qgis_iface: QgisInterface, monkeypatch: pytest.MonkeyPatch) -> Told:
    """What stands in the message bar, with its level."""
    messages: Told = []
    monkeypatch.setattr(
        qgis_iface.messageBar(), "pushMessage", lambda _title, text, level, _time: messages.append((text, level))
    )
    return messages


@pytest.mark.parametrize("module", NAMES)
def test_a_missing_package_is_named_once_and_used_after_a_restart(
    start: Callable[[], Any], bar: Told, monkeypatch: pytest.MonkeyPatch, module: str
) -> None:
    find = packages.find_spec
    with monkeypatch.context() as patch:
        patch.setattr(packages, "find_spec", lambda name: None if name == module else find(name))
        plugin = start()
        assert bar == []  # it is time enough when somebody wants to use it
        plugin.desk("seamInspectorAction").action.trigger()
        assert plugin.desk("seamInspectorAction").dock is None
        assert not plugin.desk("seamInspectorAction").action.isChecked()
    ((text, level),) = bar
    assert level == Qgis.MessageLevel.Warning
    assert NAMES[module] in text
    assert_sentence(text, "then restart QGIS")
    bar.clear()
    plugin = start()
    plugin.desk("seamInspectorAction").action.trigger()
    assert plugin.desk("seamInspectorAction").dock is not None
    assert plugin.desk("seamInspectorAction").dock.session.windows() == []
    assert bar == []


@pytest.mark.parametrize("action", ["seamInspectorAction", "seamInspectorBarAction"])
@pytest.mark.parametrize(("module", "modules"), [("matplotlib", DRAWING), ("jinja2", WRITING)])
def test_the_desk_opens_without_what_charts_in_files_and_reports_need(
    start: Callable[[], Any], bar: Told, monkeypatch: pytest.MonkeyPatch, module: str, modules: list[str], action: str
) -> None:
    take_away(monkeypatch, module, modules)
    plugin = start()
    plugin.desk(action).action.trigger()
    assert plugin.desk(action).dock is not None
    assert bar == []


def take_away(monkeypatch: pytest.MonkeyPatch, package: str, modules: list[str]) -> None:
    """A system where only one package is missing; our modules that need it can't be imported."""
    find = packages.find_spec
    monkeypatch.setattr(packages, "find_spec", lambda name: None if name == package else find(name))
    for name in (package, *(f"seam_inspector.plugin.{name}" for name in modules)):
        monkeypatch.setitem(sys.modules, name, None)


def asked_for(name: str, output: str, path: Path) -> dict[str, Any]:
    """One of an algorithm's outputs and no other."""
    job = algorithm(name)
    others = {definition.name(): None for definition in job.destinationParameterDefinitions()}
    return {**others, output: str(path)}


@pytest.mark.usefixtures("provider")
@pytest.mark.parametrize(("name", "output"), DRAWN)
def test_a_chart_or_report_is_refused_before_anything_is_measured(
    name: str, output: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    take_away(monkeypatch, "matplotlib", DRAWING)
    words = "the Python package.s. matplotlib.*then restart QGIS"
    assert_refused(name, words, **asked_for(name, output, tmp_path / "page.html"))


@pytest.mark.parametrize(("kind", "tested"), [("DRAWN", DRAWN), ("PAGES", PAGES)])
def test_every_file_with_charts_and_every_page_is_among_those_tested(
    provider: QgsProcessingProvider, kind: str, tested: tuple[tuple[str, str], ...]
) -> None:
    values = {
        (job.name(), output.name())
        for job in provider.algorithms()
        for output in job.destinationParameterDefinitions()
        if output.name() in getattr(algorithm(job.name()), kind, ())
    }
    assert values == set(tested)


@pytest.mark.parametrize(
    ("platform", "has_apt", "words"),
    [
        ("linux", True, "'sudo apt install python3-pywt'"),
        ("linux", False, "'python -m pip install PyWavelets' with the Python that QGIS uses.*QPIP.*requirements.txt"),
        ("win32", True, "'python -m pip install PyWavelets' .*on Windows in the OSGeo4W shell"),
    ],
)
def test_how_to_get_it_depends_on_the_system(
    monkeypatch: pytest.MonkeyPatch, platform: str, has_apt: bool, words: str
) -> None:
    monkeypatch.setattr(packages, "find_spec", lambda name: None if name == "pywt" else object())
    monkeypatch.setattr(sys, "platform", platform)
    monkeypatch.setattr(shutil, "which", lambda _program: "/usr/bin/apt" if has_apt else None)
    assert_sentence(packages.missing_packages_sentence(), words)


def test_a_package_that_cant_be_loaded_is_named(repository: Path, tmp_path: Path) -> None:
    """In a process of its own, since ours has loaded it."""
    (tmp_path / "pywt").mkdir()
    (tmp_path / "pywt" / "__init__.py").write_text("raise ImportError('its library is missing', name='pywt._dwt')")
    code = """
from unittest.mock import MagicMock
from qgis.core import QgsApplication
from qgis.PyQt.QtWidgets import QAction
application = QgsApplication([], True)
application.initQgis()
import seam_inspector
iface = MagicMock()
iface.mainWindow.return_value = None
plugin = seam_inspector.classFactory(iface)
plugin.initGui()
plugin.desk("seamInspectorAction").action.trigger()
(_, text, _, _), _ = iface.messageBar().pushMessage.call_args
print(plugin.desk("seamInspectorAction").dock, plugin.desk("seamInspectorAction").action.isChecked(), text, sep="|")
plugin.unload()
"""
    environment = {**os.environ, "QGIS_CUSTOM_CONFIG_PATH": str(tmp_path)}
    environment["PYTHONPATH"] = os.pathsep.join((str(tmp_path), str(repository / "build" / "plugins")))
    finished = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, env=environment, timeout=300, check=False
    )
    assert "Traceback" not in finished.stderr, finished.stderr
    dock, is_checked, text = finished.stdout.strip().split("|")
    assert (dock, is_checked) == ("None", "False")
    assert_sentence(text, "PyWavelets can't be loaded .its library is missing.")
