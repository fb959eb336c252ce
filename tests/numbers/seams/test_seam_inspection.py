"""Windows on seams, from files to the result: what was kept, and the verdict by it."""
from __future__ import annotations

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.seams.measure import messages as seams_messages
from seam_inspector.plugin.seams.measure.judgement.causes import Cause
from seam_inspector.plugin.seams.measure.judgement.verdicts import Verdict, judge_curves

from tests.numbers.seams.inspecting import MakeRaster, block_of, inspect, mosaic_of, templates
from tests.numbers.seams.made_seams import BORDER, SIDE, WHOLE, as_bytes, blended, inspected, three_images, weight


@pytest.fixture(scope="module")
def sources() -> list[np.ndarray]:
    """Three images of one scene, (3, rows, columns) 8 bit."""
    return three_images()


@pytest.mark.parametrize(
    ("width", "verdict", "cause"),
    [(0, Verdict.PRESERVED, Cause.NONE), (40, Verdict.SIGNIFICANT, Cause.FEATHERING)],
)
def test_a_seam_is_judged_by_what_it_kept(
    make_raster: MakeRaster, sources: list[np.ndarray], width: float, verdict: Verdict, cause: Cause
) -> None:
    result = inspected(make_raster, blended(sources, width), sources[:2])
    assert result.judgement.verdict is verdict
    assert result.judgement.reason is None
    assert result.causes[0] is cause
    assert result.source_count == 2
    assert result.explained == pytest.approx(1, abs=0.01)
    assert result.notices == ()
    inner = np.abs(np.arange(SIDE) + 0.5 - BORDER) < 8
    expected = float(np.mean(weight(width)[inner] ** 2 + (1 - weight(width)[inner]) ** 2))
    assert result.profile.kept[0] == pytest.approx(expected, abs=0.06)
    assert result.profile.low < expected < result.profile.high
    assert result.band_width_m == pytest.approx(0.1 * 0.894 * width, abs=0.5)
    assert (result.visibility > 1) == (verdict is Verdict.SIGNIFICANT)


@pytest.mark.parametrize("noise", [0.0, 1.2])
def test_orthoimages_that_hold_the_mosaics_pixels_along_a_seam_say_nothing_of_it(
    make_raster: MakeRaster, sources: list[np.ndarray], noise: float
) -> None:
    """Both were changed where the mosaic lost detail, so that nothing seems to be lost."""
    image = blended(sources, 40)
    beside = np.abs(np.arange(SIDE) + 0.5 - BORDER) < 22
    changed = [
        as_bytes(np.where(beside, image + noise * np.random.default_rng(seed).normal(size=image.shape), source))
        for seed, source in enumerate(sources[:2])
    ]
    judgement = inspected(make_raster, image, changed).judgement
    assert judgement.verdict is Verdict.NOT_COMPARABLE
    assert templates([judgement.reason]) == [seams_messages.SAME_ALONG_THE_SEAM.template]


def test_the_papers_rule_and_the_seam_can_differ(make_raster: MakeRaster, sources: list[np.ndarray]) -> None:
    """A strip is thin in a window; the paper's verdict stands beside the other, to the letter."""
    image = blended(sources, 40)
    by_seam = inspected(make_raster, image, sources[:2])
    by_paper = inspected(make_raster, image, sources[:2], reference="sources")
    assert by_seam.judgement.verdict is Verdict.SIGNIFICANT
    assert by_seam.paper_verdict is by_paper.paper_verdict is by_paper.judgement.verdict is not Verdict.SIGNIFICANT
    assert by_seam.judgement.ratios == by_paper.judgement.ratios
    of_mosaic, *others = (clip.curves["luminance"] for clip in by_paper.clips)
    assert by_paper.judgement == judge_curves(of_mosaic, others)
    assert (by_seam.reference, by_paper.reference) == ("seam", "sources")


def test_the_operator_sets_the_limit(make_raster: MakeRaster, sources: list[np.ndarray]) -> None:
    image = blended(sources, 40)
    kept = inspected(make_raster, image, sources[:2]).profile.kept[0]  # type: ignore[union-attr]
    for min_kept, verdict in ((kept + 0.01, Verdict.SIGNIFICANT), (kept - 0.01, Verdict.REDUCED)):
        assert inspected(make_raster, image, sources[:2], min_kept=min_kept).judgement.verdict is verdict


@pytest.mark.parametrize("change", ["unsharp", "gain", "noise", "dodged"])
def test_what_came_over_the_whole_mosaic_moves_no_verdict(
    make_raster: MakeRaster, sources: list[np.ndarray], change: str
) -> None:
    def changed(bands: np.ndarray) -> np.ndarray:
        values = bands.astype(np.float32)
        return as_bytes({
            "unsharp": 2 * values - ndimage.gaussian_filter(values, (0, 1, 1)), "gain": 0.6 * values + 20,
            "noise": values + np.random.default_rng(101).normal(0, 4, values.shape),  # of no source
            "dodged": values * np.linspace(0.75, 1.1, SIDE),
        }[change])

    hard = inspected(make_raster, changed(blended(sources)), sources[:2])
    feathered = inspected(make_raster, changed(blended(sources, 40)), sources[:2])
    assert hard.judgement.verdict is Verdict.PRESERVED
    assert feathered.judgement.verdict is Verdict.SIGNIFICANT
    assert feathered.causes[0] is Cause.FEATHERING
    assert Cause.FEATHERING not in hard.causes
    assert hard.causes[0] in feathered.causes


@pytest.mark.parametrize("side", [64, 128])
@pytest.mark.parametrize(("width", "verdict"), [(0, Verdict.PRESERVED), (40, Verdict.SIGNIFICANT)])
def test_a_small_window_is_judged_by_the_ground_around_it(
    make_raster: MakeRaster, sources: list[np.ndarray], width: int, verdict: Verdict, side: int
) -> None:
    mosaic = mosaic_of(make_raster, blended(sources, width))
    block = block_of(mosaic, *(make_raster(f"{number}.tif", source) for number, source in enumerate(sources[:2])))
    small = inspect(block, PixelWindow(BORDER - side // 2, 96, side, side))
    assert small.judgement.verdict is verdict
    whole = inspect(block, WHOLE).profile
    assert small.profile.kept[0] == pytest.approx(whole.kept[0], abs=0.08)


def test_a_window_of_little_seam_is_not_judged(make_raster: MakeRaster, sources: list[np.ndarray]) -> None:
    mosaic = mosaic_of(make_raster, blended(sources))
    block = block_of(mosaic, *(make_raster(f"{number}.tif", source) for number, source in enumerate(sources[:2])))
    small = inspect(block, PixelWindow(BORDER - 60, 96, 64, 64))
    assert small.judgement.verdict is Verdict.NOT_COMPARABLE
    assert templates([small.judgement.reason]) == [seams_messages.TOO_LITTLE_GROUND.template]
    assert small.paper_verdict is not Verdict.NOT_COMPARABLE
    assert small.profile is None
    assert small.band_width_m is None
    beside = inspect(block, PixelWindow(0, 0, 128, 128))  # the seam lies in the ground that is read around it
    assert templates([beside.judgement.reason]) == [seams_messages.NO_SEAM.template]
    assert beside.judgement.verdict is Verdict.PRESERVED


@pytest.mark.parametrize("levels", [1, 2, 4, 5, 6])
def test_there_is_a_share_kept_for_every_level(
    make_raster: MakeRaster, sources: list[np.ndarray], levels: int
) -> None:
    image = blended(sources, 40)
    usual = inspected(make_raster, image, sources[:2]).profile
    seam = inspected(make_raster, image, sources[:2], levels=levels).profile
    assert len(seam.kept) == levels
    assert seam.kept[0] == pytest.approx(usual.kept[0], abs=0.01)
    known = [kept for kept in seam.kept if kept is not None]
    assert seam.kept[: len(known)] == tuple(known)  # coefficients larger than a cell of 16 px tell nothing of a place
    assert len(known) == min(levels, 4)
