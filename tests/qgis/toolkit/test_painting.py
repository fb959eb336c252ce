"""Painters end with their block, whoever still knows them."""
from __future__ import annotations

import re
from pathlib import Path

import pytest
from qgis.PyQt.QtGui import QImage
from seam_inspector.plugin.toolkit import painting

PLUGIN = Path(painting.__file__).parents[1]


def test_a_painter_that_is_still_held_has_ended() -> None:
    image = QImage(4, 4, QImage.Format.Format_ARGB32)
    with pytest.raises(ZeroDivisionError), painting.painting(image) as held:
        assert held.isActive()
        held.rotate(1 / 0)
    assert not held.isActive()
    assert not image.paintingActive()


def test_nothing_paints_otherwise() -> None:
    elsewhere = [path.name for path in PLUGIN.rglob("*.py") if re.search(r"\bQPainter\(", path.read_text())]
    assert elsewhere == ["painting.py"]
