"""How much detail mosaicking programs keep along their seams: `make benchmark-programs`.

Two orthoimages that overlap along a known line go through every program and mode of ``program_makings``, lossless and
by JPEG on both sides: the orthoimages before, the mosaic since. What the plugin says of each mosaic stands beside the
truth by the program's own weights, which are read off a mosaic of two grey images.
"""
from __future__ import annotations

import argparse
import json
import os
import tempfile
import time
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass, replace
from math import ceil
from pathlib import Path

import numpy as np
from osgeo import gdal
from seam_inspector.plugin.imagery.limits import LUMINANCE
from seam_inspector.plugin.seams.measure.window.measured_window import InspectionSettings
from seam_inspector.plugin.seams.measure.window.window_result import WindowResult

from .compressed import LOSSLESS, Codec
from .detail import details, luminance_of
from .detection import grounds
from .figures import figure, median, percent
from .known_windows import KnownWindow, WindowFacts
from .production import Made
from .program_makings import MODES, NODATA, Mode, Overlap, Product, TruthBy, missing_programs
from .readings import inspected, number, reading_of
from .seam_makings import Mixed, Part, mixed, seam_distance, signed_distance
from .timing import print_table, say
from .true_profile import BIN_PX, truth_of

OVERLAP_PX = 64
ZONES_PX = (-64, -32, -16, *range(-BIN_PX, BIN_PX + 1), 16, 32, 64)
"""Distances from a seam between which one weight is fitted; the second image's side is positive."""
GREYS = (50, 250)
"""Grey values of the two images that a program's weights are read from."""
SNAP = 0.01
"""A weight nearer to 0 or 1 is that: programs round and cut grey values differently."""
TIE = 0.02
"""Weights nearer to one half name neither image: the side of the line counts."""
UNMIXED = 0.1
"""Weight of the other image where a feather ends, as the plugin has it."""
FAR = 0.05
"""Distance from the truth that is a disagreement, even inside the interval."""
FEATHER_PX = 10
MOST_HOLES = 0.001
"""Share of the pixels without a value in a mosaic of which it can't be told what was kept."""
CODECS = tuple((codec, replace(codec, shift_px=0)) for codec in (
    LOSSLESS, Codec("JPEG", 90), Codec("JPEG", 75, shift_px=3), Codec("JPEG", 75)))
"""Codecs of the orthoimages, and of the mosaic."""
HEAD = ("program, mode", "truth", "delivered", "kept_1", "interval", "right", "feather true", "feather px", "gain",
        "off weights DN", "seconds")
MARKS = {"weights": "", "mask": " *", "mosaic": " **"}
NOTE = (
    "Medians of {windows} windows of {side} px, overlap {overlap} px. truth: by the program's own weights; * by its\n"
    "  own seam mask; ** by weights fitted to the mosaic before compression, for a blend by levels or by content.\n"
    "  delivered: all detail of the stored mosaic against the ground, edges of the cut and traces of compression\n"
    "  included. right: windows in whose interval the truth lies, of those with both. off weights: root mean square\n"
    "  of the mosaic less the weighted images.")
SUMMARY_HEAD = ("orthoimages and mosaic", "figures", "median error", "right %", "feathers: kept_1 - truth", "right %")
FAR_HEAD = ("program, mode", "codec", "window", "truth", "delivered", "kept_1", "low", "high", "energy", "mixture",
            "verdict", "causes")


@dataclass(frozen=True, eq=False)
class Mixture:
    """What is known of how a mode mixes two images over one window."""

    labels: np.ndarray
    """Number of the image that each pixel follows, (rows, columns) uint8."""
    weights: tuple[np.ndarray, np.ndarray]
    """Weights of the two images, (rows, columns) float32."""

    @property
    def feather_px(self) -> float:
        """Full width of a linear feather that mixes as many pixels from 10 to 90 %, a pixel of seam."""
        length = (seam_distance(self.labels) <= BIN_PX).sum() / (2 * BIN_PX)
        second = self.weights[1] / np.maximum(sum(self.weights), TIE)
        return float((np.minimum(second, 1 - second) >= UNMIXED).sum() / length / (1 - 2 * UNMIXED))


@dataclass(frozen=True)
class Row:
    """One mosaic of one window: what is true and what the plugin says; nan where it says nothing."""

    mode: str
    codec: str
    ground: str
    window: int
    truth_by: str
    truth: float
    delivered: float
    """Detail of the mosaic as it was stored, its compression included, against the ground."""
    kept: float
    low: float
    high: float
    verdict: str
    causes: tuple[str, ...]
    true_feather_px: float
    feather_px: float
    gain: float
    """Gain of the mosaic's grey values against the plugin's hard cut."""
    off_dn: float
    by_energy: float
    by_mixture: float
    holes: float
    """Share of the mosaic's pixels that are nodata."""
    seconds: float

    @property
    def is_compared(self) -> bool:
        """Whether there are both a figure and a truth."""
        return not np.isnan(self.kept) and not np.isnan(self.truth)

    @property
    def is_right(self) -> bool:
        return self.low <= self.truth <= self.high

    @property
    def disagrees(self) -> bool:
        """Whether the figure is far off, or the truth outside its interval."""
        return self.is_compared and not (self.is_right and abs(self.kept - self.truth) <= FAR)


def made_by(mode: Mode, overlap: Overlap) -> tuple[Product, float]:
    """What a mode makes of an overlap, and the seconds that it takes."""
    with tempfile.TemporaryDirectory(prefix="seam_inspector_") as name:
        folder = Path(name)
        overlap.write(folder)
        started = time.perf_counter()
        return mode.make(overlap, folder), time.perf_counter() - started


def overlap_of(window: KnownWindow) -> Overlap:
    """The window's main orthoimages, each ending half an overlap beyond the known cut."""
    first, second = window.main
    is_second = window.labels == second
    depth = signed_distance(is_second)
    images = tuple(np.maximum(window.sources[number], 1) for number in (first, second))
    return Overlap(images, (depth < OVERLAP_PX / 2, depth > -OVERLAP_PX / 2), is_second, window.pixel_m)


def probed(mode: Mode, overlap: Overlap) -> Mixture:
    """The mixture by a mosaic of two grey images."""
    product, _ = made_by(mode, overlap.painted(*GREYS))
    weight = (product.bands[0].astype(np.float32) - GREYS[0]) / (GREYS[1] - GREYS[0])
    weight = np.where(np.abs(weight - np.rint(weight)) <= SNAP, np.rint(weight), weight)
    is_second = np.where(np.abs(weight - 0.5) <= TIE, overlap.is_second, weight > 0.5)
    return Mixture(is_second.astype(np.uint8), (1 - weight, weight))


def masked(overlap: Overlap, product: Product) -> Mixture:
    """The mixture of a cut along the program's own mask, or along the line where it has none."""
    labels = (overlap.is_second if product.mask is None else product.mask).astype(np.uint8)
    return Mixture(labels, (np.float32(1) - labels, labels.astype(np.float32)))


def fitted(overlap: Overlap, product: Product) -> Mixture:
    """The mixture by least squares: how much of each image's finest detail is there, by distance from the seam."""
    labels = masked(overlap, product).labels
    zones = np.digitize(np.where(labels == 1, 1, -1) * seam_distance(labels), ZONES_PX)
    mosaic, first, second = (details(luminance_of(one), 1, "coif3") for one in (product.bands, *overlap.images))
    weights = np.zeros((2, *labels.shape), np.float32)
    for zone in np.unique(zones):
        inside = zones == zone
        images = np.stack([first[:, inside].ravel(), second[:, inside].ravel()], axis=1)
        weights[:, inside] = np.linalg.lstsq(images, mosaic[:, inside].ravel(), rcond=None)[0][:, np.newaxis]
    return Mixture(labels, (weights[0], weights[1]))


def rows_of(mode: Mode, window: KnownWindow) -> Iterator[Row]:
    """Its mosaics of one window by every codec."""
    plain = overlap_of(window)
    probe = probed(mode, plain) if mode.truth_by is TruthBy.WEIGHTS else None
    for before, since in CODECS:
        overlap = replace(plain, images=tuple(before.stored(image) for image in plain.images))
        product, seconds = made_by(mode, overlap)
        mixture = probe or (masked if mode.truth_by is TruthBy.MASK else fitted)(overlap, product)
        parts = mixed(overlap.images, mixture.weights, mixture.labels)
        stored = since.stored(product.bands)
        whole = replace(parts, parts=(Part(luminance_of(stored), np.ones(stored.shape[1:], np.float32)),))
        truth, delivered = (against_ground(one, window) for one in (parts, whole))
        holes = float((product.bands == NODATA).all(axis=0).mean())
        result = inspected(made_of(overlap, stored, parts), replace(window, labels=mixture.labels),
                           InspectionSettings())
        reading, profile = reading_of(result), result.profile
        width, energy, by_mixture = (
            (profile.feather_width_px, profile.by_energy, profile.by_mixture) if profile else (None,) * 3)
        off = luminance_of(product.bands) - luminance_of(parts.bands)
        yield Row(
            mode.name, before.name, window.imagery, window.number, mode.truth_by.value,
            truth if holes <= MOST_HOLES else np.nan, delivered, reading.kept, reading.low, reading.high,
            reading.verdict, reading.causes, mixture.feather_px, number(width), gain_of(result),
            np.nan if mode.truth_by is TruthBy.MOSAIC else float(np.sqrt(np.square(off).mean())),
            number(energy), number(by_mixture), holes, seconds,
        )


def against_ground(parts: Mixed, window: KnownWindow) -> float:
    """What is kept beside the seam, relative to what is kept farther off than the overlap."""
    distance = seam_distance(parts.labels)
    near, far = distance, np.where(distance >= OVERLAP_PX, 0, np.inf)
    kept = [truth_of(parts, pixels, window.middle).near for pixels in (near, far)]
    return kept[0] / kept[1]


def made_of(overlap: Overlap, stored: np.ndarray, parts: Mixed) -> Made:
    """The stored mosaic with both orthoimages, each given as a whole."""
    everywhere = (np.ones(overlap.is_second.shape, bool),) * 2
    return Made(stored, parts.bands, overlap.images, everywhere, ((0.0, 0.0),) * 2, np.nan, frozenset(), parts.foreign,
                frozenset())


def gain_of(result: WindowResult) -> float:
    """The mosaic's tones against the plugin's hard cut."""
    tone = result.explanation.changes[-1][LUMINANCE].tone if result.explanation else None
    return tone.gain if tone else np.nan


def windows_of(data: Path | None, side: int, count: int, imagery: str, held_back: bool) -> Iterator[KnownWindow]:
    """Up to ``count`` windows of the main ground, fewer of others: with texture, and covered by all orthoimages."""
    for ground in grounds(data, imagery.lower()):
        fit = [window for window in ground.imagery.windows(side, 4 * count, held_back)
               if window.is_covered and WindowFacts.of(window).has_texture]
        yield from fit[: ceil(count * ground.share)]


def cells(rows: Sequence[Row]) -> list[str]:
    """The line of one mode and codec."""
    compared = [row for row in rows if row.is_compared]

    def of(name: str, unit: str = ".2f") -> str:
        value = median(getattr(row, name) for row in rows)
        return "." if np.isnan(value) else format(value, unit)

    return [rows[0].mode, of("truth") + MARKS[rows[0].truth_by], of("delivered"), of("kept"),
            f"{of('low')} to {of('high')}", f"{sum(row.is_right for row in compared)} of {len(compared)}",
            of("true_feather_px", ".0f"), of("feather_px", ".0f"), of("gain"), of("off_dn"), of("seconds", ".1f")]


def summary(codec: Codec, rows: Sequence[Row]) -> list[str]:
    """The line of one codec: all modes, then feathers alone."""
    compared = [row for row in rows if row.codec == codec.name and row.is_compared]
    feathers = [row for row in compared if row.true_feather_px >= FEATHER_PX]
    return [codec.name, str(len(compared)), figure(median(abs(row.kept - row.truth) for row in compared)),
            percent(row.is_right for row in compared), f"{median(row.kept - row.truth for row in feathers):+.3f}",
            percent(row.is_right for row in feathers)]


def report(rows: Sequence[Row], note: str) -> None:
    """Print a table for each codec, what keeps most first, and the disagreements."""
    kept = {mode: median(row.truth for row in rows if (row.mode, row.codec) == (mode, LOSSLESS.name))
            for mode in {row.mode for row in rows}}
    order = sorted(kept, key=lambda mode: (-np.nan_to_num(kept[mode]).round(2), mode))
    for codec, _ in CODECS:
        groups = ([row for row in rows if (row.mode, row.codec) == (mode, codec.name)] for mode in order)
        print_table(f"Orthoimages and mosaic {codec.name}", HEAD, [cells(group) for group in groups], note)
    print_table("All modes; feathers are those of 10 px and more", SUMMARY_HEAD,
                [summary(codec, rows) for codec, _ in CODECS])
    holes = {mode: max(row.holes for row in rows if row.mode == mode) for mode in order}
    print("  Pixels without a value inside the mosaic:", "; ".join(
        f"{mode}, up to {share:.1%}" for mode, share in holes.items() if share > MOST_HOLES) or "none")
    far = [[row.mode, row.codec, f"{row.ground} {row.window}",
            *(figure(getattr(row, name)) for name in ("truth", "delivered", "kept", "low", "high", "by_energy",
                                                      "by_mixture")),
            row.verdict, "; ".join(row.causes)] for row in rows if row.disagrees]
    print_table(f"Disagreements: truth outside the interval, or more than {FAR} off: {len(far)} of "
                f"{sum(row.is_compared for row in rows)}",
                FAR_HEAD, far)


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.programs", description=__doc__.split("\n")[0])
    parser.add_argument("--side", type=int, default=512, help="of the windows, px")
    parser.add_argument("--windows", type=int, default=2, help="of the main ground; half as many of each other")
    parser.add_argument("--imagery", default="", help="only grounds whose name holds this")
    parser.add_argument("--half", choices=("used", "held back"), default="held back", help="of the ground")
    parser.add_argument("--only", default="", help="only programs and modes that hold this")
    parser.add_argument("--out", help="a file of JSON lines")
    arguments = parser.parse_args()
    gdal.UseExceptions()
    data = os.environ.get("SEAM_INSPECTOR_DATA")
    missing = list(missing_programs())
    if missing:
        print(f"Missing here, so without rows: {', '.join(missing)}", flush=True)
    modes = [mode for mode in MODES if mode.is_installed and arguments.only in mode.name]
    windows = list(windows_of(Path(data) if data else None, arguments.side, arguments.windows, arguments.imagery,
                              arguments.half == "held back"))
    rows: list[Row] = []
    for window in windows:
        say(f"{window.imagery} {window.number}")
        rows += [row for mode in modes for row in rows_of(mode, window)]
        if arguments.out:
            Path(arguments.out).write_text("".join(json.dumps(asdict(row)) + "\n" for row in rows))
    if not rows:
        print("No such ground, program or mode.")
        return 1
    report(rows, NOTE.format(windows=len(windows), side=arguments.side, overlap=OVERLAP_PX))
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
