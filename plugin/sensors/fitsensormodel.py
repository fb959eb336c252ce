"""``seaminspector:fitsensormodel``, ``seaminspector:comparesensormodels`` and ``seaminspector:planpoints``: one sensor
model, or all of them, from ground control points, and the accuracy to expect from points that are not measured yet."""
from __future__ import annotations

import math
import re
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import QgsCoordinateReferenceSystem, QgsProcessingOutputString, QgsProcessingParameterString, QgsWkbTypes
from qgis.PyQt.QtCore import QT_TR_NOOP

from ..imagery.errors import SensorModelError, SettingsError
from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.run import Run
from ..toolkit.reference_systems import reference_system
from ..toolkit.table_fields import column_features, column_fields, table_fields
from ..toolkit.translation import filled, sentence, tr
from .measure import limits, messages, registry
from .sensor_parameters import IMAGE_RPC, ORBIT_HEIGHT, ROBUST, TERRAIN_ERROR, SensorAlgorithm, view_numbers

if TYPE_CHECKING:
    from ..imagery.errors import Message
    from .measure.point_planning import PlannedScene
    from .measure.registry import ModelRequest
    from .point_tables import SensorInputs

MOST_PLANNED = 1000  # points

MODEL, ORDER, DLT_XY, BIAS = "MODEL", "ORDER", "DLT_XY", "BIAS"
OUTPUT, MODEL_FILE, RPC, RPC_IMAGE, POINTS = "OUTPUT", "MODEL_FILE", "RPC", "RPC_IMAGE", "POINTS"
CONTROL_COUNT, CHECK_COUNT, CONDITION = "CONTROL_COUNT", "CHECK_COUNT", "CONDITION"
BIAS_COLUMN, BIAS_ROW = "BIAS_COLUMN", "BIAS_ROW"
RECOMMENDED, RECOMMENDATION, MODEL_COUNT = "RECOMMENDED", "RECOMMENDATION", "MODEL_COUNT"
COUNTS, SPREAD, CORNER_SHARE, SIGMA, SIGMA_PX = "COUNTS", "SPREAD", "CORNER_SHARE", "SIGMA", "SIGMA_PX"
LOWEST, HIGHEST, VIEW_ANGLE, PIXEL_SIZE, SIDE, SEED = "LOWEST", "HIGHEST", "VIEW_ANGLE", "PIXEL_SIZE", "SIDE", "SEED"
_MODELS = tuple(f"{kind.name} {variant.name}".strip() for kind in registry.KINDS.values() for variant in kind.variants)
_BIASES = tuple(variant.name for variant in registry.RPC_BIAS.variants)
_ERRORS = ("RMSE_X", "RMSE_Y", "MAX_X", "MAX_Y")
MODEL_TITLES = {
    "polynomial_2d": QT_TR_NOOP("polynomials of the plane, as in a georeferencer, without heights"),
    "polynomial_3d": QT_TR_NOOP("polynomials of space, without physics"),
    "rational": QT_TR_NOOP("quotients of polynomials as in an RPC, without physics"),
    "rational_terms": QT_TR_NOOP("quotients of order 2 at most, without the terms that the points do not support"),
    "dlt": QT_TR_NOOP("the direct linear transformation, without physics"),
    "pushbroom": QT_TR_NOOP("the parametric model of a line scanner"),
    "rpc_bias": QT_TR_NOOP("the RPC that came with the image, corrected"),
}
"""Titles by the model's name in the registry; a test looks that every model has its entry."""


class FitSensorModel(SensorAlgorithm):
    """A model between ground and image, fitted to control points and judged on check points."""

    ID = "fitsensormodel"
    NAME = QT_TR_NOOP("Fit sensor model")
    HELP = QT_TR_NOOP(
        "Fits the geometry of a satellite image to ground control points and judges it on check points that the fit "
        "does not use (Kurczynski and Wolniewicz). The result is a model file and an RPC for orthorectification."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.addPoints()
        purpose = " ".join(map(_described, registry.KINDS.values()))
        self.addDescribed(common.choice(MODEL, tr("Model"), tuple(registry.KINDS), registry.RATIONAL.name), purpose)
        self.addDescribed(common.whole(ORDER, tr("Order"), 1, 1, 3), tr(
            "For polynomials and quotients. Higher orders need many points and oscillate between them."
        ))
        self.addDescribed(common.flag(DLT_XY, tr("Term a12 xy of the direct linear transformation")), tr(
            "Adds one unknown to dlt, the product of column and row in the equation of the row (Fraser 2000)."
        ))
        self.addDescribed(common.choice(BIAS, tr("Correction of the RPC"), _BIASES), tr(
            "For rpc_bias: a shift in the image, with a drift along the lines, or an affine change of the image."
        ))
        self.addFittingParameters()
        self.addTerrainError()
        self.addDescribed(common.result(OUTPUT, tr("Residuals"), common.POINT), tr(
            "The points with residuals, model minus measured: in pixels, and in metres at the point's height."
        ))
        for name, label, filters, purpose in (
            (MODEL_FILE, tr("Model file"), tr("Model files (*.json)"), tr("The whole model, for orthorectification.")),
            (RPC, tr("RPC"), tr("RPC files (*.txt *.TXT *.rpb *.RPB)"),
             tr("The model as RPC. GDAL reads it beside image.tif under the name image_RPC.TXT or image.RPB.")),
            (RPC_IMAGE, tr("Image with the RPC"), tr("GeoTIFF files (*.tif *.tiff *.TIF *.TIFF)"),
             tr("A copy of the image that carries the model as RPC in its tags, and no other georeference.")),
            (POINTS, tr("Points for the georeferencer"), tr("GCP files (*.points)"),
             tr("The points with their residuals in pixels; check points and blunders are switched off.")),
        ):  # fmt: skip
            self.addDescribed(common.made_file(name, label, filters, optional=True, by_default=False), purpose)
        report = tr("Accuracy, warnings and a plot of the residuals.")
        self.addDescribed(*common.report(report, tr("HTML files (*.html)")))
        for group, label in (("CHECK", tr("check points")), ("CONTROL", tr("control points"))):
            for error in _ERRORS:
                kind = tr("Root mean square") if error.startswith("RMSE") else tr("Largest error")
                words = filled(tr("{kind} in {axis}, {group} (m)"), kind=kind, axis=error[-1], group=label)
                self.addNumbers({f"{group}_{error}": words})
        self.addViewNumbers()
        self.addNumbers({
            CONTROL_COUNT: tr("Control points used"), CHECK_COUNT: tr("Check points used"),
            CONDITION: tr("Condition number"),
            BIAS_COLUMN: tr("Correction of the RPC in the middle of the image, columns (px)"),
            BIAS_ROW: tr("Correction of the RPC in the middle of the image, rows (px)"),
        })

    def execute(self, run: Run) -> dict[str, Any]:
        from . import point_tables
        from .measure.adjustment import adjust
        from .measure.fit_files import FitFiles, view_direction
        from .measure.points import control_coverage

        given = point_tables.SensorInputs(run, *self._prepared, IMAGE_RPC)
        request = self._request(run, given)
        points = given.read_points(request)
        done = adjust(request, points, run.flag(ROBUST))
        box = given.box(points)
        coverage = control_coverage(points.image[~points.check & ~done.blunder], box)
        notices = done.notices + coverage.notices

        def tell(notice: Message) -> None:
            notices.append(notice)
            run.tell(notice)

        files = FitFiles(done, given.image, box, run.is_cancelled, tell)
        column, row = None, None
        if files.rpc_bias is not None:
            (column, row), *_ = biases = files.rpc_bias.tolist()
            most = max(math.hypot(*bias) for bias in biases)
            notices.append(messages.RPC_BIAS_FOUND(columns=column, rows=row, most=most))
        view = view_direction(done.fitted.model, points.wkt, files.domain, run.real(TERRAIN_ERROR))
        if view is not None:
            notices.append(view.notice)
        run.tell(*notices)
        run.progress(0.6)
        system = reference_system(points.wkt)
        crs = system if system.isValid() else QgsCoordinateReferenceSystem(points.wkt)
        sink, output = run.sink(OUTPUT, table_fields(*point_tables.RESIDUALS), QgsWkbTypes.Type.Point, crs)
        run.write(sink, point_tables.residual_features(done))

        def write_report(path: Path) -> None:
            from .report import save_fit_report

            save_fit_report(path, done, coverage, box, notices)

        results: dict[str, Any] = {OUTPUT: output}
        for name, write in (
            (MODEL_FILE, files.save_model), (RPC, files.save_rpc), (RPC_IMAGE, files.save_rpc_image),
            (POINTS, files.save_points), (common.REPORT, write_report),
        ):  # fmt: skip
            results.update(run.save(name, write))
        for group, title, errors in (
            ("CHECK", tr("Check points"), done.check), ("CONTROL", tr("Control points"), done.control)
        ):  # fmt: skip
            results[f"{group}_COUNT"] = errors.count
            for name in _ERRORS:
                results[f"{group}_{name}"] = getattr(errors, name.lower())
            if errors.count:
                words = tr(
                    "{name}: {count}, root mean square X {x:.3f} m, Y {y:.3f} m, largest X {max_x:.3f} m, Y "
                    "{max_y:.3f} m"
                )
                sides = {"x": errors.rmse_x, "y": errors.rmse_y, "max_x": errors.max_x, "max_y": errors.max_y}
                run.feedback.pushInfo(filled(words, name=title, count=errors.count, **sides))
        condition = done.fitted.condition if math.isfinite(done.fitted.condition) else None
        return {**results, CONDITION: condition, **view_numbers(view), BIAS_COLUMN: column, BIAS_ROW: row}

    @staticmethod
    def _request(run: Run, given: SensorInputs) -> ModelRequest:
        kind = registry.KINDS[run.text(MODEL)]
        if given.rpc is None and kind.corrects_rpc:
            raise SensorModelError(messages.NO_RPC())
        words = str(run.whole(ORDER)), run.text(BIAS), "xy" if run.flag(DLT_XY) else ""
        rpc = given.rpc if kind.corrects_rpc else None
        return kind.request(*words, orbit_height_m=given.orbit_height_m, size=given.size, rpc=rpc)


class CompareSensorModels(SensorAlgorithm):
    """Every model that the points allow, in one table, with a recommendation."""

    ID = "comparesensormodels"
    NAME = QT_TR_NOOP("Compare sensor models")
    HELP = QT_TR_NOOP(
        "Fits every sensor model that the points allow and judges each on points that its fit has not seen: check "
        "points, or, where they are fewer than five, every point predicted from the others. The table is that of "
        "Kurczynski and Wolniewicz. Among the models whose errors, there and at control points left out in turn, "
        "differ only by chance, the one with the fewest unknowns is recommended; plane polynomials for flat ground "
        "only."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.addPoints()
        self.addFittingParameters()
        self.addDescribed(common.result(OUTPUT, tr("Models"), common.TABLE), tr(
            "One row per model: mean (root mean square) and largest errors in metres, the points used, or why not."
        ))
        report = tr("The table with a chart and the recommendation.")
        self.addDescribed(*common.report(report, tr("HTML files (*.html)")))
        self.addOutput(QgsProcessingOutputString(RECOMMENDED, tr("Recommended model")))
        self.addOutput(QgsProcessingOutputString(RECOMMENDATION, tr("Recommendation with its reason")))
        self.addNumbers({MODEL_COUNT: tr("Models judged")})

    def execute(self, run: Run) -> dict[str, Any]:
        from .measure import adjustment
        from .measure.heights import is_flat
        from .measure.points import control_coverage
        from .point_tables import SensorInputs, model_columns

        given = SensorInputs(run, *self._prepared, IMAGE_RPC)
        points = given.read_points()
        notices = control_coverage(points.image[~points.check], given.box(points)).notices
        run.tell(*notices)
        requests = adjustment.all_requests(given.rpc, given.orbit_height_m, given.size)
        result = adjustment.compare(
            points, requests, run.flag(ROBUST), is_flat(points), run.progress, run.is_cancelled
        )
        columns = model_columns(result)
        sink, output = run.sink(OUTPUT, column_fields(columns))
        run.write(sink, column_features(columns, result.rows))
        run.tell(result.reason)

        def write_report(path: Path) -> None:
            from .report import save_comparison_report

            save_comparison_report(path, result, notices)

        name = result.recommended.request.name if result.recommended is not None else ""
        return {
            OUTPUT: output, RECOMMENDED: name, RECOMMENDATION: sentence(result.reason),
            MODEL_COUNT: sum(row.errors is not None for row in result.rows), **run.save(common.REPORT, write_report),
        }  # fmt: skip


class PlanPoints(SensorAlgorithm):
    """The accuracy to expect from a number of points, their spread and their quality."""

    ID = "planpoints"
    NAME = QT_TR_NOOP("Plan control points")
    HELP = QT_TR_NOOP(
        "Predicts the accuracy from the number, quality and spread of control points before they are measured. For "
        "every number of points 50 sets with random errors are drawn on an image whose geometry is known, its RPC or "
        "that of a nominal line scanner; the model is fitted to each and judged all over the image. This is a planning "
        "figure; your own check points show how accurate the image is."
    )

    def initAlgorithm(self, configuration: Any = None) -> None:
        purpose = tr("The sensor model to be fitted, with its order or form. rpc_bias needs an RPC.")
        self.addDescribed(common.choice(MODEL, tr("Model"), _MODELS, registry.PUSHBROOM.name), purpose)
        counts = QgsProcessingParameterString(COUNTS, tr("Numbers of control points"), "6, 8, 10, 15, 20, 30")
        self.addDescribed(counts, tr(
            "One row of the table for each, such as 6, 10, 20. Check points are not counted."
        ))
        self.addDescribed(common.choice(SPREAD, tr("Spread"), limits.SPREADS), tr(
            "grid: one point in each cell of a grid over the image; random: anywhere; corner: all in one corner."
        ))
        for name, label, default, least, most, text in (
            (CORNER_SHARE, tr("Share of the corner"), 0.25, 0.01, 1, tr("Share of the image, for the spread corner.")),
            (SIGMA, tr("Standard deviation on the ground (metres)"), 0.5, 0, 1000,
             tr("For each ground coordinate of a point, as it will be surveyed.")),
            (SIGMA_PX, tr("Standard deviation in the image (pixels)"), 0.5, 0, 1000,
             tr("For a point's column and row: how well it is identified.")),
        ):  # fmt: skip
            self.addReal(name, label, default, text, least=least, most=most)
        text = tr("Height above the ellipsoid. Points lie anywhere between the lowest and the highest.")
        self.addReal(LOWEST, tr("Lowest terrain (metres)"), 0.0, text)
        self.addReal(HIGHEST, tr("Highest terrain (metres)"), 300.0, text)
        self.addImage()
        self.addDescribed(common.file(IMAGE_RPC, tr("RPC of the image"), optional=True), tr(
            "An RPC whose geometry is taken as true. Without it and without IMAGE: a nominal line scanner."
        ))
        for name, label, default, least, most, text in (
            (ORBIT_HEIGHT, tr("Height of the orbit (km)"), 694.0, 100, 40000,
             tr("For the nominal scanner and the model pushbroom.")),
            (VIEW_ANGLE, tr("Angle of the view (degrees)"), 15.0, 0, 50, tr("From the vertical; nominal scanner.")),
            (PIXEL_SIZE, tr("Pixel size (metres)"), 0.5, 0.05, 1000, tr("On the ground; nominal scanner.")),
            (SIDE, tr("Side of the image (km)"), 15.0, 1, 200, tr("The image is square; nominal scanner.")),
        ):  # fmt: skip
            self.addReal(name, label, default, text, advanced=True, least=least, most=most)
        seed = common.whole(SEED, tr("Seed"), 1, 0, 2**31 - 1)
        self.addDescribed(seed, tr("The same number gives the same draws."), advanced=True)
        self.addDescribed(common.result(OUTPUT, tr("Expected accuracy"), common.TABLE), tr(
            "One row per number of points: root mean square errors in metres, of both coordinates together, that 50 % "
            "and 90 % of the draws do not exceed: over the whole image, and at check points that are measured as well "
            "as the control points."
        ))

    def execute(self, run: Run) -> dict[str, Any]:
        from .measure.point_planning import PointPlan, expected_accuracies
        from .point_tables import PLANS

        words = [word for word in re.split(r"[\s,;]+", run.text(COUNTS)) if word]
        if not words or not all(re.fullmatch(r"[0-9]{1,4}", word) and 0 < int(word) <= MOST_PLANNED for word in words):
            raise SettingsError(messages.PLAN_COUNTS_UNREADABLE(given=run.text(COUNTS), most=MOST_PLANNED))
        request, scene = self._planned(run)
        plan = PointPlan(run.word(SPREAD), run.real(CORNER_SHARE), run.real(SIGMA), run.real(SIGMA_PX))
        draws = partial(expected_accuracies, progress=run.progress, cancelled=run.is_cancelled)
        rows = list(draws(request, scene, plan, tuple(sorted(set(map(int, words)))), run.whole(SEED)))
        for row in rows:
            if row.image_usual is not None and row.image_most is not None:
                run.tell(messages.PLAN_TOLD(count=row.count, usual=row.image_usual, most=row.image_most))
            if row.reason is not None:
                run.tell(messages.PLAN_DRAWS_FAILED(count=row.count, failed=row.failed, why=row.reason))
        sink, output = run.sink(OUTPUT, column_fields(PLANS))
        run.write(sink, column_features(PLANS, rows))
        return {OUTPUT: output}

    def _planned(self, run: Run) -> tuple[ModelRequest, PlannedScene]:
        from .measure.point_planning import nominal_scene, scene_of_rpc
        from .measure.points import check_heights
        from .point_tables import SensorInputs

        low, high = run.real(LOWEST), run.real(HIGHEST)
        check_heights(low, high, f"{LOWEST}, {HIGHEST}")
        given, orbit_m = SensorInputs(run, *self._prepared, IMAGE_RPC), run.real(ORBIT_HEIGHT) * 1000
        rpc = given.rpc
        if rpc is not None:
            scene = scene_of_rpc(rpc, given.size, (low, high))
        elif given.image is not None:
            raise SettingsError(messages.PLAN_IMAGE_WITHOUT_RPC())
        else:
            side_m = run.real(SIDE) * 1000
            scene = nominal_scene(orbit_m, run.real(VIEW_ANGLE), run.real(PIXEL_SIZE), side_m, (low, high))
        name, _, variant = run.word(MODEL).partition(" ")
        return registry.KINDS[name].request(variant, orbit_height_m=orbit_m, size=scene.size, rpc=rpc), scene


def _described(kind: registry.ModelKind) -> str:
    """A model in words, and how many points it needs."""
    counts = {variant.name: variant.fewest for variant in kind.variants}
    fewest = ", ".join(f"{count} ({name})" if name else str(count) for name, count in counts.items())
    words = tr("{model}: {title}; needs at least {fewest} control points.")
    return filled(words, model=kind.name, title=tr(MODEL_TITLES[kind.name]), fewest=fewest)
