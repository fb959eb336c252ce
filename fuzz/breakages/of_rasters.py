"""GeoTIFFs whose tags lie, and rasters that nobody expects."""
from __future__ import annotations

import struct
import zipfile
from typing import Any

import numpy as np
from osgeo import gdal, osr

from fuzz.breakages.broken import RASTERS, Broken, breakage

EXTREMES = (0, 1, 2, 3, 15, 16, 255, 256, 65535, 65536, 2**31 - 1, 2**31, 2**32 - 1)
SYSTEMS = (
    "", "EPSG:4326", "EPSG:32733", "EPSG:4978", "EPSG:5773", "EPSG:3857", "EPSG:32661", "EPSG:2180", "IAU:30100",
    "+proj=lcc +lat_1=0 +lat_2=0", "+proj=utm +zone=33 +units=us-ft", "+proj=omerc +lat_0=0 +alpha=0",
    'LOCAL_CS["x",UNIT["metre",1]]', 'LOCAL_CS["x",UNIT["metre",0]]', "EPSG:999999", "garbage", "EPSG:32633+5773",
    'ENGCRS["a",EDATUM["b"],CS[Cartesian,2],AXIS["x",east],AXIS["y",north],LENGTHUNIT["metre",1e300]]',
)  # fmt: skip
NUMBERS = ("nan", "inf", "-inf", "0", "-0.0", "1e300", "-1e300", "1e-300", "1e9", "-1")


@breakage(".tif")
def tags(broken: Broken) -> None:
    """One to three values of a TIFF's directories, whichever they are, become extreme."""
    content = bytearray(broken.path.read_bytes())
    for _ in range(broken.random.choice((1, 1, 2, 3))):
        _break_tag(content, broken)
    broken.path.write_bytes(content)


def _break_tag(content: bytearray, broken: Broken) -> None:
    order = "<" if content[:2] == b"II" else ">"
    if struct.unpack_from(order + "H", content, 2)[0] != 42:
        return
    entries, at, seen = [], struct.unpack_from(order + "I", content, 4)[0], set()
    while at and at not in seen and at + 2 < len(content):
        seen.add(at)
        count = struct.unpack_from(order + "H", content, at)[0]
        entries += [at + 2 + 12 * number for number in range(count) if at + 14 + 12 * number <= len(content)]
        end = at + 2 + 12 * count
        at = struct.unpack_from(order + "I", content, end)[0] if end + 4 <= len(content) else 0
    if not entries:
        return
    entry = broken.random.choice(entries)
    value = broken.random.choice(EXTREMES)
    kind, count = struct.unpack_from(order + "HI", content, entry + 2)
    what = broken.random.random()
    if what < 0.1:
        struct.pack_into(order + "H", content, entry + 2, broken.random.choice((0, 1, 2, 3, 4, 5, 11, 12, 13, 16)))
    elif what < 0.25:
        struct.pack_into(order + "I", content, entry + 4, value)
    elif kind == 3 and count == 1:
        struct.pack_into(order + "H", content, entry + 8, value & 0xFFFF)
    elif count * {3: 2, 4: 4, 12: 8, 16: 8}.get(kind, 1) > 4 and what < 0.7:
        place = struct.unpack_from(order + "I", content, entry + 8)[0] + 4 * broken.random.randrange(min(count, 999))
        if place + 8 <= len(content):
            bad = struct.pack(order + "d", broken.random.choice((np.nan, np.inf, -np.inf, 0.0, 1e300, -1e300)))
            content[place : place + 8] = bad if kind == 12 else struct.pack(order + "I", value) * 2
    else:
        struct.pack_into(order + "I", content, entry + 8, value)


@breakage(*RASTERS)
def geotransform(broken: Broken) -> str:
    """A geotransform by a VRT over the file, since GDAL writes no such thing into one."""
    kept = [str(value) for value in gdal.Open(str(broken.path)).GetGeoTransform()]
    for _ in range(broken.random.choice((1, 1, 2, 6))):
        kept[broken.random.randrange(6)] = broken.random.choice(NUMBERS)
    return _wrapped(broken, ", ".join(kept))


@breakage(*RASTERS)
def system(broken: Broken) -> str:
    text = broken.random.choice(SYSTEMS)
    reference = osr.SpatialReference()
    try:
        known = text and reference.SetFromUserInput(text) == 0
    except RuntimeError:
        known = False
    wkt = reference.ExportToWkt() if known else text
    return _wrapped(broken, srs=wkt)


def _wrapped(broken: Broken, transform: str = "", srs: str | None = None) -> str:
    """A VRT over the file."""
    source = gdal.Open(str(broken.path))
    bands = "".join(
        f'<VRTRasterBand dataType="{gdal.GetDataTypeName(source.GetRasterBand(number).DataType)}" band="{number}">'
        f"<SimpleSource><SourceFilename>{broken.path}</SourceFilename><SourceBand>{number}</SourceBand></SimpleSource>"
        "</VRTRasterBand>"
        for number in range(1, source.RasterCount + 1)
    )
    wkt = source.GetProjection() if srs is None else srs
    place = transform or ", ".join(map(str, source.GetGeoTransform()))
    path = broken.renamed("wrapped.vrt")
    wkt = wkt.replace("&", "&amp;").replace("<", "&lt;")
    path.write_text(
        f'<VRTDataset rasterXSize="{source.RasterXSize}" rasterYSize="{source.RasterYSize}"><SRS>{wkt}</SRS>'
        f"<GeoTransform>{place}</GeoTransform>{bands}</VRTDataset>"
    )
    return str(path)


@breakage(*RASTERS)
def values(broken: Broken) -> str:
    """Pixels that are no numbers, extreme, the same everywhere, or of a type nobody expects."""
    source = gdal.Open(str(broken.path))
    kinds = (gdal.GDT_Byte, gdal.GDT_UInt16, gdal.GDT_Int16, gdal.GDT_UInt32, gdal.GDT_Int32, gdal.GDT_Float32,
             gdal.GDT_Float64, gdal.GDT_CFloat32, gdal.GDT_CInt16, gdal.GDT_UInt64, gdal.GDT_Int64)
    kind = broken.random.choice(kinds)
    pixels = source.ReadAsArray().astype(float)
    bad = broken.random.choice((np.nan, np.inf, -np.inf, 1e38, -1e38, 1e300, 0.0, -1.0, 255.0, 2.0**63))
    share = broken.random.choice((0.0, 0.001, 0.01, 0.5, 1.0))
    chosen = np.random.default_rng(broken.random.randrange(2**31)).random(pixels.shape) < share
    with np.errstate(all="ignore"):
        pixels[chosen] = bad
        return _written(broken, pixels, kind, source)


def _written(broken: Broken, pixels: np.ndarray, kind: int, like: Any) -> str:
    bands = pixels.reshape(-1, *pixels.shape[-2:])
    path = broken.renamed("made.tif")
    made = gdal.GetDriverByName("GTiff").Create(str(path), bands.shape[2], bands.shape[1], len(bands), kind)
    made.SetGeoTransform(like.GetGeoTransform())
    made.SetProjection(like.GetProjection())
    nodata = broken.random.choice((None, None, 0.0, float("nan"), -9999.0, 1e300, 255.0))
    if nodata is not None and kind not in (gdal.GDT_UInt64, gdal.GDT_Int64):
        made.GetRasterBand(1).SetNoDataValue(nodata)
    made.WriteArray(bands)
    made.FlushCache()
    return str(path)


@breakage(*RASTERS)
def small(broken: Broken) -> str:
    """A piece of the raster: a pixel, a line, a column, a few."""
    source = gdal.Open(str(broken.path))
    columns, rows = (broken.random.choice((1, 2, 3, 7, 17, 63)) if broken.random.random() < 0.7 else side
                     for side in (source.RasterXSize, source.RasterYSize))
    path = broken.renamed("made.tif")
    window = [0, 0, min(columns, source.RasterXSize), min(rows, source.RasterYSize)]
    gdal.Translate(str(path), source, srcWin=window).FlushCache()
    return str(path)


@breakage(*RASTERS)
def bands(broken: Broken) -> str:
    """One, two, or very many."""
    source = gdal.Open(str(broken.path))
    count = broken.random.choice((1, 2, 5, 300, 5000))
    path = broken.renamed("made.vrt")
    gdal.Translate(str(path), source, bandList=[1 + number % source.RasterCount for number in range(count)],
                   format="VRT").FlushCache()
    return str(path)


@breakage(*RASTERS)
def sparse(broken: Broken) -> str:
    """An image of 10^12 pixels and no bytes, at the place of the raster."""
    like, path = gdal.Open(str(broken.path)), broken.renamed("made.tif")
    block = broken.random.choice((("4096", "4096"), ("16384", "16384"), ("1000000", "16")))
    options = ["SPARSE_OK=TRUE", "TILED=YES", f"BLOCKXSIZE={-(-int(block[0]) // 16) * 16}", f"BLOCKYSIZE={block[1]}",
               "COMPRESS=DEFLATE", "BIGTIFF=YES"]
    count = broken.random.choice((1, 3))
    made = gdal.GetDriverByName("GTiff").Create(str(path), 1_000_000, 1_000_000, count, gdal.GDT_Byte, options)
    place = list(like.GetGeoTransform())
    if broken.random.random() < 0.5:  # the same ground in far smaller pixels
        place[1] *= like.RasterXSize / 1e6
        place[5] *= like.RasterYSize / 1e6
    made.SetGeoTransform(place)
    made.SetProjection(like.GetProjection())
    made.FlushCache()
    return str(path)


@breakage(*RASTERS)
def one_huge_block(broken: Broken) -> str:
    """A bomb: some kilobytes that are a gigabyte of pixels once one of them is wanted."""
    like, path = gdal.Open(str(broken.path)), broken.renamed("made.tif")
    options = ["SPARSE_OK=TRUE", "TILED=YES", "BLOCKXSIZE=30000", "BLOCKYSIZE=30000", "COMPRESS=DEFLATE"]
    options[2:4] = ["BLOCKXSIZE=32768", "BLOCKYSIZE=32768"]
    made = gdal.GetDriverByName("GTiff").Create(str(path), 32768, 32768, 3, gdal.GDT_Byte, options)
    made.SetGeoTransform(like.GetGeoTransform())
    made.SetProjection(like.GetProjection())
    made.FlushCache()
    return str(path)


@breakage(*RASTERS)
def archive_bomb(broken: Broken) -> str:
    """A raster in an archive with far more behind it than there is room for."""
    path = broken.renamed("bomb.zip")
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as file, file.open("a.tif", "w") as inside:
        inside.write(broken.path.read_bytes()[: broken.random.choice((8, 400, 10**6))])
        piece = bytes(2**20)
        for _ in range(64):
            inside.write(piece)
    return f"/vsizip/{path}/a.tif"
