"""An aerial photo with its orientations, ready to be rectified."""
from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from ....imagery.errors import SensorModelError
from ....imagery.grids import PixelWindow
from ....imagery.message import Message
from ....imagery.open_raster import OpenRaster
from ....imagery.rasters import RasterRef
from ....imagery.reference_systems import (
    horizontal_wkt,
    is_geographic,
    metres_per_unit,
    transform_points,
)
from .. import messages
from ..ground_system import WGS84
from ..height_datums import ELLIPSOID, VERTICAL, Datum, Geoid, above_ellipsoid
from ..limits import EXTERIOR_DATUMS
from ..models.frame_camera import FrameCamera
from ..models.rpc import Domain
from ..terrain import HIGHEST_M, LOWEST_M
from .exterior_files import read_exterior
from .interior_files import read_interior

AS_TERRAIN = EXTERIOR_DATUMS[0]
MIN_DIP = 0.02  # sine of the angle below the horizon of the flattest view
HEIGHTS_PX = 512  # longer side of the overview of the terrain that the range of heights is taken from


@dataclass(frozen=True)
class FrameFiles:
    """What a photo's orientation is read from."""

    interior: Path
    exterior: Path
    wkt: str
    """Reference system of the exterior orientation, if it is stated; empty: what its file says, else the image's."""
    datum: Datum
    """What the projection centre's height refers to: one of ``limits.EXTERIOR_DATUMS``, or a grid."""


@dataclass(frozen=True)
class OrientedFrame:
    """A photo's camera on the ground."""

    camera: FrameCamera
    wkt: str
    """Reference system of its position."""
    domain: Domain
    terrain_datum: Datum
    """What the terrain model's heights are to be taken as: the camera's are of the same kind then."""
    notices: tuple[Message, ...]


def oriented_frame(
    image: OpenRaster, files: FrameFiles, dem: RasterRef | None, dem_datum: Datum, height: float
) -> OrientedFrame:
    """The camera of an image; the ground's heights from ``dem``, else one ``height`` everywhere.

    Raises SensorModelError for files that can't be used and for cameras that don't see the ground.
    """
    exterior = read_exterior(files.exterior, image.ref.name)
    interior = read_interior(files.interior, exterior.camera, (image.columns, image.rows))
    wkt, notices = _system(image, files, exterior.wkt)
    if exterior.perhaps_radians:
        notices = (*notices, messages.ANGLES_PERHAPS_RADIANS(name=files.exterior.name))
    camera = FrameCamera(interior, exterior.position, exterior.axes)
    vertical = files.datum if isinstance(files.datum, Geoid) else VERTICAL.get(files.datum)
    if vertical is not None:
        camera = replace(camera, position=_above_ellipsoid(camera.position, wkt, vertical))
    low, high = (height, height) if dem is None else _range_of_heights(dem)
    _check_view(camera, image, low, high)
    middle = camera.place_at((low + high) / 2)
    domain = Domain((0.0, image.columns), (0.0, image.rows), (low, high), (float(middle[0]), float(middle[1])))
    return OrientedFrame(camera, wkt, domain, ELLIPSOID if files.datum == AS_TERRAIN else dem_datum, notices)


def _system(image: OpenRaster, files: FrameFiles, named: str) -> tuple[str, tuple[Message, ...]]:
    """The horizontal system of the exterior orientation, and what to say of it."""
    own = image.raster.own_wkt
    wkt = files.wkt or named or own
    if not wkt:
        raise SensorModelError(messages.EXTERIOR_WITHOUT_SYSTEM(name=files.exterior.name))
    if is_geographic(wkt) or metres_per_unit(wkt, 0.0) != (1.0, 1.0):
        raise SensorModelError(messages.EXTERIOR_NOT_METRIC())
    return horizontal_wkt(wkt), () if files.wkt or named else (messages.EXTERIOR_SYSTEM_TAKEN(),)


def _above_ellipsoid(position: np.ndarray, wkt: str, vertical: Datum) -> np.ndarray:
    place = transform_points(position[None, :2], wkt, WGS84)
    height = above_ellipsoid(np.column_stack([place, position[None, 2:]]), vertical)
    return np.append(position[:2], height)


def _range_of_heights(dem: RasterRef) -> tuple[float, float]:
    """Lowest and highest terrain as the terrain model has it, m; over all of it, which costs an overview only."""
    source = OpenRaster(dem)
    whole = PixelWindow(0, 0, source.columns, source.rows)
    share = max(source.columns, source.rows) / HEIGHTS_PX
    size = (max(round(source.rows / share), 1), max(round(source.columns / share), 1)) if share > 1 else None
    block = source.read(whole, size)
    band = source.dataset.GetRasterBand(1)
    heights = block.bands[0][block.valid] * float(band.GetScale() or 1) + (band.GetOffset() or 0)
    heights = heights[(heights >= LOWEST_M) & (heights <= HIGHEST_M)]  # others stand for none, and no nodata says so
    if not heights.size:
        raise SensorModelError(messages.TERRAIN_EMPTY(name=dem.name))
    return float(heights.min()), float(heights.max())


def _check_view(camera: FrameCamera, image: OpenRaster, low: float, high: float) -> None:
    """Raise SensorModelError for a camera that is not above the ground, or sees more than the ground."""
    if camera.position[2] <= high:
        raise SensorModelError(
            messages.CAMERA_BELOW_TERRAIN(name=image.ref.name, height=float(camera.position[2]), low=low, high=high)
        )
    corners = np.array([[0, 0], [image.columns, 0], [0, image.rows], [image.columns, image.rows]], float)
    across = (corners - camera.interior.principal) / camera.interior.focal
    views = np.column_stack([across, np.ones(len(across))]) @ camera.axes.T
    if views[:, 2].max() > -MIN_DIP * np.linalg.norm(views, axis=1).max():
        raise SensorModelError(messages.CAMERA_LOOKS_UP(name=image.ref.name))
