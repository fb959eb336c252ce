"""``seaminspector:comparesensormodels``: the same points through every model."""
from __future__ import annotations

from pathlib import Path
from typing import Any

from qgis.core import QgsProcessingOutputString
from qgis.PyQt.QtCore import QT_TR_NOOP

from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.run import Run
from ..toolkit.table_fields import column_features, column_fields
from ..toolkit.translation import sentence, tr
from .sensor_parameters import IMAGE_RPC, ROBUST, SensorAlgorithm, image_box

OUTPUT = "OUTPUT"
RECOMMENDED, RECOMMENDATION, MODEL_COUNT = "RECOMMENDED", "RECOMMENDATION", "MODEL_COUNT"


class CompareSensorModels(SensorAlgorithm):
    """Every model that the points allow, in one table, with a recommendation."""

    ID = "comparesensormodels"
    NAME = QT_TR_NOOP("Compare sensor models")
    HELP = QT_TR_NOOP(
        "Fits every sensor model that the points allow and judges each on points that its fit has not seen: check "
        "points, or, where they are fewer than five, every point predicted from the others. The table is that of "
        "Kurczynski and Wolniewicz. Among the models whose errors, there and at control points left out in turn, "
        "differ only by chance, the one with the fewest unknowns is recommended; plane polynomials for flat ground "
        "only."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.addPoints()
        self.addFittingParameters()
        self.addTable(OUTPUT, tr("Models"), tr(
            "One row per model: mean (root mean square) and largest errors in metres, the points used, or why not."
        ))
        report = tr("The table with a chart and the recommendation.")
        self.addDescribed(*common.report(report, tr("HTML files (*.html)")))
        self.addOutput(QgsProcessingOutputString(RECOMMENDED, tr("Recommended model")))
        self.addOutput(QgsProcessingOutputString(RECOMMENDATION, tr("Recommendation with its reason")))
        self.addNumbers({MODEL_COUNT: tr("Models judged")})

    def execute(self, run: Run) -> dict[str, Any]:
        from .measure import adjustment
        from .measure.heights import is_flat
        from .measure.points import control_coverage, coverage_warnings
        from .point_tables import MODELS, ModelRow

        image = self._image()
        rpc = self._rpc(run, IMAGE_RPC, image)
        points = self._points(run, image, rpc)
        size = (float(image.columns), float(image.rows)) if image is not None else None
        notices = coverage_warnings(control_coverage(points.image[~points.check], image_box(image, points)))
        run.tell(*notices)
        result = adjustment.compare(
            points, adjustment.all_requests(rpc, self._orbit_height_m(run, image), size), run.flag(ROBUST),
            is_flat(points), run.progress, run.is_cancelled,
        )
        sink, output = run.sink(OUTPUT, column_fields(MODELS))
        run.write(sink, column_features(MODELS, [ModelRow(result, model) for model in result.rows]))
        run.tell(result.reason)

        def write_report(path: Path) -> None:
            from .report import save_comparison_report

            save_comparison_report(path, result, notices)

        name = result.recommended.request.name if result.recommended is not None else ""
        return {
            OUTPUT: output, RECOMMENDED: name, RECOMMENDATION: sentence(result.reason),
            MODEL_COUNT: sum(row.errors is not None for row in result.rows), **run.save(common.REPORT, write_report),
        }  # fmt: skip
