"""The measurement: from the pixels of a clip to its curve of relative variances (Pyka 2010, equation 4).

The decomposition is orthonormal, so the energy that leaves the coarse component at level r is exactly
the energy of that level's three details (Mallat 1989). The curve therefore needs the chain of coarse
components only: with E_r the sum of squares of the coarse component at level r,

    detail_r = (E_(r-1) - E_r) / E_0        background = E_R / E_0

The same holds for inner products of two clips. Large clips run in float32 where that is exact enough,
others in float64; where a detail is too small to be a difference of energies (very smooth clips), all
components are computed one by one.

Clips are arrays (bands, rows, columns). Coarse components are shifted in a circle against those of
PyWavelets: energies and inner products do not see it, and all clips of one size are shifted alike.
"""
from __future__ import annotations

import math
import threading
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache, lru_cache
from itertools import combinations

import numpy as np
import pywt

from . import limits, messages
from .errors import SettingsError

MIN_CHAIN_SHARE = 1e-3  # a component smaller than 1e-7 / 1e-4 is computed for itself, not as a difference
MIN_FLOAT32_PIXELS = 1024 * 1024  # smaller clips are fast in float64 too, and average less rounding out
FLOAT32_WAVELETS = (  # those whose float32 shares stayed within 1e-7 on textures and orthoimages of 1024 x 1024 px
    *("coif1", "coif2", "coif3", "db2", "db3", "db4", "db5", "db6"),
    *("sym2", "sym3", "sym4", "sym5", "sym6", "sym7", "sym8", "sym9"),
)
MAX_FILTER_ERROR = 1e-9  # orthonormality of PyWavelets' coefficients: 1e-11 at worst (sym20), dmey 2e-3

Pair = tuple[int, int]
"""Two bands by their index in a clip."""

_BLOCK = 8  # outputs per matrix product
_MAX_MULTIPLICATIONS = 4 * 65536 - 1  # per matrix product; for more OpenBLAS starts threads, which get in ours' way
_PIECE = 64  # samples summed in their own type
_STRIP = 3 * 512 * 512  # samples filtered at a time, so that what lies between two passes stays in the cache

_memory = threading.local()


@dataclass(frozen=True)
class Curve:
    """How the variance of one clip and band spreads over the components. All shares add up to 1."""

    detail: tuple[float, ...]
    """Relative variance of the three detail components of level 1 (finest), 2, ..., R together."""
    background: float
    """Relative variance of the coarse component at level R."""
    variance: float
    """Variance of the clip, DN squared; 0 for a constant clip, whose shares are NaN."""


@dataclass(frozen=True)
class Products:
    """Inner products of the components of a clip's bands: level 1..R details, then the coarse one."""

    own: np.ndarray
    """(bands, R + 1), float64: each band with itself, the energies of its components."""
    cross: np.ndarray
    """(pairs, R + 1), float64: the pairs that were asked for."""
    own_totals: np.ndarray
    """(bands,), float64: energy of each band less its mean."""
    cross_totals: np.ndarray
    """(pairs,), float64: inner products of the pairs, less their means."""
    coarse: np.ndarray
    """(bands, rows / 2^R, columns / 2^R): the coarse components at level R, up to a constant."""


def check_decomposition(wavelet: str, levels: int) -> None:
    """Raise SettingsError unless the wavelet is orthogonal and the levels are 1 to 8."""
    if wavelet not in limits.WAVELETS:
        if wavelet in pywt.wavelist(kind="discrete"):
            raise SettingsError(messages.WAVELET_NOT_ORTHOGONAL(wavelet=wavelet))
        raise SettingsError(messages.WAVELET_UNKNOWN(wavelet=wavelet))
    if not limits.MIN_LEVELS <= levels <= limits.MAX_LEVELS:
        raise SettingsError(
            messages.LEVELS_OUT_OF_RANGE(levels=levels, least=limits.MIN_LEVELS, most=limits.MAX_LEVELS)
        )


def clip_curves(
    bands: np.ndarray, wavelet: str, levels: int, luminance_weights: Sequence[float] = ()
) -> tuple[list[Curve], np.ndarray]:
    """Curves of all bands of a clip, and of its luminance when weights are given.

    ``bands`` is (bands, rows, columns) of any real type, finite, rows and columns multiples of
    ``2 ** levels``; ``luminance_weights`` has one weight for each of the first bands. Returns the
    curves, luminance last, and the coarse components at level R in the same order.

    The luminance has no transform of its own: the decomposition is linear, so its energies follow
    from the inner products of the bands (the homogeneity of Pyka 2009).

    Raises SettingsError for a wavelet that is not orthogonal or levels out of range.
    """
    weights = np.asarray(luminance_weights, dtype=np.float64)
    mixed = len(weights)
    pairs = list(combinations(range(mixed), 2))
    products = component_products(bands, wavelet, levels, pairs)
    pixels = bands[0].size
    curves = [_curve(own, total, pixels) for own, total in zip(products.own, products.own_totals)]
    if not mixed:
        return curves, products.coarse
    doubled = np.array([2 * weights[i] * weights[j] for i, j in pairs])
    own = weights**2 @ products.own[:mixed] + doubled @ products.cross
    bands_energy = weights**2 @ products.own_totals[:mixed]
    if own.min() <= MIN_CHAIN_SHARE * bands_energy:  # the bands cancel each other, or all are smooth
        mixture = np.tensordot(weights, bands[:mixed].astype(np.float64), axes=1)
        curves += clip_curves(mixture[np.newaxis], wavelet, levels)[0]
    else:
        curves.append(_curve(own, bands_energy + doubled @ products.cross_totals, pixels))
    luminance = np.tensordot(weights, products.coarse[:mixed], axes=1)
    return curves, np.concatenate([products.coarse, luminance[np.newaxis].astype(products.coarse.dtype)])


def component_products(bands: np.ndarray, wavelet: str, levels: int, pairs: Sequence[Pair] = ()) -> Products:
    """Energies of the components of every band, and inner products of the given pairs of bands.

    ``bands`` is (bands, rows, columns) of any real type, finite, rows and columns multiples of
    ``2 ** levels``. The bands may stem from different rasters: that gives the inner products of two
    clips, detail by detail.

    Raises SettingsError for a wavelet that is not orthogonal or levels out of range.
    """
    check_decomposition(wavelet, levels)
    filters = _filters(wavelet)
    if filters.orthonormal:
        single = (
            wavelet in FLOAT32_WAVELETS
            and bands[0].size >= MIN_FLOAT32_PIXELS
            and np.can_cast(bands.dtype, np.float32)  # of float64 and 32 bit integers it would drop digits
        )
        products = _chain_products(bands, filters, levels, pairs, np.float32 if single else np.float64)
        if (products.own > MIN_CHAIN_SHARE * products.own_totals[:, np.newaxis]).all():
            return products
    return _exact_products(bands, filters, levels, pairs)


def detail_components(bands: np.ndarray, wavelet: str, levels: int) -> Iterator[np.ndarray]:
    """The detail components of every band, level by level from the finest on.

    ``bands`` is (bands, rows, columns) of any real type, finite, rows and columns multiples of ``2 ** levels``.
    Each level is (3, bands, rows / 2^r, columns / 2^r): LH, HL and HH, each coefficient where PyWavelets has it,
    so that coefficient (i, j) belongs to the pixels from (2^r i, 2^r j) on. In float32 for 8 and 16 bit values,
    which is some three times as fast as PyWavelets, else in float64.

    Raises SettingsError for a wavelet that is not orthogonal or levels out of range.
    """
    check_decomposition(wavelet, levels)
    filters = _filters(wavelet)
    coarse = np.stack([_centred(band) for band in bands])
    if bands.dtype.kind in "iu" and bands.dtype.itemsize <= 2:
        coarse = coarse.astype(np.float32)
    low, high = (_scale(taps, coarse.dtype.type) for taps in (filters.low, filters.high))
    for level, (shift, (_, details)) in enumerate(zip(filters.shifts(levels), _levels(coarse, filters, levels))):
        components = np.stack([np.roll(detail, (shift, shift), axis=(1, 2)) for detail in details])
        for component, scale in zip(components, (low * high, low * high, high * high)):
            component /= component.dtype.type(scale * low ** (2 * level))
        yield components


def _curve(own: np.ndarray, total: float, pixels: int) -> Curve:
    shares = own / total if total > 0 else np.full(len(own), np.nan)
    return Curve(tuple(shares[:-1].tolist()), float(shares[-1]), float(total) / pixels)


def _chain_products(bands: np.ndarray, filters: _Filters, levels: int, pairs: Sequence[Pair], dtype: type) -> Products:
    """Products of the components from those of the coarse chain alone: what leaves it is detail."""
    wanted = _own_pairs(bands) + list(pairs)
    # An offset near the mean keeps the numbers small; what it misses by is taken out below, exactly. A whole
    # one keeps the squares of 8 bit values, and of 16 bit values near each other, free of any rounding.
    offsets = [float(band[::16].mean(dtype=np.float64)) for band in bands]
    if bands.dtype.kind in "iu":
        offsets = [float(round(offset)) for offset in offsets]
    chain, coarse, scale = [], bands, _scale(filters.low, dtype)
    for level, phase in enumerate(filters.phases(levels)):
        coarse, products = _halve(coarse, offsets, filters.low, phase, dtype, wanted)
        chain.append(products / scale ** (4 * level))
        offsets = [0.0] * len(bands)
    coarse = coarse.astype(np.float64) / scale ** (2 * levels)
    chain.append(_sums_of_products(coarse, wanted))
    # A constant c has the energy N c^2 at every level, all of it coarse.
    missed = coarse.mean(axis=(1, 2), dtype=np.float64) / 2**levels
    energies = np.array(chain) - [bands[0].size * missed[i] * missed[j] for i, j in wanted]
    components = np.append(energies[:-1] - energies[1:], energies[-1:], axis=0)
    return _products(components, energies[0], coarse)


def _exact_products(bands: np.ndarray, filters: _Filters, levels: int, pairs: Sequence[Pair]) -> Products:
    """Products of the components with every detail computed for itself, in float64.

    No component is the difference of two larger numbers here, so it holds for clips of any smoothness,
    and for PyWavelets' ``dmey``, which is orthogonal in name but only to 0.2 % in its coefficients.
    """
    wanted = _own_pairs(bands) + list(pairs)
    coarse = np.stack([_centred(band) for band in bands])
    totals = _sums_of_products(coarse, wanted)
    components = []
    for level in _levels(coarse, filters, levels):
        coarse, details = level
        components.append(sum(_sums_of_products(detail, wanted) for detail in details))
    components.append(_sums_of_products(coarse, wanted))
    return _products(np.array(components), totals, coarse)


def _levels(coarse: np.ndarray, filters: _Filters, levels: int) -> Iterator[tuple[np.ndarray, tuple[np.ndarray, ...]]]:
    """For each level the coarse component and the three details LH, HL, HH; all are (bands, rows, columns)."""
    for phase in filters.phases(levels):
        low, high = (_filtered(coarse, taps, phase).swapaxes(1, 2) for taps in (filters.low, filters.high))
        (coarse, vertical), (horizontal, diagonal) = (
            [_filtered(part, taps, phase).swapaxes(1, 2) for taps in (filters.low, filters.high)]
            for part in (low, high)
        )
        yield coarse, (horizontal, vertical, diagonal)


def _own_pairs(bands: np.ndarray) -> list[Pair]:
    return [(i, i) for i in range(len(bands))]


def _products(components: np.ndarray, totals: np.ndarray, coarse: np.ndarray) -> Products:
    """Parts (R + 1, bands + pairs) and (bands + pairs,) into the bands' own products and the pairs'."""
    bands = len(coarse)
    return Products(components.T[:bands], components.T[bands:], totals[:bands], totals[bands:], coarse)


def _halve(
    bands: np.ndarray, offsets: Sequence[float], taps: tuple[float, ...], phase: int, dtype: type, pairs: Sequence[Pair]
) -> tuple[np.ndarray, np.ndarray]:
    """One step of the chain: low-pass along both axes, every second sample kept.

    Returns the coarse components, (bands, rows / 2, columns / 2), and the pairs' inner products of
    the input less its offsets. Runs strip by strip, so that neither the converted samples nor those
    filtered along one axis only are ever held whole.
    """
    count, rows, columns = bands.shape
    overhang = len(taps) - 2 + phase
    coarse = np.empty((count, rows // 2, columns // 2), dtype=dtype)
    products = np.zeros(len(pairs))
    block_rows = 2 * _BLOCK
    strip = min(max(_STRIP // (count * columns * block_rows), 1) * block_rows, rows)
    buffer = _reused("samples", (count, strip + overhang, columns + overhang), dtype)
    low_buffer = _reused("low", (count, strip // 2, columns + overhang), dtype)
    for start in range(0, rows, strip):
        height = min(strip, rows - start)
        samples = buffer[:, : height + overhang]
        ahead = min(height + overhang, rows - start)
        samples[:, :ahead, :columns] = bands[:, start : start + ahead]
        samples[:, ahead:, :columns] = bands[:, np.arange(height + overhang - ahead) % rows]
        samples[:, :, columns:] = samples[:, :, np.arange(overhang) % columns]
        for band, offset in zip(samples, offsets):
            if offset:
                band -= dtype(offset)  # whole rows: numpy takes them in one piece, which is six times as fast
        products += _sums_of_products(samples[:, :height, :columns], pairs)
        low = _banded(samples, taps, phase, low_buffer[:, : height // 2])
        target = coarse[:, start // 2 : (start + height) // 2]
        _banded(low.swapaxes(1, 2), taps, phase, target.swapaxes(1, 2))
    return coarse, products


def _reused(name: str, shape: tuple[int, ...], dtype: type) -> np.ndarray:
    """An array in this thread's own memory, to be used until the next one of that name.

    Pages fresh from the system would cost half as much time as the arithmetic. It is some 5 MB in float32, however
    large the clip.
    """
    size = math.prod(shape) * np.dtype(dtype).itemsize
    memory = getattr(_memory, name, None)
    if memory is None or memory.size < size:
        memory = np.empty(size, dtype=np.uint8)
        setattr(_memory, name, memory)
    return memory[:size].view(dtype).reshape(shape)


def _filtered(x: np.ndarray, taps: tuple[float, ...], phase: int) -> np.ndarray:
    """Periodic filtering along axis 1, every second output kept: (n, rows, m) -> (n, rows / 2, m)."""
    rows = x.shape[1]
    return _banded(x[:, np.arange(rows + len(taps) - 2 + phase) % rows], taps, phase)


def _banded(x: np.ndarray, taps: tuple[float, ...], phase: int, out: np.ndarray | None = None) -> np.ndarray:
    """Filtering along axis 1 with every second output kept: (n, 2 k + L - 2 + phase, m) -> (n, k, m).

    A block of outputs is one small matrix product with a band of the filter matrix. The samples of
    neighbouring blocks overlap, so they are views into x and nothing is copied.
    """
    count, rows, columns = x.shape
    outputs = (rows - len(taps) + 2 - phase) // 2
    if out is None:
        out = np.empty((count, outputs, columns), dtype=x.dtype)
    body = outputs // _BLOCK * _BLOCK
    # Splitting axis 1 of a slice along axis 1 is still a view, so products land where they belong.
    targets = [(0, body, _BLOCK)] if body == outputs else [(0, body, _BLOCK), (body, outputs, outputs - body)]
    for first, last, block in targets:
        band = _band_matrix(taps, phase, block, x.dtype.type)
        blocks, width = (last - first) // block, max(1, _MAX_MULTIPLICATIONS // band.size)
        strides = (x.strides[0], 2 * block * x.strides[1], *x.strides[1:])
        samples = np.lib.stride_tricks.as_strided(
            x[:, 2 * first :], (count, blocks, band.shape[1], columns), strides, writeable=False
        )
        result = out[:, first:last].reshape(count, blocks, block, columns)
        for left in range(0, columns, width):
            part = np.s_[..., left : left + width]
            np.matmul(band, samples[part], out=result[part])
    return out


def _sums_of_products(x: np.ndarray, pairs: Sequence[Pair]) -> np.ndarray:
    """Inner products of pairs of bands of (bands, rows, columns), float64 whatever the type of x.

    A float32 dot product over a million pixels is off by per cents with some BLAS, and one over a row of 16 bit
    values by some 1e-6, so only short pieces of a row are summed in the type of x, and their sums in float64.
    """
    body = x.shape[2] // _PIECE * _PIECE
    parts = (x[..., :body].reshape(*x.shape[:2], -1, _PIECE), x[..., body:])
    return np.array(
        [sum(np.einsum("...i,...i->...", part[i], part[j]).sum(dtype=np.float64) for part in parts) for i, j in pairs]
    )


def _centred(band: np.ndarray) -> np.ndarray:
    """The band less its mean in float64; exactly zero for a constant band."""
    centred = band.astype(np.float64)
    centred -= centred[0, 0]
    return centred - centred.mean()


@dataclass(frozen=True)
class _Filters:
    """The two analysis filters of an orthogonal wavelet, taps in the order in which they meet the samples."""

    low: tuple[float, ...]
    high: tuple[float, ...]

    @property
    def orthonormal(self) -> bool:
        """Whether the low-pass is orthonormal to its even shifts as closely as the energy chain needs."""
        even_shifts = np.correlate(self.low, self.low, "full")[len(self.low) - 1 :: 2]
        even_shifts[0] -= 1
        return bool(np.abs(even_shifts).max() < MAX_FILTER_ERROR)

    def phases(self, levels: int) -> Iterator[int]:
        """For each level the sample, 0 or 1, at which its first output starts.

        PyWavelets starts output 0 at sample 1 - L / 2. A start of the same parity gives the same outputs
        from another point of the circle, which shifts what the next level has to start from.
        """
        return (phase for phase, _ in self._starts(levels))

    def shifts(self, levels: int) -> Iterator[int]:
        """For each level the output of PyWavelets that our first one is."""
        return (shift for _, shift in self._starts(levels))

    def _starts(self, levels: int) -> Iterator[tuple[int, int]]:
        shift = 0
        for _ in range(levels):
            start = 1 - len(self.low) // 2 - shift
            phase = start % 2
            shift = (phase - start) // 2
            yield phase, shift


@cache
def _filters(wavelet: str) -> _Filters:
    bank = pywt.Wavelet(wavelet)
    return _Filters(tuple(reversed(bank.dec_lo)), tuple(reversed(bank.dec_hi)))


@lru_cache(maxsize=1024)
def _band_matrix(taps: tuple[float, ...], phase: int, outputs: int, dtype: type) -> np.ndarray:
    """(outputs, 2 outputs + L - 2 + phase): row i holds the taps from sample 2 i + phase on."""
    matrix = np.zeros((outputs, 2 * outputs + len(taps) - 2 + phase), dtype=dtype)
    scaled = np.array(taps) * _scale(taps, dtype)
    for i in range(outputs):
        matrix[i, 2 * i + phase : 2 * i + phase + len(taps)] = scaled
    return matrix


@cache
def _scale(taps: tuple[float, ...], dtype: type) -> float:
    """The factor, 1 to 2, with which the taps lose least when they are rounded to ``dtype``.

    Rounded as they are, they would change the gain, and with it the background of every float32 curve, by up
    to 5e-8 a level and axis; multiplied by this factor first, by less than 5e-9 at any frequency.
    """
    if dtype is np.float64:
        return 1.0
    factors = 2 ** np.linspace(0, 1, 512, endpoint=False)[:, np.newaxis]
    rounded = (factors * taps).astype(dtype) / factors
    gains, exact_gains = (np.abs(np.fft.rfft(x, 256)) ** 2 for x in (rounded, np.array(taps)))
    return float(factors[np.abs(gains - exact_gains).max(axis=1).argmin(), 0])
