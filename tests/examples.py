"""How many examples a property test looks at: as many as the run's profile says, see conftest.py, or fewer."""
from __future__ import annotations

from hypothesis import settings


def at_most(count: int) -> settings:
    """Settings for a property that is slow to look at."""
    return settings(max_examples=min(count, settings().max_examples))


def times(factor: int) -> settings:
    """Settings for a property that is quick to look at and rarely broken."""
    return settings(max_examples=factor * settings().max_examples)
