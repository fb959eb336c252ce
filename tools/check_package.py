"""Check a plugin's zip by the rules of QGIS's plugin repository, before it is sent there.

    python -m tools.check_package PLUGIN.zip

Prints errors, which the repository refuses, and warnings, which it or the publisher should know of; the exit code is 1
when there is an error. Code is looked at by bandit, detect-secrets and flake8, as there.
"""
from __future__ import annotations

import argparse
import configparser
import json
import re
import subprocess
import sys
import tempfile
import zipfile
from collections import defaultdict
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any

_LARGEST = 25_000_000  # bytes
_WANTED = "name description version qgisMinimumVersion author email about tracker repository homepage".split()
_ADDRESSES = ("tracker", "repository", "homepage")
_NEVER = {"__MACOSX", ".git", "__pycache__"}
_ALLOWED_HIDDEN = {".gitignore", ".gitattributes", ".bandit", ".secrets.baseline", ".flake8"}
_PROGRAMS = (".exe", ".dll", ".so", ".dylib", ".bat", ".sh", ".ps1", ".cmd")
_TESTS = re.compile(r"(^|/)(tests?|conftest\.py|test_[^/]*\.py)(/|$)")
_PLACEHOLDER = re.compile(r"[@/.]example\.(org|com|net)\b")
# bandit's rules that the repository refuses a plugin for; all others it tells of
_REFUSED = set(
    "B102 B103 B105 B106 B107 B111 B201 B202 B301 B302 B304 B305 B306 B307 B312 B321 B323 B401 B402 B412 B413 B501 "
    "B502 B503 B505 B506 B507 B601 B602 B604 B605 B609 B610 B611 B612 B613 B615 B701".split()
)
_TOLD = set(
    "B101 B104 B108 B110 B112 B113 B303 B308 B310 B311 B313 B314 B315 B316 B317 B318 B319 B320 B324 B403 B405 B406 "
    "B407 B408 B409 B504 B508 B509 B603 B606 B607 B608 B614 B702 B703 B704".split()
)
_FLAKE8 = (
    "E901,E902,E999,F821,F823,F831,E101,E711,E712,E713,E714,E721,E722,E731,E741,E742,E743,W605,F402,F403,F404,F405,"
    "F811,F822,F901,C901"
)
_BROKEN_CODE = re.compile(r"E9|F82[13]|F831")
_SHOWN = 3


@dataclass(frozen=True)
class Finding:
    """What is wrong with a package."""

    is_error: bool
    """Whether the plugin repository refuses it."""
    rule: str
    place: str = ""
    """The file, and the line where there is one."""


def check_package(path: Path) -> list[Finding]:
    """All that is found; raises zipfile.BadZipFile for what is none, or empty."""
    with zipfile.ZipFile(path) as package:
        if not package.namelist():
            raise zipfile.BadZipFile("it is empty")
        found = [Finding(True, f"larger than {_LARGEST // 1_000_000} MB")] * (path.stat().st_size > _LARGEST)
        found += check_names(package)
        top = package.namelist()[0].split("/")[0]
        if f"{top}/metadata.txt" in package.namelist():
            found += check_metadata(package.read(f"{top}/metadata.txt").decode("utf-8"), package.namelist())
        with tempfile.TemporaryDirectory() as folder:
            package.extractall(folder)
            with ThreadPoolExecutor() as side_by_side:
                for findings in side_by_side.map(lambda look: list(look(folder)), (_bandit, _secrets, _flake8)):
                    found += findings
    return found


def check_names(package: zipfile.ZipFile) -> Iterator[Finding]:
    """Folders and files."""
    names = package.namelist()
    tops = {name.split("/")[0] for name in names}
    if len(tops) > 1:
        yield Finding(True, "more than one folder at the top", ", ".join(sorted(tops)))
    top = names[0].split("/")[0]
    if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_]+", top):
        yield Finding(True, "the folder at the top can't be imported", top)
    for file in ("__init__.py", "metadata.txt", "LICENSE"):
        if f"{top}/{file}" not in names:
            yield Finding(True, f"{file} is missing")
    for name in names:
        is_runnable = bool((package.getinfo(name).external_attr >> 16) & 0o111) and not name.endswith("/")
        yield from _check_name(name, is_runnable)


def _check_name(name: str, is_runnable: bool) -> Iterator[Finding]:
    parts = PurePosixPath(name).parts
    if ".." in parts or name.startswith("/") or "\\" in name:
        yield Finding(True, "a path that leads out of the folder", name)
    if _NEVER & set(parts) or ".pyc" in name:
        yield Finding(True, "a file that is never wanted", name)
    if name.lower().endswith(_PROGRAMS):
        yield Finding(True, "a program", name)
    if is_runnable:
        yield Finding(False, "a file with the right to be run", name)
    if any(part.startswith(".") for part in parts) and parts[-1] not in _ALLOWED_HIDDEN:
        yield Finding(False, "a hidden file", name)
    if _TESTS.search(name):
        yield Finding(False, "a test", name)


def check_metadata(text: str, names: list[str]) -> Iterator[Finding]:
    """metadata.txt, beside the files' names."""
    parser = configparser.ConfigParser()
    parser.optionxform = str  # type: ignore[assignment,method-assign]
    try:
        parser.read_string(text)
        fields = dict(parser["general"])
    except (configparser.Error, KeyError) as error:
        yield Finding(True, f"metadata.txt can't be read: {error}")
        return
    for field in _WANTED:
        if not fields.get(field, "").strip():
            yield Finding(True, "metadata.txt lacks a field", field)
    for field in _ADDRESSES:
        if not re.match(r"https?://[^/\s]+", fields.get(field, "")):
            yield Finding(True, "metadata.txt: not an address", field)
    if "/" in fields.get("author", ""):
        yield Finding(True, "metadata.txt: a slash in the author's name")
    for field, value in fields.items():
        if _PLACEHOLDER.search(value):
            yield Finding(False, "metadata.txt: a placeholder, for the publisher to fill in", field)
    yield from _check_newer_fields(fields, names)


def _check_newer_fields(fields: dict[str, str], names: list[str]) -> Iterator[Finding]:
    if "supportsQt6" in fields:
        yield Finding(False, "metadata.txt: supportsQt6 is out of date, qgisMaximumVersion says it")
    icon = fields.get("icon", "")
    if icon and f"{names[0].split('/')[0]}/{icon}" not in names:
        yield Finding(False, "metadata.txt: the icon is not in the package", icon)


def _bandit(folder: str) -> Iterator[Finding]:
    """What a script could be made to do."""
    report = _json("bandit", "-r", ".", "-f", "json", "-q", "-t", ",".join(sorted(_REFUSED | _TOLD)), folder=folder)
    for issue in report["results"]:
        place = f"{issue['filename'].removeprefix('./')}:{issue['line_number']}"
        yield Finding(issue["test_id"] in _REFUSED, f"bandit {issue['test_id']} {issue['test_name']}", place)
    for error in report["errors"]:
        yield Finding(True, f"bandit: {error['reason']}", error["filename"])


def _secrets(folder: str) -> Iterator[Finding]:
    """Passwords and keys."""
    report = _json(
        "detect_secrets", "scan", "--all-files", "--no-verify", "--exclude-files", r"metadata\.txt", ".", folder=folder
    )
    for file, secrets in report["results"].items():
        for secret in secrets:
            yield Finding(True, f"detect-secrets: {secret['type']}", f"{file}:{secret['line_number']}")


def _flake8(folder: str) -> Iterator[Finding]:
    """Broken code, and code that looks so."""
    for line in _said("flake8", "--isolated", "--max-line-length=120", "--select", _FLAKE8, ".", folder=folder):
        place, rule = line.split(": ", 1)
        yield Finding(bool(_BROKEN_CODE.match(rule)), f"flake8 {rule}", place.removeprefix("./"))


def _said(module: str, *arguments: str, folder: str) -> list[str]:
    run = subprocess.run(
        [sys.executable, "-m", module, *arguments], cwd=folder, capture_output=True, text=True, check=False
    )
    if run.returncode not in (0, 1):  # 1: something was found
        sys.exit(f"{module}: {run.stderr.strip()}")
    if "No module named" in run.stderr:
        sys.exit(f"{module} is not installed: requirements-package.txt names what checks a package.")
    return run.stdout.splitlines()


def _json(module: str, *arguments: str, folder: str) -> dict[str, Any]:
    return dict(json.loads("\n".join(_said(module, *arguments, folder=folder))))


def lines(found: list[Finding]) -> Iterator[str]:
    """Errors one by one, then the warnings, a line for each rule."""
    for one in found:
        if one.is_error:
            yield f"ERROR    {one.rule}{f': {one.place}' if one.place else ''}"
    places = defaultdict(list)
    for one in found:
        if not one.is_error:
            places[one.rule].append(one.place)
    for rule, where in places.items():
        more = f" and {len(where) - _SHOWN} more" if len(where) > _SHOWN else ""
        yield f"warning  {rule}: {', '.join(where[:_SHOWN])}{more}"


def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(description="Check a plugin's zip by the rules of QGIS's plugin repository.")
    parser.add_argument("package", type=Path)
    path = parser.parse_args().package
    try:
        found = check_package(path)
    except (OSError, zipfile.BadZipFile) as error:
        sys.exit(f"{path} can't be read as a zip: {error}")
    print("\n".join(lines(found)))
    errors = sum(one.is_error for one in found)
    print(f"{path.name}: {errors} errors, {len(found) - errors} warnings")
    sys.exit(1 if errors else 0)


if __name__ == "__main__":
    main()
