"""Payloads by key in a SQLite database of our own, of which one process at a time has the reading and writing.

It is written ahead (WAL), so a process that dies loses nothing that it saved, and a failing power only what was not
synced. The database is locked as a whole, for which SQLite needs no memory that processes share: it may lie on a disk
of the network. A ``RecordKeeper`` has a thread of its own for it, so that nobody waits for a slow disk.
"""
from __future__ import annotations

import contextlib
import errno
import os
import sqlite3
import stat
import time
import zlib
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor, wait
from contextlib import suppress
from pathlib import Path
from typing import Any, BinaryIO, Callable

from . import messages
from .errors import SeamInspectorError, SettingsError

_FLAGS = ("O_BINARY", "O_NOFOLLOW", "O_NONBLOCK")
"""What is not known on every system; of a pipe that nobody writes to the opening would wait for ever."""


def open_own_file(path: Path) -> BinaryIO:
    """Open it for reading and writing, made when it is not there.

    A folder of somebody else may hold links, pipes or devices by the names that we give: raises OSError for these.
    """
    flags = sum(getattr(os, name, 0) for name in _FLAGS)
    if path.is_symlink():  # where the system can't be asked to refuse
        raise OSError(errno.ELOOP, os.strerror(errno.ELOOP))
    file = os.fdopen(os.open(path, os.O_RDWR | os.O_CREAT | flags, 0o666), "r+b", buffering=0)
    if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
        file.close()
        raise OSError(errno.EINVAL, os.strerror(errno.EINVAL))
    return file


_MAKE = (
    "CREATE TABLE about (kind TEXT)",
    "CREATE TABLE records (number INTEGER PRIMARY KEY, key TEXT UNIQUE, checksum INTEGER, payload BLOB)",
)
_SAVE = (
    "INSERT INTO records (key, checksum, payload) VALUES (?, ?, ?)"
    " ON CONFLICT (key) DO UPDATE SET checksum = excluded.checksum, payload = excluded.payload"
)
_MALFORMED = "malformed"  # in what SQLite says of damaged pages
_MOST_KEPT = 64  # MB of what is written ahead, before SQLite itself moves it to its place


class RecordStore:
    """Made when it is not there. Of equal keys the last one counts.

    A record that the disk damaged is as if it were not there. For one thread at a time. All methods raise OSError; the
    constructor SettingsError too, where another process has the store open, or the file is damaged or something else.
    """

    def __init__(self, path: Path, kind: str, replaced: str | None = None) -> None:
        """``kind`` is what such stores are for, and their version. With ``replaced``, what the kinds of all versions
        begin with, the records of another version are given up, and those that can't be read any more
        (``was_damaged``).
        """
        self.path, self.was_damaged = path, False
        while True:
            with open_own_file(path) as own:  # made, and never what a link of that name leads to
                found = os.fstat(own.fileno())
                if replaced is not None and own.read(len(replaced)) == replaced.encode():  # as it was before SQLite
                    own.truncate(0)
            self._database = sqlite3.connect(path, timeout=0, isolation_level=None, check_same_thread=False)
            try:
                with _as_system_errors():
                    self._open(kind, replaced)
            except BaseException as error:
                self._database.close()
                is_damaged = isinstance(error, SettingsError) and error.message == messages.RECORDS_DAMAGED
                if is_damaged and replaced is not None and not self.was_damaged:
                    self.was_damaged = True
                    path.unlink()
                elif _is_at(path, found):
                    if isinstance(error, OSError) and not path.stat().st_size:  # made here, and no room for more
                        path.unlink()
                    raise
            else:
                if _is_at(path, found):
                    return
                self._database.close()  # another process removed it between our opening and our lock

    def _open(self, kind: str, replaced: str | None) -> None:
        try:
            self._database.execute("PRAGMA locking_mode = EXCLUSIVE")
            self._database.execute("BEGIN IMMEDIATE")
            found = self._database.execute("SELECT sql FROM sqlite_master WHERE sql IS NOT NULL")
            made = {statement for (statement,) in found}
            if made and made != set(_MAKE):  # a view by one of our names may never end
                raise SettingsError(messages.RECORDS_FOREIGN())
            held = self._database.execute("SELECT kind FROM about").fetchone() if made else None
        except sqlite3.DatabaseError as error:
            if "locked" in str(error):
                raise SettingsError(messages.RECORDS_IN_USE()) from None
            if "not a database" in str(error):
                raise SettingsError(messages.RECORDS_FOREIGN()) from None
            if _MALFORMED in str(error):
                raise SettingsError(messages.RECORDS_DAMAGED) from None
            raise
        if held != (kind,):
            if made and (held is None or replaced is None or not str(held[0]).startswith(replaced)):
                raise SettingsError(messages.RECORDS_FOREIGN())
            for statement in ("DELETE FROM about", "DELETE FROM records") if made else _MAKE:
                self._database.execute(statement)
            self._database.execute("INSERT INTO about VALUES (?)", (kind,))
        found = self._database.execute("SELECT key FROM records ORDER BY number")
        self._keys = dict.fromkeys(key for (key,) in found)
        self._database.execute("COMMIT")
        self._database.execute("PRAGMA journal_mode = WAL")
        self._database.execute("PRAGMA synchronous = NORMAL")
        self._database.execute(f"PRAGMA wal_autocheckpoint = {_MOST_KEPT * 2**20 // 4096}")

    @property
    def keys(self) -> dict[str, None]:
        """In the order in which they came first. For any thread."""
        return self._keys

    def load(self, key: str) -> bytes | None:
        """The payload; None where there is none, or it was damaged."""
        with _as_system_errors():
            try:
                found = self._database.execute("SELECT checksum, payload FROM records WHERE key = ?", (key,))
                row = found.fetchone()
            except sqlite3.DatabaseError as error:
                if _MALFORMED not in str(error):
                    raise
                return None
        return bytes(row[1]) if row is not None and zlib.crc32(row[1]) == row[0] else None

    def items(self) -> Iterator[tuple[str, bytes]]:
        """All that can be read."""
        for key in list(self._keys):
            if (payload := self.load(key)) is not None:
                yield key, payload

    def save(self, key: str, payload: bytes) -> None:
        """Keep a payload in the place of an earlier one; it outlives the process at once, and the power after sync."""
        with _as_system_errors():
            self._database.execute(_SAVE, (key, zlib.crc32(payload), payload))
        self._keys[key] = None

    def forget(self, key: str) -> None:
        """There is none of that key any more."""
        with _as_system_errors():
            self._database.execute("DELETE FROM records WHERE key = ?", (key,))
        self._keys.pop(key, None)

    def sync(self) -> None:
        """Wait for the disk. For any thread: nobody waits for who does."""
        with contextlib.suppress(FileNotFoundError), open(f"{self.path}-wal", "r+b") as ahead:
            os.fsync(ahead.fileno())

    def close(self) -> None:
        """Let go of the file."""
        with contextlib.suppress(sqlite3.Error):
            self._database.close()

    def remove(self) -> None:
        """Delete the file, before others can have it where the system lets us."""
        try:
            self.path.unlink()
        except OSError:  # on Windows, where no open file can be deleted
            self.close()
            with contextlib.suppress(OSError):
                self.path.unlink()
        self.close()
        with contextlib.suppress(OSError):  # SQLite leaves it where it finds its file gone
            Path(f"{self.path}-wal").unlink()


def _is_at(path: Path, found: os.stat_result) -> bool:
    try:
        return os.path.samestat(found, path.stat())
    except FileNotFoundError:
        return False


@contextlib.contextmanager
def _as_system_errors() -> Iterator[None]:
    """SQLite's as the OSError that they stand for."""
    try:
        yield
    except sqlite3.Error as error:
        number = errno.ENOSPC if "full" in str(error) else errno.EIO
        raise OSError(number, os.strerror(number)) from error


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
        found: bytes | None = self._do(lambda: self._opened().load(key) if self._is_there() else None).result()
        return found

    def holds(self, key: str) -> bool:
        """Whether a payload is in the file by now, be it an earlier one; nobody is waited for."""
        return self._file is not None and key in self._file.keys

    def all(self) -> dict[str, bytes]:
        """All payloads; none where there is no file, or it can't be had."""
        found = self._do(lambda: dict(self._opened().items()) if self._is_there() else {})
        return found.result() or {}

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
