"""GDAL without its own messages."""
from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from osgeo import gdal


@contextmanager
def gdal_silenced() -> Iterator[None]:
    """GDAL's own messages off in this thread; ours say it in the user's terms."""
    gdal.PushErrorHandler("CPLQuietErrorHandler")
    try:
        yield
    finally:
        gdal.PopErrorHandler()
