"""Pictures of reports hold the pixels, and leave nothing behind."""
from __future__ import annotations

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.toolkit.pages.picture_files import encoded


def test_pictures_keep_their_pixels(tmp_path) -> None:
    pixels = np.random.default_rng(1).integers(0, 256, (5, 7, 3)).astype(np.uint8)
    file = tmp_path / "picture.png"
    file.write_bytes(encoded(pixels, "PNG"))
    assert (np.moveaxis(gdal.Open(str(file)).ReadAsArray(), 0, 2) == pixels).all()
    grey = encoded(pixels[..., 0], "JPEG")
    assert grey[:3] == b"\xff\xd8\xff"


def test_a_picture_leaves_nothing_in_memory(monkeypatch: pytest.MonkeyPatch) -> None:
    """GDAL 3.10 raises where a file to be removed is not there; older ones only say so."""
    unlink, missing = gdal.Unlink, []

    def strict(path: str) -> int:
        if gdal.VSIStatL(path) is None:
            missing.append(path)
        return int(unlink(path))

    monkeypatch.setattr(gdal, "Unlink", strict)
    before = gdal.ReadDir("/vsimem/")
    encoded(np.zeros((8, 8), np.uint8), "PNG")
    assert missing == []
    assert gdal.ReadDir("/vsimem/") == before
