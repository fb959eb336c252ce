"""What was measured in a window -> the evidence that causes are judged by: texture, tones, misfit of two images."""
from __future__ import annotations

import numpy as np

from ....imagery.rasters import Raster, is_range_known, value_range
from ....imagery.shifts import Shift, shifted
from ....imagery.wavelets import placed_components
from ..following.boxes import in_squares
from ..following.compression import vanished_share
from ..limits import MIN_MISREGISTRATION_PX
from ..seam_cells import UNKNOWN
from .causes import MIN_COMPRESSED_DN, Misfit, Texture

_BLOCK_PX = 16  # side of what detail is compared in: 64 coefficients in each direction
_FEWEST_BLOCKS = 12  # that follow one source for sure: fewer have no quantiles worth the name
_WEAK, _STRONG, _STRONGEST = 0.3, 0.7, 0.9  # quantiles of the blocks' energies


def measure_texture(
    details: np.ndarray, labels: np.ndarray, mosaic: np.ndarray, expected: np.ndarray, unit_dn: float = 1.0
) -> Texture | None:
    """Texture where labels (rows, columns) name the source that is followed for sure, ``UNKNOWN`` elsewhere.

    From the finest details of the mosaic, of what is expected of it, and of the same unfiltered if that differs:
    (3, 2 or 3, rows / 2, columns / 2); and the planes (rows, columns) of the mosaic and of what is expected.
    ``unit_dn``: how many grey values are one of 8 bit. None where too few blocks of 16 px follow one source.
    """
    blocks = in_squares(labels, _BLOCK_PX)
    # Whole rows first: a fifth of the time.
    sources = blocks.min(axis=1).min(axis=2)
    whole = (sources == blocks.max(axis=1).max(axis=2)) & (sources != UNKNOWN)
    if np.count_nonzero(whole) < _FEWEST_BLOCKS:
        return None
    observed, filtered, plain = details[:, 0], details[:, 1], details[:, -1]
    side, followed = _BLOCK_PX // 2, sources[whole]
    sums = np.stack([
        in_squares(np.einsum("dij,dij->ij", a, b), side).sum(axis=1).sum(axis=2, dtype=np.float64)[whole]
        for a, b in ((observed, observed), (observed, filtered), (filtered, filtered), (plain, plain))
    ])
    mm, mc, cc, uu = sums
    left_over = np.clip(mm - 2 * mc + cc, 0, None) / (3 * side**2)
    weak, strong = np.quantile(cc, (_WEAK, _STRONG))
    noise, loud = (float(np.sqrt(left_over[where].mean())) for where in (cc <= weak, cc >= strong))
    of_sources = [sums[:, followed == i] for i in np.unique(followed)]
    of_sources = [blocks for blocks in of_sources if blocks.shape[1] >= _FEWEST_BLOCKS] or [sums]
    transfers = [_transfer(blocks) for blocks in of_sources]
    # What the sources' own compression left in them is none of the mosaic's.
    traces = quantised = 0.0
    if noise >= MIN_COMPRESSED_DN * unit_dn:
        traces = vanished_share(expected / unit_dn)
        quantised = vanished_share(mosaic / unit_dn) - traces
    return Texture(
        _transfer(sums), min(transfers), max(transfers), _transfer(sums[:, uu >= np.quantile(uu, _STRONGEST)]), noise,
        loud / max(noise, 1e-6), quantised, traces, min(map(_held, of_sources)),
    )


def _transfer(sums: np.ndarray) -> float:
    """Amplitude of the detail that comes over, wherever its pixels lie: the mosaic's share of what is expected, times
    what the filter that came over it leaves of the sources'. ``sums``: (4, blocks), of mm, mc, cc and uu."""
    _, mc, cc, uu = sums.sum(axis=1).tolist()
    return float(mc / max(np.sqrt(cc * uu), 1e-9))


def _held(sums: np.ndarray) -> float:
    """Amplitude by the mosaic's own detail, of which the sources have what is not noise of theirs (errors in the
    variables, Fuller 1987)."""
    mm, mc, cc, uu = sums.sum(axis=1).tolist()
    return float(mm / max(mc, 1e-9) * np.sqrt(cc / max(uu, 1e-9)))


def grey_unit(mosaic: Raster, values: np.ndarray) -> float:
    """How many grey values of a mosaic are one of 8 bit; ``values``: some of its own."""
    ends = value_range(mosaic, float(values.max()))
    span = ends[1] - ends[0] if ends else 1.25 * float(np.subtract(*np.percentile(values, (95, 5))))
    return max(span / 255, 1e-9)


def range_factor(mosaic: Raster, source: Raster) -> float | None:
    """The source's range of values over the mosaic's, 1 for one type of data; None where that is not known."""
    mosaic_range, source_range = (
        value_range(plane, 0.0) if is_range_known(plane) else None for plane in (mosaic, source)
    )
    if mosaic_range and source_range:
        return (source_range[1] - source_range[0]) / (mosaic_range[1] - mosaic_range[0])
    return 1.0 if source.data_type == mosaic.data_type else None


_LOOK_SAMPLES = 128  # side of the part that is looked at, about the seam: 256 px
_EDGE_SAMPLES = 8  # of it, which wavelets and the shift don't know
_FEWEST_SAMPLES = 250  # about the seam: of fewer two correlations can't be told apart


def placed_misfit(between: Shift, first: Shift, second: Shift) -> tuple[float, float]:
    """How the first image lies to the right of and below the second as placed in the mosaic, px.

    ``between``: how the first lies on the second as they are given; ``first``, ``second``: how the mosaic lies on each
    of them where it follows it. What the mosaic has in common with both, or corrected, drops out.
    """
    return between.x + first.x - second.x, between.y + first.y - second.y


def misfit_of(
    misfit: tuple[float, float], first: np.ndarray, second: np.ndarray, seam: np.ndarray, wavelet: str
) -> Misfit:
    """What a misfit makes the finest detail of two images differ by.

    ``first``, ``second``: planes (rows, columns) as the mosaic shows them; ``seam``: (rows / 2, columns / 2) bool, the
    ground about the seam between them. With rho the correlation of their finest details there, as placed and with the
    one moved to where the other is, a 50:50 feather keeps (1 + rho) / 2, so the share is that of 1 - rho.
    """
    length = float(np.hypot(*misfit))
    if length < MIN_MISREGISTRATION_PX or not seam.any():
        return Misfit(length, 0.0)
    starts = [
        int(np.clip(np.median(places) - _LOOK_SAMPLES / 2, 0, max(size - _LOOK_SAMPLES, 0)))
        for places, size in zip(np.nonzero(seam), seam.shape)
    ]
    rows, columns = (slice(2 * start, 2 * (start + _LOOK_SAMPLES)) for start in starts)
    first, second = (np.ascontiguousarray(plane[rows, columns]) for plane in (first, second))
    (details,) = placed_components(np.stack([first, second, shifted(second, *misfit)]), wavelet, 1)
    inner, (row, column) = np.s_[_EDGE_SAMPLES:-_EDGE_SAMPLES], starts
    where = seam[row : row + _LOOK_SAMPLES, column : column + _LOOK_SAMPLES][inner, inner]
    if np.count_nonzero(where) < _FEWEST_SAMPLES:
        return Misfit(length, 0.0)
    a, b, c = (details[:, k, inner, inner][:, where] for k in range(3))
    placed, aligned = _agreement(a, b), _agreement(a, c)
    return Misfit(length, float(np.clip((aligned - placed) / max(1 - placed, 1e-6), 0, 1)))


def _agreement(a: np.ndarray, b: np.ndarray) -> float:
    total = float(np.vdot(a, a) + np.vdot(b, b))
    return 2 * float(np.vdot(a, b)) / total if total > 0 else 1.0
