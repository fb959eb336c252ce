"""Records in a folder, a file each: there whole or not at all, whatever ends the process that writes them.

Whoever sees the folder reads and writes its ``RecordFiles``, be it a thread or another machine. As a ``RecordFolder``
one process at a time has it, which knows what its records are of.
"""
from __future__ import annotations

import errno
import os
import shutil
import stat
import sys
import zlib
from contextlib import ExitStack, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO
from uuid import uuid4

from . import messages
from .errors import SettingsError

if sys.platform == "win32":
    import msvcrt

    def _lock(file: BinaryIO) -> None:
        """Raises PermissionError where another process has it."""
        msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
else:
    import fcntl

    def _lock(file: BinaryIO) -> None:
        """Raises BlockingIOError where another process has it."""
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)


_CHECKSUM_BYTES = 4
_MOST_BYTES = 2**30  # of a record; the largest of ours is a twentieth of it
_ABOUT, _LOCK, _UNFINISHED = ".about", ".lock", ".unfinished-"
"""Names of what is no record, which begin with a dot: what the records are of, the lock, unfinished files."""


@dataclass(frozen=True)
class RecordFiles:
    """Payloads by name. Names are words and numbers of ours; links, pipes and folders by these names are no records."""

    folder: Path

    @property
    def names(self) -> set[str]:
        """Names of all there is: nothing where the folder is not, as its disk may be gone. Whoever saves is told."""
        with suppress(OSError), os.scandir(self.folder) as entries:
            files = [entry.name for entry in entries if entry.is_file(follow_symlinks=False)]
            return {name for name in files if not name.startswith(".")}
        return set()

    def save(self, name: str, payload: bytes, is_synced: bool = False) -> None:
        """Keep a payload in the place of an earlier one; it outlives the process, and if ``is_synced`` the power.

        Raises OSError: FileNotFoundError where nobody sees the folder from here, as without the shared disk.
        """
        unfinished = self.folder / f"{_UNFINISHED}{uuid4().hex}"
        try:
            with open(unfinished, "xb") as file:
                file.write(payload)
                file.write(zlib.crc32(payload).to_bytes(_CHECKSUM_BYTES, "little"))
                if is_synced:
                    file.flush()
                    os.fsync(file.fileno())
            os.replace(unfinished, self.folder / name)
        except OSError:
            with suppress(OSError):
                unfinished.unlink()
            raise

    def load(self, name: str) -> bytes | None:
        """The payload, None where there is none. Raises OSError where it can't be read, or the disk damaged it."""
        path = self.folder / name
        try:
            status = path.lstat()
        except FileNotFoundError:
            return None
        held = path.read_bytes() if stat.S_ISREG(status.st_mode) and status.st_size <= _MOST_BYTES else b""
        payload, checksum = held[:-_CHECKSUM_BYTES], held[-_CHECKSUM_BYTES:]
        if zlib.crc32(payload).to_bytes(_CHECKSUM_BYTES, "little") != checksum:
            raise OSError(errno.EIO, os.strerror(errno.EIO))
        return payload

    def forget(self, name: str) -> None:
        """There is none of that name any more. Raises OSError."""
        with suppress(FileNotFoundError):
            (self.folder / name).unlink()


class RecordFolder:
    """Records of one thing, for this process alone; the lock ends with it. Made when it is not there."""

    def __init__(self, folder: Path, kind: str, of: str = "") -> None:
        """``kind``: what such folders are for; ``of``: what the records are of, in one line. Records of something else
        are deleted, and what one is that was not written whole.

        Raises OSError where nothing can be written, SettingsError where another process has the folder, or something
        else is there, which is left as it is.
        """
        self.files = RecordFiles(folder)
        self.was_of: str | None = None
        """What the records there were of."""
        self._lock = _locked(folder)
        with ExitStack() as stack:
            stack.callback(self.close)
            about = self.files.load(_ABOUT)
            if about is not None:
                was_kind, _, self.was_of = about.decode(errors="replace").partition("\n")
                if was_kind != kind:
                    raise SettingsError(messages.RECORDS_FOREIGN())
            for unfinished in folder.glob(f"{_UNFINISHED}*"):
                unfinished.unlink()
            if self.was_of != of:
                for name in self.files.names:
                    self.files.forget(name)
                self.files.save(_ABOUT, f"{kind}\n{of}".encode(), is_synced=True)
            stack.pop_all()

    def close(self) -> None:
        """Let go of the folder, which stays."""
        self._lock.close()

    def remove(self) -> None:
        """Delete all of it, records first: if the process dies meanwhile, what is left is still known as ours."""
        for name in self.files.names:
            with suppress(OSError):
                self.files.forget(name)
        if os.name == "nt":  # where no open file can be deleted
            self.close()
        shutil.rmtree(self.files.folder, ignore_errors=True)
        self.close()
        with suppress(OSError):  # on a disk of the network, where the lock took room in it until now
            self.files.folder.rmdir()


def _locked(folder: Path) -> BinaryIO:
    """The lock in a folder, which is made when it is not there. Raises OSError, SettingsError."""
    while True:
        with suppress(FileExistsError):
            folder.mkdir()
        if folder.is_symlink() or not folder.is_dir():
            raise SettingsError(messages.RECORDS_FOREIGN())
        names = os.listdir(folder)
        if _ABOUT not in names and not all(name.startswith((_LOCK, _UNFINISHED)) for name in names):
            raise SettingsError(messages.RECORDS_FOREIGN())
        flags = os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0)  # a link in a folder of somebody else
        with ExitStack() as stack:
            file = stack.enter_context(os.fdopen(os.open(folder / _LOCK, flags, 0o666), "r+b", buffering=0))
            try:
                _lock(file)
            except (BlockingIOError, PermissionError):
                raise SettingsError(messages.RECORDS_IN_USE()) from None
            with suppress(FileNotFoundError):  # another process removed it between our opening and our lock
                if os.path.samestat(os.fstat(file.fileno()), os.stat(folder / _LOCK)):
                    stack.pop_all()
                    return file
