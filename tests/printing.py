"""Pages as a browser prints them: chromium makes a PDF, poppler says what stands on its pages and where."""
from __future__ import annotations

import re
import shutil
import subprocess
from dataclasses import dataclass
from functools import cache
from html import unescape
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from tests.browser import browser

_PATIENCE_S = 120
_DPI = 30
_WORD = re.compile(r'<word xMin="([\d.]+)" yMin="([\d.]+)" xMax="([\d.]+)" yMax="([\d.]+)">(.*?)</word>')
_PAGE = re.compile(r'<page width="([\d.]+)" height="([\d.]+)">(.*?)</page>', re.DOTALL)
_PLAIN = "<!DOCTYPE html><html><body><p>words</p></body></html>"


@dataclass(frozen=True)
class PrintedWord:
    """A word and where it stands, points from the page's upper left."""

    left: float
    top: float
    right: float
    bottom: float
    text: str

    @property
    def height(self) -> float:
        return self.bottom - self.top


@dataclass(frozen=True)
class PrintedPage:
    """One page of a PDF."""

    width: float  # points
    height: float
    words: tuple[PrintedWord, ...]
    ink: np.ndarray  # (rows, columns) bool, where anything is printed

    @property
    def text(self) -> str:
        return " ".join(word.text for word in self.words)

    def share_of(self, row: int) -> float:
        """How far down the page a row of the ink is."""
        return row / len(self.ink)


def why_not() -> str:
    """Why nothing can be printed here; empty where it can."""
    missing = [name for name in ("pdftotext", "pdftoppm") if shutil.which(name) is None]
    if missing:
        return f"{', '.join(missing)} of poppler-utils is missing"
    if browser() is None:
        return "no chromium is installed"
    return _first_try()


def print_page(path: Path, folder: Path) -> list[PrintedPage]:
    """An HTML file on paper."""
    pdf = folder / f"{path.stem}.pdf"
    complaint = _print(path, pdf)
    assert not complaint, complaint
    return _read(pdf)


@cache
def _first_try() -> str:
    """Ubuntu's chromium is a snap that does not start everywhere, and does not see every folder."""
    with TemporaryDirectory(prefix="seam_inspector_") as folder:
        page = Path(folder) / "page.html"
        page.write_text(_PLAIN, encoding="utf-8")
        return _print(page, page.with_suffix(".pdf"))


def _print(page: Path, pdf: Path) -> str:
    """Why there is no PDF; empty where there is one."""
    program = browser()
    assert program is not None
    with TemporaryDirectory(prefix="seam_inspector_") as profile:
        command = [
            program, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={profile}",
            f"--print-to-pdf={pdf}", page.as_uri(),
        ]  # fmt: skip
        try:
            made = subprocess.run(command, capture_output=True, text=True, timeout=_PATIENCE_S, check=False)
        except (OSError, subprocess.TimeoutExpired) as error:
            return f"chromium does not print: {error}"
    return "" if pdf.exists() else f"chromium does not print: {made.stderr[-300:]}"


def _read(pdf: Path) -> list[PrintedPage]:
    boxes = subprocess.run(
        ["pdftotext", "-bbox", str(pdf), "-"], capture_output=True, text=True, timeout=_PATIENCE_S, check=True
    ).stdout
    with TemporaryDirectory(prefix="seam_inspector_") as folder:
        command = ["pdftoppm", "-r", str(_DPI), "-gray", str(pdf), f"{folder}/page"]
        subprocess.run(command, timeout=_PATIENCE_S, check=True)
        inks = [_ink(picture) for picture in sorted(Path(folder).glob("page*.pgm"))]
    return [
        PrintedPage(float(width), float(height), tuple(_words(body)), ink)
        for (width, height, body), ink in zip(_PAGE.findall(boxes), inks)
    ]


def _words(body: str) -> list[PrintedWord]:
    return [PrintedWord(*map(float, place), unescape(text)) for *place, text in _WORD.findall(body)]


def _ink(picture: Path) -> np.ndarray:
    """Pixels of a PGM file that are not white."""
    data = picture.read_bytes()
    header = re.match(rb"P5\s+(\d+)\s+(\d+)\s+255\s", data)
    assert header is not None
    columns, rows = map(int, header.groups())
    return np.frombuffer(data, np.uint8, rows * columns, header.end()).reshape(rows, columns) < 245
