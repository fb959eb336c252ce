"""Opening a file that we keep beside another one: only one of its own, never what a link of that name leads to."""
from __future__ import annotations

import errno
import os
import stat
from pathlib import Path
from typing import BinaryIO

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
