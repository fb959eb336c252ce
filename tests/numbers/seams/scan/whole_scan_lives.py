"""A scan that is killed again and again: `python -m tests.numbers.seams.scan.whole_scan_lives LOSS SEED LIVES FILE...`.

The files are the mosaic and its orthoimages. Every life is a process of its own, killed at a random moment, that goes
on with the same output; one more may end. Prints for each life what the scan said as it began, then what it found.
"""
from __future__ import annotations

import os
import signal
import sys
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

import numpy as np
from seam_inspector.plugin.imagery.open_raster import describe, describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure.blocks.block_grid import ScanSettings
from seam_inspector.plugin.seams.measure.scan.scan_request import ScanRequest, scan_request
from seam_inspector.plugin.seams.measure.scan.scan_result import ScanResult
from seam_inspector.plugin.seams.measure.scan.whole_scan import whole_scan
from seam_inspector.plugin.seams.measure.source_images import Source
from seam_inspector.plugin.seams.measure.workers import Workers

MOST_BLOCKS, LONGEST_S = 16, 0.4
"""A life ends after up to so many blocks, those of earlier lives included, and so many seconds: while a block is
measured or written, or when all are done and put together."""


def request_of(mosaic: str, *sources: str, **settings: object) -> ScanRequest:
    """Request for files on one grid."""
    made = tuple(Source(RasterRef(path), describe(RasterRef(path)).extent) for path in sources)
    return scan_request(describe_mosaic(RasterRef(mosaic)), made, ScanSettings(**settings))[0]  # type: ignore[arg-type]


def scanned(
    request: ScanRequest, loss: Path, end: Callable[[int], None] = lambda done: None
) -> tuple[str, ScanResult]:
    """What a scan said as it began, and what it found; its journal is gone. ``end`` is told when a block is done."""
    with whole_scan(request, loss) as scan, ThreadPoolExecutor(2) as executor:
        began = str(scan.notice or "")
        sys.stdout.write(began + "\n")
        sys.stdout.flush()
        end(0)
        for done, _ in enumerate(scan.steps(Workers(executor, 4)), 1):
            end(done)
        result = scan.result(str(loss))
        assert result is not None
        scan.finish()
    return began, result


def plain_values(result: ScanResult) -> list[object]:
    """All that becomes a layer, in plain values."""
    pieces = [
        (piece.piece.vertices.tolist(), piece.left, piece.right, piece.kept, piece.low, piece.high, piece.band_width_m,
         piece.visibility, piece.verdict)
        for piece in result.pieces
    ]
    return [pieces, [(polygon.source, polygon.wkb) for polygon in result.polygons], list(result.worst)]


def _die(blocks: int, seconds: float, done: int) -> None:
    if done == blocks:
        threading.Timer(seconds, os.kill, (os.getpid(), signal.SIGKILL)).start()


def main(loss: str, seed: str, lives: str, *files: str) -> None:
    """Live and die."""
    request, random = request_of(*files), np.random.default_rng(int(seed))
    for _ in range(int(lives)):
        blocks, seconds = int(random.integers(MOST_BLOCKS)), float(random.uniform(0, LONGEST_S))
        child = os.fork()
        if not child:
            scanned(request, Path(loss), partial(_die, blocks, seconds))
            os._exit(0)
        os.waitpid(child, 0)
    _, result = scanned(request, Path(loss))
    sys.stdout.write("\n".join(map(repr, plain_values(result))) + "\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
