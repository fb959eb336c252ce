"""The parameters of the interior orientation of photos, and the words of their choices."""
from __future__ import annotations

from qgis.core import (
    QgsProcessing,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterFile,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterLayer,
)

from ...toolkit.algorithms import parameters as common
from ...toolkit.algorithms.parameters import Described
from ...toolkit.translation import tr
from ..measure import limits

PHOTO, CALIBRATION, TEMPLATE, POSITIONS, MEASURE = "PHOTO", "CALIBRATION", "TEMPLATE", "POSITIONS", "MEASURE"
TEMPLATE_KIND, TEMPLATE_DIRECTION, TEMPLATE_CENTRE, TEMPLATE_TONE = (
    "TEMPLATE_KIND", "TEMPLATE_DIRECTION", "TEMPLATE_CENTRE", "TEMPLATE_TONE"
)
SEARCH, MIN_CORRELATION, SURFACE, MODEL = "SEARCH", "MIN_CORRELATION", "SURFACE", "MODEL"
OUTPUT, PARAMETERS, WORLD_FILE, MEASURES = "OUTPUT", "PARAMETERS", "WORLD_FILE", "MEASURES"

AUTOMATIC = "automatic"
KINDS = (AUTOMATIC, "cross", "dot", "ring with dot", "ring with cross", "wedge")
DIRECTIONS = (AUTOMATIC, "upright", "diagonal")
CENTRES = (AUTOMATIC, "whole", "interrupted")
TONES = (AUTOMATIC, "light on dark", "dark on light")
SURFACES = ("correlation", "brightness")
MODELS = ("affine", "similarity", "projective")

FIGURE_CHOICES = (TEMPLATE_KIND, TEMPLATE_DIRECTION, TEMPLATE_CENTRE)

ADVANCED = {TEMPLATE_DIRECTION, TEMPLATE_CENTRE, TEMPLATE_TONE, SURFACE}


def input_parameters() -> list[Described]:
    point, number = QgsProcessing.SourceType.TypeVectorPoint, QgsProcessingParameterNumber
    return [
        (
            QgsProcessingParameterRasterLayer(PHOTO, tr("Photo")),
            tr(
                "The scan: any raster that GDAL reads, 1 to 16 bit or more; colour is turned to grey. Black is a grey "
                "value though the file calls it nodata."
            ),
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
                "A mark cut out of this photo or one like it, with some ground around. It is used for its own mark "
                "first; marks that look otherwise are measured by drawn ones. A template that looks alike turned by "
                "180 degrees is measured by its own centre, else by its middle."
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
            tr(
                "Off: the positions were measured by hand and are taken as they are; the other marks are measured. One "
                "that lies off by more than a thousandth of the frame fails as a measured mark does."
            ),
        ),
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
        (
            number(SEARCH, tr("Search (mm)"), number.Type.Double, limits.DEFAULT_SEARCH_MM, minValue=0.01),
            tr("How far around a position the mark is looked for."),
        ),
        (
            number(
                MIN_CORRELATION, tr("Smallest correlation"), number.Type.Double, limits.DEFAULT_MIN_CORRELATION,
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


def output_parameters() -> list[Described]:
    point = QgsProcessing.SourceType.TypeVectorPoint
    return [
        (
            QgsProcessingParameterFeatureSink(OUTPUT, tr("Marks"), point),
            tr(
                "A point for each mark of the calibration: column and row (pixel centres at .5), millimetres, "
                "residuals in µm, correlation, status, reason and the photo's name."
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
        (
            QgsProcessingParameterFileDestination(
                MEASURES, tr("MicMac measurement"), tr("XML files (*.xml)"), optional=True, createByDefault=False
            ),
            tr(
                "The measured and given marks as MicMac reads them: save it as Ori-InterneScan/MeasuresIm-PHOTO.xml, "
                "with the photo's whole file name, as in MeasuresIm-114.jpg.xml."
            ),
        ),
        common.report(
            tr("A page with a picture of each mark and the place that was found."),
            tr("HTML files (*.html)"),
            by_default=True,
        ),
    ]
