"""What a user can be told of the scan of a whole mosaic: its settings, inputs, journal, and pieces of seam."""
from __future__ import annotations

from ....imagery.errors import INFO, WARNING, Message

# settings of a scan
SCAN_LEVELS = Message("The scan measures 1 to {most} levels and {levels} were given; give 1 to {most}.")
DENSITY_UNKNOWN = Message("A scan has no density '{density}'; give one of: {known}.")
SCAN_CELL = Message("The picture of losses has no cells of {cell} pixels; give one of: {known}.")
SCAN_LENGTHS = Message("{name} is {value:g}; give {least} or more.")
LOSS_NOT_TIFF = Message("The picture of losses is a GeoTIFF; give {path} the ending .tif.")
SEAMS_WITHOUT_SEAL = Message(
    "The format of SEAMS has no place for the seal of the scan, without which no delivery is accepted; write SEAMS as "
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
    "None of the orthoimages can be used, for the reasons in the log; mend that, or leave them all out to scan the "
    "mosaic along its seamlines alone."
)
MOSAIC_NOT_READ = Message("Nothing of the mosaic {name} could be read, so nothing was measured: {why}")
SOURCES_NOT_READ = Message(
    "No orthoimage could be read, so nothing was measured; mend that, or leave them all out to scan the mosaic along "
    "its seamlines alone: {why}"
)
SOURCES_CROWDED = Message(
    "More than {most} orthoimages lie one above the other in parts of the mosaic (blocks: {count}); there the {most} "
    "that cover most of a block are taken.", WARNING
)
SOURCE_WITHOUT_BAND = Message(
    "{name} has no {band} band, which the mosaic is measured by, so it takes no part.", WARNING
)
# seams as producers deliver them
SEAMS_CUT_OFF = Message(
    "{outside:.0f} m of the {given:.0f} m of seamlines lie outside the mosaic and are left out.", WARNING
)
SEAM_FILE_NOT_READ = Message(
    "No seamlines can be read from {path}; check that it is a vector file, and the name of its layer."
)
SEAM_FIELD_MISSING = Message("The seamline layer has no field '{field}'; choose one of its fields: {known}.")
SEAMS_ELSEWHERE = Message(
    "None of the {count} features of the seamline layer lies on the mosaic; check the reference systems of both."
)
SEAMS_UNNAMED = Message(
    "The seamline layer names no orthoimages beside its seams, in a field 'source' for instance; where orthoimages are "
    "given, the mosaic itself tells which it follows.", INFO
)
SEAMS_NAMED_BY_DATE = Message(
    "The seamline layer names no orthoimages; the sides of its seams are named by the dates in the "
    "field '{field}'.", INFO
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
    "Polygons of the seamline layer overlap in {count} places of {area:.1f} m2 in all (such as {names}); which one "
    "lies on top can't be told, so no seam is measured there.", WARNING
)
SEAM_POLYGONS_GAPE = Message(
    "Between the polygons of the seamline layer there are {count} gaps of {area:.1f} m2 in all; their edges are no "
    "seams.", WARNING
)
SEAM_SOURCES_MISSING = Message(
    "Orthoimages that the seamline layer names and that are not given: {count} (such as {names}).", WARNING
)
SOURCES_TOO_FEW = Message(
    "Only {between:.0f} of {all:.0f} m of the seamlines lie on two of the given orthoimages or more, so the seams are "
    "measured as without orthoimages; give those that are missing.", WARNING
)
SEAM_SOURCES_AMBIGUOUS = Message(
    "Names of orthoimages in the seamline layer that fit several of those given: {count} (such as {names}). Borders "
    "of polygons with such a name stay seams, and the mosaic itself tells what it follows there; write paths with "
    "their folders into the layer to tell them apart.", WARNING
)
SEAM_FEATURES_NOT_TRANSFORMED = Message(
    "Features of the seamline layer that can't be brought into the mosaic's reference system, left out: {count}.",
    WARNING
)
# the journal of a scan that can go on where it stopped
SCAN_GOES_ON = Message("The scan goes on where it stopped; blocks that are done already: {done}.", INFO)
SCAN_ANEW = Message("The scan starts anew, since {what} changed since it stopped.", WARNING)
SCAN_INPUT_CHANGED = Message(
    "While the mosaic was scanned {name} changed, so what was read of it before can't be used; start the scan again "
    "with the same output, and it is measured anew."
)
SCAN_JOURNAL_FOREIGN = Message("{path} was not left by a scan; move it away, or choose another output.")
SCAN_JOURNAL_IN_USE = Message(
    "Another scan is writing this output ({path}); wait until it has ended, or choose another output."
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
SCAN_OF_OTHER_PLACES = Message("where the mosaic or one of the sources lies", INFO)
SCAN_WITH_OTHER_SETTINGS = Message("a setting", INFO)
SCAN_OF_OTHER_SEAMS = Message("the seam lines", INFO)
SCAN_OF_ANOTHER_KIND = Message("an input or a setting", INFO)
SCAN_STOPPED = Message("The scan was stopped; started again with the same output it goes on from here.", INFO)
SCAN_LAYER_NOT_WRITTEN = Message(
    "The layer {name} can't be written. What was measured is kept; make room on the disk, or choose another file for "
    "the layer, and start the scan again with the same picture of losses to go on."
)
SCAN_WITHOUT_SEAMS = Message(
    "No seam was found: as far as the orthoimages explain the mosaic, all of it follows {name}.", INFO
)
# what pieces of seam keep
PIECE_NOT_MEASURED = Message(
    "There is too little textured ground along this piece, or no source explains it; judge it by eye."
)
PIECE_TOO_SHORT = Message(
    "This piece is {length:.1f} m long and {needed:.1f} m are needed to measure it; take longer pieces, or judge it by "
    "eye."
)
PIECE_WITHOUT_DETAIL = Message(
    "The ground along this piece has no fine detail that could be lost: the orthoimages show hardly more than noise "
    "there. It does not count.", INFO
)
PIECE_NOT_EXPLAINED = Message(
    "None of the given orthoimages explains the mosaic along this piece; add the one that it was made from there."
)
PIECE_INTERVAL_TOO_WIDE = Message(
    "What is kept along this piece can only be told to lie between {low:.0f} and {high:.0f} %; scan with longer pieces."
)
SEAMS_WITHOUT_VERDICT = Message(
    "{metres:.0f} of {all:.0f} m of seam count neither as passed nor as failed; their fields 'state' and 'reason' say "
    "why.", WARNING
)
MOSAIC_UNEXPLAINED = Message(
    "{share:.0f} % of the mosaic's textured ground follow none of the orthoimages, most of it around {x:.1f}, "
    "{y:.1f}, so nothing is measured there. Give those that it was made from there.", WARNING
)
BORDERS_WITHOUT_SEAM = Message(
    "The mosaic passes from one orthoimage to another along some {metres:.0f} m where no seam is measured, the longest "
    "{longest:.0f} m around {x:.1f}, {y:.1f}: no seamline is given there, or the place was blurred or cut out. Look "
    "at it, and give the seamlines that lack or scan without SEAMLINES.", WARNING
)
MOSAIC_UNREAD = Message(
    "{share:.2g} % of the mosaic could not be read, such as around {x:.1f}, {y:.1f}, and count as not measured. Copy "
    "its files anew and scan again.", WARNING
)
# seams of a mosaic whose orthoimages are not given
TOO_LITTLE_BESIDE_SEAM = Message(
    "Too little of this seam can be measured, or of the ground on one side of it; give the orthoimages.", INFO
)
LONE_PIECE_TOO_SHORT = Message(
    "Without orthoimages this piece tells too little: between {low:.0f} and {high:.0f} % of the finest detail is "
    "kept. On this mosaic at least {needed:.0f} m of seam are needed; take longer pieces, or give the orthoimages.",
    INFO,
)
LONE_INTERVAL_TOO_WIDE = Message(
    "Without orthoimages the ground here tells too little: between {low:.0f} and {high:.0f} % of the finest detail is "
    "kept. Give the orthoimages to have a verdict.", INFO
)
LONE_NETWORK = Message(
    "All seams together keep {kept:.0f} % of the finest detail ({low:.0f} to {high:.0f} %), by the ground beside them.",
    INFO,
)
LONE_FROM_LENGTH = Message(
    "Without orthoimages a significant loss shows on this mosaic from about {length:.0f} m of seam on; that a seam is "
    "sound takes more.", INFO
)
LONE_NEVER = Message(
    "Without orthoimages no piece of seam can be judged on this mosaic, however long; add its orthoimages.", WARNING
)
