"""What is said of a scan under way."""
from __future__ import annotations

from ..toolkit.translation import filled, tr

_MINUTE_S, _HOUR_S = 60, 3600


def time_left(seconds: float) -> str:
    """As precise as it can be told."""
    if seconds < _MINUTE_S:
        return tr("less than a minute left")
    if seconds < 1.5 * _HOUR_S:
        return filled(tr("some {count} min left"), count=round(seconds / _MINUTE_S))
    return filled(tr("some {count} h left"), count=round(seconds / _HOUR_S))
