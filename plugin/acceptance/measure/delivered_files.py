"""The files of a delivery against what was ordered: is each sheet there, whole, and of the form that was asked for."""
from __future__ import annotations

import fnmatch
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Callable, TypeVar

import numpy as np
from osgeo import gdal, ogr

from ...imagery.errors import Message, RasterError
from ...imagery.gdal_calls import gdal_writing
from ...imagery.grids import PixelWindow
from ...imagery.limits import MAX_PIXEL_SIZE_DIFFERENCE
from ...imagery.lines import burnt
from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import Raster, RasterRef
from ...imagery.reference_systems import geometry_on, same_system
from . import messages

_AT_ONCE = 1 << 22  # pixels
_LEAST_MISSING = 1e-9  # of an outline: less is rounding
_EDGE_PX = 1.0  # a sheet that ends so near to its outline covers it: outlines are drawn on the ground, not on pixels

Value = TypeVar("Value", str, float, int)


@dataclass(frozen=True)
class OrderedForm:
    """What every file has to be; None and empty: as most of them are."""

    pixel_m: float | None = None
    wkt: str = ""
    bands: int | None = None
    data_type: str = ""
    """numpy's name, such as ``uint8``."""
    pattern: str = ""
    """Of the file's name, with ``*`` and ``?``; empty: any."""
    most_missing: float = 0.0
    """Share of an outline that may have no data, 0 to 1."""


@dataclass(frozen=True)
class OrderedSheet:
    """A sheet of the order, or a file that nobody ordered."""

    name: str
    path: str
    """Of its file; empty where there is none."""
    outline: bytes | None
    """WKB of what it has to cover; None: all that its file covers."""
    wkt: str = ""
    """Reference system of the outline."""
    is_ordered: bool = True


@dataclass(frozen=True)
class CheckedSheet:
    """What was found at a sheet."""

    sheet: OrderedSheet
    raster: Raster | None
    """None where there is no file that can be read."""
    missing: float | None
    """Share of the outline without data, 0 to 1; None where that can't be told."""
    findings: tuple[Message, ...]
    """All that is not as it was ordered."""


def checked_sheets(
    sheets: Sequence[OrderedSheet], form: OrderedForm, goes_on: Callable[[float], bool]
) -> list[CheckedSheet] | None:
    """In the order given; None when it is not wanted any more. ``goes_on``: told the share that is done."""
    opened = [_opened(sheet) for sheet in sheets]
    form = _as_most([raster for raster, _ in opened if raster is not None], form)
    found = []
    for done, (sheet, (raster, trouble)) in enumerate(zip(sheets, opened)):
        if not goes_on(done / len(sheets)):
            return None
        missing = None if raster is None else _missing(sheet, raster)
        findings = (*trouble, *_findings(sheet, raster, form, missing))
        found.append(CheckedSheet(sheet, raster, missing, findings))
    return found


def fitting(sheets: Sequence[CheckedSheet]) -> list[CheckedSheet]:
    """Those that one mosaic can be made of: of the first one's system, pixels, bands and type."""
    found: list[CheckedSheet] = []
    for one in sheets:
        if one.raster is not None and one.raster.is_north_up and (not found or _is_like(one.raster, found[0].raster)):
            found.append(one)
    return found


def build_mosaic(path: str, sheets: Sequence[CheckedSheet]) -> None:
    """A VRT over the files of ``fitting`` sheets. Raises RasterError when it can't be written."""
    with gdal_writing(messages.MOSAIC_NOT_WRITTEN(path=path)):
        made = gdal.BuildVRT(path, [one.sheet.path for one in sheets])
        made.FlushCache()


def _opened(sheet: OrderedSheet) -> tuple[Raster | None, tuple[Message, ...]]:
    if not sheet.path:
        return None, (messages.FILE_MISSING(),)
    try:
        raster = OpenRaster(RasterRef(sheet.path)).raster
    except RasterError as error:
        return None, (error.message,)
    return (raster, ()) if raster.has_place else (None, (messages.FILE_WITHOUT_PLACE(),))


def _as_most(rasters: Sequence[Raster], form: OrderedForm) -> OrderedForm:
    """The form with what it leaves open filled in by what most files have."""
    if not rasters:
        return form
    most_wkt = _most([one.wkt for one in rasters])
    return OrderedForm(
        form.pixel_m or _most([round(one.ground_sample_distance, 6) for one in rasters]),
        form.wkt or most_wkt,
        form.bands or _most([len(one.band_names) for one in rasters]),
        form.data_type or _most([one.data_type for one in rasters]),
        form.pattern, form.most_missing,
    )  # fmt: skip


def _most(values: Sequence[Value]) -> Value:
    return Counter(values).most_common(1)[0][0]


def _findings(
    sheet: OrderedSheet, raster: Raster | None, form: OrderedForm, missing: float | None
) -> Iterator[Message]:
    if not sheet.is_ordered:
        yield messages.FILE_NOT_ORDERED()
    if raster is None:
        return
    if form.pattern and not fnmatch.fnmatchcase(raster.ref.name, form.pattern):
        yield messages.NAME_OTHER(name=raster.ref.name, pattern=form.pattern)
    pixel, bands = raster.ground_sample_distance, len(raster.band_names)
    if form.pixel_m and abs(pixel / form.pixel_m - 1) > MAX_PIXEL_SIZE_DIFFERENCE:
        yield messages.PIXEL_OTHER(pixel=pixel, wanted=form.pixel_m)
    if form.wkt and not same_system(raster.wkt, form.wkt):
        yield messages.SYSTEM_OTHER()
    if form.bands and bands != form.bands:
        yield messages.BANDS_OTHER(bands=bands, wanted=form.bands)
    if form.data_type and raster.data_type != form.data_type:
        yield messages.TYPE_OTHER(kind=raster.data_type, wanted=form.data_type)
    if missing is None:
        yield messages.MISSING_UNKNOWN()
    elif missing > form.most_missing + _LEAST_MISSING:
        yield messages.DATA_MISSING(share=missing)


def _missing(sheet: OrderedSheet, raster: Raster) -> float | None:
    """The share of a sheet's outline where its file has no data, or none of its pixels; None where it can't be told."""
    try:
        opened = OpenRaster(raster.ref)
        if sheet.outline is None:
            invalid, pixels = _invalid_pixels(opened, raster, None), raster.columns * raster.rows
            return invalid / pixels
        outline = ogr.CreateGeometryFromWkb(sheet.outline)
        if outline is None:  # QGIS keeps rings that GDAL has none of
            return None
        if sheet.wkt and not same_system(sheet.wkt, raster.wkt):
            outline = geometry_on(outline, sheet.wkt, raster.wkt)
        grid = raster.grid
        area_px = outline.Area() / (abs(grid.pixel_width) * abs(grid.pixel_height))
        near, exact = (_area_beyond(outline, _reach(raster, by)) for by in (_EDGE_PX, 0.0))
        beyond = exact / (abs(grid.pixel_width) * abs(grid.pixel_height)) if near else 0.0
        return (beyond + _invalid_pixels(opened, raster, outline)) / area_px if area_px else None
    except (RasterError, RuntimeError):
        return None


def _area_beyond(outline: ogr.Geometry, reach: ogr.Geometry) -> float:
    """Raises RuntimeError for an outline that crosses itself, as GDAL does where its exceptions are on."""
    beyond = outline.Difference(reach)
    if beyond is None:
        raise RuntimeError(gdal.GetLastErrorMsg())
    return float(beyond.Area())


def _reach(raster: Raster, more_px: float) -> ogr.Geometry:
    """What a raster covers, and so many pixels more on each side."""
    xmin, ymin, xmax, ymax = raster.extent
    x, y = more_px * abs(raster.grid.pixel_width), more_px * abs(raster.grid.pixel_height)
    return ogr.CreateGeometryFromWkt(
        f"POLYGON(({xmin - x} {ymin - y},{xmax + x} {ymin - y},{xmax + x} {ymax + y},{xmin - x} {ymax + y},"
        f"{xmin - x} {ymin - y}))"
    )


def _invalid_pixels(opened: OpenRaster, raster: Raster, outline: ogr.Geometry | None) -> int:
    """Pixels without data whose middles lie within an outline; None: all of them. Nothing is read where the file says
    nothing of such pixels."""
    if opened.is_all_valid:
        return 0
    count = 0
    for window in opened.blocks(PixelWindow(0, 0, raster.columns, raster.rows), _AT_ONCE):
        invalid = ~opened.read(window).valid
        if outline is not None and invalid.any():
            invalid &= burnt([(outline, 1)], raster.grid, window, 0) == 1
        count += int(np.count_nonzero(invalid))
    return count


def _is_like(raster: Raster, other: Raster | None) -> bool:
    return other is not None and (
        same_system(raster.wkt, other.wkt) and raster.band_names == other.band_names
        and raster.data_type == other.data_type
        and abs(raster.ground_sample_distance / other.ground_sample_distance - 1) <= MAX_PIXEL_SIZE_DIFFERENCE
    )  # fmt: skip
