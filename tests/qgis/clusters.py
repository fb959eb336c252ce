"""A Dask cluster of worker processes that know nothing of the plugin."""
from __future__ import annotations

import importlib.util
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

needs_dask = pytest.mark.skipif(
    importlib.util.find_spec("distributed") is None, reason="dask[distributed] is not installed"
)

# A process of its own, so that neither the workers nor the scheduler inherit this one's modules and paths.
CLUSTER = """
import sys
from distributed import LocalCluster

if __name__ == "__main__":
    with LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster:
        print(cluster.scheduler_address, flush=True)
        sys.stdin.read()
"""


@contextmanager
def two_workers(folder: Path, python: str = sys.executable, has_the_wheel: bool = False) -> Iterator[str]:
    """The address of a scheduler with two workers of one thread each, which know nothing of the plugin, or what a wheel
    brought to their ``python``.
    """
    script = folder / "cluster.py"
    script.write_text(CLUSTER, encoding="utf-8")
    environment = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "QGIS"))}
    command = [python, "-I", str(script)]
    pipe = subprocess.PIPE
    with subprocess.Popen(command, stdin=pipe, stdout=pipe, text=True, cwd=folder, env=environment) as process:
        assert process.stdin is not None
        assert process.stdout is not None
        address = process.stdout.readline().strip()
        if not has_the_wheel:
            assert_knows_nothing(address)
        yield address
        process.send_signal(signal.SIGCONT)  # to one that a test has stopped
        process.stdin.close()


def assert_knows_nothing(address: str) -> None:
    """Neither the scheduler nor the workers can import the plugin."""
    from distributed import Client

    with Client(address) as client:
        assert list(client.run(importlib.util.find_spec, "seam_inspector").values()) == [None, None]
        assert client.run_on_scheduler(importlib.util.find_spec, "seam_inspector") is None


def worker_processes(address: str) -> list[int]:
    """The process ids of the workers, in no order."""
    from distributed import Client

    with Client(address) as client:
        return list(client.run(os.getpid, on_error="ignore").values())


def scheduler_process(address: str) -> int:
    """The process id of the scheduler."""
    from distributed import Client

    with Client(address) as client:
        return int(client.run_on_scheduler(os.getpid))
