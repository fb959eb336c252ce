"""One run of seam: request -> the new cut and its patch as a file, or why there is none."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from uuid import uuid4

import numpy as np
from osgeo import gdal, gdal_array, ogr
from scipy import ndimage

from ....imagery import messages as imagery_messages
from ....imagery.clips import Clip
from ....imagery.errors import Message, NotCoveredError, RasterError, SettingsError
from ....imagery.gdal_calls import gdal_writing, taken_from_memory
from ....imagery.grids import Grid, PixelWindow
from ....imagery.limits import check_settings
from ....imagery.lines import as_xy, burnt, points_along, straightened
from ....imagery.raster_pool import open_raster
from ....imagery.raster_writer import whole_raster
from ....imagery.rasters import Raster
from ....imagery.wavelets import judged_plane
from .. import messages
from ..blocks.block_pixels import ALL_READ, BlockPixels
from ..following.boxes import enlarged, in_squares, near_border, opened, widened
from ..following.levelling import TONE_PX, square_means, to_pixels
from ..judgement.hard_cut import JudgedGround, as_type, judged_ground
from ..limits import MEND_BLEND_PX, MEND_WIDTH_M, MOST_BLEND_PX
from ..seam_cells import UNKNOWN
from ..seamlines.seam_pieces import NearestPieces, PieceIndex
from ..source_images import Source
from ..workers import measuring
from . import new_cut
from .failed_runs import SeamRun
from .new_cut import CELL_PX

GROUND_PX = 192
"""Around the old seam and the new cut: what tones and filters are learned of."""
_MOST_BESIDE_PX = 128  # from a seam, as far as it is mixed
_BESIDE_PX = 16  # more than the scan says, on either side
_MOST_UNKNOWN = 0.5  # of the pixels beside a seam, that follow no source for sure
_EXACT_PX = 16.0  # from a seam
_MOST_OTHERWISE = 0.005  # of the squares that only one image shows: of images that the mosaic was made from, none
_LEAST_DETAIL = 0.8  # of the mosaic's, that an image shows: levelled and filtered as it should be it has 0.93 to 1
_LEAST_OBJECT = 25.0  # grey values by which something stands out, of 255: more than tones differ between images
_RIM_PX = 2  # of an image
_RIM_CELLS = 8  # of a patch, in which it is led over to the mosaic's tones
_STRAIGHTENED_PX = 3.0
_BESIDE_MISFIT_CELLS, _SHORTEST_PART_CELLS = 8, 32  # of a run that is cut in parts
_SMOOTH_CELLS = 0.8  # of the cut's steps from cell to cell
_SIDES = 0, 1
"""Places of the sources of a request: of those on the left and on the right hand of the run."""


@dataclass(frozen=True)
class MendSettings:
    """How seams are cut anew."""

    width_m: float = MEND_WIDTH_M
    """On either side of a seam, that its new cut may move."""
    blend_px: int = MEND_BLEND_PX
    """Width over which the images are mixed at the cut, at most 31; 0: not at all."""

    def check(self) -> None:
        """Raise SettingsError when a value is out of its range."""
        check_settings(self, MendSettings)
        if self.width_m <= 0:
            raise SettingsError(messages.NO_WIDTH(value=self.width_m))
        if self.blend_px not in range(MOST_BLEND_PX + 1):
            raise SettingsError(messages.NO_BLEND(value=self.blend_px, most=MOST_BLEND_PX))


@dataclass(frozen=True, eq=False)
class RunRequest:
    """All that is needed to cut one run anew, in plain data that can cross threads and processes."""

    key: tuple[int, int]
    """The run's number, and 0."""
    mosaic: Raster
    sources: tuple[Source, ...]
    """Sources beside the run, the left one first, then others that are near."""
    run: SeamRun
    index: PieceIndex
    """All pieces of seam near by."""
    reach_px: float
    """How far the cut may move."""
    blend_px: int
    """Width of the blend as the settings have it."""


@dataclass(frozen=True)
class MendedRun:
    """What became of it."""

    reading = ALL_READ
    key: tuple[int, int]
    """Key of the request."""
    reason: Message | None = None
    """Why it stays as it is."""
    vertices: np.ndarray | None = field(default=None, compare=False)
    """(n, 2) float64 map units: the new cut."""
    window: PixelWindow | None = None
    """Window of its patch, on the mosaic's grid."""
    patch: np.ndarray | None = field(default=None, compare=False)
    """(n,) uint8: its file, as ``patch_file`` makes it."""
    steps: tuple[float | None, float | None] = (None, None)
    """Steps of tone, across the old seam and across the new cut, DN."""
    misfit: float | None = None
    """Misfit of the images along the new cut, px; None where nothing in common shows it."""
    fitting: tuple[tuple[float, float], ...] = ()
    """Parts of one that stays, m from its start, that may be cut by themselves: beyond them the images misfit."""
    notices: tuple[Message, ...] = ()


@measuring()
def mend_run(request: RunRequest) -> MendedRun:
    """Cut one run anew. One that can't be tells why; it never raises for that."""
    try:
        return _mended(request)
    except NotCoveredError:
        return MendedRun(request.key, messages.NOT_ON_MOSAIC())
    except RasterError as error:
        return MendedRun(request.key, error.message)


def not_mended(request: RunRequest, notices: tuple[Message, ...]) -> MendedRun:
    """A run that stays as it was where something happened that nobody foresaw."""
    return MendedRun(request.key, notices[0], notices=notices)


def _mended(request: RunRequest) -> MendedRun:
    """Raises RasterError where it can't be."""
    grid, names = request.mosaic.grid, request.mosaic.band_names
    line = grid.to_pixels(request.run.piece.vertices)
    cut = _new_way(request, line)
    if isinstance(cut, MendedRun):
        return cut
    way, misfit = cut
    reach = min(request.run.width_m / grid.ground_sample_distance / 2, _MOST_BESIDE_PX) + _BESIDE_PX
    read = _Pixels(request, _around(np.concatenate([line, way]), GROUND_PX), len(request.sources))
    part = _part(request, read.window, line, way)
    ground, alone = _ground(read, part), enlarged(part.from_any > reach, CELL_PX)
    unmixed_sides = [alone & read.valid(side) & (ground.expected.labels == side) for side in _SIDES]
    squares = [np.count_nonzero(square_means(side) > new_cut.MIN_UNMIXED) for side in unmixed_sides]
    if min(squares) < new_cut.FEWEST_SQUARES:
        raise RasterError(messages.TONES_NOT_TOLD())
    inside, weight, valid = part.patch(reach), part.weight(request.blend_px), [read.valid(side) for side in _SIDES]
    # Of each image only what is shown has to be there.
    pixels = enlarged(inside, CELL_PX) & (valid[0] | (weight == 0)) & (valid[1] | (weight == 1))
    if not pixels.any():
        raise RasterError(messages.PART_NOT_COVERED())
    before, both = read.mosaic_clip.bands, valid[0] & valid[1]
    images = [new_cut.placed_bands(ground, side, _named(read.clips[side], names), valid[side]) for side in _SIDES]
    for side, image in zip(_SIDES, images):
        new_cut.dress(ground, side, image, before, unmixed_sides[side])
        for name, band, shown in zip(names, image, before):
            share = new_cut.shown_detail(band, shown, unmixed_sides[side])
            if share is not None and share < _LEAST_DETAIL:
                source = read.clips[side].raster.ref.name
                raise RasterError(messages.DETAIL_NOT_SHOWN(name=source, share=share, band=name))
    middle = (judged_plane(images[0], names) + judged_plane(images[1], names)) / 2
    faded = _by_pixel(np.clip(ndimage.distance_transform_edt(inside) / _RIM_CELLS, 0, 1).astype(np.float32))
    made = new_cut.eased(images, weight, before, faded, both)  # at the patch's rim in the mosaic's tones
    after = np.where(pixels, _stored(made, request.mosaic, before.dtype), before)
    unmixed = enlarged(inside & (part.from_any > reach) & ~part.flipped, CELL_PX) & pixels
    was, is_now = (judged_plane(bands.astype(np.float32), names) for bands in (before, after))
    otherwise = _shown_otherwise(before, after, unmixed)
    if otherwise > _MOST_OTHERWISE:
        raise RasterError(messages.IMAGES_OF_OTHER_GROUND(share=otherwise))
    corner = read.window.column, read.window.row
    old_step, new_step = (
        new_cut.tone_step(shown - middle, points - corner, both) for shown, points in ((was, line), (is_now, way))
    )
    rows, columns = (np.flatnonzero(pixels.any(axis=axis)) for axis in (1, 0))
    down, across = (slice(int(places[0]), int(places[-1]) + 1) for places in (rows, columns))
    window = PixelWindow(across.start, down.start, across.stop - across.start, down.stop - down.start).moved_by(*corner)
    return MendedRun(
        request.key, None, np.array([grid.to_map(*point) for point in way]), window,
        patch_file(request.mosaic, window, after[:, down, across], pixels[down, across]), (old_step, new_step), misfit,
    )


def _new_way(request: RunRequest, line: np.ndarray) -> tuple[np.ndarray, float | None] | MendedRun:
    """Columns and rows (n, 2) of the new cut, and the images' misfit along it; the run as it stays where they misfit.
    Raises RasterError without any."""
    read = _Pixels(request, _around(line, request.reach_px), len(_SIDES))
    first_image, second_image = (read.planes.sources[side].plane for side in _SIDES)
    both = read.valid(0) & read.valid(1)
    cost = new_cut.cutting_cost(first_image, second_image, both)
    corner = np.array([read.window.column, read.window.row])
    nearest = _beside(request.index, read.window)
    allowed = _belongs(nearest, request.run) & (nearest.distance_px <= request.reach_px)
    points = points_along(line, 1.0)
    column, row = ((points - corner) // CELL_PX).astype(int).T
    # Where a seam runs out at the rim of an image it stays as it is.
    held = np.flatnonzero(np.isfinite(cost)[row, column])
    if not len(held):
        raise RasterError(messages.NO_WAY())
    allowed[row, column] = True
    first, last = held[0], held[-1]
    way = new_cut.cheapest_way(cost, allowed, (row[first], column[first]), (row[last], column[last]))
    if way is None:
        raise RasterError(messages.NO_WAY())
    misfit, fault, far = new_cut.fit_along(way, first_image, second_image, both)
    if fault is not None:
        return MendedRun(request.key, fault, fitting=_fitting(request, nearest.station_m[tuple(way.T)], far))
    inner = way[1:-1, ::-1] * CELL_PX + CELL_PX / 2 + corner
    way = np.concatenate([points[: first + 1], inner, points[last:]])
    return as_xy(straightened(way @ (1, 1j), _STRAIGHTENED_PX)), misfit


def _fitting(request: RunRequest, stations: np.ndarray, far: np.ndarray) -> tuple[tuple[float, float], ...]:
    """Parts of a run, m from its start, that are long enough and lie beside what misfits; ``stations`` of a way, m, and
    whether images are ``far`` apart there, (n,) each. None where nothing or all of it misfits."""
    piece, cell = request.run.piece, CELL_PX * request.mosaic.ground_sample_distance
    fits = np.ones(int(np.ceil(piece.length_m / cell)), bool)
    fits[((stations[far] - piece.station_m) / cell).astype(int).clip(0, len(fits) - 1)] = False
    fits = ndimage.binary_erosion(fits, iterations=_BESIDE_MISFIT_CELLS, border_value=1)
    parts = [part for (part,) in ndimage.find_objects(ndimage.label(fits)[0])]
    return () if fits.all() else tuple(
        (part.start * cell, min(part.stop * cell, piece.length_m)) for part in parts
        if part.stop - part.start >= _SHORTEST_PART_CELLS
    )


def _belongs(nearest: NearestPieces, run: SeamRun) -> np.ndarray:
    """(rows, columns) bool: whose nearest seam is a run."""
    first, last = run.span
    return np.isin(nearest.number, run.numbers) & (nearest.station_m >= first) & (nearest.station_m <= last)


class _Pixels:
    """What a window shows, as files have it and as it is judged."""

    def __init__(self, request: RunRequest, window: PixelWindow, count: int) -> None:
        """``count``: of the sources. Raises RasterError where the mosaic or one beside the run has no pixels."""
        refs = [source.ref for source in request.sources[:count]]
        block = BlockPixels(request.mosaic, refs, window)
        self.window = window
        self.mosaic_clip, self.clips = block.held
        if any(side not in self.clips for side in _SIDES):
            raise RasterError(next(iter(block.notices), messages.PART_NOT_COVERED()))
        self.planes = block.part(window, list(self.clips))

    def valid(self, source: int) -> np.ndarray:
        """(rows, columns) bool: where the mosaic and this source have pixels; not its rim, mixed with nothing maybe."""
        is_valid, source_valid = np.ones(self.planes.mosaic.plane.shape, bool), self.clips[source].valid
        if source_valid is not None:
            is_valid &= source_valid & ~widened(opened(~source_valid, TONE_PX), _RIM_PX)
        return is_valid if self.mosaic_clip.valid is None else is_valid & self.mosaic_clip.valid


def _shown_otherwise(before: np.ndarray, after: np.ndarray, unmixed: np.ndarray) -> float:
    """The largest share, of all bands, of squares in ``unmixed`` ground, (rows, columns) bool, that a patch changes by
    more than that ground varies: there the images show something else than the mosaic."""
    whole, most = in_squares(unmixed, CELL_PX).all(axis=(1, 3)), 0.0
    for shown, made in zip(before, after) if whole.any() else ():
        was, is_now = (in_squares(plane, CELL_PX).mean(axis=(1, 3), dtype=np.float32)[whole] for plane in (shown, made))
        grey = 1.0 if shown.dtype == np.uint8 else float(np.percentile(was, 99)) / 255
        most = max(most, float(np.mean(np.abs(is_now - was) > max(was.std(), _LEAST_OBJECT * grey))))
    return most


def _stored(made: np.ndarray, mosaic: Raster, dtype: np.dtype) -> np.ndarray:
    """Pixels as the mosaic holds its own; none of them is what stands there for no data."""
    stored, nodata = as_type(made, dtype), open_raster(mosaic.ref).nodata
    if mosaic.bits and dtype.kind != "f":
        np.minimum(stored, 2**mosaic.bits - 1, out=stored)
    if nodata is not None:
        stored[0, (stored == nodata).all(axis=0)] += np.array(1 if nodata <= 0 else -1).astype(dtype)
    return stored


def _named(clip: Clip, names: Sequence[str]) -> np.ndarray:
    """The bands of a source in the order of these names. Raises RasterError where it lacks one."""
    held = clip.raster.band_names
    missing = [name for name in names if name not in held]
    if missing:
        raise RasterError(messages.BANDS_DIFFER(
            name=clip.raster.ref.name, band=", ".join(missing), bands=", ".join(held)
        ))
    return clip.bands[[held.index(name) for name in names]]


def _ground(read: _Pixels, part: _Part) -> JudgedGround:
    """What the estimator tells of a window; its sources are numbered as in the request.

    Where compression left too little to tell them by, what a scan says of the sides of the seam is believed.
    """
    image, sources = read.planes.mosaic, list(read.planes.sources.values())
    ground = judged_ground(image, sources, None)
    territory = enlarged(part.territory, CELL_PX) & (True if image.valid is None else image.valid)
    if np.count_nonzero(ground.expected.labels[territory] == UNKNOWN) <= _MOST_UNKNOWN * np.count_nonzero(territory):
        return ground
    sides = enlarged(np.where(part.on_left ^ part.flipped, *map(np.uint8, _SIDES)), CELL_PX)
    return judged_ground(image, sources, np.where(territory, sides, np.uint8(UNKNOWN)))


@dataclass(frozen=True, eq=False)
class _Part:
    """A window by cells, each (rows, columns)."""

    territory: np.ndarray
    """bool: whose nearest seam is the run."""
    from_any: np.ndarray
    """float32: pixels from the nearest seam."""
    flipped: np.ndarray
    """bool: between the old seam and the new cut."""
    on_left: np.ndarray
    """bool: what is on the left hand of the new cut."""

    def weight(self, blend_px: int) -> np.ndarray:
        """Weight of the left image, by pixels, (rows, columns) float32, 0 to 1."""
        sides = np.where(self.on_left, np.float32(1), np.float32(-1))
        left = (_by_pixel(ndimage.gaussian_filter(sides, _SMOOTH_CELLS, mode="nearest")) > 0).astype(np.float32)
        return np.clip(ndimage.uniform_filter(left, blend_px, mode="nearest"), 0, 1) if blend_px > 1 else left

    def patch(self, reach: float) -> np.ndarray:
        """bool: what is made anew, where the mosaic is mixed up to ``reach`` px from the old seam."""
        from_cut = CELL_PX * ndimage.distance_transform_edt(~near_border(self.on_left.view(np.uint8), 1))
        near = (self.from_any <= reach) | (from_cut <= new_cut.EASED_PX) | widened(self.flipped, 2)
        return self.territory & near


def _part(request: RunRequest, window: PixelWindow, line: np.ndarray, way: np.ndarray) -> _Part:
    any_near = _beside(request.index, window)
    of_run = _beside(PieceIndex([request.run.piece], request.mosaic.grid), window)
    ring = ogr.Geometry(ogr.wkbLinearRing)
    for column, row in np.concatenate([line, way[::-1], line[:1]]).tolist():
        ring.AddPoint_2D(column / CELL_PX, -row / CELL_PX)
    between = ogr.Geometry(ogr.wkbPolygon)
    between.AddGeometry(ring)
    cells = PixelWindow(*(side // CELL_PX for side in (window.column, window.row, window.width, window.height)))
    flipped = burnt([(between, 1)], Grid(0, 0, 1, 1, 1, 1), cells) == 1
    return _Part(_belongs(any_near, request.run), any_near.distance_px, flipped, of_run.on_left ^ flipped)


def _around(points: np.ndarray, margin: float) -> PixelWindow:
    """Whole squares around columns and rows (n, 2)."""
    first = np.floor((points.min(axis=0) - margin) / TONE_PX).astype(int) * TONE_PX
    last = np.ceil((points.max(axis=0) + margin) / TONE_PX).astype(int) * TONE_PX
    return PixelWindow(*first.tolist(), *(last - first).tolist())


def _beside(index: PieceIndex, window: PixelWindow) -> NearestPieces:
    """Places of the middles of its cells beside the pieces, (rows, columns) each: near by exactly, farther off as the
    nearest cell of those, which takes a tenth of the time."""
    columns, rows = (
        first + np.arange(CELL_PX / 2, length, CELL_PX)
        for first, length in ((window.column, window.width), (window.row, window.height))
    )
    near = index.beside(columns, rows[:, np.newaxis], _EXACT_PX)
    off, places = ndimage.distance_transform_edt(near.number < 0, return_indices=True)
    number, distance, on_left, station = (
        plane[tuple(places)] for plane in (near.number, near.distance_px, near.on_left, near.station_m)
    )
    return NearestPieces(number, distance + CELL_PX * off, on_left, station)


def _by_pixel(cells: np.ndarray) -> np.ndarray:
    """Linear between the middles of cells."""
    return to_pixels(cells, tuple(CELL_PX * length for length in cells.shape), CELL_PX)


_COG = ["COMPRESS=DEFLATE", "PREDICTOR=YES", "OVERVIEW_RESAMPLING=AVERAGE", "BIGTIFF=IF_SAFER", "SPARSE_OK=TRUE"]
_ROLES = {"red": gdal.GCI_RedBand, "green": gdal.GCI_GreenBand, "blue": gdal.GCI_BlueBand}


def patch_file(mosaic: Raster, window: PixelWindow, pixels: np.ndarray, inside: np.ndarray) -> np.ndarray:
    """The bytes (n,) of a cloud-optimised GeoTIFF whose last band is alpha. Raises RasterError where memory lacks.

    ``pixels``: (bands, rows, columns); ``inside``: (rows, columns) bool.
    """
    opaque = np.iinfo(pixels.dtype).max if pixels.dtype.kind != "f" else 255
    made = np.where(inside, np.concatenate([pixels, np.full_like(pixels[:1], opaque)]), 0).astype(pixels.dtype)
    dataset = gdal_array.OpenArray(made)
    _, across, skew, _, down, height = mosaic.placement
    x, y = mosaic.grid.to_map(window.column, window.row)
    dataset.SetGeoTransform((x, across, skew, y, down, height))
    dataset.SetProjection(mosaic.wkt)
    for number, name in enumerate(mosaic.band_names, 1):
        dataset.GetRasterBand(number).SetColorInterpretation(_ROLES.get(name, gdal.GCI_Undefined))
    dataset.GetRasterBand(len(made)).SetColorInterpretation(gdal.GCI_AlphaBand)
    # GDAL takes alpha for a mask in grey and coloured images of 8 and 16 bits, without sign, only: others get one.
    mask = "auto" if len(made) in (2, 4) and made.dtype in (np.uint8, np.uint16) else len(made)
    path = f"/vsimem/patch_{uuid4().hex}.tif"
    with whole_raster(path), gdal_writing(imagery_messages.RASTER_NOT_WRITTEN(path=path)):
        gdal.Translate(path, dataset, format="COG", creationOptions=_COG, maskBand=mask)
    return np.frombuffer(taken_from_memory(path), np.uint8)
