"""``seaminspector:minimumheight``: the lowest flying height for a ground resolved distance."""
from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from qgis.core import QgsFeature, QgsFields
from qgis.PyQt.QtCore import QT_TR_NOOP

from ..imagery import messages as imagery_messages
from ..imagery.errors import Message, SettingsError
from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.base import GROUND_RESOLUTION, SeamInspectorAlgorithm
from ..toolkit.algorithms.run import Run
from ..toolkit.table_fields import feature, number, table_fields, text
from ..toolkit.translation import sentence, shown_number, tr
from .measure import messages

if TYPE_CHECKING:
    from .measure.minimum_height import HeightResult, Observation

HEIGHT, GRD = "height", "grd"
_KEYS = ("sensor", "image_type", "direction")  # fields whose values make groups, as far as the table has them
MEASURED = ("grd_error",)  # fields of measured groups that begin as those of observers do


def reading_fields(names: Sequence[str]) -> list[str]:
    """The fields with the distances that observers read: ``grd``, ``grd_2`` and so on, or names after ``grd_``.

    Raises SettingsError where there is none, or no height.
    """
    fields = [name for name in names if name == GRD or (name.startswith(f"{GRD}_") and name not in MEASURED)]
    for name in (HEIGHT, GRD):
        if name not in names and (name == HEIGHT or not fields):
            raise SettingsError(messages.FIELD_MISSING(field=name))
    return fields


def observation(row: QgsFeature, keys: Sequence[str], readings: Sequence[str]) -> Observation | Message:
    """A row as an observation, or why it is none. ``readings``: the fields of its observers, of whom some may lack."""
    from .measure.minimum_height import Observation

    words = [row[name] for name in readings if text(row[name])]
    height, grds = number(row[HEIGHT]), tuple(grd for grd in map(number, words) if grd is not None)
    if height is None or not grds or len(grds) < len(words):
        return messages.OBSERVATION_NO_NUMBER()
    made = Observation(height, grds, tuple(text(row[name]) for name in keys))
    return made.fault or made


def height_table(results: Sequence[HeightResult], keys: Sequence[str]) -> tuple[QgsFields, list[QgsFeature]]:
    kinds = {
        "count": "integer", "mean": "real", "spread": "real", "observers": "integer", "observer_spread": "real",
        "reference": "real", "tolerance": "real", "notice": "text",
    }  # fmt: skip
    fields = table_fields(*((name, "text") for name in keys), *kinds.items())
    return fields, [
        feature(fields, [
            *result.key, len(result.heights_m), result.mean_m, result.spread_m, result.observers,
            result.observer_spread_m, result.reference_m, result.tolerance_percent,
            None if result.notice is None else sentence(result.notice),
        ])
        for result in results
    ]  # fmt: skip


def pass_table(
    observations: Sequence[Observation], keys: Sequence[str], required_cm: float
) -> tuple[QgsFields, list[QgsFeature]]:
    """HEIGHTS: one row per observation, with the distance that its height goes with: of several, a harmonic mean."""
    others = [(name, "text") for name in keys if name != HEIGHT]
    fields = table_fields(*others, (HEIGHT, "real"), (GRD, "real"), ("h_min", "real"), ("observers", "integer"))
    rows = []
    for passage in observations:
        words = [word for name, word in zip(keys, passage.key) if name != HEIGHT]
        height = passage.minimum_height(required_cm)
        grd = passage.height_m * required_cm / height
        rows.append(feature(fields, [*words, passage.height_m, grd, height, len(passage.grds_cm)]))
    return fields, rows


_REQUIRED_GRD_CM = 30.0, 1e-3, 1e6  # Open Skies: optical cameras; from a microscope to a satellite

OBSERVATIONS, REQUIRED_GRD, REFERENCE_HEIGHT = "OBSERVATIONS", "REQUIRED_GRD", "REFERENCE_HEIGHT"
BY_HEIGHT, OUTPUT, HEIGHTS, GROUP_COUNT = "BY_HEIGHT", "OUTPUT", "HEIGHTS", "GROUP_COUNT"


class MinimumHeight(SeamInspectorAlgorithm):
    """Heights at which each pass over a target would just have kept to the required distance, and their mean."""

    ID = "minimumheight"
    NAME = QT_TR_NOOP("Minimum flying height")
    GROUP = GROUND_RESOLUTION
    HELP = QT_TR_NOOP(
        "Computes from passes over a bar target how low a sensor may fly without resolving more than agreed: for each "
        "pass its height times the required distance over the one that was read, then the mean of each group of "
        "passes, its spread, and how far it lies from a reference (Walczykowski and others 2009, equations 1 and 2)."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.addDescribed(common.features(OBSERVATIONS, tr("Observations"), common.TABLE), tr(
            "One row per pass with the fields 'height' (metres above the target) and 'grd' (centimetres), several "
            "observers' in 'grd', 'grd_2', 'grd_3' and so on: their heights are averaged within the pass. Rows that "
            "agree in 'sensor', 'image_type' and 'direction', as far as there are such fields, make a group."
        ))
        self.addDescribed(common.real(REQUIRED_GRD, tr("Required distance (cm)"), *_REQUIRED_GRD_CM), tr(
            "The ground resolved distance that must not be undercut: 30 cm for optical cameras of Open Skies."
        ))
        self.addDescribed(common.words(REFERENCE_HEIGHT, tr("Reference height (metres)")), tr(
            "The minimum height that the results are compared with, or one for each sensor, type of image or "
            "direction: 'DMC 2714; RC20 2015'."
        ))
        self.addDescribed(common.flag(BY_HEIGHT, tr("Keep flying heights apart")), tr(
            "Rows of different 'height' make groups of their own, as in tables 4A and 4B of the paper."
        ), advanced=True)
        self.addDescribed(common.result(OUTPUT, tr("Minimum heights"), common.TABLE), tr(
            "One row per group: count, mean and spreads (metres), tolerance (%), and what to know about it."
        ))
        self.addDescribed(
            common.result(HEIGHTS, tr("Heights by pass"), common.TABLE, optional=True, by_default=False),
            tr("The observations that were used, each with its minimum height 'h_min'."),
        )
        self.addNumbers({GROUP_COUNT: tr("Groups")})

    def check(self, run: Run) -> None:
        from .measure.minimum_height import read_references

        read_references(run.text(REFERENCE_HEIGHT))

    def execute(self, run: Run) -> dict[str, Any]:
        from ..toolkit import layers
        from .measure.minimum_height import doubts, minimum_heights, read_references

        required, references = run.real(REQUIRED_GRD), read_references(run.text(REFERENCE_HEIGHT))
        source = run.source(OBSERVATIONS)
        names = source.fields().names()
        readings = reading_fields(names)
        keys = (*(name for name in _KEYS if name in names), *((HEIGHT,) if run.flag(BY_HEIGHT) else ()))
        observations = []
        for place, row in enumerate(layers.features(source), 1):
            if run.is_cancelled():
                break
            made = observation(row, keys, readings)
            if isinstance(made, Message):
                run.tell(messages.OBSERVATIONS_LEFT_OUT(row=place, why=made))
            else:
                observations.append(made)
        if not observations:
            raise SettingsError(messages.NO_OBSERVATIONS())
        run.tell(*doubts(observations))
        results = minimum_heights(observations, required, references)
        fields, rows = height_table(results, keys)
        sink, destination = run.sink(OUTPUT, fields)
        run.write(sink, rows)
        fields, rows = pass_table(observations, keys, required)
        passes, passes_id = run.optional_sink(HEIGHTS, fields)
        run.write(passes, rows)
        for result in results:
            name = ", ".join(result.key) or tr("all passes")
            run.feedback.pushInfo(f"{name}: {shown_number(result.mean_m, 1)} m")
            if result.notice is not None:
                run.tell(imagery_messages.ABOUT(what=name, why=result.notice).as_warning())
        return {OUTPUT: destination, HEIGHTS: passes_id, GROUP_COUNT: len(results)}
