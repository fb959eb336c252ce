"""Enhancement of photos."""
from __future__ import annotations

from .message import Message

FILTER_SIDE = Message("The side of the mean is {size:g} px; give an odd number from 3 to {most:g}.")
FILTER_DEVIATION = Message(
    "The standard deviation of the Gaussian is {size:g} px; give one above 0 and up to {most:g}."
)
RASTER_NOT_WRITTEN = Message("{path} can't be written; choose another folder, or make room on the disk.")
