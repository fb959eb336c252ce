"""Why contrast was lost: each rule at its limit, and real clips that were spoilt in known ways (Brighton)."""
from __future__ import annotations

import re
from collections import Counter
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.imagery.band_curves import luminance
from seam_inspector.plugin.imagery.band_names import LUMINANCE
from seam_inspector.plugin.imagery.clips import Clip
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import describe_mosaic
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef
from seam_inspector.plugin.seams.measure import limits as seams_limits
from seam_inspector.plugin.seams.measure.causes import (
    MAX_BLURRED_SHARPNESS,
    MAX_NARROWED_GAIN,
    MAX_STRONGLY_BLURRED_SHARPNESS,
    MIN_CAUSE_FIT,
    MIN_CLIPPED_SHARE,
    MIN_COLOUR_SHIFT,
    MIN_GAMMA_CHANGE,
    MIN_MIXED_SHARE,
    Cause,
    CauseEvidence,
    find_cause,
)
from seam_inspector.plugin.seams.measure.explanation import Explanation
from seam_inspector.plugin.seams.measure.followed_source import follow, high_pass
from seam_inspector.plugin.seams.measure.inspection import (
    InspectionSettings,
    inspect_window,
    make_block,
    window_request,
)

from benchmarks.scenes import (
    Scene,
    Truth,
    blur,
    brighton_scenes,
    explained,
    feather,
    gain,
    half_and_half,
    truths,
    whole_values,
)
from tests.numbers.synthetic import orthoimage

SOUND = CauseEvidence(1.0, 1.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.99)
LITTLE = 1e-6


def test_nothing_wrong_is_no_cause() -> None:
    assert find_cause(SOUND) is Cause.NONE
    assert find_cause(replace(SOUND, colour_shift=None, sharpness=None)) is Cause.NONE


def test_the_documentation_lists_the_causes_in_their_order(repository: Path) -> None:
    page = (repository / "docs" / "causes.md").read_text(encoding="utf-8")
    table = page.partition("| Cause | Limit |")[2].partition("\n\n")[0]
    assert re.findall(r"^\| `([a-z ]+)` \|", table, re.MULTILINE) == [cause.value for cause in Cause]


@pytest.mark.parametrize(
    ("name", "limit", "beyond", "cause"),
    [
        ("fit", MIN_CAUSE_FIT, -1, Cause.UNCLEAR),
        ("clipped", MIN_CLIPPED_SHARE, 1, Cause.CLIPPING),
        ("gamma", MIN_GAMMA_CHANGE, 1, Cause.GAMMA),
        ("gamma", 1 / MIN_GAMMA_CHANGE, -1, Cause.GAMMA),
        ("colour_shift", MIN_COLOUR_SHIFT, 1, Cause.COLOUR_SHIFT),
        ("gain", MAX_NARROWED_GAIN, -1, Cause.NARROWED_HISTOGRAM),
        ("misregistration", seams_limits.MIN_MISREGISTRATION_PX, 1, Cause.MISREGISTRATION),
        ("sharpness", MAX_BLURRED_SHARPNESS, -1, Cause.BLUR),
        ("mixed_share", MIN_MIXED_SHARE, 1, Cause.FEATHERING),
    ],
)
def test_each_cause_begins_at_its_limit(name: str, limit: float, beyond: int, cause: Cause) -> None:
    changes: dict[str, Any] = {name: limit + beyond * LITTLE}
    assert find_cause(replace(SOUND, **changes)) is cause
    changes = {name: limit - beyond * LITTLE}
    assert find_cause(replace(SOUND, **changes)) is Cause.NONE


def test_without_a_gain_the_cause_is_unclear() -> None:
    assert find_cause(replace(SOUND, gain=None)) is Cause.UNCLEAR


def test_a_strong_blur_goes_before_all_else() -> None:
    limit = MAX_STRONGLY_BLURRED_SHARPNESS
    assert find_cause(replace(SOUND, sharpness=limit - LITTLE, colour_shift=1.5)) is Cause.BLUR
    assert find_cause(replace(SOUND, sharpness=limit + LITTLE, colour_shift=1.5)) is Cause.COLOUR_SHIFT


def test_the_grossest_interference_is_named_first() -> None:
    everything = CauseEvidence(0.5, 0.5, 0.1, 1.5, 3.0, 0.4, 0.5, 0.9)
    mended: list[tuple[Cause, dict[str, Any]]] = [
        (Cause.BLUR, {"sharpness": 0.9}),
        (Cause.CLIPPING, {"clipped": 0.0}), (Cause.GAMMA, {"gamma": 1.0}), (Cause.COLOUR_SHIFT, {"colour_shift": 1.0}),
        (Cause.NARROWED_HISTOGRAM, {"gain": 1.0}), (Cause.MISREGISTRATION, {"misregistration": 0.0}),
        (Cause.BLUR, {"sharpness": 1.0}), (Cause.FEATHERING, {"mixed_share": 0.0}),
    ]
    for cause, mend in mended:
        assert find_cause(everything) is cause
        everything = replace(everything, **mend)
    assert find_cause(everything) is Cause.NONE


def test_a_blur_is_not_taken_for_the_shift_between_sources(mosaic: Raster) -> None:
    rng = np.random.default_rng(8)
    scene = ndimage.gaussian_filter(orthoimage((264, 264)).astype(np.float32), (0, 0.6, 0.6))  # as a lens draws it
    images = [scene, ndimage.shift(scene, (0, 0.6, -1.5), order=3)]
    noisy = [image[:, 4:-4, 4:-4] + rng.normal(0, 1.5, (3, 256, 256)) for image in images]
    clips = tuple(Clip(mosaic, whole_values(image), 0.0) for image in noisy)
    labels = np.where(np.arange(256) < 180, 0, 1) + np.zeros((256, 1), np.uint8)
    window = PixelWindow(0, 0, 256, 256)
    place = Scene(window, labels.astype(np.uint8), clips, mosaic)
    found = explained(place, blur(place, 0.8))[0]
    assert found.cause is Cause.BLUR
    for change in (found.changes[0], found.changes[1]):
        shift = change[LUMINANCE].shift
        assert shift is not None
        assert shift.length < 0.1


# --- Real clips, spoilt in known ways ---------------------------------------------------------------------------

SIDE, EACH = 384, 3
OPERATIONS = truths(0.03)


@pytest.fixture(scope="module")
def brighton(data_folder: Path) -> Path:
    """The folder of the eight orthoimages and the two mosaics of them."""
    return data_folder / "seams" / "brighton"


@pytest.fixture(scope="module")
def scenes(brighton: Path) -> list[Scene]:
    """Windows on seams, spread over the mosaic."""
    found = brighton_scenes(brighton, SIDE, EACH * len(OPERATIONS))
    assert len(found) == EACH * len(OPERATIONS)
    return found


Found = list[tuple[Truth, Scene, Explanation]]


@pytest.fixture(scope="module")
def spoilt(scenes: list[Scene]) -> Found:
    """Every operation in some windows of its own, and what is said of them."""
    found = []
    for number, scene in enumerate(scenes):
        truth = OPERATIONS[number % len(OPERATIONS)]
        found.append((truth, scene, explained(scene, truth.make(scene))[0]))
    return found


def test_the_cause_is_found(spoilt: Found) -> None:
    wrong = Counter((truth.name, found.cause.value) for truth, _, found in spoilt if found.cause is not truth.cause)
    assert sum(wrong.values()) <= 0.05 * len(spoilt), wrong


def test_gain_and_bias_are_measured(spoilt: Found) -> None:
    gains, biases = [], []
    for truth, scene, found in spoilt:
        wanted = truth.linear(scene) if truth.linear else (truth.gain, truth.bias)
        tone = found.changes[-1][LUMINANCE].tone
        if wanted[0] is not None and wanted[1] is not None:
            assert tone is not None
            gains.append(abs(tone.gain / wanted[0] - 1))
            biases.append(abs(tone.bias - wanted[1]))
    assert len(gains) >= 8 * EACH
    assert np.quantile(gains, 0.95) < 0.02
    assert max(gains) < 0.04  # a blur of 1.2 px in a window of few large shapes
    assert np.quantile(biases, 0.95) < 2.5


def test_gains_of_the_colours_are_measured(spoilt: Found) -> None:
    for truth, _, found in spoilt:
        tones = [found.changes[-1][band].tone for band in ("red", "green", "blue")]
        if truth.colours:
            assert [tone.gain for tone in tones if tone] == pytest.approx(truth.colours, rel=0.02)


def test_gamma_is_measured(spoilt: Found) -> None:
    for truth, _, found in spoilt:
        tone = found.changes[-1][LUMINANCE].tone
        assert tone is not None
        if truth.colours is None:
            assert tone.gamma == pytest.approx(truth.gamma, abs=0.05), truth.name


def test_shifts_are_measured(spoilt: Found) -> None:
    errors = []
    for truth, scene, found in spoilt:
        if truth.shift:
            shift = found.changes[scene.main[1]][LUMINANCE].shift
            errors.append(np.hypot(shift.x - truth.shift[0], shift.y - truth.shift[1]) if shift else np.inf)
    assert len(errors) == 3 * EACH
    assert max(errors) < 0.1


@pytest.mark.parametrize("name", ["hard cut", "feather 0.4 m", "gain 0.6", "gamma 0.6", "gamma 1.6"])
def test_the_right_source_is_followed(scenes: list[Scene], name: str) -> None:
    (truth,) = (one for one in OPERATIONS if one.name == name)
    right = []
    for scene in scenes[:10]:
        fine = [high_pass(luminance(bands)) for bands in (truth.make(scene), *(clip.bands for clip in scene.sources))]
        count = len(scene.sources)
        found = follow(lambda start, stop, fine=fine: [plane[start:stop] for plane in fine], (SIDE, SIDE), count)
        right.append(float((found.labels == scene.labels).mean()))
    assert np.mean(right) >= 0.99


# --- The fair reference -----------------------------------------------------------------------------------------


def test_a_hard_cut_has_lost_nothing_against_the_composite(spoilt: Found) -> None:
    for truth, _, found in spoilt:
        if truth.cause is Cause.NONE:
            assert found.ratios[LUMINANCE].detail == pytest.approx((1, 1, 1), abs=0.005)
            assert found.changes[-1][LUMINANCE].contrast == pytest.approx((1, 1, 1), abs=0.005)
            assert found.mixed_share < MIN_MIXED_SHARE


def test_a_gain_leaves_the_ratio_and_lowers_contrast(scenes: list[Scene]) -> None:
    found = explained(scenes[0], gain(scenes[0], 0.6, 20))[0]
    change = found.changes[-1][LUMINANCE]
    assert found.ratios[LUMINANCE].detail[1:] == pytest.approx((1, 1), abs=0.02)
    assert change.contrast == pytest.approx((0.6,) * 3, rel=0.03)  # rounding adds to the finest
    assert change.sharpness == pytest.approx((1,) * 3, rel=0.03)


def test_wider_feathers_leave_less_and_more_is_mixed(scenes: list[Scene]) -> None:
    kept, mixed = [], []
    for scene in scenes[:3]:
        mosaics = [scene.cut(), *(feather(scene.labels, [c.bands for c in scene.sources], s) for s in (7, 13, 33))]
        found = [explained(scene, mosaic)[0] for mosaic in mosaics]
        kept.append([one.ratios[LUMINANCE].detail[0] or 0 for one in found])
        mixed.append([one.mixed_share for one in found])
    assert (np.diff(np.mean(kept, axis=0)) < 0).all()
    assert (np.diff(mixed) > 0).all()


def test_half_and_half_leaves_what_was_predicted(scenes: list[Scene]) -> None:
    for scene in [scene for scene in scenes if len(scene.sources) == 2][:3]:
        found = explained(scene, half_and_half(scene))[0]
        assert found.mixed_share > 0.9
        assert found.cause is Cause.FEATHERING
        wanted = [one or 0 for one in found.expected]
        halves = explained_energy(scene)
        assert halves == pytest.approx(wanted, rel=0.03)


def explained_energy(scene: Scene) -> list[float]:
    """Detail variance of the mean of two sources over the mean of theirs, by the curves alone."""
    _, curve, sources = explained(scene, half_and_half(scene))
    energies = [
        np.array(one[LUMINANCE].detail) * one[LUMINANCE].variance for one in (curve, *sources)
    ]
    return list(energies[0] / ((energies[1] + energies[2]) / 2))


def test_brightons_own_mosaics_against_the_composite(brighton: Path, scenes: list[Scene]) -> None:
    sources = [RasterRef(str(path)) for path in sorted(brighton.glob("DJI_*.tif"))]
    plain, fair = {}, {}
    for name in ("mosaic_hardseam.tif", "mosaic_feather0p4m.tif"):
        block, _ = make_block(describe_mosaic(RasterRef(str(brighton / name))), sources)
        results = []
        for number, scene in enumerate(scenes[:12]):
            extent = block.mosaic.grid.window_extent(scene.window)
            results.append(inspect_window(window_request(block, number, extent, InspectionSettings())))
        plain[name] = np.array([result.judgement.ratios.detail[0] for result in results], float)
        explanations = [result.explanation for result in results]
        fair[name] = np.array([one.ratios[LUMINANCE].detail[0] for one in explanations if one], float)
    hard, feathered = fair
    assert np.abs(fair[hard] - 1).max() < 0.01
    assert np.abs(fair[hard] - 1).max() < np.abs(plain[hard] - 1).mean()
    assert fair[feathered].max() < 1
    assert (fair[feathered] < fair[hard]).all()
    assert np.median(fair[feathered]) < fair[hard].min()
    assert plain[feathered].max() > np.median(plain[hard])  # the paper's ratio can't part them
