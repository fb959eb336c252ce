"""``seaminspector:orthorectify``: an image over a terrain model."""
from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import QgsProcessingParameterExtent, QgsProcessingParameterRasterDestination
from qgis.PyQt.QtCore import QT_TR_NOOP

from ..imagery.errors import SensorModelError, SettingsError
from ..toolkit.algorithms.run import Run
from ..toolkit.translation import filled, tr
from .measure import limits, messages
from .sensor_parameters import DEM, DEM_HEIGHTS, IMAGE, TERRAIN_ERROR, SensorAlgorithm, height_datums, view_numbers

if TYPE_CHECKING:
    from ..imagery.open_raster import OpenRaster
    from ..imagery.rasters import RasterRef
    from .measure.heights import Datum
    from .measure.oriented_frames import FrameBlock
    from .measure.orthorectification import Ortho, OrthoRequest
    from .measure.rpc import Domain
    from .measure.sensor_model import SensorModel

MODEL_FILE, RPC, HEIGHT, CRS, PIXEL_SIZE, EXTENT = "MODEL_FILE", "RPC", "HEIGHT", "CRS", "PIXEL_SIZE", "EXTENT"
RESAMPLING, FORMAT, OUTPUT = "RESAMPLING", "FORMAT", "OUTPUT"
INTERIOR, EXTERIOR, EXTERIOR_CRS, EXTERIOR_HEIGHTS = "INTERIOR", "EXTERIOR", "EXTERIOR_CRS", "EXTERIOR_HEIGHTS"
EXTERIOR_ANGLES = "EXTERIOR_ANGLES"
ERROR_RMS, ERROR_MAX, UNCOVERED = "ERROR_RMS", "ERROR_MAX", "UNCOVERED"


class OrthoAlgorithm(SensorAlgorithm):
    """An algorithm that makes orthoimages: the parameters of photos' orientations, of terrain and of what is made."""

    RASTER_LISTS = (DEM,)

    def addOrientations(self) -> None:
        self.addFile(EXTERIOR, tr("Exterior orientation"), tr(
            "Where the camera of an aerial photo was and how it looked: a table with filename, x, y, z, omega, phi and "
            "kappa, or a file of OpenSfM (an OpenDroneMap project's folder, too), Metashape, Pix4D, Applanix, Inpho, "
            "PATB, ContextCapture, orthority or MicMac."
        ), filters=tr("All files (*)"))  # *.*, QGIS's own, leaves out folders
        self.addFile(INTERIOR, tr("Interior orientation"), tr(
            "The camera of an aerial photo, as orthority, OpenSfM, Metashape, Pix4D, Inpho, ContextCapture or MicMac "
            "write it. Empty: in the file of the exterior orientation."
        ))
        self.addSystem(EXTERIOR_CRS, tr("Reference system of the exterior orientation"), tr(
            "Projected, in metres. Empty: what its file says, else the image's own."
        ), advanced=True)
        self.addChoice(EXTERIOR_HEIGHTS, tr("Heights of the exterior orientation"), limits.EXTERIOR_DATUMS, tr(
            "as_terrain: they refer to what the terrain model's heights refer to, and nothing is converted."
        ), advanced=True)
        self.addChoice(EXTERIOR_ANGLES, tr("Angles of the exterior orientation"), limits.ANGLE_UNITS, tr(
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
        self.addSystem(CRS, tr("Reference system"), system)
        self.addReal(PIXEL_SIZE, tr("Pixel size"), None, tr(
            "In units of the reference system. Empty: that of the image on the ground."
        ), least=0)
        self.addChoice(
            RESAMPLING, tr("Resampling"), limits.RESAMPLINGS, tr("How pixels are interpolated."), default="cubic"
        )
        self.addChoice(FORMAT, tr("Format"), limits.ORTHO_FORMATS, tr(
            "GeoTIFF, or cloud optimised GeoTIFF with overviews."
        ))

    def _block(self, run: Run, exterior: str) -> FrameBlock:
        """The orientations and the ground. Raises SettingsError without an exterior one."""
        from ..toolkit.layers import system_wkt
        from .measure.oriented_frames import FrameFiles, read_block

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
        height, size = (
            run.real(name) if run.parameters.get(name) not in (None, "") else None for name in (HEIGHT, PIXEL_SIZE)
        )
        return OrthoRequest(
            image, model, wkt, domain, self._dem, datum, height, output, system_wkt(run.crs(CRS)), size,
            resampling=run.text(RESAMPLING), format=run.text(FORMAT),
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
        self.addFile(MODEL_FILE, tr("Model file"), tr("As Fit sensor model writes it."))
        self.addFile(RPC, tr("RPC file"), tr(
            "_RPC.TXT, .RPB, RPC_*.XML (DIMAP), .geom, ALOS's text or a YAML file of orthority. Without it and without "
            "a model file: the image's own RPC."
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
        given = run.parameters.get(HEIGHT) not in (None, "")
        if given == bool(run.parameters.get(DEM)):
            raise SettingsError(messages.DEM_AND_HEIGHT() if given else messages.NO_DEM())

    def execute(self, run: Run) -> dict[str, Any]:
        from ..toolkit.layers import box_extent, system_wkt
        from .measure.fit_files import view_direction
        from .measure.orthorectification import orthorectify

        self.check(run)
        image = self._image()
        assert image is not None
        sight = self._model(run, image)
        request = self._request(run, image.ref, sight, Path(run.layer_path(OUTPUT)))
        if run.parameters.get(EXTENT):
            target = run.crs(CRS) if request.target_wkt else run.extent_crs(EXTENT)
            if not target.isValid():
                raise SettingsError(messages.EXTENT_WITHOUT_SYSTEM())
            extent = box_extent(run.extent(EXTENT, target))
            request = replace(request, target_wkt=system_wkt(target), extent=extent)
        made = orthorectify(request, run.progress, run.is_cancelled)
        run.tell(*made.notices)
        run.inform(described(made))
        view = view_direction(*sight[:3])
        if view is not None:
            run.tell(view.notice(run.real(TERRAIN_ERROR)))
        return {
            OUTPUT: str(made.path), ERROR_RMS: made.rms_px, ERROR_MAX: made.max_px, UNCOVERED: made.uncovered,
            **view_numbers(run, view),
        }  # fmt: skip

    def _model(self, run: Run, image: OpenRaster) -> tuple[SensorModel, str, Domain, Datum]:
        """The model in the image's pixels, its system and domain, and the datum that the terrain's heights have."""
        from .measure.fit_files import load_model
        from .measure.orthorectification import rpc_domain
        from .measure.sensor_model import WGS84

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
        rpc = self._rpc(run, RPC, image)
        if rpc is None:
            raise SensorModelError(messages.NO_RPC())
        return rpc, WGS84, rpc_domain(rpc, image.raster), datum


def described(made: Ortho) -> str:
    return filled(
        tr("{columns} x {rows} px of {size:g}; against the exact model {rms:.2g} px, at most {most:.2g} px."),
        columns=made.columns, rows=made.rows, size=made.pixel_size, rms=made.rms_px, most=made.max_px,
    )  # fmt: skip
