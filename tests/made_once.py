"""Scenes that take seconds to make, made once for all files and processes of a run, which read them only."""
from __future__ import annotations

import os
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

import pytest

from demo.block import Block, make_block
from demo.delivery import Delivery, make_delivery

Made = TypeVar("Made")


def the_delivery(factory: pytest.TempPathFactory) -> Delivery:
    """Twelve sheets, four of them spoilt."""
    return _made_once(factory, "delivery", make_delivery)


def the_small_block(factory: pytest.TempPathFactory) -> Block:
    """120 x 100 m."""
    return _made_once(factory, "block", lambda folder: make_block(folder, extent_m=(120.0, 100.0)))


def the_first_block(factory: pytest.TempPathFactory) -> Block:
    """500 x 400 m, as the first steps in Python have it."""
    return _made_once(factory, "first block", make_block)


def _made_once(factory: pytest.TempPathFactory, name: str, make: Callable[[Path], Made]) -> Made:
    """What a maker returned, here or in another process of the run."""
    import fcntl

    base = factory.getbasetemp()
    folder = (base.parent if "PYTEST_XDIST_WORKER" in os.environ else base) / "made once" / name
    folder.mkdir(parents=True, exist_ok=True)
    kept = folder.with_suffix(".pickle")
    with open(folder.with_suffix(".lock"), "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not kept.exists():
            kept.write_bytes(pickle.dumps(make(folder)))
    made: Made = pickle.loads(kept.read_bytes())
    return made
