"""``seaminspector:checknoise``: random noise of single images, in one group or two."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.PyQt.QtCore import QT_TR_NOOP

from ..imagery import messages as imagery_messages
from ..imagery.errors import SettingsError
from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.base import IMAGE_QUALITY
from ..toolkit.algorithms.raster_lists import RASTERS, WINDOWS, RasterListAlgorithm
from ..toolkit.algorithms.run import Run
from ..toolkit.translation import filled, tr
from .measure import messages

if TYPE_CHECKING:
    from ..imagery.errors import Message
    from .measure.group_noise import ClipNoise

SECOND_GROUP, OUTPUT = "SECOND_GROUP", "OUTPUT"
GROUP_NAME, SECOND_GROUP_NAME, GROUP_FIELD = "GROUP_NAME", "SECOND_GROUP_NAME", "GROUP_FIELD"
_COUNTS = {
    "LOW_COUNT": QT_TR_NOOP("Windows with low noise"),
    "UNCERTAIN_COUNT": QT_TR_NOOP("Windows whose texture could hide grain"),
    "MODERATE_COUNT": QT_TR_NOOP("Windows with moderate noise"),
    "STRONG_COUNT": QT_TR_NOOP("Windows with strong noise"),
}


class CheckNoise(RasterListAlgorithm):
    """Whether the details of an image rise from level to level, or noise lifts the finest."""

    ID = "checknoise"
    NAME = QT_TR_NOOP("Check random noise")
    GROUP = IMAGE_QUALITY
    HELP = QT_TR_NOOP(
        "Measures how much random noise an image has, from film, scanner or sensor. In an image with little noise the "
        "relative variance of the details rises from level to level; noise lifts level 1 above level 2 (moderate) and, "
        "where it is strong, level 2 above level 3 (Pyka 2009). Grain coarser than a pixel is looked for in the "
        "spectrum of the quietest ground; where texture could hide it, the verdict is uncertain. The rule compares "
        "noise with the scene; the amount beside it is the ratio of the signal to the noise. Photographs and scans "
        "need no georeference. Two groups of images, of another camera, film or process, are compared; where they show "
        "the same ground each window is measured on both, with the same pixels left out. Windows are grouped by one of "
        "their fields, such as land use or scale."
    )
    RASTER_LISTS = (RASTERS, SECOND_GROUP)

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.addDescribed(common.layers(RASTERS, tr("Rasters")), tr(
            "The images to be measured, 8 or 16 bit or float."
        ))
        self.addDescribed(common.layers(SECOND_GROUP, tr("Second group"), optional=True), tr(
            "Images of another camera, film or process, to be compared with the first. Pixel sizes may differ."
        ))
        self.addDescribed(common.words(GROUP_NAME, tr("Name of the rasters")), tr(
            "What the first group is called in chart and report. Empty: its file's name, or group 1."
        ))
        self.addDescribed(common.words(SECOND_GROUP_NAME, tr("Name of the second group")), tr(
            "What the second group is called. Empty: its file's name, or group 2."
        ))
        self.addDescribed(common.features(WINDOWS, tr("Windows"), common.POLYGON, optional=True), tr(
            "Rectangles in any reference system; each is measured on all rasters under it. Without windows up to 25 of "
            "1024 px are chosen on each raster, spread over its valid part, the least saturated first."
        ))
        self.addDescribed(common.field(GROUP_FIELD, tr("Group windows by"), WINDOWS), tr(
            "A field of the windows, such as land use, scale or film: chart and report compare its values."
        ))
        self.addDescribed(*common.wavelet())
        self.addDescribed(*common.levels())
        self.addDescribed(common.result(OUTPUT, tr("Noise"), common.TABLE), tr(
            "One row per window, raster and band: relative variances, kurtosis of each level's details (3 for Gaussian "
            "noise), sigma in DN, the most that grain can be, the verdict low, uncertain, moderate or strong, and "
            "beside it the amount of noise by the signal to noise ratio: little, some or much; at most some where "
            "texture can hide it, uncertain where texture can hide much."
        ))
        self.addDescribed(*common.chart(tr(
            "The range of each group with its mean line, and the bands of one window. PNG, SVG or PDF."
        )))
        self.addDescribed(*common.report(tr("All figures with the chart on one HTML page.")))
        self.addNumbers({name: tr(title) for name, title in _COUNTS.items()})

    def check(self, run: Run) -> None:
        super().check(run)
        self._settings(run)
        self._group_field(run)

    def execute(self, run: Run) -> dict[str, Any]:
        from ..toolkit.executors import open_executor
        from . import noise_summary
        from .measure import group_noise, noise_plan
        from .measure.band_noise import NoiseVerdict

        super().check(run)
        wavelet, levels = self._settings(run)
        field = self._group_field(run)
        images = []
        names = (run.text(GROUP_NAME), run.text(SECOND_GROUP_NAME))
        for group, (parameter, name) in enumerate(zip(self.RASTER_LISTS, names), 1):
            refs = self.refs[parameter]
            usual = refs[0].name if len(refs) == 1 else filled(tr("group {group}"), group=group)
            images += [noise_plan.GroupedImage(image, group, name or usual) for image in self.opened(refs)]
        self.require_rasters(images)
        drawn = self.drawn_windows(run, (field,) if field else ())
        if drawn is None:
            plan = noise_plan.plan_chosen(images, levels, run.is_cancelled)
        else:
            if field and any(field not in values for values in self.window_values.values()):
                raise SettingsError(messages.GROUP_FIELD_UNKNOWN(field=field))
            classes = {window: values.get(field) for window, values in self.window_values.items()}
            plan = noise_plan.plan_drawn(images, drawn, levels, classes)
        notices = [*self.left_out, *plan.notices]
        sizes = noise_plan.pixel_size_notice(plan)
        notices += [sizes] if sizes else []
        run.tell_once(notices)
        if not plan.requests and not run.is_cancelled():
            raise SettingsError(imagery_messages.NOTHING_MEASURED(why=tuple(notices[:1])))
        sink, output_id = run.sink(OUTPUT, noise_summary.noise_fields(levels))
        results: list[group_noise.ClipNoise] = []
        with open_executor() as (executor, ahead):
            measured = group_noise.measure_requests(plan.requests, wavelet, levels, executor, ahead, run.is_cancelled)
            for done, clips in enumerate(measured, 1):
                for clip in clips:
                    if clip.reason is not None:
                        run.tell(imagery_messages.ABOUT(what=clip.window_id, why=clip.reason))
                results += clips
                run.progress(done / len(plan.requests))
        results = group_noise.pooled(results, wavelet)
        for clip in results:
            run.write(sink, noise_summary.noise_features(clip, levels))
        counts = noise_summary.verdict_counts(results)
        words = noise_summary.VERDICT_WORDS
        run.feedback.pushInfo(", ".join(f"{tr(word)}: {counts[verdict]}" for verdict, word in words.items()))
        return {
            OUTPUT: output_id,
            **run.save(common.CHART, lambda path: _save_chart(path, results, field)),
            **run.save(common.REPORT, lambda path: _save_report(path, results, notices, wavelet, levels, field)),
            **{name: counts[NoiseVerdict[name.partition("_")[0]]] for name in _COUNTS},
        }

    def _group_field(self, run: Run) -> str:
        """The field that windows are grouped by; empty for none. Raises SettingsError when there are no windows."""
        field = run.text(GROUP_FIELD)
        if field and not run.parameters.get(WINDOWS):
            raise SettingsError(messages.GROUP_FIELD_WITHOUT_WINDOWS())
        return field

    def _settings(self, run: Run) -> tuple[str, int]:
        """Wavelet and levels. Raises SettingsError when they can't be used."""
        from .measure.band_noise import check_noise_settings

        wavelet, levels = run.decomposition()
        check_noise_settings(wavelet, levels)
        return wavelet, levels


def _save_chart(path: Path, results: Sequence[ClipNoise], field: str) -> bool:
    from ..toolkit.charts.figure_files import save_figure
    from .charts import noise_figure

    figure = noise_figure(results, field)
    if figure is not None:
        save_figure(figure, path)
    return figure is not None


def _save_report(
    path: Path, results: Sequence[ClipNoise], notices: Iterable[Message], wavelet: str, levels: int, field: str
) -> None:
    from .report import save_noise_report

    save_noise_report(path, results, notices, wavelet, levels, field)
