"""``seaminspector:checkradiometry``: the radiometric acceptance of images against rules."""
from __future__ import annotations

import math
import re
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import QgsProcessingOutputString, QgsProcessingParameterNumber, QgsProcessingParameterRange
from qgis.PyQt.QtCore import QT_TR_NOOP

from ..imagery import messages as imagery_messages
from ..imagery.errors import SettingsError
from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.base import IMAGE_QUALITY
from ..toolkit.algorithms.raster_lists import RASTERS, WINDOWS, RasterListAlgorithm
from ..toolkit.algorithms.run import Run
from ..toolkit.table_fields import column_fields, text
from ..toolkit.translation import filled, tr
from .measure import messages
from .measure.rules import DEFAULT_RULES, ready_rule_files

if TYPE_CHECKING:
    from ..imagery.errors import Message
    from ..imagery.rasters import RasterRef, ValueRange
    from .measure.assessment import Assessment, RadiometricDecision
    from .measure.rules import RuleSet

READY_RULES, RULES, VALUE_RANGE, GREY_AREAS = "READY_RULES", "RULES", "VALUE_RANGE", "GREY_AREAS"
SHEETS, SEAMLINES, OUTPUT, MAYBE_GREY = "SHEETS", "SEAMLINES", "OUTPUT", "MAYBE_GREY"
_STATE, _NOT_ORDERED = "state", "not_ordered"  # of a file that is no part of the delivery for 'Check a delivery'
_LOCATION = "location"  # the field of a sheet's file, as gdaltindex and 'Check a delivery' write it
PASSED_COUNT, FAILED_COUNT, NOT_MEASURABLE_COUNT = "PASSED_COUNT", "FAILED_COUNT", "NOT_MEASURABLE_COUNT"
DECISION, REASONS = "DECISION", "REASONS"


class CheckRadiometry(RasterListAlgorithm):
    """Whether images keep the limits of a specification."""

    ID = "checkradiometry"
    NAME = QT_TR_NOOP("Check radiometry")
    GROUP = IMAGE_QUALITY
    HELP = QT_TR_NOOP(
        "Checks images against the limits of a specification, by default JRC's for orthoimages in the LPIS: clipped "
        "tails, peak of the histogram and contrast of the luminosity, signal to noise on uniform mid-tone areas, "
        "colour balance on grey areas that you give, and with seamlines the step of tone at the seams. Whole rasters "
        "are streamed in blocks. What can't be measured is listed with the reason; nothing is accepted on a guess."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.addDescribed(common.layers(RASTERS, tr("Rasters"), optional=True), tr(
            "The images to be checked, each on its own."
        ))
        self.addDescribed(common.features(SHEETS, tr("Sheets"), common.POLYGON, optional=True), tr(
            "Alone or beside the rasters: the sheets that 'Check a delivery' wrote, or a tile index as gdaltindex "
            "writes it. The files that their field 'location' names are checked."
        ))
        self.addDescribed(common.features(WINDOWS, tr("Windows"), common.POLYGON, optional=True), tr(
            "Rectangles in any reference system; each is checked separately on all rasters under it. Without windows "
            "each raster is checked as a whole."
        ))
        self.addDescribed(common.choice(READY_RULES, tr("Ready rules"), list(ready_rule_files()), DEFAULT_RULES), tr(
            "jrc_lpis: as JRC's text says, clipping, peak and contrast of the luminosity. jrc_lpis_each_band: "
            "stricter, each band is held to the limits, and signal to noise and colour balance have to be known."
        ))
        self.addDescribed(common.file(RULES, tr("Rules"), "json", optional=True), tr(
            "A JSON file of your own with the limits and where they come from, instead of the ready rules; the "
            "documentation has one to start from."
        ))
        number = QgsProcessingParameterNumber.Type.Double
        self.addDescribed(QgsProcessingParameterRange(VALUE_RANGE, tr("Range of values"), number, optional=True), tr(
            "The lowest and highest value that pixels can have, such as 0 to 4095 for 12 bits in 16. Needed where "
            "neither the file (NBITS) nor all files together show it: without it nothing that depends on it is judged."
        ))
        self.addDescribed(common.features(GREY_AREAS, tr("Grey areas"), common.POLYGON, optional=True), tr(
            "Polygons on surfaces that are grey: roads, roofs, concrete. The colour balance is measured on them; "
            "without them it is not measurable, since a cast looks the same as the colour of the ground."
        ))
        self.addDescribed(common.features(SEAMLINES, tr("Seamlines"), common.LINE, common.POLYGON, optional=True), tr(
            "Lines, or polygons that are each filled from one orthoimage: the step of tone at the seams is measured on "
            "the rasters they cross, 2 to 10 px on either side."
        ))
        self.addDescribed(common.result(OUTPUT, tr("Radiometry"), common.TABLE), tr(
            "One row per raster or window, check and band: value, limit, whether it passed, and the rule's source."
        ))
        self.addDescribed(
            common.result(MAYBE_GREY, tr("What may be grey"), common.POLYGON, optional=True, by_default=False),
            tr(
                "Uniform areas with little colour, where no grey areas are given: look at them, delete what is not "
                "grey, and give the others as grey areas."
            ),
        )
        self.addDescribed(*common.report(tr("The decision and all figures with the histograms on one HTML page.")))
        self.addOutput(QgsProcessingOutputString(DECISION, tr("Decision: accepted, rejected or undecided")))
        self.addOutput(QgsProcessingOutputString(REASONS, tr("Reasons of the decision")))
        self.addNumbers({
            PASSED_COUNT: tr("Figures that passed"),
            FAILED_COUNT: tr("Figures that failed"),
            NOT_MEASURABLE_COUNT: tr("Figures that can't be measured"),
        })

    def check(self, run: Run) -> None:
        if not run.parameters.get(SHEETS):
            super().check(run)
        self._rules(run)

    def prepare_run(self, run: Run) -> None:
        from ..toolkit.layers import layer_path

        super().prepare_run(run)
        index = run.vector_layer(SHEETS) if run.parameters.get(SHEETS) else None
        self._home = Path(layer_path(index) if index is not None else "").parent

    def execute(self, run: Run) -> dict[str, Any]:
        from . import image_set, words
        from .image_set import DrawnLayers, assessed, jobs_on
        from .measure.assessment import decide

        self.check(run)
        rules = self._rules(run)
        drawn = self.drawn_windows(run)
        images = self.opened([*self.refs[RASTERS], *self._indexed(run)])
        self.require_rasters(images)
        run.tell_once(self.left_out)
        sink, output_id = run.sink(OUTPUT, column_fields(image_set.COLUMNS))
        grey_sink, grey_id = run.optional_sink(MAYBE_GREY, *image_set.maybe_grey_layout(images))
        unseen = list(self.left_out)
        jobs = list(jobs_on(images, drawn, unseen))
        run.tell_once(unseen[len(self.left_out) :])
        results: list[Assessment] = []
        drawn_on = DrawnLayers(run, *(run.source(name) if run.parameters.get(name) else None
                                      for name in (SEAMLINES, GREY_AREAS)))  # fmt: skip
        for result in assessed(drawn_on, rules, jobs, unseen):
            run.write(sink, image_set.radiometry_features(result))
            run.write(grey_sink, image_set.maybe_grey_features(result, images, run.context.transformContext()))
            run.tell_once(result.notices)
            for sentence in words.found_words(result):
                run.feedback.pushInfo(f"{words.title(result)}: {sentence}")
            results.append(result)
        if not results and not run.is_cancelled():
            raise SettingsError(imagery_messages.NOTHING_MEASURED(why=tuple(unseen[-1:])))
        decision = None
        if not run.is_cancelled():
            decision = decide(results, unseen)
            run.feedback.pushInfo(filled(tr("Radiometry: {word}."), word=words.decision_word(decision)))
            for reason in words.decision_reasons(decision):
                run.feedback.pushInfo(reason)
        figures = [checked for result in results for checked in result.checked_figures]
        states = [checked.passed for checked in figures]
        return {
            OUTPUT: output_id,
            MAYBE_GREY: grey_id,
            **({} if decision is None else {
                **run.save(common.REPORT, lambda path: _save_report(path, decision, unseen, rules)),
                DECISION: decision.outcome,
                REASONS: " ".join(words.decision_reasons(decision)),
            }),
            PASSED_COUNT: states.count(True),
            FAILED_COUNT: states.count(False),
            NOT_MEASURABLE_COUNT: sum(checked.value is None for checked in figures),
        }  # fmt: skip

    def _indexed(self, run: Run) -> list[RasterRef]:
        """The files of SHEETS; sheets without one, and files that nobody ordered, are left out.

        Raises SettingsError for another layer.
        """
        from ..imagery.rasters import RasterRef
        from ..toolkit.layers import features

        if not run.parameters.get(SHEETS):
            return []
        source = run.source(SHEETS)
        names = source.fields().names()
        if _LOCATION not in names:
            raise SettingsError(messages.SHEETS_WITHOUT_FILES(name=source.sourceName(), field=_LOCATION))
        ordered = (row for row in features(source) if _STATE not in names or text(row[_STATE]) != _NOT_ORDERED)
        paths = (text(row[_LOCATION]) for row in ordered)
        return [RasterRef(str(self._home / path)) for path in paths if path]

    def _rules(self, run: Run) -> RuleSet:
        from .measure.rules import load_rules

        chosen = run.text(RULES) if run.parameters.get(RULES) else ""
        path = Path(chosen) if chosen else ready_rule_files()[run.word(READY_RULES) or DEFAULT_RULES]
        rules = load_rules(path, tr)
        given = self._value_range(run)
        return rules if given is None else replace(rules, value_range=given)

    def _value_range(self, run: Run) -> ValueRange | None:
        value = run.parameters.get(VALUE_RANGE)
        if value is None or set(re.findall(r"[^\s,()[\]]+", str(value).lower())) <= {"nan", "none"}:
            return None  # the form says "None,None" with nothing in it
        low, high = map(float, self.parameterAsRange(run.parameters, VALUE_RANGE, run.context))
        if not (math.isfinite(low) and math.isfinite(high) and low < high):
            raise SettingsError(messages.VALUE_RANGE_BAD())
        return low, high


def _save_report(path: Path, decision: RadiometricDecision, unseen: Iterable[Message], rules: RuleSet) -> None:
    from .report import save_radiometry_report

    save_radiometry_report(path, decision, unseen, rules)
