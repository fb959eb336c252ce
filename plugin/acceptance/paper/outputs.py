"""What acceptmosaic leaves on paper: the layer of failures with their pictures, the report, the XML."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from qgis.core import (
    QgsProcessingException,
    QgsProcessingUtils,
    QgsProviderRegistry,
    QgsWkbTypes,
)

from ...imagery.errors import CancelledError, RasterError, SettingsError
from ...imagery.open_raster import describe_mosaic, describe_placed
from ...imagery.rasters import Raster, RasterRef
from ...toolkit.algorithms.run import Run
from ...toolkit.pages.templates import whole_path
from ...toolkit.reference_systems import reference_system
from ..acceptmosaic import DEFECTS, MOST_PICTURES, QUALITY, REPORT
from ..measure import messages
from ..measure.decision import Decision, Defect
from .defect_files import DefectPicture, DefectPictures, defect_features, defect_fields, save_pictures
from .inspection_record import InspectionRecord, described_bands, scan_settings

TOLD_UNEXPLAINED = 0.03  # of a mosaic without an orthoimage behind it: where the scan tells it, too


def write(
    run: Run, decision: Decision, refs: Sequence[RasterRef], loss_ref: RasterRef | None,
    seams: Sequence[tuple[str, str]], windows: str, rules: str,
) -> dict[str, Any]:
    """Write what is wanted; what can't be written is told, and does not cost the decision.

    ``refs``: of the mosaics; ``loss_ref``: of the picture of losses. ``seams``, ``windows`` and ``rules``: where
    sheets, windows and rules were read from, in words for people.
    """
    loss, settings, bands = _loss(run, loss_ref)
    report = run.file_path(REPORT)
    maker, mosaics = _maker(run, refs, decision) if run.parameters.get(DEFECTS) or report else (None, ())
    record = InspectionRecord(
        decision, tuple((sheet, whole_path(address)) for sheet, address in seams), whole_path(windows),
        whole_path(rules), mosaics, loss, settings, bands, str(report or ""),
    )
    pictures: dict[int, DefectPicture] = {}
    results = _write_defects(run, decision, record.defects, maker, pictures)

    def save_quality(path: Path) -> None:
        from .quality_document import save_quality_document

        save_quality_document(path, record)

    def save_report(path: Path) -> None:
        from .acceptance_report import save_acceptance_report

        save_acceptance_report(path, record, pictures)

    return {**results, **run.save(QUALITY, save_quality), **run.save(REPORT, save_report)}


def _loss(run: Run, ref: RasterRef | None) -> tuple[Raster | None, Mapping[str, str], tuple[str, ...]]:
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


def _maker(run: Run, refs: Sequence[RasterRef], decision: Decision) -> tuple[DefectPictures | None, tuple[Raster, ...]]:
    """What cuts the pictures, and the mosaics that it can cut them from."""
    mosaics = []
    for ref in refs:
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
    try:
        crs = reference_system(decision.delivery.wkt)
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
