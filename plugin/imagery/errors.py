"""The errors a user can cause. Each carries one sentence from ``messages`` that says what to do."""
from __future__ import annotations

import errno

from . import messages
from .message import Message


class SeamInspectorError(Exception):
    """Base of all errors that are shown to the user as they are."""

    def __init__(self, message: Message) -> None:
        super().__init__(message)
        self.message = message

    def __str__(self) -> str:
        return str(self.message)


class SeamInspectorWarning(UserWarning):
    """Something was left out or assumed, and the work goes on."""


class SettingsError(SeamInspectorError):
    """A setting is out of its range, or the inputs together make no job."""


class RasterError(SeamInspectorError):
    """A raster can't be opened, read or compared."""


class NotCoveredError(RasterError):
    """A raster holds too few valid pixels in a window."""


class WindowError(SeamInspectorError):
    """A window can't be measured on the mosaic's pixel grid."""


class SeamlineError(SeamInspectorError):
    """Seamlines from which no window can be placed."""


class WindowLayerError(SeamInspectorError):
    """The window layer can't be made or edited."""


class BarLineError(SeamInspectorError):
    """A line across the bars of a target can't be measured."""


class PhotoError(SeamInspectorError):
    """A photo, its calibration or its marks from which no interior orientation can be had."""


class SensorModelError(SeamInspectorError):
    """A sensor model that can't be fitted, read or applied."""


class WorkersLostError(SeamInspectorError):
    """Nobody is left who could do the work; what is done is kept where it is kept at all."""


class CancelledError(SeamInspectorError):
    """The user stopped the work."""


_SYSTEM_REASONS = {
    errno.EACCES: messages.SYSTEM_ACCESS,
    errno.EDQUOT: messages.SYSTEM_QUOTA,
    errno.EEXIST: messages.SYSTEM_EXISTS,
    errno.EINVAL: messages.SYSTEM_INVALID,
    errno.EIO: messages.SYSTEM_DEVICE,
    errno.EISDIR: messages.SYSTEM_FOLDER,
    errno.ELOOP: messages.SYSTEM_LINKS,
    errno.ENAMETOOLONG: messages.SYSTEM_NAME,
    errno.ENOENT: messages.SYSTEM_NOTHING,
    errno.ENOSPC: messages.SYSTEM_FULL,
    errno.ENOTDIR: messages.SYSTEM_NO_FOLDER,
    errno.EPERM: messages.SYSTEM_PERMISSION,
    errno.EROFS: messages.SYSTEM_READ_ONLY,
}


def system_reason(error: OSError) -> Message | str:
    """Why the system refuses a file, for a message: its own words are English, and used where that is rare."""
    word = _SYSTEM_REASONS.get(error.errno or 0)
    return error.strerror or str(error) if word is None else word()
