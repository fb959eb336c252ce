"""Seam Inspector: how much local contrast an orthophoto mosaic lost along its seams."""


def classFactory(iface: object) -> object:
    """The plugin, as QGIS asks for it. ``iface`` is None in qgis_process."""
    from .plugin.plugin import SeamInspectorPlugin

    return SeamInspectorPlugin(iface)
