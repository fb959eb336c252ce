"""What of a mosaic and its orthoimages could be read while its blocks were measured."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ....imagery.errors import Message, RasterError
from ....imagery.grids import PixelWindow
from ....imagery.rasters import Raster
from .. import messages


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
