"""What others made and this uses: bounded, with a licence that is told; what is promised of it has its tests."""
from __future__ import annotations

import re
from pathlib import Path

import pytest

FILES = ("requirements.txt", "requirements-dev.txt", "requirements-package.txt", "requirements-qt6.txt")


def requirements(path: Path) -> dict[str, str]:
    """Versions by name, as a file of requirements has them."""
    lines = (line.partition("#")[0].strip() for line in path.read_text(encoding="utf-8").splitlines())
    matches = [re.fullmatch(r"([\w-]+)(?:\[\w+\])?(.*)", line) for line in lines if line and not line.startswith("-r")]
    return {match[1]: match[2] for match in matches if match is not None}


@pytest.mark.parametrize("name", FILES)
def test_every_requirement_has_an_upper_bound_and_a_licence(repository: Path, name: str) -> None:
    licences = (repository / "LICENCES.md").read_text(encoding="utf-8")
    listed = set(re.findall(r"[\w-]+", " ".join(re.findall(r"^\| ([^|]+) \|", licences, re.M))))
    for package, versions in requirements(repository / name).items():
        assert re.search(r"<|==", versions), f"{package} in {name} has no upper bound"
        assert package in listed, f"{package} of {name} has no licence in LICENCES.md"


def test_what_pip_installs_is_bounded_alike(repository: Path) -> None:
    project = (repository / "pyproject.toml").read_text(encoding="utf-8")
    bounded = requirements(repository / "requirements.txt")
    for package in ("numpy", "PyWavelets", "scipy"):
        assert f'"{package}{bounded[package]}"' in project


def test_each_of_ten_promises_names_tests_that_there_are(repository: Path) -> None:
    security = (repository / "SECURITY.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (?!promise|---)[^|]+\|([^|]+)\|$", security.partition("## What is not")[0], re.M)
    rows = [row for row in rows if "---" not in row]
    assert len(rows) == 10
    there = {path.name for path in (repository / "tests").rglob("test_*.py")}
    for row in rows:
        named = re.findall(r"`(test_\w+\.py)`", row)
        assert named
        assert set(named) <= there, set(named) - there
