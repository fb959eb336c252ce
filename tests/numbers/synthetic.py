"""What the tests of numbers are made of: textures, rasters of them as files, and what PyWavelets says about them."""
from __future__ import annotations

import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
import pywt
from osgeo import gdal, gdal_array, osr

UTM33 = 32633
_MOST_SHARED_PX = 1024**2
ORIGIN = (500000.0, 5000000.0)  # x and y of the upper left corner of rasters, unless a test says otherwise

GeoTransform = tuple[float, float, float, float, float, float]
Colour = tuple[int, ...]


def texture(shape: tuple[int, int], beta: float = 2.0, seed: int = 0) -> np.ndarray:
    """A periodic texture of mean 0 and standard deviation 1 whose power falls with frequency as f^-beta.

    0 is white noise, 2 looks like an orthoimage, 5 is very smooth. Tests share small ones, which can't be written to.
    """
    return (_shared_texture if shape[0] * shape[1] <= _MOST_SHARED_PX else _texture)(shape, beta, seed)


@lru_cache(maxsize=16)
def _shared_texture(shape: tuple[int, int], beta: float, seed: int) -> np.ndarray:
    made = _texture(shape, beta, seed)
    made.flags.writeable = False
    return made


def _texture(shape: tuple[int, int], beta: float, seed: int) -> np.ndarray:
    rows, columns = shape
    noise = np.random.default_rng(seed).standard_normal(shape)
    frequency = np.hypot(np.fft.fftfreq(rows)[:, np.newaxis], np.fft.rfftfreq(columns))
    frequency[0, 0] = np.inf
    made = np.fft.irfft2(np.fft.rfft2(noise) * frequency ** (-beta / 2), shape)
    return (made - made.mean()) / made.std()


def patchy_texture(shape: tuple[int, int], beta: float = 2.0, seed: int = 0) -> np.ndarray:
    """A texture between quiet patches, as woods stand between fields: of mean 0 and standard deviation 1."""
    patches = 1 / (1 + np.exp(-8 * texture(shape, 5, seed + 500)))
    made = patches * texture(shape, beta, seed)
    return (made - made.mean()) / made.std()


def orthoimage(
    shape: tuple[int, int], bands: int = 3, seed: int = 0, beta: float = 1.6, dtype: type = np.uint8
) -> np.ndarray:
    """(bands, rows, columns) of a scene: bands that are alike but not the same, no pixel of the value 0."""
    scene = texture(shape, beta, seed)
    layers = [0.9 * scene + 0.3 * texture(shape, beta, seed + 1000 + band) for band in range(bands)]
    values = np.stack([120 + 6 * band + 30 * layer for band, layer in enumerate(layers)]).clip(1, 254)
    if np.dtype(dtype).kind == "f":
        return values.astype(dtype)
    return np.round(values * (1 if np.dtype(dtype).itemsize == 1 else 16)).astype(dtype)


@dataclass(frozen=True)
class Decomposition:
    """A clip by ``pywt.wavedec2`` in float64, its mean taken off before."""

    details: tuple[np.ndarray, ...]  # all detail coefficients of level 1 (finest), 2, ..., R in a row each
    coarse: np.ndarray  # the coarse component at level R
    energy: float  # sum of squares of the clip less its mean

    @property
    def shares(self) -> np.ndarray:
        """detail_1, ..., detail_R, background."""
        return np.array([np.sum(part**2) for part in (*self.details, self.coarse)]) / self.energy

    def products(self, other: Decomposition) -> np.ndarray:
        """Inner products with the components of another clip, in the same order."""
        mine, others = (*self.details, self.coarse.ravel()), (*other.details, other.coarse.ravel())
        return np.array([a @ b for a, b in zip(mine, others)])


def without_mean(band: np.ndarray) -> np.ndarray:
    """A band less its mean in float64; the mean is taken off in more digits than that."""
    exact = band.astype(np.longdouble)
    return (exact - exact.mean()).astype(np.float64)


def wavedec(band: np.ndarray, wavelet: str, levels: int) -> list[Any]:
    """``pywt.wavedec2`` of a band less its mean, as the design defines the components."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # says that at high levels all coefficients see the border
        return list(pywt.wavedec2(without_mean(band), wavelet, mode="periodization", level=levels))


def placed_wavedec(band: np.ndarray, wavelet: str, levels: int) -> list[Any]:
    """Components of a band, as ``wavedec`` has them, that goes on as in a mirror at every level, each detail moved by
    whole coefficients to where the points of an image show in it."""
    coarse, placed = without_mean(band), []
    for level in range(1, levels + 1):
        around = np.pad(coarse, 64, mode="symmetric")
        parts = pywt.dwt2(around, wavelet, "periodization")
        coarse, details = (np.asarray(part)[..., 32:-32, 32:-32] for part in parts)
        shifts = np.rint(-_lags_px(wavelet, level) / 2**level).astype(int)
        placed.append(tuple(_moved(part, shift) for part, shift in zip(details, shifts)))
    return [coarse, *reversed(placed)]


def _moved(part: np.ndarray, shift: np.ndarray) -> np.ndarray:
    """Down and to the right; the edges are repeated."""
    most = int(np.abs(shift).max())
    moved = np.roll(np.pad(part, most, mode="edge"), tuple(shift), (0, 1))
    return moved[most : most + part.shape[0], most : most + part.shape[1]]


@lru_cache
def _lags_px(wavelet: str, level: int) -> np.ndarray:
    """Pixels by which the energy of a point lies behind it in each detail, down and across, (3, 2): the mean over
    points on all places beside the grid."""
    step, side = 2**level, 64 * 2**level
    lags = np.zeros((3, 2))
    for place in range(side // 2, side // 2 + step):
        point = np.zeros((side, side))
        point[place, place] = 1
        for direction, part in enumerate(wavedec(point, wavelet, level)[1]):
            energy = np.square(part)
            for axis in (0, 1):
                at = step * np.arange(len(energy)) + (step - 1) / 2
                lags[direction, axis] += (energy.sum(axis=1 - axis) @ at / energy.sum() - place) / step
    return lags


def decompose(band: np.ndarray, wavelet: str = "coif3", levels: int = 3) -> Decomposition:
    """The components of one band (rows, columns)."""
    coarse, *details = wavedec(band, wavelet, levels)
    rows = tuple(np.concatenate([part.ravel() for part in level]) for level in reversed(details))
    return Decomposition(rows, coarse, float(np.sum(without_mean(band) ** 2)))


def luminance(bands: np.ndarray) -> np.ndarray:
    """Luminance of red, green and blue as Pyka 2009 mixes it."""
    red, green, blue = bands[:3].astype(np.float64)
    return 0.299 * red + 0.587 * green + 0.114 * blue


def wkt(system: str | int) -> str:
    """WKT of an EPSG code or of anything else that PROJ knows."""
    reference = osr.SpatialReference()
    reference.SetFromUserInput(f"EPSG:{system}" if isinstance(system, int) else system)
    return str(reference.ExportToWkt())


def write_mask(dataset: gdal.Dataset, mask: np.ndarray, inside: bool = False) -> None:
    """Into a TIFF or beside it; which of them is GDAL's own choice depends on its version."""
    before = gdal.GetConfigOption("GDAL_TIFF_INTERNAL_MASK")
    gdal.SetConfigOption("GDAL_TIFF_INTERNAL_MASK", "YES" if inside else "NO")
    dataset.CreateMaskBand(gdal.GMF_PER_DATASET)
    dataset.GetRasterBand(1).GetMaskBand().WriteArray(mask)
    gdal.SetConfigOption("GDAL_TIFF_INTERNAL_MASK", before)


def write_raster(
    path: Path,
    array: np.ndarray,
    gsd: float = 0.1,
    origin: tuple[float, float] = ORIGIN,
    geotransform: GeoTransform | None = None,
    system: str | int | None = UTM33,
    nodata: float | None = None,
    valid: np.ndarray | None = None,
    mask_inside: bool = True,
    colours: Sequence[int] | None = None,
    palette: Sequence[Colour] | None = None,
    options: Sequence[str] = ("TILED=YES", "BLOCKXSIZE=64", "BLOCKYSIZE=64", "COMPRESS=DEFLATE"),
) -> str:
    """A GeoTIFF of an array, (rows, columns) or (bands, rows, columns); returns its path.

    ``gsd`` and ``origin`` make a north-up geotransform unless ``geotransform`` is given. ``system`` is an EPSG
    code, WKT, or None for none at all. ``valid`` becomes the mask band of the dataset, in the file or beside it.
    ``colours`` are the bands' colour interpretations (gdal.GCI_*), without them GDAL decides.
    """
    bands = array[np.newaxis] if array.ndim == 2 else array
    options = list(options)
    if colours is not None:
        options += [f"PHOTOMETRIC={'RGB' if gdal.GCI_RedBand in colours[:1] else 'MINISBLACK'}"]
        options += [f"ALPHA={'YES' if gdal.GCI_AlphaBand in colours else 'NO'}"]
    kind = gdal_array.NumericTypeCodeToGDALTypeCode(bands.dtype.type)
    dataset = gdal.GetDriverByName("GTiff").Create(
        str(path), bands.shape[2], bands.shape[1], bands.shape[0], kind, options=options
    )
    dataset.SetGeoTransform(geotransform or (origin[0], gsd, 0.0, origin[1], 0.0, -gsd))
    if system is not None:
        dataset.SetProjection(wkt(system))
    for index, colour in enumerate(colours or ()):
        dataset.GetRasterBand(index + 1).SetColorInterpretation(colour)
    if palette is not None:
        table = gdal.ColorTable()
        for index, entry in enumerate(palette):
            table.SetColorEntry(index, entry)
        dataset.GetRasterBand(1).SetColorTable(table)
    if nodata is not None:
        dataset.GetRasterBand(1).SetNoDataValue(nodata)
    dataset.WriteArray(bands)
    if valid is not None:
        write_mask(dataset, valid.astype(np.uint8) * 255, mask_inside)
    dataset.FlushCache()
    del dataset
    return str(path)


def read_pixels(path: str, column: int, row: int, width: int, height: int) -> np.ndarray:
    """Pixels by GDAL alone, (bands, rows, columns)."""
    dataset = gdal.Open(path)
    return np.asarray(dataset.ReadAsArray(column, row, width, height)).reshape(-1, height, width)


def write_plain(path: Path, array: np.ndarray, options: Sequence[str] = ()) -> str:
    """A picture without a place on the map, (rows, columns) or (bands, rows, columns), in the format of its ending."""
    bands = array[np.newaxis] if array.ndim == 2 else array
    memory = gdal.GetDriverByName("MEM").Create(
        "", bands.shape[2], bands.shape[1], len(bands), gdal_array.NumericTypeCodeToGDALTypeCode(bands.dtype.type)
    )
    memory.WriteArray(bands)
    driver = {".bmp": "BMP", ".png": "PNG", ".jpg": "JPEG"}.get(path.suffix, "GTiff")
    gdal.GetDriverByName(driver).CreateCopy(str(path), memory, options=list(options))
    return str(path)
