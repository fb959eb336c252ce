"""Where windows are measured: threads of this machine, or a Dask cluster."""
from __future__ import annotations

import tempfile
import zipfile
from collections.abc import Iterator
from concurrent.futures import Executor
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from ..imagery.errors import SettingsError
from ..imagery.raster_pool import ahead_of, own_threads
from . import messages
from .watched_executor import WatchedExecutor

if TYPE_CHECKING:
    from distributed import Client

_ANSWER_SECONDS = 10
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
def open_executor(scheduler: str = "") -> Iterator[tuple[Executor, int]]:
    """An executor and how many windows it should have under way.

    Without a ``scheduler`` (address of a Dask scheduler) the windows run in one thread per core.

    Raises SettingsError when Dask is not installed or the scheduler does not answer.
    """
    if scheduler:
        with _dask_executor(scheduler) as opened:
            yield opened
        return
    with own_threads() as opened:
        yield opened


@contextmanager
def _dask_executor(scheduler: str) -> Iterator[tuple[Executor, int]]:
    try:
        from distributed import Client
    except ImportError:
        raise SettingsError(messages.DASK_MISSING()) from None
    try:
        client = Client(scheduler, timeout=_ANSWER_SECONDS)
    except (OSError, ValueError, TypeError) as error:
        raise SettingsError(messages.SCHEDULER_SILENT(address=scheduler, error=error)) from None
    with client:
        threads = sum(client.nthreads().values())
        if not threads:
            raise SettingsError(messages.SCHEDULER_WITHOUT_WORKERS(address=scheduler))
        _prepare(client, scheduler)
        executor = WatchedExecutor(client, scheduler)
        try:
            yield executor, ahead_of(threads)
        finally:
            executor.shutdown()
            if client.status == "running":
                client.run(exec, _CLOSE, on_error="ignore")


def _prepare(client: Client, scheduler: str) -> None:
    """Give the workers this plugin's code, whatever they have of it; those that come later get it, too.

    A worker that is lost costs its windows' time only: Dask gives them to others.
    """
    lacking = client.run(eval, _MISSING.format(needed=_NEEDED))
    missing = sorted({name for names in lacking.values() for name in names})
    if missing:
        raise SettingsError(messages.WORKERS_WITHOUT_PACKAGES(address=scheduler, packages=", ".join(missing)))
    client.run(exec, _FORGET)
    with tempfile.TemporaryDirectory() as folder:
        client.upload_file(_measuring_archive(Path(folder)))


def measuring_modules(plugin: Path) -> list[Path]:
    """The files below the plugin's folder that measure, with what makes them packages: no QGIS, no charts."""
    return sorted({found for part in _MEASURING for found in plugin.glob(part)})


def _measuring_archive(folder: Path) -> str:
    """All that measures as an importable zip for the workers, which need neither QGIS nor this plugin.

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
