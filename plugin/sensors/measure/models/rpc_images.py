"""An image that carries its RPC itself, as GDAL's programs read it."""
from __future__ import annotations

from pathlib import Path
from typing import Any, Callable

from osgeo import gdal

from ....imagery import messages as imagery_messages
from ....imagery.errors import CancelledError
from ....imagery.gdal_calls import gdal_silenced, gdal_writing
from ....imagery.open_raster import OpenRaster
from ....imagery.raster_writer import whole_raster
from .rational import Rational
from .rpc_files import to_metadata


def image_with_rpc(image: OpenRaster, rpc: Rational) -> gdal.Dataset:
    """The image, virtually, with the RPC and nothing else that could place it."""
    with gdal_silenced():
        source = gdal.Translate("", image.dataset, format="VRT", noData=None)
        source.SetGeoTransform((0.0, 1.0, 0.0, 0.0, 0.0, 1.0))
        source.SetProjection("")
        source.SetGCPs([], "")
        source.SetMetadata(to_metadata(rpc), "RPC")
    return source


def write_image_with_rpc(
    image: OpenRaster, rpc: Rational, path: Path, cancelled: Callable[[], bool] = lambda: False
) -> None:
    """A GeoTIFF of the image with the RPC in its tags.

    Raises RasterError where it can't be written, CancelledError when cancelled; no half-written file is left then.
    """
    source = image_with_rpc(image, rpc)

    def report(share: float, message: str, data: Any) -> int:
        return 0 if cancelled() else 1

    failure = imagery_messages.RASTER_NOT_WRITTEN(path=path)
    creation = ["COMPRESS=DEFLATE", "TILED=YES", "BIGTIFF=IF_SAFER", "NUM_THREADS=ALL_CPUS"]
    with whole_raster(str(path)) as unfinished:
        with gdal_writing(failure):
            gdal.GetDriverByName("GTiff").CreateCopy(unfinished, source, False, creation, report)
        if cancelled():
            raise CancelledError(imagery_messages.CANCELLED())
