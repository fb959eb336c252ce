"""Bad input of ``seaminspector:inspectwindows``: one sentence, and what can be measured is measured."""
from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from osgeo import gdal
from qgis.core import QgsGeometry, QgsRasterLayer, QgsVectorLayer

from tests.numbers.synthetic import ORIGIN, write_raster
from tests.qgis.runs import Run, assert_refused, assert_sentence, run
from tests.qgis.scenes import BLURRED, SHARP, Scene, at, layer, outline, pixel_box, whole, windows

pytestmark = pytest.mark.usefixtures("provider")

ROTATED = (ORIGIN[0], 0.09, 0.04, ORIGIN[1], 0.04, -0.09)
SOUTH_UP = (ORIGIN[0], 0.1, 0.0, ORIGIN[1], 0.0, 0.1)


def given(scene: Scene, **parameters: Any) -> dict[str, Any]:
    return {
        "WINDOWS": windows(SHARP, BLURRED), "MOSAIC": str(scene.mosaic), "SOURCES": scene.sources, **parameters
    }


def inspect(scene: Scene, **parameters: Any) -> Run:
    outcome = run("inspectwindows", **given(scene, **parameters))
    assert outcome.complaint is None
    return outcome


@pytest.fixture(scope="module")
def good(scene: Scene, provider: None) -> Iterator[Run]:
    """Run of sound input."""
    made = inspect(scene)
    yield made
    made.close()


# --- files -----------------------------------------------------------------------------------------------------


CHANGES: dict[str, tuple[Callable[[np.ndarray], np.ndarray], dict[str, Any]]] = {
    "no_system": (np.array, {"system": None}),
    "rotated": (np.array, {"geotransform": ROTATED}),
    "south_up": (np.array, {"geotransform": SOUTH_UP}),
    "far_away": (np.array, {"origin": (600000, 5100000)}),
    "complex_values": (lambda pixels: pixels.astype(np.complex64), {}),
    "nodata": (np.zeros_like, {"nodata": 0}),
    "constant": (lambda pixels: np.full_like(pixels, 77), {}),
    "not_a_number": (lambda pixels: np.full(pixels.shape, np.nan, np.float32), {}),
    "one_band": (lambda pixels: pixels[0], {}),
}
"""Pixels, and how they are written."""


def bad_file(kind: str, good: Path, folder: Path) -> str:
    """A file that is bad in one way, made of a good one."""
    path, pixels = folder / f"{kind}.tif", whole(good)
    if kind == "text":
        path.write_text("no raster")
    elif kind == "header_only":
        path.write_bytes(good.read_bytes()[:6])
    elif kind == "no_position":
        gdal.GetDriverByName("GTiff").Create(str(path), 512, 256, 3).WriteArray(pixels)
    elif kind == "half":  # its upper 60 % can be read, the rest can't
        write_raster(path, pixels, options=[], nodata=0)
        os.truncate(path, 6 * os.path.getsize(path) // 10)
    elif kind != "missing":
        changed, options = CHANGES[kind]
        write_raster(path, changed(pixels), **options)
    return str(path)


BAD_SOURCES = {
    "missing": "missing.tif is left out: .*missing.tif does not exist",
    "text": "text.tif is left out: text.tif is not a raster",
    "header_only": "header_only.tif is left out: header_only.tif is not a raster",
    "half": "half.tif can't be read; the file may be truncated",
    "no_system": "no_system.tif is left out: no_system.tif has no coordinate reference system",
    "no_position": "no_position.tif is left out: no_position.tif has no position",
    "complex_values": "complex_values.tif is left out: complex_values.tif holds complex values",
    "constant": "constant.tif has no variance",
    "one_band": "one_band.tif has no luminance",
    "nodata": "",  # does not cover the window, as any source may
    "not_a_number": "",
    "far_away": "",
    "rotated": "",
}


@pytest.mark.parametrize("kind", BAD_SOURCES)
def test_a_bad_source_does_not_cost_the_good_ones(scene: Scene, good: Run, tmp_path: Path, kind: str) -> None:
    bad = bad_file(kind, scene.west, tmp_path)
    outcome = inspect(scene, SOURCES=[bad, *scene.sources])
    if kind == "half":  # takes part in the upper window, as a part of the image that it was cut from
        assert outcome.column("sources") == [2, 2]
        assert outcome.rows()[1] == good.rows()[1]
    else:
        assert outcome.rows() == good.rows()
        assert outcome.rows("CURVES") == good.rows("CURVES")
    if not BAD_SOURCES[kind]:
        assert outcome.log.warnings == []
    else:
        (warning,) = outcome.log.warnings  # once, not in every window
        assert_sentence(warning, BAD_SOURCES[kind])


@pytest.mark.parametrize("other", ["vector", "service"])
def test_a_layer_that_is_no_file_among_the_sources_is_left_out(scene: Scene, good: Run, other: str) -> None:
    odd = (
        QgsVectorLayer("Polygon?crs=EPSG:32633", "parcels", "memory")
        if other == "vector"
        else QgsRasterLayer("type=xyz&url=http://127.0.0.1:9/{z}/{x}/{y}.png&zmax=19&zmin=0", "tiles", "wms")
    )
    outcome = inspect(scene, SOURCES=[odd, *scene.sources])
    assert outcome.rows() == good.rows()
    (warning,) = outcome.log.warnings
    assert_sentence(warning, "parcels is not a raster layer" if other == "vector" else "tiles .* comes from a service")


BAD_MOSAICS = {
    "missing": "missing.tif does not exist",
    "text": "text.tif is not a raster",
    "header_only": "header_only.tif is not a raster",
    "no_system": "no_system.tif has no coordinate reference system",
    "no_position": "no_position.tif has no position",
    "rotated": "rotated.tif is rotated",
    "complex_values": "complex_values.tif holds complex values",
}


@pytest.mark.parametrize("kind", BAD_MOSAICS)
def test_a_bad_mosaic_gets_a_sentence(scene: Scene, tmp_path: Path, kind: str) -> None:
    mosaic = bad_file(kind, scene.mosaic, tmp_path)
    assert_refused("inspectwindows", BAD_MOSAICS[kind], **given(scene, MOSAIC=mosaic))


@pytest.mark.parametrize(
    ("kind", "reason"),
    [
        ("nodata", r"100\.00\u00a0% of the pixels of nodata.tif are invalid"),
        ("constant", "The mosaic has no variance"),
        ("not_a_number", r"100\.00\u00a0% of the pixels"),
    ],
)
def test_a_mosaic_without_content_gives_reasons(scene: Scene, tmp_path: Path, kind: str, reason: str) -> None:
    outcome = inspect(scene, MOSAIC=bad_file(kind, scene.mosaic, tmp_path))
    assert outcome.column("verdict") == ["not_comparable"] * 2
    for text in outcome.column("reason"):
        assert_sentence(text, reason)


# --- windows ---------------------------------------------------------------------------------------------------


def crossing() -> QgsGeometry:
    (left, top), (right, bottom) = at(0, 0), at(128, 128)
    ring = f"{left} {top}, {right} {bottom}, {right} {top}, {left} {bottom}, {left} {top}"
    return QgsGeometry.fromWkt(f"POLYGON(({ring}))")


BAD_WINDOWS: list[tuple[Callable[[], QgsGeometry | None], str]] = [
    (crossing, "not a single polygon whose outline crosses nowhere"),
    (lambda: outline(SHARP).combine(outline(BLURRED)), "not a single polygon"),
    (lambda: None, "has no outline"),
    (lambda: QgsGeometry.fromWkt("POLYGON EMPTY"), "has no outline"),
    (lambda: outline((0, 0, 63, 128)), "63 x 128 px of the mosaic; a side needs at least 64 px"),
    (lambda: outline((470, 0, 128, 128)), "covers 42 x 128 px of the mosaic"),
    (lambda: outline((-500, 0, 128, 128)), "outside the mosaic"),
    (lambda: outline((0, 5000, 128, 128)), "outside the mosaic"),
]


def test_bad_windows_have_a_reason_and_the_good_ones_between_are_measured(scene: Scene, good: Run) -> None:
    shapes: list[QgsGeometry | None] = []
    for make, _ in BAD_WINDOWS:
        shapes += [make(), outline(SHARP)]
    outcome = inspect(scene, WINDOWS=layer("MultiPolygon", shapes))
    bad, between = outcome.rows()[::2], outcome.rows()[1::2]
    for row, (_, words) in zip(bad, BAD_WINDOWS):
        assert row["verdict"] == "not_comparable"
        assert_sentence(row["reason"], words)
        assert row["ratio_1"] is None
    expected = good.rows()[0]
    assert between == [{**expected, "window_id": number} for number in range(2, 17, 2)]
    assert outcome.results["NOT_COMPARABLE_COUNT"] == len(BAD_WINDOWS)
    # As drawn where nothing could be measured, so that one can see it on the map.
    assert pixel_box(outcome.features()[8].geometry()) == (0, 0, 63, 128)
    assert outcome.features()[4].geometry().isNull()


# --- settings and outputs --------------------------------------------------------------------------------------

BAD_VALUES: list[tuple[dict[str, Any], str]] = [
    ({"MOSAIC": None}, "is not a raster layer"),
    ({"MOSAIC": lambda: layer("Polygon", [])}, "made is not a raster layer"),
    ({"SOURCES": None}, "No sources are given; choose the orthoimages .* or an index of them"),
    ({"WINDOWS": windows}, "The window layer is empty; draw windows or place them"),
    ({"WINDOWS": "/nowhere/windows.gpkg"}, "/nowhere/windows.gpkg not found"),
]


@pytest.mark.parametrize(("parameters", "words"), BAD_VALUES, ids=lambda value: str(value).partition(" at 0x")[0][:40])
def test_bad_values_get_a_sentence(scene: Scene, parameters: dict[str, Any], words: str) -> None:
    values = {name: value() if callable(value) else value for name, value in parameters.items()}
    assert_refused("inspectwindows", words, **given(scene, **values))
