"""Sources that cover a part of a window, that are not given, or that have other pixels and depths than the mosaic."""
from __future__ import annotations

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.seams.measure import messages as seams_messages
from seam_inspector.plugin.seams.measure.judgement.causes import Cause
from seam_inspector.plugin.seams.measure.judgement.verdicts import Verdict

from tests.numbers.seams.inspecting import MakeRaster, block_of, inspect, mosaic_of, templates
from tests.numbers.seams.made_seams import (
    BORDER,
    SHAPE,
    SIDE,
    WHOLE,
    as_bytes,
    blended,
    inspected,
    three_images,
    weight,
)
from tests.numbers.synthetic import orthoimage


@pytest.fixture(scope="module")
def sources() -> list[np.ndarray]:
    """Three images of one scene, (3, rows, columns) 8 bit."""
    return three_images()


def without(image: np.ndarray, where: np.ndarray) -> np.ndarray:
    return np.where(where, 0, image).astype(image.dtype)


@pytest.mark.parametrize("width", [0, 40])
def test_a_source_with_gaps_takes_part_pixel_by_pixel(
    make_raster: MakeRaster, sources: list[np.ndarray], width: float
) -> None:
    """The second source lacks the 30 % that lie farthest from the seam, on the first one's side."""
    lacking = np.broadcast_to(np.arange(SIDE) < 0.3 * SIDE, SHAPE)
    image = blended(sources, width)
    result = inspected(make_raster, image, [sources[0], without(sources[1], lacking)])
    assert result.source_count == 2
    assert templates(result.notices) == [seams_messages.SOURCE_IN_PART.template]
    assert str(result.notices[0]) == "b.tif covers 70 % of the window and is used there."
    whole = inspected(make_raster, image, sources[:2])
    assert result.judgement.verdict is whole.judgement.verdict
    assert result.profile.kept[0] == pytest.approx(whole.profile.kept[0], abs=0.03)
    assert result.explained == pytest.approx(1, abs=0.01)
    assert result.causes[0] is whole.causes[0]
    # The paper's rule is by whole clips: only the first source has one.
    assert [clip.raster for clip in result.clips] == ["mosaic.tif", "a.tif"]
    assert result.judgement.ratios.detail == pytest.approx(
        next(pair.ratios.detail for pair in result.pairs if pair.source == "a.tif")
    )
    in_part = [pair for pair in result.pairs if pair.source == "b.tif"]
    assert in_part
    assert all(set(pair.ratios.detail) == {None} and pair.similarity is None for pair in in_part)
    assert in_part[0].change.tone.gain == pytest.approx(1, abs=0.03)


def test_where_all_sources_cover_parts_the_seam_is_judged_all_the_same(
    make_raster: MakeRaster, sources: list[np.ndarray]
) -> None:
    column = np.broadcast_to(np.arange(SIDE), SHAPE)
    given = [without(sources[0], column >= BORDER + 30), without(sources[1], column < BORDER - 30)]
    result = inspected(make_raster, blended(sources, 40), given)
    assert result.judgement.verdict is Verdict.SIGNIFICANT
    assert result.paper_verdict is Verdict.NOT_COMPARABLE
    assert result.source_count == 2
    assert len(result.notices) == 2
    assert result.explained == pytest.approx(1, abs=0.01)
    by_paper = inspected(make_raster, blended(sources, 40), given, reference="sources").judgement
    assert by_paper.verdict is Verdict.NOT_COMPARABLE
    assert by_paper.reason is not None


def test_pixels_that_only_a_gap_could_explain_are_said_to_be_missing(
    make_raster: MakeRaster, sources: list[np.ndarray]
) -> None:
    row = np.broadcast_to(np.arange(SIDE)[:, np.newaxis], SHAPE)
    column = np.broadcast_to(np.arange(SIDE), SHAPE)
    lacking = (column >= BORDER) & (row >= 160)
    result = inspected(make_raster, blended(sources), [sources[0], without(sources[1], lacking)])
    assert result.causes[0] is Cause.MISSING_SOURCE
    assert result.explained == pytest.approx(1 - lacking.mean(), abs=0.05)
    assert templates(result.notices) == [seams_messages.SOURCE_IN_PART.template]
    assert result.judgement.verdict is not Verdict.SIGNIFICANT


@pytest.mark.parametrize("border", [100, 150, 220])
@pytest.mark.parametrize("given", [0, 1])
def test_a_source_that_is_not_given_is_missed(
    make_raster: MakeRaster, sources: list[np.ndarray], given: int, border: int
) -> None:
    image = as_bytes(np.where(np.arange(SIDE) < border, sources[0], sources[1]))
    result = inspected(make_raster, image, [sources[given]])
    share = border / SIDE if given == 0 else 1 - border / SIDE
    assert result.causes[0] is Cause.MISSING_SOURCE
    assert result.explained == pytest.approx(share, abs=0.05)


def test_one_of_three_that_is_not_given_leaves_the_seam_of_the_others(
    make_raster: MakeRaster, sources: list[np.ndarray]
) -> None:
    image = blended(sources, 40)
    row = np.broadcast_to(np.arange(SIDE)[:, np.newaxis], SHAPE)
    image = np.where(row >= 250, sources[2], image)
    result = inspected(make_raster, image, sources[:2])
    assert result.causes[:2] == (Cause.FEATHERING, Cause.MISSING_SOURCE)  # the verdict is that of the rest
    assert result.explained == pytest.approx(250 / SIDE, abs=0.04)
    assert result.judgement.verdict is Verdict.SIGNIFICANT
    assert result.profile.kept[0] == pytest.approx(0.54, abs=0.07)


def coarser(image: np.ndarray) -> np.ndarray:
    """Pixels twice as large."""
    bands, rows, columns = image.shape
    return as_bytes(image.reshape(bands, rows // 2, 2, columns // 2, 2).mean(axis=(2, 4)))


def test_a_source_of_another_pixel_size_is_shown_and_does_not_count(
    make_raster: MakeRaster, sources: list[np.ndarray]
) -> None:
    mosaic = mosaic_of(make_raster, blended(sources, 40))
    paths = [make_raster(f"{name}.tif", source) for name, source in zip("ab", sources)]
    coarse = make_raster("coarse.tif", coarser(sources[2]), gsd=0.2)
    plain, result = (inspect(block_of(mosaic, *given), WHOLE) for given in (paths, [*paths, coarse]))
    assert templates(result.notices) == [seams_messages.SOURCE_RESAMPLED.template]
    assert "coarse.tif" in str(result.notices[0])
    assert result.judgement == plain.judgement
    assert result.paper_verdict is plain.paper_verdict
    assert result.causes == plain.causes
    assert [clip.raster for clip in result.clips] == ["mosaic.tif", "a.tif", "b.tif", "coarse.tif"]  # it is seen
    assert {pair.source: pair.resampled for pair in result.pairs} == {
        "a.tif": False, "b.tif": False, "coarse.tif": True
    }


def test_where_all_are_resampled_the_verdict_says_so(make_raster: MakeRaster, sources: list[np.ndarray]) -> None:
    fine = [np.kron(source, np.ones((1, 2, 2), np.uint8)) for source in sources[:2]]
    mosaic = mosaic_of(make_raster, blended(sources, 40))
    block = block_of(mosaic, *(make_raster(f"{name}.tif", pixels, gsd=0.05) for name, pixels in zip("ab", fine)))
    for reference in ("seam", "sources", "composite"):
        result = inspect(block, WHOLE, reference=reference)
        assert result.judgement.verdict is not Verdict.NOT_COMPARABLE
        assert templates([result.judgement.reason]) == [seams_messages.ALL_RESAMPLED.template]
    assert all(pair.resampled for pair in result.pairs)


@pytest.mark.parametrize("bits", [12, 16])
def test_a_mosaic_of_8_bit_of_deeper_sources_has_no_narrowed_histogram(
    make_raster: MakeRaster, sources: list[np.ndarray], bits: int
) -> None:
    factor = 2 ** (bits - 8)
    deep = [source.astype(np.uint16) * factor + np.uint16(factor // 2) for source in sources[:2]]
    mosaic = mosaic_of(make_raster, blended(sources))
    options = ["TILED=YES", *([f"NBITS={bits}"] if bits < 16 else [])]
    paths = [make_raster(f"{name}.tif", pixels, options=options) for name, pixels in zip("ab", deep)]
    result = inspect(block_of(mosaic, *paths), WHOLE)
    assert result.causes == (Cause.NONE,)
    assert result.judgement.verdict is Verdict.PRESERVED
    assert result.profile.kept[0] == pytest.approx(1, abs=0.05)


@pytest.mark.slow
@pytest.mark.parametrize("change", ["nothing", "unsharp", "blur", "gain", "noise"])
def test_causes_do_not_depend_on_how_many_grey_values_there_are(
    make_raster: MakeRaster, sources: list[np.ndarray], change: str
) -> None:
    """One ground in 8 and in 16 bit: what is noise there is noise here."""
    rng = np.random.default_rng(2)
    fine = [source.astype(np.float64) + rng.uniform(-0.5, 0.5, source.shape) for source in sources[:2]]
    hard = np.where(np.arange(SIDE) < BORDER, *fine)
    made = {
        "nothing": hard, "unsharp": 2 * hard - ndimage.gaussian_filter(hard, (0, 1, 1)), "gain": 0.6 * hard + 20,
        "blur": ndimage.gaussian_filter(hard, (0, 0.7, 0.7)), "noise": hard + rng.normal(0, 4, hard.shape),
    }[change]
    few = inspected(make_raster, as_bytes(made), [as_bytes(plane) for plane in fine])
    many = inspected(make_raster, in_16_bit(made), [in_16_bit(plane) for plane in fine])
    assert many.causes == few.causes
    assert many.judgement.verdict is few.judgement.verdict


@pytest.mark.slow
@pytest.mark.parametrize("factor", [1 / 255, 1e-3 / 255, 1e4])
def test_floating_point_of_any_scale_is_measured_as_8_bit_is(
    make_raster: MakeRaster, sources: list[np.ndarray], factor: float
) -> None:
    """Reflectance from 0 to 1: verdict, causes and what is kept; variances and tones stay in the file's values."""
    image = blended(sources, 40)
    scaled = [(pixels * factor).astype(np.float32) for pixels in (image, *sources[:2])]
    few, many = inspected(make_raster, image, sources[:2]), inspected(make_raster, scaled[0], scaled[1:])
    assert many.judgement.verdict is few.judgement.verdict
    assert many.causes == few.causes
    assert many.explained == pytest.approx(few.explained, abs=1e-3)
    assert many.profile.kept == pytest.approx(few.profile.kept, abs=1e-3)
    assert many.judgement.ratios.detail == pytest.approx(few.judgement.ratios.detail, abs=1e-3)
    for ours, theirs in zip(many.with_composite, few.with_composite):
        variances = [curve.variance / factor**2 for curve in ours.curves.values()]
        assert variances == pytest.approx([curve.variance for curve in theirs.curves.values()], rel=1e-3)
    for ours, theirs in zip(many.pairs, few.pairs):
        assert ours.change.tone.gain == pytest.approx(theirs.change.tone.gain, abs=1e-3)
        assert ours.change.tone.bias / factor == pytest.approx(theirs.change.tone.bias, abs=0.1)


def in_16_bit(bands: np.ndarray) -> np.ndarray:
    return np.clip(np.rint(200 * bands), 1, 65535).astype(np.uint16)


def test_one_band_is_judged_too(make_raster: MakeRaster) -> None:
    first, second = (orthoimage(SHAPE, 1, seed=seed) for seed in (1, 2))
    second = as_bytes(0.5 * first + 0.5 * second)
    result = inspected(make_raster, as_bytes((1 - weight(40)) * first + weight(40) * second), [first, second])
    assert result.causes[0] is Cause.FEATHERING
    assert result.profile.high < 1
