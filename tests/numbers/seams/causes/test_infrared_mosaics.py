"""An infrared mosaic (NIR, red, green) of orthoimages in red, green, blue and NIR: bands are matched by their roles."""
from __future__ import annotations

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery.open_raster import describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure.judgement.causes import Cause
from seam_inspector.plugin.seams.measure.judgement.verdicts import Verdict

from tests.numbers.seams.inspecting import MakeRaster, block_of, inspect, mosaic_of
from tests.numbers.seams.made_seams import SHAPE, WHOLE, as_bytes, blended, three_images
from tests.numbers.synthetic import texture

FEATHER_PX = 40.0
RED, GREEN, BLUE, UNDEFINED = gdal.GCI_RedBand, gdal.GCI_GreenBand, gdal.GCI_BlueBand, gdal.GCI_Undefined


@pytest.mark.parametrize("said", ["colours", "names"])
@pytest.mark.parametrize("width", [0.0, FEATHER_PX])
def test_an_infrared_mosaic_is_measured_as_the_coloured_one(make_raster: MakeRaster, width: float, said: str) -> None:
    given = [with_infrared(image, seed) for seed, image in enumerate(three_images()[:2])]
    mosaic, coloured = blended(given, width), [RED, GREEN, BLUE, UNDEFINED]
    paths = [make_raster(f"{'ab'[number]}.tif", image, colours=coloured) for number, image in enumerate(given)]
    plain = mosaic_of(make_raster, mosaic, "rgb.tif", colours=coloured)
    colours = [UNDEFINED, RED, GREEN] if said == "colours" else [RED, GREEN, BLUE]
    path = make_raster("cir.tif", mosaic[[3, 0, 1]], colours=colours)
    if said == "names":
        name_bands(path)
    results = [inspect(block_of(described, *paths), WHOLE) for described in (describe_mosaic(RasterRef(path)), plain)]
    assert {result.judgement.verdict for result in results} == {Verdict.SIGNIFICANT if width else Verdict.PRESERVED}
    assert {result.causes for result in results} == {(Cause.FEATHERING,) if width else (Cause.NONE,)}


def with_infrared(image: np.ndarray, seed: int) -> np.ndarray:
    """(4, rows, columns): plants are another picture in the infrared."""
    infrared = 120 + 25 * texture(SHAPE, 3.0, 77) + 9 * texture(SHAPE, 0.8, 90 + seed)
    return np.concatenate([image, as_bytes(infrared)[np.newaxis]])


def name_bands(path: str) -> None:
    dataset = gdal.Open(path, gdal.GA_Update)
    for number, name in enumerate(("NIR", "Red", "Green"), 1):
        dataset.GetRasterBand(number).SetDescription(name)
