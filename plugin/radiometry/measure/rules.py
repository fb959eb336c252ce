"""The rules of acceptance: which figures are checked, of which bands, against which limits, and where those come from.

A rules file is JSON (``imagery/documents.py``):

    {"name": "...", "value_range": [0, 4095], "rules": [
        {"check": "contrast", "band": "luminosity", "least": 0.10, "most": 0.20, "source": "..."}, ...]}

``check`` is one of ``CHECKS``. ``band`` is ``luminosity``, ``each`` (also when it is left out) or a band's name; no
band has two rules for one check. ``least`` and ``most`` are limits, both inclusive, and a rule with neither is measured
and not judged. ``required`` (true when left out) says whether an image can be accepted when the figure is not
measurable. ``values`` (clipped_low and clipped_high only, 5 when left out) is how many values count as clipped.
``value_range``, optional, is the lowest and highest value that pixels could have. Shares are fractions of 1.
"""
from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ...imagery.documents import RuleObject, is_number, read_rules, ready_rules
from ...imagery.errors import SettingsError
from ...imagery.limits import COLOURS
from . import messages

if TYPE_CHECKING:
    from ...imagery.rasters import ValueRange

CLIPPED_LOW, CLIPPED_HIGH, PEAK, CONTRAST = "clipped_low", "clipped_high", "peak", "contrast"
SIGNAL_TO_NOISE, COLOUR_BALANCE = "signal_to_noise", "colour_balance"
SEAM_STEP, SEAM_CONTRAST = "seam_step", "seam_contrast"
FROM_HISTOGRAM = (CLIPPED_LOW, CLIPPED_HIGH, PEAK, CONTRAST)
AT_SEAMS = (SEAM_STEP, SEAM_CONTRAST)  # measured only where seamlines are given
CHECKS = (*FROM_HISTOGRAM, SIGNAL_TO_NOISE, COLOUR_BALANCE, *AT_SEAMS)

LUMINOSITY = "luminosity"  # 0.299 R + 0.587 G + 0.114 B; of an image with one band that band
EACH_BAND = "each"
ALL_BANDS = "all"  # the band of a figure that is taken between the bands

# The decision on an image, or on all
ACCEPTED = "accepted"  # every limit is kept, but for figures that are not measurable and not required
REJECTED = "rejected"  # at least one figure is beyond its limit
UNDECIDED = "undecided"  # nothing is beyond its limit, and something that a rule requires is not known

SUBJECT, DEFAULT_RULES = "radiometry", "jrc_lpis"  # the ready files, and the one that counts where none is named

_CLIPPING = (CLIPPED_LOW, CLIPPED_HIGH)
_RULE_KEYS = ("check", "band", "least", "most", "required", "values", "source")
_FILE_KEYS = ("name", "value_range", "rules")
_DEFAULT_VALUES = 5
_OTHER_BAND = re.compile(r"band_[1-9]\d*")


@dataclass(frozen=True)
class Rule:
    check: str  # one of ``CHECKS``
    least: float | None  # smallest value that passes; None for no such limit
    most: float | None  # largest value that passes; None for no such limit
    source: str  # origin of the limits
    values: int = _DEFAULT_VALUES  # how many values at the end of the range count as clipped
    band: str = EACH_BAND  # ``luminosity``, ``each`` or the name of a band; ``all`` for what is taken between the bands
    required: bool = True  # whether an image can't be accepted when the figure is not measurable

    @property
    def has_limit(self) -> bool:
        return self.least is not None or self.most is not None

    def passes(self, value: float) -> bool:
        return (self.least is None or value >= self.least) and (self.most is None or value <= self.most)

    def bands_of(self, names: Sequence[str]) -> Sequence[str]:
        """The figures of an image with these bands that the rule is for; a band that it names need not be there."""
        if self.check == COLOUR_BALANCE:
            return (ALL_BANDS,)
        return names if self.band == EACH_BAND else (self.band,)


@dataclass(frozen=True)
class RuleSet:
    name: str
    rules: tuple[Rule, ...]
    value_range: ValueRange | None = None  # lowest and highest value that pixels could have; None: as the files say


def ready_rule_files() -> dict[str, Path]:
    """The ready files by their names, that of JRC's text first."""
    ready = ready_rules(SUBJECT)
    return {DEFAULT_RULES: ready[DEFAULT_RULES], **ready}


def load_rules(path: Path, worded: Callable[[str], str] = str) -> RuleSet:
    """The rules of a JSON file. Raises SettingsError that says what is wrong with it and where."""
    return read_rules(path, _rule_set, worded)


def _rule_set(whole: RuleObject, objects: Sequence[RuleObject]) -> RuleSet:
    whole.allow(_FILE_KEYS)
    rules: list[Rule] = []
    for item in objects:
        rule = _rule(item)
        for earlier in rules:
            if earlier.check == rule.check and (earlier.band == rule.band or EACH_BAND in _named(earlier, rule)):
                raise SettingsError(
                    messages.RULES_CHECK_TWICE(place=item.place, name=item.file, check=rule.check, band=rule.band)
                )
        rules.append(rule)
    return RuleSet(whole.name(), tuple(rules), _range(whole))


def _named(*rules: Rule) -> set[str]:
    """Bands of the image itself that rules name; luminosity may stand beside each of them."""
    names = {rule.band for rule in rules}
    return set() if LUMINOSITY in names else names


def _rule(item: RuleObject) -> Rule:
    item.allow(_RULE_KEYS)
    check = item.word("check", CHECKS)
    least, most = item.limits()
    if "values" in item.content and check not in _CLIPPING:
        raise SettingsError(messages.RULES_VALUES_UNUSED(place=item.place, name=item.file))
    values = item.whole("values", _DEFAULT_VALUES)
    return Rule(check, least, most, item.source(), values, _band(item, check), item.flag("required", True))


def _band(item: RuleObject, check: str) -> str:
    if check == COLOUR_BALANCE:
        if "band" in item.content:
            raise SettingsError(messages.RULES_BAND_UNUSED(place=item.place, name=item.file, check=check))
        return ALL_BANDS
    band = item.content.get("band", EACH_BAND)
    known = (LUMINOSITY, EACH_BAND, *COLOURS, "nir")
    if not isinstance(band, str) or not (band in known or _OTHER_BAND.fullmatch(band)):
        raise SettingsError(messages.RULES_BAND_BAD(place=item.place, name=item.file))
    return band


def _range(whole: RuleObject) -> ValueRange | None:
    content: Any = whole.content.get("value_range")
    if content is None:
        return None
    if isinstance(content, list) and len(content) == 2 and all(map(is_number, content)) and content[0] < content[1]:
        return float(content[0]), float(content[1])
    raise SettingsError(messages.RULES_RANGE_BAD(place=whole.place, name=whole.file))
