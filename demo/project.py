"""A QGIS project of a block, ready to open: the mosaic over its orthoimages, the seamlines on top.

    python -m demo.project FOLDER
"""
from __future__ import annotations

import sys
from collections.abc import Iterable
from pathlib import Path

from qgis.core import QgsApplication, QgsProject, QgsRasterLayer, QgsReferencedRectangle, QgsVectorLayer
from qgis.PyQt.QtGui import QColor

SEAM_COLOUR, SEAM_WIDTH_MM = "#00e5ff", 0.4  # seen on any ground


def write_project(path: Path, mosaic: Path, sources: Iterable[Path], seamlines: Path) -> None:
    """The layers of a block as a project that opens on the whole mosaic."""
    project = QgsProject()
    images = [QgsRasterLayer(str(image), image.stem) for image in (*sorted(sources), mosaic)]
    lines = QgsVectorLayer(f"{seamlines}|layername=seamlines", "seamlines", "ogr")
    lines.renderer().symbol().setColor(QColor(SEAM_COLOUR))
    lines.renderer().symbol().setWidth(SEAM_WIDTH_MM)
    for layer in (*images, lines):
        project.addMapLayer(layer, False)
        project.layerTreeRoot().insertLayer(0, layer).setExpanded(False)
    project.setCrs(images[-1].crs())
    project.viewSettings().setDefaultViewExtent(QgsReferencedRectangle(images[-1].extent(), images[-1].crs()))
    project.write(str(path))


def main() -> int:
    folder = Path(sys.argv[1])
    application = QgsApplication([], False)
    application.initQgis()
    sources = [path for path in folder.glob("*.tif") if path.name != "mosaic.tif"]
    write_project(folder / "block.qgz", folder / "mosaic.tif", sources, folder / "seamlines.gpkg")
    return 0


if __name__ == "__main__":
    sys.exit(main())
