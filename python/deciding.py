"""The decision on scans, by the plugin's rules."""
from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

from ..plugin.acceptance.measure import deciding
from ..plugin.acceptance.measure.acceptance_rules import AcceptanceRules
from ..plugin.acceptance.measure.decision import Decision
from ..plugin.acceptance.measure.delivered_rows import make_delivery
from ..plugin.acceptance.measure.scanned_files import file_doubts
from ..plugin.imagery.errors import SettingsError
from ..plugin.imagery.limits import PATH_TYPES, check_type
from ..plugin.imagery.records import TableRows
from ..plugin.imagery.reference_systems import same_system
from ..plugin.seams.measure.scan.scan_result import ScanResult
from ..plugin.seams.measure.window.inspection import PathLike, paths_of
from . import messages
from .scan_files import read_seams


class NoSeamsError(SettingsError):
    """No sheet has a seam, so that there is nothing to decide on."""


def decide(
    sheets: Mapping[str, ScanResult | PathLike], rules: AcceptanceRules, *, mosaics: Iterable[PathLike] = (),
    lot_size: int | None = None, seed: int = 0,
) -> Decision:
    """Accept a delivery, reject it, or say what would decide it.

    Parameters
    ----------
    sheets : mapping
        By the name of each sheet what ``scan`` found in it, or the GeoPackage that holds that, as for ``mend``, which
        has to be as the scan left it; all in one reference system. One without any seam counts for nothing beside
        others.
    rules : AcceptanceRules
        Of ``limit_rules`` or ``load_acceptance_rules``.
    mosaics : iterable of paths, optional
        The files that are delivered; where others were scanned nothing is decided.
    lot_size : int, optional
        Pieces of the whole lot, for rules with a plan of sampling; None or 0: those that are given.
    seed : int
        Of the sample that is drawn then.

    What is left out or doubtful is told by a SeamInspectorWarning each. Raises SettingsError for a delivery without
    any seams, sheets in different systems, a file that holds no scan, or a lot size that can't be or without a plan.
    """
    check_type("sheets", sheets, Mapping)
    check_type("rules", rules, AcceptanceRules)
    check_type("lot_size", lot_size or 0, int)
    check_type("seed", seed, int)
    if (lot_size or seed) and rules.sampling is None:
        raise SettingsError(messages.LOT_WITHOUT_PLAN(rules=rules.name))
    rows: dict[str, TableRows] = {}
    notes: dict[str, Mapping[str, str]] = {}
    for name, sheet in zip(map(str, sheets), sheets.values()):
        check_type(f"sheets[{name!r}]", sheet, ScanResult, *PATH_TYPES)
        rows[name], notes[name] = read_seams(sheet)
        first, wkt = next((other, table.wkt) for other, table in rows.items())
        if not same_system(rows[name].wkt, wkt):
            raise SettingsError(messages.NOT_IN_ONE_SYSTEM(name=name, first=first))
    if not any(rows.values()):
        raise NoSeamsError(messages.NO_SEAM_TO_DECIDE_ON())
    files = [str(name) for name, sheet in sheets.items() if not isinstance(sheet, ScanResult)]
    delivery = make_delivery(rows, wkt, notes, files)
    doubts = file_doubts(delivery, paths_of("mosaics", mosaics), ())
    return deciding.decide(replace(delivery, files=doubts), rules, lot_size or None, seed)
