"""Messages on radiometry: the file with rules, and why a rule could not be checked."""
from __future__ import annotations

from ...imagery.errors import INFO, WARNING, Message

# a file with rules
RULES_CHECK_TWICE = Message("{place} in {name}: '{check}' of {band} already has a rule; keep one.")
RULES_VALUES_UNUSED = Message("{place} in {name}: 'values' belongs to clipped_low and clipped_high only.")
RULES_BAND_UNUSED = Message("{place} in {name}: '{check}' compares red, green and blue, so it has no 'band'.")
RULES_BAND_BAD = Message(
    "{place} in {name}: 'band' has to be luminosity, each, or the name of a band such as red, nir or band_4.")
RULES_RANGE_BAD = Message("{place} in {name}: 'value_range' has to be two numbers, the smaller one first.")
VALUE_RANGE_BAD = Message("The range of values has to be two numbers, the smaller one first, such as 0,4095.")
SHEETS_WITHOUT_FILES = Message(
    "{name} has no field '{field}'; give the sheets that 'Check a delivery' wrote, or an index that gdaltindex made.")
# why a rule could not be checked, and what was assumed to check it
NOT_MEASURABLE = Message("not measurable: {why}", INFO)
TOO_FEW_VALID_PIXELS = Message("{count} pixels are valid and at least {least} are needed; choose a larger part.", INFO)
NO_VALUE_RANGE = Message(
    "values of type {data_type} have no fixed range; give the range of values, or 'value_range' in the rules "
    "file.", INFO)
RANGE_UNKNOWN = Message(
    "the files do not say how many bits their values have. The largest value of all such images ({count}) is "
    "{largest}, so {possible} bits are possible. Give the range of values, as 0 to 4095 for 12 bits, or 'value_range' "
    "in the rules file.", INFO)
RANGE_CONTRADICTED = Message(
    "the file says that its values have {bits} bits, but holds values up to {largest}; give the range of values, or "
    "'value_range' in the rules file.", INFO)
NO_UNIFORM_AREA = Message(
    "fewer than {least} uniform mid-tone areas of {side} x {side} px were found; draw windows on such "
    "areas.", INFO)
NO_NOISE_AT_ALL = Message(
    "the uniform areas do not vary at all; a photograph would, so check how the image was made.", INFO)
NO_GREY_AREAS = Message(
    "no grey areas are given, and none that may be grey were found; draw roads or roofs and give them as grey areas.",
    INFO)
GREY_AREAS_UNSEEN = Message(
    "no grey areas are given. {count} areas of 16 px that may be grey were found ({share:.1%} of those looked at, near "
    "{x:.1f}, {y:.1f}); their red, green and blue differ by {difference:.1%}, which may be a cast or the colour of the "
    "ground. Look at them and give those that are grey.", INFO)
GREY_AREAS_UNUSABLE = Message(
    "the grey areas show fewer than {least} valid pixels of it that are neither too dark nor too bright; draw more.",
    INFO)
NO_COLOURS = Message("it has no red, green and blue.", INFO)
NO_LUMINOSITY = Message("it has no red, green and blue to mix; name one of its bands in the rules.", INFO)
NO_SUCH_BAND = Message("it has no band {band}.", INFO)
NO_SEAM_HERE = Message("no seam runs across valid pixels of it for {pixels} px or more.", INFO)
NO_LIMIT = Message("The rules set no limit; give one in the rules file.", INFO)
# about an image as a whole
NOT_JUDGED = Message("{name}: what depends on the range of values is not judged: {why}", WARNING)
BEYOND_RANGE = Message(
    "{name}: {share:.2%} of the pixels lie beyond the range of {low:g} to {high:g} that was given, and count as "
    "clipped; check the range.", WARNING)
HISTOGRAMS_OF_SOME = Message(
    "Histograms of {drawn} of the {count} images are drawn, those of images that are not accepted first.", INFO)
# where a figure comes from
SEAM = Message("seam {number}", INFO)
SEAM_OF_FEATURES = Message("seam {number} (feature {features} of {layer})", INFO)
GREYEST_NOT = Message("grey area {area} with {share:.1%}, the most of all", INFO)
