"""What a user can be told of seams: of inputs, windows placed and inspected, forecasts, thresholds and reports."""
from __future__ import annotations

from ...imagery.message import INFO, WARNING, Message

# settings
MAX_RATIO_OUT_OF_RANGE = Message("The largest ratio of a significant loss is {ratio}; give a number between 0 and 1.")
MIN_KEPT_OUT_OF_RANGE = Message(
    "The smallest share of detail that a seam has to keep is {kept}; give a number between 0 and 1."
)
REFERENCE_UNKNOWN = Message("A verdict can't be taken against '{reference}'; choose one of {known}.")
# the mosaic, its sources and its seamlines
NO_MOSAIC = Message("No mosaic is chosen; choose the mosaic in the inputs.")
MOSAIC_OPENING = Message("The mosaic is still being opened; try again in a moment.", WARNING)
MOSAIC_NOT_OPENED = Message(
    "The mosaic was not opened, as the task was cancelled; choose another mosaic in the inputs, then this one again."
)
NO_SOURCES_GIVEN = Message(
    "No sources are given; choose the orthoimages the mosaic was made from, or their index layer."
)
INDEX_WITHOUT_LOCATION = Message("The index layer has no field '{field}'; make it with gdaltindex.")
MOSAIC_AMONG_SOURCES = Message("{name} is the mosaic itself and is left out of the sources.", WARNING)
CELLS_WITHOUT_SOURCE = Message(
    "The layer of seam cells has no field 'source'; add one with the file names of the orthoimages."
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
STATION_WITHOUT_WINDOW = Message(
    "Seam {seam} has no window at {station:.1f} m: it would stick out of the mosaic or hold too few valid pixels, and "
    "there is no room beside.", WARNING
)
STRETCH_WITHOUT_WINDOW = Message(
    "Seam {seam} has no windows from {start:.1f} to {end:.1f} m: they would stick out of the mosaic or hold too few "
    "valid pixels, and there is no room beside.", WARNING
)
WINDOWS_CROWDED = Message(
    "Left out because they would share more than half of their pixels with another window of the same seam: "
    "{count}.", WARNING
)
SEAMS_COVERED = Message("Seams that lie within windows of longer ones and got none of their own: {count}.", WARNING)
SEAMS_TINY = Message("Seams shorter than {shortest:.2f} m, too short to matter in a window: {count}.", WARNING)
SEAMS_OUTSIDE = Message("Seams outside the mosaic: {count}.", WARNING)
WINDOWS_PLACED = Message("Windows placed along the seams: {count}. Inspect them when you are ready.", INFO)
WINDOWS_PLACED_IN_PART = Message(
    "Windows placed along the seams: {count}; places left without one: {notes}, told in the log messages.", INFO
)
WINDOWS_PLACED_BESIDES = Message(
    "Windows placed along the seams: {count}; places that had theirs already: {there}. Inspect them when you are "
    "ready.",
    INFO,
)
WINDOWS_THERE_ALREADY = Message("No window was placed: all {there} places along the seams have theirs already.", INFO)
NO_WINDOW_PLACED = Message("No window could be placed along the seams; the log messages say why.", WARNING)
# the window layer
WINDOW_LAYER_NOT_CREATED = Message(
    "No window layer can be written to {folder}; save the project in a folder that you may write to."
)
WINDOWS_NOT_SAVED = Message(
    "The windows in {name} could not be saved with the project ({error}); they stay open for editing, so save that "
    "layer elsewhere."
)
WINDOWS_KEPT_MEANWHILE = Message(
    "Until the project is saved its windows are in {path}; they move beside the project then.", INFO
)
WINDOWS_MOVED = Message("The windows moved beside the project, to {path}.", INFO)
WINDOWS_NOT_MOVED = Message(
    "The windows stay in {old}, as they can't be moved to {folder} ({error}); export them from there."
)
WINDOWS_FOUND = Message(
    "QGIS ended before a project with windows was saved; they are in {path}. Open its rasters, then the windows.",
    WARNING,
)
WINDOWS_RESTORED = Message(
    "QGIS ended without saving; the changes of {count} windows in {name} are back. Save the layer.", WARNING
)
WINDOWS_NOT_KEPT = Message(
    "What is judged is safe only once you save the layer: it can't be kept in {path} meanwhile ({error}).", WARNING
)
RESULTS_NOT_KEPT = Message(
    "Curves and pictures of the windows can't be kept in {path} ({error}); without them windows are measured again "
    "after the project was closed.",
    WARNING,
)
WINDOWS_WITHOUT_FILE = Message(
    "The windows in {name} are in no file: they and what is judged are lost when QGIS ends. Export the layer to a "
    "GeoPackage to keep them.",
    WARNING,
)
WINDOWS_RENUMBERED = Message("{count} windows had no number of their own and were given the next free ones.", WARNING)
# why a window is not comparable
NO_SOURCES = Message("No source covers the window; add the orthoimages that overlap it or move the window.", INFO)
NO_SOURCE_COMPARABLE = Message("No source can be compared here: {why}", INFO)
MOSAIC_CONSTANT = Message("The mosaic has no variance in the window; move the window to where there is content.", INFO)
SOURCE_CONSTANT = Message("{name} has no variance in the window; move the window to where there is content.")
SOURCES_WITHOUT_DETAIL = Message(
    "No source has detail at level 1 in the window; move the window to where there is some.", INFO
)
BANDS_DIFFER = Message("{name} has no {band} (its bands: {bands}); choose sources with the mosaic's bands.")
COMPOSITE_UNCLEAR = Message(
    "No source explains the mosaic's fine detail here, so their composite is no reference; add the orthoimages it was "
    "made from, or take the verdict against the sources.", INFO
)
NO_SEAM = Message(
    "The mosaic follows one source all over the window, so there is no seam here; the verdict is that of the sharpness "
    "alone.",
    INFO
)
TOO_LITTLE_GROUND = Message(
    "There is too little ground beside the seam to compare it with; take a larger window, or move it so that more "
    "than the seam's surroundings are in it.", INFO
)
SEAM_UNEXPLAINED = Message(
    "{share:.0f} % of the window is from none of the given sources, so what its seam kept can't be told; add the "
    "orthoimage that is missing.", INFO
)
VERDICT_OF_THE_REST = Message(
    "{share:.0f} % of the window is from none of the given sources and took no part; the verdict is that of the rest, "
    "so add the orthoimage that is missing.", WARNING
)
MORE_ALONG_THE_SEAM = Message(
    "Along the seam the mosaic has {low:.0f} to {high:.0f} % of the detail of the sources that it seems to follow, "
    "more than any seam leaves; add the orthoimages that it was made from.", INFO
)
INTERVAL_TOO_WIDE = Message(
    "What is kept along the seam can only be told to lie between {low:.0f} and {high:.0f} %; take a larger window.",
    INFO
)
SOURCE_IN_PART = Message("{name} covers {share:.0f} % of the window and takes part there.", INFO)
SOURCE_RESAMPLED = Message(
    "{name} has another pixel size or system than the mosaic and was resampled; it is shown and doesn't count, as "
    "others are on the mosaic's pixels.", INFO
)
ALL_RESAMPLED = Message(
    "All sources have another pixel size or system than the mosaic and were resampled, which changes detail; the "
    "verdict is uncertain by that.", WARNING
)
WINDOW_FAILED = Message("The window could not be measured ({error}); please report this.")
# why no loss is foretold
ONE_SOURCE = Message("Only one source covers the window, so nothing will be feathered there.", INFO)
ONE_SOURCE_COMPARABLE = Message("Only one source can be compared here: {why}", INFO)
# the feather whose loss is foretold
WIDTH_NEGATIVE = Message("The feather is {width} m wide; give a width in metres, or 0 for its middle alone.")
RAMP_UNKNOWN = Message("A feather can't have the ramp '{ramp}'; choose one of {known}.")
SEAM_ASSUMED = Message(
    "Where no seamline divides a window in two, the seam is assumed to run through its middle.", INFO
)
# tables of inspected windows
WINDOWS_WITHOUT_FIELD = Message(
    "The window layer has no field '{field}'; choose a layer of inspected windows, as 'Inspect windows' leaves it."
)
PAIRS_WITHOUT_FIELD = Message(
    "The table of pairs has no field '{field}'; choose the table that 'Inspect windows' left with these windows."
)
CURVES_WITHOUT_FIELD = Message(
    "The table of curves has no field '{field}'; choose the table that 'Inspect windows' left with these windows."
)
PAIRS_WITHOUT_CONTRAST = Message(
    "The table of pairs has no field 'contrast_1', so the absolute contrast is not judged; inspect the windows anew to "
    "have it.", WARNING
)
TABLE_NOT_SAVED = Message("The table can't be saved as {path}: {error}.")
FILTER_NOT_UNDERSTOOD = Message("The filter is not understood: {error}. Example: kept < 0.7 and cause = 'feathering'.")
FILTER_FIELD_UNKNOWN = Message("The filter asks for '{name}', which windows don't have. They have: {known}.")
FIELD_NOT_HELD = Message(
    "The file of the layer {name} can't hold a field '{field}': save the windows as a GeoPackage and use that layer."
)
# the threshold that an observer's verdicts support
VERDICTS_UNKNOWN = Message(
    "Left out because the observer's word is neither 'visible' nor 'invisible': {count} windows.", WARNING
)
VERDICTS_WITHOUT_VALUE = Message(
    "{measure}: left out because nothing was measured there: {count} judged windows.", WARNING
)
TOO_FEW_VERDICTS = Message(
    "{measure}: {visible} visible and {invisible} invisible verdicts; a threshold needs at least {fewest} of either, "
    "so judge more windows.", WARNING
)
NO_BETTER_THAN_CHANCE = Message(
    "{measure} does not tell visible losses from others for sure: the area under its curve lies between {low:.2f} and "
    "{high:.2f}, and 0.5 is a guess. Judge more windows before you rely on a threshold.", WARNING
)
VERDICTS_FULLY_APART = Message(
    "{measure} is lower in every window with a visible loss than in any other, so resampling has no error to show; the "
    "interval is the score interval.", WARNING
)
VERDICTS_IN_ONE_PLACE = Message(
    "{measure}: the verdicts of a kind lie in one neighbourhood, so the intervals take windows as if none had to do "
    "with another and are too narrow; judge windows elsewhere too.", WARNING
)
VERDICTS_WITHOUT_OUTLINE = Message(
    "Judged windows without an outline: {count}. Each counts as if no other lay near it, so the intervals may be too "
    "narrow; use the window layer itself.", WARNING
)
NO_THRESHOLD = Message(
    "{measure}: no threshold that can be set is better than a guess; look at the verdicts again, or use another "
    "measure.", WARNING
)
THRESHOLD_TOO_HIGH = Message(
    "{measure}: the verdicts support a threshold of {threshold:.3f}, and one that can be set lies below {most:g}; the "
    "best below it is given.", WARNING
)
# the report
NO_REPORT_FILE = Message("No file is given for the report; choose where it is to be written.")
CLIP_NOT_SHOWN = Message("Window {window}: {why}", WARNING)
DETAILS_LIMITED = Message(
    "{count} windows are flagged and the report shows curves and clips of the {most} with the greatest losses; the "
    "others stand in the table. Report a part of the windows to see them.", WARNING
)
# the scan of a whole mosaic
SCAN_LEVELS = Message("The scan measures 1 to {most} levels and {levels} were given; give 1 to {most}.")
DENSITY_UNKNOWN = Message("{density} is no density of a scan; give one of: {known}.")
SCAN_CELL = Message("The picture of losses has no cells of {cell} pixels; give one of: {known}.")
SCAN_LENGTHS = Message("{name} is {value:g}; give a number of {least} or more.")
SOURCE_WITHOUT_BAND = Message(
    "{name} has no {band} band, which the mosaic is measured by, so it takes no part.", WARNING
)
SEAMS_CUT_OFF = Message(
    "{outside:.0f} m of the {given:.0f} m of seamlines lie outside the mosaic and are left out.", WARNING
)
# the journal of a scan that can go on where it stopped
SCAN_GOES_ON = Message("The scan goes on where it stopped; blocks that are done already: {done}.", INFO)
SCAN_ANEW = Message("The scan starts anew, since {what} changed since it stopped.", WARNING)
SCAN_ANEW_DAMAGED = Message("The scan starts anew, since nothing in {path} can be read any more.", WARNING)
SCAN_JOURNAL_DAMAGED = Message(
    "{path} is damaged; the blocks before are kept ({done}), and the others are measured again.", WARNING
)
SCAN_JOURNAL_FOREIGN = Message("{path} was not left by a scan; move it away, or choose another output.")
SCAN_JOURNAL_IN_USE = Message(
    "Another scan is writing this output ({path}); wait until it has ended, or choose another output."
)
SCAN_JOURNAL_NOT_LOCKED = Message(
    "{path} can't be kept to one scan on this disk ({error}); choose an output on a local disk."
)
SCAN_JOURNAL_NOT_OPENED = Message("{path} can't be written ({error}); choose another folder for the output.")
SCAN_JOURNAL_NOT_SAVED = Message(
    "{path} can't be written ({error}). What was measured is kept (blocks done: {done}); make room on the disk and "
    "start the scan again with the same output to go on."
)
SCAN_JOURNAL_NOT_READ = Message(
    "{path} can't be read any more ({error}); start the scan again with the same output, and what is damaged is "
    "measured again."
)
SCAN_OF_ANOTHER_VERSION = Message("the plugin's version", INFO)
SCAN_OF_ANOTHER_MOSAIC = Message("the mosaic", INFO)
SCAN_OF_OTHER_SOURCES = Message("the sources or one of their files", INFO)
SCAN_WITH_OTHER_SETTINGS = Message("a setting", INFO)
SCAN_OF_OTHER_SEAMS = Message("the seam lines", INFO)
SCAN_OF_ANOTHER_KIND = Message("an input or a setting", INFO)
PIECE_NOT_MEASURED = Message(
    "There is too little textured ground along this piece, or no source explains it; judge it by eye."
)
SCAN_STOPPED = Message("The scan was stopped; started again with the same output it goes on from here.", INFO)
# seams as producers deliver them
SEAM_FIELD_MISSING = Message("The seamline layer has no field '{field}'; choose one of its fields: {known}.")
SEAMS_ELSEWHERE = Message(
    "None of the {count} features of the seamline layer lies on the mosaic; check the reference systems of both."
)
SEAMS_UNNAMED = Message(
    "The seamline layer names no orthoimages beside its seams, in a field 'source' for instance; where orthoimages are "
    "given, the mosaic itself tells which it follows.", INFO
)
SEAMS_NAMED_BY_DATE = Message(
    "The seamline layer names no orthoimages; what lies beside its seams is called by its dates, of the field "
    "'{field}'.", INFO
)
SEAM_FEATURES_BROKEN = Message(
    "Features of the seamline layer whose geometry can't be read, left out: {count}; repair the layer with 'Fix "
    "geometries'.", WARNING
)
SEAM_FEATURES_ALL_BROKEN = Message(
    "The geometry of no feature of the seamline layer can be read; repair the layer with 'Fix geometries'."
)
SEAM_LINES_CROSS = Message(
    "Lines of the seamline layer that cross themselves: {count}; they are measured as they are.", WARNING
)
SEAM_POLYGONS_REPAIRED = Message(
    "Polygons of the seamline layer whose outline crosses itself, repaired: {count}.", WARNING
)
SEAM_POLYGONS_OVERLAP = Message(
    "Polygons of the seamline layer overlap in {count} places of {area:.1f} m2 in all; which one lies on top can't be "
    "told, so no seam is measured there.", WARNING
)
SEAM_POLYGONS_OVERLAP_NAMED = Message(
    "Polygons of the seamline layer overlap in {count} places of {area:.1f} m2 in all ({names} first of all); which "
    "one lies on top can't be told, so no seam is measured there.", WARNING
)
SEAM_POLYGONS_GAPE = Message(
    "Between the polygons of the seamline layer there are {count} gaps of {area:.1f} m2 in all; their edges are no "
    "seams.", WARNING
)
SEAM_SOURCES_MISSING = Message(
    "Orthoimages that the seamline layer names and that are not given: {count} ({names} first of all).", WARNING
)
SEAM_FEATURES_NOT_TRANSFORMED = Message(
    "Features of the seamline layer that can't be brought into the mosaic's reference system, left out: {count}.",
    WARNING
)
# seams of a mosaic whose orthoimages are not given
TOO_LITTLE_BESIDE_SEAM = Message(
    "Too little of this seam can be measured, or of the ground on one side of it; give the orthoimages.", INFO
)
LONE_PIECE_TOO_SHORT = Message(
    "Without orthoimages this piece tells too little: between {low:.0f} and {high:.0f} % of the finest detail is kept. "
    "On this mosaic some {needed:.0f} m of seam are needed; take longer pieces, or give the orthoimages.", INFO
)
LONE_INTERVAL_TOO_WIDE = Message(
    "Without orthoimages the ground here tells too little: between {low:.0f} and {high:.0f} % of the finest detail is "
    "kept. Give the orthoimages to have a verdict.", INFO
)
JUDGED_WITH_RUN = Message(
    "Too short to be judged without orthoimages; judged with the {length:.0f} m of seam around it, which keep "
    "{low:.0f} to {high:.0f} %.", INFO
)
# sources that were made from the mosaic
COPY_AMONG_SOURCES = Message(
    "{name} is like the mosaic everywhere, so it is a copy of it, or the mosaic that this one was cut from. It would "
    "hide every loss and is left out of the sources.", WARNING
)
OVERVIEW_AMONG_SOURCES = Message(
    "{name} is the mosaic with larger pixels, an overview of it, and left out of the sources.", WARNING
)
ONLY_SOURCE_IS_EQUAL = Message(
    "{name} is like the mosaic everywhere and there is no other source; if it is a copy of the mosaic, the scan tells "
    "nothing, so give the orthoimages that the mosaic was made from.", WARNING
)
NEITHER_SOURCES_NOR_SEAMS = Message(
    "Neither orthoimages nor seamlines are given; add the orthoimages, or the seamlines to scan the mosaic alone."
)
LONE_NETWORK = Message(
    "All seams together keep {kept:.0f} % of the finest detail ({low:.0f} to {high:.0f} %), by the ground beside them.",
    INFO,
)
LONE_FROM_LENGTH = Message(
    "Without orthoimages a piece of seam can be judged on this mosaic from some {length:.0f} m on.", INFO
)
LONE_NEVER = Message(
    "Without orthoimages no piece of seam can be judged on this mosaic, however long; add its orthoimages.", WARNING
)
SCAN_MOSAIC_TOO_SMALL = Message(
    "The mosaic has {width} x {height} pixels and a scan needs {fewest} at least; inspect it in windows instead."
)
NO_SOURCE_ON_MOSAIC = Message(
    "No orthoimage lies on the mosaic, of {count}; check the reference systems, or give those that it was made from."
)
SOURCES_CROWDED = Message(
    "More than {most} orthoimages lie one above the other in parts of the mosaic (blocks: {count}); there the {most} "
    "that cover most of a block are taken.", WARNING
)
SCAN_LAYER_NOT_WRITTEN = Message(
    "The layer {name} can't be written. What was measured is kept; make room on the disk, or choose another file for "
    "the layer, and start the scan again with the same picture of losses to go on."
)
NO_SOURCE_USABLE = Message(
    "None of the orthoimages can be used, for the reasons that are told; mend that, or leave them all out to scan the "
    "mosaic along its seamlines alone."
)
PIECE_TOO_SHORT = Message(
    "This piece is {length:.1f} m long and {needed:.1f} m are needed to measure it; take longer pieces, or judge it by "
    "eye."
)
MOSAIC_UNEXPLAINED = Message(
    "{share:.0f} % of the mosaic follow none of the orthoimages, so nothing is measured there. Give those that it was "
    "made from there; ground without any texture, such as water, is counted as well.", WARNING
)
PIECE_NOT_EXPLAINED = Message(
    "None of the given orthoimages explains the mosaic along this piece; add the one that it was made from there."
)
PIECE_INTERVAL_TOO_WIDE = Message(
    "What is kept along this piece can only be told to lie between {low:.0f} and {high:.0f} %; scan with longer pieces."
)
PIECES_LENGTHENED = Message(
    "Pieces of seam are made {needed:.1f} m long: at this pixel size shorter ones can't be measured.", WARNING
)
SEAMS_WITHOUT_VERDICT = Message(
    "{metres:.0f} of {all:.0f} m of seam have no verdict; the field 'reason' of the seams says why.", WARNING
)
CORRIDOR_WITHOUT_SEAMS = Message(
    "The corridor counts only with seamlines; without them all of the mosaic is read.", WARNING
)
LOSS_NOT_TIFF = Message("The picture of losses is a GeoTIFF; give {path} the ending .tif.")
