"""Messages about scanned photos: marks and their positions, calibrations, the transformation."""
from __future__ import annotations

from ...imagery.errors import INFO, WARNING, Message

# enhancing
FILTER_SIDE = Message("The side of the mean is {size:g} px; give an odd number from 3 to {most:g}.")
FILTER_DEVIATION = Message(
    "The standard deviation of the Gaussian is {size:g} px; give one above 0 and up to {most:g}.")
# the photo
PHOTO_TOO_LARGE = Message(
    "{name} has {columns} x {rows} px and no scanned photo has more than {most} along a side; choose the scan of one "
    "photo.")
# the calibration of a camera
NO_CALIBRATION = Message("No calibration is given; choose the file with the calibrated marks of the camera.")
CALIBRATION_NOT_READ = Message("The calibration {path} can't be read ({error}); check the path.")
CALIBRATION_UNKNOWN = Message(
    "{name} is neither a CSV with the columns mark, x_mm and y_mm nor a MeasuresCamera.xml of MicMac; choose one of "
    "these.")
CALIBRATION_ROW = Message("Row {row} of {name} has no mark with two numbers; complete or remove it.")
CALIBRATION_TWICE = Message("{name} has the mark '{mark}' twice; give every mark a name of its own.")
CALIBRATION_EMPTY = Message("{name} holds no marks; a calibration has one row with mark, x_mm and y_mm for each.")
CALIBRATION_UNIT = Message(
    "The marks of the calibration are {span:g} mm apart and a photo has {least:g} to {most:g} mm; give millimetres.")
TOO_FEW_CALIBRATED = Message(
    "The calibration has too few marks: {count}, and the {model} model needs {least}; complete it or use "
    "another model.")
MARKS_AT_ONE_PLACE = Message(
    "The marks '{mark}' and '{other}' of the calibration are at the same place; correct their coordinates.")
# the positions that a user gives
POSITIONS_WITHOUT_MARK = Message(
    "The layer of positions has no field 'mark'; add one and write the names of the calibration's marks into it.")
POSITIONS_EMPTY = Message("The layer of positions holds no point with a name in its field 'mark'; digitise some.")
POSITION_TWICE = Message("The layer of positions has the mark '{mark}' twice; remove one of them.")
POSITION_UNKNOWN = Message(
    "The positions name a mark '{mark}' that the calibration does not have ({marks}); rename it.")
POSITION_OUTSIDE = Message(
    "The position of '{mark}' lies outside the photo; digitise it on the photo as QGIS shows it without a world file, "
    "or with the one that the photo has.")
POSITIONS_AT_ONE_PLACE = Message("The positions of '{mark}' and '{other}' are at the same place; move one of them.")
POSITIONS_OFF = Message(
    "The positions lie up to {worst:.0f} mm from where the calibration places them; check their names and the "
    "calibration.")
# a template
TEMPLATE_TOO_SMALL = Message(
    "The template is {width} x {height} px and a side needs at least {fewest} px; cut it out with the whole "
    "mark in it.")
TEMPLATE_TOO_LARGE = Message(
    "The template is {side:.1f} mm wide and the search area {search:.1f} mm; cut it out smaller or search further.")
TEMPLATE_EMPTY = Message("All pixels of the template are alike; cut it out where the mark is.")
# the marks of a photo
PHOTO_EMPTY = Message("All pixels of {name} are alike, so it shows no marks; scan the photo again.")
NO_MARK_FOUND = Message(
    "No mark was found in {name} ({why}); give positions, another kind of template, or a template cut out of "
    "the photo.")
ARRANGEMENT_NOT_AT_POSITIONS = Message(
    "Marks were found in the photo, but not where the positions say; each was looked for on its own there.", WARNING)
SCAN_ORIENTATION_ASSUMED = Message(
    "The photo's orientation in the scanner is unknown, so it is taken as upright and not mirrored; give the positions "
    "of three marks if that is wrong.", WARNING)
MARK_STANDS_OUT = Message(
    "The mark '{mark}' stands out: the others, which agree well, place it {worst:.2f} mm away; look at its picture.",
    WARNING)
NO_MARK_TRUSTED = Message(
    "No mark of {name} can be trusted ({why}); check the positions, their names and the calibration.")
# why a mark failed
SURFACE_FLAT = Message("the surface around the best place is flat, so it has no extremum")
SURFACE_SADDLE = Message("the surface around the best place is a saddle, so it has no extremum")
SURFACE_OUTSIDE = Message("the extremum of the surface lies outside the pixels it was computed from")
MARK_NOT_SEEN = Message("nothing around the position looks like a mark", WARNING)
MARK_NO_ROOM = Message("the template is larger than the part of the photo around the mark", WARNING)
MARK_TOO_WEAK = Message("the best correlation is {value:.2f} and at least {least:.2f} is asked for", WARNING)
MARK_AMBIGUOUS = Message("two places look nearly alike, with correlations of {best:.2f} and {second:.2f}", WARNING)
MARK_WANDERS = Message("the surface's extremum leads away from where the mark was found", WARNING)
MARK_AT_THE_EDGE = Message("the mark lies at the edge of the photo and is cut off", WARNING)
MARK_HALVES_DIFFER = Message(
    "parts of the mark differ by {shift:.1f} px and at most {most:.1f} px is trusted: dirt, a scratch or no "
    "mark", WARNING)
MARK_OUTSIDE = Message("it would lie outside the photo")
MARK_NOT_ARRANGED = Message("no possible marks in the photo are arranged as in the calibration", WARNING)
MARK_UNSUPPORTED = Message(
    "only {count} possible marks are arranged as in the calibration, and without positions {least} are needed", WARNING)
MARK_TWICE = Message("it was found at the same place as '{other}'", WARNING)
MARK_OFF = Message("it lies {worst:.2f} mm from where the other marks place it and {limit:.2f} mm is allowed", WARNING)
GIVEN_OFF = Message(
    "the given place lies {worst:.2f} mm from where the other marks place it and {limit:.2f} mm is allowed; check it "
    "and its name", WARNING)
MARKS_DISAGREE = Message(
    "the marks lie up to {worst:.2f} mm from where the calibration places them, {limit:.2f} mm is allowed, and it is "
    "unknown which is wrong", WARNING)
# the transformation
TOO_FEW_MARKS = Message(
    "Marks measured or given: {count}, and the {model} model needs {least}; measure the others by hand and give them "
    "as positions with their measurement off.")
MARKS_ON_A_LINE = Message(
    "The marks are at the same place or on one line, so the {model} model can't be determined; give further marks.")
NO_REDUNDANCY = Message(
    "The {model} model needs all of the {count} marks, so the residuals are 0 and say nothing about its accuracy; "
    "measure more marks or use a simpler model.", WARNING)
NO_TRANSFORMATION = Message("There is no transformation to write; give the positions of more marks.")
PHOTO_WITHOUT_TRANSFORMATION = Message(
    "{name} has no transformation ({why}); its marks are in the output, but no parameters and no world file were "
    "written.")
# two measurements compared
MEASURES_NOT_READ = Message("The measurement {name} can't be read ({error}); remove it from the folder or correct it.")
MEASURES_ROW = Message("The mark '{mark}' in {name} has no column and row; complete or remove it.")
COMPARED_EITHER = Message("Give each of the two measurements either as a layer or as a folder.")
COMPARED_NO_MARKS = Message(
    "The folder {path} does not exist, or holds neither layers with a field 'mark' nor MicMac's MeasuresIm-*.xml.")
COMPARED_ALONE = Message(
    "Marks in only one of the measurements, which are not compared: {count} ({names}).", WARNING)
COMPARED_WITHOUT_MARK = Message("The layer {layer} has no field 'mark'; choose layers of measured marks.")
COMPARED_TWICE = Message(
    "A measurement has the mark '{mark}' twice{where}; give both layers a field 'photo' that tells photos apart.")
COMPARED_NOWHERE = Message(
    "The mark '{mark}' was measured at column {column:g}, row {row:g}, where no scanned photo has pixels; correct or "
    "remove it.")
NOTHING_IN_COMMON = Message(
    "The two measurements have no mark in common ({first}; {second}); check their fields 'mark' and 'photo'.")
PIXEL_SIZE_UNKNOWN = Message(
    "The pixel size is not known, so the distances are given in pixels only; give the pixel size, or layers with the "
    "fields x_mm and y_mm.", WARNING)
# words for MODELS, STATES, EVIDENCE, SURFACES and KINDS of limits
WORDS = {word.template.lower(): word for word in (
    Message("affine", INFO), Message("similarity", INFO), Message("projective", INFO),
    Message("Measured", INFO), Message("Given", INFO), Message("Failed", INFO),
    Message("positions", INFO), Message("dots", INFO), Message("data strip", INFO), Message("residuals", INFO),
    Message("marks", INFO), Message("assumed", INFO), Message("correlation", INFO), Message("brightness", INFO),
    Message("cross", INFO), Message("dot", INFO), Message("ring with dot", INFO), Message("ring with cross", INFO),
    Message("wedge", INFO),
)}
