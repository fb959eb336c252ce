"""What is to be measured in one window, and the ground around it that is read with it where it is small: to compare its
seam with, and to tell labels and filters by."""
from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np

from ....imagery import limits as imagery_limits
from ....imagery.clips import Clip
from ....imagery.errors import Message, NotCoveredError, RasterError, SettingsError
from ....imagery.grids import PixelWindow
from ....imagery.open_raster import OpenRaster
from ....imagery.rasters import Raster
from ....imagery.wavelets import check_decomposition
from .. import limits, messages
from ..inputs.grey_values import read_grey_clip
from ..profile.cell_table import CELL_PX
from ..seam_cells import Cell
from ..source_images import Source
from ..window_records import REFERENCES

MARGIN_PX = 128
"""On every side, or what there is of the mosaic."""
ENOUGH_PX = 512
"""A side: a window as long has ground enough of its own."""


def surroundings(window: PixelWindow, mosaic: Raster, levels: int) -> PixelWindow:
    """A window with its margin, in whole cells and multiples of 2^R, inside the mosaic."""
    step = max(CELL_PX, 2 ** int(levels))

    def margins(first: int, length: int, end: int) -> tuple[int, int]:
        wanted = min(MARGIN_PX, max(ENOUGH_PX - length, 0) // 2)
        before, after = (min(wanted, max(there, 0)) // step * step for there in (first, end - first - length))
        return before, after

    left, right = margins(window.column, window.width, mosaic.columns)
    top, bottom = margins(window.row, window.height, mosaic.rows)
    return PixelWindow(
        window.column - left, window.row - top, window.width + left + right, window.height + top + bottom
    )


def place_in(window: PixelWindow, around: PixelWindow) -> tuple[slice, slice]:
    """Rows and columns of a window in a larger one."""
    row, column = window.row - around.row, window.column - around.column
    return slice(row, row + window.height), slice(column, column + window.width)


def read_with_surroundings(
    raster: OpenRaster, mosaic: Raster, window: PixelWindow, around: PixelWindow, partly: bool
) -> tuple[Clip, Clip, float]:
    """The clip of a window, that of all that is read around it, and by what both were multiplied.

    The window's own is as ``read_grey_clip`` has it. Raises RasterError.
    """
    wide: Clip | None = None
    if around != window:
        with suppress(RasterError if partly else NotCoveredError):  # the window itself may be covered, and readable
            wide, factor = read_grey_clip(raster, mosaic, around, partly=True)
    if wide is not None and wide.invalid_share == 0:
        place = place_in(window, around)
        return replace(wide, bands=np.ascontiguousarray(wide.bands[(slice(None), *place)])), wide, factor
    clip, factor = read_grey_clip(raster, mosaic, window, partly)
    return clip, wide or _padded(clip, window, around), factor


def _padded(clip: Clip, window: PixelWindow, around: PixelWindow) -> Clip:
    """A clip as one of all that is around it, where that has no pixels: mirrored, so that no edge is seen there."""
    if around == window:
        return clip
    valid = np.zeros((around.height, around.width), bool)
    valid[place_in(window, around)] = True if clip.valid is None else clip.valid
    return replace(clip, bands=np.pad(clip.bands, [(0, 0), *around.margins_of(window)], "symmetric"), valid=valid)


@dataclass(frozen=True)
class InspectionSettings:
    """How windows are measured and judged."""

    wavelet: str = imagery_limits.DEFAULT_WAVELET
    """Any orthogonal wavelet of PyWavelets."""
    levels: int = imagery_limits.DEFAULT_LEVELS
    """R, 1 to 8."""
    max_ratio: float = imagery_limits.MAX_SIGNIFICANT_RATIO
    """Largest ratio_1 that is a significant loss."""
    reference: str = REFERENCES[0]
    """What the verdict is taken by: ``seam``, the sources' ``composite``, or whole ``sources`` as in the paper."""
    min_kept: float = limits.MAX_SIGNIFICANT_KEPT
    """Share of the finest detail along the seam, kept_1, at or below which a loss is significant."""
    directions: bool = False
    """Whether the detail of the mosaic and the sources is told by direction too."""

    def check(self) -> None:
        """Raise SettingsError when a value is out of its range."""
        imagery_limits.check_settings(self, InspectionSettings)
        check_decomposition(self.wavelet, self.levels)
        for name, limit in (("max_ratio", self.max_ratio), ("min_kept", self.min_kept)):
            if not 0 < limit < 1:
                raise SettingsError(messages.LIMIT_OUT_OF_RANGE(name=name, limit=limit))
        if self.reference not in REFERENCES:
            raise SettingsError(messages.REFERENCE_UNKNOWN(reference=self.reference, known=", ".join(REFERENCES)))


@dataclass(frozen=True)
class WindowRequest:
    """All that is needed to measure one window, in plain data that can cross threads and processes."""

    window_id: int
    """What its result is known by."""
    mosaic: Raster
    """Whose grid the window lies on."""
    sources: tuple[Source, ...]
    """Sources that may cover the window."""
    window: PixelWindow | None
    """On the mosaic's grid; None when the drawn rectangle can't be measured."""
    settings: InspectionSettings
    """How it is measured and judged."""
    reason: Message | None = None
    """Why there is no window."""
    cells: tuple[Cell, ...] = ()
    """Known seam cells that meet the window."""
    is_alone: bool = False
    """Whether the mosaic can't be read around it."""

    @property
    def around(self) -> PixelWindow:
        """All that is read: a small window with the ground around it."""
        assert self.window is not None
        return self.window if self.is_alone else surroundings(self.window, self.mosaic, self.settings.levels)
