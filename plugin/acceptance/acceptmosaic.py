"""``seaminspector:acceptmosaic``: the decision on a delivery."""
from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsProcessing,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterFile,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterMultipleLayers,
    QgsProcessingParameterRasterLayer,
)
from qgis.PyQt.QtCore import QT_TR_NOOP

from ..imagery.errors import SettingsError
from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.base import SeamInspectorAlgorithm
from ..toolkit.algorithms.run import Run
from ..toolkit.reference_systems import reference_system
from ..toolkit.translation import filled, tr
from . import stated_rules as stated
from .measure import messages
from .measure.acceptance_rules import ready_files
from .sheet_index import add_sheets, with_sheets
from .stated_rules import LOT_SIZE, SEED, add_plan_parameters

if TYPE_CHECKING:
    from .measure.decision import Decision

MOST_PICTURES = 100  # of a delivery, of the longest failures: some 12 MB of report

LOSS, DEFECTS, REPORT, QUALITY = "LOSS", "DEFECTS", common.REPORT, "QUALITY"
SEAMS, WINDOWS, JUDGE = "SEAMS", "WINDOWS", "JUDGE"
TOOL, OBSERVER = "tool", "observer"
ACCEPTED, TOTAL_METRES, MEASURED_METRES = "ACCEPTED", "TOTAL_METRES", "MEASURED_METRES"
FAILED_METRES, FAILED_SHARE, LONGEST_FAILURE = "FAILED_METRES", "FAILED_SHARE", "LONGEST_FAILURE"


class AcceptMosaic(SeamInspectorAlgorithm):
    """Whether a delivery is accepted, and what goes back."""

    ID = "acceptmosaic"
    NAME = QT_TR_NOOP("Accept or reject a delivery")
    HELP = QT_TR_NOOP(
        "Decides on a delivery from the seams of one scan or of many sheets: how many metres failed, how long without "
        "a break, and by rules or a plan of ISO 2859-1 whether that is accepted, with the risk of it. A piece "
        "of seam fails when it kept less than is asked for. What could not be measured never counts as passed."
    )
    RASTER_LISTS = (SEAMS, common.MOSAIC)
    PAGES = (REPORT, QUALITY)

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
        self._add_paper()
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
        self._mosaics, left_out = run.raster_refs(common.MOSAIC)
        run.tell(*left_out)
        self._loss = run.raster(LOSS)

    def execute(self, run: Run) -> dict[str, Any]:
        from .paper.outputs import write

        decision = self._decision(run)
        run.tell(*decision.sentences)
        whole = decision.whole
        seams = tuple((layer.sheet, layer.address) for layer in self._seams)
        rules = run.text(stated.RULES) if run.parameters.get(stated.RULES) else ""
        return {
            **write(run, decision, self._mosaics, self._loss, seams, self._windows, rules),
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
            crs = reference_system(delivery.wkt)
            delivery = replace(delivery, windows=judged_windows(run.source(WINDOWS), crs, run))
        return decide(delivery, rules, run.whole(LOT_SIZE) or None, run.whole(SEED), self._by_observer(run))

    def _add_paper(self) -> None:
        """What is shown beside the decision, and what is written."""
        self.addDescribed(
            QgsProcessingParameterMultipleLayers(
                common.MOSAIC, tr("Mosaic"), QgsProcessing.SourceType.TypeRaster, optional=True
            ),
            tr("The mosaic or its sheets: pictures of the failures are cut from them, for the layer and the report."),
        )
        self.addDescribed(
            QgsProcessingParameterRasterLayer(LOSS, tr("Picture of losses"), optional=True),
            tr("As the scan wrote it: the XML refers to it, and it says how the seams were measured."),
            advanced=True,
        )
        self.addDescribed(
            QgsProcessingParameterFeatureSink(
                DEFECTS, tr("Failures"), QgsProcessing.SourceType.TypeVectorLine, optional=True, createByDefault=True
            ),
            tr(
                "One feature for each failure without a break, for the producer: place, length, what is kept, the two "
                "orthoimages and their dates, remarks, and a picture in a folder beside the file. GeoPackage or CSV."
            ),
        )
        self.addDescribed(*common.report(filled(tr(
            "The decision on paper, to be signed: rules, sheets, a map, the failures with pictures of the longest "
            "{most}, the plan's risk. Opens in a browser and prints on A4."
        ), most=MOST_PICTURES), by_default=True))
        self.addDescribed(
            QgsProcessingParameterFileDestination(
                QUALITY, tr("Quality record (ISO 19157)"), "XML (*.xml)", optional=True, createByDefault=False
            ),
            tr(
                "The figures and the decision as a catalogue reads them: ISO 19157:2013 in the XML of ISO/TS "
                "19157-2:2016."
            ),
        )

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
