"""The seams that windows snap to, found in the background as soon as the inputs name them."""
from __future__ import annotations

from functools import partial
from typing import Any

from ..adapters import tasks
from ..adapters.text import tr
from ..core.nearest import SeamIndex
from .background import Background
from .block_cache import BlockCache


class SeamFinder:
    """Looks for the seams once for each layer of seamlines and mosaic."""

    def __init__(self, block: BlockCache, background: Background) -> None:
        self._block = block
        self._background = background
        self.forget()

    def forget(self) -> None:
        """The layers may be gone, or others under the same names."""
        self._seams = SeamIndex([])
        self._key: tuple[str, str] | None = None  # the layers that were searched

    def refresh(self) -> None:
        """The inputs or the project's layers have changed."""
        block = self._block.silent()
        lines = self._block.seamlines(block) if block is not None else None
        key = (self._block.inputs.seamlines, self._block.inputs.mosaic) if lines is not None else None
        if key == self._key:
            return
        self.forget()
        self._key = key
        if block is not None and lines is not None:
            job = tasks.seams_job(lines, block.mosaic.grid.pixel_width)
            self._background.start(tr("Find seams"), job, partial(self._take, key))

    def nearest(self, x: float, y: float, reach: float) -> tuple[float, float] | None:
        """The nearest point of a seam within ``reach``; none while they are being found."""
        return self._seams.nearest(x, y, reach)

    def _take(self, key: object, seams: Any) -> None:
        if key == self._key:
            self._seams = SeamIndex(seams)
