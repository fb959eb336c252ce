"""``seaminspector:planinspection``: a random sample of a delivery, to be judged."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsGeometry,
    QgsLineString,
    QgsProcessing,
    QgsProcessingOutputString,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterMultipleLayers,
    QgsProcessingParameterNumber,
    QgsProcessingParameterString,
    QgsWkbTypes,
)
from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP

from ..imagery import limits as imagery_limits
from ..imagery.errors import SettingsError
from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.base import SeamInspectorAlgorithm
from ..toolkit.algorithms.run import Run
from ..toolkit.translation import tr
from . import stated_rules as stated
from .measure import acceptance_rules as limits
from .measure import messages
from .measure.sampling_plans import INSPECTION_LEVELS, SEVERITIES
from .sheet_index import add_sheets, with_sheets
from .stated_rules import LOT_SIZE, SEED, add_plan_parameters

if TYPE_CHECKING:
    from ..imagery.rasters import Raster
    from .measure.delivery import DeliveredPiece, Delivery
    from .measure.sampling_plans import SamplingPlan
    from .measure.sampling_risks import RiskPlan, StatedRisk
    from .planned_sample import SampledItem

SEAMS, UNIT, SIDE, PIECE, SHEET_FIELD, COUNT = "SEAMS", "UNIT", "SIDE", "PIECE", "SHEET_FIELD", "COUNT"
GOOD_SHARE, PRODUCERS_RISK = "GOOD_SHARE", "PRODUCERS_RISK"
BAD_SHARE, CONSUMERS_RISK, CORRELATION = "BAD_SHARE", "CONSUMERS_RISK", "CORRELATION"
OUTPUT, SAMPLE_SIZE, ACCEPTANCE_NUMBER, CODE_LETTER = "OUTPUT", "SAMPLE_SIZE", "ACCEPTANCE_NUMBER", "CODE_LETTER"
RISK, BY_COUNT = "risk", "count"
PIECES, WINDOWS = "pieces", "windows"


class PlanInspection(SeamInspectorAlgorithm):
    """Which pieces of seam to look at when not all are."""

    ID = "planinspection"
    NAME = QT_TRANSLATE_NOOP("@default", "Plan an inspection")
    HELP = QT_TRANSLATE_NOOP(
        "@default",
        "Draws a random sample of the seams of a delivery, in proportion from every sheet: as large as ISO 2859-1 asks "
        "for, as stated risks ask for, or as large as you say. The sample comes as pieces of seam for 'Accept or "
        "reject a delivery', or as windows that open in the dock to be judged. The same seed draws the same sample."
    )
    RASTER_LISTS = (SEAMS,)

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.addDescribed(
            QgsProcessingParameterMultipleLayers(SEAMS, tr("Seams"), QgsProcessing.SourceType.TypeVectorLine),
            tr("Layers 'Seams' of scans, a sheet each, or plain seamlines: these are cut into pieces first."),
        )
        add_sheets(self)
        self.addDescribed(
            common.choice(stated.PLAN, tr("Plan"), (stated.ISO2859, RISK, BY_COUNT)),
            tr(
                "How many: iso2859, as the standard's tables say for the lot; risk, as few as keep the risks below; "
                "count, as many as you say."
            ),
        )
        add_plan_parameters(self)
        self.addDescribed(
            QgsProcessingParameterNumber(
                COUNT, tr("Count"), QgsProcessingParameterNumber.Type.Integer, 50, minValue=1
            ),
            tr("How many are drawn with the plan 'count'."),
        )
        self._add_risks()
        self.addDescribed(
            common.choice(UNIT, tr("Unit"), (PIECES, WINDOWS)),
            tr("pieces: pieces of seam, as lines. windows: one around the middle of each, on the mosaic's pixels."),
        )
        self.addDescribed(
            common.mosaic(optional=True)[0],
            tr(
                "What windows are placed on; pieces that do not lie on it are no part of the lot. With it and the same "
                "seed, windows and pieces are one sample."
            ),
        )
        self.addDescribed(
            common.real(SIDE, tr("Window side (metres)"), imagery_limits.STANDARD_SIDE_M, 0.01),
            tr("What a window spans at least: 100 m at 0.10 m pixels gives 1024 pixels, 102.4 m."),
        )
        self.addDescribed(
            common.real(PIECE, tr("Length of a piece (metres)"), limits.STANDARD_PIECE_M, 0.01),
            tr("Plain seamlines are cut into pieces of about this length; those of a scan stay as they are."),
        )
        self.addDescribed(
            QgsProcessingParameterString(SHEET_FIELD, tr("Field of the sheets"), optional=True),
            tr("Whose values the sample is drawn from in proportion. Empty: layer by layer."),
            advanced=True,
        )
        self.addDescribed(
            QgsProcessingParameterFeatureSink(OUTPUT, tr("Sample")),
            tr("The sample: its field 'sample' numbers the pieces as they were drawn, 'lot_size' says of how many."),
        )
        self.addNumbers({
            SAMPLE_SIZE: tr("Pieces in the sample"),
            ACCEPTANCE_NUMBER: tr("How many of them may fail"),
            LOT_SIZE: tr("Pieces in the lot"),
        })
        self.addOutput(QgsProcessingOutputString(CODE_LETTER, tr("Code letter of the plan")))

    def check(self, run: Run) -> None:
        self._check(run)

    def for_check(self, parameters: dict[str, Any]) -> dict[str, Any]:
        return stated.with_standard_aql(super().for_check(parameters))

    def prepare(self, run: Run) -> None:
        from .delivery_layers import seam_layers

        self._check(run)
        self._seams, self._told = seam_layers(run.raster_values(SEAMS), run.context)
        field = run.text(SHEET_FIELD)
        if field and not any(field in layer.fields for layer in self._seams):
            raise SettingsError(messages.SHEET_FIELD_MISSING(field=field))
        self._mosaic = run.mosaic() if run.parameters.get(common.MOSAIC) else None

    def execute(self, run: Run) -> dict[str, Any]:
        from .measure.inspection_plan import drawn_sample

        run.tell(*self._told)
        delivery = self._delivery(run)
        lot = self._on_mosaic(run, delivery)
        size = run.whole(LOT_SIZE) or len(lot)
        if size < len(lot):
            raise SettingsError(messages.LOT_SMALLER_THAN_GIVEN(size=size, given=len(lot)))
        plan, by_risk = self._plan(run, lot, size)
        sample = drawn_sample(lot, min(run.whole(COUNT), size) if plan is None else plan.sample_size, run.whole(SEED))
        self._tell_plan(run, plan, by_risk, len(sample), size)
        destination = self._write(run, sample, size, QgsCoordinateReferenceSystem.fromWkt(delivery.wkt))
        return {
            OUTPUT: destination,
            SAMPLE_SIZE: len(sample),
            ACCEPTANCE_NUMBER: None if plan is None else plan.rejection_number - 1,
            LOT_SIZE: size,
            CODE_LETTER: None if plan is None else plan.code_letter or None,
        }

    def _add_risks(self) -> None:
        share = tr("Of the plan 'risk', in percent of the pieces.")
        self.addDescribed(common.real(GOOD_SHARE, tr("Good: failing pieces (%)"), 1.0, 0.0), share, advanced=True)
        self.addDescribed(
            common.real(PRODUCERS_RISK, tr("Producer's risk (%)"), 5.0, 0.0),
            tr("How often a lot that is good may be rejected."),
            advanced=True,
        )
        self.addDescribed(common.real(BAD_SHARE, tr("Bad: failing pieces (%)"), 8.0, 0.0), share, advanced=True)
        self.addDescribed(
            common.real(CONSUMERS_RISK, tr("Consumer's risk (%)"), 10.0, 0.0),
            tr("How often a lot that is bad may be accepted."),
            advanced=True,
        )
        self.addDescribed(
            common.real(CORRELATION, tr("Likeness along a seam"), None, 0.0, optional=True),
            tr(
                "How much alike pieces of one seam are, 0 to 1 (intraclass correlation); the sample grows with it. "
                "Empty: as a scan's kept_1 says, or 0.3 without one."
            ),
            advanced=True,
        )
        self.addDescribed(
            common.real(stated.MIN_KEPT, tr("Least share of detail kept"), stated.LIMITS[stated.MIN_KEPT], 0.0),
            tr("What counts as failed where likeness along seams is taken from a scan."),
            advanced=True,
        )

    def _check(self, run: Run) -> None:
        """Raise SettingsError for what can't be planned."""
        plan = stated.known_word(run, stated.PLAN, (stated.ISO2859, RISK, BY_COUNT))
        stated.standard_aql(run)
        stated.known_word(run, stated.INSPECTION_LEVEL, INSPECTION_LEVELS)
        stated.known_word(run, stated.SEVERITY, SEVERITIES)
        stated.check_limit(LOT_SIZE, run.whole(LOT_SIZE))
        stated.check_limit(PIECE, run.real(PIECE))
        stated.check_limit(stated.MIN_KEPT, run.real(stated.MIN_KEPT), 1.0)
        if plan == RISK:
            self._risk(run).check()
            self._correlation(run)
        if plan == BY_COUNT and run.whole(COUNT) < 1:
            raise SettingsError(messages.COUNT_NOT_POSITIVE(count=run.whole(COUNT)))
        if stated.known_word(run, UNIT, (PIECES, WINDOWS)) == WINDOWS and not run.parameters.get(common.MOSAIC):
            raise SettingsError(messages.WINDOWS_WITHOUT_MOSAIC())

    @staticmethod
    def _risk(run: Run) -> StatedRisk:
        from .measure.sampling_risks import StatedRisk

        return StatedRisk(*(run.real(name) / 100 for name in (GOOD_SHARE, PRODUCERS_RISK, BAD_SHARE, CONSUMERS_RISK)))

    @staticmethod
    def _correlation(run: Run) -> float | None:
        if run.parameters.get(CORRELATION) is None:
            return None
        correlation = run.real(CORRELATION)
        stated.check_limit(CORRELATION, correlation, 1.0)
        return correlation

    def _delivery(self, run: Run) -> Delivery:
        """The pieces of the scans, and those that plain seamlines are cut into."""
        from .planned_sample import with_cut_seamlines

        step = self._mosaic.grid.ground_sample_distance if self._mosaic is not None else None
        delivery, told = with_cut_seamlines(
            self._seams, run.context.transformContext(), run.text(SHEET_FIELD), run.real(PIECE), step
        )
        run.tell(*told)
        return with_sheets(delivery, run)

    def _on_mosaic(self, run: Run, delivery: Delivery) -> Sequence[DeliveredPiece]:
        """The pieces that windows can be placed on; all where none are."""
        from .planned_sample import middle_on

        if self._mosaic is None:
            return delivery.pieces
        found = [piece for piece in delivery.pieces if middle_on(self._mosaic, piece, delivery.wkt) is not None]
        if not found:
            raise SettingsError(messages.ALL_OFF_MOSAIC())
        if len(found) < len(delivery.pieces):
            run.tell(messages.PIECES_OFF_MOSAIC(count=len(delivery.pieces) - len(found)))
        return found

    def _plan(
        self, run: Run, lot: Sequence[DeliveredPiece], size: int
    ) -> tuple[SamplingPlan | None, RiskPlan | None]:
        """The plan, none where as many are drawn as were asked for, and how it came about where risks were stated."""
        from .measure.inspection_plan import plan_of_risk
        from .measure.sampling_plans import single_sampling_plan

        plan = run.word(stated.PLAN)
        if plan == BY_COUNT:
            return None, None
        if plan == RISK:
            least_kept = run.real(stated.MIN_KEPT)
            by_risk = plan_of_risk(lot, size, self._risk(run), self._correlation(run), least_kept)
            return by_risk.plan, by_risk
        level, severity = run.word(stated.INSPECTION_LEVEL), run.word(stated.SEVERITY)
        return single_sampling_plan(size, stated.standard_aql(run), level, severity), None

    def _tell_plan(self, run: Run, plan: SamplingPlan | None, by_risk: RiskPlan | None, drawn: int, size: int) -> None:
        from .measure.inspection_plan import risk_sentences
        from .measure.sampling_risks import allowed_at_aql, operating_characteristic

        if plan is None:
            run.tell(messages.PLANNED_BY_COUNT(size=drawn, lot=size))
            return
        if by_risk is not None:
            run.tell(*risk_sentences(by_risk, self._risk(run)))
        else:
            risks = operating_characteristic(plan)
            run.tell(messages.PLANNED_BY_STANDARD(
                size=plan.sample_size, lot=size, acceptance=plan.rejection_number - 1, level=plan.inspection_level,
                aql=plan.aql, letter=plan.code_letter, allowed=allowed_at_aql(plan),
                producers=risks.producers_risk, bad=round(risks.limiting_quality * plan.lot_size),
                limiting=risks.limiting_quality, consumers=risks.consumers_risk,
            ))  # fmt: skip
        if drawn < plan.sample_size:
            run.tell(messages.SAMPLE_LARGER_THAN_GIVEN(size=plan.sample_size, drawn=drawn))

    def _write(
        self, run: Run, sample: Sequence[DeliveredPiece], lot_size: int, crs: QgsCoordinateReferenceSystem
    ) -> str | None:
        from ..toolkit import layers
        from ..toolkit.table_fields import column_fields, column_values, feature
        from .planned_sample import PIECE_COLUMNS, WINDOW_COLUMNS, SampledItem, sampled_window

        items = [SampledItem(order, piece, lot_size) for order, piece in enumerate(sample, 1)]
        mosaic, columns, kind = self._mosaic, PIECE_COLUMNS, QgsWkbTypes.Type.LineString
        if mosaic is not None and run.word(UNIT) == WINDOWS:
            wkt = layers.system_wkt(crs)
            columns, kind, crs = WINDOW_COLUMNS, QgsWkbTypes.Type.Polygon, layers.mosaic_crs(mosaic)
            items = [replace(one, window=sampled_window(mosaic, one.piece, wkt, run.real(SIDE))) for one in items]
        fields = column_fields(columns)
        sink, destination = run.sink(OUTPUT, fields, kind, crs)
        run.write(sink, (feature(fields, column_values(columns, one), _outline(one, mosaic)) for one in items))
        is_windows = columns is WINDOW_COLUMNS
        run.title(destination, tr("Sample (windows)") if is_windows else tr("Sample (pieces)"))
        if is_windows:
            run.style(destination, "placed_windows")
        return destination


def _outline(item: SampledItem, mosaic: Raster | None) -> QgsGeometry:
    from ..toolkit import layers

    if item.window is not None and mosaic is not None:
        return layers.rectangle(mosaic.grid.window_extent(item.window))
    return QgsGeometry(QgsLineString(*item.piece.vertices.T.tolist()))
