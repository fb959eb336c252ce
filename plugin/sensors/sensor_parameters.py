"""Points, images, heights and their parameters, which the algorithms of sensor models share."""
from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import QgsProcessingParameterCrs, QgsVectorLayer

from ..imagery.errors import SettingsError
from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.base import SATELLITE_IMAGES, SeamInspectorAlgorithm
from ..toolkit.algorithms.run import Run
from ..toolkit.translation import tr
from .measure import limits, messages

if TYPE_CHECKING:
    from ..imagery.errors import Message
    from ..imagery.open_raster import OpenRaster
    from .measure.fit_files import ViewDirection
    from .measure.heights import Datum
    from .measure.points import ImageBox, Points
    from .measure.polynomials import Rational
    from .measure.registry import ModelRequest

MOST_CHECK_SHARE = 0.9
DEFAULT_CHECK_SHARE = 0.25  # Kurczynski and Wolniewicz: 7 to 10 control and 10 to 46 check points
ORBIT_HEIGHTS_KM = {  # by the satellite's name in the image's metadata; the operators' data sheets
    "PHR": 694.0, "PLEIADES": 694.0, "SPOT": 694.0, "PNEO": 620.0, "IK": 681.0, "QB": 450.0, "WV01": 496.0,
    "WV02": 770.0, "WV03": 617.0, "WV04": 617.0, "GE01": 681.0, "GEOEYE": 681.0, "EROS": 480.0, "KOMPSAT": 685.0,
}  # fmt: skip

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
        if _file_path(given.get(GCPS)):
            given[GCPS] = QgsVectorLayer("Point?crs=EPSG:4326", "points", "memory")
        return given

    def prepare_run(self, run: Run) -> None:
        self._image_ref = run.raster(IMAGE)
        self._dem = run.raster(DEM)
        self._heights_wkt = ""  # of the points' layer, which may say what heights are in
        given = run.parameters.get(GCPS)
        layer = run.vector_layer(GCPS) if given and not _file_path(given) else None
        if layer is not None:
            from .point_tables import heights_wkt

            self._heights_wkt = heights_wkt(layer)

    def _image(self) -> OpenRaster | None:
        from .measure.rpc import open_image

        return open_image(self._image_ref) if self._image_ref is not None else None

    def _points(
        self, run: Run, image: OpenRaster | None, rpc: Rational | None, request: ModelRequest | None = None
    ) -> Points:
        """The points with roles, and heights where the model (None: any) needs them, held against the image's RPC."""
        from .measure.heights import with_heights
        from .measure.points import check_against_rpc, check_inside, check_plausible, choose_check_points

        points, with_roles, notices = self._points_given(run, image)
        run.tell(*notices)
        check_plausible(points)
        if request is None or request.needs_heights:
            datum, dem_datum = height_datums(run, HEIGHTS, DEM_HEIGHTS)
            points, notices = with_heights(points, datum, self._dem, dem_datum, tr("the points"))
            run.tell(*notices)
        if not len(points):
            raise SettingsError(messages.NO_POINTS())
        if image is not None:
            run.tell(*check_inside(points, (image.columns, image.rows), rpc))
        if rpc is not None:
            run.tell(*check_against_rpc(points, rpc))
        return points if with_roles else choose_check_points(points, run.real(CHECK_SHARE))

    def _points_given(self, run: Run, image: OpenRaster | None) -> tuple[Points, bool, list[Message]]:
        """The points as given, whether they have roles, and what was left out."""
        from ..imagery.rasters import RasterRef
        from ..toolkit.layers import system_wkt
        from . import point_tables
        from .measure.points import file_points, image_points
        from .measure.rpc import open_image

        given = run.parameters.get(GCPS)
        path, wkt = _file_path(given), system_wkt(run.crs(GCPS_CRS))
        if path.lower().endswith(POINTS_SUFFIX):
            points, notices = file_points(Path(path), wkt, image.raster.geotransform if image is not None else None)
            return points, False, notices
        if path:
            return image_points(open_image(RasterRef(path, wkt))), False, []
        if not given:
            if image is None:
                raise SettingsError(messages.NO_POINTS())
            return image_points(image), False, []
        return point_tables.layer_points(run.source(GCPS), self._heights_wkt)

    def _rpc(self, run: Run, name: str, image: OpenRaster | None) -> Rational | None:
        """The RPC of a file, or the image's own, in the image's own pixels; None where there is none."""
        from .measure.rpc import own_rpc, read_rpc, rpc_of_image_part

        path = run.path(name)
        rpc = read_rpc(Path(path)) if path else own_rpc(image) if image is not None else None
        if rpc is None or image is None or (not path and image.dataset.GetMetadata("RPC")):
            return rpc
        rpc, notice = rpc_of_image_part(rpc, image.raster)
        if notice is not None:
            run.tell(notice)
        return rpc

    def _orbit_height_m(self, run: Run, image: OpenRaster | None) -> float:
        """Height of the orbit as given, else by the satellite that the image's metadata name, else the default."""
        data = image.dataset if image is not None else None
        about = {**(data.GetMetadata() or {}), **(data.GetMetadata("IMAGERY") or {})} if data is not None else {}
        name = str(about.get("SATELLITEID") or about.get("NITF_ISORCE") or "").upper()
        known = (height for word, height in ORBIT_HEIGHTS_KM.items() if name.startswith(word))
        return (run.real(ORBIT_HEIGHT) or next(known, limits.DEFAULT_ORBIT_HEIGHT_KM)) * 1000


def optional_real(run: Run, name: str) -> float | None:
    """A number that may be left out."""
    return None if run.parameters.get(name) in (None, "") else run.real(name)


def view_numbers(view: ViewDirection | None) -> dict[str, float | None]:
    """The numbers of a view; None for a plane model."""
    numbers = (None,) * 3 if view is None else (view.angle, view.azimuth, view.shift)
    return dict(zip((VIEW_ANGLE, VIEW_AZIMUTH, TERRAIN_SHIFT), numbers))


def height_datums(run: Run, *names: str) -> list[Datum]:
    """The datums of heights by these parameters, with the grid of GEOID. Raises SettingsError without it, or unused."""
    from ..imagery.rasters import RasterRef
    from .measure.heights import GEOID as BY_GRID

    words, path = [run.text(name) for name in names], run.path(GEOID)
    if (BY_GRID in words) != bool(path):
        raise SettingsError(messages.GEOID_OR_NONE())
    return [RasterRef(path) if word == BY_GRID else word for word in words]


def image_box(image: OpenRaster | None, points: Points) -> ImageBox:
    """The image's rectangle, or that of the points where there is no image."""
    if image is not None:
        return 0.0, 0.0, float(image.columns), float(image.rows)
    from .measure.sensor_model import bounding_box

    return bounding_box(points.image)


def _file_path(value: object) -> str:
    """Path of a georeferencer's file or an image that holds points; empty for a layer."""
    return value if isinstance(value, str) and value.lower().endswith((POINTS_SUFFIX, *IMAGE_SUFFIXES)) else ""
