"""What parts of the plugin that only draw and listen need of QGIS 4's Python. Tests alone use it."""
