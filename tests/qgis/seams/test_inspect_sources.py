"""How ``seaminspector:inspectwindows`` takes its sources: as layers, ids, paths, or from an index."""
from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from osgeo import gdal
from qgis.core import QgsCoordinateReferenceSystem, QgsProject, QgsRasterLayer, QgsRasterRange, QgsVectorLayer

from tests.numbers.synthetic import ORIGIN, UTM33, GeoTransform, write_raster
from tests.qgis.runs import Run, assert_sentence, run
from tests.qgis.scenes import BLURRED, SHARP, Scene, layer, line, whole, windows

pytestmark = pytest.mark.usefixtures("provider")

MIDDLE = (192, 64, 128, 128)
SOUTH_UP = (ORIGIN[0], 0.1, 0.0, ORIGIN[1] - 25.6, 0.0, 0.1)


def inspect(scene: Scene, **parameters: Any) -> Run:
    given = {"WINDOWS": windows(SHARP, BLURRED), "MOSAIC": str(scene.mosaic), "SOURCES": scene.sources}
    outcome = run("inspectwindows", **{**given, **parameters})
    assert outcome.complaint is None
    return outcome


@pytest.fixture(scope="module")
def expected(scene: Scene, provider: object) -> list[dict[str, Any]]:
    """What comes out when the sources are given as paths."""
    return inspect(scene).rows("PAIRS")


def file_of(folder: Path, name: str, pixels: np.ndarray, **options: Any) -> QgsRasterLayer:
    return QgsRasterLayer(write_raster(folder / name, pixels, **options), name)


# --- layers, ids, paths ----------------------------------------------------------------------------------------


def test_a_copy_of_the_mosaic_is_dropped_with_a_warning(scene: Scene, tmp_path: Path) -> None:
    """Under another name; it would explain all of the mosaic, and hide every loss."""
    flights = [
        np.clip(whole(path) + np.random.default_rng(seed).normal(0, 12, (3, 256, 512)), 1, 255).astype(np.uint8)
        for seed, path in enumerate((scene.west, scene.east))
    ]
    flights[1] = np.roll(flights[1], 3, axis=2)  # heights lean otherwise
    cut = np.where(np.arange(512) < 250, *flights)
    west, east, mosaic = (
        write_raster(tmp_path / f"{name}.tif", item) for name, item in zip(("west", "east", "mosaic"), (*flights, cut))
    )
    copy = str(tmp_path / "east_2.tif")
    gdal.Translate(copy, str(mosaic), creationOptions=["COMPRESS=LZW"])
    outcome = inspect(scene, MOSAIC=str(mosaic), SOURCES=[copy, west, east])
    (warning,) = outcome.log.warnings
    assert_sentence(warning, "east_2.tif matches the mosaic on both sides of its seams, so it is a copy")
    assert {row["source"] for row in outcome.rows("PAIRS")} == {"west.tif", "east.tif", "composite"}


def other_system(name: str) -> str:
    """What is said of a file that names another system than its layer (a pattern)."""
    return rf"{name}.tif is read in .*EPSG:{UTM33}.* not in that of its file, EPSG:2180"


@pytest.mark.parametrize("step", ["inspectwindows", "model"])
def test_a_reference_system_set_by_hand_is_taken_and_said_once(
    scene: Scene, tmp_path: Path, project: QgsProject, expected: list[dict[str, Any]], step: str
) -> None:
    """The layer's system is as after a file that names a wrong one: QGIS draws such layers in place."""
    layers = [
        file_of(tmp_path, path.name, whole(path), system=2180, nodata=0)
        for path in (scene.mosaic, scene.west, scene.east)
    ]
    project.addMapLayers(layers)
    for item in layers:
        item.setCrs(QgsCoordinateReferenceSystem(f"EPSG:{UTM33}"))
    ids = [layer.id() for layer in layers]
    if step == "inspectwindows":
        outcome = inspect(scene, MOSAIC=ids[0], SOURCES=ids[1:])
        assert outcome.rows("PAIRS") == expected
    else:
        seam = layer("LineString", [line((256, 0), (256, 256))])
        outcome = run("inspect_mosaic", seamlines=seam, mosaic=ids[0], sources=ids[1:], side=6.4, spacing=6.4)
        assert outcome.complaint is None
        assert len(outcome.rows("inspect:windows")) == 4
        assert "not_comparable" not in outcome.column("verdict", "inspect:windows")
    said = [text for text in outcome.log.infos if "not in that of its file" in text]
    of_mosaic = 1 if step == "inspectwindows" else 2  # of the model's steps, once by each
    for name, times in (("mosaic", of_mosaic), ("west", 1), ("east", 1)):
        assert sum(re.search(other_system(name), text) is not None for text in said) == times


def test_additional_nodata_of_a_layer_is_no_pixel(
    scene: Scene, tmp_path: Path, project: QgsProject
) -> None:
    """A white margin, which no file names."""
    layers = []
    for path in (scene.west, scene.east):
        image = whole(path)
        image[:, :, :40] = 255
        layers.append(file_of(tmp_path, path.name, image, nodata=0))
        for band in (1, 2, 3):
            layers[-1].dataProvider().setUserNoDataValue(band, [QgsRasterRange(255, 255)])
    project.addMapLayers(layers)
    in_margin = windows((0, 0, 64, 256))
    outcome = inspect(scene, WINDOWS=in_margin, SOURCES=[layer.id() for layer in layers])
    assert "source" not in outcome.column("role", "CURVES")  # there is no whole clip
    assert outcome.column("sources") == [2]  # of its other part
    for item in layers:
        for band in (1, 2, 3):
            item.dataProvider().setUserNoDataValue(band, [])
    plain = inspect(scene, WINDOWS=in_margin, SOURCES=[layer.id() for layer in layers])
    assert "source" in plain.column("role", "CURVES")


# --- resampled sources -----------------------------------------------------------------------------------------


def turned(angle: float) -> GeoTransform:
    """A geotransform of the scene's pixels, turned by some degrees around their middle, 256 px right and 128 down."""
    cosine, sine = 0.1 * np.cos(np.radians(angle)), 0.1 * np.sin(np.radians(angle))
    x, y = ORIGIN[0] + 25.6, ORIGIN[1] - 12.8
    return x - 256 * cosine - 128 * sine, cosine, sine, y - 256 * sine + 128 * cosine, sine, -cosine


def test_sources_in_other_systems_and_pixel_sizes_are_resampled(scene: Scene, tmp_path: Path) -> None:
    same = whole(scene.west)
    finer = np.repeat(np.repeat(same, 2, axis=1), 2, axis=2)
    paths = [
        write_raster(tmp_path / "finer.tif", finer, gsd=0.05),
        # What covers all of the mosaic in larger pixels would be taken for an overview of it.
        write_raster(tmp_path / "coarser.tif", same[:, 1::2, 1:400:2], gsd=0.2),
        write_raster(tmp_path / "turned.tif", same, geotransform=turned(0.3)),
        write_raster(tmp_path / "south_up.tif", same[:, ::-1], geotransform=SOUTH_UP),
    ]
    for name, system in (("utm34.tif", "EPSG:32634"), ("degrees.tif", "EPSG:4326")):
        gdal.Warp(str(tmp_path / name), str(scene.west), dstSRS=system, dstNodata=0, resampleAlg="cubic")
        paths.append(str(tmp_path / name))
    west = write_raster(tmp_path / "west.tif", same[..., :400])
    outcome = inspect(scene, WINDOWS=windows(MIDDLE), SOURCES=[*paths, west])
    assert not outcome.log.warnings
    pairs = {row["source"]: row for row in outcome.rows("PAIRS") if row["band"] == "luminance"}
    resampled = {source: row["resampled"] for source, row in pairs.items()}
    assert resampled == {**{Path(path).name: 1 for path in paths}, "south_up.tif": 0, "west.tif": 0, "composite": 1}
    for source, row in pairs.items():
        # All but the turned one show the same ground at the same place; that is turned by 0.4 px at the corners.
        assert row["similarity"] > 0.97, source
    for source in ("finer.tif", "south_up.tif"):  # averaging and turning over give back the very pixels
        assert pairs[source]["ratio_1"] == pytest.approx(pairs["west.tif"]["ratio_1"], rel=1e-6)


# --- the index -------------------------------------------------------------------------------------------------


def gdaltindex(folder: Path, name: str, *arguments: str) -> str:
    """An index by GDAL's own tool, made in the folder of the rasters."""
    subprocess.run(["gdaltindex", *arguments[:-2], name, *arguments[-2:]], cwd=folder, check=True, capture_output=True)
    return str(folder / name)


@pytest.mark.parametrize("absolute", [False, True])
@pytest.mark.parametrize("name", ["index.shp", "index.gpkg"])
def test_an_index_by_gdaltindex(
    scene: Scene, expected: list[dict[str, Any]], tmp_path: Path, name: str, absolute: bool
) -> None:
    for path in (scene.west, scene.east):
        os.link(path, tmp_path / path.name)
    options = ["-f", "GPKG"] if name.endswith(".gpkg") else []
    options += ["-write_absolute_path"] if absolute else []
    index = gdaltindex(tmp_path, name, *options, "west.tif", "east.tif")
    locations = {row["location"] for row in QgsVectorLayer(index, "index", "ogr").getFeatures()}
    assert all(os.path.isabs(location) == absolute for location in locations)
    assert inspect(scene, SOURCES=None, SOURCE_INDEX=index).rows("PAIRS") == expected
    opened = QgsVectorLayer(index, "index", "ogr")
    assert inspect(scene, SOURCES=[], SOURCE_INDEX=opened).rows("PAIRS") == expected
    beside = inspect(scene, SOURCES=[str(tmp_path / "west.tif")], SOURCE_INDEX=index)
    assert beside.rows("PAIRS") == expected


def test_relative_locations_start_at_the_index_and_not_at_the_working_folder(
    scene: Scene, expected: list[dict[str, Any]], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for folder in ("images", "elsewhere"):
        (tmp_path / folder).mkdir()
    for path in (scene.west, scene.east):
        os.link(path, tmp_path / "images" / path.name)
    gdaltindex(tmp_path, "index.shp", "images/west.tif", "images/east.tif")
    monkeypatch.chdir(tmp_path / "elsewhere")
    index = str(tmp_path / "index.shp")
    assert inspect(scene, SOURCES=None, SOURCE_INDEX=index).rows("PAIRS") == expected
