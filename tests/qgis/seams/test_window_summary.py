"""What is said about a window: verdict, ratios and cause, with its numbers where they are at hand."""
from __future__ import annotations

from typing import Any

import pytest
from qgis.core import QgsApplication
from seam_inspector.plugin.imagery.shifts import Shift
from seam_inspector.plugin.imagery.wavelets import Curve
from seam_inspector.plugin.seams import cause_words
from seam_inspector.plugin.seams.cause_words import CAUSES, cause_sentence, cause_word
from seam_inspector.plugin.seams.measure.causes import Cause
from seam_inspector.plugin.seams.measure.explanation import Change, Explanation
from seam_inspector.plugin.seams.measure.inspection import WindowResult
from seam_inspector.plugin.seams.measure.tone import Tone
from seam_inspector.plugin.seams.measure.verdicts import Judgement, Ratios, Verdict
from seam_inspector.plugin.seams.measure.window_records import WindowRecord
from seam_inspector.plugin.seams.window_summary import cause_numbers, explanation_of, window_sentence

from tests.qgis.seams.desk.windows_session import window

RATIOS = (0.38, 0.52, 0.88)


def row(cause: str, verdict: str = "significant", **values: Any) -> WindowRecord:
    return window(1, verdict, RATIOS, **{"sources": 2, "composite_ratio": 0.4, "cause": cause, **values})


def result(
    cause: str, apart: float | None = 1.4, shifts: tuple[float, ...] = (1.3, 1.3), **values: Any
) -> WindowResult:
    """Of a window whose mosaic was compared with one source and the composite."""
    ratios = Ratios(RATIOS, 1.2)
    changes = tuple(
        {"luminance": Change(**{
            "tone": Tone(0.62, 12.0, 0.6), "contrast": (0.43, 0.5, 0.6), "clipped": 0.031, "colour_shift": 1.24,
            "shift": Shift(length, 0.0, 0.5), **values,
        })}
        for length in shifts
    )  # fmt: skip
    curve = Curve((0.1, 0.2, 0.3), 0.4, 100.0)
    found = Explanation(
        Cause(cause), {"luminance": curve}, {"luminance": ratios}, {"luminance": 1.0}, changes, (0.41, 0.6, 0.9), 0.02,
        0.1, apart,
    )
    return WindowResult(1, None, Judgement(Verdict.SIGNIFICANT, ratios), explanation=found)


@pytest.mark.parametrize(
    ("cause", "words", "alone"),
    [
        ("blur", "blur to 69 % of their sharpness explains it", "blur explains it"),
        ("feathering", "feathering of images 1.4 px apart explains it", "feathering explains it"),
        ("narrowed histogram", "the histogram is narrowed, gain 0.62", "the histogram is narrowed"),
        ("gamma", "grey values are bent, gamma 0.60", "grey values are bent by a gamma"),
        ("clipping", "3.1 % of the pixels are clipped", "highlights or shadows are clipped"),
        ("colour shift", "the colours are shifted, gains differ by a factor of 1.24", "the colours are shifted"),
        ("misregistration", "the mosaic lies 1.3 px off its sources", "the mosaic does not lie where its sources do"),
        ("none", "no step of production took detail away", "no step of production took detail away"),
        ("unclear", "the cause is unclear: its detail is not that of the sources", None),
    ],
)
def test_every_cause_has_its_words(qgis_app: QgsApplication, cause: str, words: str, alone: str | None) -> None:
    start = "Significant loss. Detail at level 1 is 38 % of the sources'; "
    assert window_sentence(row(cause), result(cause)) == f"{start}{words}."
    assert window_sentence(row(cause)) == f"{start}{alone or words}."


def test_every_cause_has_its_entry() -> None:
    assert set(CAUSES) == {cause.value for cause in Cause}


@pytest.mark.parametrize("cause", list(Cause))
def test_all_causes_are_told(qgis_app: QgsApplication, monkeypatch: pytest.MonkeyPatch, cause: Cause) -> None:
    assert ";" in window_sentence(row(cause.value))
    assert cause_sentence(cause.value)
    monkeypatch.setattr(cause_words, "tr", str.upper)  # an unknown word is not translated but told as it is
    assert cause_word(cause.value) == cause.value.upper()


@pytest.mark.parametrize(
    ("values", "sentence"),
    [
        ({"composite_ratio": 0.62}, "Detail at level 1 is 38 % of the sources' and 62 % of their composite's; blur"),
        ({"composite_ratio": None}, "Detail at level 1 is 38 % of the sources'; blur"),
        ({"sources": 1}, "Detail at level 1 is 38 % of the source's; blur"),
        ({"verdict": "reduced"}, "Reduced. Detail at level 1 is 38 % of the sources'; blur explains it."),
        ({"verdict": "preserved"}, "Preserved. Detail at level 1 is 38 % of the sources'; it is blurred."),
        ({"verdict": "preserved", "cause": "none"}, "Preserved. Detail at level 1 is 38 % of the sources'."),
        ({"cause": ""}, "Significant loss. Detail at level 1 is 38 % of the sources'."),
        ({"cause": "of a later version"}, "Significant loss. Detail at level 1 is 38 % of the sources'."),
        ({"stale": True}, "blur explains it. Changed since: inspect it again."),
    ],
)
def test_what_else_is_told(qgis_app: QgsApplication, values: dict[str, Any], sentence: str) -> None:
    assert sentence in window_sentence(row(**{"cause": "blur", **values}))


def test_numbers_that_say_nothing_are_left_out(qgis_app: QgsApplication) -> None:
    for apart in (None, 0.02):
        assert window_sentence(row("feathering"), result("feathering", apart)).endswith("; feathering explains it.")
    assert window_sentence(row("gamma"), result("gamma", tone=None)).endswith("; grey values are bent by a gamma.")
    assert "where its sources do" in window_sentence(row("misregistration"), result("misregistration", shift=None))


def test_the_shift_told_is_that_of_the_source_that_the_composite_agrees_with(qgis_app: QgsApplication) -> None:
    found = result("misregistration", shifts=(9.0, 0.8, 0.9))
    assert "lies 0.8 px off" in window_sentence(row("misregistration"), found)


def test_a_result_that_is_not_the_one_in_the_row_is_left_aside(qgis_app: QgsApplication) -> None:
    found = result("feathering")
    assert explanation_of(row("feathering"), found) is found.explanation
    assert explanation_of(row("blur"), found) is None
    assert explanation_of(window(1, "significant", (0.39, 0.52, 0.88), cause="feathering"), found) is None
    assert explanation_of(row("feathering"), None) is None


def test_the_tooltip_tells_the_numbers(qgis_app: QgsApplication) -> None:
    found = result("feathering").explanation
    assert found is not None
    text = "\n".join(cause_numbers(found))
    for words in ("gain 0.62, bias 12.0, gamma 0.60", "contrast at level 1: 43 %", "clipped: 3.1 %", "1.40 px apart"):
        assert words in text
