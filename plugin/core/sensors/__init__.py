"""Sensor models: from points to a model, its accuracy, an RPC, and an orthoimage.

Image coordinates are (column, row) in pixels as GDAL counts them: (0, 0) is the upper left corner of the first
pixel, (0.5, 0.5) its centre. Ground coordinates are (x, y) in the units of a reference system, x first, and a
height in metres above the ellipsoid.
"""
