"""Files that are there whole or not at all: an older one is replaced only when all of the new one is written."""
from __future__ import annotations

import errno
import os
import shutil
import tempfile
import zlib
from collections.abc import Iterable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from itertools import count
from pathlib import Path

from . import messages
from .errors import SettingsError
from .messages import system_reason


def unfinished_name(path: Path) -> str:
    """What the names of the folders in which a file is written begin with: known by the file, however long its name."""
    return f".unfinished-{zlib.crc32(os.fsencode(path.name)):08x}-"


@contextmanager
def whole_file(path: Path) -> Iterator[Path]:
    """The place to write what is to be ``path``: ``with whole_file(path) as unfinished: unfinished.write_text(...)``.

    The file becomes ``path`` when the block ends. An exception in the block (cancelling is one) leaves no part of it,
    nothing beside it, and an older file as it was. Raises SettingsError where no file can be.
    """
    with files_written(path), replacing(path) as unfinished:
        yield unfinished


@contextmanager
def files_written(path: Path | str) -> Iterator[None]:
    """SettingsError for whatever the system refuses in a block that writes ``path`` and what belongs to it."""
    try:
        yield
    except OSError as error:
        raise SettingsError(messages.FILE_NOT_WRITTEN(path=path, error=system_reason(error))) from None


def save_text(text: str, path: Path, encoding: str = "utf-8") -> None:
    """Write a text file, whole or not at all. Raises SettingsError where none can be."""
    with whole_file(path) as unfinished:
        unfinished.write_text(text, encoding=encoding)


@contextmanager
def replacing(path: Path, companions: Iterable[str] = ()) -> Iterator[Path]:
    """Like ``whole_file``, with Python's OSError where no file can be; ``companions`` as ``UnfinishedFile.keep``."""
    if path.exists() and not path.is_file():
        yield path  # a device takes what is written to it; a folder refuses
        return
    unfinished = UnfinishedFile(path)
    try:
        yield unfinished.written
        unfinished.keep(companions)
    finally:
        unfinished.drop()


class UnfinishedFile:
    """A file in the making, in a hidden folder beside where it is to be.

    It has its name there, so that what GDAL writes next to a file goes along; the last step renames it on one disk.
    """

    def __init__(self, path: Path) -> None:
        """Raises OSError where no file can be."""
        self._path = Path(os.path.realpath(path))  # the file that a link points to is replaced, not the link
        self.replaces = self._path.exists()
        """Whether there is an older one."""
        if self.replaces and not os.access(self._path, os.W_OK):
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
        self._folder = Path(tempfile.mkdtemp(prefix=unfinished_name(self._path), dir=self._path.parent))
        self.written = self._folder / self._path.name
        """The place it is written to."""

    def keep(self, companions: Iterable[str] = ()) -> None:
        """It is whole and becomes what it is to be. ``companions``: names of files beside the older one that go with it
        before the new one comes, which they would spoil; with an OSError all stay as they were."""
        with suppress(OSError):
            shutil.copymode(self._path, self.written)
        with ExitStack() as undo:
            for older in filter(Path.exists, map(self._path.with_name, companions)):
                aside = Path(tempfile.mkdtemp(dir=self._folder)) / older.name
                os.replace(older, aside)
                undo.callback(os.replace, aside, older)
            self._move(self._path)
            undo.pop_all()
        self.drop()

    def keep_beside(self) -> Path:
        """The older file stays, and this one gets a name like it that is free. Raises OSError where that can't be."""
        names = (self._path.with_name(f"{self._path.stem}_{number}{self._path.suffix}") for number in count(2))
        path = next(name for name in names if not os.path.lexists(name))
        self._move(path)
        self.drop()
        return path

    def drop(self) -> None:
        """Nothing of it stays, as far as it was not kept."""
        shutil.rmtree(self._folder, ignore_errors=True)

    def _move(self, path: Path) -> None:
        every = filter(Path.is_file, self._folder.iterdir())
        for made in sorted(every, key=lambda made: made.name == self._path.name):  # itself comes last
            os.replace(made, path.with_name(path.stem + made.name[len(self._path.stem) :]))


def drop_unfinished(path: Path) -> None:
    """Remove what processes that were killed left of a file, where it is sure that nobody is writing it now."""
    path = Path(os.path.realpath(path))
    with suppress(OSError):
        for folder in path.parent.glob(f"{unfinished_name(path)}*"):
            shutil.rmtree(folder, ignore_errors=True)
