"""Stand-in for ``qgis.utils``: no interface."""
iface = None
