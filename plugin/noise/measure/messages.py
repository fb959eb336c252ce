"""Messages on random noise: settings, windows and groups, and curves."""
from __future__ import annotations

from ...imagery.errors import INFO, WARNING, Message

NOISE_LEVELS_TOO_FEW = Message("{levels} levels asked for; the noise rule compares levels, so use at least {least}.")
# windows and groups
GROUP_FIELD_WITHOUT_WINDOWS = Message(
    "GROUP_FIELD is a field of the windows; give WINDOWS, or leave GROUP_FIELD empty."
)
GROUP_FIELD_UNKNOWN = Message("The windows have no field {field}; choose one that they have.")
RASTER_WITHOUT_WINDOW = Message(
    "{name} has no valid part of {fewest} x {fewest} px; draw windows, or choose a larger raster.", WARNING
)
WINDOWS_SMALLER = Message("{name} has no valid part of {wanted} x {wanted} px; its windows have {side} px.", WARNING)
MASKED_TOO_MUCH = Message(
    "{share:.1%} of the window is invalid in one raster or another and {most:.0%} are allowed; choose "
    "another place.", INFO
)
GROUPS_APART = Message(
    "The two groups show no common ground, so each raster has windows of its own and nothing is compared "
    "pairwise.", WARNING
)
PIXEL_SIZES_DIFFER = Message(
    "Pixel sizes differ ({first} and {second}), so a level does not mean the same size on the ground in both "
    "groups.", WARNING
)
# a curve
NOISE_CONSTANT = Message("{name} has no variance in {band} here; choose a place with content.", INFO)
NOISE_HUMP = Message(
    "The detail falls only after level 2, not from level 1 to 2: noise coarser than a pixel (grain, resampling, "
    "compression) or a texture of that size; look at the window.", INFO
)
GRAIN_FOUND = Message(
    "The quiet ground has the spectrum of grain, noise coarser than a pixel; the curve alone does not show it.", INFO
)
GRAIN_MAY_HIDE = Message(
    "The curve rises, but noise coarser than a pixel (grain) can hide in this texture; measure smoother ground.", INFO
)
GRAIN_UNKNOWN = Message(
    "The curve rises, but the window is too small to tell noise coarser than a pixel (grain) from texture; take a "
    "larger one.", INFO
)
