"""Measurements of arrays in memory: numpy's, (rows, columns[, bands]), or xarray's with the dimensions y and x."""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from typing import TYPE_CHECKING, Union
from uuid import uuid4

import numpy as np
from osgeo import gdal, gdal_array, ogr

from ..plugin.imagery import limits as imagery_limits
from ..plugin.imagery import wavelets
from ..plugin.imagery.errors import SettingsError
from ..plugin.imagery.gdal_calls import gdal_settings, gdal_silenced
from ..plugin.imagery.limits import COLOURS
from ..plugin.imagery.open_raster import describe_mosaic
from ..plugin.imagery.raster_pool import close_rasters
from ..plugin.imagery.rasters import Raster, RasterRef
from ..plugin.imagery.wavelets import Curve, check_decomposition
from ..plugin.noise.measure import band_noise
from ..plugin.noise.measure.band_noise import BandNoise
from ..plugin.seams.measure.profile.seam_profile import SeamProfile
from ..plugin.seams.measure.seam_cells import Cell
from ..plugin.seams.measure.window.inspection import Block, inspect_window, usable_block
from ..plugin.seams.measure.window.measured_window import InspectionSettings
from ..plugin.seams.measure.window.window_result import WindowResult
from . import messages

if TYPE_CHECKING:
    from xarray import DataArray

Image = Union[np.ndarray, "DataArray"]
Images = Union[Sequence[Image], Mapping[str, Image]]

_METRES = 'LOCAL_CS["array",UNIT["metre",1]]'
_HELD_AS = {"float16": "float32", "int8": "int16", "int64": "float64", "uint64": "float64"}  # what GDAL 3.6 lacks
_SAME_PLACE_PX = 0.1
_MOST_BANDS_FIRST = 16  # of an array whose first side is its shortest: more are rows


def seam_profile(
    mosaic: Image, sources: Images, pixel_size_m: float, labels: Image | None = None,
    settings: InspectionSettings | None = None,
) -> SeamProfile | None:
    """What a mosaic kept of its sources along its seams, all of them arrays on one pixel grid.

    The ``profile`` of ``inspect_arrays``, whose ``judgement.reason`` says why where it is None, as without a seam.
    """
    return _inspected(mosaic, sources, pixel_size_m, labels, settings).profile


def inspect_arrays(
    mosaic: Image, sources: Images, pixel_size_m: float, labels: Image | None = None,
    settings: InspectionSettings | None = None,
) -> WindowResult:
    """Inspect arrays as ``inspect_window`` does a window of files.

    Sides are trimmed to a multiple of ``2 ** levels``, at least 64 px. NaN and masked pixels are no measurements: a
    source takes part where it has others, a mosaic with more than 0.1 % of them is ``not_comparable``. Detail weaker
    than a ten-thousandth of the mean value is rounding, and not measured: take off an offset as large.

    Parameters
    ----------
    mosaic : array
        (rows, columns) or (rows, columns, bands); three bands or more begin with red, green and blue.
    sources : sequence or mapping of arrays
        The images that it may have been made from, on the mosaic's rows and columns; a mapping has their names. The
        mosaic itself and copies of it, which would explain all, are left out, and told by a SeamInspectorWarning each.
    pixel_size_m : float
        Metres on the ground that a pixel spans.
    labels : array, optional
        (rows, columns) of whole numbers: the place in ``sources``, from 0 and in the order of a mapping, of the one
        that each pixel was taken from; -1 or masked where unknown.
    settings : InspectionSettings, optional
        The standard ones where None.

    Raises SettingsError for arrays that are no images, of different sides, or whose coordinates x and y are others, and
    when no source can be used.
    """
    return _inspected(mosaic, sources, pixel_size_m, labels, settings)


def _inspected(
    mosaic: Image, sources: Images, pixel_size_m: float, labels: Image | None, settings: InspectionSettings | None
) -> WindowResult:
    imagery_limits.check_type("pixel_size_m", pixel_size_m, float)
    imagery_limits.check_type("sources", sources, Iterable)
    if pixel_size_m <= 0:
        raise SettingsError(messages.NO_PIXEL_SIZE(value=pixel_size_m))
    named = dict(sources) if isinstance(sources, Mapping) else {f"source_{i}": image for i, image in enumerate(sources)}
    if not named:
        raise SettingsError(messages.NO_SOURCES())
    for name, image in (*named.items(), ("labels", labels)):
        _check_places(name, image, mosaic)
    with ExitStack() as held:
        held.callback(close_rasters)
        ref = held.enter_context(_raster_of(mosaic, "mosaic", pixel_size_m))
        raster = describe_mosaic(ref)
        refs = [
            ref if source is mosaic else held.enter_context(_raster_of(source, name, pixel_size_m, raster))
            for name, source in named.items()
        ]
        cells = () if labels is None else tuple(_cells(_known(labels), [ref.path for ref in refs], raster))
        block = usable_block(Block(raster, (), cells), refs, calls=3)
        return inspect_window(block.window(raster.extent, settings))


def clip_curves(
    image: Image, wavelet: str = imagery_limits.DEFAULT_WAVELET, levels: int = imagery_limits.DEFAULT_LEVELS
) -> dict[str, Curve]:
    """Shares of an image's variance by level, band by band: the curve of Pyka (2010), as ``pywt.wavedec2`` has it.

    ``image``: (rows, columns) or (rows, columns, bands), finite, both sides multiples of ``2 ** levels``. Three bands
    or more begin with red, green and blue, and have a ``luminance``. Raises SettingsError for anything else.
    """
    check_decomposition(wavelet, levels)
    bands = _whole(image, levels)
    names = _band_names(len(bands))
    weights = imagery_limits.LUMINANCE_WEIGHTS if len(bands) >= len(COLOURS) else ()
    curves, _ = wavelets.clip_curves(bands, wavelet, levels, weights)
    return dict(zip([*names, imagery_limits.LUMINANCE], curves))


def measure_noise(
    image: Image, names: Sequence[str] = (), wavelet: str = imagery_limits.DEFAULT_WAVELET,
    levels: int = imagery_limits.DEFAULT_LEVELS,
) -> dict[str, BandNoise]:
    """Random noise of an image, band by band, the luminance first where there is one.

    ``image``: as for ``clip_curves``. ``names``: of the bands; without them three or more begin with red, green and
    blue. Raises SettingsError for what is no image, and for names that are too many, too few or twice there.
    """
    check_decomposition(wavelet, levels)
    imagery_limits.check_type("names", names, Iterable)
    bands = _whole(image, levels)
    names = list(names) or _band_names(len(bands))
    if len(names) != len(bands):
        raise SettingsError(messages.NAMES_COUNT(given=len(names), count=len(bands)))
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        raise SettingsError(messages.NAMES_TWICE(name=twice))
    return band_noise.measure_noise(bands, names, wavelet, levels)


def _in_order(image: Image, name: str) -> Image:
    """An array with its rows first, a DataArray by its dimensions. Raises SettingsError where these are others."""
    dimensions = getattr(image, "dims", None)
    if dimensions is None:
        return image
    if not {"y", "x"} <= set(dimensions):
        raise SettingsError(messages.OTHER_DIMENSIONS(name=name, dimensions=", ".join(map(str, dimensions))))
    return image.transpose("y", "x", ...).values


def _known(labels: np.ndarray | DataArray) -> np.ndarray:
    """Labels (rows, columns) with -1 where they are masked."""
    turned = np.ma.asanyarray(_in_order(labels, "labels"))
    turned = turned[..., 0] if turned.shape[2:] == (1,) else turned
    return np.asarray(np.ma.filled(turned, -1) if np.ma.isMaskedArray(turned) else turned)


def _bands(image: Image, name: str) -> tuple[np.ndarray, np.ndarray | None]:
    """(bands, rows, columns), and (rows, columns) bool where any of them is masked."""
    nodata = getattr(image, "attrs", {}).get("_FillValue")
    image = _in_order(image, name)
    if nodata is not None:
        masked = np.ma.masked_values if image.dtype.kind == "f" else np.ma.masked_equal
        image = masked(image, nodata)
    pixels = np.ma.getdata(np.ma.asanyarray(image))
    if pixels.dtype.kind not in "iuf" or pixels.ndim not in (2, 3) or not pixels.size:
        raise SettingsError(messages.NO_IMAGE(name=name, kind=str(pixels.dtype), shape=str(pixels.shape)))
    if pixels.ndim == 3 and pixels.shape[0] <= _MOST_BANDS_FIRST and pixels.shape[0] < min(pixels.shape[1:]):
        raise SettingsError(messages.BANDS_FIRST(name=name, shape=str(pixels.shape)))
    mask = np.ma.getmask(image)
    bands = np.moveaxis(pixels.reshape(*pixels.shape[:2], -1), -1, 0)
    kind = _HELD_AS.get(bands.dtype.name, bands.dtype.name)
    invalid = None if mask is np.ma.nomask else mask.reshape(*pixels.shape[:2], -1).any(axis=-1)
    return np.ascontiguousarray(bands, kind), invalid


def _whole(image: Image, levels: int) -> np.ndarray:
    """The bands of an image all of whose pixels can be decomposed."""
    bands, invalid = _bands(image, "image")
    rows, columns = bands.shape[1:]
    if rows % 2**levels or columns % 2**levels:
        raise SettingsError(messages.NOT_MULTIPLE(columns=columns, rows=rows, step=2**levels, levels=levels))
    if (invalid is not None and invalid.any()) or not np.isfinite(bands).all():
        raise SettingsError(messages.NOT_FINITE())
    return bands


def _band_names(count: int) -> list[str]:
    names = [*COLOURS, "nir"][:count] if count >= len(COLOURS) else []
    return [*names, *(f"band_{number}" for number in range(len(names) + 1, count + 1))]


@contextmanager
def _raster_of(image: Image, name: str, pixel_size_m: float, mosaic: Raster | None = None) -> Iterator[RasterRef]:
    """An image as a file in memory, which has to go before it does, with the sides of a mosaic."""
    bands, invalid = _bands(image, name)
    count, rows, columns = bands.shape
    if mosaic is not None:
        _check_sides(name, (rows, columns), mosaic)
    path = f"/vsimem/{uuid4().hex}/{name}"
    kind = gdal_array.NumericTypeCodeToGDALTypeCode(bands.dtype.type)
    try:
        with gdal_silenced(), gdal_settings(GDAL_TIFF_INTERNAL_MASK="YES"):
            made = gdal.GetDriverByName("GTiff").Create(path, columns, rows, count, kind)
            made.SetGeoTransform((0.0, pixel_size_m, 0.0, rows * pixel_size_m, 0.0, -pixel_size_m))
            made.WriteArray(bands)
            if invalid is not None:
                made.CreateMaskBand(gdal.GMF_PER_DATASET)
                made.GetRasterBand(1).GetMaskBand().WriteArray(np.where(invalid, 0, 255).astype(np.uint8))
            made = None
        yield RasterRef(path, _METRES)
    finally:
        gdal.Unlink(path)


def _check_sides(name: str, shape: tuple[int, ...], mosaic: Raster) -> None:
    if shape != (mosaic.rows, mosaic.columns):
        raise SettingsError(messages.OTHER_SHAPE(name=name, shape=str(shape), rows=mosaic.rows, columns=mosaic.columns))


def _check_places(name: str, image: Image, mosaic: Image) -> None:
    """Raise SettingsError where a DataArray lies elsewhere than the mosaic, by a tenth of a pixel or more."""
    for side in ("y", "x"):
        there, here = (
            np.asarray(getattr(array, "coords", {}).get(side, ())).astype(float) for array in (image, mosaic)
        )
        if len(there) == len(here) > 1 and np.abs(there - here).max() > _SAME_PLACE_PX * abs(here[1] - here[0]):
            raise SettingsError(messages.OTHER_COORDINATES(name=name, side=side))


def _cells(labels: np.ndarray, paths: Sequence[str], mosaic: Raster) -> Iterator[Cell]:
    """The polygons of the labels, each with the path of its source."""
    _check_sides("labels", labels.shape, mosaic)
    if labels.dtype.kind not in "biuf" or (labels != np.rint(labels)).any():  # NaN is unlike itself
        raise SettingsError(messages.LABELS_NOT_WHOLE(kind=str(labels.dtype)))
    other = labels[(labels < -1) | (labels >= len(paths))]
    if other.size:
        raise SettingsError(messages.LABELS_OF_OTHERS(number=other[0], count=len(paths), most=len(paths) - 1))
    raster = gdal_array.OpenArray(np.ascontiguousarray(labels, np.int32))
    raster.SetGeoTransform(mosaic.placement)
    features = (gdal.GetDriverByName("Memory") or gdal.GetDriverByName("MEM")).Create("", 0, 0, 0, gdal.GDT_Unknown)
    layer = features.CreateLayer("cells", geom_type=ogr.wkbPolygon)
    layer.CreateField(ogr.FieldDefn("number", ogr.OFTInteger))
    gdal.Polygonize(raster.GetRasterBand(1), None, layer, 0)
    for feature in layer:
        outline, number = feature.GetGeometryRef(), feature["number"]
        if number >= 0:
            xmin, xmax, ymin, ymax = outline.GetEnvelope()
            yield Cell(paths[number], bytes(outline.ExportToWkb(ogr.wkbNDR)), (xmin, ymin, xmax, ymax))
