"""The mosaic in its orthoimages, mixed into them along seams: it would hide what was lost there.

Two exposures a, b have detail of their own: where both are as sharp <a - b, a + b> is 0, however alike they are. An
orthoimage into which a share t of the mosaic was mixed holds t of the other one beyond the seam, where the mosaic shows
that, and lost detail by it: there <b - a, a + b> / <a - b, a - b> is t / (1 - t). On this side it is so with a and b
changed, and within a feather, too. No honest orthoimage loses sharpness where a seam happens to lie.
"""
from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from functools import lru_cache

import numpy as np
from scipy import ndimage

from ....imagery.clips import Clip, read_clip
from ....imagery.errors import Message, RasterError
from ....imagery.grids import Grid, PixelWindow
from ....imagery.open_raster import OpenRaster
from ....imagery.raster_pool import KEPT_OPEN
from ....imagery.rasters import Raster, RasterRef
from ....imagery.statistics import NORMAL_95
from ....imagery.wavelets import detail_components
from .. import messages
from ..following.boxes import in_squares
from ..seamlines.seam_pieces import PieceIndex, SeamPiece, around_pieces

_BANDS_PX = ((6, 24), (24, 48))  # from a seam, where sharpness is compared: far off it changes as a lens makes it
_CELL_PX, _STATION_PX = 8, 64  # of sums, and along the seam: what lies farther apart is other ground
_LEAST_ENERGY = 100.0  # <a, a> + <b, b> of a cell: rounding alone makes 8 of whole numbers
_FEWEST_CELLS = 8  # on either side of a piece
_PLACE, _FEWEST = 6, 5  # stations that are looked at together, and of them those with detail on both sides
LEAST_MIXED = 0.2
"""t / (1 - t) at the lower end of its 95 % interval. Honest pairs have 0.15 at most (Brighton, PackO, a photograph with
other noise; lossless, JPEG 60 to 90, resampled)."""
LEAST_MIXED_IN_ONE, MOST_ALIKE = 0.05, 0.5
"""Likewise where it was mixed into one of the two, and both are alike on one side: <a - b, a - b> of <a, a> + <b, b>
there, of that on the other. Brighton, 60 to 70 % mixed in along 12 to 40 m: 0.11 and more with 0.38 and less; honest
pairs that are so much alike on one side, of generated ground, have at most 0.01."""
_MORE_APART = 0.1  # than images that are nothing alike, by chance
LEAST_APART, LEAST_OF_APART = 0.02, 0.2
"""<a - b, a - b> of <a, a> + <b, b>, and of that on the other side or in the other band: honest pairs have 0.09 and
0.58 or more."""


def mixed_images(
    mosaic: Raster, sources: Mapping[str, RasterRef], pieces: Iterable[tuple[str, str, SeamPiece]]
) -> tuple[list[Message], dict[str, str]]:
    """What is told of orthoimages that hold the mosaic along the seams between them, and what layers say of them:
    ``mixed_sources``, ``mixed_metres`` of these seams, and a place on the longest piece, ``mixed_at``.

    ``sources``: all orthoimages by their names; ``pieces``: with the names of those on their left and their right.
    """
    opened, reach = lru_cache(KEPT_OPEN)(OpenRaster), _BANDS_PX[-1][1]
    by_pair: dict[tuple[str, str], list[tuple[SeamPiece, np.ndarray]]] = defaultdict(list)
    for left, right, piece in pieces:
        first, second = sorted((left, right))
        around = around_pieces([piece], mosaic.grid, reach)
        if left != right and left in sources and right in sources:
            with suppress(RasterError):  # the scan says so where it needs it
                clips = [read_clip(opened(sources[name]), mosaic, around, partly=True) for name in (first, second)]
                energies = _energies(clips, around, piece, mosaic.grid)[:, :, :: 1 if left == first else -1]
                by_pair[first, second].append((piece, energies))
    shares = {pair: _mixed(np.concatenate([part for _, part in parts], axis=1)) for pair, parts in by_pair.items()}
    if not (names := sorted({name for pair, share in shares.items() if share for name in pair})):
        return [], {}
    beside = [piece for pair, measured in by_pair.items() if shares[pair] for piece, _ in measured]
    length, (x, y) = math.fsum(piece.length_m for piece in beside), max(beside, key=lambda piece: piece.length_m).middle
    listed, share = ", ".join(names), max(shares.values())
    notice = messages.MOSAIC_MIXED_IN(names=listed, metres=length, share=100 * share, x=x, y=y)
    return [notice], {"mixed_sources": listed, "mixed_metres": f"{length:.1f}", "mixed_at": f"{x:.10g} {y:.10g}"}


def _mixed(energies: np.ndarray) -> float:
    """How much of the mosaic two orthoimages hold somewhere, by their ``_energies`` beside all pieces between them."""
    (aa, bb), (other_aa, other_bb) = np.moveaxis(energies.sum(axis=1), 0, -1)[:, :2]
    gains = (aa * other_aa / np.maximum(bb * other_bb, np.finfo(float).tiny)) ** 0.25  # both as sharp over both sides
    share, stations = 0.0, energies.shape[1]
    for first in range(0, max(stations - _PLACE, 0) + _PLACE // 3, _PLACE // 3):
        differing = []
        for band, gain in zip(energies[:, first : first + _PLACE], gains):
            band = band[band[..., :2].all(axis=(1, 2))]
            if len(band) < _FEWEST:
                continue
            aa, bb, ab = np.moveaxis(band, 2, 0) / np.array([gain, 1 / gain, 1])[:, np.newaxis, np.newaxis]
            sides = (aa + bb - 2 * ab).sum(axis=0) / (aa + bb).sum(axis=0)
            differing += sides.tolist()
            lost, apart = (aa - bb) @ [1, -1], (aa + bb - 2 * ab).sum(axis=1)
            ratio = lost.sum() / max(apart.sum(), np.finfo(float).tiny)
            within = NORMAL_95 * math.hypot(*(lost - ratio * apart)) / max(apart.sum(), np.finfo(float).tiny)
            mixed = ratio / (1 + ratio)
            most = 2 * (1 - mixed) ** 2 / (1 + (1 - mixed) ** 2 + mixed**2)  # of images that are nothing alike
            if ratio - within > LEAST_MIXED and apart.sum() < (most + _MORE_APART) * (aa + bb).sum():
                share = max(share, float(mixed))
            if ratio - within > LEAST_MIXED_IN_ONE and sides.min() < MOST_ALIKE * sides.max():
                share = max(share, float(1 - sides.min() / sides.max()))
        if not share and differing and min(differing) < max(LEAST_APART, LEAST_OF_APART * max(differing)):
            share = 1.0
    return share


def _energies(clips: Sequence[Clip], around: PixelWindow, piece: SeamPiece, grid: Grid) -> np.ndarray:
    """(bands, stations, 2, 3): <a, a>, <b, b> and <a, b> of two clips' finest detail on the left and the right of the
    piece that they lie ``around``; all cells weigh alike, how much detail they have. 0 where too few have pixels of
    both."""
    partly = [clip.valid for clip in clips if clip.valid is not None]
    valid = np.all(partly or [np.ones(clips[0].bands.shape[1:], bool)], axis=0)
    # Beside what has no pixels JPEG rings.
    inside = ndimage.minimum_filter(in_squares(valid, _CELL_PX).all(axis=(1, 3)), 3, mode="nearest")
    down, across = np.nonzero(inside)
    columns, rows = around.column + _CELL_PX * (across + 0.5), around.row + _CELL_PX * (down + 0.5)
    beside = PieceIndex([piece], grid).beside(columns, rows, _BANDS_PX[-1][1])
    station_m, station_px = beside.station_m - piece.station_m, _STATION_PX * grid.ground_sample_distance
    is_within = (station_m > 0) & (station_m < piece.length_m)
    a, b = map(_detail, clips)
    products = (in_squares((x * y).sum(axis=0), _CELL_PX // 2) for x, y in ((a, a), (b, b), (a, b)))
    energy = np.stack([product.sum(axis=(1, 3))[inside] for product in products], axis=1)
    sums = np.zeros((len(_BANDS_PX), int(piece.length_m / station_px) + 1, 2, 3))
    for band, (near, far) in zip(sums, _BANDS_PX):
        is_used = is_within & (near <= beside.distance_px) & (beside.distance_px < far)
        is_used &= energy[:, :2].sum(axis=1) > _LEAST_ENERGY
        is_right, used = ~beside.on_left[is_used], energy[is_used]
        if min(np.count_nonzero(is_right), np.count_nonzero(~is_right)) >= _FEWEST_CELLS:
            weight = 1 / (used[:, :2].sum(axis=1) + used[:, :2].mean() / 2 + np.finfo(float).tiny)
            place = (station_m[is_used] / station_px).astype(int), is_right.astype(int)
            np.add.at(band, place, used * weight[:, np.newaxis])
    return sums


def _detail(clip: Clip) -> np.ndarray:
    """The three finest details of a clip's grey values, by Haar's wavelet: those of a sharp edge stay in their cell."""
    grey = clip.bands[: 3 if clip.raster.has_luminance else 1].mean(axis=0, dtype=np.float64)
    rows, columns = (size // 2 * 2 for size in grey.shape)
    return next(detail_components(grey[np.newaxis, :rows, :columns], "haar", 1))[:, 0]
