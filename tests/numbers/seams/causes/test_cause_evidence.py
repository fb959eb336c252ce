"""What causes are judged by: how fine detail came over, what was added to it, traces of compression, tones."""
from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.imagery.rasters import Raster
from seam_inspector.plugin.imagery.wavelets import detail_components
from seam_inspector.plugin.seams.measure.following.compression import MIN_VANISHED
from seam_inspector.plugin.seams.measure.judgement.cause_evidence import measure_texture, range_factor
from seam_inspector.plugin.seams.measure.judgement.causes import Texture
from seam_inspector.plugin.seams.measure.seam_cells import UNKNOWN

from benchmarks import aftermaths
from tests.numbers.synthetic import texture

SHAPE = (256, 288)
EVERYWHERE = np.ones(SHAPE, bool)
RNG = np.random.default_rng(4)


@pytest.fixture(scope="module")
def plane() -> np.ndarray:
    """Plane of the sources, with weak and strong detail, (rows, columns) float32 of whole values."""
    strength = 3 + 14 * (ndimage.gaussian_filter(texture(SHAPE, 3.0, 1), 8, mode="wrap") > 0)
    return np.rint(120 + 20 * texture(SHAPE, 2.5, 2) + strength * texture(SHAPE, 1.0, 3)).astype(np.float32)


def halves() -> np.ndarray:
    return np.broadcast_to((np.arange(SHAPE[1]) >= 144).astype(np.uint8), SHAPE)


def texture_of(
    mosaic: np.ndarray, expected: np.ndarray, plain: np.ndarray | None = None, labels: np.ndarray | None = None,
    sure: np.ndarray = EVERYWHERE, unit_dn: float = 1.0,
) -> Texture | None:
    planes = [mosaic, expected] if plain is None else [mosaic, expected, plain]
    details = next(iter(detail_components(np.stack(planes).astype(np.float32), "coif3", 1)))
    labels = halves() if labels is None else labels
    sure_labels = np.where(sure, labels, np.uint8(UNKNOWN))
    return measure_texture(details, sure_labels, mosaic.astype(np.float32), expected.astype(np.float32), unit_dn)


@pytest.mark.parametrize("quality", [50, 75, 90])
@pytest.mark.parametrize("corner", [(0, 0), (3, 5)])
def test_compression_leaves_its_grid_wherever_that_begins(
    plane: np.ndarray, quality: int, corner: tuple[int, int]
) -> None:
    bands = np.repeat(plane[np.newaxis], 3, axis=0).clip(0, 255).astype(np.uint8)
    large = np.pad(bands, ((0, 0), (corner[0], 8), (corner[1], 8)), mode="reflect")
    made = aftermaths.jpeg(quality)(large, RNG)[1, corner[0] :, corner[1] :][: SHAPE[0], : SHAPE[1]]
    texture = texture_of(made, plane)
    assert texture.quantised > MIN_VANISHED
    deep = texture_of(257 * made.astype(np.float32), 257 * plane, unit_dn=257)  # the same in 16 bit
    assert deep.quantised == pytest.approx(texture.quantised, abs=0.01)


@pytest.mark.parametrize("change", ["noise", "unsharp", "blur", "gain"])
def test_nothing_else_leaves_such_a_grid(plane: np.ndarray, change: str) -> None:
    noise = RNG.normal(0, 4, SHAPE)
    made = {
        "noise": plane + noise, "unsharp": 2 * plane - ndimage.gaussian_filter(plane, 1) + noise,
        "blur": ndimage.gaussian_filter(plane + noise, 0.8), "gain": np.rint(0.3 * plane),
    }[change]
    texture = texture_of(np.rint(made), plane)
    assert texture.quantised < MIN_VANISHED


def test_what_compressed_the_sources_is_none_of_the_mosaics(plane: np.ndarray) -> None:
    bands = np.repeat(plane[np.newaxis], 3, axis=0).clip(0, 255).astype(np.uint8)
    source = aftermaths.jpeg(60)(bands, RNG)[1].astype(np.float32)
    texture = texture_of(source + RNG.normal(0, 2, SHAPE), source)
    assert texture.quantised < MIN_VANISHED


def raster(mosaic: Raster, data_type: str, bits: int | None = None) -> Raster:
    return replace(mosaic, data_type=data_type, bits=bits)


@pytest.mark.parametrize(
    ("ours", "theirs", "gain", "expected"),
    [
        (("uint8", None), ("uint8", None), 0.6, 0.6),
        (("uint8", None), ("uint16", 12), 255 / 4095, 1.0),
        (("uint8", None), ("uint16", 16), 0.6 * 255 / 65535, 0.6),
        (("uint16", 12), ("uint8", None), 4095 / 255, 1.0),
        (("uint16", None), ("uint16", None), 0.6, 0.6),  # of one type: as they are
        (("uint8", None), ("uint16", None), 0.06, None),  # nobody says how much of 16 bit is used
        (("float32", None), ("float32", None), 0.8, 0.8),
        (("uint8", None), ("float32", None), 200.0, None),
    ],
)
def test_gains_are_told_in_the_range_of_values(
    mosaic: Raster, ours: tuple[str, int | None], theirs: tuple[str, int | None], gain: float, expected: float | None
) -> None:
    factor = range_factor(raster(mosaic, *ours), raster(mosaic, *theirs))
    assert (factor if factor is None else gain * factor) == (expected if expected is None else pytest.approx(expected))
