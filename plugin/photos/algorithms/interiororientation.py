"""``seaminspector:interiororientation``: the fiducial marks of a scanned photo and its interior orientation."""
from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import QgsCoordinateReferenceSystem, QgsWkbTypes
from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP

from ...imagery import messages as imagery_messages
from ...imagery.errors import PhotoError
from ...toolkit.algorithms import groups
from ...toolkit.algorithms import parameters as common
from ...toolkit.algorithms.base import SeamInspectorAlgorithm
from ...toolkit.algorithms.run import Run
from ...toolkit.translation import filled, sentence, tr
from ..measure import messages
from . import photo_parameters

if TYPE_CHECKING:
    from ...imagery.rasters import RasterRef
    from ..measure.camera_calibration import CameraCalibration
    from ..measure.mark_templates import CutOut, MarkShape
    from ..measure.orientation import GivenPosition, OrientationSettings, PhotoOrientation
    from ..measure.photo import Photo

RMS_UM, MARKS, FAILED = "RMS_UM", "MARKS", "FAILED"


class InteriorOrientation(SeamInspectorAlgorithm):
    """Fiducial marks by correlation and a surface, the transformation by least squares."""

    ID = "interiororientation"
    NAME = QT_TRANSLATE_NOOP("@default", "Interior orientation")
    GROUP = groups.PHOTOS
    HELP = QT_TRANSLATE_NOOP(
        "@default",
        "Measures the fiducial marks of a scanned film photograph and fits the transformation from pixels to "
        "millimetres. A mark is found by normalised cross correlation and measured to a fraction of a pixel by the "
        "extremum of a second-degree surface (Mikrut and Chwastek 2007). A mark that can't be trusted fails with the "
        "reason; point at it on the map and give that point as its position, with the measurement off."
    )
    RASTER_LISTS = ()
    DRAWN = ()

    def initAlgorithm(self, configuration: Any = None) -> None:
        for definition, description in photo_parameters.input_parameters():
            self.addDescribed(definition, description, advanced=definition.name() in photo_parameters.ADVANCED)
        for definition, description in photo_parameters.output_parameters():
            self.addDescribed(definition, description)
        self.addNumbers({
            RMS_UM: tr("Root mean square of the residuals (µm)"),
            MARKS: tr("Marks measured or given"),
            FAILED: tr("Marks that failed"),
        })

    def check(self, run: Run) -> None:
        from ..measure.camera_calibration import check_calibration

        check_calibration(self._calibration(run), self._settings(run).model)
        self._open(run.required_raster(photo_parameters.PHOTO))

    def prepare(self, run: Run) -> None:
        self._photo_ref = run.required_raster(photo_parameters.PHOTO)
        self._template_ref = run.raster(photo_parameters.TEMPLATE)

    def execute(self, run: Run) -> dict[str, Any]:
        from .. import mark_tables
        from ..measure.interior_orientation import orient_photo
        from ..measure.orientation import MarkStatus

        calibration = self._calibration(run)
        photo = self._open(self._photo_ref)
        positions = self._positions(run, photo)
        settings = self._settings(run)
        run.progress(0.05)
        made = orient_photo(photo, calibration, positions, settings, run.is_cancelled)
        run.progress(0.8)
        wkt = photo.raster.wkt
        crs = QgsCoordinateReferenceSystem.fromWkt(wkt) if wkt else QgsCoordinateReferenceSystem()
        sink, destination = run.sink(photo_parameters.OUTPUT, mark_tables.mark_fields(), QgsWkbTypes.Type.Point, crs)
        run.write(sink, (mark_tables.mark_feature(mark, photo) for mark in made.marks))
        run.style(destination, "marks")
        self._tell(made, run)
        failed = made.count(MarkStatus.FAILED)
        results: dict[str, Any] = {photo_parameters.OUTPUT: destination}
        results.update({MARKS: len(made.marks) - failed, FAILED: failed})
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
        from ...imagery.atomic_files import save_text
        from ..measure import orientation_files
        from ..measure.micmac_measures import measures_text
        from ..report import OrientationJob, save_orientation_report

        job = OrientationJob(photo, calibration, Path(run.path(photo_parameters.CALIBRATION)), settings)
        results = run.save(common.REPORT, lambda path: save_orientation_report(path, job, made))
        measures = measures_text(photo.ref.name, made.marks)
        results.update(run.save(photo_parameters.MEASURES, partial(save_text, measures)))
        if made.fitted is None:
            why = made.notices[-1] if made.notices else messages.NO_TRANSFORMATION()
            run.tell(messages.PHOTO_WITHOUT_TRANSFORMATION(name=photo.ref.name, why=why))
            return results
        for name, text in (
            (photo_parameters.PARAMETERS, orientation_files.parameters_text(photo, calibration, made)),
            (photo_parameters.WORLD_FILE, orientation_files.world_file(photo, made)),
        ):
            results.update(run.save(name, partial(save_text, text)))
        return results

    def _tell(self, made: PhotoOrientation, run: Run) -> None:
        run.tell(*made.notices)
        for mark in made.marks:
            if mark.reason is not None:
                run.tell(imagery_messages.ABOUT(what=mark.name, why=mark.reason).as_warning())
        if made.fitted is not None:
            run.inform(
                filled(tr("{marks} marks, {model} model, root mean square of the residuals {rms:.1f} µm."),
                    marks=made.fitted.marks, rms=made.fitted.rms,
                    model=sentence(messages.WORDS[made.fitted.to_mm.model.value]),
                )
            )

    # --- the inputs ---------------------------------------------------------------------------------------------

    @staticmethod
    def _open(ref: RasterRef) -> Photo:
        from ..measure.photo import scanned_photo

        return scanned_photo(ref)

    def _calibration(self, run: Run) -> CameraCalibration:
        from ..measure.camera_calibration import read_calibration

        path = run.path(photo_parameters.CALIBRATION)
        if not path:
            raise PhotoError(messages.NO_CALIBRATION())
        return read_calibration(Path(path))

    def _positions(self, run: Run, photo: Photo) -> dict[str, GivenPosition]:
        from ...toolkit import layers
        from .. import mark_tables

        if not run.parameters.get(photo_parameters.POSITIONS):
            return {}
        source = run.source(photo_parameters.POSITIONS)
        measure = run.flag(photo_parameters.MEASURE)
        return mark_tables.given_positions(layers.features(source), source.fields().names(), photo, measure)

    def _settings(self, run: Run) -> OrientationSettings:
        from ..measure.measuring_marks import SurfaceBasis
        from ..measure.orientation import OrientationSettings
        from ..measure.transformations import PlaneModel

        tone = run.word(photo_parameters.TEMPLATE_TONE)
        return OrientationSettings(
            template=self._template(run),
            shapes=() if run.parameters.get(photo_parameters.TEMPLATE) else self._shapes(run),
            sign={photo_parameters.TONES[1]: 1, photo_parameters.TONES[2]: -1}.get(tone),
            search_mm=run.real(photo_parameters.SEARCH),
            min_correlation=run.real(photo_parameters.MIN_CORRELATION),
            surface=SurfaceBasis(run.word(photo_parameters.SURFACE)),
            model=PlaneModel(run.word(photo_parameters.MODEL)),
        )

    def _template(self, run: Run) -> CutOut | None:
        from ..measure.mark_templates import cut_out

        ref = getattr(self, "_template_ref", None) or run.raster(photo_parameters.TEMPLATE)
        return cut_out(self._open(ref).grey()) if ref is not None else None

    def _shapes(self, run: Run) -> tuple[MarkShape, ...]:
        from ..measure.mark_templates import chosen_shapes

        words = (run.word(name) for name in photo_parameters.FIGURE_CHOICES)
        kind, direction, centre = (None if word == photo_parameters.AUTOMATIC else word for word in words)
        diagonal = None if direction is None else direction == photo_parameters.DIRECTIONS[2]
        interrupted = None if centre is None else centre == photo_parameters.CENTRES[2]
        return chosen_shapes(kind, diagonal, interrupted)
