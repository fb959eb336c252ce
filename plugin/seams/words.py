"""Words and colours of what tables hold, for people: verdicts, the observer's words, causes, lost detail.

A cause has its word, what it means, and what is said of a window where it was found. Lost detail has one fixed scale of
colours for the windows' pictures, the map and the scan, so that all compare.
"""

from __future__ import annotations

from collections.abc import Callable
from math import floor, inf, isfinite, log
from typing import TYPE_CHECKING, NamedTuple

from qgis.PyQt.QtCore import QT_TR_NOOP

from ..toolkit.translation import filled, percent, shown_metres, shown_number, tr
from .measure.judgement.causes import MIN_GAIN_RATIO, Cause
from .measure.profile.seam_profile import BAND_KEPT, STRIP_PX, WIDEST_FEATHER_PX

if TYPE_CHECKING:
    import numpy as np

    from .measure.judgement.explanation import Explanation
    from .measure.profile.seam_profile import SeamProfile
    from .measure.profile.window_detail import LossPicture


class ShownVerdict(NamedTuple):
    """How people meet a verdict."""

    word: str
    colour: str  # the one on the map, too (resources/styles/windows.qml)
    sentence: str = ""  # what is said of such a window, where that is more than the word


VERDICTS = {
    "significant": ShownVerdict(QT_TR_NOOP("significant"), "#d55e00", QT_TR_NOOP("Significant loss.")),
    "reduced": ShownVerdict(QT_TR_NOOP("reduced"), "#f0c800"),
    "preserved": ShownVerdict(QT_TR_NOOP("preserved"), "#0072b2"),
    "not_comparable": ShownVerdict(
        QT_TR_NOOP("not comparable"), "#8a8a8a", QT_TR_NOOP("The mosaic could not be compared with a source here.")
    ),
    "": ShownVerdict(QT_TR_NOOP("not inspected"), "#c8c8c8", QT_TR_NOOP("Not inspected yet.")),
}
"""Verdicts by the word that tables hold, the worst first; the empty one is that of a window not inspected."""
LOSSES = ("significant", "reduced")


def verdict_word(verdict: str) -> str:
    """A verdict for the user."""
    return tr(VERDICTS[verdict].word) if verdict in VERDICTS else verdict


def verdict_sentence(verdict: str) -> str:
    """What a verdict says of a window."""
    verdict_text = VERDICTS[verdict].sentence if verdict in VERDICTS else ""
    return tr(verdict_text) if verdict_text else f"{verdict_word(verdict).capitalize()}."


def verdict_colour(verdict: str) -> str:
    """The colour of a verdict, that of ``not_comparable`` for an unknown one."""
    return VERDICTS[verdict if verdict in VERDICTS else "not_comparable"].colour


_LEAST_WIDTH_M = 0.05  # less is 0.0 m
_ENDLESS = 0.999  # of the widest feather: layers may keep a few digits only


def strip_words(pixel_m: float | None) -> str:
    """How wide a strip along the seam kept_1 is of, metres; empty where the mosaic's pixel size is not known."""
    return "" if pixel_m is None else shown_metres(2 * STRIP_PX * pixel_m)


def seam_width_words(
    metres: float | None, pixel_m: float | None = None, window_m: float = inf, profile: SeamProfile | None = None
) -> str:
    """How wide a cause took detail along a seam, metres; empty for a cut. "At least" where it does not end as far as it
    is looked for, by the mosaic's pixel size or by the profile, or in the window, of which ``window_m`` is the side.
    """
    if metres is None or metres < _LEAST_WIDTH_M:
        return ""
    known = [] if profile is None else [bin_ for bin_ in profile.bins if bin_.level == 1 and isfinite(bin_.far_px)]
    beyond = [bin_.kept for bin_ in known if bin_.far_px > STRIP_PX]
    is_endless = pixel_m is not None and metres > _ENDLESS * WIDEST_FEATHER_PX * pixel_m
    is_endless = is_endless or metres > window_m + _LEAST_WIDTH_M or max(beyond, default=1.0) < BAND_KEPT
    width = shown_number(min(metres, window_m), 1)
    return filled(tr("at least {width}"), width=width) if is_endless else width


def shown_side(side_m: float) -> str:
    """The side of a window, in the centimetres that it spans at least, by which it is set."""
    return shown_metres(floor(100 * side_m + 1e-6) / 100)


def observer_word(observer: str) -> str:
    """The observer's word for the user."""
    words = {"visible": tr("visible"), "invisible": tr("invisible"), "unsure": tr("not sure")}
    return words.get(observer, observer)


def _noise(explanation: Explanation) -> float | None:
    return explanation.evidence.texture.noise_dn if explanation.evidence.texture else None


def _tenths(value: float) -> str:
    return shown_number(value, 1)


class ShownCause(NamedTuple):
    """The texts of a cause."""

    word: str
    meaning: str
    clause: str  # what was done, to go on a sentence with
    measured: str = ""  # the clause with its number, ``{value}``
    number: Callable[[Explanation], float | None] = lambda explanation: None
    """That number; None where it is not known, and 0 says nothing."""
    shown: Callable[[float], str] = shown_number
    loss: str = ""  # what it took all over a window, ``{value}`` per cent of the finest detail
    brief: str = ""  # what was done where it took detail, in a word or two
    to_do: str = ""  # what whoever made the mosaic can do about what it took


CAUSES: dict[str, ShownCause] = {
    Cause.BLUR.value: ShownCause(
        QT_TR_NOOP("blur"),
        QT_TR_NOOP("The mosaic is less sharp than its sources, beyond what tone and feathering explain."),
        QT_TR_NOOP("the mosaic is blurred"),
        QT_TR_NOOP("the mosaic is blurred to {value} % of their sharpness"),
        lambda explanation: explanation.sharpness,
        percent,
        QT_TR_NOOP("blur took {value} %"),
        brief=QT_TR_NOOP("blurred"),
        to_do=QT_TR_NOOP("Leave out that filter."),
    ),
    Cause.FEATHERING.value: ShownCause(
        QT_TR_NOOP("feathering"),
        QT_TR_NOOP("Two images that differ were mixed by weights along the seam."),
        QT_TR_NOOP("images are feathered"),
        brief=QT_TR_NOOP("feathered"),
        to_do=QT_TR_NOOP("Feather less."),
    ),
    Cause.OTHER_MIXTURE.value: ShownCause(
        QT_TR_NOOP("other mixture"),
        QT_TR_NOOP("Images were mixed along the seam, but not by weights: by the darker pixel, at random, by hand."),
        QT_TR_NOOP("images are mixed by another rule than weights"),
        brief=QT_TR_NOOP("mixed by another rule"),
        to_do=QT_TR_NOOP("Cut hard there."),
    ),
    Cause.SOFTENED.value: ShownCause(
        QT_TR_NOOP("softened seam"),
        QT_TR_NOOP("The mosaic was softened along the seam: less is left than a mixture of its images would leave."),
        QT_TR_NOOP("the seam is softened"),
        brief=QT_TR_NOOP("softened"),
        to_do=QT_TR_NOOP("Don't soften it."),
    ),
    Cause.NARROWED_HISTOGRAM.value: ShownCause(
        QT_TR_NOOP("narrowed histogram"),
        QT_TR_NOOP("The range of grey values was narrowed by a linear function."),
        QT_TR_NOOP("the histogram is narrowed"),
        QT_TR_NOOP("the histogram is narrowed, gain {value}"),
        lambda explanation: max((tone.gain for tone in explanation.evidence.tones if tone.gain), default=None),
    ),
    Cause.GAMMA.value: ShownCause(
        QT_TR_NOOP("gamma"),
        QT_TR_NOOP("Grey values were changed by a power function."),
        QT_TR_NOOP("grey values are bent by a gamma"),
        QT_TR_NOOP("grey values are bent, gamma {value}"),
        lambda explanation: max(
            (tone.gamma for tone in explanation.evidence.tones), key=lambda gamma: abs(log(gamma)), default=None
        ),
    ),
    Cause.CLIPPING.value: ShownCause(
        QT_TR_NOOP("clipping"),
        QT_TR_NOOP("Highlights or shadows were cut off at the limits."),
        QT_TR_NOOP("highlights or shadows are clipped"),
        QT_TR_NOOP("{value} % of the pixels are clipped"),
        lambda explanation: next(iter(explanation.changes[-1].values())).clipped,  # in the judged band
        percent,
        QT_TR_NOOP("clipping took {value} %"),
        brief=QT_TR_NOOP("clipped"),
        to_do=QT_TR_NOOP("Stretch it less."),
    ),
    Cause.COLOUR_SHIFT.value: ShownCause(
        QT_TR_NOOP("colour shift"),
        QT_TR_NOOP("The channels were corrected one by one, so the colours shifted."),
        QT_TR_NOOP("the colours are shifted"),
        QT_TR_NOOP("the colours are shifted, gains differ by a factor of {value}"),
        lambda explanation: max(filter(None, (tone.colour_shift for tone in explanation.evidence.tones)), default=None),
    ),
    Cause.MISREGISTRATION.value: ShownCause(
        QT_TR_NOOP("misregistration"),
        QT_TR_NOOP("Images that meet in the mosaic do not line up there."),
        QT_TR_NOOP("images do not fit where they meet"),
        QT_TR_NOOP("images lie {value} px apart where they meet"),
        shown=_tenths,
        brief=QT_TR_NOOP("images do not fit"),
        to_do=QT_TR_NOOP("Register images."),
    ),
    Cause.MISSING_SOURCE.value: ShownCause(
        QT_TR_NOOP("missing source"),
        QT_TR_NOOP(
            "A part of the mosaic matches no source: add the missing orthoimage, unless the mosaic was altered there."
        ),
        QT_TR_NOOP("a part of the mosaic matches none of these sources"),
        QT_TR_NOOP("{value} % of the mosaic match none of these sources"),
        lambda explanation: explanation.evidence.missing,
        percent,
        to_do=QT_TR_NOOP("Add the missing orthoimage."),
    ),
    Cause.RESAMPLED.value: ShownCause(
        QT_TR_NOOP("resampled"),
        QT_TR_NOOP("The mosaic's pixels lie between those of its sources, so they were interpolated from them."),
        QT_TR_NOOP("the mosaic was resampled"),
        QT_TR_NOOP("the mosaic was resampled, {value} px off the sources' pixels"),
        lambda explanation: explanation.evidence.off_pixel,
        _tenths,
        QT_TR_NOOP("resampling took {value} %"),
        brief=QT_TR_NOOP("resampled"),
        to_do=QT_TR_NOOP("Don't resample it."),
    ),
    Cause.SHARPENED.value: ShownCause(
        QT_TR_NOOP("sharpened"),
        QT_TR_NOOP("The whole mosaic was sharpened, beyond what its sources show."),
        QT_TR_NOOP("the mosaic was sharpened"),
        QT_TR_NOOP("the mosaic was sharpened to {value} % of the sources' contrast"),
        lambda explanation: explanation.evidence.texture.most_transfer if explanation.evidence.texture else None,
        percent,
    ),
    Cause.COMPRESSED.value: ShownCause(
        QT_TR_NOOP("compressed"),
        QT_TR_NOOP("Lossy compression, block by block, changed the fine detail."),
        QT_TR_NOOP("the mosaic was compressed with loss"),
        QT_TR_NOOP("the mosaic was compressed with loss, which changed fine detail by {value} DN"),
        _noise,
        _tenths,
        QT_TR_NOOP("compression took {value} %"),
        brief=QT_TR_NOOP("compressed with loss"),
        to_do=QT_TR_NOOP("Compress it less."),
    ),
    Cause.NOISE_ADDED.value: ShownCause(
        QT_TR_NOOP("noise added"),
        QT_TR_NOOP("The mosaic has noise that its sources do not have."),
        QT_TR_NOOP("noise was added"),
        QT_TR_NOOP("noise of {value} DN was added"),
        _noise,
        _tenths,
    ),
    Cause.DODGING.value: ShownCause(
        QT_TR_NOOP("dodging"),
        QT_TR_NOOP("Brightness was evened out from place to place; from a coarse overview, this removes detail."),
        QT_TR_NOOP("brightness was evened out from place to place"),
        loss=QT_TR_NOOP("dodging took {value} %"),
        brief=QT_TR_NOOP("dodged"),
        to_do=QT_TR_NOOP("Dodge it less."),
    ),
    Cause.BALANCED.value: ShownCause(
        QT_TR_NOOP("balanced"),
        QT_TR_NOOP("The sources' tones were matched, each by its gain and bias; nothing is lost."),
        QT_TR_NOOP("the sources' tones were balanced"),
        QT_TR_NOOP("the sources' tones were balanced, gains a factor of {value} apart"),
        lambda explanation: ratio if (ratio := explanation.evidence.spread[0]) >= MIN_GAIN_RATIO else None,
    ),
    Cause.NONE.value: ShownCause(
        QT_TR_NOOP("none"),
        QT_TR_NOOP("No step of production was found that took contrast away."),
        QT_TR_NOOP("no step of production took detail away, so the sources differ in content"),
        QT_TR_NOOP("the sources were compressed with loss, and the mosaic holds more than they do"),
        lambda explanation: 1.0 if explanation.evidence.has_compressed_sources else None,
    ),
    Cause.UNCLEAR.value: ShownCause(
        QT_TR_NOOP("unclear"),
        QT_TR_NOOP("What was measured does not point to one cause."),
        QT_TR_NOOP("the cause is unclear"),
        brief=QT_TR_NOOP("cause unclear"),
    ),
}
"""Causes by the word that tables hold."""


def cause_word(cause: str) -> str:
    """A cause for the user."""
    return tr(CAUSES[cause].word) if cause in CAUSES else cause


def causes_words(causes: str) -> str:
    """All causes of a window for the user, in their order, as tables hold them: joined by ``; ``."""
    return ", ".join(cause_word(cause) for cause in causes.split("; ") if cause)


def cause_sentence(cause: str) -> str:
    """What a cause means, in plain words; empty for an unknown one."""
    return tr(CAUSES[cause].meaning) if cause in CAUSES else ""


def loss_words(cause: str, share: float) -> str:
    """What a cause took all over a window; empty for one that does not."""
    text = CAUSES[cause].loss if cause in CAUSES else ""
    return filled(tr(text), value=percent(share)) if text else ""


def to_do(cause: str) -> str:
    """What can be done about what a cause took; empty where it took nothing."""
    return tr(CAUSES[cause].to_do) if cause in CAUSES and CAUSES[cause].to_do else ""


def cause_clause(cause: str, explanation: Explanation | None, number: float | None = None) -> str:
    """What the cause did, to go on a sentence with; empty for an unknown one. With the number given, else with its own
    where that is at hand."""
    if cause not in CAUSES:
        return ""
    shown = CAUSES[cause]
    number = shown.number(explanation) if number is None and explanation is not None else number
    return filled(tr(shown.measured), value=shown.shown(number)) if number else tr(shown.clause)


Rgba = tuple[int, int, int, int]

LOSS_CLASSES: tuple[tuple[float, Rgba, str], ...] = (
    (0.5, (163, 0, 38, 255), QT_TR_NOOP("50 % kept, or less")),
    (0.6, (220, 47, 28, 255), QT_TR_NOOP("50 to 60 %")),
    (0.7, (244, 109, 31, 255), QT_TR_NOOP("60 to 70 %")),
    (0.8, (253, 174, 51, 235), QT_TR_NOOP("70 to 80 %")),
    (0.9, (255, 225, 77, 215), QT_TR_NOOP("80 to 90 %")),
)
"""Share of the detail that is kept at most, its colour, its words, as in ``resources/styles/loss.qml``. What keeps more
is even ground and has none."""
LOSS_OPACITY = 0.6
"""With which pictures of lost detail are painted: what lies beneath is what is judged."""
_NO_COLOUR = (0, 0, 0, 0)
_SPREAD_PX = 80  # as far as a picture's smoothing carries a loss where the ground is rough


def loss_rgba(loss: LossPicture, width_px: float = 0.0) -> np.ndarray:
    """The colours of what a window kept, (rows, columns, 4) uint8, alpha not multiplied in; transparent where the
    ground is even or nothing can be told (NaN).

    ``width_px``: how wide the seam took detail, of which a cell and a half are painted at least, and not what smoothing
    spreads beside that; 0: all is.
    """
    import numpy as np  # not when QGIS starts
    from scipy.ndimage import distance_transform_edt

    from .measure.profile.window_detail import SAMPLE_PX

    colours = np.array([*(colour for _, colour, _ in LOSS_CLASSES), _NO_COLOUR], np.uint8)
    rgba = np.asarray(colours[np.searchsorted([limit for limit, _, _ in LOSS_CLASSES], loss.kept)])  # NaN after all
    if width_px and len(loss.seam):
        cells = loss.cell_px // SAMPLE_PX
        is_away = np.ones(tuple(cells * side for side in loss.kept.shape), bool)
        is_away[tuple(loss.seam.T)] = False
        away_px = SAMPLE_PX * (distance_transform_edt(is_away)[cells // 2 :: cells, cells // 2 :: cells] + 0.5)
        reach_px = max(width_px, 1.5 * loss.cell_px) / 2
        rgba[(away_px > reach_px) & (away_px < reach_px + _SPREAD_PX)] = _NO_COLOUR
    return rgba


def loss_legend() -> list[tuple[str, Rgba]]:
    """Words and colour of each class, the greatest loss first."""
    return [(tr(words), colour) for _, colour, words in LOSS_CLASSES]
