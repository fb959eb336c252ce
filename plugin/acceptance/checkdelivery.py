"""``seaminspector:checkdelivery``: whether all sheets are there, whole and of the form that was ordered."""
from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import QgsProcessingOutputRasterLayer, QgsProcessingParameterCrs
from qgis.PyQt.QtCore import QT_TR_NOOP

from ..imagery.errors import CancelledError, RasterError, SettingsError
from ..imagery.gdal_paths import is_there
from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.base import SeamInspectorAlgorithm
from ..toolkit.algorithms.run import Run
from ..toolkit.translation import tr
from .measure import messages
from .sheet_index import index_rows

if TYPE_CHECKING:
    from .measure.delivered_files import OrderedForm, OrderedSheet

FOLDER, SHEETS, PATTERN, PIXEL, CRS = "FOLDER", "SHEETS", "PATTERN", "PIXEL", "CRS"
BANDS, DATA_TYPE, MAX_NODATA, OUTPUT, VRT = "BANDS", "DATA_TYPE", "MAX_NODATA", "OUTPUT", "VRT"
SHEET_COUNT, MISSING_COUNT, FAULTY_COUNT, IS_COMPLETE = "SHEET_COUNT", "MISSING_COUNT", "FAULTY_COUNT", "COMPLETE"
DATA_TYPES = ("uint8", "uint16", "int16", "float32")
RASTERS = (".tif", ".tiff", ".jp2", ".img")  # endings of files that are sheets of a delivery


class CheckDelivery(SeamInspectorAlgorithm):
    """What an agency checks by hand before it looks at any picture."""

    ID = "checkdelivery"
    NAME = QT_TR_NOOP("Check a delivery")
    HELP = QT_TR_NOOP(
        "Checks the files of a delivery before their seams: sheets that are missing, were not ordered, have no data "
        "inside their outline, can't be read, or hide each other; pixel size, reference system, bands, type of the "
        "pixels and names. Writes the sheets with their findings, ready for 'Accept or reject a delivery', and one "
        "mosaic over all that were ordered, ready for the scan."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.addDescribed(common.folder(FOLDER, tr("Folder"), optional=True), tr(
            "Folder of the delivered sheets. Empty: the files named in the sheets' field location."
        ))
        self.addDescribed(common.features(SHEETS, tr("Sheets"), common.POLYGON, optional=True), tr(
            "Outlines of the sheets that were ordered, as polygons with a field sheet, name or location. Empty: all "
            "files in the folder count as ordered, and only their form is checked."
        ))
        self.addDescribed(common.words(PATTERN, tr("Pattern of names")), tr(
            "The pattern of file names, with * and ?, such as ortho_????_??.tif. Empty: any name."
        ))
        self.addDescribed(common.real(PIXEL, tr("Pixel size (metres)"), None, 0.0, optional=True, decimals=4), tr(
            "Within 1 %. Empty: that of most sheets."
        ))
        self.addDescribed(QgsProcessingParameterCrs(CRS, tr("Reference system"), optional=True), tr(
            "Empty: that of most sheets."
        ))
        self.addDescribed(common.whole(BANDS, tr("Bands"), None, 1, optional=True), tr(
            "Number of bands without alpha. Empty: that of most sheets."
        ))
        self.addDescribed(common.choice(DATA_TYPE, tr("Type of the pixels"), DATA_TYPES, None, optional=True), tr(
            "8 bit is uint8, 16 bit uint16. Empty: that of most sheets."
        ))
        self.addDescribed(common.real(MAX_NODATA, tr("Largest share without data (%)"), 0.0, 0.0), tr(
            "Share of a sheet's outline."
        ), advanced=True)
        self.addDescribed(common.result(OUTPUT, tr("Checked sheets"), common.POLYGON), tr(
            "Each sheet with its file, its findings, and whether it has none."
        ))
        self.addDescribed(common.made_file(VRT, tr("Mosaic of all sheets"), "VRT (*.vrt)"), tr(
            "A virtual mosaic over the ordered sheets that fit together; nothing is copied."
        ))
        self.addOutput(QgsProcessingOutputRasterLayer(common.MOSAIC, tr("Mosaic of all sheets")))
        self.addNumbers({
            SHEET_COUNT: tr("Number of sheets"),
            MISSING_COUNT: tr("Sheets without a file"),
            FAULTY_COUNT: tr("Sheets with findings"),
            IS_COMPLETE: tr("Complete (1) or not (0)"),
        })

    def check(self, run: Run) -> None:
        if not run.path(FOLDER) and not run.parameters.get(SHEETS):
            raise SettingsError(messages.NO_DELIVERY())

    def prepare_run(self, run: Run) -> None:
        from ..toolkit.layers import layer_path

        self.check(run)
        layer = run.vector_layer(SHEETS) if run.parameters.get(SHEETS) else None
        self._index = layer_path(layer) if layer is not None else ""

    def execute(self, run: Run) -> dict[str, Any]:
        from .checked_layer import write_checked
        from .measure.delivered_files import build_mosaic, checked_sheets, fitting

        def tell(share: float) -> None:
            if not run.goes_on(share):
                raise CancelledError(messages.CHECK_STOPPED())

        checked = checked_sheets(self._sheets(run), _form(run), tell)
        faulty = [sheet for sheet in checked if sheet.findings]
        for sheet in faulty:
            run.tell(*(messages.SHEET_FINDING(sheet=sheet.sheet.name, finding=finding) for finding in sheet.findings))
        missing = sum(not sheet.sheet.path for sheet in checked)
        run.tell(messages.DELIVERY_CHECKED(count=len(checked), faulty=len(faulty), missing=missing))
        results: dict[str, Any] = {OUTPUT: write_checked(run, OUTPUT, checked)}
        path, whole = run.file_path(VRT), fitting(checked)
        if path is not None and whole:
            try:
                build_mosaic(str(path), whole)
                results[VRT] = results[common.MOSAIC] = str(path)
            except RasterError as error:
                run.tell(error.message)
        return {
            **results, SHEET_COUNT: len(checked), MISSING_COUNT: missing, FAULTY_COUNT: len(faulty),
            IS_COMPLETE: int(not faulty),
        }

    def _sheets(self, run: Run) -> list[OrderedSheet]:
        """Raises SettingsError where there is neither a sheet nor a file."""
        from .measure.delivered_files import OrderedSheet
        from .measure.delivery import in_words

        folder, is_ordered = run.path(FOLDER), bool(run.parameters.get(SHEETS))
        folder = folder and os.path.abspath(folder)  # what is written names the files from anywhere
        paths = Path(folder).glob("**/*" if is_ordered else "*") if folder else ()  # an index also names those deeper
        files = sorted(path for path in paths if path.suffix.lower() in RASTERS)
        sheets, homes = [], {Path(folder)}
        for name, path, outline, wkt in index_rows(run, SHEETS, self._index) if is_ordered else ():
            file = _of_stem(files, Path(path or name).stem) if folder else None
            place = str(file or path) if file is not None or not folder else ""
            sheets.append(OrderedSheet(name, place if is_there(place) else "", outline, wkt))
            if file is not None:
                files.remove(file)
                homes.add(file.parent)
        beside = (path for path in files if path.parent in homes)
        sheets += [OrderedSheet(path.stem, str(path), None, "", not is_ordered) for path in beside]
        if not sheets:
            raise SettingsError(messages.NO_SHEETS(folder=folder))
        return sorted(sheets, key=lambda sheet: in_words(sheet.name))


def _of_stem(files: Sequence[Path], stem: str) -> Path | None:
    """The first file that is called so, whatever its ending and its capitals; tables of numbers lose zeros in front."""
    names = (str.lower, lambda name: name.lower().lstrip("0"))
    return next((path for name in names for path in files if name(path.stem) == name(stem)), None)


def _form(run: Run) -> OrderedForm:
    from ..toolkit.layers import system_wkt
    from .measure.delivered_files import OrderedForm

    return OrderedForm(
        run.real(PIXEL) or None if run.parameters.get(PIXEL) is not None else None,
        system_wkt(run.crs(CRS)) if run.parameters.get(CRS) else "",
        run.whole(BANDS) if run.parameters.get(BANDS) is not None else None,
        run.word(DATA_TYPE), run.text(PATTERN).strip(), run.real(MAX_NODATA) / 100,
    )  # fmt: skip
