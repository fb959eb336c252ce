"""``seaminspector:acceptmosaic``: the decision on a delivery."""
from __future__ import annotations

from dataclasses import replace
from functools import partial
from itertools import chain
from typing import TYPE_CHECKING, Any

from qgis.core import QgsProcessingOutputString
from qgis.PyQt.QtCore import QT_TR_NOOP

from ..imagery.documents import ready_rules
from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.base import SeamInspectorAlgorithm
from ..toolkit.algorithms.run import Run
from ..toolkit.reference_systems import reference_system
from ..toolkit.translation import sentence, tr
from . import stated_rules as stated
from .paper.paper_head import QUALITY, REPORT, add_paper
from .sheet_index import add_sheets, with_sheets
from .stated_rules import LOT_SIZE, SEED, add_plan_parameters

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ..imagery.rasters import Raster, RasterRef
    from .measure.decision import Decision
    from .paper.defect_files import Prover

SEAMS, WINDOWS = "SEAMS", "WINDOWS"
REASONS = "REASONS"
DECISION, ACCEPTED, TOTAL_METRES, MEASURED_METRES = "DECISION", "ACCEPTED", "TOTAL_METRES", "MEASURED_METRES"
FAILED_METRES, FAILED_SHARE, LONGEST_FAILURE = "FAILED_METRES", "FAILED_SHARE", "LONGEST_FAILURE"


class AcceptMosaic(SeamInspectorAlgorithm):
    """Whether a delivery is accepted, and what goes back. The provider has its subclass with proof from orthoimages."""

    ID = "acceptmosaic"
    NAME = QT_TR_NOOP("Accept or reject a delivery")
    HELP = QT_TR_NOOP(
        "Decides on a delivery from the seams of one scan or of many sheets: how many metres failed, how long without "
        "a break, and whether rules or a plan of ISO 2859 accept it, reject it or can't decide, and then what would "
        "decide it. A piece of seam fails when it kept less than required; metres are sums of whole pieces. What could "
        "not be measured never counts as passed."
    )
    PAGES = (REPORT, QUALITY)

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.addDescribed(common.layers(SEAMS, tr("Seams"), common.LINE), tr(
            "The layers 'Seams' of the scans of one delivery, a sheet each, or a sample that 'Plan an inspection' drew "
            "of them."
        ))
        add_sheets(self)
        self._add_limits()
        self.addDescribed(common.choice(stated.PLAN, tr("Plan"), (stated.ALL, stated.ISO2859, stated.ISOLATED)), tr(
            "all: by the metres of all seams and the limits above. iso2859: by the number of failing pieces in a "
            "random sample, as ISO 2859-1 plans it for the lots of a series. iso2859_2: the same for a single "
            "delivery, an isolated lot, by its limiting quality (ISO 2859-2)."
        ))
        add_plan_parameters(self)
        self.addDescribed(
            common.choice(stated.READY_RULES, tr("Ready rules"), list(ready_rules("acceptance")), None, optional=True),
            tr("Rules that come with the plugin, instead of the limits above; leave those at their defaults."),
        )
        self.addDescribed(common.file(stated.RULES, tr("Rules"), "json", optional=True), tr(
            "A JSON file of your own with limits and where they come from, instead of the limits above; leave those at "
            "their defaults. The documentation has an example."
        ))
        self.addDescribed(common.features(WINDOWS, tr("Inspected windows"), common.POLYGON, optional=True), tr(
            "Inspected windows: each gives its cause and remarks to the failures of which it shows a part."
        ))
        add_paper(self)
        self.addOutput(QgsProcessingOutputString(DECISION, tr("accepted, rejected or undecided")))
        self.addOutput(QgsProcessingOutputString(REASONS, tr("Its reasons, in words")))
        self.addNumbers({
            ACCEPTED: tr("Accepted (1), rejected (0), or empty if undecided"),
            TOTAL_METRES: tr("Length of all seams (metres)"),
            MEASURED_METRES: tr("Length that was measured (metres)"),
            FAILED_METRES: tr("Length that failed (metres)"),
            FAILED_SHARE: tr("Share of the measured length that failed (%)"),
            LONGEST_FAILURE: tr("Longest failure without a break (metres)"),
        })

    def check(self, run: Run) -> None:
        stated.stated_rules(run)

    def for_check(self, parameters: dict[str, Any]) -> dict[str, Any]:
        return stated.with_standard_words(super().for_check(parameters))

    def prepare_run(self, run: Run) -> None:
        from ..toolkit.layers import layer_address
        from .delivery_layers import seam_layers

        self._seams = seam_layers(run.raster_values(SEAMS), run.context)
        windows = run.vector_layer(WINDOWS) if run.parameters.get(WINDOWS) else None
        self._windows = "" if windows is None else layer_address(windows)
        rasters = [run.raster_refs(name) for name in (common.MOSAIC, common.SOURCES)]
        (self._mosaics, self._images), notices = zip(*rasters)
        run.tell(*chain(*notices))

    def proof(
        self, run: Run, scanned: Sequence[str], mosaics: Sequence[Raster]
    ) -> tuple[Sequence[str], Prover | None]:
        """Paths of the orthoimages, as given, else as they were scanned; and who proves failures by them."""
        return [ref.path for ref in self._images] or scanned, None

    def execute(self, run: Run) -> dict[str, Any]:
        from ..toolkit.pages.templates import whole_path
        from .paper.inspection_record import InspectionRecord
        from .paper.outputs import write

        decision = self._decision(run)
        run.tell(*decision.sentences)
        whole = decision.whole
        layers = zip(self._seams, decision.delivery.layers)
        seams = tuple((layer.sheet, whole_path(layer.address), read.digest) for layer, read in layers)
        rules = run.text(stated.RULES) if run.parameters.get(stated.RULES) else ""
        record = InspectionRecord(decision, seams, whole_path(self._windows), whole_path(rules))
        return {
            **write(run, record, self._mosaics, partial(self.proof, run)),
            DECISION: decision.outcome.value,
            REASONS: sentence(decision.why),
            ACCEPTED: None if decision.accepted is None else int(decision.accepted),
            TOTAL_METRES: whole.total_m,
            MEASURED_METRES: whole.measured_m,
            FAILED_METRES: whole.failed_m,
            FAILED_SHARE: None if whole.failed_share is None else 100 * whole.failed_share,
            LONGEST_FAILURE: decision.longest_failure_m,
        }

    def _decision(self, run: Run) -> Decision:
        from .delivery_layers import inspected_windows
        from .measure.deciding import decide
        from .measure.delivered_rows import read_layers
        from .measure.scanned_files import file_doubts

        rules = stated.stated_rules(run)
        delivery, notices = read_layers(self._seams)
        run.tell(*notices)
        doubts = file_doubts(delivery, _paths(self._mosaics), _paths(self._images))
        delivery = replace(with_sheets(delivery, run), files=doubts)
        if run.parameters.get(WINDOWS):
            crs = reference_system(delivery.wkt)
            delivery = replace(delivery, windows=inspected_windows(run.source(WINDOWS), crs, run))
        return decide(delivery, rules, run.whole(LOT_SIZE) or None, run.whole(SEED))

    def _add_limits(self) -> None:
        for name, title, words in (
            (stated.MIN_KEPT, tr("Least share of detail kept"),
             tr("A piece of seam fails when its kept_1 is smaller; one that keeps exactly as much passes.")),
            (stated.MAX_SHARE, tr("Largest share that may fail (%)"), tr("Share of the measured metres of seam.")),
            (stated.MAX_RUN, tr("Longest failure without a break (metres)"),
             tr("Failed pieces that follow each other, across seams and sheets where they touch.")),
            (stated.MIN_MEASURED, tr("Least share that has to be measured (%)"),
             tr("Share of the seams on ground with detail. If less was measured, a delivery is not accepted.")),
        ):  # fmt: skip
            limit = common.real(name, title, stated.LIMITS[name], 0.0, stated.MOST[name])
            self.addDescribed(limit, words, advanced=name == stated.MIN_MEASURED)


def _paths(refs: Sequence[RasterRef]) -> list[str]:
    return [path for ref in refs for path in ref.paths]
