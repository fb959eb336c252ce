"""One run of seam: request -> the new cut and the pixels of its patch, or why there is none."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from osgeo import ogr
from scipy import ndimage

from ....imagery.clips import Clip, read_clip
from ....imagery.errors import Message, NotCoveredError, RasterError, SettingsError
from ....imagery.grids import Grid, PixelWindow
from ....imagery.limits import measured_bands
from ....imagery.lines import as_xy, burnt, points_at, straightened, vertex_stations
from ....imagery.raster_pool import open_raster
from ....imagery.rasters import Raster
from ....imagery.remote_files import remote_settings
from ....imagery.shifts import find_shift
from ....imagery.wavelets import judged_plane
from ..compared_image import ComparedImage
from ..following.boxes import enlarged, in_squares, near_border, widened
from ..following.followed_source import high_pass
from ..following.hard_cut import JudgedGround, judged_ground
from ..following.levelling import SQUARE_PX
from ..inputs.grey_values import grey_factor
from ..limits import FAILED, MEND_BLEND_PX, MEND_WIDTH_M, MENDED_SEAMS, MOST_BLEND_PX
from ..scan.lines.piece_index import NearestPieces, PieceIndex
from ..seam_cells import UNKNOWN
from ..source_images import Source
from ..while_measuring import measuring
from . import messages
from .dressing import EASED_PX, dressed, eased, placed_bands, tells_tones
from .failed_runs import SeamRun
from .new_cut import CELL_PX, MOST_APART, apart_along, cheapest_way, difference
from .tone_steps import tone_step

GROUNDS_PX = 192, 512
"""Around the old seam and the new cut: what tones and filters are learned of, and where that is too little."""
MOST_BESIDE_PX = 128
"""From a seam, as far as its mixture is looked for."""
MOST_MISFIT_PX = 2.5
"""Along the new cut: where images lie farther apart, an edge that it crosses is seen to break."""
_BESIDE_PX = 16  # more than is mixed, on either side
_BIN_CELLS = 4  # by distance from the seam
_AS_ELSEWHERE = 1.5  # times what sources leave over far from the seam
_MOST_UNKNOWN = 0.5  # of the pixels beside a seam, that follow no source for sure
_LEAST_LEFT = 0.002  # of the fine detail: what rounding leaves over
_EXACT_PX = 16.0  # from a seam
_STRIP_PX = 40  # on either side of a way, in which the images' misfit is looked for
_RIM_CELLS = 8  # of a patch, in which it is led over to the mosaic's tones
_STRAIGHTENED_PX = 3.0
_SMOOTH_CELLS = 0.8  # of the cut's steps from cell to cell
_BAND = ("judged",)
SIDES = 0, 1
"""Of the sources of a request: those on the left and on the right hand of the run."""


@dataclass(frozen=True)
class MendSettings:
    """How seams are cut anew."""

    width_m: float = MEND_WIDTH_M
    """On either side of a seam, that its new cut may move."""
    blend_px: int = MEND_BLEND_PX
    """Width over which the images are mixed at the cut; 0: not at all."""
    what: str = FAILED
    """Which seams, one of ``limits.MENDED_SEAMS``."""

    def check(self) -> None:
        """Raise SettingsError when a value is out of its range."""
        if not 0 < self.width_m < np.inf:
            raise SettingsError(messages.WIDTH_NOT_POSITIVE(width=self.width_m))
        if not 0 <= self.blend_px <= MOST_BLEND_PX:
            raise SettingsError(messages.BLEND_OUT_OF_RANGE(blend=self.blend_px, most=MOST_BLEND_PX))
        if self.what not in MENDED_SEAMS:
            raise SettingsError(messages.WHAT_UNKNOWN(what=self.what, known=", ".join(MENDED_SEAMS)))


@dataclass(frozen=True, eq=False)
class RunRequest:
    """All that is needed to cut one run anew, in plain data that can cross threads and processes."""

    key: tuple[int, int]
    """The run's number, and 0."""
    mosaic: Raster
    sources: tuple[Source, ...]
    """Those beside the run, the left one first, then others that are near."""
    run: SeamRun
    index: PieceIndex
    """All pieces of seam near by."""
    reach_px: float
    """As far as the cut may move."""
    settings: MendSettings


@dataclass(frozen=True, eq=False)
class MendedRun:
    """What became of it."""

    key: tuple[int, int]
    """Of the request."""
    reason: Message | None = None
    """Why it stays as it is."""
    vertices: np.ndarray | None = None
    """(n, 2) float64 map units: the new cut."""
    window: PixelWindow | None = None
    """Of its patch, on the mosaic's grid."""
    pixels: np.ndarray | None = None
    """(bands, rows, columns) in the mosaic's type and order."""
    inside: np.ndarray | None = None
    """(rows, columns) bool: which of them replace the mosaic's."""
    steps: tuple[float | None, float | None] = (None, None)
    """Of tone, across the old seam and across the new cut, DN."""
    misfit: float | None = None
    """Of the images along the new cut, px; None where nothing in common shows it."""
    notices: tuple[Message, ...] = ()


@measuring()
def mend_run(request: RunRequest) -> MendedRun:
    """Cut one run anew. One that can't be tells why; it never raises for that."""
    try:
        with remote_settings({}):
            return _mended(request)
    except RasterError as error:
        return MendedRun(request.key, error.message)


def not_mended(request: RunRequest, notices: tuple[Message, ...]) -> MendedRun:
    """Where something happened that nobody foresaw."""
    return MendedRun(request.key, notices[0], notices=notices)


def _mended(request: RunRequest) -> MendedRun:
    grid = request.mosaic.grid
    line = grid.to_pixels(request.run.piece.vertices)
    found = _new_way(request, line)
    if isinstance(found, Message):
        return MendedRun(request.key, found)
    way, misfit = found
    known_reach = min(request.run.width_m / grid.ground_sample_distance / 2, MOST_BESIDE_PX) + _BESIDE_PX
    for margin in GROUNDS_PX:
        window = _around(np.concatenate([line, way]), margin)
        clips = _read(request, window, range(len(request.sources)))
        part = _part(request, window, line, way)
        ground = _ground(clips, part)
        reach = max(_mixed_reach(ground, part), known_reach)
        alone = enlarged(part.from_any > reach, CELL_PX)
        own = [alone & clips.valid(side) & (ground.expected.labels == side) for side in SIDES]
        if all(map(tells_tones, own)):
            break
    else:
        return MendedRun(request.key, messages.TONES_NOT_TOLD())
    weight = part.weight(request.settings.blend_px)
    inside = part.patch(reach)
    pixels = enlarged(inside, CELL_PX) & clips.both
    if not pixels.any():
        return MendedRun(request.key, messages.PART_NOT_COVERED())
    before = clips.mosaic.bands
    made, middle = _made(ground, clips, own, weight, part.fade(inside))
    after = np.where(pixels, _of_type(made, before.dtype), before)
    names = clips.mosaic.raster.band_names
    steps = [
        tone_step(judged_plane(bands - middle, names), points - (window.column, window.row), clips.both)
        for bands, points in ((before, line), (after, way))
    ]
    place, patch = _cropped(pixels, window)
    vertices = np.array([grid.to_map(*point) for point in way])
    return MendedRun(
        request.key, None, vertices, patch, after[(slice(None), *place)], pixels[place], (steps[0], steps[1]), misfit
    )


def _new_way(request: RunRequest, line: np.ndarray) -> tuple[np.ndarray, float | None] | Message:
    """Columns and rows (n, 2) of the new cut, and the misfit of the images along it; why there is none."""
    window = _around(line, request.reach_px)
    clips = _read(request, window, SIDES)
    first_image, second_image = clips.planes
    found = difference(first_image, second_image, clips.both)
    corner = np.array([window.column, window.row])
    nearest = _beside(request.index, window)
    allowed = np.isin(nearest.number, request.run.numbers) & (nearest.distance_px <= request.reach_px)
    along = vertex_stations(line)
    points = points_at(line, along, np.linspace(0, along[-1], int(along[-1]) + 2))
    column, row = ((points - corner) // CELL_PX).astype(int).T
    # Where a seam runs out at the rim of an image it stays as it is.
    held = np.flatnonzero(np.isfinite(found.cost)[row, column])
    if not len(held):
        return messages.NO_WAY()
    allowed[row, column] = True
    first, last = held[0], held[-1]
    way = cheapest_way(found.cost, allowed, (row[first], column[first]), (row[last], column[last]))
    if way is None:
        return messages.NO_WAY()
    misfit = _misfit(clips, way)
    if misfit is None and apart_along(found, way) > MOST_APART:
        return messages.IMAGES_UNLIKE()
    if misfit is not None and misfit > MOST_MISFIT_PX:
        return messages.IMAGES_MISFIT(misfit=misfit)
    inner = way[1:-1, ::-1] * CELL_PX + CELL_PX / 2 + corner
    way = np.concatenate([points[: first + 1], inner, points[last:]])
    return as_xy(straightened(way @ (1, 1j), _STRAIGHTENED_PX)), misfit


def _misfit(clips: _RunClips, way: np.ndarray) -> float | None:
    """How far the images lie from each other along a way, px; None where nothing in common shows it."""
    off = np.ones([length // CELL_PX for length in clips.both.shape], bool)
    off[tuple(way.T)] = False
    beside = enlarged(CELL_PX * ndimage.distance_transform_edt(off) <= _STRIP_PX, CELL_PX)
    first, second = clips.planes
    shift = find_shift(first, second, beside & clips.both)
    return None if shift is None else shift.length


def _made(
    ground: JudgedGround, clips: _RunClips, own: Sequence[np.ndarray], weight: np.ndarray, fade: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """The bands of the patch, (bands, rows, columns) float32, and the mean of both images in the mosaic's dress."""
    names = clips.mosaic.raster.band_names
    images = [placed_bands(ground, side, clips.named(side, names)) for side in SIDES]
    made, middle = np.empty((2, *clips.mosaic.bands.shape), np.float32)
    for place, band in enumerate(clips.mosaic.bands.astype(np.float32)):
        first, second = (dressed(ground, side, images[side][place], band, own[side]) for side in SIDES)
        made[place], middle[place] = eased(first, second, weight, band, fade), (first + second) / 2
    return made, middle


@dataclass(frozen=True, eq=False)
class _RunClips:
    """The pixels of a window."""

    mosaic: Clip
    sources: list[Clip]
    """Those beside the run first."""
    factors: list[float]
    """What the values of each are multiplied by for the estimator, the mosaic's first."""

    @property
    def both(self) -> np.ndarray:
        """(rows, columns) bool: where the mosaic and both sources have pixels."""
        return np.logical_and(*map(self.valid, SIDES))

    def valid(self, source: int) -> np.ndarray:
        """(rows, columns) bool: where the mosaic and this source have pixels."""
        valid = [clip.valid for clip in (self.mosaic, self.sources[source]) if clip.valid is not None]
        return np.logical_and.reduce([np.ones(self.mosaic.bands.shape[1:], bool), *valid])

    @property
    def planes(self) -> list[np.ndarray]:
        """Of the judged band, of the sources."""
        return [_plane(clip, self.mosaic.raster, factor) for clip, factor in zip(self.sources, self.factors[1:])]

    def named(self, source: int, names: Sequence[str]) -> np.ndarray:
        """The bands of a source in the order of these names. Raises RasterError where it lacks one."""
        clip = self.sources[source]
        held = clip.raster.band_names
        missing = [name for name in names if name not in held]
        if missing:
            raise RasterError(messages.BANDS_LACK(name=clip.raster.ref.name, bands=", ".join(missing)))
        return clip.bands[[held.index(name) for name in names]]


def _read(request: RunRequest, window: PixelWindow, numbers: Sequence[int]) -> _RunClips:
    """Raises RasterError where the mosaic or a source beside the run can't be read."""
    mosaic = read_clip(open_raster(request.mosaic.ref), request.mosaic, window, partly=True, holes=True)
    sources, factors = [], [grey_factor(request.mosaic)]
    for number in numbers:
        try:
            raster = open_raster(request.sources[number].ref)
            clip = read_clip(raster, request.mosaic, window, partly=True, holes=True)
        except NotCoveredError:
            if number in SIDES:
                raise
            continue
        if request.mosaic.judged_band in measured_bands(clip.raster.band_names):
            sources.append(clip)
            factors.append(grey_factor(raster.raster))
    return _RunClips(mosaic, sources, factors)


def _plane(clip: Clip, mosaic: Raster, factor: float) -> np.ndarray:
    names = clip.raster.band_names
    first = 0 if mosaic.has_luminance else names.index(mosaic.judged_band)
    some = slice(first, first + (3 if mosaic.has_luminance else 1))
    return np.float32(factor) * judged_plane(clip.bands[some], names[some])


def _ground(clips: _RunClips, part: _Part) -> JudgedGround:
    """What the estimator tells of a window; its sources are numbered as in the request.

    Where compression left too little to tell them by, what a scan says of the sides of the seam is believed.
    """
    image, *images = (
        ComparedImage(
            _plane(clip, clips.mosaic.raster, factor)[np.newaxis], _BAND, {}, {}, clip.raster,
            (clip.offset_x, clip.offset_y), clip.valid,
        )
        for clip, factor in zip((clips.mosaic, *clips.sources), clips.factors)
    )
    found = judged_ground(image, images, None)
    own = enlarged(part.territory, CELL_PX)
    if np.count_nonzero(found.expected.labels[own] == UNKNOWN) <= _MOST_UNKNOWN * np.count_nonzero(own):
        return found
    sides = enlarged(np.where(part.on_left ^ part.flipped, *map(np.uint8, SIDES)), CELL_PX)
    return judged_ground(image, images, np.where(own, sides, np.uint8(UNKNOWN)))


@dataclass(frozen=True, eq=False)
class _Part:
    """A window by cells, each (rows, columns)."""

    territory: np.ndarray
    """bool: whose nearest seam is the run."""
    from_run: np.ndarray
    """float32: pixels from the old seam."""
    from_any: np.ndarray
    """float32: pixels from the nearest seam."""
    flipped: np.ndarray
    """bool: between the old seam and the new cut."""
    on_left: np.ndarray
    """bool: what is on the left hand of the new cut."""

    def weight(self, blend_px: int) -> np.ndarray:
        """Of the left image, by pixels, (rows, columns) float32, 0 to 1."""
        sides = np.where(self.on_left, np.float32(1), np.float32(-1))
        left = (_zoomed(ndimage.gaussian_filter(sides, _SMOOTH_CELLS, mode="nearest")) > 0).astype(np.float32)
        return np.clip(ndimage.uniform_filter(left, blend_px, mode="nearest"), 0, 1) if blend_px > 1 else left

    def patch(self, reach: float) -> np.ndarray:
        """bool: what is made anew, where the mosaic is mixed up to ``reach`` px from the old seam."""
        from_cut = CELL_PX * ndimage.distance_transform_edt(~near_border(self.on_left.view(np.uint8), 1))
        near = (self.from_run <= reach) | (from_cut <= EASED_PX) | widened(self.flipped, 2)
        return self.territory & near

    def fade(self, inside: np.ndarray) -> np.ndarray:
        """By pixels, (rows, columns) float32: from 0 at the rim of a patch to 1."""
        return _zoomed(np.clip(ndimage.distance_transform_edt(inside) / _RIM_CELLS, 0, 1).astype(np.float32))


def _part(request: RunRequest, window: PixelWindow, line: np.ndarray, way: np.ndarray) -> _Part:
    any_near = _beside(request.index, window)
    own = _beside(PieceIndex([request.run.piece], request.mosaic.grid), window)
    ring = ogr.Geometry(ogr.wkbLinearRing)
    for column, row in np.concatenate([line, way[::-1], line[:1]]).tolist():
        ring.AddPoint_2D(column / CELL_PX, -row / CELL_PX)
    between = ogr.Geometry(ogr.wkbPolygon)
    between.AddGeometry(ring)
    cells = PixelWindow(*(side // CELL_PX for side in (window.column, window.row, window.width, window.height)))
    flipped = burnt([(between, 1)], Grid(0, 0, 1, 1, 1, 1), cells) == 1
    return _Part(
        np.isin(any_near.number, request.run.numbers), own.distance_px, any_near.distance_px, flipped,
        own.on_left ^ flipped,
    )


def _mixed_reach(ground: JudgedGround, part: _Part) -> float:
    """How far from the old seam the mosaic is not what its sources make it, px: there they leave over more of its fine
    detail than farther off."""
    own, expected = high_pass(ground.mosaic.plane), high_pass(ground.expected.plane)
    known = (ground.expected.labels != UNKNOWN).astype(np.float32)
    left, energy = (in_squares(known * np.square(one), CELL_PX).sum(axis=(1, 3)) for one in (own - expected, expected))
    step = _BIN_CELLS * CELL_PX
    bins = np.minimum(part.from_run // step, MOST_BESIDE_PX // step + 2).astype(int)
    count, own_cells = MOST_BESIDE_PX // step, part.territory
    sums = [np.bincount(bins[own_cells], one[own_cells], count + 3) for one in (left, energy)]
    share = sums[0] / np.maximum(sums[1], _LEAST_LEFT)
    mixed = share[:count] > np.maximum(_AS_ELSEWHERE * share[count:].max(), _LEAST_LEFT)
    return float(step * (len(mixed) if mixed.all() else mixed.argmin()) + _BESIDE_PX)


def _around(points: np.ndarray, margin: float) -> PixelWindow:
    """Whole squares around columns and rows (n, 2)."""
    first = np.floor((points.min(axis=0) - margin) / SQUARE_PX).astype(int) * SQUARE_PX
    last = np.ceil((points.max(axis=0) + margin) / SQUARE_PX).astype(int) * SQUARE_PX
    return PixelWindow(*first.tolist(), *(last - first).tolist())


def _beside(index: PieceIndex, window: PixelWindow) -> NearestPieces:
    """Where the middles of its cells lie beside the pieces, (rows, columns) each: near by exactly, farther off as the
    nearest cell of those, which takes a tenth of the time."""
    columns, rows = (
        first + np.arange(CELL_PX / 2, length, CELL_PX)
        for first, length in ((window.column, window.width), (window.row, window.height))
    )
    near = index.beside(columns, rows[:, np.newaxis], _EXACT_PX)
    off, places = ndimage.distance_transform_edt(near.number < 0, return_indices=True)
    number, distance, on_left, station = (
        one[tuple(places)] for one in (near.number, near.distance_px, near.on_left, near.station_m)
    )
    return NearestPieces(number, distance + CELL_PX * off, on_left, station)


def _zoomed(cells: np.ndarray) -> np.ndarray:
    """Linear between the middles of cells, by pixels."""
    return np.asarray(ndimage.zoom(cells, CELL_PX, order=1, mode="nearest", grid_mode=True))


def _of_type(pixels: np.ndarray, dtype: np.dtype) -> np.ndarray:
    if dtype.kind == "f":
        return pixels.astype(dtype)
    ends = np.iinfo(dtype)
    return np.clip(np.rint(pixels), ends.min, ends.max).astype(dtype)


def _cropped(pixels: np.ndarray, window: PixelWindow) -> tuple[tuple[slice, slice], PixelWindow]:
    """Rows and columns in which any pixel is, in the window and as one of its own."""
    rows, columns = (np.flatnonzero(pixels.any(axis=axis)) for axis in (1, 0))
    down, across = (slice(int(one[0]), int(one[-1]) + 1) for one in (rows, columns))
    width, height = across.stop - across.start, down.stop - down.start
    return (down, across), PixelWindow(window.column + across.start, window.row + down.start, width, height)
