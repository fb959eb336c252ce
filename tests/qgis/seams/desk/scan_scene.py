"""A mosaic of two blocks, cut from two orthoimages along a line that crosses both of them, feathered or not."""
from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from qgis.core import QgsProject, QgsRasterLayer
from scipy import ndimage
from seam_inspector.plugin.seams.desk.inputs.project_inputs import Inputs
from seam_inspector.plugin.seams.desk.mosaic_scans import MosaicScans
from seam_inspector.plugin.seams.desk.session import Session
from seam_inspector.plugin.seams.measure import messages

from tests.numbers.synthetic import write_raster
from tests.qgis.scenes import layer, line
from tests.qgis.seams.desk.session_desk import wait_until

COLUMNS, ROWS, PIXEL = 2560, 1024, 0.1
SEAM_ROW = 500
FEATHER_PX = 24
PIECE_M = 25.0


@dataclass(frozen=True)
class ScanScene:
    """Files."""

    mosaic: Path
    north: Path
    south: Path


def make_scan_scene(folder: Path) -> ScanScene:
    """One band, 8 bit. What the two see of the ground differs, as trees and shadows do."""
    random = np.random.default_rng(5)
    ground = _texture(random, 1.0)
    north, south = (128 + 25 * (ground + 2.0 * _texture(random, 1.0)) for _ in range(2))
    weight = np.clip((np.arange(ROWS) - SEAM_ROW) / FEATHER_PX + 0.5, 0, 1)[:, None]
    scene = ScanScene(folder / "ortho.tif", folder / "north.tif", folder / "south.tif")
    for path, pixels in (
        (scene.north, north), (scene.south, south), (scene.mosaic, (1 - weight) * north + weight * south)
    ):
        write_raster(path, np.clip(np.rint(pixels), 1, 255).astype(np.uint8))
    return scene


def _texture(random: np.random.Generator, sigma: float) -> np.ndarray:
    pixels = ndimage.gaussian_filter(random.normal(size=(ROWS, COLUMNS)).astype(np.float32), sigma)
    return np.asarray(pixels / pixels.std() / 2)


class ScanDesk:
    """The project's layers, a session with its scans, and what these told."""

    def __init__(self, scene: ScanScene, folder: Path) -> None:
        self.project = QgsProject.instance()
        self.project.setPresetHomePath(str(folder))
        self.folder = folder
        self.rasters = {path.stem: QgsRasterLayer(str(path), path.stem) for path in vars(scene).values()}
        self.seamlines = layer("LineString", [line((0, SEAM_ROW), (COLUMNS, SEAM_ROW))])
        self.project.addMapLayers([*self.rasters.values(), self.seamlines])
        self.session = Session()
        self.scans = MosaicScans(self.session, self.session)
        self.messages: list[str] = []
        self.found: list[Any] = []
        self.session.messageRaised.connect(self._heard)
        self.scans.notified.connect(self._heard)
        self.scans.scanned.connect(self.found.append)

    def _heard(self, text: str, _level: int) -> None:
        self.messages.append(text)

    def use(self, *sources: str, **changes: Any) -> None:
        """Set the inputs and wait until the mosaic is open."""
        values = {"sources": tuple(self.rasters[name].id() for name in sources), "piece_m": PIECE_M, **changes}
        self.session.set_inputs(Inputs(mosaic=self.rasters["ortho"].id(), **values))
        wait_until(lambda: self.session.problem() != messages.MOSAIC_OPENING(), "for the mosaic")

    def scan(self) -> Any:
        """From the start to the layers on the map."""
        self.found.clear()
        self.scans.start()
        wait_until(lambda: not self.scans.is_at_work, "for the scan")
        return self.found[0] if self.found else None

    def titles(self) -> list[str]:
        """Names of all layers, the topmost first."""
        return [node.name() for node in self.project.layerTreeRoot().findLayers()]

    def close(self) -> None:
        self.scans.close()
        self.session.close()
