"""``seaminspector:planinspection``: a random sample of a delivery, to be judged."""
from __future__ import annotations

from dataclasses import replace
from typing import Any

from qgis.core import QgsProcessingOutputString
from qgis.PyQt.QtCore import QT_TR_NOOP

from ..imagery import limits as imagery_limits
from ..imagery.errors import SettingsError
from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.base import SeamInspectorAlgorithm
from ..toolkit.algorithms.run import Run
from ..toolkit.translation import tr
from . import stated_rules as stated
from .measure import messages
from .sheet_index import add_sheets, with_sheets
from .stated_rules import LOT_SIZE, SEED, add_plan_parameters

SEAMS, UNIT, SIDE, COUNT = "SEAMS", "UNIT", "SIDE", "COUNT"
OUTPUT, SAMPLE_SIZE, ACCEPTANCE_NUMBER, CODE_LETTER = "OUTPUT", "SAMPLE_SIZE", "ACCEPTANCE_NUMBER", "CODE_LETTER"
BY_COUNT = "count"
PIECES, WINDOWS = "pieces", "windows"


class PlanInspection(SeamInspectorAlgorithm):
    """Draws the pieces of seam to look at when not all are."""

    ID = "planinspection"
    NAME = QT_TR_NOOP("Plan an inspection")
    HELP = QT_TR_NOOP(
        "Draws a random sample of the seams of a delivery, proportionally from every sheet: as large as ISO 2859 "
        "requires, or as large as you choose. The sample comes as pieces of seam for 'Accept or reject a delivery', or "
        "as windows that open in the desk to be judged. The same seed draws the same sample."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.addDescribed(common.layers(SEAMS, tr("Seams"), common.LINE), tr(
            "The layers 'Seams' of the scans of one delivery, a sheet each."
        ))
        add_sheets(self)
        self.addDescribed(common.choice(stated.PLAN, tr("Plan"), (stated.ISO2859, stated.ISOLATED, BY_COUNT)), tr(
            "How many: iso2859, as ISO 2859-1 says for a lot of a series; iso2859_2, as ISO 2859-2 says for an "
            "isolated lot; count, as many as you choose."
        ))
        add_plan_parameters(self)
        self.addDescribed(common.whole(COUNT, tr("Count"), 50, 1), tr("How many are drawn with the plan 'count'."))
        self.addDescribed(common.choice(UNIT, tr("Unit"), (PIECES, WINDOWS)), tr(
            "pieces: pieces of seam, as lines. windows: one around the middle of each, on the mosaic's pixels."
        ))
        self.addDescribed(common.mosaic(optional=True)[0], tr(
            "What windows are placed on. With the same seed, windows and pieces are the same sample."
        ))
        self.addDescribed(common.real(SIDE, tr("Window side (metres)"), imagery_limits.STANDARD_SIDE_M, 0.01), tr(
            "Minimum side of a window: 100 m at 0.10 m pixels gives 1024 pixels, 102.4 m."
        ))
        self.addDescribed(common.result(OUTPUT, tr("Sample")), tr(
            "The sample: its field 'sample' numbers the pieces as they were drawn, 'lot_size' is how many there were."
        ))
        self.addNumbers({
            SAMPLE_SIZE: tr("Pieces in the sample"),
            ACCEPTANCE_NUMBER: tr("How many of them may fail"),
            LOT_SIZE: tr("Pieces in the lot"),
        })
        self.addOutput(QgsProcessingOutputString(CODE_LETTER, tr("Code letter of the plan")))

    def check(self, run: Run) -> None:
        if run.word(UNIT) == WINDOWS and not run.parameters.get(common.MOSAIC):
            raise SettingsError(messages.WINDOWS_WITHOUT_MOSAIC())

    def for_check(self, parameters: dict[str, Any]) -> dict[str, Any]:
        return stated.with_standard_words(super().for_check(parameters))

    def prepare_run(self, run: Run) -> None:
        from .delivery_layers import seam_layers

        self.check(run)
        self._seams = seam_layers(run.raster_values(SEAMS), run.context)
        self._mosaic = run.mosaic() if run.parameters.get(common.MOSAIC) else None

    def execute(self, run: Run) -> dict[str, Any]:
        from .measure.delivered_rows import read_layers
        from .measure.inspection_plan import plan_sentence, rule_plan, stratified_sample
        from .planned_sample import write_sample

        delivery, notices = read_layers(self._seams)
        run.tell(*notices)
        delivery = with_sheets(delivery, run)
        lot = delivery.pieces
        size = run.whole(LOT_SIZE) or len(lot)
        if size < len(lot):
            raise SettingsError(messages.LOT_SMALLER_THAN_GIVEN(size=size, given=len(lot)))
        rule = stated.sampling_rule(run)
        plan = None if rule is None else rule_plan(size, rule)
        count = min(run.whole(COUNT), size) if plan is None else plan.sample_size
        sample = [lot[place] for place in stratified_sample([piece.sheet for piece in lot], count, run.whole(SEED))]
        run.tell(plan_sentence(plan) if plan else messages.PLANNED_BY_COUNT(size=len(sample), lot=size))
        if plan is not None and len(sample) < plan.sample_size:
            run.tell(messages.SAMPLE_LARGER_THAN_GIVEN(size=plan.sample_size, drawn=len(sample)))
        on = None if self._mosaic is None or run.word(UNIT) != WINDOWS else (self._mosaic, run.real(SIDE))
        return {
            OUTPUT: write_sample(run, OUTPUT, sample, replace(delivery, lot_size=size), on),
            SAMPLE_SIZE: len(sample),
            ACCEPTANCE_NUMBER: None if plan is None else plan.acceptance_number,
            LOT_SIZE: size,
            CODE_LETTER: None if plan is None else plan.code_letter or None,
        }
