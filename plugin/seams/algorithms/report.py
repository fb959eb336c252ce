"""``seaminspector:report``: an inspection as one HTML page."""
from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar

from qgis.PyQt.QtCore import QT_TR_NOOP

from ...imagery.errors import SettingsError
from ...toolkit import messages as toolkit_messages
from ...toolkit.algorithms import parameters as common
from ...toolkit.algorithms.base import SeamInspectorAlgorithm
from ...toolkit.algorithms.run import Run
from ...toolkit.translation import tr
from ..measure import messages
from ..measure.limits import MAX_SIGNIFICANT_KEPT
from .block_parameters import given_block, given_sources

if TYPE_CHECKING:
    from ..report.report_request import ReportRequest

Row = TypeVar("Row")

WINDOWS, CURVES, PAIRS, PROFILES, TITLE, OUTPUT = "WINDOWS", "CURVES", "PAIRS", "PROFILES", "TITLE", "OUTPUT"
MIN_KEPT = "MIN_KEPT"


class Report(SeamInspectorAlgorithm):
    """What an inspection found, on paper."""

    ID = "report"
    NAME = QT_TR_NOOP("Report of an inspection")
    DRAWN, PAGES = (), (OUTPUT,)
    HELP = QT_TR_NOOP(
        "Writes one HTML page that opens anywhere without network and prints well on A4: a summary by mosaic, a map "
        "sketch of the windows by verdict, their relative variances as in table 1 of Pyka 2010, and for each flagged "
        "window (a significant loss, or one that the observer saw) what it keeps by distance from the seam, where it "
        "lost detail, its curves, its clips at 2x, cause and observer."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.addDescribed(common.features(WINDOWS, tr("Inspected windows"), common.TABLE), tr(
            "The windows that 'Inspect windows' wrote, judged by an observer or not."
        ))
        self.addDescribed(common.features(CURVES, tr("Curves"), common.TABLE, optional=True), tr(
            "The table of curves of the same windows; without it there are no relative variances and no charts."
        ))
        self.addDescribed(common.features(PAIRS, tr("Pairs"), common.TABLE, optional=True), tr(
            "The table of pairs of the same windows: it gives absolute contrast, and which sources are shown."
        ))
        self.addDescribed(common.features(PROFILES, tr("Seam profiles"), common.TABLE, optional=True), tr(
            "The table of seam profiles of the same windows: how much detail is kept by distance from the seam."
        ))
        self.addDescribed(common.mosaic(optional=True)[0], tr(
            "The inspected mosaic; with it the report shows the clips and an overview below the map sketch."
        ))
        self.addDescribed(common.sources()[0], tr(
            "The orthoimages that the mosaic was made from; their clips stand beside its own."
        ))
        self.addDescribed(*common.source_index())
        self.addDescribed(common.words(TITLE, tr("Title")), tr("Heading of the page. Empty: the mosaics' names."))
        self.addDescribed(
            common.real(MIN_KEPT, tr("Least share kept along the seam"), MAX_SIGNIFICANT_KEPT, 0.0, optional=True),
            tr("The limit drawn in the seam profiles: the one the windows were inspected with."),
            advanced=True,
        )
        self.addDescribed(*common.max_ratio(tr(
            "The limit drawn in the charts: the one the windows were inspected with."
        )), advanced=True)
        self.addDescribed(common.made_file(OUTPUT, tr("Report"), tr("HTML files (*.html)")), tr("The page, one file."))

    def check(self, run: Run) -> None:
        if run.parameters.get(common.MOSAIC):
            run.mosaic()

    def prepare_run(self, run: Run) -> None:
        self._mosaic = run.mosaic() if run.parameters.get(common.MOSAIC) else None
        self._given = given_sources(run)

    def execute(self, run: Run) -> dict[str, Any]:
        from ..report.inspection_report import write_report

        path = run.file_path(OUTPUT)
        if path is None:
            raise SettingsError(messages.NO_REPORT_FILE())
        notices = write_report(path, self._request(run), run.progress, run.is_cancelled)
        run.tell(*notices or ())
        return {} if notices is None else {OUTPUT: str(path)}

    def _request(self, run: Run) -> ReportRequest:
        from ...toolkit import layers
        from ..measure.window.inspection import Block
        from ..report.report_request import ReportRequest
        from ..tables import record_tables

        windows = run.source(WINDOWS)
        if windows.featureCount() == 0:
            raise SettingsError(toolkit_messages.NO_WINDOWS())
        block, crs, transform = None, windows.sourceCrs(), None
        if self._mosaic is not None:
            block = Block(self._mosaic, ())
            if self._given.refs or run.parameters.get(common.SOURCE_INDEX):
                block = given_block(run, self._mosaic, self._given)
            crs = layers.mosaic_crs(self._mosaic)
            transform = run.transform(windows, crs)
        names = windows.fields().names()
        record_tables.check_inspected(names)
        records = record_tables.read_windows(layers.features(windows), names, transform)
        run.tell(*record_tables.doubts(records))
        return ReportRequest(
            tuple(records),
            curves=self._table(run, CURVES, record_tables.read_curves),
            pairs=self._table(run, PAIRS, record_tables.read_pairs),
            profiles=self._table(run, PROFILES, record_tables.read_profiles),
            block=block,
            wkt=layers.system_wkt(crs),
            title=run.text(TITLE).strip(),
            name=windows.sourceName(),
            max_ratio=run.real(common.MAX_RATIO),
            min_kept=run.real(MIN_KEPT),
        )

    def _table(self, run: Run, name: str, read: Callable[..., dict[int, list[Row]]]) -> dict[int, list[Row]]:
        """What an optional table says of each window."""
        from ...toolkit import layers

        if not run.parameters.get(name):
            return {}
        table = run.source(name)
        return read(layers.features(table), table.fields().names())
