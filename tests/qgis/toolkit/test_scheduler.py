"""The parameter ``SCHEDULER``: the same windows on a Dask cluster whose workers know nothing of the plugin."""
from __future__ import annotations

import os
import signal
import socketserver
import subprocess
import sys
import threading
import venv
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from seam_inspector.plugin.imagery.errors import CancelledError, SettingsError
from seam_inspector.plugin.toolkit.executors import open_executor

from tests.numbers.synthetic import write_raster
from tests.qgis.clusters import needs_dask, two_workers, worker_processes
from tests.qgis.runs import Run, assert_refused, assert_sentence, run
from tests.qgis.scenes import BLURRED, SHARP, Scene, whole, windows
from tests.releases import built, cloned

pytestmark = [pytest.mark.slow, pytest.mark.usefixtures("provider")]


@pytest.fixture(scope="module")
def cluster(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The address of a scheduler with two workers."""
    with two_workers(tmp_path_factory.mktemp("cluster")) as address:
        yield address


def inspect(scene: Scene, **parameters: Any) -> Run:
    boxes = [(40 * index, 0, 64, 96) for index in range(8)] + [BLURRED, (0, 0, 10, 10), SHARP]
    return run(
        "inspectwindows",
        **{"WINDOWS": windows(*boxes), "MOSAIC": str(scene.mosaic), "SOURCES": scene.sources, **parameters},
    )


def assert_same_rows(rows: list[dict[str, Any]], expected: list[dict[str, Any]]) -> None:
    """Numbers to five digits: sums of float32 depend on where in memory the arrays lie."""
    assert len(rows) == len(expected)
    for row, same in zip(rows, expected):
        assert row.keys() == same.keys()
        for name, value in same.items():
            assert row[name] == (pytest.approx(value, rel=1e-5, abs=4e-3) if isinstance(value, float) else value)


@pytest.mark.release
@needs_dask
def test_a_cluster_gives_the_rows_that_threads_give(cluster: str, scene: Scene) -> None:
    threads = inspect(scene)
    for _ in range(2):  # the second run meets workers that have the archive already
        dask = inspect(scene, SCHEDULER=cluster)
        assert dask.complaint is None
        for table in ("OUTPUT", "CURVES", "PAIRS"):
            assert_same_rows(dask.rows(table), threads.rows(table))
        assert dask.log.warnings == threads.log.warnings
    assert len(set(threads.column("verdict"))) >= 3


@pytest.mark.release
@needs_dask
def test_bad_rasters_cost_no_window_on_a_cluster(cluster: str, scene: Scene, tmp_path: Path) -> None:
    broken = Path(write_raster(tmp_path / "broken.tif", whole(scene.west), options=[]))
    os.truncate(broken, broken.stat().st_size // 3)
    sources = [str(broken), *scene.sources, str(scene.mosaic)]
    threads, dask = inspect(scene, SOURCES=sources), inspect(scene, SOURCES=sources, SCHEDULER=cluster)
    assert_same_rows(dask.rows(), threads.rows())
    assert dask.log.warnings == threads.log.warnings
    assert len(dask.log.warnings) == 2
    for warning in dask.log.warnings:
        assert_sentence(warning, "broken.tif can't be read|mosaic.tif is the mosaic itself")


@needs_dask
@pytest.mark.parametrize(
    ("address", "words"),
    [
        ("tcp://127.0.0.1:9", r"scheduler answers at tcp://127\.0\.0\.1:9 .*; check the address .* 8786"),
        ("nowhere", r"scheduler answers at nowhere .*; check the address .* 8786\), or give none"),
        ("udp://127.0.0.1:9", r"scheduler answers at udp://127\.0\.0\.1:9 "),
    ],
)
def test_an_address_without_a_scheduler_gets_a_sentence(
    scene: Scene, monkeypatch: pytest.MonkeyPatch, address: str, words: str
) -> None:
    monkeypatch.setattr("seam_inspector.plugin.toolkit.executors.ANSWER_SECONDS", 0.2)
    given = {"WINDOWS": windows(SHARP), "MOSAIC": str(scene.mosaic), "SOURCES": scene.sources}
    assert_refused("inspectwindows", words, SCHEDULER=address, **given)


@contextmanager
def port_that_says(words: bytes) -> Iterator[str]:
    """The address of a server that is no scheduler: it says so much to whoever comes, then nothing."""

    class Talk(socketserver.BaseRequestHandler):
        def handle(self) -> None:
            self.request.sendall(words)
            ended.wait()

    ended = threading.Event()
    with socketserver.ThreadingTCPServer(("127.0.0.1", 0), Talk) as server:
        server.daemon_threads = True
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"tcp://127.0.0.1:{server.server_address[1]}"
        ended.set()
        server.shutdown()


def assert_not_opened(
    address: str, error: type[Exception], words: str, is_cancelled: Callable[[], bool] = lambda: False
) -> None:
    with pytest.raises(error, match=words), open_executor(address, is_cancelled):
        pass


OTHERS = (
    b"", b"SSH-2.0-OpenSSH_9.2p1\r\n", b"HTTP/1.1 400 Bad Request\r\n\r\n", (2**62).to_bytes(8, "little"),
    (16).to_bytes(8, "little") + (1).to_bytes(8, "little") + (0).to_bytes(8, "little"),
)  # fmt: skip


@needs_dask
@pytest.mark.parametrize("words", OTHERS, ids=["silent", "ssh", "http", "oversized frame", "empty frame"])
def test_what_is_not_a_scheduler_gets_a_sentence(words: bytes, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("seam_inspector.plugin.toolkit.executors.ANSWER_SECONDS", 0.3)
    with port_that_says(words) as address:
        assert_not_opened(address, SettingsError, r"No Dask scheduler answers at .* 8786")


@needs_dask
def test_a_silent_port_is_left_when_the_run_is_cancelled() -> None:
    asked = iter([False, False, True])
    with port_that_says(b"") as address:
        assert_not_opened(address, CancelledError, "cancelled", lambda: next(asked))


@pytest.mark.release
@needs_dask
def test_workers_that_stand_still_are_left_when_the_run_is_cancelled(tmp_path: Path) -> None:
    with two_workers(tmp_path) as address:
        stopped = worker_processes(address)
        for process in stopped:
            os.kill(process, signal.SIGSTOP)
        try:
            asked = iter([False] * 5 + [True])
            assert_not_opened(address, CancelledError, "cancelled", lambda: next(asked))
        finally:
            for process in stopped:
                os.kill(process, signal.SIGCONT)


@needs_dask
def test_a_scheduler_without_workers_gets_a_sentence(scene: Scene) -> None:
    from distributed import LocalCluster

    with LocalCluster(n_workers=0, processes=False, dashboard_address=":0") as empty:
        outcome = inspect(scene, SCHEDULER=empty.scheduler_address)
    assert_sentence(outcome.complaint, "has no workers that answer; start some, or give no scheduler")


def test_without_dask_a_scheduler_gets_a_sentence(scene: Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    outcome = inspect(scene, SCHEDULER="tcp://127.0.0.1:9")
    assert_sentence(outcome.complaint, r"Dask is not installed; install 'dask\[distributed\]', or give no scheduler")
    assert inspect(scene).complaint is None


@pytest.mark.release
@needs_dask
def test_workers_that_have_the_wheel_alone_measure(scene: Scene, repository: Path, tmp_path: Path) -> None:
    """An environment that sees the system's GDAL and numpy, with the released wheel and Dask."""
    import distributed

    environment = tmp_path / "venv"
    venv.create(environment, system_site_packages=True, with_pip=True)
    python = str(environment / "bin" / "python")
    wheel = built(cloned(repository, tmp_path / "clone"), "make_wheel")
    install = [python, "-I", "-m", "pip", "install", "--quiet", "--no-deps", "--no-index", str(wheel)]
    subprocess.run(install, check=True, capture_output=True)
    (packages,) = environment.glob("lib/python*/site-packages")
    (packages / "dask.pth").write_text(str(Path(distributed.__file__).parents[1]), encoding="utf-8")
    (tmp_path / "cluster").mkdir()
    expected = inspect(scene)
    with two_workers(tmp_path / "cluster", python, has_the_wheel=True) as address:
        with distributed.Client(address) as client:
            homes = client.run(eval, "__import__('seam_inspector').__file__").values()
            assert all(str(packages) in home for home in homes)
        outcome = inspect(scene, SCHEDULER=address)
    assert outcome.complaint is None
    assert outcome.column("verdict") == expected.column("verdict")
    for ratio, other in zip(outcome.column("ratio_1"), expected.column("ratio_1")):
        assert ratio == (other if other is None else pytest.approx(other, rel=1e-5))
