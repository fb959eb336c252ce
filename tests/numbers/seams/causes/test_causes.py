"""What happened to a window: each cause at its limits, the order of several, and what rules another one out."""
from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import fields, replace
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from seam_inspector.plugin.seams.measure import causes as rules
from seam_inspector.plugin.seams.measure import limits
from seam_inspector.plugin.seams.measure.causes import Cause, CauseEvidence, SourceTone, Texture, find_causes

SOUND_TEXTURE = Texture(
    transfer=1.0, least_transfer=1.0, most_transfer=1.0, noise_dn=0.4, noise_rise=1.0, quantised=0.0
)
SOUND_TONE = SourceTone(share=0.5, gain=1.0, offset=0.5, gamma=1.0, colour_shift=1.0)
SOUND = CauseEvidence(
    missing=0.0, kept=1.0, kept_high=1.1, mixed=0.0, sharpness=1.0, clipped=0.0, tones=(SOUND_TONE, SOUND_TONE),
    unevenness=0.0, misregistration=0.0, apart=0.0, off_pixel=0.0, texture=SOUND_TEXTURE, lossy_file=False,
)
LITTLE = 1e-6


def evidence(**changes: Any) -> CauseEvidence:
    """Sound but for some values: of the evidence, of its texture, or of the tones of both sources."""
    own = {field.name for field in fields(CauseEvidence)}
    of_texture = {field.name for field in fields(Texture)}
    found = replace(SOUND, **{name: value for name, value in changes.items() if name in own})
    texture = {name: value for name, value in changes.items() if name in of_texture}
    tone = {name: value for name, value in changes.items() if name not in own | of_texture}
    if texture:
        found = replace(found, texture=replace(SOUND_TEXTURE, **texture))
    return replace(found, tones=tuple(replace(one, **tone) for one in SOUND.tones)) if tone else found


def two_tones(**changes: Any) -> CauseEvidence:
    """The second source's tone is changed."""
    return replace(SOUND, tones=(SOUND_TONE, replace(SOUND_TONE, **changes)))


NOISY = {"noise_dn": 4.0}
COMPRESSED = {"noise_dn": 4.0, "quantised": 2 * rules.MIN_QUANTISED}


def test_where_nothing_is_lost_or_changed_none_stands_alone() -> None:
    assert find_causes(SOUND) == (Cause.NONE,)
    assert find_causes(replace(SOUND, kept=None, kept_high=None, texture=None, tones=(), sharpness=None)) == (
        Cause.NONE,
    )
    assert find_causes(evidence(gain=None, colour_shift=None)) == (Cause.NONE,)


def test_the_documentation_lists_the_causes_in_their_order(repository: Path) -> None:
    page = (repository / "docs" / "method" / "causes.md").read_text(encoding="utf-8")
    table = page.partition("| Cause | Limit |")[2].partition("\n\n")[0]
    assert re.findall(r"^\| `([a-z ]+)` \|", table, re.MULTILINE) == [cause.value for cause in Cause]


def test_less_than_a_mixture_leaves_is_blur_along_the_seam() -> None:
    assert find_causes(evidence(kept=0.1, kept_high=rules.MIN_BLENDED_KEPT - LITTLE)) == (Cause.BLUR,)
    assert find_causes(evidence(kept=0.1, kept_high=rules.MIN_BLENDED_KEPT)) == (Cause.FEATHERING,)
    assert find_causes(evidence(kept=0.1, kept_high=0.15, mixed=rules.MIN_MIXED)) == (Cause.FEATHERING,)


# --- limits ----------------------------------------------------------------------------------------------------

AT_LIMITS: list[tuple[str, float, int, dict[str, Any], Cause]] = [
    ("missing", rules.MIN_MISSING_SHARE, 1, {}, Cause.MISSING_SOURCE),
    ("misregistration", limits.MIN_MISREGISTRATION_PX, 1, {}, Cause.MISREGISTRATION),
    ("kept", rules.MAX_FEATHERED_KEPT, -1, {"kept_high": 0.99}, Cause.FEATHERING),
    ("kept_high", 1.0, -1, {"kept": 0.9}, Cause.FEATHERING),
    ("mixed", rules.MIN_MIXED, 1, {"kept": None, "kept_high": None}, Cause.FEATHERING),
    ("least_transfer", rules.MAX_BLURRED_TRANSFER, -1, {}, Cause.BLUR),
    ("least_transfer", rules.MAX_BLURRED_COMPRESSED, -1, COMPRESSED, Cause.BLUR),
    ("sharpness", rules.MAX_BLURRED_TRANSFER, -1, {"texture": None}, Cause.BLUR),
    ("off_pixel", rules.MIN_RESAMPLED_PX, 1, {}, Cause.RESAMPLED),
    ("most_transfer", rules.MIN_SHARPENED_TRANSFER, 1, {}, Cause.SHARPENED),
    ("quantised", rules.MIN_QUANTISED, 1, NOISY, Cause.COMPRESSED),
    ("quantised", rules.MIN_LOSSY_QUANTISED, 1, {**NOISY, "lossy_file": True}, Cause.COMPRESSED),
    ("noise_dn", rules.MIN_COMPRESSED_DN, 1, {"quantised": 1.0}, Cause.COMPRESSED),
    ("noise_dn", rules.MIN_NOISE_DN, 1, {}, Cause.NOISE_ADDED),
    ("noise_dn", 2 * rules.MIN_NOISE_DN, 1, {"transfer": 2.0}, Cause.NOISE_ADDED),
    ("noise_rise", rules.MAX_NOISE_RISE, -1, NOISY, Cause.NOISE_ADDED),
    ("clipped", rules.MIN_CLIPPED_SHARE, 1, {}, Cause.CLIPPING),
    ("unevenness", rules.MIN_UNEVENNESS, 1, {}, Cause.DODGING),
    ("gamma", rules.MIN_GAMMA_CHANGE, 1, {}, Cause.GAMMA),
    ("gamma", 1 / rules.MIN_GAMMA_CHANGE, -1, {}, Cause.GAMMA),
    ("colour_shift", rules.MIN_COLOUR_SHIFT, 1, {}, Cause.COLOUR_SHIFT),
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
    """What had to be there besides is a cause of its own in one case: sources that were compressed can be blurred."""
    found = find_causes(evidence(**{**besides, name: limit + beyond * LITTLE}))
    assert set(found) == ({cause, Cause.COMPRESSED} if besides is COMPRESSED else {cause})


@pytest.mark.parametrize(
    ("name", "sound", "limit"),
    [("gain", 1.0, rules.MIN_BALANCED_GAIN), ("offset", 0.5, 0.5 + rules.MIN_BALANCED_OFFSET)],
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


# --- what rules another one out --------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("spoilt", "cause"),
    [({"gamma": 1.5}, Cause.GAMMA), ({"colour_shift": 1.5}, Cause.COLOUR_SHIFT)],
)
def test_what_changes_from_place_to_place_is_dodging_and_no_tone(spoilt: dict[str, Any], cause: Cause) -> None:
    assert find_causes(evidence(**spoilt)) == (cause,)
    assert find_causes(evidence(**spoilt, unevenness=0.9)) == (Cause.DODGING,)
    assert Cause.BALANCED not in find_causes(replace(two_tones(gain=1.5), unevenness=0.9))


@pytest.mark.parametrize("spoilt", [{"gamma": 1.5}, {"colour_shift": 1.5}])
def test_where_most_is_mixed_tones_between_two_sources_say_nothing(spoilt: dict[str, Any]) -> None:
    most = rules.MIN_MOSTLY_MIXED
    assert find_causes(evidence(**spoilt, mixed=most)) == (Cause.FEATHERING,)
    assert len(find_causes(evidence(**spoilt, mixed=most - LITTLE))) == 2
    assert find_causes(replace(two_tones(gain=1.5), mixed=most)) == (Cause.FEATHERING,)


def test_a_gamma_is_not_called_a_narrowed_histogram_too() -> None:
    assert find_causes(evidence(gamma=0.6, gain=0.7)) == (Cause.GAMMA,)


def test_what_was_resampled_is_not_called_blurred_too() -> None:
    assert find_causes(evidence(off_pixel=0.5, least_transfer=0.6)) == (Cause.RESAMPLED,)


def test_compression_is_not_called_noise_too() -> None:
    assert find_causes(evidence(**COMPRESSED)) == (Cause.COMPRESSED,)
    assert find_causes(evidence(**NOISY)) == (Cause.NOISE_ADDED,)


def test_a_files_own_compression_alone_is_no_cause() -> None:
    assert find_causes(replace(SOUND, lossy_file=True)) == (Cause.NONE,)


def test_what_lies_elsewhere_is_not_called_noise() -> None:
    assert find_causes(evidence(**NOISY, misregistration=1.0)) == (Cause.MISREGISTRATION,)


def test_noise_that_follows_strong_detail_is_no_noise() -> None:
    assert find_causes(evidence(**NOISY, noise_rise=3.0)) == (Cause.NONE,)


def test_blur_needs_unmixed_ground_or_hardly_any_mixture() -> None:
    blurred = replace(SOUND, texture=None, sharpness=0.6)
    assert find_causes(blurred) == (Cause.BLUR,)
    assert find_causes(replace(blurred, mixed=rules.MIN_MIXED)) == (Cause.FEATHERING,)


def test_without_a_seam_there_is_no_feathering_however_little_is_known() -> None:
    assert find_causes(replace(SOUND, kept=None, kept_high=None)) == (Cause.NONE,)
    assert find_causes(replace(SOUND, kept=0.2, kept_high=None)) == (Cause.NONE,)


@pytest.mark.parametrize(("kept", "high"), [(0.5, 1.0), (0.5, 1.4), (0.98, 0.99)])
def test_a_loss_that_may_be_none_is_no_feathering(kept: float, high: float) -> None:
    assert find_causes(replace(SOUND, kept=kept, kept_high=high)) == (Cause.NONE,)


# --- several at once -------------------------------------------------------------------------------------------

EVERYTHING: dict[str, Any] = {
    "missing": 0.2, "misregistration": 1.0, "apart": 1.0, "kept": 0.5, "kept_high": 0.7, "most_transfer": 1.5,
    "least_transfer": 0.4, "noise_dn": 6.0, "quantised": 1.0, "clipped": 0.02, "gamma": 1.4, "colour_shift": 1.2,
}


def test_all_that_took_part_are_named() -> None:
    found = find_causes(evidence(**EVERYTHING))
    assert set(found) == {
        Cause.MISSING_SOURCE, Cause.MISREGISTRATION, Cause.FEATHERING, Cause.BLUR, Cause.SHARPENED, Cause.COMPRESSED,
        Cause.CLIPPING, Cause.GAMMA, Cause.COLOUR_SHIFT,
    }


def test_what_is_missing_goes_first_then_what_happened_at_the_seam_then_the_whole_then_tones() -> None:
    found = find_causes(evidence(**EVERYTHING))
    assert found[:3] == (Cause.MISSING_SOURCE, Cause.MISREGISTRATION, Cause.FEATHERING)
    of_detail = {Cause.BLUR, Cause.SHARPENED, Cause.COMPRESSED}
    assert set(found[3:6]) == of_detail
    assert set(found[6:]) == {Cause.CLIPPING, Cause.GAMMA, Cause.COLOUR_SHIFT}


def test_mended_one_by_one_the_next_comes_first() -> None:
    mended: list[tuple[Cause, dict[str, Any]]] = [
        (Cause.MISSING_SOURCE, {"missing": 0.0}), (Cause.MISREGISTRATION, {"misregistration": 0.0, "apart": 0.0}),
        (Cause.FEATHERING, {"kept": 1.0, "kept_high": 1.1}), (Cause.BLUR, {"least_transfer": 1.0}),
        (Cause.SHARPENED, {"most_transfer": 1.0}), (Cause.COMPRESSED, {"quantised": 0.0, "noise_dn": 0.4}),
        (Cause.CLIPPING, {"clipped": 0.0}), (Cause.GAMMA, {"gamma": 1.0}), (Cause.COLOUR_SHIFT, {"colour_shift": 1.0}),
    ]
    left = dict(EVERYTHING)
    for cause, mend in mended:
        assert find_causes(evidence(**left))[0] is cause
        left.update(mend)
    assert find_causes(evidence(**left)) == (Cause.NONE,)


def test_a_seam_goes_before_what_came_over_the_whole_mosaic() -> None:
    for spoilt in (
        {"most_transfer": 3.0}, {"least_transfer": 0.3}, {"off_pixel": 0.5}, NOISY, COMPRESSED, {"clipped": 0.3},
        {"gain": 0.4}, {"gamma": 2.5}, {"colour_shift": 2.0}, {"unevenness": 1.0},
    ):
        found = find_causes(evidence(**spoilt, kept=0.9, kept_high=0.95))
        assert found[0] is Cause.FEATHERING
        assert len(found) == 2


def test_all_of_a_mosaic_off_its_place_lost_nothing_at_the_seam() -> None:
    """Images that do not fit are what spoils a feather; a mosaic that lies elsewhere as a whole is another matter."""
    whole = evidence(misregistration=1.0, apart=0.0, kept=0.8, kept_high=0.9)
    apart = replace(whole, apart=1.0)
    assert find_causes(whole) == (Cause.FEATHERING, Cause.MISREGISTRATION)
    assert find_causes(apart) == (Cause.MISREGISTRATION, Cause.FEATHERING)
    limit = limits.MIN_MISREGISTRATION_PX / 2
    assert find_causes(replace(whole, apart=limit))[0] is Cause.MISREGISTRATION
    assert find_causes(replace(whole, apart=limit - LITTLE))[0] is Cause.FEATHERING


@pytest.mark.parametrize(
    ("little", "much"),
    [
        ({"least_transfer": 0.9, "most_transfer": 1.4}, {"least_transfer": 0.3, "most_transfer": 1.1}),
        ({**COMPRESSED, "noise_dn": 2.0, "most_transfer": 2.5}, {**COMPRESSED, "noise_dn": 20.0, "most_transfer": 1.1}),
    ],
    ids=["blur and sharpening", "compression and sharpening"],
)
def test_the_stronger_of_two_goes_first(little: dict[str, Any], much: dict[str, Any]) -> None:
    assert find_causes(evidence(**little))[0] is Cause.SHARPENED
    assert find_causes(evidence(**much))[0] is not Cause.SHARPENED
    assert set(find_causes(evidence(**little))) == set(find_causes(evidence(**much)))


def strength_of(cause: Cause) -> Callable[..., float]:
    return lambda **changes: cause.strength(evidence(**changes))


@pytest.mark.parametrize(
    ("cause", "name", "values", "besides"),
    [
        (Cause.MISSING_SOURCE, "missing", (0.03, 0.2, 0.9), {}),
        (Cause.FEATHERING, "kept", (0.9, 0.6, 0.3), {"kept_high": 0.95}),
        (Cause.BLUR, "least_transfer", (0.9, 0.7, 0.3), {}),
        (Cause.SHARPENED, "most_transfer", (1.1, 1.5, 2.5), {}),
        (Cause.COMPRESSED, "noise_dn", (2.0, 5.0, 20.0), {"quantised": 1.0}),
        (Cause.NOISE_ADDED, "noise_dn", (2.0, 5.0, 20.0), {}),
        (Cause.CLIPPING, "clipped", (0.01, 0.05, 0.5), {}),
        (Cause.NARROWED_HISTOGRAM, "gain", (0.8, 0.6, 0.3), {}),
    ],
)
def test_the_more_it_did_the_stronger_it_is(
    cause: Cause, name: str, values: tuple[float, ...], besides: dict[str, Any]
) -> None:
    strengths = [strength_of(cause)(**besides, **{name: value}) for value in values]
    assert strengths == sorted(strengths)
    assert strengths[0] > 0
    assert strengths[-1] > strengths[0]


@given(
    missing=st.floats(0, 1), kept=st.floats(0.01, 2), mixed=st.floats(0, 1), clipped=st.floats(0, 1),
    gain=st.floats(-2, 2), gamma=st.floats(0.2, 5), transfer=st.floats(0.05, 4), noise=st.floats(0, 40),
    quantised=st.floats(0, 1), shift=st.floats(0, 5), uneven=st.floats(-1, 1),
)
def test_whatever_was_measured_there_is_a_cause_or_none_alone(
    missing: float, kept: float, mixed: float, clipped: float, gain: float, gamma: float, transfer: float, noise: float,
    quantised: float, shift: float, uneven: float,
) -> None:
    found = find_causes(evidence(
        missing=missing, kept=kept, kept_high=1.2 * kept, mixed=mixed, clipped=clipped, gain=gain, gamma=gamma,
        transfer=transfer, least_transfer=transfer, most_transfer=transfer, noise_dn=noise, quantised=quantised,
        misregistration=shift, apart=shift, unevenness=uneven,
    ))
    assert len(set(found)) == len(found) > 0
    assert Cause.UNCLEAR not in found
    assert (Cause.NONE in found) is (found == (Cause.NONE,))
