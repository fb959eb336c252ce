"""The angle an image was taken at, and what errors of the terrain make of it."""
from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery.reference_systems import metres_per_unit
from seam_inspector.plugin.sensors.measure.fit_files import view_direction
from seam_inspector.plugin.sensors.measure.frames import BrownLens, FrameCamera, FrameInterior, camera_axes
from seam_inspector.plugin.sensors.measure.rpc import Domain, to_metadata

from tests.numbers.sensors.sensor_scenes import COLUMNS, MIDDLE, ROWS, WGS84, made_rational

DOMAIN = Domain((0, COLUMNS), (0, ROWS), (0, 1200), (float(MIDDLE[0]), float(MIDDLE[1])))


def test_the_angle_is_that_of_gdals_lines_of_sight() -> None:
    """GDAL's RPC transformer puts the middle of the image at two heights; 45 degrees would move it by as much."""
    rpc = made_rational(3, 4)
    view = view_direction(rpc, WGS84, DOMAIN)
    image = gdal.GetDriverByName("MEM").Create("", int(COLUMNS), int(ROWS), 1)
    image.SetMetadata(to_metadata(rpc), "RPC")
    transformer = gdal.Transformer(image, None, ["METHOD=RPC", "RPC_PIXEL_ERROR_THRESHOLD=1e-6"])
    low, high = (np.array(transformer.TransformPoint(0, COLUMNS / 2, ROWS / 2, z)[1][:2]) for z in (550, 650))
    east, north = (high - low) * metres_per_unit(WGS84, low)
    assert np.tan(np.radians(view.angle)) == pytest.approx(np.hypot(east, north) / 100, rel=1e-3)
    assert view.azimuth == pytest.approx(np.degrees(np.arctan2(east, north)) % 360, abs=0.1)
    assert view.shift_m(7) == pytest.approx(7 * np.hypot(east, north) / 100, rel=1e-3)
    assert view.largest >= view.angle - 1e-9


def test_an_oblique_photo_has_a_view() -> None:
    """A drone's strong lens, tilted by 30 degrees: a search from below the photo loses its way to a corner."""
    principal = np.array([688.2, 453.0])
    interior = FrameInterior(np.full(2, 914.0), principal, BrownLens((-0.264, 0.112, -0.027), (9e-4, -5e-4)))
    camera = FrameCamera(interior, np.array([500_000.0, 5_550_000.0, 520.0]), camera_axes(30, 0, 0))
    domain = Domain((0, 1368), (0, 912), (230, 370), (500_000.0, 5_550_130.0))
    view = view_direction(camera, "EPSG:32651", domain)
    assert view.angle == pytest.approx(30, abs=0.3)
    assert view.azimuth == pytest.approx(180, abs=1)
    assert 65 < view.largest < 75


def test_a_model_that_can_t_be_inverted_has_no_view() -> None:
    """So that an orthoimage which is made already does not fail for it."""
    bent = replace(made_rational(1, 2), numerators=np.zeros((4, 2)))
    assert view_direction(bent, WGS84, DOMAIN) is None
