"""What the plugin calls of compiled libraries holds in two threads at once; the tests run on the system's packages."""
from __future__ import annotations

import ast
import re
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
import pywt
import scipy
from seam_inspector.plugin.seams.measure.profile.intervals import Kept

from tests.numbers.hammering import CALLS, HAMMERED, MANY, POSITIVE, fault_in_threads

LIBRARIES = ("scipy.", "pywt.", "numpy.fft.", "numpy.linalg.")
SECONDS, QUICK_SECONDS = 0.1, 0.01  # of a function: an unsafe one fails within some ten calls


def calls(source: str) -> Iterator[str]:
    """Full names of all that a file takes of ``LIBRARIES``."""
    tree = ast.parse(source)
    names = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            for alias in node.names:
                first = alias.name.partition(".")[0]
                names[alias.asname or first] = alias.name if alias.asname else first
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            names.update({alias.asname or alias.name: f"{node.module}.{alias.name}" for alias in node.names})
    inner = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Attribute)}
    for node in ast.walk(tree):
        if isinstance(node, (ast.Attribute, ast.Name)) and id(node) not in inner:
            parts: list[str] = []
            while isinstance(node, ast.Attribute):
                parts, node = [node.attr, *parts], node.value
            name = ".".join([names.get(node.id, ""), *parts]) if isinstance(node, ast.Name) else ""
            if name.startswith(LIBRARIES):
                yield name


def test_all_that_is_called_is_hammered(repository: Path) -> None:
    sources = (path.read_text(encoding="utf-8") for path in (repository / "plugin").rglob("*.py"))
    called = {name for source in sources if re.search("scipy|pywt|linalg|fft", source) for name in calls(source)}
    assert called == set(HAMMERED)


@pytest.mark.parametrize("name", HAMMERED)
def test_two_threads_get_what_a_single_one_gets(name: str, request: pytest.FixtureRequest) -> None:
    seconds = QUICK_SECONDS if request.config.getoption("quick") else SECONDS
    assert fault_in_threads(HAMMERED[name], CALLS, seconds) is None


def test_a_function_that_threads_disturb_is_told() -> None:
    count = 0

    def counted() -> int:
        nonlocal count
        count += 1
        return count

    assert "another result" in str(fault_in_threads(counted, CALLS, SECONDS))


def test_intervals_are_the_same_from_two_threads() -> None:
    value, error = np.full(MANY, 0.7), np.full(MANY, 0.1)
    assert fault_in_threads(lambda: Kept.of(value, error, POSITIVE).high, CALLS, SECONDS) is None


def test_the_systems_packages_are_tested(repository: Path) -> None:
    if Path(sys.prefix).resolve() != (repository / ".venv").resolve():
        pytest.skip("another environment than .venv, with packages of its own")
    for package in (np, scipy, pywt):
        assert not Path(package.__file__).is_relative_to(sys.prefix), f"{package.__name__} is not QGIS's: make install"
