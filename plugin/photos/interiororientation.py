"""``seaminspector:interiororientation``: the fiducial marks of a scanned photo and its interior orientation."""
from __future__ import annotations

import json
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import QgsWkbTypes
from qgis.PyQt.QtCore import QT_TR_NOOP

from ..imagery import messages as imagery_messages
from ..imagery.errors import PhotoError
from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.base import INTERIOR_ORIENTATION, SeamInspectorAlgorithm
from ..toolkit.algorithms.run import Run
from ..toolkit.reference_systems import reference_system
from ..toolkit.translation import filled, sentence, tr
from .measure import limits, messages

if TYPE_CHECKING:
    from .measure.camera_calibration import CameraCalibration
    from .measure.orientation import GivenPosition, OrientationSettings, PhotoOrientation
    from .measure.photo import Photo

PHOTO, CALIBRATION, TEMPLATE, POSITIONS, MEASURE = "PHOTO", "CALIBRATION", "TEMPLATE", "POSITIONS", "MEASURE"
TEMPLATE_KIND, TEMPLATE_DIRECTION, TEMPLATE_CENTRE, TEMPLATE_TONE = (
    "TEMPLATE_KIND", "TEMPLATE_DIRECTION", "TEMPLATE_CENTRE", "TEMPLATE_TONE"
)
SEARCH, MIN_CORRELATION, SURFACE, MODEL = "SEARCH", "MIN_CORRELATION", "SURFACE", "MODEL"
OUTPUT, PARAMETERS, WORLD_FILE, MEASURES = "OUTPUT", "PARAMETERS", "WORLD_FILE", "MEASURES"

AUTOMATIC = "automatic"
KINDS = (AUTOMATIC, *limits.KINDS)
DIRECTIONS = (AUTOMATIC, "upright", "diagonal")
CENTRES = (AUTOMATIC, "whole", "interrupted")
TONES = (AUTOMATIC, "light on dark", "dark on light")

RMS_UM, MARKS, FAILED = "RMS_UM", "MARKS", "FAILED"


class InteriorOrientation(SeamInspectorAlgorithm):
    """Fiducial marks by correlation and a surface, the transformation by least squares."""

    ID = "interiororientation"
    NAME = QT_TR_NOOP("Interior orientation")
    GROUP = INTERIOR_ORIENTATION
    HELP = QT_TR_NOOP(
        "Measures the fiducial marks of a scanned film photograph and fits the transformation from pixels to "
        "millimetres. A mark is found by normalised cross correlation and measured to a fraction of a pixel by the "
        "extremum of a second-degree surface (Mikrut and Chwastek 2007). A mark that can't be trusted fails with the "
        "reason; point at it on the map and give that point as its position, with the measurement off."
    )
    DRAWN = ()

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.addDescribed(common.raster(PHOTO, tr("Photo")), tr(
            "The scan: any raster that GDAL reads, 1 to 16 bit or more; colour is turned to grey. Black is a grey "
            "value even if the file calls it nodata."
        ))
        self.addDescribed(common.file(CALIBRATION, tr("Calibration")), tr(
            "The marks of the camera: a CSV with the columns mark, x_mm and y_mm, or MicMac's MeasuresCamera.xml. x to "
            "the right, y upwards. Rows named principal_point, focal_length (in x_mm) and data_strip (a place in it) "
            "are optional."
        ))
        self.addDescribed(common.raster(TEMPLATE, tr("Template"), optional=True), tr(
            "A mark cut out of this photo or one like it, with some ground around. It is used for its own mark first; "
            "marks that look different are measured by drawn ones. A template that looks the same when turned by 180 "
            "degrees is measured by its centre of symmetry, else by its middle."
        ))
        self.addDescribed(common.features(POSITIONS, tr("Positions"), common.POINT, optional=True), tr(
            "Points with the field 'mark', digitised on the photo as QGIS shows it (without a world file x is the "
            "column and y the negative row). Without positions all of the photo is searched. A field 'measure' with 0 "
            "says that a point is the mark itself."
        ))
        self.addDescribed(common.flag(MEASURE, tr("Measure around the positions"), True), tr(
            "Off: the positions were measured by hand and are taken as they are; the other marks are measured. One "
            "that is off by more than a thousandth of the frame fails like a measured mark."
        ))
        for name, title, words, text, advanced in (
            (TEMPLATE_KIND, tr("Kind of mark"), KINDS,
             tr("The shape to look for, in the size it has on the photo; automatic tries all."), False),
            (TEMPLATE_DIRECTION, tr("Direction of the arms"), DIRECTIONS,
             tr("Whether the arms of a cross, or the wedges, stand upright or diagonally."), True),
            (TEMPLATE_CENTRE, tr("Centre of the cross"), CENTRES, tr("Whether a cross is open in the middle."), True),
            (TEMPLATE_TONE, tr("Tone of the mark"), TONES,
             tr("Whether the mark is lighter than its ground, as on most positives, or darker."), True),
        ):  # fmt: skip
            self.addDescribed(common.choice(name, title, words), text, advanced)
        self.addDescribed(common.real(SEARCH, tr("Search (mm)"), limits.DEFAULT_SEARCH_MM, 0.01, decimals=None), tr(
            "How far around a position the mark is looked for."
        ))
        usual = limits.DEFAULT_MIN_CORRELATION
        least = common.real(MIN_CORRELATION, tr("Smallest correlation"), usual, 0, 1, decimals=None)
        self.addDescribed(least, tr("A mark whose best correlation is smaller fails."))
        self.addDescribed(common.choice(SURFACE, tr("Surface"), limits.SURFACES), tr(
            "What the second-degree surface is laid through: the correlations around the best pixel, or the brightness "
            "of the photo as in the paper."
        ), advanced=True)
        self.addDescribed(common.choice(MODEL, tr("Transformation"), limits.MODELS), tr(
            "Needs at least 3 (affine), 2 (similarity) or 4 (projective) marks; with more there is a check."
        ))
        self.addDescribed(common.result(OUTPUT, tr("Marks"), common.POINT), tr(
            "A point for each mark of the calibration: column and row (pixel centres at .5), millimetres, residuals in "
            "µm, correlation, status, reason and the photo's name."
        ))
        for name, title, filters, text in (
            (PARAMETERS, tr("Parameters"), tr("JSON files (*.json)"),
             tr("Both directions of the transformation, pixel size, rotation, shear, principal point and accuracy.")),
            (WORLD_FILE, tr("World file"), tr("World files (*.wld *.jgw *.tfw *.pgw *.bpw)"),
             tr("Saved beside the photo under its name, it lets QGIS open the photo in millimetres.")),
            (MEASURES, tr("MicMac measurement"), tr("XML files (*.xml)"),
             tr("The measured and given marks as MicMac reads them: save it as Ori-InterneScan/MeasuresIm-PHOTO.xml, "
                "with the photo's whole file name, as in MeasuresIm-114.jpg.xml.")),
        ):  # fmt: skip
            self.addDescribed(common.made_file(name, title, filters, True, name == PARAMETERS), text)
        self.addDescribed(*common.report(tr(
            "A page with a picture of each mark and the place that was found."
        ), tr("HTML files (*.html)"), True))
        self.addNumbers({
            RMS_UM: tr("Root mean square of the residuals (µm)"), MARKS: tr("Marks measured or given"),
            FAILED: tr("Marks that failed"),
        })

    def check(self, run: Run) -> None:
        from .measure.camera_calibration import check_calibration
        from .measure.photo import scanned_photo

        check_calibration(self._calibration(run), self._settings(run).model)
        scanned_photo(run.required_raster(PHOTO))

    def prepare_run(self, run: Run) -> None:
        self._photo_ref = run.required_raster(PHOTO)
        self._template_ref = run.raster(TEMPLATE)

    def execute(self, run: Run) -> dict[str, Any]:
        from ..toolkit import layers
        from . import mark_tables
        from .measure.interior_orientation import orient_photo
        from .measure.photo import scanned_photo

        calibration = self._calibration(run)
        photo = scanned_photo(self._photo_ref)
        positions: dict[str, GivenPosition] = {}
        if run.parameters.get(POSITIONS):
            source = run.source(POSITIONS)
            names, is_measured = source.fields().names(), run.flag(MEASURE)
            positions = mark_tables.given_positions(layers.features(source), names, photo, is_measured)
        settings = self._settings(run)
        run.progress(0.05)
        made = orient_photo(photo, calibration, positions, settings, run.is_cancelled)
        run.progress(0.8)
        crs = reference_system(photo.raster.wkt)
        sink, destination = run.sink(OUTPUT, mark_tables.mark_fields(), QgsWkbTypes.Type.Point, crs)
        run.write(sink, (mark_tables.mark_feature(mark, photo) for mark in made.marks))
        run.style(destination, "marks")
        self._tell(made, run)
        failed = made.count(limits.FAILED)
        results: dict[str, Any] = {OUTPUT: destination, MARKS: len(made.marks) - failed, FAILED: failed}
        if made.fitted is not None and made.fitted.redundancy:
            results[RMS_UM] = made.fitted.rms
        results.update(self._files(run, photo, calibration, settings, made))
        run.progress(1)
        return results

    def _files(
        self, run: Run, photo: Photo, calibration: CameraCalibration, settings: OrientationSettings,
        made: PhotoOrientation,
    ) -> dict[str, Any]:
        """Write the files asked for; without a transformation those of the marks alone, and say so."""
        from ..imagery.atomic_files import save_text
        from .measure import orientation
        from .report import OrientationJob, save_orientation_report

        job = OrientationJob(photo, calibration, Path(run.path(CALIBRATION)), settings)
        results = run.save(common.REPORT, lambda path: save_orientation_report(path, job, made))
        measures = orientation.measures_text(photo.ref.name, made.marks)
        results.update(run.save(MEASURES, partial(save_text, measures)))
        if made.fitted is None:
            why = made.notices[-1] if made.notices else messages.NO_TRANSFORMATION()
            run.tell(messages.PHOTO_WITHOUT_TRANSFORMATION(name=photo.ref.name, why=why))
            return results
        known = orientation.parameters(photo, calibration, made)
        text = json.dumps(known, indent=2, ensure_ascii=False) + "\n"
        results.update(run.save(PARAMETERS, partial(save_text, text)))
        results.update(run.save(WORLD_FILE, partial(save_text, orientation.world_file(made))))
        return results

    def _tell(self, made: PhotoOrientation, run: Run) -> None:
        run.tell(*made.notices)
        for mark in made.marks:
            if mark.reason is not None:
                run.tell(imagery_messages.ABOUT(what=mark.name, why=mark.reason).as_warning())
        if made.fitted is not None:
            words = tr("{marks} marks, {model} model, root mean square of the residuals {rms:.1f} µm.")
            model = sentence(messages.WORDS[made.fitted.to_mm.model])
            run.feedback.pushInfo(filled(words, marks=made.fitted.marks, rms=made.fitted.rms, model=model))

    def _calibration(self, run: Run) -> CameraCalibration:
        from .measure.camera_calibration import read_calibration

        path = run.path(CALIBRATION)
        if not path:
            raise PhotoError(messages.NO_CALIBRATION())
        return read_calibration(Path(path))

    def _settings(self, run: Run) -> OrientationSettings:
        from .measure.mark_templates import chosen_shapes, cut_out
        from .measure.orientation import OrientationSettings
        from .measure.photo import scanned_photo

        template = getattr(self, "_template_ref", None) or run.raster(TEMPLATE)
        kind, direction, centre = (run.word(name) for name in (TEMPLATE_KIND, TEMPLATE_DIRECTION, TEMPLATE_CENTRE))
        shapes = chosen_shapes(
            None if kind == AUTOMATIC else kind,
            None if direction == AUTOMATIC else direction == DIRECTIONS[2],
            None if centre == AUTOMATIC else centre == CENTRES[2],
        )
        return OrientationSettings(
            template=cut_out(scanned_photo(template).grey()) if template is not None else None,
            shapes=() if run.parameters.get(TEMPLATE) else shapes,
            sign={TONES[1]: 1, TONES[2]: -1}.get(run.word(TEMPLATE_TONE)),
            search_mm=run.real(SEARCH),
            min_correlation=run.real(MIN_CORRELATION),
            surface=run.word(SURFACE),
            model=run.word(MODEL),
        )
