"""Who reads the rasters of a window: one after the other here, or threads that keep them open, side by side."""
from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Protocol, TypeVar

from ..errors import RasterError
from ..open_raster import OpenRaster
from ..rasters import RasterRef

Found = TypeVar("Found")
Reading = tuple[RasterRef, Callable[[OpenRaster], Found]]
"""A raster, and what is read from it once it is open."""


class ReadEach(Protocol):
    """Does all readings; gives what each found, or why it found nothing, in their order."""

    def __call__(self, readings: Iterable[Reading[Found]]) -> list[Found | RasterError]: ...


def one_by_one(readings: Iterable[Reading[Found]]) -> list[Found | RasterError]:
    """In this thread; each raster is opened for it."""
    return [read_one(OpenRaster, *reading) for reading in readings]


def read_one(
    opened: Callable[[RasterRef], OpenRaster], ref: RasterRef, work: Callable[[OpenRaster], Found]
) -> Found | RasterError:
    """What is found in a raster, or why nothing is."""
    try:
        return work(opened(ref))
    except RasterError as error:
        error.__context__ = None  # that and where it was raised would keep the file open as long as it is remembered
        return error.with_traceback(None)
