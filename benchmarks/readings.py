"""What is read of a mosaic that an operation made: what the plugin says of the window, and what usual measures say.

The plugin reads files, as it does for its users; here they lie in memory.
"""
from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from uuid import uuid4

import numpy as np
from osgeo import gdal, osr
from scipy import ndimage
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.limits import LUMINANCE
from seam_inspector.plugin.imagery.open_raster import describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.imagery.wavelets import luminance
from seam_inspector.plugin.seams.measure.compared_image import Change
from seam_inspector.plugin.seams.measure.window.inspection import inspect_window, make_block
from seam_inspector.plugin.seams.measure.window.measured_window import InspectionSettings, WindowRequest
from seam_inspector.plugin.seams.measure.window.window_result import WindowResult
from skimage.measure import blur_effect
from skimage.metrics import structural_similarity

from .known_windows import KnownWindow
from .production import Made

EPSG = 2180
LEFT, TOP = 566200.0, 244700.0


@dataclass(frozen=True)
class Reading:
    """What the plugin says of one window; nan where it says nothing."""

    verdict: str
    causes: tuple[str, ...]
    """Strongest first."""
    kept: float
    """kept_1, with its 95 % interval."""
    low: float
    high: float
    band_width: float
    """m"""
    misfit: float
    """How far the images lie off each other as placed in the mosaic, px."""
    explained: float
    contrast: float
    composite_ratio: float
    ratio: float
    source_count: int
    tones: Mapping[int, Change] = field(default_factory=dict)
    """What became of each given source's luminance, where it was compared as a whole."""

    @property
    def has_verdict(self) -> bool:
        return self.verdict != "not_comparable"

    @property
    def cause(self) -> str:
        """The main one."""
        return self.causes[0] if self.causes else ""

    def says_that_missing(self, share: float) -> bool:
        """Whether it says in any way that about this share of the pixels is not from the given sources."""
        return not self.has_verdict or "missing source" in self.causes or self.explained <= 1 - share / 2


def read(made: Made, window: KnownWindow, settings: InspectionSettings | None = None) -> Reading:
    """What the plugin says, with no labels given."""
    return reading_of(inspected(made, window, settings or InspectionSettings()))


def reading_of(result: WindowResult) -> Reading:
    """The only place that knows how the plugin's results are built."""
    found = result.explanation
    profile = result.profile
    change = found.changes[-1][LUMINANCE] if found else None
    causes = result.causes
    return Reading(
        verdict=result.judgement.verdict.value,
        causes=tuple(cause.value for cause in causes),
        kept=number(profile.kept[0]) if profile else np.nan,
        low=number(profile.low) if profile else np.nan,
        high=number(profile.high) if profile else np.nan,
        band_width=profile.band_width_px * result.ground_sample_distance if profile else np.nan,
        misfit=number(getattr(found, "misfit", None)),
        explained=number(result.explained),
        contrast=number(change.contrast[0]) if change else np.nan,
        composite_ratio=number(found.ratios[LUMINANCE].detail[0]) if found else np.nan,
        ratio=number(result.judgement.ratios.detail[0]),
        source_count=result.source_count,
        tones={
            int(pair.source.partition(".")[0].rpartition("_")[2]): pair.change
            for pair in result.pairs if pair.band == LUMINANCE and pair.change is not None
        },
    )


def inspected(made: Made, window: KnownWindow, settings: InspectionSettings) -> WindowResult:
    """The plugin's result for the window in the middle of the frame."""
    rows, columns = window.middle
    place = PixelWindow(columns.start, rows.start, window.side, window.side)
    with _files(made, window.pixel_m) as folder:
        return inspected_files(folder, place, settings)


def inspected_files(folder: str, place: PixelWindow, settings: InspectionSettings) -> WindowResult:
    """The plugin's result for a window of the files in a folder (``write_files``)."""
    names = sorted(gdal.ReadDir(folder))
    refs = [RasterRef(f"{folder}/{name}") for name in names if name.startswith("source_") and name.endswith(".tif")]
    block, _ = make_block(describe_mosaic(RasterRef(f"{folder}/mosaic.tif")), refs)
    return inspect_window(WindowRequest(1, block.mosaic, block.sources_over(place), place, settings))


@contextmanager
def _files(made: Made, pixel_m: float) -> Iterator[str]:
    folder = f"/vsimem/{uuid4().hex}"
    paths = write_files(made, folder, pixel_m)
    try:
        yield folder
    finally:
        for path in paths:
            gdal.Unlink(path)


def write_files(made: Made, folder: str, pixel_m: float) -> list[str]:
    """The mosaic and its sources, as files of a folder."""
    mosaic, sources = f"{folder}/mosaic.tif", [f"{folder}/source_{number}.tif" for number in range(len(made.sources))]
    write_frame(mosaic, made.bands, None, pixel_m)
    for path, bands, mask, offset in zip(sources, made.sources, made.valid, made.offsets):
        write_frame(path, bands, None if mask.all() else mask, pixel_m, offset)
    return [mosaic, *sources]


def write_frame(
    path: str, bands: np.ndarray, valid: np.ndarray | None, pixel_m: float, offset: tuple[float, float] = (0.0, 0.0)
) -> None:
    """A GeoTIFF at the place of all frames; 0 is its nodata where not all pixels are valid."""
    kind = gdal.GDT_Byte if bands.dtype == np.uint8 else gdal.GDT_UInt16
    raster = gdal.GetDriverByName("GTiff").Create(path, bands.shape[2], bands.shape[1], len(bands), kind,
                                                  ["PHOTOMETRIC=RGB"])
    raster.SetGeoTransform((LEFT + offset[1] * pixel_m, pixel_m, 0, TOP - offset[0] * pixel_m, 0, -pixel_m))
    system = osr.SpatialReference()
    system.ImportFromEPSG(EPSG)
    raster.SetProjection(system.ExportToWkt())
    if valid is not None:
        raster.GetRasterBand(1).SetNoDataValue(0)
        bands = np.where(valid, np.maximum(bands, 1), 0).astype(bands.dtype)
    raster.WriteArray(bands)


def peers(made: Made, window: KnownWindow) -> tuple[float, float, float]:
    """Variance of the Laplacian, ``blur_effect`` turned round, and the similarity of structure to the hard cut.

    Each is higher the sharper the mosaic. The last is given the hard cut as it was before anything came over it, and
    the true one at that, so it knows more than the plugin.
    """
    grey, reference = (luminance(bands[(slice(None), *window.middle)]) for bands in (made.bands, made.before))
    similarity = structural_similarity(reference, grey, data_range=255)
    return float(ndimage.laplace(grey).var()), -float(blur_effect(grey / 255)), float(similarity)


def number(value: float | None) -> float:
    """The value; nan for None."""
    return np.nan if value is None else float(value)
