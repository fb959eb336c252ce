"""``seaminspector:orthorectify``: an image over a terrain model."""
from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsProcessingParameterCrs,
    QgsProcessingParameterExtent,
    QgsProcessingParameterFile,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterDestination,
)
from qgis.PyQt.QtCore import QT_TR_NOOP

from ..imagery.errors import SensorModelError, SettingsError
from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.run import Run
from ..toolkit.translation import filled, tr
from .measure import limits, messages
from .sensor_parameters import DEM, DEM_HEIGHTS, IMAGE, TERRAIN_ERROR, SensorAlgorithm, height_datums, view_numbers

if TYPE_CHECKING:
    from ..imagery.open_raster import OpenRaster
    from .measure.heights import Datum
    from .measure.rpc import Domain
    from .measure.sensor_model import SensorModel

MODEL_FILE, RPC, HEIGHT, CRS, PIXEL_SIZE, EXTENT = "MODEL_FILE", "RPC", "HEIGHT", "CRS", "PIXEL_SIZE", "EXTENT"
RESAMPLING, FORMAT, OUTPUT = "RESAMPLING", "FORMAT", "OUTPUT"
INTERIOR, EXTERIOR, EXTERIOR_CRS, EXTERIOR_HEIGHTS = "INTERIOR", "EXTERIOR", "EXTERIOR_CRS", "EXTERIOR_HEIGHTS"
EXTERIOR_ANGLES = "EXTERIOR_ANGLES"
ERROR_RMS, ERROR_MAX, UNCOVERED = "ERROR_RMS", "ERROR_MAX", "UNCOVERED"


class Orthorectify(SensorAlgorithm):
    """An orthoimage from an image, its model and terrain heights."""

    ID = "orthorectify"
    RASTER_LISTS = (DEM,)
    NAME = QT_TR_NOOP("Orthorectify")
    HELP = QT_TR_NOOP(
        "Puts an image on the map over a terrain model: a satellite image by a model file of Fit sensor model, an RPC "
        "file or its own RPC, an aerial photo by its interior and exterior orientation. GDAL's warper does it with all "
        "cores; how far it is from the exact model is measured on a grid and reported. Heights above sea level are "
        "brought to the ellipsoid, as RPCs want them."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.addImage(optional=False)
        for name, label, purpose in (
            (MODEL_FILE, tr("Model file"), tr("As Fit sensor model writes it.")),
            (
                RPC,
                tr("RPC file"),
                tr(
                    "_RPC.TXT, .RPB, RPC_*.XML (DIMAP), .geom, ALOS's text or a YAML file of orthority. Without it and "
                    "without a model file: the image's own RPC."
                ),
            ),
            (
                INTERIOR,
                tr("Interior orientation"),
                tr(
                    "The camera of an aerial photo, as orthority, OpenSfM, Metashape, Pix4D, Inpho, ContextCapture or "
                    "MicMac write it. Empty: in the file of the exterior orientation."
                ),
            ),
            (
                EXTERIOR,
                tr("Exterior orientation"),
                tr(
                    "Where the camera of an aerial photo was and how it looked: a table with filename, x, y, z, omega, "
                    "phi and kappa, or a file of OpenSfM (an OpenDroneMap project's folder, too), Metashape, Pix4D, "
                    "Applanix, Inpho, PATB, ContextCapture, orthority or MicMac."
                ),
            ),
        ):
            self.addDescribed(QgsProcessingParameterFile(name, label, optional=True), purpose)
        self.addDescribed(
            QgsProcessingParameterCrs(EXTERIOR_CRS, tr("Reference system of the exterior orientation"), optional=True),
            tr("Projected, in metres. Empty: what its file says, else the image's own."),
            advanced=True,
        )
        self.addDescribed(
            common.choice(EXTERIOR_HEIGHTS, tr("Heights of the exterior orientation"), limits.EXTERIOR_DATUMS),
            tr("as_terrain: they refer to what the terrain model's heights refer to, and nothing is converted."),
            advanced=True,
        )
        self.addDescribed(
            common.choice(EXTERIOR_ANGLES, tr("Angles of the exterior orientation"), limits.ANGLE_UNITS),
            tr("Of a table. auto: what its header says, else degrees."),
            advanced=True,
        )
        self.addTerrain(
            tr("Terrain heights under the whole image, in any reference system."),
            (DEM_HEIGHTS, tr("Heights of the terrain model")),
        )
        self.addTerrainError()
        self.addDescribed(
            QgsProcessingParameterNumber(
                HEIGHT, tr("Constant height (metres)"), QgsProcessingParameterNumber.Type.Double, None, optional=True
            ),
            tr("Above the ellipsoid, instead of a terrain model: only where the terrain is flat."),
        )
        self.addDescribed(
            QgsProcessingParameterCrs(CRS, tr("Reference system"), optional=True),
            tr("Of the orthoimage. Empty: that of the extent, or the UTM zone of the image's centre."),
        )
        self.addDescribed(
            QgsProcessingParameterNumber(
                PIXEL_SIZE, tr("Pixel size"), QgsProcessingParameterNumber.Type.Double, None, True, 0
            ),
            tr("In units of the reference system. Empty: that of the image on the ground."),
        )
        self.addDescribed(
            QgsProcessingParameterExtent(EXTENT, tr("Extent"), optional=True),
            tr("Empty: the whole image. It is widened to whole pixels."),
        )
        self.addDescribed(
            common.choice(RESAMPLING, tr("Resampling"), limits.RESAMPLINGS, "cubic"), tr("How pixels are interpolated.")
        )
        self.addDescribed(
            common.choice(FORMAT, tr("Format"), limits.ORTHO_FORMATS),
            tr("GeoTIFF, or cloud optimised GeoTIFF with overviews."),
        )
        self.addDescribed(
            QgsProcessingParameterRasterDestination(OUTPUT, tr("Orthoimage")),
            tr("A GeoTIFF; empty where the image or the terrain model ends."),
        )
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
        from .measure.orthorectification import OrthoRequest, orthorectify

        self.check(run)
        assert self._image_ref is not None
        image = self._image()
        assert image is not None
        model, wkt, domain, dem_datum = self._model(run, image)
        target = run.crs(CRS)
        extent = None
        if run.parameters.get(EXTENT):
            if not target.isValid():
                target = run.extent_crs(EXTENT)
            if not target.isValid():
                raise SettingsError(messages.EXTENT_WITHOUT_SYSTEM())
            extent = box_extent(run.extent(EXTENT, target))
        size = run.parameters.get(PIXEL_SIZE)
        height = run.parameters.get(HEIGHT)
        output = Path(run.layer_path(OUTPUT))
        request = OrthoRequest(
            self._image_ref,
            model,
            wkt,
            domain,
            self._dem,
            dem_datum,
            None if height in (None, "") else run.real(HEIGHT),
            output,
            system_wkt(target),
            None if size in (None, "") else run.real(PIXEL_SIZE),
            extent,
            run.text(RESAMPLING),
            run.text(FORMAT),
        )
        made = orthorectify(request, run.progress, run.is_cancelled)
        run.tell(*made.notices)
        run.inform(
            filled(tr(
                "{columns} x {rows} px of {size:g}; against the exact model {rms:.2g} px, at most {most:.2g} px."
            ), columns=made.columns, rows=made.rows, size=made.pixel_size, rms=made.rms_px, most=made.max_px)
        )
        results = {OUTPUT: str(made.path), ERROR_RMS: made.rms_px, ERROR_MAX: made.max_px, UNCOVERED: made.uncovered}
        view = view_direction(model, wkt, domain)
        if view is not None:
            run.tell(view.told(run.real(TERRAIN_ERROR)))
        return {**results, **view_numbers(run, view)}

    def _model(self, run: Run, image: OpenRaster) -> tuple[SensorModel, str, Domain, Datum]:
        """The model in the image's own pixels, the system it is in, where it is used, and what the terrain model's
        heights are to be taken as."""
        from .measure.fit_files import load_model
        from .measure.orthorectification import rpc_domain
        from .measure.sensor_model import WGS84

        path = run.path(MODEL_FILE)
        datums = height_datums(run, DEM_HEIGHTS, EXTERIOR_HEIGHTS)
        dem_datum, exterior_datum = datums
        if path and run.path(RPC):
            raise SettingsError(messages.MODEL_AND_RPC())
        if run.path(INTERIOR) or run.path(EXTERIOR):
            if path or run.path(RPC):
                raise SettingsError(messages.ORIENTATION_AND_MODEL())
            return self._frame(run, image, dem_datum, exterior_datum)
        if path:
            file = load_model(Path(path))
            return file.model, file.wkt, file.domain, dem_datum
        rpc = self._rpc(run, RPC, image)
        if rpc is None:
            raise SensorModelError(messages.NO_RPC())
        return rpc, WGS84, rpc_domain(rpc, image.raster), dem_datum

    def _frame(
        self, run: Run, image: OpenRaster, dem_datum: Datum, datum: Datum
    ) -> tuple[SensorModel, str, Domain, Datum]:
        from ..toolkit.layers import system_wkt
        from .measure.oriented_frames import FrameFiles, oriented_frame

        interior, exterior = run.path(INTERIOR), run.path(EXTERIOR)
        if not exterior:
            raise SettingsError(messages.ORIENTATION_INCOMPLETE())
        wkt = system_wkt(run.crs(EXTERIOR_CRS))
        angles = run.text(EXTERIOR_ANGLES)
        files = FrameFiles(Path(interior) if interior else None, Path(exterior), wkt, datum, angles)
        made = oriented_frame(image, files, self._dem, dem_datum, run.real(HEIGHT))
        run.tell(*made.notices)
        return made.camera, made.wkt, made.domain, made.terrain_datum
