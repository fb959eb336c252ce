"""The provider ``seaminspector``: our algorithms and ready models in the toolbox, the modeler and qgis_process."""
from __future__ import annotations

from qgis.core import QgsProcessingProvider
from qgis.PyQt.QtGui import QIcon

from .acceptance.checkdelivery import CheckDelivery
from .acceptance.planinspection import PlanInspection
from .noise.checknoise import CheckNoise
from .photos.comparemarks import CompareMarks
from .photos.enhancephoto import EnhancePhoto
from .photos.interiororientation import InteriorOrientation
from .proven_acceptance import ProvenAcceptMosaic
from .radiometry.checkradiometry import CheckRadiometry
from .resolution.measureresolution import MeasureResolution
from .resolution.minimumheight import MinimumHeight
from .resolution.simulatebayer import SimulateBayer
from .seams.algorithms.calibratethreshold import CalibrateThreshold
from .seams.algorithms.inspectwindows import InspectWindows
from .seams.algorithms.mendseams import MendSeams
from .seams.algorithms.placewindows import PlaceWindows
from .seams.algorithms.predictloss import PredictLoss
from .seams.algorithms.report import Report
from .seams.algorithms.scanmosaic import ScanMosaic
from .sensors.fitsensormodel import CompareSensorModels, FitSensorModel, PlanPoints
from .sensors.orthorectify import Orthorectify, OrthorectifyPhotos
from .toolkit.algorithms.base import ReadyModel
from .toolkit.algorithms.outputs import RASTER_ENDINGS
from .toolkit.resources import RESOURCES, icon_path

ALGORITHMS = (
    PlaceWindows,
    InspectWindows,
    ScanMosaic,
    MendSeams,
    CheckDelivery,
    PlanInspection,
    ProvenAcceptMosaic,
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
    OrthorectifyPhotos,
    PlanPoints,
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

    def supportedOutputRasterLayerExtensions(self) -> list[str]:
        return list(RASTER_ENDINGS)

    def loadAlgorithms(self) -> None:
        for algorithm in ALGORITHMS:
            self.addAlgorithm(algorithm())
        for path in sorted((RESOURCES / "models").glob("*.model3")):
            model = ReadyModel()
            if model.fromFile(str(path)):
                self.addAlgorithm(model)
