"""What an operator's verdicts come to once the last window is judged."""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from qgis.PyQt.QtCore import QObject, pyqtSignal

from ...imagery.statistics import DECIDED, INVISIBLE, UNSURE, VISIBLE, Operator
from ...toolkit.background_tasks import BackgroundTasks, Cancelled, Job
from ...toolkit.translation import filled, percent, tr
from ..measure.window_records import WindowRecord
from ..words import CLAIMS

if TYPE_CHECKING:
    from ...imagery.grids import Extent
    from ..measure.threshold_calibration import ThresholdCalibration


def counts_words(windows: Sequence[WindowRecord], operator: Operator) -> str:
    """How many were judged, and what was said of them."""
    said = [getattr(row, operator.observer) for row in windows]
    shares = {word: said.count(word) for word in (VISIBLE, INVISIBLE, UNSURE)}
    text = tr("All windows are judged: {visible} visible, {invisible} invisible, {unsure} not sure.")
    return filled(text, visible=shares[VISIBLE], invisible=shares[INVISIBLE], unsure=shares[UNSURE])


def tool_words(windows: Sequence[WindowRecord], operator: Operator) -> str:
    """How often the tool says so too; empty where both said something of none."""
    pairs = [
        (getattr(row, operator.observer) == VISIBLE, row.verdict == "significant") for row in windows
        if getattr(row, operator.observer) in DECIDED and row.verdict in CLAIMS
    ]  # fmt: skip
    same, vain = sum(seen == found for seen, found in pairs), sum(found and not seen for seen, found in pairs)
    text = tr("The tool agrees on {same} of {count}.")
    if same < len(pairs):
        text = tr("The tool agrees on {same} of {count}. Called significant and not seen: {vain}; seen and not called "
                  "so: {missed}.")
    missed = len(pairs) - same - vain
    return filled(text, same=same, count=len(pairs), vain=vain, missed=missed) if pairs else ""


def limit_words(found: ThresholdCalibration, min_kept: float) -> str:
    """The limit that the verdicts support, beside the one that is set, and how many more it needs to be relied on."""
    visible, invisible = len(found.verdicts.visible), len(found.verdicts.invisible)
    if found.best is None or found.best_range is None:
        text = tr("Too few for a limit of your own ({visible} visible, {invisible} invisible with a number along the "
                  "seam).")
        return filled(text, visible=visible, invisible=invisible)
    low, high = map(percent, found.best_range)
    text = tr("Your verdicts support a limit of {limit} % kept along the seam ({low} to {high} %); {set} % is set.")
    said = filled(text, limit=percent(found.best.threshold), low=low, high=high, set=percent(min_kept))
    lacking = sum(max(wanted - count, 0) for wanted, count in zip(found.wanted or (), (visible, invisible)))
    if not lacking:
        return said
    more = tr("These are {count} verdicts; judge some {more} more before you rely on it.")
    return f"{said} {filled(more, count=visible + invisible, more=lacking)}"


class OwnLimit(QObject):
    """The limit that an operator's verdicts support, found in the background, as it takes a second."""

    found = pyqtSignal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._background = BackgroundTasks(self)
        self._values: list[tuple[Extent | None, bool, float]] | None = None
        self.calibration: ThresholdCalibration | None = None
        """Calibration by the windows asked for last; None until it is there."""

    def ask(self, windows: Sequence[WindowRecord], operator: Operator) -> None:
        """For these windows from now on."""
        values = [
            (row.extent, getattr(row, operator.observer) == VISIBLE, row.kept_1) for row in windows
            if getattr(row, operator.observer) in DECIDED and row.kept_1 is not None
        ]  # fmt: skip
        if values == self._values:
            return
        self._values, self.calibration = values, None
        self._background.abandon()
        self._background.start(tr("Find the limit that the verdicts support"), _job(values), self._take)

    def close(self) -> None:
        """Find nothing more."""
        self._background.close()

    def _take(self, calibration: Any) -> None:
        self.calibration = calibration
        self.found.emit()


def _job(values: list[tuple[Extent | None, bool, float]]) -> Job:
    def job(_cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        from ..measure.threshold_calibration import calibrate, verdicts_of

        yield 1.0, calibrate(verdicts_of("kept_1", values), 1.0)

    return job
