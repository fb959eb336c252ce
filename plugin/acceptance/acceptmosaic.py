"""``seaminspector:acceptmosaic``: the decision on a delivery."""
from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessing,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterFile,
    QgsProcessingParameterMultipleLayers,
)
from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP

from ..imagery.errors import SettingsError
from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.base import SeamInspectorAlgorithm
from ..toolkit.algorithms.run import Run
from ..toolkit.translation import tr
from . import stated_rules as stated
from .measure import messages
from .measure.acceptance_rules import ready_files
from .paper import outputs as paper
from .sheet_index import add_sheets, with_sheets
from .stated_rules import LOT_SIZE, SEED, add_plan_parameters

if TYPE_CHECKING:
    from .measure.decision import Decision

SEAMS, WINDOWS, JUDGE = "SEAMS", "WINDOWS", "JUDGE"
TOOL, OBSERVER = "tool", "observer"
ACCEPTED, TOTAL_METRES, MEASURED_METRES = "ACCEPTED", "TOTAL_METRES", "MEASURED_METRES"
FAILED_METRES, FAILED_SHARE, LONGEST_FAILURE = "FAILED_METRES", "FAILED_SHARE", "LONGEST_FAILURE"


class AcceptMosaic(SeamInspectorAlgorithm):
    """Whether a delivery is accepted, and what goes back."""

    ID = "acceptmosaic"
    NAME = QT_TRANSLATE_NOOP("@default", "Accept or reject a delivery")
    HELP = QT_TRANSLATE_NOOP(
        "@default",
        "Decides on a delivery from the seams of one scan or of many sheets: how many metres failed, how long without "
        "a break, and by rules or a plan of ISO 2859-1 whether that is accepted, with the risk of it. A piece "
        "of seam fails when it kept less than is asked for. What could not be measured never counts as passed."
    )
    RASTER_LISTS = (SEAMS, paper.MOSAIC)
    PAGES = (paper.REPORT, paper.QUALITY)

    def initAlgorithm(self, configuration: Any = None) -> None:
        line, polygon = QgsProcessing.SourceType.TypeVectorLine, QgsProcessing.SourceType.TypeVectorPolygon
        self.addDescribed(
            QgsProcessingParameterMultipleLayers(SEAMS, tr("Seams"), line),
            tr(
                "The layers 'Seams' of the scans of one delivery, a sheet each, or a sample that 'Plan an inspection' "
                "drew of them."
            ),
        )
        add_sheets(self)
        self._add_limits()
        self.addDescribed(
            common.choice(stated.PLAN, tr("Plan"), (stated.ALL, stated.ISO2859)),
            tr(
                "all: by the metres of all seams and the limits above. iso2859: by the number of failing pieces in a "
                "random sample, as ISO 2859-1 plans it for the lot."
            ),
        )
        add_plan_parameters(self)
        self.addDescribed(
            common.choice(stated.READY_RULES, tr("Ready rules"), list(ready_files()), None, optional=True),
            tr("Rules that come with the plugin, instead of the limits above; these then stay as they are."),
        )
        self.addDescribed(
            QgsProcessingParameterFile(stated.RULES, tr("Rules"), extension="json", optional=True),
            tr(
                "A JSON file of your own with limits and where they come from, instead of the limits above; these then "
                "stay as they are. The documentation shows one."
            ),
        )
        self.addDescribed(
            QgsProcessingParameterFeatureSource(WINDOWS, tr("Inspected windows"), [polygon], optional=True),
            tr(
                "Windows that were inspected, and judged perhaps: their causes and remarks go to the failures in them, "
                "and the agreement of operators and tool is told."
            ),
        )
        self.addDescribed(
            common.choice(JUDGE, tr("Who judges"), (TOOL, OBSERVER)),
            tr(
                "tool: a piece fails by what it kept. observer: by what the operator saw in the window over it; what "
                "nobody judged counts as not measured."
            ),
            advanced=True,
        )
        paper.add_inputs(self)
        paper.add_outputs(self)
        self.addDescribed(*common.chart(tr(
            "The plan's operating characteristic; without a plan how many metres kept how much."
        )))
        self.addNumbers({
            ACCEPTED: tr("Accepted (1) or not (0)"),
            TOTAL_METRES: tr("Length of all seams (metres)"),
            MEASURED_METRES: tr("Length that was measured (metres)"),
            FAILED_METRES: tr("Length that failed (metres)"),
            FAILED_SHARE: tr("Share of the measured length that failed (%)"),
            LONGEST_FAILURE: tr("Longest failure without a break (metres)"),
        })

    def check(self, run: Run) -> None:
        stated.stated_rules(run)
        self._by_observer(run)
        run.check_chart()

    @staticmethod
    def _by_observer(run: Run) -> bool:
        """Raises SettingsError where there are no windows that an observer could have judged."""
        by_observer = stated.known_word(run, JUDGE, (TOOL, OBSERVER)) == OBSERVER
        if by_observer and not run.parameters.get(WINDOWS):
            raise SettingsError(messages.NO_JUDGED_WINDOWS())
        return by_observer

    def for_check(self, parameters: dict[str, Any]) -> dict[str, Any]:
        return stated.with_standard_aql(super().for_check(parameters))

    def prepare(self, run: Run) -> None:
        from ..toolkit.layers import layer_address
        from .delivery_layers import seam_layers

        needed = "" if self._by_observer(run) else "kept_1"
        self._seams, self._told = seam_layers(run.raster_values(SEAMS), run.context, needed)
        windows = run.vector_layer(WINDOWS) if run.parameters.get(WINDOWS) else None
        self._windows = "" if windows is None else layer_address(windows)
        self._paper = paper.prepare(run)

    def execute(self, run: Run) -> dict[str, Any]:
        decision = self._decision(run)
        run.tell(*decision.sentences)
        whole = decision.whole
        seams = tuple((layer.sheet, layer.address) for layer in self._seams)
        rules = run.text(stated.RULES) if run.parameters.get(stated.RULES) else ""
        return {
            **paper.write(run, decision, self._paper, seams, self._windows, rules),
            **run.save(common.CHART, lambda path: _save_chart(path, decision)),
            ACCEPTED: int(decision.accepted),
            TOTAL_METRES: whole.total_m,
            MEASURED_METRES: whole.measured_m,
            FAILED_METRES: whole.failed_m,
            FAILED_SHARE: None if whole.failed_share is None else 100 * whole.failed_share,
            LONGEST_FAILURE: decision.longest_failure_m,
        }

    def _decision(self, run: Run) -> Decision:
        from .delivery_layers import judged_windows, read_delivery
        from .measure.deciding import decide

        rules = stated.stated_rules(run)
        run.check_chart()
        run.tell(*self._told)
        delivery, told = read_delivery(self._seams, run.context.transformContext())
        run.tell(*told)
        delivery = with_sheets(delivery, run)
        if run.parameters.get(WINDOWS):
            crs = QgsCoordinateReferenceSystem.fromWkt(delivery.wkt)
            delivery = replace(delivery, windows=judged_windows(run.source(WINDOWS), crs, run))
        return decide(delivery, rules, run.whole(LOT_SIZE) or None, run.whole(SEED), self._by_observer(run))

    def _add_limits(self) -> None:
        self.addDescribed(
            common.real(stated.MIN_KEPT, tr("Least share of detail kept"), stated.LIMITS[stated.MIN_KEPT], 0.0),
            tr("A piece of seam fails when its kept_1 is smaller; one that keeps exactly as much passes."),
        )
        self.addDescribed(
            common.real(
                stated.MAX_SHARE, tr("Largest share that may fail (%)"), stated.LIMITS[stated.MAX_SHARE], 0.0
            ),
            tr("Of the metres of seam that were measured."),
        )
        self.addDescribed(
            common.real(
                stated.MAX_RUN, tr("Longest failure without a break (metres)"), stated.LIMITS[stated.MAX_RUN], 0.0
            ),
            tr("Failed pieces that follow each other, across seams and sheets where they touch."),
        )
        self.addDescribed(
            common.real(
                stated.MIN_MEASURED, tr("Least share that has to be measured (%)"),
                stated.LIMITS[stated.MIN_MEASURED], 0.0,
            ),
            tr("With less of the metres measured a delivery is not accepted."),
            advanced=True,
        )


def _save_chart(path: Path, decision: Decision) -> None:
    from ..toolkit.charts.figure_files import save_figure
    from .paper.charts import kept_figure, oc_figure

    save_figure(kept_figure(decision) if decision.plan is None else oc_figure(decision.plan), path)
