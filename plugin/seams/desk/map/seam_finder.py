"""The seams that windows snap to, found in the background as soon as the inputs name them."""
from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np

from ....toolkit.background_tasks import BackgroundTasks
from ....toolkit.translation import tr
from ... import jobs
from ...measure.nearest_seam import SeamIndex
from ..inputs.block_cache import BlockCache


class SeamFinder:
    """Looks for the seams once for each layer of seamlines and mosaic, and when the seamlines are edited."""

    def __init__(self, block: BlockCache, background: BackgroundTasks) -> None:
        self._block = block
        self._background = background
        self.forget()

    def forget(self) -> None:
        """Another project."""
        self._seams = SeamIndex([])
        self._key: object = None  # what was searched
        self._turn = object()

    def refresh(self, anew: bool = False) -> None:
        """The inputs or the project's layers have changed; ``anew``: so have the seamlines themselves."""
        block = self._block.silent()
        lines = self._block.seamlines(block) if block is not None else None
        if block is None or lines is None:
            self.forget()
            return
        seamlines = self._block.inputs.seamlines
        key = seamlines, self._block.seen(seamlines), block.mosaic
        if key == self._key and not anew:
            return
        if key != self._key:  # else those of before are better than none
            self.forget()
        self._key = key
        self._turn = turn = object()
        job = jobs.seams_job(lines, block.mosaic.grid.pixel_width)
        self._background.start(tr("Find seams"), job, partial(self._take, turn))

    def nearest(self, x: float, y: float, reach: float) -> tuple[float, float] | None:
        """The nearest point of a seam within ``reach``; none while they are being found."""
        return self._seams.nearest(x, y, reach)

    def points(self, x: float, y: float, reach: float, spacing: float) -> np.ndarray:
        """(n, 2) points on the seams around a place, some ``spacing`` apart."""
        return self._seams.points(x, y, reach, spacing)

    def _take(self, turn: object, seams: Any) -> None:
        if turn is self._turn:
            self._seams = seams
