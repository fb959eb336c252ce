"""What is said about a window: verdict, what it was taken by, and causes, with numbers where they are at hand."""
from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from qgis.core import QgsApplication
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.shifts import Shift
from seam_inspector.plugin.imagery.wavelets import Curve
from seam_inspector.plugin.seams.charts.profile_painter import ShownProfile, summary_words
from seam_inspector.plugin.seams.desk.windows.window_columns import COLUMNS
from seam_inspector.plugin.seams.measure import messages
from seam_inspector.plugin.seams.measure.compared_image import Change
from seam_inspector.plugin.seams.measure.judgement.causes import Cause, CauseEvidence, Misfit, SourceTone, Texture
from seam_inspector.plugin.seams.measure.judgement.explanation import Explanation
from seam_inspector.plugin.seams.measure.judgement.verdicts import Judgement, Ratios, Verdict
from seam_inspector.plugin.seams.measure.profile.seam_profile import ProfileBin, SeamProfile
from seam_inspector.plugin.seams.measure.tone import Tone
from seam_inspector.plugin.seams.measure.window.window_result import WindowResult
from seam_inspector.plugin.seams.measure.window.window_tables import window_rows
from seam_inspector.plugin.seams.measure.window_records import MAY_BE_SIGNIFICANT, WindowRecord
from seam_inspector.plugin.seams.window_summary import judged_words, window_sentence, window_why

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
    record = window(1, verdict, RATIOS, **{"sources": 2, "composite_ratio": 0.4, "cause": cause, **values})
    return replace(record, reference="sources")


def seam_row(verdict: str = "significant", **values: Any) -> WindowRecord:
    """Judged by its seam: a feather 2 m wide."""
    fields: dict[str, Any] = {
        "reference": "seam", "paper_verdict": values.get("verdict", verdict),
        "kept": (0.56, 0.81, 0.97), "kept_low": 0.51,
        "kept_high": 0.62, "band_width": 2.0, "sharpness": 1.0, "explained": 1.0, "cause": "feathering",
        "causes": "feathering", "sources": 2, **values,
    }
    return replace(window(1, verdict, RATIOS), **fields)


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
    explanation = Explanation(
        causes=tuple(map(Cause, causes.split("; "))), evidence=evidence, profile=profile, has_seam=True, explained=0.83,
        contrast=0.43, sharpness=0.69, added=0.04, curves={"luminance": curve}, ratios={"luminance": ratios},
        similarity={"luminance": 1.0}, changes=({"luminance": change},) * 2, expected=(0.41, 0.6, 0.9),
        unclear_share=0.02, mixed_share=0.1, visibility=1.4,
    )  # fmt: skip
    return WindowResult(
        1, None, Judgement(Verdict.SIGNIFICANT, ratios), Verdict.REDUCED, explanation=explanation,
        ground_sample_distance=0.1,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("cause", "words", "alone"),
    [
        ("blur", "the mosaic is blurred to 69 % of their sharpness", "the mosaic is blurred"),
        ("feathering", "images are feathered", None),
        ("clipping", "3.1 % of the pixels are clipped", "highlights or shadows are clipped"),
        ("misregistration", "images lie 1.4 px apart where they meet", "images do not fit where they meet"),
        ("resampled", "the mosaic was resampled, 0.3 px off the sources' pixels", "the mosaic was resampled"),
        ("sharpened", "the mosaic was sharpened to 142 % of the sources' contrast", "the mosaic was sharpened"),
        ("compressed", "the mosaic was compressed with loss, which changed fine detail by 2.3 DN",
         "the mosaic was compressed with loss"),
        ("none", "no step of production took detail away, so the sources differ in content", None),
    ],
)
def test_a_cause_has_its_words(qgis_app: QgsApplication, cause: str, words: str, alone: str | None) -> None:
    start = "Significant loss. Detail at level 1 is 38 % of the sources'; "
    measured = replace(row(cause), misfit=1.4)
    assert window_sentence(measured, result(cause)) == f"{start}{words}."
    assert window_sentence(row(cause)) == f"{start}{alone or words}."


@pytest.mark.parametrize(
    ("values", "sentence"),
    [
        ({"composite_ratio": 0.62}, "Detail at level 1 is 38 % of the sources' and 62 % of their composite's; the"),
        ({"composite_ratio": None}, "Detail at level 1 is 38 % of the sources'; the mosaic is"),
        ({"verdict": "reduced"}, "Reduced. Detail at level 1 is 38 % of the sources'; the mosaic is blurred."),
        ({"verdict": "preserved", "cause": "none"}, "Preserved. Detail at level 1 is 38 % of the sources'."),
        ({"cause": ""}, "Significant loss. Detail at level 1 is 38 % of the sources'."),
        ({"cause": "of a later version"}, "Significant loss. Detail at level 1 is 38 % of the sources'."),
        ({"stale": True}, "the mosaic is blurred. Changed since: inspect it again."),
    ],
)
def test_what_else_is_told(qgis_app: QgsApplication, values: dict[str, Any], sentence: str) -> None:
    assert sentence in window_sentence(row(**{"cause": "blur", **values}))


STRIP, FEATHER = "44 % of detail lost in 1.6 m along the seam", "feathered over 2.0 m"
CUT = "Feather less."
SOUND = {"verdict": "preserved", "kept": (0.98,), "kept_low": 0.9, "kept_high": 1.07, "band_width": 0.0}


@pytest.mark.parametrize(
    ("values", "sentence"),
    [
        ({}, f"Significant loss. {STRIP}: {FEATHER}. {CUT}"),
        (
            {"causes": "feathering; misregistration", "misfit": 2.04, "feather_width": 1.5},
            f"Significant loss. {STRIP}: feathered over 1.5 m, images 2.0 px apart. {CUT}",
        ),
        (  # in all of the window more is gone than beside the seam
            {"verdict": "reduced", "kept": (0.84,), "kept_low": 0.78, "kept_high": 0.91, "sharpness": 0.81,
             "loss": 3634.3, "cause": "resampled", "causes": "resampled; unclear; feathering"},
            ("Reduced. 34 % of the window's detail lost (3,634 m²; limit 85 %), 16 % of the rest along the "
             "seam: resampled. Don't resample it."),
        ),
        (  # on this side of the limit, and said so
            {"verdict": "reduced", "kept": (0.703,), "kept_low": 0.6, "kept_high": 0.8},
            f"Reduced. 29.7 % of detail lost in 1.6 m along the seam: {FEATHER}. {CUT}",
        ),
        (  # what resampling took all over is no part of what the misfit did
            {"sharpness": 0.79, "loss": 3931.0, "cause": "resampled", "causes": "resampled; misregistration",
             "misfit": 2.2},
            f"Significant loss. {STRIP}: images 2.2 px apart. Register images. In all 3,931 m².",
        ),
        (
            {"verdict": "reduced", "cause": "unclear", "causes": "unclear; feathering", "feather_width": 1.9},
            f"Reduced. {STRIP}: cause unclear. Judge by eye.",
        ),
        (
            {**SOUND, "cause": "none", "causes": "none", "visibility": 0.1, "feather_width": 0.0, "loss": 0.0},
            "Preserved. As much of the finest detail is left in 1.6 m along the seam as around it.",
        ),
        (  # what was done, without a number along a seam
            {"verdict": "preserved", "kept": (), "cause": "compressed", "causes": "compressed", "reason": "No seam."},
            "Preserved. No seam. The mosaic was compressed with loss.",
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
            f"Reduced. 41 % of detail lost in 1.6 m along the seam: {FEATHER}. It may be more: judge by eye.",
        ),
    ],
)
def test_by_the_seam_the_sentence_says_what_one_sees(
    qgis_app: QgsApplication, values: dict[str, Any], sentence: str
) -> None:
    assert window_sentence(seam_row(**values), pixel_m=0.1) == sentence


@pytest.mark.parametrize(
    ("causes", "kept", "sharpness", "written"),
    [
        # the seam made the verdict, and resampling took more
        ("resampled; misregistration; feathering", 0.56, 0.79, "misregistration; feathering; resampled"),
        ("resampled; balanced; softened seam", 0.56, 0.79, "softened seam; resampled; balanced"),
        ("softened seam; feathering; blur", 0.56, 0.79, "softened seam; feathering; blur"),
        ("resampled; unclear; feathering", 0.84, 0.81, "resampled; unclear; feathering"),
        ("feathering; resampled", 0.84, 0.81, "resampled; feathering"),
        ("missing source; feathering", 0.56, 1.0, "feathering; missing source"),
    ],
)
def test_the_cause_that_is_written_is_the_one_that_the_sentence_tells(
    qgis_app: QgsApplication, causes: str, kept: float, sharpness: float, written: str
) -> None:
    measured = result(causes, profile=replace(PROFILE, kept=(kept,), low=kept - 0.05, high=kept + 0.06))
    assert measured.explanation is not None
    verdict = "significant" if kept <= 0.7 else "reduced"
    measured = replace(
        measured, judgement=replace(measured.judgement, verdict=Verdict(verdict)),
        explanation=replace(measured.explanation, sharpness=sharpness),
    )
    values = window_rows([measured])[0]
    assert values["causes"] == written
    assert values["cause"] == written.split("; ")[0]
    seen = seam_row(verdict, kept=(kept,), kept_low=kept - 0.05, kept_high=kept + 0.06, sharpness=sharpness,
                    cause=values["cause"], causes=written)
    brief = {"misregistration": "images do not fit", "softened seam": "softened", "feathering": "feathered"}
    reason = messages.VERDICT_OF_THE_REST(share=3)
    with_reason = replace(measured, judgement=replace(measured.judgement, reason=reason))
    assert str(reason) in window_why(replace(seen, reason="As it was inspected."), with_reason)  # in the reader's words
    for said in (window_sentence(seen), window_sentence(seen, measured)):
        assert f": {brief.get(str(values['cause']), values['cause'])}" in said
    assert Cause(causes.split("; ")[0]) is measured.explanation.cause  # by the energy that each took


@pytest.mark.parametrize(
    ("ratio", "composite", "is_said"),
    [(0.98, 1.01, False), (0.8, 1.0, True), (0.99, 0.9, True), (None, 1.2, True), (None, None, False)],
)
def test_curves_that_lie_apart_where_nothing_is_lost_are_explained(
    qgis_app: QgsApplication, ratio: float | None, composite: float | None, is_said: bool
) -> None:
    said = window_why(seam_row(**SOUND, ratios=(ratio,), composite_ratios=(composite,)))
    place = said.index("The window is as sharp as its sources.")
    assert any("curve lies apart all the same" in line for line in said[place + 1 :]) == is_said


def test_numbers_lie_on_their_side_of_their_limits(qgis_app: QgsApplication) -> None:
    at_seam = seam_row(kept=(0.6996,), kept_low=0.62, kept_high=0.704)
    assert judged_words(at_seam)[0] == "kept 1: 0.6996 (0.62 to 0.704)"
    assert "between 29.6 and 38 %" in window_why(at_seam)[0]
    by_ratio = replace(row("none"), ratios=(0.503,), composite_ratios=(0.4996,))
    assert judged_words(by_ratio) == ["ratio 1: 0.503", "composite: 0.4996"]
    (column,) = (column for column in COLUMNS if column.name == "ratio")
    assert column.text(by_ratio) == "0.503"
    assert summary_words(ShownProfile(replace(PROFILE, kept=(0.6996,), low=0.62, high=0.704), 0.1, 0.7)).startswith(
        "69.96 % kept (62 to 70.4 %)"
    )


@pytest.mark.parametrize(("side_px", "width"), [(512, "28.0"), (280, "28.0"), (256, "at least 25.6")])
def test_a_seam_is_no_wider_than_its_window(qgis_app: QgsApplication, side_px: int, width: str) -> None:
    """Ground was read beyond it."""
    measured, seen = result("feathering"), seam_row(feather_width=28.0)
    measured = replace(measured, window=PixelWindow(0, 0, side_px, 64))
    assert f"44 % of detail lost in 1.6 m along the seam: feathered over {width} m" in window_sentence(seen, measured)
    assert any(f"over {width} m" in said for said in window_why(seen, measured))
