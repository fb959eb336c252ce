"""How a whole mosaic is scanned."""
from __future__ import annotations

from dataclasses import dataclass

from ....imagery import limits as imagery_limits
from ....imagery.errors import SettingsError
from ....imagery.wavelets import check_decomposition
from .. import limits, messages
from ..limits import DENSITIES, MOST_LEVELS, SEAMS
from ..profile.cell_table import CELL_PX

LEAST_PIECE_M = 0.01  # what is shorter is no length; scan_request lengthens what can't be measured
CELLS_PX = tuple(CELL_PX * 2**power for power in range(5))
"""Sides of a pixel of the picture of losses: whole cells, and whole pixels in a block."""


@dataclass(frozen=True)
class ScanSettings:
    """What is measured, and how it is told."""

    wavelet: str = imagery_limits.DEFAULT_WAVELET
    """Any orthogonal wavelet of PyWavelets."""
    levels: int = imagery_limits.DEFAULT_LEVELS
    """R, 1 to 4."""
    density: str = SEAMS
    """``seams``: everything along the seams, samples elsewhere; ``full``: everything everywhere."""
    cell_px: int = 2 * CELL_PX
    """Side of a pixel of the picture of losses, px of the mosaic: 16, 32, 64, 128 or 256."""
    piece_m: float = limits.STANDARD_PIECE_M
    """Length of the pieces into which seams are cut."""
    corridor_m: float = 0.0
    """What is read on either side of given seamlines; 0: everything."""
    worst_count: int = limits.WORST_COUNT
    """Windows of the least kept places."""
    source_field: str = ""
    """Field of given seamlines that names the source of a polygon, where that can't be guessed."""

    @property
    def told(self) -> dict[str, str]:
        """What its results say of how they were measured."""
        notes = {
            "wavelet": self.wavelet, "levels": str(self.levels), "density": self.density,
            "piece_m": f"{self.piece_m:.4g}",
        }  # fmt: skip
        return {**notes, "corridor_m": f"{self.corridor_m:.4g}"} if self.corridor_m else notes

    def check(self) -> None:
        """Raise SettingsError when a value is out of its range."""
        imagery_limits.check_settings(self, ScanSettings)
        if not 1 <= self.levels <= MOST_LEVELS:
            raise SettingsError(messages.SCAN_LEVELS(levels=self.levels, most=MOST_LEVELS))
        check_decomposition(self.wavelet, self.levels)
        if self.density not in DENSITIES:
            raise SettingsError(messages.DENSITY_UNKNOWN(density=self.density, known=", ".join(DENSITIES)))
        if self.cell_px not in CELLS_PX:
            raise SettingsError(messages.SCAN_CELL(cell=self.cell_px, known=", ".join(map(str, CELLS_PX))))
        for name, least in (("piece_m", LEAST_PIECE_M), ("corridor_m", 0.0), ("worst_count", 0)):
            if (value := getattr(self, name)) < least:
                raise SettingsError(messages.SCAN_LENGTHS(name=name, value=value, least=f"{least:g}"))
