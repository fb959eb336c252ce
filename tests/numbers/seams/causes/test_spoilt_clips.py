"""What is said of Brighton's clips spoilt in known ways, one step of production at a time."""
from __future__ import annotations

from collections import Counter
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.imagery.limits import LUMINANCE
from seam_inspector.plugin.imagery.wavelets import luminance
from seam_inspector.plugin.seams.measure.following.followed_source import follow_planes, high_pass
from seam_inspector.plugin.seams.measure.judgement.causes import Cause, causes_taken
from seam_inspector.plugin.seams.measure.judgement.explanation import Explanation
from seam_inspector.plugin.seams.measure.judgement.verdicts import Verdict
from seam_inspector.plugin.seams.measure.window.explained_window import judge_by_seam

from benchmarks import aftermaths
from benchmarks.detail import details
from benchmarks.scenes import Scene, Truth, brighton_scenes, cut, explained, feather, gain, truths, whole_values
from benchmarks.seam_makings import seam_distance

pytestmark = pytest.mark.release

MOST_MIXED = 0.005  # of the pixels of a hard cut
SIDE, EACH = 384, 2
OPERATIONS = truths(0.03)


@pytest.fixture(scope="module")
def scenes(brighton: Path) -> list[Scene]:
    """Windows on seams, spread over the mosaic."""
    chosen = brighton_scenes(brighton, SIDE, EACH * len(OPERATIONS))
    assert len(chosen) == EACH * len(OPERATIONS)
    return chosen


Found = list[tuple[Truth, Scene, Explanation]]


@pytest.fixture(scope="module")
def spoilt(scenes: list[Scene]) -> Found:
    """Every operation in some windows of its own, and what is said of them."""
    explained_scenes = []
    for number, scene in enumerate(scenes):
        truth = OPERATIONS[number % len(OPERATIONS)]
        explained_scenes.append((truth, scene, explained(scene, truth.make(scene))[0]))
    return explained_scenes


def smaller_share(scene: Scene) -> float:
    """Share of the window that the second of its two main images has."""
    return float(min((scene.labels == number).mean() for number in scene.main))


def besides_misfit(explanation: Explanation) -> tuple[Cause, ...]:
    """Brighton's own orthoimages lie apart in relief, by up to 3 px."""
    return tuple(cause for cause in explanation.causes if cause is not Cause.MISREGISTRATION) or (Cause.NONE,)


def test_the_cause_is_found(spoilt: Found) -> None:
    judged = [(truth, besides_misfit(explanation)[0]) for truth, _, explanation in spoilt if not truth.shift]
    wrong = Counter((truth.name, cause.value) for truth, cause in judged if cause is not truth.cause)
    assert sum(wrong.values()) <= 0.05 * len(judged), wrong


def test_what_took_nothing_comes_last(spoilt: Found) -> None:
    for truth, _, explanation in spoilt:
        taken = dict(causes_taken(explanation.evidence))
        shares = [taken[cause] for cause in explanation.causes if cause in taken]
        assert shares == sorted(shares, reverse=True), truth.name
        if truth.cause in (Cause.NONE, Cause.NARROWED_HISTOGRAM, Cause.COLOUR_SHIFT):
            assert max(shares, default=0) < 0.02, (truth.name, taken)


def test_feathers_are_as_wide_as_they_were_made(spoilt: Found) -> None:
    """A Gaussian goes from 5 to 95 % over 3.29 sigma."""
    for truth, scene, explanation in spoilt:
        if truth.cause is Cause.FEATHERING and smaller_share(scene) > 0.2:
            assert explanation.profile.feather_width_px == pytest.approx(3.29 * sigma_of(truth), rel=0.25), truth.name


def test_gain_and_bias_are_measured(spoilt: Found) -> None:
    gains, biases = [], []
    for truth, scene, explanation in spoilt:
        wanted = truth.linear(scene) if truth.linear else (truth.gain, truth.bias)
        tone = explanation.changes[-1][LUMINANCE].tone
        if wanted[0] is not None and wanted[1] is not None:
            gains.append(abs(tone.gain / wanted[0] - 1))
            biases.append(abs(tone.bias - wanted[1]))
    assert len(gains) >= 8 * EACH
    assert np.quantile(gains, 0.95) < 0.02
    assert max(gains) < 0.04  # a blur of 1.2 px in a window of few large shapes
    assert np.quantile(biases, 0.95) < 2.5


def test_gamma_is_measured(spoilt: Found) -> None:
    for truth, _, explanation in spoilt:
        tone = explanation.changes[-1][LUMINANCE].tone
        if truth.colours is None:
            assert tone.gamma == pytest.approx(truth.gamma, abs=0.05), truth.name


def test_shifts_are_measured(spoilt: Found) -> None:
    errors = []
    for truth, scene, explanation in spoilt:
        if truth.shift:
            shift = explanation.changes[scene.main[1]][LUMINANCE].shift
            errors.append(np.hypot(shift.x - truth.shift[0], shift.y - truth.shift[1]) if shift else np.inf)
    assert len(errors) == 3 * EACH
    assert max(errors) < 0.1


CHANGES_THE_WHOLE = (Cause.NONE, Cause.NARROWED_HISTOGRAM, Cause.GAMMA, Cause.CLIPPING, Cause.COLOUR_SHIFT, Cause.BLUR)


def true_kept(scene: Scene, sigma_px: float) -> float:
    """What a feather of that sigma leaves of the sources' finest detail within 8 px of the seam, by PyWavelets."""
    fine = [details(luminance(clip.bands), 1, "coif3") for clip in scene.sources]
    followed = [(scene.labels == number).astype(np.float32) for number in range(len(fine))]
    weights = [ndimage.gaussian_filter(mask, sigma_px) for mask in followed]
    near = seam_distance(scene.labels) <= 8
    made, plain = (
        float(np.square(sum(share * plane for share, plane in zip(shares, fine)))[:, near].sum())
        for shares in (weights, followed)
    )
    return made / plain


def sigma_of(truth: Truth) -> float:
    """Sigma of a feather, px."""
    return float(truth.name.split()[1]) / 0.03


def test_what_feathers_kept_is_told(spoilt: Found) -> None:
    errors, held = [], []
    for truth, scene, explanation in spoilt:
        if truth.cause is Cause.FEATHERING:
            kept = true_kept(scene, sigma_of(truth))
            errors.append(explanation.profile.kept[0] - kept)
            held.append(explanation.profile.low <= kept <= explanation.profile.high)
    assert np.median(np.abs(errors)) < 0.05
    assert np.max(np.abs(errors)) < 0.15
    assert sum(held) >= len(held) - 2


def test_what_came_over_the_whole_mosaic_is_no_loss_of_the_seam(spoilt: Found) -> None:
    judged = [
        (truth.name, judge_by_seam(replace(explanation, sharpness=1.0))[0])
        for truth, _, explanation in spoilt if truth.cause in CHANGES_THE_WHOLE
    ]
    assert len(judged) >= 9 * EACH
    verdicts = Counter(verdict for _, verdict in judged)
    assert verdicts[Verdict.SIGNIFICANT] == 0, judged
    assert verdicts[Verdict.REDUCED] <= 1, judged
    assert verdicts[Verdict.PRESERVED] >= 0.9 * len(judged), judged


def test_feathers_are_flagged(spoilt: Found) -> None:
    for truth, _, explanation in spoilt:
        if truth.cause is Cause.FEATHERING:
            verdict, _ = judge_by_seam(explanation)
            assert verdict in (Verdict.REDUCED, Verdict.SIGNIFICANT), truth.name


RNG = np.random.default_rng(1)
AFTERWARDS = {
    "unsharp": (aftermaths.unsharp(1.0), Cause.SHARPENED),
    "JPEG 75": (aftermaths.jpeg(75), Cause.COMPRESSED),
    "noise 5 DN": (aftermaths.noise(5.0), Cause.NOISE_ADDED),
    "dodged": (aftermaths.dodged(0.7, 1.1), Cause.DODGING),
    "blur": (aftermaths.blurred(0.5), Cause.BLUR),
    "a third of a pixel off": (aftermaths.resampled(0.2, 0.25, 3), Cause.RESAMPLED),
}


@pytest.mark.parametrize("name", AFTERWARDS)
def test_what_came_afterwards_is_named_beside_the_feather_and_hides_it_not(scenes: list[Scene], name: str) -> None:
    change, cause = AFTERWARDS[name]
    for scene in [scene for scene in scenes if smaller_share(scene) > 0.3 and len(np.unique(scene.labels)) == 2][:2]:
        hard, feathered = scene.cut(), feather(scene.labels, [clip.bands for clip in scene.sources], 13)
        after_feather, after_cut = (explained(scene, change(bands, RNG))[0] for bands in (feathered, hard))
        assert {Cause.FEATHERING, cause} <= set(after_feather.causes)
        assert besides_misfit(after_cut)[0] is cause
        if not dict(causes_taken(after_cut.evidence))[cause]:  # it took nothing
            assert Cause.FEATHERING in after_feather.causes[:2]
        assert Cause.FEATHERING not in after_cut.causes
        assert after_feather.profile.kept[0] == pytest.approx(true_kept(scene, 13), abs=0.1)
        assert after_feather.profile.high < 1
        assert after_cut.profile.high >= 1


def test_sources_that_were_balanced_are_no_loss(scenes: list[Scene]) -> None:
    for scene in scenes[:2]:
        toned = [clip.bands.astype(np.float32) for clip in scene.sources]
        toned[scene.main[0]] = 0.85 * toned[scene.main[0]]
        toned[scene.main[1]] = 1.1 * toned[scene.main[1]]
        explanation = explained(scene, whole_values(cut(scene.labels, toned)))[0]
        assert besides_misfit(explanation)[0] is Cause.BALANCED
        assert judge_by_seam(explanation)[0] is Verdict.PRESERVED
        gains = sorted(tone.gain for tone in explanation.evidence.tones if tone.gain)
        assert gains[0] == pytest.approx(0.85, rel=0.02)
        assert gains[-1] == pytest.approx(1.1, rel=0.02)


def test_a_source_that_is_not_given_is_missed(scenes: list[Scene]) -> None:
    errors, main = [], []
    for scene in scenes[:8]:
        missing = scene.main[1]
        given = replace(scene, sources=tuple(clip for i, clip in enumerate(scene.sources) if i != missing))
        explanation = explained(given, scene.cut())[0]
        share = float((scene.labels == missing).mean())
        assert share > 0.1
        errors.append(abs(1 - explanation.explained - share))
        main.append(explanation.cause is Cause.MISSING_SOURCE)
    assert sum(main) >= len(main) - 1
    assert np.median(errors) < 0.05
    assert sorted(errors)[-2] < 0.15


@pytest.mark.parametrize("name", ["hard cut", "feather 0.4 m", "gain 0.6", "gamma 0.6", "gamma 1.6"])
def test_the_right_source_is_followed(scenes: list[Scene], name: str) -> None:
    (truth,) = (operation for operation in OPERATIONS if operation.name == name)
    right = []
    for scene in scenes[:6]:
        fine = [high_pass(luminance(bands)) for bands in (truth.make(scene), *(clip.bands for clip in scene.sources))]
        right.append(float((follow_planes(fine).labels == scene.labels).mean()))
    assert np.mean(right) >= 0.99


def test_a_hard_cut_has_lost_nothing_against_the_composite(spoilt: Found) -> None:
    for truth, _, explanation in spoilt:
        if truth.cause is Cause.NONE:
            assert explanation.ratios[LUMINANCE].detail == pytest.approx((1, 1, 1), abs=0.005)
            assert explanation.changes[-1][LUMINANCE].contrast == pytest.approx((1, 1, 1), abs=0.005)
            assert explanation.mixed_share < MOST_MIXED


def test_a_gain_leaves_the_ratio_and_lowers_contrast(scenes: list[Scene]) -> None:
    explanation = explained(scenes[0], gain(scenes[0], 0.6, 20))[0]
    change = explanation.changes[-1][LUMINANCE]
    assert explanation.ratios[LUMINANCE].detail[1:] == pytest.approx((1, 1), abs=0.02)
    assert change.contrast == pytest.approx((0.6,) * 3, rel=0.03)  # rounding adds to the finest
    assert change.sharpness == pytest.approx((1,) * 3, rel=0.03)
