"""The figure of a photo's marks: the drawn mark whose measures correlate best with all of them."""
from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np

from .. import limits
from ..correlation import CorrelatedImage
from ..mark_patterns import wedge_to_middle
from ..mark_templates import MarkKind, MarkShape, draw
from ..measuring_marks import MarkWindow
from ..photo_views import Place, block_means

REFINING_SIZES = (0.87, 0.93, 1.0, 1.07, 1.15)  # against the coarse size, which is good to 10 %
REFINING_ROUNDS = 6


def refine_shape(
    windows: Mapping[str, MarkWindow],
    places: Mapping[str, Place],
    begin: MarkShape,
    sign: int,
    angle: float,
    finest: float,
) -> tuple[MarkShape, float]:
    """The drawn mark that correlates best with a photo's marks, in pixels of the photo, and its median correlation.

    ``begin`` has a size good to 15 %; ``places`` are the marks in the frame, mm, and ``angle`` is the frame's rotation
    in degrees. A mark wider than ``finest`` px is reduced to about that, which is faster.
    """
    step = max(1, round(begin.size / finest))
    images = {mark: CorrelatedImage(sign * block_means(window.pixels, step)) for mark, window in windows.items()}

    def fitness(shape: MarkShape) -> float:
        found = []
        for mark, image in images.items():
            values = image.correlate(draw(turned_with_frame(shape, places[mark], angle)))
            found.append(float(values.max()) if values.size else -1.0)
        return float(np.median(found))

    shapes = enumerate(_first_shapes(begin.scaled(1 / step)))
    tried = sorted(((fitness(one), number, one) for number, one in shapes), reverse=True)
    best, _, shape = tried[0]
    for _ in range(REFINING_ROUNDS):
        before = best
        for other in _similar_shapes(shape):
            value = fitness(other)
            if value > best:
                best, shape = value, other
        if best - before < 1e-3:
            break
    return shape.scaled(step), best


def without_plane(window: MarkWindow) -> MarkWindow:
    """A window less the plane that fits it best."""
    y, x = np.indices(window.pixels.shape, dtype=np.float64)
    terms = np.column_stack([x.ravel(), y.ravel(), np.ones(x.size)])
    plane = np.linalg.lstsq(terms, window.pixels.ravel().astype(np.float64), rcond=None)[0]
    return replace(window, pixels=window.pixels - (terms @ plane).reshape(x.shape))


def turned_with_frame(shape: MarkShape, place: Place, angle: float) -> MarkShape:
    """A shape as it stands in a frame turned by an angle: a wedge looks to the middle."""
    turned = wedge_to_middle(shape, place)
    return replace(turned, angle=turned.angle + angle)


def _first_shapes(shape: MarkShape) -> Iterator[MarkShape]:
    for factor in REFINING_SIZES:
        sized = replace(shape, size=shape.size * factor, softness=0.8)
        if shape.kind in (MarkKind.DOT, MarkKind.WEDGE):
            yield sized
            continue
        for width in (0.06, 0.12):
            yield replace(sized, width=width)
            if shape.kind is MarkKind.RING_WITH_CROSS:
                yield replace(sized, width=width, reach=1.6)


def _similar_shapes(shape: MarkShape) -> Iterator[MarkShape]:
    for factor in (0.95, 1.05, 0.98, 1.02):
        yield replace(shape, size=shape.size * factor)
    for factor in (0.8, 1.25):
        yield replace(shape, softness=min(max(shape.softness * factor, limits.PIXEL_SOFTNESS), shape.size / 4))
        yield replace(shape, width=min(max(shape.width * factor, 0.02), 0.3))
    if shape.kind in (MarkKind.CROSS, MarkKind.RING_WITH_CROSS):
        yield replace(shape, interrupted=not shape.interrupted)
    if shape.kind is MarkKind.RING_WITH_CROSS:
        for reach in (1.0, 1.4, 1.8):
            yield replace(shape, reach=reach)
