"""Random noise and radiometry of real images: a scanned frame, a drone photo, production orthoimages, two mosaics."""
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from osgeo import ogr
from seam_inspector.plugin.imagery.lines import find_seams
from seam_inspector.plugin.imagery.open_raster import describe
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.noise.measure import noise_plan
from seam_inspector.plugin.noise.measure.group_noise import ClipNoise
from seam_inspector.plugin.radiometry.measure.assessment import Assessment

from tests.numbers.noise.measuring import measured
from tests.numbers.radiometry.judging import checked
from tests.numbers.synthetic import decompose, luminance, read_pixels


def check(*paths: Path, most: int = 3) -> list[ClipNoise]:
    plan = noise_plan.plan_chosen([noise_plan.GroupedImage(describe(RasterRef(str(path))), 1) for path in paths], 3)
    return measured(plan.requests[:most])


def verdicts(results: list[ClipNoise]) -> set[str]:
    return {result.bands["luminance"].verdict.value for result in results}


def test_the_scanned_frame(data_folder: Path) -> None:
    path = data_folder / "fiducials" / "unbc" / "15BCC02013_114.jpg"
    results = check(path)
    assert "low" in verdicts(results) <= {"low", "uncertain"}  # 42 um a pixel and JPEG: the grain is averaged away
    window = results[1].part.window
    pixels = read_pixels(str(path), window.column, window.row, window.width, window.height)
    expected = decompose(luminance(pixels)).shares[:3]
    assert results[1].bands["luminance"].curve.detail == pytest.approx(expected, abs=1e-6)


def test_the_drone_photo_and_the_production_orthoimages(data_folder: Path) -> None:
    # Its trees and grass are as fine and even as grain of several DN would be: that can't be told from a photo.
    assert verdicts(check(data_folder / "noise" / "seneca" / "IMG_0460.jpg")) <= {"low", "uncertain"}
    sharp = check(*sorted((data_folder / "seams" / "packo").glob("*.tif")))
    assert verdicts(sharp) <= {"low", "uncertain"}
    kurtoses = [result.bands["luminance"].kurtosis[0] for result in sharp]
    assert int(np.argmax(kurtoses)) == 2  # type: ignore[arg-type]  # the blurred one: its few edges stand out most


def test_brightons_orthoimages_are_noisy_in_every_window(data_folder: Path) -> None:
    assert verdicts(check(data_folder / "seams" / "brighton" / "mosaic_hardseam.tif", most=4)) == {"strong"}


def test_feathering_halves_brightons_steps_and_takes_a_tenth_of_the_contrast_beside_them(data_folder: Path) -> None:
    folder = data_folder / "seams" / "brighton"
    layer = ogr.Open(str(folder / "seamlines.gpkg"))
    lines = [bytes(feature.GetGeometryRef().ExportToWkb()) for feature in layer.GetLayer("seamlines")]
    results: list[Assessment] = []
    for name in ("mosaic_hardseam.tif", "mosaic_feather0p4m.tif"):
        results.append(checked(str(folder / name), seams=find_seams(lines, 0.03)))
    figures = [
        {(entry.rule.check, entry.band): entry.value for entry in result.checked_figures if entry.value is not None}
        for result in results
    ]
    hard, feathered = figures
    most = {"seam_step": 0.6, "contrast": 1.0, "seam_contrast": 0.9}
    assert set(most) <= {check for check, _ in hard}
    for check, band in hard:
        if check in most:
            assert feathered[check, band] < most[check] * hard[check, band]
