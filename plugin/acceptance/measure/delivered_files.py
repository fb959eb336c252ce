"""The files of a delivery against what was ordered: is each sheet there, whole, and of the form that was asked for."""
from __future__ import annotations

import fnmatch
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Callable

import numpy as np
from osgeo import gdal, ogr

from ...imagery.errors import Message, RasterError
from ...imagery.gdal_calls import gdal_writing
from ...imagery.limits import MAX_PIXEL_SIZE_DIFFERENCE
from ...imagery.lines import burnt
from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import Raster, RasterRef
from ...imagery.reference_systems import geometry_on, same_system, system_name
from . import messages
from .delivery import SheetState
from .overlapping_sheets import AT_ONCE, overlapping_otherwise

_LEAST_MISSING = 1e-9  # of an outline: less is rounding
_READ = 0.9  # of the time: the rest is to compare sheets where they overlap
_MOSTLY = 0.5  # of an outline
_EDGE_PX = 1.0  # a sheet that ends so near to its outline covers it: outlines are drawn on the ground, not on pixels

_OPEN = ("pixel_m", "wkt", "bands", "data_type")  # of a form: as most files have it where nothing is asked for


@dataclass(frozen=True)
class OrderedForm:
    """What every file has to be; None and empty: as most of them are."""

    pixel_m: float | None = None
    wkt: str = ""
    bands: int | None = None
    data_type: str = ""  # numpy's name, such as uint8
    pattern: str = ""  # pattern of the file's name, with * and ?; empty: any
    most_missing: float = 0.0  # share of an outline that may have no data, 0 to 1


@dataclass(frozen=True)
class OrderedSheet:
    """A sheet of the order, or a file that nobody ordered."""

    name: str
    path: str  # path of its file; empty where there is none
    outline: bytes | None  # WKB of what it has to cover; None: all that its file covers
    wkt: str = ""  # reference system of the outline
    is_ordered: bool = True


@dataclass(frozen=True)
class CheckedSheet:
    sheet: OrderedSheet
    raster: Raster | None  # None where there is no file that can be read
    missing: float | None  # share of the outline without data, 0 to 1; None where that can't be told
    findings: tuple[Message, ...]  # all that is not as it was ordered
    state: SheetState = SheetState.SHOWN  # what it is to the mosaic of all sheets


def checked_sheets(
    sheets: Sequence[OrderedSheet], form: OrderedForm, tell: Callable[[float], object]
) -> list[CheckedSheet]:
    """In the order given. ``tell``: is told the share that is done; what it raises ends the check.

    All pixels of every file are read once, as whoever measures it needs them; a file that has hardly any is not read.
    """
    opened = [_opened(sheet) for sheet in sheets]
    ordered = [raster for (raster, _), sheet in zip(opened, sheets) if raster is not None and sheet.is_ordered]
    form = _as_most(ordered or [raster for raster, _ in opened if raster is not None], form)
    checked: list[CheckedSheet] = []
    for done, (sheet, (raster, trouble)) in enumerate(zip(sheets, opened)):
        part = partial(_part_done, tell, _READ * done / len(sheets), _READ / len(sheets))
        part(0.0)
        checked.append(_checked(sheet, raster, trouble, form, part))
    return with_states(checked, partial(_part_done, tell, _READ, 1 - _READ))


def _part_done(tell: Callable[[float], object], before: float, part: float, share: float) -> None:
    tell(before + part * share)


def fitting(sheets: Sequence[CheckedSheet]) -> list[CheckedSheet]:
    """The sheets that one mosaic can be made of: the ordered ones of most sheets' system, pixels, bands and type."""
    groups: list[list[tuple[Raster, CheckedSheet]]] = []
    for sheet in sheets:
        if (raster := sheet.raster) is not None and raster.is_north_up and sheet.sheet.is_ordered:
            alike = next((group for group in groups if _is_like(raster, group[0][0])), None)
            if alike is None:
                groups.append(alike := [])
            alike.append((raster, sheet))
    return [sheet for _, sheet in max(groups, key=len, default=[])]


def with_states(sheets: Sequence[CheckedSheet], tell: Callable[[float], None]) -> list[CheckedSheet]:
    """The sheets with what they are to the mosaic of all of them; those that hide each other with other pixels say so.

    ``tell``: is told the share that is done; what it raises ends the look.
    """
    shown = fitting(sheets)
    others = overlapping_otherwise([sheet.raster for sheet in shown if sheet.raster is not None], tell)
    names = {id(sheet): [shown[other].sheet.name for other in others[number]] for number, sheet in enumerate(shown)}
    checked = []
    for sheet in sheets:
        if not sheet.sheet.is_ordered:
            sheet = replace(sheet, state=SheetState.NOT_ORDERED)
        elif id(sheet) not in names:
            findings = sheet.findings or (messages.NOT_IN_MOSAIC(),)
            sheet = replace(sheet, findings=findings, state=SheetState.LEFT_OUT)
        elif hidden := names[id(sheet)]:
            finding = messages.SHOWS_OTHERWISE(names=", ".join(hidden))
            sheet = replace(sheet, findings=(*sheet.findings, finding), state=SheetState.OVERLAPS)
        checked.append(sheet)
    return checked


def build_mosaic(path: str, sheets: Sequence[CheckedSheet]) -> None:
    """A VRT over the files of ``fitting`` sheets. Raises RasterError when it can't be written."""
    with gdal_writing(messages.MOSAIC_NOT_WRITTEN(path=path)):
        made = gdal.BuildVRT(path, [sheet.sheet.path for sheet in sheets], allowProjectionDifference=True)
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
    forms = [
        OrderedForm(round(raster.ground_sample_distance, 6), raster.wkt, len(raster.band_names), raster.data_type)
        for raster in rasters
    ]
    most = {name: Counter(getattr(each, name) for each in forms).most_common(1)[0][0] for name in _OPEN}
    return replace(form, **{name: getattr(form, name) or value for name, value in most.items()})


def _findings(
    sheet: OrderedSheet, raster: Raster | None, form: OrderedForm, missing: float | None, state: SheetState
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
        yield messages.SYSTEM_OTHER(system=system_name(raster.wkt), wanted=system_name(form.wkt))
    if form.bands and bands != form.bands:
        yield messages.BANDS_OTHER(bands=bands, wanted=form.bands)
    if form.data_type and raster.data_type != form.data_type:
        yield messages.TYPE_OTHER(kind=raster.data_type, wanted=form.data_type)
    if missing is None:
        yield from () if state is SheetState.DAMAGED else (messages.MISSING_UNKNOWN(),)
    elif missing > form.most_missing + _LEAST_MISSING:
        yield messages.DATA_MISSING(share=missing)


def _checked(
    sheet: OrderedSheet, raster: Raster | None, trouble: tuple[Message, ...], form: OrderedForm,
    tell: Callable[[float], None],
) -> CheckedSheet:
    missing, state = None, SheetState.SHOWN
    if raster is not None:
        try:
            missing = _missing(sheet, raster, tell)
        except RasterError as error:
            trouble, state = (*trouble, error.message), SheetState.DAMAGED
    return CheckedSheet(sheet, raster, missing, (*trouble, *_findings(sheet, raster, form, missing, state)), state)


def _missing(sheet: OrderedSheet, raster: Raster, tell: Callable[[float], None]) -> float | None:
    """The share of a sheet's outline where its file has no data, or none of its pixels; None where it can't be told.
    Raises RasterError where pixels can't be read."""
    opened, pixels = OpenRaster(raster.ref), raster.columns * raster.rows
    if sheet.outline is None:
        return _invalid_pixels(opened, None, pixels, tell) / pixels
    try:
        outline = _placed_outline(sheet, raster)
        pixel_area = abs(raster.grid.pixel_width) * abs(raster.grid.pixel_height)
        area_px = outline.Area() / pixel_area
        near, exact = (_area_beyond(outline, _reach(raster, by)) for by in (_EDGE_PX, 0.0))
    except (RasterError, RuntimeError):
        _invalid_pixels(opened, None, pixels, tell)
        return None
    beyond = exact / pixel_area if near else 0.0
    invalid = _invalid_pixels(opened, outline, area_px - exact / pixel_area, tell)
    return (beyond + invalid) / area_px if area_px else None


def _placed_outline(sheet: OrderedSheet, raster: Raster) -> ogr.Geometry:
    """The outline in the raster's reference system. Raises RuntimeError for rings that QGIS keeps and GDAL has none
    of."""
    outline = ogr.CreateGeometryFromWkb(sheet.outline)
    if outline is None:
        raise RuntimeError(gdal.GetLastErrorMsg())
    return geometry_on(outline, sheet.wkt, raster.wkt) if sheet.wkt else outline


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


def _invalid_pixels(
    opened: OpenRaster, outline: ogr.Geometry | None, inside: float, tell: Callable[[float], None]
) -> float:
    """Pixels without data whose middles lie within an outline, of ``inside`` pixels; None: all of them.

    What the file has no blocks for is no data and not read. Where that is most of what lies inside it is all that is
    counted. Raises RasterError where pixels can't be read.
    """
    raster = opened.raster
    whole = raster.whole
    surely = (1 - opened.stored_share(whole)) * whole.width * whole.height - (whole.width * whole.height - inside)
    if surely > _MOSTLY * inside:
        return surely
    count = 0
    for window in opened.blocks(whole, AT_ONCE if opened.stored_share(whole) == 1 else 1):  # each is there or not
        tell((window.row * whole.width + window.column) / (whole.width * whole.height))
        is_stored = opened.stored_share(window) > 0
        invalid = opened.read(window).invalid if is_stored else np.ones((window.height, window.width), bool)
        if invalid is not None and invalid.any():
            within = True if outline is None else burnt([(outline, 1)], raster.grid, window, 0) == 1
            count += int(np.count_nonzero(invalid & within))
    return count


def _is_like(raster: Raster, other: Raster) -> bool:
    pixel, other_pixel = raster.ground_sample_distance, other.ground_sample_distance
    return (
        same_system(raster.wkt, other.wkt) and raster.band_names == other.band_names
        and raster.data_type == other.data_type and abs(pixel / other_pixel - 1) <= MAX_PIXEL_SIZE_DIFFERENCE
    )
