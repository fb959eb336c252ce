"""The images of one run, measured one by one and held against the rules."""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Callable

from qgis.core import (
    QgsCoordinateTransform,
    QgsCsException,
    QgsFeatureRequest,
    QgsGeometry,
    QgsPointXY,
    QgsProcessingFeatureSource,
    QgsWkbTypes,
)

from ..imagery import messages as imagery_messages
from ..imagery.clips import DrawnWindow, pixels_under
from ..imagery.errors import CancelledError, Message, SeamInspectorError, WindowError
from ..imagery.grids import PixelWindow
from ..imagery.open_raster import OpenRaster
from ..imagery.rasters import Raster
from ..toolkit import layers
from ..toolkit.algorithms.run import Run
from ..toolkit.reference_systems import transformation
from .measure.assessment import Assessment, judge
from .measure.image_statistics import known_range, range_of_set
from .measure.measured_image import MeasuredImage, measure
from .measure.rules import RuleSet

if TYPE_CHECKING:
    from ..imagery.lines import Seam
    from .measure.areas import GreyArea
    from .measure.seam_steps import SeamStep

_REACH_PX = 3  # between a seam and the features it comes from: it was straightened by 1.5 px


def has_map(image: Raster) -> bool:
    """Whether layers can be laid on an image."""
    return image.is_north_up and image.has_place and bool(image.wkt)


def seams_on(seamlines: QgsProcessingFeatureSource, image: Raster, run: Run) -> list[Seam]:
    """The seams in the image's reference system; none for an image without a place on the map."""
    from ..imagery.lines import find_seams

    if not has_map(image):
        return []
    transform = run.transform(seamlines, layers.mosaic_crs(image))
    lines = (layers.line_wkb(feature, transform) for feature in layers.features(seamlines))
    return find_seams(lines, image.grid.pixel_width)


def grey_areas_on(areas: QgsProcessingFeatureSource, image: Raster, run: Run) -> list[GreyArea]:
    """The polygons in the image's reference system; features without one are nothing grey."""
    from .measure.areas import GreyArea

    if not has_map(image):
        return []
    transform = run.transform(areas, layers.mosaic_crs(image))
    found = []
    for feature in layers.features(areas):
        geometry = feature.geometry()
        if geometry.isEmpty() or geometry.type() != QgsWkbTypes.GeometryType.PolygonGeometry:
            continue
        wkb = layers.line_wkb(feature, transform)
        if wkb is not None:
            found.append(GreyArea(feature.id(), wkb))
    return found


def with_features(
    steps: Iterable[SeamStep], seamlines: QgsProcessingFeatureSource, image: Raster, run: Run
) -> tuple[SeamStep, ...]:
    """Each seam with the numbers of the features that run along it where its tone steps."""
    back = transformation(layers.mosaic_crs(image), seamlines.sourceCrs(), run.context.transformContext())
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
    found = []
    for feature in source.getFeatures(request, QgsProcessingFeatureSource.Flag.FlagSkipGeometryValidityChecks):
        geometry = feature.geometry()
        if geometry.type() == QgsWkbTypes.GeometryType.PolygonGeometry:
            geometry = QgsGeometry(geometry.constGet().boundary())
        if geometry.intersects(around):
            found.append(str(feature.id()))
    return tuple(sorted(found, key=int))


def assessed(
    run: Run, rules: RuleSet, layers_drawn: tuple[QgsProcessingFeatureSource | None, QgsProcessingFeatureSource | None],
    jobs: Sequence[tuple[Raster, PixelWindow, int | None]], unseen: list[Message],
) -> Iterator[Assessment]:
    """Measures image by image and holds them against the rules; those whose range only the whole set can tell wait for
    the others. Ends where the run is cancelled.

    ``layers_drawn``: seamlines and grey areas. ``unseen`` is added to.
    """
    waiting: list[MeasuredImage] = []
    for done, (image, window, number) in enumerate(jobs):
        if run.is_cancelled():
            return

        def goes_on(share: float, done: int = done) -> bool:
            return run.goes_on((done + share) / len(jobs))

        try:
            measured = _measured(image, window, number, rules, layers_drawn, run, goes_on)
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
            waiting.append(measured.kept())
        else:
            yield judge(measured, rules, of_image)
    if waiting:
        of_set = range_of_set([one.largest_value for one in waiting if one.largest_value is not None])
        while waiting:
            yield judge(waiting.pop(0), rules, of_set)


def _measured(
    image: Raster, window: PixelWindow, number: int | None, rules: RuleSet,
    layers_drawn: tuple[QgsProcessingFeatureSource | None, QgsProcessingFeatureSource | None], run: Run,
    goes_on: Callable[[float], bool],
) -> MeasuredImage | None:
    seamlines, greys = layers_drawn
    seams = None if seamlines is None else seams_on(seamlines, image, run)
    grey_areas = None if greys is None else grey_areas_on(greys, image, run)
    measured = measure(OpenRaster(image.ref), window, rules, seams, grey_areas, number, goes_on)
    if measured is not None and measured.seams and seamlines is not None and has_map(image):
        return replace(measured, seams=with_features(measured.seams, seamlines, image, run))
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
