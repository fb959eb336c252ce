"""The pixels of one block, read once: what mosaic and sources show of it, in the band that is judged; and how much of
all blocks could be read."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Callable

import numpy as np

from ....imagery.clips import Clip, read_clip
from ....imagery.errors import Message, NotCoveredError, RasterError
from ....imagery.grids import PixelWindow
from ....imagery.limits import LUMINANCE, measured_bands
from ....imagery.raster_pool import open_raster
from ....imagery.rasters import Raster, RasterRef
from ....imagery.wavelets import judged_plane
from .. import messages
from ..compared_image import ComparedImage, clip_factor

_Pick = Callable[[np.ndarray], np.ndarray]
"""Picks of pixels (..., rows, columns) those that are wanted, as an image of their own."""

JUDGED = ("judged",)
"""The band of such an image."""
MOST_HELD = 8
"""Sources of a block that are held in memory; of others only what is asked for is read."""


@dataclass(frozen=True, eq=False)
class Planes:
    """A part of a block in the band that is judged."""

    mosaic: ComparedImage
    """Image of one plane, as its sources."""
    sources: dict[int, ComparedImage]
    """Sources by number."""
    resampled: frozenset[int]
    """Sources that had to be warped to the mosaic's grid."""


class BlockPixels:
    """The clips of one window of the mosaic, and parts of them; what lies beyond is read anew."""

    def __init__(
        self, mosaic: Raster, refs: Sequence[RasterRef], window: PixelWindow, margin_px: int | None = 0
    ) -> None:
        """Reads the mosaic and the sources that have pixels there, and ``margin_px`` around; None: parts on demand.

        A source that can't be read is told in ``notices`` and takes no part. Raises NotCoveredError where the mosaic
        has no pixels, RasterError where it can't be read.
        """
        self.window = window
        self.notices: list[Message] = []
        self.has_sources: bool | None = None
        """Whether any orthoimage was read; None where none has pixels here."""
        self.mosaic, self._refs, self._band = mosaic, refs, mosaic.judged_band
        self._absent: set[int] = set()
        self._margin = margin_px or 0
        self._around = window.with_margin(self._margin)
        self._held = None if margin_px is None else self._read(self._around, range(min(len(refs), MOST_HELD)))

    @property
    def held(self) -> tuple[Clip, dict[int, Clip]]:
        """All that was read of the mosaic, and of sources by their numbers, of a block that was read as a whole."""
        assert self._held is not None
        return self._held

    @property
    def numbers(self) -> tuple[int, ...]:
        """Numbers of the sources that may have pixels here."""
        return tuple(i for i in range(len(self._refs)) if i not in self._absent)

    @property
    def valid(self) -> np.ndarray | None:
        """(rows, columns) bool: where the mosaic has pixels; None: everywhere."""
        valid, first = None if self._held is None else self._held[0].valid, self._margin
        return None if valid is None else valid[first : first + self.window.height, first : first + self.window.width]

    def patches(self, rows: np.ndarray, columns: np.ndarray, side: int) -> Planes:
        """Squares of ``side`` px that begin at these rows and columns of the block, side by side as one image, of a
        block that was read as a whole."""
        down, across = (rows + self._margin).tolist(), (columns + self._margin).tolist()

        def pick(pixels: np.ndarray) -> np.ndarray:  # by arrays of indices it takes ten times as long
            rows = (pixels[..., row : row + side, :] for row in down)
            strips = [[strip[..., column : column + side] for column in across] for strip in rows]
            return np.concatenate([np.concatenate(strip, axis=-1) for strip in strips], axis=-2)

        planes = self._planes(*self.held, pick)
        for number in range(MOST_HELD, len(self._refs)):  # one after the other, so that memory does not grow with them
            more = self._planes(self.held[0], self._read_sources(self._around, [number]), pick)
            planes = Planes(planes.mosaic, {**planes.sources, **more.sources}, planes.resampled | more.resampled)
        return planes

    def strip_of_patches(self, rows: np.ndarray, columns: np.ndarray, side: int) -> Planes:
        """Squares of ``side`` px that begin at these places (n,) of the block, one below the other, of a block that was
        read as a whole; of the sources that are held only."""
        places = (np.column_stack([rows, columns]) + self._margin).tolist()
        return self._planes(*self.held, lambda pixels: np.concatenate(
            [pixels[..., row : row + side, column : column + side] for row, column in places], axis=-2
        ))

    def part(self, window: PixelWindow, numbers: Sequence[int]) -> Planes:
        """A window of the mosaic of some sources. Raises RasterError where the mosaic can't be read."""
        (top, below), (left, right) = self._around.margins_of(window)
        is_within = min(top, below, left, right) >= 0
        if self._held is None or not is_within or any(i not in self._held[1] for i in numbers):
            return self._planes(*self._read(window, numbers))
        mosaic, clips = self._held
        return self._planes(
            mosaic, {i: clips[i] for i in numbers},
            lambda pixels: pixels[..., top : top + window.height, left : left + window.width],
        )

    def _read(self, window: PixelWindow, numbers: Sequence[int]) -> tuple[Clip, dict[int, Clip]]:
        mosaic = read_clip(open_raster(self.mosaic.ref), self.mosaic, window, partly=True, holes=True)
        return mosaic, self._read_sources(window, numbers)

    def _read_sources(self, window: PixelWindow, numbers: Sequence[int]) -> dict[int, Clip]:
        clips = {}
        for i in numbers:
            try:
                clip = read_clip(open_raster(self._refs[i]), self.mosaic, window, partly=True, holes=True)
            except NotCoveredError:
                continue
            except RasterError as error:
                self.notices.append(error.message.as_warning())
                self.has_sources = bool(self.has_sources)
                continue
            self.has_sources = True
            name, bands = clip.raster.ref.name, clip.raster.band_names
            if self._band not in measured_bands(bands):
                lacking = messages.BANDS_DIFFER(name=name, band=self._band, bands=", ".join(bands))
                self.notices.append(lacking.as_warning())
                continue
            clips[i] = clip
        if window == self._around:
            self._absent.update(i for i in numbers if i not in clips)
        return clips

    def _planes(self, mosaic: Clip, clips: dict[int, Clip], pick: _Pick = lambda pixels: pixels) -> Planes:
        sources = {i: self._image(clip, pick) for i, clip in clips.items()}
        return Planes(self._image(mosaic, pick), sources, frozenset(i for i, clip in clips.items() if clip.resampled))

    def _image(self, clip: Clip, pick: _Pick) -> ComparedImage:
        names, band = clip.raster.band_names, self._band
        wanted = slice(0, 3) if band == LUMINANCE else slice(names.index(band), names.index(band) + 1)
        plane = judged_plane(pick(clip.bands[wanted]), names[wanted])
        if (factor := clip_factor(clip, self.mosaic)) != 1:
            plane *= np.float32(factor)
        valid, offset = None if clip.valid is None else pick(clip.valid), (clip.offset_x, clip.offset_y)
        return ComparedImage(plane[np.newaxis], JUDGED, {}, {}, clip.raster, offset, valid, plane)


@dataclass(frozen=True)
class BlockReading:
    """What of one block could be read; without anything said all of it."""

    unread: tuple[PixelWindow, ...] = ()
    """Windows of the mosaic that were to be measured and could not be read."""
    has_mosaic: bool = True
    """Whether anything of the mosaic was read, or it has no pixels there."""
    has_sources: bool | None = None
    """Whether any orthoimage was read; None where none had to be."""


ALL_READ = BlockReading()


class MosaicReading:
    """What of all blocks could be read."""

    def __init__(self, mosaic: Raster) -> None:
        self._mosaic = mosaic
        self.unread: dict[PixelWindow, None] = {}
        """Windows on the mosaic that could not be read, each once."""
        self._has_mosaic = self._has_sources = False
        self._why_no_mosaic: Message | None = None
        self._why_no_sources: Message | None = None

    def add(self, block: BlockReading, notices: Sequence[Message]) -> None:
        """One block more; ``notices``: why it lacks something."""
        self.unread |= dict.fromkeys(
            window.cut_to(self._mosaic.columns, self._mosaic.rows) for window in block.unread
        )
        self._has_mosaic |= block.has_mosaic
        self._has_sources |= bool(block.has_sources)
        why = next(iter(notices), None)
        self._why_no_mosaic = self._why_no_mosaic or (None if block.has_mosaic else why)
        self._why_no_sources = self._why_no_sources or (why if block.has_sources is False else None)

    def check(self) -> None:
        """Raise RasterError where nothing of the mosaic, or no orthoimage at all, could be read."""
        if self._why_no_mosaic is not None and not self._has_mosaic:
            raise RasterError(messages.MOSAIC_NOT_READ(name=self._mosaic.ref.name, why=self._why_no_mosaic))
        if self._why_no_sources is not None and not self._has_sources:
            raise RasterError(messages.SOURCES_NOT_READ(why=self._why_no_sources))

    @property
    def told(self) -> tuple[dict[str, str], tuple[Message, ...]]:
        """What the layers say of it, and in words: the share of the mosaic that was to be measured and could not be
        read, and the middle of its largest window; nothing where all was read."""
        if not self.unread:
            return {}, ()
        share = sum(map(_area, self.unread)) / (self._mosaic.columns * self._mosaic.rows)
        largest = max(self.unread, key=_area)
        x, y = self._mosaic.grid.to_map(largest.column + largest.width / 2, largest.row + largest.height / 2)
        notes = {"unread": f"{share:.3g}", "unread_at": f"{x:.10g} {y:.10g}"}
        return notes, (messages.MOSAIC_UNREAD(share=100 * share, x=x, y=y),)


def _area(window: PixelWindow) -> int:
    return window.width * window.height
