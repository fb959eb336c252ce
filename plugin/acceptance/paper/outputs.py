"""What acceptmosaic leaves on paper: the layer of failures with their pictures, that of sheets, the report, the XML."""
from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, Callable

from qgis.core import QgsFeatureSink, QgsProcessingException, QgsProcessingUtils, QgsProviderRegistry, QgsWkbTypes

from ...imagery.errors import CancelledError, RasterError, SettingsError
from ...imagery.open_raster import describe_mosaic
from ...imagery.rasters import Raster, RasterRef
from ...toolkit.algorithms.run import Run
from ...toolkit.pages.templates import whole_path
from ...toolkit.reference_systems import reference_system
from ...toolkit.table_fields import column_fields
from ...toolkit.translation import tr
from ..measure import messages
from ..measure.decision import Decision, Defect
from .defect_files import DEFECT_COLUMNS, DefectPicture, DefectPictures, Prover, defect_features, save_pictures
from .inspection_record import InspectionRecord, listed_images, scanned_images
from .paper_head import DEFECTS, MOST_PICTURES, QUALITY, REPORT, SHEETS_OUT, stated_head
from .sheet_layer import SHEET_COLUMNS, sheet_features

Proof = Callable[["Sequence[str]", "Sequence[Raster]"], "tuple[Sequence[str], Prover | None]"]
"""From the paths of the orthoimages that were scanned, and the mosaics, to those that are listed, and who proves
failures by them; None for nobody."""


def write(run: Run, record: InspectionRecord, mosaics: Sequence[RasterRef], proof: Proof) -> dict[str, Any]:
    """Write what is wanted; what can't be written is told, and does not cost the decision.

    ``record``: the decision with what it was read from.
    """
    decision, report = record.decision, run.file_path(REPORT)
    shown = tuple(_readable(run, mosaics)) if run.parameters.get(DEFECTS) or report else ()
    images, prover = proof(scanned_images(decision), shown)
    record = replace(
        record, mosaics=shown, head=stated_head(run), images=listed_images(decision, map(whole_path, images)),
        report=str(report or ""),
    )
    pictures: dict[int, DefectPicture] = {}
    try:
        if shown:
            _cut_pictures(run, record.defects, DefectPictures(shown, decision, prover), pictures)
    finally:  # without its failures a layer would say that there are none, also where the run was stopped
        results = {**_write_defects(run, record, pictures), **_write_sheets(run, decision)}

    from .acceptance_report import save_acceptance_report
    from .quality_document import save_quality_document

    return {
        **results, **run.save(QUALITY, lambda path: save_quality_document(path, record)),
        **run.save(REPORT, lambda path: save_acceptance_report(path, record, pictures)),
    }


def _write_sheets(run: Run, decision: Decision) -> dict[str, Any]:
    layout = column_fields(SHEET_COLUMNS), QgsWkbTypes.Type.MultiPolygon
    sink, destination = _sink(run, SHEETS_OUT, tr("Decided sheets"), decision, *layout)
    if sink is None:
        return {}
    run.write(sink, sheet_features(decision))
    run.style(destination, "decided_sheets")
    return {SHEETS_OUT: destination}


def _sink(
    run: Run, output: str, title: str, decision: Decision, *layout: Any
) -> tuple[QgsFeatureSink | None, str | None]:
    """The sink of a layer and its destination; none where it is not wanted, or can't be written, which is told."""
    try:
        return run.optional_sink(output, *layout, reference_system(decision.delivery.wkt))
    except QgsProcessingException:
        run.tell(messages.RESULT_NOT_WRITTEN(name=title))
        return None, None


def _readable(run: Run, mosaics: Sequence[RasterRef]) -> Iterator[Raster]:
    """The mosaics that pictures can be cut from; those that can't be read are told."""
    for ref in mosaics:
        try:
            yield describe_mosaic(ref)
        except RasterError as error:
            run.tell(error.message.as_warning())


def _write_defects(run: Run, record: InspectionRecord, pictures: Mapping[int, DefectPicture]) -> dict[str, Any]:
    """The layer of failures, with the pictures by their numbers."""
    layout = column_fields(DEFECT_COLUMNS), QgsWkbTypes.Type.MultiLineString
    sink, destination = _sink(run, DEFECTS, tr("Failures"), record.decision, *layout)
    if sink is None:
        return {}
    file = _file_of(str(destination))
    folder = Path(QgsProcessingUtils.generateTempFilename("pictures")) if file is None else (
        file.with_name(f"{file.stem}_pictures")
    )
    paths: dict[int, str] = {}
    try:
        save_pictures(folder, pictures, paths, [path for mosaic in record.mosaics for path in mosaic.ref.paths])
    except SettingsError as error:
        run.tell(error.message.as_warning())
    if file is not None:
        paths = {number: f"{folder.name}/{Path(path).name}" for number, path in paths.items()}
    run.write(sink, defect_features(record.defects, paths))
    run.style(destination, "defects")
    return {DEFECTS: destination}


def _file_of(destination: str) -> Path | None:
    """The file of a layer; None for one in memory or in a database."""
    path = Path(str(QgsProviderRegistry.instance().decodeUri("ogr", destination).get("path") or ""))
    return path.absolute() if path.suffix and os.path.isdir(path.absolute().parent) else None


def _cut_pictures(
    run: Run, defects: Sequence[Defect], maker: DefectPictures, pictures: dict[int, DefectPicture]
) -> None:
    """Cut the pictures of the longest failures. Raises CancelledError when they are not wanted any more."""
    shown = defects[:MOST_PICTURES]
    for done, defect in enumerate(shown):
        if not run.goes_on(done / len(shown)):
            raise CancelledError(messages.PAPER_STOPPED())
        if (picture := maker.of(defect)) is not None:
            pictures[defect.run.number] = picture
    if missing := len(shown) - len(pictures):
        run.tell(messages.PICTURES_MISSING(count=missing))
