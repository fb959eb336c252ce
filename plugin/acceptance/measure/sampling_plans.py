"""Single sampling by attributes: the tables of ISO 2859-1 (series of lots, by AQL) and ISO 2859-2 (isolated lots).

Table 1 (code letters) and tables 2-A and 2-B (normal and tightened inspection) of ISO 2859-1:1999, which are I, II-A
and II-B of ISO 2859-1:1989 and MIL-STD-105E. Reduced inspection is table II-C of these two, which later editions have
with other numbers. In a master table a plan depends on the sum of its row and its column alone, the first rows of two
tables apart; so each table is one row of numbers here, by that sum, and arrows are where it has none.

Table A of ISO 2859-2:1985 (procedure A: producer and consumer both regard the lot as isolated) is indexed by the
limiting quality; its columns below 2 % are left out: no published copy was found to hold them against.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ...imagery.errors import SettingsError
from . import messages


@dataclass(frozen=True)
class SamplingPlan:
    """How many items of a lot are inspected, and how many of these may be nonconforming."""

    lot_size: int
    """Items: pieces of seam."""
    sample_size: int
    acceptance_number: int
    """Ac: the lot is accepted up to so many nonconforming items in the sample."""
    rejection_number: int
    """Re: it is rejected from so many on."""
    aql: float | None
    """Acceptance quality limit: nonconforming items per hundred; None for one of an isolated lot."""
    inspection_level: str
    severity: str
    code_letter: str
    """Letter of the table's row that the plan was taken from, arrows followed; empty where there are no letters."""
    lq: float | None = None
    """Limiting quality of an isolated lot: nonconforming items per hundred with which it is hardly ever accepted."""

    @property
    def standard(self) -> str:
        """With the edition whose numbers it has."""
        if self.lq is not None:
            return "ISO 2859-2:1985"
        return "ISO 2859-1:1989" if self.severity == REDUCED else "ISO 2859-1:1999"

    @property
    def is_whole_lot(self) -> bool:
        """Whether every item is inspected, since the sample would be as large as the lot."""
        return self.sample_size >= self.lot_size


@dataclass(frozen=True)
class OperatingCharacteristic:
    """How likely a lot is accepted by how good it is."""

    nonconforming_shares: tuple[float, ...]
    """Fractions of 1, rising."""
    accepted: tuple[float, ...]
    """The probability of acceptance at each."""
    good_quality: float
    """The share of nonconforming items that the AQL allows; of an isolated lot the largest one that is rejected with
    5 % at most, or that of one item."""
    producers_risk: float
    """Probability that a lot as good as that is rejected."""
    limiting_quality: float
    """The smallest share of nonconforming items at which a lot is accepted with 10 % at most (LQ, LTPD); of an isolated
    lot that of its plan, in whole items."""
    consumers_risk: float
    """With which it is then: 10 %, or what whole items of a lot leave below; up to 13 % for an isolated lot."""


NORMAL, TIGHTENED, REDUCED = "normal", "tightened", "reduced"
SEVERITIES = (NORMAL, TIGHTENED, REDUCED)
INSPECTION_LEVELS = ("S-1", "S-2", "S-3", "S-4", "I", "II", "III")
DEFAULT_LEVEL = "II"
AQLS = tuple(
    "0.010 0.015 0.025 0.040 0.065 0.10 0.15 0.25 0.40 0.65 1.0 1.5 2.5 4.0 6.5 10 15 25 40 65 100 150 250 400 650 "
    "1000".split()
)
"""AQLs as the standard writes them: nonconforming items per cent up to 10, above it nonconformities per 100 items."""
SHARE_AQLS = AQLS[: AQLS.index("10") + 1]
"""Those for items that conform or don't."""
MIN_LOT = 2

_LETTERS = "ABCDEFGHJKLMNPQRS"  # of the rows; S in tightened inspection alone
_LARGEST_LOTS = (8, 15, 25, 50, 90, 150, 280, 500, 1200, 3200, 10_000, 35_000, 150_000, 500_000)
_LETTERS_OF_LEVEL = {  # table 1, by the lot sizes
    "S-1": "AAAABBBBCCCCDDD",
    "S-2": "AAABBBCCCDDDEEE",
    "S-3": "AABBCCDDEEFFGGH",
    "S-4": "AABCCDEEFGGHJJK",
    "I": "AABCCDEFGHJKLMN",
    "II": "ABCDEFGHJKLMNPQ",
    "III": "BCDEFGHJKLMNPQR",
}
_SIZES = (2, 3, 5, 8, 13, 20, 32, 50, 80, 125, 200, 315, 500, 800, 1250, 2000, 3150)
_REDUCED_SIZES = (2, 2, 2, 3, 5, 8, 13, 20, 32, 50, 80, 125, 200, 315, 500, 800)
_SMALL_ROWS, _FIRST_OF_SMALL = 5, 25  # from that sum of row and column on the first rows alone have plans
_ARROW_UP = 15  # the sum at which an arrow with plans on both sides points up; the others point down

_Numbers = dict[int, tuple[int, int]]  # Ac and Re by the sum of row and column


def _numbers(start: int, acceptance: Sequence[int], rejection: Sequence[int] = ()) -> _Numbers:
    """``rejection``: where it is not one more than the acceptance number."""
    pairs = zip(acceptance, rejection or [number + 1 for number in acceptance])
    return {start + place: pair for place, pair in enumerate(pairs)}


_NORMAL = {14: (0, 1), **_numbers(17, (1, 2, 3, 5, 7, 10, 14, 21, 30, 44))}
_TIGHTENED = {15: (0, 1), **_numbers(18, (1, 2, 3, 5, 8, 12, 18, 27, 41))}
_TIGHTENED_A = {total: pair for total, pair in _TIGHTENED.items() if total != 15}
_REDUCED = {
    14: (0, 1),
    **_numbers(17, (0, 1, 1, 2, 3, 5, 7, 10, 14, 21), (2, 3, 4, 5, 6, 8, 10, 13, 17, 24)),
}
_REDUCED_B = {
    14: (0, 1),
    **_numbers(17, (0, 1, 2, 3, 5, 7, 10, 14, 21, 30), (2, 3, 4, 5, 6, 8, 11, 15, 22, 31)),
}
_TABLES: dict[str, tuple[tuple[int, ...], _Numbers, dict[int, _Numbers]]] = {
    NORMAL: (_SIZES[:-1], _NORMAL, {}),
    TIGHTENED: (_SIZES, _TIGHTENED, {0: _TIGHTENED_A}),
    REDUCED: (_REDUCED_SIZES, _REDUCED, {0: _NORMAL, 1: _REDUCED_B}),
}
"""Sample sizes by row, numbers, and those of the rows that have others."""


def code_letter(lot_size: int, inspection_level: str) -> str:
    """Code letter of a lot by table 1."""
    place = sum(lot_size > largest for largest in _LARGEST_LOTS)
    return _LETTERS_OF_LEVEL[inspection_level][place]


def single_sampling_plan(
    lot_size: int, aql: str, inspection_level: str = DEFAULT_LEVEL, severity: str = NORMAL
) -> SamplingPlan:
    """The plan of the tables, its arrows followed.

    A sample as large as the lot or larger is the lot itself: all of it is inspected, against the same numbers. Raises
    SettingsError for a lot of fewer than two items.
    """
    if lot_size < MIN_LOT:
        raise SettingsError(messages.LOT_TOO_SMALL(size=lot_size))
    letter, column = code_letter(lot_size, inspection_level), AQLS.index(aql)
    row = _row_of_plan(_LETTERS.index(letter), column, severity)
    acceptance, rejection = _numbers_of(row, severity)[row + column]
    return SamplingPlan(
        lot_size, min(_TABLES[severity][0][row], lot_size), acceptance, rejection, float(aql), inspection_level,
        severity, _LETTERS[row],
    )


_SMALLEST_ISOLATED = 16  # items: the table begins there, and smaller lots are inspected whole
_LARGEST_ISOLATED = (25, 50, 90, 150, 280, 500, 1200, 3200, 10_000, 35_000, 150_000, 500_000)
_ISOLATED = {  # table A: sample sizes and acceptance numbers by the lot sizes
    "2.00": "50/0 50/0 50/0 80/0 95/0 105/0 125/0 200/1 200/1 315/3 500/5 800/10 1250/18",
    "3.15": "50/0 50/0 44/0 55/0 65/0 80/0 125/1 125/1 200/3 315/5 500/10 800/18 800/18",
    "5.00": "28/0 28/0 34/0 38/0 42/0 50/0 80/1 125/3 200/5 315/10 500/18 500/18 500/18",
    "8.00": "17/0 22/0 24/0 26/0 28/0 32/0 50/1 80/3 125/5 200/10 315/18 315/18 315/18",
    "12.5": "13/0 15/0 16/0 18/0 20/0 32/1 32/1 50/3 80/5 125/10 200/18 200/18 200/18",
    "20.0": "9/0 10/0 10/0 13/0 20/1 20/1 32/3 50/5 80/10 125/18 125/18 125/18 125/18",
    "31.5": "6/0 6/0 8/0 13/1 13/1 20/3 32/5 50/10 80/18 80/18 80/18 80/18 80/18",
}
LIMITING_QUALITIES = tuple(_ISOLATED)
"""Limiting qualities as the standard writes them: nonconforming items per cent."""
DEFAULT_LQ = "5.00"


def isolated_lot_plan(lot_size: int, lq: str) -> SamplingPlan:
    """The plan of ISO 2859-2:1985, procedure A. A sample as large as the lot or larger is the lot itself.

    Raises SettingsError for a lot of fewer than two items.
    """
    if lot_size < MIN_LOT:
        raise SettingsError(messages.LOT_TOO_SMALL(size=lot_size))
    place = sum(lot_size > largest for largest in _LARGEST_ISOLATED)
    size, acceptance = map(int, _ISOLATED[lq].split()[place].split("/"))
    sample = lot_size if lot_size < _SMALLEST_ISOLATED else min(size, lot_size)
    return SamplingPlan(lot_size, sample, acceptance, acceptance + 1, None, "", "", "", float(lq))


def word_of(value: object, words: Sequence[str]) -> str | None:
    """A quality as the standard writes it, from a number or another way to write it; None where it has none."""
    try:
        number = float(str(value))
    except ValueError:
        return None
    return next((word for word in words if float(word) == number), None)


def _plan(row: int, column: int, severity: str) -> tuple[int, int] | None:
    """Ac and Re; None where there is an arrow."""
    total = row + column
    return None if row >= _SMALL_ROWS and total >= _FIRST_OF_SMALL else _numbers_of(row, severity).get(total)


def _numbers_of(row: int, severity: str) -> _Numbers:
    _, numbers, others = _TABLES[severity]
    return others.get(row, numbers)


def _row_of_plan(row: int, column: int, severity: str) -> int:
    """The row that arrows lead to."""
    rows = [other for other in range(len(_TABLES[severity][0])) if _plan(other, column, severity)]
    above, below = [other for other in rows if other < row], [other for other in rows if other > row]
    if row in rows:
        return row
    if not below or (above and row + column == _ARROW_UP):
        return above[-1]
    return below[0]
