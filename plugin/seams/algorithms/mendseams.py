"""``seaminspector:mendseams``: failed seams cut anew where the orthoimages agree, and measured again."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsGeometry,
    QgsLineString,
    QgsProcessing,
    QgsProcessingFeatureSource,
    QgsProcessingOutputRasterLayer,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterFolderDestination,
    QgsProcessingParameterNumber,
    QgsWkbTypes,
)
from qgis.PyQt.QtCore import QT_TR_NOOP

from ...imagery.errors import CancelledError
from ...toolkit.algorithms import parameters as common
from ...toolkit.algorithms.base import SeamInspectorAlgorithm
from ...toolkit.algorithms.run import Run
from ...toolkit.translation import tr
from ..measure.limits import MEND_BLEND_PX, MEND_WIDTH_M, MENDED_SEAMS, MOST_BLEND_PX
from ..measure.mending import messages
from .block_parameters import check_sources, follow_steps, gathered_sources, given_features, given_sources

if TYPE_CHECKING:
    from ..measure.mending.failed_runs import ScannedPiece
    from ..measure.mending.mend_run import MendSettings
    from ..measure.mending.mending import MendedSeam, Mending
    from ..measure.source_images import Source

SEAMS, WHAT, WIDTH, BLEND, PATCHES, MENDED, CUTS = "SEAMS", "WHAT", "WIDTH", "BLEND", "PATCHES", "MENDED", "CUTS"
MENDED_MOSAIC = "MENDED_MOSAIC"
MENDED_METRES, LEFT_METRES = "MENDED_METRES", "LEFT_METRES"
_CUT = 0.6  # of the time: the rest is to measure what was made


class MendSeams(SeamInspectorAlgorithm):
    """Find, prove, mend: what a scan found to have lost detail gets it back from the orthoimages."""

    ID = "mendseams"
    NAME = QT_TR_NOOP("Mend seams")
    HELP = QT_TR_NOOP(
        "Cuts failed seams anew. Each new cut runs where the two orthoimages agree, around roofs, cars and trees "
        "that they show in different places. Its pixels come from the orthoimages in the mosaic's own tones and "
        "sharpness, and only tones are eased. Patches and a virtual mosaic are written; the mosaic itself is never "
        "touched. Then the new cuts are measured as a scan does it, and only what keeps more detail than before "
        "stays. Where the orthoimages fit nowhere, the seam stays as it is and the table gives the reason."
    )
    NAMED_BY_FORMAT = (MENDED,)

    def initAlgorithm(self, configuration: Any = None) -> None:
        line, polygon = QgsProcessing.SourceType.TypeVectorLine, QgsProcessing.SourceType.TypeVectorPolygon
        whole = QgsProcessingParameterNumber.Type.Integer
        self.addDescribed(*common.mosaic())
        self.addDescribed(*common.sources())
        self.addDescribed(*common.source_index())
        self.addDescribed(
            QgsProcessingParameterFeatureSource(SEAMS, tr("Seams"), [line, polygon]),
            tr(
                "The seams as Scan a whole mosaic writes them, all of them. Or windows: then the mosaic is scanned "
                "first, and the seams in the windows are mended."
            ),
        )
        self.addDescribed(
            common.choice(WHAT, tr("What to mend"), MENDED_SEAMS),
            tr(
                "failed: pieces that keep less than 70 %. reduced: also those that measurably lost some detail. all: "
                "every piece."
            ),
        )
        self.addDescribed(
            common.real(WIDTH, tr("Width of the corridor (metres)"), MEND_WIDTH_M, 0.01),
            tr("How far a new cut may move to either side of the seam; at most 800 pixels."),
        )
        self.addDescribed(
            QgsProcessingParameterNumber(
                BLEND, tr("Blend (pixels)"), whole, MEND_BLEND_PX, minValue=0, maxValue=MOST_BLEND_PX
            ),
            tr("Width over which the two orthoimages are mixed at the cut. 0: a hard cut."),
            advanced=True,
        )
        self.addDescribed(*common.scheduler(), advanced=True)
        self.addDescribed(
            QgsProcessingParameterFolderDestination(PATCHES, tr("Patches")),
            tr(
                "A folder for the patches, cloud-optimised GeoTIFFs with an alpha band; or the name of one .tif for "
                "all of them."
            ),
        )
        self.addDescribed(
            QgsProcessingParameterFileDestination(MENDED, tr("Mended mosaic"), "VRT (*.vrt)"),
            tr("A virtual raster: the mosaic with the patches above it. It needs both where they are."),
        )
        self.addDescribed(
            QgsProcessingParameterFeatureSink(CUTS, tr("Cuts"), line),
            tr("Each seam as it runs now, with what it kept before and after, and its step of tone before and after."),
        )
        self.addOutput(QgsProcessingOutputRasterLayer(MENDED_MOSAIC, tr("Mended mosaic")))
        self.addNumbers({
            MENDED_METRES: tr("Length of the seams that are mended (metres)"),
            LEFT_METRES: tr("Length of the seams that stay as they were (metres)"),
        })

    @staticmethod
    def _settings(run: Run) -> MendSettings:
        """Raises SettingsError for values out of their range."""
        from ..measure.mending.mend_run import MendSettings

        settings = MendSettings(run.real(WIDTH), run.whole(BLEND), run.text(WHAT))
        settings.check()
        return settings

    def check(self, run: Run) -> None:
        self._settings(run)
        check_sources(run)
        run.mosaic()

    def prepare(self, run: Run) -> None:
        self._mosaic = run.mosaic()
        self._given = given_sources(run)

    def execute(self, run: Run) -> dict[str, Any]:
        from ...toolkit import layers
        from ...toolkit.executors import open_executor
        from ...toolkit.table_fields import column_fields, column_values, feature
        from ..measure.inputs.mosaic_copies import leave_out_copies
        from ..measure.mending.failed_runs import given_pieces
        from ..measure.mending.mending import CUT_COLUMNS, LEFT, MendRequest, mending, metres

        self.check(run)
        settings = self._settings(run)
        mosaic, patches, mended = self._mosaic, run.text(PATCHES), run.file_path(MENDED)
        assert mended is not None
        crs = layers.mosaic_crs(mosaic)
        gathered = gathered_sources(run, self._given, crs, mosaic.wkt, mosaic.ref)
        sources, notices = leave_out_copies(mosaic, gathered)
        run.tell_once(notices)
        given = run.source(SEAMS)
        with open_executor(run.text(common.SCHEDULER), run.is_cancelled) as (executor, ahead):
            if QgsWkbTypes.geometryType(given.wkbType()) == QgsWkbTypes.GeometryType.PolygonGeometry:
                pieces = self._scanned(run, given, crs, sources)
            else:
                pieces = given_pieces(*given_features(run, SEAMS, crs))
            request = MendRequest(mosaic, tuple(sources), tuple(pieces), settings)
            runs, unnamed = request.runs
            if unnamed:
                run.tell(messages.SIDES_UNKNOWN(metres=unnamed))
            if not runs and not unnamed:
                run.tell(messages.NOTHING_TO_MEND())
            with mending(request, mended) as job:
                seams = self._mended(run, job, patches, str(mended), executor, ahead)
        run.tell_once(one.reason for one in seams if one.reason is not None)
        fields = column_fields(CUT_COLUMNS)
        sink, cuts = run.sink(CUTS, fields, QgsWkbTypes.Type.LineString, crs)
        run.write(sink, (
            feature(fields, column_values(CUT_COLUMNS, one), QgsGeometry(QgsLineString(*one.vertices.T.tolist())))
            for one in seams
        ))
        left = metres(seams, LEFT)
        return {
            PATCHES: patches, MENDED: str(mended), MENDED_MOSAIC: str(mended), CUTS: cuts,
            MENDED_METRES: metres(seams) - left, LEFT_METRES: left + unnamed,
        }

    @staticmethod
    def _mended(
        run: Run, job: Mending, patches: str, mended: str, executor: Any, ahead: int
    ) -> list[MendedSeam]:
        """Raises CancelledError where nobody wants it any more."""
        if job.done:
            run.tell(messages.MENDING_GOES_ON(done=job.done))
        follow_steps(run, job.steps(executor, ahead, run.is_cancelled), _CUT)
        if run.is_cancelled():
            raise CancelledError(messages.MENDING_STOPPED())
        return job.result(patches, mended, lambda share: run.goes_on(_CUT + (1 - _CUT) * share), executor, ahead)

    def _scanned(
        self, run: Run, windows: QgsProcessingFeatureSource, crs: QgsCoordinateReferenceSystem, sources: list[Source]
    ) -> list[ScannedPiece]:
        """The pieces of a scan of the mosaic; those in no window as such that passed."""
        from ...toolkit import layers
        from ..measure.inspection import Block
        from ..measure.mending.failed_runs import scanned_pieces
        from ..measure.scan.whole_scan import scan

        def goes_on(share: float) -> None:
            if run.is_cancelled():
                raise CancelledError(messages.MENDING_STOPPED())

        transform = run.transform(windows, crs)
        wanted = [layers.window_geometry(one, transform) for one in layers.features(windows)]
        found = scan(Block(self._mosaic, tuple(sources)), progress=goes_on)
        run.tell_once(found.notices)

        def is_wanted(vertices: Any) -> bool:
            line = QgsGeometry(QgsLineString(*vertices.T.tolist()))
            return any(one.intersects(line) for one in wanted)

        return scanned_pieces(found.pieces, is_wanted)
