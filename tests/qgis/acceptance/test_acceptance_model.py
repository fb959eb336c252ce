"""Sample and decision, joined in the graphical modeler."""
from __future__ import annotations

import pytest
from qgis.core import (
    QgsProcessing,
    QgsProcessingModelAlgorithm,
    QgsProcessingModelChildAlgorithm,
    QgsProcessingModelChildParameterSource,
    QgsProcessingModelParameter,
    QgsProcessingParameterMultipleLayers,
)

from tests.qgis.acceptance.seam_scenes import seams
from tests.qgis.runs import run

pytestmark = pytest.mark.usefixtures("provider")

Source = QgsProcessingModelChildParameterSource


def child(name: str, **parameters: Source) -> QgsProcessingModelChildAlgorithm:
    made = QgsProcessingModelChildAlgorithm(f"seaminspector:{name}")
    made.setChildId(name)
    for parameter, source in parameters.items():
        made.addParameterSources(parameter, [source])
    return made


def model() -> QgsProcessingModelAlgorithm:
    made = QgsProcessingModelAlgorithm("sampled", "tests")
    given = QgsProcessingParameterMultipleLayers("seams", "seams", QgsProcessing.SourceType.TypeVectorLine)
    made.addModelParameter(given, QgsProcessingModelParameter("seams"))
    plan = {"PLAN": Source.fromStaticValue("iso2859"), "AQL": Source.fromStaticValue("4.0")}
    made.addChildAlgorithm(child("planinspection", SEAMS=Source.fromModelParameter("seams"), **plan))
    sample = Source.fromChildOutput("planinspection", "OUTPUT")
    lot = Source.fromChildOutput("planinspection", "LOT_SIZE")
    made.addChildAlgorithm(child("acceptmosaic", SEAMS=sample, LOT_SIZE=lot, **plan))
    return made


@pytest.mark.parametrize(("kept", "accepted"), [(0.95, True), (0.5, False)])
def test_a_model_draws_and_decides(kept: float, accepted: bool) -> None:
    west, east = seams([kept] * 300, name="west"), seams([kept] * 200, y=90, name="east")
    outcome = run(model(), seams=[west, east])
    assert outcome.complaint is None
    said = "\n".join(outcome.log.infos)
    assert ("Accepted by" in said, "Rejected by" in said) == (accepted, not accepted)
    assert "of 50 inspected pieces failed" in said
    assert "lot of 500" in said
