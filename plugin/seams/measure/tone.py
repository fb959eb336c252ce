"""What tonal correction did to grey values: gain, bias, gamma, clipping (Pyka 2010, section 3).

Fitted to the means of squares of 2^R px, the coarse component of the simplest wavelet: neither blur nor sub-pixel
shifts touch those, and they stand in grey values.
"""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

MIN_TONE_RESIDUAL = 0.05  # grey values: a line that fits the coarse means this well is one
MIN_GAMMA, MAX_GAMMA = 0.2, 5.0  # that are looked for
MIN_GAMMA_GAIN = 0.1  # a power function has to leave residuals smaller by this share

_ROUNDS = 6  # of reweighting at most; it settles in two to five
_MOST_POINTS = 1024  # means that a line is fitted to, picked evenly: all of a large window take their time
_GAMMA_POINTS = 384  # of them, that exponents are tried on: each takes all of its pixels
_GAMMA_VALUES = 1024  # that pixels are told apart by: of 8 bit and 10 bit ones all
_GAMMA_STEPS = ((13, 2), (7, 3), (7, _ROUNDS))
"""How many exponents are tried, first and then between the neighbours of the best, to 1 %; and rounds of each fit."""
_FEWEST_POINTS = 16  # means: fewer are no base for a robust line
TUKEY = 4.685  # times the scale: weights of 95 % efficiency (Holland and Welsch 1977)
_LEAST_SCALE = 1e-9  # grey values: what varies less is even, but for rounding
_SETTLED = 1e-6  # of the spread of grey values
_FOUR_FIFTHS = 1.2816  # standard deviations within which 80 % of a normal distribution lie
_LEAST_PILE = 1e-4  # of the pixels: fewer are not worth a second look


@dataclass(frozen=True)
class Tone:
    """Grey values of the mosaic as a function of a source's: gain x g + bias."""

    gain: float
    """A; below 1 the histogram was narrowed."""
    bias: float
    """B, grey values."""
    gamma: float = 1.0
    """Exponent of a x g^gamma + b where that fits clearly better, else 1."""


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
    side = 2**levels
    rows, columns = (length // side for length in mask.shape)
    down = np.logical_and.reduce(mask.reshape(rows, side, -1), axis=1)
    return np.asarray(down.reshape(rows, columns, side).all(axis=2))


def fit_tones(
    mosaic: np.ndarray, source: np.ndarray, where: np.ndarray, pixels: Sequence[tuple[np.ndarray, Sequence[float]]]
) -> list[Tone | None]:
    """Robust fits of the mosaic's coarse means to the source's, both (bands, rows, columns), band by band.

    ``where``, (rows, columns) bool, says which means count. ``pixels`` has for each band what its means are averaged
    from: bands (n, rows, columns) of the source and their weights, since a power function acts on the pixels of each
    band before they are averaged. Iteratively reweighted least squares with Tukey's weights, started from medians.
    None where there is nothing to fit: too few means, or all alike.
    """
    rows, columns = np.nonzero(where)
    step = max(1, len(rows) // _MOST_POINTS)
    rows, columns = rows[::step], columns[::step]
    if len(rows) < _FEWEST_POINTS:
        return [None] * len(mosaic)
    y, x = mosaic[:, rows, columns].astype(np.float64), source[:, rows, columns].astype(np.float64)
    varied = (x.std(axis=1) > _LEAST_SCALE) & (y.std(axis=1) > _LEAST_SCALE)
    tones: list[Tone | None] = [None] * len(mosaic)
    if not varied.any():
        return tones
    numbers = np.flatnonzero(varied)
    gains, biases, spreads = _linear(x[varied], y[varied])
    bends = (gains > 0) & (spreads > MIN_TONE_RESIDUAL)
    if bends.any():
        bends[bends] = _bends(x[varied][bends], y[varied][bends], spreads[bends])
    for number, gain, bias, bent in zip(numbers.tolist(), gains.tolist(), biases.tolist(), bends.tolist()):
        bands, weights = pixels[number]
        gamma = _gamma(bands, weights, source.shape[1:], (rows, columns), y[number]) if bent else 1.0
        tones[number] = Tone(gain, bias, gamma)
    return tones


def colour_shift(gains: Iterable[float]) -> float | None:
    """Largest over smallest gain of the bands; None where there are fewer than two, or one of them is no gain."""
    known = [abs(gain) for gain in gains]
    return max(known) / min(known) if len(known) > 1 and min(known) > 0 else None


def clipped_share(mosaic: np.ndarray, source: np.ndarray) -> float:
    """Share of pixels at the lowest or highest value of the mosaic's clip that were not at the source's (band each).

    Values that whole numbers merged by a smaller gain are no clipping: what the tone merely moved to the end of the
    scale stood close together in the source.
    """
    piles = [source[mosaic == end(mosaic)] for end in (np.min, np.max)]
    shares = [int(np.count_nonzero(pile != end(source))) / mosaic.size for pile, end in zip(piles, (np.min, np.max))]
    if max(shares) < _LEAST_PILE:
        return float(sum(shares))
    merged = _merged(mosaic, source)
    return float(sum(
        share
        for pile, share in zip(piles, shares)
        if share < _LEAST_PILE or pile.max() - pile.min() > merged
    ))


def _merged(mosaic: np.ndarray, source: np.ndarray) -> float:
    """How many source values become one in the mosaic when the scale is merely compressed, with one to spare."""
    if mosaic.dtype.kind == "f":
        return 0.0
    return _width(source) / max(_width(mosaic), 1.0) + 1


def _width(band: np.ndarray) -> float:
    """Nine tenths of the values lie so far from each other at most."""
    ordered = np.sort(band[::4, ::4], axis=None, kind="stable")  # whole numbers are merely counted
    outside = len(ordered) // 20
    return float(ordered[-1 - outside]) - float(ordered[outside])


def _linear(x: np.ndarray, y: np.ndarray, rounds: int = _ROUNDS) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Gain, bias and the residuals' scale of each row of x and y, (rows, points)."""
    x_middle, y_middle = _median(x), _median(y)
    x_off, y_off = x - x_middle[:, np.newaxis], y - y_middle[:, np.newaxis]
    squares, products = x_off * x_off, x_off * y_off
    x_spread, y_spread = _median(np.abs(x_off)), _median(np.abs(y_off))
    sign = np.where(_median(products) < 0, -1.0, 1.0)
    least = products.sum(axis=1) / np.maximum(squares.sum(axis=1), _LEAST_SCALE)
    gain = np.where(x_spread > 0, sign * y_spread / np.where(x_spread > 0, x_spread, 1), least)
    bias = np.zeros_like(gain)
    terms = np.stack([np.ones_like(x), x_off, y_off, squares, products], axis=1)
    for _ in range(rounds):
        weights = _weights(y_off - gain[:, np.newaxis] * x_off - bias[:, np.newaxis])
        total, of_x, of_y, of_squares, of_products = (terms @ weights[..., np.newaxis])[..., 0].T
        spread = of_squares - of_x**2 / total
        fitted = (of_products - of_x * of_y / total) / np.maximum(spread, _LEAST_SCALE)
        before = gain, bias
        gain = np.where(spread > _LEAST_SCALE, fitted, gain)
        bias = np.where(spread > _LEAST_SCALE, (of_y - gain * of_x) / total, bias)
        moved = np.abs(gain - before[0]) * x_spread + np.abs(bias - before[1])
        if (moved <= _SETTLED * y_spread).all():
            break
    scale = _reach_of(y_off - gain[:, np.newaxis] * x_off - bias[:, np.newaxis])
    return gain, bias + y_middle - gain * x_middle, scale


def _gamma(
    bands: np.ndarray,
    weights: Sequence[float],
    shape: tuple[int, ...],
    places: tuple[np.ndarray, np.ndarray],
    y: np.ndarray,
) -> float:
    """The exponent where a power function leaves clearly less than the linear one, else 1.

    ``shape`` (rows, columns) of the coarse means, ``places`` of those that count, ``y`` the mosaic's at these places.
    """
    step = max(1, len(y) // _GAMMA_POINTS)
    rows, columns = (index[::step] for index in places)
    side = bands.shape[1] // shape[0]
    split = bands.reshape(len(bands), shape[0], side, shape[1], side)[:, rows, :, columns]  # points come first
    lowest, highest = float(split.min()), float(split.max())
    if lowest < 0 or highest <= lowest:
        return 1.0
    count = _GAMMA_VALUES if bands.dtype.kind == "f" else min(int(highest - lowest) + 1, _GAMMA_VALUES)
    shares = _value_shares(split.swapaxes(0, 1), weights, lowest, (count - 1) / (highest - lowest), count)
    values = np.linspace(lowest, highest, count) / highest
    means = y[np.newaxis, ::step]

    low, high = MIN_GAMMA, MAX_GAMMA
    for count, rounds in _GAMMA_STEPS:
        grid = np.append(np.geomspace(low, high, count), 1.0)  # the last is the line
        powers = values ** grid[:, np.newaxis] @ shares.T
        found = _linear(powers, np.broadcast_to(means, powers.shape), rounds)[2]
        best = int(found[:-1].argmin())
        low, high = grid[max(best - 1, 0)], grid[min(best + 1, count - 1)]
    return float(grid[best]) if found[best] <= (1 - MIN_GAMMA_GAIN) * found[-1] else 1.0


def _value_shares(
    pixels: np.ndarray, weights: Sequence[float], lowest: float, scale: float, count: int
) -> np.ndarray:
    """Weighted share of the pixels (bands, points, rows, columns) of each point at each value, (points, count)."""
    points = pixels.shape[1]
    number = ((pixels - np.float32(lowest)) * np.float32(scale) + np.float32(0.5)).astype(np.intp)
    number += count * np.arange(points)[:, np.newaxis, np.newaxis]
    each = number[0, 0].size
    shares = np.bincount(number.ravel(), np.repeat(np.asarray(weights) / each, points * each), points * count)
    return shares.reshape(points, count)


def _bends(x: np.ndarray, y: np.ndarray, linear_spreads: np.ndarray) -> np.ndarray:
    """For each row whether a parabola does better than a line: where it does not, no power function will."""
    scaled = (x - x.mean(axis=1, keepdims=True)) / x.std(axis=1, keepdims=True)
    powers = [np.ones_like(x), scaled, scaled**2]
    terms = np.stack([*powers, scaled**3, scaled**4, y, scaled * y, powers[2] * y], axis=1)
    weights = np.ones_like(y)
    for _ in range(_ROUNDS // 2):
        sums = (terms @ weights[..., np.newaxis])[..., 0]
        normal = np.stack([sums[:, i : i + 3] for i in range(3)], axis=1)
        constant, slope, bend = (np.linalg.pinv(normal) @ sums[:, 5:, np.newaxis]).T[0, :, :, np.newaxis]
        residuals = y - (constant + (slope + bend * scaled) * scaled)
        weights = _weights(residuals)
    return _reach_of(residuals) <= (1 - MIN_GAMMA_GAIN / 2) * linear_spreads


def _weights(residuals: np.ndarray) -> np.ndarray:
    """Tukey's; their scale is a normal distribution's standard deviation by the median."""
    weights = np.abs(residuals)
    weights /= np.maximum(1.4826 * TUKEY * _median(weights), TUKEY * _LEAST_SCALE)[:, np.newaxis]
    weights *= weights
    np.subtract(1, weights, out=weights)
    np.maximum(weights, 0, out=weights)
    weights *= weights
    weights += 1e-12
    return weights


def _reach_of(residuals: np.ndarray) -> np.ndarray:
    """Standard deviation by what four fifths stay within: a bend shows in dark and bright parts, which are few."""
    return _ranked(np.abs(residuals), int(0.8 * residuals.shape[1])) / _FOUR_FIFTHS


def _median(values: np.ndarray) -> np.ndarray:
    """The upper median of each row."""
    return _ranked(values, values.shape[1] // 2)


def _ranked(values: np.ndarray, rank: int) -> np.ndarray:
    """Value of that rank in each row, to seven digits: half the time of all, and a sixth of numpy's median."""
    with np.errstate(over="ignore"):  # what float32 can't hold is the largest there, too
        return np.partition(values.astype(np.float32), rank, axis=1)[:, rank].astype(np.float64)
