"""Prints what a QGIS is made of, as JSON; run by the Python of that QGIS."""
import json
import platform

import numpy
import pywt
from osgeo import gdal
from qgis.core import Qgis
from qgis.PyQt.QtCore import QT_VERSION_STR

print(
    json.dumps({
        "QGIS": Qgis.QGIS_VERSION.split("-")[0],
        "Qt": QT_VERSION_STR,
        "Python": platform.python_version(),
        "numpy": numpy.__version__,
        "GDAL": gdal.__version__,
        "PyWavelets": pywt.__version__,
    })
)
