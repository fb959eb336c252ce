"""Sound and spoilt deliveries of a real block, from its files to the decision, by the Python interface."""
from __future__ import annotations

from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal, ogr
from seam_inspector import Decision, ScanSettings, decide, limit_rules, open_block, scan


def files(folder: Path) -> tuple[Path, list[Path], Path]:
    """Mosaic cut hard, orthoimages, polygons of what each part is made from."""
    block = folder / "seams" / "brighton"
    if not block.is_dir():
        pytest.skip(f"no real data at {block}")
    return block / "mosaic_hardseam.tif", sorted(block.glob("DJI*.tif")), block / "seamlines.gpkg"


def as_jpeg(path: Path, folder: Path) -> Path:
    """At quality 90, its nodata as a mask."""
    given, made = gdal.Open(str(path)), folder / "mosaic_90.tif"
    mask = given.GetRasterBand(1).GetMaskBand().ReadAsArray()
    options = ["COMPRESS=JPEG", "JPEG_QUALITY=90", "PHOTOMETRIC=YCBCR", "TILED=YES"]
    gdal.Translate(str(made), given, creationOptions=options, noData="none")
    dataset = gdal.Open(str(made), gdal.GA_Update)
    gdal.SetConfigOption("GDAL_TIFF_INTERNAL_MASK", "YES")
    dataset.CreateMaskBand(gdal.GMF_PER_DATASET)
    gdal.SetConfigOption("GDAL_TIFF_INTERNAL_MASK", None)
    dataset.GetRasterBand(1).GetMaskBand().WriteArray(mask)
    return made


def decision(mosaic: Path, orthoimages: list[Path], seamlines: Path | str = "") -> Decision:
    block = open_block(mosaic, orthoimages)
    result = scan(block, ScanSettings(piece_m=3.0), seamlines=seamlines)
    made = decide({"a": result}, limit_rules(min_kept=0.7, max_share=0.02, max_run_m=25, min_measured=0.8))
    assert (float(result.told["metres"]), made.delivery.lacking_m) == (result.seam_metres, 0)
    return made


@pytest.mark.release
@pytest.mark.parametrize("is_given", [False, True])
@pytest.mark.parametrize("is_jpeg", [False, True])
def test_a_sound_delivery_is_accepted(tmp_path: Path, data_folder: Path, is_jpeg: bool, is_given: bool) -> None:
    mosaic, orthoimages, seamlines = files(data_folder)
    decided = decision(as_jpeg(mosaic, tmp_path) if is_jpeg else mosaic, orthoimages, seamlines if is_given else "")
    assert decided.accepted, str(decided.sentences[0])
    assert any("compared with the orthoimages that were given" in str(sentence) for sentence in decided.sentences)


def part(mosaic: Path, made: Path, width: int) -> Path:
    """900 rows where many orthoimages meet, from the left."""
    gdal.Translate(str(made), str(mosaic), srcWin=[950, 1000, width, 900])
    return made


def borders(seamlines: Path, mosaic: Path) -> list[ogr.Geometry]:
    """Between two polygons on a mosaic, the longest first."""
    given, raster = ogr.Open(str(seamlines)), gdal.Open(str(mosaic))
    left, size, _, top, _, _ = raster.GetGeoTransform()
    right, bottom = left + size * raster.RasterXSize, top - size * raster.RasterYSize
    corners = (left, bottom), (right, bottom), (right, top), (left, top), (left, bottom)
    extent = ogr.CreateGeometryFromWkt(f"POLYGON(({', '.join(f'{x} {y}' for x, y in corners)}))")
    areas = [feature.geometry().Intersection(extent) for feature in given.GetLayer(0)]
    shared = (area.Intersection(other) for area, other in combinations(areas, 2))
    lines = (ogr.ForceToMultiLineString(border) for border in shared if border and border.GetDimension() == 1)
    return sorted(lines, key=lambda line: -line.Length())


def as_lines(given: Path, path: Path, lines: list[ogr.Geometry]) -> Path:
    """In the reference system of the polygons."""
    polygons, made = ogr.Open(str(given)), ogr.GetDriverByName("GPKG").CreateDataSource(str(path))
    layer = made.CreateLayer("seams", polygons.GetLayer(0).GetSpatialRef(), ogr.wkbMultiLineString)
    for line in lines:
        feature = ogr.Feature(layer.GetLayerDefn())
        feature.SetGeometry(line)
        layer.CreateFeature(feature)
    return path


@pytest.mark.release
@pytest.mark.parametrize("left_out", [slice(0, 1), slice(3, 6), slice(5, 8)])
def test_seams_left_out_of_the_seamlines_leave_it_open(tmp_path: Path, data_folder: Path, left_out: slice) -> None:
    """The longest, or some of 190 to 530 px each."""
    mosaic, orthoimages, seamlines = files(data_folder)
    made = part(mosaic, tmp_path / "part.tif", 1100)
    lines = borders(seamlines, made)
    assert decision(made, orthoimages, as_lines(seamlines, tmp_path / "all.gpkg", lines)).accepted
    del lines[left_out]
    decided = decision(made, orthoimages, as_lines(seamlines, tmp_path / "some.gpkg", lines))
    assert decided.accepted is None
    assert "the scan saw the mosaic change from one orthoimage to another" in str(decided.why)


@pytest.mark.release
def test_a_sound_part_with_seamlines_is_accepted(tmp_path: Path, data_folder: Path) -> None:
    """Filters and ground are learned from all of it, however little that is."""
    mosaic, orthoimages, seamlines = files(data_folder)
    made = part(mosaic, tmp_path / "part.tif", 550)
    assert decision(made, orthoimages, seamlines).accepted


@pytest.mark.release
def test_a_strip_cut_out_along_a_seam_leaves_it_open(tmp_path: Path, data_folder: Path) -> None:
    mosaic, orthoimages, _ = files(data_folder)
    label = gdal.Open(str(mosaic.with_name("source_label.tif"))).ReadAsArray()
    made = tmp_path / "cut.tif"
    gdal.Translate(str(made), str(mosaic))
    dataset = gdal.Open(str(made), gdal.GA_Update)
    pixels = dataset.ReadAsArray()
    for axis in (0, 1):
        here, there = (label[1:], label[:-1]) if axis == 0 else (label[:, 1:], label[:, :-1])
        for row, column in np.argwhere((here != there) & (here > 0) & (there > 0))[::8].tolist():
            if row < len(label) // 2:
                pixels[:, max(row - 20, 0) : row + 20, max(column - 20, 0) : column + 20] = 0
    dataset.WriteArray(pixels)
    del dataset
    decided = decision(made, orthoimages)
    assert decided.accepted is None
    assert "the scan saw the mosaic change from one orthoimage to another" in str(decided.why)
