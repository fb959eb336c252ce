"""What happened to a window: each cause at its limits, the order of several, and what rules another one out."""
from __future__ import annotations

import re
from dataclasses import fields, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from seam_inspector.plugin.seams.measure import limits
from seam_inspector.plugin.seams.measure.judgement import causes as rules
from seam_inspector.plugin.seams.measure.judgement.causes import (
    Cause,
    CauseEvidence,
    Misfit,
    SourceTone,
    Texture,
    causes_taken,
    find_causes,
)
from seam_inspector.plugin.seams.measure.judgement.loss_place import LossPlace
from seam_inspector.plugin.seams.measure.profile.seam_profile import STRIP_PX, Measure, SeamProfile

SOUND_TEXTURE = Texture(
    transfer=1.0, least_transfer=1.0, most_transfer=1.0, strong_transfer=1.0, noise_dn=0.4,
    noise_rise=1.0, quantised=0.0,
)  # fmt: skip
SOUND_TONE = SourceTone(gain=1.0, offset=0.5, gamma=1.0, colour_shift=1.0)
SOUND_PROFILE = SeamProfile((1.0, 1.0, 1.0), 0.9, 1.1, 0.0, 0.0, (), feather_width_px=0.0)
SOUND = CauseEvidence(
    missing=0.0, profile=SOUND_PROFILE, lost=0.0, mixed=0.0, sharpness=1.0, clipped=0.0, clipped_lost=0.0,
    tones=(SOUND_TONE, SOUND_TONE), unevenness=0.0, misfit=None, off_pixel=0.0, texture=SOUND_TEXTURE,
    lossy_file=False, lossy_sources=False,
)  # fmt: skip
LITTLE = 1e-6
OF_PROFILE = {"kept": "kept", "kept_high": "high", **{
    name: name for name in ("measure", "by_energy", "by_mixture", "left_by_mixture", "feather_width_px")
}}  # fmt: skip
"""Values by the names that tests give them, and those of the profile."""


def evidence(**changes: Any) -> CauseEvidence:
    """Sound but for some values: of the evidence, of its profile or texture, or of the tones of both sources."""
    of_evidence = {field.name for field in fields(CauseEvidence)}
    of_texture = {field.name for field in fields(Texture)} - of_evidence
    changed = replace(SOUND, **{name: value for name, value in changes.items() if name in of_evidence})
    texture = {name: value for name, value in changes.items() if name in of_texture}
    profile = {OF_PROFILE[name]: value for name, value in changes.items() if name in OF_PROFILE}
    tone = {name: value for name, value in changes.items() if name not in of_evidence | of_texture | set(OF_PROFILE)}
    if "kept" in profile:
        profile["kept"] = (profile["kept"], 1.0, 1.0)
    if profile:
        changed = replace(changed, profile=replace(SOUND_PROFILE, **profile))
    if texture:
        changed = replace(changed, texture=replace(SOUND_TEXTURE, **texture))
    return replace(changed, tones=tuple(replace(fitted, **tone) for fitted in SOUND.tones)) if tone else changed


def two_tones(**changes: Any) -> CauseEvidence:
    """The second source's tone is changed."""
    return replace(SOUND, tones=(SOUND_TONE, replace(SOUND_TONE, **changes)))


NOISY = {"noise_dn": 4.0}
COMPRESSED = {"noise_dn": 4.0, "quantised": 2 * rules.MIN_VANISHED}
FROM_COMPRESSED = {"noise_dn": 4.0, "source_traces": 2 * rules.MIN_VANISHED}
BENT = {"gamma": 0.5}
FEATHERED = {"kept": 0.5, "kept_high": 0.6, "feather_width_px": 20.0}
OFF = Misfit(2.0, 0.6)


def test_where_nothing_is_lost_or_changed_none_stands_alone() -> None:
    assert find_causes(SOUND) == (Cause.NONE,)
    assert find_causes(replace(SOUND, profile=None, texture=None, tones=(), sharpness=None)) == (
        Cause.NONE,
    )
    assert find_causes(evidence(gain=None, colour_shift=None)) == (Cause.NONE,)


def test_the_documentation_lists_the_causes_in_their_order(repository: Path) -> None:
    page = (repository / "docs" / "method" / "causes.md").read_text(encoding="utf-8")
    table = page.partition("| Cause | Limit |")[2].partition("\n\n")[0]
    assert re.findall(r"^\| `([a-z ]+)` \|", table, re.MULTILINE) == [cause.value for cause in Cause]


def test_less_than_a_mixture_leaves_is_blur_along_the_seam() -> None:
    assert find_causes(evidence(kept=0.1, kept_high=rules.MIN_BLENDED_KEPT - LITTLE)) == (Cause.SOFTENED,)
    assert find_causes(evidence(kept=0.1, kept_high=rules.MIN_BLENDED_KEPT)) == (Cause.FEATHERING,)


def test_two_seams_are_explained_each_by_itself() -> None:
    feathered = replace(SOUND_PROFILE, kept=(0.6,), high=0.7, lost=300.0)
    softened = replace(feathered, kept=(0.1,), high=0.15, lost=100.0)
    both = replace(evidence(kept=0.4, kept_high=0.5), lost=0.2, sharpness=0.9)
    assert find_causes(both) == (Cause.FEATHERING,)
    both = replace(both, seams=(feathered, softened, SOUND_PROFILE))
    taken = dict(causes_taken(both))
    assert taken == {Cause.FEATHERING: pytest.approx(0.15), Cause.SOFTENED: pytest.approx(0.05)}


@pytest.mark.parametrize("by_mixture", [0.98, 0.8])
def test_where_energy_says_much_less_than_the_mixture_it_was_softened(by_mixture: float) -> None:
    least = rules.MOST_LIKE_BLUR * by_mixture
    values = {"kept_high": 0.69, "by_mixture": by_mixture, "measure": Measure.ENERGY}
    assert find_causes(evidence(**values, kept=0.5, by_energy=least - LITTLE)) == (Cause.SOFTENED,)
    assert Cause.SOFTENED not in find_causes(evidence(**values, kept=0.5, by_energy=least + LITTLE))
    agreed = {**values, "measure": Measure.BOTH}
    assert find_causes(evidence(**agreed, kept=0.5, by_energy=least - LITTLE)) == (Cause.FEATHERING,)


def test_a_feather_is_blamed_where_it_takes_a_good_part_of_the_loss() -> None:
    """A strip lost 20 %, of which the mixture takes a third, or a tenth."""
    values = {"kept": 0.8, "by_energy": 0.8, "kept_high": 0.9, "measure": Measure.ENERGY, "lost": 0.1}
    part = rules.MIN_MIXED_LOSS * 0.2
    much = {**values, "by_mixture": 1 - part - LITTLE}
    assert causes_taken(evidence(**much, feather_width_px=20.0)) == ((Cause.FEATHERING, 0.1),)
    little = {**values, "by_mixture": 0.98}
    causes = causes_taken(evidence(**little, feather_width_px=20.0))
    assert [cause for cause, _ in causes] == [Cause.UNCLEAR, Cause.FEATHERING]
    assert [share for _, share in causes] == pytest.approx([0.09, 0.01])
    misfit = dict(causes_taken(evidence(**little, feather_width_px=20.0, misfit=OFF)))
    assert sum(misfit.values()) == pytest.approx(0.1)
    assert misfit[Cause.MISREGISTRATION] == pytest.approx(OFF.share * 0.01)
    agreed = evidence(**{**little, "measure": Measure.BOTH}, feather_width_px=20.0)
    assert find_causes(agreed) == (Cause.FEATHERING,)


def test_images_mixed_by_no_weights_are_another_mixture() -> None:
    most, least = rules.MOST_LEFT, rules.NARROW_PX
    other = evidence(**{**FEATHERED, "feather_width_px": least}, left_by_mixture=most + LITTLE)
    assert find_causes(other) == (Cause.OTHER_MIXTURE,)
    assert find_causes(evidence(**FEATHERED, left_by_mixture=most)) == (Cause.FEATHERING,)
    cut = evidence(**{**FEATHERED, "feather_width_px": least - LITTLE}, left_by_mixture=1.0)
    assert Cause.OTHER_MIXTURE not in find_causes(cut)  # of a border that is known no better


AT_LIMITS: list[tuple[str, float, int, dict[str, Any], Cause]] = [
    ("missing", rules.MIN_MISSING_SHARE, 1, {}, Cause.MISSING_SOURCE),
    ("kept", rules.MAX_FEATHERED_KEPT, -1, {"kept_high": 0.99}, Cause.FEATHERING),
    ("kept_high", 1.0, -1, {"kept": 0.9}, Cause.FEATHERING),
    ("mixed", rules.MIN_MIXED, 1, {"profile": None}, Cause.FEATHERING),
    ("least_transfer", rules.MAX_BLURRED_TRANSFER, -1, {}, Cause.BLUR),
    ("least_transfer", 0.5**rules.BENT_TRANSFER * rules.MAX_BLURRED_TRANSFER, -1, BENT, Cause.BLUR),
    ("least_held", rules.MAX_BLURRED_TRANSFER, -1, {**FROM_COMPRESSED, "least_transfer": 0.2}, Cause.BLUR),
    ("least_held", rules.MAX_BLURRED_TRANSFER, -1, {**NOISY, "lossy_sources": True, "least_transfer": 0.2}, Cause.BLUR),
    ("source_traces", rules.MIN_VANISHED, -1, NOISY, Cause.NOISE_ADDED),
    ("strong_transfer", rules.MAX_BLURRED_COMPRESSED, -1, {**COMPRESSED, "least_transfer": 0.2}, Cause.BLUR),
    ("sharpness", rules.MAX_BLURRED_TRANSFER, -1, {"texture": None}, Cause.BLUR),
    ("off_pixel", rules.MIN_RESAMPLED_PX, 1, {}, Cause.RESAMPLED),
    ("most_transfer", rules.MIN_SHARPENED_TRANSFER, 1, {}, Cause.SHARPENED),
    ("most_transfer", 2**rules.BENT_TRANSFER * rules.MIN_SHARPENED_TRANSFER, 1, {"gamma": 2.0}, Cause.SHARPENED),
    ("quantised", rules.MIN_VANISHED, 1, NOISY, Cause.COMPRESSED),
    ("quantised", rules.MIN_LOSSY_VANISHED, 1, {**NOISY, "lossy_file": True}, Cause.COMPRESSED),
    ("noise_dn", rules.MIN_NOISE_DN, 1, {}, Cause.NOISE_ADDED),
    ("noise_dn", 2 * rules.MIN_NOISE_DN, 1, {"transfer": 2.0}, Cause.NOISE_ADDED),
    ("noise_rise", rules.MAX_NOISE_RISE, -1, NOISY, Cause.NOISE_ADDED),
    ("clipped", rules.MIN_CLIPPED_SHARE, 1, {}, Cause.CLIPPING),
    ("unevenness", rules.MIN_UNEVENNESS, 1, {}, Cause.DODGING),
    ("gamma", rules.MIN_GAMMA_CHANGE, 1, {}, Cause.GAMMA),
    ("gamma", 1 / rules.MIN_GAMMA_CHANGE, -1, {}, Cause.GAMMA),
    ("colour_shift", rules.MIN_GAIN_RATIO, 1, {}, Cause.COLOUR_SHIFT),
    ("gain", rules.MAX_NARROWED_GAIN, -1, {}, Cause.NARROWED_HISTOGRAM),
]


@pytest.mark.parametrize(("name", "limit", "beyond", "besides", "cause"), AT_LIMITS)
def test_each_cause_begins_at_its_limit(
    name: str, limit: float, beyond: int, besides: dict[str, Any], cause: Cause
) -> None:
    assert cause in find_causes(evidence(**{**besides, name: limit + beyond * LITTLE}))
    assert cause not in find_causes(evidence(**{**besides, name: limit - beyond * LITTLE}))


@pytest.mark.parametrize(("name", "limit", "beyond", "besides", "cause"), AT_LIMITS)
def test_alone_it_is_the_only_one(name: str, limit: float, beyond: int, besides: dict[str, Any], cause: Cause) -> None:
    """Or with what had to be there besides and is a cause of its own: sources that were compressed can be blurred."""
    causes = find_causes(evidence(**{**besides, name: limit + beyond * LITTLE}))
    implied = {Cause.COMPRESSED} if "quantised" in besides else {Cause.GAMMA} if "gamma" in besides else set()
    assert set(causes) == {cause} | implied


@pytest.mark.parametrize("codec", [{"source_traces": 0.5}, {"lossy_sources": True}])
def test_what_a_codec_took_of_the_sources_since_is_none_of_the_mosaics_doing(codec: dict[str, Any]) -> None:
    """Compared with what is left of its sources, a sound mosaic correlates less, and has more."""
    held = {"transfer": 0.85, "least_transfer": 0.8, "most_transfer": 0.9, "least_held": 1.1}
    assert find_causes(evidence(**NOISY, **held, **codec)) == (Cause.NONE,)
    assert Cause.BLUR in find_causes(evidence(**NOISY, **held, filter_power=0.1))


@pytest.mark.parametrize(
    ("share", "is_named"),
    [(rules.MIN_MISFIT_SHARE, True), (rules.MIN_MISFIT_SHARE - LITTLE, False)],  # moved or not, they show other things
)
def test_misregistration_is_what_images_differ_by_since_they_do_not_fit(share: float, is_named: bool) -> None:
    causes = find_causes(evidence(**FEATHERED, lost=0.2, misfit=Misfit(3.0, share)))
    assert (Cause.MISREGISTRATION in causes) is is_named
    assert Cause.FEATHERING in causes


@pytest.mark.parametrize(
    ("name", "sound", "limit"),
    [("gain", 1.0, rules.MIN_GAIN_RATIO), ("offset", 0.5, 0.5 + rules.MIN_BALANCED_OFFSET)],
)
def test_balanced_begins_where_tones_of_two_sources_lie_apart(name: str, sound: float, limit: float) -> None:
    assert find_causes(two_tones(**{name: limit + LITTLE})) == (Cause.BALANCED,)
    assert find_causes(two_tones(**{name: limit - LITTLE})) == (Cause.NONE,)
    alone = replace(SOUND, tones=(replace(SOUND_TONE, **{name: 2 * sound}),))
    assert Cause.BALANCED not in find_causes(alone)
    assert Cause.BALANCED not in find_causes(evidence(**{name: 1.2 * sound}))  # the same for both


def test_tones_are_judged_source_by_source() -> None:
    """A gain that only one source went through is balancing, which takes nothing from the whole."""
    assert find_causes(two_tones(gain=0.7)) == (Cause.BALANCED,)
    assert find_causes(evidence(gain=0.7)) == (Cause.NARROWED_HISTOGRAM,)
    assert Cause.COLOUR_SHIFT not in find_causes(two_tones(colour_shift=1.4))
    assert Cause.GAMMA in find_causes(two_tones(gamma=1.5))
    assert find_causes(two_tones(gain=None)) == (Cause.NONE,)


@pytest.mark.parametrize(
    ("spoilt", "cause"),
    [({"gamma": 1.5}, Cause.GAMMA), ({"colour_shift": 1.5}, Cause.COLOUR_SHIFT)],
)
def test_what_changes_from_place_to_place_is_dodging_and_no_tone(spoilt: dict[str, Any], cause: Cause) -> None:
    assert find_causes(evidence(**spoilt)) == (cause,)
    assert find_causes(evidence(**spoilt, unevenness=0.9)) == (Cause.DODGING,)
    assert Cause.BALANCED not in find_causes(replace(two_tones(gain=1.5), unevenness=0.9))


EVENED = {"filter_power": rules.MIN_EVENED_POWER, "most_transfer": 0.7, "least_transfer": 0.7, "sharpness": 0.7}


def test_contrast_that_was_taken_evenly_was_taken_by_dodging_and_by_nothing_else() -> None:
    assert causes_taken(evidence(**EVENED)) == ((Cause.DODGING, pytest.approx(1 - 0.7**2)),)
    by_contrast = {**EVENED, "filter_power": None, "fit": rules.MIN_EVENED_FIT}
    assert causes_taken(evidence(**by_contrast)) == ((Cause.DODGING, pytest.approx(1 - 0.7**2)),)
    causes = causes_taken(evidence(**EVENED, off_pixel=0.5, **COMPRESSED))
    assert causes[0] == (Cause.DODGING, pytest.approx(1 - 0.7**2))
    assert dict(causes[1:]) == {Cause.RESAMPLED: 0.0, Cause.COMPRESSED: 0.0}


@pytest.mark.parametrize(
    "change",
    [{"filter_power": rules.MIN_EVENED_POWER - LITTLE}, {"filter_power": None, "fit": rules.MIN_EVENED_FIT - LITTLE},
     {"filter_power": None, **COMPRESSED},
     {"most_transfer": 1.0}, {"mixed": rules.MIN_MIXED}, {"lost": 0.4, **FEATHERED}],
)
def test_contrast_that_was_not_taken_evenly_or_not_everywhere_was_not_dodged(change: dict[str, Any]) -> None:
    assert Cause.DODGING not in find_causes(evidence(**{**EVENED, **change}))


@pytest.mark.parametrize("spoilt", [{"gamma": 1.5}, {"colour_shift": 1.5}])
def test_where_most_is_mixed_tones_between_two_sources_say_nothing(spoilt: dict[str, Any]) -> None:
    most = rules.MIN_MIXED
    assert find_causes(evidence(**spoilt, **FEATHERED, mixed=most)) == (Cause.FEATHERING,)
    assert len(find_causes(evidence(**spoilt, **FEATHERED, mixed=most - LITTLE))) == 2
    assert find_causes(replace(two_tones(gain=1.5), mixed=most)) == (Cause.NONE,)


def test_what_has_less_fine_detail_than_its_sources_at_the_gain_of_its_tones_is_not_sharpened() -> None:
    """Blending of several bands takes more of what is less fine."""
    assert find_causes(evidence(most_transfer=1.1, mid_scale_gain=0.9)) == (Cause.NONE,)
    assert find_causes(evidence(most_transfer=1.3, mid_scale_gain=0.9)) == (Cause.SHARPENED,)
    assert find_causes(evidence(most_transfer=1.1, mid_scale_gain=2.0)) == (Cause.SHARPENED,)  # tones were evened out
    assert find_causes(evidence(most_transfer=1.0, mid_scale_gain=2.0)) == (Cause.NONE,)


def test_a_gamma_is_not_called_a_narrowed_histogram_too() -> None:
    assert find_causes(evidence(gamma=0.6, gain=0.7)) == (Cause.GAMMA,)


def test_what_was_resampled_is_not_called_blurred_too() -> None:
    assert find_causes(evidence(off_pixel=0.5, least_transfer=0.6)) == (Cause.RESAMPLED,)


def test_compression_is_not_called_noise_too() -> None:
    assert find_causes(evidence(**COMPRESSED)) == (Cause.COMPRESSED,)
    assert find_causes(evidence(**NOISY)) == (Cause.NOISE_ADDED,)


def test_what_is_left_over_everywhere_is_no_other_mixture() -> None:
    other = {**FEATHERED, "left_by_mixture": 0.5}
    for everywhere in (NOISY, COMPRESSED):
        assert Cause.OTHER_MIXTURE not in find_causes(evidence(**other, **everywhere))
    assert find_causes(replace(evidence(**other), texture=None)) == (Cause.FEATHERING,)


@pytest.mark.parametrize(("kept", "high"), [(0.5, 1.0), (0.5, 1.4), (0.98, 0.99)])
def test_a_loss_that_may_be_none_is_no_feathering(kept: float, high: float) -> None:
    assert find_causes(evidence(kept=kept, kept_high=high)) == (Cause.NONE,)
    assert find_causes(evidence(kept=kept, kept_high=high, feather_width_px=20.0)) == (Cause.NONE,)


EVERYTHING: dict[str, Any] = {
    "missing": 0.5, **FEATHERED, "lost": 0.4, "misfit": Misfit(1.0, 0.4), "least_transfer": 0.3,
    "strong_transfer": 0.3, "most_transfer": 1.5, "noise_dn": 6.0, "quantised": 1.0, "clipped": 0.02,
    "clipped_lost": 0.05, "gamma": 1.4, "colour_shift": 1.2,
}  # fmt: skip


def everything(**mended: Any) -> CauseEvidence:
    values = {**EVERYTHING, **mended}
    off_seam = 0.2 if values["least_transfer"] < 1 or values["quantised"] else 0.0
    return evidence(**values, sharpness=np.sqrt(1 - off_seam - values["lost"] - values["clipped_lost"]))


def test_all_that_took_part_are_ranked_by_what_each_took_in_one_unit() -> None:
    assert causes_taken(everything()) == (
        (Cause.MISSING_SOURCE, 0.5), (Cause.FEATHERING, pytest.approx(0.24)), (Cause.BLUR, pytest.approx(0.2)),
        (Cause.MISREGISTRATION, pytest.approx(0.16)), (Cause.CLIPPING, 0.05), (Cause.SHARPENED, 0.0),
        (Cause.COMPRESSED, 0.0), (Cause.GAMMA, 0.0), (Cause.COLOUR_SHIFT, 0.0),
    )  # fmt: skip


@given(sharpness=st.floats(0.1, 1.5), lost=st.floats(0, 1), clipped=st.floats(0, 1))
def test_what_was_taken_adds_up_to_what_the_sharpness_says(sharpness: float, lost: float, clipped: float) -> None:
    gone = 1 - sharpness**2
    lossy = evidence(**FEATHERED, lost=lost, least_transfer=0.5, sharpness=sharpness, clipped=0.1, clipped_lost=clipped)
    taken = sum(share for _, share in causes_taken(lossy))
    assert taken == pytest.approx(max(gone, lost + clipped))


@pytest.mark.parametrize(
    ("share", "causes"),
    [
        (0.6, (Cause.MISREGISTRATION, Cause.FEATHERING)),
        (0.4, (Cause.FEATHERING, Cause.MISREGISTRATION)),
        (0.1, (Cause.FEATHERING,)),
    ],
)
def test_a_misfit_goes_first_where_it_is_more_than_half_of_what_a_feather_took(
    share: float, causes: tuple[Cause, ...]
) -> None:
    assert find_causes(evidence(**FEATHERED, lost=0.2, misfit=Misfit(2.0, share))) == causes
    assert sum(taken for _, taken in causes_taken(evidence(**FEATHERED, lost=0.2, misfit=Misfit(2.0, share)))) == (
        pytest.approx(0.2)
    )


@pytest.mark.parametrize(
    ("width_px", "apart_px", "first"),
    [(2 * STRIP_PX, 0.9, Cause.MISREGISTRATION), (1400.0, 0.9, Cause.FEATHERING), (1400.0, 8.4, Cause.MISREGISTRATION)],
)
def test_a_misfit_goes_behind_where_a_narrower_feather_gives_back_more(
    width_px: float, apart_px: float, first: Cause
) -> None:
    """A narrower feather would break the lines of images that lie far apart."""
    misfit = Misfit(apart_px, 0.8)
    causes = causes_taken(evidence(**{**FEATHERED, "feather_width_px": width_px}, lost=0.2, misfit=misfit))
    assert causes[0][0] is first
    assert {cause for cause, _ in causes} == {Cause.MISREGISTRATION, Cause.FEATHERING}
    assert sum(share for _, share in causes) == pytest.approx(0.2)


def test_at_a_cut_a_misfit_takes_nothing() -> None:
    assert causes_taken(evidence(misfit=Misfit(3.0, 0.8))) == ((Cause.MISREGISTRATION, 0.0),)


@given(
    missing=st.floats(0, 1), kept=st.floats(0.01, 2), mixed=st.floats(0, 1), clipped=st.floats(0, 1),
    gain=st.floats(-2, 2), gamma=st.floats(0.2, 5), transfer=st.floats(0.05, 4), noise=st.floats(0, 40),
    quantised=st.floats(0, 1), shift=st.floats(0, 5), uneven=st.floats(-1, 1),
)
def test_whatever_was_measured_there_is_a_cause_or_none_alone(
    missing: float, kept: float, mixed: float, clipped: float, gain: float, gamma: float, transfer: float, noise: float,
    quantised: float, shift: float, uneven: float,
) -> None:
    causes = find_causes(evidence(
        missing=missing, kept=kept, kept_high=1.2 * kept, lost=max(1 - kept, 0), mixed=mixed, clipped=clipped,
        gain=gain, gamma=gamma, transfer=transfer, least_transfer=transfer, most_transfer=transfer, noise_dn=noise,
        quantised=quantised, misfit=Misfit(shift, missing), unevenness=uneven,
    ))
    assert len(set(causes)) == len(causes) > 0
    assert Cause.UNCLEAR not in causes
    assert (Cause.NONE in causes) is (causes == (Cause.NONE,))


def percent(share: float) -> str:
    return f"{100 * share:.3g} %"


IN_GUIDE = {
    Cause.MISSING_SOURCE: (percent(rules.MIN_MISSING_SHARE),),
    Cause.FEATHERING: (f"at most {rules.MAX_FEATHERED_KEPT} of", percent(rules.MIN_MIXED)),
    Cause.OTHER_MIXTURE: (percent(rules.MOST_LEFT),),
    Cause.BLUR: (
        f"at most {rules.MAX_BLURRED_TRANSFER} of", f"{rules.MAX_BLURRED_COMPRESSED} of the strongest",
    ),
    Cause.SOFTENED: (
        f"less than {rules.MOST_LIKE_BLUR} of", f"less than {rules.MIN_BLENDED_KEPT} of",
    ),
    Cause.RESAMPLED: (
        f"{rules.MIN_RESAMPLED_PX} px",
    ),
    Cause.SHARPENED: (f"at least {rules.MIN_SHARPENED_TRANSFER} times",),
    Cause.COMPRESSED: (percent(rules.MIN_VANISHED), percent(rules.MIN_LOSSY_VANISHED)),
    Cause.NOISE_ADDED: (f"{rules.MIN_NOISE_DN:.0f} DN",),
    Cause.CLIPPING: (percent(rules.MIN_CLIPPED_SHARE),),
    Cause.DODGING: (percent(rules.MIN_UNEVENNESS), f"r^{rules.MIN_EVENED_POWER} or less"),
    Cause.GAMMA: (f"{rules.MIN_GAMMA_CHANGE} or more",),
    Cause.NARROWED_HISTOGRAM: (f"at most {rules.MAX_NARROWED_GAIN}",),
    Cause.COLOUR_SHIFT: (percent(rules.MIN_GAIN_RATIO - 1),),
    Cause.MISREGISTRATION: (
        f"{limits.MIN_MISREGISTRATION_PX} px", percent(rules.MIN_MISFIT_SHARE),
    ),
    Cause.BALANCED: (percent(rules.MIN_GAIN_RATIO - 1), f"by {percent(rules.MIN_BALANCED_OFFSET)}"),
}  # fmt: skip


@pytest.mark.parametrize("cause", IN_GUIDE)
def test_the_limits_are_those_that_the_guide_tells(repository: Path, cause: Cause) -> None:
    """Else nothing but real mosaics would tell that one was changed."""
    guide = (repository / "docs" / "method" / "causes.md").read_text(encoding="utf-8")
    limit, *_ = re.findall(rf"^\| `{cause.value}` \| ([^|]*) \|", guide, re.MULTILINE)
    assert [word for word in IN_GUIDE[cause] if word not in limit] == []


def test_only_a_loss_puts_what_took_it_before_other_causes() -> None:
    causes = ["missing source", "dodging"]
    assert LossPlace("reduced", 1.0, 1.1, 0.8).decisive(causes) == ["dodging"]
    assert not LossPlace("not_comparable", None, None, 0.8).decisive(causes)
