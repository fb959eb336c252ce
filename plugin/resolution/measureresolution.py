"""``seaminspector:measureresolution``: ground resolved distance from a bar target."""
from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import QgsWkbTypes
from qgis.PyQt.QtCore import QT_TR_NOOP

from ..imagery import messages as imagery_messages
from ..imagery.errors import SettingsError
from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.base import GROUND_RESOLUTION, SeamInspectorAlgorithm
from ..toolkit.algorithms.run import Run
from ..toolkit.translation import band_title, tr
from .measure import messages
from .measure import target as limits

if TYPE_CHECKING:
    from ..imagery.rasters import Raster
    from .measure.bar_groups import TargetResolution
    from .measure.bars import MeasuredLine

RASTER, GROUPS, WIDTH, BAND, BARS = "RASTER", "GROUPS", "WIDTH", "BAND", "BARS"
REFERENCE_GROUP, REFERENCE_GRD, STEP = "REFERENCE_GROUP", "REFERENCE_GRD", "STEP"
CRITERION, FULL_AMPLITUDE, GRD_OF, REVERSED = "CRITERION", "FULL_AMPLITUDE", "GRD_OF", "REVERSED"
OUTPUT = "OUTPUT"
_NUMBERS = {
    "GRD_ALONG": QT_TR_NOOP("Distance along the flight (cm)"),
    "GRD_ACROSS": QT_TR_NOOP("Distance across the flight (cm)"),
    "GRD_MEAN": QT_TR_NOOP("Geometric mean of both distances (cm)"),
    "GRD_ALONG_ERROR": QT_TR_NOOP("Standard deviation along the flight (cm)"),
    "GRD_ACROSS_ERROR": QT_TR_NOOP("Standard deviation across the flight (cm)"),
    "GRD_MEAN_ERROR": QT_TR_NOOP("Standard deviation of the mean (cm)"),
    "GRD_ALONG_LOW": QT_TR_NOOP("Finest distance that may be resolved along the flight (cm)"),
    "GRD_ALONG_HIGH": QT_TR_NOOP("Coarsest distance that may be the finest one along the flight (cm)"),
    "GRD_ACROSS_LOW": QT_TR_NOOP("Finest distance that may be resolved across the flight (cm)"),
    "GRD_ACROSS_HIGH": QT_TR_NOOP("Coarsest distance that may be the finest one across the flight (cm)"),
    "SEEN_ALONG": QT_TR_NOOP("Distance along the flight that all observers see (cm)"),
    "SEEN_ACROSS": QT_TR_NOOP("Distance across the flight that all observers see (cm)"),
    "TARGET_CONTRAST": QT_TR_NOOP("Contrast of the target, bars to gaps"),
}


class MeasureResolution(SeamInspectorAlgorithm):
    """The finest group of bars that an image still resolves."""

    ID = "measureresolution"
    NAME = QT_TR_NOOP("Measure ground resolved distance")
    GROUP = GROUND_RESOLUTION
    HELP = QT_TR_NOOP(
        "Reads the ground resolved distance from the image of a bar target, along and across the flight. Draw one line "
        "across the bars of each group. A group is resolved when all its bars stand out, and the amplitude of bars "
        "against gaps is at least half of the full one, that of bars against plain gaps, and exceeds three times the "
        "noise of the ground beside it. Bars finer than two pixels, and groups finer than one that is not resolved, "
        "are aliasing and are not counted (Walczykowski and others 2009)."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.addDescribed(common.raster(RASTER, tr("Image")), tr(
            "The image of the target, north-up. One without georeference is taken as QGIS shows it."
        ))
        self.addDescribed(common.features(GROUPS, tr("Lines across the bars"), common.LINE), tr(
            "One line across the bars of each group, from the ground on one side to that on the other, with the fields "
            "'group' (whole number) and 'direction' ('along' or 'across' the flight). A line is turned by up to 10 "
            "degrees to be perpendicular to the bars. What observers saw may stand beside them, 'visible' or "
            "'invisible', in the fields 'observer', 'observer_2' and so on."
        ))
        width = limits.DEFAULT_BAR_WIDTH_PX, 0, limits.MAX_BAR_LINE_PX
        self.addDescribed(common.real(WIDTH, tr("Width to average (pixels)"), *width), tr(
            "How far on either side of the line the profile is averaged; less where the bars are shorter."
        ))
        self.addDescribed(common.whole(BAND, tr("Band"), 0, 0), tr("Number of the band to measure; 0 for every band."))
        self.addDescribed(common.whole(BARS, tr("Bars in a group"), limits.DEFAULT_BARS, limits.MIN_BARS), tr(
            "How many bars each group of the target has."
        ))
        self.addDescribed(common.whole(REFERENCE_GROUP, tr("Reference group"), limits.DEFAULT_REFERENCE_GROUP), tr(
            "Number of the group whose distance is known. Higher numbers are finer."
        ))
        usual = limits.DEFAULT_REFERENCE_GRD_CM
        self.addDescribed(
            common.real(REFERENCE_GRD, tr("Distance of the reference group (cm)"), usual, limits.MIN_REFERENCE_GRD_CM),
            tr("In centimetres on the ground; the next parameter says what it is the width of."),
        )
        self.addDescribed(common.choice(GRD_OF, tr("Distances are widths of"), limits.DISTANCES), tr(
            "cycle: a bar and a gap together, which is what resolution means. bar: one bar, as some targets and "
            "reports count. A bar and a gap finer than two pixels together are aliasing either way."
        ))
        step = limits.DEFAULT_GROUP_STEP, limits.MIN_GROUP_STEP
        self.addDescribed(common.real(STEP, tr("Step from group to group"), *step, decimals=6), tr(
            "How many times as wide the next coarser group is; the sixth root of 2 on most targets."
        ), advanced=True)
        self.addDescribed(common.real(CRITERION, tr("Criterion"), limits.DEFAULT_CRITERION, 0.01, 1), tr(
            "Share of the full amplitude that the bars need for a group to be resolved."
        ), advanced=True)
        self.addDescribed(common.choice(FULL_AMPLITUDE, tr("Full amplitude"), limits.FULL_AMPLITUDES), tr(
            "group: the group's own bars against plain gaps, as in the paper. coarsest: that of the coarsest group, a "
            "reference that doesn't change from group to group, and a stricter one."
        ), advanced=True)
        self.addDescribed(common.flag(REVERSED, tr("Higher numbers are coarser")), tr(
            "For targets numbered the other way."
        ), advanced=True)
        self.addDescribed(common.result(OUTPUT, tr("Measured groups"), common.LINE), tr(
            "The lines as they were measured, one row per band: bars, amplitudes, modulation, verdict, shift."
        ))
        self.addDescribed(*common.chart(tr("The profiles with their bars, threshold and verdict, group by group.")))
        self.addDescribed(*common.report(tr(
            "A page with the distances, the target, the profiles and all measurements."
        )))
        self.addNumbers({name: tr(title) for name, title in _NUMBERS.items()})

    def check(self, run: Run) -> None:
        self._band(run, run.north_up(RASTER))

    def prepare_run(self, run: Run) -> None:
        self._raster = run.north_up(RASTER)

    def execute(self, run: Run) -> dict[str, Any]:
        from ..toolkit import layers
        from . import line_layers
        from .distance_words import distance_sentences
        from .measure.bar_groups import judge_lines
        from .measure.bars import measure_line

        raster, target = self._raster, self._target(run)
        width, band = run.real(WIDTH), self._band(run, raster)
        lines = run.source(GROUPS)
        names = lines.fields().names()
        line_layers.check_fields(names)
        observers = line_layers.observer_fields(names)
        count = lines.featureCount()
        if count == 0:
            raise SettingsError(messages.NO_BAR_LINES())
        crs = layers.mosaic_crs(raster)
        transform = run.transform(lines, crs)
        measured: list[MeasuredLine] = []
        for row in layers.features(lines):
            if run.is_cancelled():
                break
            line = line_layers.bar_line(row, raster.grid, transform, observers)
            measured.append(measure_line(raster, line, target.bars, width, band))
            run.progress(0.9 * len(measured) / max(count, 1))
        resolution = judge_lines(raster, measured, target)
        for result in resolution.results:
            if result.reason is not None:
                line, band_name = result.measured.line, band_title(result.band) if result.band else ""
                where = f"{line.group} {tr(line.direction)} {band_name}".strip()
                run.tell(imagery_messages.ABOUT(what=where, why=result.reason))
        if not any(result.is_judged for result in resolution.results) and not run.is_cancelled():
            raise SettingsError(messages.NO_LINE_MEASURED(count=count))
        run.tell(*resolution.notices)
        for sentence in distance_sentences(resolution):
            run.feedback.pushInfo(sentence)
        sink, destination = run.sink(OUTPUT, line_layers.result_fields(), QgsWkbTypes.Type.LineString, crs)
        run.write(sink, line_layers.result_features(resolution.results, raster.grid))
        return {
            OUTPUT: destination,
            **dict(zip(_NUMBERS, (
                resolution.worst("along"), resolution.worst("across"), resolution.mean,
                resolution.worst_error("along"), resolution.worst_error("across"), resolution.mean_error,
                *(resolution.interval("along") or (None, None)), *(resolution.interval("across") or (None, None)),
                resolution.seen("along"), resolution.seen("across"),
                min(resolution.contrasts.values(), default=None),
            ))),
            **run.save(common.CHART, lambda path: _save_chart(path, resolution, target)),
            **run.save(common.REPORT, lambda path: _save_report(path, raster, resolution, target)),
        }

    def _target(self, run: Run) -> limits.Target:
        numbers = run.real(REFERENCE_GRD), run.real(STEP), run.real(CRITERION)
        words = run.word(FULL_AMPLITUDE), run.word(GRD_OF)
        return limits.Target(run.whole(BARS), run.whole(REFERENCE_GROUP), *numbers, run.flag(REVERSED), *words)

    def _band(self, run: Run, raster: Raster) -> int | None:
        """The place of the band among those that are measured; None for all."""
        from ..imagery.open_raster import OpenRaster

        number = run.whole(BAND)
        return None if number == 0 else OpenRaster(raster.ref).band_index(number)


def _save_chart(path: Path, resolution: TargetResolution, target: limits.Target) -> None:
    from ..toolkit.charts.figure_files import save_figure
    from .charts import group_chart

    save_figure(group_chart(resolution.results, target.criterion), path)


def _save_report(path: Path, raster: Raster, resolution: TargetResolution, target: limits.Target) -> None:
    from .report import save_resolution_report

    save_resolution_report(path, raster, resolution, target)
