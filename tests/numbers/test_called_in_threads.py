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
from scipy import stats
from seam_inspector.plugin.imagery.statistics import critical_t
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


def test_calls_are_found_by_any_import() -> None:
    source = (
        "import numpy as np\nimport scipy.fft\nfrom scipy import special\nfrom scipy.stats import t as student\n"
        "def late(x):\n    from pywt import Wavelet\n    return Wavelet(x), np.linalg.inv(x.T), np.sum(x)\n"
        "y = special.erfc(1) + student.ppf(0.5, 3) + len(scipy.fft.fft([1]))\n"
    )
    assert set(calls(source)) == {
        "pywt.Wavelet", "numpy.linalg.inv", "scipy.special.erfc", "scipy.stats.t.ppf", "scipy.fft.fft",
    }  # fmt: skip


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


@pytest.mark.parametrize("confidence", [0.8, 0.95, 0.999, 1 - 1e-5])
def test_critical_values_are_those_of_students_t(confidence: float) -> None:
    freedom = np.concatenate([np.arange(1, 200), [1.5, 2.25, 1e3, 12345.6, 1e6]])
    np.testing.assert_allclose(critical_t(confidence, freedom), stats.t.ppf((1 + confidence) / 2, freedom), rtol=2e-7)


def test_critical_values_end_with_the_normal_ones() -> None:
    np.testing.assert_allclose(critical_t(0.95, np.array([1e9, 1e15, np.inf])), 1.959963985, rtol=2e-7)
    assert np.isnan(critical_t(0.95, np.nan))


def test_the_systems_packages_are_tested(repository: Path) -> None:
    if Path(sys.prefix).resolve() != (repository / ".venv").resolve():
        pytest.skip("another environment than .venv, with packages of its own")
    for package in (np, scipy, pywt):
        assert not Path(package.__file__).is_relative_to(sys.prefix), f"{package.__name__} is not QGIS's: make install"
