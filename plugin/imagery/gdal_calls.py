"""GDAL without its own messages, and its failures as ours, whether or not its exceptions are on."""
from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, Callable

from osgeo import gdal

from .errors import RasterError
from .message import Message

_MASK_INSIDE = "GDAL_TIFF_INTERNAL_MASK"


@contextmanager
def gdal_silenced() -> Iterator[None]:
    """GDAL's own messages off in this thread; ours say it in the user's terms."""
    gdal.PushErrorHandler("CPLQuietErrorHandler")
    try:
        yield
    finally:
        gdal.PopErrorHandler()


def gdal_call(call: Callable[[], Any], failure: Message) -> Any:
    """What a GDAL call returns; RasterError when it fails."""
    with gdal_silenced():
        try:
            result = call()
        except RuntimeError:
            result = None
    if result is None:
        raise RasterError(failure)
    return result


@contextmanager
def gdal_writing(failure: Message) -> Iterator[None]:
    """RasterError for whatever fails in a block that writes or closes a file; closing has no result to look at."""
    with gdal_silenced():
        gdal.ErrorReset()
        try:
            yield
            failed = gdal.GetLastErrorType() >= gdal.CE_Failure
        except RuntimeError:
            failed = True
    if failed:
        raise RasterError(failure)


@contextmanager
def gdal_masks_beside() -> Iterator[None]:
    """A mask that this thread adds to a TIFF becomes a file beside it, as before GDAL 3.13."""
    before = gdal.GetThreadLocalConfigOption(_MASK_INSIDE)
    gdal.SetThreadLocalConfigOption(_MASK_INSIDE, "NO")
    try:
        yield
    finally:
        gdal.SetThreadLocalConfigOption(_MASK_INSIDE, before)


def drop_from_memory(path: str) -> None:
    """Remove a file of /vsimem and what GDAL wrote beside it; removing what is not there raises in GDAL 3.10."""
    for name in (path, *(path + ending for ending in (".aux.xml", ".msk", ".ovr"))):
        if gdal.VSIStatL(name) is not None:
            gdal.Unlink(name)
