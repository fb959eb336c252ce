"""``seaminspector:inspectwindows``: the main job."""
from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from qgis.core import QgsWkbTypes
from qgis.PyQt.QtCore import QT_TR_NOOP

from ...imagery.errors import SettingsError
from ...imagery.statistics import JUDGING_FIELDS
from ...toolkit import messages as toolkit_messages
from ...toolkit.algorithms import parameters as common
from ...toolkit.algorithms.raster_lists import WindowFeatures
from ...toolkit.algorithms.run import Run
from ...toolkit.translation import tr
from ..measure import messages
from ..measure.limits import MAX_SIGNIFICANT_KEPT
from ..measure.window_records import REFERENCES
from .block_parameters import BlockAlgorithm, check_sources, given_block

if TYPE_CHECKING:
    from ..measure.seam_cells import Cell
    from ..measure.window.inspection import Block
    from ..measure.window.measured_window import InspectionSettings, WindowRequest

WINDOWS, CELLS, REFERENCE, DIRECTIONS = "WINDOWS", "CELLS", "REFERENCE", "DIRECTIONS"
MIN_KEPT = "MIN_KEPT"
OUTPUT, CURVES, PAIRS, PROFILES = "OUTPUT", "CURVES", "PAIRS", "PROFILES"
WINDOW_COUNT, SIGNIFICANT_COUNT, NOT_COMPARABLE_COUNT = "WINDOW_COUNT", "SIGNIFICANT_COUNT", "NOT_COMPARABLE_COUNT"


class InspectWindows(BlockAlgorithm):
    """How much detail a mosaic kept in each window, against each of its sources."""

    ID = "inspectwindows"
    NAME = QT_TR_NOOP("Inspect windows")
    HELP = QT_TR_NOOP(
        "Measures how much local contrast a mosaic kept in each window. The mosaic and every source that meets the "
        "window are clipped and decomposed by wavelets, and the share of the sources' finest detail that the mosaic "
        "has beside a seam is compared with the share farther off: whatever was done to the whole mosaic cancels out. "
        "A loss is significant where by the best estimate 70 % or less is kept along the seam and some loss is "
        "certain, reduced where the 95 % interval lies below 100 %. The paper's own rule (Pyka 2010), by shares of "
        "variance in whole clips, is applied too: half of the detail or less against every source is a significant "
        "loss."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.addDescribed(common.features(WINDOWS, tr("Windows"), common.POLYGON), tr(
            "Rectangles on the mosaic in any reference system, drawn or placed along the seamlines. The rectangle "
            "around each is measured, snapped to the mosaic's pixels."
        ))
        self.add_block()
        self.addDescribed(*common.wavelet())
        self.addDescribed(*common.levels())
        # Optional, or QGIS would refuse models that were drawn before there was this choice.
        self.addDescribed(common.choice(REFERENCE, tr("Verdict against"), REFERENCES, optional=True), tr(
            "seam: what is kept along the seam, against the hard-cut composite of the sources and the ground around. "
            "composite: the whole window against that composite. sources: the whole clip of each source, as in the "
            "paper; that verdict is always in the field 'paper_verdict', too."
        ))
        self.addDescribed(common.features(CELLS, tr("Seam cells"), common.POLYGON, optional=True), tr(
            "Polygons that say in the field 'source' which orthoimage each part of the mosaic was cut from. Where they "
            "are given they determine the composite; elsewhere it is found from the detail itself."
        ), advanced=True)
        self.addDescribed(
            # Optional for the same reason.
            common.real(MIN_KEPT, tr("Least share kept along the seam"), MAX_SIGNIFICANT_KEPT, 0.0, optional=True),
            tr(
                "A window is significant when by the best estimate this share of the finest detail, or less, is kept "
                "along its seam, and some loss is certain. 0.5 is what a 50:50 blend leaves of two images that have "
                "nothing in common."
            ),
            advanced=True,
        )
        self.addDescribed(*common.max_ratio(tr(
            "By the paper's rule a window is significant when its ratio at level 1 is this or less."
        )), advanced=True)
        self.addDescribed(common.flag(DIRECTIONS, tr("Detail by direction"), optional=True), tr(
            "Adds to the curves of the mosaic and the sources the three directional components of each level: LH, in "
            "which horizontal lines show up, HL, vertical ones, and HH, diagonal ones. Their sum is the level's "
            "detail. Takes several times as long as the curves alone."
        ), advanced=True)
        self.addDescribed(*common.scheduler(), advanced=True)
        self.addDescribed(common.result(OUTPUT, tr("Inspected windows"), common.POLYGON), tr(
            "The rectangles as measured, with their verdict, what is kept along the seam, how far an eye sees the loss "
            "at 2x ('visibility', 1 is just seen), and ratios: the largest over the sources."
        ))
        self.addDescribed(common.result(CURVES, tr("Curves"), common.TABLE, optional=True), tr(
            "Relative variance of every component, for each window, raster and band."
        ))
        self.addDescribed(common.result(PAIRS, tr("Pairs"), common.TABLE, optional=True), tr(
            "The mosaic against each single source: ratios, similarity, sub-pixel offset."
        ))
        self.addDescribed(common.result(PROFILES, tr("Seam profiles"), common.TABLE, optional=True), tr(
            "What is kept of each level's detail by distance from the seam, with its 95 % interval."
        ))
        self.addNumbers({
            WINDOW_COUNT: tr("Windows"),
            SIGNIFICANT_COUNT: tr("Windows with a significant loss"),
            NOT_COMPARABLE_COUNT: tr("Windows that can't be compared"),
        })

    def check(self, run: Run) -> None:
        self._settings(run).check()
        run.mosaic()
        check_sources(run)

    def execute(self, run: Run) -> dict[str, Any]:
        from ...toolkit import layers
        from ...toolkit.algorithms.window_notices import WindowNotices
        from ...toolkit.executors import open_executor
        from ...toolkit.table_fields import column_features, column_fields
        from ..measure.judgement.verdicts import Verdict
        from ..measure.window import window_tables as tables
        from ..measure.window.inspection import inspect_windows
        from ..tables.result_tables import output_fields, window_feature
        from ..words import verdict_word

        settings = self._settings(run)
        settings.check()
        windows = run.source(WINDOWS)
        if windows.featureCount() == 0:
            raise SettingsError(toolkit_messages.NO_WINDOWS())
        cells = self._cells(run)
        block = given_block(run, self._mosaic, self._given, cells)
        grid, crs = block.mosaic.grid, layers.mosaic_crs(block.mosaic)
        drawn = WindowFeatures(windows, crs, run, carried=tuple(JUDGING_FIELDS))

        verdicts: Counter[Verdict] = Counter()
        notices = WindowNotices()
        with open_executor(run.text(common.SCHEDULER), run.is_cancelled) as (executor, ahead):
            # Only now, with nothing in the way of new results, are old ones overwritten.
            fields = output_fields(settings.levels, drawn.carried)
            output, output_id = run.sink(OUTPUT, fields, QgsWkbTypes.Type.Polygon, crs)
            curves, curves_id = run.optional_sink(CURVES, column_fields(tables.CURVE_COLUMNS))
            pair_fields = column_fields(tables.PAIR_COLUMNS, settings.levels)
            pairs, pairs_id = run.optional_sink(PAIRS, pair_fields)
            profiles, profiles_id = run.optional_sink(PROFILES, column_fields(tables.PROFILE_COLUMNS))
            for result in inspect_windows(self._requests(drawn, block, settings), executor, ahead, run.is_cancelled):
                geometry, said = drawn.taken(result.window_id)
                if result.window is not None:
                    geometry = layers.rectangle(grid.window_extent(result.window))
                run.write(output, [window_feature(result, geometry, said)])
                run.write(curves, column_features(tables.CURVE_COLUMNS, tables.curves_of(result)))
                run.write(pairs, column_features(tables.PAIR_COLUMNS, tables.pairs_of(result), result.levels))
                run.write(profiles, column_features(tables.PROFILE_COLUMNS, tables.bins_of(result)))
                notices.add(result.window_id, [*result.notices, result.judgement.reason])
                verdicts[result.judgement.verdict] += 1
                run.progress(sum(verdicts.values()) / drawn.count)
        run.tell(*notices.messages())
        run.tell(*drawn.notices())
        run.feedback.pushInfo(", ".join(f"{verdict_word(verdict.value)}: {verdicts[verdict]}" for verdict in Verdict))
        run.style(output_id, "windows")
        return {
            OUTPUT: output_id,
            CURVES: curves_id,
            PAIRS: pairs_id,
            PROFILES: profiles_id,
            WINDOW_COUNT: sum(verdicts.values()),
            SIGNIFICANT_COUNT: verdicts[Verdict.SIGNIFICANT],
            NOT_COMPARABLE_COUNT: verdicts[Verdict.NOT_COMPARABLE],
        }

    def _settings(self, run: Run) -> InspectionSettings:
        from ..measure.window.measured_window import InspectionSettings

        return InspectionSettings(
            *run.decomposition(), run.real(common.MAX_RATIO), run.text(REFERENCE), run.real(MIN_KEPT),
            run.flag(DIRECTIONS),
        )

    def _cells(self, run: Run) -> list[Cell]:
        from ...toolkit import layers
        from ..tables.input_layers import seam_cells

        if not run.parameters.get(CELLS):
            return []
        cells = run.source(CELLS)
        if "source" not in cells.fields().names():
            raise SettingsError(messages.CELLS_WITHOUT_SOURCE())
        transform = run.transform(cells, layers.mosaic_crs(self._mosaic))
        return seam_cells(layers.features(cells), transform)

    @staticmethod
    def _requests(drawn: WindowFeatures, block: Block, settings: InspectionSettings) -> Iterator[WindowRequest]:
        from ..measure.window.inspection import window_request
        from ..measure.window.measured_window import WindowRequest

        for window in drawn.windows():
            if window.extent is None:
                yield WindowRequest(window.window_id, block.mosaic, (), None, settings, window.reason)
            else:
                yield window_request(block, window.window_id, window.extent, settings)
