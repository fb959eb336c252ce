"""``seaminspector:fitsensormodel``: a sensor model from ground control points."""
from __future__ import annotations

import math
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable

from qgis.core import QgsCoordinateReferenceSystem, QgsWkbTypes
from qgis.PyQt.QtCore import QT_TR_NOOP

from ..imagery.errors import SensorModelError
from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.run import Run
from ..toolkit.reference_systems import reference_system
from ..toolkit.translation import filled, tr
from .measure import messages, registry
from .sensor_parameters import IMAGE_RPC, ROBUST, TERRAIN_ERROR, SensorAlgorithm, image_box, view_numbers

if TYPE_CHECKING:
    from ..imagery.errors import Message
    from ..imagery.open_raster import OpenRaster
    from .measure.adjustment import Accuracy, Adjustment
    from .measure.polynomials import Rational
    from .measure.registry import ModelRequest

MAX_CONDITION = 1e12  # float64 keeps four digits of the unknowns

MODEL, ORDER, DLT_XY, BIAS = "MODEL", "ORDER", "DLT_XY", "BIAS"
OUTPUT, MODEL_FILE, RPC, RPC_IMAGE, POINTS = "OUTPUT", "MODEL_FILE", "RPC", "RPC_IMAGE", "POINTS"
CONTROL_COUNT, CHECK_COUNT, CONDITION = "CONTROL_COUNT", "CHECK_COUNT", "CONDITION"
BIAS_COLUMN, BIAS_ROW = "BIAS_COLUMN", "BIAS_ROW"
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

    NAMED_BY_FORMAT = (RPC_IMAGE,)

    def initAlgorithm(self, configuration: Any = None) -> None:
        self.addPoints()
        purpose = " ".join(map(_described, registry.KINDS.values()))
        self.addChoice(MODEL, tr("Model"), tuple(registry.KINDS), purpose, registry.RATIONAL.name)
        self.addDescribed(common.whole(ORDER, tr("Order"), 1, 1, 3), tr(
            "For polynomials and quotients. Higher orders need many points and oscillate between them."
        ))
        self.addDescribed(common.flag(DLT_XY, tr("Term a12 xy of the direct linear transformation")), tr(
            "Adds one unknown to dlt, the product of column and row in the equation of the row (Fraser 2000)."
        ))
        self.addChoice(BIAS, tr("Correction of the RPC"), _BIASES, tr(
            "For rpc_bias: a shift in the image, with a drift along the lines, or an affine change of the image."
        ))
        self.addFittingParameters()
        self.addTerrainError()
        self.addTable(OUTPUT, tr("Residuals"), tr(
            "The points with residuals, model minus measured: in pixels, and in metres at the point's height."
        ), common.POINT)
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
        from .measure.points import control_coverage, coverage_warnings

        image = self._image()
        rpc = self._rpc(run, IMAGE_RPC, image)
        request = self._request(run, image, rpc)
        points = self._points(run, image, rpc, request)
        done = adjust(request, points, run.flag(ROBUST))
        box = image_box(image, points)
        coverage = control_coverage(points.image[~points.check & ~done.blunder], box)
        notices = self._notices(done) + coverage_warnings(coverage)
        files = FitFiles(done, image, box, run.is_cancelled)
        column, row = None, None
        if files.rpc_bias is not None:
            (column, row), *_ = biases = files.rpc_bias.tolist()
            most = max(math.hypot(*bias) for bias in biases)
            notices.append(messages.RPC_BIAS_FOUND(columns=column, rows=row, most=most))
        view = view_direction(done.fitted.model, points.wkt, files.domain)
        if view is not None:
            notices.append(view.notice(run.real(TERRAIN_ERROR)))
        run.tell(*notices)
        run.progress(0.6)
        system = reference_system(points.wkt)
        crs = system if system.isValid() else QgsCoordinateReferenceSystem(points.wkt)
        sink, output = run.sink(OUTPUT, point_tables.residual_fields(), QgsWkbTypes.Type.Point, crs)
        run.write(sink, point_tables.residual_features(done))

        def write_rpc(write: Callable[[Path], tuple[Message, bool]], path: Path) -> bool:
            notice, written = write(path)
            notices.append(notice)
            run.tell(notice)
            return written

        def write_report(path: Path) -> None:
            from .report import save_fit_report

            save_fit_report(path, done, coverage, box, notices)

        results: dict[str, Any] = {OUTPUT: output}
        for name, write in (
            (MODEL_FILE, files.save_model), (RPC, partial(write_rpc, files.save_rpc)),
            (RPC_IMAGE, partial(write_rpc, files.save_rpc_image)), (POINTS, files.save_points),
            (common.REPORT, write_report),
        ):  # fmt: skip
            results.update(run.save(name, write))
        for group, errors in (("CHECK", done.check), ("CONTROL", done.control)):
            results[f"{group}_COUNT"] = errors.count
            for name in _ERRORS:
                results[f"{group}_{name}"] = getattr(errors, name.lower())
            if errors.count:
                run.inform(_errors_described(group, errors))
        condition = done.fitted.condition if math.isfinite(done.fitted.condition) else None
        return {**results, CONDITION: condition, **view_numbers(run, view), BIAS_COLUMN: column, BIAS_ROW: row}

    def _request(self, run: Run, image: OpenRaster | None, rpc: Rational | None) -> ModelRequest:
        kind = registry.KINDS[run.text(MODEL)]
        if kind.corrects_rpc and rpc is None:
            raise SensorModelError(messages.NO_RPC())
        words = str(run.whole(ORDER)), run.text(BIAS), "xy" if run.flag(DLT_XY) else ""
        size = (float(image.columns), float(image.rows)) if image is not None else None
        orbit_m = self._orbit_height_m(run, image)
        return kind.request(*words, orbit_height_m=orbit_m, size=size, rpc=rpc if kind.corrects_rpc else None)

    @staticmethod
    def _notices(done: Adjustment) -> list[Message]:
        from .measure.adjustment import suspects
        from .measure.polynomials import Rational, term_names

        fitted, notices = done.fitted, []
        if not fitted.converged:
            notices.append(messages.NOT_CONVERGED(iterations=fitted.iterations))
        if fitted.condition > MAX_CONDITION:
            notices.append(messages.ILL_CONDITIONED(condition=fitted.condition))
        if done.request.kind is registry.RATIONAL_TERMS and isinstance(fitted.model, Rational):
            notices.append(messages.TERMS_KEPT(terms=term_names(fitted.model)))
        if done.check.count == 0:
            notices.append(messages.CHECK_POINTS_MISSING())
        if names := done.points.named(done.blunder):
            notices.append(messages.BLUNDERS_FOUND(count=len(names), names=", ".join(names[:20])))
        elif names := done.points.named(suspects(done)):
            notices.append(messages.BLUNDERS_POSSIBLE(count=len(names), names=", ".join(names[:20])))
        return notices


def _described(kind: registry.ModelKind) -> str:
    """A model in words, and how many points it needs."""
    counts = {variant.name: variant.fewest for variant in kind.variants}
    fewest = ", ".join(f"{count} ({name})" if name else str(count) for name, count in counts.items())
    words = tr("{model}: {title}; needs at least {fewest} control points.")
    return filled(words, model=kind.name, title=tr(MODEL_TITLES[kind.name]), fewest=fewest)


def _errors_described(group: str, errors: Accuracy) -> str:
    name = tr("Check points") if group == "CHECK" else tr("Control points")
    return filled(tr(
        "{name}: {count}, root mean square X {x:.3f} m, Y {y:.3f} m, largest X {max_x:.3f} m, Y {max_y:.3f} m"
    ), name=name, count=errors.count, x=errors.rmse_x, y=errors.rmse_y, max_x=errors.max_x, max_y=errors.max_y)
