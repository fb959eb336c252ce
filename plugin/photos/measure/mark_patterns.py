"""What marks look like in a photo that is reduced: figures of a few sizes, or the user's cut-out."""
from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from . import limits
from .mark_templates import CutOut, MarkKind, MarkShape, draw
from .photo_views import Place, block_means

COARSE_SIZES_PX = (10.0, 12.0, 14.3, 17.0)  # of a mark at each level: an octave in steps of 1.19


@dataclass(frozen=True, eq=False)
class Pattern:
    """One template at one level: its pixels, and where its centre lies in them."""

    pixels: np.ndarray
    centre: Place
    """Column and row, pixel centres at .5."""
    shape: MarkShape | None
    """None for a user's template; in pixels of the level."""


Patterns = Callable[[float, Place], Iterator[Pattern]]
"""The templates for pixels that are so many of the photo's wide, and a place in the frame in mm (for wedges)."""


def drawn_patterns(kinds: Sequence[MarkShape]) -> Patterns:
    """Drawn marks: every shape in the sizes of one octave. Wedges lie in line with the middle of the frame."""

    def patterns(factor: float, place: Place) -> Iterator[Pattern]:
        for shape in kinds:
            for size in COARSE_SIZES_PX:
                sized = wedge_to_middle(replace(shape, size=size), place)
                pixels = draw(sized)
                yield Pattern(pixels, (pixels.shape[1] / 2, pixels.shape[0] / 2), sized)

    return patterns


def cut_out_patterns(template: CutOut) -> Patterns:
    """The user's template, reduced to each level; none where too little of it is left."""

    def patterns(factor: float, place: Place) -> Iterator[Pattern]:
        step = int(factor)
        rows, columns = (side // step for side in template.pixels.shape)
        if min(rows, columns) < limits.MIN_TEMPLATE_PX:
            return
        yield Pattern(block_means(template.pixels, step), (template.centre[0] / step, template.centre[1] / step), None)

    return patterns


def wedge_to_middle(shape: MarkShape, place: Place) -> MarkShape:
    """Wedges in line with the middle of the frame, along an axis or a diagonal; other shapes as they are."""
    if shape.kind is not MarkKind.WEDGE:
        return shape
    towards = math.degrees(math.atan2(-place[1], -place[0])) - (45 if shape.diagonal else 0)
    return replace(shape, angle=90.0 * round(towards / 90))
