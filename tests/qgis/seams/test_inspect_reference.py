"""The fair reference of ``seaminspector:inspectwindows``: REFERENCE, and CELLS that say where a mosaic was cut."""
from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from qgis.core import QgsVectorLayer
from scipy.ndimage import gaussian_filter

from tests.numbers.synthetic import orthoimage, write_raster
from tests.qgis.runs import Run, run
from tests.qgis.scenes import (
    COLUMNS,
    ROWS,
    Scene,
    blurred,
    layer,
    luminance_shares,
    moved,
    outline,
    to_bytes,
    whole,
    windows,
)

pytestmark = pytest.mark.usefixtures("provider")

ACROSS, WEST, EAST = (192, 64, 128, 128), (0, 64, 128, 128), (384, 64, 128, 128)
NAMES = ("composite_ratio_1", "composite_ratio_2", "composite_ratio_3")


@pytest.fixture(scope="module")
def cut(tmp_path_factory: pytest.TempPathFactory) -> Scene:
    """A mosaic that is west to the left of its middle and east to the right; east is soft and lies 2 px off."""
    folder, random = tmp_path_factory.mktemp("cut"), np.random.default_rng(11)
    ground = orthoimage((ROWS, COLUMNS), beta=1.2).astype(np.float64)
    west = to_bytes(ground + random.normal(0, 2, ground.shape))
    east = to_bytes(blurred(np.roll(ground, (1, 2), (-2, -1))) + random.normal(0, 2, ground.shape))
    mosaic = np.concatenate([west[..., : COLUMNS // 2], east[..., COLUMNS // 2 :]], axis=-1)
    paths = [Path(write_raster(folder / name, item)) for name, item in (
        ("mosaic.tif", mosaic), ("west.tif", west), ("east.tif", east)
    )]
    return Scene(*paths)


def inspect(scene: Scene, *boxes: tuple[float, ...], **parameters: Any) -> Run:
    given = {"WINDOWS": windows(*boxes or (ACROSS,)), "MOSAIC": str(scene.mosaic), "SOURCES": scene.sources}
    outcome = run("inspectwindows", **{**given, **parameters})
    assert outcome.complaint is None
    return outcome


def cells(*named: tuple[str | None, tuple[float, ...]], epsg: int = 32633) -> QgsVectorLayer:
    outlines = [moved(outline(box), epsg) for _, box in named]  # type: ignore[arg-type]
    return layer("Polygon", outlines, epsg, source=("string", [name for name, _ in named]))


def composite_curve(outcome: Run, band: str = "luminance") -> list[float]:
    rows = [row for row in outcome.rows("CURVES") if row["role"] == "composite" and row["band"] == band]
    return [row["relative_variance"] for row in rows]


def composite_ratios(outcome: Run) -> list[float]:
    (row,) = outcome.rows()
    return [row[name] for name in NAMES]


# --- the composite ---------------------------------------------------------------------------------------------


def test_a_hard_cut_has_lost_nothing_against_the_composite(cut: Scene) -> None:
    outcome = inspect(cut)
    (row,) = outcome.rows()
    plain = [row["ratio_1"] for row in outcome.rows("PAIRS") if row["band"] == "luminance"][:2]
    assert row["composite_ratio_1"] == pytest.approx(1, abs=0.01)
    assert min(abs(ratio - 1) for ratio in plain) > 0.1
    assert composite_curve(outcome) == pytest.approx(luminance_shares(cut.mosaic, ACROSS).tolist(), rel=0.02)
    assert row["unclear_share"] < 0.1
    assert row["cause"] == "none"


# --- REFERENCE -------------------------------------------------------------------------------------------------


def test_the_verdict_is_taken_against_the_reference(cut: Scene, tmp_path: Path) -> None:
    """Beside a soft source a blurred mosaic looks sound; the composite, mostly of the sharp one, tells."""
    pixels = to_bytes(gaussian_filter(whole(cut.mosaic).astype(float), (0, 0.7, 0.7)))
    mosaic = write_raster(tmp_path / "spoilt.tif", pixels)
    sharp = (136, 64, 128, 128)  # all but 8 of its columns are from the sharp source
    against_sources, against_composite = (
        inspect(cut, sharp, MOSAIC=mosaic, REFERENCE=reference) for reference in ("sources", "composite")
    )
    assert against_sources.column("verdict") == ["preserved"]
    assert against_composite.column("verdict") == ["significant"]
    for outcome in (against_sources, against_composite):
        (row,) = outcome.rows()
        pairs = {row["source"]: row["ratio_1"] for row in outcome.rows("PAIRS") if row["band"] == "luminance"}
        assert row["ratio_1"] == max(pairs["west.tif"], pairs["east.tif"]) > 1
        assert row["composite_ratio_1"] == pairs["composite"] < 0.5


# --- CELLS -----------------------------------------------------------------------------------------------------


def test_cells_decide_against_the_detail(cut: Scene) -> None:
    """Cells that name the wrong source are believed: what is compared is what the producer says."""
    outcome = inspect(cut, WEST, CELLS=cells(("east.tif", (-5, -5, 600, 300))))
    assert composite_curve(outcome) == pytest.approx(luminance_shares(cut.east, WEST).tolist(), rel=1e-3)
    east = next(row for row in outcome.rows("PAIRS") if (row["source"], row["band"]) == ("east.tif", "luminance"))
    assert composite_ratios(outcome) == pytest.approx([east[f"ratio_{level}"] for level in (1, 2, 3)], rel=1e-3)
