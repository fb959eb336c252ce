"""Readings of several rasters: what each found, or why it found nothing."""
from __future__ import annotations

import gc
import weakref
from pathlib import Path

import numpy as np
from seam_inspector.plugin.imagery import messages
from seam_inspector.plugin.imagery.errors import RasterError
from seam_inspector.plugin.imagery.open_raster import OpenRaster
from seam_inspector.plugin.imagery.raster_pool import read_one
from seam_inspector.plugin.imagery.rasters import RasterRef

from tests.numbers.synthetic import write_raster


def test_why_nothing_was_found_keeps_no_file_open(tmp_path: Path) -> None:
    ref = RasterRef(write_raster(tmp_path / "image.tif", np.ones((8, 8), np.uint8)))
    opened: list[weakref.ref[OpenRaster]] = []

    def work(raster: OpenRaster) -> None:
        opened.append(weakref.ref(raster))
        try:
            raise RuntimeError("as GDAL says it")
        except RuntimeError:
            raise RasterError(messages.NOT_READABLE(name="image.tif")) from None

    gc.disable()
    try:
        found = read_one(OpenRaster, ref, work)
        assert isinstance(found, RasterError)
        assert opened[0]() is None
    finally:
        gc.enable()
