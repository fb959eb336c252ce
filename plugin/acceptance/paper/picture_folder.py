"""The folder beside a layer in which the pictures of its features lie."""
from __future__ import annotations

import errno
import os
from pathlib import Path

from ...imagery.atomic_files import whole_file
from ...imagery.errors import SettingsError
from ...imagery.messages import system_reason
from . import messages

_NAME = "defect_{}.jpg"


class PictureFolder:
    """Holds the pictures of one layer; those of an earlier one go."""

    def __init__(self, folder: Path) -> None:
        """Raises SettingsError where it can't be written."""
        self._folder = folder
        try:
            if folder.is_symlink():  # what it leads to is none of ours
                raise OSError(errno.ELOOP, os.strerror(errno.ELOOP))
            folder.mkdir(parents=True, exist_ok=True)
            for old in folder.glob(_NAME.format("*")):
                old.unlink()
        except OSError as error:
            raise SettingsError(messages.PICTURES_NOT_WRITTEN(folder=folder, error=system_reason(error))) from None

    def save(self, number: int, jpeg: bytes) -> Path:
        """Write one; where it is. Raises SettingsError where it can't be."""
        path = self._folder / _NAME.format(f"{number:03d}")
        with whole_file(path) as unfinished:
            unfinished.write_bytes(jpeg)
        return path
