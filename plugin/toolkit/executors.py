"""Where windows are measured: threads of this machine, or a Dask cluster."""
from __future__ import annotations

import os
import tempfile
import zipfile
from collections.abc import Iterator
from concurrent.futures import Executor, ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path

from ..imagery.errors import SettingsError
from . import messages

_ANSWER_SECONDS = 10
_FORGET = f"""
import sys
for name in [name for name in sys.modules if name.partition(".")[0] == {__name__.partition(".")[0]!r}]:
    del sys.modules[name]
"""  # else workers that met an older version of the plugin would go on with its code
_MEASURING = ("*/__init__.py", "imagery/**/*.py", "*/measure/**/*.py")
_AHEAD = 2  # windows under way per worker: one is measured while the next waits


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
    workers = os.cpu_count() or 1
    with ThreadPoolExecutor(workers, thread_name_prefix="seam-inspector") as executor:
        yield executor, _AHEAD * workers


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
        client.run(exec, _FORGET)
        with tempfile.TemporaryDirectory() as folder:
            client.upload_file(_measuring_archive(Path(folder)))
        threads = sum(client.nthreads().values())
        if not threads:
            raise SettingsError(messages.SCHEDULER_WITHOUT_WORKERS(address=scheduler))
        yield client.get_executor(), _AHEAD * threads


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
        for module in sorted({found for part in _MEASURING for found in plugin.glob(part)}):
            file.write(module, "/".join([*package, *module.relative_to(plugin).parts]))
    return str(archive)
