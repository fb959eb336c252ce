"""An image, or a window of it, against the rules: every figure with its limit, or why it can't be measured."""
from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Optional

from ...imagery.errors import Message
from ...imagery.rasters import Raster, ValueRange
from . import limits, messages
from . import rules as checks
from .areas import Areas, ColourBalance, MaybeGrey, colour_balance, find_maybe_grey, signal_to_noise
from .image_statistics import Histogram, ImageRange
from .measured_image import MIN_STATISTICS_PIXELS, MeasuredImage
from .rules import ACCEPTED, ALL_BANDS, LUMINOSITY, REJECTED, UNDECIDED, Rule, RuleSet
from .seam_steps import SeamStep


@dataclass(frozen=True)
class Spot:
    """The place that a figure comes from."""

    place: tuple[float, float]  # in the image's reference system
    what: Message  # what is there


@dataclass(frozen=True)
class CheckedFigure:
    band: str  # name of the band as in ``Image.band_names``, or ``luminosity`` or ``all``
    rule: Rule
    value: float | None  # shares are fractions of 1; None when it can't be measured
    passed: bool | None  # None when it can't be measured or the rule has no limit
    reason: Message | None = None  # why it can't be measured or judged
    spot: Spot | None = None  # place of the worst seam, or of the grey area with most colour
    is_applicable: bool = True  # False where an image has nothing of the kind, as one band has no colours

    @property
    def is_unknown(self) -> bool:
        """Whether it has a limit and can't be held against it."""
        return self.value is None and self.rule.has_limit and self.is_applicable

    @property
    def is_missed(self) -> bool:
        """Whether it would have to be known for an image to be accepted, and is not."""
        return self.is_unknown and self.rule.required


@dataclass(frozen=True, eq=False)
class Assessment:
    """An image, or a window of it, and what was found."""

    image: Raster
    window_id: int | None  # None for the whole image
    checked_figures: tuple[CheckedFigure, ...]
    available: ValueRange | None  # the range that shares are shares of; None where nobody says it
    histograms: Mapping[str, Histogram]  # by band name, and luminosity; empty when the values can't be counted
    seams: tuple[SeamStep, ...] = ()
    notices: tuple[Message, ...] = ()
    maybe_grey: MaybeGrey | None = None  # what may be grey, where no grey areas were given
    balance: ColourBalance | None = None  # colour balance by the grey areas that were given

    @property
    def pixels(self) -> int:
        return min((histogram.pixels for histogram in self.histograms.values()), default=0)

    def measured(self, check: str) -> list[CheckedFigure]:
        return [figure for figure in self.checked_figures if figure.rule.check == check and figure.value is not None]


_Found = tuple[float, Optional["Spot"]]  # a figure, and where it comes from


def judge(measured: MeasuredImage, rules: RuleSet, of_image: ImageRange) -> Assessment:
    """Hold what was measured of an image against the rules; ``of_image`` is its range of values.

    Without seamlines the rules on seams are left out. Without a range all that is a share of it is not measurable.
    """
    applied = [rule for rule in rules.rules if rule.check not in checks.AT_SEAMS or measured.seams is not None]
    pairs = [(rule, band) for rule in applied for band in rule.bands_of(measured.image.band_names)]
    available = None if isinstance(of_image, Message) else of_image
    if measured.areas is None or measured.pixels < MIN_STATISTICS_PIXELS:
        why = messages.TOO_FEW_VALID_PIXELS(count=measured.pixels, least=MIN_STATISTICS_PIXELS)
        if measured.areas is None:
            unknown = messages.NO_VALUE_RANGE(data_type=measured.image.data_type)
            why = of_image if isinstance(of_image, Message) else unknown
        figures = tuple(_checked(measured, rule, band, why) for rule, band in pairs)
        return Assessment(measured.image, measured.window_id, figures, None, measured.histograms)
    judged = _Judged(measured, measured.areas, of_image)
    figures = tuple(_checked(measured, rule, band, judged.figure(rule, band)) for rule, band in pairs)
    return Assessment(
        measured.image, measured.window_id, figures, available, measured.histograms, measured.seams or (),
        tuple(judged.notices(rules)), judged.maybe_grey, judged.balance,
    )  # fmt: skip


def clipped_share(histogram: Histogram, rule: Rule, available: ValueRange) -> float:
    """Share of the pixels in the lowest or highest values of the range, or beyond them.

    Values without steps of their own (float) are taken as 256 steps.
    """
    low, high = available
    width = rule.values - 1 if histogram.has_steps else rule.values * (high - low) / 256
    if rule.check == checks.CLIPPED_LOW:
        return histogram.share(most=low + width)
    return histogram.share(least=high - width)


def seam_contrast(steps: Sequence[SeamStep], band: int, available: ValueRange) -> float:
    """Standard deviation beside the seams as a share of the range, root mean square over all stations."""
    squares = math.fsum(step.stations * step.contrasts[band] ** 2 for step in steps)
    return math.sqrt(squares / sum(step.stations for step in steps)) / (available[1] - available[0])


class _Judged:
    """The figures of one image, each or why there is none."""

    def __init__(self, measured: MeasuredImage, areas: Areas, of_image: ImageRange) -> None:
        self._measured, self._areas, self._range = measured, areas, of_image
        self.maybe_grey: MaybeGrey | None = None
        self.balance: ColourBalance | None = None
        if not isinstance(of_image, Message) and measured.image.has_luminance:
            if measured.grey is None:
                self.maybe_grey = find_maybe_grey(areas, of_image)
            else:
                self.balance = colour_balance(measured.grey, of_image)

    def notices(self, rules: RuleSet) -> Iterator[Message]:
        """The warnings that concern all figures."""
        name, given = self._measured.image.ref.name, rules.value_range
        if isinstance(self._range, Message):
            yield messages.NOT_JUDGED(name=name, why=self._range)
        if given is not None and self._range == given:
            beyond = max(1 - histogram.share(*given) for histogram in self._measured.histograms.values())
            if beyond > 0:
                yield messages.BEYOND_RANGE(name=name, share=beyond, low=given[0], high=given[1])

    def figure(self, rule: Rule, band: str) -> _Found | Message:
        """The figure of a rule and band, or why there is none."""
        if band not in (ALL_BANDS, *self._measured.bands, *self._measured.histograms):
            return messages.NO_LUMINOSITY() if band == LUMINOSITY else messages.NO_SUCH_BAND(band=band)
        if rule.check == checks.COLOUR_BALANCE:
            return self._colour()
        if rule.check == checks.SEAM_STEP:
            return self._seam_step(band)
        if isinstance(self._range, Message):
            if rule.check == checks.CLIPPED_LOW and self._measured.image.data_type == "uint16":  # it begins at 0
                return (clipped_share(self._measured.histograms[band], rule, (0.0, math.inf)), None)
            return self._range
        if rule.check == checks.SIGNAL_TO_NOISE:
            return self._noise(band, self._range)
        if rule.check == checks.SEAM_CONTRAST:
            steps = self._measured.seams
            return (seam_contrast(steps, self._measured.bands.index(band), self._range), None) if steps else _no_seam()
        histogram = self._measured.histograms[band]
        if rule.check == checks.PEAK:
            counts, middles = histogram.binned(self._range)
            low, high = self._range
            return (abs(float(middles[int(counts.argmax())]) - (low + high) / 2) / (high - low), None)
        if rule.check == checks.CONTRAST:
            return (histogram.deviation / (self._range[1] - self._range[0]), None)
        return (clipped_share(histogram, rule, self._range), None)

    def _noise(self, band: str, available: ValueRange) -> _Found | Message:
        ratio = signal_to_noise(self._areas, self._measured.bands.index(band), available)
        if ratio is None:
            return messages.NO_UNIFORM_AREA(least=limits.MIN_AREAS, side=limits.AREA_PX)
        return messages.NO_NOISE_AT_ALL() if math.isinf(ratio) else (ratio, None)

    def _colour(self) -> _Found | Message:
        image, balance = self._measured.image, self.balance
        if not image.has_luminance:
            return messages.NO_COLOURS()
        if isinstance(self._range, Message):
            return self._range
        if balance is not None:
            what = messages.GREYEST_NOT(area=balance.worst.number, share=balance.worst_value)
            return balance.value, Spot(balance.worst.place, what)
        if self._measured.grey is not None:
            return messages.GREY_AREAS_UNUSABLE(least=limits.MIN_GREY_PIXELS)
        if self.maybe_grey is None:
            return messages.NO_GREY_AREAS()
        middle = self.maybe_grey.middle
        place = image.grid.to_map(*middle) if image.is_north_up else middle
        return messages.GREY_AREAS_UNSEEN(
            count=len(self.maybe_grey.corners), share=self.maybe_grey.share, x=place[0], y=place[1],
            difference=self.maybe_grey.difference,
        )  # fmt: skip

    def _seam_step(self, band: str) -> _Found | Message:
        steps, largest = self._measured.seams, self._measured.largest
        if not steps or largest <= 0:
            return _no_seam()
        index = self._measured.bands.index(band)
        worst = max(steps, key=lambda step: abs(step.steps[index]))
        what = messages.SEAM(number=worst.seam_id)
        if worst.features:
            features = ", ".join(worst.features)
            what = messages.SEAM_OF_FEATURES(number=worst.seam_id, features=features, layer=worst.layer)
        return abs(worst.steps[index]) / largest, Spot(worst.places[index], what)


def _no_seam() -> Message:
    return messages.NO_SEAM_HERE(pixels=limits.MIN_SEAM_STATIONS * limits.SEAM_STATION_PX)


def _checked(measured: MeasuredImage, rule: Rule, band: str, figure: _Found | Message) -> CheckedFigure:
    """A figure against its rule, or why there is none."""
    image = measured.image
    if isinstance(figure, Message):
        applicable = rule.check != checks.COLOUR_BALANCE or image.has_luminance
        reason = messages.NOT_MEASURABLE(why=figure)
        return CheckedFigure(band, rule, None, None, reason, is_applicable=applicable)
    value, spot = figure
    if not rule.has_limit:
        return CheckedFigure(band, rule, value, None, messages.NO_LIMIT(), spot)
    return CheckedFigure(band, rule, value, rule.passes(value), spot=spot)


@dataclass(frozen=True, eq=False)
class ImageDecision:
    """The decision on an image or a window of it."""

    result: Assessment
    outcome: str
    failed: tuple[CheckedFigure, ...]  # figures beyond their limits
    missed: tuple[CheckedFigure, ...]  # figures that are not known and would have to be
    unmeasured: tuple[CheckedFigure, ...]  # figures with a limit that are not known and that the rules can do without


@dataclass(frozen=True, eq=False)
class RadiometricDecision:
    outcome: str
    images: tuple[ImageDecision, ...]
    left_out: tuple[Message, ...]  # why images or windows were not looked at; nothing is accepted unseen

    def those(self, outcome: str) -> list[ImageDecision]:
        return [image for image in self.images if image.outcome == outcome]


def decide_image(result: Assessment) -> ImageDecision:
    """The decision on an image: a failed figure rejects it whatever else is unknown, a required one that is not known
    leaves it open."""
    failed = tuple(checked for checked in result.checked_figures if checked.passed is False)
    missed = tuple(checked for checked in result.checked_figures if checked.is_missed)
    unmeasured = tuple(checked for checked in result.checked_figures if checked.is_unknown and not checked.is_missed)
    is_judged = any(checked.passed is not None for checked in result.checked_figures)
    outcome = _outcome(bool(failed), bool(missed) or not is_judged)
    return ImageDecision(result, outcome, failed, missed, unmeasured)


def decide(results: Sequence[Assessment], left_out: Sequence[Message] = ()) -> RadiometricDecision:
    """The decision on all images: a rejected one rejects all; an open one, or one not looked at, leaves all open."""
    images = tuple(map(decide_image, results))
    outcomes = {image.outcome for image in images}
    is_open = UNDECIDED in outcomes or bool(left_out) or not images
    return RadiometricDecision(_outcome(REJECTED in outcomes, is_open), images, tuple(left_out))


def _outcome(is_beyond: bool, is_open: bool) -> str:
    if is_beyond:
        return REJECTED
    return UNDECIDED if is_open else ACCEPTED
