"""Draw the PNG of the icon from its SVG, with the library that draws it in QGIS."""
from __future__ import annotations

from pathlib import Path

from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtGui import QGuiApplication, QImage, QPainter
from qgis.PyQt.QtSvg import QSvgRenderer

SIDE_PX = 128
SVG = Path(__file__).resolve().parents[1] / "resources" / "icons" / "seam_inspector.svg"


def draw(side: int) -> QImage:
    """The icon as a square image on transparent ground."""
    image = QImage(side, side, QImage.Format.Format_ARGB32)
    image.fill(Qt.GlobalColor.transparent)
    painter = QPainter(image)
    QSvgRenderer(str(SVG)).render(painter)
    painter.end()
    return image


if __name__ == "__main__":
    application = QGuiApplication([])
    draw(SIDE_PX).save(str(SVG.with_suffix(".png")))
