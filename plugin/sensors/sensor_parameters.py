"""Points, images, heights and their parameters, which the algorithms of sensor models share."""
from __future__ import annotations

from contextlib import suppress
from typing import TYPE_CHECKING, Any

from osgeo import osr
from qgis.core import QgsProcessingParameterCrs, QgsProviderRegistry, QgsVectorLayer

from ..imagery.gdal_calls import gdal_silenced
from ..imagery.gdal_paths import FEATURES, open_dataset
from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.base import SATELLITE_IMAGES, SeamInspectorAlgorithm
from ..toolkit.algorithms.run import Run
from ..toolkit.translation import tr
from .measure import limits

if TYPE_CHECKING:
    from .measure.fit_files import ViewDirection

MOST_CHECK_SHARE = 0.9
DEFAULT_CHECK_SHARE = 0.25  # Kurczynski and Wolniewicz: 7 to 10 control and 10 to 46 check points

GCPS, GCPS_CRS, IMAGE, IMAGE_RPC, DEM = "GCPS", "GCPS_CRS", "IMAGE", "IMAGE_RPC", "DEM"
HEIGHTS, DEM_HEIGHTS, GEOID, TERRAIN_ERROR = "HEIGHTS", "DEM_HEIGHTS", "GEOID", "TERRAIN_ERROR"
VIEW_ANGLE, VIEW_AZIMUTH, TERRAIN_SHIFT = "VIEW_ANGLE", "VIEW_AZIMUTH", "TERRAIN_SHIFT"
CHECK_SHARE, ROBUST, ORBIT_HEIGHT = "CHECK_SHARE", "ROBUST", "ORBIT_HEIGHT"

POINTS_SUFFIX = ".points"
IMAGE_SUFFIXES = (".tif", ".tiff", ".vrt", ".ntf", ".nitf", ".jp2", ".img")


class SensorAlgorithm(SeamInspectorAlgorithm):
    GROUP = SATELLITE_IMAGES

    def addReal(
        self, name: str, label: str, default: float | None, purpose: str, advanced: bool = False, **limits: float
    ) -> None:
        """A number between ``least`` and ``most``, which may be left out where it has no default."""
        number = common.real(name, label, default, optional=default is None, decimals=None, **limits)
        self.addDescribed(number, purpose, advanced)

    def addPoints(self) -> None:
        self.addDescribed(common.features(GCPS, tr("Ground control points"), common.POINT, optional=True), tr(
            "A point layer with the fields column and row (the place in the image in pixels, 0 0 being the upper "
            "left corner of the first pixel), and if there are any id, z, role (control or check) and sigma "
            "(standard deviation in pixels); or a .points file of QGIS's georeferencer, or a TIFF that holds such "
            "points. Empty: those inside the image."
        ))

    def addImage(self, optional: bool = True) -> None:
        self.addDescribed(common.raster(IMAGE, tr("Image"), optional), tr(
            "The satellite image as delivered, not georeferenced. Its size, satellite and RPC are taken from it."
        ))

    def addTerrain(self, purpose: str, *heights: tuple[str, str]) -> None:
        """A terrain model, what heights refer to (names and labels), and the grid for some of them."""
        self.addDescribed(common.raster(DEM, tr("Terrain model"), optional=True), purpose)
        for name, label in heights:
            self.addDescribed(common.choice(name, label, limits.HEIGHT_DATUMS), tr(
                "What the heights refer to: auto takes what the reference system says, and the ellipsoid with a "
                "warning where it says nothing; egm96 and egm2008 (heights above sea level) are converted if PROJ "
                "has the grid, geoid by a grid file of your own. SRTM tiles are egm96."
            ))
        self.addDescribed(common.file(GEOID, tr("Grid of the geoid"), optional=True), tr(
            "For heights that refer to geoid: how far sea level is above the ellipsoid, as .gtx, .tif or any raster."
        ), advanced=True)

    def addTerrainError(self) -> None:
        """The error of terrain heights that the view is judged by."""
        self.addReal(TERRAIN_ERROR, tr("Error of terrain heights (metres)"), 1.0, tr(
            "The log says how far an error of this size moves the orthoimage, by the angle that the image was taken at."
        ), advanced=True, least=0)

    def addFittingParameters(self) -> None:
        """The parameters of a fit beside its points and model."""
        self.addImage()
        self.addDescribed(common.file(IMAGE_RPC, tr("RPC of the image"), optional=True), tr(
            "The vendor's RPC where GDAL does not find it beside the image: _RPC.TXT, .RPB, RPC_*.XML (DIMAP) or .geom."
        ))
        heights = (HEIGHTS, tr("Heights of the points")), (DEM_HEIGHTS, tr("Heights of the terrain model"))
        self.addTerrain(tr("Gives heights to points that have none."), *heights)
        self.addReal(CHECK_SHARE, tr("Share of check points"), DEFAULT_CHECK_SHARE, tr(
            "Where no point has a role, this share of them, evenly spread, checks the fit and is not used in it. The "
            "same points give the same choice."
        ), least=0, most=MOST_CHECK_SHARE)
        self.addDescribed(common.flag(ROBUST, tr("Look for blunders")), tr(
            "Flags points that contradict the others and fits the model without them."
        ))
        system = QgsProcessingParameterCrs(GCPS_CRS, tr("Reference system of a .points file"), optional=True)
        self.addDescribed(system, tr(
            "For files from before QGIS 3.26, which do not name the reference system of their map coordinates."
        ), advanced=True)
        self.addReal(ORBIT_HEIGHT, tr("Height of the orbit (km)"), None, tr(
            "Nominal, for the model pushbroom. Empty: by the satellite that the image's metadata name, else 694 "
            "km. IKONOS 681, QuickBird 450, EROS-A1 480, Pleiades 694, WorldView-3 617."
        ), advanced=True, least=0, most=40000)

    def addViewNumbers(self) -> None:
        self.addNumbers({
            VIEW_ANGLE: tr("Angle of the view from the vertical, in the middle of the image (degrees)"),
            VIEW_AZIMUTH: tr("Azimuth that the image was taken from (degrees)"),
            TERRAIN_SHIFT: tr("Displacement of the image's middle by the error of terrain heights (m)"),
        })

    def for_check(self, parameters: dict[str, Any]) -> dict[str, Any]:
        # A georeferencer's file or an image is no layer that QGIS can load, so its own check gets one in its place.
        given = super().for_check(parameters)
        if points_path(given.get(GCPS)):
            given[GCPS] = QgsVectorLayer("Point?crs=EPSG:4326", "points", "memory")
        return given

    def prepare_run(self, run: Run) -> None:
        given = run.parameters.get(GCPS)
        layer = run.vector_layer(GCPS) if given and not points_path(given) else None
        image, self._dem = run.raster(IMAGE), run.raster(DEM)
        self._prepared = image, self._dem, "" if layer is None else _heights_wkt(layer)
        """The files of the image and the terrain, and the system that says what the points' heights are."""


def _heights_wkt(layer: QgsVectorLayer) -> str:
    """The system that says what a layer's heights are, or empty: QGIS forgets it, so code and file are asked."""
    from ..imagery.reference_systems import spatial_reference
    from ..toolkit.layers import layer_path

    code = str(layer.crs().authid())
    if _has_heights(spatial_reference(code)):
        return code
    path = layer_path(layer)
    file = open_dataset(path, FEATURES) if path else None
    name = QgsProviderRegistry.instance().decodeUri("ogr", layer.source()).get("layerName")
    with gdal_silenced(), suppress(RuntimeError):
        part = None if file is None else file.GetLayerByName(name) if name else file.GetLayer(0)
        stored = None if part is None else part.GetSpatialRef()
        if stored is not None and _has_heights(stored):
            return str(stored.ExportToWkt(["FORMAT=WKT2_2018"]))
    return ""


def _has_heights(system: osr.SpatialReference) -> bool:
    return bool(system.IsCompound()) or system.GetAxesCount() == 3


def view_numbers(view: ViewDirection | None) -> dict[str, float | None]:
    """The numbers of a view; None for a plane model."""
    numbers = (None,) * 3 if view is None else (view.angle, view.azimuth, view.shift)
    return dict(zip((VIEW_ANGLE, VIEW_AZIMUTH, TERRAIN_SHIFT), numbers))


def points_path(value: object) -> str:
    """Path of a georeferencer's file or an image that holds points; empty for a layer."""
    return value if isinstance(value, str) and value.lower().endswith((POINTS_SUFFIX, *IMAGE_SUFFIXES)) else ""
