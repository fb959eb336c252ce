"""Seam Inspector: how much local contrast an orthophoto mosaic lost along its seams.

A plugin of QGIS, and a Python interface that needs no QGIS: ``from seam_inspector import open_block, inspect_window``.
``__init__.pyi`` lists its names; docs/python tells of them. Nothing is imported before it is asked for, since QGIS
loads this file when it starts.
"""

from functools import cache as _cache


def classFactory(iface: object) -> object:
    """The plugin, as QGIS asks for it. ``iface`` is None in qgis_process."""
    from .plugin.plugin import SeamInspectorPlugin

    return SeamInspectorPlugin(iface)


def __getattr__(name: str) -> object:
    """A name of the Python interface, all of them, or the version."""
    from importlib import import_module

    if name == "__version__":
        return _version()
    modules = {} if name.startswith("__") and name != "__all__" else _modules()
    if name == "__all__":
        return [*modules]
    if name not in modules:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    try:
        found = globals()[name] = getattr(import_module(modules[name], __name__), name)
    except ModuleNotFoundError as error:
        if error.name != "osgeo":
            raise
        raise ImportError(
            "GDAL's Python bindings are missing: install python3-gdal of the system, or gdal of conda"
        ) from error
    return found


def __dir__() -> "list[str]":
    dunder = [name for name in globals() if name.startswith("__")]
    return sorted([*dunder, "__all__", "__version__", *_modules()])


@_cache
def _modules() -> "dict[str, str]":
    """Where each name of the Python interface comes from, as the stub says it to type checkers."""
    import ast
    import pkgutil

    stub = ast.parse(pkgutil.get_data(__name__, "__init__.pyi") or b"")
    imports = [node for node in stub.body if isinstance(node, ast.ImportFrom) and node.level]
    return {alias.name: f".{node.module}" for node in imports for alias in node.names}


def _version() -> str:
    """As metadata.txt has it."""
    import pkgutil
    from configparser import ConfigParser

    parser = ConfigParser(interpolation=None)
    parser.read_string((pkgutil.get_data(__name__, "metadata.txt") or b"").decode())
    return parser["general"]["version"]
