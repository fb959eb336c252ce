"""Words and colours of what tables hold: verdicts, the observer's words, causes."""
from __future__ import annotations

from ..toolkit.translation import tr

VERDICT_COLOURS = {
    "significant": "#d55e00",
    "reduced": "#f0c800",
    "preserved": "#0072b2",
    "not_comparable": "#8a8a8a",
    "": "#c8c8c8",
}
"""Worst first; the empty one is that of a window not inspected."""


def verdict_word(verdict: str) -> str:
    """A verdict for the user."""
    return {
        "significant": tr("significant"),
        "reduced": tr("reduced"),
        "preserved": tr("preserved"),
        "not_comparable": tr("not comparable"),
        "": tr("not inspected"),
    }.get(verdict, verdict)


def verdict_colour(verdict: str) -> str:
    """The colour of a verdict, that of ``not_comparable`` for an unknown one."""
    return VERDICT_COLOURS.get(verdict, VERDICT_COLOURS["not_comparable"])


def observer_word(observer: str) -> str:
    """The observer's word for the user."""
    return {"visible": tr("visible"), "invisible": tr("invisible")}.get(observer, observer)


def cause_word(cause: str) -> str:
    """A cause for the user."""
    return {
        "blur": tr("blur"),
        "feathering": tr("feathering"),
        "narrowed histogram": tr("narrowed histogram"),
        "gamma": tr("gamma"),
        "clipping": tr("clipping"),
        "colour shift": tr("colour shift"),
        "misregistration": tr("misregistration"),
        "none": tr("none"),
        "unclear": tr("unclear"),
    }.get(cause, cause)


def cause_sentence(cause: str) -> str:
    """What a cause means, in plain words; empty for an unknown one."""
    return {
        "blur": tr("The mosaic is less sharp than its sources, beyond what tone and feathering explain."),
        "feathering": tr("Images that do not fit were blended along the seam."),
        "narrowed histogram": tr("Grey values were pressed together by a linear function."),
        "gamma": tr("Grey values were changed by a power function."),
        "clipping": tr("Highlights or shadows were driven into the limits."),
        "colour shift": tr("The channels were corrected one by one, so that colours turned."),
        "misregistration": tr("The mosaic does not lie where its sources do."),
        "none": tr("No step of production is found that took contrast away."),
        "unclear": tr("What was measured does not point to one cause."),
    }.get(cause, "")
