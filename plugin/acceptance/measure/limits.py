"""Limits and defaults of the decision on a delivery, each with its source."""
from __future__ import annotations

STANDARD_KEPT = 0.7  # of the finest detail's variance: seam_profile.md, where a piece is called significant
STANDARD_FAILED_SHARE = 0.02  # Beeldmateriaal Nederland: 2 % may deviate if it is not contiguous
STANDARD_LONGEST_M = 50.0  # what 'not contiguous' is taken to mean: half a standard window of 100 m (Pyka 2010)
STANDARD_MEASURED_SHARE = 0.9  # of the metres: with less the rest could turn any share of 2 % round five times over
STANDARD_AQL = "1.0"
STANDARD_SEED = 2859  # the same delivery gives the same sample
STANDARD_PIECE_M = 25.0  # as the scan cuts seams
