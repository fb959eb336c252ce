"""``seaminspector:interiororientation``: the fiducial marks of a scanned photo and its interior orientation."""
from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsWkbTypes,
)
from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP

from ..adapters.text import sentence, tr
from ..core import messages
from ..core.errors import PhotoError
from . import groups, photos
from . import parameters as common
from .base import SeamInspectorAlgorithm

if TYPE_CHECKING:
    from ..core.fiducials.calibration import Calibration
    from ..core.fiducials.results import Orientation, Position, Settings
    from ..core.fiducials.templates import CutOut, Shape
    from ..core.photos import Photo
    from ..core.rasters import RasterRef

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
        for definition, description in (*photos.inputs(), *photos.template_choices(), *photos.settings()):
            self.addDescribed(definition, description, advanced=definition.name() in photos.ADVANCED)
        for definition, description in photos.outputs():
            self.addDescribed(definition, description)
        self.addNumbers({
            RMS_UM: tr("Root mean square of the residuals (um)"),
            MARKS: tr("Marks measured or given"),
            FAILED: tr("Marks that failed"),
        })

    def check(self, parameters: dict[str, Any], context: QgsProcessingContext) -> None:
        from ..core.fiducials.calibration import check_calibration

        check_calibration(self._calibration(parameters, context), self._settings(parameters, context).model)
        self._open(common.required_raster(parameters, photos.PHOTO, context))

    def prepare(self, parameters: dict[str, Any], context: QgsProcessingContext) -> None:
        self._photo_ref = common.required_raster(parameters, photos.PHOTO, context)
        self._template_ref = common.raster(parameters, photos.TEMPLATE, context)

    def execute(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        from ..adapters import marks
        from ..core.fiducials.interior import orient
        from ..core.fiducials.results import Status

        calibration = self._calibration(parameters, context)
        photo = self._open(self._photo_ref)
        positions = self._positions(parameters, context, photo)
        settings = self._settings(parameters, context)
        feedback.setProgress(5)
        made = orient(photo, calibration, positions, settings, feedback.isCanceled)
        feedback.setProgress(80)
        crs = QgsCoordinateReferenceSystem.fromWkt(photo.wkt) if photo.wkt else QgsCoordinateReferenceSystem()
        sink, destination = self.sink(
            parameters, photos.OUTPUT, context, marks.mark_fields(), QgsWkbTypes.Type.Point, crs
        )
        self.write(sink, (marks.mark_feature(mark, photo) for mark in made.marks))
        self._tell(made, feedback)
        failed = made.count(Status.FAILED)
        results: dict[str, Any] = {photos.OUTPUT: destination, MARKS: len(made.marks) - failed, FAILED: failed}
        if made.fitted is not None and made.fitted.redundancy:
            results[RMS_UM] = made.fitted.rms
        results.update(self._files(parameters, context, feedback, photo, calibration, made))
        feedback.setProgress(100)
        return results

    def _files(
        self,
        parameters: dict[str, Any],
        context: QgsProcessingContext,
        feedback: QgsProcessingFeedback,
        photo: Photo,
        calibration: Calibration,
        made: Orientation,
    ) -> dict[str, Any]:
        """Write the files asked for; without a transformation the report alone, and say so."""
        from ..adapters.mark_report import orientation_page
        from ..core.fiducials import outputs
        from ..core.report import save_page

        results: dict[str, Any] = {}
        path = self.file_path(parameters, common.REPORT, context)
        if path is not None:
            save_page(orientation_page(photo, made), path)
            results[common.REPORT] = str(path)
        if made.fitted is None:
            why = made.notices[-1] if made.notices else messages.NO_TRANSFORMATION()
            feedback.reportError(sentence(messages.PHOTO_WITHOUT_TRANSFORMATION(name=photo.ref.name, why=why)))
            return results
        for name, text in (
            (photos.PARAMETERS, outputs.parameters_text(photo, calibration, made)),
            (photos.WORLD_FILE, outputs.world_file(photo, made)),
        ):
            path = self.file_path(parameters, name, context)
            if path is not None:
                outputs.save(text, path)
                results[name] = str(path)
        return results

    def _tell(self, made: Orientation, feedback: QgsProcessingFeedback) -> None:
        for notice in made.notices:
            feedback.pushWarning(sentence(notice))
        for mark in made.marks:
            if mark.reason is not None:
                feedback.pushWarning(f"{mark.name}: {sentence(mark.reason)}")
        if made.fitted is not None:
            feedback.pushInfo(
                tr("{marks} marks, {model} model, root mean square of the residuals {rms:.1f} um.").format(
                    marks=made.fitted.marks, model=made.fitted.to_mm.model.value, rms=made.fitted.rms
                )
            )

    # --- the inputs ---------------------------------------------------------------------------------------------

    @staticmethod
    def _open(ref: RasterRef) -> Photo:
        from ..core.photos import Photo

        return Photo(ref)

    def _calibration(self, parameters: dict[str, Any], context: QgsProcessingContext) -> Calibration:
        from ..core.fiducials.calibration import read_calibration

        path = self.parameterAsFile(parameters, photos.CALIBRATION, context)
        if not path:
            raise PhotoError(messages.NO_CALIBRATION())
        return read_calibration(Path(path))

    def _positions(
        self, parameters: dict[str, Any], context: QgsProcessingContext, photo: Photo
    ) -> dict[str, Position]:
        from ..adapters import layers, marks

        if not parameters.get(photos.POSITIONS):
            return {}
        source = self.source(parameters, photos.POSITIONS, context)
        measure = self.parameterAsBool(parameters, photos.MEASURE, context)
        return marks.positions(layers.features(source), source.fields().names(), photo, measure)

    def _settings(self, parameters: dict[str, Any], context: QgsProcessingContext) -> Settings:
        from ..core.fiducials.measuring import Surface
        from ..core.fiducials.results import Settings
        from ..core.fiducials.transformations import Model

        surface, model, tone = (
            self.parameterAsEnumString(parameters, name, context)
            for name in (photos.SURFACE, photos.MODEL, photos.TEMPLATE_TONE)
        )
        return Settings(
            template=self._template(parameters, context),
            shapes=() if parameters.get(photos.TEMPLATE) else self._shapes(parameters, context),
            sign={photos.TONES[1]: 1, photos.TONES[2]: -1}.get(tone),
            search=self.parameterAsDouble(parameters, photos.SEARCH, context),
            least=self.parameterAsDouble(parameters, photos.MIN_CORRELATION, context),
            surface=Surface(surface),
            model=Model(model),
        )

    def _template(self, parameters: dict[str, Any], context: QgsProcessingContext) -> CutOut | None:
        from ..core.fiducials.templates import cut_out

        ref = getattr(self, "_template_ref", None) or common.raster(parameters, photos.TEMPLATE, context)
        return cut_out(self._open(ref).grey()) if ref is not None else None

    def _shapes(self, parameters: dict[str, Any], context: QgsProcessingContext) -> tuple[Shape, ...]:
        from ..core.fiducials.templates import chosen_shapes

        kind, direction, centre = (
            None if word == photos.AUTOMATIC else word
            for word in (
                self.parameterAsEnumString(parameters, name, context)
                for name in (photos.TEMPLATE_KIND, photos.TEMPLATE_DIRECTION, photos.TEMPLATE_CENTRE)
            )
        )
        diagonal = None if direction is None else direction == photos.DIRECTIONS[2]
        interrupted = None if centre is None else centre == photos.CENTRES[2]
        return chosen_shapes(kind, diagonal, interrupted)
