"""How much a decision leaves on paper at most."""
from __future__ import annotations

MOST_PICTURES = 100  # of a delivery, of the longest failures: some 12 MB of report
TOLD_UNEXPLAINED = 0.03  # of a mosaic without an orthoimage behind it: where the scan tells it, too
