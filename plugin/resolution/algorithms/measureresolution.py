"""``seaminspector:measureresolution``: ground resolved distance from a bar target."""
from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsProcessing,
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
from ...toolkit.algorithms.run import Run
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
            QgsProcessingParameterFeatureSink(OUTPUT, tr("Measured groups"), QgsProcessing.SourceType.TypeVectorLine),
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

    def check(self, run: Run) -> None:
        self._target(run).check()
        self._width(run)
        self._band(run, run.north_up(RASTER))

    def prepare(self, run: Run) -> None:
        self._raster = run.north_up(RASTER)

    def execute(self, run: Run) -> dict[str, Any]:
        from ...toolkit import layers
        from .. import line_table
        from ..measure.bar_groups import judge_lines
        from ..measure.bar_lines import measure_line

        raster, target = self._raster, self._target(run)
        target.check()
        width, band = self._width(run), self._band(run, raster)
        run.check_chart()
        lines = run.source(GROUPS)
        line_table.check_fields(lines.fields().names())
        count = lines.featureCount()
        if count == 0:
            raise SettingsError(messages.NO_BAR_LINES())
        crs = layers.mosaic_crs(raster)
        transform = run.transform(lines, crs)
        measured: list[MeasuredLine] = []
        for row in layers.features(lines):
            if run.is_cancelled():
                break
            line = line_table.bar_line(row, raster.grid, transform)
            measured.append(measure_line(raster, line, target.bars, width, band))
            run.progress(0.9 * len(measured) / max(count, 1))
        resolution = judge_lines(raster, measured, target)
        run.tell(*resolution.notices)
        for result in resolution.results:
            if result.reason is not None:
                where = f"{result.measured.line.group} {result.measured.line.direction} {result.band}".strip()
                run.tell(imagery_messages.ABOUT(what=where, why=result.reason))
        sink, destination = run.sink(OUTPUT, line_table.result_fields(), QgsWkbTypes.Type.LineString, crs)
        run.write(sink, line_table.result_features(resolution.results, raster.grid))
        return {
            OUTPUT: destination,
            GRD_ALONG: resolution.worst("along"),
            GRD_ACROSS: resolution.worst("across"),
            GRD_MEAN: resolution.mean,
            **run.save(common.CHART, lambda path: _save_chart(path, resolution, target)),
            **run.save(common.REPORT, lambda path: _save_report(path, raster, resolution, target)),
        }

    def _target(self, run: Run) -> Target:
        from ..measure.target import Target

        numbers = run.real(REFERENCE_GRD), run.real(STEP), run.real(CRITERION)
        return Target(run.whole(BARS), run.whole(REFERENCE_GROUP), *numbers, run.flag(REVERSED))

    def _width(self, run: Run) -> float:
        width = run.real(WIDTH)
        if not 0 <= width <= limits.MAX_BAR_LINE_PX:
            raise SettingsError(messages.BAR_WIDTH_OUT_OF_RANGE(width=width, most=limits.MAX_BAR_LINE_PX))
        return width

    def _band(self, run: Run, raster: Raster) -> int | None:
        """Where the band stands among those that are measured; None for all."""
        from ...imagery.open_raster import OpenRaster

        number = run.whole(BAND)
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
