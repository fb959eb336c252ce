"""``seaminspector:enhancephoto``: negative, grey and simple filters of a photo."""
from __future__ import annotations

from typing import Any

from qgis.core import QgsProcessingParameterRasterDestination
from qgis.PyQt.QtCore import QT_TR_NOOP

from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.base import INTERIOR_ORIENTATION, SeamInspectorAlgorithm
from ..toolkit.algorithms.run import Run
from ..toolkit.translation import tr
from .measure import limits

DEFAULT_FILTER_PX = 3.0  # the usual 3 x 3

PHOTO, OPERATION, SIZE, OUTPUT = "PHOTO", "OPERATION", "SIZE", "OUTPUT"


class EnhancePhoto(SeamInspectorAlgorithm):
    """One operation on every pixel of a photo, whose place on the map is kept."""

    ID = "enhancephoto"
    NAME = QT_TR_NOOP("Enhance photo")
    GROUP = INTERIOR_ORIENTATION
    HELP = QT_TR_NOOP(
        "Makes a photo easier to look at: its negative, 8 bit grey from colour or more bits, a mean or Gaussian "
        "against grain, Laplace or Sobel for edges. Photos of any size are processed in strips; georeference and "
        "invalid pixels are not changed. Marks are measured on the photo itself, not on this copy."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.addDescribed(common.raster(PHOTO, tr("Photo")), tr("Any raster that GDAL reads."))
        self.addDescribed(common.choice(OPERATION, tr("Operation"), limits.OPERATIONS), tr(
            "negative, mean and gaussian keep the data type; grey is 8 bit; laplace (second derivative) and sobel "
            "(length of the gradient) are floating point."
        ))
        self.addDescribed(common.real(SIZE, tr("Size (px)"), DEFAULT_FILTER_PX, decimals=None), tr(
            "Side of the mean's square (odd), or standard deviation of the Gaussian; the others ignore it."
        ))
        self.addDescribed(QgsProcessingParameterRasterDestination(OUTPUT, tr("Enhanced photo")), tr("A GeoTIFF."))

    def check(self, run: Run) -> None:
        from .measure.photo import Photo

        Photo(run.required_raster(PHOTO))

    def prepare_run(self, run: Run) -> None:
        self._photo = run.required_raster(PHOTO)

    def execute(self, run: Run) -> dict[str, Any]:
        from .measure.enhancement import enhance

        path = run.layer_path(OUTPUT)
        enhance(self._photo, path, run.word(OPERATION), run.real(SIZE), run.is_cancelled, run.progress)
        return {OUTPUT: path}
