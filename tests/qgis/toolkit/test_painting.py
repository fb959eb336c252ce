"""Painters end with their block, whoever still knows them."""
from __future__ import annotations

import contextlib
import re
from pathlib import Path

from qgis.PyQt.QtGui import QImage
from seam_inspector.plugin.toolkit import painting

PLUGIN = Path(painting.__file__).parents[1]


def test_a_painter_that_is_still_held_has_ended() -> None:
    image = QImage(4, 4, QImage.Format.Format_ARGB32)
    held = []
    with contextlib.suppress(LookupError), painting.painting(image) as painter:
        held.append(painter)
        assert painter.isActive()
        raise LookupError
    assert not held[0].isActive()
    assert not image.paintingActive()


def test_nothing_paints_otherwise() -> None:
    elsewhere = [path.name for path in PLUGIN.rglob("*.py") if re.search(r"\bQPainter\(", path.read_text())]
    assert elsewhere == ["painting.py"]
