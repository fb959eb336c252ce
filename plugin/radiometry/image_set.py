"""The images of one run, measured one by one and held against the rules."""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Callable

from qgis.core import QgsProcessingFeatureSource

from ..imagery import messages as imagery_messages
from ..imagery.clips import DrawnWindow, pixels_under
from ..imagery.errors import Message, SeamInspectorError, WindowError
from ..imagery.grids import PixelWindow
from ..imagery.open_raster import OpenRaster
from ..imagery.rasters import Raster
from ..toolkit.algorithms.run import Run
from .drawn_layers import grey_areas_on, has_map, seams_on, with_features
from .measure.assessment import Assessment, judge
from .measure.image_ranges import known_range, range_of_set
from .measure.measured_image import Drawn, MeasuredImage, measure
from .measure.rules import RuleSet


class ImageSet:
    """Measures image by image; those whose range only the whole set can tell wait for the others."""

    def __init__(
        self, run: Run, rules: RuleSet, seamlines: QgsProcessingFeatureSource | None,
        grey_areas: QgsProcessingFeatureSource | None, unseen: list[Message], finish: Callable[[Assessment], None],
    ) -> None:
        """``unseen`` is added to; ``finish`` takes each result."""
        self._run, self._rules, self._unseen, self._finish = run, rules, unseen, finish
        self._seamlines, self._grey_areas = seamlines, grey_areas
        self._waiting: list[MeasuredImage] = []

    def check(self, jobs: Sequence[tuple[Raster, PixelWindow, int | None]]) -> None:
        for done, (image, window, number) in enumerate(jobs):
            if self._run.is_cancelled():
                return
            place = (done, len(jobs))
            try:
                measured = self._measured(image, window, number, place)
            except SeamInspectorError as error:
                self._unseen.append(imagery_messages.SOURCE_LEFT_OUT(name=image.ref.name, why=error.message))
                self._run.tell(self._unseen[-1])
                continue
            if measured is None:
                return
            of_image = known_range(image, measured.largest_value, self._rules.value_range)
            if of_image is None:
                self._waiting.append(measured.kept())
            else:
                self._finish(judge(measured, self._rules, of_image))
        if self._waiting:
            of_set = range_of_set([one.largest_value for one in self._waiting if one.largest_value is not None])
            while self._waiting:
                self._finish(judge(self._waiting.pop(0), self._rules, of_set))

    def _measured(
        self, image: Raster, window: PixelWindow, number: int | None, place: tuple[int, int]
    ) -> MeasuredImage | None:
        done, count = place
        run = self._run
        drawn = Drawn(
            None if self._seamlines is None else seams_on(self._seamlines, image, run),
            None if self._grey_areas is None else grey_areas_on(self._grey_areas, image, run),
        )
        source = OpenRaster(image.ref)
        measured = measure(
            source, window, self._rules, drawn, number, lambda share: run.goes_on((done + share) / count)
        )
        if measured is not None and measured.seams and self._seamlines is not None and has_map(image):
            return replace(measured, seams=with_features(measured.seams, self._seamlines, image, run))
        return measured


def jobs_on(
    images: Sequence[Raster], drawn: Sequence[DrawnWindow] | None, notices: list[Message]
) -> Iterator[tuple[Raster, PixelWindow, int | None]]:
    """What is checked: whole images, or the windows on them; ``notices`` is added to."""
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
