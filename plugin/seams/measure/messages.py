"""What a user can be told of seams: of windows, scans of whole mosaics, forecasts, thresholds and reports."""
from __future__ import annotations

from ...imagery.errors import INFO, WARNING, Message

# settings
LIMIT_OUT_OF_RANGE = Message("{name} is {limit}; give a number between 0 and 1.")
CHOICE_UNKNOWN = Message("{name} can't be '{value}'; choose one of {known}.")
# the mosaic, its sources and its seamlines
NO_MOSAIC = Message("No mosaic is chosen; choose the mosaic in the inputs.")
MOSAIC_OPENING = Message("The mosaic is still being opened; try again in a moment.", WARNING)
MOSAIC_NOT_OPENED = Message(
    "The mosaic was not opened, as the task was cancelled; choose another mosaic in the inputs, then this one again."
)
NO_SOURCES_GIVEN = Message(
    "No sources are given; choose the orthoimages the mosaic was made from, or an index of them."
)
INDEX_WITHOUT_LOCATION = Message("The index layer has no field '{field}'; make it with gdaltindex.")
MOSAIC_AMONG_SOURCES = Message("{name} is the mosaic itself and is left out of the sources.", WARNING)
CELLS_WITHOUT_SOURCE = Message(
    "The layer of seam cells has no field 'source'; add one with the file names of the orthoimages."
)
NEIGHBOUR_OF_OTHER_GRID = Message(
    "{name} does not lie on the pixel grid of {sheet}, or has other bands; give sheets of one mosaic as neighbours."
)
NO_SEAMLINES = Message("No seamlines are chosen; choose a layer of seamlines in the inputs.")
# windows along the seams
SPACING_NOT_POSITIVE = Message("The spacing is {spacing} m; give a positive number of metres.")
SIDE_TOO_SHORT = Message(
    "A window of {side} m has {pixels} px a side on this mosaic and {levels} levels need at least {fewest} px; give a "
    "side of {metres} m or more."
)
MOSAIC_TOO_SMALL = Message(
    "The mosaic is {width:.1f} x {height:.1f} m, too small for a window of {side:.1f} m; give a shorter side."
)
PLACES_WITHOUT_WINDOW = Message(
    "Places along the seams without a window, which would stick out of the mosaic or hold too few valid pixels: "
    "{count}, on seam {places}.", WARNING
)
WINDOWS_CROWDED = Message(
    "Left out because they would share more than half of their pixels with another window of the same seam: "
    "{count}.", WARNING
)
SEAMS_LEFT_OUT = Message(
    "Seams without a window, as they lie within windows of longer ones or outside the mosaic, or are shorter than "
    "{shortest:.2f} m: {count}.", WARNING
)
WINDOWS_PLACED = Message("Windows placed along the seams: {count}; places taken before: {there}.", INFO)
NO_RECTANGLE = Message(
    "Window {number} is not a rectangle; give (xmin, ymin, xmax, ymax), a geometry of shapely, or a row with a "
    "geometry or with xmin, ymin, xmax and ymax."
)
NO_WINDOW_PLACED = Message("No window could be placed along the seams; the log messages say why.", WARNING)
# the window layer
WINDOW_LAYER_NOT_CREATED = Message(
    "No window layer can be written to {folder}; save the project in a folder that you can write to."
)
WINDOWS_NOT_WRITTEN = Message(
    "{path} can't be written ({error}); make sure that the disk has room and no other program has the file open."
)
# why a window is not comparable
NO_SOURCES = Message("No source covers the window; add the orthoimages that overlap it or choose another place.", INFO)
NO_SOURCE_COMPARABLE = Message("No source can be compared here: {why}", INFO)
MOSAIC_CONSTANT = Message("The mosaic has no variance in the window; choose a place with content.", INFO)
SOURCE_CONSTANT = Message("{name} has no variance in the window; choose a place with content.")
SOURCES_WITHOUT_DETAIL = Message("No source has detail at level 1 in the window; choose a place with some.", INFO)
BANDS_DIFFER = Message("{name} has no {band} (its bands: {bands}); choose sources with the mosaic's bands.")
COMPOSITE_UNCLEAR = Message(
    "No source explains the mosaic's fine detail here; add the orthoimages that it was made from.", INFO
)
NO_SEAM = Message(
    "No change from one source to another is found in the window; the verdict is based on sharpness alone.", INFO
)
MIXED_ALL_OVER = Message(
    "Two images are mixed on {share:.0f} % of the window: there is no seam, and no unmixed ground to compare with.",
    INFO
)
TOO_LITTLE_GROUND = Message(
    "There is too little ground beside the seam to compare it with; take a larger window, or move it.", INFO
)
SEAM_UNEXPLAINED = Message(
    "{share:.0f} % of the window matches none of the given sources: check their dates, and add the missing one.", INFO
)
VERDICT_OF_THE_REST = Message(
    "{share:.0f} % of the window matches none of the given sources and is left out; the verdict is that of the rest. "
    "Check their dates and add the orthoimage that is missing, unless the mosaic was altered there.", WARNING
)
MORE_ALONG_THE_SEAM = Message(
    "Along the seam the mosaic has {low:.0f} to {high:.0f} % of its sources' detail: add those that it was made from.",
    INFO
)
SAME_ALONG_THE_SEAM = Message(
    "Both orthoimages show the very same pixels along the seam, and not farther off: they were changed there, or are "
    "parts of a single image. Ask for the orthoimages as they were before the mosaic was made."
)
MAY_BE_SIGNIFICANT = Message(
    "It is unclear whether the loss is significant, as {low:.0f} to {high:.0f} % may be left; measure more of the "
    "seam, or judge it by eye.", INFO
)
INTERVAL_TOO_WIDE = Message(
    "What is kept along the seam lies somewhere between {low:.0f} and {high:.0f} %; measure more of the seam.", INFO
)
SOURCE_IN_PART = Message("{name} covers {share:.0f} % of the window and is used there.", INFO)
SOURCE_RESAMPLED = Message(
    "{name} has a different pixel size from the mosaic's and was resampled; it is shown but not used, as others have "
    "the mosaic's pixel size.", INFO
)
NO_CELLS = Message(
    "{path} holds no polygon on the mosaic that names its source; choose the layer of seam cells, with their sources' "
    "file names in a field."
)
CELLS_OF_OTHERS = Message(
    "No seam cell names a source that is given, so the cells say nothing; the first one names '{name}'.", WARNING
)
ALL_RESAMPLED = Message(
    "All sources have another pixel size or system than the mosaic and were resampled, which changes detail; so the "
    "verdict is uncertain.", WARNING
)
WINDOW_FAILED = Message("The window could not be measured ({error}); please report this.")
# why no loss is foretold
ONE_SOURCE = Message("Only one source covers the window, so nothing will be feathered there.", INFO)
ONE_SOURCE_COMPARABLE = Message("Only one source can be compared here: {why}", INFO)
# the feather whose loss is foretold
SEAM_ASSUMED = Message(
    "Where no seamline divides a window in two, the seam is assumed to run through its middle.", INFO
)
# tables of inspected windows
WINDOWS_WITHOUT_FIELD = Message(
    "The window layer has no field '{field}'; choose a layer of inspected windows, as 'Inspect windows' leaves it."
)
TABLE_WITHOUT_FIELD = Message(
    "The table {table} has no field '{field}'; choose the one that 'Inspect windows' left with these windows."
)
FIELD_NOT_HELD = Message(
    "The layer {name} has no field '{field}', which can't be added now: save its edits, then try again."
)
# the threshold that an observer's verdicts support
VERDICTS_UNKNOWN = Message(
    "Left out because the observer's word is neither 'visible' nor 'invisible': {count} windows.", WARNING
)
OPERATORS_AGREE = Message(
    "Both operators judged {count} windows and agreed on {agreed}. Cohen's kappa {kappa:.2f}, 95 % interval {low:.2f} "
    "to {high:.2f}: 1 where they always agree, 0 where they do as often as by chance.", INFO
)
VALUES_IMPOSSIBLE = Message("{field} of {count} windows is not a possible measurement; it is left out.", WARNING)
VERDICTS_WITHOUT_VALUE = Message(
    "{measure}: left out because nothing was measured there: {count} judged windows.", WARNING
)
TOO_FEW_VERDICTS = Message(
    "{measure}: {visible} visible and {invisible} invisible verdicts; a threshold needs at least {fewest} of either, "
    "so judge more windows.", WARNING
)
NO_BETTER_THAN_CHANCE = Message(
    "{measure} does not reliably separate visible losses from others: the area under its curve lies between {low:.2f} "
    "and {high:.2f}, and 0.5 is a guess. Judge more windows before you rely on a threshold.", WARNING
)
VERDICTS_FULLY_APART = Message(
    "{measure} separates every visible loss from the other windows, so resampling shows no error; the interval "
    "is the score interval.", WARNING
)
VERDICTS_IN_ONE_PLACE = Message(
    "{measure}: all verdicts of one kind lie in one neighbourhood, so each window counts as independent and the "
    "intervals are too narrow; judge windows elsewhere too.", WARNING
)
VERDICTS_WITHOUT_OUTLINE = Message(
    "Judged windows without an outline: {count}. Each counts as if no other lay near it, so the intervals may be too "
    "narrow; use the window layer itself.", WARNING
)
NO_THRESHOLD = Message(
    "{measure}: no threshold is better than a guess; look at the verdicts again, or use another measure.", WARNING
)
THRESHOLD_TOO_HIGH = Message(
    "{measure}: the verdicts support a threshold of {threshold:.3f}, but it has to be below {most:g} to be set.",
    WARNING
)
# the report
NO_REPORT_FILE = Message("No file is given for the report; choose where it is to be written.")
CLIP_NOT_SHOWN = Message("Window {window}: {why}", WARNING)
DETAILS_LIMITED = Message(
    "{count} windows are flagged and the report shows curves and clips of the {most} with the greatest losses; the "
    "others are in the table. Report a part of the windows to see them.", WARNING
)

# settings of a scan
SCAN_LENGTHS = Message("{name} is {value:g}; give {least} or more.")
LOSS_NOT_TIFF = Message("The picture of losses is a GeoTIFF; give {path} the ending .tif.")
SEAMS_WITHOUT_SEAL = Message(
    "The format of SEAMS can't hold the seal of the scan, without which no delivery is accepted; write SEAMS as "
    "GeoPackage.", WARNING
)
CORRIDOR_WITHOUT_SEAMS = Message(
    "The corridor applies only with seamlines; without them all of the mosaic is read.", WARNING
)
PIECES_LENGTHENED = Message(
    "Pieces of seam are made {needed:.1f} m long: at this pixel size shorter ones can't be measured.", WARNING
)
# the mosaic and its orthoimages
NEITHER_SOURCES_NOR_SEAMS = Message(
    "Neither orthoimages nor seamlines are given; add the orthoimages, or the seamlines to scan the mosaic alone."
)
SCAN_MOSAIC_TOO_SMALL = Message(
    "The mosaic has {width} x {height} pixels and a scan needs {fewest} at least; inspect it in windows instead."
)
NO_SOURCE_ON_MOSAIC = Message(
    "No orthoimage lies on the mosaic, of {count}; check the reference systems, or give those that it was made from."
)
NO_SOURCE_USABLE = Message(
    "None of the orthoimages can be used, for the reasons told before; fix that, or leave them all out to scan the "
    "mosaic along its seamlines alone."
)
MOSAIC_NOT_READ = Message("Nothing of the mosaic {name} could be read, so nothing was measured: {why}")
SOURCES_NOT_READ = Message(
    "No orthoimage could be read, so nothing was measured; fix that, or leave them all out to scan the mosaic along "
    "its seamlines alone: {why}"
)
# seams as producers deliver them
SEAMS_CUT_OFF = Message(
    "{outside:.0f} m of the {given:.0f} m of seamlines lie outside the mosaic, along the border of its pixels or "
    "within one orthoimage, where there is no seam, and are left out.", WARNING
)
SEAMS_WITHIN_ONE = Message(
    "Along {metres:.0f} m of the seamlines, which name no orthoimage, the mosaic shows the same one on both sides: "
    "there is no seam, so they are left out.", WARNING
)
SEAMS_PART_NOTHING = Message(
    "No seamline separates two orthoimages on the mosaic: all run along the border of its pixels or within one "
    "orthoimage. Check the reference systems, the field that names the orthoimages, and that these are not cut from "
    "the mosaic."
)
SEAM_FILE_NOT_READ = Message(
    "No seamlines can be read from {path}; check that it is a vector file, and the name of its layer."
)
SEAM_FIELD_MISSING = Message("The seamline layer has no field '{field}'; choose one of its fields: {known}.")
SEAMS_WITHOUT_SYSTEM = Message("{path} names no reference system, so it is taken in the mosaic's.", WARNING)
SEAMS_ELSEWHERE = Message(
    "None of the {count} features of the seamline layer lies on the mosaic; check the reference systems of both."
)
SEAMS_UNNAMED = Message(
    "The seamline layer names no orthoimages beside its seams, in a field 'source' for instance; where orthoimages are "
    "given, the pixels decide which of them the mosaic shows.", INFO
)
SEAMS_NAMED_BY = Message("The orthoimages beside the seams are those that the seamline layer names in {fields}.", INFO)
SEAMS_NAMED_BY_DATE = Message(
    "The seamline layer names no orthoimages; the sides of its seams are named by the dates in the "
    "field '{field}'.", INFO
)
SEAM_FEATURES_BROKEN = Message(
    "Features of the seamline layer whose geometry can't be read, left out: {count}; repair it ('Fix geometries' or "
    "ogr2ogr -makevalid)."
)
SEAM_POLYGONS_REPAIRED = Message(
    "Polygons of the seamline layer whose outline crosses itself, repaired: {count}.", WARNING
)
SEAM_SOURCES_MISSING = Message(
    "Orthoimages that the seamline layer names and that are not given: {count} (such as {names}).", WARNING
)
SOURCES_TOO_FEW = Message(
    "Only {between:.0f} of {all:.0f} m of the seamlines lie on two of the given orthoimages or more, so the seams are "
    "measured as without orthoimages; give those that are missing.", WARNING
)
SEAM_SOURCES_AMBIGUOUS = Message(
    "Names of orthoimages in the seamline layer that fit several of those given: {count} (such as {names}). Borders of "
    "polygons with such a name stay seams, and the pixels decide what the mosaic shows there; write paths with their "
    "folders into the layer to tell them apart.", WARNING
)
SEAM_FEATURES_NOT_TRANSFORMED = Message(
    "Features of the seamline layer that can't be brought into the mosaic's reference system, left out: {count}.",
    WARNING
)
# the journal of a scan that can go on where it stopped
GOES_ON = Message("The work continues where it stopped; parts that are done already: {done}.", INFO)
SCAN_ANEW = Message(
    "The scan starts from the beginning, as one of its files, a setting or the plugin's version changed since it "
    "stopped.", WARNING
)
SCAN_INPUT_CHANGED = Message(
    "While the mosaic was scanned {name} changed, so what was read of it before can't be used; start the scan again "
    "with the same output, and it is measured again."
)
SCAN_JOURNAL_NOT_SAVED = Message(
    "{path} can't be written ({error}). What was measured is saved (blocks done: {done}); make room on the disk and "
    "start it again with the same output to go on."
)
SCAN_JOURNAL_NOT_READ = Message(
    "{path} can't be read any more ({error}); start it again with the same output, and what is damaged is "
    "measured again."
)
STOPPED = Message("The work was stopped; started again with the same output it continues from here.", INFO)
SCAN_LAYER_NOT_WRITTEN = Message(
    "The layer {name} can't be written. What was measured is saved; make room on the disk, or choose another file for "
    "the layer, and start the scan again with the same picture of losses to go on."
)
MORE_SEAMS_THAN_OUTLINES = Message(
    "{metres:.0f} m of seam were found, but the orthoimages' outlines are only {around:.0f} m long: the mosaic seems "
    "to change between them everywhere, as after warping by nearest neighbour. No seam is listed; give seamlines, or "
    "the mosaic as it was before.", WARNING
)
SCAN_WITHOUT_SEAMS = Message(
    "No seam was found: as far as the orthoimages explain the mosaic, all of it shows {name}.", INFO
)
# what pieces of seam keep
PIECE_NOT_MEASURED = Message("There is too little texture along this piece to measure it; judge it by eye.")
PIECE_NOT_COMPARED = Message(
    "Too little of the ground beside this piece can be compared: an orthoimage ends there, or none shows what the "
    "mosaic does; judge it by eye, or give the orthoimages that it was made from."
)
PIECE_TOO_SHORT = Message(
    "This piece is {length:.1f} m long and {needed:.1f} m are needed to measure it; take longer pieces, or judge it by "
    "eye."
)
PIECE_WITHOUT_DETAIL = Message(
    "The ground along this piece has no fine detail that could be lost: the orthoimages show hardly more than noise "
    "there. It does not count.", INFO
)
SEAMS_WITHOUT_VERDICT = Message(
    "{metres:.0f} of {all:.0f} m of seam count neither as passed nor as failed; their fields 'state' and 'reason' say "
    "why.", WARNING
)
PIECES_NOT_MEASURED = Message("{metres:.0f} m were not measured. {reason}", WARNING)
MOSAIC_UNEXPLAINED = Message(
    "{share:.0f} % of the mosaic's textured ground match none of the orthoimages, most of it around {x:.1f}, {y:.1f}, "
    "so nothing is measured there. Give those that it was made from, and check that they lie where it does.", WARNING
)
MOSAIC_BESIDE = Message(
    "The mosaic does not lie where its orthoimages do: it lies {east:+.2f} m to the east, {north:+.2f} m to the north "
    "of all of them, so {share:.0f} % of its textured ground match none. Ask which of them have a wrong georeference.",
    WARNING,
)
BORDERS_WITHOUT_SEAM = Message(
    "The mosaic passes from one orthoimage to another along some {metres:.0f} m where no seam is measured, the longest "
    "{longest:.0f} m around {x:.1f}, {y:.1f}: no seamline is given there, it is too short to be found, or the place "
    "was blurred or cut out. Check it, and give the seamlines that are missing.", WARNING
)
MOSAIC_UNREAD = Message(
    "{share:.2g} % of the mosaic could not be read, for example around {x:.1f}, {y:.1f}, and count as not measured. "
    "Copy its files again and scan again.", WARNING
)
# seams of a mosaic whose orthoimages are not given
TOO_LITTLE_BESIDE_SEAM = Message(
    "Too little of this seam can be measured, or of the ground on one side of it; give the orthoimages.", INFO
)
LONE_PIECE_TOO_SHORT = Message(
    "Without orthoimages this piece is not enough: between {low:.0f} and {high:.0f} % of the finest detail is kept. On "
    "this mosaic at least {needed:.0f} m of seam are needed; take longer pieces, or give the orthoimages.", INFO
)
LONE_INTERVAL_TOO_WIDE = Message(
    "Without orthoimages the ground here is not enough: between {low:.0f} and {high:.0f} % of the finest detail is "
    "kept. Give the orthoimages to have a verdict.", INFO
)
LONE_NETWORK = Message(
    "All seams together keep {kept:.0f} % of the finest detail ({low:.0f} to {high:.0f} %), by the ground beside them.",
    INFO,
)
LONE_FROM_LENGTH = Message(
    "Without orthoimages a significant loss can be detected on this mosaic from about {length:.0f} m of seam on; to "
    "show that a seam is sound takes more.", INFO
)
LONE_NEVER = Message(
    "Without orthoimages no piece of seam can be judged on this mosaic, however long; add its orthoimages.", WARNING
)
# why a raster of a project is not suggested as a source
IS_THE_MOSAIC = Message("The mosaic itself.", INFO)
APART_FROM_MOSAIC = Message("Does not overlap the mosaic.", INFO)
OTHER_BANDS = Message("Other bands, {bands} and not {mosaic}: heights, a mask or a map.", INFO)
LARGER_PIXELS = Message("Pixels {factor:.1f} times as large as the mosaic's: an overview or a map.", INFO)
SMALLER_PIXELS = Message("Pixels {factor:.1f} times smaller than the mosaic's: another flight.", INFO)
OTHER_SYSTEM = Message("In another reference system than the mosaic and others here: a reprojected copy.", INFO)
OTHER_TYPE = Message("Pixels of {own}, the mosaic's and others' are {mosaic}: a converted copy.", INFO)
COVERS_MOSAIC = Message("Covers the whole mosaic, as few others do: a copy of it, another mosaic or a map.", INFO)
# sources that were made from the mosaic, and are given
COPY_AMONG_SOURCES = Message(
    "{name} matches the mosaic on both sides of its seams, so it is a copy or an overview of it, or the mosaic that "
    "this one was cut from. It would hide every loss and is left out of the sources.", WARNING
)
ALL_ARE_COPIES = Message(
    "All {count} orthoimages show the mosaic's pixels on both sides of its seams: they are copies of it, or parts of "
    "the only image that it was made of, and can't show what it lost. Give the orthoimages as they were rectified, "
    "before the mosaic was made, or none, to scan along seamlines alone."
)
MAY_BE_COPY = Message(
    "{name} is the same as the mosaic wherever they were compared. It is used, as it may be one of the orthoimages; "
    "if it is a copy of the mosaic or a part of it, it hides every loss there, so remove it from the sources.", WARNING
)
MAY_BE_ALTERED_COPY = Message(
    "{name} is like the mosaic wherever they were compared, as orthoimages of one ground can be. If it was made from "
    "the mosaic, it hides losses, so remove it from the sources.", INFO
)
MADE_OF_OTHERS = Message(
    "{name} shows what other sources show, with less detail, as a blurred mosaic or a mean of orthoimages does. It "
    "hides losses, so remove it from the sources.", WARNING
)
MOSAIC_MIXED_IN = Message(
    "Along {metres:.0f} m of seam, such as at {x:.1f}, {y:.1f}, up to {share:.0f} % of the mosaic are mixed into the "
    "orthoimages ({names}), which hides what it lost there. Ask for the orthoimages as they were before the mosaic was "
    "made.", WARNING
)
ONE_IMAGE_IN_PARTS = Message(
    "{name} and {count} more show the same pixels where they overlap: they are parts of one image and are treated "
    "as one.", INFO
)
# why a run of seam stays as it is, where seams are cut anew
NO_WAY = Message(
    "Both orthoimages cover too little of the corridor for a cut from one end to the other; make it wider."
)
IMAGES_MISFIT = Message(
    "The two orthoimages lie {misfit:.1f} pixels apart along the best cut, so edges would break; widen the corridor "
    "or register the images better."
)
IMAGES_UNLIKE = Message(
    "The two orthoimages show nothing in common along the best cut; widen the corridor, or choose other images."
)
IMAGES_OF_OTHER_GROUND = Message(
    "The orthoimages differ from the mosaic on {share:.1%} of the ground near the seam, as those of another date do, "
    "or any where its tones are clipped at white or black; choose those that it was made from."
)
DETAIL_NOT_SHOWN = Message(
    "{name} has {share:.0%} of the mosaic's fine detail beside the seam (band {band}), so it can't replace the mosaic "
    "there; choose the images that the mosaic was made from."
)
TONES_NOT_TOLD = Message(
    "Near the seam there is too little ground that shows one orthoimage alone, so its tones can't be determined."
)
PART_NOT_COVERED = Message("One of the two orthoimages has no pixels along the new cut.")
NOT_BETTER = Message("The new cut keeps no more detail than the old seam, so its patch is left out.")

CUT_NOT_MEASURED = Message("What the new cut keeps can't be measured, so its patch is left out.")
NOT_ON_MOSAIC = Message("The seam does not lie on this mosaic; give the seams that a scan of it found.")
SIDES_UNKNOWN = Message("The seam does not name two of the given orthoimages; give those the mosaic was made from.")

NO_WIDTH = Message("The corridor is {value:g} m wide; give more than 0.")
NO_BLEND = Message("A blend of {value:g} pixels can't be made; give a whole number of 0 to {most}.")
NOT_OF_A_SCAN = Message(
    "The layer of seams lacks fields of a scan ({fields}); give the seams as a scan of the mosaic writes them."
)
NO_PIECES = Message("The layer of seams holds no piece of seam; give the seams as a scan of the mosaic writes them.")
NOTHING_TO_MEND = Message("None of the seams is to be mended; choose another WHAT.", INFO)
