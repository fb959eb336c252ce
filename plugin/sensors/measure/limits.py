"""Limits and defaults that several files here share, each with its source."""
from __future__ import annotations

WGS84_SEMI_MAJOR_M = 6378137.0
HEIGHT_DATUMS = ("auto", "ellipsoid", "egm96", "egm2008", "geoid")  # auto: what the system says; geoid: a grid file
ANGLE_UNITS = ("auto", "degrees", "gon", "radians")  # auto: what the file says, else degrees
EXTERIOR_DATUMS = ("as_terrain", "ellipsoid", "egm96", "egm2008", "geoid")  # as_terrain: no conversion at all
MAX_NEWTON_ITERATIONS = 30  # the inverse of a smooth model takes four or five
EXACT_STEP_PX = 1e-7  # an iteration has settled: a tenth of the accuracy that exact points are recovered with
MIN_SIGMA_PX = 1e-7  # rounding: no measured coordinate is better
MAX_LINEAR_CONDITION = 1e6  # of the affine camera through the points, its columns scaled
DEFAULT_ORBIT_HEIGHT_KM = 694.0  # pushbroom: Pleiades; IKONOS 681, QuickBird 450, EROS-A1 480, WorldView-3 617
RESAMPLINGS = ("nearest", "bilinear", "cubic", "cubicspline", "lanczos", "average")  # GDAL's warper
ORTHO_FORMATS = ("GTiff", "COG")  # GDAL's drivers
SPREADS = ("grid", "random", "corner")  # of planned control points: a grid over the image, anywhere, one corner
