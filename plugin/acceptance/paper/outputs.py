"""What acceptmosaic leaves on paper: the layer of failures with their pictures, the report, the XML."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessing,
    QgsProcessingException,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterMultipleLayers,
    QgsProcessingParameterRasterLayer,
    QgsProcessingUtils,
    QgsProviderRegistry,
    QgsWkbTypes,
)

from ...imagery.errors import CancelledError, RasterError, SettingsError
from ...toolkit.algorithms import parameters as common
from ...toolkit.algorithms.base import SeamInspectorAlgorithm
from ...toolkit.algorithms.run import Run
from ...toolkit.translation import filled, tr
from . import messages

if TYPE_CHECKING:
    from ...imagery.rasters import Raster, RasterRef
    from ..measure.decision import Decision, Defect
    from .defect_files import DefectPicture, DefectPictures

MOST_PICTURES = 100  # of a delivery, of the longest failures: some 12 MB of report
TOLD_UNEXPLAINED = 0.03  # of a mosaic without an orthoimage behind it: where the scan tells it, too


MOSAIC, LOSS = common.MOSAIC, "LOSS"
DEFECTS, REPORT, QUALITY = "DEFECTS", common.REPORT, "QUALITY"


@dataclass(frozen=True)
class PaperInputs:
    """What is shown beside the decision."""

    mosaics: tuple[RasterRef, ...] = ()
    loss: RasterRef | None = None


def add_inputs(algorithm: SeamInspectorAlgorithm) -> None:
    """Parameters for what is shown; its ``RASTER_LISTS`` has to name MOSAIC."""
    algorithm.addDescribed(
        QgsProcessingParameterMultipleLayers(
            MOSAIC, tr("Mosaic"), QgsProcessing.SourceType.TypeRaster, optional=True
        ),
        tr("The mosaic or its sheets: pictures of the failures are cut from them, for the layer and the report."),
    )
    algorithm.addDescribed(
        QgsProcessingParameterRasterLayer(LOSS, tr("Picture of losses"), optional=True),
        tr("As the scan wrote it: the XML refers to it, and it says how the seams were measured."),
        advanced=True,
    )


def add_outputs(algorithm: SeamInspectorAlgorithm) -> None:
    """What is written; its ``PAGES`` has to name REPORT and QUALITY."""
    algorithm.addDescribed(
        QgsProcessingParameterFeatureSink(
            DEFECTS, tr("Failures"), QgsProcessing.SourceType.TypeVectorLine, optional=True, createByDefault=True
        ),
        tr(
            "One feature for each failure without a break, for the producer: place, length, what is kept, the two "
            "orthoimages and their dates, remarks, and a picture in a folder beside the file. GeoPackage or CSV."
        ),
    )
    algorithm.addDescribed(*common.report(filled(tr(
        "The decision on paper, to be signed: rules, sheets, a map, the failures with pictures of the longest {most}, "
        "the plan's risk. Opens in a browser and prints on A4."
    ), most=MOST_PICTURES), by_default=True))
    algorithm.addDescribed(
        QgsProcessingParameterFileDestination(
            QUALITY, tr("Quality record (ISO 19157)"), "XML (*.xml)", optional=True, createByDefault=False
        ),
        tr("The figures and the decision as a catalogue reads them: ISO 19157:2013 in the XML of ISO/TS 19157-2:2016."),
    )


def prepare(run: Run) -> PaperInputs:
    """What the parameters name, to be asked in their layers' thread; says which mosaics can't be shown."""
    mosaics, left_out = run.raster_refs(MOSAIC)
    run.tell(*left_out)
    return PaperInputs(tuple(mosaics), run.raster(LOSS))


def write(
    run: Run, decision: Decision, inputs: PaperInputs, seams: Sequence[tuple[str, str]], windows: str, rules: str
) -> dict[str, Any]:
    """Write what is wanted; what can't be written is told, and does not cost the decision.

    ``seams``, ``windows`` and ``rules``: where sheets, windows and rules were read from, in words for people.
    """
    from ...toolkit.pages.templates import whole_path
    from .acceptance_report import save_acceptance_report
    from .inspection_record import InspectionRecord
    from .quality_document import save_quality_document

    loss, settings, bands = _loss(run, inputs.loss)
    report = run.file_path(REPORT)
    maker, mosaics = _maker(run, inputs, decision) if run.parameters.get(DEFECTS) or report else (None, ())
    record = InspectionRecord(
        decision, tuple((sheet, whole_path(address)) for sheet, address in seams), whole_path(windows),
        whole_path(rules), mosaics, loss, settings, bands, str(report or ""),
    )
    pictures: dict[int, DefectPicture] = {}
    results = _write_defects(run, decision, record.defects, maker, pictures)
    results.update(run.save(QUALITY, lambda path: save_quality_document(path, record)))
    results.update(run.save(REPORT, lambda path: save_acceptance_report(path, record, pictures)))
    return results


def _loss(run: Run, ref: RasterRef | None) -> tuple[Raster | None, Mapping[str, str], tuple[str, ...]]:
    from ...imagery.open_raster import describe_placed
    from .inspection_record import described_bands, scan_settings

    if ref is None:
        return None, {}, ()
    try:
        if settings := scan_settings(ref):
            if float(settings.get("unexplained", 0)) >= TOLD_UNEXPLAINED:
                run.tell(messages.SCAN_UNEXPLAINED(name=ref.name, share=float(settings["unexplained"])))
            if settings.get("seams") == "found":
                run.tell(messages.SEAMS_FOUND(name=ref.name))
            return describe_placed(ref), settings, described_bands(ref)
        run.tell(messages.LOSS_NOT_OF_SCAN(name=ref.name))
    except RasterError as error:
        run.tell(error.message.as_warning())
    return None, {}, ()


def _maker(run: Run, inputs: PaperInputs, decision: Decision) -> tuple[DefectPictures | None, tuple[Raster, ...]]:
    """What cuts the pictures, and the mosaics that it can cut them from."""
    from ...imagery.open_raster import describe_mosaic
    from .defect_files import DefectPictures
    from .inspection_record import scan_settings

    mosaics = []
    for ref in inputs.mosaics:
        try:
            if scan_settings(ref):
                run.tell(messages.MOSAIC_IS_LOSS(name=ref.name))
                continue
            mosaics.append(describe_mosaic(ref))
        except RasterError as error:
            run.tell(error.message.as_warning())
    return DefectPictures(mosaics, decision.delivery.wkt) if mosaics else None, tuple(mosaics)


def _write_defects(
    run: Run, decision: Decision, defects: Sequence[Defect], maker: DefectPictures | None,
    pictures: dict[int, DefectPicture],
) -> dict[str, Any]:
    """The layer; fills in the pictures by the failures' numbers, for the report too."""
    from .defect_files import defect_features, defect_fields, save_pictures

    try:
        crs = QgsCoordinateReferenceSystem.fromWkt(decision.delivery.wkt)
        layout = defect_fields(), QgsWkbTypes.Type.MultiLineString, crs
        sink, destination = run.optional_sink(DEFECTS, *layout)
    except QgsProcessingException:
        run.tell(messages.DEFECTS_NOT_WRITTEN())
        sink, destination = None, None
    if sink is None:
        _cut_pictures(run, defects, maker, pictures)
        return {}
    file = _file_of(str(destination))
    folder = Path(QgsProcessingUtils.generateTempFilename("pictures")) if file is None else (
        file.with_name(f"{file.stem}_pictures")
    )
    paths: dict[int, str] = {}
    try:
        _cut_pictures(run, defects, maker, pictures)
        save_pictures(folder, pictures, paths)
    except SettingsError as error:
        run.tell(error.message.as_warning())
    finally:  # a layer without a failure would say that there are none, also where the run was stopped
        if file is not None:
            paths = {number: f"{folder.name}/{Path(path).name}" for number, path in paths.items()}
        run.write(sink, defect_features(defects, paths))
    run.style(destination, "defects")
    return {DEFECTS: destination}


def _file_of(destination: str) -> Path | None:
    """The file of a layer; None for one in memory or in a database."""
    path = Path(str(QgsProviderRegistry.instance().decodeUri("ogr", destination).get("path") or ""))
    return path.absolute() if path.suffix and path.absolute().parent.is_dir() else None


def _cut_pictures(
    run: Run, defects: Sequence[Defect], maker: DefectPictures | None, pictures: dict[int, DefectPicture]
) -> None:
    """Of the longest failures. Raises CancelledError when they are not wanted any more."""
    shown = defects[:MOST_PICTURES]
    if maker is None or not shown:
        return
    for done, defect in enumerate(shown):
        if not run.goes_on(done / len(shown)):
            raise CancelledError(messages.PAPER_STOPPED())
        if (picture := maker.of(defect)) is not None:
            pictures[defect.number] = picture
    if missing := len(shown) - len(pictures):
        run.tell(messages.PICTURES_MISSING(count=missing))
    if len(defects) > len(shown):
        run.tell(messages.PICTURES_LIMITED(shown=len(shown), count=len(defects)))
