"""The process that plays cases: reads their texts from standard input, writes a report of each as a line of JSON."""
from __future__ import annotations

import ctypes
import faulthandler
import gc
import json
import os
import re
import resource
import shutil
import signal
import sys
import time
import traceback
from dataclasses import asdict
from pathlib import Path
from typing import Any, TextIO

import matplotlib.font_manager  # noqa: F401 - lists the fonts now, and says so
from osgeo import gdal
from qgis.core import QgsApplication, QgsProject
from seam_inspector.plugin.provider import SeamInspectorProvider

from fuzz.calls import MODELS
from fuzz.cases import NOTHING, Case, grows, kinds, values_of
from fuzz.judging import MOST_BYTES, UNBROKEN, Report, judged
from fuzz.running import READERS, Outcome, outputs, run
from fuzz.samples import make_samples
from fuzz.watching import differences, forget, state_of

SAID = "said.txt"
MOST_ADDRESSES = 12 * 2**30
"""Far more than what is used: only what would fall on the whole machine at once ends here."""
LONG_SECONDS = 0.5
"""Time of the processor: what takes less tells nothing of how it grows."""
MOST_GROWTH = 3.0
"""Times the time, for twice the bytes."""
_DIES_WITH_PARENT = 1  # PR_SET_PDEATHSIG
_KEPT_BY_QGIS = re.compile(r"^(made|changed) .*\.aux\.xml$|^changed .*\.vrt$")
"""Statistics, by which it stretches a raster: GDAL keeps them beside it, those of a VRT in the VRT."""
_KEPT_BY_DESK = re.compile(r"\.scan(/.*)?$")
"""Records, which are a scan's own."""
_SAID_BY_QGIS = re.compile(
    r"Unable to load mesh|Creating Warped VRT|Warped VRT Creation failed|already exists in ZIP file"
    r"|Failed to open \S+ to write|Unable to save auxiliary information"
    r"|^HDF5-DIAG: |^  #\d{3}: \.\./.*\.c line \d+ in H5|^, filename = '.*', file descriptor = |^    (major|minor): "
)
"""A file that is no raster is tried as a mesh, by HDF5 too, one that is rotated is warped, and to a VRT in an archive,
or where nothing can be written, statistics are to be added, all aloud."""


class Player:
    """Plays cases in a folder of its own."""

    def __init__(self, samples: Path, folder: Path) -> None:
        self.samples, self.folder = samples, folder
        self._here, self._outside = folder / "here", folder / "outside"
        for one in (self._here, self._outside, folder / "played"):
            one.mkdir(parents=True, exist_ok=True)
        os.chdir(self._here)
        (self._outside / "secret.txt").write_text("THE-SECRET\n")
        self._count = 0

    def play(self, case: Case) -> Report:
        """One case; its folder is left where something was found."""
        self._count += 1
        folder = self.folder / "played" / str(self._count)
        inputs, results = folder / "in", folder / "out"
        inputs.mkdir(parents=True)
        results.mkdir()
        said = open(folder / SAID, "w+b")  # noqa: SIM115 - stands for stdout and stderr, also when the process dies
        os.dup2(said.fileno(), 1)
        os.dup2(said.fileno(), 2)
        try:
            with gdal_quiet():
                values = values_of(case, self.samples, inputs, self._outside / "secret.txt")
        except Exception:  # such as a document that is no layer, which can't be broken as one
            shutil.rmtree(folder, ignore_errors=True)
            return Report(str(case), UNBROKEN)
        watched = (self.samples, inputs, self._here, self._outside)
        before = state_of(watched)
        _forget_peak()
        start, worked = time.monotonic(), time.process_time()
        chosen = {**outputs(case.algorithm, results), **values}
        outcome = self._outcome(case, chosen)
        worked = time.process_time() - worked
        sys.stdout.flush()
        sys.stderr.flush()
        report = Report(str(case), "refused" if outcome.refusal else "ran" if outcome.worked else "failed")
        report.seconds, report.peak_bytes = time.monotonic() - start, _peak()
        report.stderr = (folder / SAID).read_text(errors="replace")
        report.said = outcome.said
        changed = differences(before, state_of(watched))
        changed, report.stderr = _of_ours(case.algorithm, changed, report.stderr)
        report.findings = judged(outcome, report.stderr) + changed
        if grows(case) and worked > LONG_SECONDS:
            report.findings += self._growth(case, folder, worked)
        if report.peak_bytes > MOST_BYTES:
            report.findings.append(f"took {report.peak_bytes / 2**30:.1f} GB")
        if case.parameter == NOTHING and not outcome.worked:
            report.findings.append("a sound call did not run")
        left = [name for name in gdal.ReadDirRecursive("/vsimem/") or [] if not name.endswith("/")]
        if left:
            report.findings.append(f"left in memory: {left[:3]}")
            for name in left:
                gdal.Unlink("/vsimem/" + name)
        if any("THE-SECRET" in one for one in outcome.said) or _holds_secret(results):
            report.findings.append("read a file that an input names into a result")
        said.close()
        if not report.findings:
            shutil.rmtree(folder, ignore_errors=True)
        forget(folder)
        QgsProject.instance().clear()
        gc.collect()
        return report

    def _growth(self, case: Case, folder: Path, worked: float) -> list[str]:
        """Findings with twice the bytes: the run may take longer, but not by more than that."""
        with gdal_quiet():
            values = values_of(case, self.samples, folder / "twice", self._outside / "secret.txt", scale=2)
        (folder / "out twice").mkdir()
        start = time.process_time()
        self._outcome(case, {**outputs(case.algorithm, folder / "out twice"), **values})
        again = time.process_time() - start
        return [f"twice the bytes took {again / worked:.1f} times as long ({worked:.2f} s)"] if (
            again > MOST_GROWTH * worked
        ) else []

    @staticmethod
    def _outcome(case: Case, values: dict[str, Any]) -> Outcome:
        try:
            return run(case.algorithm, values, checked=case.seed % 4 != 3)  # the others as a step of a model
        except Exception:  # whatever it is, it is what is looked for
            return Outcome(False, errors=[traceback.format_exc()])


def _of_ours(algorithm: str, changed: list[str], said: str) -> tuple[list[str], str]:
    """What changed and was said that is not QGIS's own doing, or the desk's."""
    if algorithm in READERS:  # QGIS tells aloud what it can't read of a project
        return [one for one in changed if not _KEPT_BY_DESK.search(one)], ""
    if algorithm in MODELS:
        lines = (line for line in said.splitlines() if not _SAID_BY_QGIS.search(line))
        return [one for one in changed if not _KEPT_BY_QGIS.search(one)], "\n".join(lines)
    return changed, said


class gdal_quiet:  # noqa: N801 - used as a function
    """Nothing of GDAL's on stderr while files are broken: that is ours, not the product's."""

    def __enter__(self) -> None:
        gdal.PushErrorHandler("CPLQuietErrorHandler")

    def __exit__(self, *raised: object) -> None:
        gdal.PopErrorHandler()
        gdal.ErrorReset()


def _forget_peak() -> None:
    Path("/proc/self/clear_refs").write_text("5")


def _peak() -> int:
    status = Path("/proc/self/status").read_text()
    return 1024 * int(status.split("VmHWM:")[1].split()[0])


def _holds_secret(folder: Path) -> bool:
    return any(b"THE-SECRET" in path.read_bytes() for path in folder.rglob("*")
               if path.is_file() and path.stat().st_size < 2**22)


def _bind(parent: int) -> None:
    """To the process that asks, without which nobody would stop this one, and to what the machine can spare."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(_DIES_WITH_PARENT, signal.SIGKILL)
    if os.getppid() != parent:  # it ended before
        sys.exit(1)
    resource.setrlimit(resource.RLIMIT_AS, (MOST_ADDRESSES, MOST_ADDRESSES))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def main() -> None:
    samples, folder = Path(sys.argv[1]), Path(sys.argv[2])
    _bind(int(sys.argv[3]))
    answers: TextIO = os.fdopen(os.dup(1), "w", buffering=1)
    os.dup2(2, 1)
    faulthandler.enable()
    faulthandler.register(signal.SIGUSR1, all_threads=True)
    application = QgsApplication([], False)
    application.initQgis()
    provider = SeamInspectorProvider()
    QgsApplication.processingRegistry().addProvider(provider)
    if not samples.is_dir():
        with gdal_quiet():
            made = samples.with_name("samples being made")
            shutil.rmtree(made, ignore_errors=True)
            make_samples(made)
            made.rename(samples)
    player = Player(Path(shutil.copytree(samples, folder / "samples")), folder)
    answers.write(json.dumps([str(case) for case in kinds()]) + "\n")
    gc.collect()
    gc.freeze()  # what stays is not looked through after each case
    for line in sys.stdin:
        answers.write(json.dumps(asdict(player.play(Case.of(line.strip())))) + "\n")
    application.exitQgis()


if __name__ == "__main__":
    main()
