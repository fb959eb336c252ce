"""The scan of a mosaic on a Dask cluster of worker processes, some of which are killed."""
from __future__ import annotations

import os
import signal
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery.open_raster import describe, describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure.blocks.block_grid import ScanSettings
from seam_inspector.plugin.seams.measure.scan.scan_request import ScanRequest
from seam_inspector.plugin.seams.measure.scan.scan_result import ScanResult
from seam_inspector.plugin.seams.measure.scan.whole_scan import whole_scan
from seam_inspector.plugin.seams.measure.source_images import Source
from seam_inspector.plugin.seams.measure.workers import Workers
from seam_inspector.plugin.toolkit.executors import open_executor

from tests.numbers.synthetic import orthoimage, write_raster
from tests.qgis.clusters import needs_dask, two_workers, worker_processes
from tests.qgis.runs import run
from tests.qgis.scenes import Scene

pytestmark = [pytest.mark.slow, pytest.mark.release, needs_dask]

SIDE = 4200  # side of the mosaic, px: 3 x 3 blocks


@pytest.fixture(scope="module")
def cluster(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    with two_workers(tmp_path_factory.mktemp("cluster")) as address:
        yield address


@pytest.fixture(scope="module")
def request_(tmp_path_factory: pytest.TempPathFactory) -> ScanRequest:
    """A mosaic cut hard out of two images along a crooked line."""
    folder = tmp_path_factory.mktemp("large")
    west, east = (np.tile(orthoimage((SIDE, SIDE // 4), bands=1, seed=seed), (1, 1, 4)) for seed in (1, 2))
    seam = SIDE / 2 + 90 * np.sin(np.arange(SIDE) / 300)
    mosaic = np.where(np.arange(SIDE) < seam[:, np.newaxis], west, east)
    refs = [
        RasterRef(write_raster(folder / f"{name}.tif", pixels))
        for name, pixels in (("mosaic", mosaic), ("west", west), ("east", east))
    ]
    sources = tuple(Source(ref, describe(ref).extent) for ref in refs[1:])
    return ScanRequest(describe_mosaic(refs[0]), sources, ScanSettings())


def in_threads(request: ScanRequest, loss: Path) -> ScanResult | None:
    with whole_scan(request, loss) as scan, ThreadPoolExecutor(2) as executor:
        list(scan.steps(Workers(executor, 4)))
        return scan.result(str(loss))


def assert_alike(result: ScanResult | None, expected: ScanResult | None) -> None:
    """Results are the same but for the last digits, since float32 sums depend on memory's alignment."""
    assert result is not None
    assert expected is not None
    assert result.notices == expected.notices
    assert result.seam_metres == pytest.approx(expected.seam_metres, rel=1e-6)
    assert [piece.verdict for piece in result.pieces] == [piece.verdict for piece in expected.pieces]
    kept = [piece.least_kept for piece in expected.pieces]
    assert [piece.least_kept for piece in result.pieces] == pytest.approx(kept, 1e-4)
    assert len(kept) > 10


def test_killed_workers_cost_a_scan_nothing_but_time(cluster: str, request_: ScanRequest, tmp_path: Path) -> None:
    expected = in_threads(request_, tmp_path / "threads.tif")
    killed = []
    with whole_scan(request_, tmp_path / "cluster.tif") as scan:
        with open_executor(cluster) as (executor, ahead):
            for number, step in enumerate(scan.steps(Workers(executor, ahead))):
                assert step.notices == ()
                if number in (1, 5):
                    killed.append(worker_processes(cluster)[0])
                    os.kill(killed[-1], signal.SIGKILL)
        result = scan.result(str(tmp_path / "cluster.tif"))
    assert len(set(killed)) == 2
    assert_alike(result, expected)
    ours, theirs = (gdal.Open(str(tmp_path / name)).ReadAsArray() for name in ("cluster.tif", "threads.tif"))
    np.testing.assert_allclose(ours, theirs, rtol=1e-4, atol=1e-6, equal_nan=True)


def test_a_cluster_gives_the_layers_that_threads_give(
    cluster: str, scene: Scene, provider: None, tmp_path: Path
) -> None:
    given = {"MOSAIC": str(scene.mosaic), "SOURCES": scene.sources, "PIECE": 5.0}
    threads = run("scanmosaic", LOSS=str(tmp_path / "threads.tif"), **given)
    dask = run("scanmosaic", LOSS=str(tmp_path / "dask.tif"), SCHEDULER=cluster, **given)
    assert dask.complaint is None
    assert dask.log.warnings == threads.log.warnings
    for table in ("SEAMS", "CELLS", "WORST"):
        assert len(dask.rows(table)) == len(threads.rows(table))
    assert dask.column("verdict", "SEAMS") == threads.column("verdict", "SEAMS")
