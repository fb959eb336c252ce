"""Windows and whole mosaics, measured by any executor, with progress and cancelling alike everywhere."""
from __future__ import annotations

import logging
import os
import warnings
from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from threading import Event
from typing import Any, Callable, Union

from osgeo import ogr

from ..plugin.imagery.errors import CancelledError, Level, Message, SeamInspectorWarning, SettingsError
from ..plugin.imagery.gdal_calls import gdal_silenced
from ..plugin.imagery.limits import PATH_TYPES, check_type
from ..plugin.imagery.messages import CANCELLED
from ..plugin.imagery.records import GEOMETRY
from ..plugin.seams.measure import messages as seams_messages
from ..plugin.seams.measure.limits import FAILED
from ..plugin.seams.measure.mending.failed_runs import FIELDS, given_pieces
from ..plugin.seams.measure.mending.mend_run import MendSettings
from ..plugin.seams.measure.mending.mending import PATCHED, MendedSeam, Mending, MendRequest, mending
from ..plugin.seams.measure.scan import whole_scan
from ..plugin.seams.measure.scan.scan_result import ScanResult
from ..plugin.seams.measure.scan.whole_scan import ScanSettings
from ..plugin.seams.measure.window import inspection
from ..plugin.seams.measure.window.inspection import Block, PathLike
from ..plugin.seams.measure.window.measured_window import InspectionSettings, WindowRequest
from ..plugin.seams.measure.window.window_result import WindowResult
from ..plugin.seams.measure.workers import Workers
from ..plugin.toolkit.executors import Crew, open_executor
from . import messages
from .outputs import GEOTIFF, VRT, check_writing
from .scan_files import SEAMLINES, check_scanned, read_seams

Progress = Callable[[float], object]
Cancelled = Union[Callable[[], bool], Event]
_log = logging.getLogger("seam_inspector")
_log.addHandler(logging.NullHandler())
_SIDES = ("xmin", "ymin", "xmax", "ymax")


def inspect_windows(
    windows: Iterable[Any], block: Block | None = None, settings: InspectionSettings | None = None, *,
    executor: Crew = None, progress: Progress | None = None, cancelled: Cancelled | None = None,
) -> Iterator[WindowResult]:
    """``inspect_window`` for many, in their order, each as soon as it is ready.

    Parameters
    ----------
    windows : iterable
        What ``Block.window`` makes; or with a ``block`` rectangles, numbered from 1: (xmin, ymin, xmax, ymax) in the
        mosaic's reference system, geometries of shapely, of which the box around each is inspected, rows with a
        ``geometry`` or with these four names, a GeoSeries or a GeoDataFrame, which are moved to the mosaic's system; a
        SeamInspectorWarning tells where they name none and are taken in that.
    block : Block, optional
        The mosaic that rectangles lie on.
    settings : InspectionSettings, optional
        How rectangles are inspected; the standard ones where None.
    executor : concurrent.futures.Executor, dask.distributed.Client or address of a Dask scheduler, optional
        Where windows are measured; a thread per core where None.
    progress : callable, optional
        Is told the share that is done, 0 to 1.
    cancelled : callable or threading.Event, optional
        Is asked several times a second whether to end; threads finish what they are at, a window or a block of a scan.

    A window that fails in a way nobody foresaw is ``not_comparable`` for that reason. Raises CancelledError when
    cancelled, WorkersLostError when nobody is left to measure, SettingsError for wrong settings and no rectangles.
    """
    check_type("windows", windows, Iterable)
    if block is not None:
        check_type("block", block, Block)
        if getattr(windows, "crs", "") is None:  # of geopandas
            warnings.warn(str(messages.WITHOUT_SYSTEM()), SeamInspectorWarning, stacklevel=2)
    requests: list[WindowRequest] = list(windows) if block is None else [
        block.window(rectangle, settings, number)
        for number, rectangle in enumerate(_rectangles(windows, block.mosaic.wkt), 1)
    ]
    if not all(isinstance(request, WindowRequest) for request in requests):
        raise SettingsError(messages.RECTANGLES_WITHOUT_BLOCK())
    return _inspected(requests, executor, *_watchers(progress, cancelled))


def _inspected(
    requests: list[WindowRequest], executor: Crew, progress: Progress, cancelled: Callable[[], bool]
) -> Iterator[WindowResult]:
    done = 0
    with open_executor(executor, cancelled) as (opened, ahead):
        for done, result in enumerate(inspection.inspect_windows(requests, opened, ahead, cancelled), 1):
            _tell(result.notices)
            progress(done / len(requests))
            yield result
    if done < len(requests):
        raise CancelledError(CANCELLED())


def scan(
    block: Block, settings: ScanSettings | None = None, *, seamlines: PathLike = "", loss: PathLike = "",
    executor: Crew = None, progress: Progress | None = None, cancelled: Cancelled | None = None,
) -> ScanResult:
    """Scan a whole mosaic: what each piece of its seams kept, and windows of the places that kept least.

    Parameters
    ----------
    block : Block
        The mosaic with its orthoimages. Of one with neighbours the seams of the mosaic itself are counted; figures of
        ground that nothing explains, and the picture of losses, reach into the neighbours.
    settings : ScanSettings, optional
        The standard ones where None.
    seamlines : path, optional
        A vector file of lines, or of polygons that are filled from one source each: its first layer, or
        ``file.gpkg|layername=name``; without it seams are found from the pixels. One that names no reference system
        lies in the mosaic's; where none of its seams lies on the mosaic, nothing is measured: 0 m, and a notice.
    loss : path, optional
        A GeoTIFF for the picture of losses; a scan that was stopped goes on when it is started again with the same.
    executor, progress, cancelled : optional
        As for ``inspect_windows``.

    What was left out or assumed stands in the result's ``notices``, and goes to the log ``seam_inspector``. Raises
    SettingsError when the inputs make no scan, or the picture can't be written, or only over one of them or over what
    no scan made, SeamlineError for seamlines that are none, RasterError when the disk is full, CancelledError when
    cancelled, WorkersLostError when nobody is left to measure.
    """
    check_type("block", block, Block)
    check_type("seamlines", seamlines, *PATH_TYPES)
    check_type("loss", loss, *PATH_TYPES)
    tell, is_cancelled = _watchers(progress, cancelled)
    given = os.fspath(seamlines).partition("|")[0]
    check_writing({"loss": (os.fspath(loss), GEOTIFF)} if loss else {}, filter(None, (*block.paths, given)))
    with open_executor(executor, is_cancelled) as crew:
        workers = Workers(*crew, is_cancelled, tell)
        result = whole_scan.scan(block, settings, seamlines=seamlines, loss=loss, workers=workers)
    _tell(result.notices)
    return replace(result, told={**result.told, SEAMLINES: os.path.abspath(given)}) if given else result


def mend(
    block: Block, seams: ScanResult | PathLike, mended: PathLike, settings: MendSettings | None = None, *,
    patches: PathLike = "", which: str = FAILED,
    executor: Crew = None, progress: Progress | None = None, cancelled: Cancelled | None = None,
) -> list[MendedSeam]:
    """Cut seams anew where the images agree best, as patches beside the mosaic, which is never touched.

    Parameters
    ----------
    block : Block
        The mosaic with its orthoimages; neighbours are not looked at.
    seams : ScanResult or path
        What ``scan`` found, or the GeoPackage that holds it: its layer ``seams``, or ``file.gpkg|layername=name``.
    mended : path
        The mended mosaic, a VRT over the mosaic and the patches.
    settings : MendSettings, optional
        The standard ones where None.
    patches : path, optional
        A folder for the patches; beside ``mended`` where empty.
    which : str
        ``failed``, ``reduced`` for those too that measurably lost something, or ``all``.
    executor, progress, cancelled : optional
        As for ``inspect_windows``.

    Each run of seam with what became of it: ``mended``, ``improved`` or ``left``, and why. Raises SettingsError for a
    scan of another mosaic, it or RasterError where nothing can be mended or written, CancelledError when cancelled,
    WorkersLostError when nobody is left to measure.
    """
    check_type("block", block, Block)
    check_type("seams", seams, ScanResult, *PATH_TYPES)
    check_type("mended", mended, *PATH_TYPES)
    check_type("patches", patches, *PATH_TYPES)
    settings = settings or MendSettings()
    MendSettings.check(settings)
    tell, is_cancelled = _watchers(progress, cancelled)
    place = Path(mended)
    folder = os.fspath(patches) or str(place.parent / f"{place.stem}_patches")
    read = [*block.paths, *([] if isinstance(seams, ScanResult) else [os.fspath(seams).partition("|")[0]])]
    check_writing({"mended": (os.fspath(mended), VRT)}, read)
    rows, notes = read_seams(seams)
    if notes:
        check_scanned(notes, block)
    features = [(row, bytes(ogr.CreateGeometryFromWkt(row[GEOMETRY]).ExportToWkb())) for row in rows]
    pieces = tuple(given_pieces(features, FIELDS, which))
    request = MendRequest(block.sheet or block.mosaic, block.sources, pieces, settings)
    with open_executor(executor, is_cancelled) as crew, mending(request, folder, os.fspath(mended), read) as job:
        return _mended(job, Workers(*crew, is_cancelled, tell))


def _watchers(progress: Progress | None, cancelled: Cancelled | None) -> tuple[Progress, Callable[[], bool]]:
    """Who is told of progress, where it is more than before (found seams, and runs that share work, are counted anew),
    and who is asked whether to end. Raises SettingsError for what can't be called."""
    asked: Any = getattr(cancelled, "is_set", cancelled)
    for name, given in (("progress", progress), ("cancelled", asked)):
        if given is not None and not callable(given):
            raise SettingsError(messages.NO_FUNCTION(name=name, value=type(given).__name__))
    most = -1.0

    def tell(share: float) -> None:
        nonlocal most
        if progress is not None and share > most:
            most = share
            progress(share)

    return tell, asked or (lambda: False)


def _mended(job: Mending, workers: Workers) -> list[MendedSeam]:
    for step in job.steps(workers):
        _tell(step.notices)
        workers.progress(PATCHED * step.share)
    if workers.cancelled():
        raise CancelledError(seams_messages.STOPPED())
    made = job.result(workers.part(PATCHED))
    _tell(dict.fromkeys(seam.reason.as_warning() for seam in made if seam.reason is not None))
    workers.progress(1.0)
    return made


def _rectangles(windows: Iterable[Any], wkt: str) -> Iterator[Any]:
    """What ``Block.window`` takes for each, in the mosaic's reference system."""
    table: Any = windows
    if getattr(table, "crs", None) is not None:
        table = table.to_crs(wkt)
    table = getattr(table, "geometry", table)
    if hasattr(table, "columns"):  # a DataFrame of pandas
        table = table.to_dict("records")
    for row in table:
        sides = row
        if isinstance(row, Mapping):
            sides = row[GEOMETRY] if GEOMETRY in row else [row.get(name) for name in _SIDES]
        sides = getattr(sides, GEOMETRY, sides)  # of a row of geopandas
        if isinstance(sides, str):
            with gdal_silenced(), suppress(RuntimeError, AttributeError):  # GDAL has no geometry of other words
                xmin, xmax, ymin, ymax = ogr.CreateGeometryFromWkt(sides).GetEnvelope()
                sides = xmin, ymin, xmax, ymax
        yield sides


def _tell(notices: Iterable[Message]) -> None:
    for notice in notices:
        _log.log(logging.INFO if notice.level is Level.INFO else logging.WARNING, "%s", notice)
