"""The measurement: from the pixels of a clip to its curve of relative variances (Pyka 2010, equation 4).

The decomposition is orthonormal, so the energy that leaves the coarse component at level r is that of the level's three
details (Mallat 1989), and the chain of coarse components is enough: with E_r its sum of squares at level r,

    detail_r = (E_(r-1) - E_r) / E_0        background = E_R / E_0

and so for inner products of two clips. The chain runs in float32 where that is exact enough, else in float64; where a
detail is too small even there to be a difference of energies, all components are computed one by one.

Clips are arrays (bands, rows, columns) of any real type, finite, their sides multiples of ``2 ** levels``. Each
coefficient has the place where PyWavelets has it. Whatever decomposes raises SettingsError as ``check_decomposition``.
"""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
import pywt

from . import limits, messages
from .clips import Clip
from .errors import SettingsError
from .filters import FilterPair, Pair, filter_pair, halved, scale, split, sums_of_products
from .limits import has_colours, measured_bands

# A component of a smaller share is not exact to 1e-4 in that chain of coarse components.
MIN_FLOAT32_SHARE = 3e-3  # shares were off by 1.5e-7 at most, on textures and orthoimages from 256 x 256 px on
MIN_FLOAT64_SHARE = 1e-5  # PyWavelets' coefficients are orthonormal to 1e-11 at worst (sym20)
MIN_EXACT_SHARE = 1e-9  # of the sum of several bands' energies, where each component is computed for itself
MIN_FLOAT32_PIXELS = 256 * 256  # smaller clips are fast in float64 too, and average less rounding out
FLOAT32_WAVELETS = (  # those whose float32 shares stay that near on all of these
    *("coif1", "coif2", "coif3", "db2", "db3", "db4", "db5", "db6"),
    *("sym2", "sym3", "sym4", "sym5", "sym6", "sym7", "sym8", "sym9"),
)
DIRECTIONS = ("LH", "HL", "HH")
"""The three components of a level's detail, as ``detail_components`` has them: lines that run horizontally, vertically
and diagonally show up in them. PyWavelets calls them cH, cV and cD."""


@dataclass(frozen=True)
class Curve:
    """How the variance of one clip and band spreads over the components. All shares add up to 1."""

    detail: tuple[float, ...]
    """Relative variance of the three detail components of level 1 (finest), 2, ..., R together."""
    background: float
    """Relative variance of the coarse component at level R."""
    variance: float
    """Variance of the clip, DN squared; 0 for a constant clip, whose shares are NaN."""

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Curve) and repr(self) == repr(other)  # which NaN is to itself

    def __hash__(self) -> int:
        return hash(repr(self))


@dataclass(frozen=True)
class Products:
    """Inner products of the components of a clip's bands: each band with itself, its energies, then pairs of bands."""

    components: np.ndarray
    """(bands + pairs, R + 1), float64: level 1..R details, then the coarse component."""
    totals: np.ndarray
    """(bands + pairs,), float64: of the bands less their means."""
    coarse: np.ndarray
    """(bands, rows / 2^R, columns / 2^R): the coarse components at level R, up to a constant."""
    least_share: float
    """Parts of an energy from this share on are exact to 1e-4."""


def check_decomposition(wavelet: str, levels: int) -> None:
    """Raise SettingsError unless the wavelet is orthogonal and the levels are 1 to 8."""
    if wavelet not in limits.WAVELETS:
        if wavelet in pywt.wavelist(kind="discrete"):
            raise SettingsError(messages.WAVELET_NOT_ORTHOGONAL(wavelet=wavelet))
        raise SettingsError(messages.WAVELET_UNKNOWN(wavelet=wavelet))
    limits.check_type("levels", levels, int)
    if not limits.MIN_LEVELS <= levels <= limits.MAX_LEVELS:
        raise SettingsError(
            messages.LEVELS_OUT_OF_RANGE(levels=levels, least=limits.MIN_LEVELS, most=limits.MAX_LEVELS)
        )


def clip_curves(
    bands: np.ndarray, wavelet: str, levels: int, luminance_weights: Sequence[float] = ()
) -> tuple[list[Curve], np.ndarray]:
    """Curves of all bands of a clip, and of its luminance when weights are given; and the coarse components at level R
    in the same order, luminance last.

    ``luminance_weights`` has one weight for each of the first bands. The luminance has no transform of its own: its
    energies follow from the inner products of the bands (the homogeneity of Pyka 2009).
    """
    weights = np.asarray(luminance_weights, dtype=np.float64)
    mixed = len(weights)
    pairs = list(combinations(range(mixed), 2))
    products = component_products(bands, wavelet, levels, pairs)
    pixels = bands[0].size
    squares, cross = np.split(products.components, [len(bands)])
    curves = [_curve(energies, total, pixels) for energies, total in zip(squares, products.totals)]
    if not mixed:
        return curves, products.coarse
    doubled = np.array([2 * weights[i] * weights[j] for i, j in pairs])
    energies = weights**2 @ squares[:mixed] + doubled @ cross
    bands_energy = weights**2 @ products.totals[:mixed]
    if energies.min() <= products.least_share * bands_energy:  # the bands cancel each other, or all are smooth
        mixture = np.tensordot(weights, bands[:mixed].astype(np.float64), axes=1)
        curves += clip_curves(mixture[np.newaxis], wavelet, levels)[0]
    else:
        curves.append(_curve(energies, bands_energy + doubled @ products.totals[len(bands) :], pixels))
    luminance = np.tensordot(weights, products.coarse[:mixed], axes=1)
    return curves, np.concatenate([products.coarse, luminance[np.newaxis].astype(products.coarse.dtype)])


def component_products(bands: np.ndarray, wavelet: str, levels: int, pairs: Sequence[Pair] = ()) -> Products:
    """Energies of the components of every band, and inner products of the given pairs of bands, which may stem from
    different rasters."""
    check_decomposition(wavelet, levels)
    filters = filter_pair(wavelet)
    single = (
        wavelet in FLOAT32_WAVELETS
        and bands[0].size >= MIN_FLOAT32_PIXELS
        and np.can_cast(bands.dtype, np.float32)  # of float64 and 32 bit integers it would drop digits
    )
    for dtype in (np.float32, np.float64) if single else (np.float64,):
        products = _chain_products(bands, filters, levels, pairs, dtype)
        if (products.components > products.least_share * products.totals[:, np.newaxis])[: len(bands)].all():
            return products
    return _exact_products(bands, filters, levels, pairs)


def detail_components(bands: np.ndarray, wavelet: str, levels: int, mirrored: bool = False) -> Iterator[np.ndarray]:
    """The detail components of every band less its mean, level by level from the finest on.

    Each level is (3, bands, rows / 2^r, columns / 2^r): LH, HL and HH; coefficient (i, j) belongs to the pixels from
    (2^r i, 2^r j) on. In float32 for 8 and 16 bit values and float32, else in float64. Beyond their edges the bands go
    on periodically, or ``mirrored``.
    """
    check_decomposition(wavelet, levels)
    dtype = np.float32 if np.can_cast(bands.dtype, np.float32) else np.float64
    offsets = _near_means(bands)
    for _ in range(levels):
        parts = split(bands, offsets, filter_pair(wavelet), dtype, mirrored)
        yield parts[1:]
        bands, offsets = parts[0], [0.0] * len(bands)


def placed_components(bands: np.ndarray, wavelet: str, levels: int) -> Iterator[np.ndarray]:
    """Components as of ``detail_components``, without what only the periodic edges show: the bands are mirrored there,
    so the step from one edge to the opposite one is no detail. The energies therefore don't add up to the bands', as
    those of ``clip_curves`` do.

    Each coefficient is at the pixels that it comes from, to half of 2^r px: filters that are not symmetric lag behind,
    the low-pass of coif3 by 2.5 px and its high-pass by as much the other way. Those at the edges are repeated.
    """
    filters = filter_pair(wavelet)
    for level, parts in enumerate(detail_components(bands, wavelet, levels, mirrored=True), 1):
        low, high = (round(delay / 2**level) for delay in filters.delays_px(level))
        rows, columns = map(np.arange, parts.shape[2:])
        for part, (down, across) in zip(parts, ((high, low), (low, high), (high, high))):
            part[...] = part.take(rows - down, axis=1, mode="clip").take(columns - across, axis=2, mode="clip")
        yield parts


def _curve(energies: np.ndarray, total: float, pixels: int) -> Curve:
    shares = energies / total if total > 0 else np.full(len(energies), np.nan)
    return Curve(tuple(shares[:-1].tolist()), float(shares[-1]), float(total) / pixels)


def _chain_products(
    bands: np.ndarray, filters: FilterPair, levels: int, pairs: Sequence[Pair], dtype: type
) -> Products:
    """Products of the components from those of the coarse chain alone: what leaves it is detail."""
    wanted = [(i, i) for i in range(len(bands))] + list(pairs)
    offsets: Sequence[float] = _near_means(bands)  # what they miss the means by is taken out below, exactly
    chain, coarse, factor = [], bands, scale(filters.low, dtype)
    for level in range(levels):
        coarse, products = halved(coarse, offsets, filters, dtype, wanted)
        chain.append(products / factor ** (4 * level))
        offsets = [0.0] * len(bands)
    coarse = coarse.astype(np.float64) / factor ** (2 * levels)
    chain.append(sums_of_products(coarse, wanted))
    # A constant c has the energy N c^2 at every level, all of it coarse.
    missed = coarse.mean(axis=(1, 2), dtype=np.float64) / 2**levels
    energies = np.array(chain) - [bands[0].size * missed[i] * missed[j] for i, j in wanted]
    components = np.append(energies[:-1] - energies[1:], energies[-1:], axis=0)
    least_share = MIN_FLOAT32_SHARE if dtype is np.float32 else MIN_FLOAT64_SHARE
    return Products(components.T, energies[0], coarse, least_share)


def _exact_products(bands: np.ndarray, filters: FilterPair, levels: int, pairs: Sequence[Pair]) -> Products:
    """Products of the components with every detail computed for itself, in float64.

    No component is the difference of two larger numbers here, so it holds for clips of any smoothness.
    """
    wanted = [(i, i) for i in range(len(bands))] + list(pairs)
    coarse = bands - bands[:, :1, :1].astype(np.float64)  # exactly zero for a constant band
    coarse -= coarse.mean(axis=(1, 2), keepdims=True)
    totals = sums_of_products(coarse, wanted)
    components = []
    for _ in range(levels):
        coarse, *details = split(coarse, [0.0] * len(coarse), filters, np.float64)
        components.append(sum(sums_of_products(detail, wanted) for detail in details))
    components.append(sums_of_products(coarse, wanted))
    return Products(np.array(components).T, totals, coarse, MIN_EXACT_SHARE)


def _near_means(bands: np.ndarray) -> list[float]:
    """Offsets that keep the numbers small.

    Whole ones keep the squares of 8 bit values, and of 16 bit values near each other, free of any rounding.
    """
    means = [float(band[::16].mean(dtype=np.float64)) for band in bands]
    return [float(round(mean)) for mean in means] if bands.dtype.kind in "iu" else means


Directions = tuple[tuple[float, ...], ...]
"""Relative variance of LH, HL and HH, for level 1 (finest), 2, ..., R; NaN for a constant clip."""


def measure_bands(
    bands: np.ndarray, names: Sequence[str], wavelet: str, levels: int
) -> tuple[dict[str, Curve], dict[str, np.ndarray]]:
    """Curves and coarse components, by name, of bands (bands, rows, columns) with their names; luminance first."""
    weights = limits.LUMINANCE_WEIGHTS if has_colours(names) else ()
    curves, coarse = clip_curves(bands, wavelet, levels, weights)
    if weights:
        curves, coarse = [curves[-1], *curves[:-1]], [coarse[-1], *coarse[:-1]]
    measured = measured_bands(names)
    return dict(zip(measured, curves)), dict(zip(measured, coarse))


def measure_directions(clip: Clip, wavelet: str, levels: int) -> dict[str, Directions]:
    """Relative variances of the directional components of a clip by band name, luminance first where there is one.

    The decomposition is a whole one, in float64, of the luminance too: some five times the work of the curves.
    """
    bands, names = clip.bands.astype(np.float64), clip.raster.band_names
    if has_colours(names):
        weights = np.array(limits.LUMINANCE_WEIGHTS)
        bands = np.concatenate([np.tensordot(weights, bands[: len(weights)], axes=1)[np.newaxis], bands])
    energies = bands.var(axis=(1, 2)) * bands[0].size
    sums = [np.sum(parts**2, axis=(2, 3)) for parts in detail_components(bands, wavelet, levels)]
    shares = np.array(sums) / np.where(energies > 0, energies, np.nan)  # (levels, directions, bands)
    return {
        name: tuple(map(tuple, band.tolist())) for name, band in zip(measured_bands(names), np.moveaxis(shares, 2, 0))
    }


def luminance(bands: np.ndarray) -> np.ndarray:
    """The luminance, (rows, columns) float32, of bands whose first three are red, green and blue."""
    red, *others = (np.float32(weight) for weight in limits.LUMINANCE_WEIGHTS)
    mixture: np.ndarray = np.multiply(bands[0], red, dtype=np.float32)
    for band, weight in zip(bands[1:], others):
        mixture += np.multiply(band, weight, dtype=np.float32)
    return mixture


def judged_plane(bands: np.ndarray, names: Sequence[str]) -> np.ndarray:
    """What the verdict looks at, (rows, columns) float32: the luminance, else the first band."""
    return luminance(bands) if has_colours(names) else bands[0].astype(np.float32)


def correlation(a: np.ndarray, b: np.ndarray) -> float | None:
    """Correlation of two arrays of one shape; None where one of them is constant."""
    a, b = (x.astype(np.float64).ravel() for x in (a, b))
    a, b = a - a.mean(), b - b.mean()
    scale = np.sqrt((a @ a) * (b @ b))
    return float(a @ b / scale) if scale > 0 else None
