"""The statistics of an image, or of a window of it, before they are held against a range or a rule."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Callable

from ...imagery.grids import PixelWindow
from ...imagery.lines import Seam
from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import Raster
from . import rules as checks
from .areas import Areas, GreyArea, GreyTone, grey_tones
from .image_statistics import Histogram, LargestValue, can_count, largest_value, own_range, stream_statistics
from .rules import LUMINOSITY, RuleSet
from .seam_steps import SeamStep, seam_steps

MIN_STATISTICS_PIXELS = 4096  # 64 x 64: a histogram of fewer is no picture of an image


@dataclass(frozen=True, eq=False)
class MeasuredImage:
    image: Raster
    window_id: int | None  # None for the whole image
    seams: tuple[SeamStep, ...] | None = None  # with the bands of ``areas``; None without seamlines
    grey: tuple[GreyTone, ...] | None = None  # empty where no grey area lies on the image; None where none were given
    bands: tuple[str, ...] = ()  # of areas and seams: the image's, and luminosity where a rule asks for it
    histograms: Mapping[str, Histogram] = field(default_factory=dict)  # by band name, and luminosity; empty without
    areas: Areas | None = None  # None where the values can't be counted

    @property
    def pixels(self) -> int:
        return min((histogram.pixels for histogram in self.histograms.values()), default=0)

    @property
    def largest(self) -> float:
        """The largest value of any band; where only luminosity was counted, of that."""
        return max(histogram.largest for histogram in self.histograms.values())

    @property
    def largest_value(self) -> LargestValue | None:
        """The largest value, to find the range of the set; None where it is of no use for that."""
        is_open = self.image.data_type == "uint16" and self.pixels > 0
        return largest_value(self.histograms.values()) if is_open else None

    def trimmed(self) -> MeasuredImage:
        """A copy in little memory, to wait for the other images of the set."""
        return replace(self, histograms={name: histogram.trimmed() for name, histogram in self.histograms.items()})


def measure(
    source: OpenRaster, window: PixelWindow, rules: RuleSet, seams: Sequence[Seam] | None = None,
    grey_areas: Sequence[GreyArea] | None = None, window_id: int | None = None,
    progress: Callable[[float], bool] = lambda share: True,
) -> MeasuredImage | None:
    """Stream a window of an image (all of it: ``image.whole``) for what rules ask of it.

    ``seams`` and ``grey_areas`` in its reference system; None for what users gave no layer of. ``progress`` is told the
    share that is done and ends the work by returning False: then there is no result.

    Raises RasterError when the pixels can't be read.
    """
    image = source.raster
    if not can_count(image, rules.value_range):
        return MeasuredImage(image, window_id)
    counted, looked_at = _wanted(image, rules, seams is not None)
    statistics = stream_statistics(source, window, counted, looked_at, rules.value_range, progress)
    if statistics is None:
        return None
    steps = None if seams is None else tuple(seam_steps(source, window, seams, looked_at))
    grey = None
    if grey_areas is not None and image.has_luminance:
        grey = grey_tones(source, window, grey_areas) if image.is_north_up else ()
    return MeasuredImage(image, window_id, steps, grey, looked_at, *statistics)


def _wanted(image: Raster, rules: RuleSet, has_seams: bool) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Histograms of what the rules hold against limits; of all bands where their largest value has to be known, for
    the step at seams and for a range that only pixels can tell. Areas of all bands."""
    names = image.band_names
    mixed = (LUMINOSITY,) if image.has_luminance or len(names) == 1 else ()
    by_histogram, others = set[str](), set[str]()
    for rule in rules.rules:
        (by_histogram if rule.check in checks.FROM_HISTOGRAM else others).update(rule.bands_of(names))
    if has_seams or own_range(image, rules.value_range) is None:
        by_histogram.update(names)
    shown = mixed if LUMINOSITY in by_histogram else ()
    counted = (*shown, *(name for name in names if name in by_histogram)) or mixed or names
    return counted, (*names, *(mixed if LUMINOSITY in others else ()))
