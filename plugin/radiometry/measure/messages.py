"""What a user can be told of radiometry: of a file with rules, and why a rule could not be checked."""
from __future__ import annotations

from ...imagery.message import INFO, WARNING, Message

# a file with rules
RULES_NOT_READABLE = Message("The rules in {name} can't be read ({error}); give a JSON file with rules.")
RULES_NOT_JSON = Message("The rules in {name} are no JSON (line {line}: {error}); mend the file.")
RULES_NO_OBJECT = Message('{name} holds no rules; it has to be an object {{"name": ..., "rules": [...]}}.')
RULES_KEY_UNKNOWN = Message("{place} in {name} has the unknown key '{key}'; known are {known}.")
RULES_CHECK_UNKNOWN = Message("{place} in {name} names the unknown check '{check}'; known are {known}.")
RULES_CHECK_TWICE = Message("{name} has two rules for '{check}'; leave one.")
RULES_LIMIT_BAD = Message("{place} in {name}: '{key}' has to be a number of 0 or more.")
RULES_LIMITS_CROSSED = Message("{place} in {name}: 'least' is larger than 'most'.")
RULES_VALUES_BAD = Message("{place} in {name}: 'values' has to be a whole number of 1 or more.")
RULES_VALUES_UNUSED = Message("{place} in {name}: 'values' belongs to clipped_low and clipped_high only.")
RULES_SOURCE_MISSING = Message("{place} in {name} has no 'source'; say in words where the limit comes from.")
RULES_RANGE_BAD = Message("'value_range' in {name} has to be two numbers, the smaller one first.")
RULE_PLACE = Message("Rule {number}", INFO)
RULES_PLACE = Message("The object", INFO)
# why a rule could not be checked, and what was assumed to check it
NOT_MEASURABLE = Message("not measurable: {why}", INFO)
TOO_FEW_VALID_PIXELS = Message("{count} pixels are valid and at least {least} are needed; choose a larger part.", INFO)
NO_VALUE_RANGE = Message(
    "values of type {data_type} have no range of their own; give 'value_range' in the rules file.", INFO
)
NO_UNIFORM_AREA = Message(
    "fewer than {least} uniform mid-tone areas of {side} x {side} px were found; draw windows on such "
    "areas.", INFO
)
NO_NOISE_AT_ALL = Message(
    "the uniform areas do not vary at all; a photograph would, so check how the image was made.", INFO
)
NO_NEUTRAL_AREA = Message(
    "fewer than {least} uniform areas whose bands differ by less than {most:.0%} of the range were found; draw windows "
    "on grey surfaces.", INFO
)
NO_COLOURS = Message("it has no red, green and blue.", INFO)
NO_SEAM_HERE = Message("no seam runs across valid pixels of it for {pixels} px or more.", INFO)
NO_LIMIT = Message("The rules set no limit; give one in the rules file.", INFO)
RANGE_ASSUMED = Message(
    "{name}: the largest value is {largest}, so the range is taken as {low:g} to {high:g}; if it is another, give "
    "'value_range' in the rules file.", WARNING
)
