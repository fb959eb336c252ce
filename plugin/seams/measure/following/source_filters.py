"""What came over the sources of a mosaic, or over the mosaic as a whole, as linear filters: sharpening, blur,
resampling, a shift of parts of a pixel.

Fitted by least squares where one source is followed, they make of the sources what they would look like in this mosaic
if nothing had happened at its seams.
"""
from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ....imagery.shifts import shifted
from ....imagery.wavelets import correlated, product
from ..seam_cells import UNKNOWN, present
from .border import BORDER_PX
from .boxes import enlarged, in_squares, near_border
from .levelling import Levelled

REACH_PX = 2
"""The filter has 5 x 5 taps."""
UNTOUCHED = np.pad(np.ones((1, 1), np.float32), REACH_PX)
"""The filter that leaves an image as it is."""
FEWEST_PIXELS = 1500
"""Fewest pixels that a filter is learned from: two patches of a block, of which 28 x 28 px are known."""

_SIDE = 2 * REACH_PX + 1
_MOST_PIXELS = 12000
_AT_A_TIME = 384  # pixels whose samples stay in the cache, in float32; their sums are in float64
_RIDGE = 1e-5
_MARGIN_PX = 8  # of the clip: what is beyond it is not known


def fit_filter(
    image: np.ndarray, reference: np.ndarray, where: np.ndarray, gain: float | None = None
) -> np.ndarray | None:
    """Taps (5, 5) with which ``reference`` comes nearest to ``image``, both high-passed, (rows, columns).

    ``where``, (rows, columns) bool: pixels that count. ``gain``: what the taps add up to, where that is known. None
    where too few pixels count.
    """
    taps = fit_filters(image, [reference], where, gain)
    return None if taps is None else taps[0]


def fit_filters(
    image: np.ndarray, references: Sequence[np.ndarray], where: np.ndarray, gain: float | None = None
) -> np.ndarray | None:
    """Taps (references, 5, 5) as ``fit_filter`` has them, of several images that are added up; ``gain`` of each."""
    inside, inner = np.zeros(where.shape, bool), np.s_[_MARGIN_PX:-_MARGIN_PX, _MARGIN_PX:-_MARGIN_PX]
    inside[inner] = where[inner]
    places = np.flatnonzero(inside)
    if len(places) < FEWEST_PIXELS:
        return None
    places, reach = places[:: max(1, len(places) // _MOST_PIXELS)], np.arange(-REACH_PX, REACH_PX + 1)
    offsets = np.add.outer(reach * where.shape[1], reach).ravel()
    count = len(references) * _SIDE**2
    normal, right = np.zeros((count, count)), np.zeros(count)
    for start in range(0, len(places), _AT_A_TIME):
        part = places[start : start + _AT_A_TIME]
        samples = np.concatenate([np.take(plane, part[:, np.newaxis] + offsets) for plane in references], axis=1)
        normal += product(samples.T, samples)
        right += np.take(image, part) @ samples
    mean = float(np.trace(normal)) / count
    if mean <= 0:
        return None
    normal += _RIDGE * mean * np.eye(count)
    if gain is not None:  # high-passed images say nothing of it, so it is given with weight
        normal += mean * np.kron(np.eye(len(references)), np.ones((_SIDE**2, _SIDE**2)))
        right += mean * gain
    return np.linalg.solve(normal, right).reshape(-1, _SIDE, _SIDE).astype(np.float32)


def filtered(plane: np.ndarray, taps: np.ndarray) -> np.ndarray:
    """A plane (rows, columns) float32 through the filter."""
    return correlated(plane, taps)


MIN_FILTERED_GAIN = 0.002  # of the fine detail that a filter has to explain more to be applied
MAX_LEFT_UNFILTERED = 0.005  # of the fine detail: with no more left over, labels are as sure without a filter
MIN_SINGLE_GAIN = 0.02  # of one source's detail, that a filter of its own has to explain more than one for all
MOST_LEFT_OF_BEST = 0.5  # of what is left over of the ground that is explained best, by a filter that is learned there
LEAST_MOVED_PX = 0.05  # what lies nearer lies where it was

_FEWEST_SAMPLES = 300
_EVERY = 4  # rows and columns apart are looked at to see whether a filter explains more
_ROUNDS = 3
_SQUARE_PX = 32  # of which whole ones are of one image or another
_LEAST_OF_SQUARE = 0.4  # of its pixels that count
SAMPLE = np.s_[::_EVERY, ::_EVERY]
"""Index of the sampled rows and columns of a plane, every fourth."""


@dataclass(frozen=True, eq=False)
class Filters:
    """What makes of the sources what the mosaic shows of them."""

    taps: Mapping[int, np.ndarray]
    """Taps (5, 5) of each source that is followed; empty where nothing was done to them."""
    came_over_cuts: bool
    """Whether it was done to the mosaic, its cuts included, and not to the sources before."""

    def placed(self, source: int, plane: np.ndarray) -> np.ndarray:
        """A source's plane as sharp as it was, only moved: what came over a whole mosaic can't be told from what came
        over its sources, but where they lie in it is what they were mixed by."""
        if not self.taps or self.came_over_cuts:
            return plane
        taps = self.taps[source]
        at, total = np.arange(-REACH_PX, REACH_PX + 1), float(taps.sum())
        x, y = (-float(taps.sum(axis=axis) @ at) / total for axis in (0, 1))
        return plane if max(abs(x), abs(y)) < LEAST_MOVED_PX else shifted(plane, x, y)

    def applied(self, source: int, plane: np.ndarray) -> np.ndarray:
        """A source's plane as the mosaic shows it."""
        return filtered(plane, self.taps[source]) if self.taps else plane


UNFILTERED = Filters({}, False)
"""Nothing was done to any source."""


@dataclass(frozen=True, eq=False)
class Learned:
    """What came over a mosaic, as far as that is known of more ground than there is in a part of it."""

    taps: Mapping[int, np.ndarray]
    """The filter (5, 5) of each source that anything is known of; ``UNTOUCHED`` where nothing came over it."""
    left_over: Mapping[int, float]
    """Share of the mosaic's finest detail that is left over where it was learned, of the same sources; 1 of those that
    no ground is sure to follow: what they come nearest to the mosaic by may be made of others."""

    @property
    def is_plain(self) -> bool:
        """Whether nothing came over any."""
        return all((kernel == UNTOUCHED).all() for kernel in self.taps.values())

    def applied(self, source: int, plane: np.ndarray) -> np.ndarray:
        """A source's plane as the mosaic shows it; as it is where nothing is known."""
        taps = self.taps.get(source, UNTOUCHED)
        return plane if (taps == UNTOUCHED).all() else filtered(plane, taps)


def known_filters(taps: Mapping[int, np.ndarray], sources: Sequence[int]) -> Filters | None:
    """Filters by the places of these sources, from the taps of those of which they are known.

    Where all are known and alike they are one, which came over the mosaic with its cuts; sources of which nothing is
    known have a plain one. None where nothing is known that would serve them.
    """
    known = {place: taps.get(i, UNTOUCHED) for place, i in enumerate(sources)}
    if all((kernel == UNTOUCHED).all() for kernel in known.values()):
        return UNFILTERED if all(i in taps for i in sources) else None
    first, *others = known.values()
    alike = MIN_SINGLE_GAIN * np.square(first).sum()
    if others and all(np.square(other - first).sum() <= alike for other in others):
        return Filters(dict.fromkeys(range(len(sources)), first), True)
    return Filters(known, False)


def find_filters(
    mosaic: np.ndarray, fine: Mapping[int, np.ndarray], in_tone: Mapping[int, Levelled], labels: np.ndarray,
    sure: np.ndarray,
) -> Filters:
    """What has to be done to the sources in the mosaic's tones."""
    # The gain is even enough to be taken for the same within the reach of a high-pass.
    def reference(place: slice | tuple[slice, ...]) -> np.ndarray:
        toned = {i: source.gain[place] * fine[i][place] for i, source in in_tone.items()}
        return cut_of(mosaic[place], toned, labels[place])

    if _is_a_multiple(mosaic[SAMPLE], reference(SAMPLE), labels[SAMPLE], sure[SAMPLE]):
        return UNFILTERED
    return _fitted_filters(mosaic, reference(np.s_[:]), labels, sure)


def through_filter(mosaic: np.ndarray, source: np.ndarray, where: np.ndarray) -> np.ndarray:
    """A source's fine detail as the mosaic shows it."""
    sample = where[SAMPLE]
    if _is_a_multiple(mosaic[SAMPLE], source[SAMPLE], sample.astype(np.uint8), sample, MAX_LEFT_UNFILTERED):
        return source
    taps = fit_filter(mosaic, source, where)
    if taps is None:
        return source
    made = filtered(source, taps)
    shown = made if _explains_more(mosaic, source, made, where) else source
    return _of_best_ground(mosaic, source, shown, where)


def _of_best_ground(mosaic: np.ndarray, source: np.ndarray, shown: np.ndarray, where: np.ndarray) -> np.ndarray:
    """``shown``, the source through the filter of all its ground; through that of the half that is explained best where
    that tells that the rest is of another image: it explains this half far better (least trimmed squares, Rousseeuw
    1984)."""
    best = _best_explained(mosaic, source, where)
    for _ in range(_ROUNDS):
        taps = fit_filter(mosaic, source, best)
        if taps is None:
            break
        made = filtered(source, taps)
        observed, before, after = _chosen(best[SAMPLE], *(plane[SAMPLE] for plane in (mosaic, shown, made)))
        if np.square(observed - after).sum() > MOST_LEFT_OF_BEST * np.square(observed - before).sum():
            break
        shown, best = made, _best_explained(mosaic, made, where)
    return shown


def best_filter(
    mosaic: np.ndarray, source: np.ndarray, where: np.ndarray, side_px: int = _SQUARE_PX
) -> np.ndarray | None:
    """Taps (5, 5) of a source by the half of a part that it explains best, square by square (least trimmed squares,
    Rousseeuw 1984). Images of one scene are more like each other than like a mosaic that something came over, and the
    sharpest would be followed everywhere, if they were compared as they are. None where too few pixels count, or where
    it explains no more of the other half, as of an image that was warped from place to place.

    ``mosaic``, ``source``: high-passed, (rows, columns); ``where``, (rows, columns) bool: the part.
    """
    taps, shown = None, source
    for _ in range(_ROUNDS):
        best = _best_explained(mosaic, shown, where, side_px)
        fitted = fit_filter(mosaic, source, best)
        if fitted is None:
            return None
        taps, shown = fitted, filtered(source, fitted)
    return taps if _explains_more(mosaic, source, shown, where & ~best) else None


def _best_explained(
    mosaic: np.ndarray, shown: np.ndarray, where: np.ndarray, side_px: int = _SQUARE_PX
) -> np.ndarray:
    """The half of a part, (rows, columns) bool, that a source is correlated with best, square by square."""
    inside = np.float32(where)
    m, s = mosaic * inside, shown * inside
    area, energy, source, shared = (
        in_squares(a * b, side_px).sum(axis=(1, 3)) for a, b in ((inside, inside), (m, m), (s, s), (m, s))
    )
    known = (area >= _LEAST_OF_SQUARE * side_px**2) & (energy > 0)
    if not known.any():
        return where
    fit = np.where(known, shared * np.abs(shared) / np.maximum(energy * source, 1e-9), -np.inf)
    return where & enlarged(fit >= np.median(fit[known]), side_px, where.shape)


def cut_of(mosaic: np.ndarray, planes: Mapping[int, np.ndarray], labels: np.ndarray) -> np.ndarray:
    """Each pixel from the plane that its label names; the mosaic's own where none is."""
    if not planes:
        return mosaic.copy()
    first, *others = sorted(planes, key=lambda i: -np.count_nonzero(labels == i))
    made = planes[first].copy()
    for i in others:
        np.copyto(made, planes[i], where=labels == i)
    unknown = labels == UNKNOWN
    if unknown.any():
        np.copyto(made, mosaic, where=unknown)
    return made


def _fitted_filters(fine: np.ndarray, reference: np.ndarray, labels: np.ndarray, sure: np.ndarray) -> Filters:
    """One filter for all sources, or one for each where that explains more; none where none is needed."""
    taps = fit_filter(fine, reference, sure, gain=1.0)
    if taps is None:
        return UNFILTERED
    common = filtered(reference, taps)
    if not _explains_more(fine, reference, common, sure):
        return UNFILTERED
    numbers = present(labels)
    if len(numbers) > 1:
        parts = {i: sure & (labels == i) for i in numbers}
        fitted = {i: fit_filter(fine, reference, part, gain=1.0) for i, part in parts.items()}
        single = {i: kernel for i, kernel in fitted.items() if kernel is not None}
        if any(
            _explains_more(fine, common, filtered(reference, kernel), parts[i], MIN_SINGLE_GAIN)
            for i, kernel in single.items()
        ):
            return Filters({i: single.get(i, taps) for i in numbers}, False)
    return Filters(dict.fromkeys(numbers, taps), True)


def _is_a_multiple(
    mosaic: np.ndarray, plain: np.ndarray, labels: np.ndarray, where: np.ndarray, most: float = MIN_FILTERED_GAIN
) -> bool:
    """Whether so little of the mosaic is left over by a multiple of the plain image that no filter is called for;
    samples of all of them.

    Beside a border, which is known to a few pixels only, nothing can be told of that.
    """
    parts = np.where(where, labels, np.uint8(UNKNOWN))
    inside = (parts != UNKNOWN) & ~near_border(parts, -(-BORDER_PX // _EVERY))
    observed, before = _chosen(inside, mosaic, plain)
    return len(observed) > _FEWEST_SAMPLES and _left_by_multiple(observed, before) <= most * float(observed @ observed)


def _explains_more(
    mosaic: np.ndarray, plain: np.ndarray, made: np.ndarray, where: np.ndarray, least: float = MIN_FILTERED_GAIN
) -> bool:
    """Whether less of the mosaic is left over by a filtered image than by a mere multiple of the plain one."""
    observed, before, after = _chosen(where[SAMPLE], *(image[SAMPLE] for image in (mosaic, plain, made)))
    rest = observed - after
    return float(rest @ rest) < _left_by_multiple(observed, before) - least * float(observed @ observed)


def _left_by_multiple(mosaic: np.ndarray, plain: np.ndarray) -> float:
    rest = mosaic - float(mosaic @ plain) / max(float(plain @ plain), 1e-12) * plain
    return float(rest @ rest)


def _chosen(where: np.ndarray, *images: np.ndarray) -> list[np.ndarray]:
    places = np.flatnonzero(where)
    return [image.ravel()[places].astype(np.float64) for image in images]


_WAVES_PX = 5.0, 2.5  # the longer is as long as 5 taps tell
_LEAST_RESPONSE = 0.2  # with less of the shorter they were blurred away, by whatever is wider than the taps


def filter_power(taps: Iterable[np.ndarray]) -> float | None:
    """The power p with which filters leave r^p of waves of 5 px where they leave r of those of 2.5 px, the least of
    all, in any direction; 0 where one takes nothing, or nearly all; None without any. Gaussian blur has 0.25,
    interpolation less; contrast that is taken evenly has 1."""
    powers = []
    for kernel in taps:
        longer, shorter = (_response(kernel, wave) for wave in _WAVES_PX)
        is_usable = bool(((shorter >= _LEAST_RESPONSE) & (shorter < 1)).all())
        powers.append(float((np.log(np.minimum(longer, 1)) / np.log(shorter)).min()) if is_usable else 0.0)
    return min(powers, default=None)


def _response(taps: np.ndarray, wave_px: float) -> np.ndarray:
    """Amplitude that taps (5, 5) leave of waves in eight directions, (8,)."""
    at = np.arange(-REACH_PX, REACH_PX + 1)
    angles = np.pi / 8 * np.arange(8)
    down, across = (2 * np.pi / wave_px * np.outer(turn(angles), at) for turn in (np.sin, np.cos))
    response = np.einsum("di,ij,dj->d", np.exp(1j * down), taps, np.exp(1j * across))
    return np.asarray(np.abs(response) / abs(taps.sum()))
