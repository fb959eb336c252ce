"""A chart, a report or another file that can't be written costs nothing of what was measured, in any algorithm."""
from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from qgis.core import QgsProcessingProvider

from fuzz.calls import MODELS
from tests.qgis.acceptance.seam_scenes import seams
from tests.qgis.runs import Log, algorithm, assert_sentence, run
from tests.qgis.scenes import BLURRED, SHARP, windows

ENDINGS = {  # else a page
    "CHART": "png", "PARAMETERS": "json", "MODEL_FILE": "json", "RPC": "txt", "WORLD_FILE": "wld", "QUALITY": "xml",
    "VRT": "vrt",
}  # fmt: skip

WITH_IMAGE = {"RPC_IMAGE"}  # a copy of an image, and there is none here

ALL_THERE_IS = {"report", "mendseams"}  # whose files are what they are run for

MEASURED = {"acceptmosaic": "DEFECTS"}  # else OUTPUT


def measurements(given: dict[str, Any]) -> dict[str, dict[str, Any]]:
    """What the algorithms measure that could lack a file."""
    points = {"GCPS": given["gcps"], "HEIGHTS": "ellipsoid", "CHECK_SHARE": 0.2}
    judged = windows(SHARP, BLURRED, ratio_1=("double", [0.9, 0.4]), observer=("string", ["invisible", "visible"]))
    return {
        "acceptmosaic": {"SEAMS": [seams([0.5, 0.9])]},
        "checkdelivery": {"FOLDER": str(Path(given["mosaic"]).parent)},
        "checknoise": {"RASTERS": given["sources"]},
        "checkradiometry": {"RASTERS": given["sources"]},
        "calibratethreshold": {"WINDOWS": judged},
        "measureresolution": {"RASTER": given["target"], "GROUPS": given["bars"], "REFERENCE_GRD": 100},
        "interiororientation": {
            "PHOTO": given["photo"], "CALIBRATION": given["calibration"], "TEMPLATE_KIND": "ring with cross"
        },
        "fitsensormodel": {**points, "MODEL": "polynomial_3d"},
        "comparesensormodels": points,
    }  # fmt: skip


def files(name: str) -> list[str]:
    job = algorithm(name)  # its definitions live as long as it does
    return [one.name() for one in job.destinationParameterDefinitions() if one.type() == "fileDestination"]


def test_no_algorithm_is_forgotten(provider: QgsProcessingProvider, given: dict[str, Any]) -> None:
    with_files = {algorithm.name() for algorithm in provider.algorithms() if files(algorithm.name())}
    assert with_files == {*measurements(given), *ALL_THERE_IS, *MODELS - {"inspect_mosaic"}}


@pytest.mark.usefixtures("provider")
@pytest.mark.parametrize("name", ["acceptmosaic", "checkdelivery", "checknoise", "checkradiometry",
                                  "calibratethreshold", "measureresolution", "interiororientation", "fitsensormodel",
                                  "comparesensormodels"])  # fmt: skip
def test_a_file_that_can_not_be_written_costs_nothing(name: str, given: dict[str, Any], tmp_path: Path) -> None:
    log, asked = Log(), {}
    for file in set(files(name)) - WITH_IMAGE:
        asked[file] = str(tmp_path / "gone" / f"{file}.{ENDINGS.get(file, 'html')}")
    outcome = run(name, log, **measurements(given)[name], **asked)
    assert outcome.complaint is None
    measured = MEASURED.get(name, "OUTPUT")
    assert outcome.rows(measured)
    assert not set(asked) & set(outcome.results)
    assert len(log.errors) == len(asked)
    for said, path in zip(sorted(log.errors), sorted(asked.values())):
        assert_sentence(said, "can't be written")
        assert path in said
    whole = run(name, **measurements(given)[name])
    assert whole.rows(measured) == outcome.rows(measured)
