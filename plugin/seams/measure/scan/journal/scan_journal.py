"""What a scan has measured so far, on disk, so that one that was stopped in any way goes on where it was.

The file: ``_MAGIC``, a record whose key is empty and whose payload is the fingerprint, then a record for each result.
Records are those of ``imagery/records``. Only ever appended to.
"""
from __future__ import annotations

import contextlib
import errno
import os
import time
from collections.abc import KeysView
from pathlib import Path
from typing import BinaryIO

from .....imagery.errors import SettingsError, system_reason
from .....imagery.message import Message
from .....imagery.records.file_lock import lock_file, remove_locked
from .....imagery.records.own_file import open_own_file
from .....imagery.records.record_bytes import append_record, is_cut_off, read_all, record_at, record_size, write_all
from .. import messages
from .scan_fingerprint import what_changed

MOST_LOST_SECONDS = 2.0
"""Of work, when the power fails: to wait for the disk at every block would take longer than to put the block there."""

_MAGIC = b"Seam Inspector: journal of a scan, 2\n"
_SMALL = 65536  # a journal that was killed before its fingerprint was on the disk is no larger


def open_journal(path: Path, fingerprint: str) -> tuple[ScanJournal, Message | None]:
    """The journal in a file, for this scan alone, and what the user should know of an earlier one there.

    An earlier scan of the same ``fingerprint`` goes on: what its process had not written whole when it died is
    dropped, and so is all from a damaged place on. Of another fingerprint nothing is kept.

    Raises SettingsError where no file can be, another scan has it open, or it is something else.
    """
    try:
        file = _opened(path)
        try:
            return _resumed(path, file, fingerprint)
        except BaseException:
            file.close()
            raise
    except OSError as error:
        raise SettingsError(messages.SCAN_JOURNAL_NOT_OPENED(path=path, error=system_reason(error))) from None


class ScanJournal:
    """Results by their keys. For one thread; the lock on its file ends with it, or with the process."""

    def __init__(self, path: Path, file: BinaryIO, places: dict[str, int], end: int) -> None:
        self.path = path
        self._file, self._places, self._end = file, places, end
        self._on_disk = time.monotonic()

    @property
    def keys(self) -> KeysView[str]:
        """What is done, in the order in which it was."""
        return self._places.keys()

    def load(self, key: str) -> bytes:
        """A result. Raises KeyError where it is not done, SettingsError when the disk lost it meanwhile."""
        place = self._places[key]
        try:
            found = record_at(self._file, place, self._end)
        except OSError as error:
            raise SettingsError(messages.SCAN_JOURNAL_NOT_READ(path=self.path, error=system_reason(error))) from None
        if found is None or found[0] != key:
            reason = system_reason(OSError(errno.EIO, os.strerror(errno.EIO)))
            raise SettingsError(messages.SCAN_JOURNAL_NOT_READ(path=self.path, error=reason))
        return found[1]

    def save(self, key: str, payload: bytes) -> None:
        """Keep a result. A key that is there gets the new one.

        What is saved outlives the process; of what was saved last, ``MOST_LOST_SECONDS`` may be lost with the power.

        Raises SettingsError when the disk is full; what was saved before stays, and more may be tried.
        """
        try:
            end = append_record(self._file, self._end, key, payload)
            if time.monotonic() - self._on_disk > MOST_LOST_SECONDS:
                os.fsync(self._file.fileno())
                self._on_disk = time.monotonic()
        except OSError as error:
            with contextlib.suppress(OSError):  # what is left of it is dropped when the file is opened again
                self._file.truncate(self._end)
            raise SettingsError(
                messages.SCAN_JOURNAL_NOT_SAVED(path=self.path, error=system_reason(error), done=len(self._places))
            ) from None
        self._places[key], self._end = self._end, end

    def close(self) -> None:
        """Let go of the file, which stays for a scan that goes on."""
        with contextlib.suppress(OSError):
            self._file.close()

    def remove(self) -> None:
        """Delete the file, as its scan is complete."""
        remove_locked(self._file, self.path)


def _opened(path: Path) -> BinaryIO:
    """The file, made if there is none, with the lock on it. Raises OSError, or SettingsError when another has it."""
    while True:
        file = open_own_file(path)
        try:
            if not lock_file(file):
                raise SettingsError(messages.SCAN_JOURNAL_IN_USE(path=path))
            with contextlib.suppress(FileNotFoundError):
                if os.path.samestat(os.fstat(file.fileno()), path.stat()):
                    return file
        except OSError as error:
            file.close()
            raise SettingsError(
                messages.SCAN_JOURNAL_NOT_LOCKED(path=path, error=system_reason(error))
            ) from None
        except BaseException:
            file.close()
            raise
        file.close()  # another scan removed it as it ended, between our opening and our lock


def _resumed(path: Path, file: BinaryIO, fingerprint: str) -> tuple[ScanJournal, Message | None]:
    """What is whole in the file, cut after it. Raises OSError; SettingsError for a file that is no journal."""
    size = os.fstat(file.fileno()).st_size
    start = read_all(file, len(_MAGIC))
    was_never_whole = start != _MAGIC and size <= _SMALL and _MAGIC.startswith(_whole_text(file).rstrip(b"\0"))
    if start != _MAGIC and not was_never_whole:
        raise SettingsError(messages.SCAN_JOURNAL_FOREIGN(path=path))
    first = record_at(file, len(_MAGIC), size) if start == _MAGIC else None
    if first is None or first[0] or first[1] != fingerprint.encode():
        lost = start == _MAGIC and not is_cut_off(file, len(_MAGIC), size)
        journal = _anew(path, file, fingerprint)
        if first is not None:
            return journal, messages.SCAN_ANEW(what=what_changed(first[1].decode(errors="replace"), fingerprint))
        return journal, messages.SCAN_ANEW_DAMAGED(path=path) if lost else None
    places: dict[str, int] = {}
    end = len(_MAGIC) + record_size(*first)
    while (record := record_at(file, end, size)) is not None:
        places[record[0]] = end
        end += record_size(*record)
    damaged = not is_cut_off(file, end, size)
    file.truncate(end)
    journal = ScanJournal(path, file, places, end)
    if damaged:
        return journal, messages.SCAN_JOURNAL_DAMAGED(path=path, done=len(places))
    return journal, messages.SCAN_GOES_ON(done=len(places)) if places else None


def _anew(path: Path, file: BinaryIO, fingerprint: str) -> ScanJournal:
    """Raises OSError."""
    file.truncate(0)
    file.seek(0)
    write_all(file, _MAGIC)
    end = append_record(file, len(_MAGIC), "", fingerprint.encode())
    if os.name != "nt":  # so that the name of the file, too, is on the disk
        folder = os.open(path.parent, os.O_RDONLY)
        try:
            with contextlib.suppress(OSError):  # some network disks know no such thing
                os.fsync(folder)
        finally:
            os.close(folder)
    return ScanJournal(path, file, {}, end)


def _whole_text(file: BinaryIO) -> bytes:
    file.seek(0)
    return read_all(file, _SMALL)
