"""What a scan has measured so far, on disk, so that one that was stopped in any way goes on where it was."""
from __future__ import annotations

import errno
import os
import time
from collections.abc import KeysView
from pathlib import Path

from .....imagery import messages as imagery_messages
from .....imagery.errors import Message, SettingsError
from .....imagery.messages import system_reason
from .....imagery.record_store import RecordStore
from .. import messages
from .scan_fingerprint import what_changed

MOST_LOST_SECONDS = 2.0
"""Of work, when the power fails: to wait for the disk at every block would take longer than to put the block there."""

_KIND = "Seam Inspector: journal of a scan, "
_VERSION = "3"
_FINGERPRINT = ""  # the key of what the scan is of


def open_journal(path: Path, fingerprint: str) -> tuple[ScanJournal, Message | None]:
    """The journal in a file, for this scan alone, and what the user should know of an earlier one there.

    An earlier scan of the same ``fingerprint`` goes on: what its process had not written whole when it died is
    dropped. Of another fingerprint nothing is kept.

    Raises SettingsError where no file can be, another scan has it open, or it is something else.
    """
    try:
        store = _opened(path)
        held = store.load(_FINGERPRINT)
        if held == fingerprint.encode():
            done = len(store.keys) - 1
            return ScanJournal(store), messages.SCAN_GOES_ON(done=done) if done else None
        is_damaged = store.was_damaged or (bool(store.keys) and held is None)
        if store.keys:
            store.remove()
            store = _opened(path)
        store.save(_FINGERPRINT, fingerprint.encode())
    except OSError as error:
        raise SettingsError(messages.SCAN_JOURNAL_NOT_OPENED(path=path, error=system_reason(error))) from None
    if held is not None:
        return ScanJournal(store), messages.SCAN_ANEW(what=what_changed(held.decode(errors="replace"), fingerprint))
    return ScanJournal(store), messages.SCAN_ANEW_DAMAGED(path=path) if is_damaged else None


class ScanJournal:
    """Results by their keys. For one thread; the lock on its file ends with it, or with the process."""

    def __init__(self, store: RecordStore) -> None:
        self._store = store
        self._done = {key: None for key in store.keys if key != _FINGERPRINT}
        self._on_disk = time.monotonic()

    @property
    def path(self) -> Path:
        """Of its file."""
        return self._store.path

    @property
    def keys(self) -> KeysView[str]:
        """What is done, in the order in which it was."""
        return self._done.keys()

    def load(self, key: str) -> bytes:
        """A result. Raises KeyError where it is not done, SettingsError when the disk lost it meanwhile."""
        if key not in self._done:
            raise KeyError(key)
        try:
            found = self._store.load(key)
            if found is None:
                self.forget(key)  # the next run measures it again
                raise OSError(errno.EIO, os.strerror(errno.EIO))
        except OSError as error:
            raise SettingsError(messages.SCAN_JOURNAL_NOT_READ(path=self.path, error=system_reason(error))) from None
        return found

    def forget(self, key: str) -> None:
        """A result is worth nothing. Raises SettingsError when the disk refuses."""
        try:
            self._store.forget(key)
            self._done.pop(key, None)
        except OSError as error:
            raise SettingsError(messages.SCAN_JOURNAL_NOT_READ(path=self.path, error=system_reason(error))) from None

    def save(self, key: str, payload: bytes) -> None:
        """Keep a result. A key that is there gets the new one.

        What is saved outlives the process; of what was saved last, ``MOST_LOST_SECONDS`` may be lost with the power.

        Raises SettingsError when the disk is full; what was saved before stays, and more may be tried.
        """
        try:
            self._store.save(key, payload)
            if time.monotonic() - self._on_disk > MOST_LOST_SECONDS:
                self._store.sync()
                self._on_disk = time.monotonic()
            self._done[key] = None
        except OSError as error:
            raise SettingsError(messages.SCAN_JOURNAL_NOT_SAVED(
                path=self.path, error=system_reason(error), done=len(self._done)
            )) from None

    def close(self) -> None:
        """Let go of the file, which stays for a scan that goes on."""
        self._store.close()

    def remove(self) -> None:
        """Delete the file, as its scan is complete."""
        self._store.remove()


def _opened(path: Path) -> RecordStore:
    """The store, made if there is none. Raises OSError, or SettingsError when another scan has it, or it is something
    else."""
    try:
        return RecordStore(path, _KIND + _VERSION, _KIND)
    except SettingsError as error:
        if error.message.template == imagery_messages.RECORDS_IN_USE.template:
            raise SettingsError(messages.SCAN_JOURNAL_IN_USE(path=path)) from None
        raise SettingsError(messages.SCAN_JOURNAL_FOREIGN(path=path)) from None
