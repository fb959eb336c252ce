"""The parameters that a plan of sampling takes, wherever it is made."""
from __future__ import annotations

from qgis.core import QgsProcessingParameterNumber

from ...toolkit.algorithms import parameters as common
from ...toolkit.algorithms.base import SeamInspectorAlgorithm
from ...toolkit.translation import tr
from ..measure import limits
from ..measure.sampling.iso2859 import DEFAULT_LEVEL, INSPECTION_LEVELS, NORMAL, SEVERITIES, SHARE_AQLS
from ..stated_rules import AQL, INSPECTION_LEVEL, SEVERITY

LOT_SIZE, SEED = "LOT_SIZE", "SEED"
_WHOLE = QgsProcessingParameterNumber.Type.Integer
_LARGEST_SEED = 2**31 - 1


def add_plan_parameters(algorithm: SeamInspectorAlgorithm) -> None:
    """LOT_SIZE, AQL, INSPECTION_LEVEL, SEVERITY and SEED."""
    algorithm.addDescribed(
        QgsProcessingParameterNumber(LOT_SIZE, tr("Lot size"), _WHOLE, 0, minValue=0),
        tr("How many pieces of seam the whole lot has; 0: as many as the layers hold."),
    )
    algorithm.addDescribed(
        common.choice(AQL, tr("Acceptance quality limit (AQL)"), SHARE_AQLS, limits.STANDARD_AQL),
        tr("The percentage of failing pieces up to which lots should be accepted nearly always, as ISO 2859-1 has it."),
    )
    algorithm.addDescribed(
        common.choice(INSPECTION_LEVEL, tr("Inspection level"), INSPECTION_LEVELS, DEFAULT_LEVEL),
        tr("How large the sample is for its lot: II unless something else was agreed; S-1 is the smallest."),
    )
    algorithm.addDescribed(
        common.choice(SEVERITY, tr("Inspection"), SEVERITIES, NORMAL),
        tr("Normal; tightened after two of five lots were rejected; reduced after ten that were accepted."),
        advanced=True,
    )
    algorithm.addDescribed(
        QgsProcessingParameterNumber(
            SEED, tr("Seed"), _WHOLE, limits.STANDARD_SEED, minValue=0, maxValue=_LARGEST_SEED
        ),
        tr("Of the drawing: the same seed draws the same sample again."),
        advanced=True,
    )
