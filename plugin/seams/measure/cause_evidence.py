"""What was measured in a window -> the evidence that causes are judged by: texture, tones, misfit of two images."""
from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ...imagery.rasters import Raster, is_range_known, value_range
from ...imagery.shifts import Shift, shifted
from ...imagery.wavelets import placed_components
from .causes import MIN_COMPRESSED_DN, Misfit, SourceTone, Texture
from .following.boxes import in_squares
from .following.compression import vanished_share
from .limits import MIN_MISREGISTRATION_PX
from .seam_cells import UNKNOWN
from .tone import Tone

_BLOCK_PX = 16  # side of what detail is compared in: 64 coefficients in each direction
_FEWEST_BLOCKS = 12  # that follow one source for sure: fewer have no quantiles worth the name
_FEWEST_OF_SOURCE = 8  # blocks, before what comes over of one source alone is told
_WEAK, _STRONG, _STRONGEST = 0.3, 0.7, 0.9  # quantiles of the blocks' energies


def measure_texture(
    details: np.ndarray, labels: np.ndarray, sure: np.ndarray, mosaic: np.ndarray, expected: np.ndarray,
    unit_dn: float = 1.0,
) -> Texture | None:
    """From the finest details of the mosaic, of what is expected of it, and of the same unfiltered if that differs:
    (3, 2 or 3, rows / 2, columns / 2). ``labels``, ``sure`` and the planes of the mosaic and of what is
    expected of it (rows, columns).

    ``unit_dn``: how many grey values are one of 8 bit. None where too few blocks of 16 px follow one source for sure.
    """
    own, predicted, plain = details[:, 0], details[:, 1], details[:, -1]
    blocks = in_squares(np.where(sure, labels, UNKNOWN), _BLOCK_PX)
    # Whole rows first: a fifth of the time.
    first = blocks.min(axis=1).min(axis=2)
    whole = (first == blocks.max(axis=1).max(axis=2)) & (first != UNKNOWN)
    if np.count_nonzero(whole) < _FEWEST_BLOCKS:
        return None
    side = _BLOCK_PX // 2
    sums = {
        name: in_squares(np.einsum("dij,dij->ij", a, b), side).sum(axis=1).sum(axis=2, dtype=np.float64)[whole]
        for name, a, b in (
            ("mm", own, own), ("cc", predicted, predicted), ("mc", own, predicted), ("uu", plain, plain),
        )
    }
    left = np.clip(sums["mm"] - 2 * sums["mc"] + sums["cc"], 0, None) / (3 * side**2)
    weak, strong = np.quantile(sums["cc"], (_WEAK, _STRONG))
    noise = float(np.sqrt(left[sums["cc"] <= weak].mean()))
    loud = float(np.sqrt(left[sums["cc"] >= strong].mean()))
    transfer = _transfer(sums, np.ones(np.count_nonzero(whole), bool))
    strongest = _transfer(sums, sums["uu"] >= np.quantile(sums["uu"], _STRONGEST))
    large = [of for of in (first[whole] == i for i in np.unique(first[whole]))
             if np.count_nonzero(of) >= _FEWEST_OF_SOURCE] or [np.ones(np.count_nonzero(whole), bool)]
    of_sources, held = ([way(sums, of) for of in large] for way in (_transfer, _held))
    # What the sources' own compression left in them is none of the mosaic's.
    quantised = traces = 0.0
    if noise >= MIN_COMPRESSED_DN * unit_dn:
        traces = vanished_share(expected / unit_dn)
        quantised = vanished_share(mosaic / unit_dn) - traces
    return Texture(
        transfer, min(of_sources), max(of_sources), strongest, noise, loud / max(noise, 1e-6), quantised, traces,
        min(held), max(held),
    )


def _transfer(sums: Mapping[str, np.ndarray], where: np.ndarray) -> float:
    """Amplitude of the detail that comes over, wherever its pixels lie: the mosaic's share of what is expected, times
    what the filter that came over it leaves of the sources'."""
    mc, cc, uu = (float(sums[name][where].sum()) for name in ("mc", "cc", "uu"))
    return mc / max(float(np.sqrt(cc * uu)), 1e-9)


def _held(sums: Mapping[str, np.ndarray], where: np.ndarray) -> float:
    """Amplitude by the mosaic's own detail, of which the sources have what is not noise of theirs (errors in the
    variables, Fuller 1987)."""
    mm, mc, cc, uu = (float(sums[name][where].sum()) for name in ("mm", "mc", "cc", "uu"))
    return mm / max(mc, 1e-9) * float(np.sqrt(cc / max(uu, 1e-9)))


def measure_tones(
    mosaic: Raster,
    sources: Sequence[tuple[Raster, float, float, Tone | None, float | None]],
    values: np.ndarray,
) -> tuple[SourceTone, ...]:
    """Tones of the sources that are followed, each given by its raster, share of the pixels, mean grey value, tone of
    the judged band and shift of the colours. ``values``: grey values of the mosaic's judged band."""
    known = [one for one in sources if one[3] is not None]
    if not known:
        return ()
    own = _range(mosaic)
    span = own or 1.25 * float(np.subtract(*np.percentile(values, (95, 5)))) or 1.0
    middle = float(np.mean([mean for _, _, mean, _, _ in known]))
    found = []
    for raster, share, _, tone, colours in known:
        assert tone is not None
        factor = range_factor(mosaic, raster)
        gain = None if factor is None else tone.gain * factor
        found.append(SourceTone(share, gain, (tone.gain * middle + tone.bias) / span, tone.gamma, colours))
    return tuple(found)


def grey_unit(mosaic: Raster, values: np.ndarray) -> float:
    """How many grey values of a mosaic are one of 8 bit; ``values``: some of its own."""
    found = value_range(mosaic, float(values.max()))
    span = found[1] - found[0] if found else 1.25 * float(np.subtract(*np.percentile(values, (95, 5))))
    return max(span / 255, 1e-9)


def range_factor(mosaic: Raster, source: Raster) -> float | None:
    """The source's range of values over the mosaic's, 1 for one type of data; None where that is not known."""
    own, theirs = _range(mosaic), _range(source)
    return theirs / own if own and theirs else 1.0 if source.data_type == mosaic.data_type else None


def _range(raster: Raster) -> float | None:
    """How many grey values a raster could use, where that is known and not guessed."""
    if not is_range_known(raster):
        return None
    found = value_range(raster, 0.0)
    return None if found is None else found[1] - found[0]


_LOOK_PX = 256  # side of the part that is looked at, about the seam
_EDGE_PX = 16  # of it, which wavelets and the shift don't know
_FEWEST_PX = 1000  # about the seam: of fewer two correlations can't be told apart


def placed_misfit(between: Shift, first: Shift, second: Shift) -> tuple[float, float]:
    """How the first image lies to the right of and below the second as placed in the mosaic, px.

    ``between``: how the first lies on the second as they are given; ``first``, ``second``: how the mosaic lies on each
    of them where it follows it. What the mosaic has in common with both, or corrected, drops out.
    """
    return between.x + first.x - second.x, between.y + first.y - second.y


def misfit_of(
    misfit: tuple[float, float], shown: Mapping[int, np.ndarray], pair: tuple[int, int], seam: np.ndarray, wavelet: str
) -> Misfit:
    """What a misfit makes the finest detail of two images differ by.

    ``shown``: planes (rows, columns) as the mosaic shows its sources; ``seam``: (rows, columns) bool, the ground about
    the seam between the ``pair``. With rho the correlation of their finest details there, as placed and with the one
    moved to where the other is, a 50:50 feather keeps (1 + rho) / 2, so the share is that of 1 - rho.
    """
    length = float(np.hypot(*misfit))
    if length < MIN_MISREGISTRATION_PX or not seam.any():
        return Misfit(length, 0.0)
    place = _about(seam)
    first, second = (np.ascontiguousarray(shown[number][place]) for number in pair)
    moved = shifted(second, *misfit)
    (details,) = placed_components(np.stack([first, second, moved]), wavelet, 1)
    inner = np.s_[_EDGE_PX // 2 : -_EDGE_PX // 2]
    where = seam[place][::2, ::2][inner, inner]
    if np.count_nonzero(where) * 4 < _FEWEST_PX:
        return Misfit(length, 0.0)
    a, b, c = (details[:, k, inner, inner][:, where] for k in range(3))
    placed, aligned = _agreement(a, b), _agreement(a, c)
    return Misfit(length, float(np.clip((aligned - placed) / max(1 - placed, 1e-6), 0, 1)))


def _agreement(a: np.ndarray, b: np.ndarray) -> float:
    total = float(np.vdot(a, a) + np.vdot(b, b))
    return 2 * float(np.vdot(a, b)) / total if total > 0 else 1.0


def _about(seam: np.ndarray) -> tuple[slice, slice]:
    """The part, of an even number of rows and columns, in whose middle the seam is."""
    rows, columns = (
        _part(float(np.median(places)), length) for places, length in zip(np.nonzero(seam), seam.shape)
    )
    return rows, columns


def _part(middle: float, length: int) -> slice:
    side = min(_LOOK_PX, length)
    start = int(np.clip(middle - side / 2, 0, length - side)) // 2 * 2
    return slice(start, start + side)
