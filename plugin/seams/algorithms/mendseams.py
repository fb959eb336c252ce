"""``seaminspector:mendseams``: failed seams cut anew where the orthoimages agree, and measured again."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsGeometry,
    QgsLineString,
    QgsProcessingOutputRasterLayer,
    QgsProcessingParameterFolderDestination,
    QgsWkbTypes,
)
from qgis.PyQt.QtCore import QT_TR_NOOP

from ...imagery.errors import CancelledError
from ...toolkit.algorithms import parameters as common
from ...toolkit.algorithms.run import Run
from ...toolkit.translation import tr
from ..measure import messages
from ..measure.limits import MEND_BLEND_PX, MEND_WIDTH_M, MENDED_SEAMS, MOST_BLEND_PX
from .block_parameters import BlockAlgorithm, check_sources, follow_steps, gathered_sources, given_features

if TYPE_CHECKING:
    from ..measure.mending.failed_runs import SeamRun
    from ..measure.source_images import Source

SEAMS, WHAT, WIDTH, BLEND, PATCHES, MENDED, CUTS = "SEAMS", "WHAT", "WIDTH", "BLEND", "PATCHES", "MENDED", "CUTS"
MENDED_MOSAIC = "MENDED_MOSAIC"
MENDED_METRES, LEFT_METRES = "MENDED_METRES", "LEFT_METRES"


class MendSeams(BlockAlgorithm):
    """Find, prove, mend: what a scan found to have lost detail gets it back from the orthoimages."""

    ID = "mendseams"
    DRAWN = ()
    NAME = QT_TR_NOOP("Mend seams")
    HELP = QT_TR_NOOP(
        "Cuts failed seams anew. Each new cut runs where the two orthoimages agree, around roofs, cars and trees that "
        "they show in different places. Its pixels come from the orthoimages in the mosaic's own tones and sharpness, "
        "and only tones are blended more widely. Patches and a virtual mosaic are written; the mosaic itself is never "
        "touched. Then the new cuts are measured as in a scan, and only those that keep more detail than before are "
        "used. Where the orthoimages do not fit anywhere, the seam stays as it is and the table gives the reason."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.add_block()
        self.addDescribed(common.features(SEAMS, tr("Seams"), common.LINE, common.POLYGON), tr(
            "All seams as Scan a whole mosaic writes them. Or windows: then the mosaic is scanned first, and the seams "
            "in the windows are mended."
        ))
        self.addDescribed(common.choice(WHAT, tr("What to mend"), MENDED_SEAMS), tr(
            "failed: pieces that keep less than 70 %. reduced: also those that measurably lost some detail. all: every "
            "piece."
        ))
        self.addDescribed(common.real(WIDTH, tr("Width of the corridor (metres)"), MEND_WIDTH_M, 0.01), tr(
            "How far a new cut may move to either side of the seam; at most 800 pixels."
        ))
        self.addDescribed(common.whole(BLEND, tr("Blend (pixels)"), MEND_BLEND_PX, 0, MOST_BLEND_PX), tr(
            "Width over which the two orthoimages are mixed at the cut. 0: a hard cut."
        ), advanced=True)
        self.addDescribed(*common.scheduler(), advanced=True)
        self.addDescribed(QgsProcessingParameterFolderDestination(PATCHES, tr("Patches")), tr(
            "A folder for the patches, cloud-optimised GeoTIFFs with an alpha band."
        ))
        self.addDescribed(common.made_file(MENDED, tr("Mended mosaic"), "VRT (*.vrt)"), tr(
            "A virtual raster: the mosaic with the patches on top. It refers to both, so leave both there."
        ))
        self.addDescribed(common.result(CUTS, tr("Cuts"), common.LINE), tr(
            "Each seam as it runs now, with what it kept before and after, and its step of tone before and after."
        ))
        self.addDescribed(*common.report(tr("Each seam before and after, in figures and in pictures at 2x.")))
        self.addOutput(QgsProcessingOutputRasterLayer(MENDED_MOSAIC, tr("Mended mosaic")))
        self.addNumbers({
            MENDED_METRES: tr("Length of the seams that are mended (metres)"),
            LEFT_METRES: tr("Length of the seams that stay as they were (metres)"),
        })

    def check(self, run: Run) -> None:
        from ..measure.mending.failed_runs import check_what

        check_what(run.text(WHAT))
        check_sources(run)
        run.mosaic()

    def execute(self, run: Run) -> dict[str, Any]:
        from ...toolkit.executors import open_executor
        from ...toolkit.layers import mosaic_crs
        from ...toolkit.table_fields import column_fields, column_values, feature
        from ..measure.inputs.mosaic_copies import leave_out_copies
        from ..measure.mending.mend_run import MendSettings
        from ..measure.mending.mending import CUT_COLUMNS, LEFT, PATCHED, MendRequest, mending, metres
        from ..measure.workers import Workers
        from ..report.mending_report import save_mending_report

        self.check(run)
        mosaic, patches, mended = self._mosaic, run.text(PATCHES), str(run.file_path(MENDED))
        crs = mosaic_crs(mosaic)
        sources, notices = leave_out_copies(mosaic, gathered_sources(run, self._given, crs, mosaic.wkt, mosaic.ref))
        run.tell_once(notices)
        pieces = self._pieces(run, crs, sources)
        request = MendRequest(mosaic, tuple(sources), tuple(pieces), MendSettings(run.real(WIDTH), run.whole(BLEND)))
        if not any(request.runs):
            run.tell(messages.NOTHING_TO_MEND())
        with open_executor(run.text(common.SCHEDULER), run.is_cancelled) as crew, \
                mending(request, patches, mended) as job:
            if job.done:
                run.tell(messages.GOES_ON(done=job.done))
            workers = Workers(*crew, run.is_cancelled, run.progress)
            follow_steps(run, job.steps(workers), PATCHED)
            if run.is_cancelled():
                raise CancelledError(messages.STOPPED())
            seams = job.result(workers.part(PATCHED))
        run.tell_once(seam.reason.as_warning() for seam in seams if seam.reason is not None)
        fields = column_fields(CUT_COLUMNS)
        sink, cuts = run.sink(CUTS, fields, QgsWkbTypes.Type.LineString, crs)
        run.write(sink, (
            feature(fields, column_values(CUT_COLUMNS, seam), QgsGeometry(QgsLineString(*seam.vertices.T.tolist())))
            for seam in seams
        ))
        left_metres = metres(seams, LEFT)
        return {
            PATCHES: patches, MENDED: mended, MENDED_MOSAIC: mended, CUTS: cuts,
            MENDED_METRES: metres(seams) - left_metres, LEFT_METRES: left_metres,
            **run.save(common.REPORT, lambda path: save_mending_report(path, request, mended, seams)),
        }

    def _pieces(self, run: Run, crs: QgsCoordinateReferenceSystem, sources: list[Source]) -> list[SeamRun]:
        """Pieces of a scan; with windows of one that is made now, of which only those in the windows are wanted."""
        from ...imagery.records import GEOMETRY
        from ...toolkit import layers
        from ..measure.mending.failed_runs import FIELDS, given_pieces
        from ..measure.scan.scan_result import seam_rows
        from ..measure.scan.whole_scan import scan
        from ..measure.window.inspection import Block
        from ..measure.workers import Workers

        given, what = run.source(SEAMS), run.text(WHAT)
        if QgsWkbTypes.geometryType(given.wkbType()) != QgsWkbTypes.GeometryType.PolygonGeometry:
            return given_pieces(*given_features(run, SEAMS, crs), what)

        transform = run.transform(given, crs)
        windows = [layers.window_geometry(feature, transform) for feature in layers.features(given)]
        result = scan(Block(self._mosaic, tuple(sources)), workers=Workers(cancelled=run.is_cancelled))
        run.tell_once(result.notices)
        rows = [(row, bytes(QgsGeometry.fromWkt(row[GEOMETRY]).asWkb())) for row in seam_rows(result)]
        return given_pieces(rows, FIELDS, what, lambda vertices: any(
            window.intersects(QgsGeometry(QgsLineString(*vertices.T.tolist()))) for window in windows
        ))
