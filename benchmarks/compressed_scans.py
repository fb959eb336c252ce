"""How truly scans judge compressed deliveries: `make benchmark-compressed-scans`.

Orthoimages of a block are cut along seams through the middle of their overlaps, and mixed over a known width along
parts of them; mosaic and orthoimages are stored by a codec. Each piece that a scan tells is compared with the detail
that was truly left along it.
"""
from __future__ import annotations

import argparse
import os
import tempfile
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from osgeo import gdal, gdal_array, ogr, osr
from scipy.ndimage import distance_transform_edt, gaussian_filter, label
from scipy.spatial import cKDTree
from seam_inspector import ScanResult, ScanSettings, open_block, scan
from seam_inspector.plugin.imagery.seam_totals import PieceState
from seam_inspector.plugin.seams.measure.scan.scan_result import JudgedPiece

from . import seam_makings as seams
from .compressed import LOSSLESS, Codec
from .detail import detail_energy, luminance_of
from .detection import grounds
from .known_windows import Imagery, hard_cut
from .timing import print_table

SCANNED_PX = 2400
"""Side of the block that is scanned, at most."""
PLANT_PX = 400
"""Side of the parts of the block in which seams are cut or mixed in turn."""
CROOKED_PX = 40.0
STRIP_PX = 8
NEAR_PX = 24
"""How far from a true seam a piece may lie that tells of it."""
TEXTURE = 4.0
"""Mean energy of the hard cut's finest detail along a seam, DN2: with less there is none."""
FAILED, SOUND = 0.7, 0.98
"""Detail that is left along a seam that fails, and along a sound one."""
EPSG = 2180
LEFT, TOP = 566200.0, 244700.0
PLANTS = {"sound": (0.0,), "13, 33": (0.0, 13.0, 0.0, 33.0), "66": (0.0, 0.0, 66.0)}
"""Widths, px, of the mixtures in turn."""
JPEG_75, JPEG_90, JPEG_85 = (Codec("JPEG", quality) for quality in (75, 90, 85))
CODECS = {
    "used": [(LOSSLESS, LOSSLESS), (JPEG_75, JPEG_75), (JPEG_75, replace(JPEG_75, shift_px=3)),
             (JPEG_90, replace(JPEG_90, shift_px=3))],
    "held back": [(JPEG_85, JPEG_85), (JPEG_85, replace(JPEG_85, shift_px=5)),
                  (Codec("JPEG", 60), Codec("JPEG", 95, shift_px=2)),
                  (Codec("WEBP", 85), Codec("WEBP", 85, shift_px=3))],
}
"""Codec of the mosaic, and of the orthoimages before it was made."""


@dataclass(frozen=True, eq=False)
class PlantedBlock:
    """A block of orthoimages and the mosaic of them before it was stored."""

    pixel_m: float
    sources: tuple[np.ndarray, ...]
    """(bands, rows, columns) 8 bit each, 0 where there is nothing."""
    labels: np.ndarray
    """(rows, columns): number of each pixel's source; -1 where there is none."""
    mosaic: np.ndarray
    kept_energy: np.ndarray
    """Of the mosaic's finest detail, (rows, columns) DN2."""
    hard_energy: np.ndarray
    """That of the hard cut."""

    @classmethod
    def of(
        cls, imagery: Imagery, sources: Sequence[np.ndarray], widths_px: Sequence[float], seed: int, least_px: int = 0
    ) -> PlantedBlock:
        """``least_px``: pixels of the smallest part that is cut from a source."""
        masks = [source.any(axis=0) for source in sources]
        rng = np.random.default_rng(seed)
        inside = [distance_transform_edt(np.pad(mask, 1))[1:-1, 1:-1] for mask in masks]
        bends = [gaussian_filter(rng.standard_normal(mask.shape), 60) * mask for mask in masks]
        depth = [np.where(mask, one + CROOKED_PX * bend / bend.std(), -np.inf)
                 for one, bend, mask in zip(inside, bends, masks)]
        labels = np.where(np.any(masks, axis=0), np.argmax(depth, axis=0), -1)
        labels = _without_islands(labels, least_px) if least_px else labels
        rows, columns = (np.arange(size) // PLANT_PX for size in labels.shape)
        turn = (rows[:, np.newaxis] + 2 * columns) % len(widths_px)
        cut = hard_cut(sources, labels)
        mixed = cut
        for number, width in enumerate(widths_px):
            if width:
                weights = [seams.ramp(seams.signed_distance(labels == k), width, "linear") * mask
                           for k, mask in enumerate(masks)]
                total = np.maximum(sum(weights), 1e-6)
                feathered = seams.whole_values(np.asarray(sum(w / total * s for w, s in zip(weights, sources))))
                mixed = np.where(turn == number, feathered, mixed)
        mixed = np.where(labels < 0, 0, mixed)
        kept, hard = (detail_energy(luminance_of(one), 1, "coif3") for one in (mixed, cut))
        return cls(imagery.pixel_m, tuple(sources), labels, mixed, kept, hard)

    @property
    def transform(self) -> tuple[float, ...]:
        """As GDAL has it."""
        return LEFT, self.pixel_m, 0.0, TOP, 0.0, -self.pixel_m

    def seam_pixels(self) -> np.ndarray:
        """Row and column of the pixels along which two sources meet, (n, 2)."""
        found = []
        for axis in (0, 1):
            beside = np.roll(self.labels, -1, axis)
            differs = (beside != self.labels) & (beside >= 0) & (self.labels >= 0)
            differs[(-1, slice(None)) if axis == 0 else (slice(None), -1)] = False
            found.append(np.argwhere(differs))
        return np.unique(np.concatenate(found), axis=0)

    def write(self, folder: Path, mosaic: Codec, orthoimages: Codec) -> tuple[Path, list[Path], Path]:
        """Mosaic, orthoimages and the polygons of what each part was made from."""
        paths = [self._written(folder / f"source_{k}.tif", orthoimages, one) for k, one in enumerate(self.sources)]
        return self._written(folder / "mosaic.tif", mosaic, self.mosaic), paths, self._polygons(folder / "seams.gpkg")

    def _written(self, path: Path, codec: Codec, bands: np.ndarray) -> Path:
        valid = bands.any(axis=0)
        memory = gdal_array.OpenArray(np.where(valid, codec.stored(np.where(valid, bands, 1)), 0).astype(np.uint8))
        memory.SetProjection(_system().ExportToWkt())
        memory.SetGeoTransform(self.transform)
        for band in range(len(bands)):
            memory.GetRasterBand(band + 1).SetNoDataValue(0)
        gdal.Translate(str(path), memory, creationOptions=["TILED=YES", "COMPRESS=DEFLATE"])
        return path

    def _polygons(self, path: Path) -> Path:
        labels = gdal_array.OpenArray(self.labels.astype(np.int32))
        labels.SetProjection(_system().ExportToWkt())
        labels.SetGeoTransform(self.transform)
        mask = gdal_array.OpenArray((self.labels >= 0).astype(np.uint8))
        made = ogr.GetDriverByName("GPKG").CreateDataSource(str(path))
        layer = made.CreateLayer("seams", _system(), ogr.wkbPolygon)
        layer.CreateField(ogr.FieldDefn("source", ogr.OFTInteger))
        gdal.Polygonize(labels.GetRasterBand(1), mask.GetRasterBand(1), layer, 0)
        return path


def _without_islands(labels: np.ndarray, least_px: int) -> np.ndarray:
    """Parts of fewer pixels go to what lies nearest."""
    small = np.zeros(labels.shape, bool)
    for number in range(labels.max() + 1):
        parts, _ = label(labels == number)
        small |= (np.bincount(parts.ravel()) < least_px)[parts] & (parts > 0)
    nearest = distance_transform_edt(small | (labels < 0), return_distances=False, return_indices=True)
    return np.where(small, labels[tuple(nearest)], labels)


def _system() -> osr.SpatialReference:
    system = osr.SpatialReference()
    system.ImportFromEPSG(EPSG)
    return system


def planted(imagery: Imagery, widths_px: Sequence[float], held_back: bool, codec: Codec) -> PlantedBlock:
    """One half of an imagery, its orthoimages stored before the mosaic was made."""
    rows, columns = min(imagery.rows, SCANNED_PX), min(imagery.columns // 2, SCANNED_PX)
    first = imagery.columns - columns if held_back else 0
    side = max(rows, columns)
    sources = [one.over(0, first, side)[:, :rows, :columns] for one in imagery.placed]
    valid = [(source != placed.nodata).any(axis=0) for source, placed in zip(sources, imagery.placed)]
    stored = [np.where(mask, codec.stored(np.where(mask, source, 1)), 0).astype(np.uint8)
              for source, mask in zip(sources, valid) if mask.mean() > 0.05]
    return PlantedBlock.of(imagery, stored, widths_px, len(widths_px))


@dataclass(frozen=True, eq=False)
class ScanOutcome:
    """What a scan said of a planted block, by the pixels of its true seams."""

    length_m: np.ndarray
    """(n,): of seam that each pixel stands for."""
    truth: np.ndarray
    """(n,): detail that is left around each."""
    is_textured: np.ndarray
    pieces: Sequence[JudgedPiece]
    piece: np.ndarray
    """(n,): number of the nearest piece, -1 where none is near."""
    piece_truth: np.ndarray
    """(pieces,): detail that is left along each."""

    @classmethod
    def of(cls, block: PlantedBlock, result: ScanResult, piece_px: float) -> ScanOutcome:
        pixels = block.seam_pixels()
        tree = cKDTree(pixels)
        beside = np.argwhere((distance_transform_edt(~_as_mask(pixels, block.labels.shape)) < STRIP_PX)
                             & (block.labels >= 0))
        owner = tree.query(beside)[1]
        at = tuple(beside.T)
        hard, kept = (np.bincount(owner, one[at], len(pixels)) for one in (block.hard_energy, block.kept_energy))
        area = np.bincount(owner, minlength=len(pixels))
        pieces = result.pieces
        points, numbers = [np.empty((0, 2))], [np.empty(0, int)]
        for number, one in enumerate(pieces):
            line = _dense(one.piece.vertices, block.pixel_m)
            points.append((np.array([LEFT, TOP]) - line)[:, ::-1] * (1, -1) / block.pixel_m - 0.5)
            numbers.append(np.full(len(line), number))
        distance, place = cKDTree(np.concatenate(points)).query(pixels) if len(pieces) else (
            np.full(len(pixels), np.inf), np.zeros(len(pixels), int))
        piece = np.where(distance <= NEAR_PX, np.append(np.concatenate(numbers), -1)[place], -1)
        by_piece = [np.bincount(piece[piece >= 0], one[piece >= 0], len(pieces)) for one in (hard, kept)]
        around = [np.zeros(len(pixels)) for _ in range(3)]
        for near, own in zip(tree.query_ball_point(pixels, piece_px / 2), range(len(pixels))):
            for total, one in zip(around, (hard, kept, area)):
                total[own] = one[near].sum()
        return cls(
            _lengths(pixels, block), around[1] / np.maximum(around[0], 1e-9),
            around[0] / np.maximum(around[2], 1) >= TEXTURE, pieces, piece,
            np.divide(by_piece[1], by_piece[0], out=np.full(len(pieces), np.nan), where=by_piece[0] > 0),
        )

    def cells(self) -> list[str]:
        """For a row of the table."""
        states = np.array([piece.state for piece in self.pieces] + [None], dtype=object)
        state = states[self.piece]
        textured = self.length_m * self.is_textured
        is_near = self.piece >= 0
        is_measured = is_near & (state != PieceState.NOT_MEASURED) & (state != PieceState.NO_DETAIL)
        judged = [place for place, piece in enumerate(self.pieces)
                  if piece.kept and np.isfinite(self.piece_truth[place])]
        lengths = np.array([self.pieces[place].piece.length_m for place in judged])
        kept, low, high = np.array([
            (self.pieces[place].least_kept, self.pieces[place].low, self.pieces[place].high) for place in judged
        ], float).reshape(-1, 3).T
        failed = np.array([self.pieces[place].state is PieceState.FAILED for place in judged], bool)
        truth = self.piece_truth[judged]
        errors, right, sound, below = kept - truth, (low <= truth) & (truth <= high), truth >= SOUND, high < 1
        planted_m = float((textured * (self.truth < FAILED)).sum())
        false_m = float(lengths[failed & (truth >= FAILED)].sum())

        def share(part: float, whole: float) -> str:
            return f"{100 * part / whole:.0f}" if whole else "-"

        return [
            f"{textured.sum():.0f}", share((textured * is_near).sum(), textured.sum()),
            share((textured * is_measured).sum(), textured.sum()), f"{planted_m:.0f}",
            f"{lengths[failed].sum():.0f}", f"{false_m:.0f}", f"{lengths[failed & sound].sum():.0f}",
            share(lengths[below & sound].sum(), lengths[sound].sum()), f"{np.median(errors):+.3f}",
            f"{np.median(np.abs(errors)):.3f}", share(right.sum(), len(right)),
        ] if judged else [f"{textured.sum():.0f}", *["-"] * 10]


HEAD = ["delivery", "textured m", "found %", "measured %", "below 0.7 m", "failed m", "falsely m", "sound failed m",
        "sound below 1 %", "bias", "error", "right %", "s"]


def _as_mask(pixels: np.ndarray, shape: Sequence[int]) -> np.ndarray:
    mask = np.zeros(tuple(shape), bool)
    mask[tuple(pixels.T)] = True
    return mask


def _dense(vertices: np.ndarray, step: float) -> np.ndarray:
    """Points on a line, a step apart, (n, 2)."""
    along = np.append(0, np.hypot(*np.diff(vertices, axis=0).T).cumsum())
    places = np.linspace(0, along[-1], max(int(along[-1] / step), 2))
    return np.column_stack([np.interp(places, along, one) for one in vertices.T])


def _lengths(pixels: np.ndarray, block: PlantedBlock) -> np.ndarray:
    """Metres of seam that each pixel of a staircase stands for, (n,)."""
    near = cKDTree(pixels).query_ball_point(pixels, 10.5, return_length=True)
    return np.asarray(21 * block.pixel_m / np.maximum(near, 1))


def outcomes(half: str, imagery: str, piece_m: float) -> Iterator[list[str]]:
    """A row of the table for every delivery, without its seamlines and with them."""
    data = os.environ.get("SEAM_INSPECTOR_DATA")
    for ground in grounds(Path(data) if data else None, imagery.lower()):
        if min(ground.imagery.rows, ground.imagery.columns) < 2 * PLANT_PX:
            continue
        for (mosaic, orthoimages), (plant, widths) in (
            (codec, plant) for codec in CODECS[half] for plant in PLANTS.items()
        ):
            block = planted(ground.imagery, widths, half != "used", orthoimages)
            piece = piece_m * block.pixel_m / 0.1
            with tempfile.TemporaryDirectory() as folder:
                path, sources, polygons = block.write(Path(folder), mosaic, LOSSLESS)
                for seamlines in ("", str(polygons)):
                    started = time.perf_counter()
                    result = scan(open_block(path, sources), ScanSettings(piece_m=piece), seamlines=seamlines)
                    found = ScanOutcome.of(block, result, piece / block.pixel_m)
                    name = f"{ground.imagery.name}, {orthoimages.name} / {mosaic.name}, {plant}"
                    row = [name + (", given" if seamlines else ""), *found.cells(),
                           f"{time.perf_counter() - started:.0f}"]
                    print(" ".join(row), flush=True)
                    yield row


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.compressed_scans", description=__doc__.split("\n")[0])
    parser.add_argument("--half", choices=tuple(CODECS), default="used")
    parser.add_argument("--imagery", default="", help="only grounds whose name holds this")
    parser.add_argument("--piece", type=float, default=10.0, help="length of a piece at 0.1 m a pixel, m")
    arguments = parser.parse_args()
    gdal.UseExceptions()
    rows = list(outcomes(arguments.half, arguments.imagery, arguments.piece))
    print_table("Scans of compressed deliveries", HEAD, rows,
                "Seam: along which the hard cut has texture. Measured: of that. Below 0.7: truly. Falsely: failed\n"
                "  pieces that truly keep 0.7 or more. Sound: pieces that truly keep 0.98 or more.")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
