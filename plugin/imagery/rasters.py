"""What a raster is, in plain data that crosses threads and processes, and the range of values it could have used."""
from __future__ import annotations

import math
import os
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from . import messages
from .errors import Message, RasterError
from .grids import Extent, Grid, PixelWindow, middle_of
from .limits import has_colours, measured_bands
from .reference_systems import metres_per_unit, other_system, same_coordinates

MAX_SYSTEM_SHIFT_PX = 0.01  # two reference systems whose coordinates agree this closely are one
MAX_SKEW = 1e-6  # of a pixel per pixel: 0.05 px across 50 000 px

GeoTransform = tuple[float, float, float, float, float, float]

ON_ITS_OWN_PIXELS: GeoTransform = (0.0, 1.0, 0.0, 0.0, 0.0, -1.0)
"""Placement that QGIS gives a raster without a place on the map: x is the column, y the row downwards, so negative."""


@dataclass(frozen=True)
class RasterRef:
    """A raster's place in files."""

    path: str
    """What GDAL opens."""
    wkt: str = ""
    """Reference system that holds whatever the file names, such as a layer's; empty: the file's."""
    nodata: float | None = None
    """Value of pixels that are no measurements, beside those that the file names: all bands hold it."""
    parts: tuple[str, ...] = ()
    """Further files on the same pixel grid that are parts of the same image; what the first one shows lies on top."""
    bounds: Extent | None = None
    """Rectangle of what they show that is looked at; None: all of it."""

    def __post_init__(self) -> None:
        # Whoever opens it may have another working folder: a worker, or this process later on.
        object.__setattr__(self, "path", _from_anywhere(self.path))
        object.__setattr__(self, "parts", tuple(map(_from_anywhere, self.parts)))

    @property
    def name(self) -> str:
        """File name without its folder; of an image in parts that of its first one."""
        return os.path.basename(self.path) or self.path

    @property
    def paths(self) -> tuple[str, ...]:
        """Paths of all its parts."""
        return self.path, *self.parts


def _from_anywhere(path: str) -> str:
    """A file's absolute path; what is no file is left as it is."""
    return os.path.abspath(path) if not os.path.isabs(path) and os.path.exists(path) else path


@dataclass(frozen=True)
class Raster:
    """What there is to know about a raster before its pixels are read."""

    ref: RasterRef
    """Its place in files."""
    columns: int
    """Number of columns, px."""
    rows: int
    """Number of rows, px."""
    geotransform: GeoTransform | None
    """From columns and rows to map coordinates; None when it has no place on the map, as a photograph or a scan."""
    own_wkt: str
    """Reference system that the file names; empty when it names none."""
    band_names: tuple[str, ...]
    """``red``, ``green``, ``blue`` first where all three are there, ``nir``, ``band_N``; no alpha."""
    data_type: str
    """numpy's name of the pixels' type as they are measured, such as ``uint8``."""
    bits: int | None = None
    """Bits a pixel where the file says it (NBITS), as 12 in 16."""
    is_lossy: bool = False
    """Whether the file says that its pixels are compressed with loss."""
    band_order: tuple[int, ...] = ()
    """Place in the file, from 0, of each of its bands."""
    is_turned: bool = False
    """Whether it is seen turned over, as the rows of its file run north."""

    @cached_property
    def wkt(self) -> str:
        """Reference system; empty when neither the file nor its reference names one. Of two that mean the same place
        it is the file's, which may tell of heights."""
        of_file, given = self.own_wkt, self.ref.wkt
        nearest = MAX_SYSTEM_SHIFT_PX * min(abs(self.placement[1]), abs(self.placement[5]))
        is_taken = of_file and (not given or same_coordinates(of_file, given, self.extent, nearest))
        return of_file if is_taken else given

    @property
    def notices(self) -> tuple[Message, ...]:
        """What was settled about it that its file says otherwise."""
        of_file, taken = self.own_wkt, self.wkt
        return other_system(self.ref.name, of_file, taken) if of_file and of_file != taken else ()

    @property
    def whole(self) -> PixelWindow:
        """All of its pixels."""
        return PixelWindow(0, 0, self.columns, self.rows)

    @property
    def has_luminance(self) -> bool:
        """Whether there are red, green and blue to mix."""
        return has_colours(self.band_names)

    @property
    def judged_band(self) -> str:
        """The name of the band that a verdict is taken from: luminance where there is one, else the first."""
        return measured_bands(self.band_names)[0]

    @property
    def has_place(self) -> bool:
        """Whether it lies on the map; a raster that does not lies on its own pixels."""
        return self.geotransform is not None and (bool(self.wkt) or self.geotransform != ON_ITS_OWN_PIXELS)

    @property
    def placement(self) -> GeoTransform:
        """From columns and rows to coordinates, wherever it lies."""
        return self.geotransform or ON_ITS_OWN_PIXELS

    @property
    def is_north_up(self) -> bool:
        """Whether it is neither rotated nor mirrored nor south-up, so that it has a grid."""
        _, right, skew_x, _, skew_y, down = self.placement
        return max(abs(skew_x), abs(skew_y)) < MAX_SKEW * min(right, -down)

    @cached_property
    def grid(self) -> Grid:
        """Grid of its pixels on the map. Raises RasterError when it is not north-up, or lies nowhere on the ground."""
        if not self.is_north_up:
            raise RasterError(messages.NOT_NORTH_UP(name=self.ref.name))
        if not all(math.isfinite(metres) and metres > 0 for metres in self._metres):
            raise RasterError(messages.NOT_ON_GROUND(name=self.ref.name))
        left, right, _, top, _, down = self.placement
        return Grid(left, top, right, -down, self.columns, self.rows, *self._metres)

    @cached_property
    def extent(self) -> Extent:
        """Bounding box in the raster's own reference system."""
        left, right, skew_x, top, skew_y, down = self.placement
        corners = [(x, y) for x in (0, self.columns) for y in (0, self.rows)]
        xs = [left + x * right + y * skew_x for x, y in corners]
        ys = [top + x * skew_y + y * down for x, y in corners]
        return min(xs), min(ys), max(xs), max(ys)

    @cached_property
    def ground_sample_distance(self) -> float:
        """Metres on the ground per pixel, the shorter side; 1 when it has no place on the map."""
        _, right, skew_x, _, skew_y, down = self.placement
        metres_x, metres_y = self._metres
        return min(math.hypot(right * metres_x, skew_y * metres_y), math.hypot(skew_x * metres_x, down * metres_y))

    @cached_property
    def _metres(self) -> tuple[float, float]:
        """Metres per map unit along x and y."""
        return metres_per_unit(self.wkt if self.has_place else "", middle_of(self.extent))


BIT_DEPTHS = (8, 10, 11, 12, 14, 16)  # of cameras and scanners; the smallest that holds an image's largest value

ValueRange = tuple[float, float]
"""The lowest and the highest value that a pixel can hold."""


def is_range_known(image: Raster) -> bool:
    """Whether the data type or the file says the range, so that no pixel has to be asked."""
    return image.bits is not None or image.data_type in ("uint8", "int8")


def value_range(image: Raster, largest: float) -> ValueRange | None:
    """The range of an image whose largest value is given; None for values without a range of their own.

    8 bit: all of it. 16 bit: from the bits a pixel where the file says them, else the smallest usual depth of
    cameras and scanners that holds the largest value (12 bit in 16: 0 to 4095). Signed values start at their
    type's lowest value. 32 and 64 bit values have no range that an image would fill.
    """
    if image.data_type not in ("uint8", "int8", "uint16", "int16"):
        return None
    information = np.iinfo(image.data_type)
    if information.min < 0 or image.data_type == "uint8":
        return float(information.min), float(information.max)
    bits = image.bits or next((bits for bits in BIT_DEPTHS if largest < 2**bits), 16)
    return 0.0, float(2**bits - 1)
