"""``seaminspector:interiororientation``: the fiducial marks of a scanned photo and its interior orientation."""
from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessing,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterFile,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterLayer,
    QgsWkbTypes,
)
from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP

from ..adapters.text import sentence, tr
from ..core import messages, thresholds
from ..core.errors import PhotoError
from . import groups
from . import parameters as common
from .base import SeamInspectorAlgorithm

if TYPE_CHECKING:
    from ..core.fiducials.calibration import Calibration
    from ..core.fiducials.results import Orientation, Position, Settings
    from ..core.fiducials.templates import CutOut, Shape
    from ..core.photos import Photo
    from ..core.rasters import RasterRef

PHOTO, CALIBRATION, TEMPLATE, POSITIONS, MEASURE = "PHOTO", "CALIBRATION", "TEMPLATE", "POSITIONS", "MEASURE"
TEMPLATE_KIND, TEMPLATE_DIRECTION, TEMPLATE_CENTRE, TEMPLATE_TONE = (
    "TEMPLATE_KIND", "TEMPLATE_DIRECTION", "TEMPLATE_CENTRE", "TEMPLATE_TONE"
)
SEARCH, MIN_CORRELATION, SURFACE, MODEL = "SEARCH", "MIN_CORRELATION", "SURFACE", "MODEL"
OUTPUT, PARAMETERS, WORLD_FILE = "OUTPUT", "PARAMETERS", "WORLD_FILE"
RMS_UM, MARKS, FAILED = "RMS_UM", "MARKS", "FAILED"

AUTOMATIC = "automatic"
KINDS = (AUTOMATIC, "cross", "dot", "ring with dot", "ring with cross", "wedge")
DIRECTIONS = (AUTOMATIC, "upright", "diagonal")
CENTRES = (AUTOMATIC, "whole", "interrupted")
TONES = (AUTOMATIC, "light on dark", "dark on light")
SURFACES = ("correlation", "brightness")
MODELS = ("affine", "similarity", "projective")


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
        for definition, description in (*_inputs(), *_template_choices(), *_settings()):
            self.addDescribed(definition, description, advanced=definition.name() in _ADVANCED)
        for definition, description in _outputs():
            self.addDescribed(definition, description)
        self.addNumbers({
            RMS_UM: tr("Root mean square of the residuals (um)"),
            MARKS: tr("Marks measured or given"),
            FAILED: tr("Marks that failed"),
        })

    def check(self, parameters: dict[str, Any], context: QgsProcessingContext) -> None:
        from ..core.fiducials.calibration import check_calibration

        check_calibration(self._calibration(parameters, context), self._settings(parameters, context).model)
        self._open(common.required_raster(parameters, PHOTO, context))

    def prepare(self, parameters: dict[str, Any], context: QgsProcessingContext) -> None:
        self._photo_ref = common.required_raster(parameters, PHOTO, context)
        self._template_ref = common.raster(parameters, TEMPLATE, context)

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
            parameters, OUTPUT, context, marks.mark_fields(), QgsWkbTypes.Type.Point, crs
        )
        self.write(sink, (marks.mark_feature(mark, photo) for mark in made.marks))
        self._tell(made, feedback)
        failed = made.count(Status.FAILED)
        results: dict[str, Any] = {OUTPUT: destination, MARKS: len(made.marks) - failed, FAILED: failed}
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
            (PARAMETERS, outputs.parameters_text(photo, calibration, made)),
            (WORLD_FILE, outputs.world_file(photo, made)),
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

        path = self.parameterAsFile(parameters, CALIBRATION, context)
        if not path:
            raise PhotoError(messages.NO_CALIBRATION())
        return read_calibration(Path(path))

    def _positions(
        self, parameters: dict[str, Any], context: QgsProcessingContext, photo: Photo
    ) -> dict[str, Position]:
        from ..adapters import layers, marks

        if not parameters.get(POSITIONS):
            return {}
        source = self.source(parameters, POSITIONS, context)
        measure = self.parameterAsBool(parameters, MEASURE, context)
        return marks.positions(layers.features(source), source.fields().names(), photo, measure)

    def _settings(self, parameters: dict[str, Any], context: QgsProcessingContext) -> Settings:
        from ..core.fiducials.measuring import Surface
        from ..core.fiducials.results import Settings
        from ..core.fiducials.transformations import Model

        word = {name: self.parameterAsEnumString(parameters, name, context) for name in (SURFACE, MODEL, TEMPLATE_TONE)}
        return Settings(
            template=self._template(parameters, context),
            shapes=() if parameters.get(TEMPLATE) else self._shapes(parameters, context),
            sign={TONES[1]: 1, TONES[2]: -1}.get(word[TEMPLATE_TONE]),
            search=self.parameterAsDouble(parameters, SEARCH, context),
            least=self.parameterAsDouble(parameters, MIN_CORRELATION, context),
            surface=Surface(word[SURFACE]),
            model=Model(word[MODEL]),
        )

    def _template(self, parameters: dict[str, Any], context: QgsProcessingContext) -> CutOut | None:
        from ..core.fiducials.templates import cut_out

        ref = getattr(self, "_template_ref", None) or common.raster(parameters, TEMPLATE, context)
        return cut_out(self._open(ref).grey()) if ref is not None else None

    def _shapes(self, parameters: dict[str, Any], context: QgsProcessingContext) -> tuple[Shape, ...]:
        from ..core.fiducials.templates import chosen_shapes

        kind, direction, centre = (
            None if word == AUTOMATIC else word
            for word in (
                self.parameterAsEnumString(parameters, name, context)
                for name in (TEMPLATE_KIND, TEMPLATE_DIRECTION, TEMPLATE_CENTRE)
            )
        )
        diagonal = None if direction is None else direction == DIRECTIONS[2]
        interrupted = None if centre is None else centre == CENTRES[2]
        return chosen_shapes(kind, diagonal, interrupted)


_ADVANCED = {TEMPLATE_DIRECTION, TEMPLATE_CENTRE, TEMPLATE_TONE, SURFACE}


def _inputs() -> list[common.Described]:
    point = QgsProcessing.SourceType.TypeVectorPoint
    return [
        (
            QgsProcessingParameterRasterLayer(PHOTO, tr("Photo")),
            tr("The scan: any raster that GDAL reads, 1 to 16 bit or more; colour is turned to grey."),
        ),
        (
            QgsProcessingParameterFile(CALIBRATION, tr("Calibration")),
            tr(
                "The marks of the camera: a CSV with the columns mark, x_mm and y_mm, or MicMac's MeasuresCamera.xml. "
                "x to the right, y upwards. Rows named principal_point, focal_length (in x_mm) and data_strip (a place "
                "in it) are optional."
            ),
        ),
        (
            QgsProcessingParameterRasterLayer(TEMPLATE, tr("Template"), optional=True),
            tr(
                "A mark cut out of this photo or one like it, with some ground around; it takes the place of a drawn "
                "one. A template that looks alike turned by 180 degrees is measured by its own centre, else by its "
                "middle."
            ),
        ),
        (
            QgsProcessingParameterFeatureSource(POSITIONS, tr("Positions"), [point], optional=True),
            tr(
                "Points with the field 'mark', digitised on the photo as QGIS shows it (without a world file x is the "
                "column and y the negative row). Without positions all of the photo is searched. A field 'measure' "
                "with 0 says that a point is the mark itself."
            ),
        ),
        (
            QgsProcessingParameterBoolean(MEASURE, tr("Measure around the positions"), True),
            tr("Off: the positions were measured by hand and are taken as they are; the other marks are measured."),
        ),
    ]


def _template_choices() -> list[common.Described]:
    return [
        (
            common.choice(TEMPLATE_KIND, tr("Kind of mark"), KINDS),
            tr("What is drawn to look for, in the size that the photo has it; automatic tries all."),
        ),
        (
            common.choice(TEMPLATE_DIRECTION, tr("Direction of the arms"), DIRECTIONS),
            tr("Whether the arms of a cross, or the wedges, stand upright or diagonally."),
        ),
        (
            common.choice(TEMPLATE_CENTRE, tr("Centre of the cross"), CENTRES),
            tr("Whether a cross is open in the middle."),
        ),
        (
            common.choice(TEMPLATE_TONE, tr("Tone of the mark"), TONES),
            tr("Whether the mark is lighter than its ground, as on most positives, or darker."),
        ),
    ]


def _settings() -> list[common.Described]:
    number = QgsProcessingParameterNumber
    return [
        (
            number(SEARCH, tr("Search (mm)"), number.Type.Double, thresholds.DEFAULT_SEARCH_MM, minValue=0.01),
            tr("How far around a position the mark is looked for."),
        ),
        (
            number(
                MIN_CORRELATION, tr("Smallest correlation"), number.Type.Double, thresholds.DEFAULT_MIN_CORRELATION,
                minValue=0, maxValue=1,
            ),
            tr("A mark whose best correlation is smaller fails."),
        ),
        (
            common.choice(SURFACE, tr("Surface"), SURFACES),
            tr(
                "What the second-degree surface is laid through: the correlations around the best pixel, or the "
                "brightness of the photo as in the paper."
            ),
        ),
        (
            common.choice(MODEL, tr("Transformation"), MODELS),
            tr("Needs at least 3 (affine), 2 (similarity) or 4 (projective) marks; with more there is a check."),
        ),
    ]


def _outputs() -> list[common.Described]:
    point = QgsProcessing.SourceType.TypeVectorPoint
    return [
        (
            QgsProcessingParameterFeatureSink(OUTPUT, tr("Marks"), point),
            tr(
                "A point for each mark of the calibration: column and row (pixel centres at .5), millimetres, "
                "residuals in um, correlation, status and reason."
            ),
        ),
        (
            QgsProcessingParameterFileDestination(
                PARAMETERS, tr("Parameters"), tr("JSON files (*.json)"), optional=True
            ),
            tr("Both directions of the transformation, pixel size, rotation, shear, principal point and accuracy."),
        ),
        (
            QgsProcessingParameterFileDestination(
                WORLD_FILE, tr("World file"), tr("World files (*.wld *.jgw *.tfw *.pgw *.bpw)"), optional=True,
                createByDefault=False,
            ),
            tr("Saved beside the photo under its name, it lets QGIS open the photo in millimetres."),
        ),
        common.report(
            tr("A page with a picture of each mark and the place that was found."),
            tr("HTML files (*.html)"),
            by_default=True,
        ),
    ]
