"""Mosaics and parts of mosaics among the sources: they follow several of the others, each in its part, and no true
orthoimage does. They would explain the mosaic where its orthoimages do not, and hide losses."""
from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterator, Sequence
from contextlib import suppress
from itertools import product
from typing import NamedTuple

import numpy as np

from ....imagery.errors import RasterError
from ....imagery.raster_pool import RasterPool
from ....imagery.rasters import Raster
from ..source_images import Source
from .grey_values import grey_factor
from .mosaic_copies import FEWEST, FEWEST_TURNS, LEAST_BOTH, LEAST_CONTENT, LITTLE, NEARLY_ALL, Likeness, Look, plainly

_MOSAIC = -1  # its number among the sources' in a place
FEWEST_FOLLOWED = 2  # sources, each of which is followed here and beaten there
ALL_LACKING = 0.95  # of the mosaic's detail, in each of so many places: an image 7 px aside, a map
FEWEST_UNLIKE = 64


class _ComparedPatch(NamedTuple):
    """A small patch in which rasters were compared with each other."""

    numbers: tuple[int, ...]
    """Numbers of the mosaic and the sources that have pixels there."""
    lacking: np.ndarray
    """Share of the detail of each that each other one does not show, square; nan where they share too few pixels."""

    def others(self, number: int, aside: Collection[int]) -> dict[int, float]:
        """What each other source that is not put aside lacks of a raster, by number."""
        if number not in self.numbers:
            return {}
        row = self.lacking[self.numbers.index(number)].tolist()
        apart = {number, _MOSAIC, *aside}
        return {n: one for n, one in zip(self.numbers, row) if n not in apart and not np.isnan(one)}


def mosaics_among(
    mosaic: Raster, sources: Sequence[Source], known: dict[int, Likeness], is_cancelled: Callable[[], bool]
) -> dict[int, Likeness]:
    """What sources are to the mosaic that were made of it or of the other sources.

    Sources are compared with each other, in four parts of up to 144 places.

    Parameters
    ----------
    mosaic
        The mosaic.
    sources
        Rasters that may be its sources.
    known
        What some are to the mosaic, by number; its copies take no part.
    is_cancelled
        Whether nobody waits for it any more.

    Returns
    -------
    dict of int to Likeness
        What is known; MOSAIC for other mosaics and for parts of one; where nothing more can be told, EQUAL for those
        that are the mosaic itself wherever they lie, and TURNING for those that are another source here and not there;
        UNLIKE for those that show nothing of the mosaic anywhere.
    """
    found = dict(known)
    with RasterPool() as pool:
        look = Look(mosaic, 1, sources, pool)
        factor = grey_factor(mosaic)
        places = [one for k in range(len(look.places)) if not is_cancelled() for one in _quarters(look, k, factor)]
    aside = {n for n, one in known.items() if one is Likeness.COPY}
    scores = {n: 1 for n in range(len(sources)) if n not in aside}
    # An orthoimage that several mosaics were made of follows these, each in its part, but in fewer places than they do.
    while scores and not is_cancelled():
        scores = {n: score for n in scores if n not in aside and (score := _followed_places(places, n, aside))}
        if scores:
            likely = max(scores, key=lambda n: scores[n])
            found[likely] = Likeness.MOSAIC
            aside.add(likely)
    others = [n for n in range(len(sources)) if n not in aside]
    lacking = {n: _lacking_of_mosaic(places, n) for n in others}
    equal = {n for n, ones in lacking.items() if len(ones) >= FEWEST and max(ones) <= NEARLY_ALL}
    for number, ones in lacking.items():
        if number in equal:
            found.setdefault(number, Likeness.EQUAL)
        elif _turns(places, number, aside | equal):
            found[number] = Likeness.TURNING
        elif len(ones) >= FEWEST_UNLIKE and min(ones) > ALL_LACKING:
            found.setdefault(number, Likeness.UNLIKE)
    return found


def _quarters(look: Look, k: int, factor: float) -> Iterator[_ComparedPatch]:
    """A patch of the look in four parts, with the factor that makes grey values those of 8 bit."""
    place = look.places[k]
    patches = {_MOSAIC: (place.values, place.valid)}
    for number in look.over[k]:
        with suppress(RasterError):  # the scan says so where it needs it
            pixels = look.source(number, k)
            if pixels is not None:
                patches[number] = pixels
    values = np.stack([one[0] for one, _ in patches.values()]) * factor
    valid = np.stack([where for _, where in patches.values()])
    middle = [length // 2 for length in valid.shape[1:]]
    for rows, columns in product(*((slice(None, half), slice(half, None)) for half in middle)):
        inside = (slice(None), rows, columns)
        yield _ComparedPatch(tuple(patches), _lacking_of_each_other(values[inside], valid[inside]))


def _lacking_of_each_other(values: np.ndarray, valid: np.ndarray) -> np.ndarray:
    """Share of the detail of each patch, of all of them (patches, rows, columns) and where they are valid, that each
    other one does not show; nan where both have little or are hardly valid together."""
    count = len(values)
    has = np.concatenate([
        (valid[:, :, 1:] & valid[:, :, :-1]).reshape(count, -1), (valid[:, 1:] & valid[:, :-1]).reshape(count, -1)
    ], axis=1)
    with np.errstate(invalid="ignore", over="ignore"):
        steps = np.concatenate([np.diff(values, axis=axis).reshape(count, -1) for axis in (2, 1)], axis=1)
        steps = np.where(has, steps, 0).astype(np.float32)
        both = has.astype(np.float32) @ has.T.astype(np.float32)
        squares = np.square(steps) @ has.T.astype(np.float32)  # of each, where each other one has pixels
        like = steps @ steps.T / np.sqrt(np.maximum(squares * squares.T, np.finfo(np.float32).tiny))
    is_known = (both > LEAST_BOTH * has.shape[1]) & (np.maximum(squares, squares.T) > LEAST_CONTENT * both)
    return np.where(is_known, 1 - np.maximum(like, 0) ** 2, np.nan)


def _lacking_of_mosaic(places: Sequence[_ComparedPatch], number: int) -> list[float]:
    """What a source lacks of the mosaic wherever they were compared."""
    ones = [place.lacking[0, place.numbers.index(number)] for place in places if number in place.numbers]
    return [float(one) for one in ones if not np.isnan(one)]


def _followed_places(places: Sequence[_ComparedPatch], number: int, aside: Collection[int]) -> int:
    """In how many places a raster follows sources that it follows here and not there; 0 for an orthoimage."""
    followed: list[set[int]] = []
    beaten: Counter[int] = Counter()
    for place in places:
        others = place.others(number, aside)
        least = min(others.values(), default=np.inf)
        lost = [n for n, more in others.items() if plainly(more, least) and more > least + LITTLE]
        if least <= LITTLE and lost:
            followed.append({n for n, more in others.items() if not plainly(more, least)})
            beaten.update(lost)
    turning = {n for found in followed for n in found if beaten[n]}
    count = sum(bool(turning & found) for found in followed)
    return count if len(turning) >= FEWEST_FOLLOWED and count >= FEWEST else 0


def _turns(places: Sequence[_ComparedPatch], number: int, aside: Collection[int]) -> bool:
    """Whether a raster and another one are the same here and not there: one of the two is a mosaic."""
    others = [place.others(number, aside) for place in places]
    same = Counter(n for found in others for n, one in found.items() if one <= NEARLY_ALL)
    unlike = Counter(n for found in others for n, one in found.items() if one > LITTLE)
    return any(min(count, unlike[n]) >= FEWEST_TURNS for n, count in same.items())
