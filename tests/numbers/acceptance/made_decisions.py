"""Decisions on sheets side by side whose every figure is known: what stands on paper is held against them."""
from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

import numpy as np
from seam_inspector.plugin.acceptance.measure.acceptance_rules import SamplingRule
from seam_inspector.plugin.acceptance.measure.deciding import decide
from seam_inspector.plugin.acceptance.measure.decision import Decision
from seam_inspector.plugin.acceptance.measure.delivery import DeliveredPiece, Delivery, SeenWindow

from tests.numbers.acceptance.deliveries import rules

UTM = (
    'PROJCS["WGS 84 / UTM zone 33N",GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],'
    'PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433],AUTHORITY["EPSG","4326"]],'
    'PROJECTION["Transverse_Mercator"],PARAMETER["latitude_of_origin",0],PARAMETER["central_meridian",15],'
    'PARAMETER["scale_factor",0.9996],PARAMETER["false_easting",500000],PARAMETER["false_northing",0],UNIT["metre",1],'
    'AUTHORITY["EPSG","32633"]]'
)
LEFT, BOTTOM = 500000.0, 5500000.0
PIECE_M = 25.0
LOST, SOUND, UNKNOWN = 0.45, 0.97, None
IMAGES = "0412_ortho.tif", "0413_ortho.tif"
PLAN = SamplingRule("1.0", "II", "contract")


def seam_of(
    sheet: str, number: int, pieces: int, failed: Collection[int], unknown: Collection[int] = (),
    images: tuple[str, str] = IMAGES,
) -> list[DeliveredPiece]:
    """A seam from south to north in pieces of 25 m, which waves a little; ``number``: of the sheet, 100 m each."""
    made = []
    for place in range(pieces):
        y = BOTTOM + PIECE_M * place + np.linspace(0, PIECE_M, 6)
        kept = LOST if place in failed else UNKNOWN if place in unknown else SOUND
        made.append(DeliveredPiece(
            number * pieces + place, sheet, "1", PIECE_M * place, PIECE_M, kept,
            None if kept is None else kept - 0.05, None if kept is None else kept + 0.06,
            None if kept is None else 2.5 * (kept == LOST), "", "",
            np.column_stack([LEFT + 100 * number + 4 * np.sin(y / 20), y]), *images, "2019-07-04", "2019-08-11",
        ))  # fmt: skip
    return made


def decided(
    sheets: Sequence[str] = ("sheet_1",), pieces: int = 40, failed: Collection[tuple[int, int]] = (),
    sampling: SamplingRule | None = None, windows: Sequence[SeenWindow] = (), images: tuple[str, str] = IMAGES,
) -> Decision:
    """The decision by 2 % and 50 m, or by a plan too; ``failed``: sheet and piece, by their numbers."""
    all_pieces = [
        piece for number, sheet in enumerate(sheets)
        for piece in seam_of(sheet, number, pieces, [place for of, place in failed if of == number], images=images)
    ]  # fmt: skip
    return decide(Delivery(tuple(all_pieces), UTM, tuple(windows)), rules(sampling=sampling))


def window_on(decision: Decision, piece: int, cause: str, *remarks: str) -> SeenWindow:
    """A window of 40 m around the middle of a piece."""
    x, y = decision.delivery.pieces[piece].middle
    return SeenWindow((x - 20, y - 20, x + 20, y + 20), cause, remarks)


def with_windows(decision: Decision, *windows: SeenWindow) -> Decision:
    """The decision on that delivery, looked at."""
    return decide(replace(decision.delivery, windows=windows), decision.rules)
