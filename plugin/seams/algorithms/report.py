"""``seaminspector:report``: an inspection as one HTML page."""
from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsFeature,
    QgsProcessing,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterString,
)
from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP

from ...imagery.errors import SettingsError
from ...toolkit import messages as toolkit_messages
from ...toolkit.algorithms import parameters as common
from ...toolkit.algorithms.base import SeamInspectorAlgorithm
from ...toolkit.algorithms.feedback import TellOnce, tell
from ...toolkit.translation import tr
from ..measure import messages
from .block_parameters import given_block, given_sources

if TYPE_CHECKING:
    from ..report.inspection_report import ReportRequest

WINDOWS, CURVES, PAIRS, TITLE, OUTPUT = "WINDOWS", "CURVES", "PAIRS", "TITLE", "OUTPUT"


class Report(SeamInspectorAlgorithm):
    """What an inspection found, on paper."""

    ID = "report"
    NAME = QT_TRANSLATE_NOOP("@default", "Report of an inspection")
    DRAWN = PAGES = (OUTPUT,)
    HELP = QT_TRANSLATE_NOOP(
        "@default",
        "Writes one HTML page that opens anywhere without network and prints well on A4: a summary by mosaic, a map "
        "sketch of the windows by verdict, their relative variances as in table 1 of Pyka 2010, and for each flagged "
        "window (a significant loss, or one that the observer saw) its curves, its clips at 2x, cause and observer."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        table = QgsProcessing.SourceType.TypeVector
        self.addDescribed(
            QgsProcessingParameterFeatureSource(WINDOWS, tr("Inspected windows"), [table]),
            tr("The windows as 'Inspect windows' leaves them, judged by an observer or not."),
        )
        self.addDescribed(
            QgsProcessingParameterFeatureSource(CURVES, tr("Curves"), [table], optional=True),
            tr("The table of curves of the same windows; without it there are no relative variances and no charts."),
        )
        self.addDescribed(
            QgsProcessingParameterFeatureSource(PAIRS, tr("Pairs"), [table], optional=True),
            tr("The table of pairs of the same windows: it tells absolute contrast, and which sources are shown."),
        )
        self.addDescribed(
            common.mosaic(optional=True)[0],
            tr("The inspected mosaic; with it the report shows the clips and an overview below the map sketch."),
        )
        self.addDescribed(
            common.sources()[0], tr("The orthoimages that the mosaic was made from; their clips stand beside its own.")
        )
        self.addDescribed(*common.source_index())
        self.addDescribed(
            QgsProcessingParameterString(TITLE, tr("Title"), optional=True),
            tr("Heading of the page. Empty: the mosaics' names."),
        )
        self.addDescribed(
            *common.max_ratio(tr("The limit drawn into the charts: that which the windows were inspected with.")),
            advanced=True,
        )
        self.addDescribed(
            QgsProcessingParameterFileDestination(OUTPUT, tr("Report"), tr("HTML files (*.html)")),
            tr("The page, one file."),
        )

    def check(self, parameters: dict[str, Any], context: QgsProcessingContext) -> None:
        if parameters.get(common.MOSAIC):
            self.describe_mosaic(parameters, context)

    def prepare(self, parameters: dict[str, Any], context: QgsProcessingContext) -> None:
        self._mosaic = self.describe_mosaic(parameters, context) if parameters.get(common.MOSAIC) else None
        self._given = given_sources(self, parameters, context)

    def execute(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        from ..report.inspection_report import write_report

        path = self.file_path(parameters, OUTPUT, context)
        if path is None:
            raise SettingsError(messages.NO_REPORT_FILE())
        request = self._request(parameters, context, feedback)
        notices = write_report(
            path, request, lambda share: feedback.setProgress(100 * share), feedback.isCanceled
        )
        tell(feedback, *notices or ())
        return {} if notices is None else {OUTPUT: str(path)}

    def _request(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> ReportRequest:
        from ...toolkit import layers
        from ..measure.inspection import Block
        from ..report.inspection_report import ReportRequest
        from ..tables import record_tables

        windows = self.source(parameters, WINDOWS, context)
        if windows.featureCount() == 0:
            raise SettingsError(toolkit_messages.NO_WINDOWS())
        block, crs, transform = None, windows.sourceCrs(), None
        if self._mosaic is not None:
            block = Block(self._mosaic, ())
            if self._given.refs or parameters.get(common.SOURCE_INDEX):
                block = given_block(self, parameters, context, self._mosaic, self._given, TellOnce(feedback))
            crs = layers.mosaic_crs(self._mosaic)
            transform = common.transform(windows, crs, context)
        names = windows.fields().names()
        record_tables.check_inspected(names)
        found = record_tables.read_windows(layers.features(windows), names, transform)
        curves = self._rows(parameters, CURVES, context)
        pairs = self._rows(parameters, PAIRS, context)
        return ReportRequest(
            tuple(found),
            curves=record_tables.read_curves(*curves) if curves else {},
            pairs=record_tables.read_pairs(*pairs) if pairs else {},
            block=block,
            wkt=layers.system_wkt(crs),
            title=self.parameterAsString(parameters, TITLE, context).strip(),
            name=windows.sourceName(),
            max_ratio=self.parameterAsDouble(parameters, common.MAX_RATIO, context),
        )

    def _rows(
        self, parameters: dict[str, Any], name: str, context: QgsProcessingContext
    ) -> tuple[Iterator[QgsFeature], list[str]] | None:
        """The rows of an optional table and its fields."""
        from ...toolkit import layers

        if not parameters.get(name):
            return None
        table = self.source(parameters, name, context)
        return layers.features(table), table.fields().names()
