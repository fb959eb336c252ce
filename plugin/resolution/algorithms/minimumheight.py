"""``seaminspector:minimumheight``: the lowest flying height for a ground resolved distance."""
from __future__ import annotations

from typing import Any

from qgis.core import (
    QgsProcessing,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFeatureSource,
)
from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP

from ...imagery import messages as imagery_messages
from ...imagery.errors import SettingsError
from ...toolkit.algorithms import groups
from ...toolkit.algorithms import parameters as common
from ...toolkit.algorithms.base import SeamInspectorAlgorithm
from ...toolkit.algorithms.run import Run
from ...toolkit.attribute_values import text
from ...toolkit.translation import shown_number, tr
from ..measure import messages

DEFAULT_REQUIRED_GRD_CM = 30.0  # Open Skies: optical cameras

OBSERVATIONS, REQUIRED_GRD, REFERENCE_HEIGHT = "OBSERVATIONS", "REQUIRED_GRD", "REFERENCE_HEIGHT"
BY_HEIGHT, OUTPUT, HEIGHTS, GROUP_COUNT = "BY_HEIGHT", "OUTPUT", "HEIGHTS", "GROUP_COUNT"


class MinimumHeight(SeamInspectorAlgorithm):
    """Heights at which each pass over a target would just have kept to the required distance, and their mean."""

    ID = "minimumheight"
    NAME = QT_TRANSLATE_NOOP("@default", "Minimum flying height")
    GROUP = groups.GROUND_RESOLUTION
    HELP = QT_TRANSLATE_NOOP(
        "@default",
        "Computes from passes over a bar target how low a sensor may fly without resolving more than agreed: for each "
        "pass its height times the required distance over the one that was read, then the mean of each group of "
        "passes, its spread, and how far it lies from a reference (Walczykowski and others 2009, equations 1 and 2)."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        table = QgsProcessing.SourceType.TypeVector
        self.addDescribed(
            QgsProcessingParameterFeatureSource(OBSERVATIONS, tr("Observations"), [table]),
            tr(
                "One row per pass with the fields 'height' (metres above the target) and 'grd' (centimetres), several "
                "observers' in 'grd', 'grd_2', 'grd_3' and so on: their heights are averaged within the pass. Rows "
                "that agree in 'sensor', 'image_type' and 'direction', as far as there are such fields, make a group."
            ),
        )
        self.addDescribed(
            common.real(REQUIRED_GRD, tr("Required distance (cm)"), DEFAULT_REQUIRED_GRD_CM),
            tr("The ground resolved distance that must not be undercut: 30 cm for optical cameras of Open Skies."),
        )
        self.addDescribed(
            common.real(REFERENCE_HEIGHT, tr("Reference height (metres)"), None, optional=True),
            tr("The minimum height that the results are compared with, if there is one."),
        )
        self.addDescribed(
            QgsProcessingParameterBoolean(BY_HEIGHT, tr("Keep flying heights apart"), False),
            tr("Rows of different 'height' make groups of their own, as in tables 4A and 4B of the paper."),
            advanced=True,
        )
        self.addDescribed(
            QgsProcessingParameterFeatureSink(OUTPUT, tr("Minimum heights"), table),
            tr("One row per group: count, mean and spreads (metres), tolerance (%), and what to know about it."),
        )
        self.addDescribed(
            QgsProcessingParameterFeatureSink(
                HEIGHTS, tr("Heights by pass"), table, optional=True, createByDefault=False
            ),
            tr("The observations that were used, each with its minimum height 'h_min'."),
        )
        self.addNumbers({GROUP_COUNT: tr("Groups")})

    def check(self, run: Run) -> None:
        from ..measure.minimum_height import check_heights

        check_heights(*self._limits(run))

    def execute(self, run: Run) -> dict[str, Any]:
        from ...toolkit import layers
        from .. import height_tables
        from ..measure.minimum_height import check_heights, doubts, minimum_heights

        required, reference = self._limits(run)
        check_heights(required, reference)
        source = run.source(OBSERVATIONS)
        names = source.fields().names()
        readings = height_tables.reading_fields(names)
        keys = height_tables.key_fields(names, run.flag(BY_HEIGHT))
        observations = []
        for number, row in enumerate(layers.features(source), 1):
            if run.is_cancelled():
                break
            observation, fault = height_tables.observation(row, keys, readings)
            if fault is not None or observation is None:
                run.tell(messages.OBSERVATIONS_LEFT_OUT(row=number, why=fault))
            else:
                observations.append(observation)
        if not observations:
            raise SettingsError(messages.NO_OBSERVATIONS())
        run.tell(*doubts(observations))
        results = minimum_heights(observations, required, reference)
        sink, destination = run.sink(OUTPUT, height_tables.height_fields(keys))
        run.write(sink, (height_tables.height_feature(result, keys) for result in results))
        passes, passes_id = run.optional_sink(HEIGHTS, height_tables.pass_fields(keys))
        run.write(passes, (height_tables.pass_feature(one, keys, required) for one in observations))
        for result in results:
            name = ", ".join(result.key) or tr("all passes")
            run.inform(f"{name}: {shown_number(result.mean_m, 1)} m")
            if result.notice is not None:
                run.tell(imagery_messages.ABOUT(what=name, why=result.notice).as_warning())
        return {OUTPUT: destination, HEIGHTS: passes_id, GROUP_COUNT: len(results)}

    def _limits(self, run: Run) -> tuple[float, float | None]:
        """The required distance in cm, and the reference height in m where one is given."""
        given = run.parameters.get(REFERENCE_HEIGHT)
        reference = run.real(REFERENCE_HEIGHT) if text(given) else None
        return run.real(REQUIRED_GRD), reference
