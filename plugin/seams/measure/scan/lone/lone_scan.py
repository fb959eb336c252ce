"""A whole scan without orthoimages: along given seams, by what lies on either side."""
from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import Executor
from typing import Callable

from .. import messages
from ..block_runs import ScanStep
from ..blocks.block_grid import BlockGrid
from ..blocks.seam_squares import SeamSquares
from ..inputs.scan_request import ScanRequest
from ..journal.scan_journal import ScanJournal
from ..lines.piece_index import PieceIndex
from ..results.gathering import ScanResult
from ..results.judged_pieces import without_verdict
from ..results.loss_raster import loss_raster
from ..results.worst_windows import worst_windows
from .lone_blocks import LoneRun
from .lone_gathering import LoneGathering
from .lone_table import REACH_PX

_CELLS_BESIDE_PX = 12  # what a cell whose middle is within reach sticks out


class LoneScanning:
    """Measures and tells."""

    def __init__(self, request: ScanRequest, journal: ScanJournal) -> None:
        self._request, self._journal = request, journal
        self._index = PieceIndex(request.pieces, request.mosaic.grid)

    def steps(self, executor: Executor, ahead: int, cancelled: Callable[[], bool]) -> Iterator[ScanStep]:
        """Every block that a seam meets."""
        request = self._request
        along = SeamSquares(
            request.seams, BlockGrid(request.mosaic.grid), beside_px=int(REACH_PX) + _CELLS_BESIDE_PX
        )
        run = LoneRun(request.mosaic, self._index, along, request.settings.wavelet, self._journal)
        yield from run.steps(executor, ahead, cancelled)

    def result(self, loss_path: str, goes_on: Callable[[float], bool]) -> ScanResult | None:
        """Pieces, worst windows and, where a path is given, the picture of losses; None where ``goes_on`` says no."""
        mosaic, settings = self._request.mosaic, self._request.settings
        gathering = LoneGathering(mosaic, self._request.pieces, self._index, settings.levels, self._journal)
        told = gathering.judged(lambda share: goes_on(0.8 * share))
        if told is None:
            return None
        if loss_path:
            with loss_raster(loss_path, mosaic, settings.cell_px, settings.told) as raster:
                gathering.draw(raster, told.pieces, settings.cell_px)
                raster.close([])
        notices = []
        if (all_of_them := told.network) is not None:
            kept, low, high = (100 * one for one in (all_of_them.kept, all_of_them.low, all_of_them.high))
            notices.append(messages.LONE_NETWORK(kept=kept, low=low, high=high))
            least = told.judgeable_m
            notices.append(messages.LONE_FROM_LENGTH(length=least) if least else messages.LONE_NEVER())
        worst = worst_windows(told.pieces, mosaic, settings.worst_count, settings.levels)
        notices += without_verdict(told.pieces)
        return ScanResult(tuple(told.pieces), (), tuple(worst), tuple(notices)) if goes_on(1.0) else None
