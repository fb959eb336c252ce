"""No algorithm takes NaN, an infinite number, one beyond its limits or too large for any parameter, a word that is none
of a choice, or a reference system that there is not."""
from __future__ import annotations

import math
import re
from typing import Any

import pytest
from qgis.core import QgsProcessingParameterDefinition, QgsProcessingParameterEnum, QgsProcessingParameterNumber

from fuzz.calls import MODELS
from tests.qgis.runs import algorithm, assert_refused, run_unchecked
from tests.qgis.test_provider import NAMES

LARGEST = 2**31 - 1  # a number that is as large has no limit of its own
pytestmark = pytest.mark.usefixtures("provider")


@pytest.mark.parametrize("name", [name for name in NAMES if name not in MODELS])
def test_numbers_that_are_none_are_refused(name: str) -> None:
    job = algorithm(name)  # which its definitions live with
    for definition in job.parameterDefinitions():
        if isinstance(definition, QgsProcessingParameterNumber):
            for value in (math.nan, math.inf, -math.inf):
                words = f"'{definition.description()}' is {value:g}; give a number"
                assert_refused(name, words.replace("(", r"\(").replace(")", r"\)"), **{definition.name(): value})


@pytest.mark.parametrize("name", [name for name in NAMES if name not in MODELS])
def test_words_for_numbers_that_may_be_left_out_are_refused(name: str) -> None:
    """QGIS refuses them for other numbers, and takes them for none given here."""
    job = algorithm(name)  # which its definitions live with
    for definition in job.parameterDefinitions():
        is_optional = definition.flags() & QgsProcessingParameterDefinition.Flag.FlagOptional
        if isinstance(definition, QgsProcessingParameterNumber) and is_optional:
            for value in ("0,3", "much"):
                words = f"'{definition.description()}' is '{value}', which is no number"
                assert_refused(name, words.replace("(", r"\(").replace(")", r"\)"), **{definition.name(): value})


@pytest.mark.parametrize("name", [name for name in NAMES if name not in MODELS])
def test_numbers_beyond_their_limits_and_unknown_words_are_refused(name: str) -> None:
    job = algorithm(name)  # which its definitions live with
    for definition in job.parameterDefinitions():
        title = re.escape(definition.description())
        if isinstance(definition, QgsProcessingParameterNumber):
            least, most = definition.minimum(), definition.maximum()
            for value in ([least - 1] if abs(least) < LARGEST else []) + ([most + 1] if abs(most) < LARGEST else []):
                assert_refused(name, f"'{title}' is {re.escape(f'{value:g}')}; give", **{definition.name(): value})
        elif isinstance(definition, QgsProcessingParameterEnum):
            words = f"'{title}' is 'another'; known are {re.escape(definition.options()[0])}"
            assert_refused(name, words, **{definition.name(): "another"})


@pytest.mark.parametrize(("name", "parameter"), [("orthorectify", "CRS"), ("fitsensormodel", "GCPS_CRS")])
def test_a_reference_system_that_there_is_not_is_not_taken_for_none(name: str, parameter: str) -> None:
    for value in ("EPSG:99999999", "nonsense"):
        assert_refused(name, f"is {value}, which is not a coordinate reference system", **{parameter: value})
    complaint = str(run_unchecked(name, **{parameter: ""}).complaint)
    assert "reference system" not in complaint


@pytest.mark.parametrize("value", [math.nan, math.inf])
@pytest.mark.parametrize("parameter", ["side", "spacing"])
def test_numbers_that_are_none_are_refused_by_the_steps_of_models(
    given: dict[str, Any], parameter: str, value: float
) -> None:
    values = {"seamlines": given["seams"], "mosaic": given["mosaic"], "sources": given["sources"], parameter: value}
    outcome = run_unchecked("inspect_mosaic", **values)
    assert f"is {value:g}; give a number" in str(outcome.complaint)
    assert "Traceback" not in str(outcome.complaint)


def test_whole_numbers_are_such_that_they_can_be_held(given: dict[str, Any]) -> None:
    for value in (2**31, -(2**31), 1e300):
        assert_refused("measureresolution", "give a whole number between", RASTER=given["target"],
                       GROUPS=given["bars"], BARS=value)
