"""What `make soak` makes of its counts."""
from __future__ import annotations

from typing import Any

import pytest

from tests.desktop.soak import ALLOWED, ALLOWED_AT_ALL, COLUMNS, SLOWER, grown, table

FIRST: dict[str, Any] = dict.fromkeys((*ALLOWED_AT_ALL, *COLUMNS), 10) | {"windows": 500}


def test_what_stays_within_its_allowance_is_no_finding() -> None:
    more = {name: FIRST[name] + allowed + 4500 * ALLOWED.get(name, 0) for name, allowed in ALLOWED_AT_ALL.items()}
    assert grown([FIRST, FIRST | more | {"windows": 5000, "key_work_ms": SLOWER * 10}]) == []


@pytest.mark.parametrize("name", [*ALLOWED_AT_ALL, "inspect_work_ms", "key_work_ms"])
def test_each_count_that_grows_is_told(name: str) -> None:
    (found,) = grown([FIRST, FIRST | {name: 10_000_000}])
    assert found.startswith(name)


def test_the_table_has_a_row_for_each_round() -> None:
    lines = table([FIRST, FIRST | {"rss_mb": 1234.56}]).splitlines()
    assert len(lines) == 3
    assert len({len(line) for line in lines}) == 1
    assert "1234.6" in lines[2]
