"""Payloads by key in a file that is only appended to, of which one process at a time has the writing."""
from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO

from .. import messages
from ..errors import SettingsError
from .file_lock import lock_file, remove_locked
from .own_file import open_own_file
from .record_bytes import append_record, is_cut_off, read_all, record_at, record_ends, write_all


class RecordFile:
    """Made when it is not there. Of equal keys the last one counts; an empty payload stands for none.

    What was not written whole when the process died is dropped. A record that the disk damaged is as if it were not
    there, and stays in the file as it is. For one thread. All methods raise OSError; the constructor SettingsError too,
    where another process has the file open, or it is something else.
    """

    def __init__(self, path: Path, magic: bytes, replaced: bytes | None = None) -> None:
        """``magic`` is what such files begin with, their kind and version; one that begins with ``replaced`` is of
        another version whose payloads are given up.
        """
        self.path, self._magic, self._replaced = path, magic, replaced
        self._file: BinaryIO = open_own_file(path)
        try:
            with contextlib.suppress(OSError):  # a disk that knows no locks
                if not lock_file(self._file):
                    raise SettingsError(messages.RECORDS_IN_USE())
            self._open()
        except BaseException:
            self._file.close()
            raise

    def _open(self) -> None:
        size = os.fstat(self._file.fileno()).st_size
        start = read_all(self._file, len(self._magic))
        if start != self._magic:
            is_replaced = self._replaced is not None and start.startswith(self._replaced)
            if not is_replaced and not self._magic.startswith(start.rstrip(b"\0")):
                raise SettingsError(messages.RECORDS_FOREIGN())
            self._file.truncate(0)
            self._file.seek(0)
            write_all(self._file, self._magic)
            size = len(self._magic)
        self._places: dict[str, int] = {}
        self._sizes: dict[str, int] = {}
        self._end, self.is_damaged = len(self._magic), False
        for key, place, length, end in record_ends(self._file, self._end, size):
            self.is_damaged |= place != self._end
            self._note(key, place, length)
            self._end = end
        if is_cut_off(self._file, self._end, size):
            self._file.truncate(self._end)
        else:
            self.is_damaged, self._end = True, size

    @property
    def keys(self) -> list[str]:
        """Those with a payload, in the order in which they came first."""
        return list(self._places)

    @property
    def size(self) -> int:
        """Bytes of the file."""
        return self._end

    @property
    def used(self) -> int:
        """Bytes of the payloads that count."""
        return sum(self._sizes.values())

    def load(self, key: str) -> bytes | None:
        """The payload; None where there is none, or it was damaged."""
        if key not in self._places:
            return None
        found = record_at(self._file, self._places[key], self._end)
        return found[1] if found is not None and found[0] == key else None

    def holds(self, key: str) -> bool:
        """Whether there is a payload, which may be damaged. For any thread."""
        return key in self._places

    def items(self) -> Iterator[tuple[str, bytes]]:
        """All that can be read."""
        for key in self.keys:
            if (payload := self.load(key)) is not None:
                yield key, payload

    def save(self, key: str, payload: bytes) -> None:
        """Keep a payload in the place of an earlier one; it outlives the process at once, and the power after sync."""
        try:
            end = append_record(self._file, self._end, key, payload)
        except OSError:
            with contextlib.suppress(OSError):
                self._file.truncate(self._end)
            raise
        self._note(key, self._end, len(payload))
        self._end = end

    def sync(self) -> None:
        """Wait for the disk."""
        os.fsync(self._file.fileno())

    def clear(self) -> None:
        """Forget all payloads."""
        self._end = len(self._magic)
        self._file.truncate(self._end)
        self._places.clear()
        self._sizes.clear()

    def close(self) -> None:
        """Let go of the file."""
        with contextlib.suppress(OSError):
            self._file.close()

    def remove(self) -> None:
        """Delete the file."""
        remove_locked(self._file, self.path)

    def _note(self, key: str, place: int, length: int) -> None:
        if length:
            self._places[key], self._sizes[key] = place, length
        else:
            self._places.pop(key, None)
            self._sizes.pop(key, None)
