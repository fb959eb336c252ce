"""Whether deliveries are decided rightly: `make benchmark-deliveries`.

Twelve deliveries whose truth is planted: Brighton, PackO, the demonstration's block and ground that is partly smooth,
lossless and with JPEG on both sides, their seams found, given or partly given, with an orthoimage that is missing or
sheets that hide each other. Each is scanned and decided on; printed are the truth, the decision and its reason. Limits
in metres are those of a mosaic of 0.1 m, by pixels.
"""
from __future__ import annotations

import argparse
import os
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path

import numpy as np
from osgeo import gdal, ogr
from scipy.ndimage import gaussian_filter
from seam_inspector import (
    Decision,
    ScanResult,
    ScanSettings,
    limit_rules,
    open_block,
    scan,
)
from seam_inspector.plugin.acceptance.measure.deciding import decide
from seam_inspector.plugin.acceptance.measure.decision import AcceptanceOutcome
from seam_inspector.plugin.acceptance.measure.delivered_files import OrderedForm, OrderedSheet, checked_sheets
from seam_inspector.plugin.acceptance.measure.delivered_rows import make_delivery
from seam_inspector.plugin.acceptance.measure.delivery import Delivery, SheetOutline
from seam_inspector.plugin.acceptance.measure.scanned_files import file_doubts
from seam_inspector.plugin.seams.measure.scan.scan_result import seam_rows

from .compressed import LOSSLESS, WAVELET, Codec
from .compressed_scans import FAILED, SCANNED_PX, PlantedBlock, ScanOutcome
from .detail import detail_energy, luminance_of
from .detection import grounds
from .known_windows import Imagery, PlacedImage, hard_cut
from .timing import print_table

PIECE_PX = 250
"""25 m at 0.1 m a pixel, as a scan cuts seams unless told otherwise."""
RUN_PX = 500
"""That may fail without a break."""
SHARE = 0.02
"""That may fail."""
CLEAR = 1.25
"""Times more or less than that: what has to be decided, and rightly."""
SMOOTH_PX = 40.0
"""Sigma by which all detail is taken from the upper third of smooth ground."""
OVERLAP_PX = 240
LEAST_PART = 0.007
"""Of the ground, by a part that is cut from one orthoimage: seam editors leave no islands."""
LEAST_VALID = 0.05
"""Of the ground, by an orthoimage that takes part."""
SOUND: tuple[float, ...] = (0.0,)
JPEG_75, JPEG_80, JPEG_85, JPEG_90 = (Codec("JPEG", quality) for quality in (75, 80, 85, 90))
ACCEPTED, REJECTED, UNDECIDED = AcceptanceOutcome


@dataclass(frozen=True)
class Case:
    """A delivery as it is made and handed over."""

    ground: str
    codec: Codec = LOSSLESS
    """Of the mosaic; that of the orthoimages has blocks 3 px beside."""
    widths_px: Sequence[float] = SOUND
    """Of the mixtures planted in turn."""
    seamlines: str = "none"
    """``given``, ``partly`` or ``none``."""
    lacks: str = ""
    """What of it can't be accepted: ``orthoimage``, which is not given, or ``sheets`` that hide each other."""

    @property
    def name(self) -> str:
        planted = ", ".join(f"{width:g}" for width in self.widths_px if width) or "sound"
        words = [self.ground, self.codec.name, planted, f"seamlines {self.seamlines}"]
        return ", ".join([*words, *([f"lacks {self.lacks}"] if self.lacks else [])])

    def wanted(self, failed_share: float) -> set[AcceptanceOutcome]:
        """The outcomes that are right, by the share of the seams that truly fails."""
        found = {REJECTED} if failed_share > CLEAR * SHARE else {ACCEPTED} if failed_share < SHARE / CLEAR else set(
            AcceptanceOutcome
        )
        return {UNDECIDED, *(found - {ACCEPTED})} if self.lacks or self.seamlines == "partly" else found


CASES = (
    Case("brighton"),
    Case("brighton", widths_px=(0.0, 13.0, 0.0, 33.0), seamlines="given"),
    Case("packo", widths_px=(33.0,)),
    Case("block", seamlines="partly"),
    Case("block", lacks="sheets"),
    Case("smooth block", seamlines="given"),
    Case("brighton", JPEG_90),
    Case("brighton", JPEG_75, (0.0, 0.0, 66.0), "given"),
    Case("block", JPEG_90, seamlines="given"),
    Case("block", JPEG_85, lacks="orthoimage"),
    Case("packo", JPEG_80, seamlines="given"),
    Case("smooth block", JPEG_90, (0.0, 0.0, 66.0)),
)


@lru_cache(4)
def imagery_of(ground: str) -> Imagery | None:
    """None where there is none of it."""
    data = os.environ.get("SEAM_INSPECTOR_DATA")
    found = next(grounds(Path(data) if data else None, ground.split()[-1]), None)
    if found is None:
        return None
    if "smooth" not in ground:
        return found.imagery
    return replace(found.imagery, placed=tuple(_smoothed(image, found.imagery.rows) for image in found.imagery.placed))


def _smoothed(one: PlacedImage, rows: int) -> PlacedImage:
    """Without detail in the upper third of the ground, as a lake has it in all images; without a step below."""
    valid = one.valid
    weight = np.maximum(gaussian_filter(valid.astype(float), SMOOTH_PX), 1e-6)
    fade = np.clip((one.row + np.arange(len(valid)) - rows / 3) / 200 + 0.5, 0, 1)[:, np.newaxis]
    bands = []
    for band in one.bands:
        even = gaussian_filter(np.where(valid, band, 0).astype(float), SMOOTH_PX) / weight
        bands.append(np.where(valid, np.clip(np.rint(fade * band + (1 - fade) * even), 1, 255), one.nodata))
    return replace(one, bands=np.array(bands, one.bands.dtype))


def planted(case: Case, imagery: Imagery) -> PlantedBlock:
    """All of an imagery, its orthoimages stored before the mosaic was made."""
    side = min(max(imagery.rows, imagery.columns), SCANNED_PX)
    rows, columns = min(imagery.rows, side), min(imagery.columns, side)
    codec = replace(case.codec, shift_px=3 if case.codec.quality else 0)
    sources = []
    for one in imagery.placed:
        bands = one.over(0, 0, side)[:, :rows, :columns]
        mask = (bands != one.nodata).any(axis=0)
        if mask.mean() > LEAST_VALID:
            sources.append(np.where(mask, codec.stored(np.where(mask, bands, 1)), 0).astype(np.uint8))
    block = PlantedBlock.of(imagery, sources, case.widths_px, len(CASES), round(LEAST_PART * rows * columns))
    whole = hard_cut(sources, np.maximum(block.labels, 0))
    # What the followed orthoimages have, without the edge that a cut makes itself.
    own = [detail_energy(luminance_of(np.where(source.any(axis=0), source, whole)), 1, WAVELET) for source in sources]
    return replace(block, hard_energy=np.choose(np.maximum(block.labels, 0), own))


def scanned(case: Case, block: PlantedBlock, folder: Path) -> tuple[ScanResult, Delivery]:
    """What the scan of a delivery tells, and what is decided on."""
    mosaic, sources, polygons = block.write(folder, case.codec, LOSSLESS)
    sheets = _sheets(folder, mosaic, sources) if case.lacks == "sheets" else []
    if sheets:
        mosaic = folder / "sheets.vrt"
        gdal.BuildVRT(str(mosaic), [sheet.path for sheet in sheets]).FlushCache()
    if case.lacks == "orthoimage":
        sources.pop(int(np.bincount(block.labels[block.labels >= 0]).argmin()))
    if case.seamlines == "partly":
        _drop_half(polygons)
    settings = ScanSettings(piece_m=PIECE_PX * block.pixel_m)
    opened = open_block(mosaic, sources)
    result = scan(opened, settings, seamlines="" if case.seamlines == "none" else str(polygons))
    delivery = make_delivery({"mosaic": seam_rows(result)}, opened.mosaic.wkt, {"mosaic": result.told})
    checked = checked_sheets(sheets, OrderedForm(), lambda _: True)
    return result, replace(
        delivery, outlines=tuple(SheetOutline(one.sheet.name, b"", state=one.state) for one in checked)
    )


def _sheets(folder: Path, mosaic: Path, sources: Sequence[Path]) -> list[OrderedSheet]:
    """The mosaic in two sheets that overlap, where one of them has an orthoimage alone."""
    whole = gdal.Open(str(mosaic))
    half, rows = whole.RasterXSize // 2, whole.RasterYSize
    found = []
    for name, first, width in (("west", 0, half + OVERLAP_PX), ("east", half, whole.RasterXSize - half)):
        path = folder / f"{name}.tif"
        gdal.Translate(str(path), whole, srcWin=[first, 0, width, rows])
        found.append(OrderedSheet(name, str(path), None))
    other = max((gdal.Open(str(source)).ReadAsArray()[:, :, half:half + OVERLAP_PX] for source in sources), key=np.mean)
    west = gdal.Open(found[0].path, gdal.GA_Update)
    kept = west.ReadAsArray()[:, :, half:]
    west.WriteArray(np.where(other.any(axis=0), other, kept), half, 0)
    return found


def _drop_half(polygons: Path) -> None:
    """Every second outline: seams between those that are left out are in no line."""
    opened = ogr.Open(str(polygons), 1)
    layer = opened.GetLayer(0)
    sources = sorted({feature["source"] for feature in layer})
    dropped = sources[1::2]
    layer.ResetReading()
    for number in [feature.GetFID() for feature in layer if feature["source"] in dropped]:
        layer.DeleteFeature(number)


def row_of(case: Case, block: PlantedBlock, result: ScanResult, decision: Decision) -> list[str]:
    """A row of the table."""
    truth = ScanOutcome.of(block, result, PIECE_PX)
    planted_m, total_m = float((truth.length_m * (truth.truth < FAILED)).sum()), float(truth.length_m.sum())
    wanted = case.wanted(planted_m / total_m)
    whole = decision.whole
    return [
        case.name, "/".join(sorted(one.value for one in wanted)), decision.outcome.value,
        "right" if decision.outcome in wanted else "open" if decision.outcome is UNDECIDED else "WRONG",
        f"{total_m:.0f}", f"{100 * whole.measured_share:.0f}", f"{planted_m:.1f}", f"{whole.failed_m:.1f}",
        str(decision.why),
    ]


HEAD = ["delivery", "right", "decided", "", "seams m", "measured %", "planted m", "failed m", "why"]


def rows_of(cases: Sequence[Case]) -> Iterator[list[str]]:
    """A row for each delivery whose ground is there."""
    for case in cases:
        imagery = imagery_of(case.ground)
        if imagery is None:
            continue
        block = planted(case, imagery)
        rules = limit_rules(max_share=SHARE, max_run_m=RUN_PX * block.pixel_m)
        with tempfile.TemporaryDirectory(prefix="seam_inspector_") as folder:
            result, delivery = scanned(case, block, Path(folder))
            delivery = replace(delivery, files=file_doubts(delivery, (), ()))
            row = row_of(case, block, result, decide(delivery, rules))
        print(" | ".join(row), flush=True)
        yield row


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.deliveries", description=__doc__.split("\n")[0])
    parser.add_argument("--only", default="", help="deliveries whose name holds this")
    arguments = parser.parse_args()
    gdal.UseExceptions()
    rows = list(rows_of([one for one in CASES if arguments.only in one.name]))
    print_table("Decisions on planted deliveries", HEAD, rows,
                "Planted: metres of seam that truly keep less than 0.7. Open: undecided though that\n"
                "  could have been decided.")
    return int(any("WRONG" in row for row in rows))


if __name__ == "__main__":
    raise SystemExit(main())
