"""As much of QGIS 4's Python as parts of the plugin that only draw and listen need. Tests alone use it."""
