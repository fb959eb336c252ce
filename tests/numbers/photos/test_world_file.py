"""A photo's world file, as GDAL reads it."""
from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.photos.measure.orientation_files import world_file
from seam_inspector.plugin.photos.measure.transformations import PlaneModel, Transformation

from tests.numbers.synthetic import write_plain


@pytest.mark.parametrize("degrees", [0.0, 1.2, 37.0, 90.0, -135.0])
def test_gdal_puts_every_pixel_where_the_orientation_does(degrees: float, tmp_path: Path) -> None:
    turn, pixel_mm = np.radians(degrees), 0.4
    matrix = np.array([
        [pixel_mm * np.cos(turn), pixel_mm * np.sin(turn), -106.0],
        [pixel_mm * np.sin(turn), -pixel_mm * np.cos(turn), 106.0],
        [0.0, 0.0, 1.0],
    ])
    to_mm = Transformation(PlaneModel.AFFINE, matrix)
    marks = [SimpleNamespace(place=place) for place in ((0.0, 0.0), (530.0, 0.0), (0.0, 530.0), (530.0, 530.0))]
    made: Any = SimpleNamespace(fitted=SimpleNamespace(to_mm=to_mm), marks=marks)
    path = write_plain(tmp_path / "photo.png", np.zeros((530, 530), np.uint8))
    (tmp_path / "photo.pgw").write_text(world_file(made))
    transform = gdal.Open(path).GetGeoTransform()
    places = np.array([(0.0, 0.0), (0.5, 0.5), (529.25, 17.75), (265.0, 530.0)])
    transformed = [gdal.ApplyGeoTransform(transform, column, row) for column, row in places.tolist()]
    assert np.array(transformed) == pytest.approx(to_mm(places), abs=1e-9)
