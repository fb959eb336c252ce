"""``seaminspector:checknoise``: random noise of single images, in one group or two."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import QgsProcessing, QgsProcessingParameterFeatureSink
from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP

from ..imagery import messages as imagery_messages
from ..imagery.errors import SettingsError
from ..toolkit.algorithms import groups
from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.raster_lists import RASTERS, RasterListAlgorithm
from ..toolkit.algorithms.run import Run
from ..toolkit.translation import tr

if TYPE_CHECKING:
    from ..imagery.message import Message
    from .measure.group_noise import ClipNoise

SECOND_GROUP, OUTPUT = "SECOND_GROUP", "OUTPUT"
LOW_COUNT, MODERATE_COUNT, STRONG_COUNT = "LOW_COUNT", "MODERATE_COUNT", "STRONG_COUNT"


class CheckNoise(RasterListAlgorithm):
    """Whether the details of an image rise from level to level, or noise lifts the finest."""

    ID = "checknoise"
    NAME = QT_TRANSLATE_NOOP("@default", "Check random noise")
    GROUP = groups.IMAGE_QUALITY
    HELP = QT_TRANSLATE_NOOP(
        "@default",
        "Says how much random noise an image has, whether film, scan or sensor. In an image with little noise the "
        "relative variance of the details rises from level to level; noise lifts level 1 above level 2 (moderate) "
        "and, where it is strong, level 2 above level 3 (Pyka 2009). Photographs and scans need no place on the map. "
        "Two groups of images, of another camera, film or process, are compared; where they show the same ground "
        "each window is measured on both, with the same pixels left out."
    )
    RASTER_LISTS = (RASTERS, SECOND_GROUP)

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.addRasters(RASTERS, tr("Rasters"), tr("The images to be measured, 8 or 16 bit or float."))
        self.addRasters(
            SECOND_GROUP,
            tr("Second group"),
            tr("Images of another camera, film or process, to be compared with the first. Pixel sizes may differ."),
            optional=True,
        )
        self.addWindows(
            tr(
                "Rectangles in any reference system; each is measured on all rasters under it. Without windows up to "
                "25 of 1024 px are chosen on each raster, spread over its valid part, the least saturated first."
            )
        )
        self.addDescribed(*common.wavelet())
        self.addDescribed(*common.levels())
        table = QgsProcessing.SourceType.TypeVector
        self.addDescribed(
            QgsProcessingParameterFeatureSink(OUTPUT, tr("Noise"), table),
            tr(
                "One row per window, raster and band: relative variances, kurtosis of each level's details (3 for "
                "Gaussian noise), sigma in DN, and the verdict low, moderate or strong."
            ),
        )
        self.addDescribed(
            *common.chart(
                tr("The range of each group with its mean line, and the bands of one window. PNG, SVG or PDF.")
            )
        )
        self.addDescribed(*common.report(tr("All figures with the chart on one HTML page.")))
        self.addNumbers({
            LOW_COUNT: tr("Windows with low noise"),
            MODERATE_COUNT: tr("Windows with moderate noise"),
            STRONG_COUNT: tr("Windows with strong noise"),
        })

    def check(self, run: Run) -> None:
        super().check(run)
        self._settings(run)
        run.check_chart()

    def execute(self, run: Run) -> dict[str, Any]:
        from ..toolkit.executors import open_executor
        from . import noise_summary, tables
        from .measure import group_noise, window_plan
        from .measure.band_noise import NoiseVerdict
        from .measure.noise_requests import describe_images

        super().check(run)
        wavelet, levels = self._settings(run)
        run.check_chart()
        images = []
        for group, name in enumerate(self.RASTER_LISTS, 1):
            found, notices = describe_images(self.refs[name], group)
            images += found
            self.left_out += notices
        self.require_rasters(images)
        drawn = self.drawn_windows(run)
        if drawn is None:
            plan = window_plan.plan_chosen(images, levels, run.is_cancelled)
        else:
            plan = window_plan.plan_drawn(images, drawn, levels)
        notices = [*self.left_out, *plan.notices]
        sizes = window_plan.pixel_size_notice(plan)
        notices += [sizes] if sizes else []
        run.tell_once(notices)
        if not plan.requests and not run.is_cancelled():
            raise SettingsError(imagery_messages.NOTHING_MEASURED(why=tuple(notices[:1])))
        sink, output_id = run.sink(OUTPUT, tables.noise_fields(levels))
        results: list[group_noise.ClipNoise] = []
        with open_executor() as (executor, ahead):
            measured = group_noise.measure_requests(plan.requests, wavelet, levels, executor, ahead, run.is_cancelled)
            for done, clips in enumerate(measured, 1):
                for clip in clips:
                    run.write(sink, tables.noise_features(clip, levels))
                    if clip.reason is not None:
                        run.tell(imagery_messages.ABOUT(what=clip.window_id, why=clip.reason))
                results += clips
                run.progress(done / len(plan.requests))
        counts = noise_summary.verdict_counts(results)
        words = noise_summary.VERDICT_WORDS
        run.inform(", ".join(f"{tr(word)}: {counts[verdict]}" for verdict, word in words.items()))
        return {
            OUTPUT: output_id,
            **run.save(common.CHART, lambda path: _save_chart(path, results)),
            **run.save(common.REPORT, lambda path: _save_report(path, results, notices, wavelet, levels)),
            LOW_COUNT: counts[NoiseVerdict.LOW],
            MODERATE_COUNT: counts[NoiseVerdict.MODERATE],
            STRONG_COUNT: counts[NoiseVerdict.STRONG],
        }

    def _settings(self, run: Run) -> tuple[str, int]:
        """Wavelet and levels. Raises SettingsError when they can't be used."""
        from .measure.band_noise import check_noise_settings

        wavelet, levels = run.decomposition()
        check_noise_settings(wavelet, levels)
        return wavelet, levels


def _save_chart(path: Path, results: Sequence[ClipNoise]) -> bool:
    from ..toolkit.charts.figure_files import save_figure
    from .charts import noise_figure

    figure = noise_figure(results)
    if figure is not None:
        save_figure(figure, path)
    return figure is not None


def _save_report(
    path: Path, results: Sequence[ClipNoise], notices: Iterable[Message], wavelet: str, levels: int
) -> None:
    from .report import save_noise_report

    save_noise_report(path, results, notices, wavelet, levels)
