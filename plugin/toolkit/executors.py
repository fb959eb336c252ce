"""Who measures: threads of this machine, any executor, or a Dask cluster that is watched for lost workers."""
from __future__ import annotations

import asyncio
import concurrent.futures
import tempfile
import time
import zipfile
from collections.abc import Iterator
from concurrent.futures import Executor, Future
from contextlib import contextmanager, suppress
from pathlib import Path
from threading import Event, Thread
from typing import TYPE_CHECKING, Any, Callable, Union

from ..imagery.errors import CancelledError, Message, SettingsError, WorkersLostError
from ..imagery.messages import CANCELLED
from ..imagery.raster_pool import AHEAD, own_threads
from . import messages

if TYPE_CHECKING:
    from distributed import Client

Crew = Union[Executor, "Client", str, None]
"""An executor, a client of a Dask cluster, the address of its scheduler, or a thread per core."""

_ANSWER_SECONDS = 10.0  # to the scheduler, until it is known that it is one
_PREPARING_SECONDS = 120.0  # for all workers to take the code
_CANCELLED_EVERY_SECONDS = 0.1  # is asked for
PATIENCE_SECONDS = 120.0  # without any worker: long enough for those that were lost to be started anew
LOOK_SECONDS = 5.0  # between two looks at the cluster
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
    crew: Crew = None, is_cancelled: Callable[[], bool] = lambda: False
) -> Iterator[tuple[Executor, int]]:
    """An executor and how many windows it should have under way.

    Raises SettingsError for a cluster that can't be used, CancelledError, and WorkersLostError when nobody is left.
    """
    if isinstance(crew, str) and crew:
        with _connected(crew, is_cancelled) as client, _watched(client, is_cancelled) as opened:
            yield opened
    elif crew and not isinstance(crew, Executor):
        if not hasattr(crew, "get_executor"):
            raise SettingsError(messages.NO_EXECUTOR(given=type(crew).__name__))
        if crew.status == "closed":
            raise WorkersLostError(messages.EXECUTOR_LOST())
        with _watched(crew, is_cancelled) as opened:
            yield opened
    else:
        with own_threads(crew or None) as opened:
            try:
                yield opened
            except (RuntimeError, concurrent.futures.CancelledError) as error:
                if isinstance(error, RuntimeError) and _takes_work(opened[0]):
                    raise
                raise WorkersLostError(messages.EXECUTOR_LOST()) from None


def _takes_work(executor: Executor) -> bool:
    """Whether it was neither shut down nor broken, for which Python has the same error as for all else."""
    with suppress(RuntimeError):
        executor.submit(int)
        return True
    return False


@contextmanager
def _connected(address: str, is_cancelled: Callable[[], bool]) -> Iterator[Client]:
    """A client of the scheduler. Whatever else answers, or does not, is left to itself after a time."""
    try:
        from distributed import Client
    except ImportError:
        raise SettingsError(messages.DASK_MISSING()) from None
    asking = _started(lambda: asyncio.run(asyncio.wait_for(_check_scheduler(address), _ANSWER_SECONDS)))
    is_answered = _is_done(asking, _ANSWER_SECONDS, is_cancelled)
    try:
        asking.result(_ANSWER_SECONDS if is_answered else 0)
        client = Client(address, timeout=_ANSWER_SECONDS)
    except SettingsError:
        raise
    except Exception as silent:  # whatever Dask makes of bytes that are none of its own, too
        why = str(silent) or f"{_ANSWER_SECONDS:.0f} s"
        raise SettingsError(messages.SCHEDULER_SILENT(address=address, error=why)) from None
    try:
        yield client
    finally:
        client.close(_ANSWER_SECONDS)


async def _check_scheduler(address: str) -> None:
    """Dask's client has no limit of time for the first words, and breaks off where versions differ. Raises anything."""
    from distributed.comm.core import connect
    from distributed.security import Security

    comm = await connect(address, timeout=_ANSWER_SECONDS, **Security().get_connection_args("client"))
    try:
        await comm.write({"op": "identity", "reply": True})
        if (await comm.read())["type"] != "Scheduler":
            raise TypeError(address)
        await comm.write({"op": "versions", "reply": True})
        _check_versions(address, await comm.read())
    finally:
        comm.abort()


def _check_versions(address: str, *answers: dict[str, Any]) -> None:
    """Raise SettingsError where another version of Dask answers, by what Dask tells of versions."""
    from distributed import __version__ as own

    versions = {str(answer["packages"]["distributed"]) for answer in answers} - {own}
    if versions:
        raise SettingsError(messages.DASK_VERSIONS(address=address, versions=", ".join(sorted(versions)), own=own))


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


@contextmanager
def _watched(client: Client, is_cancelled: Callable[[], bool]) -> Iterator[tuple[Executor, int]]:
    """Dask gives the work of a lost worker to others; where none is left for long, all that waits ends."""
    address = client.scheduler.address
    preparing = _started(lambda: _prepare(client, address))
    if not _is_done(preparing, _PREPARING_SECONDS, is_cancelled):
        raise SettingsError(messages.WORKERS_SILENT(address=address, seconds=_PREPARING_SECONDS))
    if isinstance(preparing.exception(), OSError):
        raise SettingsError(messages.SCHEDULER_LOST(address=address))
    executor, ended = client.get_executor(), Event()
    lost: list[Message] = []

    def watch() -> None:
        if (why := _why_lost(client, address, ended)) is not None:
            lost.append(why)
            executor.shutdown(wait=False)

    Thread(target=watch, name="seam-inspector-cluster", daemon=True).start()
    try:
        yield executor, AHEAD * preparing.result()
    except Exception as error:
        if lost or isinstance(error, concurrent.futures.CancelledError):  # else nobody has cancelled them
            raise WorkersLostError((lost or [messages.SCHEDULER_LOST(address=address)])[0]) from None
        raise
    finally:
        ended.set()
        if client.status == "running":
            executor.shutdown(wait=False)
            _is_done(_started(lambda: client.run(exec, _CLOSE, on_error="ignore")), _ANSWER_SECONDS)


def _why_lost(client: Client, address: str, ended: Event) -> Message | None:
    """Why nobody is left to measure, as soon as that is so; None once all is done."""
    last_seen = time.monotonic()
    while not ended.wait(LOOK_SECONDS):
        if client.status not in ("running", "connecting"):
            return messages.SCHEDULER_LOST(address=address)
        with suppress(OSError, ValueError):  # the connection is down; Dask tries to have it again
            if client.nthreads():
                last_seen = time.monotonic()
        if time.monotonic() - last_seen > PATIENCE_SECONDS:
            return messages.WORKERS_LOST(address=address, seconds=PATIENCE_SECONDS)
    return None


def _prepare(client: Client, address: str) -> int:
    """Give the workers this plugin's code, later ones too, whatever they have of it. How many threads they have."""
    threads = sum(client.nthreads().values())
    if not threads:
        raise SettingsError(messages.SCHEDULER_WITHOUT_WORKERS(address=address))
    versions = client.get_versions()
    _check_versions(address, versions["scheduler"], *versions["workers"].values())
    lacking = client.run(eval, _MISSING.format(needed=_NEEDED))
    missing = sorted({name for names in lacking.values() for name in names})
    if missing:
        raise SettingsError(messages.WORKERS_WITHOUT_PACKAGES(address=address, packages=", ".join(missing)))
    client.run(exec, _FORGET)
    with tempfile.TemporaryDirectory() as folder:
        client.upload_file(_measuring_archive(Path(folder)))
    return threads


def measuring_modules(plugin: Path) -> list[Path]:
    """The files below the plugin's folder that measure, with what makes them packages: no QGIS, no charts."""
    return sorted({file for part in _MEASURING for file in plugin.glob(part)})


def _measuring_archive(folder: Path) -> str:
    """An importable zip of all that measures, for workers without this plugin, by the package's full name."""
    plugin = Path(__file__).parent.parent
    package = __package__.split(".")[:-1]
    archive = folder / f"{package[0]}.zip"
    with zipfile.ZipFile(archive, "w") as file:
        for depth in range(1, len(package) + 1):
            file.writestr("/".join([*package[:depth], "__init__.py"]), "")
        for module in measuring_modules(plugin):
            file.write(module, "/".join([*package, *module.relative_to(plugin).parts]))
    return str(archive)
