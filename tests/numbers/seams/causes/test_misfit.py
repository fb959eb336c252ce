"""Misregistration is that of images as they are placed in the mosaic, not of the mosaic and an orthoimage as given."""
from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from scipy import ndimage
from seam_inspector.plugin.imagery.clips import Clip
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.rasters import Raster
from seam_inspector.plugin.imagery.shifts import Shift
from seam_inspector.plugin.seams.measure.judgement.cause_evidence import misfit_of, placed_misfit
from seam_inspector.plugin.seams.measure.judgement.causes import ALONG_THE_SEAM, MIN_MISFIT_SHARE, Cause, causes_taken
from seam_inspector.plugin.seams.measure.judgement.explanation import Explanation

from benchmarks.scenes import Scene, explained, whole_values
from tests.numbers.synthetic import orthoimage, texture

SIDE, EDGE = 384, 16
OWN = 1.0  # of the ground's fine detail: what either image alone shows, so that their finest details agree by half
FEATHER_SIGMA_PX = 10.0  # from 5 to 95 % in 33 px
Place = tuple[float, float]
NOWHERE: Place = (0.0, 0.0)


@dataclass(frozen=True)
class Placing:
    """How a second image lies, px to the right and down: as it is given, on its own grid, and in the mosaic; and how
    the mosaic lies as a whole."""

    given: Place = NOWHERE
    grid: Place = NOWHERE
    placed: Place = NOWHERE
    whole: Place = NOWHERE


PLACINGS = {
    "fits": Placing(),
    "1 px off": Placing(given=(1.0, 0.0), placed=(1.0, 0.0)),
    "2 px off": Placing(given=(1.2, -1.6), placed=(1.2, -1.6)),
    "3 px off": Placing(given=(0.0, 3.0), placed=(0.0, 3.0)),
    "moved in the mosaic": Placing(placed=(1.2, -1.6)),
    "corrected": Placing(given=(2.0, 0.5)),
    "grids out of phase": Placing(grid=(0.4, -0.3)),
    "the whole mosaic moved": Placing(whole=(0.5, 0.3)),
    "the whole mosaic moved, 2 px off": Placing(given=(1.2, -1.6), placed=(1.2, -1.6), whole=(0.5, 0.3)),
}
FEATHERS = {"hard": 0.0, "33 px": FEATHER_SIGMA_PX}


class Seen:
    """One image of the ground, moved once to each place that is asked for."""

    def __init__(self, ground: np.ndarray) -> None:
        self.moved = {NOWHERE: ground}

    def at(self, place: Place) -> np.ndarray:
        """(bands, rows, columns) without the edges, when the ground lies so many px to the right and down."""
        if place not in self.moved:
            offset = 0, place[1], place[0]
            self.moved[place] = ndimage.shift(self.moved[NOWHERE], offset, order=5, mode="mirror")
        return self.moved[place][:, EDGE:-EDGE, EDGE:-EDGE]


def generated() -> np.ndarray:
    side = SIDE + 2 * EDGE
    return ndimage.gaussian_filter(orthoimage((side, side)).astype(np.float32), (0, 0.6, 0.6))


@pytest.fixture(scope="module", params=["generated", pytest.param("real", marks=pytest.mark.release)])
def ground(request: pytest.FixtureRequest) -> np.ndarray:
    """(bands, rows, columns) float32 of one image, a margin on every side."""
    if request.param == "generated":
        return generated()
    path: Path = request.getfixturevalue("data_folder") / "seams" / "brighton"
    dataset = gdal.Open(str(sorted(path.glob("DJI_*.tif"))[2]))
    side = SIDE + 2 * EDGE
    left, top = (dataset.RasterXSize - side) // 2, (dataset.RasterYSize - side) // 2
    return np.asarray(dataset.ReadAsArray(left, top, side, side)[:3], np.float32)


def own_detail(ground: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """Detail as strong as the ground's within some pixels, alike in all bands."""
    noise = ndimage.gaussian_filter(rng.normal(0, 1, ground.shape[1:]), 0.6)
    noise -= ndimage.gaussian_filter(noise, 2)
    fine = ground - ndimage.gaussian_filter(ground, (0, 2, 2))
    return np.asarray(OWN * fine.std() / noise.std() * noise, np.float32)


@pytest.fixture(scope="module")
def images(ground: np.ndarray) -> tuple[Seen, Seen]:
    """Two of one ground that differ by their noise."""
    rng = np.random.default_rng(3)
    first, second = (Seen(ground + own_detail(ground, rng)) for _ in range(2))
    return first, second


def found_in(images: tuple[Seen, Seen], placing: Placing, sigma_px: float, raster: Raster) -> Explanation:
    """A mosaic of two images; the seam winds down its middle."""
    first, second = images
    border = SIDE // 2 + 12 * np.sin(np.arange(SIDE) / 40)
    labels = (np.arange(SIDE) >= border[:, np.newaxis]).astype(np.uint8)
    share = labels.astype(np.float32) if not sigma_px else ndimage.gaussian_filter(labels.astype(np.float32), sigma_px)
    in_mosaic = placing.placed[0] + placing.whole[0], placing.placed[1] + placing.whole[1]
    bands = (1 - share) * first.at(placing.whole) + share * second.at(in_mosaic)
    on_grid = placing.given[0] + placing.grid[0], placing.given[1] + placing.grid[1]
    clips = (
        Clip(raster, whole_values(first.at(NOWHERE)), 0.0),
        Clip(raster, whole_values(second.at(on_grid)), 0.0, *placing.grid),
    )
    return explained(Scene(PixelWindow(0, 0, SIDE, SIDE), labels, clips, raster), whole_values(bands))[0]


@pytest.mark.slow
@pytest.mark.parametrize("feather", FEATHERS)
@pytest.mark.parametrize("name", PLACINGS)
def test_what_counts_is_how_images_are_placed(
    images: tuple[Seen, Seen], mosaic: Raster, name: str, feather: str
) -> None:
    true = float(np.hypot(*PLACINGS[name].placed))
    explanation = found_in(images, PLACINGS[name], FEATHERS[feather], mosaic)
    assert Cause.MISSING_SOURCE not in explanation.causes  # of images that fit well once they are moved as well
    assert explanation.misfit == pytest.approx(true, abs=0.1)
    misfit = explanation.evidence.misfit
    is_told = true >= 1 and misfit is not None and misfit.share >= MIN_MISFIT_SHARE
    assert (Cause.MISREGISTRATION in explanation.causes) is is_told
    taken = dict(causes_taken(explanation.evidence))
    if feather == "hard":
        assert not any(taken.get(cause) for cause in ALONG_THE_SEAM)
    else:
        assert Cause.FEATHERING in explanation.causes
        misfit = explanation.evidence.misfit
        is_first = taken.get(Cause.MISREGISTRATION, 0.0) > taken[Cause.FEATHERING]
        assert is_first is (misfit.share > 0.5)


def test_a_common_offset_and_a_correction_drop_out() -> None:
    between, first, second = Shift(1.5, -0.5, 0.5), Shift(0.25, 0.25, 0.5), Shift(1.75, -0.25, 0.5)
    assert placed_misfit(between, first, second) == (0.0, 0.0)
    assert placed_misfit(between, first, first) == (1.5, -0.5)
    moved = (Shift(shift.x + 0.5, shift.y - 0.25, 0.5) for shift in (first, second))
    assert placed_misfit(between, *moved) == (0.0, 0.0)


@pytest.mark.parametrize(("away", "share"), [((0.3, 0.2), 0.0), ((2.0, -1.0), 1.0)])
def test_the_share_is_what_images_would_not_differ_by_if_they_fitted(away: Place, share: float) -> None:
    """(aligned - placed) / (1 - placed), the agreement of the finest details: of one image with itself, all of it."""
    plane = (100 + 20 * texture((256, 256), 1.5, 5)).astype(np.float32)
    moved = np.asarray(ndimage.shift(plane, (away[1], away[0]), order=5, mode="mirror"), np.float32)
    seam = np.zeros((128, 128), bool)
    seam[:, 52:76] = True
    misfit = misfit_of(away, moved, plane, seam, "coif3")
    assert misfit.px == pytest.approx(np.hypot(*away))
    assert misfit.share == pytest.approx(share, abs=0.05)
    assert misfit_of(away, moved, plane, np.zeros_like(seam), "coif3").share == 0
