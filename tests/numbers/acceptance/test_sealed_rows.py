"""A layer of seams is as its scan left it, or the decision says what is not."""
from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
import pytest
from osgeo import osr
from seam_inspector.plugin.acceptance.measure.delivered_rows import ScannedLayer, make_delivery, read_layers
from seam_inspector.plugin.acceptance.measure.delivery import DeliveredLayer, Seal
from seam_inspector.plugin.imagery.errors import SettingsError
from seam_inspector.plugin.imagery.seam_totals import SYSTEM, RowTotals

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
    return read_layers([ScannedLayer("a", held, wkt, notes)])[0].layers[0]


def sealed(**notes: str) -> dict[str, str]:
    return RowTotals(rows()).sealed(notes)


def test_in_any_order() -> None:
    sealing = read(rows()[::-1], sealed())
    assert (sealing.seal, sealing.lacking_m) == (Seal.WHOLE, 0)


@pytest.mark.parametrize("line", [np.empty((0, 2)), np.array([(30.0, 0.0)] * 2), np.array([(30.0, np.nan)] * 2)])
def test_a_piece_that_lost_its_line_is_missed(line: np.ndarray) -> None:
    """Its row still says that it failed, and it lies nowhere."""
    held = rows()
    held[1] = held[1][0], line
    sealing = read(held, sealed())
    assert (sealing.seal, sealing.lacking_m) == (Seal.BROKEN, 25)


def test_rows_of_which_none_is_a_piece_are_refused() -> None:
    """Rows in which somebody wrote another word into the field ``level`` of all of them."""
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
            ("feather_width", 9.0),
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
        Seal.WHOLE, Seal.BROKEN, Seal.BROKEN
    ]


def crs_wkt(code: int) -> str:
    system = osr.SpatialReference()
    system.ImportFromEPSG(code)
    return str(system.ExportToWkt())


@pytest.mark.parametrize(
    ("band", "feather", "width"), [(1.2, 1.3, 1.3), (1.4, 1.3, 1.4), (1.2, None, 1.2), (None, None, None)]
)
def test_a_seam_is_as_wide_as_the_desk_tells(band: float | None, feather: float | None, width: float | None) -> None:
    row = {"kept_1": 0.6, "band_width": band, "feather_width": feather, "geometry": "LINESTRING (0 0, 5 0)"}
    assert make_delivery({"a": [row]}, "").pieces[0].band_width_m == width


@pytest.mark.parametrize(("written", "expected"), [(0.5, 0.5), (7.0, 7.0), (0.0, 5.0), (-3.0, 5.0), (None, 5.0)])
def test_a_length_that_is_none_is_that_of_the_line(written: float | None, expected: float) -> None:
    row = {"kept_1": 0.9, "length": written, "geometry": "LINESTRING (0 0, 5 0)"}
    assert make_delivery({"a": [row]}, "").pieces[0].length_m == expected
