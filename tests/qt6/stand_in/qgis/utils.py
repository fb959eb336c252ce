"""As ``qgis.utils``: no interface."""
iface = None
