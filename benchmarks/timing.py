"""What all benchmarks share: interleaved timing, tables, goals, and what the figures were measured on."""
from __future__ import annotations

import os
import platform
import re
import statistics
import time
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

import numpy as np
import pywt
from osgeo import gdal

_STARTED = time.perf_counter()

DEBIAN_BLAS = "/usr/lib/"
"""Where the system's BLAS lies; wheels bring their own."""


@dataclass(frozen=True)
class Spread:
    """Least, median and largest of several figures."""

    least: float
    median: float
    most: float

    @classmethod
    def of(cls, figures: Iterable[float]) -> Spread:
        """The spread of any number of figures."""
        ordered = sorted(figures)
        return cls(ordered[0], statistics.median(ordered), ordered[-1])

    def __str__(self) -> str:
        return f"{self.median:.2f} ({self.least:.2f}-{self.most:.2f})"


@dataclass(frozen=True)
class Timing:
    """Repetitions of one call, seconds."""

    wall: tuple[float, ...]
    cpu: tuple[float, ...]
    """Times of the process: what other processes take from the machine hardly shows in it."""

    @property
    def milliseconds(self) -> str:
        """Median by the clock on the wall."""
        return f"{1e3 * statistics.median(self.wall):.2f} ms"

    def over(self, other: Timing) -> Spread:
        """How many times longer than another call, repetition by repetition."""
        return Spread.of(a / b for a, b in zip(self.wall, other.wall))

    def cpu_over(self, other: Timing) -> float:
        """How many times longer than another call, by the time on the processor, median."""
        return statistics.median(a / b for a, b in zip(self.cpu, other.cpu))


@dataclass(frozen=True)
class Goal:
    """A figure beside what the design wants of it."""

    text: str
    wanted: float
    measured: float
    at_least: bool = True
    processor: float = float("nan")
    """Figure in processor time, which other processes hardly change; NaN where it was not measured."""

    @property
    def met(self) -> bool:
        """Whether the figure is on the right side of its goal."""
        return self.measured >= self.wanted if self.at_least else self.measured <= self.wanted

    @property
    def cells(self) -> list[str]:
        """A row for ``table``."""
        return [
            self.text,
            f"{'>=' if self.at_least else '<='} {self.wanted:g}",
            f"{self.measured:.2f}",
            "met" if self.met else "NOT met",
        ]


def interleaved(calls: Sequence[Callable[[], object]], repetitions: int) -> list[Timing]:
    """Time calls in turn, A B A B ..., so that drift of the machine hits all of them alike."""
    for call in calls:
        call()
    walls: list[list[float]] = [[] for _ in calls]
    cpus: list[list[float]] = [[] for _ in calls]
    for _ in range(repetitions):
        for call, wall, cpu in zip(calls, walls, cpus):
            started, started_cpu = time.perf_counter(), time.process_time()
            call()
            wall.append(time.perf_counter() - started)
            cpu.append(time.process_time() - started_cpu)
    return [Timing(tuple(wall), tuple(cpu)) for wall, cpu in zip(walls, cpus)]


@dataclass(frozen=True)
class Run:
    """One run of something long."""

    wall: float
    """Seconds by the clock on the wall."""
    cpu: float
    """Seconds of the processor, all threads together."""


@dataclass(frozen=True)
class Speed:
    """Megapixels of the mosaic a second."""

    wall: float
    """Speed by the clock on the wall, of all threads together."""
    core: float
    """Speed of a core: by the time on the processor."""

    @classmethod
    def of(cls, megapixels: float, run: Run) -> Speed:
        """Speed of one run."""
        return cls(megapixels / run.wall, megapixels / run.cpu)

    @property
    def cells(self) -> tuple[str, str]:
        """Cells of a row for ``table``."""
        return f"{self.wall:.1f}", f"{self.core:.1f}"


def timed(call: Callable[[], object]) -> Run:
    """Run something once."""
    started, started_cpu = time.perf_counter(), time.process_time()
    call()
    return Run(time.perf_counter() - started, time.process_time() - started_cpu)


def say(words: str) -> None:
    """What is under way, at once, also into a pipe; with the seconds since the start."""
    print(f"  {time.perf_counter() - _STARTED:4.0f} s  {words}", flush=True)


def seconds_so_far() -> float:
    """Since the start."""
    return time.perf_counter() - _STARTED


def print_table(title: str, head: Sequence[str], rows: Sequence[Sequence[str]], note: str = "") -> None:
    """A table in columns, the first one to the left."""
    widths = [max(map(len, column)) for column in zip(head, *rows)]
    print(f"\n{title}\n")
    for row in (head, ["-" * width for width in widths], *rows):
        first, *others = (cell.ljust(width) if i == 0 else cell.rjust(width)
                          for i, (cell, width) in enumerate(zip(row, widths)))
        print("  " + "  ".join([first, *others]).rstrip())
    print(f"\n  {note}\n" if note else "", flush=True)


def print_machine(threads: str) -> None:
    """Processor, libraries and their versions."""
    print(f"{processor()}, {platform.system()}, Python {platform.python_version()}")
    print(f"numpy {np.__version__}, PyWavelets {pywt.__version__}, GDAL {gdal.__version__}")
    print(f"BLAS {blas()}, threads: {threads}")
    if hasattr(os, "getloadavg"):
        print(f"{os.cpu_count()} cores, load {os.getloadavg()[0]:.1f} at the start (above 0.5: take care)", flush=True)


def processor() -> str:
    """The processor's name."""
    information = Path("/proc/cpuinfo")
    lines = information.read_text().splitlines() if information.exists() else []
    names = (line.partition(":")[2].strip() for line in lines if line.startswith("model name"))
    return next(names, platform.processor() or platform.machine())


def blas() -> str:
    """The BLAS that numpy calls: by threadpoolctl where that is installed, else the library that is loaded."""
    np.dot(np.ones((2, 2)), np.ones((2, 2)))
    try:
        from threadpoolctl import threadpool_info
    except ImportError:
        loaded = loaded_blas()
        return ", ".join(loaded) if loaded else "unknown (install threadpoolctl to see it)"
    return ", ".join(f"{one['internal_api']} {one.get('version')}, {one['filepath']}"
                     for one in threadpool_info() if one.get("user_api") == "blas")


def loaded_blas() -> list[str]:
    """Files of BLAS libraries in this process, where the system tells (Linux)."""
    maps = Path("/proc/self/maps")
    if not maps.exists():
        return []
    files = {line.split()[-1] for line in maps.read_text().splitlines() if "/" in line}
    found = sorted(file for file in files if re.search(r"/lib[^/]*(openblas|blis|mkl_rt|atlas)[^/]*$", file))
    return found or sorted(file for file in files if re.search(r"/libc?blas\.so[^/]*$", file))


def is_system_blas() -> bool:
    """Whether it is Debian's (or another system's) BLAS, and not one from a wheel."""
    return any(one.startswith(DEBIAN_BLAS) for one in loaded_blas())
