"""Patches as files, and the mended mosaic as a VRT: the mosaic below, which is never touched, the patches above."""
from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
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


@dataclass(frozen=True)
class PlacedPatch:
    """A patch that lies in a file."""

    path: str
    window: PixelWindow
    """Its place in the mosaic's pixels."""


def patch_file(mosaic: Raster, window: PixelWindow, pixels: np.ndarray, inside: np.ndarray) -> np.ndarray:
    """The bytes (n,) of a cloud-optimised GeoTIFF whose last band is alpha. Raises RasterError where memory lacks.

    ``pixels``: (bands, rows, columns); ``inside``: (rows, columns) bool.
    """
    opaque = np.iinfo(pixels.dtype).max if pixels.dtype.kind != "f" else 255
    made = np.where(inside, np.concatenate([pixels, np.full_like(pixels[:1], opaque)]), 0).astype(pixels.dtype)
    dataset = _created("MEM", mosaic, window)
    dataset.WriteArray(made)
    path = f"/vsimem/patch_{uuid4().hex}.tif"
    _write(path, dataset)
    return np.frombuffer(taken_from_memory(path), np.uint8)


def joined_patches(path: str, mosaic: Raster, patches: Sequence[PlacedPatch]) -> PlacedPatch:
    """All of them in one such file, sparse between them. Raises RasterError where it can't be written."""
    windows = [patch.window for patch in patches]
    left, top = min(window.column for window in windows), min(window.row for window in windows)
    right, bottom = max(part.column + part.width for part in windows), max(part.row + part.height for part in windows)
    whole = _created("VRT", mosaic, window := PixelWindow(left, top, right - left, bottom - top))
    moved = [PlacedPatch(patch.path, patch.window.moved_by(-left, -top)) for patch in patches]
    _lay(whole, range(whole.RasterCount), moved)
    _write(path, whole)
    return PlacedPatch(path, window)


def write_mended(path: str, mosaic: Raster, patches: Sequence[PlacedPatch]) -> None:
    """The mosaic and its patches as a VRT. Raises RasterError where it can't be written."""
    with whole_raster(path) as unfinished, gdal_writing(imagery_messages.RASTER_NOT_WRITTEN(path=path)):
        below = OpenRaster(mosaic.ref)
        whole = gdal.GetDriverByName("VRT").CreateCopy("", below.dataset)
        whole.SetProjection(mosaic.wkt)
        _lay(whole, below.roles.indices, patches)
        whole.SetMetadataItem("patches", str(len(patches)), MENDED_DOMAIN)
        Path(unfinished).write_text(whole.GetMetadata("xml:VRT")[0], encoding="utf-8")


def _created(driver: str, mosaic: Raster, window: PixelWindow) -> gdal.Dataset:
    """A raster in memory for the mosaic's bands and alpha, in a window of it."""
    kind = gdal_array.NumericTypeCodeToGDALTypeCode(np.dtype(mosaic.data_type).type)
    count = len(mosaic.band_names) + 1
    dataset = gdal.GetDriverByName(driver).Create("", window.width, window.height, count, kind)
    _, across, skew, _, down, height = mosaic.placement
    x, y = mosaic.grid.to_map(window.column, window.row)
    dataset.SetGeoTransform((x, across, skew, y, down, height))
    dataset.SetProjection(mosaic.wkt)
    for number, name in enumerate(mosaic.band_names, 1):
        dataset.GetRasterBand(number).SetColorInterpretation(_ROLES.get(name, gdal.GCI_Undefined))
    dataset.GetRasterBand(count).SetColorInterpretation(gdal.GCI_AlphaBand)
    return dataset


def _write(path: str, dataset: gdal.Dataset) -> None:
    """Write a cloud-optimised GeoTIFF; GDAL takes alpha for a mask in grey and coloured images of 8 and 16 bits,
    without sign, only: others get one."""
    count, kind = dataset.RasterCount, dataset.GetRasterBand(1).DataType
    mask = "auto" if count in (2, 4) and kind in (gdal.GDT_Byte, gdal.GDT_UInt16) else count
    with whole_raster(path) as unfinished, gdal_writing(imagery_messages.RASTER_NOT_WRITTEN(path=path)):
        gdal.Translate(unfinished, dataset, format="COG", creationOptions=_COG, maskBand=mask)


def _lay(whole: gdal.Dataset, bands: Sequence[int], patches: Sequence[PlacedPatch]) -> None:
    """Patches above these bands of a VRT, where their alpha is set."""
    for number, index in enumerate(bands, 1):
        for place, patch in enumerate(patches):
            path, window = escape(os.path.abspath(patch.path)), patch.window
            size = f'xSize="{window.width}" ySize="{window.height}"'
            source = (
                f'<ComplexSource><SourceFilename relativeToVRT="0">{path}</SourceFilename>'
                f"<SourceBand>{number}</SourceBand><UseMaskBand>true</UseMaskBand>"
                f'<SrcRect xOff="0" yOff="0" {size}/>'
                f'<DstRect xOff="{window.column}" yOff="{window.row}" {size}/></ComplexSource>'
            )
            whole.GetRasterBand(index + 1).SetMetadataItem(f"source_{place}", source, "new_vrt_sources")
