"""While a window or a block is measured BLAS has one thread, as threadpoolctl sees it, and what it had before after;
and arrays that are let go of are used again, as the system counts fresh pages."""
from __future__ import annotations

import os
import platform
import subprocess
import sys
from pathlib import Path

import pytest
from osgeo import gdal
from seam_inspector.plugin.seams.measure.workers import measuring

PROGRAM = """
import threading
import threadpoolctl
import numpy, scipy.linalg
from seam_inspector.plugin.seams.measure.workers import measuring

def counts():
    return {library["num_threads"] for library in threadpoolctl.threadpool_info() if library["user_api"] == "blas"}

print(counts())
inside, go_on = threading.Event(), threading.Event()

def other():
    with measuring():
        inside.set()
        go_on.wait()

thread = threading.Thread(target=other)
with measuring():
    thread.start()
    inside.wait()
    print(counts())
print(counts())  # the other is still under way
go_on.set()
thread.join()
print(counts())
try:
    with measuring():
        raise ValueError
except ValueError:
    print(counts())
"""


@pytest.mark.slow
def test_one_thread_while_anything_runs(repository: Path) -> None:
    environment = {name: value for name, value in os.environ.items() if not name.endswith("_NUM_THREADS")}
    environment["PYTHONPATH"] = str(repository / "build" / "plugins")
    finished = subprocess.run(
        [sys.executable, "-c", PROGRAM], env=environment, capture_output=True, text=True, timeout=120, check=False
    )
    assert finished.returncode == 0, finished.stderr
    before, *inside, after, failed = finished.stdout.split()
    assert inside == ["{1}", "{1}"]
    assert before == after == failed


@pytest.mark.parametrize("own_mb", [3000, 40])
def test_gdal_keeps_no_more_than_is_read_at_a_time(own_mb: int) -> None:
    cache = gdal.GetCacheMax()
    try:
        gdal.SetCacheMax(own_mb * 2**20)
        with measuring():
            with measuring():
                pass
            inside = gdal.GetCacheMax()
        assert inside == min(own_mb, 128 * (os.cpu_count() or 1)) * 2**20
        assert gdal.GetCacheMax() == own_mb * 2**20
    finally:
        gdal.SetCacheMax(cache)


ARRAYS = """
import resource
import numpy as np
from seam_inspector.plugin.seams.measure.workers import measuring

def fresh_pages():
    before = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
    held = [np.ones(2**17) for _ in range(128)]  # 128 MB
    del held
    return resource.getrusage(resource.RUSAGE_SELF).ru_minflt - before

with measuring():
    with measuring():
        fresh_pages()
    print(fresh_pages())
fresh_pages()
print(fresh_pages())
"""


@pytest.mark.slow
@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="another C library than glibc keeps memory its own way")
def test_pages_are_used_again_while_anything_runs(repository: Path) -> None:
    finished = subprocess.run(
        [sys.executable, "-c", ARRAYS], env={"PYTHONPATH": str(repository / "build" / "plugins")},
        capture_output=True, text=True, timeout=120, check=False,
    )
    assert finished.returncode == 0, finished.stderr
    inside, after = map(int, finished.stdout.split())
    assert inside < 100 < 10_000 < after  # of 32,768
