"""`make fuzz` knows every algorithm and every file of theirs, and finds nothing in a few of its cases."""
from __future__ import annotations

import pytest
from qgis.core import QgsProcessingProvider

from fuzz.breakages.broken import BREAKAGES
from fuzz.calls import CALLS
from fuzz.cases import NO_FILE, SOUND, kinds
from tests.qgis.runs import algorithm
from tests.qgis.test_overwriting import INPUTS
from tests.qgis.test_provider import NAMES

pytestmark = pytest.mark.usefixtures("provider")


def test_every_algorithm_has_a_sound_call(provider: QgsProcessingProvider) -> None:
    """A new one has to get its own in fuzz/calls.py."""
    assert {call.algorithm for call in CALLS} == set(NAMES) == {one.name() for one in provider.algorithms()}


@pytest.mark.parametrize("name", NAMES)
def test_every_input_that_is_a_file_is_broken_somewhere(name: str) -> None:
    job = algorithm(name)
    inputs = {one.name() for one in job.parameterDefinitions() if one.type() in INPUTS and not one.isDestination()}
    assert inputs <= {case.parameter for case in kinds() if case.algorithm == name and case.breakage == NO_FILE}


def test_every_breakage_is_played() -> None:
    assert set(BREAKAGES) <= {case.breakage for case in kinds()}
    assert len({str(case) for case in kinds()}) == len(kinds())
    assert sum(case.breakage == SOUND for case in kinds()) == len(CALLS)
