"""Single sampling by attributes: the tables of ISO 2859-1 (series of lots, by AQL) and ISO 2859-2 (isolated lots).

Table 1 (code letters) and table 2-A (normal inspection) of ISO 2859-1:1999, which are I and II-A of ISO 2859-1:1989 and
MIL-STD-105E. In the master table a plan depends on the sum of its row and its column alone; so it is one row of numbers
here, by that sum, and arrows are where it has none.

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

    lot_size: int  # items: pieces of seam
    sample_size: int
    acceptance_number: int  # Ac: with so many nonconforming items in the sample the lot is still accepted
    aql: float | None  # acceptance quality limit: nonconforming items per hundred; None for one of an isolated lot
    inspection_level: str
    code_letter: str  # of the table's row that the plan was taken from, arrows followed; empty where there are none
    lq: float | None = None
    """Limiting quality of an isolated lot: nonconforming items per hundred with which it is hardly ever accepted."""

    @property
    def standard(self) -> str:
        """With the edition whose numbers it has."""
        return "ISO 2859-1:1999" if self.lq is None else "ISO 2859-2:1985"

    @property
    def is_whole_lot(self) -> bool:
        """Whether every item is inspected, since the sample would be as large as the lot."""
        return self.sample_size >= self.lot_size


INSPECTION_LEVELS = ("S-1", "S-2", "S-3", "S-4", "I", "II", "III")
DEFAULT_LEVEL = "II"
AQLS = tuple("0.010 0.015 0.025 0.040 0.065 0.10 0.15 0.25 0.40 0.65 1.0 1.5 2.5 4.0 6.5 10".split())
"""AQLs of items that conform or don't, as the standard writes them: nonconforming items per cent."""
MIN_LOT = 2

_LETTERS = "ABCDEFGHJKLMNPQR"  # of the rows
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
_SIZES = (2, 3, 5, 8, 13, 20, 32, 50, 80, 125, 200, 315, 500, 800, 1250, 2000)
_ARROW_UP = 15  # the sum at which an arrow with plans on both sides points up; the others point down

_ACCEPTANCE = {14: 0, 17: 1, 18: 2, 19: 3, 20: 5, 21: 7, 22: 10, 23: 14, 24: 21}  # by the sum of row and column


def code_letter(lot_size: int, inspection_level: str) -> str:
    place = sum(lot_size > largest for largest in _LARGEST_LOTS)
    return _LETTERS_OF_LEVEL[inspection_level][place]


def single_sampling_plan(lot_size: int, aql: str, inspection_level: str = DEFAULT_LEVEL) -> SamplingPlan:
    """The plan of the table, its arrows followed.

    A sample as large as the lot or larger is the lot itself: all of it is inspected, against the same number. Raises
    SettingsError for a lot of fewer than two items.
    """
    if lot_size < MIN_LOT:
        raise SettingsError(messages.LOT_TOO_SMALL(size=lot_size))
    column = AQLS.index(aql)
    row = _row_of_plan(_LETTERS.index(code_letter(lot_size, inspection_level)), column)
    return SamplingPlan(
        lot_size, min(_SIZES[row], lot_size), _ACCEPTANCE[row + column], float(aql), inspection_level, _LETTERS[row]
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
LIMITING_QUALITIES = tuple(_ISOLATED)  # limiting qualities as the standard writes them: nonconforming items per cent
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
    return SamplingPlan(lot_size, sample, acceptance, None, "", "", float(lq))


def word_of(value: object, words: Sequence[str]) -> str | None:
    """A quality as the standard writes it, from a number or another way to write it; None where it has none."""
    try:
        number = float(str(value))
    except ValueError:
        return None
    return next((word for word in words if float(word) == number), None)


def _row_of_plan(row: int, column: int) -> int:
    """The row that arrows lead to."""
    rows = [total - column for total in _ACCEPTANCE if 0 <= total - column < len(_SIZES)]
    above, below = [other for other in rows if other < row], [other for other in rows if other > row]
    if row in rows:
        return row
    if not below or (above and row + column == _ARROW_UP):
        return above[-1]
    return below[0]
