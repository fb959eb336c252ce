"""``seaminspector:simulatebayer``: what a single-chip camera would have seen."""
from __future__ import annotations

from typing import Any

from qgis.core import QgsProcessingParameterRasterDestination
from qgis.PyQt.QtCore import QT_TR_NOOP

from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.base import GROUND_RESOLUTION, SeamInspectorAlgorithm
from ..toolkit.algorithms.run import Run
from ..toolkit.translation import tr
from .measure import target as limits

RASTER, PATTERN, DEMOSAIC, OUTPUT = "RASTER", "PATTERN", "DEMOSAIC", "OUTPUT"


class SimulateBayer(SeamInspectorAlgorithm):
    """An image through a Bayer filter and back."""

    ID = "simulatebayer"
    NAME = QT_TR_NOOP("Simulate a Bayer filter")
    GROUP = GROUND_RESOLUTION
    HELP = QT_TR_NOOP(
        "Shows what a camera with a single chip would have seen of an image: each pixel records only the colour of its "
        "filter, and the other two are interpolated from the neighbours. Fine lines get wider and coloured "
        "(Walczykowski and others 2009, section 5). An image of one band is taken as a grey scene."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.addDescribed(common.raster(RASTER, tr("Image")), tr(
            "A colour image, or one of a single band, north-up or without georeference."
        ))
        self.addDescribed(common.choice(PATTERN, tr("Pattern"), limits.BAYER_PATTERNS), tr(
            "Colours of the filter over the first two pixels of the first row, then of the second."
        ))
        self.addDescribed(common.choice(DEMOSAIC, tr("Interpolation"), limits.DEMOSAICS), tr(
            "bilinear: the mean of the nearest pixels of the colour. malvar: sharper, as the recorded colour shows "
            "where the others change too (Malvar, He and Cutler 2004). edge_aware: along edges, by OpenCV, which has "
            "to be installed."
        ))
        self.addDescribed(QgsProcessingParameterRasterDestination(OUTPUT, tr("Seen by a single chip")), tr(
            "A GeoTIFF: red, green and blue on the image's own pixels, in its data type."
        ))

    def check(self, run: Run) -> None:
        from .measure.bayer import check_demosaic

        check_demosaic(run.word(DEMOSAIC))
        run.north_up(RASTER)

    def prepare_run(self, run: Run) -> None:
        self._raster = run.north_up(RASTER)

    def execute(self, run: Run) -> dict[str, Any]:
        from .measure.bayer import simulate_file

        path = run.layer_path(OUTPUT)
        simulate_file(self._raster, path, run.word(PATTERN), run.word(DEMOSAIC), run.goes_on)
        return {OUTPUT: path}
