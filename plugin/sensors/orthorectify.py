"""``seaminspector:orthorectify`` and ``seaminspector:orthorectifyphotos``: an image, or all photos of a block, over a
terrain model."""
from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsProcessingParameterCrs,
    QgsProcessingParameterExtent,
    QgsProcessingParameterFolderDestination,
    QgsProcessingParameterRasterDestination,
)
from qgis.PyQt.QtCore import QT_TR_NOOP

from ..imagery.errors import CancelledError, SeamInspectorError, SensorModelError, SettingsError
from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.run import Run
from ..toolkit.translation import filled, tr
from .measure import limits, messages
from .sensor_parameters import DEM, DEM_HEIGHTS, GEOID, IMAGE, TERRAIN_ERROR, SensorAlgorithm, view_numbers

if TYPE_CHECKING:
    from ..imagery.open_raster import OpenRaster
    from ..imagery.rasters import RasterRef
    from .measure.heights import Datum
    from .measure.oriented_frames import FrameBlock
    from .measure.orthorectification import Ortho, OrthoRequest
    from .measure.rpc import Domain
    from .measure.sensor_model import SensorModel
    from .point_tables import SensorInputs

MODEL_FILE, RPC, HEIGHT, CRS, PIXEL_SIZE, EXTENT = "MODEL_FILE", "RPC", "HEIGHT", "CRS", "PIXEL_SIZE", "EXTENT"
RESAMPLING, FORMAT, OUTPUT = "RESAMPLING", "FORMAT", "OUTPUT"
INTERIOR, EXTERIOR, EXTERIOR_CRS, EXTERIOR_HEIGHTS = "INTERIOR", "EXTERIOR", "EXTERIOR_CRS", "EXTERIOR_HEIGHTS"
EXTERIOR_ANGLES = "EXTERIOR_ANGLES"
ERROR_RMS, ERROR_MAX, UNCOVERED = "ERROR_RMS", "ERROR_MAX", "UNCOVERED"
PHOTOS, PHOTO_COUNT, LEFT_OUT_COUNT = "PHOTOS", "PHOTO_COUNT", "LEFT_OUT_COUNT"


class OrthoAlgorithm(SensorAlgorithm):
    """An algorithm that makes orthoimages: the parameters of photos' orientations, of terrain and of what is made."""

    def addOrientations(self) -> None:
        exterior = common.file(EXTERIOR, tr("Exterior orientation"), optional=True)
        exterior.setFileFilter(tr("All files (*)"))  # *.*, QGIS's own, leaves out folders
        self.addDescribed(exterior, tr(
            "Where the camera of an aerial photo was and how it looked: a table with filename, x, y, z, omega, phi and "
            "kappa, or a file of OpenSfM (an OpenDroneMap project's folder, too), Metashape, Pix4D, Applanix, Inpho, "
            "PATB, ContextCapture or orthority."
        ))
        self.addDescribed(common.file(INTERIOR, tr("Interior orientation"), optional=True), tr(
            "The camera of an aerial photo, as orthority, OpenSfM, Metashape, Pix4D, Inpho or ContextCapture write it. "
            "Empty: in the file of the exterior orientation."
        ))
        system = tr("Reference system of the exterior orientation")
        self.addDescribed(QgsProcessingParameterCrs(EXTERIOR_CRS, system, optional=True), tr(
            "Projected, in metres. Empty: what its file says, else the image's own."
        ), advanced=True)
        heights, angles = tr("Heights of the exterior orientation"), tr("Angles of the exterior orientation")
        self.addDescribed(common.choice(EXTERIOR_HEIGHTS, heights, limits.EXTERIOR_DATUMS), tr(
            "as_terrain: they refer to what the terrain model's heights refer to, and nothing is converted."
        ), advanced=True)
        self.addDescribed(common.choice(EXTERIOR_ANGLES, angles, limits.ANGLE_UNITS), tr(
            "For a table. auto: what its header says, else degrees."
        ), advanced=True)

    def addGround(self, terrain: str) -> None:
        """A terrain model or a height."""
        self.addTerrain(terrain, (DEM_HEIGHTS, tr("Heights of the terrain model")))
        self.addReal(HEIGHT, tr("Constant height (metres)"), None, tr(
            "Above the ellipsoid, instead of a terrain model: only where the terrain is flat."
        ))

    def addGrid(self, system: str) -> None:
        """The pixels and the file of orthoimages; ``system``: the help of their reference system."""
        self.addDescribed(QgsProcessingParameterCrs(CRS, tr("Reference system"), optional=True), system)
        self.addReal(PIXEL_SIZE, tr("Pixel size"), None, tr(
            "In units of the reference system. Empty: that of the image on the ground."
        ), least=0)
        resampling = common.choice(RESAMPLING, tr("Resampling"), limits.RESAMPLINGS, "cubic")
        self.addDescribed(resampling, tr("How pixels are interpolated."))
        self.addDescribed(common.choice(FORMAT, tr("Format"), limits.ORTHO_FORMATS), tr(
            "GeoTIFF, or cloud optimised GeoTIFF with overviews."
        ))

    def _block(self, run: Run, exterior: str) -> FrameBlock:
        """The orientations and the ground. Raises SettingsError without an exterior one."""
        from ..toolkit.layers import system_wkt
        from .measure.oriented_frames import FrameFiles, read_block
        from .point_tables import height_datums

        interior = run.path(INTERIOR)
        if not exterior:
            raise SettingsError(messages.ORIENTATION_INCOMPLETE())
        dem_datum, datum = height_datums(run, DEM_HEIGHTS, EXTERIOR_HEIGHTS)
        files = FrameFiles(
            Path(interior) if interior else None, Path(exterior), system_wkt(run.crs(EXTERIOR_CRS)), datum,
            run.text(EXTERIOR_ANGLES),
        )  # fmt: skip
        return read_block(files, self._dem, dem_datum, run.real(HEIGHT))

    def _request(
        self, run: Run, image: RasterRef, sight: tuple[SensorModel, str, Domain, Datum], output: Path
    ) -> OrthoRequest:
        """Request for one image and what ``_model`` says of it, in its whole extent."""
        from ..toolkit.layers import system_wkt
        from .measure.orthorectification import OrthoRequest

        model, wkt, domain, datum = sight
        return OrthoRequest(
            image, model, wkt, domain, self._dem, datum, optional_real(run, HEIGHT), output, system_wkt(run.crs(CRS)),
            optional_real(run, PIXEL_SIZE), resampling=run.text(RESAMPLING), format=run.text(FORMAT),
        )  # fmt: skip


class Orthorectify(OrthoAlgorithm):
    """An orthoimage from an image, its model and terrain heights."""

    ID = "orthorectify"
    NAME = QT_TR_NOOP("Orthorectify")
    HELP = QT_TR_NOOP(
        "Puts an image on the map over a terrain model: a satellite image by a model file of Fit sensor model, an RPC "
        "file or its own RPC, an aerial photo by its interior and exterior orientation. GDAL's warper does it with all "
        "cores; how far it is from the exact model is measured on a grid and reported. Heights above sea level are "
        "brought to the ellipsoid, as RPCs want them."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.addImage(optional=False)
        model_file = common.file(MODEL_FILE, tr("Model file"), optional=True)
        self.addDescribed(model_file, tr("As Fit sensor model writes it."))
        self.addDescribed(common.file(RPC, tr("RPC file"), optional=True), tr(
            "_RPC.TXT, .RPB, RPC_*.XML (DIMAP) or .geom. Without it and without a model file: the image's own RPC."
        ))
        self.addOrientations()
        self.addGround(tr("Terrain heights under the whole image, in any reference system."))
        self.addTerrainError()
        self.addGrid(tr("System of the orthoimage. Empty: that of the extent, or the UTM zone of the image's centre."))
        extent = QgsProcessingParameterExtent(EXTENT, tr("Extent"), optional=True)
        self.addDescribed(extent, tr("Empty: the whole image. It is widened to whole pixels."))
        output = QgsProcessingParameterRasterDestination(OUTPUT, tr("Orthoimage"))
        self.addDescribed(output, tr("A GeoTIFF; empty where the image or the terrain model ends."))
        self.addViewNumbers()
        self.addNumbers({
            ERROR_RMS: tr("Root mean square against the exact model (px)"),
            ERROR_MAX: tr("Largest error against the exact model (px)"),
            UNCOVERED: tr("Share of the image without terrain heights"),
        })

    def check(self, run: Run) -> None:
        from .measure.rpc import open_image

        open_image(run.required_raster(IMAGE))

    def execute(self, run: Run) -> dict[str, Any]:
        from ..toolkit.layers import box_extent, system_wkt
        from .measure.fit_files import view_direction
        from .measure.orthorectification import orthorectify
        from .point_tables import SensorInputs

        self.check(run)
        given = SensorInputs(run, *self._prepared, RPC)
        assert given.image is not None
        sight = self._model(run, given, given.image)
        request = self._request(run, given.image.ref, sight, Path(run.layer_path(OUTPUT)))
        if run.parameters.get(EXTENT):
            named = self.parameterAsExtentCrs(run.parameters, EXTENT, run.context)
            target = run.crs(CRS) if request.target_wkt else named
            if not target.isValid():
                raise SettingsError(messages.EXTENT_WITHOUT_SYSTEM())
            extent = box_extent(self.parameterAsExtent(run.parameters, EXTENT, run.context, target))
            request = replace(request, target_wkt=system_wkt(target), extent=extent)
        made = orthorectify(request, run.progress, run.is_cancelled)
        run.tell(*made.notices)
        run.feedback.pushInfo(_described(made))
        view = view_direction(*sight[:3], run.real(TERRAIN_ERROR))
        if view is not None:
            run.tell(view.notice)
        return {
            OUTPUT: str(made.path), ERROR_RMS: made.rms_px, ERROR_MAX: made.max_px, UNCOVERED: made.uncovered,
            **view_numbers(view),
        }  # fmt: skip

    def _model(
        self, run: Run, given: SensorInputs, image: OpenRaster
    ) -> tuple[SensorModel, str, Domain, Datum]:
        """The model in the image's pixels, its system and domain, and the datum that the terrain's heights have."""
        from .measure.fit_files import load_model
        from .measure.orthorectification import rpc_domain
        from .measure.sensor_model import WGS84
        from .point_tables import height_datums

        path, is_photo = run.path(MODEL_FILE), run.path(INTERIOR) or run.path(EXTERIOR)
        if sum(map(bool, (path, run.path(RPC), is_photo))) > 1:
            raise SettingsError(messages.SEVERAL_MODELS())
        if is_photo:
            frame = self._block(run, run.path(EXTERIOR)).frame(image)
            run.tell(*frame.notices)
            return frame[:4]
        datum = height_datums(run, DEM_HEIGHTS, EXTERIOR_HEIGHTS)[0]
        if path:
            file = load_model(Path(path))
            return file.model, file.wkt, file.domain, datum
        if given.rpc is None:
            raise SensorModelError(messages.NO_RPC())
        return given.rpc, WGS84, rpc_domain(given.rpc, image.raster), datum


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
        if optional_real(run, HEIGHT) is not None and run.parameters.get(DEM):
            raise SettingsError(messages.TERRAIN_OR_HEIGHT())

    def execute(self, run: Run) -> dict[str, Any]:
        from ..imagery.rasters import RasterRef
        from .measure.oriented_frames import block_photos, project_photos, project_terrain
        from .measure.orthorectification import orthorectify
        from .measure.rpc import open_image

        self.check(run)
        exterior, output = Path(run.path(EXTERIOR) or run.path(PHOTOS)), Path(run.text(OUTPUT))
        if self._dem is None and optional_real(run, HEIGHT) is None:
            self._dem = project_terrain(exterior)
            run.tell(messages.PROJECT_TERRAIN(name=self._dem.path))
        block = self._block(run, str(exterior))
        folder = Path(run.path(PHOTOS)) if run.path(PHOTOS) and run.path(EXTERIOR) else project_photos(exterior)
        read = [run.path(name) for name in (EXTERIOR, INTERIOR, GEOID)] + [self._dem.path if self._dem else ""]
        photos, left_out = block_photos(block.exteriors, folder, output, map(Path, filter(None, read)))
        run.tell(*left_out)
        wkt, size, count = "", None, 0
        for number, photo in enumerate(photos):
            run.feedback.setProgressText(photo.name)
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
            wkt, size, count = made.wkt, made.grid.pixel_width, count + 1
            run.tell_once(made.notices)
            run.feedback.pushInfo(f"{photo.name}: {_described(made)}")
        if left_out and not count and not run.is_cancelled():
            raise SensorModelError(left_out[-1])
        return {OUTPUT: str(output), PHOTO_COUNT: count, LEFT_OUT_COUNT: len(left_out)}


def optional_real(run: Run, name: str) -> float | None:
    """A number that may be left out."""
    return None if run.parameters.get(name) in (None, "") else run.real(name)


def _described(made: Ortho) -> str:
    return filled(
        tr("{columns} x {rows} px of {size:g}; against the exact model {rms:.2g} px, at most {most:.2g} px."),
        columns=made.grid.columns, rows=made.grid.rows, size=made.grid.pixel_width, rms=made.rms_px, most=made.max_px,
    )  # fmt: skip
