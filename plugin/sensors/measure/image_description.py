"""What an image says of itself before it is georeferenced."""
from __future__ import annotations

from dataclasses import dataclass

from ...imagery import messages as imagery_messages
from ...imagery.datasets import open_dataset
from ...imagery.errors import RasterError
from ...imagery.rasters import GeoTransform, RasterRef


@dataclass(frozen=True)
class SensorImage:
    """An image as a sensor took it, which may have no place on the map yet."""

    ref: RasterRef
    columns: int
    rows: int
    geotransform: GeoTransform | None
    """None where the file has none."""
    georeferenced: bool
    """Whether a reference system goes with the geotransform."""
    rpc: dict[str, str]
    """GDAL's metadata domain RPC; empty where the image has none."""
    satellite: str
    """What the metadata call the satellite; may be empty."""


def describe_image(ref: RasterRef) -> SensorImage:
    """What there is to know about an image before it is georeferenced. Raises RasterError."""
    dataset = open_dataset(ref)
    if dataset.RasterCount == 0:
        raise RasterError(imagery_messages.NO_BANDS(name=ref.name))
    transform = dataset.GetGeoTransform(can_return_null=True)
    about = {**(dataset.GetMetadata() or {}), **(dataset.GetMetadata("IMAGERY") or {})}
    named = next((str(about[key]) for key in ("SATELLITEID", "NITF_ISORCE") if key in about), "")
    return SensorImage(
        ref,
        dataset.RasterXSize,
        dataset.RasterYSize,
        tuple(transform) if transform is not None else None,
        bool(dataset.GetProjection()),
        dict(dataset.GetMetadata("RPC") or {}),
        named,
    )
