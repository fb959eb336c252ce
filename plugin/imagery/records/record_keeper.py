"""A store of records with a thread of its own, so that nobody waits for a slow disk."""
from __future__ import annotations

import time
from concurrent.futures import Future, ThreadPoolExecutor, wait
from contextlib import suppress
from pathlib import Path
from typing import Any, Callable

from ..errors import SeamInspectorError
from .record_store import RecordStore

_SYNC_SECONDS = 2.0  # of work that may be lost when the power fails; a process that dies loses nothing


class RecordKeeper:
    """Does in turn what it is asked. The file is opened, and made, by the first thing that needs it."""

    def __init__(
        self, path: Path, kind: str, failed: Callable[[object], None], replaced: str | None = None
    ) -> None:
        """``failed`` is told from the thread why something can't be kept: a text or a Message. A file that begins with
        ``replaced``, as those of other versions do, is begun anew.
        """
        self.path = path
        self._kind = kind
        self._replaced = replaced
        self._failed = failed
        self._file: RecordStore | None = None
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
        return self._file is not None and key in self._file.keys

    def all(self) -> dict[str, bytes]:
        """All payloads; none where there is no file, or it can't be had."""
        found: dict[str, bytes] | None = self._do(self._all).result()
        return found or {}

    def remove(self) -> None:
        """Delete the file; it is made again when there is something to keep."""
        self._do(self._remove)

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

    def _opened(self) -> RecordStore:
        if self._file is None:
            self._file = RecordStore(self.path, self._kind, self._replaced)
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

    def _close(self) -> None:
        if self._file is not None:
            self._file.close()
            self._file = None


def _sync(file: RecordStore) -> None:
    with suppress(OSError):  # a disk that can't
        file.sync()
