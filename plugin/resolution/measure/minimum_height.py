"""The lowest flying height at which a sensor keeps to a ground resolved distance (Walczykowski et al. 2009)."""
from __future__ import annotations

import math
import statistics
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

from ...imagery.errors import Message, SettingsError
from . import messages

MIN_OBSERVATIONS = 5  # of the minimum height: the Open Skies treaty asks for five passes
MAX_HEIGHT_M, MIN_GRD_CM, MAX_GRD_CM = 1e6, 1e-3, 1e6  # from a microscope to a satellite
MAX_RESOLUTION_RAD = 0.05  # distance over height: thermal cameras of a few pixels keep to 0.01
MIN_RESOLUTION_RAD = 5e-6  # diffraction at an aperture of 13 cm: below it are telescopes
MAX_AIRCRAFT_HEIGHT_M = 1e5  # telescopes fly above it

Key = tuple[str, ...]


@dataclass(frozen=True)
class Observation:
    height_m: float  # flying height above the target, m
    grds_cm: tuple[float, ...]  # ground resolved distance as each observer read it, cm; at least one
    key: Key = ()  # what it is grouped by: sensor, type of image, direction

    @property
    def fault(self) -> Message | None:
        """The reason why it can't be used; None when it can."""
        for grd in self.grds_cm:
            if not 0 < self.height_m <= MAX_HEIGHT_M or not MIN_GRD_CM <= grd <= MAX_GRD_CM:
                return messages.OBSERVATION_IMPOSSIBLE(
                    height=self.height_m, grd=grd, highest=MAX_HEIGHT_M, least=MIN_GRD_CM, most=MAX_GRD_CM
                )
        return None

    def minimum_height(self, required_cm: float) -> float:
        """Height at which the distance would be the required one, m, the mean of its observers' (equations 1, 2)."""
        return statistics.fmean(self.heights_m(required_cm))

    def heights_m(self, required_cm: float) -> list[float]:
        """Heights of the required distance by each observer, m: height and distance grow alike."""
        return [self.height_m * (required_cm / grd) for grd in self.grds_cm]


@dataclass(frozen=True)
class HeightResult:
    """The minimum height from the passes of one group."""

    key: Key
    heights_m: tuple[float, ...]  # minimum height by each pass, m
    reference_m: float | None  # what it is compared with, m
    notice: Message | None  # what to know about it
    observers: int = 1  # how many readings the passes have together
    observer_spread_m: float | None = None  # of one observer within a pass; None where no pass has several

    @property
    def mean_m(self) -> float:
        return statistics.fmean(self.heights_m)

    @property
    def spread_m(self) -> float | None:
        """Standard deviation of one pass, m; None for a single one."""
        return statistics.stdev(self.heights_m) if len(self.heights_m) > 1 else None

    @property
    def tolerance_percent(self) -> float | None:
        """The mean's distance above the reference, %; None without one."""
        return None if self.reference_m is None else 100 * (self.mean_m - self.reference_m) / self.reference_m


References = Mapping[str, float]  # m, by a word of the groups' keys; under the empty word that of all others


def read_references(text: str) -> dict[str, float]:
    """Reference heights as they are typed: ``2714``, or ``DMC 2714; RC20 2015``. Raises SettingsError
    for words that are none, and for heights that no flight has."""
    heights = {}
    for part in filter(None, map(str.strip, text.split(";"))):
        name, _, word = part.rpartition(" ")
        try:
            height = heights[name.strip(" =:")] = float(word.replace(",", "."))
        except ValueError as error:
            raise SettingsError(messages.REFERENCE_HEIGHT_UNREADABLE(word=part)) from error
        if not 0 < height <= MAX_HEIGHT_M:
            raise SettingsError(messages.REFERENCE_HEIGHT_IMPOSSIBLE(height=height, highest=MAX_HEIGHT_M))
    return heights


def doubts(observations: Iterable[Observation]) -> list[Message]:
    """Warnings of distances that no camera resolves, as of columns or units mixed up: each once, for the first pass."""
    warnings: dict[str, Message] = {}
    for observation in observations:
        height = observation.height_m
        for grd in observation.grds_cm:
            resolution = grd / 100 / height
            if resolution > MAX_RESOLUTION_RAD:
                warnings.setdefault("coarse", messages.COLUMNS_INTERCHANGED(grd=grd, height=height))
            elif resolution < MIN_RESOLUTION_RAD and height <= MAX_AIRCRAFT_HEIGHT_M:
                warnings.setdefault("fine", messages.GRD_IN_METRES(grd=grd, height=height))
    return list(warnings.values())


def minimum_heights(
    observations: Iterable[Observation], required_cm: float, references: References = MappingProxyType({})
) -> list[HeightResult]:
    """The minimum height of every group of passes, in the order in which the groups first come.

    Raises SettingsError for a reference of a group that is not there.
    """
    groups: dict[Key, list[Observation]] = {}
    for observation in observations:
        groups.setdefault(observation.key, []).append(observation)
    words = dict.fromkeys(word for key in groups for word in key)
    for name in references:
        if name and name not in words:
            raise SettingsError(messages.REFERENCE_OF_NO_GROUP(name=name, known=", ".join(words)))

    def reference(key: Key) -> float | None:
        return next((references[word] for word in key if word and word in references), references.get(""))

    return [_result(key, passes, required_cm, reference(key)) for key, passes in groups.items()]


def _result(key: Key, passes: Sequence[Observation], required_cm: float, reference_m: float | None) -> HeightResult:
    notice = None
    if len(passes) < MIN_OBSERVATIONS:
        notice = messages.FEW_OBSERVATIONS(count=len(passes), least=MIN_OBSERVATIONS)
    several = [passage.heights_m(required_cm) for passage in passes]
    free = sum(len(heights) - 1 for heights in several)
    squares = sum((len(heights) - 1) * statistics.variance(heights) for heights in several if len(heights) > 1)
    means = tuple(map(statistics.fmean, several))
    spread = math.sqrt(squares / free) if free else None
    return HeightResult(key, means, reference_m, notice, sum(map(len, several)), spread)
