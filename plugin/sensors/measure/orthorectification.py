"""Orthoimages: of photos pixel by pixel by their own camera, of all others by GDAL's warper with an RPC."""
from __future__ import annotations

import os
import uuid
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Callable

import numpy as np
from osgeo import gdal

from ...imagery import messages as imagery_messages
from ...imagery.errors import CancelledError, Message, RasterError, SettingsError
from ...imagery.file_identity import refuse_overwriting
from ...imagery.gdal_calls import drop_from_memory, gdal_silenced, gdal_writing
from ...imagery.gdal_paths import RASTERS, open_dataset, vrt_parts
from ...imagery.grids import Extent, Grid, extents_meet
from ...imagery.limits import COLOURS
from ...imagery.open_raster import OpenRaster
from ...imagery.raster_writer import GEOTIFF, WrittenBands, raster_writer, whole_raster
from ...imagery.rasters import Raster, RasterRef
from ...imagery.reference_systems import extent_on, horizontal_wkt, metres_per_unit, transform_points, utm_wkt
from . import limits, messages
from .frames import FrameCamera
from .heights import Datum, Terrain, load_terrain
from .photo_warp import PhotoWarp
from .points import check_heights
from .polynomials import Rational
from .rpc import CREATION, Domain, RpcOfModel, image_with_rpc, located, open_image, rpc_of
from .sensor_model import WGS84, Map, SensorModel, bounding_box, reprojected

ORTHO_GRID = 21  # places a side of the image that are looked for on the ground
TOLERATED_PX = 0.5  # how far an RPC may be from the model that it stands for without a warning
_NO_HEIGHT = -32768.0
COVER_GRID = 256  # places a side that terrain heights are looked for at
FINEST_MESH_M, COARSEST_MESH_M = 9.0, 32.0  # 10 to 30 m (Kurczynski and Wolniewicz, conclusion 7); SRTM has 31


def uncovered_share(image: OpenRaster, project: Map, terrain: Terrain, footprint: np.ndarray) -> float:
    """Share of the image's valid pixels without terrain heights. ``project`` takes (n, 3) longitude, latitude, height
    to (n, 2) column, row; ``footprint`` (n, 3) of the former."""
    sides = (np.linspace(footprint[:, axis].min(), footprint[:, axis].max(), COVER_GRID) for axis in (0, 1))
    places = np.stack(np.meshgrid(*sides), axis=-1).reshape(-1, 2)
    heights = terrain.at(places)
    missing = ~np.isfinite(heights)
    if not missing.any():
        return 0.0
    ground = np.column_stack([places, np.where(missing, footprint[:, 2].mean(), heights)])
    column, row = project(ground).T
    inside = (column >= 0) & (row >= 0) & (column < image.columns) & (row < image.rows)
    size = min(image.columns, COVER_GRID), min(image.rows, COVER_GRID)
    with gdal_silenced():
        held = image.dataset.GetRasterBand(1).GetMaskBand().ReadAsArray(buf_xsize=size[0], buf_ysize=size[1])
    if held is not None:
        down, across = (row / image.rows * size[1])[inside], (column / image.columns * size[0])[inside]
        inside[inside] = held[down.astype(int), across.astype(int)] != 0
    return float(np.count_nonzero(missing & inside) / max(np.count_nonzero(inside), 1))


@dataclass(frozen=True)
class OrthoRequest:
    """An image to rectify, and how."""

    image: RasterRef  # the image
    model: SensorModel  # in the image's own pixels
    wkt: str  # system of the points that the model was fitted to
    domain: Domain  # the part of image and ground that the model is used in
    dem: RasterRef | None  # terrain heights; None with a constant ``height``
    datum: Datum  # datum of the heights of ``dem``
    height: float | None  # constant height above the ellipsoid, m, instead of ``dem``
    output: Path  # the file that is written
    target_wkt: str = ""  # empty: the UTM zone of the image's centre
    pixel_size: float | None = None  # map units; None: the image's own, rounded
    extent: Extent | None = None  # in the target system; None: the whole image
    resampling: str = "cubic"  # ``nearest``, ``bilinear``, ``cubic``, ``cubicspline``, ``lanczos`` or ``average``
    format: str = "GTiff"  # ``GTiff`` or ``COG``


@dataclass(frozen=True)
class Ortho:
    path: Path  # its file
    wkt: str  # its reference system
    grid: Grid  # its pixels
    rms_px: float  # of the RPC that stands for the model, px of the image; 0 for an RPC itself, and a photo
    max_px: float  # the largest of the same
    uncovered: float  # share of the image without terrain heights
    notices: tuple[Message, ...]  # warnings and remarks for the user


def orthorectify(
    request: OrthoRequest,
    progress: Callable[[float], None] = lambda share: None,
    cancelled: Callable[[], bool] = lambda: False,
) -> Ortho:
    """Write the orthoimage, whole or not at all, and over no input. Raises RasterError, SensorModelError or
    SettingsError for what the user can mend, CancelledError when cancelled."""
    refs = [request.image, *([] if request.dem is None else [request.dem])]
    refuse_overwriting({"output": str(request.output)}, (path for ref in refs for path in ref.paths))
    if (request.dem is None) == (request.height is None):
        raise SettingsError(messages.TERRAIN_OR_HEIGHT())
    if request.height is not None:
        check_heights(request.height, request.height, "HEIGHT")
    image = open_image(request.image)
    terrain, footprint, rpc, uncovered = _ground(request, image)
    request, grid = _target(request, image, footprint)
    if grid.columns > 2**31 - 1 or grid.rows > 2**31 - 1 or grid.columns * grid.rows > 1e12:
        raise SettingsError(messages.ORTHO_TOO_LARGE(width=grid.columns, height=grid.rows))
    notices = [*terrain.notices]
    middle = np.add(terrain.origin, np.multiply(terrain.step, terrain.heights.shape[::-1]) / 2)
    finest, coarsest = sorted(np.abs(np.multiply(terrain.step, metres_per_unit(terrain.wkt, middle))).tolist())
    is_fine = finest < FINEST_MESH_M and rpc is not None  # aerial photos may need it
    if terrain.name and (coarsest > COARSEST_MESH_M or is_fine):  # a constant height has no name
        notices.append(messages.MESH_UNUSUAL(name=terrain.name, mesh=finest if is_fine else coarsest))
    if uncovered > 0:
        notices.append(messages.DEM_PARTLY_COVERING(name=terrain.name, share=uncovered))
    rms, most = (rpc.rms_px, rpc.max_px) if rpc is not None else (0.0, 0.0)
    if most > TOLERATED_PX:
        notices.append(messages.ORTHO_APPROXIMATE(most=most))
    heights = _heights(terrain)
    del terrain  # GDAL has it now
    try:
        if rpc is None:
            _warp_photo(request, heights, grid, progress, cancelled)
        else:
            _warp(request, image_with_rpc(image, rpc.rpc), heights, grid, progress, cancelled)
    finally:
        drop_from_memory(heights)
    return Ortho(request.output, request.target_wkt, grid, rms, most, uncovered, tuple(notices))


def rpc_domain(rpc: Rational, image: Raster) -> Domain:
    """The domain of an image's own RPC: the image, at the heights it was made for."""
    (x, y, height), half = rpc.ground.offset.tolist(), float(rpc.ground.scale[2])
    return Domain((0, image.columns), (0, image.rows), (height - half, height + half), (x, y))


def _ground(request: OrthoRequest, image: OpenRaster) -> tuple[Terrain, np.ndarray, RpcOfModel | None, float]:
    """The terrain; (n, 3) longitude, latitude, height of places all over the image; the RPC that GDAL sees it by, which
    no photo has; and the share of the image without heights."""
    domain = replace(request.domain, columns=(0.0, float(image.columns)), rows=(0.0, float(image.rows)))
    side = np.linspace(0, 1, ORTHO_GRID)
    places = np.stack(np.meshgrid(side * image.columns, side * image.rows), axis=-1).reshape(-1, 2)
    seen_by, wkt, used, rpc = request.model, request.wkt, domain, None
    if not isinstance(seen_by, FrameCamera):
        rpc = rpc_of(seen_by, wkt, domain)
        ((longitude, latitude),) = transform_points(np.array([domain.middle]), wkt, WGS84).tolist()
        seen_by, wkt, used = rpc.rpc, WGS84, replace(domain, middle=(longitude, latitude))

    def on_ground(heights: np.ndarray) -> np.ndarray:
        return located(seen_by, wkt, np.column_stack([places, heights]), used)

    if request.height is not None:
        domain = replace(domain, heights=(request.height, request.height))
    around = np.concatenate([on_ground(np.full(len(places), height)) for height in domain.heights])[:, :2]
    margin = 0.02 * np.ptp(around, axis=0) + 1e-4
    extent = bounding_box(np.concatenate([around - margin, around + margin]))
    if request.dem is not None:
        terrain = load_terrain(request.dem, extent, request.datum)
    else:
        (west, south, east, north), height = extent, domain.heights[0]
        step = (east - west) / 2, (south - north) / 2
        terrain = Terrain("", WGS84, (west, north), step, np.full((2, 2), height, np.float32), ())
    heights = np.full(len(places), float(np.nanmean(terrain.heights)))
    for _ in range(limits.MAX_NEWTON_ITERATIONS):
        ground = on_ground(heights)
        terrain_heights = terrain.at(ground)
        missing = ~np.isfinite(terrain_heights)
        change = np.abs(terrain_heights - heights)[~missing].max(initial=0)
        heights = np.where(missing, heights, terrain_heights)
        if change < 0.01:
            break
    if missing.all():
        west, south, east, north = extent
        raise RasterError(messages.DEM_NOT_COVERING(name=terrain.name, west=west, east=east, south=south, north=north))
    if rpc is not None and rpc.max_px > 0:  # a fitted RPC holds best where the terrain is
        rpc = rpc_of(request.model, request.wkt, replace(domain, heights=(float(heights.min()), float(heights.max()))))
    footprint = np.column_stack([ground[:, :2], heights])
    uncovered = uncovered_share(image, lambda at: seen_by.project(reprojected(at, WGS84, wkt)), terrain, footprint)
    return terrain, footprint, rpc, uncovered


def _target(request: OrthoRequest, image: OpenRaster, footprint: np.ndarray) -> tuple[OrthoRequest, Grid]:
    """The request with its system, and its pixels."""
    centre = footprint[len(footprint) // 2]
    wkt = request.target_wkt or utm_wkt(float(centre[0]), float(centre[1]))
    places = transform_points(footprint, WGS84, wkt)
    size = request.pixel_size
    if size is None:
        grid = places.reshape(ORTHO_GRID, ORTHO_GRID, 2)
        across, down = (np.median(np.linalg.norm(np.diff(grid, axis=axis), axis=2)) for axis in (1, 0))
        size = float(f"{min(across / image.columns, down / image.rows) * (ORTHO_GRID - 1):.2g}")
    if not 0 < size < np.inf:
        raise SettingsError(messages.PIXEL_SIZE_NOT_POSITIVE(size=size))
    bounds = request.extent or bounding_box(places)
    if request.extent and not extents_meet(bounds, extent_on(bounding_box(footprint), WGS84, wkt)):
        raise SettingsError(messages.EXTENT_OUTSIDE())  # nor meet those that are no numbers
    left, bottom = (float(np.floor(bounds[i] / size) * size) for i in (0, 1))
    right, top = (float(np.ceil(bounds[i] / size) * size) for i in (2, 3))
    columns, rows = max(round((right - left) / size), 1), max(round((top - bottom) / size), 1)
    return replace(request, target_wkt=wkt), Grid(left, top, size, size, columns, rows)


def _heights(terrain: Terrain) -> str:
    """The path of a file in memory with the terrain's heights, which GDAL's RPC transformer reads."""
    path = f"/vsimem/terrain-{uuid.uuid4().hex}.tif"
    rows, columns = terrain.heights.shape
    with gdal_silenced():
        file = gdal.GetDriverByName("GTiff").Create(path, columns, rows, 1, gdal.GDT_Float32, ["BIGTIFF=IF_SAFER"])
        file.SetGeoTransform((terrain.origin[0], terrain.step[0], 0.0, terrain.origin[1], 0.0, terrain.step[1]))
        file.SetProjection(horizontal_wkt(terrain.wkt))
        if not np.isfinite(terrain.heights).all():  # GDAL interpolates in half the time without
            file.GetRasterBand(1).SetNoDataValue(_NO_HEIGHT)
        np.nan_to_num(terrain.heights, copy=False, nan=_NO_HEIGHT)  # a copy costs as much memory as GDAL's own
        file.WriteArray(terrain.heights)
    return path


def _warp(
    request: OrthoRequest, source: gdal.Dataset, heights: str, grid: Grid, progress: Callable[[float], None],
    cancelled: Callable[[], bool],
) -> None:
    options = ["METHOD=RPC", f"RPC_DEM={heights}", "RPC_DEMINTERPOLATION=bilinear", "RPC_DEM_APPLY_VDATUM_SHIFT=NO"]
    nodata = source.GetRasterBand(1).GetNoDataValue()
    is_virtual = bool(vrt_parts(request.image.path))  # in another thread GDAL would print which of its files lacks

    def report(share: float, message: str, data: Any) -> int:
        progress(share)
        return 0 if cancelled() else 1

    with whole_raster(str(request.output)) as unfinished, gdal_silenced():
        gdal.ErrorReset()
        try:
            made = gdal.Warp(
                unfinished, source, format=request.format, dstSRS=request.target_wkt, outputBounds=grid.extent,
                width=grid.columns, height=grid.rows, resampleAlg=request.resampling, rpc=True,
                transformerOptions=options, errorThreshold=0, multithread=not is_virtual,
                warpOptions=["NUM_THREADS=ALL_CPUS", "UNIFIED_SRC_NODATA=YES"],
                dstNodata=0 if nodata is None else nodata, creationOptions=CREATION[request.format], callback=report,
            )
            error = gdal.GetLastErrorMsg() if made is None else ""
        except RuntimeError as raised:
            made, error = None, str(raised)
        if cancelled():
            made = None
            raise CancelledError(imagery_messages.CANCELLED())
        if made is None:
            unread = imagery_messages.NOT_READABLE(name=request.image.name)
            raise RasterError(messages.WARP_FAILED(error=error) if error else unread)
        with gdal_writing(imagery_messages.RASTER_NOT_WRITTEN(path=request.output)):
            made = None  # closing writes the file


def _warp_photo(
    request: OrthoRequest, heights: str, grid: Grid, progress: Callable[[float], None],
    cancelled: Callable[[], bool],
) -> None:
    image = open_image(request.image)
    nodata = 0.0 if image.nodata is None else image.nodata
    transform = (grid.left, grid.pixel_width, 0.0, grid.top, 0.0, -grid.pixel_height)
    wkt = horizontal_wkt(request.target_wkt)
    made = replace(image.raster, columns=grid.columns, rows=grid.rows, geotransform=transform, own_wkt=wkt)
    names, kind = made.band_names, np.dtype(made.data_type)
    assert isinstance(request.model, FrameCamera)
    bands = WrittenBands(len(names), kind, names == COLOURS, nodata)
    photo = PhotoWarp(image, request.model, request.wkt, open_dataset(heights, RASTERS), grid, request.target_wkt)

    def write(path: str) -> None:
        with raster_writer(path, made, bands) as file:
            for row, strip in photo.strips(request.resampling, nodata, cancelled):
                file.write(row, strip)
                progress((row + strip.shape[1]) / grid.rows)
            if cancelled():
                raise CancelledError(imagery_messages.CANCELLED())

    if request.format == GEOTIFF:
        write(str(request.output))
        return
    with whole_raster(str(request.output)) as unfinished, gdal_silenced():
        plain = f"{unfinished}.tif"
        write(plain)
        with gdal_writing(imagery_messages.RASTER_NOT_WRITTEN(path=request.output)):
            gdal.Translate(unfinished, plain, format=request.format, creationOptions=CREATION[request.format])
        os.remove(plain)
