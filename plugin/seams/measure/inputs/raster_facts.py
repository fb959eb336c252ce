"""Rasters of a project that may be sources, by their headers."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ....imagery.errors import Message
from ....imagery.grids import Extent, covered_share, extents_meet
from .. import messages

MOST_LARGER = 1.25  # pixel size over the mosaic's: nobody makes detail that the source does not have
MOST_SMALLER = 4.0  # the mosaic's pixel size over a source's
COLOURS = 3  # bands: rasters of fewer are grey
RIVAL_AREA = 0.8  # of the likely mosaic's: another one as large may be the mosaic as well
MOST_MOSAICS = 5  # the largest rasters, one of which may be the mosaic
SAME_PLACE = 0.9  # of a rectangle, that another one covers nearly


@dataclass(frozen=True)
class RasterFacts:
    """What is known of a raster before its pixels are read, seen from the mosaic."""

    key: str
    """What it is called where the question comes from, such as a layer's id."""
    name: str
    """What the operator calls it."""
    extent: Extent | None
    """In the mosaic's reference system; None where it has no place there."""
    pixel_size: float
    """Side of a pixel in the mosaic's units, about."""
    bands: int
    """Bands of measurements: no alpha, and three for a palette."""
    pixel_type: str
    """In words, such as ``8 bit``."""
    has_mosaic_system: bool
    """Whether its coordinates are the mosaic's."""
    is_mosaic: bool = False
    """Whether it is the mosaic's file."""


def suitable_by_header(mosaic: RasterFacts, rasters: Sequence[RasterFacts]) -> dict[str, Message | None]:
    """Why each raster, by its key, is not taken for a source as long as the operator does not say otherwise; None for
    one that is.

    Other systems and other types of pixels are left out only where there are as many rasters or more that share the
    mosaic's, since all of the sources of a mosaic may have been converted; one that covers the mosaic where fewer than
    half of the others do, for it is rather a copy of it, another mosaic or a map.
    """
    unsuitable = {raster.key: reason for raster in rasters if (reason := _unfit(mosaic, raster)) is not None}
    fit = [raster for raster in rasters if raster.key not in unsuitable]
    for group, reasons in (
        ([raster.has_mosaic_system for raster in fit], {raster.key: messages.OTHER_SYSTEM() for raster in fit}),
        ([raster.pixel_type == mosaic.pixel_type for raster in fit], {
            raster.key: messages.OTHER_TYPE(own=raster.pixel_type, mosaic=mosaic.pixel_type) for raster in fit
        }),
    ):
        if 2 * sum(group) >= len(group):
            unsuitable |= {raster.key: reasons[raster.key] for raster, shares in zip(fit, group) if not shares}
    suitable = [raster for raster in rasters if raster.key not in unsuitable]
    covering = [raster.key for raster in suitable if covers(mosaic, raster)]
    if 2 * len(covering) < len(suitable):
        unsuitable |= dict.fromkeys(covering, messages.COVERS_MOSAIC())
    return {raster.key: unsuitable.get(raster.key) for raster in rasters}


def covers(mosaic: RasterFacts, raster: RasterFacts) -> bool:
    """Whether a raster covers the mosaic, or nearly."""
    return bool(mosaic.extent and raster.extent and covered_share(mosaic.extent, raster.extent) >= SAME_PLACE)


def likely_mosaic(rasters: Sequence[RasterFacts]) -> str | None:
    """The key of the raster that others are suitable sources of, if none of its size is; all in one system.

    Sources that overlap much look like sources of each other, but none of them is nearly as large as the mosaic.
    """
    largest = sorted(rasters, key=_area, reverse=True)[:MOST_MOSAICS]
    likely = [raster for raster in largest if _has_sources(raster, rasters)]
    if not likely or (len(likely) > 1 and _area(likely[1]) > RIVAL_AREA * _area(likely[0])):
        return None
    return likely[0].key


def _has_sources(mosaic: RasterFacts, rasters: Sequence[RasterFacts]) -> bool:
    """Whether there are two sources of its pixel size, smaller than it, that lie in it but for their margins."""
    others = [raster for raster in rasters if raster.key != mosaic.key]
    reasons = suitable_by_header(mosaic, others)
    sources = [
        raster for raster in others if reasons[raster.key] is None and raster.extent and mosaic.extent
        and not covers(mosaic, raster) and covered_share(raster.extent, mosaic.extent) > 0.5
        and raster.pixel_size * MOST_LARGER >= mosaic.pixel_size
    ]
    return len(sources) >= 2 and _area(mosaic) > max(map(_area, sources))


def _unfit(mosaic: RasterFacts, raster: RasterFacts) -> Message | None:
    if raster.is_mosaic:
        return messages.IS_THE_MOSAIC()
    if raster.extent is None or mosaic.extent is None or not extents_meet(raster.extent, mosaic.extent):
        return messages.APART_FROM_MOSAIC()
    if (raster.bands >= COLOURS) != (mosaic.bands >= COLOURS):
        return messages.OTHER_BANDS(bands=raster.bands, mosaic=mosaic.bands)
    factor = raster.pixel_size / mosaic.pixel_size
    if factor > MOST_LARGER:
        return messages.LARGER_PIXELS(factor=factor)
    return messages.SMALLER_PIXELS(factor=1 / factor) if factor < 1 / MOST_SMALLER else None


def _area(raster: RasterFacts) -> float:
    xmin, ymin, xmax, ymax = raster.extent or (0.0, 0.0, 0.0, 0.0)
    return (xmax - xmin) * (ymax - ymin)
