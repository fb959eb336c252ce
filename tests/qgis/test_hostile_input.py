"""`make fuzz` knows every algorithm and every file of theirs, and finds nothing in a few of its cases."""
from __future__ import annotations

from itertools import islice
from pathlib import Path

import pytest
from qgis.core import QgsProcessingProvider

from fuzz.breakages.broken import BREAKAGES
from fuzz.calls import CALLS
from fuzz.cases import NO_FILE, SOUND, kinds
from fuzz.run import endless_cases
from fuzz.workers import Worker
from tests.qgis.runs import algorithm
from tests.qgis.test_contract import INPUTS, NAMES

pytestmark = [pytest.mark.slow, pytest.mark.usefixtures("provider")]


def test_every_algorithm_has_a_sound_call(provider: QgsProcessingProvider) -> None:
    """A new one has to get its own in fuzz/calls.py, where the desk has one too."""
    assert {call.algorithm for call in CALLS} - {"desk"} == set(NAMES) == {job.name() for job in provider.algorithms()}


@pytest.mark.parametrize("name", NAMES)
def test_every_input_that_is_a_file_is_broken_somewhere(name: str) -> None:
    job = algorithm(name)
    asked = [definition for definition in job.parameterDefinitions() if not definition.isDestination()]
    inputs = {definition.name() for definition in asked if definition.type() in INPUTS}
    assert inputs <= {case.parameter for case in kinds() if case.algorithm == name and case.breakage == NO_FILE}


def test_every_breakage_is_played() -> None:
    assert set(BREAKAGES) <= {case.breakage for case in kinds()}
    assert len({str(case) for case in kinds()}) == len(kinds())
    assert sum(case.breakage == SOUND for case in kinds()) == len(CALLS)


ONCE_BROKEN = (
    "inspectwindows/cells/SOURCES/a_pipe/706052501",
    "placewindows/lines/SEAMLINES/a_pipe/1",
    "orthorectify/frame/INTERIOR/a_device/134046355",
    "acceptmosaic/rules/RULES/a_device/1",
    "simulatebayer/big/RASTER/vrt_of_no_size/826561445",
    "enhancephoto/gaussian/PHOTO/sparse/58338084",
    "comparesensormodels/heights/GEOID/sparse/242540163",
    "acceptmosaic/limits/WINDOWS/shapes/483435043",
    "acceptmosaic/rules/SHEETS/shapes/233671740",
    "inspect_mosaic/index/mosaic/system/437490206",
    "inspect_mosaic/lines/sources/sparse/834058247",
    "comparemarks/folders/SECOND_FOLDER/a_pipe/809317441",
    "orthorectify/frame/INTERIOR/deep/912777930",
    "orthorectify/model/IMAGE/vrt_of_many/566069506",
    "predictloss/width/WINDOWS/an_address/387873611",
    "scanmosaic/given/SOURCES/values/245008460",
    "interiororientation/table/PHOTO/vrts_in_each_other/977363352",
    "checkradiometry/windows/RASTERS/bands/41286105",
    "fitsensormodel/bias/IMAGE_RPC/one_endless_line/599400605",
    "scanmosaic/lone/MOSAIC/sparse/555636332",
    "interiororientation/template/PHOTO/geotransform/761095921",
    "inspect_mosaic/index/mosaic/one_huge_block/553833707",
    "accept_delivery/sources/folder/sparse/390607293",
    "comparesensormodels/heights/GCPS/all_numbers/161795838",
    "orthorectifyphotos/table/INTERIOR/structure/486750580",
)
"""Cases that crashed, hung, took all memory or said something else than a sentence once."""
QUICK = {
    "placewindows", "inspectwindows", "planinspection", "predictloss", "minimumheight", "simulatebayer", "comparemarks",
    "enhancephoto", "orthorectify", "report",
}


@pytest.mark.release
def test_a_few_cases_find_nothing(tmp_path: Path) -> None:
    """No crash, no hang, no traceback, nothing outside the outputs, no error without a sentence."""
    broken = [case for case in kinds() if case.algorithm in QUICK and case.breakage != SOUND]
    chosen = [*ONCE_BROKEN, *map(str, islice(endless_cases(broken, 1), 6))]
    worker = Worker(tmp_path / "samples", tmp_path / "worker", tmp_path / "findings.txt")
    findings = {}
    for case in chosen:
        report = worker.play(case)
        if report.findings:
            findings[case] = report.findings
        if worker.is_lost:
            break
    worker.close()
    assert findings == {}
