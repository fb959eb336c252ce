"""What of a run is a finding."""
from __future__ import annotations

import re
from dataclasses import dataclass, field

from fuzz.running import Outcome

UNBROKEN = "unbroken"
"""How a case ends whose file its breakage can do nothing with."""
MOST_BYTES = 2 * 2**30
OF_QGIS = (
    "Could not load source layer for", "Could not create destination layer for", "Incorrect parameter value for",
    "No parameter value for", "Could not write feature", "Error encountered while running",
)  # fmt: skip
"""How sentences of QGIS's own begin."""
_LEAKED = re.compile(
    r"Traceback|ERROR \d|Warning \d:|libtiff|TIFF[A-Z]\w+:|PROJ:|proj_\w+:|<class |object at 0x|Segmentation"
    r"|Fatal Python|RuntimeWarning|DeprecationWarning|UserWarning"
)
_HARMLESS = re.compile(r"^QStandardPaths: |^propagateSizeHints|^\s*$")


@dataclass
class Report:
    """How a case ended."""

    case: str
    ended: str
    """refused, failed, ran, unbroken, crashed, hung or too much memory."""
    findings: list[str] = field(default_factory=list)
    said: list[str] = field(default_factory=list)
    stderr: str = ""
    peak_bytes: int = 0
    seconds: float = 0.0


def is_sentence(text: str) -> bool:
    """Whether a text is something for the user to read: a whole sentence, or one of QGIS's."""
    text = text.strip()
    return text.startswith(OF_QGIS) or ("\n" not in text and text.endswith((".", ".)")))  # QGIS repeats any name


def judged(outcome: Outcome, stderr: str) -> list[str]:
    """What is wrong with what a run said."""
    found = []
    if outcome.refusal and not is_sentence(outcome.refusal):
        found.append(f"refused without a sentence: {outcome.refusal[-300:]}")
    if not outcome.worked and not outcome.refusal and not outcome.errors:
        found.append("failed without a word")
    for error in outcome.errors:
        if not is_sentence(error):
            found.append(f"an error that is no sentence: {error[-300:]}")
    found += [f"leaked into the log: {one[-300:]}" for one in outcome.said if _LEAKED.search(one)]
    lines = [line for line in stderr.splitlines() if not _HARMLESS.search(line)]
    if lines:
        found.append(f"leaked into stderr: {' / '.join(lines)[-400:]}")
    return found


def kind_of(finding: str) -> str:
    """Kind of a finding, the same for those that are alike: without numbers, names of files and quoted words."""
    text = re.sub(r"'[^']*'|\"[^\"]*\"|/\S+|\S+\.(tif|vrt|gpkg|csv|json|xml|jpg|shp|zip)\b", "*", finding)
    return re.sub(r"\d+", "#", text)[:160]
