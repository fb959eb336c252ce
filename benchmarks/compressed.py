"""How truly compressed deliveries are judged: `make benchmark-compressed`.

Mosaics whose seams are known are stored by a codec, and so are their orthoimages: before the mosaic was made, since, or
one of them alone. What the plugin says of each window is compared with the detail that was truly left, and with whether
an orthoimage is missing. Where a given one, moved if need be, has what it shows there, or codecs leave over as much, it
counts apart, as faint. Codecs, makings and grounds stand in halves: those that may be looked at while limits are set,
and those that are held back.
"""
from __future__ import annotations

import argparse
import json
import os
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass, replace
from itertools import product
from pathlib import Path
from uuid import uuid4

import numpy as np
from osgeo import gdal
from scipy import ndimage
from seam_inspector.plugin.seams.measure.window.measured_window import InspectionSettings
from skimage.registration import phase_cross_correlation

from . import seam_makings as seams
from .detail import details, luminance_of
from .detection import grounds
from .known_windows import MIN_TEXTURE, KnownWindow, WindowFacts
from .production import Made
from .readings import inspected, reading_of
from .seam_makings import Mix
from .true_profile import truth_of


@dataclass(frozen=True)
class Codec:
    """A way to store an image; quality 0: without loss."""

    driver: str = ""
    quality: int = 0
    shift_px: int = 0
    """How far the image's blocks lie beside the mosaic's."""
    full_colour: bool = False
    """Whether colours are stored for every pixel (4:4:4) and not for every fourth."""

    @property
    def name(self) -> str:
        if not self.quality:
            return "lossless"
        return f"{self.driver} {self.quality}" + (" 4:4:4" if self.full_colour else "") + (
            f" {self.shift_px} px beside" if self.shift_px else "")

    def stored(self, bands: np.ndarray) -> np.ndarray:
        """The bands (bands, rows, columns), 8 bit, written to a file and read back."""
        if not self.quality:
            return bands
        moved = np.roll(bands, (self.shift_px, self.shift_px), (1, 2))
        _, rows, columns = bands.shape
        memory = gdal.GetDriverByName("MEM").Create("", columns, rows, len(bands), gdal.GDT_Byte)
        memory.WriteArray(moved)
        path = f"/vsimem/{uuid4().hex}"
        options, driver = [f"QUALITY={self.quality}"], self.driver
        if driver == "JPEG" and self.full_colour:  # the driver's own files have 4:2:0 alone
            driver = "GTiff"
            options = ["COMPRESS=JPEG", f"JPEG_QUALITY={self.quality}", "PHOTOMETRIC=RGB", "INTERLEAVE=PIXEL"]
        elif driver == "JP2OpenJPEG":
            options.append("REVERSIBLE=NO")
        gdal.GetDriverByName(driver).CreateCopy(path, memory, options=options)
        found = gdal.Open(path).ReadAsArray()
        gdal.GetDriverByName(driver).Delete(path)
        return np.maximum(np.roll(found, (-self.shift_px, -self.shift_px), (1, 2)), 1)


LOSSLESS = Codec()
WAVELET = "coif3"
SMOOTH_PX = 2.0
"""Sigma of what is coarser than the detail that images are placed by."""
WAYS = ("lossless", "before", "since", "one since", "one before")
MAKINGS: dict[str, dict[str, Mix]] = {
    "used": {
        "hard": seams.hard, "13": seams.feathered(13, "cosine"), "33": seams.feathered(33, "linear"),
        "66": seams.feathered(66, "cosine"), "256": seams.feathered(256, "linear"), "multiband": seams.blended,
        "missing 30": seams.missing(0.3), "missing 15": seams.missing(0.15),
    },
    "held back": {
        "hard": seams.hard, "13": seams.feathered(13, "linear"), "33": seams.feathered(33, "cosine"),
        "66": seams.feathered(66, "linear"), "256": seams.feathered(256, "cosine"), "multiband": seams.blended,
        "missing 50": seams.missing(0.5), "missing 20": seams.missing(0.2),
    },
}


def codecs(half: str) -> Iterator[tuple[Codec, str, Codec]]:
    """Codec of the mosaic, way of the orthoimages, and their codec."""
    qualities = (75, 90) if half == "used" else (60, 85, 95)
    mosaics = (LOSSLESS, *(Codec("JPEG", quality) for quality in qualities))
    for mosaic, way in product(mosaics, WAYS):
        if way == "lossless":
            yield mosaic, way, LOSSLESS
            continue
        for quality in qualities if way in ("before", "since") else qualities[:1]:
            yield mosaic, way, Codec("JPEG", quality)
            if mosaic.quality == quality and way == "before":
                yield mosaic, way, Codec("JPEG", quality, shift_px=3)
                yield replace(mosaic, full_colour=True), way, Codec("JPEG", quality, full_colour=True)
    others = (("WEBP", 75), ("JP2OpenJPEG", 20)) if half == "used" else (("WEBP", 85), ("JP2OpenJPEG", 10))
    for driver, quality in others:
        yield Codec(driver, quality), "before", Codec(driver, quality)
        yield Codec(driver, quality), "lossless", LOSSLESS


@dataclass(frozen=True)
class Case:
    """One mosaic to be made."""

    making: str
    half: str
    mosaic: Codec
    way: str
    orthoimages: Codec

    def made(self, window: KnownWindow) -> Made | None:
        """The mosaic of a window; None where the making does not fit it."""
        mix = MAKINGS[self.half][self.making]
        before = self.way in ("before", "one before")
        if self.making.startswith("missing") and not window.is_covered:
            return None
        stored = self.stored(window)
        used = replace(window, sources=stored) if before else window
        seed = [len(self.making), window.number, window.side]
        mixed = mix(used, np.random.default_rng(seed))
        is_missing = mixed.foreign[window.middle].any()
        truth = np.nan if is_missing else truth_of(mixed, seams.seam_distance(mixed.labels), window.middle).near
        return Made(self.mosaic.stored(mixed.bands), mixed.bands, tuple(stored[k] for k in mixed.given),
                    tuple(window.valid[k] for k in mixed.given), ((0.0, 0.0),) * len(mixed.given), truth,
                    frozenset(), mixed.foreign, frozenset())

    def stored(self, window: KnownWindow) -> tuple[np.ndarray, ...]:
        """A window's orthoimages as they are given."""
        return tuple(
            self.orthoimages.stored(source) if "one" not in self.way or k == window.main[1] else source
            for k, source in enumerate(window.sources)
        )


def shows_missing(mosaic: np.ndarray, given: Sequence[np.ndarray], missing: np.ndarray, part: np.ndarray) -> bool:
    """Whether the given orthoimages, as they lie or moved, leave over more of a part's finest detail than the missing
    one would: by as much again, and by what windows need to have texture. Bands (bands, rows, columns), the part (rows,
    columns) bool."""
    plane, *others = map(luminance_of, (mosaic, missing, *given))
    own = details(plane, 1, WAVELET)[:, part]

    def left_over(other: np.ndarray) -> float:
        """Variance, whatever the contrast."""
        its = details(other, 1, WAVELET)[:, part]
        shared = max(float((own * its).sum()), 0.0)
        return float((own**2).sum() - shared**2 / max(float((its**2).sum()), 1e-9)) / int(part.sum())

    noise, *left = map(left_over, others)
    left += [left_over(_moved(other, plane, part)) for other in others[1:]]
    return min(left) - noise >= max(noise, MIN_TEXTURE)


def _moved(plane: np.ndarray, onto: np.ndarray, part: np.ndarray) -> np.ndarray:
    """A plane where its fine detail fits a part of another one best."""
    fine, own = (one - ndimage.gaussian_filter(one, SMOOTH_PX) for one in (plane, onto))
    shift = phase_cross_correlation(own * part, fine, upsample_factor=16, normalization=None)[0]
    return np.asarray(ndimage.shift(plane, shift, order=5, mode="mirror"))


def run(task: tuple[Case, KnownWindow]) -> dict[str, object] | None:
    """What the plugin says of one mosaic."""
    gdal.UseExceptions()
    case, window = task
    made = case.made(window)
    if made is None:
        return None
    started = time.process_time()
    result = inspected(made, window, InspectionSettings())
    seconds = time.process_time() - started
    reading, profile = reading_of(result), result.profile
    part = np.zeros_like(made.foreign)
    part[window.middle] = made.foreign[window.middle]
    missing = case.stored(window)[window.main[1]]
    return {
        "making": case.making, "mosaic": case.mosaic.name, "way": case.way, "orthoimages": case.orthoimages.name,
        "ground": window.imagery, "number": window.number, "side": window.side, "truth": made.truth,
        "missing": float(made.foreign[window.middle].mean()),
        "faint": bool(part.any() and not shows_missing(made.bands, made.sources, missing, part)),
        "seconds": seconds,
        "energy": profile and profile.by_energy, "mixture": profile and profile.by_mixture,
        "width": profile and profile.feather_width_px, "measure": profile and profile.measure.value,
        "left": profile and profile.left_by_mixture, "strength": profile and profile.energy,
        **{k: v for k, v in asdict(reading).items() if k != "tones"},
    }


def table(title: str, rows: Sequence[dict]) -> None:
    """Print one line: windows without a missing orthoimage, with one, and with one that is faint."""
    whole = [row for row in rows if not row["missing"]]
    faint = [row for row in rows if row["faint"]]
    parts = [row for row in rows if row["missing"] and not row["faint"]]
    measured = [one for one in whole if np.isfinite(one["kept"]) and np.isfinite(one["truth"])]
    errors = np.array([one["kept"] - one["truth"] for one in measured])
    hard = [one for one in measured if one["making"] == "hard"]

    def mean(values: Sequence[bool]) -> float:
        return float(np.mean(values)) if len(values) else np.nan

    said = "missing source"

    def named(windows: Sequence[dict]) -> float:
        return 100 * mean([said in window["causes"] or window["verdict"] == "not_comparable" for window in windows])

    print(f"{title:34s} {len(whole):4d} {len(parts):4d} {len(faint):4d} | "
          f"false {100 * mean([said in o['causes'] for o in whole]):5.1f} "
          f"true {named(parts):5.1f} faint {named(faint):5.1f} | "
          f"error {np.median(np.abs(errors)) if len(errors) else np.nan:.3f} bias "
          f"{np.median(errors) if len(errors) else np.nan:+.3f} p90 "
          f"{np.quantile(np.abs(errors), 0.9) if len(errors) else np.nan:.3f} right "
          f"{100 * mean([o['low'] <= o['truth'] <= o['high'] for o in measured]):5.1f} width "
          f"{np.median([o['high'] - o['low'] for o in measured]) if measured else np.nan:.2f} | verdicts "
          f"{100 * mean([o['verdict'] != 'not_comparable' for o in whole]):5.1f} | hard: significant "
          f"{100 * mean([o['verdict'] == 'significant' for o in hard]):4.1f} below 1 "
          f"{100 * mean([o['high'] < 1 for o in hard]):4.1f} feathering "
          f"{100 * mean(['feathering' in o['causes'] for o in hard]):4.1f} blur "
          f"{100 * mean(['blur' in o['causes'] for o in hard]):4.1f}", flush=True)


def report(rows: Sequence[dict]) -> None:
    """Print all tables."""
    table("all", rows)
    for key in ("side", "ground", "making", "way", "mosaic"):
        for value in sorted({row[key] for row in rows}, key=str):
            table(f"{key} {value}", [row for row in rows if row[key] == value])
    for mosaic, way, orthoimages in sorted(
        {(row["mosaic"], row["way"], row["orthoimages"]) for row in rows}):
        table(f"{mosaic} / {way} {orthoimages if way != 'lossless' else ''}", [
            row for row in rows if (row["mosaic"], row["way"], row["orthoimages"]) == (mosaic, way, orthoimages)])


def tasks(half: str, side: int, imagery: str, count: int) -> Iterator[tuple[Case, KnownWindow]]:
    """Every codec with every making, each on ``count`` windows in turn of all grounds; none without texture."""
    data = os.environ.get("SEAM_INSPECTOR_DATA")
    cases = [Case(making, half, *one) for one in codecs(half) for making in MAKINGS[half]]
    every: list[KnownWindow] = []
    for ground in grounds(Path(data) if data else None, imagery.lower()):
        windows = ground.imagery.windows(side, 24, half != "used")
        every += [window for window in windows if WindowFacts.of(window).has_texture][: 24 if ground.share == 1 else 8]
    order = np.random.default_rng(1).permutation(len(cases) * count)
    for turn, place in enumerate(order.tolist() if every else ()):
        yield cases[place % len(cases)], every[turn % len(every)]


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.compressed", description=__doc__.split("\n")[0])
    parser.add_argument("--half", choices=("used", "held back"), default="used")
    parser.add_argument("--sides", type=int, nargs="+", default=[512, 256])
    parser.add_argument("--count", type=int, default=1, help="windows of each codec and making")
    parser.add_argument("--imagery", default="", help="only grounds whose name holds this")
    parser.add_argument("--only", default="", help="only makings, codecs and ways that hold this")
    parser.add_argument("--share", type=float, default=1.0, help="of the tasks")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--out", help="a file of JSON lines")
    arguments = parser.parse_args()
    gdal.UseExceptions()
    every = [
        one for side in arguments.sides for one in tasks(arguments.half, side, arguments.imagery, arguments.count)
        if arguments.only in f"{one[0].making} {one[0].mosaic.name} {one[0].way}"
    ]
    every = every[:: max(1, round(1 / arguments.share))]
    started = time.perf_counter()
    with ProcessPoolExecutor(arguments.jobs) as pool:
        rows = [one for one in pool.map(run, every, chunksize=8) if one is not None]
    if arguments.out:
        Path(arguments.out).write_text("".join(json.dumps(row) + "\n" for row in rows))
    report(rows)
    print(f"{time.perf_counter() - started:.0f} s")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
