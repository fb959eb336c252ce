"""``seaminspector:calibratethreshold``: the threshold that the operator's own eyes support."""
from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any, Optional

from qgis.PyQt.QtCore import QT_TR_NOOP

from ...imagery.errors import SettingsError
from ...imagery.statistics import UNSURE, VISIBLE
from ...toolkit.algorithms import parameters as common
from ...toolkit.algorithms.base import SeamInspectorAlgorithm
from ...toolkit.algorithms.run import Run
from ...toolkit.translation import tr
from ..measure import messages
from ..measure.window_records import WindowRecord, contrast_of

if TYPE_CHECKING:
    from ..measure.calibration.threshold_calibration import ThresholdCalibration, Verdicts

WINDOWS, PAIRS, MEASURE, OUTPUT = "WINDOWS", "PAIRS", "MEASURE", "OUTPUT"
MAX_RATIO, AUC, AUC_LOW, AUC_HIGH = "MAX_RATIO", "AUC", "AUC_LOW", "AUC_HIGH"
VISIBLE_COUNT, INVISIBLE_COUNT, WANTED_COUNT = "VISIBLE_COUNT", "INVISIBLE_COUNT", "WANTED_COUNT"

_KEPT, _COMPOSITE_RATIO, _CONTRAST, _RATIO = "kept_1", "composite_ratio_1", "contrast_1", "ratio_1"
_VISIBILITY = "visibility"
_MEASURES = (_KEPT, _VISIBILITY, _COMPOSITE_RATIO, _CONTRAST, _RATIO)
_HIGHEST_RATIO = 1.0  # a ratio that is a limit stays below it
_UNBOUNDED = (_CONTRAST, _VISIBILITY)

_Values = list[tuple[WindowRecord, Optional[float]]]


class CalibrateThreshold(SeamInspectorAlgorithm):
    """How well each measure agrees with what an observer saw, and where its limit belongs."""

    ID = "calibratethreshold"
    NAME = QT_TR_NOOP("Calibrate the threshold")
    HELP = QT_TR_NOOP(
        "Finds the limit of a significant loss that an observer's verdicts support. For every threshold it counts "
        "how many visible losses would be flagged and how many windows without one would be flagged by mistake: the "
        "ROC curve. The threshold to set is the one with the largest Youden index (sensitivity + specificity - 1) of "
        "the smoothed verdicts, with the 95 % interval of the true one; the area under the curve (AUC) says how well "
        "the measure tells both kinds apart, 0.5 being a guess, with its 95 % bootstrap interval. Windows that lie "
        "near each other are resampled together. With fewer than 5 visible or 5 invisible verdicts there is no "
        "number."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.addDescribed(common.features(WINDOWS, tr("Inspected windows"), common.TABLE), tr(
            "Windows that were inspected and judged: the field 'observer' with the words 'visible' (a loss was seen at "
            "2x) and 'invisible' ('unsure' does not count), and the measures 'kept_1', 'visibility', "
            "'composite_ratio_1', 'contrast_1' and 'ratio_1', as far as they exist."
        ))
        self.addDescribed(common.features(PAIRS, tr("Pairs"), common.TABLE, optional=True), tr(
            "The table of pairs of the same windows. With it the absolute contrast 'contrast_1' is judged too: against "
            "the composite where there is one, else the largest over the sources."
        ))
        self.addDescribed(common.choice(MEASURE, tr("Measure"), _MEASURES, default=None, optional=True), tr(
            "The measure whose figures are given as outputs: the one the windows are judged by. Not set: 'kept_1' "
            "where the judged windows have it, else 'ratio_1'. The table and the chart hold all measures."
        ))
        self.addDescribed(common.result(OUTPUT, tr("Calibration"), common.TABLE), tr(
            "For each measure a summary with the threshold to set, its range, the area and the verdicts wanted, what "
            "the standard limit does, and what every other threshold would do."
        ))
        self.addDescribed(*common.chart(tr(
            "ROC curves with their areas, and the judged windows of each measure."
        ), by_default=True))
        self.addNumbers({
            MAX_RATIO: tr("Threshold of the measure"),
            AUC: tr("Area under the ROC curve"),
            AUC_LOW: tr("Area, lower end of its interval"),
            AUC_HIGH: tr("Area, upper end of its interval"),
            VISIBLE_COUNT: tr("Visible verdicts"),
            INVISIBLE_COUNT: tr("Invisible verdicts"),
            WANTED_COUNT: tr("Verdicts wanted"),
        })

    def execute(self, run: Run) -> dict[str, Any]:
        from ..measure.calibration.threshold_calibration import calibrate
        from ..tables.result_tables import calibration_features, calibration_fields

        calibrations = []
        for verdicts in self._verdicts(run):
            most = float("inf") if verdicts.measure in _UNBOUNDED else _HIGHEST_RATIO
            calibrations.append(calibrate(verdicts, most))
            run.tell(*calibrations[-1].notices)
        output, output_id = run.sink(OUTPUT, calibration_fields())
        for calibration in calibrations:
            run.write(output, calibration_features(calibration))
        chart = run.save(common.CHART, lambda path: _save_chart(path, calibrations))
        return {OUTPUT: output_id, **_numbers(calibrations[0]), **chart}

    def _verdicts(self, run: Run) -> list[Verdicts]:
        """The measures that are there in the judged windows, the one that the numbers are of first."""
        names, judged = self._judged(run)
        measures = self._measures(run, names, judged)
        asked = run.word(MEASURE)
        if asked and asked not in measures:
            raise SettingsError(messages.WINDOWS_WITHOUT_FIELD(field=asked))
        has_kept = any(value is not None for _, value in measures.get(_KEPT, ()))
        first = asked or next(name for name in ((_KEPT,) if has_kept else ()) + (_RATIO, *measures) if name in measures)
        ordered = sorted(measures, key=lambda measure: measure != first)
        return [self._measured(measure, measures[measure], run) for measure in ordered]

    @staticmethod
    def _judged(run: Run) -> tuple[list[str], list[WindowRecord]]:
        """The windows' fields, and those that an observer judged."""
        from ...toolkit import layers
        from ..measure.calibration.threshold_calibration import agreement
        from ..tables.record_tables import doubts, read_windows

        windows = run.source(WINDOWS)
        names = windows.fields().names()
        if "observer" not in names:
            raise SettingsError(messages.WINDOWS_WITHOUT_FIELD(field="observer"))
        observed = [window for window in read_windows(layers.features(windows), names) if window.observer]
        judged = [window for window in observed if window.is_judged]
        run.tell(*doubts(judged))
        count, agreed, kappa = agreement([(window.observer, window.observer_2) for window in observed])
        if kappa is not None:
            run.tell(messages.OPERATORS_AGREE(
                count=count, agreed=agreed, kappa=kappa.value, low=kappa.low, high=kappa.high
            ))
        unsure = sum(window.observer == UNSURE for window in observed)
        if len(judged) + unsure < len(observed):
            run.tell(messages.VERDICTS_UNKNOWN(count=len(observed) - len(judged) - unsure))
        without = sum(window.extent is None for window in judged)
        if without:
            run.tell(messages.VERDICTS_WITHOUT_OUTLINE(count=without))
        return names, judged

    @staticmethod
    def _measures(run: Run, names: list[str], judged: list[WindowRecord]) -> dict[str, _Values]:
        """What is there of each measure."""
        from ...toolkit import layers
        from ..tables.record_tables import check_inspected, read_pairs

        read = {
            _KEPT: lambda window: window.kept_1,
            _VISIBILITY: lambda window: window.visibility,
            _COMPOSITE_RATIO: lambda window: window.composite_ratio,
            _CONTRAST: lambda window: window.contrast,
            _RATIO: lambda window: window.ratio,
        }
        if run.parameters.get(PAIRS):
            table = run.source(PAIRS)
            pairs = read_pairs(layers.features(table), table.fields().names())
            if _CONTRAST in table.fields().names():
                names = [*names, _CONTRAST]
                read[_CONTRAST] = lambda window: contrast_of(pairs.get(window.window_id, ()))
        values = {
            measure: [(window, read[measure](window)) for window in judged] for measure in _MEASURES if measure in names
        }
        if not values:
            check_inspected(names)
        return values

    @staticmethod
    def _measured(measure: str, values: _Values, run: Run) -> Verdicts:
        """The windows where the measure has a value, by the observer's word, and their neighbourhoods."""
        from ..measure.calibration.threshold_calibration import verdicts_of

        known = [(window, value) for window, value in values if value is not None]
        if len(known) < len(values):
            run.tell(messages.VERDICTS_WITHOUT_VALUE(measure=measure, count=len(values) - len(known)))
        placed = [(window.extent, window.observer == VISIBLE, value) for window, value in known]
        return verdicts_of(measure, placed, is_loss=measure == _VISIBILITY)


def _save_chart(path: Path, calibrations: list[ThresholdCalibration]) -> None:
    from ...toolkit.charts.figure_files import save_figure
    from ..charts.calibration_chart import calibration_figure

    save_figure(calibration_figure(calibrations), path)


def _numbers(calibration: ThresholdCalibration) -> dict[str, float]:
    """What the results say of the first measure; a number that nobody knows is not among them."""
    visible, invisible = len(calibration.verdicts.visible), len(calibration.verdicts.invisible)
    numbers: dict[str, float] = {VISIBLE_COUNT: visible, INVISIBLE_COUNT: invisible}
    if calibration.best is not None:
        numbers[MAX_RATIO] = calibration.best.threshold
    if calibration.area is not None:
        numbers.update({AUC: calibration.area.value, AUC_LOW: calibration.area.low, AUC_HIGH: calibration.area.high})
    if calibration.wanted is not None:
        numbers[WANTED_COUNT] = sum(calibration.wanted)
    return numbers
