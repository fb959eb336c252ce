"""Every example on the pages of the algorithms runs, on the data that `make demo-data` makes, with a smaller block."""
from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from qgis.core import QgsApplication, QgsProcessingProvider

from demo.data import make_data
from tests.qgis.guide.page_examples import NAMES, Call, blocks, same_call, shell_call
from tests.qgis.qgis_processes import NEEDED, PROGRAM, environment

pytestmark = pytest.mark.slow

FIRST = "placewindows inspectwindows scanmosaic interiororientation fitsensormodel".split()  # others take their results
ORDER = [*FIRST, *(name for name in NAMES if name not in FIRST)]
BY_QGIS_PROCESS = ("minimumheight", "planpoints")  # one plain, one with a value in quotes; they take a second


@pytest.fixture(scope="module")
def checkout(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """A folder with the data, in which the examples run."""
    folder, before = tmp_path_factory.mktemp("checkout"), Path.cwd()
    make_data(folder / "output" / "demo", small=True, progress=lambda message: None)
    os.chdir(folder)
    yield folder
    os.chdir(before)


@pytest.fixture(scope="module")
def calls(qgis_processing: None, provider: QgsProcessingProvider) -> Iterator[list[Call]]:
    """What `processing.run` was asked for, in the order of the examples."""
    import processing

    made: list[Call] = []
    real = processing.run

    def noted(algorithm: str, parameters: dict[str, Any]) -> dict[str, Any]:
        made.append((algorithm, parameters))
        return dict(real(algorithm, parameters))

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(processing, "run", noted)
        yield made


@pytest.mark.parametrize("name", ORDER)
def test_the_example_in_python_and_that_on_the_command_line(name: str, checkout: Path, calls: list[Call]) -> None:
    """The one is run, the other asks for the same."""
    python, (shell,) = blocks(name, "python")[0], blocks(name, "shell")
    exec(compile(python, f"{name}.md", "exec"), {})
    algorithm, parameters = shell_call(shell)
    assert algorithm == f"seaminspector:{name}"
    assert same_call((algorithm, parameters)) == same_call(calls[-1])
    created = QgsApplication.processingRegistry().createAlgorithmById(algorithm)
    for output in created.destinationParameterDefinitions():
        made = parameters.get(output.name())
        assert made is None or (checkout / made).stat().st_size > 0


@NEEDED
@pytest.mark.parametrize("name", BY_QGIS_PROCESS)
def test_blocks_run_in_a_shell_as_they_stand(name: str, repository: Path, checkout: Path, tmp_path: Path) -> None:
    own = environment(repository, tmp_path / "settings")
    (tmp_path / "qgis_process").symlink_to(str(PROGRAM))
    own["PATH"] = f"{tmp_path}{os.pathsep}{own.get('PATH', '')}"
    script = f"set -e\nqgis_process plugins enable seam_inspector\n{blocks(name, 'shell')[0]}"
    finished = subprocess.run(
        ["sh", "-c", script], cwd=checkout, env=own, capture_output=True, text=True, timeout=120, check=False
    )
    assert finished.returncode == 0, finished.stdout + finished.stderr


def test_blocks_for_a_machine_without_qgis_need_none(repository: Path, checkout: Path) -> None:
    codes = [code for name in NAMES for code in blocks(name, "python")[1:]]
    assert len(codes) >= 5
    program = "\n".join(["import sys", "sys.modules['qgis'] = None", *codes])
    own = {**os.environ, "PYTHONPATH": str(repository / "build" / "plugins")}
    finished = subprocess.run(
        [sys.executable, "-c", program], cwd=checkout, env=own, capture_output=True, text=True, timeout=120, check=False
    )
    assert finished.returncode == 0, finished.stderr
