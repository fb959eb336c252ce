"""Model files: JSON, complete and versioned, so that a fit can be used again by other programs."""
from __future__ import annotations

import dataclasses
import json
import math
import typing
from pathlib import Path
from typing import Any

import numpy as np

from ....imagery import messages as imagery_messages
from ....imagery.atomic_files import save_text
from ....imagery.documents.document_files import document_bytes, json_document
from ....imagery.errors import SensorModelError
from .. import messages
from . import registry
from .rpc import Domain
from .sensor_model import SensorModel

FORMAT = "seam_inspector sensor model"
VERSION = 1


@dataclasses.dataclass(frozen=True)
class ModelFile:
    """What a model file holds."""

    model: SensorModel
    wkt: str
    """System of the points it was fitted to; models in longitude and latitude ignore it."""
    domain: Domain
    facts: dict[str, Any]
    """Accuracy, condition, points and the like, for the reader."""


def save_model(file: ModelFile, path: Path) -> None:
    """Write a model file. Raises SettingsError where none can be."""
    kind = next(name for name, kind in registry.KINDS.items() if type(file.model) is kind.model_class())
    document = {
        "format": FORMAT,
        "version": VERSION,
        "model": kind,
        "conventions": {
            "image": "column and row in pixels, (0, 0) is the upper left corner of the first pixel",
            "ground": "longitude and latitude in degrees (EPSG:4326)" if file.model.GEOGRAPHIC else "x and y of 'crs'",
            "height": "metres above the ellipsoid",
            "scaling": "scaled = (value - offset) / scale",
            "terms": "1 x y z xy xz yz xx yy zz xyz xxx xyy xzz xxy yyy yzz xxz yyz zzz; in a plane without z",
        },
        "crs": file.wkt,
        "domain": dataclasses.asdict(file.domain),
        "parameters": _plain(file.model),
        "facts": _plain(file.facts),
    }
    save_text(json.dumps(document, indent=1, allow_nan=False) + "\n", path)


def load_model(path: Path) -> ModelFile:
    """Read a model file. Raises SensorModelError when it is none, or one of a newer version."""
    try:
        document = json_document(document_bytes(path).decode())
    except OSError:
        raise SensorModelError(imagery_messages.NOT_FOUND(path=path)) from None
    except ValueError:
        raise SensorModelError(messages.NO_MODEL_FILE(name=path.name)) from None
    if not isinstance(document, dict) or document.get("format") != FORMAT:
        raise SensorModelError(messages.NO_MODEL_FILE(name=path.name))
    if document.get("version") != VERSION:
        raise SensorModelError(messages.MODEL_FILE_VERSION(name=path.name, version=document.get("version")))
    try:
        model = _built(registry.KINDS[document["model"]].model_class(), document["parameters"])
        plain = document["domain"]
        parts = [(float(plain[field.name][0]), float(plain[field.name][1])) for field in dataclasses.fields(Domain)]
        domain = Domain(*parts)
        return ModelFile(model, str(document["crs"]), domain, document.get("facts", {}))
    except (KeyError, IndexError, TypeError, ValueError, AttributeError):
        raise SensorModelError(messages.NO_MODEL_FILE(name=path.name)) from None


def _plain(value: Any) -> Any:
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        return {field.name: _plain(getattr(value, field.name)) for field in dataclasses.fields(value)}
    if isinstance(value, dict):
        return {name: _plain(one) for name, one in value.items()}
    if isinstance(value, (list, tuple, np.ndarray)):
        return [_plain(one) for one in (value.tolist() if isinstance(value, np.ndarray) else value)]
    if isinstance(value, np.generic):
        value = value.item()
    return None if isinstance(value, float) and not math.isfinite(value) else value


def _built(kind: Any, plain: Any) -> Any:
    """A value of a type from what JSON keeps of it."""
    if kind is np.ndarray:
        array = np.array(plain, float)
        if not np.isfinite(array).all():
            raise ValueError
        return array
    if isinstance(kind, type) and dataclasses.is_dataclass(kind):
        hints = typing.get_type_hints(kind)
        return kind(**{field.name: _built(hints[field.name], plain[field.name]) for field in dataclasses.fields(kind)})
    return kind(plain)
