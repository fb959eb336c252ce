"""How much a decision leaves on paper at most."""
from __future__ import annotations

MOST_PICTURES = 100  # of a delivery, of the longest failures: some 12 MB of report
