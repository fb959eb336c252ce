"""What tonal correction did to grey values: gain, bias, gamma, clipping (Pyka 2010, section 3).

Fitted to the means of squares of 2^R px, the coarse component of the simplest wavelet: neither blur nor sub-pixel
shifts touch those, and they stand in grey values.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import minimize_scalar

from ...imagery.statistics import robust_sigma

MIN_TONE_RESIDUAL = 0.05  # grey values: a line that fits the coarse means this well is one
MIN_GAMMA, MAX_GAMMA = 0.2, 5.0  # that are looked for
MIN_GAMMA_GAIN = 0.1  # a power function has to leave residuals smaller by this share

_GAMMA_STEP = 0.01  # share of an exponent that it is told to, a tenth of what is called a gamma
_MOST_POINTS = 512  # means that are fitted to, picked evenly: an exponent takes all pixels of each
_FEWEST_POINTS = 16  # means: fewer are no base for a robust line
_EVEN = 1e-9  # grey values: what varies less is even, but for rounding
_TUKEY_SCALES = 4.685  # where Tukey's weights vanish: those of 95 % efficiency


@dataclass(frozen=True)
class Tone:
    """Grey values of the mosaic as a function of a source's: gain x g + bias."""

    gain: float
    """A; below 1 the histogram was narrowed."""
    bias: float
    """B, grey values."""
    gamma: float = 1.0
    """Exponent of a x g^gamma + b where that fits clearly better, else 1."""


def tukey_weights(residuals: np.ndarray) -> np.ndarray:
    """Weight of each residual: 1 where it is 0, 0 far beyond their scale."""
    scale = max(robust_sigma(residuals), _EVEN)
    return np.asarray(np.clip(1 - (residuals / (_TUKEY_SCALES * scale)) ** 2, 0, None) ** 2)


def robust_fit(terms: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Coefficients of terms (k, points) that make values (points,) of them, and what they leave over: least squares,
    reweighted (Holland and Welsch 1977)."""
    weights = np.ones_like(values)
    for _ in range(6):  # it settles in two to five
        weighted = terms * weights
        coefficients = np.linalg.lstsq(weighted @ terms.T, weighted @ values, rcond=None)[0]
        residuals = values - coefficients @ terms
        weights = tukey_weights(residuals)
    return coefficients, residuals


def coarse_means(band: np.ndarray, levels: int) -> np.ndarray:
    """Means of the squares of 2^R px of a band (rows, columns), both multiples of 2^R; float32."""
    side = 2**levels
    rows, columns = (length // side for length in band.shape)
    values = band.view(np.uint8) if band.dtype == bool else band
    # Whole rows first, which are added up at once; 2^R samples of one byte fit into two.
    single = np.uint16 if values.dtype == np.uint8 else np.float32
    down = np.add.reduce(values.reshape(rows, side, -1), axis=1, dtype=single)
    means: np.ndarray = down.reshape(-1, side).astype(np.float32) @ np.full(side, 1 / side**2, np.float32)
    return means.reshape(rows, columns)


def whole_squares(mask: np.ndarray, levels: int) -> np.ndarray:
    """Squares of 2^R px that lie wholly in a mask, (rows / 2^R, columns / 2^R) bool."""
    return coarse_means(mask, levels) == 1


def fit_tones(
    mosaic: np.ndarray, source: np.ndarray, where: np.ndarray, pixels: Sequence[tuple[np.ndarray, Sequence[float]]]
) -> list[Tone | None]:
    """Robust fits of the mosaic's coarse means to the source's, both (bands, rows, columns), band by band.

    ``where``, (rows, columns) bool, says which means count. ``pixels`` has for each band what its means are averaged
    from: bands (n, rows, columns) of the source and their weights, since a power function acts on the pixels of each
    band before they are averaged. None where there is nothing to fit: too few means, or all alike.
    """
    places = np.argwhere(where)
    places = places[:: max(1, len(places) // _MOST_POINTS)]
    tones: list[Tone | None] = []
    for band, (bands, weights) in enumerate(pixels):
        y, x = (pixel_values[band][tuple(places.T)].astype(np.float64) for pixel_values in (mosaic, source))
        if len(places) < _FEWEST_POINTS or min(x.std(), y.std()) <= _EVEN:
            tones.append(None)
            continue
        scaled = (x - x.mean()) / x.std()
        line = np.stack([np.ones_like(x), scaled])
        (middle, slope), rest = robust_fit(line, y)
        gain, gamma = float(slope / x.std()), 1.0
        # Where a parabola does no better than a line, no power function will.
        if gain > 0 and _spread(rest) > MIN_TONE_RESIDUAL:
            bent = _spread(robust_fit(np.stack([*line, scaled**2]), y)[1])
            if bent <= (1 - MIN_GAMMA_GAIN / 2) * _spread(rest):
                gamma = _gamma(_squares_at(bands, source.shape[1:], places), weights, y)
        tones.append(Tone(gain, float(middle - gain * x.mean()), gamma))
    return tones


def _squares_at(bands: np.ndarray, shape: tuple[int, ...], places: np.ndarray) -> np.ndarray:
    """Pixels (bands, points, pixels) that the coarse means (rows, columns) of ``shape`` at some places stand for."""
    side = bands.shape[1] // shape[0]
    split = bands.reshape(len(bands), shape[0], side, shape[1], side)[:, places[:, 0], :, places[:, 1]]
    return split.swapaxes(0, 1).reshape(len(bands), len(places), -1).astype(np.float32)


def _gamma(pixels: np.ndarray, weights: Sequence[float], y: np.ndarray) -> float:
    """The exponent where a power function of pixels (bands, points, pixels), averaged with the bands' weights, leaves
    clearly less of ``y`` (points,) than a linear one, else 1."""
    lowest, highest = float(pixels.min()), float(pixels.max())
    if lowest < 0 or highest <= lowest:
        return 1.0

    def left_over(log_exponent: float) -> float:
        powers = (pixels / np.float32(highest)) ** np.float32(np.exp(log_exponent))
        means = np.asarray(weights) @ powers.mean(axis=2)
        return _spread(robust_fit(np.stack([np.ones_like(y), means]), y)[1])

    fitted = minimize_scalar(
        left_over, bounds=np.log([MIN_GAMMA, MAX_GAMMA]), method="bounded", options={"xatol": _GAMMA_STEP}
    )
    return float(np.exp(fitted.x)) if fitted.fun <= (1 - MIN_GAMMA_GAIN) * left_over(0.0) else 1.0


def _spread(residuals: np.ndarray) -> float:
    """Standard deviation by what four fifths stay within: a bend shows in dark and bright parts, which are few."""
    return float(np.quantile(np.abs(residuals), 0.8)) / 1.2816


def clipped_share(mosaic: np.ndarray, source: np.ndarray) -> float:
    """Share of pixels at the lowest or highest value of the mosaic's clip that were not at the source's (band each).

    Values that whole numbers merged by a smaller gain are no clipping: what the tone merely moved to the end of the
    scale stood close together in the source.
    """
    merged = 0.0
    if mosaic.dtype.kind != "f":  # source values that become one where the scale is merely narrowed, one to spare
        merged = _width(source) / max(_width(mosaic), 1.0) + 1
    count = 0
    for end in (np.min, np.max):
        pile = source[mosaic == end(mosaic)]
        if pile.max() - pile.min() > merged:
            count += int(np.count_nonzero(pile != end(source)))
    return count / mosaic.size


def _width(band: np.ndarray) -> float:
    """How far nine tenths of the values lie apart."""
    ordered = np.sort(band[::4, ::4], axis=None, kind="stable")  # whole numbers are merely counted
    outside = len(ordered) // 20
    return float(ordered[-1 - outside]) - float(ordered[outside])
