"""The demonstration's block through its own mosaicking line: tones balanced, pixels resampled source by source.

Its sources lie on grids and places of their own, so everything is there that a real line does before it cuts.
"""
from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from demo.block import GAP_FILLER, TIES, Layout, photograph
from demo.camera import Orthoimage
from demo.canvas import PIXEL, Extent
from demo.mosaic import Tone, Weights, assemble, balance

from .detail import luminance_of
from .figures import figure, median, percent
from .known_windows import MARGIN_PX, MIN_SECOND_SHARE, KnownWindow
from .outcomes import HARDLY_LOST
from .production import Made
from .readings import Reading, read
from .seam_makings import Mixed, Part, seam_distance
from .timing import print_table
from .true_profile import truth_of

EXTENT: Extent = (330.0, 264.0)
SEED = 2010
FEATHERS_PX = {"cut hard": 0.0, "feather 10 px": 10.0, "feather 33 px": 33.0}
"""Linear, full widths; that beside the gap-filler is always wide."""
STEP_PX = 128
SOUND = 0.999
"""Where more is truly kept, nothing but tones and interpolation touched the mosaic."""
SOUND_CAUSES = ("none", "resampled", "balanced")


@dataclass(frozen=True, eq=False)
class Line:
    """The images, and the seams that a mosaic of them is cut along."""

    images: Sequence[Orthoimage]
    layout: Layout

    @cached_property
    def tones(self) -> dict[str, Tone]:
        return balance(self.images)

    @cached_property
    def whole(self) -> list[np.ndarray]:
        """Luminance of each image as the mosaic takes it over, where it has it."""
        return [
            luminance_of(assemble([image], self.tones, TIES, _everywhere(image), self.layout.extent_m))
            for image in self.images
        ]

    def mosaic(self, feather_px: float) -> Mosaic:
        """Cut and feathered."""
        layout = replace(self.layout, feather_m=max(feather_px, 0.01) * PIXEL / self.layout.scale)
        bands = assemble(self.images, self.tones, TIES, layout.weights, layout.extent_m)
        y, x = ((np.arange(size) + np.float32(0.5)) * np.float32(PIXEL) for size in bands.shape[1:])
        shares = layout.weights(x[np.newaxis], y[:, np.newaxis])
        return Mosaic(self, bands, np.stack([shares[image.name] for image in self.images]))


@dataclass(frozen=True, eq=False)
class Mosaic:
    """What the line made, and of what."""

    line: Line
    bands: np.ndarray
    weights: np.ndarray
    """(images, rows, columns)."""

    @cached_property
    def labels(self) -> np.ndarray:
        return np.asarray(self.weights.argmax(axis=0).astype(np.uint8))

    def windows(self, side: int, in_east: bool) -> Iterator[tuple[int, int]]:
        """Upper left corners of those of one half that a seam runs through the middle of."""
        rows, columns = self.labels.shape
        middle = columns // 2
        first, last = (middle, columns - side - MARGIN_PX) if in_east else (MARGIN_PX, middle - side)
        for row in range(MARGIN_PX, rows - side - MARGIN_PX + 1, STEP_PX):
            for column in range(first, last + 1, STEP_PX):
                inside = self.labels[row : row + side, column : column + side]
                core = inside[side // 4 : -side // 4, side // 4 : -side // 4]
                shares = np.sort(np.bincount(inside.ravel(), minlength=2)) / inside.size
                if shares[-2] >= MIN_SECOND_SHARE and core.min() != core.max():
                    yield row, column

    def read(self, row: int, column: int, side: int) -> MadeWindow:
        """What the plugin says of one, and what is true."""
        frame = side + 2 * MARGIN_PX
        place = slice(row - MARGIN_PX, row - MARGIN_PX + frame), slice(column - MARGIN_PX, column - MARGIN_PX + frame)
        given = [_given(image, place) for image in self.line.images]
        used = [number for number, (bands, _) in enumerate(given) if bands.any()]
        sources, valid = [given[k][0] for k in used], [given[k][0].any(axis=0) for k in used]
        labels = np.searchsorted(used, self.labels[place]).astype(np.uint8)
        window = KnownWindow("block", 0, False, PIXEL, side, tuple(sources), tuple(valid), labels)
        planes = tuple(self.line.whole[k][place] for k in used)
        parts = tuple(Part(plane, self.weights[k][place]) for plane, k in zip(planes, used))
        bands = self.bands[(slice(None), *place)]
        mixed = Mixed(bands, planes, parts, labels, tuple(range(len(used))))
        truth = truth_of(mixed, seam_distance(labels), window.middle)
        made = Made(bands, bands, tuple(sources), tuple(valid), tuple(given[k][1] for k in used), truth.near,
                    frozenset(), mixed.foreign, frozenset())
        names = {self.line.images[k].name for k in np.unique(self.labels[place][window.middle])}
        return MadeWindow(side, truth.near, GAP_FILLER in names, read(made, window))


@dataclass(frozen=True)
class MadeWindow:
    """One window of a mosaic."""

    side: int
    truth: float
    has_gap_filler: bool
    """Whether an image that was never tied takes part: it lies 2 px off the others."""
    reading: Reading

    @property
    def is_right(self) -> bool:
        """Whether the main cause is: interpolation took from the whole window, a feather where it left less."""
        said = self.reading.cause
        if self.truth >= SOUND:
            return said in SOUND_CAUSES
        if self.truth >= HARDLY_LOST and said in SOUND_CAUSES:
            return True
        return said in ("feathering", "resampled") or (said == "misregistration" and self.has_gap_filler)


def _everywhere(image: Orthoimage) -> Weights:
    """All of an image, over its box on the ground."""
    bottom, right = (start + size * PIXEL for start, size in zip((image.top, image.left), image.pixels.shape[1:]))

    def weights(x: np.ndarray, y: np.ndarray) -> dict[str, np.ndarray]:
        inside = (x > image.left) & (x < right) & (y > image.top) & (y < bottom)
        return {image.name: inside.astype(np.float32)}

    return weights


def _given(image: Orthoimage, place: tuple[slice, slice]) -> tuple[np.ndarray, tuple[float, float]]:
    """An image's own pixels over a frame of the mosaic, 0 where it has none, and how its grid lies beside it."""
    top, left = (-value / PIXEL for value in (image.top, image.left))
    row, column = place[0].start + round(top), place[1].start + round(left)
    frame = place[0].stop - place[0].start
    bands = np.zeros((3, frame, frame), np.uint8)
    first, start = max(row, 0), max(column, 0)
    found = image.pixels[:, first : max(row + frame, 0), start : max(column + frame, 0)]
    bands[:, first - row : first - row + found.shape[1], start - column : start - column + found.shape[2]] = found
    return bands, (round(top) - top, round(left) - left)


def print_block(title: str, sides: Sequence[int], in_east: bool, count: int) -> None:
    """Make the mosaics and read up to ``count`` windows of each side, spread over one half."""
    line = Line(*photograph(EXTENT, SEED))
    rows = []
    for name, feather_px in FEATHERS_PX.items():
        mosaic = line.mosaic(feather_px)
        for side in sides:
            corners = list(mosaic.windows(side, in_east))
            chosen = corners[:: max(len(corners) // count, 1)][:count]
            found = [mosaic.read(row, column, side) for row, column in chosen]
            for kind, own in _kinds(name, found):
                rows.append([f"{kind}, {side} px", *_cells(own)])
    head = ["seam, side", "windows", "verdict %", "truth", "kept_1", "kept_1 - truth", "interval right %",
            "significant", "main right %", "main causes"]
    print_table(f"The block by its own line, {title}", head, rows,
                "Resampled and balanced image by image. Main cause right: none, resampled or balanced in a hard cut,\n"
                "  else resampled or the feather; misregistration as well where the gap-filler takes part.")


def _kinds(name: str, found: Sequence[MadeWindow]) -> Iterator[tuple[str, list[MadeWindow]]]:
    """The seams of the gap-filler for themselves."""
    for kind, with_filler in ((name, False), (f"{name}, with the gap-filler's wide feather", True)):
        own = [one for one in found if one.has_gap_filler is with_filler]
        if own:
            yield kind, own


def _cells(own: Sequence[MadeWindow]) -> list[str]:
    measured = [one for one in own if not np.isnan(one.reading.kept)]
    main = Counter(one.reading.cause for one in own)
    return [
        str(len(own)),
        percent(one.reading.has_verdict for one in own),
        figure(median(one.truth for one in own)),
        figure(median(one.reading.kept for one in measured)),
        figure(median(one.reading.kept - one.truth for one in measured)),
        percent(one.reading.low <= one.truth <= one.reading.high for one in measured),
        str(sum(one.reading.verdict == "significant" for one in own)),
        percent(one.is_right for one in own),
        ", ".join(f"{cause} {number}" for cause, number in main.most_common(3)),
    ]
