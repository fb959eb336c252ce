"""What the dock says of a line and of the target that it belongs to."""
from __future__ import annotations

from collections.abc import Sequence

from ...toolkit.translation import filled, sentence, tr
from ..distance_words import distance_sentences, distance_text
from ..measure.bar_groups import GroupResult, TargetResolution


def verdict_text(results: Sequence[GroupResult], resolution: TargetResolution) -> str:
    """The line's distance and verdict, or the reasons why it has none; below it what all lines say together."""
    reasons = list(dict.fromkeys(sentence(result.reason) for result in results if result.reason is not None))
    grd = results[0].grd_cm if results else None
    words = ""
    if grd is not None:
        distance = distance_text(grd, _largest([result.grd_error_cm for result in results]))
        words = filled(tr("Group {group}, {distance}"), group=results[0].measured.line.group, distance=distance)
    if results and all(result.resolved for result in results):
        words += ", " + tr("resolved")
        shares = [result.reading.share for result in results if result.reading and result.reading.share is not None]
        if shares:
            words += " " + filled(tr("(amplitude {share:.0%} of the full one)"), share=min(shares))
    verdict = ": ".join(part for part in (words, " ".join(reasons)) if part)
    notice = sentence(resolution.scale_notice) if resolution.scale_notice is not None else ""
    together = "; ".join(distance_sentences(resolution, each_band=False))
    together = together and filled(tr("All lines: {distances}"), distances=together)
    return "\n".join(part for part in (verdict, notice, together) if part)


def _largest(errors: Sequence[float | None]) -> float | None:
    return max((error for error in errors if error is not None), default=None)
