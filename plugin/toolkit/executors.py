"""Who measures: threads of this machine, any executor, or a Dask cluster that is watched for lost workers."""
from __future__ import annotations

import asyncio
import concurrent.futures
import tempfile
import time
import zipfile
from collections.abc import Iterator
from concurrent.futures import BrokenExecutor, Executor, Future
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from threading import Event, Thread
from typing import TYPE_CHECKING, Any, Callable, Union

from ..imagery.errors import CancelledError, SettingsError, WorkersLostError
from ..imagery.messages import CANCELLED
from ..imagery.raster_pool import AHEAD, own_threads
from . import messages

if TYPE_CHECKING:
    from distributed import Client

Crew = Union[Executor, "Client", str, None]
"""An executor, a client of a Dask cluster, the address of its scheduler, or a thread per core."""

ANSWER_SECONDS = 10.0  # to a scheduler, until it is known that it is one
PATIENCE_SECONDS = 120.0  # without any worker: long enough for those that were lost to be started anew
LOOK_SECONDS = 5.0  # between two looks at the cluster
_CANCELLED_EVERY_SECONDS = 0.1  # is asked for
_LOST = BrokenExecutor, concurrent.futures.CancelledError  # none of which is ours: who cancels gets no results
_SILENT = OSError, asyncio.TimeoutError, concurrent.futures.TimeoutError
_PREPARE = f"""
import sys
for name in [name for name in sys.modules if name.partition(".")[0] == {__name__.partition(".")[0]!r}]:
    del sys.modules[name]
import numpy, scipy, pywt, osgeo
"""  # else workers that met an older version of the plugin would go on with its code
_CLOSE = f"""
import sys
pool = sys.modules.get("{__package__.rpartition(".")[0]}.imagery.raster_pool")
if pool:
    pool.close_rasters()
"""  # else the workers, which live on, would keep the last rasters of the run open
_MEASURING = ("*/__init__.py", "imagery/**/*.py", "*/measure/**/*.py")  # as in the wheel, see pyproject.toml


@contextmanager
def open_executor(
    crew: Crew = None, is_cancelled: Callable[[], bool] = lambda: False
) -> Iterator[tuple[Executor, int]]:
    """An executor and how many windows it should have under way.

    Raises SettingsError for a cluster that can't be used, CancelledError, and WorkersLostError when nobody is left.
    """
    if crew and not isinstance(crew, Executor):
        with _cluster(crew, is_cancelled) as opened:
            yield opened
        return
    try:
        with own_threads(crew or None) as opened:
            yield opened
    except _LOST:
        raise WorkersLostError(messages.EXECUTOR_LOST()) from None


@contextmanager
def _cluster(crew: Client | str, is_cancelled: Callable[[], bool]) -> Iterator[tuple[Executor, int]]:
    """Dask gives the work of a lost worker to others; where none is left for long, all that waits ends."""
    with ExitStack() as opened:
        client = crew
        if isinstance(client, str):
            client = _client_at(client, is_cancelled)
            opened.callback(client.close, ANSWER_SECONDS)
        if not hasattr(client, "get_executor"):
            raise SettingsError(messages.NO_EXECUTOR(given=type(client).__name__))
        if client.status == "closed":
            raise WorkersLostError(messages.EXECUTOR_LOST())
        address = client.scheduler.address
        try:
            threads = _answer(lambda: _prepare(client, address), is_cancelled)
        except _SILENT:
            raise SettingsError(messages.SCHEDULER_WITHOUT_WORKERS(address=address)) from None
        executor = opened.enter_context(_watched(client))
        try:
            yield executor, AHEAD * threads
        except _LOST:
            raise WorkersLostError(messages.SCHEDULER_WITHOUT_WORKERS(address=address)) from None


def _client_at(address: str, is_cancelled: Callable[[], bool]) -> Client:
    """A client of the scheduler at an address."""
    try:
        from distributed import Client
    except ImportError:
        raise SettingsError(messages.DASK_MISSING()) from None
    try:
        # Dask's client has no limit of time for the first words
        return _answer(lambda: Client(address, timeout=ANSWER_SECONDS), is_cancelled, ANSWER_SECONDS)
    except CancelledError:
        raise
    except Exception as error:  # whatever Dask makes of bytes that are none of its own
        why = str(error) or f"{ANSWER_SECONDS:.0f} s"
        raise SettingsError(messages.SCHEDULER_SILENT(address=address, error=why)) from None


def _answer(call: Callable[[], Any], is_cancelled: Callable[[], bool], seconds: float = PATIENCE_SECONDS) -> Any:
    """What a call gives in a thread that nobody has to wait for, not even Python at its end.

    Raises whatever it raises, TimeoutError after a time, and CancelledError as soon as it is cancelled.
    """
    future: Future[Any] = Future()

    def run() -> None:
        try:
            future.set_result(call())
        except Exception as error:  # for whoever asks for the result
            future.set_exception(error)

    Thread(target=run, name="seam-inspector-cluster", daemon=True).start()
    last = time.monotonic() + seconds
    while not future.done() and time.monotonic() < last:
        if is_cancelled():
            raise CancelledError(CANCELLED())
        concurrent.futures.wait([future], _CANCELLED_EVERY_SECONDS)
    return future.result(0)


@contextmanager
def _watched(client: Client) -> Iterator[Executor]:
    """An executor that is shut down when the cluster has no workers for long, or its scheduler is gone."""
    executor, ended = client.get_executor(), Event()

    def watch() -> None:
        seen = time.monotonic()
        while not ended.wait(LOOK_SECONDS):
            with suppress(*_SILENT, ValueError):  # the connection is down; Dask tries to have it again
                if client.sync(client.scheduler.ncores, callback_timeout=LOOK_SECONDS):
                    seen = time.monotonic()
            if client.status not in ("running", "connecting") or time.monotonic() - seen > PATIENCE_SECONDS:
                executor.shutdown(wait=False)
                return

    Thread(target=watch, name="seam-inspector-cluster", daemon=True).start()
    try:
        yield executor
    finally:
        ended.set()
        if client.status == "running":
            executor.shutdown(wait=False)
            with suppress(*_SILENT):
                _answer(lambda: client.run(exec, _CLOSE, on_error="ignore"), lambda: False, ANSWER_SECONDS)


def _prepare(client: Client, address: str) -> int:
    """Give the workers this plugin's code, later ones too, whatever they have of it. How many threads they have."""
    threads = sum(client.nthreads().values())
    if not threads:
        raise SettingsError(messages.SCHEDULER_WITHOUT_WORKERS(address=address))
    answers = client.get_versions()
    here, *others = (
        str(answer["packages"]["distributed"])
        for answer in (answers["client"], answers["scheduler"], *answers["workers"].values())
    )
    if versions := ", ".join(sorted({*others} - {here})):
        raise SettingsError(messages.DASK_VERSIONS(address=address, versions=versions, own=here))
    try:
        client.run(exec, _PREPARE)
    except ImportError as error:
        raise SettingsError(messages.WORKERS_WITHOUT_PACKAGES(address=address, packages=error.name)) from None
    with tempfile.TemporaryDirectory() as folder:
        client.upload_file(_measuring_archive(Path(folder)))
    return threads


def measuring_modules(plugin: Path) -> list[Path]:
    """The files below the plugin's folder that measure, with what makes them packages: no QGIS, no charts."""
    return sorted({file for part in _MEASURING for file in plugin.glob(part)})


def _measuring_archive(folder: Path) -> str:
    """An importable zip of all that measures, for workers without this plugin, by the package's full name."""
    plugin, (package, room, _) = Path(__file__).parent.parent, __package__.split(".")
    archive = folder / f"{package}.zip"
    with zipfile.ZipFile(archive, "w") as file:
        for name in (package, f"{package}/{room}"):
            file.writestr(f"{name}/__init__.py", "")
        for module in measuring_modules(plugin):
            file.write(module, Path(package, room, module.relative_to(plugin)))
    return str(archive)
