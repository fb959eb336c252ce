"""A mosaic with its sources, and windows of it: request -> result, one by one or many on any executor."""
from __future__ import annotations

import os
import warnings
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from numbers import Real
from typing import Any, Callable, Union

from ....imagery import limits as imagery_limits
from ....imagery.errors import Message, SeamInspectorWarning, SettingsError, WindowError
from ....imagery.grids import Extent, PixelWindow, extents_meet, snap_window, standard_side_px, standard_window
from ....imagery.open_raster import OpenRaster, describe_mosaic, placed
from ....imagery.raster_pool import own_threads
from ....imagery.rasters import Raster, RasterRef
from ....imagery.reference_systems import known_wkt
from .. import messages
from ..inputs.mosaic_copies import leave_out_copies
from ..seam_cells import Cell, source_stem
from ..seamlines.seam_features import read_cells
from ..source_images import Source, gather_sources, have_same_grid
from ..workers import Workers, in_order, measuring, unforeseen
from . import measured_window
from .explained_window import explain_window
from .measured_window import InspectionSettings, MeasuredWindow, MeasureWindow, WindowRequest
from .window_result import WindowClips, WindowResult

NEIGHBOURS_PX = 2048
"""How far a sheet's neighbours are looked at: a block of a scan."""
PathLike = Union[str, "os.PathLike[str]"]
"""A file, or whatever else GDAL opens, as ``/vsicurl/https://...``."""


@dataclass(frozen=True)
class Block:
    """A mosaic and the orthoimages it may have been made from; no block of a scan, which is a square of pixels."""

    mosaic: Raster
    """North-up, on the map."""
    sources: tuple[Source, ...]
    """Each once, with its footprint in the mosaic's reference system."""
    cells: tuple[Cell, ...] = ()
    """The source that each part of the mosaic was cut from, where that is known."""
    paths: tuple[str, ...] = ()
    """All files that ``open_block`` was given, those left out too: no result takes their place."""
    sheet: Raster | None = None
    """The mosaic without the neighbours that ``mosaic`` goes on in; None where it has none."""

    @property
    def sheet_window(self) -> PixelWindow | None:
        """Pixels of the sheet among those of the mosaic; None where it has no neighbours."""
        if self.sheet is None:
            return None
        grid, (xmin, _, _, ymax) = self.mosaic.grid, self.sheet.extent
        return PixelWindow(round(grid.column_at(xmin)), round(grid.row_at(ymax)), self.sheet.columns, self.sheet.rows)

    def sources_over(self, window: PixelWindow) -> tuple[Source, ...]:
        """Sources whose footprint meets the window, wholly or in part."""
        extent = self.mosaic.grid.window_extent(window)
        return tuple(source for source in self.sources if extents_meet(source.extent, extent))

    def window(
        self, extent: Extent, settings: InspectionSettings | None = None, window_id: int = 1
    ) -> WindowRequest:
        """What ``inspect_window`` takes for a rectangle: xmin, ymin, xmax, ymax in the mosaic's reference system.

        It is snapped to the mosaic's pixels and trimmed to a multiple of ``2 ** levels`` of them, at least 64 px. One
        that can't be measured makes a request that says why, and its result will. ``extent`` may be a geometry of
        shapely, whose bounds count; ``settings``: the standard ones where None. Raises SettingsError for what is no
        rectangle, and for settings out of their range.
        """
        settings = settings or InspectionSettings()
        InspectionSettings.check(settings)
        imagery_limits.check_type("window_id", window_id, int)
        try:
            xmin, ymin, xmax, ymax = map(float, getattr(extent, "bounds", extent))
        except (TypeError, ValueError):
            raise SettingsError(messages.NO_RECTANGLE(number=window_id)) from None
        extent = xmin, ymin, xmax, ymax
        return window_request(self, window_id, extent, settings)

    def window_at(
        self, x: float, y: float, side_m: float = imagery_limits.STANDARD_SIDE_M,
        settings: InspectionSettings | None = None, window_id: int = 1,
    ) -> WindowRequest:
        """What ``inspect_window`` takes for a standard window about a place in the mosaic's reference system.

        Its side is the smallest power of two of pixels that spans at least ``side_m`` metres. Raises SettingsError for
        what is no place, no side, or settings out of their range.
        """
        for name, value in (("x", x), ("y", y), ("side_m", side_m)):
            imagery_limits.check_type(name, value, float)
        grid = self.mosaic.grid
        window = standard_window(grid, x, y, standard_side_px(grid, side_m))
        return self.window(grid.window_extent(window), settings, window_id)


def open_block(  # noqa: PLR0913 - keywords of a notebook
    mosaic: PathLike, sources: Iterable[PathLike] | PathLike = (), cells: PathLike = "", *, keep_copies: bool = False,
    crs: Any = "", nodata: float | None = None, neighbours: Iterable[PathLike] | PathLike = (),
) -> Block:
    """Open a mosaic with the orthoimages that it may have been made from.

    ``mosaic``: a north-up raster with a reference system. ``sources``: rasters in any reference system, each opened for
    its footprint; without any the block can be scanned along given seamlines only. ``cells``: a vector file of polygons
    that name in a field which source each part of the mosaic was cut from: its first layer, or
    ``file.gpkg|layername=cells``. ``keep_copies``: whether copies of the mosaic among the sources take part, though
    they hide every loss; without it they are looked for, and doubtful ones take part and are told. ``crs``: the
    reference system of all rasters (WKT, such as ``EPSG:2180``, its number, or what rasterio and pyproj have), whatever
    their files name; empty or None: what they name. ``nodata``: a value of pixels that are no measurements, in all
    bands and of all rasters, beside those that the files name. ``neighbours``: sheets of the same mosaic on its pixel
    grid, those around or all; what they show within 2048 px of its border, or a block more, is looked at, not counted.

    What is left out (sources that can't be opened, copies of the mosaic), and files that name another system than
    ``crs``, are told by a SeamInspectorWarning each. Raises RasterError when the mosaic can't be used, SettingsError
    when no source can, ``crs`` is none or a neighbour lies on another grid, SeamlineError when the cells can't.
    """
    wkt = known_wkt(crs)
    imagery_limits.check_type("mosaic", mosaic, *imagery_limits.PATH_TYPES)
    imagery_limits.check_type("cells", cells, *imagery_limits.PATH_TYPES)
    sources, neighbours = paths_of("sources", sources), paths_of("neighbours", neighbours)
    if nodata is not None and (isinstance(nodata, bool) or not isinstance(nodata, Real)):
        imagery_limits.check_type("nodata", nodata, float)
    value = None if nodata is None else float(nodata)
    sheet = describe_mosaic(RasterRef(os.fspath(mosaic), wkt, value))
    raster = with_neighbours(sheet, neighbours) if neighbours else sheet
    refs = [RasterRef(os.fspath(source), wkt, value) for source in sources]
    known = read_cells(os.fspath(cells), raster) if cells else ()
    table = [os.fspath(cells).partition("|")[0]] if cells else []
    paths = (sheet.ref.path, *neighbours, *(ref.path for ref in refs), *table)
    block = usable_block(Block(raster, (), tuple(known)), refs, keep_copies)
    return replace(block, paths=paths, sheet=sheet if neighbours else None)


def usable_block(alone: Block, sources: Sequence[RasterRef], keep_copies: bool = False, calls: int = 2) -> Block:
    """A mosaic with the sources that can be used. What is left out is told by a SeamInspectorWarning each, as of a
    caller so many ``calls`` up. Raises SettingsError when none of those that are given can be used."""
    block, notices = make_block(alone.mosaic, sources, (), alone.cells) if sources else (alone, [])
    block, of_copies = (block, []) if keep_copies else without_copies(block)
    for notice in (*alone.mosaic.notices, *notices, *of_copies):
        warnings.warn(str(notice), SeamInspectorWarning, stacklevel=1 + calls)
    if sources and not block.sources:
        raise SettingsError(messages.NO_SOURCE_USABLE())
    return block


def paths_of(name: str, given: Iterable[PathLike] | PathLike) -> list[str]:
    """Paths that an argument gives, be it a single one. Raises SettingsError for what is none."""
    imagery_limits.check_type(name, given, *imagery_limits.PATH_TYPES, Iterable)
    paths = [given] if isinstance(given, imagery_limits.PATH_TYPES) else [*given]
    for path in paths:
        imagery_limits.check_type(name, path, *imagery_limits.PATH_TYPES)
    return [os.fspath(path) for path in paths]


def with_neighbours(sheet: Raster, neighbours: Iterable[str]) -> Raster:
    """A sheet of a mosaic with what other sheets show within ``NEIGHBOURS_PX`` of it; the sheet itself lies on top.

    It begins where a block of all sheets together does, so that those that are measured are the blocks of the whole.
    Raises RasterError for one that can't be opened, SettingsError for one on another pixel grid.
    """
    grid, side = sheet.grid, NEIGHBOURS_PX
    others = [placed(OpenRaster(replace(sheet.ref, path=path)).raster) for path in neighbours]
    for other in others:
        if not have_same_grid(sheet, other):
            raise SettingsError(messages.NEIGHBOUR_OF_OTHER_GRID(name=other.ref.name, sheet=sheet.ref.name))
    lefts, bottoms, rights, tops = zip(sheet.extent, *(other.extent for other in others))
    starts = round(grid.column_at(min(lefts))), round(grid.row_at(max(tops)))
    column, row = (start + side * max(0, -start // side - 1) for start in starts)
    right, bottom = (
        start + side * (1 - (start - length) // side) for start, length in zip(starts, (grid.columns, grid.rows))
    )
    around = grid.window_extent(PixelWindow(column, row, right - column, bottom - row))
    near = (other.ref.path for other in others if extents_meet(other.extent, around))
    parts = tuple(path for path in near if path != sheet.ref.path)
    bounds = around[0], max(min(bottoms), around[1]), min(max(rights), around[2]), around[3]
    return describe_mosaic(replace(sheet.ref, parts=parts, bounds=bounds)) if parts else sheet


def make_block(
    mosaic: Raster, sources: Iterable[RasterRef], indexed: Iterable[Source] = (), cells: Iterable[Cell] = ()
) -> tuple[Block, list[Message]]:
    """A mosaic with its sources, each once, and notices about those left out.

    ``sources`` are opened for their footprints; ``indexed`` ones come with theirs and are not. The mosaic
    itself among the sources is dropped. Raises SettingsError when no source is named at all.
    """
    kept, notices = gather_sources(sources, indexed, mosaic.wkt, mosaic.ref)
    block = Block(mosaic, tuple(kept), tuple(cells))
    given = {source_stem(source.ref.name) for source in kept}
    if block.cells and given.isdisjoint(source_stem(cell.source) for cell in block.cells):
        notices.append(messages.CELLS_OF_OTHERS(name=block.cells[0].source))
    return block, notices


def without_copies(block: Block) -> tuple[Block, list[Message]]:
    """A block without copies of the mosaic among its sources, which are opened for that; and notices about them."""
    kept, notices = leave_out_copies(block.mosaic, block.sources)
    return replace(block, sources=tuple(kept)), notices


def window_request(block: Block, window_id: int, extent: Extent, settings: InspectionSettings) -> WindowRequest:
    """The request for a rectangle in the mosaic's reference system, snapped to the mosaic's pixels."""
    try:
        window = snap_window(block.mosaic.grid, extent, settings.levels)
    except WindowError as error:
        return WindowRequest(window_id, block.mosaic, (), None, settings, error.message)
    place = block.mosaic.grid.window_extent(window)
    cells = tuple(cell for cell in block.cells if extents_meet(cell.extent, place))
    return WindowRequest(window_id, block.mosaic, block.sources_over(window), window, settings, cells=cells)


def inspect_window(request: WindowRequest) -> WindowResult:
    """Clip, decompose, compare, judge and explain one window.

    A raster that can't be compared is left out with a notice; a window that can't be measured is
    ``not_comparable`` with the reason. Neither raises. Raises SettingsError for what ``Block.window`` did not make.
    """
    imagery_limits.check_type("request", request, WindowRequest)
    measured = measured_window.measure_window(request)
    if isinstance(measured, MeasuredWindow):
        return explain_window(measured)
    return measured_window.not_comparable(request, measured)


def inspect_windows(
    requests: Iterable[WindowRequest],
    executor: Executor | None = None,
    ahead: int = 0,
    cancelled: Callable[[], bool] = lambda: False,
) -> Iterator[WindowResult]:
    """``inspect_window`` for many, in their order, each as soon as it is ready.

    ``executor``: where they are measured, a thread per core where None; ``ahead``: how many it should have under way,
    twice this machine's cores where 0. One that fails in a way nobody foresaw is ``not_comparable`` for that.
    """
    with measuring(), own_threads(executor, ahead) as opened:  # memory is kept from one window to the next
        yield from in_order(requests, inspect_window, measured_window.not_comparable, Workers(*opened, cancelled))


def inspect_in_stages(
    request: WindowRequest, measure: MeasureWindow = measured_window.measure_window
) -> Iterator[WindowResult]:
    """Inspect a window that somebody waits for: its WindowClips as soon as they are there, if there are any, then all.

    ``measure`` may know a faster way to the first of them. What nobody foresaw becomes the reason of a result.
    """
    try:
        measured = measure(request)
        if isinstance(measured, MeasuredWindow):
            yield WindowClips(**vars(measured.result), has_sources=measured.is_explicable)
            yield explain_window(measured)
        else:
            yield measured_window.not_comparable(request, measured)
    except Exception as error:  # as an executor keeps it for ``in_order``
        yield measured_window.not_comparable(request, unforeseen(error))
