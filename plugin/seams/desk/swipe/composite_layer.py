"""The hard-cut composite of a window as a layer: a file in memory with the mosaic's bands, to take its style."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from ....imagery import messages as imagery_messages
from ....imagery.errors import Message, RasterError
from ....imagery.gdal_calls import gdal_call
from ....imagery.open_raster import OpenRaster
from ....imagery.raster_writer import raster_writer
from ....imagery.rasters import RasterRef
from ....toolkit.background_tasks import Cancelled, Job
from ...measure.window.explained_window import WindowComposite, window_composite
from ...measure.window.window_request import WindowRequest
from .swiped_layer import private_layer


def composite_job(request: WindowRequest, path: str) -> Job:
    """Cuts the composite and writes it to ``path``; yields its QgsRasterLayer, or the Message why there is none."""

    def made() -> object:
        found = window_composite(request)
        if isinstance(found, Message):
            return found
        try:
            write_composite(found, request, path)
        except RasterError as error:
            return error.message
        return private_layer(RasterRef(path, request.mosaic.wkt))

    def job(_cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        yield 1.0, made()

    return job


def write_composite(composite: WindowComposite, request: WindowRequest, path: str) -> None:
    """As a raster that differs from the mosaic's window in the composite's pixels only.

    Raises RasterError when the mosaic can't be read.
    """
    window, mosaic = request.window, OpenRaster(request.mosaic.ref)
    assert window is not None
    pixels = composite.bands
    if mosaic.roles.palette is None:
        place = window.column, window.row, window.width, window.height
        failure = imagery_messages.NOT_READABLE(name=mosaic.ref.name)
        pixels = gdal_call(lambda: mosaic.dataset.ReadAsArray(*place), failure).reshape(-1, window.height, window.width)
        for name, band in zip(composite.names, composite.bands):
            pixels[mosaic.roles.indices[mosaic.roles.names.index(name)]] = band
    grid = request.mosaic.grid
    left, _, _, top = grid.window_extent(window)
    like = replace(
        request.mosaic, columns=window.width, rows=window.height,
        geotransform=(left, grid.pixel_width, 0.0, top, 0.0, -grid.pixel_height),
    )  # fmt: skip
    with raster_writer(path, like, len(pixels), pixels.dtype, nodata=mosaic.nodata) as writer:
        writer.write(0, pixels)
