"""Photos' cameras on the ground, by the files of their orientations and their terrain, and the files of a block."""
from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ...imagery import messages as imagery_messages
from ...imagery.atomic_files import files_written
from ...imagery.errors import Message, SensorModelError, SettingsError
from ...imagery.file_identity import DataPlace, check_outputs
from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import RasterRef
from ...imagery.reference_systems import horizontal_wkt, spatial_reference
from . import messages
from .camera_files import Cameras, document, orientation_file, read_cameras
from .exterior_files import AUTO, Exteriors, read_exteriors
from .frames import FrameCamera
from .heights import ELLIPSOID, Datum, converted, first_band
from .limits import EXTERIOR_DATUMS
from .points import HIGHEST_M, LOWEST_M
from .rpc import Domain
from .sensor_model import WGS84, reprojected

AS_TERRAIN = EXTERIOR_DATUMS[0]
MIN_DIP = 0.02  # sine of the angle below the horizon of the flattest view
HEIGHTS_PX = 512  # longer side of the overview of the terrain that the range of heights is taken from
PHOTO_ENDINGS = (".tif", ".tiff", ".jpg", ".jpeg", ".png", ".jp2")
_TERRAINS = ("odm_dem/dtm.tif", "odm_dem/dsm.tif")  # of a project: the ground, else the surface


@dataclass(frozen=True)
class FrameFiles:
    """The files that photos' orientations are read from."""

    interior: Path | None  # none: the file of the exterior orientation holds the camera, too
    exterior: Path  # a file, or an OpenDroneMap project's folder
    wkt: str  # reference system of the exterior orientation; empty: what its file says, else the image's
    datum: Datum  # what the projection centre's height refers to: one of ``limits.EXTERIOR_DATUMS``, or a grid
    angles: str = AUTO  # what the angles of a table are in: one of ``limits.ANGLE_UNITS``


class OrientedFrame(NamedTuple):
    """A photo's camera on the ground."""

    camera: FrameCamera
    wkt: str  # reference system of its position
    domain: Domain
    terrain_datum: Datum  # what the terrain model's heights are to be taken as: the camera's are of the same kind then
    notices: tuple[Message, ...]


@dataclass(frozen=True)
class FrameBlock:
    """Orientation files that are read, and the ground below their photos."""

    files: FrameFiles
    exteriors: Exteriors
    cameras: Cameras
    heights: tuple[float, float]  # lowest and highest terrain, m
    terrain_datum: Datum  # as in ``OrientedFrame``

    def frame(self, image: OpenRaster, name: str = "") -> OrientedFrame:
        """The camera of an image, by its file's name or another. Raises SensorModelError where it sees no ground."""
        exterior = self.exteriors.of(name or image.ref.name)
        interior = self.cameras.of(exterior.camera, (image.columns, image.rows))
        named = self.files.wkt or exterior.wkt
        wkt, system = named or image.raster.own_wkt, spatial_reference(named or image.raster.own_wkt)
        if not wkt or system.IsGeographic() or system.GetLinearUnits() != 1:
            raise SensorModelError(messages.EXTERIOR_NOT_METRIC(name=self.files.exterior.name))
        wkt, notices = horizontal_wkt(wkt), () if named else (messages.EXTERIOR_SYSTEM_TAKEN(),)
        camera = FrameCamera(interior, exterior.position, exterior.axes, exterior.curvature)
        if self.files.datum != AS_TERRAIN:
            place = reprojected(camera.position[None], wkt, WGS84)
            raised, _ = converted(place, wkt, self.files.datum, exterior.camera)
            camera = replace(camera, position=np.append(camera.position[:2], raised))
        (low, high), height = self.heights, float(camera.position[2])
        if height <= high:
            below = messages.CAMERA_BELOW_TERRAIN(name=image.ref.name, height=height, low=low, high=high)
            raise SensorModelError(below)
        domain = Domain((0.0, image.columns), (0.0, image.rows), self.heights, (0.0, 0.0))
        views = camera.views(domain.middle_and_corners)
        if views[:, 2].max() > -MIN_DIP:
            raise SensorModelError(messages.CAMERA_LOOKS_UP(name=image.ref.name))
        ((x, y),) = camera.places_at(views[:1], np.array([(low + high) / 2])).tolist()
        domain = replace(domain, middle=(x, y))
        return OrientedFrame(camera, wkt, domain, self.terrain_datum, (*notices, *exterior.notices))


def read_block(files: FrameFiles, dem: RasterRef | None, dem_datum: Datum, height: float) -> FrameBlock:
    """The orientations of files; the ground's heights from ``dem``, else one ``height``. Raises SensorModelError."""
    path = orientation_file(files.exterior)
    content = document(path)
    exteriors = read_exteriors(content, path, files.angles)
    cameras = read_cameras(document(files.interior), files.interior) if files.interior else read_cameras(content, path)
    heights = np.array([height])
    if dem is not None:  # by an overview
        source = OpenRaster(dem)
        share = max(source.columns, source.rows) / HEIGHTS_PX
        size = (max(round(source.columns / share), 1), max(round(source.rows / share), 1)) if share > 1 else None
        heights = first_band(source, source.raster.whole, size)
        heights = heights[(heights >= LOWEST_M) & (heights <= HIGHEST_M)]  # others stand for none, with nodata or not
        if not heights.size:
            raise SensorModelError(messages.TERRAIN_EMPTY(name=dem.name))
    span = float(heights.min()), float(heights.max())
    return FrameBlock(files, exteriors, cameras, span, ELLIPSOID if files.datum == AS_TERRAIN else dem_datum)


def project_photos(exterior: Path) -> Path:
    """The folder of the photos of a project's reconstruction, or of the file itself."""
    path = orientation_file(exterior)
    images = path.parent.parent / "images"
    return images if path.parent.name == "opensfm" and images.is_dir() else path.parent


def project_terrain(exterior: Path) -> RasterRef:
    """The terrain model of a project. Raises SettingsError where there is none, or no file of that name at all."""
    path = orientation_file(exterior)
    if not os.path.isfile(path):
        raise SettingsError(imagery_messages.NOT_FOUND(path=path))
    for terrain in (path.parent.parent / name for name in _TERRAINS):
        if terrain.is_file():
            return RasterRef(str(terrain))
    raise SettingsError(messages.TERRAIN_OR_HEIGHT())


@dataclass(frozen=True)
class BlockPhoto:
    name: str  # as its orientation calls it
    path: Path
    ortho: Path  # what is made of it


def block_photos(
    exteriors: Exteriors, folder: Path, output: Path, read: Iterable[Path] = ()
) -> tuple[list[BlockPhoto], list[Message]]:
    """The photos that are oriented and in a folder, and what to say of others; ``output`` is there then, and nothing in
    it that is ``read`` is replaced. Raises SeamInspectorError where none can be made."""
    try:
        there = [path for path in sorted(folder.iterdir()) if path.suffix.lower() in PHOTO_ENDINGS]
    except OSError:
        there = []
    photos: dict[Path, BlockPhoto] = {}
    missing: list[Message] = []
    for name in exteriors.names:
        file, stem = name.lower(), Path(name).stem.lower()
        alike = [path for path in there if file in (path.name.lower(), path.stem.lower())]
        alike = alike or [path for path in there if stem == path.stem.lower()]
        photo = next((path for path in alike if path.name == name), alike[0] if alike else None)
        if photo is None or photo in photos:
            missing.append(messages.PHOTO_MISSING(name=name, folder=folder))
            continue
        ortho = output / f"{photo.stem}.tif"
        taken = any(other.ortho == ortho for other in photos.values())
        photos[photo] = BlockPhoto(name, photo, output / f"{photo.name}.tif" if taken else ortho)
    if not photos:
        raise SensorModelError(messages.NO_PHOTOS(folder=folder, name=exteriors.name))
    made = [(photo.ortho.name, DataPlace(str(photo.ortho))) for photo in photos.values()]
    check_outputs(made, (), map(str, (*there, *read)))
    with files_written(output):
        output.mkdir(parents=True, exist_ok=True)
    return list(photos.values()), missing
