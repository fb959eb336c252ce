"""What only the image of a sensor says of itself."""
from __future__ import annotations

from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import RasterRef


def open_image(ref: RasterRef) -> OpenRaster:
    """An image as a sensor took it, which may have no place on the map yet; radar's complex values are welcome."""
    return OpenRaster(ref, complex_values=True)


def rpc_metadata(image: OpenRaster) -> dict[str, str]:
    """GDAL's metadata domain RPC; empty where the image has none."""
    return dict(image.dataset.GetMetadata("RPC") or {})


def satellite_name(image: OpenRaster) -> str:
    """What the metadata call the satellite; may be empty."""
    about = {**(image.dataset.GetMetadata() or {}), **(image.dataset.GetMetadata("IMAGERY") or {})}
    return next((str(about[key]) for key in ("SATELLITEID", "NITF_ISORCE") if key in about), "")
