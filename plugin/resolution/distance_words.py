"""The distances of a target in words: for log, report and dock."""
from __future__ import annotations

from collections.abc import Sequence

from ..toolkit.translation import filled, sentence, shown_number, tr
from .measure.bar_groups import GroupResult, TargetResolution
from .measure.target import DIRECTIONS


def direction_title(direction: str) -> str:
    return {"along": tr("along the flight"), "across": tr("across the flight")}.get(direction, direction)


def distance_number(grd_cm: float, error_cm: float | None) -> str:
    """A distance and its standard deviation, without their unit."""
    return shown_number(grd_cm) if error_cm is None else f"{shown_number(grd_cm)} ± {shown_number(error_cm)}"


def distance_text(grd_cm: float, error_cm: float | None) -> str:
    return f"{distance_number(grd_cm, error_cm)} cm"


def target_distances(resolution: TargetResolution) -> list[tuple[str, float, float | None]]:
    """Name, distance (cm) and standard deviation of each distance: along, across, and their mean."""
    distances = [
        (direction_title(direction), resolution.worst(direction), resolution.worst_error(direction))
        for direction in DIRECTIONS
    ]
    distances.append((tr("geometric mean"), resolution.mean, resolution.mean_error))
    return [(name, grd, error) for name, grd, error in distances if grd is not None]


def distance_sentences(resolution: TargetResolution) -> list[str]:
    """The results line by line: distances, what observers saw, the lowest contrast of the target."""
    words = [f"{name}: {distance_text(grd, error)}" for name, grd, error in target_distances(resolution)]
    for direction in DIRECTIONS:
        interval = resolution.interval(direction)
        if interval is not None and interval[0] < interval[1]:
            low, high = (shown_number(end) for end in interval)
            words.append(filled(
                tr("{direction}, one group more or less: {low} to {high} cm"),
                direction=direction_title(direction), low=low, high=high,
            ))
        seen = resolution.seen(direction)
        if seen is not None:
            words.append(filled(
                tr("seen by all observers {direction}: {grd:.2f} cm"), direction=direction_title(direction), grd=seen
            ))
    if resolution.contrasts:
        contrast = min(resolution.contrasts.values())
        words.append(filled(tr("contrast of the target {contrast:.1f}:1"), contrast=contrast))
    return words


def verdict_text(results: Sequence[GroupResult], resolution: TargetResolution) -> str:
    """The line's distance and verdict, or the reasons why it has none; below it what all lines say together."""
    reasons = list(dict.fromkeys(sentence(result.reason) for result in results if result.reason is not None))
    grd = results[0].grd_cm if results else None
    words = ""
    if grd is not None:
        errors = [result.grd_error_cm for result in results if result.grd_error_cm is not None]
        distance = distance_text(grd, max(errors, default=None))
        words = filled(tr("Group {group}, {distance}"), group=results[0].measured.line.group, distance=distance)
    if results and all(result.resolved for result in results):
        words += ", " + tr("resolved")
        shares = [result.reading.share for result in results if result.reading and result.reading.share is not None]
        if shares:
            words += " " + filled(tr("(amplitude {share:.0%} of the full one)"), share=min(shares))
    verdict = ": ".join(part for part in (words, " ".join(reasons)) if part)
    notice = sentence(resolution.scale_notice) if resolution.scale_notice is not None else ""
    together = "; ".join(distance_sentences(resolution))
    together = together and filled(tr("All lines: {distances}"), distances=together)
    return "\n".join(part for part in (verdict, notice, together) if part)
