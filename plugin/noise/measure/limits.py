"""Limits and defaults that several files here share, each with its source."""
from __future__ import annotations

# Random noise
NOISE_WINDOW_PX = 1024  # side of a window; Pyka 2009, section 3
NOISE_SHRINK = 8  # every 8th pixel shows where an image is saturated or invalid
