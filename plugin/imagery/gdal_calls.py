"""How GDAL is called: without its own messages, its failures as ours whether or not its exceptions are on."""
from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import Any, Callable

from osgeo import gdal

from .errors import Message, RasterError


@contextmanager
def gdal_silenced() -> Iterator[None]:
    """GDAL's own messages off in this thread; ours say it in the user's terms."""
    gdal.PushErrorHandler("CPLQuietErrorHandler")
    try:
        yield
    finally:
        gdal.PopErrorHandler()


@contextmanager
def gdal_heard() -> Iterator[list[tuple[int, str]]]:
    """What GDAL says in this thread, each time with its level, instead of its printing it."""
    said: list[tuple[int, str]] = []
    gdal.PushErrorHandler(lambda level, number, text: said.append((level, text)))
    try:
        yield said
    finally:
        gdal.PopErrorHandler()


def gdal_call(call: Callable[[], Any], failure: Message) -> Any:
    """What a GDAL call returns; RasterError when it fails."""
    with gdal_silenced(), suppress(RuntimeError):
        if (result := call()) is not None:
            return result
    raise RasterError(failure)


_DAMAGE = re.compile(r"JPEGLib|libpng|libjpeg: (?!.* extraneous)|Decod|corrupt|premature", re.I)
"""What decoders say of pixels that they then make up. Bytes that cameras leave at the end of a JPEG do no harm; in a
tile of a TIFF there are none."""


def gdal_pixels(call: Callable[[], Any], failure: Message, damage: Callable[[str], Message]) -> Any:
    """What a call that reads pixels returns. Raises RasterError with ``failure`` when it fails, and with ``damage``,
    which is given GDAL's words, when it goes on after a warning that pixels can't be decoded."""
    result = None
    with gdal_heard() as said, suppress(RuntimeError):
        result = call()
    if result is None or any(level >= gdal.CE_Failure for level, _ in said):
        raise RasterError(failure)
    for text in filter(_DAMAGE.search, (text for _, text in said)):
        raise RasterError(damage(text.partition(" (this warning")[0]))
    return result


@contextmanager
def gdal_settings(**options: str) -> Iterator[None]:
    """GDAL's options for this thread alone."""
    before = {name: gdal.GetThreadLocalConfigOption(name) for name in options}
    try:
        for name, value in options.items():
            gdal.SetThreadLocalConfigOption(name, value)
        yield
    finally:
        for name in options:
            gdal.SetThreadLocalConfigOption(name, before[name])


@contextmanager
def gdal_writing(failure: Message) -> Iterator[None]:
    """RasterError for whatever fails in a block that writes or closes a file; closing has no result to look at."""
    with gdal_silenced():
        gdal.ErrorReset()
        try:
            yield
        except RuntimeError:
            raise RasterError(failure) from None
        except AttributeError:  # of the None that GDAL gives for what it can't make
            if gdal.GetLastErrorType() < gdal.CE_Failure:
                raise
        if gdal.GetLastErrorType() >= gdal.CE_Failure:
            raise RasterError(failure)


def vsi_bytes(path: str, most: int | None = None) -> bytes:
    """The first bytes of a file that GDAL can open, or all; none of one that it can't."""
    file = gdal.VSIFOpenExL(path, "rb", 1)
    if file is None:
        return b""
    try:
        return bytes(gdal.VSIFReadL(1, gdal.VSIStatL(path).size if most is None else most, file) or b"")
    finally:
        gdal.VSIFCloseL(file)


def taken_from_memory(path: str) -> bytes:
    """The bytes of a file of /vsimem, which is then removed."""
    content = vsi_bytes(path)
    drop_from_memory(path)
    return content


def drop_from_memory(path: str) -> None:
    """Remove a file of /vsimem and what GDAL wrote beside it; removing what is not there raises in GDAL 3.10."""
    for name in (path, *(path + ending for ending in (".aux.xml", ".msk", ".ovr"))):
        if gdal.VSIStatL(name) is not None:
            gdal.Unlink(name)
