"""A lock on a file that ends with the process that holds it."""
from __future__ import annotations

import errno
import os
from contextlib import suppress
from pathlib import Path
from typing import BinaryIO

_FAR = 1 << 43  # a byte that no journal has (8 TiB): on Windows others can't read what is locked
_TAKEN = (errno.EACCES, errno.EAGAIN, errno.EDEADLK)


def lock_file(file: BinaryIO) -> bool:
    """Lock an open file until it is closed; False when it is locked already, by this or another process.

    Raises OSError on a disk that knows no locks.
    """
    try:
        if os.name == "nt":
            _lock_on_windows(file)
        else:
            import fcntl

            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        if error.errno in _TAKEN:
            return False
        raise
    return True


def remove_locked(file: BinaryIO, path: Path) -> None:
    """Delete an open file before others can lock it, and close it."""
    if os.name == "nt":  # where no open file can be deleted
        _close(file)
    with suppress(OSError):
        path.unlink()
    _close(file)


def _close(file: BinaryIO) -> None:
    with suppress(OSError):
        file.close()


def _lock_on_windows(file: BinaryIO) -> None:
    import msvcrt  # only there

    place = file.tell()
    file.seek(_FAR)
    try:
        msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)  # type: ignore[attr-defined,unused-ignore]
    finally:
        file.seek(place)
