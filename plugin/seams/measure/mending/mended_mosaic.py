"""Patches as files, and the mended mosaic as a VRT: the mosaic below, which is never touched, the patches above."""
from __future__ import annotations

import os
from collections.abc import Mapping
from itertools import product
from pathlib import Path
from uuid import uuid4
from xml.sax.saxutils import escape

import numpy as np
from osgeo import gdal, gdal_array

from ....imagery import messages as imagery_messages
from ....imagery.gdal_calls import gdal_writing, taken_from_memory
from ....imagery.grids import PixelWindow
from ....imagery.open_raster import OpenRaster
from ....imagery.raster_writer import whole_raster
from ....imagery.rasters import Raster

MENDED_DOMAIN = "SEAM_INSPECTOR_MENDED"
"""Metadata domain of a mended mosaic: how many patches lie on it."""
_COG = ["COMPRESS=DEFLATE", "PREDICTOR=YES", "OVERVIEW_RESAMPLING=AVERAGE", "BIGTIFF=IF_SAFER", "SPARSE_OK=TRUE"]
_ROLES = {"red": gdal.GCI_RedBand, "green": gdal.GCI_GreenBand, "blue": gdal.GCI_BlueBand}


def patch_file(mosaic: Raster, window: PixelWindow, pixels: np.ndarray, inside: np.ndarray) -> np.ndarray:
    """The bytes (n,) of a cloud-optimised GeoTIFF whose last band is alpha. Raises RasterError where memory lacks.

    ``pixels``: (bands, rows, columns); ``inside``: (rows, columns) bool.
    """
    opaque = np.iinfo(pixels.dtype).max if pixels.dtype.kind != "f" else 255
    made = np.where(inside, np.concatenate([pixels, np.full_like(pixels[:1], opaque)]), 0).astype(pixels.dtype)
    kind = gdal_array.NumericTypeCodeToGDALTypeCode(pixels.dtype.type)
    dataset = gdal.GetDriverByName("MEM").Create("", window.width, window.height, len(made), kind)
    _, across, skew, _, down, height = mosaic.placement
    x, y = mosaic.grid.to_map(window.column, window.row)
    dataset.SetGeoTransform((x, across, skew, y, down, height))
    dataset.SetProjection(mosaic.wkt)
    for number, name in enumerate(mosaic.band_names, 1):
        dataset.GetRasterBand(number).SetColorInterpretation(_ROLES.get(name, gdal.GCI_Undefined))
    dataset.GetRasterBand(len(made)).SetColorInterpretation(gdal.GCI_AlphaBand)
    dataset.WriteArray(made)
    # GDAL takes alpha for a mask in grey and coloured images of 8 and 16 bits, without sign, only: others get one.
    mask = "auto" if len(made) in (2, 4) and kind in (gdal.GDT_Byte, gdal.GDT_UInt16) else len(made)
    path = f"/vsimem/patch_{uuid4().hex}.tif"
    with whole_raster(path), gdal_writing(imagery_messages.RASTER_NOT_WRITTEN(path=path)):
        gdal.Translate(path, dataset, format="COG", creationOptions=_COG, maskBand=mask)
    return np.frombuffer(taken_from_memory(path), np.uint8)


def write_mended(path: str, mosaic: Raster, patches: Mapping[str, PixelWindow]) -> None:
    """The mosaic and above it its patches, where their alpha is set, as a VRT. Raises RasterError where it can't be
    written.

    ``patches``: their places in the mosaic's pixels by their files.
    """
    with whole_raster(path) as unfinished, gdal_writing(imagery_messages.RASTER_NOT_WRITTEN(path=path)):
        below = OpenRaster(mosaic.ref)
        whole = gdal.GetDriverByName("VRT").CreateCopy("", below.dataset)
        whole.SetProjection(mosaic.wkt)
        placed = enumerate(patches.items())
        for (number, index), (place, (patch, window)) in product(enumerate(below.roles.indices, 1), placed):
            file = escape(os.path.abspath(patch))
            size = f'xSize="{window.width}" ySize="{window.height}"'
            source = (
                f'<ComplexSource><SourceFilename relativeToVRT="0">{file}</SourceFilename>'
                f"<SourceBand>{number}</SourceBand><UseMaskBand>true</UseMaskBand>"
                f'<SrcRect xOff="0" yOff="0" {size}/>'
                f'<DstRect xOff="{window.column}" yOff="{window.row}" {size}/></ComplexSource>'
            )
            whole.GetRasterBand(index + 1).SetMetadataItem(f"source_{place}", source, "new_vrt_sources")
        whole.SetMetadataItem("patches", str(len(patches)), MENDED_DOMAIN)
        Path(unfinished).write_text(whole.GetMetadata("xml:VRT")[0], encoding="utf-8")
