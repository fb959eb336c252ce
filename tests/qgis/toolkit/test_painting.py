"""Pictures: painters end with their block, whoever still knows them, and figures become files."""
from __future__ import annotations

import contextlib
import re
from pathlib import Path

import pytest
from qgis.PyQt.QtGui import QImage
from seam_inspector.plugin.imagery.errors import SettingsError
from seam_inspector.plugin.toolkit import painting
from seam_inspector.plugin.toolkit.charts.figure_files import new_figure, save_figure, svg_text

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


def _figure():
    figure = new_figure(4, 3)
    figure.add_subplot().plot([1, 2], [3, 4], label="curve")
    return figure


@pytest.mark.parametrize(("name", "start"), [("c.png", b"\x89PNG"), ("c.SVG", b"<?xml"), ("c.pdf", b"%PDF")])
def test_the_ending_decides_on_the_format(tmp_path, name: str, start: bytes) -> None:
    save_figure(_figure(), tmp_path / name)
    assert (tmp_path / name).read_bytes().startswith(start)


def test_a_folder_that_is_not_there_is_told(tmp_path) -> None:
    with pytest.raises(SettingsError, match="can't be written"):
        save_figure(_figure(), tmp_path / "none" / "c.png")


def test_svg_keeps_its_words() -> None:
    figure = _figure()
    figure.axes[0].set_title("Größe <1>")
    assert "Größe &lt;1&gt;" in svg_text(figure)
