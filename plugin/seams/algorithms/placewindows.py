"""``seaminspector:placewindows``: windows along seamlines."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

from qgis.core import QgsWkbTypes
from qgis.PyQt.QtCore import QT_TR_NOOP

from ...imagery import limits as imagery_limits
from ...toolkit.algorithms import parameters as common
from ...toolkit.algorithms.base import SeamInspectorAlgorithm
from ...toolkit.algorithms.run import Run
from ...toolkit.translation import filled, tr
from ..measure import limits

if TYPE_CHECKING:
    from ...imagery.grids import PixelWindow
    from ..measure.planning.window_placing import PlacingSettings

SEAMLINES, SIDE, SPACING, OUTPUT = "SEAMLINES", "SIDE", "SPACING", "OUTPUT"


class PlaceWindows(SeamInspectorAlgorithm):
    """Standard windows along the seams of a mosaic."""

    ID = "placewindows"
    NAME = QT_TR_NOOP("Place windows along seamlines")
    HELP = QT_TR_NOOP(
        "Places square windows of about 100 m along the seamlines of a mosaic, ready to be inspected. A window's side "
        "is the smallest power of two of pixels that spans the given length, and its edges are pixel edges of the "
        "mosaic. Windows that would stick out of the mosaic are moved along their seam; the log names those that had "
        "to be dropped."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.addDescribed(common.features(SEAMLINES, tr("Seamlines"), common.LINE, common.POLYGON), tr(
            "Lines, or polygons that are each filled from one orthoimage: where two touch there is a seam. Fragments "
            "and pixel staircases are joined and straightened first."
        ))
        self.addDescribed(*common.mosaic())
        self.addDescribed(common.real(SIDE, tr("Window side (metres)"), imagery_limits.STANDARD_SIDE_M, 0.01), tr(
            "Minimum side of a window: 100 m at 0.10 m pixels gives 1024 pixels, 102.4 m."
        ))
        self.addDescribed(common.real(SPACING, tr("Spacing (metres)"), limits.STANDARD_SPACING_M, 0.01), tr(
            "Distance between the centres of neighbouring windows, measured along the seam."
        ))
        self.addDescribed(*common.levels())
        self.addDescribed(common.result(OUTPUT, tr("Windows"), common.POLYGON), tr(
            "The windows, with the number of their seam and their station along it in metres."
        ))

    def check(self, run: Run) -> None:
        from ..measure.planning.window_placing import window_side_px

        window_side_px(run.mosaic().grid, self._settings(run))

    def prepare_run(self, run: Run) -> None:
        self._mosaic = run.mosaic()

    def execute(self, run: Run) -> dict[str, Any]:
        from ...imagery.lines import find_seams
        from ...imagery.open_raster import OpenRaster
        from ...toolkit import layers
        from ...toolkit.table_fields import column_fields, column_values, feature
        from ..measure.planning.window_placing import PLACED_COLUMNS, place_windows

        seamlines, mosaic = run.source(SEAMLINES), self._mosaic
        crs = layers.mosaic_crs(mosaic)
        transform = run.transform(seamlines, crs)
        lines = (layers.line_wkb(feature, transform) for feature in layers.features(seamlines))
        seams = find_seams(lines, mosaic.grid.pixel_width)
        source = OpenRaster(mosaic.ref)

        def is_valid(window: PixelWindow) -> bool:
            return not run.is_cancelled() and source.is_valid(window)

        placement = place_windows(seams, mosaic.grid, self._settings(run), is_valid)
        if not run.is_cancelled():
            run.tell(*placement.dropped)
        fields = column_fields(PLACED_COLUMNS)
        sink, destination = run.sink(OUTPUT, fields, QgsWkbTypes.Type.Polygon, crs)
        for done, placed in enumerate(placement.windows, 1):
            if run.is_cancelled():
                break
            geometry = layers.rectangle(mosaic.grid.window_extent(placed.window))
            run.write(sink, [feature(fields, column_values(PLACED_COLUMNS, placed), geometry)])
            run.progress(done / len(placement.windows))
        sentence = tr("{windows} windows placed along {seams} seams.")
        run.feedback.pushInfo(filled(sentence, windows=len(placement.windows), seams=len(seams)))
        run.style(destination, "placed_windows")
        return {OUTPUT: destination}

    def _settings(self, run: Run) -> PlacingSettings:
        from ..measure.planning.window_placing import PlacingSettings

        return PlacingSettings(run.real(SIDE), run.real(SPACING), run.whole(common.LEVELS))
