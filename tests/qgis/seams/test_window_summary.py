"""What is said about a window: verdict, what it was taken by, and causes, with numbers where they are at hand."""
from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from qgis.core import QgsApplication
from seam_inspector.plugin.imagery.shifts import Shift
from seam_inspector.plugin.imagery.wavelets import Curve
from seam_inspector.plugin.seams.measure.compared_image import Change
from seam_inspector.plugin.seams.measure.judgement.causes import (
    Cause,
    CauseEvidence,
    Misfit,
    SourceTone,
    Texture,
    find_causes,
)
from seam_inspector.plugin.seams.measure.judgement.explanation import Explanation
from seam_inspector.plugin.seams.measure.judgement.verdicts import Judgement, Ratios, Verdict
from seam_inspector.plugin.seams.measure.messages import VERDICT_OF_THE_REST
from seam_inspector.plugin.seams.measure.profile.seam_profile import Measure, ProfileBin, SeamProfile
from seam_inspector.plugin.seams.measure.tone import Tone
from seam_inspector.plugin.seams.measure.window.window_result import WindowResult
from seam_inspector.plugin.seams.measure.window_records import MAY_BE_SIGNIFICANT, OF_THE_REST, WindowRecord
from seam_inspector.plugin.seams.window_summary import (
    explanation_of,
    told_causes,
    window_sentence,
    window_why,
)
from seam_inspector.plugin.toolkit.translation import sentence

from tests.qgis.seams.desk.windows_session import window

RATIOS = (0.38, 0.52, 0.88)
EVIDENCE = CauseEvidence(
    missing=0.17, profile=None, lost=0.1, mixed=0.1, sharpness=0.69, clipped=0.031, clipped_lost=0.03,
    tones=(SourceTone(0.62, 0.41, 0.6, 1.24), SourceTone(0.50, 0.4, 1.0, 1.1)), unevenness=0.0,
    misfit=Misfit(1.4, 0.6), off_pixel=0.31, texture=Texture(0.9, 0.69, 1.42, 0.9, 2.34, 1.1, 0.0),
    lossy_file=False, lossy_sources=False,
)  # fmt: skip
PROFILE = SeamProfile(
    (0.56, 0.81, 0.97), 0.51, 0.62, 20.0, 0.05,
    (
        ProfileBin(1, 0, 2, 0.56, 0.5, 0.63, 0.55, 1200.0, 0.48),
        ProfileBin(1, 256, float("inf"), 1.0, 0.9, 1.1, 1.0, 5e4),
    ),
    feather_width_px=15.0, by_energy=0.57, by_mixture=0.55, lost=900.0, energy=(60.0, 90.0, 120.0),
)  # fmt: skip


def row(cause: str, verdict: str = "significant", **values: Any) -> WindowRecord:
    """Judged by the paper's rule."""
    found = window(1, verdict, RATIOS, **{"sources": 2, "composite_ratio": 0.4, "cause": cause, **values})
    return replace(found, reference="sources")


def seam_row(verdict: str = "significant", **values: Any) -> WindowRecord:
    """Judged by its seam: a feather 2 m wide."""
    found: dict[str, Any] = {
        "reference": "seam", "paper_verdict": values.get("verdict", verdict),
        "kept": (0.56, 0.81, 0.97), "kept_low": 0.51,
        "kept_high": 0.62, "band_width": 2.0, "sharpness": 1.0, "explained": 1.0, "cause": "feathering",
        "causes": "feathering", "sources": 2, **values,
    }
    return replace(window(1, verdict, RATIOS), **found)


def result(
    causes: str, evidence: CauseEvidence = EVIDENCE, profile: SeamProfile = PROFILE, **values: Any
) -> WindowResult:
    """Result of a window whose mosaic was compared with one source and the composite."""
    ratios = Ratios(RATIOS, 1.2)
    change = Change(**{
        "tone": Tone(0.62, 12.0, 0.6), "contrast": (0.43, 0.5, 0.6), "clipped": 0.031, "colour_shift": 1.24,
        "shift": Shift(1.3, 0.0, 0.5), **values,
    })  # fmt: skip
    curve = Curve((0.1, 0.2, 0.3), 0.4, 100.0)
    found = Explanation(
        causes=tuple(map(Cause, causes.split("; "))), evidence=evidence, profile=profile, has_seam=True, explained=0.83,
        contrast=0.43, sharpness=0.69, added=0.04, curves={"luminance": curve}, ratios={"luminance": ratios},
        similarity={"luminance": 1.0}, changes=({"luminance": change},) * 2, expected=(0.41, 0.6, 0.9),
        unclear_share=0.02, mixed_share=0.1, shares=(1.0,), visibility=1.4,
    )  # fmt: skip
    return WindowResult(
        1, None, Judgement(Verdict.SIGNIFICANT, ratios), Verdict.REDUCED, explanation=found,
        ground_sample_distance=0.1,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("cause", "words", "alone"),
    [
        ("blur", "the mosaic is blurred to 69 % of their sharpness", "the mosaic is blurred"),
        ("feathering", "images 1.4 px apart are feathered", "images are feathered"),
        ("narrowed histogram", "the histogram is narrowed, gain 0.62", "the histogram is narrowed"),
        ("gamma", "grey values are bent, gamma 0.60", "grey values are bent by a gamma"),
        ("clipping", "3.1 % of the pixels are clipped", "highlights or shadows are clipped"),
        ("colour shift", "the colours are shifted, gains differ by a factor of 1.24", "the colours are shifted"),
        ("misregistration", "images lie 1.4 px apart where they meet", "images do not fit where they meet"),
        ("other mixture", "images are mixed by another rule than weights", None),
        (
            "missing source", "17 % of the mosaic match none of these sources",
            "a part of the mosaic matches none of these sources",
        ),
        ("resampled", "the mosaic was resampled, 0.3 px off the sources' pixels", "the mosaic was resampled"),
        ("sharpened", "the mosaic was sharpened to 142 % of the sources' contrast", "the mosaic was sharpened"),
        ("compressed", "the mosaic was compressed with loss, which changed fine detail by 2.3 DN",
         "the mosaic was compressed with loss"),
        ("noise added", "noise of 2.3 DN was added", "noise was added"),
        ("dodging", "brightness was evened out from place to place", None),
        ("balanced", "the sources' tones were balanced, gains a factor of 1.24 apart",
         "the sources' tones were balanced"),
        ("none", "no step of production took detail away, so the sources differ in content", None),
        ("unclear", "the cause is unclear", None),
    ],
)
def test_every_cause_has_its_words(qgis_app: QgsApplication, cause: str, words: str, alone: str | None) -> None:
    start = "Significant loss. Detail at level 1 is 38 % of the sources'; "
    assert window_sentence(row(cause), result(cause)) == f"{start}{words}."
    assert window_sentence(row(cause)) == f"{start}{alone or words}."


@pytest.mark.parametrize(
    ("values", "sentence"),
    [
        ({"composite_ratio": 0.62}, "Detail at level 1 is 38 % of the sources' and 62 % of their composite's; the"),
        ({"composite_ratio": None}, "Detail at level 1 is 38 % of the sources'; the mosaic is"),
        ({"sources": 1}, "Detail at level 1 is 38 % of the source's; the mosaic is"),
        ({"verdict": "reduced"}, "Reduced. Detail at level 1 is 38 % of the sources'; the mosaic is blurred."),
        ({"verdict": "preserved"}, "Preserved. Detail at level 1 is 38 % of the sources'; the mosaic is blurred."),
        ({"verdict": "preserved", "cause": "none"}, "Preserved. Detail at level 1 is 38 % of the sources'."),
        ({"cause": ""}, "Significant loss. Detail at level 1 is 38 % of the sources'."),
        ({"cause": "of a later version"}, "Significant loss. Detail at level 1 is 38 % of the sources'."),
        ({"stale": True}, "the mosaic is blurred. Changed since: inspect it again."),
    ],
)
def test_what_else_is_told(qgis_app: QgsApplication, values: dict[str, Any], sentence: str) -> None:
    assert sentence in window_sentence(row(**{"cause": "blur", **values}))


def test_numbers_that_say_nothing_are_left_out(qgis_app: QgsApplication) -> None:
    bare = replace(EVIDENCE, tones=(), texture=None, misfit=None)
    for evidence in (bare, replace(bare, misfit=Misfit(0.02, 0.0))):
        found = result("feathering", evidence)
        assert window_sentence(row("feathering"), found).endswith("; images are feathered.")
    assert window_sentence(row("gamma"), result("gamma", bare)).endswith("; grey values are bent by a gamma.")
    assert window_sentence(row("noise added"), result("noise added", bare)).endswith("; noise was added.")
    found = result("misregistration", bare)
    assert "images do not fit where they meet" in window_sentence(row("misregistration"), found)


STRIP = "44 % of detail lost in 2.0 m along the seam"
CUT = "Cut hard or feather less."
NO_SEAM = {"kept": (None,), "kept_low": None, "kept_high": None, "band_width": None}
SOUND = {"verdict": "preserved", "kept": (0.98,), "kept_low": 0.9, "kept_high": 1.07, "band_width": 0.0}


@pytest.mark.parametrize(
    ("values", "sentence"),
    [
        ({}, f"Significant loss. {STRIP}: feathered. {CUT}"),
        (
            {"visibility": 1.42, "feather_width": 1.53, "loss": 81.4},
            f"Significant loss. {STRIP} (81 m²): feathered. {CUT}",
        ),
        (
            {"verdict": "reduced", "kept": (0.85,), "kept_low": 0.8, "kept_high": 0.88, "loss": 2.66},
            f"Reduced. 15 % of detail lost in 2.0 m along the seam (2.7 m²): feathered. {CUT}",
        ),
        (
            {"band_width": 0.0},
            f"Significant loss. 44 % of detail lost beside the seam: feathered. {CUT}",
        ),
        (
            {"causes": "feathering; misregistration", "misfit": 2.04, "feather_width": 1.5},
            f"Significant loss. {STRIP}: feathered, 2.0 px misfit. {CUT}",
        ),
        (
            {"causes": "misregistration; feathering", "misfit": 2.04, "feather_width": 1.5},
            f"Significant loss. {STRIP}: 2.0 px misfit, feathered. Register images.",
        ),
        ({"misfit": 2.04}, f"Significant loss. {STRIP}: feathered. {CUT}"),  # it cost nothing
        (
            {"causes": "other mixture; misregistration", "feather_width": 1.5, "misfit": 2.0},
            f"Significant loss. {STRIP}: mixed, but not by weights. Cut hard there.",
        ),
        (  # half a pixel off explains no dip along the seam
            {"causes": "resampled; feathering; balanced", "sharpness": 0.99},
            f"Significant loss. {STRIP}: feathered. {CUT}",
        ),
        (
            {"verdict": "reduced", "sharpness": 0.8, "cause": "blur", "causes": "blur; feathering; compressed"},
            f"Reduced. {STRIP}: feathered. {CUT}",
        ),
        (  # in all of the window more is gone than beside the seam
            {"verdict": "reduced", "kept": (0.84,), "kept_low": 0.78, "kept_high": 0.91, "sharpness": 0.81,
             "loss": 3634.3, "cause": "resampled", "causes": "resampled; unclear; feathering"},
            ("Reduced. 34 % of the window's detail lost (3,634 m²), 16 % of the rest along the seam: resampled. Keep "
             "the pixel grid."),
        ),
        (  # what resampling took all over is no part of what the misfit did
            {"sharpness": 0.79, "loss": 3931.0, "cause": "resampled", "causes": "resampled; misregistration",
             "misfit": 2.2},
            f"Significant loss. {STRIP}: 2.2 px misfit. Register images. In all 3,931 m².",
        ),
        (
            {"verdict": "reduced", "cause": "unclear", "causes": "unclear; feathering", "feather_width": 1.9},
            f"Reduced. {STRIP}: cause unclear. Judge by eye.",
        ),
        (
            {"cause": "missing source", "causes": "missing source; feathering", "explained": 0.8},
            f"Significant loss. {STRIP}: feathered. Add the missing orthoimage.",
        ),
        ({"stale": True}, f"Significant loss. {STRIP}: feathered. Changed since: inspect it again."),
        (
            {**SOUND, "cause": "none", "causes": "none", "visibility": 0.1, "feather_width": 0.0, "loss": 0.0},
            "Preserved. Along the seam as much of the finest detail is left as around it.",
        ),
        (
            {**SOUND, "causes": "misregistration; balanced", "misfit": 3.47},
            ("Preserved. Along the seam as much of the finest detail is left as around it; images lie 3.5 px apart "
             "where they meet."),
        ),
        (
            {**SOUND, "kept": (0.92,), "causes": "none"},
            "Preserved. Along the seam no loss is certain.",
        ),
        (  # by the sharpness: what is left along the seam is no reason
            {"verdict": "reduced", "kept": (1.07,), "kept_low": 0.88, "kept_high": 1.22, "band_width": 0.0,
             "sharpness": 0.97, "cause": "none", "causes": "none"},
            "Reduced. 5.9 % of the window's detail lost, no more along the seam.",
        ),
        (  # by the sharpness, too: kept is not shown
            {"kept": (1.37,), "kept_low": 1.1, "kept_high": 1.6, "band_width": 0.0, "sharpness": 0.36,
             "causes": "blur", "loss": 8704.0},
            ("Significant loss. 87 % of the window's detail lost (8,704 m²): blurred. Leave out that "
             "filter."),
        ),
        (  # it may be more: what to do about it is to measure
            {"verdict": "reduced", "kept": (0.59,), "kept_low": 0.35, "kept_high": 0.94,
             "reason": "Said in another language.", "reason_code": MAY_BE_SIGNIFICANT},
            "Reduced. 41 % of detail lost in 2.0 m along the seam: feathered. It may be more: judge by eye.",
        ),
        (
            {**NO_SEAM, "verdict": "preserved", "reason": "One source covers it.", "explained": 0.83,
             "cause": "missing source", "causes": "missing source; balanced"},
            "Preserved. One source covers it.",
        ),
    ],
)
def test_by_the_seam_the_sentence_says_what_one_sees(
    qgis_app: QgsApplication, values: dict[str, Any], sentence: str
) -> None:
    assert window_sentence(seam_row(**values)) == sentence


def test_pixels_that_took_no_part_are_told_once(qgis_app: QgsApplication) -> None:
    """The reason of a verdict of the rest names them already."""
    reason = sentence(VERDICT_OF_THE_REST(share=9.98))
    row = seam_row(explained=0.9002, reason=reason, reason_code=OF_THE_REST)
    assert " ".join([window_sentence(row), *window_why(row)]).count("took no part") == 1


def test_what_is_blamed_and_what_mixing_takes_agree(qgis_app: QgsApplication) -> None:
    """A feather of 1.9 m that takes 2.2 of 16 % is not what made a strip of softer ground."""
    profile = replace(PROFILE, measure=Measure.ENERGY, kept=(0.84, 0.9, 1.0), low=0.78, high=0.91, by_energy=0.84,
                      by_mixture=0.978, feather_width_px=19.0)  # fmt: skip
    values = {"verdict": "reduced", "kept": (0.84,), "kept_low": 0.78, "kept_high": 0.91, "feather_width": 1.9}
    causes = "; ".join(find_causes(replace(EVIDENCE, profile=profile, lost=0.01, misfit=None, tones=(), texture=None,
                                           off_pixel=0.0, missing=0.0, clipped=0.0, sharpness=1.0)))  # fmt: skip
    assert causes == "unclear; feathering"
    said = told(causes, profile, values, sharpness=1.0, misfit=None, lost=0.01)
    assert said.startswith("Reduced. 16 % of detail lost in 2.0 m along the seam: cause unclear.")
    assert "Mixing alone would have taken 2.2 % there; what took the rest is unclear." in said
    assert "feathered" not in said


def test_a_result_that_is_not_the_one_in_the_row_is_left_aside(qgis_app: QgsApplication) -> None:
    found = result("feathering")
    assert explanation_of(row("feathering"), found) is found.explanation
    assert explanation_of(row("blur"), found) is None
    assert explanation_of(window(1, "significant", (0.39, 0.52, 0.88), cause="feathering"), found) is None
    assert explanation_of(row("feathering"), None) is None


@pytest.mark.parametrize(
    ("values", "causes"),
    [
        ({"causes": "feathering; balanced", "cause": "feathering"}, ["feathering"]),
        (  # the seam made the verdict, and resampling took more
            {"cause": "resampled", "causes": "resampled; misregistration; feathering", "sharpness": 0.79},
            ["misregistration", "resampled"],
        ),
        (
            {"verdict": "reduced", "kept": (0.84,), "kept_low": 0.78, "kept_high": 0.91, "sharpness": 0.81,
             "cause": "resampled", "causes": "resampled; unclear; feathering"},
            ["resampled"],
        ),
        ({**SOUND, "cause": "resampled", "causes": "resampled; feathering"}, ["resampled"]),
    ],
)  # fmt: skip
def test_the_table_names_the_cause_that_the_sentence_tells_first(values: dict[str, Any], causes: list[str]) -> None:
    assert told_causes(seam_row(**values)) == causes
