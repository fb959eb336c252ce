"""A layer of seams is as its scan left it, or the decision says what is not."""
from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
import pytest
from osgeo import osr
from seam_inspector.plugin.acceptance.measure.delivered_rows import LayerDoubts, make_delivery, overlap
from seam_inspector.plugin.acceptance.measure.delivery import DeliveredLayer, DeliveredPiece, Seal
from seam_inspector.plugin.imagery.errors import SettingsError
from seam_inspector.plugin.imagery.seam_totals import SYSTEM, sealed_notes

Rows = list[tuple[dict[str, object], np.ndarray]]
STATES = "passed", "failed", "passed"


def rows() -> Rows:
    """A seam along x in three pieces of 25 m, of which the second failed."""
    return [
        ({"seam_id": 1, "station": 25.0 * place, "length": 25.0, "level": "piece", "state": state,
          "kept_1": 0.95 if state == "passed" else 0.4},
         np.array([(25.0 * place, 0.0), (25.0 * place + 25, 0.0)]))
        for place, state in enumerate(STATES)
    ]  # fmt: skip


def read(held: Rows, notes: Mapping[str, str], wkt: str = "") -> DeliveredLayer:
    doubts = LayerDoubts("a")
    for row, line in held:
        doubts.piece("a", row, line, 25.0 * bool(len(line)))
    return doubts.layer(notes, wkt)


def sealed(**notes: str) -> dict[str, str]:
    return sealed_notes(notes, rows())


def test_in_any_order() -> None:
    found = read(rows()[::-1], sealed())
    assert (found.seal, found.lacking_m) == (Seal.WHOLE, 0)


@pytest.mark.parametrize("line", [np.empty((0, 2)), np.array([(30.0, 0.0)] * 2), np.array([(30.0, np.nan)] * 2)])
def test_a_piece_that_lost_its_line_is_missed(line: np.ndarray) -> None:
    """Its row still says that it failed, and it lies nowhere."""
    held = rows()
    held[1] = held[1][0], line
    found = read(held, sealed())
    assert (found.seal, found.lacking_m) == (Seal.BROKEN, 25)
    assert read(held, {}).lacking_m == 25  # of an export too, once


def test_rows_of_which_none_is_a_piece_are_refused() -> None:
    """As where somebody wrote another word into the field ``level`` of all of them."""
    held = [{**row, "level": "stretch", "geometry": "LINESTRING(0 0, 25 0)"} for row, _ in rows()]
    with pytest.raises(SettingsError, match="none of their rows is a piece of seam"):
        make_delivery({"a": held}, "")


def bent(held: Rows) -> None:
    """A vertex between the ends, so that the line leads elsewhere."""
    row, line = held[1]
    held[1] = row, np.insert(line, 1, [40.0, 30.0], axis=0)


@pytest.mark.parametrize(
    "change",
    [
        bent, lambda held: held.append(held[0]), lambda held: held.pop(0),
        *(lambda held, name=name, value=value: held[0][0].update({name: value}) for name, value in (  # type: ignore
            ("length", 50.0), ("kept_1", 0.99), ("kept_high", 0.99), ("visibility", 0.1), ("band_width", 9.0),
            ("seam_id", 7), ("verdict", "preserved"), ("left_date", "2026-01-01"), ("sample", 1), ("sheet", "b"),
        )),
    ],
)  # fmt: skip
def test_the_seal_covers_rows_lines_and_every_field_that_counts(change: Callable[[Rows], None]) -> None:
    held = rows()
    change(held)
    assert read(held, sealed()).seal is Seal.BROKEN


def test_the_seal_covers_what_stands_beside_the_rows() -> None:
    notes = sealed(unexplained="0.4")
    assert read(rows(), notes).seal is Seal.WHOLE
    assert read(rows(), {**notes, "unexplained": "0.0"}).seal is Seal.BROKEN
    assert read(rows(), {name: value for name, value in notes.items() if name != "unexplained"}).seal is Seal.BROKEN
    assert read(rows(), {}).seal is Seal.MISSING


def test_a_layer_in_another_reference_system_is_not_what_the_scan_left() -> None:
    zone, other = (crs_wkt(code) for code in (32633, 32634))
    notes = sealed(**{SYSTEM: zone})
    assert [read(rows(), notes, wkt).seal for wkt in (zone, other, "")] == [
        Seal.WHOLE, Seal.OTHER_SYSTEM, Seal.OTHER_SYSTEM
    ]


def crs_wkt(code: int) -> str:
    system = osr.SpatialReference()
    system.ImportFromEPSG(code)
    return str(system.ExportToWkt())


def piece(number: int, first_m: float, last_m: float, y: float = 0.0, length: object = None) -> DeliveredPiece:
    line = np.array([(first_m, y), ((first_m + last_m) / 2, y), (last_m, y)])
    made = LayerDoubts(f"sheet {number}").piece(f"sheet {number}", {"length": length}, line, last_m - first_m)
    assert made is not None
    return made


@pytest.mark.parametrize(("written", "told"), [(0.5, 0.5), (7.0, 7.0), (0.0, 5.0), (-3.0, 5.0), (None, 5.0)])
def test_a_length_that_is_none_is_that_of_the_line(written: float | None, told: float) -> None:
    assert piece(0, 0.0, 5.0, length=written).length_m == told


@pytest.mark.parametrize("shared_m", [6.0, 8.0])
def test_what_lies_on_another_piece_counts_once(shared_m: float) -> None:
    """Two of 10 m that share some of their line, others beside them, which share none."""
    pieces = [piece(0, 0.0, 10.0), piece(1, 10.0 - shared_m, 20.0 - shared_m), piece(2, 0.0, 10.0, 40.0),
              piece(3, 25.0, 35.0)]  # fmt: skip
    found = overlap(pieces)
    assert found[0] == pytest.approx(shared_m, abs=1.5)
    assert set(found[1]) == {"sheet 0", "sheet 1"}


def test_pieces_that_follow_each_other_share_nothing() -> None:
    assert overlap([piece(number, 10.0 * number, 10.0 * number + 10.0) for number in range(6)]) is None
