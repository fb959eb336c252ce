"""``seaminspector:checkradiometry``: the radiometric acceptance of images against rules."""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessing,
    QgsProcessingFeatureSource,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterFile,
)
from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP

from ..imagery import messages as imagery_messages
from ..imagery.errors import RasterError, SeamInspectorError, SettingsError, WindowError
from ..toolkit.algorithms import groups
from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.raster_lists import RASTERS, RasterListAlgorithm
from ..toolkit.algorithms.run import Run
from ..toolkit.translation import tr

if TYPE_CHECKING:
    from ..imagery.drawn_windows import DrawnWindow
    from ..imagery.grids import PixelWindow
    from ..imagery.lines.seamlines import Seam
    from ..imagery.message import Message
    from ..imagery.rasters import Raster, RasterRef
    from .measure.assessment import Assessment
    from .measure.rules import RuleSet

RULES, SEAMLINES, OUTPUT = "RULES", "SEAMLINES", "OUTPUT"
PASSED_COUNT, FAILED_COUNT, NOT_MEASURABLE_COUNT = "PASSED_COUNT", "FAILED_COUNT", "NOT_MEASURABLE_COUNT"


class CheckRadiometry(RasterListAlgorithm):
    """Whether images keep the limits of a specification."""

    ID = "checkradiometry"
    NAME = QT_TRANSLATE_NOOP("@default", "Check radiometry")
    GROUP = groups.IMAGE_QUALITY
    HELP = QT_TRANSLATE_NOOP(
        "@default",
        "Holds images against the limits of a specification, by default JRC's for orthoimages in the LPIS: clipped "
        "tails, peak of the histogram, contrast, signal to noise on uniform mid-tone areas, colour balance on neutral "
        "areas, and with seamlines the step of tone at the seams. Whole rasters are streamed in blocks. What can't be "
        "measured is said with the reason."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        line, polygon = QgsProcessing.SourceType.TypeVectorLine, QgsProcessing.SourceType.TypeVectorPolygon
        self.addRasters(RASTERS, tr("Rasters"), tr("The images to be checked, each for itself."))
        self.addWindows(tr(
            "Rectangles in any reference system; each is checked for itself on all rasters under it. Without windows "
            "each raster is checked as a whole."
        ))
        self.addDescribed(
            QgsProcessingParameterFile(RULES, tr("Rules"), extension="json", optional=True),
            tr(
                "A JSON file with the limits and where they come from; the documentation has one to start from. "
                "Without it the JRC specification is used."
            ),
        )
        self.addDescribed(
            QgsProcessingParameterFeatureSource(SEAMLINES, tr("Seamlines"), [line, polygon], optional=True),
            tr(
                "Lines, or polygons of which each is filled from one orthoimage: the step of tone at the seams is "
                "measured on the rasters they cross, 2 to 10 px on either side."
            ),
        )
        self.addDescribed(
            QgsProcessingParameterFeatureSink(OUTPUT, tr("Radiometry"), QgsProcessing.SourceType.TypeVector),
            tr("One row per raster or window, check and band: value, limit, whether it passed, and the rule's source."),
        )
        self.addDescribed(*common.report(tr("All figures with the histograms on one HTML page.")))
        self.addNumbers({
            PASSED_COUNT: tr("Figures that passed"),
            FAILED_COUNT: tr("Figures that failed"),
            NOT_MEASURABLE_COUNT: tr("Figures that can't be measured"),
        })

    def check(self, run: Run) -> None:
        super().check(run)
        self._rules(run)

    def execute(self, run: Run) -> dict[str, Any]:
        from . import tables

        super().check(run)
        rules = self._rules(run)
        drawn = self.drawn_windows(run)
        seamlines = run.source(SEAMLINES) if run.parameters.get(SEAMLINES) else None
        images = [image for ref in dict.fromkeys(self.refs[RASTERS]) if (image := self._image(ref)) is not None]
        self.require_rasters(images)
        run.tell_once(self.left_out)
        sink, output_id = run.sink(OUTPUT, tables.radiometry_fields())
        results: list[Assessment] = []
        notices = list(self.left_out)
        jobs = list(self._jobs(images, drawn, notices))
        run.tell_once(notices[len(self.left_out) :])
        for done, (image, window, number) in enumerate(jobs):
            if run.is_cancelled():
                break
            try:
                seams = None if seamlines is None else self._seams(seamlines, image, run)
                result = self._assess(image, window, number, rules, seams, (done, len(jobs)), run)
            except SeamInspectorError as error:
                notices.append(imagery_messages.SOURCE_LEFT_OUT(name=image.ref.name, why=error.message))
                run.tell(notices[-1])
                continue
            if result is None:
                break
            run.write(sink, tables.radiometry_features(result))
            run.tell_once(result.notices)
            notices += result.notices
            results.append(result)
        if not results and not run.is_cancelled():
            raise SettingsError(imagery_messages.NOTHING_MEASURED(why=tuple(notices[-1:])))
        figures = [checked for result in results for checked in result.checked_figures]
        states = [checked.passed for checked in figures]
        return {
            OUTPUT: output_id,
            **run.save(common.REPORT, lambda path: _save_report(path, results, notices, rules)),
            PASSED_COUNT: states.count(True),
            FAILED_COUNT: states.count(False),
            NOT_MEASURABLE_COUNT: sum(checked.value is None for checked in figures),
        }

    def _rules(self, run: Run) -> RuleSet:
        from .measure.rules import default_rules, load_rules

        path = run.text(RULES) if run.parameters.get(RULES) else ""
        return load_rules(Path(path)) if path else default_rules()

    def _image(self, ref: RasterRef) -> Raster | None:
        from ..imagery.open_raster import describe

        try:
            return describe(ref)
        except RasterError as error:
            self.left_out.append(imagery_messages.SOURCE_LEFT_OUT(name=ref.name, why=error.message))
            return None

    @staticmethod
    def _jobs(
        images: Sequence[Raster], drawn: Sequence[DrawnWindow] | None, notices: list[Message]
    ) -> Iterator[tuple[Raster, PixelWindow, int | None]]:
        """What is checked: whole images, or the windows on them; ``notices`` is added to."""
        from ..imagery.drawn_windows import pixels_under

        if drawn is None:
            yield from ((image, image.whole, None) for image in images)
            return
        seen: set[int] = set()
        for image in images:
            for window in drawn:
                try:
                    pixels = pixels_under(window, image)
                except WindowError as error:
                    name, why = image.ref.name, error.message
                    notices.append(imagery_messages.WINDOW_LEFT_OUT(window=window.window_id, name=name, why=why))
                    seen.add(window.window_id)
                    continue
                if pixels is not None:
                    seen.add(window.window_id)
                    yield image, pixels, window.window_id
        unseen = [window.window_id for window in drawn if window.window_id not in seen]
        notices += [imagery_messages.WINDOW_ON_NO_RASTER(window=window) for window in unseen]

    @staticmethod
    def _seams(seamlines: QgsProcessingFeatureSource, image: Raster, run: Run) -> list[Seam]:
        """The seams in the image's reference system; none for an image without a place on the map."""
        from ..imagery.lines.seamlines import find_seams
        from ..toolkit import layers

        if not (image.is_north_up and image.has_place and image.wkt):
            return []
        crs = QgsCoordinateReferenceSystem.fromWkt(image.wkt)
        transform = run.transform(seamlines, crs)
        lines = (layers.line_wkb(feature, transform) for feature in layers.features(seamlines))
        return find_seams(lines, image.grid.pixel_width)

    @staticmethod
    def _assess(
        image: Raster, window: PixelWindow, number: int | None, rules: RuleSet, seams: Sequence[Seam] | None,
        place: tuple[int, int], run: Run,
    ) -> Assessment | None:
        from ..imagery.open_raster import OpenRaster
        from .measure.assessment import assess

        done, count = place
        source = OpenRaster(image.ref)
        return assess(source, window, rules, seams, number, lambda share: run.goes_on((done + share) / count))


def _save_report(path: Path, results: Sequence[Assessment], notices: Iterable[Message], rules: RuleSet) -> None:
    from .report import save_radiometry_report

    save_radiometry_report(path, results, notices, rules)
