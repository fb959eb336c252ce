"""Figures, limits and the decision in words."""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from qgis.PyQt.QtCore import QT_TR_NOOP

from ..imagery.errors import in_sentence
from ..toolkit.translation import band_title, decimals_beside, filled, formatted, sentence, shown_number, tr
from .measure import rules as checks
from .measure.assessment import Assessment, CheckedFigure, ImageDecision, RadiometricDecision
from .measure.rules import ACCEPTED, ALL_BANDS, EACH_BAND, LUMINOSITY, REJECTED, UNDECIDED, Rule

_MOST_NAMED = 5  # images in one sentence; the others are counted

CHECK_WORDS = {
    checks.CLIPPED_LOW: QT_TR_NOOP("clipped at the dark end"),
    checks.CLIPPED_HIGH: QT_TR_NOOP("clipped at the bright end"),
    checks.PEAK: QT_TR_NOOP("histogram peak from mid-scale"),
    checks.CONTRAST: QT_TR_NOOP("contrast"),
    checks.SIGNAL_TO_NOISE: QT_TR_NOOP("signal to noise"),
    checks.COLOUR_BALANCE: QT_TR_NOOP("colour balance"),
    checks.SEAM_STEP: QT_TR_NOOP("step at the seams"),
    checks.SEAM_CONTRAST: QT_TR_NOOP("contrast beside the seams"),
}
OUTCOME_WORDS = {
    ACCEPTED: QT_TR_NOOP("accepted"),
    REJECTED: QT_TR_NOOP("rejected"),
    UNDECIDED: QT_TR_NOOP("undecided"),
}
_BAND_WORDS = {
    ALL_BANDS: QT_TR_NOOP("between bands"),
    EACH_BAND: QT_TR_NOOP("each band"),
    LUMINOSITY: QT_TR_NOOP("luminosity"),
}


def band_words(band: str) -> str:
    return tr(_BAND_WORDS[band]) if band in _BAND_WORDS else band_title(band)


def title(result: Assessment) -> str:
    """The image, and the window where it is not all of it."""
    name = in_sentence(result.image.ref.name)
    if result.window_id is None:
        return name
    return filled(tr("{name}, window {window}"), name=name, window=result.window_id)


def figure_words(rule: Rule, value: float) -> str:
    """The value, with as many decimals as show on which side of its limits it lies."""
    is_share = rule.check != checks.SIGNAL_TO_NOISE
    scale, least = (100, 2) if is_share else (1, 1)
    limits = [scale * limit for limit in (rule.least, rule.most) if limit is not None]
    shown = shown_number(scale * value, decimals_beside(scale * value, limits, least))
    return f"{shown}\u00a0%" if is_share else shown


def limit_words(rule: Rule) -> str:
    scale, unit = (1, "") if rule.check == checks.SIGNAL_TO_NOISE else (100, "\u00a0%")
    least, most = (
        None if limit is None else formatted(scale * limit, "g") + unit for limit in (rule.least, rule.most)
    )
    if least and most:
        return filled(tr("{least} to {most}"), least=least, most=most)
    if most:
        return filled(tr("at most {most}"), most=most)
    return filled(tr("at least {least}"), least=least) if least else tr("none")


def checks_words(figures: Iterable[CheckedFigure]) -> str:
    """Several checks, each once, with the bands that they concern."""
    bands: dict[str, dict[str, None]] = {}
    for checked in figures:
        names = bands.setdefault(checked.rule.check, {})
        if checked.band != ALL_BANDS:
            names[band_words(checked.band)] = None
    named = ((tr(CHECK_WORDS[check]), names) for check, names in bands.items())
    return ", ".join(f"{words} ({', '.join(names)})" if names else words for words, names in named)


def spot_words(checked: CheckedFigure) -> str | None:
    """The place that a figure comes from, as "seam 3, of feature 12"."""
    return None if checked.spot is None else sentence(checked.spot.what)


def found_words(result: Assessment) -> Iterator[str]:
    """Sentences on an image beside its figures: the band and the seam at which tone steps most, and the grey areas
    that the colour balance comes from."""
    if steps := result.measured(checks.SEAM_STEP):
        worst = max(steps, key=lambda checked: checked.value or 0.0)
        assert worst.value is not None
        assert worst.spot is not None
        x, y = worst.spot.place
        yield filled(
            tr("The largest step of tone is {step} in {band}, at {seam}, near {x:.2f}, {y:.2f}."),
            step=figure_words(worst.rule, worst.value), band=band_words(worst.band), seam=spot_words(worst), x=x, y=y,
        )  # fmt: skip
    if (balance := result.balance) is not None:
        x, y = balance.worst.place
        red, green, blue = balance.means
        pixels = sum(tone.pixels for tone in balance.tones)
        yield filled(
            tr(
                "Grey areas: {count}, with {pixels} px, {share:.2%} of the image; red, green and blue on them are "
                "{red:.1f}, {green:.1f}, {blue:.1f}. Area {area} has the most colour: {worst:.1%}, near {x:.2f}, "
                "{y:.2f}."
            ),
            count=len(balance.tones), pixels=pixels, share=pixels / max(result.pixels, 1), red=red, green=green,
            blue=blue, area=balance.worst.number, worst=balance.worst_value, x=x, y=y,
        )  # fmt: skip


def no_limit_words() -> str:
    """The reason why an image is undecided of which nothing is missed."""
    return tr("The rules set no limit for it.")


def decision_word(decision: RadiometricDecision) -> str:
    return tr(OUTCOME_WORDS[decision.outcome])


def decision_reasons(decision: RadiometricDecision) -> list[str]:
    """The reasons, a sentence each: the images that reject it or leave it open, what was not measured, what lacks."""
    said = []
    rejected, undecided = map(decision.those, (REJECTED, UNDECIDED))
    if rejected:
        failed = checks_words(checked for image in rejected for checked in image.failed)
        said.append(filled(tr("Beyond their limits: {images}; by {checks}."), images=_names(rejected), checks=failed))
    if undecided:
        missed = checks_words(checked for image in undecided for checked in image.missed)
        said.append(filled(tr("Required but not measurable: {checks}; in {images}."),
            images=_names(undecided), checks=missed) if missed
            else no_limit_words())  # fmt: skip
    if decision.left_out:
        said.append(filled(tr("Not checked: {count}."), count=len(decision.left_out)))
    without = [image for image in decision.images if image.unmeasured]
    if without:
        unmeasured = checks_words(checked for image in without for checked in image.unmeasured)
        said.append(filled(tr("Not measurable and not required: {checks}; in {images}."),
            images=_names(without), checks=unmeasured))  # fmt: skip
    if not said:
        said.append(tr("All figures are within their limits."))
    return said


def _names(images: Sequence[ImageDecision]) -> str:
    named = ", ".join(title(image.result) for image in images[:_MOST_NAMED])
    more = len(images) - _MOST_NAMED
    return named if more <= 0 else filled(tr("{names} and {count} more"), names=named, count=more)
