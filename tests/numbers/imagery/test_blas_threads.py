"""BLAS has one thread while a window or a block is measured, as threadpoolctl sees it, and what it had before after."""
from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

PROGRAM = """
import threading
import threadpoolctl
import numpy, scipy.linalg
from seam_inspector.plugin.imagery.blas_threads import one_blas_thread

def counts():
    return {library["num_threads"] for library in threadpoolctl.threadpool_info() if library["user_api"] == "blas"}

print(counts())
inside, go_on = threading.Event(), threading.Event()

def other():
    with one_blas_thread():
        inside.set()
        go_on.wait()

thread = threading.Thread(target=other)
with one_blas_thread():
    thread.start()
    inside.wait()
    print(counts())
print(counts())  # the other is still under way
go_on.set()
thread.join()
print(counts())
try:
    with one_blas_thread():
        raise ValueError
except ValueError:
    print(counts())
"""


@pytest.mark.slow
def test_one_thread_while_anything_runs(repository: Path) -> None:
    own = {name: value for name, value in os.environ.items() if not name.endswith("_NUM_THREADS")}
    own["PYTHONPATH"] = str(repository / "build" / "plugins")
    finished = subprocess.run(
        [sys.executable, "-c", PROGRAM], env=own, capture_output=True, text=True, timeout=120, check=False
    )
    assert finished.returncode == 0, finished.stderr
    before, *inside, after, failed = finished.stdout.split()
    assert inside == ["{1}", "{1}"]
    assert before == after == failed
