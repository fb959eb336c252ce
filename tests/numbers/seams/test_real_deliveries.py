"""Sound and spoilt deliveries of a real block, from its files to the decision, by the Python interface."""
from __future__ import annotations

from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal, ogr
from seam_inspector import Decision, ScanSettings, decide, limit_rules, make_delivery, open_block, scan, seam_rows
from seam_inspector.plugin.imagery.gdal_calls import gdal_silenced


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
    found = scan(block, ScanSettings(piece_m=5.0), seamlines=seamlines)
    delivery = make_delivery({"a": seam_rows(found)}, block.mosaic.wkt, {"a": found.told})
    assert (float(found.told["metres"]), delivery.lacking_m) == (found.seam_metres, 0)
    return decide(delivery, limit_rules(min_kept=0.7, max_share=0.02, max_run_m=25, min_measured=0.8))


@pytest.mark.slow
@pytest.mark.parametrize("is_given", [False, True])
@pytest.mark.parametrize("is_jpeg", [False, True])
def test_a_sound_delivery_is_accepted(tmp_path: Path, data_folder: Path, is_jpeg: bool, is_given: bool) -> None:
    mosaic, orthoimages, seamlines = files(data_folder)
    found = decision(as_jpeg(mosaic, tmp_path) if is_jpeg else mosaic, orthoimages, seamlines if is_given else "")
    assert found.accepted, str(found.sentences[0])


@pytest.mark.slow
def test_seams_left_out_of_the_seamlines_leave_it_open(tmp_path: Path, data_folder: Path) -> None:
    """Two neighbours are delivered as one polygon."""
    mosaic, orthoimages, seamlines = files(data_folder)
    given, made = ogr.Open(str(seamlines)), tmp_path / "seamlines.gpkg"
    with gdal_silenced():
        copy = ogr.GetDriverByName("GPKG").CopyDataSource(given, str(made))
    layer = copy.GetLayer(0)
    areas: dict[str, list[ogr.Geometry]] = {}
    for feature in layer:
        areas.setdefault(feature["source"], []).append(feature.geometry().Clone())
    shared = {
        (one, other): sum(a.Intersection(b).Length() for a in areas[one] for b in areas[other])
        for one, other in combinations(sorted(areas), 2)
    }
    one, other = max(shared, key=lambda pair: shared[pair])
    for feature in layer:
        if feature["source"] == other:
            feature["source"] = one
            layer.SetFeature(feature)
    del layer, copy
    found = decision(mosaic, orthoimages, made)
    assert found.accepted is None
    assert "are in no figure (the longest around" in str(found.sentences[0])


@pytest.mark.slow
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
    found = decision(made, orthoimages)
    assert found.accepted is None
    assert "are in no figure (the longest around" in str(found.sentences[0])
