"""A sound call or more of every algorithm: where the breaking starts."""
from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from fuzz.breakages.broken import RECORDS


@dataclass(frozen=True)
class Address:
    """A layer of delimited text in a file of the samples."""

    path: Path

    def of(self, path: Path) -> str:
        return f"delimitedtext://file://{path}?xField=x&yField=y&zField=z&crs=EPSG:4326"


@dataclass(frozen=True)
class Call:
    """What an algorithm is given."""

    algorithm: str
    name: str
    values: Mapping[str, Any]
    """Files as a Path below the samples, an Address, or a list of those; anything else is a plain value."""

    @property
    def key(self) -> str:
        return f"{self.algorithm}/{self.name}"


def _files(*names: str) -> list[Path]:
    return [Path(name) for name in names]


def _file(name: str) -> Path:
    return Path(name)


FOLDERS = {
    "first": {".xml"}, "second": {".csv"}, "delivery": {".tif"}, "photos": {".tif"},
    "desk": {".qgs", ".gpkg", *RECORDS},
}
"""The endings of what folders of the samples hold."""
MODELS = {"inspect_mosaic", "accept_delivery"}
"""Their rasters are loaded by QGIS itself before a step of ours begins, and their steps refuse what they are given."""
_SOURCES = _files("west.tif", "east.tif")
_SCANNED = _files("scan/west.tif", "scan/east.tif")
_FITTED = {"GCPS": Address(Path("gcps.csv")), "HEIGHTS": "ellipsoid"}

CALLS: tuple[Call, ...] = tuple(Call(*one) for one in (
    ("desk", "project", {"FOLDER": _file("desk")}),
    ("placewindows", "lines", {
        "SEAMLINES": _file("seams.gpkg"), "MOSAIC": _file("mosaic.tif"), "SIDE": 6.4, "SPACING": 6.4, "LEVELS": 3}),
    ("placewindows", "cells", {
        "SEAMLINES": _file("cells.gpkg"), "MOSAIC": _file("cog.tif"), "SIDE": 6.4, "SPACING": 6.4, "LEVELS": 2}),
    ("placewindows", "shape", {"SEAMLINES": _file("seams.shp"), "MOSAIC": _file("mosaic.vrt"), "SIDE": 6.4}),
    ("inspectwindows", "seam", {
        "WINDOWS": _file("windows.gpkg"), "MOSAIC": _file("mosaic.tif"), "SOURCES": _SOURCES, "LEVELS": 3,
        "WAVELET": "coif3", "MAX_RATIO": 0.5, "MIN_KEPT": 0.7, "DIRECTIONS": True}),
    ("inspectwindows", "index", {
        "WINDOWS": _file("windows.geojson"), "MOSAIC": _file("overviews.tif"), "SOURCE_INDEX": _file("index.gpkg"),
        "REFERENCE": "sources"}),
    ("inspectwindows", "cells", {
        "WINDOWS": _file("windows.shp"), "MOSAIC": _file("jpeg.tif"), "SOURCES": _files("masked.tif", "alpha.tif"),
        "CELLS": _file("cells.gpkg"), "REFERENCE": "composite"}),
    ("scanmosaic", "sources", {
        "MOSAIC": _file("scan/mosaic.tif"), "SOURCES": _SCANNED, "PIECE": 5.0, "WORST_COUNT": 3, "CELL": 32,
        "LEVELS": 3, "DENSITY": "seams", "WAVELET": "coif3"}),
    ("scanmosaic", "lone", {
        "MOSAIC": _file("scan/mosaic.tif"), "SEAMLINES": _file("scan/seam.gpkg"), "CORRIDOR": 0.0, "PIECE": 5.0,
        "WORST_COUNT": 3}),
    ("scanmosaic", "given", {
        "MOSAIC": _file("mosaic.tif"), "SOURCES": _SOURCES, "SEAMLINES": _file("cells.gpkg"), "CORRIDOR": 8.0,
        "SOURCE_FIELD": "source", "DENSITY": "full", "PIECE": 5.0}),
    ("scanmosaic", "index", {
        "MOSAIC": _file("mosaic.tif"), "SOURCE_INDEX": _file("index.gpkg"), "PIECE": 5.0, "SCHEDULER": ""}),
    ("mendseams", "scanned", {
        "MOSAIC": _file("scan/mosaic.tif"), "SOURCES": _SCANNED, "SEAMS": _file("scan_seams.gpkg"), "WHAT": "all",
        "WIDTH": 3.0, "BLEND": 3}),
    ("mendseams", "index", {
        "MOSAIC": _file("mosaic.tif"), "SOURCE_INDEX": _file("index.gpkg"), "SEAMS": _file("windows.gpkg"),
        "SCHEDULER": ""}),
    ("planinspection", "iso", {
        "SEAMS": _files("scan_seams.gpkg"), "PLAN": "iso2859", "LOT_SIZE": 0, "AQL": "1.0", "SEED": 1}),
    ("planinspection", "count", {
        "SEAMS": _files("scan_seams.gpkg"), "PLAN": "count", "COUNT": 3, "UNIT": "windows", "SIDE": 12.8,
        "MOSAIC": _file("scan/mosaic.tif"), "SHEETS": _file("sheets.gpkg")}),
    ("acceptmosaic", "limits", {
        "SEAMS": _files("scan_seams.gpkg"), "MIN_KEPT": 0.7, "MAX_SHARE": 2.0, "MAX_RUN": 50.0, "MIN_MEASURED": 90.0,
        "MOSAIC": _files("scan/mosaic.tif"), "LOSS": _files("scan_loss.tif"), "WINDOWS": _file("windows.gpkg"),
        "SOURCES": _SCANNED, "RADIOMETRY": _file("checked.gpkg")}),
    ("acceptmosaic", "rules", {
        "SEAMS": _files("scan_seams.gpkg"), "RULES": _file("acceptance.json"), "SHEETS": _file("sheets.gpkg"),
        "MOSAIC": _files("scan/mosaic.tif"), "SOURCE_INDEX": _file("scan/index.gpkg")}),
    ("acceptmosaic", "plan", {
        "SEAMS": _files("scan_seams.gpkg"), "PLAN": "iso2859", "WINDOWS": _file("windows.gpkg"),
        "LOT_SIZE": 100, "SEED": 3}),
    ("checkdelivery", "sheets", {
        "SHEETS": _file("sheets.gpkg"), "PATTERN": "*.tif", "PIXEL": 0.1, "BANDS": 3, "MAX_NODATA": 1.0}),
    ("checkdelivery", "folder", {"FOLDER": _file("delivery"), "CRS": "EPSG:32633", "DATA_TYPE": "uint8"}),
    ("predictloss", "width", {
        "WINDOWS": _file("windows.gpkg"), "SOURCES": _SOURCES, "WIDTH": 3.0, "SEAMLINES": _file("seams.gpkg"),
        "LEVELS": 3, "WAVELET": "db4"}),
    ("predictloss", "index", {"WINDOWS": _file("windows.gpkg"), "SOURCE_INDEX": _file("index.gpkg")}),
    ("calibratethreshold", "windows", {
        "WINDOWS": _file("inspected.gpkg"), "PAIRS": _file("pairs.gpkg"), "MEASURE": "kept_1"}),
    ("report", "all", {
        "WINDOWS": _file("inspected.gpkg"), "CURVES": _file("curves.gpkg"), "PAIRS": _file("pairs.gpkg"),
        "PROFILES": _file("profiles.gpkg"), "MOSAIC": _file("mosaic.tif"), "SOURCES": _SOURCES, "TITLE": "A block",
        "MIN_KEPT": 0.7, "MAX_RATIO": 0.5}),
    ("report", "plain", {"WINDOWS": _file("inspected.gpkg"), "MOSAIC": _file("picture.jpg")}),
    ("report", "index", {
        "WINDOWS": _file("inspected.gpkg"), "MOSAIC": _file("mosaic.tif"), "SOURCE_INDEX": _file("index.gpkg")}),
    ("checknoise", "windows", {
        "RASTERS": _files("mosaic.tif", "deep.tif"), "WINDOWS": _file("windows.gpkg"), "LEVELS": 2,
        "WAVELET": "haar", "GROUP_FIELD": "group"}),
    ("checknoise", "groups", {
        "RASTERS": _files("lzw.tif"), "SECOND_GROUP": _files("plain.tif"), "GROUP_NAME": "a",
        "SECOND_GROUP_NAME": "b"}),
    ("checknoise", "whole", {"RASTERS": _files("zstd.tif")}),
    ("checkradiometry", "windows", {
        "RASTERS": _files("mosaic.tif", "picture.png"), "WINDOWS": _file("windows.gpkg"), "VALUE_RANGE": [0, 255],
        "SEAMLINES": _file("seams.geojson"), "GREY_AREAS": _file("grey.gpkg")}),
    ("checkradiometry", "rules", {"RASTERS": _files("float.tif", "webp.tif"), "RULES": _file("radiometry.json")}),
    ("checkradiometry", "sheets", {"SHEETS": _file("scan/index.gpkg")}),
    ("measureresolution", "bars", {
        "RASTER": _file("target.tif"), "GROUPS": _file("bars.gpkg"), "WIDTH": 3.0, "BARS": 3, "BAND": 0,
        "REFERENCE_GROUP": 1, "REFERENCE_GRD": 100.0, "STEP": 1.12, "CRITERION": 0.5, "FULL_AMPLITUDE": "coarsest"}),
    ("minimumheight", "table", {
        "OBSERVATIONS": _file("observations.csv"), "REQUIRED_GRD": 25.0, "REFERENCE_HEIGHT": 2000.0,
        "BY_HEIGHT": True}),
    ("simulatebayer", "mosaic", {"RASTER": _file("mosaic.tif"), "PATTERN": "RGGB", "DEMOSAIC": "malvar"}),
    ("simulatebayer", "big", {"RASTER": _file("big.tif"), "PATTERN": "GBRG", "DEMOSAIC": "edge_aware"}),
    ("interiororientation", "table", {
        "PHOTO": _file("photo.bmp"), "CALIBRATION": _file("camera.csv"), "SEARCH": 8.0, "MIN_CORRELATION": 0.5,
        "TEMPLATE_KIND": "ring with cross"}),
    ("interiororientation", "positions", {
        "PHOTO": _file("photo.bmp"), "CALIBRATION": _file("MeasuresCamera.xml"), "POSITIONS": _file("marks.gpkg"),
        "MEASURE": False, "MODEL": "projective"}),
    ("interiororientation", "template", {
        "PHOTO": _file("photo.bmp"), "CALIBRATION": _file("camera.csv"), "TEMPLATE": _file("template.tif"),
        "POSITIONS": _file("marks.gpkg"), "SEARCH": 20.0}),
    ("comparemarks", "layers", {
        "FIRST": _file("marks.gpkg"), "SECOND": _file("marks.gpkg"), "LIMIT": 0.25, "PIXEL_SIZE": 20.0}),
    ("comparemarks", "folders", {"FIRST_FOLDER": _file("first"), "SECOND_FOLDER": _file("second")}),
    ("enhancephoto", "mean", {"PHOTO": _file("mosaic.tif"), "OPERATION": "mean", "SIZE": 3.0}),
    ("enhancephoto", "gaussian", {"PHOTO": _file("picture.jpg"), "OPERATION": "gaussian", "SIZE": 2.0}),
    ("enhancephoto", "grey", {"PHOTO": _file("deep.tif"), "OPERATION": "grey"}),
    ("fitsensormodel", "table", {
        **_FITTED, "MODEL": "rational", "ORDER": 1, "IMAGE": _file("image.tif"), "CHECK_SHARE": 0.25,
        "ORBIT_HEIGHT": 694.0, "TERRAIN_ERROR": 1.0, "ROBUST": True}),
    ("fitsensormodel", "points", {
        "GCPS": _file("image.points"), "DEM": _file("dem.tif"), "DEM_HEIGHTS": "ellipsoid", "MODEL": "polynomial_3d",
        "ORDER": 1}),
    ("fitsensormodel", "bias", {
        "GCPS": _file("gcps.geojson"), "IMAGE": _file("image.tif"), "IMAGE_RPC": _file("rpc/image.RPB"),
        "MODEL": "rpc_bias", "BIAS": "affine"}),
    ("comparesensormodels", "table", {
        **_FITTED, "IMAGE": _file("image.tif"), "IMAGE_RPC": _file("rpc/image_RPC.TXT"), "CHECK_SHARE": 0.25}),
    ("comparesensormodels", "heights", {
        "GCPS": _file("image.points"), "DEM": _file("dem.tif"), "DEM_HEIGHTS": "geoid", "GEOID": _file("geoid.tif")}),
    ("orthorectify", "geoid", {
        "IMAGE": _file("image.tif"), "MODEL_FILE": _file("model.json"), "DEM": _file("dem.tif"),
        "DEM_HEIGHTS": "geoid", "GEOID": _file("geoid.tif"), "CRS": "EPSG:32632", "PIXEL_SIZE": 500.0}),
    ("fitsensormodel", "geoid", {
        **_FITTED, "HEIGHTS": "geoid", "GEOID": _file("geoid.tif"), "MODEL": "polynomial_3d", "IMAGE": None}),
    ("orthorectify", "model", {
        "IMAGE": _file("image.tif"), "MODEL_FILE": _file("model.json"), "DEM": _file("dem.tif"),
        "DEM_HEIGHTS": "ellipsoid", "CRS": "EPSG:32632", "PIXEL_SIZE": 500.0}),
    ("orthorectify", "rpc", {
        "IMAGE": _file("image.tif"), "RPC": _file("rpc/image_RPC.TXT"), "HEIGHT": 600.0, "RESAMPLING": "bilinear",
        "FORMAT": "COG", "TERRAIN_ERROR": 1.0, "EXTENT": "330000,350000,4830000,4850000 [EPSG:32632]",
        "PIXEL_SIZE": 500.0}),
    ("orthorectify", "frame", {
        "IMAGE": _file("photo.tif"), "INTERIOR": _file("camera.yaml"), "EXTERIOR": _file("exterior.csv"),
        "EXTERIOR_CRS": "EPSG:32633", "DEM": _file("terrain.tif"), "PIXEL_SIZE": 20.0}),
    ("orthorectify", "geojson", {
        "IMAGE": _file("photo.tif"), "INTERIOR": _file("camera.yaml"), "EXTERIOR": _file("exterior.geojson"),
        "DEM": _file("terrain.tif"), "PIXEL_SIZE": 20.0}),
    ("orthorectifyphotos", "table", {
        "EXTERIOR": _file("exterior.csv"), "INTERIOR": _file("camera.yaml"), "EXTERIOR_CRS": "EPSG:32633",
        "PHOTOS": _file("photos"), "DEM": _file("terrain.tif"), "DEM_HEIGHTS": "geoid", "GEOID": _file("sea.tif"),
        "PIXEL_SIZE": 20.0}),
    ("planpoints", "nominal", {
        "MODEL": "polynomial_3d 1", "COUNTS": "6, 8", "SPREAD": "grid", "SIGMA": 0.5, "SIGMA_PX": 0.5, "LOWEST": 0.0,
        "HIGHEST": 300.0, "ORBIT_HEIGHT": 694.0, "VIEW_ANGLE": 15.0, "PIXEL_SIZE": 0.5, "SIDE": 15.0, "SEED": 1}),
    ("planpoints", "rpc", {
        "MODEL": "rpc_bias shift", "COUNTS": "3", "IMAGE": _file("image.tif"), "IMAGE_RPC": _file("rpc/image.RPB"),
        "LOWEST": 500.0, "HIGHEST": 700.0}),
    ("inspect_mosaic", "lines", {
        "seamlines": _file("seams.gpkg"), "mosaic": _file("mosaic.tif"), "sources": _SOURCES, "side": 6.4,
        "spacing": 6.4, "levels": 3}),
    ("inspect_mosaic", "index", {
        "seamlines": _file("seams.gpkg"), "mosaic": _file("mosaic.tif"), "source_index": _file("index.gpkg"),
        "side": 12.8, "spacing": 12.8}),
    ("accept_delivery", "sources", {
        "folder": _file("delivery"), "sheets": _file("ordered.gpkg"), "sources": _SCANNED, "piece": 5.0,
        "rules": _file("acceptance.json")}),
    ("accept_delivery", "index", {
        "folder": _file("delivery"), "source_index": _file("scan/index.gpkg"), "seamlines": _file("scan/seam.gpkg"),
        "piece": 5.0}),
))  # fmt: skip


def placed(value: Any, folder: Path) -> Any:
    """A value of a call as the algorithm is given it, its files in a folder."""
    if isinstance(value, (list, tuple)):
        return [placed(one, folder) for one in value]
    if isinstance(value, Address):
        return value.of(folder / value.path)
    return str(folder / value) if isinstance(value, Path) else value
