"""A record file with a thread of its own, so that nobody waits for a slow disk."""
from __future__ import annotations

import contextlib
import time
from concurrent.futures import Future, ThreadPoolExecutor, wait
from pathlib import Path
from typing import Any, Callable

from ..errors import SeamInspectorError
from .record_file import RecordFile

_SYNC_SECONDS = 2.0  # of work that may be lost when the power fails; a process that dies loses nothing
_MOST_WASTE = 2  # times the payloads that count, and
_LEAST_SIZE = 2**20  # bytes: a file this small is left as it is


class RecordKeeper:
    """Does in turn what it is asked. The file is opened, and made, by the first thing that needs it."""

    def __init__(
        self, path: Path, magic: bytes, failed: Callable[[object], None], replaced: bytes | None = None
    ) -> None:
        """``failed`` is told from the thread why something can't be kept: a text or a Message. A file that begins with
        ``replaced``, as those of other versions do, is begun anew.
        """
        self.path = path
        self._magic = magic
        self._replaced = replaced
        self._failed = failed
        self._file: RecordFile | None = None
        self._synced = time.monotonic()
        self._last: Future[Any] | None = None  # of all that was asked
        self._worker = ThreadPoolExecutor(1, "keeper")
        self._syncer = ThreadPoolExecutor(1, "syncer")  # apart, as it takes the longest and nobody waits for it

    def save(self, key: str, make: Callable[[], bytes]) -> None:
        """Keep the payload that ``make`` makes in the thread."""
        self._do(lambda: self._save(key, make()))

    def load(self, key: str) -> bytes | None:
        """The payload, with all that was asked before; None where there is none."""
        found: bytes | None = self._do(lambda: self._load(key)).result()
        return found

    def holds(self, key: str) -> bool:
        """Whether a payload is in the file by now, be it an earlier one; nobody is waited for."""
        return self._file is not None and self._file.holds(key)

    def all(self) -> dict[str, bytes]:
        """All payloads; none where there is no file, or it can't be had."""
        found: dict[str, bytes] | None = self._do(self._all).result()
        return found or {}

    def remove(self) -> None:
        """Delete the file; it is made again when there is something to keep."""
        self._do(self._remove)

    def compact(self) -> None:
        """Write a file anew that is mostly of payloads which count no more."""
        self._do(self._compact)

    def flush(self) -> None:
        """Wait until all that was asked is done."""
        self._do(lambda: None).result()

    def wait(self, seconds: float) -> None:
        """Wait, but no longer than that, until all that was asked is done."""
        if self._last is not None:
            wait([self._last], seconds)

    def close(self) -> None:
        """Do what was asked, and let go of the file."""
        self._do(self._close)
        self._worker.shutdown()
        self._syncer.shutdown()

    # In the thread

    def _do(self, work: Callable[[], Any]) -> Future[Any]:
        self._last = asked = self._worker.submit(self._guarded, work)
        return asked

    def _guarded(self, work: Callable[[], Any]) -> Any:
        try:
            return work()
        except OSError as error:
            self._failed(error.strerror or str(error))
        except SeamInspectorError as error:
            self._failed(error.message)
        return None

    def _opened(self) -> RecordFile:
        if self._file is None:
            self._file = RecordFile(self.path, self._magic, self._replaced)
        return self._file

    def _save(self, key: str, payload: bytes) -> None:
        file = self._opened()
        file.save(key, payload)
        if time.monotonic() - self._synced > _SYNC_SECONDS:
            self._synced = time.monotonic()
            self._syncer.submit(_sync, file)

    def _is_there(self) -> bool:
        return self._file is not None or self.path.is_file()

    def _load(self, key: str) -> bytes | None:
        return self._opened().load(key) if self._is_there() else None

    def _all(self) -> dict[str, bytes]:
        return dict(self._opened().items()) if self._is_there() else {}

    def _remove(self) -> None:
        if self._file is not None:
            self._file.remove()
            self._file = None

    def _compact(self) -> None:
        if not self._is_there():
            return
        file = self._opened()
        if file.size > max(_LEAST_SIZE, _MOST_WASTE * file.used):
            held = dict(file.items())  # appended to an empty file: what a crash here costs is measured again
            file.clear()
            for key, payload in held.items():
                file.save(key, payload)

    def _close(self) -> None:
        if self._file is not None:
            _sync(self._file)
            self._file.close()
            self._file = None


def _sync(file: RecordFile) -> None:
    with contextlib.suppress(OSError, ValueError):  # a disk that can't, or a file that is closed by now
        file.sync()
