"""What a user can be told of the decision on a delivery."""
from __future__ import annotations

from ...imagery.errors import INFO, WARNING, Message

# an index of sheets
SHEETS_WITHOUT_NAMES = Message("The layer of sheets does not name them; it needs one of the fields {fields}.")
SHEETS_ELSEWHERE = Message(
    "No piece of seam lies in any of the sheets; choose the index of this delivery, and check its reference system.")
SHEET_WITHOUT_NAME = Message("Sheet no. {number} has no name in the field {field}; fill it in.")
SHEET_WITHOUT_PLACE = Message("The outline of the sheet {name} has coordinates that are not numbers; draw it again.")
PIECES_OFF_SHEETS = Message(
    "Pieces of seam outside of all sheets: {count}. They are listed under their layer's name.", WARNING)
SEAMS_NOT_ON_GROUND = Message(
    "The seams lie outside the area of their coordinate reference system; assign them the system of their coordinates.")
# a file with rules
TWO_RULES_FOR_CHECK = Message("{name} has two rules for '{check}' ({place} is the second); keep one.")
RULES_WITHOUT_KEPT = Message("{name} does not say what a piece must keep; add a rule with the check 'kept'.")
KEPT_NOTHING = Message("A piece that has to keep 0 always passes; give the share that it has to keep, such as 0.7.")
RULES_DECIDE_NOTHING = Message(
    "{name} has no rule to decide by; add a rule 'failed_share', 'longest_failure' or 'sampling'.")
RULES_LIMIT_MISSING = Message("{place} in {name}: the check '{check}' needs '{key}'; give it.")
RULES_NO_SHARE = Message("{place} in {name}: '{key}' is {limit:g} and a share is at most 1; write 2 % as 0.02.")
RULES_QUALITY_UNKNOWN = Message("{place} in {name}: the {key} '{value}' is not in the standard; known are {known}.")
RULES_AND_PARAMETER = Message(
    "{parameter} is {value}, and the rules in {name} are given, too; leave it at its default, or leave the rules out.")
TWO_RULES = Message("Both the ready rules '{ready}' and the rules in {name} are given; choose one of them.")
# plans of sampling
LOT_TOO_SMALL = Message("The lot has {size} items and a plan of sampling needs at least 2; inspect all of it instead.")
LOT_SMALLER_THAN_GIVEN = Message(
    "The lot size is {size} and the layers hold {given} pieces; give the size of the whole lot, or 0 to take what is "
    "given.")
WINDOWS_WITHOUT_MOSAIC = Message("Windows are placed on the mosaic's pixels; give MOSAIC, or take pieces as the unit.")
MOSAIC_SMALLER_THAN_WINDOW = Message(
    "The mosaic is smaller than a window of {pixels} px, the power of two that spans {side:g} m; give a shorter SIDE.")
WINDOW_SIDE_TOO_SHORT = Message(
    "A window of {side:g} m has {pixels} px and needs {least} at least; give a longer SIDE.")
SEAM_OFF_MOSAIC = Message(
    "A piece of the sample does not lie on the mosaic; give that of all sheets, and check the reference systems.")
PLANNED_BY_STANDARD = Message("{size} of {lot} pieces are inspected and up to {acceptance} may fail ({plan}).", INFO)
SAMPLE_LARGER_THAN_GIVEN = Message(
    "The plan needs {size} pieces and the layers hold {drawn}; draw the others from the rest of the lot.", WARNING)
PLANNED_BY_COUNT = Message("{size} of {lot} pieces are drawn.", INFO)
# the decision: {why} and {also} are reasons from below
ACCEPTED = Message("Accepted by '{rules}': {why}.", INFO)
REJECTED = Message("Rejected by '{rules}': {why}.", INFO)
UNDECIDED = Message("Undecided by '{rules}': {why}.", INFO)
OPEN_BESIDES = Message("Open besides: {why}.", INFO)
AND = Message("{why}; {also}", INFO)
LIMITS_ARE = Message("the limits are {limits}", INFO)
WITH = Message("{first}, {also}", INFO)
LIMIT_OF_KEPT = Message("at least {limit:.0%} kept", INFO)
LIMIT_OF_SHARE = Message("at most {limit:.2%} failed", INFO)
LIMIT_OF_RUN = Message("at most {limit:.1f} m without a break", INFO)
LIMIT_OF_MEASURED = Message("at least {limit:.1%} measured", INFO)
NO_LIMIT_OF_SHARE = Message("no limit on the share that failed", INFO)
NO_LIMIT_OF_RUN = Message("no limit on metres without a break", INFO)
NO_LIMIT_OF_MEASURED = Message("no limit on the share measured", INFO)
SAMPLED_BY_AQL = Message("sampled at level {level}, AQL {aql:g}", INFO)
SAMPLED_BY_LQ = Message("sampled as an isolated lot, LQ {lq:g} %", INFO)
SHARE_FAILED = Message("{value:.2%} of the measured metres failed, {limit:.2%} is allowed", INFO)
SHARE_OPEN = Message(
    "{value:.2%} of the measured metres failed, {limit:.2%} is allowed; with what is unknown it may be {low:.2%} "
    "to {high:.2%}", INFO)
SHARE_UNKNOWN = Message(
    "{value:.2%} of the measured metres failed, {limit:.2%} is allowed; with what is unknown, such as {metres:.0f} "
    "m that were not measured, it may be up to {high:.2%}", INFO)
RUN_FAILED = Message("the longest failure without a break is {value:.1f} m and the limit is {limit:.1f} m", INFO)
RUN_OPEN = Message(
    "the longest failure without a break is {value:.1f} m and the limit is {limit:.1f} m, but it may be {low:.1f} to "
    "{high:.1f} m by the intervals of its pieces", INFO)
RUN_UNKNOWN = Message(
    "the longest failure without a break is {value:.1f} m and the limit is {limit:.1f} m, but a row of pieces that "
    "were not measured may make it {metres:.1f} m", INFO)
RUN_IN_PIECE = Message(
    "the longest failure without a break is {value:.1f} m and the limit is {limit:.1f} m, but pieces are up to "
    "{metres:.1f} m long, which can hide a longer one", INFO)
MEASURED = Message("{value:.1%} of the metres were measured and {limit:.1%} are required", INFO)
NOTHING_WAS_MEASURED = Message("nothing was measured, so it can't be decided", INFO)
MOSAIC_LACKS = Message(
    "{share:.0%} of the mosaic of '{name}' match no orthoimage, {limit:.0%} is allowed; most around {place}", INFO)
MOSAIC_DISPLACED = Message(
    "the mosaic of '{name}' does not lie where its orthoimages do: it lies {east:+.2f} m to the east, {north:+.2f} m "
    "to the north of all of them", INFO)
MOSAIC_PARTLY_READ = Message("{share:.2%} of the mosaic of '{name}' could not be read, such as around {place}", INFO)
DOUBT_NOT_MEASURED = Message("sheets of which nothing was measured: {count} ({names})", INFO)
DOUBT_LEFT_OUT = Message("sheets that are missing in the mosaic that was scanned: {count} ({names})", INFO)
DOUBT_DAMAGED = Message("sheets whose pixels can't all be read: {count} ({names})", INFO)
DOUBT_OVERLAP = Message(
    "sheets that differ from others where they overlap, which nobody has checked: {count} ({names})", INFO)
DOUBT_LAYERS_CHANGED = Message("layers of seams were changed since their scan: {count} ({names})", INFO)
DOUBT_SCANNED_TWICE = Message("different scans of one mosaic are given: {count} ({names})", INFO)
DOUBT_WITHOUT_SEAL = Message("layers of seams without the seal of a scan: {count} ({names})", INFO)
DOUBT_NOT_SCANNED = Message("the files given are not the ones that were scanned: {count} ({names})", INFO)
DOUBT_FILES_CHANGED = Message("files were changed since they were scanned: {count} ({names})", INFO)
DOUBT_OF_OTHERS = Message("layers of seams whose mosaics are not given: {count} ({names})", INFO)
DOUBT_FILES_GONE = Message("files of the scanned mosaic can no longer be found: {count} ({names})", INFO)
SEAMS_LACK = Message("{metres:.0f} m of seam are missing", INFO)
SOURCES_ARE_MOSAIC = Message(
    "some images given as orthoimages are the mosaic, or were made from others, so they hide what it lost: "
    "{names}", INFO)
SOURCES_HOLD_MOSAIC = Message(
    "along {metres:.0f} m of seam the mosaic is mixed into the orthoimages ({names}), which hides what it lost there",
    INFO)
SOURCES_LACK = Message(
    "orthoimages that the seamlines name were not given to the scan ({names}), so seams beside them are not measured",
    INFO)
SEAMS_UNSEEN = Message(
    "parts of the mosaic match no orthoimage, and {metres:.0f} m of border around them may be seams that are not "
    "counted: with these only {value:.1%} of the metres were measured and {limit:.1%} are required", INFO)
SEAMS_UNCHANGED = Message(
    "along {metres:.0f} of {judged:.0f} m of seam that are judged both sides show the same orthoimage, {limit:.0%} "
    "is allowed", INFO)
SEAMS_NOT_JUDGED = Message(
    "beside {judged:.0f} m of seam that are judged the scan saw the mosaic change from one orthoimage to another along "
    "{metres:.0f} m, the longest around {place}; {limit:.0%} is allowed", INFO)
BORDER_WITHOUT_SEAM = Message(
    "along {metres:.0f} m around {place} the mosaic passes from one orthoimage to another and no seam is measured, and "
    "{limit:.1f} m may fail without a break", INFO)
BORDER_HIDDEN = Message(
    "along {metres:.0f} m between two orthoimages, the longest around {place}, no seam is judged, or neither explains "
    "the mosaic; with these {value:.2%} of the metres may have failed, {limit:.2%} is allowed", INFO)
SAMPLE_FAILED = Message("{nonconforming} of {inspected} inspected pieces failed, at most {limit} may", INFO)
BY_AQL = Message("{standard}, lot of {lot}, level {level}, AQL {aql:g}, code letter {letter}", INFO)
BY_LQ = Message("{standard}, isolated lot of {lot}, limiting quality {lq:g} %", INFO)
WITHOUT_SAMPLE = Message("{standard}, all of the lot of {lot} inspected", INFO)
PLAN_LACKS_PIECES = Message(
    "the plan needs a sample of {needed} pieces and {given} were measured, so it can't be decided", INFO)
# what the decision rests on
NOT_MEASURED = Message("{metres:.1f} of {all:.1f} m of seam could not be measured.", WARNING)
WITHOUT_DETAIL = Message(
    "{metres:.0f} of {all:.0f} m of seam lie on ground without detail, which has nothing to lose; they are not "
    "judged.", INFO)
# what would decide what is undecided
WOULD_MEASURE = Message(
    "What would decide it: a scan with pieces of {piece:.0f} m (PIECE), with which some {share:.0%} of the metres "
    "would be measured.", WARNING)
WOULD_GIVE_COVER = Message(
    "What would decide it: a scan with the orthoimages that the mosaic was made from, complete and unchanged. Along "
    "{metres:.0f} m, such as at {place}, pixels are missing or were changed, or those that were given do not explain "
    "the mosaic; ask the producer for them.", WARNING)
WOULD_LOOK_THERE = Message(
    "What would decide it: an operator's look at what was not measured, at least {wanted:.0f} of {lacking:.0f} m; "
    "whoever signs decides by that. A scan with longer pieces may not measure enough.", WARNING)
WOULD_MEASURE_ALONE = Message(
    "What would decide it: measuring at least {wanted:.0f} of the {lacking:.0f} m that were not measured. Give the "
    "orthoimages beside them to the scan.", WARNING)
WOULD_LOOK = Message(
    "What would decide it: an operator's look, by which whoever signs decides, since all seams lie on ground without "
    "detail.", WARNING)
WOULD_TELL_APART = Message(
    "What would decide it: an operator's look at the pieces whose intervals include the limit ({metres:.0f} m, pieces: "
    "{count}); whoever signs decides by that.", WARNING)
WOULD_SHORTEN = Message(
    "What would decide it: a scan with shorter pieces. Failures end within pieces, so with pieces of {piece:.0f} m the "
    "failed length is known only to {within:.0f} m, and {allowed:.0f} m may fail.", WARNING)
WOULD_GIVE_SCAN = Message("What would decide it: the layers of the whole scan, not a sample of their pieces.", WARNING)
WOULD_COMPLETE_SAMPLE = Message(
    "What would decide it: as many measured pieces as the plan needs, drawn from the whole lot.", WARNING)
WOULD_GIVE_ORTHOIMAGES = Message("What would decide it: a scan with the orthoimages that are missing.", WARNING)
WOULD_PLACE = Message(
    "What would decide it: a scan of mosaic and orthoimages that lie in the same place. Ask the producer which of them "
    "have a wrong georeference.", WARNING)
WOULD_GIVE_SEAMS = Message(
    "What would decide it: a scan with seamlines that lie wherever the mosaic changes from one orthoimage to another, "
    "and nowhere else, or with none.", WARNING)
WOULD_GIVE_LAYER = Message(
    "What would decide it: the layers of seams as their scans wrote them, in the GeoPackages themselves or copies of "
    "these files; exports, merged layers and other formats lose the seal. Scan again where they are lost.", WARNING)
WOULD_SCAN_AGAIN = Message(
    "What would decide it: the files that were scanned, given as the mosaic and its orthoimages, or a new scan of the "
    "present files.", WARNING)
WOULD_GIVE_MOSAICS = Message(
    "What would decide it: all mosaics of the delivery given to the decision, each sheet or a VRT of all; leave the "
    "layers of others out.", WARNING)
WOULD_CUT = Message(
    "What would decide it: a scan with pieces of {piece:.0f} m or less, half of the longest failure that is allowed: a "
    "longer piece may pass although a part of it failed.", WARNING)
WOULD_SEE_SHEETS = Message(
    "What would decide it: a scan of all sheets, complete, readable and identical where they overlap; leave out the "
    "layer of a sheet without seams.", WARNING)
WOULD_LEAVE_OUT = Message(
    "What would decide it: one scan of each mosaic, and of sheets that overlap as one mosaic.", WARNING)
WOULD_GIVE_ORIGINALS = Message(
    "What would decide it: a scan with the complete orthoimages as rectified, and no others.", WARNING)
# the layers that are decided on
LAYERS_SEALED = Message("The layers of seams are as their scans left them ({count}).", INFO)
OF_MOSAICS = Message(
    "The layers of seams are of {count} mosaics, and none is given to the decision, so it is unknown whether all "
    "belong to the delivery.", INFO)
SOURCES_GONE = Message(
    "Orthoimages that were scanned can no longer be found: {count} ({names}); without them the measurements behind the "
    "decision can't be repeated.", WARNING)
SETTINGS_DIFFER = Message(
    "The layers of seams were measured with different settings: {setting} is {values}.", WARNING)
LAYER_FILTERED = Message(
    "{name} is filtered ({filter}) and shows only a part of its seams; remove the filter, as the decision needs all of "
    "them.")
DRAWN = Message("The sample of {size} was drawn of {given} measured pieces with the seed {seed}.", INFO)
SAMPLE_GIVEN = Message(
    "The layers are a sample of {given} pieces of seam: metres and shares are those of the sample, and the longest "
    "failure of the delivery can't be determined from it.", INFO)
RUN_NOT_IN_SAMPLE = Message("the longest failure can't be determined from a sample", INFO)
# inspected windows
WINDOWS_GIVEN = Message(
    "Windows that operators inspected: {count}; with a cause: {causes}; judged visible: {visible}, invisible: "
    "{invisible}. They explain failures and do not change the decision.", INFO)
# layers
NO_LAYERS = Message("No layer of seams is given; choose the layers 'Seams' of one or more scans.")
LAYER_NOT_FOUND = Message("{name} can't be read as a layer of lines; choose the layer 'Seams' of a scan.")
LAYER_WITHOUT_KEPT = Message("{name} has no field 'kept_1'; choose the layer 'Seams' of a scan, not the seamlines.")
LAYER_EMPTY = Message("{name} is empty: no seam of it can be judged.", WARNING)
LAYERS_EMPTY = Message(
    "The layers of seams are empty, or none of their rows is a piece of seam (field 'level'); choose the layers as the "
    "scans wrote them.")
PIECES_WITHOUT_LENGTH = Message("{name}: features without a line are left out ({count}).", WARNING)
PIECES_TWICE = Message(
    "{count} pieces of seam are given twice, the same line with the same figures; they count once.", WARNING)
PLACES_IN = Message("The layers are in degrees; places and lengths are given in {system}.", INFO)
NOT_TRANSFORMED = Message(
    "{name} can't be transformed to the reference system of the first layer; check the systems of both.")
LIMIT_NO_SHARE = Message("{parameter} is {value:g} and has to lie between {least:g} and {most:g}.")
RESULT_NOT_WRITTEN = Message(
    "The layer '{name}' can't be written; choose another folder, and close the file where it is open.")
PICTURES_NOT_WRITTEN = Message(
    "The folder {folder} can't be written ({error}), so the layer of failures has no pictures.")
PICTURES_MISSING = Message(
    "Failures without a picture: {count}; the mosaic does not show them, or can't be read there.", WARNING)
SEAMS_ELSEWHERE_UNKNOWN = Message(
    "Without what a scan with orthoimages found on the ground, seams that are in no row are unknown: {names}.", INFO)
SCAN_PARTLY = Message(
    "Only {share:.0%} of the mosaic of '{name}' were scanned, in its corridor; seams elsewhere are unknown.", INFO)
SCANNED_APART = Message(
    "{count} mosaics were scanned one by one: seams on their borders do not count, where they overlap twice.", WARNING)
SOURCES_BELIEVED = Message(
    "The mosaic was compared with the orthoimages that were given. Detail that these lack too does not count as lost: "
    "make sure that the mosaic was made from them.", INFO)
SEAMS_GIVEN = Message(
    "The scan of '{name}' measured along the seamlines that it was given; a seam that these lack is noticed only if it "
    "is longer than some 150 pixels.", INFO)
SEAMS_FOUND = Message(
    "The scan of '{name}' found the seams from the pixels, without seamlines, and wide feathers hide some of them.",
    WARNING)
PAPER_STOPPED = Message(
    "The run was stopped: there is neither report nor XML, and the failures may have no pictures.", WARNING)
# the files of a delivery; what is found at a sheet goes into tables
NO_DELIVERY = Message("Neither a folder nor sheets are given; choose the folder of the delivery, or its index.")
NO_SHEETS = Message("{folder} holds no rasters and no sheets are given; choose the folder of the delivery.")
CHECK_STOPPED = Message("The check was stopped; nothing is written.", WARNING)
SHEET_FINDING = Message("{sheet}: {finding}.", WARNING)
DELIVERY_CHECKED = Message("Sheets: {count}, with findings: {faulty}, of these without a file: {missing}.", INFO)
MOSAIC_NOT_WRITTEN = Message("{path} can't be written; choose another folder.")
FILE_MISSING = Message("the file is missing", INFO)
FILE_NOT_ORDERED = Message("it was not ordered", INFO)
FILE_WITHOUT_PLACE = Message("the file is not georeferenced", INFO)
NAME_OTHER = Message("its name {name} does not match {pattern}", INFO)
PIXEL_OTHER = Message("its pixels are {pixel:.3g} m instead of {wanted:.3g} m", INFO)
SYSTEM_OTHER = Message("its reference system is {system} instead of {wanted}", INFO)
BANDS_OTHER = Message("it has {bands} bands instead of {wanted}", INFO)
TYPE_OTHER = Message("its pixels are {kind} instead of {wanted}", INFO)
DATA_MISSING = Message("{share:.2%} of its outline has no data", INFO)
SHOWS_OTHERWISE = Message("it does not show the same as {names} where they overlap", INFO)
NOT_IN_MOSAIC = Message("it is not part of the mosaic of all sheets", INFO)
MISSING_UNKNOWN = Message("it is unknown whether it has data everywhere", INFO)
