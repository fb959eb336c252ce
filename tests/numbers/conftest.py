"""The numbers work without QGIS and Qt: an import of either fails in this run."""
from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

for name in ("qgis", "PyQt5", "PyQt6"):
    sys.modules.setdefault(name, None)  # type: ignore[arg-type]

from seam_inspector.plugin.imagery.open_raster import describe_mosaic  # noqa: E402
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef  # noqa: E402

from tests.numbers.clips import SIZE  # noqa: E402
from tests.numbers.synthetic import orthoimage, write_raster  # noqa: E402

MakeRaster = Callable[..., str]


@pytest.fixture
def make_raster(tmp_path: Path) -> MakeRaster:
    """Writes an array as a GeoTIFF of that name into the test's folder; see ``synthetic.write_raster``."""

    def make(name: str, array: np.ndarray, **options: Any) -> str:
        return write_raster(tmp_path / name, array, **options)

    return make


@pytest.fixture(scope="session")
def mosaic(tmp_path_factory: pytest.TempPathFactory) -> Raster:
    """256 x 256 px of 10 cm, red, green and blue in 8 bit."""
    folder = tmp_path_factory.mktemp("mosaic")
    return describe_mosaic(RasterRef(write_raster(folder / "mosaic.tif", orthoimage(SIZE))))
