"""The images of one run, measured one by one and held against the rules; and the table of that, whose field names are
contracts."""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Callable, NamedTuple, Optional

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCoordinateTransformContext,
    QgsCsException,
    QgsFeature,
    QgsFeatureRequest,
    QgsFields,
    QgsGeometry,
    QgsPointXY,
    QgsProcessingFeatureSource,
    QgsWkbTypes,
)

from ..imagery import messages as imagery_messages
from ..imagery.clips import DrawnWindow, extent_on_image
from ..imagery.errors import CancelledError, Message, SeamInspectorError, WindowError
from ..imagery.grids import PixelWindow, covered_share, snap_window
from ..imagery.open_raster import OpenRaster
from ..imagery.rasters import Raster
from ..imagery.records import Column
from ..toolkit import layers
from ..toolkit.algorithms.run import Run
from ..toolkit.layers import rectangle, transformed
from ..toolkit.reference_systems import reference_system, transformation
from ..toolkit.table_fields import column_features, feature, table_fields
from ..toolkit.translation import sentence
from .measure import limits
from .measure.assessment import Assessment, CheckedFigure, decide_image, judge
from .measure.image_statistics import known_range, range_of_set
from .measure.measured_image import MeasuredImage, measure
from .measure.rules import Rule, RuleSet
from .words import spot_words

if TYPE_CHECKING:
    from ..imagery.lines import Seam
    from .measure.seam_steps import SeamStep

ImageJob = tuple[Raster, PixelWindow, Optional[int]]
"""An image, the pixels of it that are measured, and the number of their window; None for the whole image."""
_REACH_PX = 3  # between a seam and the features it comes from: it was straightened by 1.5 px


def has_map(image: Raster) -> bool:
    """Whether layers can be laid on an image."""
    return image.is_north_up and image.has_place and bool(image.wkt)


@dataclass(frozen=True)
class DrawnLayers:
    """The layers of one run that tell of its images where the seams are, and what is grey."""

    run: Run
    seamlines: QgsProcessingFeatureSource | None
    grey_areas: QgsProcessingFeatureSource | None

    def measured(
        self, job: ImageJob, rules: RuleSet, goes_on: Callable[[float], bool]
    ) -> MeasuredImage | None:
        """The statistics of an image for what rules ask of it; None when ``goes_on`` ends the work.

        Raises SeamInspectorError for an image that can't be measured.
        """
        from ..imagery.lines import find_seams
        from .measure.areas import GreyArea

        image, window, number = job
        seams: list[Seam] | None = None
        if self.seamlines is not None:
            lines = [wkb for _, wkb in self._wkb_on(self.seamlines, image)]
            seams = find_seams(lines, image.grid.pixel_width) if has_map(image) else []
        grey = None
        if self.grey_areas is not None:
            areas = self._wkb_on(self.grey_areas, image, are_areas=True)
            grey = [GreyArea(number, wkb) for number, wkb in areas if wkb is not None]
        measured = measure(OpenRaster(image.ref), window, rules, seams, grey, number, goes_on)
        if measured is not None and measured.seams and self.seamlines is not None and has_map(image):
            return replace(measured, seams=self._with_features(measured.seams, self.seamlines, image))
        return measured

    def _wkb_on(
        self, source: QgsProcessingFeatureSource, image: Raster, are_areas: bool = False
    ) -> Iterator[tuple[int, bytes | None]]:
        """Numbers of features, or of polygons alone, with their shapes in the image's reference system; none for an
        image without a place on the map."""
        if has_map(image):
            transform = self.run.transform(source, layers.mosaic_crs(image))
            for row in layers.features(source):
                if not are_areas or row.geometry().type() == QgsWkbTypes.GeometryType.PolygonGeometry:
                    yield row.id(), layers.line_wkb(row, transform)

    def _with_features(
        self, steps: Iterable[SeamStep], seamlines: QgsProcessingFeatureSource, image: Raster
    ) -> tuple[SeamStep, ...]:
        """Each seam with the numbers of the features that run along it where its tone steps."""
        transforms = self.run.context.transformContext()
        back = transformation(layers.mosaic_crs(image), seamlines.sourceCrs(), transforms)
        reach = _REACH_PX * max(image.grid.pixel_width, image.grid.pixel_height)
        name = seamlines.sourceName()
        return tuple(
            replace(step, features=_features_at(seamlines, step.places[0], reach, back), layer=name) for step in steps
        )


def _features_at(
    source: QgsProcessingFeatureSource, place: tuple[float, float], reach: float, back: QgsCoordinateTransform
) -> tuple[str, ...]:
    around = QgsGeometry.fromPointXY(QgsPointXY(*place)).buffer(reach, 8)
    try:
        around.transform(back)
    except QgsCsException:
        return ()
    request = QgsFeatureRequest().setFilterRect(around.boundingBox())
    numbers = []
    for row in source.getFeatures(request, QgsProcessingFeatureSource.Flag.FlagSkipGeometryValidityChecks):
        geometry = row.geometry()
        if geometry.type() == QgsWkbTypes.GeometryType.PolygonGeometry:
            geometry = QgsGeometry(geometry.constGet().boundary())
        if geometry.intersects(around):
            numbers.append(row.id())
    return tuple(map(str, sorted(numbers)))


def assessed(
    drawn: DrawnLayers, rules: RuleSet, jobs: Sequence[ImageJob], unseen: list[Message]
) -> Iterator[Assessment]:
    """Measure image by image and hold them against the rules; those whose range only the whole set can tell wait for
    the others. Ends where the run is cancelled. ``unseen`` is added to."""
    run, waiting = drawn.run, []
    for done, job in enumerate(jobs):
        if run.is_cancelled():
            return

        def goes_on(share: float, done: int = done) -> bool:
            return run.goes_on((done + share) / len(jobs))

        image = job[0]
        try:
            measured = drawn.measured(job, rules, goes_on)
        except CancelledError:
            return
        except SeamInspectorError as error:
            unseen.append(imagery_messages.SOURCE_LEFT_OUT(name=image.ref.name, why=error.message))
            run.tell(unseen[-1])
            continue
        if measured is None:
            return
        of_image = known_range(image, measured.largest_value, rules.value_range)
        if of_image is None:
            waiting.append(measured.trimmed())
        else:
            yield judge(measured, rules, of_image)
    if waiting:
        of_set = range_of_set([image.largest_value for image in waiting if image.largest_value is not None])
        while waiting:
            yield judge(waiting.pop(0), rules, of_set)


def jobs_on(
    images: Sequence[Raster], drawn: Sequence[DrawnWindow] | None, notices: list[Message]
) -> Iterator[ImageJob]:
    """The images to be checked, whole or the windows on them; ``notices`` is added to."""
    if drawn is None:
        yield from ((image, image.whole, None) for image in images)
        return
    seen: set[int] = set()
    for image in images:
        for window in drawn:
            try:
                if not image.is_north_up:
                    raise WindowError(imagery_messages.NOT_NORTH_UP(name=image.ref.name))
                extent = extent_on_image(window.extent, window.wkt, image)
                pixels = None
                if extent is not None and covered_share(extent, image.grid.extent):
                    pixels = snap_window(image.grid, extent, levels=0)
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


class _Row(NamedTuple):
    result: Assessment
    checked: CheckedFigure
    decision: str


COLUMNS: tuple[Column[_Row], ...] = (
    Column("raster", "text", lambda row: row.result.image.ref.name),
    Column("window_id", "integer", lambda row: row.result.window_id),
    Column("band", "text", lambda row: row.checked.band),
    Column("check", "text", lambda row: row.checked.rule.check),
    Column("value", "real", lambda row: row.checked.value),
    Column("limit", "text", lambda row: limit_text(row.checked.rule)),
    Column("passed", "integer", lambda row: None if row.checked.passed is None else int(row.checked.passed)),
    Column("source", "text", lambda row: row.checked.rule.source),
    Column("reason", "text", lambda row: sentence(row.checked.reason) if row.checked.reason else None),
    Column("least", "real", lambda row: row.checked.rule.least),
    Column("most", "real", lambda row: row.checked.rule.most),
    Column("required", "integer", lambda row: int(row.checked.rule.required)),
    Column("decision", "text", lambda row: row.decision),
    Column("place", "text", lambda row: spot_words(row.checked)),
    Column("x", "real", lambda row: None if row.checked.spot is None else row.checked.spot.place[0]),
    Column("y", "real", lambda row: None if row.checked.spot is None else row.checked.spot.place[1]),
)
"""OUTPUT: one row per raster (or window of it), check and band. Shares are fractions of 1; ``passed`` is 1, 0, or
nothing where the figure can't be measured or has no limit; ``decision`` is that on the raster or window; ``place``,
``x`` and ``y`` say where a figure comes from, in the raster's reference system."""

_AREA_FIELDS = (("raster", "text"), ("red", "real"), ("green", "real"), ("blue", "real"), ("difference", "real"))


def radiometry_features(result: Assessment) -> Iterator[QgsFeature]:
    """The rows of OUTPUT for an image or a window of it."""
    decision = decide_image(result).outcome
    return column_features(COLUMNS, (_Row(result, checked, decision) for checked in result.checked_figures))


def maybe_grey_layout(images: Sequence[Raster]) -> tuple[QgsFields, QgsWkbTypes.Type, QgsCoordinateReferenceSystem]:
    """MAYBE_GREY: polygons of areas that may be grey, in the reference system of the first raster on the map."""
    wkt = next((image.wkt for image in images if has_map(image)), "")
    return table_fields(*_AREA_FIELDS), QgsWkbTypes.Type.Polygon, reference_system(wkt)


def maybe_grey_features(
    result: Assessment, images: Sequence[Raster], transforms: QgsCoordinateTransformContext
) -> Iterator[QgsFeature]:
    """The rows of MAYBE_GREY for an image; none for one without a place on the map."""
    areas, image = result.maybe_grey, result.image
    if areas is None or not has_map(image):
        return
    fields, _, crs = maybe_grey_layout(images)
    try:
        transform = transformation(reference_system(image.wkt), crs, transforms)
    except WindowError:
        return
    for (column, row), means, spread in zip(areas.corners.tolist(), areas.means.tolist(), areas.spreads.tolist()):
        window = PixelWindow(column, row, limits.AREA_PX, limits.AREA_PX)
        outline = rectangle(image.grid.window_extent(window))
        try:
            outline = transformed(outline, transform)
        except WindowError:
            continue
        yield feature(fields, [image.ref.name, *means, spread], outline)


def limit_text(rule: Rule) -> str | None:
    """The limits in the unit of the value; None without any."""
    if rule.least is not None and rule.most is not None:
        return f"{rule.least:g} to {rule.most:g}"
    if rule.most is not None:
        return f"<= {rule.most:g}"
    return None if rule.least is None else f">= {rule.least:g}"
