"""``seaminspector:calibratethreshold``: the threshold that the operator's own eyes support."""
from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import QgsProcessing, QgsProcessingParameterFeatureSink, QgsProcessingParameterFeatureSource
from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP

from ...imagery.errors import SettingsError
from ...toolkit.algorithms import parameters as common
from ...toolkit.algorithms.base import SeamInspectorAlgorithm
from ...toolkit.algorithms.run import Run
from ...toolkit.translation import tr
from ..measure import messages
from ..measure.window_records import WindowRecord, contrast_of

if TYPE_CHECKING:
    from ..measure.threshold_calibration import ThresholdCalibration, Verdicts

WINDOWS, PAIRS, OUTPUT = "WINDOWS", "PAIRS", "OUTPUT"
MAX_RATIO, AUC, AUC_LOW, AUC_HIGH = "MAX_RATIO", "AUC", "AUC_LOW", "AUC_HIGH"
VISIBLE_COUNT, INVISIBLE_COUNT, WANTED_COUNT = "VISIBLE_COUNT", "INVISIBLE_COUNT", "WANTED_COUNT"

_HIGHEST_RATIO = 1.0  # MAX_RATIO of 'Inspect windows' stays below it


class CalibrateThreshold(SeamInspectorAlgorithm):
    """How well each measure agrees with what an observer saw, and where its limit belongs."""

    ID = "calibratethreshold"
    NAME = QT_TRANSLATE_NOOP("@default", "Calibrate the threshold")
    HELP = QT_TRANSLATE_NOOP(
        "@default",
        "Finds the largest ratio of a significant loss that an observer's verdicts support. For every threshold it "
        "counts how many visible losses would be flagged and how many windows without one in vain: the ROC curve. The "
        "threshold to set is the one with the largest Youden index (sensitivity + specificity - 1); the area under "
        "the curve (AUC) says how well the measure tells both kinds apart, 0.5 being a guess, with its 95 % "
        "bootstrap interval. With fewer than 5 visible or 5 invisible verdicts there is no number."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        table = QgsProcessing.SourceType.TypeVector
        self.addDescribed(
            QgsProcessingParameterFeatureSource(WINDOWS, tr("Inspected windows"), [table]),
            tr(
                "Windows that were inspected and judged: fields 'ratio_1' and 'observer' with the words 'visible' "
                "(a loss was seen at 2x) and 'invisible'; 'composite_ratio_1' takes part where it is there."
            ),
        )
        self.addDescribed(
            QgsProcessingParameterFeatureSource(PAIRS, tr("Pairs"), [table], optional=True),
            tr(
                "The table of pairs of the same windows. With it the absolute contrast 'contrast_1' is judged too: "
                "against the composite where there is one, else the largest over the sources."
            ),
        )
        self.addDescribed(
            QgsProcessingParameterFeatureSink(OUTPUT, tr("Calibration"), table),
            tr(
                "For each measure a summary with the threshold to set, the area and the verdicts wanted, what the "
                "standard limit does, and what every other threshold would do."
            ),
        )
        self.addDescribed(
            *common.chart(tr("ROC curves with their areas, and the judged windows of each measure."), by_default=True)
        )
        self.addNumbers({
            MAX_RATIO: tr("Largest ratio of a significant loss"),
            AUC: tr("Area under the ROC curve"),
            AUC_LOW: tr("Area, lower end of its interval"),
            AUC_HIGH: tr("Area, upper end of its interval"),
            VISIBLE_COUNT: tr("Visible verdicts"),
            INVISIBLE_COUNT: tr("Invisible verdicts"),
            WANTED_COUNT: tr("Verdicts wanted"),
        })

    def execute(self, run: Run) -> dict[str, Any]:
        from ..measure.threshold_calibration import calibrate
        from ..tables import calibration_table

        run.check_chart()
        found = []
        for verdicts in self._verdicts(run):
            most = float("inf") if verdicts.measure == "contrast_1" else _HIGHEST_RATIO
            found.append(calibrate(verdicts, most))
            run.tell(*found[-1].notices)
        output, output_id = run.sink(OUTPUT, calibration_table.calibration_fields())
        for one in found:
            run.write(output, calibration_table.calibration_features(one))
        chart = run.save(common.CHART, lambda path: _save_chart(path, found))
        return {OUTPUT: output_id, **_numbers(found[0]), **chart}

    def _verdicts(self, run: Run) -> list[Verdicts]:
        """The measures that are there, ratio_1 first, in the judged windows."""
        from ...toolkit import layers
        from ..tables.record_tables import check_inspected, read_pairs, read_windows

        windows = run.source(WINDOWS)
        names = windows.fields().names()
        if "observer" not in names:
            raise SettingsError(messages.WINDOWS_WITHOUT_FIELD(field="observer"))
        judged, unknown = [], 0
        check_inspected(names)
        for window in read_windows(layers.features(windows), names):
            judged += [window] if window.observer in ("visible", "invisible") else []
            unknown += window.observer not in ("visible", "invisible", "")
        if unknown:
            run.tell(messages.VERDICTS_UNKNOWN(count=unknown))
        measures = {"ratio_1": [(window, window.ratio) for window in judged]}
        if "composite_ratio_1" in names:
            measures["composite_ratio_1"] = [(window, window.composite_ratio) for window in judged]
        if run.parameters.get(PAIRS):
            table = run.source(PAIRS)
            pairs = read_pairs(layers.features(table), table.fields().names())
            if "contrast_1" in table.fields().names():
                measures["contrast_1"] = [(one, contrast_of(pairs.get(one.window_id, ()))) for one in judged]
            else:  # of an earlier version
                run.tell(messages.PAIRS_WITHOUT_CONTRAST())
        return [self._measured(measure, values, run) for measure, values in measures.items()]

    @staticmethod
    def _measured(measure: str, values: list[tuple[WindowRecord, float | None]], run: Run) -> Verdicts:
        """The windows where the measure has a value, by the observer's word."""
        from ..measure.threshold_calibration import Verdicts

        known = [(window.observer, value) for window, value in values if value is not None]
        if len(known) < len(values):
            run.tell(messages.VERDICTS_WITHOUT_VALUE(measure=measure, count=len(values) - len(known)))
        groups = (tuple(value for word, value in known if word == one) for one in ("visible", "invisible"))
        return Verdicts(measure, *groups)


def _save_chart(path: Path, found: list[ThresholdCalibration]) -> None:
    from ...toolkit.charts.figure_files import save_figure
    from ..charts.calibration_chart import calibration_figure

    save_figure(calibration_figure(found), path)


def _numbers(found: ThresholdCalibration) -> dict[str, float]:
    """What the results say of the first measure; a number that nobody knows is not among them."""
    visible, invisible = len(found.verdicts.visible), len(found.verdicts.invisible)
    numbers: dict[str, float] = {VISIBLE_COUNT: visible, INVISIBLE_COUNT: invisible}
    if found.best is not None:
        numbers[MAX_RATIO] = found.best.threshold
    if found.area is not None:
        numbers.update({AUC: found.area.value, AUC_LOW: found.area.low, AUC_HIGH: found.area.high})
    if found.wanted is not None:
        numbers[WANTED_COUNT] = sum(found.wanted)
    return numbers
