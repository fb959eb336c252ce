"""Messages on ground resolution: bar targets, minimum heights and the Bayer filter."""
from __future__ import annotations

from ...imagery.errors import INFO, WARNING, Message

# the layer of lines
NO_BAR_IMAGE = Message("No image of a bar target is chosen; choose one above, then draw a line across its bars.", INFO)
NO_BAR_LINES = Message("The layer has no lines; draw one across the bars of each group.")
BAR_LAYER_NOT_CREATED = Message(
    "No layer of bar groups can be written to {folder}; save the project in a folder that you can write to.")
FIELD_MISSING = Message("The layer has no field '{field}'; add it and fill it in.")
# a line across the bars of a group
BAR_LINE_BENT = Message("Not one straight line; draw it with two points across the bars of the group.", INFO)
BAR_LINE_OUTSIDE = Message("The line leaves {name}; draw it on the image, across the bars of the group.")
BAR_LINE_ON_NODATA = Message("The line crosses pixels of {name} without data; draw it where the image is.")
BAR_LINE_TOO_SHORT = Message(
    "The line is {length:.1f} px long, and {bars} bars with their gaps need {least} px at least; draw it from the "
    "ground on one side of the bars to that on the other.")
BAR_LINE_TOO_LONG = Message(
    "The line is {length:.0f} px long and {most} px are the most; draw it across the bars of one group only.")
GROUP_NOT_GIVEN = Message("The line has no whole number in its field 'group'; fill in the group's number.", INFO)
DIRECTION_UNKNOWN = Message("The line's direction is '{direction}'; fill in 'along' or 'across'.", INFO)
GROUP_TOO_FAR = Message(
    "Group {group} is too far from the reference group {reference} to have a width; correct one of the numbers.", INFO)
GROUP_TWICE = Message(
    "Group {group} {direction} is drawn twice; the first line counts, so delete this one or correct its "
    "number.", INFO)
# why a group is not resolved, or how sure that is
NO_BARS = Message("No bars stand out on the line; draw it across the bars of one group.", INFO)
BARS_MERGED = Message("The bars can't be told apart: {found} of {bars} stand out.", INFO)
TOO_MANY_BARS = Message("{found} bars stand out and a group has {bars}; draw the line across one group only.", INFO)
BARS_TOO_WEAK = Message("The amplitude is {share:.0%} of the full one and the criterion is {criterion:.0%}.", INFO)
BARS_IN_NOISE = Message(
    "The amplitude of {amplitude:.1f} DN does not exceed three times the noise of {noise:.1f} DN.", INFO)
BARS_BEYOND_NYQUIST = Message(
    "A bar and a gap cover {cycle:.2f} px, fewer than two: what is seen there is aliasing and is not "
    "counted.", INFO)
BARS_MAYBE_ALIASED = Message(
    "The bars seem {spacing:.1f} px apart, which can't be told from aliasing in an image without scale; draw lines "
    "across coarser groups too.", INFO)
BARS_MISPLACED = Message(
    "The bars seem {spacing:.1f} px apart, but those of the group are {cycle:.1f} px: what is seen is aliasing or "
    "another group, and is not counted.", INFO)
BARS_SPURIOUS = Message("A coarser group, {group}, is not resolved, so this one is aliasing and is not counted.", INFO)
BARS_SATURATED = Message(
    "The bars are saturated at {value:g} DN, so the full amplitude is larger than measured; use an image with a "
    "shorter exposure.", INFO)
# all groups together
TARGET_SCALE_DIFFERS = Message(
    "The bars are {ratio:.2f} times as far apart as their group numbers and the pixel size say; the measured bars are "
    "used, so check the reference group, its distance and the raster's pixel size.", WARNING)
TARGET_REVERSED = Message(
    "The bars get wider where the group numbers say that they get finer; set REVERSED for this target, or clear "
    "it.", WARNING)
NO_GRD = Message(
    "No group {direction} the flight is resolved in {band}, so there is no ground resolved distance.", WARNING)
TARGET_CONTRAST_LOW = Message(
    "Bars and gaps of the coarsest group differ by a factor of {contrast:.1f} and the method asks for {least:g} at "
    "least, so the distance may be coarser than the sensor's best; haze and a low sun lower the contrast.", WARNING)
NO_PLAIN_PLACE = Message(
    "No plain area of the target shows the full amplitude, so the groups may seem better resolved than they are; "
    "draw lines across coarser groups too.", WARNING)
PLAIN_IS_GROUND = Message(
    "The groups show too little of the target's contrast, so the full amplitude is taken from the ground beside the "
    "bars; draw lines across coarser groups too, or make sure that this ground is as dark as the gaps.", WARNING)
NO_LINE_MEASURED = Message(
    "None of the {count} lines shows bars that can be measured, so there is no ground resolved distance; draw each "
    "across the bars of one group, on the image.")
# the minimum height
REFERENCE_HEIGHT_UNREADABLE = Message(
    "'{word}' is not a reference height; give metres, or a name and metres for each group, as 'DMC 2714; RC20 2015'.")
REFERENCE_OF_NO_GROUP = Message(
    "There is a reference height for {name}, but no group of passes has that name; give one of: {known}.")
REFERENCE_HEIGHT_IMPOSSIBLE = Message(
    "The reference height is {height:g} m; give a positive number of metres up to {highest:g}, or leave it empty.")
NO_OBSERVATIONS = Message("No row has a height and a distance to compute with; fill in 'height' and 'grd'.")
OBSERVATIONS_LEFT_OUT = Message("Row {row} is left out: {why}", WARNING)
OBSERVATION_NO_NUMBER = Message("'height' or 'grd' holds no number; fill in both.", INFO)
OBSERVATION_IMPOSSIBLE = Message(
    "Height {height:g} m and distance {grd:g} cm give no minimum height; give positive numbers, metres up to "
    "{highest:g} and centimetres from {least:g} to {most:g}.", INFO)
COLUMNS_INTERCHANGED = Message(
    "A distance of {grd:g} cm from a height of {height:g} m is coarser than that of any camera; 'height' is in metres "
    "and 'grd' in centimetres, so check whether both are interchanged.", WARNING)
GRD_IN_METRES = Message(
    "A distance of {grd:g} cm from a height of {height:g} m is finer than that of any camera on an aircraft; 'grd' is "
    "in centimetres, so check whether it holds metres.", WARNING)
FEW_OBSERVATIONS = Message("{count} passes over the target; the Open Skies treaty asks for {least} at least.", WARNING)
# the Bayer filter
OPENCV_MISSING = Message(
    "The interpolation edge_aware needs OpenCV (python3-opencv on Debian and Ubuntu, 'python -m pip install "
    "opencv-python-headless' elsewhere); install it, or choose malvar or bilinear.")
EDGE_AWARE_WANTS_INTEGERS = Message(
    "The interpolation edge_aware works on images of 8 or 16 bit and this one holds {kind}; choose malvar or bilinear.")
BANDS_NOT_COLOURS = Message(
    "{name} has {count} bands and no red, green and blue; choose a colour image, or one of a single band.")
