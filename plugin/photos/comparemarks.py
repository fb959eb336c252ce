"""``seaminspector:comparemarks``: two measurements of the same marks against each other."""
from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.PyQt.QtCore import QT_TR_NOOP

from ..imagery.errors import PhotoError
from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.base import INTERIOR_ORIENTATION, SeamInspectorAlgorithm
from ..toolkit.algorithms.run import Run
from ..toolkit.translation import filled, tr
from .measure import messages

if TYPE_CHECKING:
    from .measure.mark_comparison import ComparedMark, DifferenceStatistics, MarkDifference

DEFAULT_MEAN_DISTANCE_PX = 0.25  # of two operators in Mikrut and Chwastek 2007, tables 1 and 2, and so their demand
FIRST, SECOND, PIXEL_SIZE, LIMIT = "FIRST", "SECOND", "PIXEL_SIZE", "LIMIT"
FOLDERS = {FIRST: "FIRST_FOLDER", SECOND: "SECOND_FOLDER"}
OUTPUT, PHOTOS, DIFFERENCES, WITHIN_LIMIT = "OUTPUT", "PHOTOS", "DIFFERENCES", "WITHIN_LIMIT"
STATISTICS = ("COUNT", "MEAN", "STANDARD_DEVIATION", "MAXIMUM", "MINIMUM")
WITHIN, BEYOND = "within", "beyond"  # verdicts on a mean distance
TABLES = {
    OUTPUT: (  # one row for each unit
        ("unit", "text"), ("count", "integer"), ("mean", "real"), ("standard_deviation", "real"), ("maximum", "real"),
        ("minimum", "real"), ("limit", "real"), ("verdict", "text"),
    ),
    PHOTOS: (("photo", "text"), ("count", "integer"), ("mean", "real"), ("maximum", "real"), ("verdict", "text")),
    DIFFERENCES: (  # one row for each mark in both layers
        ("photo", "text"), ("mark", "text"), ("difference_column", "real"), ("difference_row", "real"),
        ("distance", "real"),
    ),
}  # fmt: skip


class CompareMarks(SeamInspectorAlgorithm):
    """The distances between two operators' or programs' marks."""

    ID = "comparemarks"
    NAME = QT_TR_NOOP("Compare marks")
    GROUP = INTERIOR_ORIENTATION
    HELP = QT_TR_NOOP(
        "Compares two measurements of the same marks: count, mean, standard deviation, maximum and minimum of the "
        "distances, in pixels and micrometres, as tables 1 to 4 of Mikrut and Chwastek 2007 do, and whether the mean "
        "is within a limit. Two operators differed there by 0.25 px, so a program has to stay within that. Many photos "
        "are compared in one run: give folders, or merged layers with a field 'photo'."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        described = tr(
            "Marks with the field 'mark', and 'photo' (or 'layer', as merged layers have) where there are several "
            "photos. Places are the fields column and row, or the points themselves."
        )
        of_folder = tr(
            "Instead of the layer: all files of this folder, layers with the field 'mark' (of the photo named in their "
            "field 'photo', else in the file's name) and MicMac's MeasuresIm-*.xml."
        )
        for name, title, of_files in (
            (FIRST, tr("First measurement"), tr("First measurement, a folder")),
            (SECOND, tr("Second measurement"), tr("Second measurement, a folder")),
        ):
            self.addDescribed(common.features(name, title, common.TABLE, optional=True), described)
            self.addDescribed(common.folder(FOLDERS[name], of_files, optional=True), of_folder)
        limit = common.real(LIMIT, tr("Largest mean distance (px)"), DEFAULT_MEAN_DISTANCE_PX, 0, decimals=None)
        self.addDescribed(limit, tr(
            "The verdict is 'within' where the mean distance is at most this; in the paper 0.25 px."
        ))
        self.addDescribed(common.real(PIXEL_SIZE, tr("Pixel size (µm)"), None, 0.001, optional=True, decimals=None), tr(
            "Pixel size of the scan. Empty: taken from the fields x_mm and y_mm of the first layer that has them."
        ))
        self.addDescribed(common.result(OUTPUT, tr("Statistics"), common.TABLE), tr(
            "Count, mean, standard deviation, maximum and minimum of the distances, the limit and the verdict, a row "
            "for each unit."
        ))
        self.addDescribed(common.result(PHOTOS, tr("Photos"), common.TABLE, optional=True, by_default=False), tr(
            "Count, mean, maximum (px) and verdict of each photo."
        ))
        self.addDescribed(common.result(DIFFERENCES, tr("Differences"), common.TABLE, True, False), tr(
            "The difference of each mark, the second measurement minus the first, in pixels."
        ))
        for unit in ("PX", "UM"):
            self.addNumbers({f"{name}_{unit}": f"{name} {unit}".lower().replace("_", " ") for name in STATISTICS[1:]})
        self.addNumbers({
            STATISTICS[0]: tr("Marks in both measurements"),
            WITHIN_LIMIT: tr("1 where the mean distance is within the limit, else 0"),
        })

    def check(self, run: Run) -> None:
        for name in (FIRST, SECOND):
            if bool(run.parameters.get(name)) == bool(run.text(FOLDERS[name])):
                raise PhotoError(messages.COMPARED_EITHER())

    def execute(self, run: Run) -> dict[str, Any]:
        from ..toolkit import table_fields
        from .measure import mark_comparison

        self.check(run)
        measured = [self._marks(run, name) for name in (FIRST, SECOND)]
        differences, alone = mark_comparison.mark_differences(*measured)
        limit = run.real(LIMIT)
        size = run.real(PIXEL_SIZE) if run.parameters.get(PIXEL_SIZE) else None
        size = size or mark_comparison.pixel_size(measured[0]) or mark_comparison.pixel_size(measured[1])
        statistics, limits_of_units = {"px": mark_comparison.distance_statistics(differences)}, {"px": limit}
        if size is None:
            run.tell(messages.PIXEL_SIZE_UNKNOWN())
        else:
            statistics["um"] = mark_comparison.distance_statistics(differences, size)
            limits_of_units["um"] = limit * size
        if alone:
            run.tell(messages.COMPARED_ALONE(count=len(alone), names=mark_comparison.some_names(alone)))
        by_photo: dict[str, list[MarkDifference]] = {}
        for difference in differences:
            by_photo.setdefault(difference.photo, []).append(difference)
        rows: dict[str, list[list[object]]] = {
            OUTPUT: [
                [unit, made.count, *made.lengths, limits_of_units[unit], _verdict(made, limits_of_units[unit])]
                for unit, made in statistics.items()
            ],
            PHOTOS: [
                [photo or None, made.count, made.mean, made.maximum, _verdict(made, limit)]
                for photo, of_photo in by_photo.items() for made in [mark_comparison.distance_statistics(of_photo)]
            ],
            DIFFERENCES: [
                [mark.photo or None, mark.mark, mark.column, mark.row, mark.distance] for mark in differences
            ],
        }  # fmt: skip
        results: dict[str, Any] = {}
        for name, columns in TABLES.items():
            fields = table_fields.table_fields(*columns)
            sink, results[name] = (run.sink if name == OUTPUT else run.optional_sink)(name, fields)
            run.write(sink, (table_fields.feature(fields, row) for row in rows[name]))
        within = _verdict(statistics["px"], limit) == WITHIN
        results.update({"COUNT": len(differences), WITHIN_LIMIT: int(within)})
        words = tr("{count} marks: mean {mean:.3f}, maximum {maximum:.3f}, minimum {minimum:.3f} {unit}.")
        for unit, made in statistics.items():
            known = zip(STATISTICS[1:], made.lengths)
            results.update({f"{name}_{unit.upper()}": value for name, value in known if not math.isnan(value)})
            lengths = {"mean": made.mean, "maximum": made.maximum, "minimum": made.minimum}
            run.feedback.pushInfo(filled(words, count=made.count, unit=unit, **lengths))
        words = tr("The mean distance is within the limit of {limit:g} px.") if within else tr(
            "The mean distance is beyond the limit of {limit:g} px."
        )
        run.feedback.pushInfo(filled(words, limit=limit))
        return results

    @staticmethod
    def _marks(run: Run, name: str) -> list[ComparedMark]:
        from ..toolkit import layers
        from . import mark_tables

        folder = run.text(FOLDERS[name])
        if folder:
            return mark_tables.folder_marks(Path(folder))
        source = run.source(name)
        return mark_tables.compared_marks(layers.features(source), source.fields().names(), source.sourceName())


def _verdict(made: DifferenceStatistics, limit: float) -> str:
    """Verdict on the mean distance, against a limit in the same unit."""
    return WITHIN if made.mean <= limit else BEYOND
