"""``seaminspector:minimumheight``: the lowest flying height for a ground resolved distance."""
from __future__ import annotations

from typing import Any

from qgis.core import (
    QgsProcessing,
    QgsProcessingContext,
    QgsProcessingFeedback,
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
from ...toolkit.algorithms.feedback import tell
from ...toolkit.attribute_values import text
from ...toolkit.translation import tr
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
                "One row per pass with the fields 'height' (metres above the target) and 'grd' (centimetres). Rows "
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
            tr("One row per group: count, mean and spread (metres), tolerance (%), and what to know about it."),
        )
        self.addDescribed(
            QgsProcessingParameterFeatureSink(
                HEIGHTS, tr("Heights by pass"), table, optional=True, createByDefault=False
            ),
            tr("The observations that were used, each with its minimum height 'h_min'."),
        )
        self.addNumbers({GROUP_COUNT: tr("Groups")})

    def check(self, parameters: dict[str, Any], context: QgsProcessingContext) -> None:
        from ..measure.minimum_height import check_heights

        check_heights(*self._limits(parameters, context))

    def execute(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        from ...toolkit import layers
        from .. import height_tables
        from ..measure.minimum_height import check_heights, minimum_heights

        required, reference = self._limits(parameters, context)
        check_heights(required, reference)
        source = self.source(parameters, OBSERVATIONS, context)
        names = source.fields().names()
        height_tables.check_fields(names)
        keys = height_tables.key_fields(names, self.parameterAsBool(parameters, BY_HEIGHT, context))
        observations = []
        for number, row in enumerate(layers.features(source), 1):
            if feedback.isCanceled():
                break
            observation, fault = height_tables.observation(row, keys)
            if fault is not None or observation is None:
                tell(feedback, messages.OBSERVATIONS_LEFT_OUT(row=number, why=fault))
            else:
                observations.append(observation)
        if not observations:
            raise SettingsError(messages.NO_OBSERVATIONS())
        results = minimum_heights(observations, required, reference)
        sink, destination = self.sink(parameters, OUTPUT, context, height_tables.height_fields(keys))
        self.write(sink, (height_tables.height_feature(result, keys) for result in results))
        passes, passes_id = self.optional_sink(parameters, HEIGHTS, context, height_tables.pass_fields(keys))
        self.write(passes, (height_tables.pass_feature(one, keys, required) for one in observations))
        for result in results:
            name = ", ".join(result.key) or tr("all passes")
            feedback.pushInfo(f"{name}: {result.mean_m:.1f} m")
            if result.notice is not None:
                tell(feedback, imagery_messages.ABOUT(what=name, why=result.notice).as_warning())
        return {OUTPUT: destination, HEIGHTS: passes_id, GROUP_COUNT: len(results)}

    def _limits(self, parameters: dict[str, Any], context: QgsProcessingContext) -> tuple[float, float | None]:
        """The required distance in cm, and the reference height in m where one is given."""
        given = parameters.get(REFERENCE_HEIGHT)
        reference = self.parameterAsDouble(parameters, REFERENCE_HEIGHT, context) if text(given) else None
        return self.parameterAsDouble(parameters, REQUIRED_GRD, context), reference
