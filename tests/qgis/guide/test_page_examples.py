"""Every example on the pages of the algorithms and every command of `qgis_process` on the guide's other pages runs, on
the data that `make demo-data` makes, with a smaller block."""
from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from osgeo import gdal, ogr
from qgis.core import QgsApplication, QgsProcessingProvider

from demo.data import make_data
from demo.run import DONE
from tests.made_once import the_delivery
from tests.qgis.guide.page_examples import DOCS, NAMES, PAGES, Call, blocks, commands, same_call, shell_call
from tests.qgis.qgis_processes import NEEDED, PROGRAM, environment

pytestmark = pytest.mark.slow

FIRST = "placewindows inspectwindows scanmosaic interiororientation fitsensormodel".split()  # others take their results
ORDER = [*FIRST, *(name for name in NAMES if name not in FIRST)]
BY_QGIS_PROCESS = ("minimumheight", "planpoints")  # one plain, one with a value in quotes; they take a second

QUICKER = {"planpoints": {"COUNTS": "10"}, "orthorectify": {"PIXEL_SIZE": "5"}}
"""Values that take seconds on the small scene in place of those that take a minute."""
OPEN = "acceptance/cluster.md"  # dots for values: there is no line to copy
NAMED: dict[str, dict[str, str]] = {
    "block": {
        "block/mosaic.tif": "mosaic.tif",
        "block/seamlines.gpkg": "seamlines.gpkg",
        "block/strip1_0141.tif": "ortho_1.tif a.tif ortho/ortho_1.tif",
        "block/strip1_0142.tif": "ortho_2.tif b.tif ortho/ortho_2.tif",
        "block/sources.gpkg": "roads_and_roofs.gpkg",
    },
    "delivery": {f"delivery/{name}": name for name in ("mosaic.vrt", "seamlines.gpkg", "sheets.gpkg", "sources")},
    "others": {
        "bars/target.tif": "target.tif scene.tif",
        "bars/groups.gpkg": "bar_groups.gpkg",
        "bars/passes.csv": "passes.csv",
        "noise/film.tif": "film.tif",
        "noise/sensor.tif": "digital.tif",
        "photo/photo.tif": "photo.jpg",
        "photo/camera.csv": "camera.csv",
        "photo/by_hand.csv": "operator/photo.csv program/photo.csv",
        "satellite/image.tif": "image.tif",
        "satellite/points.gpkg": "points.gpkg",
        "satellite/terrain.tif": "dem.tif",
    },
}
"""Files of `make demo-data` by folder of a reader, and what the pages call them."""
READ = {
    "block": "start/own_rasters acceptance/calibration acceptance/choose_a_limit desk/report method/predictloss "
    "acceptance/scan acceptance/sampling neighbours/radiometry",
    "delivery": "acceptance/accept",
    "others": "neighbours/bayer neighbours/interior_orientation neighbours/noise neighbours/resolution "
    "neighbours/sensor_models",
}
"""The pages in the order in which the reader of a folder takes them: later ones use what earlier ones wrote."""
READ_PAGES = [(folder, f"{page}.md") for folder, pages in READ.items() for page in pages.split()]


@pytest.fixture(scope="module")
def checkout(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """A folder with the data, in which the examples run."""
    folder, before = tmp_path_factory.mktemp("checkout"), Path.cwd()
    delivery = folder / "output" / "demo" / "delivery"
    shutil.copytree(the_delivery(tmp_path_factory).mosaic.parent, delivery)
    (delivery / DONE).touch()
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
    variables = environment(repository, tmp_path / "settings")
    (tmp_path / "qgis_process").symlink_to(str(PROGRAM))
    variables["PATH"] = f"{tmp_path}{os.pathsep}{variables.get('PATH', '')}"
    script = f"set -e\nqgis_process plugins enable seam_inspector\n{blocks(name, 'shell')[0]}"
    finished = subprocess.run(
        ["sh", "-c", script], cwd=checkout, env=variables, capture_output=True, text=True, timeout=120, check=False
    )
    assert finished.returncode == 0, finished.stdout + finished.stderr


def test_blocks_for_a_machine_without_qgis_need_none(repository: Path, checkout: Path) -> None:
    codes = [code for name in NAMES for code in blocks(name, "python")[1:]]
    assert len(codes) >= 5
    program = "\n".join(["import sys", "sys.modules['qgis'] = None", *codes])
    environment = {**os.environ, "PYTHONPATH": str(repository / "build" / "plugins")}
    finished = subprocess.run(
        [sys.executable, "-c", program],
        cwd=checkout, env=environment, capture_output=True, text=True, timeout=120, check=False,
    )
    assert finished.returncode == 0, finished.stderr


@pytest.fixture(scope="module")
def reader(checkout: Path) -> Path:
    """Folders of readers, with what the pages name."""
    made, place = checkout / "output" / "demo", checkout / "reader"
    for folder, files in NAMED.items():
        for source, names in files.items():
            for name in names.split():
                (place / folder / name).parent.mkdir(parents=True, exist_ok=True)
                (place / folder / name).symlink_to(made / source)
    for sheet in (made / "delivery").glob("sheet_*.tif"):
        (place / "delivery" / sheet.name).symlink_to(sheet)
    return place


def judge(windows: str, judged: str) -> None:
    """Judge as an operator does in the desk, in a copy if need be: one loss seen, the other windows sound."""
    if judged != windows:
        Path(judged).unlink(missing_ok=True)
        assert gdal.VectorTranslate(judged, windows, format="GPKG") is not None
    source = gdal.OpenEx(judged, gdal.OF_VECTOR | gdal.OF_UPDATE)
    layer = source.GetLayer(0)
    layer.CreateField(ogr.FieldDefn("observer", ogr.OFTString))
    for number, feature in enumerate(layer):
        feature["observer"] = "invisible" if number else "visible"
        layer.SetFeature(feature)


def test_no_page_with_commands_is_left_out() -> None:
    pages = (path for path in DOCS.rglob("*.md") if path.parent != PAGES)
    values = {path.relative_to(DOCS).as_posix() for path in pages if commands(path)}
    assert values - {page for _, page in READ_PAGES} == {OPEN}
    assert "..." in "".join(commands(DOCS / OPEN))


@pytest.mark.release
@pytest.mark.parametrize(("folder", "page"), READ_PAGES)
def test_the_commands_of_a_page_run(
    folder: str, page: str, reader: Path, calls: list[Call], monkeypatch: pytest.MonkeyPatch
) -> None:
    import processing

    monkeypatch.chdir(reader / folder)
    for command in commands(DOCS / page):
        if command.startswith("(judge"):
            files = re.findall(r"\w+\.gpkg", command)
            judge(files[0], files[-1])
        elif not command.startswith("qgis_process"):
            subprocess.run(["sh", "-c", command], check=True, timeout=60)
        else:
            algorithm, parameters = shell_call(command)
            processing.run(algorithm, {**parameters, **QUICKER.get(algorithm.split(":")[1], {})})
            created = QgsApplication.processingRegistry().createAlgorithmById(algorithm)
            made = [parameters.get(output.name()) for output in created.destinationParameterDefinitions()]
            assert [name for name in made if name and not Path(name).stat().st_size] == []
