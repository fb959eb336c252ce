"""How the benchmarks call the scan."""
from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from seam_inspector.plugin.imagery.open_raster import describe, describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure.blocks.block_grid import ScanSettings
from seam_inspector.plugin.seams.measure.scan.scan_request import ScanRequest
from seam_inspector.plugin.seams.measure.scan.scan_result import ScanResult
from seam_inspector.plugin.seams.measure.scan.whole_scan import whole_scan
from seam_inspector.plugin.seams.measure.seamlines.given_seams import given_seams
from seam_inspector.plugin.seams.measure.source_images import Source
from seam_inspector.plugin.seams.measure.workers import Workers

from .large_mosaic import LargeMosaic
from .timing import say

SEAMS, GIVEN, FULL = "seams", "seams given", "full"
KINDS = (SEAMS, GIVEN, FULL)
AHEAD = 2
"""Blocks under way per thread, as in the plugin."""


def scan_request(made: LargeMosaic, tile_format: str, kind: str) -> ScanRequest:
    """The whole mosaic."""
    mosaic, *others = (RasterRef(str(path)) for path in made.files[tile_format])
    sources = tuple(Source(ref, describe(ref).extent) for ref in others)
    settings, raster = ScanSettings(density="full" if kind == FULL else "seams"), describe_mosaic(mosaic)
    features = [seam.feature(made.files[tile_format]) for seam in made.seams]
    given = given_seams(features, raster.grid) if kind == GIVEN else None
    return ScanRequest(raster, sources, settings, given)


def scan_once(made: LargeMosaic, tile_format: str, kind: str, threads: int, folder: Path) -> ScanResult:
    """A whole scan, from the files to the pieces of seam and the picture of losses."""
    loss = folder / "loss.tif"
    loss.unlink(missing_ok=True)
    with whole_scan(scan_request(made, tile_format, kind), loss) as scan:
        with ThreadPoolExecutor(threads) as executor:
            for step in scan.steps(Workers(executor, AHEAD * threads)):
                assert not step.notices, step.notices
        say(f"{tile_format}: scan, {kind}: blocks done")
        result = scan.result(str(loss))
        assert result is not None
        scan.finish()
    failed = f"{result.failed_metres:,.0f} m of them with a significant loss"
    say(f"{tile_format}: scan, {kind}: {result.seam_metres:,.0f} m of seams, {failed}")
    return result
