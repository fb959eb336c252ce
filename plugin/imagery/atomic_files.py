"""Files that are there whole or not at all: an older one is replaced only when all of the new one is written."""
from __future__ import annotations

import errno
import os
import shutil
import tempfile
import zlib
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from . import messages
from .errors import SettingsError, system_reason


def unfinished_name(path: Path) -> str:
    """What the names of the folders in which a file is written begin with: known by the file, however long its name."""
    return f".unfinished-{zlib.crc32(os.fsencode(path.name)):08x}-"


@contextmanager
def whole_file(path: Path) -> Iterator[Path]:
    """Where to write what is to be ``path``: ``with whole_file(path) as unfinished: unfinished.write_text(...)``.

    The file becomes ``path`` when the block ends. An exception in the block (cancelling is one) leaves no part of it,
    nothing beside it, and an older file as it was. Raises SettingsError where no file can be.
    """
    try:
        with replacing(path) as unfinished:
            yield unfinished
    except OSError as error:
        raise SettingsError(messages.FILE_NOT_WRITTEN(path=path, error=system_reason(error))) from None


def save_text(text: str, path: Path, encoding: str = "utf-8") -> None:
    """Write a text file, whole or not at all. Raises SettingsError where none can be."""
    with whole_file(path) as unfinished:
        unfinished.write_text(text, encoding=encoding)


@contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """Like ``whole_file``, with Python's OSError where no file can be.

    The place to write has the name of ``path``, in a hidden folder beside it, so that what GDAL writes next to a file
    goes along with it, and the last step is a renaming on one disk.
    """
    path = Path(os.path.realpath(path))  # the file that a link points to is replaced, not the link
    if path.exists() and not path.is_file():
        yield path  # a device takes what is written to it; a folder refuses
        return
    if path.exists() and not os.access(path, os.W_OK):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
    folder = Path(tempfile.mkdtemp(prefix=unfinished_name(path), dir=path.parent))
    try:
        yield folder / path.name
        with suppress(OSError):
            shutil.copymode(path, folder / path.name)
        for made in sorted(folder.iterdir(), key=lambda made: made.name == path.name):  # the file itself comes last
            os.replace(made, path.with_name(made.name))
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def drop_unfinished(path: Path) -> None:
    """Remove what processes that were killed left of a file, where it is sure that nobody is writing it now."""
    path = Path(os.path.realpath(path))
    with suppress(OSError):
        for folder in path.parent.glob(f"{unfinished_name(path)}*"):
            shutil.rmtree(folder, ignore_errors=True)
