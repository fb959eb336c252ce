"""What every report says of how its figures came about."""
from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from datetime import date

from qgis.core import Qgis, QgsCoordinateReferenceSystem

from ...imagery.rasters import Raster, RasterRef
from ...imagery.reference_systems import is_geographic
from ..resources import plugin_version
from ..translation import filled, shown_number, tr

MOST_RASTERS = 40  # listed one by one: a page of them


@dataclass(frozen=True)
class MeasuredRaster:
    """What a report says of one raster."""

    role: str
    """What it is to the measurement: mosaic, orthoimage, image."""
    path: str
    size: str = ""
    """Columns and rows; empty where it was not opened."""
    pixel: str = ""
    pixels: str = ""
    """How many bands of which type."""
    system: str = ""
    """Reference system, by its code where it has one."""


@dataclass(frozen=True)
class HowMeasured:
    """How the figures of a report came about."""

    settings: Sequence[tuple[str, str]] = ()
    """Names and values: wavelet, limits, files."""
    rasters: Sequence[MeasuredRaster] = ()
    """Those that were measured, in an order that their reader knows."""
    made_on: date | None = None
    """The day of the measurement; None for today."""

    @property
    def day(self) -> str:
        """As the world writes it, so that no month is taken for a day."""
        return (self.made_on or date.today()).isoformat()

    @property
    def software(self) -> str:
        """Names and versions of the programs."""
        return f"Seam Inspector {plugin_version()}, QGIS {Qgis.version()}"

    @property
    def listed(self) -> Sequence[MeasuredRaster]:
        """The rasters that a report lists."""
        return self.rasters[:MOST_RASTERS]

    @property
    def left_out(self) -> int:
        """How many more there are."""
        return len(self.rasters) - len(self.listed)


def measured_raster(role: str, raster: Raster | RasterRef) -> MeasuredRaster:
    """Of one raster; of one that was not opened its path alone is known."""
    if isinstance(raster, RasterRef):
        return MeasuredRaster(role, whole_path(raster.path))
    return MeasuredRaster(
        role,
        whole_path(raster.ref.path),
        f"{raster.columns} x {raster.rows} px",
        _pixel_size(raster) if raster.has_place else "",
        f"{len(raster.band_names)} x {raster.data_type}",
        system_name(raster.wkt) if raster.has_place else "",
    )


def each_raster(role: str, rasters: Iterable[Raster | RasterRef]) -> list[MeasuredRaster]:
    """Of several rasters, each path once."""
    return list({facts.path: facts for facts in (measured_raster(role, one) for one in rasters)}.values())


def whole_path(address: str) -> str:
    """What somebody else finds a file or a layer in it by, wherever the program was started; others as they are."""
    path, bar, layer = address.partition("|")
    return f"{os.path.abspath(path)}{bar}{layer}" if path and os.path.exists(path) else address


def system_name(wkt: str) -> str:
    """The name of a reference system and its code; empty for none."""
    crs = QgsCoordinateReferenceSystem.fromWkt(wkt) if wkt else QgsCoordinateReferenceSystem()
    if not crs.isValid():
        return ""
    return f"{crs.authid()}, {crs.description()}" if crs.authid() else crs.description()


def system_code(wkt: str) -> str:
    """The code of a reference system, such as EPSG:2180; empty for one without."""
    crs = QgsCoordinateReferenceSystem.fromWkt(wkt) if wkt else QgsCoordinateReferenceSystem()
    return str(crs.authid())


def _pixel_size(raster: Raster) -> str:
    size = raster.ground_sample_distance
    if is_geographic(raster.wkt):
        return filled(tr("about {size:.3g} m"), size=size)
    return f"{shown_number(size, 4).rstrip('0').rstrip('.,')} m"
