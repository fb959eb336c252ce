"""What the tests of a decision on paper share."""
from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
from seam_inspector.plugin.acceptance.measure.decision import Decision
from seam_inspector.plugin.acceptance.measure.delivery import DeliveredLayer, Seal
from seam_inspector.plugin.acceptance.paper.inspection_record import InspectionRecord
from seam_inspector.plugin.imagery.open_raster import describe_mosaic
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef

from tests.numbers.acceptance.made_decisions import BOTTOM, LEFT, UTM
from tests.numbers.synthetic import write_raster

EVIL = "<script>alert(\"1\")</script> & 'Söhne' \u202egnp.exe \x07"


def ground(path: Path, across: float = 200.0, up: float = 1000.0, kind: str = "uint8") -> Raster:
    """Noise at 0.5 m on which the made seams lie, from 50 m west of the first one."""
    shape = (3, round(up / 0.5), round(across / 0.5))
    pixels = np.random.default_rng(1).integers(60, 190, shape).astype(kind)
    write_raster(path, pixels, 0.5, (LEFT - 50, BOTTOM + up), system=UTM)
    return describe_mosaic(RasterRef(str(path)))


def record_of(decision: Decision, **also: object) -> InspectionRecord:
    """With where each sheet was read from."""
    seams = tuple((name, f"/deliveries/{name}.gpkg", "") for name in decision.delivery.sheets)
    return InspectionRecord(decision, seams, **also)  # type: ignore[arg-type]


def scanned_with(decision: Decision, wavelet: str) -> Decision:
    """What was decided, of a layer that says how it was measured."""
    layer = DeliveredLayer("seams", Seal.WHOLE, 0.0, {"wavelet": wavelet, "levels": "3"})
    return replace(decision, delivery=replace(decision.delivery, layers=(layer,)))
