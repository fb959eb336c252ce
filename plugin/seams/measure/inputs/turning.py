"""Whether a raster that is like the mosaic everywhere was made from it, or is an orthoimage on well registered ground.

Such images are like each other everywhere, so that likeness alone tells nothing. What was made from the mosaic turns
with it from one orthoimage to the other; an orthoimage is less like it where another one beats it.
"""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from itertools import combinations

import numpy as np

from .mosaic_copies import MEDIAN_LIKE

BEATEN_BY = 0.05  # correlation with the mosaic: an eighth of it is what noise does to 64 x 64 px
TURNING_BY = 0.05
# Where it is beaten an orthoimage lacks 3 times or more of what it lacks elsewhere (demonstration block, PackO,
# Brighton), copies by JPEG 75 twice at most, as that depends on the ground alone.
LEAST_DROP = 2.5
FEWEST_BEATEN = 2  # places; one may be by chance
LEAST_AGREEING = 0.95  # of the places where two others differ: copies 0.97 and more, orthoimages 0.9 and less

SLIGHTLY_DISTINCT = 0.1
DISTINCT = 0.3  # correlation with one above that with another: it is that one's image, and no neighbour on even ground


MOST_EVEN = 1.5  # two orthoimages of a pair lack about as much where the mosaic follows the other
ROUNDING = 0.01  # of a correlation: what sharpening or bits change
MANY_BEATEN = 8  # pairs of others at such places
LEAST_FOLLOWED = 0.4  # of a difference between two others that the mosaic shows: what turns with it shows as much
LEAST_FOLLOWING = 0.85  # of those pairs


class Origin(Enum):
    """What a raster that is like the mosaic everywhere is."""

    SOURCE = "source"
    MOSAIC = "mosaic"
    UNKNOWN = "unknown"
    """The others do not say: nothing of the mosaic turns there, or there are no others."""


@dataclass(frozen=True)
class Rival:
    """Another raster at one place."""

    like_mosaic: float
    """Correlation of its fine detail with the mosaic's."""
    like_one: float
    """With that of the raster in question."""


@dataclass(frozen=True)
class PlaceLikeness:
    """A raster at one place, and the others there by name."""

    like: float
    """Correlation of its fine detail with the mosaic's."""
    rivals: Mapping[str, Rival]


def origin_of(comparisons: Sequence[PlaceLikeness], is_whole: bool) -> Origin:
    """By its places, with those rivals that are not even more like the mosaic, as other copies are.

    One that covers the whole mosaic is a copy of it more often than not; of others the drop is asked first.
    """
    found = [one for one in _without_copies(comparisons) if one.rivals]
    if not found:
        return Origin.UNKNOWN
    best = np.array([max(rival.like_mosaic for rival in one.rivals.values()) for one in found])
    likes = np.array([one.like for one in found])
    beaten = best - likes > BEATEN_BY
    if is_whole and _turns_where_beaten([one for one, is_beaten in zip(found, beaten) if is_beaten]):
        return Origin.MOSAIC
    if min(beaten.sum(), (~beaten).sum()) >= FEWEST_BEATEN:
        lacks_there, lacks_elsewhere = (float(np.median(1 - likes[which])) for which in (beaten, ~beaten))
        if lacks_there > LEAST_DROP * lacks_elsewhere:
            return Origin.SOURCE
    return Origin.MOSAIC if _turns(found) else Origin.UNKNOWN


def put_together_from(comparisons: Sequence[PlaceLikeness], by: float = DISTINCT) -> tuple[str, str] | None:
    """Two others that a raster was put together from: plainly the one's image here, and the second's there."""
    found = _without_copies(comparisons)
    for first, second in combinations(sorted({name for one in found for name in one.rivals}), 2):
        both = [(one.rivals[first], one.rivals[second]) for one in found if {first, second} <= one.rivals.keys()]
        more = np.array([a.like_one - b.like_one for a, b in both])
        is_like = np.array([max(a.like_one, b.like_one) for a, b in both]) >= MEDIAN_LIKE
        if (is_like & (more > by)).any() and (is_like & (more < -by)).any():
            return first, second
    return None


def _turns(comparisons: Sequence[PlaceLikeness]) -> bool:
    """Whether the mosaic follows one of two others here and the second there, and the raster does so with it."""
    names = sorted({name for one in comparisons for name in one.rivals})
    agreeing: list[bool] = []
    is_turning = False
    for first, second in combinations(names, 2):
        both = [(one.rivals[first], one.rivals[second]) for one in comparisons if {first, second} <= one.rivals.keys()]
        ours = np.array([b.like_mosaic - a.like_mosaic for a, b in both])
        theirs = np.array([b.like_one - a.like_one for a, b in both])
        plain = np.abs(ours) > TURNING_BY
        agreeing += (ours * theirs > 0)[plain].tolist()
        is_turning = is_turning or bool((ours > TURNING_BY).any() and (ours < -TURNING_BY).any())
    return is_turning and float(np.mean(agreeing)) >= LEAST_AGREEING


def _turns_where_beaten(comparisons: Sequence[PlaceLikeness]) -> bool:
    """Whether it follows the mosaic even where others are more like that, as a copy with loss does."""
    followed: list[bool] = []
    for one in comparisons:
        for first, second in combinations(one.rivals.values(), 2):
            ours = first.like_mosaic - second.like_mosaic
            if abs(ours) > TURNING_BY:
                followed.append((first.like_one - second.like_one) / ours > LEAST_FOLLOWED)
    return len(followed) >= MANY_BEATEN and float(np.mean(followed)) >= LEAST_FOLLOWING and _turns(comparisons)


def _without_copies(comparisons: Sequence[PlaceLikeness]) -> list[PlaceLikeness]:
    """Without rivals that lack plainly less of the mosaic than the raster does, each at its worst of their places."""
    names = {name for one in comparisons for name in one.rivals}
    kept = set()
    for name in names:
        shared = [one for one in comparisons if name in one.rivals]
        least = min(one.rivals[name].like_mosaic for one in shared)
        if 1 - min(one.like for one in shared) <= MOST_EVEN * (1 - least) + ROUNDING:
            kept.add(name)
    return [
        PlaceLikeness(one.like, {name: rival for name, rival in one.rivals.items() if name in kept})
        for one in comparisons
    ]
