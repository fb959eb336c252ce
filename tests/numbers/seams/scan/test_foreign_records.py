"""A journal may hold what no scan of ours wrote: that counts as not measured."""
from __future__ import annotations

import json
import struct
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from seam_inspector.plugin.imagery.records import RecordFiles, packed, record_of, value_of
from seam_inspector.plugin.seams.measure import messages
from seam_inspector.plugin.seams.measure.blocks.block_grid import ScanSettings
from seam_inspector.plugin.seams.measure.blocks.scan_block import BlockScan
from seam_inspector.plugin.seams.measure.scan.scan_request import ScanRequest, scan_request
from seam_inspector.plugin.seams.measure.scan.scan_result import ScanResult
from seam_inspector.plugin.seams.measure.scan.whole_scan import whole_scan
from seam_inspector.plugin.seams.measure.workers import Workers

from tests.numbers.seams.scan.blocks.scenes import beside, blended, images, scene


def changed(**fields: object) -> Callable[[bytes], bytes]:
    return lambda record: record_of(replace(value_of(BlockScan, record, {}), **fields), exact=True)


def boundless(record: bytes) -> bytes:
    """A kilobyte that says to hold a terabyte."""
    head = json.dumps([["squares", "|u1", [2**40], 1000, True]]).encode()
    return struct.pack("<I", len(head)) + head + bytes(1000)


FOREIGN: dict[str, Callable[[bytes], bytes]] = {
    "nothing": lambda record: b"",
    "noise": lambda record: np.random.default_rng(1).bytes(5000),
    "cut off": lambda record: record[: len(record) // 2],
    "no table": lambda record: packed({"key": np.array([0, 0])}),
    "what lacks something": changed(notices=(messages.NO_SOURCE_USABLE(),)),
    "boundless": boundless,
}


def scanned(request: ScanRequest, output: Path, is_last: bool) -> tuple[ScanResult, int]:
    """And how many blocks were measured."""
    with whole_scan(request, output) as scan, ThreadPoolExecutor(1) as executor:
        steps = list(scan.steps(Workers(executor, 2)))
        result = scan.result("")
        if is_last:
            scan.finish()
    assert result is not None
    return result, len(steps)


@pytest.mark.slow
@pytest.mark.parametrize("foreign", FOREIGN)
def test_a_foreign_record_is_measured_again(tmp_path: Path, foreign: str) -> None:
    given = images()
    made = scene(tmp_path, blended(*given, beside(500, 20)), given)
    request, _ = scan_request(made.mosaic, made.sources, ScanSettings())
    output = tmp_path / "loss.tif"
    expected, _ = scanned(request, output, is_last=False)
    files = RecordFiles(tmp_path / "loss.tif.scan")
    record = files.load("block 0 0")
    assert record is not None
    files.save("block 0 0", FOREIGN[foreign](record))
    result, _ = scanned(request, output, is_last=True)
    assert [piece.kept for piece in result.pieces] == [piece.kept for piece in expected.pieces]
