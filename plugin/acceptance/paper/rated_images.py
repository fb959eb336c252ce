"""What 'Check radiometry' found, as its table says: beside the decision on the seams, which it does not change."""
from __future__ import annotations

from dataclasses import dataclass

from ...imagery.errors import SettingsError
from ...toolkit.algorithms.run import Run
from ...toolkit.layers import features
from ...toolkit.table_fields import attributes, text, whole_number
from ...toolkit.translation import filled, tr
from ..measure import messages
from ..measure.decision import AcceptanceOutcome
from ..paper_parameters import RADIOMETRY


@dataclass(frozen=True)
class RatedImage:
    """An image, or a window of it."""

    name: str
    outcome: AcceptanceOutcome
    failed_by: tuple[str, ...]
    """Where the limits come from that it does not keep, each once."""


def rated_images(run: Run) -> tuple[RatedImage, ...]:
    """In the order of the table; none where none is given. Raises SettingsError for another table."""
    if not run.parameters.get(RADIOMETRY):
        return ()
    source = run.source(RADIOMETRY)
    names = source.fields().names()
    if not {"raster", "window_id", "passed", "source", "decision"} <= set(names):
        raise SettingsError(messages.RADIOMETRY_NO_TABLE(name=source.sourceName()))
    found: dict[str, tuple[str, dict[str, None]]] = {}
    for row in attributes(features(source), names):
        name, window = text(row["raster"]), whole_number(row["window_id"])
        if window is not None:
            name = filled(tr("{name}, window {window}"), name=name, window=window)
        _, failed_by = found.setdefault(name, (text(row["decision"]), {}))
        if whole_number(row["passed"]) == 0:
            failed_by[text(row["source"])] = None
    words = {one.value: one for one in AcceptanceOutcome}
    return tuple(
        RatedImage(name, words.get(decision, AcceptanceOutcome.UNDECIDED), tuple(failed_by))
        for name, (decision, failed_by) in found.items()
    )
