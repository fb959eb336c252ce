"""Patches as files, and the mended mosaic as a VRT: the mosaic below, which is never touched, the patches above."""
from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from xml.sax.saxutils import escape

import numpy as np
from osgeo import gdal, gdal_array

from ....imagery import messages as imagery_messages
from ....imagery.gdal_calls import RASTERS, gdal_call, gdal_writing, open_dataset
from ....imagery.grids import PixelWindow
from ....imagery.open_raster import band_roles, describe_mosaic
from ....imagery.raster_writer import whole_raster
from ....imagery.rasters import Raster, RasterRef

_COG = ["COMPRESS=DEFLATE", "PREDICTOR=YES", "BIGTIFF=IF_SAFER", "SPARSE_OK=TRUE"]
_ROLES = {"red": gdal.GCI_RedBand, "green": gdal.GCI_GreenBand, "blue": gdal.GCI_BlueBand}


@dataclass(frozen=True)
class PlacedPatch:
    """A patch that lies in a file."""

    path: str
    window: PixelWindow
    """Of the mosaic's pixels."""


def write_patch(
    path: str, mosaic: Raster, window: PixelWindow, pixels: np.ndarray, inside: np.ndarray
) -> PlacedPatch:
    """A patch as a cloud-optimised GeoTIFF whose last band is alpha. Raises RasterError where it can't be written.

    ``pixels``: (bands, rows, columns); ``inside``: (rows, columns) bool.
    """
    failure = imagery_messages.RASTER_NOT_WRITTEN(path=path)
    opaque = np.iinfo(pixels.dtype).max if pixels.dtype.kind != "f" else 255
    made = np.where(inside, np.concatenate([pixels, np.full_like(pixels[:1], opaque)]), 0).astype(pixels.dtype)
    bands, rows, columns = made.shape
    kind = gdal_array.NumericTypeCodeToGDALTypeCode(made.dtype.type)
    dataset = gdal_call(lambda: gdal.GetDriverByName("MEM").Create("", columns, rows, bands, kind), failure)
    _, across, skew, _, down, height = mosaic.placement
    x, y = mosaic.grid.to_map(window.column, window.row)
    dataset.SetGeoTransform((x, across, skew, y, down, height))
    dataset.SetProjection(mosaic.wkt)
    dataset.WriteArray(made)
    for number, name in enumerate(mosaic.band_names, 1):
        dataset.GetRasterBand(number).SetColorInterpretation(_ROLES.get(name, gdal.GCI_Undefined))
    dataset.GetRasterBand(bands).SetColorInterpretation(gdal.GCI_AlphaBand)
    with whole_raster(path) as unfinished, gdal_writing(failure):
        _copy(dataset, unfinished)
    return PlacedPatch(path, window)


def joined_patches(path: str, mosaic: Raster, patches: Sequence[PlacedPatch]) -> PlacedPatch:
    """All of them in one such file, sparse between them. Raises RasterError where it can't be written."""
    failure = imagery_messages.RASTER_NOT_WRITTEN(path=path)
    windows = [one.window for one in patches]
    left, top = min(one.column for one in windows), min(one.row for one in windows)
    right, bottom = max(one.column + one.width for one in windows), max(one.row + one.height for one in windows)
    first = gdal_call(lambda: open_dataset(patches[0].path, RASTERS), failure)
    _, across, skew, _, down, height = mosaic.placement
    x, y = mosaic.grid.to_map(left, top)
    with whole_raster(path) as unfinished, gdal_writing(failure):
        whole = gdal.GetDriverByName("VRT").Create("", right - left, bottom - top, 0)
        whole.SetGeoTransform((x, across, skew, y, down, height))
        whole.SetProjection(mosaic.wkt)
        for number in range(1, first.RasterCount + 1):
            whole.AddBand(first.GetRasterBand(number).DataType)
            band = whole.GetRasterBand(number)
            band.SetColorInterpretation(first.GetRasterBand(number).GetColorInterpretation())
            for place, one in enumerate(patches):
                moved = PlacedPatch(one.path, one.window.moved_by(-left, -top))
                band.SetMetadataItem(f"source_{place}", _source(moved, number), "new_vrt_sources")
        _copy(whole, unfinished)
    return PlacedPatch(path, PixelWindow(left, top, right - left, bottom - top))


def open_mosaic(path: str) -> Raster:
    """A mended mosaic. Raises RasterError where it can't be read."""
    return describe_mosaic(RasterRef(path))


def write_mended(path: str, mosaic: Raster, patches: Sequence[PlacedPatch]) -> None:
    """The mosaic and its patches as a VRT. Raises RasterError where it can't be written."""
    failure = imagery_messages.RASTER_NOT_WRITTEN(path=path)
    with whole_raster(path) as unfinished, gdal_writing(failure):
        below = gdal_call(lambda: open_dataset(os.path.abspath(mosaic.ref.path), RASTERS), failure)
        whole = gdal.GetDriverByName("VRT").CreateCopy("", below)
        for number, index in enumerate(band_roles(below).indices, 1):
            band = whole.GetRasterBand(index + 1)
            for place, patch in enumerate(patches):
                band.SetMetadataItem(f"source_{place}", _source(patch, number), "new_vrt_sources")
        Path(unfinished).write_text(whole.GetMetadata("xml:VRT")[0], encoding="utf-8")


def _copy(dataset: gdal.Dataset, path: str) -> None:
    """As a cloud-optimised GeoTIFF; GDAL knows alpha as a mask of grey and coloured images only, others get one."""
    count = dataset.RasterCount
    gdal.Translate(path, dataset, format="COG", creationOptions=_COG, maskBand="auto" if count in (2, 4) else count)


def _source(patch: PlacedPatch, band: int) -> str:
    """One band of a patch where its alpha is set."""
    window = patch.window
    size = f'xSize="{window.width}" ySize="{window.height}"'
    return (
        f'<ComplexSource><SourceFilename relativeToVRT="0">{escape(os.path.abspath(patch.path))}</SourceFilename>'
        f"<SourceBand>{band}</SourceBand><UseMaskBand>true</UseMaskBand>"
        f'<SrcRect xOff="0" yOff="0" {size}/>'
        f'<DstRect xOff="{window.column}" yOff="{window.row}" {size}/></ComplexSource>'
    )
