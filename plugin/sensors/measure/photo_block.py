"""The files of a block: photos that its orientations name, and what an OpenDroneMap project has beside them."""
from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from ...imagery import messages as imagery_messages
from ...imagery.errors import Message, SensorModelError, SettingsError
from ...imagery.messages import system_reason
from ...imagery.rasters import RasterRef
from . import messages
from .camera_files import orientation_file
from .exterior_files import Exteriors

PHOTO_ENDINGS = (".tif", ".tiff", ".jpg", ".jpeg", ".png", ".jp2")
_TERRAINS = ("odm_dem/dtm.tif", "odm_dem/dsm.tif")  # of a project: the ground, else the surface


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
    project = path.parent.parent
    found = next((project / name for name in _TERRAINS if (project / name).is_file()), None)
    if found is None:
        raise SettingsError(messages.NO_DEM())
    return RasterRef(str(found))


@dataclass(frozen=True)
class BlockPhoto:
    """One photo of a block."""

    name: str
    """As its orientation calls it."""
    path: Path
    ortho: Path
    """What is made of it."""


def block_photos(
    exteriors: Exteriors, folder: Path, output: Path, read: Iterable[Path] = ()
) -> tuple[list[BlockPhoto], list[Message]]:
    """The photos that are oriented and in a folder, and what to say of others; ``output`` is there then, and nothing in
    it that is ``read`` is replaced. Raises SeamInspectorError where none can be made."""
    try:
        there = [one for one in sorted(folder.iterdir()) if one.suffix.lower() in PHOTO_ENDINGS]
    except OSError:
        there = []
    photos: dict[Path, BlockPhoto] = {}
    missing: list[Message] = []
    for name in exteriors.names:
        alike = [one for one in there if name.lower() in (one.name.lower(), one.stem.lower())]
        alike = alike or [one for one in there if Path(name).stem.lower() == one.stem.lower()]
        path = next((one for one in alike if one.name == name), alike[0] if alike else None)
        if path is None or path in photos:
            missing.append(messages.PHOTO_MISSING(name=name, folder=folder))
            continue
        ortho = output / f"{path.stem}.tif"
        taken = any(one.ortho == ortho for one in photos.values())
        photos[path] = BlockPhoto(name, path, output / f"{path.name}.tif" if taken else ortho)
    if not photos:
        raise SensorModelError(messages.NO_PHOTOS(folder=folder, name=exteriors.name))
    inputs = {_identity(one) for one in (*there, *read)} - {None}
    met = next((one.ortho for one in photos.values() if _identity(one.ortho) in inputs), None)
    if met is not None:
        raise SettingsError(messages.ORTHO_IS_INPUT(path=met))
    try:
        output.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise SettingsError(imagery_messages.FILE_NOT_WRITTEN(path=output, error=system_reason(error))) from None
    return list(photos.values()), missing


def _identity(path: Path) -> tuple[int, int] | None:
    """Of a file, whatever leads to it; None where there is none."""
    try:
        found = path.stat()
    except OSError:
        return None
    return found.st_dev, found.st_ino
