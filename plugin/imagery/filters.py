"""The wavelets' filters over pixels: one step of the decomposition, and small kernels, as products of matrices.

A step filters along both axes, periodically or with mirrored edges, and keeps every second output. A block of outputs
is one small product with a band of the filter matrix (``FilterPair``). It runs strip by strip, so that what lies
between two passes stays in the cache and the converted samples are never held whole.

In QGIS on Debian and Ubuntu numpy's products go to GSL's CBLAS, which libqgis_core brings along and which takes ten to
twenty times as long; SciPy's BLAS is reached there by other names.
"""
from __future__ import annotations

import ctypes
import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache, lru_cache

import numpy as np
import pywt
from numpy.lib.stride_tricks import sliding_window_view

BLOCK = 8
"""Outputs of each filter per matrix product."""


@dataclass(frozen=True)
class FilterPair:
    """Low-pass and high-pass, taps in the order in which they meet the samples."""

    low: tuple[float, ...]
    high: tuple[float, ...]

    @property
    def margin(self) -> int:
        """Samples before the first of two, and after the last, that their outputs need: there PyWavelets has them."""
        return len(self.low) // 2 - 1

    def delays_px(self, level: int) -> tuple[float, float]:
        """How far behind its own pixels lies what a coefficient of a level comes from, by the energy of the taps: along
        an axis that the low-pass and one that the high-pass came over last."""
        energies = (np.square(taps) for taps in (self.low, self.high))
        low, high = (float(taps @ np.arange(len(taps)) / taps.sum()) - (len(taps) - 1) / 2 for taps in energies)
        before = low * (2 ** (level - 1) - 1)
        return before + 2 ** (level - 1) * low, before + 2 ** (level - 1) * high


@cache
def filter_pair(wavelet: str) -> FilterPair:
    """Filters of a wavelet of PyWavelets."""
    bank = pywt.Wavelet(wavelet)
    return FilterPair(tuple(reversed(bank.dec_lo)), tuple(reversed(bank.dec_hi)))


@lru_cache(maxsize=1024)
def _band_matrix(taps: tuple[float, ...], factor: float, dtype: type) -> np.ndarray:
    """(BLOCK, 2 BLOCK + L - 2): row i holds the taps from sample 2 i on, times a factor."""
    matrix = np.zeros((BLOCK, 2 * BLOCK + len(taps) - 2), dtype=dtype)
    for i in range(BLOCK):
        matrix[i, 2 * i : 2 * i + len(taps)] = np.array(taps) * factor
    return matrix


@cache
def scale(taps: tuple[float, ...], dtype: type) -> float:
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


Pair = tuple[int, int]
"""Two bands by their index in a clip."""

MAX_MULTIPLICATIONS = 4 * 65536 - 1  # per matrix product; for more OpenBLAS starts threads, which get in ours' way
_PIECE = 64  # samples summed in their own type
_AT_A_TIME = 512 * 512  # samples of a band


def halved(
    bands: np.ndarray, offsets: Sequence[float], filters: FilterPair, dtype: type, pairs: Sequence[Pair]
) -> tuple[np.ndarray, np.ndarray]:
    """The coarse components of bands (bands, rows, columns) less their offsets, times twice the low-pass's scale.

    Returns them, (bands, rows / 2, columns / 2), and the pairs' inner products of the input less its offsets.
    """
    count, rows, columns = bands.shape
    matrix, margin = _band_matrix(filters.low, scale(filters.low, dtype), dtype), filters.margin
    coarse = np.empty((count, *(_whole(length) // 2 for length in (rows, columns))), dtype)
    products = np.zeros(len(pairs))
    for start, samples in _strips(bands, offsets, margin, dtype):
        height = samples.shape[1] - 2 * margin
        inner = samples[:, margin : margin + min(height, rows - start), margin : margin + columns]
        products += sums_of_products(inner, pairs)
        low = np.empty((count, height // 2, samples.shape[2]), dtype)
        _banded(samples, matrix, low.reshape(count, -1, BLOCK, samples.shape[2]))
        target = coarse[:, start // 2 : (start + height) // 2].swapaxes(1, 2)
        _banded(low.swapaxes(1, 2), matrix, target.reshape(count, -1, BLOCK, height // 2))
    return coarse[:, : rows // 2, : columns // 2], products


def split(
    bands: np.ndarray, offsets: Sequence[float], filters: FilterPair, dtype: type, mirrored: bool = False
) -> np.ndarray:
    """LL, LH, HL and HH of bands (bands, rows, columns) less their offsets, (4, bands, rows / 2, columns / 2).

    Beyond their edges the bands go on periodically, or ``mirrored``.
    """
    count, rows, columns = bands.shape
    matrix, margin = np.concatenate([_band_matrix(t, 1.0, dtype) for t in (filters.low, filters.high)]), filters.margin
    parts = np.empty((2, 2, count, *(_whole(length) // 2 for length in (rows, columns))), dtype)
    for band in range(count):
        alone = slice(band, band + 1)
        for start, samples in _strips(bands[alone], offsets[alone], margin, dtype, mirrored):
            height, across = samples.shape[1] - 2 * margin, parts.shape[-1] // BLOCK
            # Of each block of rows both filters' outputs, then the same of each block of columns.
            down = np.empty((1, height, samples.shape[2]), dtype)
            _banded(samples, matrix, down.reshape(1, -1, 2 * BLOCK, samples.shape[2]))
            both = np.empty((1, across, height, 2 * BLOCK), dtype)
            _banded(down.swapaxes(1, 2), matrix, both.swapaxes(2, 3))
            target = parts[:, :, band, start // 2 : (start + height) // 2].reshape(2, 2, -1, BLOCK, across, BLOCK)
            target[...] = both.reshape(across, -1, 2, BLOCK, 2, BLOCK).transpose(4, 2, 1, 3, 0, 5)
    return parts.reshape(4, *parts.shape[2:])[..., : rows // 2, : columns // 2]


def sums_of_products(x: np.ndarray, pairs: Sequence[Pair]) -> np.ndarray:
    """Inner products of pairs of bands of (bands, rows, columns), float64 whatever the type of x.

    A float32 dot product over a million pixels is off by per cents with some BLAS, and one over a row of 16 bit
    values by some 1e-6, so only short pieces of a row are summed in the type of x, and their sums in float64.
    """
    body = x.shape[2] // _PIECE * _PIECE
    parts = (x[..., :body].reshape(*x.shape[:2], -1, _PIECE), x[..., body:])
    return np.array(
        [sum(np.einsum("...i,...i->...", part[i], part[j]).sum(dtype=np.float64) for part in parts) for i, j in pairs]
    )


def _whole(length: int) -> int:
    """Samples rounded up to whole blocks of outputs."""
    return -(-length // (2 * BLOCK)) * 2 * BLOCK


def _strips(
    bands: np.ndarray, offsets: Sequence[float], margin: int, dtype: type, mirrored: bool = False
) -> Iterator[tuple[int, np.ndarray]]:
    """First row and samples (bands, rows, columns) of each strip with a margin all around, periodic or ``mirrored``.

    Rounded up to whole blocks within the margins. The next strip takes the same memory.
    """
    count, rows, columns = bands.shape
    most = max(_AT_A_TIME // (columns * 2 * BLOCK), 1) * 2 * BLOCK
    inside = slice(margin, margin + columns)
    buffer = np.empty((count, min(most, _whole(rows)) + 2 * margin, _whole(columns) + 2 * margin), dtype)
    left, right = (
        _continued(beyond, columns, mirrored)
        for beyond in (np.arange(-margin, 0), np.arange(columns, buffer.shape[2] - margin))
    )
    for start in range(0, rows, most):
        first, last = start - margin, start + _whole(min(most, rows - start)) + margin
        samples = buffer[:, : last - first]
        held = slice(max(first, 0), min(last, rows))
        samples[:, held.start - first : held.stop - first, inside] = bands[:, held]
        for beyond in (np.arange(first, held.start), np.arange(held.stop, last)):
            if len(beyond):
                samples[:, beyond - first, inside] = bands[:, _continued(beyond, rows, mirrored)]
        samples[:, :, : inside.start] = samples[:, :, margin + left]
        samples[:, :, inside.stop :] = samples[:, :, margin + right]
        for band, offset in zip(samples, offsets):
            if offset:
                band -= dtype(offset)  # whole rows: numpy takes them in one piece, which is six times as fast
        yield start, samples


def _continued(beyond: np.ndarray, length: int, mirrored: bool) -> np.ndarray:
    """The samples of an axis that stand at places beyond its ends."""
    if not mirrored:
        return np.asarray(beyond % length)
    beyond = beyond % (2 * length)
    return np.minimum(beyond, 2 * length - 1 - beyond)


def _banded(x: np.ndarray, matrix: np.ndarray, out: np.ndarray, step: int = 2 * BLOCK) -> None:
    """Filtering along axis 1: (n, samples, m) -> ``out`` (n, blocks, outputs of a block, m); from one block to the next
    it is ``step`` samples.

    The samples of neighbouring blocks overlap, so they are views into x and nothing is copied.
    """
    strides = (x.strides[0], step * x.strides[1], *x.strides[1:])
    shape = (x.shape[0], out.shape[1], matrix.shape[1], x.shape[2])
    samples = np.lib.stride_tricks.as_strided(x, shape, strides, writeable=False)
    width = max(1, MAX_MULTIPLICATIONS // matrix.size)
    for left in range(0, x.shape[2], width):
        part = np.s_[..., left : left + width]
        multiply(matrix, samples[part], out[part])


def product(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """Product of two matrices of one type, (n, k) and (k, m) -> (n, m)."""
    made = np.empty((first.shape[0], second.shape[1]), np.result_type(first, second))
    multiply(first, second, made)
    return made


def multiply(first: np.ndarray, second: np.ndarray, out: np.ndarray) -> None:
    """Products of a matrix (n, k) with one or many, (..., k, m), into ``out`` (..., n, m), all float32 or float64."""
    if not numpy_has_plain_products():
        np.matmul(first, second, out=out)
    elif second.ndim > 2:
        for matrix, made in zip(second, out):
            multiply(first, matrix, made)
    else:
        from scipy.linalg import blas  # not where nobody needs it

        gemm = blas.sgemm if out.dtype == np.float32 else blas.dgemm
        out[...] = gemm(1.0, second.T, first.T).T


@cache
def numpy_has_plain_products() -> bool:
    """Whether this process was started with GSL's CBLAS, whose names go before those that numpy asks for."""
    try:
        libraries = ctypes.CDLL(None), ctypes.CDLL("libgslcblas.so.0", os.RTLD_NOLOAD)
        process, gsl = (ctypes.cast(library.cblas_sgemm, ctypes.c_void_p).value for library in libraries)
    except (AttributeError, OSError, TypeError):  # none of these names, as on other systems and in plain Python
        return False
    return process == gsl


_BLOCK = 4  # rows of outputs per matrix product
_STRIP = 64  # rows worked on at a time, so that what lies between two steps stays in the cache


def correlated(plane: np.ndarray, taps: np.ndarray) -> np.ndarray:
    """A plane (rows, columns) float32 through a kernel of odd sides; its edges are repeated.

    As ``scipy.ndimage.correlate`` with the mode ``nearest``, in a sixth of its time for 5 x 5 taps.
    """
    (rows, columns), (down, across) = plane.shape, taps.shape
    matrix = np.zeros((_BLOCK, _BLOCK + down - 1, across), np.float32)
    for i in range(_BLOCK):
        matrix[i, i : i + down] = taps
    made = np.empty((-(-rows // _BLOCK) * _BLOCK, columns), np.float32)
    below = down - 1 - down // 2 + len(made) - rows
    padded = np.pad(plane, ((down // 2, below), (across // 2, across - 1 - across // 2)), "edge")
    for start in range(0, rows, _STRIP):
        target = made[start : start + _STRIP]
        needed = padded[start : start + len(target) + down - 1]
        # Each row once for each column of taps: a block of rows is one matrix then.
        beside = sliding_window_view(needed, columns, axis=1).reshape(1, -1, columns)
        _banded(beside, matrix.reshape(_BLOCK, -1), target.reshape(1, -1, _BLOCK, columns), _BLOCK * across)
    return made[:rows]
