"""What lies beside a raster of others is read as data."""
from __future__ import annotations

from pathlib import Path

import numpy as np
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure.scan import scan_journal

from tests.numbers.synthetic import write_raster


def test_an_entity_bomb_beside_a_raster_is_not_lit(tmp_path: Path) -> None:
    """Its entities would take gigabytes, or the content of another file."""
    path = write_raster(tmp_path / "a.tif", np.full((8, 8), 9, np.uint8))
    entities = "".join(f'<!ENTITY a{i + 1} "{f"&a{i};" * 20}">' for i in range(12))
    declared = f'<!DOCTYPE x [<!ENTITY a0 "boom"><!ENTITY f SYSTEM "/etc/passwd">{entities}]>'
    (tmp_path / "a.tif.aux.xml").write_text(f"{declared}<PAMDataset>&a12;&f;</PAMDataset>")
    said = list(scan_journal._states(RasterRef(str(path)).path, False))
    assert said
    assert sum(map(len, said)) < 1000
