"""Small sound inputs for every algorithm, made once a run: the same files, whenever they are made."""
from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import numpy as np
from osgeo import gdal

from fuzz import desk
from fuzz.running import run
from tests.numbers.photos.photos import CAMERA
from tests.numbers.sensors.sensor_scenes import made_rational, places
from tests.numbers.sensors.test_frame_cameras import TABLE, YAML
from tests.numbers.synthetic import UTM33, wkt, write_plain, write_raster
from tests.qgis.photos.photo_scenes import make_photo
from tests.qgis.resolution.bar_scenes import make_bar_scene
from tests.qgis.scenes import BLURRED, SHARP, layer, line, make_scene, outline, saved, windows
from tests.qgis.seams.scan_scenes import COLUMNS, ROWS, write_scene

PIECE_M = 5.0
PATIENCE_SECONDS = 300.0  # with a busy machine
POINTS = 40
JRC = {"name": "mine", "rules": [{"check": "peak", "least": 0.3, "most": 0.7, "source": "mine"}]}
ACCEPTANCE = {
    "name": "mine",
    "rules": [
        {"check": "kept", "least": 0.7, "source": "mine"}, {"check": "failed_share", "most": 0.02, "source": "mine"},
        {"check": "measured_share", "least": 0.5, "source": "mine"},
    ],
}


def make_samples(folder: Path) -> None:
    """Fill a folder with all that ``calls`` name."""
    folder.mkdir(parents=True)
    _rasters(folder)
    _layers(folder)
    _photos(folder)
    _sensors(folder)
    _rules(folder)
    _derived(folder)


def _rasters(folder: Path) -> None:
    scene = make_scene(folder)
    (folder / "scan").mkdir()
    write_scene(folder / "scan", nodata=0)
    mosaic = gdal.Open(str(scene.mosaic))
    for name, options in {
        "jpeg.tif": ["COMPRESS=JPEG", "PHOTOMETRIC=YCBCR", "TILED=YES"], "lzw.tif": ["COMPRESS=LZW", "PREDICTOR=2"],
        "plain.tif": ["INTERLEAVE=BAND"], "zstd.tif": ["COMPRESS=ZSTD", "TILED=YES", "BLOCKXSIZE=64", "BLOCKYSIZE=64"],
        "big.tif": ["BIGTIFF=YES", "COMPRESS=PACKBITS"], "webp.tif": ["COMPRESS=WEBP", "TILED=YES"],
    }.items():  # fmt: skip
        gdal.GetDriverByName("GTiff").CreateCopy(str(folder / name), mosaic, options=options)
    gdal.GetDriverByName("COG").CreateCopy(str(folder / "cog.tif"), mosaic, options=["BLOCKSIZE=128"])
    overviews = str(folder / "overviews.tif")
    shutil.copy(scene.mosaic, overviews)
    gdal.Open(overviews, gdal.GA_Update).BuildOverviews("average", [2, 4])
    gdal.GetDriverByName("JPEG").CreateCopy(str(folder / "picture.jpg"), mosaic, options=["WORLDFILE=YES"])
    gdal.GetDriverByName("PNG").CreateCopy(str(folder / "picture.png"), mosaic)
    for name in ("picture.jpg.aux.xml", "picture.png.aux.xml"):
        (folder / name).write_text(f"<PAMDataset><SRS>{_xml(wkt(UTM33))}</SRS></PAMDataset>")
    gdal.BuildVRT(str(folder / "mosaic.vrt"), [str(scene.mosaic)]).FlushCache()
    random = np.random.default_rng(4)
    pixels = random.integers(1, 255, (3, 256, 512))
    valid = np.ones((256, 512), bool)
    valid[:, 400:] = False
    write_raster(folder / "masked.tif", pixels.astype(np.uint8), valid=valid)
    write_raster(folder / "deep.tif", (16 * pixels).astype(np.uint16))
    write_raster(folder / "float.tif", pixels.astype(np.float32), nodata=float("nan"))
    write_raster(folder / "alpha.tif", np.concatenate([pixels, 255 * valid[np.newaxis]]).astype(np.uint8),
                 colours=[gdal.GCI_RedBand, gdal.GCI_GreenBand, gdal.GCI_BlueBand, gdal.GCI_AlphaBand])


def _layers(folder: Path) -> None:
    seam = layer("LineString", [line((256, 0), (250, 120), (262, 256)), line((0, 200), (512, 190))],
                 source=("string(20)", ["west", "east"]))
    for ending in ("gpkg", "shp", "geojson"):
        saved(seam, folder / f"seams.{ending}")
    saved(layer("Polygon", [outline((0, 0, 256, 256)), outline((256, 0, 256, 256))],
                source=("string(20)", ["west.tif", "east.tif"])), folder / "cells.gpkg")
    drawn = windows(SHARP, BLURRED, window_id=("integer", [1, 2]), group=("string(20)", ["a", "b"]),
                    observer=("string(20)", ["invisible", "visible"]))
    for ending in ("gpkg", "shp", "geojson"):
        saved(drawn, folder / f"windows.{ending}")
    saved(windows((0, 0, 512, 256), (0, 0, 512, 256), location=("string(80)", ["west.tif", "east.tif"])),
          folder / "index.gpkg")
    saved(layer("LineString", [line((210, 0), (210, 520))]), folder / "scan" / "seam.gpkg")
    saved(windows((30, 30, 60, 60)), folder / "grey.gpkg")
    saved(windows((0, 0, 256, 256), (256, 0, 256, 256), name=("string(9)", ["A", "B"])), folder / "sheets.gpkg")
    sides = (0, 0, COLUMNS // 2, ROWS), (COLUMNS // 2, 0, COLUMNS // 2, ROWS)
    (folder / "delivery").mkdir()
    for name, side in zip("AB", sides):
        gdal.Translate(str(folder / "delivery" / f"{name}.tif"), str(folder / "scan" / "mosaic.tif"), srcWin=side)
    saved(windows(*sides, sheet=("string(9)", ["A", "B"])), folder / "ordered.gpkg")
    saved(windows(*[(0, 0, COLUMNS, ROWS)] * 2, location=("string(80)", ["west.tif", "east.tif"])),
          folder / "scan" / "index.gpkg")
    bars = make_bar_scene(folder)
    saved(bars.lines(), folder / "bars.gpkg")
    rows = [f"{height},{height / 100 + step}" for height in (1000, 2000, 3000) for step in (0, 1)]
    (folder / "observations.csv").write_text("\n".join(["height,grd", *rows]) + "\n")


def _photos(folder: Path) -> None:
    scene = make_photo(folder, seed=3, rotation=1.2)
    column, row = (int(place) for place in scene.frame.places["1"])
    write_plain(folder / "template.tif", scene.frame.pixels[row - 30 : row + 30, column - 30 : column + 30])
    for name in ("first", "second"):
        (folder / name).mkdir()
    rows = [
        f'<MesureAppuiFlottant1Im><NameIm>{photo}.jpg</NameIm>' + "".join(
            f"<OneMesureAF1I><NamePt>{mark}</NamePt><PtIm>{10 * mark + 0.1} {20 * mark}</PtIm></OneMesureAF1I>"
            for mark in range(1, 5)
        ) + "</MesureAppuiFlottant1Im>" for photo in (1, 2)
    ]  # fmt: skip
    for photo, marks in enumerate(rows, 1):
        text = f'<?xml version="1.0"?>\n<SetOfMesureAppuisFlottants>{marks}</SetOfMesureAppuisFlottants>\n'
        (folder / "first" / f"MeasuresIm-{photo}.jpg.xml").write_text(text)
        table = [f"{mark},{10 * mark},{20 * mark}" for mark in range(1, 5)]
        (folder / "second" / f"{photo}.csv").write_text("\n".join(["mark,column,row", *table]) + "\n")
    camera = "".join(
        f"<OneMesureAF1I><NamePt>{name}</NamePt><PtIm>{x} {y}</PtIm></OneMesureAF1I>"
        for name, (x, y) in sorted(CAMERA.items())
    )
    (folder / "MeasuresCamera.xml").write_text(
        '<?xml version="1.0"?>\n<SetOfMesureAppuisFlottants><MesureAppuiFlottant1Im><NameIm>all</NameIm>'
        f"{camera}</MesureAppuiFlottant1Im></SetOfMesureAppuisFlottants>\n"
    )


def _sensors(folder: Path) -> None:
    random = np.random.default_rng(3)
    ground = places(POINTS, 3)
    size = np.array([60.0, 40.0])
    model = made_rational(1, 2, 0.001)
    image = (model.project(ground) + random.normal(0, 9, (POINTS, 2))) / [40000.0, 23000.0] * size
    write_plain(folder / "image.tif", random.integers(1, 255, (40, 60)).astype(np.uint8))
    table = [f"{c},{r},{x},{y},{z}" for (c, r), (x, y, z) in zip(image, ground)]
    (folder / "gcps.csv").write_text("\n".join(["column,row,x,y,z", *table]) + "\n")
    lines = [f"{x},{y},{c},{-r},1,0,0,0" for (x, y, _), (c, r) in zip(ground, image)]
    (folder / "image.points").write_text(
        "\n".join(["#CRS: EPSG:4326", "mapX,mapY,sourceX,sourceY,enable,dX,dY,residual", *lines]) + "\n"
    )
    members = [
        {"type": "Feature", "properties": {"column": place[0], "row": place[1], "id": str(number)},
         "geometry": {"type": "Point", "coordinates": list(position)}}
        for number, (place, position) in enumerate(zip(image, ground))
    ]
    (folder / "gcps.geojson").write_text(json.dumps({"type": "FeatureCollection", "features": members}))
    left, top = ground[:, 0].min() - 0.1, ground[:, 1].max() + 0.1
    heights = 600 + 50 * random.random((60, 60))
    write_raster(folder / "dem.tif", heights.astype(np.float32), geotransform=(left, 0.01, 0, top, 0, -0.01),
                 system=4326)
    write_raster(folder / "geoid.tif", np.full((20, 20), 50, np.float32), geotransform=(5, 0.2, 0, 46, 0, -0.2),
                 system=4326, options=())
    write_raster(folder / "sea.tif", np.full((20, 20), 50, np.float32), geotransform=(13, 0.2, 0, 38, 0, -0.2),
                 system=4326, options=())
    photo = random.integers(1, 255, (60, 80)).astype(np.uint8)
    (folder / "photos").mkdir()
    for path in (folder / "photo.tif", folder / "photos" / "photo.tif"):
        write_plain(path, photo)
    terrain = (100 + 30 * random.random((80, 80))).astype(np.float32)
    write_raster(folder / "terrain.tif", terrain, geotransform=(498_000, 50, 0, 4_002_000, 0, -50))
    (folder / "camera.yaml").write_text(YAML)
    (folder / "exterior.csv").write_text(TABLE)
    (folder / "exterior.geojson").write_text(json.dumps({
        "world_crs": "EPSG:32633",
        "features": [{"properties": {"filename": "photo", "camera": "cam", "xyz": [5e5, 4e6, 1500],
                                     "opk": [0.02, -0.03, 0.5]}}],
    }))  # fmt: skip


def _rules(folder: Path) -> None:
    (folder / "radiometry.json").write_text(json.dumps(JRC, indent=1))
    (folder / "acceptance.json").write_text(json.dumps(ACCEPTANCE, indent=1))


def _derived(folder: Path) -> None:
    """What algorithms take of others."""
    made = {
        "scanmosaic": {"SEAMS": "scan_seams.gpkg", "LOSS": "scan_loss.tif"},
        "inspectwindows": {
            "OUTPUT": "inspected.gpkg", "CURVES": "curves.gpkg", "PAIRS": "pairs.gpkg", "PROFILES": "profiles.gpkg",
        },
        "checkradiometry": {"OUTPUT": "checked.gpkg"},
        "interiororientation": {"OUTPUT": "marks.gpkg"},
        "fitsensormodel": {"OUTPUT": "residuals.gpkg", "MODEL_FILE": "model.json", "RPC": "rpc/image.RPB"},
    }
    given: dict[str, dict[str, Any]] = {
        "scanmosaic": {
            "MOSAIC": str(folder / "scan" / "mosaic.tif"), "PIECE": PIECE_M, "WORST_COUNT": 3,
            "SOURCES": [str(folder / "scan" / f"{name}.tif") for name in ("west", "east")],
        },
        "inspectwindows": {
            "WINDOWS": str(folder / "windows.gpkg"), "MOSAIC": str(folder / "mosaic.tif"),
            "SOURCES": [str(folder / "west.tif"), str(folder / "east.tif")],
        },
        "checkradiometry": {"RASTERS": [str(folder / "scan" / "mosaic.tif")]},
        "interiororientation": {"PHOTO": str(folder / "photo.bmp"), "CALIBRATION": str(folder / "camera.csv")},
        "fitsensormodel": {
            "GCPS": gcps_address(folder / "gcps.csv"), "IMAGE": str(folder / "image.tif"), "HEIGHTS": "ellipsoid",
        },
    }
    (folder / "rpc").mkdir()  # one beside its image would be what the image has by itself
    for algorithm, files in made.items():
        named = {output: str(folder / file) for output, file in files.items()}
        outcome = run(algorithm, {**given[algorithm], **named}, patience=PATIENCE_SECONDS)
        assert outcome.worked, (algorithm, outcome.said)
    again = run("fitsensormodel", {
        **given["fitsensormodel"], "OUTPUT": "TEMPORARY_OUTPUT", "RPC": str(folder / "rpc" / "image_RPC.TXT"),
    }, patience=PATIENCE_SECONDS)  # fmt: skip
    assert again.worked, again.said
    desk.make_folder(folder / "desk", folder / "inspected.gpkg")


def gcps_address(path: Path) -> str:
    """A table of points as QGIS's layer of delimited text."""
    return f"delimitedtext://file://{path}?xField=x&yField=y&zField=z&crs=EPSG:4326"


def _xml(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")
