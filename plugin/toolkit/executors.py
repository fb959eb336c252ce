"""Executors that measure windows: threads of this machine, or a Dask cluster that is watched for lost workers."""
from __future__ import annotations

import asyncio
import concurrent.futures
import tempfile
import time
import zipfile
from collections.abc import Iterator
from concurrent.futures import Executor, Future, InvalidStateError
from contextlib import contextmanager
from pathlib import Path
from threading import Event, Thread
from typing import TYPE_CHECKING, Any, Callable

from ..imagery.errors import CancelledError, Message, SettingsError, WorkersLostError
from ..imagery.messages import CANCELLED
from ..imagery.raster_pool import ahead_of, own_threads
from . import messages

if TYPE_CHECKING:
    from distributed import Client

_ANSWER_SECONDS = 10.0  # to the scheduler, until it is known that it is one
_PREPARING_SECONDS = 120.0  # for all workers to take the code
_CANCELLED_EVERY_SECONDS = 0.1  # is asked for
_FORGET = f"""
import sys
for name in [name for name in sys.modules if name.partition(".")[0] == {__name__.partition(".")[0]!r}]:
    del sys.modules[name]
"""  # else workers that met an older version of the plugin would go on with its code
_MEASURING = ("*/__init__.py", "imagery/**/*.py", "*/measure/**/*.py")  # as in the wheel, see pyproject.toml
_NEEDED = ("numpy", "scipy", "pywt", "osgeo")
_MISSING = "[name for name in {needed} if __import__('importlib.util').util.find_spec(name) is None]"
_CLOSE = f"""
import sys
pool = sys.modules.get("{__package__.rpartition(".")[0]}.imagery.raster_pool")
if pool:
    pool.close_rasters()
"""  # else the workers, which live on, would keep the last rasters of the run open


@contextmanager
def open_executor(
    scheduler: str = "", is_cancelled: Callable[[], bool] = lambda: False
) -> Iterator[tuple[Executor, int]]:
    """An executor and how many windows it should have under way.

    Without a ``scheduler`` (address of a Dask scheduler) the windows run in one thread per core.

    Raises SettingsError when Dask is not installed, nothing answers, or what answers is not a scheduler;
    CancelledError when cancelled before it is open.
    """
    with _dask_executor(scheduler, is_cancelled) if scheduler else own_threads() as opened:
        yield opened


@contextmanager
def _dask_executor(scheduler: str, is_cancelled: Callable[[], bool]) -> Iterator[tuple[Executor, int]]:
    with _connected(scheduler, is_cancelled) as client:
        preparing = _started(lambda: _prepare(client, scheduler))
        if not _is_done(preparing, _PREPARING_SECONDS, is_cancelled):
            raise SettingsError(messages.WORKERS_SILENT(address=scheduler, seconds=_PREPARING_SECONDS))
        if isinstance(preparing.exception(), OSError):
            raise SettingsError(messages.SCHEDULER_LOST(address=scheduler))
        executor = WatchedExecutor(client, scheduler)
        try:
            yield executor, ahead_of(preparing.result())
        finally:
            executor.shutdown()
            if client.status == "running":
                _is_done(_started(lambda: client.run(exec, _CLOSE, on_error="ignore")), _ANSWER_SECONDS)


@contextmanager
def _connected(scheduler: str, is_cancelled: Callable[[], bool]) -> Iterator[Client]:
    """A client of the scheduler. Whatever else answers, or does not, is left to itself after a time."""
    try:
        from distributed import Client
    except ImportError:
        raise SettingsError(messages.DASK_MISSING()) from None
    connecting = _started(lambda: asyncio.run(asyncio.wait_for(_check_scheduler(scheduler), _ANSWER_SECONDS)))
    has_answered = _is_done(connecting, _ANSWER_SECONDS, is_cancelled)
    error = connecting.exception() if has_answered else None
    if not has_answered or isinstance(error, asyncio.TimeoutError):
        raise SettingsError(messages.SCHEDULER_SILENT(address=scheduler, error=f"{_ANSWER_SECONDS:.0f} s"))
    if isinstance(error, (OSError, ValueError)):
        raise SettingsError(messages.SCHEDULER_SILENT(address=scheduler, error=error))
    if error is not None:  # whatever Dask makes of bytes that are none of its own
        raise SettingsError(messages.NOT_A_SCHEDULER(address=scheduler))
    try:
        client = Client(scheduler, timeout=_ANSWER_SECONDS)
    except (OSError, ValueError) as lost:
        raise SettingsError(messages.SCHEDULER_SILENT(address=scheduler, error=lost)) from None
    try:
        yield client
    finally:
        client.close(_ANSWER_SECONDS)


async def _check_scheduler(address: str) -> None:
    """Dask's own client has no limit of time for the first words. Raises whatever those of something else lead to."""
    from distributed.comm.core import connect
    from distributed.security import Security

    comm = await connect(address, timeout=_ANSWER_SECONDS, **Security().get_connection_args("client"))
    try:
        await comm.write({"op": "identity", "reply": True})
        if (await comm.read())["type"] != "Scheduler":
            raise TypeError(address)
    finally:
        comm.abort()


def _started(call: Callable[[], Any]) -> Future[Any]:
    """A call in a thread of its own, which nobody has to wait for, not even Python at its end."""
    future: Future[Any] = Future()

    def run() -> None:
        try:
            future.set_result(call())
        except Exception as error:  # for whoever asks for the result
            future.set_exception(error)

    Thread(target=run, name="seam-inspector-cluster", daemon=True).start()
    return future


def _is_done(future: Future[Any], seconds: float, is_cancelled: Callable[[], bool] = lambda: False) -> bool:
    """Whether it is within a time. Raises CancelledError as soon as it is cancelled."""
    last = time.monotonic() + seconds
    while not future.done() and time.monotonic() < last:
        if is_cancelled():
            raise CancelledError(CANCELLED())
        concurrent.futures.wait([future], _CANCELLED_EVERY_SECONDS)
    return future.done()


def _prepare(client: Client, scheduler: str) -> int:
    """Give the workers this plugin's code, whatever they have of it; those that come later get it, too. How many
    threads they have.

    A worker that is lost costs its windows' time only: Dask gives them to others.
    """
    threads = sum(client.nthreads().values())
    if not threads:
        raise SettingsError(messages.SCHEDULER_WITHOUT_WORKERS(address=scheduler))
    lacking = client.run(eval, _MISSING.format(needed=_NEEDED))
    missing = sorted({name for names in lacking.values() for name in names})
    if missing:
        raise SettingsError(messages.WORKERS_WITHOUT_PACKAGES(address=scheduler, packages=", ".join(missing)))
    client.run(exec, _FORGET)
    with tempfile.TemporaryDirectory() as folder:
        client.upload_file(_measuring_archive(Path(folder)))
    return threads


def measuring_modules(plugin: Path) -> list[Path]:
    """The files below the plugin's folder that measure, with what makes them packages: no QGIS, no charts."""
    return sorted({file for part in _MEASURING for file in plugin.glob(part)})


def _measuring_archive(folder: Path) -> str:
    """An importable zip of all that measures, for the workers, which need neither QGIS nor this plugin.

    It keeps the package's full name, since that is how functions and requests refer to it.
    """
    plugin = Path(__file__).parent.parent
    package = __package__.split(".")[:-1]
    archive = folder / f"{package[0]}.zip"
    with zipfile.ZipFile(archive, "w") as file:
        for depth in range(1, len(package) + 1):
            file.writestr("/".join([*package[:depth], "__init__.py"]), "")
        for module in measuring_modules(plugin):
            file.write(module, "/".join([*package, *module.relative_to(plugin).parts]))
    return str(archive)


PATIENCE_SECONDS = 120.0
"""Without any worker: long enough for those that were lost to be started anew."""
LOOK_SECONDS = 5.0
"""Between two looks at the cluster."""


class WatchedExecutor(Executor):
    """Dask gives the work of a lost worker to others; where none is left for long, all that waits ends with
    WorkersLostError instead of waiting for ever."""

    def __init__(self, client: Client, address: str) -> None:
        """``address`` of the scheduler, for the user."""
        self._client, self._address = client, address
        self._executor = client.get_executor()
        self._waiting: set[Future[Any]] = set()
        self._closed = Event()
        self._watch = Thread(target=self._look, name="seam-inspector-cluster", daemon=True)
        self._watch.start()

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Submit work as any executor does."""
        promised: Future[Any] = Future()
        self._waiting.add(promised)
        under_way = self._executor.submit(fn, *args, **kwargs)

        def settle(done: Future[Any]) -> None:
            try:
                error = done.exception()
            except concurrent.futures.CancelledError:  # by us, then nobody asks any more; else the scheduler is gone
                error = WorkersLostError(messages.SCHEDULER_LOST(address=self._address))
            self._settle(promised, error, None if error else done.result())

        under_way.add_done_callback(settle)
        promised.add_done_callback(lambda done: under_way.cancel() if done.cancelled() else None)
        return promised

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Ends the watch, and the work that nobody waits for."""
        self._closed.set()
        self._executor.shutdown(wait=False)

    def _settle(self, promised: Future[Any], error: BaseException | None, result: Any = None) -> None:
        self._waiting.discard(promised)
        try:
            if error is None:
                promised.set_result(result)
            else:
                promised.set_exception(error)
        except InvalidStateError:
            pass  # cancelled, or given up before

    def _look(self) -> None:
        last_seen = time.monotonic()
        while not self._closed.wait(LOOK_SECONDS):
            if self._client.status not in ("running", "connecting"):
                self._give_up(messages.SCHEDULER_LOST(address=self._address))
            elif self._has_workers():
                last_seen = time.monotonic()
            elif time.monotonic() - last_seen > PATIENCE_SECONDS:
                self._give_up(messages.WORKERS_LOST(address=self._address, seconds=PATIENCE_SECONDS))

    def _has_workers(self) -> bool:
        try:
            return bool(self._client.nthreads())
        except (OSError, ValueError):  # the connection is down; Dask tries to have it again
            return False

    def _give_up(self, why: Message) -> None:
        for promised in list(self._waiting):
            self._settle(promised, WorkersLostError(why))
