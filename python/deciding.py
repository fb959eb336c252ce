"""The decision on scans, by the plugin's rules."""
from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from dataclasses import replace

from ..plugin.acceptance.measure import deciding
from ..plugin.acceptance.measure.acceptance_rules import AcceptanceRules
from ..plugin.acceptance.measure.decision import Decision
from ..plugin.acceptance.measure.delivered_rows import make_delivery
from ..plugin.acceptance.measure.scanned_files import file_doubts
from ..plugin.imagery.errors import SettingsError
from ..plugin.imagery.limits import PATH_TYPES, check_type
from ..plugin.imagery.reference_systems import same_system
from ..plugin.seams.measure.scan.scan_result import ScanResult, seam_rows
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
        By the name of each sheet what ``scan`` found in it, or the GeoPackage that holds that, which has to be as the
        scan left it; all in one reference system. One without any seam counts for nothing beside others.
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
    sheets = {str(name): sheet for name, sheet in sheets.items()}
    for name, sheet in sheets.items():
        check_type(f"sheets[{name!r}]", sheet, ScanResult, *PATH_TYPES)
    files = {name: os.fspath(sheet) for name, sheet in sheets.items() if not isinstance(sheet, ScanResult)}
    tables = {
        name: (seam_rows(sheet), dict(sheet.told)) if isinstance(sheet, ScanResult) else read_seams(sheet)
        for name, sheet in sheets.items()
    }
    rows = {name: table for name, (table, _) in tables.items()}
    notes = {name: beside for name, (_, beside) in tables.items()}
    first, wkt = next(((name, table.wkt) for name, table in rows.items()), ("", ""))
    for name, table in rows.items():
        if not same_system(table.wkt, wkt):
            raise SettingsError(messages.NOT_IN_ONE_SYSTEM(name=name, first=first))
    if not any(rows.values()):
        raise NoSeamsError(messages.NO_SEAM_TO_DECIDE_ON())
    delivery = make_delivery(rows, wkt, notes, files)
    doubts = file_doubts(delivery, paths_of("mosaics", mosaics), ())
    return deciding.decide(replace(delivery, files=doubts), rules, lot_size or None, seed)
