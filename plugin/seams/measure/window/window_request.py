"""What is to be measured in one window."""
from __future__ import annotations

from dataclasses import dataclass

from ....imagery import limits as imagery_limits
from ....imagery.errors import Message, SettingsError
from ....imagery.grids import PixelWindow
from ....imagery.rasters import Raster
from ....imagery.wavelets import check_decomposition
from .. import limits, messages
from ..seam_cells import Cell
from ..source_images import Source
from ..verdicts import check_max_ratio, check_min_kept
from ..window_records import REFERENCES
from .surroundings import surroundings


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
        check_decomposition(self.wavelet, self.levels)
        check_max_ratio(self.max_ratio)
        check_min_kept(self.min_kept)
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
    """Those that may cover the window."""
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
