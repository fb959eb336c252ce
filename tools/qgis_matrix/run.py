"""Runs the tests on every QGIS: this machine's, and those of other Debians, each in a chroot. `make test-matrix`."""
from __future__ import annotations

import argparse
import json
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Union

from tools.make_package import make_package
from tools.qgis_matrix.places import DEBIAN_FOR_QT6, PICTURES, REPOSITORY, Chroot, Here, PlaceError

Place = Union[Here, Chroot]
OUTPUT = REPOSITORY / "output" / "matrix"
SIDE_BY_SIDE = ("-n", "auto", "--maxprocesses", "4", "--dist", "loadfile")
WORK_STOLEN = ("-n", "auto", "--maxprocesses", "4", "--dist", "worksteal")


@dataclass(frozen=True)
class Step:
    """Some of the tests, in a process of their own."""

    name: str
    tests: tuple[str, ...]
    """Tests that are run each time; the whole folder with FULL=1."""
    folder: str
    options: tuple[str, ...] = ()
    variables: tuple[tuple[str, str], ...] = ()
    most_minutes: int = 40
    """With FULL=1 five times as many."""


STEPS = (
    Step(
        "numbers",
        ("tests/numbers",),
        "tests/numbers",
        (
            *("-p", "no:pytest_qgis"),
            # Guide and CITATION.cff are nothing of QGIS's: each Debian's Sphinx judges differently, and none checks CFF
            *("--ignore=tests/numbers/test_guide.py", "--ignore=tests/numbers/test_metadata.py"),
            *SIDE_BY_SIDE,
        ),
    ),
    Step(
        "qgis",
        (
            "tests/qgis/test_qgis_process.py",
            "tests/qgis/test_provider.py",
            "tests/qgis/test_plugin_lifecycle.py",
            "tests/qgis/test_plugin_package.py",
            "tests/qgis/test_chains.py",
            "tests/qgis/toolkit",
        ),
        "tests/qgis",
        SIDE_BY_SIDE,
        (("QT_QPA_PLATFORM", "offscreen"),),
    ),
    Step(
        "desktop",
        ("tests/desktop/test_desktop.py::test_operators_walk", "tests/desktop/test_installed.py"),
        "tests/desktop",
        ("-p", "no:pytest_qgis", *WORK_STOLEN),
        (("SCREENSHOTS", PICTURES),),
    ),
)


@dataclass
class Row:
    """What is known of one QGIS."""

    name: str
    versions: dict[str, str] = field(default_factory=dict)
    results: dict[str, str] = field(default_factory=dict)
    """How each step ended, in words, by its name."""
    seconds: float = 0.0
    picture: str = ""
    failed: bool = False


def main() -> int:
    """Run everything; 1 where something failed."""
    wanted = _arguments()
    for end in (signal.SIGTERM, signal.SIGHUP):  # as Ctrl+C does: what runs in a chroot ends, too
        signal.signal(end, lambda number, _frame: sys.exit(128 + number))
    data = str(Path(os.environ.get("SEAM_INSPECTOR_DATA", REPOSITORY.parent / "shared" / "data")).resolve())
    OUTPUT.mkdir(parents=True, exist_ok=True)
    package, rows = make_package(REPOSITORY / "build"), []
    for suite in wanted.suites.split():
        rows.append(run_place(_place(suite, wanted, data if Path(data).is_dir() else ""), package, wanted.full))
    print("\n" + table(rows))
    return int(any(row.failed for row in rows))


def _place(suite: str, wanted: argparse.Namespace, data: str) -> Place:
    if suite == "here":
        return Here()
    qgis = wanted.qt6.resolve() if suite == "qt6" else None
    return Chroot(DEBIAN_FOR_QT6 if qgis else suite, Path(wanted.chroots).resolve(), wanted.mirror, data, qgis)


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--suites", default="here trixie sid", help="'here', 'qt6', and names of Debian's releases")
    parser.add_argument("--qt6", type=Path, help="folder or tarball of a QGIS on Qt 6, for the suite qt6")
    parser.add_argument("--chroots", default=str(REPOSITORY / "build" / "chroots"), help="their folder")
    parser.add_argument("--mirror", default="", help="of Debian; debootstrap knows one")
    parser.add_argument("--full", action="store_true", help="all tests")
    wanted = parser.parse_args()
    if "qt6" in wanted.suites.split() and not (wanted.qt6 and wanted.qt6.exists()):
        parser.error("No Debian has a QGIS on Qt 6: name its folder or tarball by QT6=, as "
                     "tools/qgis_matrix/build_qgis_qt6.sh makes one.")  # fmt: skip
    return wanted


def run_place(place: Place, package: Path, full: bool) -> Row:
    """Versions, then all steps, also where one failed."""
    row, start = Row(place.name), time.monotonic()
    try:
        place.prepare(package, OUTPUT / f"{place.name}-install.log")
        row.versions = _versions(place)
    except PlaceError as error:
        print(f"{place.name}: {error}", flush=True)
        row.failed = True
        return row
    title = "-".join(["qgis", ".".join(row.versions["QGIS"].split(".")[:2]), *(["qt6"] if place.name == "qt6" else [])])
    for step in STEPS:
        passed, told = _run_step(place, step, package, full, OUTPUT / f"{title}-{step.name}.log")
        row.results[step.name] = told
        row.failed |= not passed
    picture = OUTPUT / f"{title}.png"
    picture.unlink(missing_ok=True)
    if place.fetch(f"{PICTURES}/desk.png", picture):
        row.picture = str(picture.relative_to(REPOSITORY))
    row.seconds = time.monotonic() - start
    return row


def _versions(place: Place) -> dict[str, str]:
    script = "tools/qgis_matrix/versions.py"
    asked = subprocess.run(
        place.python([script], {}, 120), cwd=REPOSITORY, capture_output=True, text=True, check=False
    )  # fmt: skip
    if asked.returncode:
        raise PlaceError(f"its Python does not know QGIS, or a package is missing: {asked.stderr.strip()[-300:]}")
    versions: dict[str, str] = json.loads(asked.stdout.splitlines()[-1])
    print(f"\n{place.name}: " + ", ".join(f"{name} {version}" for name, version in versions.items()), flush=True)
    return versions


def _run_step(place: Place, step: Step, package: Path, full: bool, log: Path) -> tuple[bool, str]:
    """Whether it passed, and the words for the table."""
    print(f"  {step.name:8} ", end="", flush=True)
    tests = (step.folder,) if full else step.tests
    variables = {**dict(step.variables), "SEAM_INSPECTOR_PACKAGE": str(package.relative_to(REPOSITORY))}
    seconds = 60 * step.most_minutes * (5 if full else 1)
    command = place.python(["-m", "pytest", *step.options, *tests], variables, seconds)
    start = time.monotonic()
    with open(log, "wb") as output:
        code = subprocess.run(
            command, cwd=REPOSITORY, stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT, check=False
        ).returncode
    text = log.read_text(encoding="utf-8", errors="replace")
    passed, told = ended(code, text)
    told = f"{told}, {minutes(time.monotonic() - start)}"
    print(told, flush=True)
    if not passed:
        print("\n".join(text.splitlines()[-25:]) + f"\n  all of it: {log.relative_to(REPOSITORY)}", flush=True)
    return passed, told


def ended(code: int, text: str) -> tuple[bool, str]:
    """Whether pytest passed, by its exit code and last line, and how in words. Skipped tests alone are a failure."""
    counts = re.findall(r"\b(\d+) (passed|failed|error|skipped)", text.splitlines()[-1] if text.strip() else "")
    numbers = {word: int(number) for number, word in counts}
    failures = numbers.get("failed", 0) + numbers.get("error", 0)
    if code == 124:
        return False, "out of time"
    if code == 0 and numbers.get("passed", 0):
        skipped = f", {numbers['skipped']} skipped" if "skipped" in numbers else ""
        return True, f"{numbers['passed']} passed{skipped}"
    if failures:
        return False, f"{failures} FAILED of {sum(numbers.values())}"
    return False, f"FAILED ({'nothing ran' if code in (0, 5) else f'exit code {code}'})"


def minutes(seconds: float) -> str:
    """Seconds as minutes and seconds."""
    return f"{int(seconds) // 60}:{int(seconds) % 60:02d}"


def table(rows: Sequence[Row]) -> str:
    """A line for each QGIS."""
    names = list(dict.fromkeys(name for row in rows for name in row.versions))
    steps = [step.name for step in STEPS]
    cells = [["", *names, *steps, "time", "picture"]]
    for row in rows:
        versions = [row.versions.get(name, "-") for name in names]
        results = [row.results.get(name, "not run") for name in steps]
        cells.append([row.name, *versions, *results, minutes(row.seconds), row.picture or "-"])
    widths = [max(len(line[column]) for line in cells) for column in range(len(cells[0]))]
    return "\n".join("  ".join(word.ljust(width) for word, width in zip(line, widths)).rstrip() for line in cells)


if __name__ == "__main__":
    sys.exit(main())
