"""The seam that a click snaps to."""
from __future__ import annotations

from typing import Any

import pytest
from qgis.core import QgsGeometry
from seam_inspector.plugin.seams.desk.map.under_mouse import SeamFinder

EAST, NORTH = 500_000.0, 5_000_000.0


def test_the_nearest_point_of_all_seams_within_reach() -> None:
    nobody: Any = None
    finder = SeamFinder(nobody, nobody)
    assert finder.nearest(EAST, NORTH, 1e9) is None
    finder.seams = QgsGeometry.fromWkt("MultiLineString ((0 0, 10 0), (0 5, 10 5))")
    finder.seams.translate(EAST, NORTH)
    assert finder.nearest(EAST + 4, NORTH + 1.5, 1.6) == pytest.approx((EAST + 4, NORTH))
    assert finder.nearest(EAST + 12, NORTH + 4, 3) == pytest.approx((EAST + 10, NORTH + 5))
    assert finder.nearest(EAST + 4, NORTH + 1.5, 1.4) is None
