"""Virtual rasters that point where they should not, or are made of too much."""
from __future__ import annotations

import re
from pathlib import Path

from osgeo import gdal

from fuzz.breakages.broken import RASTERS, Broken, breakage

EXTREMES = ("nan", "inf", "-1", "0", "1e300", "2147483647", "99999999999", "", "x")


@breakage(*RASTERS)
def vrt_words(broken: Broken) -> str:
    """A sound VRT with some of its numbers and words changed."""
    path = broken.renamed("made.vrt")
    gdal.BuildVRT(str(path), [str(broken.path)]).FlushCache()
    text = path.read_text()
    for _ in range(broken.random.choice((1, 1, 3))):
        places = list(re.finditer(r'(?<=")[^"<>]*(?=")|(?<=>)[^<>\n]+(?=<)', text))
        one = broken.random.choice(places)
        text = text[: one.start()] + broken.random.choice(EXTREMES) + text[one.end() :]
    path.write_text(text)
    return str(path)


def _vrt(
    broken: Broken, sources: list[str], name: str = "made.vrt", band: str = "", shape: tuple[int, int] | None = None
) -> Path:
    """A VRT of the raster's own shape and place, with other sources."""
    like = gdal.Open(str(broken.path))
    columns, rows = shape or (like.RasterXSize, like.RasterYSize)
    inside = "".join(
        f"<SimpleSource><SourceFilename>{source}</SourceFilename><SourceBand>1</SourceBand></SimpleSource>"
        for source in sources
    )
    path = broken.renamed(name)
    srs = like.GetProjection().replace("&", "&amp;").replace("<", "&lt;")
    transform = ", ".join(map(str, like.GetGeoTransform()))
    path.write_text(
        f'<VRTDataset rasterXSize="{columns}" rasterYSize="{rows}"><SRS>{srs}</SRS>'
        f'<GeoTransform>{transform}</GeoTransform>'
        f'<VRTRasterBand dataType="Byte" band="1"{band}>{inside}</VRTRasterBand></VRTDataset>'
    )
    return path


@breakage(*RASTERS)
def vrt_of_itself(broken: Broken) -> str:
    return str(_vrt(broken, [str(broken.renamed("made.vrt"))]))


@breakage(*RASTERS)
def vrts_in_a_ring(broken: Broken) -> str:
    count = broken.random.choice((2, 3, 40))
    for number in range(count):
        _vrt(broken, [str(broken.renamed(f"made{(number + 1) % count}.vrt"))], f"made{number}.vrt")
    return str(broken.renamed("made0.vrt"))


@breakage(*RASTERS)
def vrts_in_each_other(broken: Broken) -> str:
    """Each names the next one several times: all together are read a thousand times."""
    depth, times = broken.random.choice(((200, 1), (10, 2), (3, 10)))
    for number in range(depth):
        inner = broken.path if number == depth - 1 else broken.renamed(f"made{number + 1}.vrt")
        _vrt(broken, [str(inner)] * times, f"made{number}.vrt")
    return str(broken.renamed("made0.vrt"))


@breakage(*RASTERS)
def vrt_outside(broken: Broken) -> str:
    return str(_vrt(broken, [broken.random.choice((
        "/etc/passwd", str(broken.outside), "../../../../etc/passwd",
        "http://127.0.0.1:9/a.tif", "/vsicurl/http://127.0.0.1:9/a.tif", "/vsis3/no/such.tif",
        "PG:dbname=no", "WMS:http://127.0.0.1:9/", "/nowhere/a.tif", "",
    ))]))  # fmt: skip


@breakage(*RASTERS)
def vrt_of_raw_bytes(broken: Broken) -> str:
    """Takes any file for pixels."""
    source = broken.random.choice(("/etc/passwd", str(broken.outside)))
    like = gdal.Open(str(broken.path))
    path = _vrt(broken, [])
    band = (
        f'<VRTRasterBand dataType="Byte" band="1" subClass="VRTRawRasterBand"><SourceFilename>{source}'
        f"</SourceFilename><ImageOffset>0</ImageOffset><PixelOffset>1</PixelOffset><LineOffset>{like.RasterXSize}"
        "</LineOffset></VRTRasterBand>"
    )
    path.write_text(re.sub("<VRTRasterBand.*</VRTRasterBand>", band, path.read_text(), flags=re.S))
    return str(path)


@breakage(*RASTERS)
def vrt_with_python(broken: Broken) -> str:
    """A pixel function that leaves a file where it runs."""
    left = f"open({str(broken.renamed('RAN'))!r}, 'w').write('ran')\n"
    code = f"{left}def spoil(*a, **k):\n    {left}"
    path = _vrt(broken, [str(broken.path)], band=' subClass="VRTDerivedRasterBand"')
    function = (
        "<PixelFunctionType>spoil</PixelFunctionType><PixelFunctionLanguage>Python</PixelFunctionLanguage>"
        f"<PixelFunctionCode><![CDATA[{code}]]></PixelFunctionCode>"
    )
    path.write_text(path.read_text().replace("<SimpleSource>", function + "<SimpleSource>", 1))
    return str(path)


@breakage(*RASTERS)
def vrt_of_many(broken: Broken) -> str:
    count = broken.random.choice((2000, 20000))
    same = broken.random.random() < 0.5
    return str(_vrt(broken, [str(broken.path) if same else f"{broken.path}.{number}" for number in range(count)]))


@breakage(*RASTERS)
def vrt_of_no_size(broken: Broken) -> str:
    shape = broken.random.choice(((2**31 - 1, 2**31 - 1), (10**6, 10**6), (0, 0), (-5, 5), (2**31 - 1, 1)))
    return str(_vrt(broken, [str(broken.path)], shape=shape))


@breakage(*RASTERS)
def vrt_with_entities(broken: Broken) -> str:
    path = _vrt(broken, [str(broken.path)])
    bomb = '<!DOCTYPE a [<!ENTITY a "aaaaaaaaaa">' + "".join(
        f'<!ENTITY {chr(98 + number)} "{f"&{chr(97 + number)};" * 10}">' for number in range(9)
    ) + "]>"
    path.write_text(bomb + path.read_text().replace("<SRS>", "<Metadata><MDI key='x'>&j;</MDI></Metadata><SRS>"))
    return str(path)


@breakage(*RASTERS)
def vrt_warped(broken: Broken) -> str:
    """A warp whose words are changed."""
    path = broken.renamed("made.vrt")
    srs = broken.random.choice(("EPSG:3857", "EPSG:4326", "EPSG:32733"))
    try:
        made = gdal.Warp(str(path), str(broken.path), format="VRT", dstSRS=srs)
    except RuntimeError:
        made = None
    if made is None:
        return str(_vrt(broken, [str(broken.path)]))
    made.FlushCache()
    made = None
    text = path.read_text()
    places = list(re.finditer(r"(?<=>)[^<>\n]+(?=<)", text))
    one = broken.random.choice(places)
    path.write_text(text[: one.start()] + broken.random.choice(EXTREMES) + text[one.end() :])
    return str(path)
