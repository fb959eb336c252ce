"""What was measured of the blocks of a scan: a file each, written by whoever measured it and read by whoever needs it,
be it a thread or another machine."""
from __future__ import annotations

import errno
import os
import shutil
import stat
import zlib
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from uuid import uuid4

_CHECKSUM_BYTES = 4
_UNFINISHED = "."
"""What the names of files begin with that are being written."""


@dataclass(frozen=True)
class BlockFiles:
    """Payloads by name in a folder; a file is there whole or not at all. Names are words and numbers of ours."""

    folder: Path

    @property
    def names(self) -> set[str]:
        """Names of all there is: nothing where the folder is not, as its disk may be gone. Whoever saves is told."""
        files = set[str]()
        with suppress(OSError), os.scandir(self.folder) as found:
            files = {one.name for one in found if one.is_file(follow_symlinks=False)}
        return {name for name in files if not name.startswith(_UNFINISHED)}

    def save(self, name: str, payload: bytes) -> None:
        """Keep a payload in the place of an earlier one. Raises OSError: FileNotFoundError where nobody sees the folder
        from here, as on a machine that does not share the disk."""
        unfinished = self.folder / f"{_UNFINISHED}{uuid4().hex}"
        try:
            with open(unfinished, "xb") as file:
                file.write(payload)
                file.write(zlib.crc32(payload).to_bytes(_CHECKSUM_BYTES, "little"))
            os.replace(unfinished, self.folder / name)
        except OSError:
            with suppress(OSError):
                unfinished.unlink()
            raise

    def load(self, name: str) -> bytes | None:
        """The payload, None where there is none. Raises OSError where it can't be read, or the disk damaged it."""
        path = self.folder / name
        try:
            is_file = stat.S_ISREG(path.lstat().st_mode)
        except FileNotFoundError:
            return None
        held = path.read_bytes() if is_file else b""
        payload, checksum = held[:-_CHECKSUM_BYTES], held[-_CHECKSUM_BYTES:]
        if zlib.crc32(payload).to_bytes(_CHECKSUM_BYTES, "little") != checksum:
            raise OSError(errno.EIO, os.strerror(errno.EIO))
        return payload

    def forget(self, name: str) -> None:
        """There is none of that name any more. Raises OSError."""
        with suppress(FileNotFoundError):
            (self.folder / name).unlink()

    def make(self) -> None:
        """The folder is there, without what was not written whole. Raises OSError, for a link of that name as well."""
        if self.folder.is_symlink():
            raise OSError(errno.ELOOP, os.strerror(errno.ELOOP))
        self.folder.mkdir(exist_ok=True)
        for unfinished in self.folder.glob(f"{_UNFINISHED}*"):
            unfinished.unlink()

    def remove(self) -> None:
        """Nothing of it is left."""
        shutil.rmtree(self.folder, ignore_errors=True)
