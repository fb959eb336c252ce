"""``seaminspector:scanmosaic``: the whole mosaic."""
from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import QgsCoordinateReferenceSystem, QgsProcessingException, QgsProcessingParameterRasterDestination
from qgis.PyQt.QtCore import QT_TR_NOOP

from ...imagery.errors import CancelledError, SettingsError
from ...imagery.seam_totals import TOTALS_DOMAIN
from ...toolkit.algorithms import parameters as common
from ...toolkit.algorithms.outputs import output_text
from ...toolkit.algorithms.run import Run
from ...toolkit.translation import sentence, tr
from ..measure import limits, messages
from .block_parameters import BlockAlgorithm, follow_steps, gathered_sources, given_features

if TYPE_CHECKING:
    from ..measure.blocks.block_grid import ScanSettings
    from ..measure.scan.scan_result import ScanResult
    from ..measure.scan.whole_scan import WholeScan
    from ..measure.seamlines.given_seams import GivenSeams
    from ..measure.source_images import Source

SEAMLINES, SOURCE_FIELD, CORRIDOR, DENSITY = "SEAMLINES", "SOURCE_FIELD", "CORRIDOR", "DENSITY"
CELL, PIECE = "CELL", "PIECE"
LOSS, SEAMS, CELLS, WORST, WORST_COUNT = "LOSS", "SEAMS", "CELLS", "WORST", "WORST_COUNT"
SEAM_METRES, FAILED_METRES, WORST_KEPT = "SEAM_METRES", "FAILED_METRES", "WORST_KEPT"


class ScanMosaic(BlockAlgorithm):
    """Finds where a whole mosaic lost detail, and what each piece of its seams kept."""

    ID = "scanmosaic"
    NAME = QT_TR_NOOP("Scan a whole mosaic")
    HELP = QT_TR_NOOP(
        "Measures a whole mosaic in one pass: a picture of where detail was lost, every piece of its seams with what "
        "it kept, which orthoimage each part came from, and windows of the worst places, ready to be judged in the "
        "desk. Seams are found from the pixels, or taken from the seamlines that are given. A scan that was stopped "
        "for any reason continues when it is started again with the same output."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.add_block()
        self.addDescribed(common.features(SEAMLINES, tr("Seamlines"), common.LINE, common.POLYGON, optional=True), tr(
            "Lines, or polygons that are each filled from one orthoimage. Without them seams are found from the "
            "pixels. Needed where there are no orthoimages."
        ))
        self.addDescribed(common.field(SOURCE_FIELD, tr("Field with the orthoimage's name"), SEAMLINES), tr(
            "For seamlines that are polygons. Empty: the first of the fields that producers use, such as source, "
            "CLICHE, image or imageSourceReference."
        ), advanced=True)
        self.addDescribed(common.real(CORRIDOR, tr("Corridor (metres)"), 0.0, 0.0), tr(
            "Width that is read on either side of the seamlines; 0: the whole mosaic."
        ))
        self.addDescribed(common.choice(DENSITY, tr("Density"), limits.DENSITIES), tr(
            "seams: every pixel along the seams, samples elsewhere; takes about as long as reading the files. full: "
            "every pixel everywhere."
        ))
        self.addDescribed(
            common.real(PIECE, tr("Length of a piece of seam (metres)"), limits.STANDARD_PIECE_M, 0.01),
            tr("Seams are measured and judged in pieces of about this length."),
        )
        self.addDescribed(common.whole(CELL, tr("Cell of the picture (pixels)"), 32, 16), tr(
            "Side of a pixel of the picture of losses, in pixels of the mosaic: 16, 32, 64, 128 or 256."
        ), advanced=True)
        self.addDescribed(common.whole(WORST_COUNT, tr("Windows of the worst places"), limits.WORST_COUNT, 0), tr(
            "How many windows are placed where least was kept."
        ), advanced=True)
        self.addDescribed(*common.levels(limits.MOST_LEVELS), advanced=True)
        self.addDescribed(*common.wavelet(), advanced=True)
        self.addDescribed(*common.scheduler(), advanced=True)
        picture = QgsProcessingParameterRasterDestination(LOSS, tr("Picture of losses"), None, True, True)
        self.addDescribed(picture, tr(
            "A GeoTIFF with the bands kept_1, contrast_1, added_1, source and mixture. What was not measured is nodata."
        ))
        self.addDescribed(common.result(SEAMS, tr("Seams"), common.LINE, optional=True), tr(
            "Each piece of seam with what it kept, the 95 % interval, the width of its band, how far an eye sees the "
            "loss at 2x, and the verdict."
        ))
        self.addDescribed(common.result(CELLS, tr("Source cells"), common.POLYGON, optional=True), tr(
            "Polygons that say in the field 'source' which orthoimage each part of the mosaic came from."
        ))
        self.addDescribed(common.result(WORST, tr("Worst places"), common.POLYGON, optional=True), tr(
            "Windows that kept least, the worst first, ready for the desk and for Inspect windows."
        ))
        self.addNumbers({
            SEAM_METRES: tr("Length of all seams (metres)"),
            FAILED_METRES: tr("Length of the pieces that keep less than 70 % (metres)"),
            WORST_KEPT: tr("Least share kept by a piece"),
        })

    def check(self, run: Run) -> None:
        self._settings(run).check()
        run.mosaic()
        check_tiff(self._picture(run))
        if not run.parameters.get(SEAMLINES) and not _names_sources(run):
            raise SettingsError(messages.NEITHER_SOURCES_NOR_SEAMS())

    def execute(self, run: Run) -> dict[str, Any]:
        from ...toolkit import layers
        from ..measure.scan.scan_request import scan_request
        from ..measure.scan.whole_scan import whole_scan
        from ..tables import scan_layers

        settings, mosaic = self._settings(run), self._mosaic
        crs = layers.mosaic_crs(mosaic)
        sources = self._sources(run, crs)
        given = self._given_seams(run, crs, [source.ref.path for source in sources])
        request, notices = scan_request(mosaic, sources, settings, given)
        run.tell(*notices)
        picture = self._picture(run)
        check_tiff(picture)
        with self._journal_beside(run) as output, whole_scan(request, output) as scan:
            if scan.notice is not None:
                run.tell(scan.notice)
            result = self._scanned(run, scan, picture)
            run.tell(*result.notices)
            run.feedback.pushInfo(sentence(scan_layers.scan_finding(result.pieces)))
            results = {LOSS: picture or None, **self._write(run, result, request)}
            scan.finish()
        run.style(picture, "loss")
        return {
            **results,
            SEAM_METRES: result.seam_metres, FAILED_METRES: result.failed_metres, WORST_KEPT: result.worst_kept,
        }

    def _sources(self, run: Run, crs: QgsCoordinateReferenceSystem) -> tuple[Source, ...]:
        """The orthoimages; none where only seamlines are given."""
        if not _names_sources(run):
            return ()
        from ..measure.inputs.mosaic_copies import leave_out_copies

        sources = gathered_sources(run, self._given, crs, self._mosaic.wkt, self._mosaic.ref)
        if not sources:
            raise SettingsError(messages.NO_SOURCE_USABLE())
        kept, notices = leave_out_copies(self._mosaic, sources)
        run.tell_once(notices)
        return tuple(kept)

    def _given_seams(self, run: Run, crs: QgsCoordinateReferenceSystem, paths: list[str]) -> GivenSeams | None:
        """What the seamlines say; None without them. ``paths``: of the orthoimages."""
        from ..measure.seamlines.given_seams import given_seams

        if not run.parameters.get(SEAMLINES):
            return None
        features, _ = given_features(run, SEAMLINES, crs)
        return given_seams(features, self._mosaic.grid, self._settings(run).source_field, paths)

    def _scanned(self, run: Run, scan: WholeScan, picture: str) -> ScanResult:
        """What all blocks tell. Raises CancelledError where nobody wants it any more."""
        from ...toolkit.executors import open_executor
        from ..measure.scan.whole_scan import MEASURED
        from ..measure.workers import Workers

        with open_executor(run.text(common.SCHEDULER), run.is_cancelled) as crew:
            workers = Workers(*crew, run.is_cancelled, run.progress)
            follow_steps(run, scan.steps(workers), MEASURED)
            result = None if run.is_cancelled() else scan.result(picture, workers.part(MEASURED))
        if result is None:
            raise CancelledError(messages.STOPPED())
        return result

    def _write(self, run: Run, result: ScanResult, request: Any) -> dict[str, Any]:
        """The layers, whole on the disk when this returns. Raises SettingsError where one can't be written."""
        from ...toolkit.layers import mosaic_crs
        from ..measure.scan.scan_result import seam_notes
        from ..tables import scan_layers

        crs, made = mosaic_crs(request.mosaic), {}
        for name, layer in (
            (SEAMS, scan_layers.SEAMS), (CELLS, scan_layers.CELLS), (WORST, scan_layers.WORST),
        ):
            fields, rows = layer.fields(request.settings.levels), layer.rows(result, request)
            try:
                sink, made[name] = run.optional_sink(name, fields, layer.geometry, crs)
                run.write(sink, rows)
            except QgsProcessingException:
                raise SettingsError(messages.SCAN_LAYER_NOT_WRITTEN(name=name)) from None
            run.style(made[name], layer.style)
        lost = run.close()
        for name, destination in made.items():
            if destination in lost:
                raise SettingsError(messages.SCAN_LAYER_NOT_WRITTEN(name=name))
        if not run.note(made[SEAMS], TOTALS_DOMAIN, seam_notes(result)):
            run.tell(messages.SEAMS_WITHOUT_SEAL())
        return made

    def _settings(self, run: Run) -> ScanSettings:
        from ..measure.blocks.block_grid import ScanSettings

        return ScanSettings(
            *run.decomposition(), run.text(DENSITY), run.whole(CELL), run.real(PIECE), run.real(CORRIDOR),
            run.whole(WORST_COUNT), run.text(SOURCE_FIELD),
        )

    @staticmethod
    def _picture(run: Run) -> str:
        """The picture's file, empty where none is wanted."""
        return run.layer_path(LOSS) if run.parameters.get(LOSS) else ""

    @staticmethod
    @contextmanager
    def _journal_beside(run: Run) -> Iterator[Path]:
        """What the journal lies beside: the first output that is a file of a name."""
        for name in (LOSS, SEAMS, CELLS, WORST):
            output = output_text(run.parameters.get(name), run.context)
            if Path(output).suffix and not output.startswith("/vsi") and os.path.isdir(Path(output).parent):
                yield Path(output)
                return
        with tempfile.TemporaryDirectory() as folder:
            yield Path(folder) / "loss"


def check_tiff(path: str) -> None:
    """Raise SettingsError for an ending that says that it is something else; nothing where no picture is wanted."""
    if path and Path(path).suffix.lower() not in (".tif", ".tiff"):
        raise SettingsError(messages.LOSS_NOT_TIFF(path=path))


def _names_sources(run: Run) -> bool:
    return bool(run.raster_values(common.SOURCES) or run.parameters.get(common.SOURCE_INDEX))
