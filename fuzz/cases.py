"""What is played: a sound call with one of its values broken, told by a text that makes it again."""
from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from fuzz.breakages import of_bytes, of_growth, of_layers, of_rasters, of_several, of_texts, of_vrts
from fuzz.breakages.broken import BREAKAGES, Broken, copied, kind_of
from fuzz.breakages.of_values import other_input, other_value
from fuzz.calls import CALLS, FOLDERS, Address, Call, placed
from fuzz.running import created

REGISTERED = (of_bytes, of_growth, of_layers, of_rasters, of_several, of_texts, of_vrts)
SOUND, NO_FILE, OTHER_VALUE = "sound", "no_file", "other_value"
NOTHING = "-"
"""The parameter of a call that is left as it is."""


@dataclass(frozen=True)
class Case:
    """A call, the parameter that is broken, how, and the seed of all chance in it."""

    algorithm: str
    call: str
    parameter: str
    breakage: str
    seed: int

    def __str__(self) -> str:
        return f"{self.algorithm}/{self.call}/{self.parameter}/{self.breakage}/{self.seed}"

    @classmethod
    def of(cls, text: str) -> Case:
        """The case that a text tells. Raises ValueError for another text."""
        algorithm, call, parameter, broken, seed = text.split("/")
        return cls(algorithm, call, parameter, broken, int(seed))

    @property
    def sound_call(self) -> Call:
        return next(one for one in CALLS if one.key == f"{self.algorithm}/{self.call}")


def kinds(seed: int = 0) -> list[Case]:
    """Every call with every breakage of every parameter, one of each; needs the algorithms."""
    return [Case(*key, seed) for call in CALLS for key in _kinds(call)]


def _kinds(call: Call) -> Iterator[tuple[str, str, str, str]]:
    yield call.algorithm, call.name, NOTHING, SOUND
    job = created(call.algorithm)
    for definition in job.parameterDefinitions():
        if definition.isDestination():
            continue
        name, value = definition.name(), call.values.get(definition.name())
        files = _files(value)
        if files:
            yield call.algorithm, call.name, name, NO_FILE
            endings = set().union(*(FOLDERS.get(file.name, {file.suffix.lower()}) for file in files))
            for registered in BREAKAGES.values():
                if endings & set(registered.endings):
                    yield call.algorithm, call.name, name, registered.name
        else:
            yield call.algorithm, call.name, name, OTHER_VALUE


def _files(value: Any) -> list[Path]:
    if isinstance(value, list):
        return [path for one in value for path in _files(one)]
    return [value.path] if isinstance(value, Address) else [value] if isinstance(value, Path) else []


def grows(case: Case) -> bool:
    """Whether twice as much of its breakage can be made."""
    return case.breakage in BREAKAGES and BREAKAGES[case.breakage].grows


def values_of(case: Case, samples: Path, folder: Path, outside: Path, scale: int = 1) -> dict[str, Any]:
    """What the algorithm is given; broken files are made in the folder."""
    call, chance = case.sound_call, random.Random(str(case))
    values = {name: placed(value, samples) for name, value in call.values.items()}
    if case.parameter == NOTHING:
        return values
    job = created(case.algorithm)
    definition = job.parameterDefinition(case.parameter)
    if case.breakage == OTHER_VALUE:
        values[case.parameter] = other_value(definition, chance)
    elif case.breakage == NO_FILE:
        values[case.parameter] = other_input(values[case.parameter], definition, chance)
    else:
        values[case.parameter] = _broken(
            case, call.values[case.parameter], samples, folder, outside, chance, scale
        )
    return values


def _broken(
    case: Case, value: Any, samples: Path, folder: Path, outside: Path, chance: random.Random, scale: int
) -> Any:
    registered = BREAKAGES[case.breakage]
    if isinstance(value, list):
        at = chance.choice([n for n, one in enumerate(value) if one.suffix.lower() in registered.endings])
        made: list[Any] = list(placed(value, samples))
        made[at] = _broken(case, value[at], samples, folder, outside, chance, scale)
        return made
    path = value.path if isinstance(value, Address) else value
    copy = copied(samples / path, folder)
    if copy.is_dir():  # one of its files
        inside = [one for one in sorted(copy.rglob("*")) if one.is_file() and kind_of(one) in registered.endings]
        registered.breaks(Broken(chance.choice(inside), samples, chance, outside, scale))
        return str(copy)
    given = registered.breaks(Broken(copy, samples, chance, outside, scale))
    if isinstance(value, Address):
        return value.of(Path(given) if isinstance(given, str) else copy)
    return str(copy) if given is None else given
