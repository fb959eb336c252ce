"""`seam-inspector`: scan, inspect, accept and mend mosaics from a shell, without QGIS."""
from __future__ import annotations

import argparse
import csv
import io
import logging
import os
import re
import signal
import sys
import traceback
import warnings
from collections.abc import Sequence
from pathlib import Path
from threading import Event
from typing import Any, NoReturn, TextIO

from ..plugin.acceptance.measure.acceptance_rules import CHECKS, AcceptanceRules, limit_rules, load_acceptance_rules
from ..plugin.acceptance.measure.decision import AcceptanceOutcome, Decision
from ..plugin.imagery.atomic_files import save_text
from ..plugin.imagery.documents import plugin_version
from ..plugin.imagery.errors import SeamInspectorError, SeamInspectorWarning
from ..plugin.imagery.limits import DEFAULT_LEVELS
from ..plugin.seams.measure.blocks.block_grid import ScanSettings
from ..plugin.seams.measure.judgement.verdicts import Verdict
from ..plugin.seams.measure.limits import DENSITIES, FAILED, MENDED_SEAMS, STANDARD_PIECE_M
from ..plugin.seams.measure.mending.mend_run import MendSettings
from ..plugin.seams.measure.mending.mending import LEFT, metres
from ..plugin.seams.measure.window.inspection import Block, open_block
from ..plugin.seams.measure.window.measured_window import InspectionSettings
from ..plugin.seams.measure.window.window_tables import window_rows
from .deciding import NoSeamsError, decide
from .measuring import inspect_windows, mend, scan
from .outputs import GEOPACKAGE, GEOTIFF, PAGE, TABLE, check_writing
from .report_page import save_report
from .scan_files import write_scan
from .start import ERROR

ACCEPTED, REJECTED, UNDECIDED = 0, 1, 2  # exit codes, beside ERROR
_CODES = dict(zip(AcceptanceOutcome, (ACCEPTED, REJECTED, UNDECIDED)))
_DECISIONS = "0 accepted; 1 rejected; 2 undecided; 3 error"
_VERDICTS = "0 no loss is significant; 1 a loss is significant; 2 none is, and a window can't be compared; 3 error"
_CUTS = "0 all wanted seams are cut anew; 1 some stay as they were; 3 error"
# argparse takes it for an option unless a space goes before
_EXPONENT = re.compile(r"^-[\d.]+e[+-]?\d+$", re.IGNORECASE)
_LIMITS = ("min_kept", "max_share", "max_run_m", "min_measured")
"""Arguments of ``limit_rules``, in the order of ``CHECKS``."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command, and give its exit code."""
    parser = _parser()
    words = sys.argv[1:] if arguments is None else arguments
    asked = parser.parse_args([_EXPONENT.sub(r" \g<0>", word) for word in words])
    if getattr(asked, "rules", "") and any(getattr(asked, name) is not None for name in _LIMITS):
        parser.error("the file of --rules holds all limits; leave out --min-kept and those beside it")
    stopped = Event()
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda *_: stopped.set())
    logging.basicConfig(format="%(message)s", level=logging.ERROR if asked.quiet else logging.WARNING)
    shown = _shown if sys.stderr.isatty() and not asked.quiet else None
    asked.run = {"executor": asked.scheduler or None, "progress": shown, "cancelled": stopped.is_set}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore" if asked.quiet else "always", SeamInspectorWarning)
        warnings.showwarning = lambda message, *_, **__: _say(str(message))
        code = ERROR
        try:
            code = int(asked.command(asked))
        except NoSeamsError as error:
            code = UNDECIDED
            _say(f"Undecided. {error}", sys.stdout)
        except SeamInspectorError as error:
            _say(f"seam-inspector: {error}")
        except Exception:  # any other exit code than 3 would be a decision
            _say(traceback.format_exc())
        _say("", end="")  # what the log could not write
    return code


def _block(asked: argparse.Namespace) -> Block:
    beside = getattr(asked, "neighbours", None) or ()
    return open_block(asked.mosaic, asked.sources, keep_copies=asked.keep_copies, crs=asked.crs, neighbours=beside)


def _scan(asked: argparse.Namespace) -> int:
    block, rules = _block(asked), _rules(asked)
    settings = ScanSettings(density=asked.density, piece_m=asked.piece, levels=asked.levels)
    _check_outputs(asked, block.paths)
    result = scan(block, settings, seamlines=asked.seamlines, loss=asked.loss or "", **asked.run)
    write_scan(asked.output, result, block)
    return _decided(asked, decide({Path(asked.mosaic).stem: asked.output}, rules, mosaics=[asked.mosaic]))


def _accept(asked: argparse.Namespace) -> int:
    stems = [Path(path).stem for path in asked.seams]
    sheets = {path if stems.count(stem) > 1 else stem: path for path, stem in zip(asked.seams, stems)}
    _check_outputs(asked, (*asked.seams, *asked.mosaics))
    return _decided(asked, decide(
        sheets, _rules(asked), mosaics=asked.mosaics, lot_size=asked.lot_size, seed=asked.seed
    ))


def _inspect(asked: argparse.Namespace) -> int:
    block = _block(asked)
    settings = InspectionSettings(min_kept=asked.min_kept, levels=asked.levels)
    requests = [block.window_at(x, y, asked.side, settings, number) for number, (x, y) in enumerate(asked.at, 1)]
    _check_outputs(asked, block.paths)
    results = list(inspect_windows(requests, **asked.run))
    rows = window_rows(results)
    if asked.output:
        text = io.StringIO()
        table = csv.DictWriter(text, list(rows[0]))
        table.writeheader()
        table.writerows(rows)
        save_text(text.getvalue(), Path(asked.output))
    for row in rows:
        numbers = [row[name] for name in ("kept_1", "kept_low", "kept_high")]
        why = row["reason"] or row["causes"]
        kept = "" if None in numbers else ", {:.2f} kept ({:.2f} to {:.2f})".format(*numbers)
        _say(f"{row['window_id']}: {row['verdict']}{kept}{f': {why}' if why else ''}", sys.stdout)
    verdicts = {result.judgement.verdict for result in results}
    if Verdict.SIGNIFICANT in verdicts:
        return REJECTED
    return UNDECIDED if Verdict.NOT_COMPARABLE in verdicts else ACCEPTED


def _mend(asked: argparse.Namespace) -> int:
    block = _block(asked)
    settings = MendSettings(asked.width, asked.blend)
    made = mend(block, asked.seams, asked.output, settings, patches=asked.patches, which=asked.which, **asked.run)
    left = metres(made, LEFT)
    _say(f"{metres(made) - left:.1f} m mended, {left:.1f} m left as they were: {asked.output}", sys.stdout)
    for seam in made:
        if seam.reason is not None:
            _say(f"seam {seam.run.piece.seam_id}, {seam.run.piece.station_m:.0f} m: {seam.reason}", sys.stdout)
    return REJECTED if left else ACCEPTED


def _decided(asked: argparse.Namespace, decision: Decision) -> int:
    for sentence in decision.sentences:
        _say(sentence, sys.stdout)
    if asked.report:
        save_report(Path(asked.report), decision)
    return _CODES[decision.outcome]


def _rules(asked: argparse.Namespace) -> AcceptanceRules:
    if asked.rules:
        return load_acceptance_rules(asked.rules)
    return limit_rules(**{name: value for name in _LIMITS if (value := getattr(asked, name)) is not None})


def _check_outputs(asked: argparse.Namespace, inputs: Sequence[str]) -> None:
    """Raise SettingsError for outputs whose names can't be, or that are over an input, before anything is measured."""
    given = (getattr(asked, name, "") for name in ("seamlines", "rules"))
    endings = {"output": TABLE if asked.command is _inspect else GEOPACKAGE, "loss": GEOTIFF, "report": PAGE}
    outputs = {name: (getattr(asked, name, None), ending) for name, ending in endings.items()}
    wanted = {name: (path, ending) for name, (path, ending) in outputs.items() if path is not None}
    check_writing(wanted, (*inputs, *filter(None, given)))


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        """A command that is wrong is an error: argparse would end with what means undecided here."""
        self.print_usage(sys.stderr)
        self.exit(ERROR, f"{self.prog}: {message}\n")


def _parser() -> argparse.ArgumentParser:
    words = "Measure the detail that a mosaic lost along its seams."
    parser = _Parser("seam-inspector", description=words, epilog="COMMAND --help tells options and exit codes.")
    parser.add_argument("--version", action="version", version=plugin_version())
    commands = parser.add_subparsers(metavar="COMMAND", required=True)

    def command(name: str, call: Any, words: str, codes: str = _DECISIONS, is_measuring: bool = True) -> _Parser:
        made = commands.add_parser(name, help=words, description=words, epilog=f"Exit codes: {codes}.")
        made.set_defaults(command=call, scheduler="")
        made.add_argument("-q", "--quiet", action="store_true", help="tell nothing but the result and errors")
        if is_measuring:
            made.add_argument("mosaic", metavar="MOSAIC")
            made.add_argument("sources", metavar="SOURCE", nargs="*", default=(), help="its orthoimages")
            made.add_argument("--scheduler", default="", help="address of a Dask scheduler, as tcp://host:8786")
            made.add_argument("--crs", default="", help="reference system of all rasters, as EPSG:2180")
            made.add_argument("--keep-copies", action="store_true", help="use sources that look like copies")
        return made

    def add_reach(parser: argparse.ArgumentParser) -> None:
        beside = "sheets beside MOSAIC that are looked at along the border; MOSAIC may be among them"
        parser.add_argument("--neighbour", action="extend", nargs="+", dest="neighbours", metavar="SHEET", help=beside)
        parser.add_argument("--levels", type=int, default=DEFAULT_LEVELS, metavar="COUNT", help="of the decomposition")

    scanning = command("scan", _scan, "Scan a mosaic and decide on it.")
    scanning.add_argument("-o", "--output", required=True, help="GeoPackage for what is found")
    scanning.add_argument("--seamlines", default="", help="vector file of seams; else they are found")
    scanning.add_argument("--loss", help="GeoTIFF of losses; a scan that was stopped goes on by it")
    scanning.add_argument("--density", choices=DENSITIES, default=DENSITIES[0])
    scanning.add_argument("--piece", type=float, default=STANDARD_PIECE_M, metavar="METRES", help="of a piece of seam")
    add_reach(scanning)
    _add_limits(scanning)
    window, middle = command("inspect", _inspect, "Inspect windows.", _VERDICTS), "a window's middle, once for each"
    window.add_argument("--at", nargs=2, type=float, action="append", required=True, metavar=("X", "Y"), help=middle)
    window.add_argument("--side", type=float, default=100.0, metavar="METRES", help="the least side of a window")
    window.add_argument("--min-kept", type=float, default=InspectionSettings().min_kept, help="share to be kept")
    add_reach(window)
    window.add_argument("-o", "--output", help="CSV for the table of windows")
    accepting = command("accept", _accept, "Decide on what scans left.", is_measuring=False)
    accepting.add_argument("seams", metavar="SEAMS", nargs="+", help="GeoPackages of scans, a sheet each")
    accepting.add_argument("--mosaic", action="extend", nargs="+", default=[], dest="mosaics", help="delivered files")
    accepting.add_argument("--lot-size", type=int, metavar="PIECES", help="of the whole lot, where a sample decides")
    accepting.add_argument("--seed", type=int, default=0, metavar="NUMBER", help="of the sample that is drawn")
    _add_limits(accepting)
    mending = command("mend", _mend, "Cut failed seams anew.", _CUTS)
    mending.add_argument("--seams", required=True, help="GeoPackage of the scan")
    mending.add_argument("-o", "--output", required=True, help="VRT for the mended mosaic")
    mending.add_argument("--patches", default="", help="folder for the patches")
    mending.add_argument("--which", choices=MENDED_SEAMS, default=FAILED)
    cut, beside = MendSettings(), "on either side of a seam, that its new cut may move"
    mending.add_argument("--width", type=float, default=cut.width_m, metavar="METRES", help=beside)
    mending.add_argument("--blend", type=int, default=cut.blend_px, metavar="PIXELS", help="mixed at the new cut")
    return parser


def _add_limits(parser: argparse.ArgumentParser) -> None:
    standard = limit_rules()
    parser.add_argument("--report", help="page of HTML for the decision")
    parser.add_argument("--rules", default="", help="JSON file of rules, in the place of the limits below")
    usual = standard.least_kept, *map(standard.limit, CHECKS[1 : len(_LIMITS)])
    for name, value, unit in zip(_LIMITS, usual, ("SHARE", "SHARE", "METRES", "SHARE")):
        option = "--" + name.removesuffix("_m").replace("_", "-")
        parser.add_argument(option, dest=name, type=float, metavar=unit, help=f"{value:g} unless given")


def _shown(share: float) -> None:
    _say(f"\r{share:4.0%}", end="\n" if share >= 1 else "")


def _say(words: object, file: TextIO | None = None, end: str = "\n") -> None:
    """To standard error, or another file. A reader who has gone, as ``head``, changes nothing of what is decided."""
    file = file or sys.stderr
    try:
        print(words, end=end, file=file, flush=True)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), file.fileno())


if __name__ == "__main__":
    sys.exit(main())
