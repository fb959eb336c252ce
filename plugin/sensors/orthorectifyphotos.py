"""``seaminspector:orthorectifyphotos``: all photos of a block over a terrain model, in one run."""
from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from qgis.core import QgsProcessingParameterFolderDestination
from qgis.PyQt.QtCore import QT_TR_NOOP

from ..imagery.errors import CancelledError, SeamInspectorError, SensorModelError, SettingsError
from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.run import Run
from ..toolkit.translation import tr
from .measure import messages
from .orthorectify import DEM, EXTERIOR, HEIGHT, INTERIOR, OUTPUT, OrthoAlgorithm, described
from .sensor_parameters import GEOID

PHOTOS, PHOTO_COUNT, LEFT_OUT_COUNT = "PHOTOS", "PHOTO_COUNT", "LEFT_OUT_COUNT"


class OrthorectifyPhotos(OrthoAlgorithm):
    """An orthoimage of each photo that the files of a block name."""

    ID = "orthorectifyphotos"
    NAME = QT_TR_NOOP("Orthorectify a block of photos")
    HELP = QT_TR_NOOP(
        "Puts all aerial photos of a block on the map over a terrain model, on one grid of pixels: those that the file "
        "of their orientations names. For an OpenDroneMap project the folder, or reconstruction.json, is enough. A "
        "photo that can't be used is named, and the others are processed."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        photos = common.folder(PHOTOS, tr("Folder of an OpenDroneMap project, or of photos"), optional=True)
        self.addDescribed(photos, tr(
            "For a project nothing else is needed. Empty: the photos are in images of the exterior orientation's "
            "project, else in the folder of its file."
        ))
        self.addOrientations()
        self.addGround(tr(
            "Terrain heights under all photos, in any reference system. Empty: the terrain or surface model of an "
            "OpenDroneMap project."
        ))
        self.addGrid(tr("System of the orthoimages. Empty: the UTM zone of the first photo."))
        self.addDescribed(
            QgsProcessingParameterFolderDestination(OUTPUT, tr("Orthoimages")),
            tr("A folder: a GeoTIFF of each photo, under its name; empty where the photo or the terrain model ends."),
        )
        self.addNumbers({PHOTO_COUNT: tr("Orthoimages made"), LEFT_OUT_COUNT: tr("Photos without an orthoimage")})

    def check(self, run: Run) -> None:
        if not (run.path(EXTERIOR) or run.path(PHOTOS)):
            raise SettingsError(messages.NO_BLOCK())
        if run.parameters.get(HEIGHT) not in (None, "") and run.parameters.get(DEM):
            raise SettingsError(messages.DEM_AND_HEIGHT())

    def prepare(self, run: Run) -> None:
        self._dem = run.raster(DEM)

    def execute(self, run: Run) -> dict[str, Any]:
        from ..imagery.rasters import RasterRef
        from .measure.oriented_frames import block_photos, project_photos, project_terrain
        from .measure.orthorectification import orthorectify
        from .measure.rpc import open_image

        self.check(run)
        exterior, output = Path(run.path(EXTERIOR) or run.path(PHOTOS)), Path(run.text(OUTPUT))
        if self._dem is None and run.parameters.get(HEIGHT) in (None, ""):
            self._dem = project_terrain(exterior)
            run.tell(messages.PROJECT_TERRAIN(name=self._dem.path))
        block = self._block(run, str(exterior))
        folder = Path(run.path(PHOTOS)) if run.path(PHOTOS) and run.path(EXTERIOR) else project_photos(exterior)
        read = [run.path(name) for name in (EXTERIOR, INTERIOR, GEOID)] + [self._dem.path if self._dem else ""]
        photos, left_out = block_photos(block.exteriors, folder, output, map(Path, filter(None, read)))
        run.tell(*left_out)
        wkt, size, count = "", None, 0
        for number, photo in enumerate(photos):
            run.doing(photo.name)
            try:
                image = open_image(RasterRef(str(photo.path)))
                frame = block.frame(image, photo.name)
                run.tell_once(frame.notices)
                request = self._request(run, image.ref, frame[:4], photo.ortho)
                request = replace(request, target_wkt=request.target_wkt or wkt, pixel_size=request.pixel_size or size)
                tell = partial(lambda done, share: run.progress((done + share) / len(photos)), number)
                made = orthorectify(request, tell, run.is_cancelled)
            except CancelledError as stopped:
                run.tell(stopped.message)
                break
            except SeamInspectorError as error:
                left_out.append(messages.PHOTO_LEFT_OUT(name=photo.path.name, why=error.message))
                run.tell(left_out[-1])
                continue
            wkt, size, count = made.wkt, made.pixel_size, count + 1
            run.tell_once(made.notices)
            run.inform(f"{photo.name}: {described(made)}")
        if left_out and not count and not run.is_cancelled():
            raise SensorModelError(left_out[-1])
        return {OUTPUT: str(output), PHOTO_COUNT: count, LEFT_OUT_COUNT: len(left_out)}
