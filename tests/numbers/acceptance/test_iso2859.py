"""The tables of ISO 2859-1 and 2859-2, held against published copies of them."""
from __future__ import annotations

import pytest
from seam_inspector.plugin.acceptance.measure.sampling_plans import (
    AQLS,
    INSPECTION_LEVELS,
    LIMITING_QUALITIES,
    code_letter,
    isolated_lot_plan,
    single_sampling_plan,
    word_of,
)
from seam_inspector.plugin.imagery.errors import SettingsError

LETTERS = "ABCDEFGHJKLMNPQR"
LARGEST_LOTS = [8, 15, 25, 50, 90, 150, 280, 500, 1200, 3200, 10_000, 35_000, 150_000, 500_000, 5_000_000]
# MIL-STD-105E, table I, row by row: S-1 to S-4, I to III
CODE_LETTERS = """AAAAAAB AAAAABC AABBBCD ABBCCDE BBCCCEF BBCDDFG BCDEEGH BCDEFHJ CCEFGJK CDEGHKL CDFGJLM CDFHKMN
DEGJLNP DEGJMPQ DEHKNQR""".split()
# MIL-STD-105E, table II-A, arrows followed, as the R package AQLSchemes 1.7-2 (J. Lawson) holds them:
# by AQL up to 10 the sample sizes of the rows A to R
SAMPLE_SIZES = """
1250 800 500 315 200 125 80 50 32 20 13 8 5 3 2 5
1250 800 500 315 200 125 80 50 32 20 13 8 5 3 2 5
1250 800 500 315 200 125 80 50 32 20 13 8 5 3 8 5
1250 800 500 315 200 125 80 50 32 20 13 8 5 13 8 8
1250 800 500 315 200 125 80 50 32 20 13 8 20 13 13 13
1250 800 500 315 200 125 80 50 32 20 13 32 20 20 20 20
1250 800 500 315 200 125 80 50 32 20 50 32 32 32 32 32
1250 800 500 315 200 125 80 50 32 80 50 50 50 50 50 50
1250 800 500 315 200 125 80 50 125 80 80 80 80 80 80 80
1250 800 500 315 200 125 80 200 125 125 125 125 125 125 125 125
1250 800 500 315 200 125 315 200 200 200 200 200 200 200 200 125
1250 800 500 315 200 500 315 315 315 315 315 315 315 315 200 125
1250 800 500 315 800 500 500 500 500 500 500 500 500 315 200 125
1250 800 500 1250 800 800 800 800 800 800 800 800 500 315 200 125
1250 800 2000 1250 1250 1250 1250 1250 1250 1250 1250 800 500 315 200 125
1250 800 2000 2000 2000 2000 2000 2000 2000 2000 1250 800 500 315 200 125"""
# acceptance numbers down some columns of the same table, rows A to R
COLUMNS = {
    "1.0": "0 0 0 0 0 0 1 1 2 3 5 7 10 14 21 21",
    "10": "1 1 1 2 3 5 7 10 14" + 7 * " 21",
    "0.025": 14 * "0 " + "1 1",
}


def lots() -> dict[str, tuple[int, str]]:
    """A lot size and a level for each code letter, by the letter; the lot is larger than any sample where it can be."""
    levels = {}
    for row, largest in zip(CODE_LETTERS, LARGEST_LOTS):
        for level, letter in zip(INSPECTION_LEVELS, row):
            levels[letter] = largest, level
    return levels


def test_code_letters_are_those_of_table_1() -> None:
    smallest = [2] + [largest + 1 for largest in LARGEST_LOTS[:-1]]
    for row, *sizes in zip(CODE_LETTERS, smallest, LARGEST_LOTS):
        for size in sizes:
            assert "".join(code_letter(size, level) for level in INSPECTION_LEVELS) == row


def test_sample_sizes_are_those_of_table_2() -> None:
    rows = [list(map(int, line.split())) for line in SAMPLE_SIZES.strip().splitlines()]
    for letter, sizes in zip(LETTERS, rows):
        lot, level = lots()[letter]
        plans = [single_sampling_plan(lot, aql, level) for aql in AQLS]
        assert code_letter(lot, level) == letter
        assert [plan.sample_size for plan in plans] == [min(size, lot) for size in sizes], letter


@pytest.mark.parametrize("aql", COLUMNS)
def test_acceptance_numbers_are_those_of_table_2(aql: str) -> None:
    plans = [single_sampling_plan(lots()[letter][0], aql, lots()[letter][1]) for letter in LETTERS]
    assert [plan.acceptance_number for plan in plans] == list(map(int, COLUMNS[aql].split()))


def test_a_sample_as_large_as_the_lot_is_the_whole_lot() -> None:
    plan = single_sampling_plan(40, "0.10", "II")
    assert plan.is_whole_lot
    assert code_letter(40, "II") == "D"
    assert (plan.sample_size, plan.acceptance_number, plan.code_letter) == (40, 0, "K")


def test_a_lot_of_one_has_no_plan() -> None:
    with pytest.raises(SettingsError, match="inspect all of it"):
        single_sampling_plan(1, "1.0")


@pytest.mark.parametrize(("given", "word"), [(1, "1.0"), ("1", "1.0"), (0.1, "0.10"), ("0.010", "0.010"), (3, None),
                                             ("x", None), (None, None), (float("nan"), None)])
def test_limits_are_written_as_the_standard_does(given: object, word: str | None) -> None:
    assert word_of(given, AQLS) == word


# ISO 2859-2:1985, table A, as two QGIS plugins for Brazil's ET-CQDG hold it: by the largest lot sample sizes, then
# acceptance numbers, for limiting qualities of 2, 3.15, 5, 8, 12.5, 20 and 31.5 %
ISOLATED = """
25: 50 50 28 17 13 9 6, 0 0 0 0 0 0 0
50: 50 50 28 22 15 10 6, 0 0 0 0 0 0 0
90: 50 44 34 24 16 10 8, 0 0 0 0 0 0 0
150: 80 55 38 26 18 13 13, 0 0 0 0 0 0 1
280: 95 65 42 28 20 20 13, 0 0 0 0 0 1 1
500: 105 80 50 32 32 20 20, 0 0 0 0 1 1 3
1200: 125 125 80 50 32 32 32, 0 1 1 1 1 3 5
3200: 200 125 125 80 50 50 50, 1 1 3 3 3 5 10
10000: 200 200 200 125 80 80 80, 1 3 5 5 5 10 18
35000: 315 315 315 200 125 125 80, 3 5 10 10 10 18 18
150000: 500 500 500 315 200 125 80, 5 10 18 18 18 18 18
500000: 800 800 500 315 200 125 80, 10 18 18 18 18 18 18
9000000: 1250 800 500 315 200 125 80, 18 18 18 18 18 18 18"""


def test_plans_of_isolated_lots_are_those_of_the_table() -> None:
    smallest = 16
    for line in ISOLATED.strip().splitlines():
        largest, *numbers = (list(map(int, part.split())) for part in line.replace(":", ",").split(","))
        for lot in (smallest, largest[0]):
            plans = [isolated_lot_plan(lot, lq) for lq in LIMITING_QUALITIES]
            assert [plan.sample_size for plan in plans] == [min(size, lot) for size in numbers[0]]
            assert [plan.acceptance_number for plan in plans] == numbers[1]
        smallest = largest[0] + 1


def test_smaller_isolated_lots_are_inspected_whole() -> None:
    assert isolated_lot_plan(15, "31.5").is_whole_lot
    with pytest.raises(SettingsError, match="inspect all of it"):
        isolated_lot_plan(1, "5.00")
