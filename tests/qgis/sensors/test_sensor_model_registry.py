"""A sensor model is one entry of the registry, with a title: the algorithms, the comparison and model files follow."""
from __future__ import annotations

import json
from dataclasses import dataclass, is_dataclass
from pathlib import Path
from typing import ClassVar

import numpy as np
import pytest
from qgis.core import QgsApplication
from seam_inspector.plugin.sensors.fitsensormodel import MODEL_TITLES
from seam_inspector.plugin.sensors.measure import registry
from seam_inspector.plugin.sensors.measure.fit_files import load_model
from seam_inspector.plugin.sensors.measure.sensor_model import FittedModel, SensorModel

from tests.numbers.sensors.sensor_scenes import made_rational, places
from tests.qgis.runs import run
from tests.qgis.sensors.test_sensor_models import gcps

pytestmark = pytest.mark.usefixtures("provider", "project")


@dataclass(frozen=True)
class Tilted(SensorModel):
    """A plane through each coordinate of the image."""

    GEOGRAPHIC: ClassVar[bool] = True

    coefficients: np.ndarray

    def project(self, ground: np.ndarray) -> np.ndarray:
        return np.column_stack([np.ones(len(ground)), ground]) @ self.coefficients


def fit_tilted(ground: np.ndarray, image: np.ndarray, weights: np.ndarray) -> FittedModel:
    terms = np.column_stack([np.ones(len(ground)), ground])
    coefficients, *_ = np.linalg.lstsq(terms * weights[:, None], image * weights[:, None], rcond=None)
    return FittedModel(Tilted(coefficients), 1.0, 1, True, 8)


@pytest.fixture
def made_up(monkeypatch: pytest.MonkeyPatch) -> str:
    kind = registry.ModelKind(
        "tilted",
        (registry.Variant("", unknowns=8, fewest=4, rank=-1),),
        (__name__, "Tilted", "fit_tilted"),
        registry.DLT.recommendation,
        lambda request, points: (),
    )
    monkeypatch.setitem(registry.KINDS, kind.name, kind)
    monkeypatch.setitem(MODEL_TITLES, kind.name, "made up for a test")
    return kind.name


def test_every_model_has_a_title_and_code_and_every_title_a_model() -> None:
    assert set(MODEL_TITLES) == set(registry.KINDS)
    for name, kind in registry.KINDS.items():
        assert name == kind.name
        assert is_dataclass(kind.model_class())
        assert kind.model_class().project is not SensorModel.project


def test_a_model_that_is_registered_is_offered_fitted_compared_and_kept_in_files(made_up: str, tmp_path: Path) -> None:
    algorithm = QgsApplication.processingRegistry().createAlgorithmById("seaminspector:fitsensormodel")
    parameter = algorithm.parameterDefinition("MODEL")
    assert parameter.options() == [*list(registry.KINDS)[:-1], made_up]
    assert "tilted: made up for a test; needs at least 4 control points." in parameter.help()
    ground = places(30, 4)
    truth = made_rational(1, 2, 0.0).project(ground)  # without denominators it is linear
    layer = gcps(truth + np.random.default_rng(4).normal(0, 0.3, truth.shape), ground)
    files = {"MODEL_FILE": str(tmp_path / "model.json"), "RPC": str(tmp_path / "rpc.txt")}
    fitted = run("fitsensormodel", GCPS=layer, MODEL=made_up, HEIGHTS="ellipsoid", CHECK_SHARE=0.5, **files)
    assert fitted.complaint is None
    assert fitted.results["CHECK_RMSE_X"] < 1
    assert json.loads((tmp_path / "model.json").read_text())["model"] == made_up
    again = load_model(tmp_path / "model.json").model
    assert isinstance(again, Tilted)
    assert np.abs(again.project(ground) - truth).max() < 1
    compared = run("comparesensormodels", GCPS=layer, HEIGHTS="ellipsoid", CHECK_SHARE=0.5)
    assert made_up in compared.column("model")
    assert compared.results["RECOMMENDED"] == made_up
