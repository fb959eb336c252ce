"""The provider ``seaminspector``: our algorithms and ready models in the toolbox, the modeler and qgis_process."""
from __future__ import annotations

from qgis.core import QgsProcessingModelAlgorithm, QgsProcessingProvider
from qgis.PyQt.QtGui import QIcon

from ..adapters.resources import icon_path, model_paths
from .calibratethreshold import CalibrateThreshold
from .checknoise import CheckNoise
from .checkradiometry import CheckRadiometry
from .comparemarks import CompareMarks
from .comparesensormodels import CompareSensorModels
from .enhancephoto import EnhancePhoto
from .fitsensormodel import FitSensorModel
from .inspectwindows import InspectWindows
from .interiororientation import InteriorOrientation
from .measureresolution import MeasureResolution
from .minimumheight import MinimumHeight
from .orthorectify import Orthorectify
from .placewindows import PlaceWindows
from .predictloss import PredictLoss
from .report import Report
from .simulatebayer import SimulateBayer

ALGORITHMS = (
    PlaceWindows,
    InspectWindows,
    PredictLoss,
    CalibrateThreshold,
    Report,
    CheckNoise,
    CheckRadiometry,
    MeasureResolution,
    MinimumHeight,
    SimulateBayer,
    InteriorOrientation,
    CompareMarks,
    EnhancePhoto,
    FitSensorModel,
    CompareSensorModels,
    Orthorectify,
)


class SeamInspectorProvider(QgsProcessingProvider):
    """Offers every algorithm of ``ALGORITHMS`` and every model of resources/models."""

    def id(self) -> str:
        return "seaminspector"

    def name(self) -> str:
        return "Seam Inspector"

    def icon(self) -> QIcon:
        return QIcon(icon_path())

    def svgIconPath(self) -> str:
        return icon_path()

    def loadAlgorithms(self) -> None:
        for algorithm in ALGORITHMS:
            self.addAlgorithm(algorithm())
        for path in model_paths():
            model = QgsProcessingModelAlgorithm()
            if model.fromFile(path):
                self.addAlgorithm(model)
