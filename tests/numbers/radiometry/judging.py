"""Images held against rules, as the algorithm does it."""
from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.lines import Seam
from seam_inspector.plugin.imagery.open_raster import OpenRaster
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.radiometry.measure.areas import GreyArea
from seam_inspector.plugin.radiometry.measure.assessment import Assessment, CheckedFigure, judge
from seam_inspector.plugin.radiometry.measure.image_statistics import known_range, range_of_set
from seam_inspector.plugin.radiometry.measure.measured_image import MeasuredImage, measure
from seam_inspector.plugin.radiometry.measure.rules import (
    DEFAULT_RULES,
    FROM_HISTOGRAM,
    LUMINOSITY,
    RuleSet,
    load_rules,
    ready_rule_files,
)


def measured(path: str, rules: RuleSet, window: PixelWindow | None = None, **options: Any) -> MeasuredImage:
    source = OpenRaster(RasterRef(path))
    result = measure(source, window or source.raster.whole, rules, **options)
    assert result is not None
    return result


def checked_set(paths: Sequence[str], rules: RuleSet | None = None) -> list[Assessment]:
    """All images of a delivery."""
    rules = rules or default_rules()
    results = [measured(path, rules) for path in paths]
    ranges = [known_range(result.image, result.largest_value, rules.value_range) for result in results]
    open_ones = [result.largest_value for result, known in zip(results, ranges) if known is None]
    of_set = range_of_set([value for value in open_ones if value is not None]) if open_ones else None
    return [judge(result, rules, known or of_set) for result, known in zip(results, ranges)]  # type: ignore[arg-type]


def checked(
    path: str, window: PixelWindow | None = None, rules: RuleSet | None = None, seams: Sequence[Seam] | None = None,
    grey_areas: Sequence[GreyArea] | None = None,
) -> Assessment:
    """One image alone."""
    rules = rules or default_rules()
    result = measured(path, rules, window, seams=seams, grey_areas=grey_areas)
    of_image = known_range(result.image, result.largest_value, rules.value_range)
    if of_image is None:
        assert result.largest_value is not None
        of_image = range_of_set([result.largest_value])
    return judge(result, rules, of_image)


def checked_figure(result: Assessment, check: str, band: str = "") -> CheckedFigure:
    """Figure of a band, else of what the default rules hold against limits in an image with one band."""
    band = band or (LUMINOSITY if check in FROM_HISTOGRAM else "band_1")
    (chosen,) = [figure for figure in result.checked_figures if (figure.rule.check, figure.band) == (check, band)]
    return chosen


def figure(result: Assessment, check: str, band: str = "") -> float:
    value = checked_figure(result, check, band).value
    assert value is not None
    return value


def reasons(result: Assessment) -> dict[str, str]:
    return {figure.rule.check: str(figure.reason) for figure in result.checked_figures if figure.value is None}


def default_rules() -> RuleSet:
    """JRC's orthoimage specification for LPIS, as its text says."""
    return load_rules(ready_rule_files()[DEFAULT_RULES])
