"""What ``seaminspector:inspectwindows`` says of a seam: kept detail, its band, causes, and what took no part."""
from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.numbers.synthetic import orthoimage, write_raster
from tests.qgis.runs import Run, assert_refused, run
from tests.qgis.scenes import PIXEL, to_bytes, windows

pytestmark = pytest.mark.usefixtures("provider")

SIDE, SEAM, FEATHER = 512, 256, 48  # px
WHOLE = (0, 0, SIDE, SIDE)


@pytest.fixture(scope="module")
def images() -> tuple[np.ndarray, np.ndarray]:
    """Two photographs of one ground; of the finest detail each has its own."""
    random, ground = np.random.default_rng(5), orthoimage((SIDE, SIDE), beta=3).astype(np.float64)
    west, east = (to_bytes(ground + random.normal(0, 8, ground.shape)) for _ in range(2))
    return west, east


def mosaicked(images: tuple[np.ndarray, np.ndarray], feather: float) -> np.ndarray:
    """West to the left of a crooked seam, east to its right, with a linear feather so many px wide."""
    rows, columns = np.mgrid[:SIDE, :SIDE]
    distance = columns - SEAM - 12 * np.sin(rows / 40)
    share = np.clip(distance / feather + 0.5, 0, 1) if feather else (distance >= 0).astype(float)
    return to_bytes((1 - share) * images[0] + share * images[1])


@pytest.fixture(scope="module")
def paths(tmp_path_factory: pytest.TempPathFactory, images: tuple[np.ndarray, np.ndarray]) -> dict[str, str]:
    folder = tmp_path_factory.mktemp("seam")
    rasters = {"west": images[0], "east": images[1], "hard": mosaicked(images, 0), "soft": mosaicked(images, FEATHER)}
    return {name: write_raster(folder / f"{name}.tif", pixels) for name, pixels in rasters.items()}


def inspect(paths: dict[str, str], mosaic: str, **parameters: Any) -> Run:
    given = {"WINDOWS": windows(WHOLE), "MOSAIC": paths[mosaic], "SOURCES": [paths["west"], paths["east"]]}
    outcome = run("inspectwindows", **{**given, **parameters})
    assert outcome.complaint is None
    return outcome


def test_a_feather_is_a_significant_loss_by_the_seam(paths: dict[str, str]) -> None:
    """Between images that have nothing fine in common half of it is kept in the middle."""
    (row,) = inspect(paths, "soft").rows()
    assert (row["verdict"], row["reference"], row["paper_verdict"]) == ("significant", "seam", "reduced")
    assert row["kept_low"] < row["kept_1"] < row["kept_high"] < 0.7
    assert row["kept_1"] == pytest.approx(0.55, abs=0.07)
    assert row["kept_1"] < row["kept_2"] < row["kept_3"]
    assert 0.4 * FEATHER * PIXEL < row["band_width"] < FEATHER * PIXEL
    assert row["cause"] == "feathering"
    assert row["causes"].split("; ")[0] == "feathering"
    assert row["explained"] > 0.99


def test_a_hard_cut_is_preserved_by_the_seam(paths: dict[str, str]) -> None:
    (row,) = inspect(paths, "hard").rows()
    assert (row["verdict"], row["cause"], row["causes"]) == ("preserved", "none", "none")
    assert row["kept_low"] < 1 < row["kept_high"]
    assert row["kept_1"] == pytest.approx(1, abs=0.08)
    assert row["sharpness_1"] == pytest.approx(1, abs=0.02)
    assert row["contrast_1"] == pytest.approx(1, abs=0.02)
    assert row["added_1"] == pytest.approx(0, abs=0.05)
    assert row["band_width"] == 0


def test_profiles_tell_what_is_kept_by_distance(paths: dict[str, str]) -> None:
    outcome = inspect(paths, "soft")
    rows = outcome.rows("PROFILES")
    assert {row["window_id"] for row in rows} == {1}
    assert sorted({row["level"] for row in rows}) == [1, 2, 3]
    first = [row for row in rows if row["level"] == 1]
    distances = [row["distance"] for row in first]
    assert distances == sorted(distances)
    assert 0 < distances[0] < 3 * PIXEL
    assert first[0]["kept"] < 0.65
    far = [row["kept"] for row in first if row["distance"] > FEATHER * PIXEL]
    np.testing.assert_allclose(far, 1, atol=0.1)
    assert all(row["low"] < row["kept"] < row["high"] for row in rows)
    assert sum(row["area"] for row in first) == pytest.approx((SIDE * PIXEL) ** 2, rel=0.02)
    assert inspect(paths, "hard", SOURCES=[paths["west"], paths["hard"]]).rows("PROFILES") == []  # one is enough


def test_min_kept_moves_the_limit(paths: dict[str, str]) -> None:
    kept = inspect(paths, "soft").column("kept_1")[0]
    assert inspect(paths, "soft", MIN_KEPT=kept - 0.01).column("verdict") == ["reduced"]
    assert inspect(paths, "soft", MIN_KEPT=kept + 0.01).column("verdict") == ["significant"]
    assert inspect(paths, "soft", MIN_KEPT=None).column("verdict") == ["significant"]
    for wrong in (0, 1):
        assert_refused(
            "inspectwindows", "min_kept is .* between 0 and 1", WINDOWS=windows(WHOLE), MOSAIC=paths["soft"],
            SOURCES=[paths["west"]], MIN_KEPT=wrong,
        )


def test_a_source_that_covers_the_window_in_part_takes_part_there(
    paths: dict[str, str], images: tuple[np.ndarray, np.ndarray], tmp_path: Path
) -> None:
    first = 200  # px: where it begins, left of the seam
    origin = (500000 + first * PIXEL, 5000000.0)
    part = write_raster(tmp_path / "part.tif", images[1][..., first:], origin=origin)
    outcome = inspect(paths, "soft", SOURCES=[paths["west"], part])
    (row,), (whole,) = outcome.rows(), inspect(paths, "soft").rows()
    assert row["sources"] == 2
    assert row["explained"] > 0.98
    assert row["verdict"] == whole["verdict"]
    assert row["kept_1"] == pytest.approx(whole["kept_1"], abs=0.03)
    pairs = {row["source"]: row for row in outcome.rows("PAIRS") if row["band"] == "luminance"}
    assert pairs["part.tif"]["ratio_1"] is None  # the paper's curve needs the whole clip
    assert pairs["part.tif"]["gain"] == pytest.approx(1, abs=0.05)
    share = 100 * (SIDE - first) / SIDE
    assert any(f"part.tif covers {share:.0f} % of the window" in text for text in outcome.log.infos)
