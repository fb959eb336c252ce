"""``seaminspector:comparemarks``: two measurements of the same marks against each other."""
from __future__ import annotations

import math
from typing import Any

from qgis.core import (
    QgsProcessing,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterNumber,
)
from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP

from ...toolkit.algorithms import groups
from ...toolkit.algorithms.base import SeamInspectorAlgorithm
from ...toolkit.algorithms.run import Run
from ...toolkit.translation import tr
from ..measure import messages

FIRST, SECOND, PIXEL_SIZE, OUTPUT, DIFFERENCES = "FIRST", "SECOND", "PIXEL_SIZE", "OUTPUT", "DIFFERENCES"
STATISTICS = ("COUNT", "MEAN", "STANDARD_DEVIATION", "MAXIMUM", "MINIMUM")


class CompareMarks(SeamInspectorAlgorithm):
    """The distances between two operators' or programs' marks."""

    ID = "comparemarks"
    NAME = QT_TRANSLATE_NOOP("@default", "Compare marks")
    GROUP = groups.PHOTOS
    HELP = QT_TRANSLATE_NOOP(
        "@default",
        "Compares two measurements of the same marks: count, mean, standard deviation, maximum and minimum of the "
        "distances, in pixels and micrometres, as tables 1 to 4 of Mikrut and Chwastek 2007 do. Two operators differed "
        "there by 0.25 px."
    )
    RASTER_LISTS = ()

    def initAlgorithm(self, configuration: Any = None) -> None:
        kinds, table = [QgsProcessing.SourceType.TypeVector], QgsProcessing.SourceType.TypeVector
        described = tr(
            "Marks with the field 'mark', and 'photo' (or 'layer', as merged layers have) where there are several "
            "photos. Places are the fields column and row, or the points themselves."
        )
        for name, title in ((FIRST, tr("First measurement")), (SECOND, tr("Second measurement"))):
            self.addDescribed(QgsProcessingParameterFeatureSource(name, title, kinds), described)
        self.addDescribed(
            QgsProcessingParameterNumber(
                PIXEL_SIZE, tr("Pixel size (um)"), QgsProcessingParameterNumber.Type.Double, optional=True,
                minValue=0.001,
            ),
            tr("Of the scan. Empty: taken from the fields x_mm and y_mm of the first layer that has them."),
        )
        self.addDescribed(
            QgsProcessingParameterFeatureSink(OUTPUT, tr("Statistics"), table),
            tr("Count, mean, standard deviation, maximum and minimum of the distances, a row for each unit."),
        )
        self.addDescribed(
            QgsProcessingParameterFeatureSink(
                DIFFERENCES, tr("Differences"), table, optional=True, createByDefault=False
            ),
            tr("The difference of each mark, the second measurement less the first, in pixels."),
        )
        for unit in ("PX", "UM"):
            self.addNumbers({f"{name}_{unit}": f"{name} {unit}".lower().replace("_", " ") for name in STATISTICS[1:]})
        self.addNumbers({STATISTICS[0]: tr("Marks in both layers")})

    def execute(self, run: Run) -> dict[str, Any]:
        from ...toolkit import layers, table_fields
        from .. import mark_tables
        from ..measure import mark_comparison

        measured = []
        for name in (FIRST, SECOND):
            source = run.source(name)
            names = source.fields().names()
            measured.append(mark_tables.compared_marks(layers.features(source), names, source.sourceName()))
        found = mark_comparison.mark_differences(*measured)
        size = run.real(PIXEL_SIZE) if run.parameters.get(PIXEL_SIZE) else None
        size = size or mark_comparison.pixel_size(measured[0]) or mark_comparison.pixel_size(measured[1])
        made = {"px": mark_comparison.distance_statistics(found)}
        if size is None:
            run.tell(messages.PIXEL_SIZE_UNKNOWN())
        else:
            made["um"] = made["px"].scaled(size)
        sink, destination = run.sink(OUTPUT, mark_tables.statistics_fields())
        run.write(sink, [mark_tables.statistics_feature(unit, one) for unit, one in made.items()])
        fields = mark_tables.difference_fields()
        rows, rows_id = run.optional_sink(DIFFERENCES, fields)
        run.write(rows, (
            table_fields.feature(fields, [one.photo or None, one.mark, one.column, one.row, one.distance])
            for one in found
        ))
        results: dict[str, Any] = {OUTPUT: destination, DIFFERENCES: rows_id, "COUNT": len(found)}
        for unit, one in made.items():
            known = zip(STATISTICS[1:], (one.mean, one.standard_deviation, one.maximum, one.minimum))
            results.update({f"{name}_{unit.upper()}": value for name, value in known if not math.isnan(value)})
            run.inform(
                tr("{count} marks: mean {mean:.3f}, maximum {maximum:.3f}, minimum {minimum:.3f} {unit}.").format(
                    count=one.count, mean=one.mean, maximum=one.maximum, minimum=one.minimum, unit=unit
                )
            )
        return results
