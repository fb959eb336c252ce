"""``seaminspector:planpoints``: the accuracy to expect from control points that are not measured yet."""
from __future__ import annotations

import re
from functools import partial
from typing import TYPE_CHECKING, Any

from qgis.core import QgsProcessingParameterString
from qgis.PyQt.QtCore import QT_TR_NOOP

from ..imagery.errors import SettingsError
from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.run import Run
from ..toolkit.table_fields import column_features, column_fields
from ..toolkit.translation import tr
from .measure import limits, messages, registry
from .sensor_parameters import IMAGE, IMAGE_RPC, ORBIT_HEIGHT, SensorAlgorithm

if TYPE_CHECKING:
    from .measure.point_planning import PlannedScene
    from .measure.registry import ModelRequest

MODEL, COUNTS, SPREAD, CORNER_SHARE = "MODEL", "COUNTS", "SPREAD", "CORNER_SHARE"
SIGMA, SIGMA_PX, LOWEST, HIGHEST = "SIGMA", "SIGMA_PX", "LOWEST", "HIGHEST"
VIEW_ANGLE, PIXEL_SIZE, SIDE = "VIEW_ANGLE", "PIXEL_SIZE", "SIDE"
SEED, OUTPUT = "SEED", "OUTPUT"
_MODELS = tuple(f"{kind.name} {variant.name}".strip() for kind in registry.KINDS.values() for variant in kind.variants)
_MOST_POINTS = 1000


class PlanPoints(SensorAlgorithm):
    """The accuracy to expect from a number of points, their spread and their quality."""

    RASTER_LISTS = (IMAGE,)
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
        self.addChoice(MODEL, tr("Model"), _MODELS, purpose, registry.PUSHBROOM.name)
        counts = QgsProcessingParameterString(COUNTS, tr("Numbers of control points"), "6, 8, 10, 15, 20, 30")
        self.addDescribed(counts, tr(
            "One row of the table for each, such as 6, 10, 20. Check points are not counted."
        ))
        self.addChoice(SPREAD, tr("Spread"), limits.SPREADS, tr(
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
        self.addFile(IMAGE_RPC, tr("RPC of the image"), tr(
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
        self.addTable(OUTPUT, tr("Expected accuracy"), tr(
            "One row per number of points: root mean square errors in metres, of both coordinates together, that 50 % "
            "and 90 % of the draws do not exceed: over the whole image, and at check points that are measured as well "
            "as the control points."
        ))

    def prepare(self, run: Run) -> None:
        self._image_ref = run.raster(IMAGE)

    def execute(self, run: Run) -> dict[str, Any]:
        from .measure.point_planning import PointPlan, expected_accuracies
        from .point_tables import PLANS

        words = [word for word in re.split(r"[\s,;]+", run.text(COUNTS)) if word]
        if not words or not all(re.fullmatch(r"[0-9]{1,4}", word) and 0 < int(word) <= _MOST_POINTS for word in words):
            raise SettingsError(messages.PLAN_COUNTS_UNREADABLE(given=run.text(COUNTS), most=_MOST_POINTS))
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

        low, high = run.real(LOWEST), run.real(HIGHEST)
        check_heights(low, high, f"{LOWEST}, {HIGHEST}")
        image, orbit_m = self._image(), run.real(ORBIT_HEIGHT) * 1000
        rpc = self._rpc(run, IMAGE_RPC, image)
        if rpc is None and image is not None:
            raise SettingsError(messages.PLAN_IMAGE_WITHOUT_RPC())
        if rpc is not None:
            size = (float(image.columns), float(image.rows)) if image is not None else None
            scene = scene_of_rpc(rpc, size, (low, high))
        else:
            side_m = run.real(SIDE) * 1000
            scene = nominal_scene(orbit_m, run.real(VIEW_ANGLE), run.real(PIXEL_SIZE), side_m, (low, high))
        name, _, variant = run.word(MODEL).partition(" ")
        return registry.KINDS[name].request(variant, orbit_height_m=orbit_m, size=scene.size, rpc=rpc), scene
