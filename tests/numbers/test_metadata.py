"""The papers that go with the plugin: metadata.txt, changelog, icon, licences of others, promises that have tests."""
from __future__ import annotations

import configparser
import re
import struct
import subprocess
from pathlib import Path

import pytest
from cffconvert import Citation

WANTED_BY_THE_PLUGIN_REPOSITORY = (
    "name description about version author email tracker repository homepage "
    "qgisMinimumVersion icon tags changelog hasProcessingProvider"
).split()

# A registry's address, or a path that only one machine has. Spelled so that this file does not match itself.
OF_ONE_MACHINE = re.compile(
    r"://[a-z.-]*(?:debian|pypi|pythonhosted|npmjs)[.]|(?:^|[^a-z.])[/](?:root|work|farm)[/][a-z]", re.MULTILINE
)


@pytest.fixture(scope="module")
def metadata(repository: Path) -> dict[str, str]:
    """The fields of metadata.txt."""
    parser = configparser.ConfigParser()
    parser.optionxform = str  # type: ignore[assignment,method-assign]
    parser.read(repository / "metadata.txt", encoding="utf-8")
    return dict(parser["general"])


@pytest.mark.parametrize("field", WANTED_BY_THE_PLUGIN_REPOSITORY)
def test_field_is_there(metadata: dict[str, str], field: str) -> None:
    assert metadata.get(field, "").strip()


def test_works_from_qgis_3_22_to_4(metadata: dict[str, str]) -> None:
    assert metadata["qgisMinimumVersion"] == "3.22"
    assert metadata["qgisMaximumVersion"] == "4.99"
    assert "supportsQt6" not in metadata  # deprecated: the maximum version says it


def test_version_is_the_newest_of_both_changelogs(metadata: dict[str, str], repository: Path) -> None:
    newest = re.search(r"^## (\S+)", (repository / "CHANGELOG.md").read_text(encoding="utf-8"), re.MULTILINE)
    assert newest
    assert newest[1] == metadata["version"]
    assert metadata["changelog"].split()[0] == metadata["version"]


def test_citation_is_valid_and_of_this_version(metadata: dict[str, str], repository: Path) -> None:
    citation = Citation((repository / "CITATION.cff").read_text(encoding="utf-8"))
    citation.validate()
    assert citation.cffobj["version"] == metadata["version"]
    assert citation.cffobj["title"] == metadata["name"]
    assert citation.cffobj["license"] == metadata["license"]
    assert "example.org" not in str(citation.cffobj)  # its address comes with the publisher's


def test_icon_is_a_square_png_with_its_svg(metadata: dict[str, str], repository: Path) -> None:
    icon = repository / metadata["icon"]
    header = icon.read_bytes()[:24]
    width, height = struct.unpack(">II", header[16:])
    assert header.startswith(b"\x89PNG")
    assert width == height >= 64
    assert icon.with_suffix(".svg").is_file()


@pytest.mark.slow
def test_files_name_no_registry_and_no_path_of_one_machine(repository: Path) -> None:
    listed = subprocess.run(
        ["git", "-c", "safe.directory=*", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        cwd=repository,
        capture_output=True,
        text=True,
    )
    if listed.returncode:
        pytest.skip("not a git checkout, so which files belong to the project is not known")
    faults = []
    for name in filter(None, listed.stdout.split("\0")):
        path = repository / name
        content = path.read_bytes() if path.is_file() else b""
        if b"\0" not in content:
            faults += [f"{name}: {match[0]}" for match in OF_ONE_MACHINE.finditer(content.decode("utf-8", "replace"))]
    assert faults == []


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
