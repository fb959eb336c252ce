"""What every algorithm keeps: help, refused values, outputs that are no inputs, cancelled runs, full disks.

Names, defaults and texts of all parameters and outputs stand in the guide's tables (guide/test_help_pages.py).
"""
from __future__ import annotations

import math
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterDestination,
    QgsProcessingProvider,
)

from fuzz.calls import CALLS, MODELS, placed
from fuzz.samples import make_samples
from tests.numbers.disks import full_disk
from tests.numbers.synthetic import write_raster
from tests.qgis.runs import Log, Run, algorithm, assert_refused, assert_sentence, run, run_unchecked
from tests.qgis.scenes import SHARP, saved, windows

pytestmark = pytest.mark.usefixtures("provider")

GROUPS = {
    "Seam inspection": (
        "placewindows", "inspectwindows", "scanmosaic", "mendseams", "checkdelivery", "planinspection", "acceptmosaic",
        "predictloss", "calibratethreshold", "report", "inspect_mosaic", "accept_delivery",
    ),
    "Image quality": ("checknoise", "checkradiometry"),
    "Ground resolution": ("measureresolution", "minimumheight", "simulatebayer"),
    "Interior orientation of photos": ("interiororientation", "comparemarks", "enhancephoto"),
    "Satellite images": ("fitsensormodel", "comparesensormodels", "orthorectify", "orthorectifyphotos", "planpoints"),
}  # fmt: skip
NAMES = [name for names in GROUPS.values() for name in names]
STEPS = [name for name in NAMES if name not in MODELS]
INPUTS = {"raster", "multilayer", "source", "vector", "file"}
WITHOUT_FILES = {"number", "range", "enum", "string", "boolean", "crs", "extent", "field"}
SINK, RASTER = QgsProcessingParameterFeatureSink, QgsProcessingParameterRasterDestination
ENDINGS = {
    "CHART": "png", "PARAMETERS": "json", "MODEL_FILE": "json", "RPC": "txt", "WORLD_FILE": "wld", "QUALITY": "xml",
    "VRT": "vrt", "RPC_IMAGE": "tif", "POINTS": "points", "MEASURES": "xml",
}  # fmt: skip
WITH_FILES = (
    "acceptmosaic", "checkdelivery", "checknoise", "checkradiometry", "calibratethreshold", "measureresolution",
    "interiororientation", "fitsensormodel", "comparesensormodels",
)  # fmt: skip
"""They write charts, pages or other files beside what they measure."""
LARGEST = 2**31 - 1  # a number that is as large has no limit of its own


def files_of(job: QgsProcessingAlgorithm) -> set[str]:
    """Outputs that are neither layers nor rasters."""
    return {output.name() for output in job.destinationParameterDefinitions() if output.type() == "fileDestination"}


def test_the_toolbox(provider: QgsProcessingProvider) -> None:
    assert sorted(job.name() for job in provider.algorithms()) == sorted(NAMES)
    assert len({job.groupId() for job in provider.algorithms()}) == len(GROUPS)  # else one is shown twice
    for job in provider.algorithms():
        assert job.name() in GROUPS[job.group()]
        assert job.displayName()
        assert len(job.shortHelpString()) > 80
        assert job.canExecute() == (True, "")
        assert [definition.name() for definition in job.parameterDefinitions() if not definition.help()] == []
    with_files = {job.name() for job in provider.algorithms() if files_of(job)}
    assert with_files - MODELS == {*WITH_FILES, "report", "mendseams"}  # the last two are run for them


# --- values ------------------------------------------------------------------------------------------------------


def bad_values(definition: QgsProcessingParameterDefinition) -> Iterator[tuple[Any, str]]:
    """Values that a parameter does not take, and what is said of them."""
    title = re.escape(definition.description())
    if isinstance(definition, QgsProcessingParameterNumber):
        for value in (math.nan, math.inf, -math.inf):
            yield value, f"'{title}' is '{value:g}', which is not a number"
        least, most = definition.minimum(), definition.maximum()
        for value in ([least - 1] if abs(least) < LARGEST else []) + ([most + 1] if abs(most) < LARGEST else []):
            yield value, f"'{title}' is {re.escape(f'{value:g}')}; give"
        if definition.flags() & QgsProcessingParameterDefinition.Flag.FlagOptional:  # QGIS refuses those of others
            for value in ("0,3", "much"):
                yield value, f"'{title}' is '{value}', which is not a number"
    elif isinstance(definition, QgsProcessingParameterEnum):
        yield "another", f"'{title}' is 'another'; give one of {re.escape(definition.options()[0])}"


@pytest.mark.parametrize("name", STEPS)
def test_values_that_mean_nothing_are_refused(name: str) -> None:
    job = algorithm(name)  # which its definitions live with
    if name != "planpoints":  # which needs nothing
        complaint = run(name).complaint
        assert complaint
        assert "Traceback" not in complaint
    for definition in job.parameterDefinitions():
        for value, words in bad_values(definition):
            assert_refused(name, words, **{definition.name(): value})


@pytest.mark.parametrize(("name", "parameter"), [("orthorectify", "CRS"), ("fitsensormodel", "GCPS_CRS")])
def test_a_reference_system_that_there_is_not_is_not_taken_for_none(name: str, parameter: str) -> None:
    for value in ("EPSG:99999999", "nonsense"):
        assert_refused(name, f"is {value}, which is not a coordinate reference system", **{parameter: value})
    assert "reference system" not in str(run_unchecked(name, **{parameter: ""}).complaint)


def test_numbers_that_are_none_are_refused_by_the_steps_of_models(given: dict[str, Any]) -> None:
    values = {"seamlines": given["seams"], "mosaic": given["mosaic"], "sources": given["sources"]}
    for parameter in ("side", "spacing"):
        complaint = str(run_unchecked("inspect_mosaic", **values, **{parameter: math.inf}).complaint)
        assert "is 'inf', which is not a number" in complaint
        assert "Traceback" not in complaint


# --- outputs -----------------------------------------------------------------------------------------------------


def an_input(definition: QgsProcessingParameterDefinition, folder: Path) -> tuple[Any, Path]:
    """A value for a parameter, and its file. What it says does not matter: nothing is to be read of it."""
    name = definition.name().replace(":", "_")
    if definition.type() in ("raster", "multilayer"):
        path = Path(write_raster(folder / f"{name}.tif", np.full((8, 8), 9, np.uint8)))
    elif definition.type() == "file":
        path = folder / f"{name}.json"
        path.write_text("{}", encoding="utf-8")
    else:
        path = Path(saved(windows(SHARP), folder / f"{name}.gpkg"))
    return [str(path)] if definition.type() == "multilayer" else str(path), path


@pytest.mark.parametrize("name", NAMES)
def test_no_output_takes_the_place_of_an_input(name: str, tmp_path: Path) -> None:
    job = algorithm(name)
    asked = [definition for definition in job.parameterDefinitions() if not definition.isDestination()]
    assert {definition.type() for definition in asked} <= INPUTS | WITHOUT_FILES  # another type may name files too
    files = {each.name(): an_input(each, tmp_path) for each in asked if each.type() in INPUTS}
    values = {parameter: value for parameter, (value, _) in files.items()}
    before = {path: path.read_bytes() for _, path in files.values()}
    assert files
    assert job.destinationParameterDefinitions()
    for output in job.destinationParameterDefinitions():
        for path in before:
            assert_refused(name, "which belongs to an input; choose another", **values, **{output.name(): str(path)})
        assert {path: path.read_bytes() for path in before} == before


def places(folder: Path, ending: str) -> dict[str, str]:
    """Places where nothing can be written, and the words that say so."""
    (folder / f"folder.{ending}").mkdir()
    (folder / "file.txt").touch()
    (folder / f"loop.{ending}").symlink_to(folder / f"loop.{ending}")
    (folder / f"dangling.{ending}").symlink_to(folder / "nowhere" / "x")
    return {
        f"{folder}/gone/x.{ending}": "No such file or directory",
        f"{folder}/dangling.{ending}": "No such file or directory",
        f"{folder}/folder.{ending}": "Is a directory",
        f"{folder}/": "Is a directory",
        f"{folder}/file.txt/x.{ending}": "Not a directory",
        f"{folder}/loop.{ending}": "symbolic links",
        f"{folder}/{'x' * 260}.{ending}": "name too long",
        f"{folder}/a\0b.{ending}": "is not a file on a disk",
        f"/vsizip/{folder}/a.zip/x.{ending}": "is not a file on a disk",
        f"/vsicurl/http://127.0.0.1:9/x.{ending}": "is not a file on a disk",
        "/dev/full": "not permitted",
        " ": "is not a file on a disk",
    }


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_what_can_not_be_written_is_refused_first(name: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    """Before anything is read: the other parameters may hold nothing. Every raster is a GeoTIFF."""
    job = algorithm(name)
    for output in job.destinationParameterDefinitions():
        if not isinstance(output, (SINK, RASTER)):
            continue
        folder = tmp_path / output.name().replace(":", "_")
        folder.mkdir()
        refused = places(folder, "tif" if isinstance(output, RASTER) else "gpkg")
        if isinstance(output, RASTER):
            assert set(output.supportedOutputRasterLayerExtensions()) == {"tif", "tiff"}
            refused |= dict.fromkeys(["postgres:dbname=x", "ogr:dbname='x.gpkg'", "http://x/y.tif"], "not a file on")
            refused |= {str(folder / f"x.{ending}"): r"GeoTIFF \(\*\.tif" for ending in ("jpg", "vrt", "xyzzy")}
        before = sorted(folder.rglob("*"))
        for path, words in refused.items():
            assert_refused(name, words, **{output.name(): path})
            assert sorted(folder.rglob("*")) == before
    assert not capfd.readouterr().err


# --- runs of sound calls -----------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def samples(provider: QgsProcessingProvider, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Small sound inputs of every algorithm."""
    folder = tmp_path_factory.mktemp("sound") / "samples"
    make_samples(folder)
    return folder


def sound(name: str, samples: Path) -> dict[str, Any]:
    """What an algorithm is given in its first call, but for one that fits no sheet."""
    call = next(call for call in CALLS if call.algorithm == name and call.key != "checkdelivery/sheets")
    return {parameter: placed(value, samples) for parameter, value in call.values.items()}


def older(job: QgsProcessingAlgorithm, folder: Path) -> dict[str, str]:
    """An older file in the place of each layer, raster and page."""
    paths = {}
    for output in job.destinationParameterDefinitions():
        name = output.name().replace(":", "_")
        if isinstance(output, RASTER):
            path = write_raster(folder / f"{name}.tif", np.full((8, 8), 9, np.uint8))
        elif isinstance(output, SINK):
            path = saved(windows(SHARP), folder / f"{name}.gpkg")
        elif output.type() == "fileDestination":
            path = str(folder / f"{name}.{ENDINGS.get(name, 'html')}")
            Path(path).write_text("older", encoding="utf-8")
        else:
            continue
        paths[output.name()] = path
    return paths


def assert_only_sentences(outcome: Run) -> None:
    """What went wrong was told, and nobody sees a traceback."""
    log = outcome.log
    for text in (*log.errors, *log.warnings, outcome.complaint or ""):
        assert "Traceback" not in text


@pytest.mark.slow
@pytest.mark.parametrize("name", STEPS)
@pytest.mark.parametrize("end", ["cancelled", "full disk"])
def test_what_does_not_come_to_its_end_replaces_nothing(name: str, end: str, samples: Path, tmp_path: Path) -> None:
    paths = older(algorithm(name), tmp_path)
    before = {path: Path(path).read_bytes() for path in paths.values()}
    log = Log()
    if end == "cancelled":
        log.cancel()
        outcome = run(name, log, **sound(name, samples), **paths)
    else:
        with full_disk(1):
            outcome = run(name, log, **sound(name, samples), **paths)
        assert log.errors or outcome.complaint
    assert {path: Path(path).read_bytes() for path in before} == before
    assert_only_sentences(outcome)


@pytest.mark.slow
@pytest.mark.parametrize("name", WITH_FILES)
def test_a_file_that_can_not_be_written_costs_nothing(name: str, samples: Path, tmp_path: Path) -> None:
    job, log = algorithm(name), Log()
    files = files_of(job) - {"RPC_IMAGE"}  # a copy of an image
    paths = {file: str(tmp_path / "gone" / f"{file}.{ENDINGS.get(file, 'html')}") for file in files}
    values = {**sound(name, samples), "RPC_IMAGE": None}
    outcome = run(name, log, **values, **paths)
    assert outcome.complaint is None
    measured = "DEFECTS" if name == "acceptmosaic" else "OUTPUT"
    assert not set(paths) & set(outcome.results)
    for path in paths.values():
        (said,) = (error for error in log.errors if path in error)
        assert_sentence(said, "can't be written")
    assert run(name, **values).rows(measured) == outcome.rows(measured)
