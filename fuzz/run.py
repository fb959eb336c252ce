"""Thousands of broken inputs through every algorithm: `make fuzz [MINUTES=10] [SEED=...] [ALGORITHM=...] [CASE=...]`.

Prints what was played and what was found; each finding has a case, which `make fuzz CASE=...` plays again.
"""
from __future__ import annotations

import argparse
import random
import shutil
import sys
import threading
import time
from collections import Counter, defaultdict
from collections.abc import Iterator
from pathlib import Path

from fuzz.cases import SOUND, Case
from fuzz.judging import UNBROKEN, Report, kind_of
from fuzz.workers import Worker, noted

FINDINGS = "findings.txt"
FRESH_AFTER = 500  # cases, so that what piles up in a process stays small
ENDS = ("refused", "failed", "ran", UNBROKEN, "findings")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--output", type=Path, default=Path("output/fuzz"))
    parser.add_argument("--minutes", type=float, default=10.0)
    parser.add_argument("--most", type=int, default=10**9, help="cases at most")
    parser.add_argument("--seed", type=int, default=None)
    parser.add_argument("--algorithm", default="", help="one or more, with commas between them")
    parser.add_argument("--breakage", default="", help="one or more, with commas between them")
    parser.add_argument("--case", default="", help="the case of a finding, to be played again")
    parser.add_argument("--jobs", type=int, default=2)
    arguments = parser.parse_args()
    seed = int(time.time()) if arguments.seed is None else arguments.seed
    folder = arguments.output.resolve()
    shutil.rmtree(folder, ignore_errors=True)
    first = Worker(folder / "samples", folder / "worker-0-0", folder / FINDINGS)
    kinds = [Case.of(text) for text in first.kinds]
    if arguments.case:
        return _again(first, arguments.case)
    for name, chosen in (("algorithm", arguments.algorithm), ("breakage", arguments.breakage)):
        if chosen:
            kinds = [kind for kind in kinds if getattr(kind, name) in chosen.split(",")]
    if not kinds:
        print("No such algorithm or breakage.")
        return 2
    print(f"seed {seed}, {len(kinds)} kinds of cases, {arguments.minutes:g} minutes")
    session = Session(folder, endless_cases(kinds, seed), time.monotonic() + 60 * arguments.minutes, arguments.most)
    session.play(first, arguments.jobs)
    print_tables(session.reports)
    return int(any(report.findings for report in session.reports))


def endless_cases(kinds: list[Case], seed: int) -> Iterator[Case]:
    """Each sound call, then without an end: algorithm by algorithm, each with what was broken least so far."""
    yield from (kind for kind in kinds if kind.breakage == SOUND)
    chance = random.Random(seed)
    by_algorithm: dict[str, list[Case]] = defaultdict(list)
    for kind in kinds:
        if kind.breakage != SOUND:
            by_algorithm[kind.algorithm].append(kind)
    waiting: dict[str, list[Case]] = {name: [] for name in by_algorithm}
    played: Counter[str] = Counter()
    while by_algorithm:
        for name, own in by_algorithm.items():
            if not waiting[name]:
                waiting[name] = chance.sample(own, len(own))
            kind = min(waiting[name], key=lambda one: played[one.breakage])
            waiting[name].remove(kind)
            played[kind.breakage] += 1
            yield Case(kind.algorithm, kind.call, kind.parameter, kind.breakage, chance.randrange(10**9))


class Session:
    """Workers side by side, who take the next case each."""

    def __init__(self, folder: Path, cases: Iterator[Case], until: float, most: int) -> None:
        self.reports: list[Report] = []
        self._folder, self._cases, self._until, self._most = folder, cases, until, most
        self._lock = threading.Lock()
        self._given = self._started = 0

    def play(self, first: Worker, jobs: int) -> None:
        threads = [threading.Thread(target=self._work, args=(number, first if not number else None))
                   for number in range(jobs)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()

    def _next(self) -> Case | None:
        with self._lock:
            if time.monotonic() > self._until or self._given >= self._most:
                return None
            self._given += 1
            return next(self._cases, None)

    def _work(self, number: int, worker: Worker | None) -> None:
        while (case := self._next()) is not None:
            if worker is None or worker.is_lost or worker.played >= FRESH_AFTER:
                if worker is not None:
                    worker.close()
                worker = self._fresh(number)
            report = worker.play(str(case))
            with self._lock:
                self.reports.append(report)
                if report.findings:
                    noted(self._folder / FINDINGS, told(report))
            for finding in report.findings:
                print(f"{report.case}\n    {finding[:500]}", flush=True)
        if worker is not None:
            worker.close()

    def _fresh(self, number: int) -> Worker:
        with self._lock:
            self._started += 1
            count = self._started
        return Worker(self._folder / "samples", self._folder / f"worker-{number}-{count}", self._folder / FINDINGS)


def _again(worker: Worker, case: str) -> int:
    report = worker.play(case)
    worker.close()
    print(f"{report.ended} in {report.seconds:.1f} s, {report.peak_bytes / 2**20:.0f} MB")
    for one in (*report.said, report.stderr):
        print("   ", one)
    for finding in report.findings:
        print("!!", finding)
    return int(bool(report.findings))


def print_tables(reports: list[Report]) -> None:
    """Calls by algorithm and by breakage, then each kind of finding with a case that has it."""
    for title, at in (("algorithm", 0), ("breakage", 3)):
        rows: dict[str, Counter[str]] = defaultdict(Counter)
        for report in reports:
            row = rows[report.case.split("/")[at]]
            row.update({"calls": 1, report.ended: 1, "findings": bool(report.findings)})
        print(f"\n{title:28}{'calls':>8}" + "".join(f"{end:>10}" for end in ENDS))
        for name, row in sorted(rows.items()):
            print(f"{name:28}{row['calls']:8}" + "".join(f"{row[end]:10}" for end in ENDS))
    print(f"\n{len(reports)} calls, {sum(bool(report.findings) for report in reports)} with findings")
    found: dict[str, list[str]] = defaultdict(list)
    for report in reports:
        for finding in report.findings:
            found[kind_of(finding)].append(report.case)
    for kind, cases in sorted(found.items(), key=lambda item: -len(item[1])):
        print(f"{len(cases):6}  {kind}\n        make fuzz CASE={cases[0]}")


def told(report: Report) -> str:
    """All that was found and said."""
    parts = [report.case, *(f"    {finding}" for finding in report.findings)]
    parts += [f"    said: {one[:2000]}" for one in report.said]
    return "\n".join([*parts, report.stderr[:5000], ""])


if __name__ == "__main__":
    sys.exit(main())
