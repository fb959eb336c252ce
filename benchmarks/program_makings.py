"""Mosaics of two overlapping orthoimages, made by programs that others use for it: OTB, SAGA, GDAL, GRASS, rasterio,
OpenCV, enblend and enfuse, each in several modes.
"""
from __future__ import annotations

import os
import shlex
import shutil
import subprocess
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from enum import Enum
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path

import numpy as np
from osgeo import gdal, ogr

from .readings import LEFT, TOP, write_frame
from .seam_makings import whole_values

NODATA = 0
FAR_PX = 0.01
"""How far a program's grid may lie beside the orthoimages': what rounding of coordinates leaves."""
BEYOND_PX = 128
"""Wider than any blend."""
TIMEOUT_S = 300
PYRAMID = 5
"""Levels of OpenCV's, its default."""


@dataclass(frozen=True, eq=False)
class Overlap:
    """Two orthoimages on one grid, each with pixels on its side of a line and some way beyond it."""

    images: tuple[np.ndarray, np.ndarray]
    """(3, rows, columns) 8 bit, nodata nowhere."""
    inside: tuple[np.ndarray, np.ndarray]
    """Pixels of each that a program is given, (rows, columns) bool."""
    is_second: np.ndarray
    """The second image's side of the line, (rows, columns) bool."""
    pixel_m: float

    def painted(self, first: int, second: int) -> Overlap:
        """Two images of one grey value each."""
        return replace(self, images=tuple(np.full_like(self.images[0], value) for value in (first, second)))

    def write(self, folder: Path) -> None:
        """All files that programs take: a.tif and b.tif, their bands (SAGA), with alpha (enblend), the line (GDAL)."""
        for name, image, inside in zip("ab", self.images, self.inside):
            path = str(folder / f"{name}.tif")
            write_frame(path, image, inside, self.pixel_m)
            for band in (1, 2, 3):
                gdal.Translate(str(folder / f"{name}{band}.tif"), path, bandList=[band])
            gdal.Translate(str(folder / f"{name}_alpha.tif"), path, bandList=[1, 2, 3, "mask"], noData="none",
                           creationOptions=["PHOTOMETRIC=RGB", "ALPHA=YES"])
        self._write_line(folder)

    def _write_line(self, folder: Path) -> None:
        """The second image's side as a polygon, beyond the images as well: GDAL blends along all of its border."""
        is_second = np.pad(self.is_second, BEYOND_PX, mode="edge").astype(np.uint8)
        side = gdal.GetDriverByName("MEM").Create("", *is_second.shape[::-1], 1, gdal.GDT_Byte)
        beyond = BEYOND_PX * self.pixel_m
        side.SetGeoTransform((LEFT - beyond, self.pixel_m, 0, TOP + beyond, 0, -self.pixel_m))
        side.WriteArray(is_second)
        package = ogr.GetDriverByName("GPKG").CreateDataSource(str(folder / "second.gpkg"))
        layer = package.CreateLayer("second", gdal.Open(str(folder / "a.tif")).GetSpatialRef())
        gdal.Polygonize(side.GetRasterBand(1), side.GetRasterBand(1), layer, -1)


@dataclass(frozen=True, eq=False)
class Product:
    """What a program made of an overlap."""

    bands: np.ndarray
    """(3, rows, columns) 8 bit, on the overlap's grid."""
    mask: np.ndarray | None = None
    """Pixels of the second image by the program's own seam, (rows, columns) bool; None where it tells of no seam."""


Make = Callable[[Overlap, Path], Product]
"""Makes the mosaic of an overlap whose files lie in a folder."""


class TruthBy(Enum):
    """What tells how much detail a mode keeps."""

    WEIGHTS = "weights"
    """How it mixes two images of one grey value each: the second's weight in every pixel."""
    MASK = "mask"
    """Its own mask: the program cuts hard along a seam that follows from the images."""
    MOSAIC = "mosaic"
    """The mosaic before compression against its images: it has a weight for each level, or by content."""


@dataclass(frozen=True)
class Mode:
    """One way to make a mosaic with a program."""

    program: str
    options: str
    needs: str
    """The command or the Python module."""
    make: Make
    truth_by: TruthBy

    @property
    def name(self) -> str:
        return f"{self.program}, {self.options}"

    @property
    def is_installed(self) -> bool:
        is_module = self.needs.isidentifier() and find_spec(self.needs) is not None
        return is_module or shutil.which(self.needs) is not None


def run(line: str, folder: Path) -> None:
    """A command in a folder, on one core, leaving nothing elsewhere."""
    environment = {**os.environ, "HOME": str(folder), "OMP_NUM_THREADS": "1"}
    done = subprocess.run(shlex.split(line), cwd=folder, env=environment, timeout=TIMEOUT_S, text=True,
                          errors="replace", stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if done.returncode:
        raise RuntimeError(f"{line}: {done.stdout[-2000:]}")


def placed(path: Path, overlap: Overlap) -> np.ndarray:
    """The bands of a file over the overlap's grid, (bands, rows, columns); a file without a place lies on that grid."""
    raster = gdal.Open(str(path))
    bands = raster.ReadAsArray()
    bands = bands if bands.ndim == 3 else bands[np.newaxis]
    rows, columns = overlap.is_second.shape
    left, width, _, top, _, height = raster.GetGeoTransform(can_return_null=True) or (LEFT, 1, 0, TOP, 0, -1)
    down, across = (top - TOP) / -height, (LEFT - left) / width
    first_row, first_column = round(down), round(across)
    if max(abs(down - first_row), abs(across - first_column)) > FAR_PX:
        raise ValueError(f"{path.name} lies {down:.3f} px down and {across:.3f} px across from the orthoimages")
    bands = bands[:3, max(first_row, 0) :, max(first_column, 0) :][:, :rows, :columns]
    if bands.shape[1:] != (rows, columns):
        raise ValueError(f"{path.name} has only {bands.shape[1:]} of the orthoimages' {rows, columns} pixels")
    return np.asarray(bands)


def commands(*lines: str, width_px: float = 0.0, outputs: Sequence[str] = ("out.tif",), mask: str = "") -> Make:
    """Command lines that leave the mosaic, or each of its bands, in files; {width} stands for the width in metres."""

    def make(overlap: Overlap, folder: Path) -> Product:
        for line in lines:
            run(line.format(width=width_px * overlap.pixel_m), folder)
        bands = np.concatenate([placed(folder / output, overlap) for output in outputs])
        return Product(whole_values(bands), placed(folder / mask, overlap)[0] > 0 if mask else None)

    return make


def otb(options: str, width_px: float = 0.0) -> Make:
    return commands(f"otbcli_Mosaic -il a.tif b.tif -out out.tif uint8 {options}", width_px=width_px)


def gdalwarp(options: str) -> Make:
    """The second image warped onto the first."""
    return commands("gdalwarp -q -overwrite a.tif out.tif", f"gdalwarp -q {options} b.tif out.tif")


def saga(options: str) -> Make:
    """Band by band, on the grid of the images: SAGA's own target grid is a row and a column short."""
    lines = [
        f"saga_cmd -f=s grid_tools 3 -GRIDS a{band}.tif;b{band}.tif -TARGET_DEFINITION 1 -TARGET_TEMPLATE a{band}.tif "
        f"-TARGET_OUT_GRID out{band}.tif {options}" for band in (1, 2, 3)
    ]
    return commands(*lines, outputs=[f"out{band}.tif" for band in (1, 2, 3)])


def grass(line: str) -> Make:
    """One command for each band of a and b, which writes the map c of that band."""
    steps = (
        "r.in.gdal -o --quiet input=a.tif output=a", "r.in.gdal -o --quiet input=b.tif output=b",
        "g.region raster=a.red,b.red", f"for k in red green blue; do {line}; done",
        "i.group --quiet group=c input=c.red,c.green,c.blue",
        "r.out.gdal --quiet --overwrite -c -f input=c output=out.tif type=Byte",
    )
    return commands(f"grass --tmp-location a.tif --exec sh -ec '{'; '.join(steps)}'")


def enblend(options: str) -> Make:
    return commands(f"enblend {options} --save-masks=mask.tif -o out.tif a_alpha.tif b_alpha.tif", mask="mask.tif")


def enfuse(options: str, mask: str = "") -> Make:
    return commands(f"enfuse {options} -o out.tif a_alpha.tif b_alpha.tif", mask=mask)


def merged(method: str) -> Make:
    """The mosaic by ``rasterio.merge``."""

    def make(overlap: Overlap, folder: Path) -> Product:
        return Product(import_module("rasterio.merge").merge([folder / "a.tif", folder / "b.tif"], method=method)[0])

    return make


def stitched(seam: str, sharpness: float = 0.0, pyramid: int = 0) -> Make:
    """The mosaic by OpenCV's seam finders and blenders; no seam: blended over all of the overlap."""

    def make(overlap: Overlap, folder: Path) -> Product:
        cv2 = import_module("cv2")  # its types leave the stitcher out
        images = [np.ascontiguousarray(image.transpose(1, 2, 0)) for image in overlap.images]
        masks = [np.where(inside, 255, 0).astype(np.uint8) for inside in overlap.inside]
        if seam:
            finder = {"Voronoi": lambda: cv2.detail.SeamFinder_createDefault(cv2.detail.SeamFinder_VORONOI_SEAM),
                      "graph cut": lambda: cv2.detail_GraphCutSeamFinder("COST_COLOR")}[seam]()
            cut = finder.find([image.astype(np.float32) for image in images], [(0, 0), (0, 0)], masks)
            masks = [mask.get() for mask in cut]
        is_second = masks[1] > 0 if seam else None
        blender = (cv2.detail_MultiBandBlender(0, pyramid) if pyramid else cv2.detail_FeatherBlender(sharpness)
                   if sharpness else cv2.detail.Blender_createDefault(cv2.detail.Blender_NO))
        blender.prepare((0, 0, *overlap.is_second.shape[::-1]))
        for image, mask in zip(images, masks):
            blender.feed(image.astype(np.int16), mask, (0, 0))
        return Product(whole_values(blender.blend(None, None)[0].transpose(2, 0, 1)), is_second)

    return make


LINE = "-cutline second.gpkg"
SLIM = "-comp.feather slim -comp.feather.slim.length {width} -distancemap.sr 1"
NEAREST = "--primary-seam-generator=nearest-feature-transform --no-optimize --fine-mask"
SAVED = "--save-masks=soft%n.tif:mask%n.tif"
WEIGHTS, MASK, MOSAIC = TruthBy


def modes(program: str, needs: str, *several: tuple[str, Make], by: TruthBy = WEIGHTS) -> list[Mode]:
    """Modes of one program."""
    return [Mode(program, options, needs, make, by) for options, make in several]


MODES: tuple[Mode, ...] = (
    *modes("GDAL", "gdal_merge.py", ("gdal_merge", commands("gdal_merge.py -q -n 0 -o out.tif a.tif b.tif"))),
    *modes("GDAL", "gdalbuildvrt", (
        "gdalbuildvrt", commands("gdalbuildvrt -q -overwrite out.vrt a.tif b.tif", outputs=["out.vrt"]))),
    *modes("GDAL", "gdalwarp", *((f"gdalwarp {options}".replace(" second.gpkg", ""), gdalwarp(options)) for options in (
        LINE, f"{LINE} -cblend 5", f"{LINE} -cblend 16", f"{LINE} -cblend 32"))),
    *modes("OTB", "otbcli_Mosaic",
           ("none", otb("-comp.feather none")), ("slim, 10 px", otb(SLIM, 10)), ("slim, 33 px", otb(SLIM, 33)),
           ("large", otb("-comp.feather large -distancemap.sr 1")),
           ("large, coarse distances", otb("-comp.feather large"))),
    *modes("SAGA", "saga_cmd",
           ("last", saga("-OVERLAP 1 -RESAMPLING 0")), ("mean", saga("-OVERLAP 4 -RESAMPLING 0 -TYPE 7")),
           ("feathering", saga("-OVERLAP 6 -RESAMPLING 0 -TYPE 7 -BLEND_DIST 33"))),
    *modes("GRASS", "grass",
           ("r.patch", grass("r.patch --quiet input=b.$k,a.$k output=c.$k")),
           ("r.series average", grass("r.series --quiet input=a.$k,b.$k output=c.$k method=average"))),
    *modes("rasterio", "rasterio", ("merge first", merged("first")), ("merge last", merged("last"))),
    *modes("OpenCV", "cv2", ("feather 0.1", stitched("", sharpness=0.1)),
           ("feather 0.02", stitched("", sharpness=0.02))),
    *modes("OpenCV", "cv2", ("Voronoi, cut", stitched("Voronoi")), ("graph cut", stitched("graph cut")), by=MASK),
    *modes("OpenCV", "cv2", ("Voronoi, multiband", stitched("Voronoi", pyramid=PYRAMID)),
           ("graph cut, multiband", stitched("graph cut", pyramid=PYRAMID)), by=MOSAIC),
    *modes("enblend", "enblend",
           ("default", enblend("")), ("1 level", enblend("--levels=1")), ("nearest feature", enblend(NEAREST)),
           by=MOSAIC),
    *modes("enfuse", "enfuse", ("default", enfuse("")), ("hard mask", enfuse(f"--hard-mask {SAVED}", "mask2.tif")),
           by=MOSAIC),
)


def missing_programs() -> Iterator[str]:
    """Programs that are not here, with what was looked for."""
    needs = {(mode.program, mode.needs) for mode in MODES if not mode.is_installed}
    yield from (f"{program} ({need})" for program, need in sorted(needs))
