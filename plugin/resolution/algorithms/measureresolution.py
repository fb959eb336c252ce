"""``seaminspector:measureresolution``: ground resolved distance from a bar target."""
from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsProcessing,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterLayer,
    QgsWkbTypes,
)
from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP

from ...imagery import messages as imagery_messages
from ...imagery.errors import RasterError, SettingsError
from ...toolkit.algorithms import groups
from ...toolkit.algorithms import parameters as common
from ...toolkit.algorithms.base import SeamInspectorAlgorithm
from ...toolkit.algorithms.feedback import tell
from ...toolkit.translation import tr
from ..measure import limits, messages

if TYPE_CHECKING:
    from ...imagery.rasters import Raster
    from ..measure.bar_groups import TargetResolution
    from ..measure.bar_lines import MeasuredLine
    from ..measure.target import Target

RASTER, GROUPS, WIDTH, BAND, BARS = "RASTER", "GROUPS", "WIDTH", "BAND", "BARS"
REFERENCE_GROUP, REFERENCE_GRD, STEP = "REFERENCE_GROUP", "REFERENCE_GRD", "STEP"
CRITERION, REVERSED = "CRITERION", "REVERSED"
OUTPUT = "OUTPUT"
GRD_ALONG, GRD_ACROSS, GRD_MEAN = "GRD_ALONG", "GRD_ACROSS", "GRD_MEAN"


class MeasureResolution(SeamInspectorAlgorithm):
    """The finest group of bars that an image still resolves."""

    ID = "measureresolution"
    NAME = QT_TRANSLATE_NOOP("@default", "Measure ground resolved distance")
    GROUP = groups.GROUND_RESOLUTION
    HELP = QT_TRANSLATE_NOOP(
        "@default",
        "Reads the ground resolved distance from the image of a bar target, along and across the flight. Draw one line "
        "across the bars of each group. A group is resolved when all its bars stand out, the smallest difference of a "
        "bar to a gap beside it is at least half of the group's full amplitude and exceeds three times the noise of "
        "the ground beside it. Bars finer than two pixels, and groups finer than one that is not resolved, are "
        "aliasing and are not counted (Walczykowski and others 2009)."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.addDescribed(
            QgsProcessingParameterRasterLayer(RASTER, tr("Image")),
            tr("The image of the target, north-up. One without georeference is taken as QGIS shows it."),
        )
        self.addDescribed(
            QgsProcessingParameterFeatureSource(
                GROUPS, tr("Lines across the bars"), [QgsProcessing.SourceType.TypeVectorLine]
            ),
            tr(
                "One line across the bars of each group, from the ground on one side to that on the other, with the "
                "fields 'group' (whole number) and 'direction' ('along' or 'across' the flight). A line is turned by "
                "up to 10 degrees to be perpendicular to the bars."
            ),
        )
        self.addDescribed(
            common.real(WIDTH, tr("Width to average (pixels)"), limits.DEFAULT_BAR_WIDTH_PX, 0),
            tr("How far either side of the line the profile is averaged; it should stay within the bars' length."),
        )
        self.addDescribed(
            QgsProcessingParameterNumber(BAND, tr("Band"), defaultValue=0, minValue=0),
            tr("Number of the band to measure; 0 for every band."),
        )
        self.addDescribed(
            QgsProcessingParameterNumber(
                BARS, tr("Bars in a group"), defaultValue=limits.DEFAULT_BARS, minValue=limits.MIN_BARS
            ),
            tr("How many bars each group of the target has."),
        )
        self.addDescribed(
            QgsProcessingParameterNumber(
                REFERENCE_GROUP, tr("Reference group"), defaultValue=limits.DEFAULT_REFERENCE_GROUP
            ),
            tr("Number of the group whose distance is known. Higher numbers are finer."),
        )
        self.addDescribed(
            common.real(REFERENCE_GRD, tr("Distance of the reference group (cm)"), limits.DEFAULT_REFERENCE_GRD_CM),
            tr("Width of one bar and one gap of the reference group together, centimetres on the ground."),
        )
        self.addDescribed(
            common.real(STEP, tr("Step from group to group"), limits.DEFAULT_GROUP_STEP, decimals=6),
            tr("How many times as wide the next coarser group is; the sixth root of 2 on most targets."),
            advanced=True,
        )
        self.addDescribed(
            common.real(CRITERION, tr("Criterion"), limits.DEFAULT_CRITERION),
            tr("Share of the full amplitude that the bars of a resolved group keep."),
            advanced=True,
        )
        self.addDescribed(
            QgsProcessingParameterBoolean(REVERSED, tr("Higher numbers are coarser"), False),
            tr("For targets numbered the other way."),
            advanced=True,
        )
        self.addDescribed(
            QgsProcessingParameterFeatureSink(
                OUTPUT, tr("Measured groups"), QgsProcessing.SourceType.TypeVectorLine
            ),
            tr("The lines as they were measured, one row per band: bars, amplitudes, modulation, verdict, shift."),
        )
        self.addDescribed(*common.chart(tr("The profiles with their bars, threshold and verdict, group by group.")))
        self.addDescribed(
            *common.report(tr("A page with the distances, the target, the profiles and all measurements."))
        )
        self.addNumbers({
            GRD_ALONG: tr("Distance along the flight (cm)"),
            GRD_ACROSS: tr("Distance across the flight (cm)"),
            GRD_MEAN: tr("Geometric mean of both distances (cm)"),
        })

    def check(self, parameters: dict[str, Any], context: QgsProcessingContext) -> None:
        self._target(parameters, context).check()
        self._width(parameters, context)
        self._band(parameters, context, self.describe_north_up(parameters, RASTER, context))

    def prepare(self, parameters: dict[str, Any], context: QgsProcessingContext) -> None:
        self._raster = self.describe_north_up(parameters, RASTER, context)

    def execute(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        from ...toolkit import layers
        from .. import line_table
        from ..measure.bar_groups import judge_lines
        from ..measure.bar_lines import measure_line

        raster, target = self._raster, self._target(parameters, context)
        target.check()
        width, band = self._width(parameters, context), self._band(parameters, context, raster)
        self.check_chart(parameters, context)
        lines = self.source(parameters, GROUPS, context)
        line_table.check_fields(lines.fields().names())
        count = lines.featureCount()
        if count == 0:
            raise SettingsError(messages.NO_BAR_LINES())
        crs = layers.mosaic_crs(raster)
        transform = common.transform(lines, crs, context)
        measured: list[MeasuredLine] = []
        for row in layers.features(lines):
            if feedback.isCanceled():
                break
            line = line_table.bar_line(row, raster.grid, transform)
            measured.append(measure_line(raster, line, target.bars, width, band))
            feedback.setProgress(90 * len(measured) / max(count, 1))
        resolution = judge_lines(raster, measured, target)
        tell(feedback, *resolution.notices)
        for result in resolution.results:
            if result.reason is not None:
                where = f"{result.measured.line.group} {result.measured.line.direction} {result.band}".strip()
                tell(feedback, imagery_messages.ABOUT(what=where, why=result.reason))
        sink, destination = self.sink(
            parameters, OUTPUT, context, line_table.result_fields(), QgsWkbTypes.Type.LineString, crs
        )
        self.write(sink, line_table.result_features(resolution.results, raster.grid))
        return {
            OUTPUT: destination,
            GRD_ALONG: resolution.worst("along"),
            GRD_ACROSS: resolution.worst("across"),
            GRD_MEAN: resolution.mean,
            **self.save(
                parameters, common.CHART, context, feedback, lambda path: _save_chart(path, resolution, target)
            ),
            **self.save(
                parameters, common.REPORT, context, feedback,
                lambda path: _save_report(path, raster, resolution, target),
            ),
        }

    def _target(self, parameters: dict[str, Any], context: QgsProcessingContext) -> Target:
        from ..measure.target import Target

        return Target(
            self.parameterAsInt(parameters, BARS, context),
            self.parameterAsInt(parameters, REFERENCE_GROUP, context),
            self.parameterAsDouble(parameters, REFERENCE_GRD, context),
            self.parameterAsDouble(parameters, STEP, context),
            self.parameterAsDouble(parameters, CRITERION, context),
            self.parameterAsBool(parameters, REVERSED, context),
        )

    def _width(self, parameters: dict[str, Any], context: QgsProcessingContext) -> float:
        width = self.parameterAsDouble(parameters, WIDTH, context)
        if not 0 <= width <= limits.MAX_BAR_LINE_PX:
            raise SettingsError(messages.BAR_WIDTH_OUT_OF_RANGE(width=width, most=limits.MAX_BAR_LINE_PX))
        return float(width)

    def _band(self, parameters: dict[str, Any], context: QgsProcessingContext, raster: Raster) -> int | None:
        """Where the band stands among those that are measured; None for all."""
        from ...imagery.open_raster import OpenRaster

        number = self.parameterAsInt(parameters, BAND, context)
        if number < 0:
            count = len(raster.band_names)
            raise RasterError(imagery_messages.BAND_NOT_THERE(name=raster.ref.name, band=number, count=count))
        return None if number == 0 else OpenRaster(raster.ref).band_index(number)


def _save_chart(path: Path, resolution: TargetResolution, target: Target) -> None:
    from ...toolkit.charts.figure_files import save_figure
    from ..charts import group_chart

    save_figure(group_chart(resolution.results, target.criterion), path)


def _save_report(path: Path, raster: Raster, resolution: TargetResolution, target: Target) -> None:
    from ..report import save_resolution_report

    save_resolution_report(path, raster, resolution, target)
