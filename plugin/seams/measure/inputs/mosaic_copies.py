"""Copies of a mosaic among its sources: they would explain all of it, and hide every loss.

A copy has pixels wherever the mosaic has, is like it in every place, and other sources are like it too, each in some
places. No true orthoimage is all of that; what is some of it takes part, and is told. So is an image that others
explain wherever it lies, with less detail than they have: a blurred mosaic, or a mean of orthoimages.
"""
from __future__ import annotations

import os
from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from ....imagery.clips import read_clip
from ....imagery.errors import Message, RasterError, SettingsError
from ....imagery.gdal_paths import vrt_parts
from ....imagery.grids import PixelWindow, covered_share
from ....imagery.open_raster import OpenRaster
from ....imagery.raster_pool import KEPT_OPEN
from ....imagery.rasters import Raster, RasterRef
from .. import messages
from ..following.boxes import in_squares
from ..source_images import Footprints, Source, even_places, is_same_file

SIDE_PX = 64  # of a patch that is compared
PLACES, FEWEST_PLACES = 12, 4  # along each side of the mosaic
FEWEST = 4  # patches, without which nothing is said
LEAST_COVER = 0.1  # of the mosaic, by a raster's rectangle: a copy may leave out empty ground, or be one of a part
AVERAGED_PX = 3  # along each side, of the raster's own size: that takes away most of what compression did
MOST_AVERAGED_PX = 6  # of the mosaic: an overview of larger pixels than twice its own shows little of what seams lose
LEAST_SHARED = 0.9  # of a patch, where both have pixels
MOST_MISSING = 0.05  # of a patch, where the mosaic has pixels and a copy has none: edges of resampled collars
# Shares of the mosaic's detail. Brighton: copies by JPEG 75 lack up to 0.05, by JPEG 50 0.11, overviews by 2 0.07.
MOST_LACKING = 0.08
LEAST_UNLIKE = 0.25  # Brighton: all orthoimages lack more somewhere, by 0.96 and more
ROUNDING = 0.0005  # is lacking where values were scaled
# Share of an image's detail that 3 x 3 px of the others explain. Brighton and PackO, lossless or JPEG 75: of a mosaic
# blurred by 0.7 to 3 px, or a mean, 0.85 in nine places of ten, of an orthoimage less than 0.25 in one of ten.
LEAST_EXPLAINED = 0.9
MOST_ELSEWHERE = 0.15  # of the places, that a thing of others may be unlike them, as where one of them is not given
FEWEST_EXPLAINED = 8  # places
MOST_OTHERS = 6  # images that explain one at a place, those most alike
MOST_FOLLOWED = 0.2  # of the places, where the mosaic is likest to a thing of others: feathers of 64 px and more
LEAST_SHARP = 0.95  # of the others' fine detail by their coarser: an image that is given twice hides nothing
LEAST_SHOWN = 0.5  # of the places, by other images. Brighton: 0.7 and more of a mosaic, 0.2 of a single orthoimage


def leave_out_copies(mosaic: Raster, sources: Sequence[Source]) -> tuple[list[Source], list[Message]]:
    """The sources without copies, overviews and VRTs of the mosaic, and what to tell of those and of doubtful ones.

    Those on a tenth of the mosaic or more are opened and compared with it in up to 72 places; others where one of
    these is like it. Raises SettingsError where all are copies, or parts of the only image that it was made of.
    """
    on_mosaic = [n for n, source in enumerate(sources) if covered_share(mosaic.extent, source.extent) >= LEAST_COVER]
    parts = {n: vrt_parts(path) if os.path.isfile(path := sources[n].ref.path) else () for n in on_mosaic}
    copies = [n for n in on_mosaic if any(is_same_file(RasterRef(part), mosaic.ref) for part in parts[n])]
    doubtful: dict[int, Message] = {}
    if candidates := [n for n in on_mosaic if n not in copies]:
        comparison = _Comparison(mosaic, sources)
        alike = [*filter(comparison.is_alike, candidates)]
        if len(alike) == len(sources) and comparison.overlap(alike):
            raise SettingsError(messages.ALL_ARE_COPIES(count=len(sources)))
        for n in alike:
            is_whole, is_shown, name = comparison.is_whole(n), comparison.is_shown_by_others(n), sources[n].ref.name
            if is_whole and is_shown:
                copies.append(n)
            elif (is_whole or is_shown) and comparison.is_alike(n, ROUNDING):
                doubtful[n] = messages.MAY_BE_COPY(name=name)  # as an orthoimage of the mosaic may be, or a part of it
            elif is_whole or is_shown:
                doubtful[n] = messages.MAY_BE_ALTERED_COPY(name=name)
        others = {n for n in range(len(sources)) if n not in copies}
        while soft := [
            (sharpness, n) for n in candidates if n in others
            and (sharpness := comparison.sharpness(n, others - {n})) is not None and sharpness < LEAST_SHARP
        ]:
            softest = min(soft)[1]
            others.remove(softest)  # which does not explain what it was made of
            doubtful[softest] = messages.MADE_OF_OTHERS(name=sources[softest].ref.name)
    kept = [replace(source, may_be_copy=n in doubtful) for n, source in enumerate(sources) if n not in copies]
    return kept, [*(messages.COPY_AMONG_SOURCES(name=sources[n].ref.name) for n in copies), *doubtful.values()]


@dataclass(frozen=True, eq=False)
class _Patch:
    """A part of the mosaic's first band, or of another raster's where that lies."""

    values: np.ndarray
    """(rows, columns) float64."""
    valid: np.ndarray
    """(rows, columns) bool."""

    def averaged(self, side: int) -> _Patch:
        """In squares of so many pixels along each side, those that are wholly valid."""
        values, valid = np.where(self.valid, self.values, 0), self.valid
        return _Patch(in_squares(values, side).mean(axis=(1, 3)), in_squares(valid, side).all(axis=(1, 3)))

    def differences(self, where: np.ndarray) -> np.ndarray:
        """Differences between neighbours that both lie in (rows, columns) bool."""
        with np.errstate(invalid="ignore", over="ignore"):  # of infinite values, which are like nothing
            across, down = np.diff(self.values, axis=1), np.diff(self.values, axis=0)
        return np.concatenate([across[where[:, 1:] & where[:, :-1]], down[where[1:] & where[:-1]]])


def _explained(patch: _Patch, others: Sequence[_Patch]) -> float:
    """Share of a patch's detail that neighbourhoods of 3 x 3 px in others explain; nan where few pixels are in all."""
    inner = (slice(1, -1),) * 2
    near = [sliding_window_view(other.values, (3, 3)).reshape(*other.values[inner].shape, 9) for other in others]
    both = patch.valid[inner] & np.all(
        [sliding_window_view(other.valid, (3, 3)).all(axis=(2, 3)) for other in others], axis=0
    )
    detail = _Patch(patch.values[inner], both).differences(both)
    if both.mean() < LEAST_SHARED or not detail.any() or not np.isfinite(detail).all():
        return np.nan
    taps = np.stack([
        _Patch(plane, both).differences(both) for planes in near for plane in np.moveaxis(planes, 2, 0)
    ], axis=1)  # fmt: skip
    if not np.isfinite(taps).all():
        return np.nan
    remainder = detail - taps @ np.linalg.lstsq(taps, detail, rcond=None)[0]
    pixels = len(detail) / 2  # which have two differences each
    return float(1 - (remainder @ remainder) / (detail @ detail) * pixels / max(pixels - taps.shape[1], 1))


def _energy(patch: _Patch) -> float:
    """Energy of a patch's detail, of a pixel."""
    detail = patch.differences(patch.valid)
    return float(np.mean(detail**2)) if len(detail) else 0.0


def _lacking(mosaic: _Patch, source: _Patch) -> float:
    """Share of the detail of the mosaic that a source does not show; nan where too few pixels are in both."""
    both = mosaic.valid & source.valid
    if both.mean() < LEAST_SHARED:
        return np.nan
    a, b = mosaic.differences(both), source.differences(both)
    like = a @ b / np.sqrt((a @ a) * (b @ b)) if (a @ a) * (b @ b) > 0 else 0.0
    return 1 - max(float(like), 0.0) ** 2


class _Comparison:
    """A mosaic and what its sources lack of it, in the one of every two patches that has more detail."""

    def __init__(self, mosaic: Raster, sources: Sequence[Source]) -> None:
        self._mosaic, self._sources, self._opened = mosaic, sources, lru_cache(KEPT_OPEN)(OpenRaster)
        # No cached methods: they would hold the comparison, and with it the open rasters, until garbage is collected.
        self._patches: dict[tuple[int, int], _Patch | None] = {}
        self._compared_places: dict[tuple[int, int], tuple[float, float]] = {}
        patches = []
        counts = [min(max(size // SIDE_PX, FEWEST_PLACES), PLACES) for size in (mosaic.rows, mosaic.columns)]
        for window in even_places(mosaic.whole, SIDE_PX, (counts[0], counts[1])):
            with suppress(RasterError):
                patch = self._read(mosaic.ref, window)
                coarse = patch.averaged(AVERAGED_PX)
                differences = coarse.differences(coarse.valid)
                if (detail := float(differences @ differences)) > 0 and coarse.valid.mean() >= LEAST_SHARED:
                    patches.append((detail, window, patch))
        richer = (max(patches[k : k + 2], key=lambda patch: patch[0]) for k in range(0, len(patches), 2))
        self._places = [(window, patch) for _, window, patch in richer]
        footprints = Footprints(sources)
        self._over = [set(footprints.meeting(mosaic.grid.window_extent(window))) for window, _ in self._places]

    def is_alike(self, number: int, most_lacking: float = MOST_LACKING) -> bool:
        """Whether a source is like the mosaic wherever both have pixels."""
        count = 0
        for lacking in self._lacking(number):
            if lacking > most_lacking:
                return False
            count += not np.isnan(lacking)
        return count >= FEWEST

    def overlap(self, numbers: Collection[int]) -> bool:
        """Whether two of some sources or more have pixels in enough places."""
        known = np.array([[not np.isnan(lacking) for lacking in self._lacking(number)] for number in numbers])
        return np.count_nonzero(known.sum(axis=0) > 1) >= FEWEST

    def is_whole(self, number: int) -> bool:
        """Whether a source has pixels wherever the mosaic has."""
        return all(self._compared(number, k)[1] <= MOST_MISSING for k in range(len(self._places)))

    def is_shown_by_others(self, number: int) -> bool:
        """Whether other images of the ground are like the mosaic in half of the places of a source."""
        places = [k for k, lacking in enumerate(self._lacking(number)) if not np.isnan(lacking)]
        shown = sum(
            any(self._compared(n, k)[0] <= MOST_LACKING and self._is_another(n) for n in self._over[k]) for k in places
        )
        return shown >= LEAST_SHOWN * len(places)

    def sharpness(self, number: int, others: Collection[int]) -> float | None:
        """Fine detail of a source that others explain nearly wherever it lies, as a share of that of those most like
        it; None for one that shows what they don't, or that the mosaic was made from."""
        places = [k for k, over in enumerate(self._over) if number in over and over & {*others}]
        detail, alone, missed, likest_of_all = [], Counter[int](), 0, 0
        for k in places:
            patch = self._patch(number, k)
            if patch is None:
                continue
            coarse, shown = patch.averaged(AVERAGED_PX), self._places[k][1]
            seen = {n: other for n in sorted(self._over[k] & {*others}) if (other := self._patch(n, k)) is not None}
            averaged = {n: other.averaged(AVERAGED_PX) for n, other in seen.items()}
            lacking = {n: _lacking(coarse, other) for n, other in averaged.items()}
            likest = sorted((n for n in seen if not np.isnan(lacking[n])), key=lambda n: lacking[n])[:MOST_OTHERS]
            theirs = [lacks for other in seen.values() if not np.isnan(lacks := _lacking(shown, other))]
            likest_of_all += _lacking(shown, patch) < min(theirs, default=1.0)
            explained = _explained(coarse, [averaged[n] for n in likest]) if likest else np.nan
            missed += explained < LEAST_EXPLAINED
            if missed > MOST_ELSEWHERE * len(places) or likest_of_all > MOST_FOLLOWED * len(places):
                return None
            if not np.isnan(explained):
                first = likest[0]
                detail.append(list(map(_energy, (patch, coarse, seen[first], averaged[first]))))
                alone[first] += _explained(coarse, [averaged[first]]) >= LEAST_EXPLAINED
        if len(detail) < FEWEST_EXPLAINED or missed > MOST_ELSEWHERE * len(detail):
            return None
        if max(alone.values()) >= (1 - MOST_ELSEWHERE) * len(detail):
            return None  # another image given twice, as in a second system
        fine, coarse_sum, their_fine, their_coarse = np.sum(detail, axis=0).tolist()
        return fine * their_coarse / (coarse_sum * their_fine) if coarse_sum * their_fine else None

    def _patch(self, number: int, k: int) -> _Patch | None:
        """A source at a place; None where it can't be read."""
        if (number, k) not in self._patches:
            self._patches[number, k] = None
            with suppress(RasterError):  # the scan says so where it needs it
                self._patches[number, k] = self._read(self._sources[number].ref, self._places[k][0])
        return self._patches[number, k]

    def _is_another(self, number: int) -> bool:
        """Whether a source is another image of the ground somewhere, or may be; what was made of the mosaic is not."""
        known = [lacking for lacking in self._lacking(number) if not np.isnan(lacking)]
        return len(known) < FEWEST or max(known) > LEAST_UNLIKE

    def _lacking(self, number: int) -> Iterator[float]:
        return (self._compared(number, k)[0] for k in range(len(self._places)))

    def _compared(self, number: int, k: int) -> tuple[float, float]:
        """What a source lacks of the mosaic at a place, nan where that can't be told, and the share of the place where
        the mosaic has pixels and it has none."""
        if (number, k) not in self._compared_places:
            source, patch = self._patch(number, k) if number in self._over[k] else None, self._places[k][1]
            lacking, missing = np.nan, 1.0
            if source is not None:
                size = self._opened(self._sources[number].ref).raster.ground_sample_distance
                side = AVERAGED_PX * max(round(size / self._mosaic.ground_sample_distance), 1)
                if side <= MOST_AVERAGED_PX:
                    lacking = _lacking(patch.averaged(side), source.averaged(side))
                missing = float((patch.valid & ~source.valid).mean())
            self._compared_places[number, k] = lacking, missing
        return self._compared_places[number, k]

    def _read(self, ref: RasterRef, window: PixelWindow) -> _Patch:
        clip = read_clip(self._opened(ref), self._mosaic, window, partly=True)
        valid = np.ones(clip.bands.shape[1:], bool) if clip.valid is None else clip.valid
        return _Patch(clip.bands[0].astype(np.float64), valid)
