"""Messages about satellite images: points, sensor models, RPCs, terrain and orthorectification."""
from __future__ import annotations

from ...imagery.errors import INFO, WARNING, Message

# points
NO_POINTS = Message("There are no points to fit a model to; measure some, or choose another layer.")
NO_POINTS_LEFT = Message("No point is left to fit a model to: {why} Correct the layer, or choose another one.")
NO_POINTS_FILE = Message(
    "{name} is not a points file of QGIS's georeferencer (its header names no mapX, mapY and sourceX or pixelX); "
    "choose one, or a point layer with the fields column and row.")
NO_POINTS_IN_IMAGE = Message("{name} holds no sound ground control points; choose a layer or a file of points.")
POINTS_LINE_UNREADABLE = Message("Line {line} of {name} can't be read; correct or remove it.")
POINTS_WITHOUT_SYSTEM = Message(
    "{name} names no coordinate reference system, as files from before QGIS 3.26 do; set the points' reference system.")
POINTS_WITHOUT_FIELD = Message(
    "The point layer has no field '{field}'; it needs column and row, the place of each point in the image in pixels.")
POINTS_DISABLED = Message("Points that are switched off in the georeferencer and left out: {count}.", INFO)
POINT_LEFT_OUT = Message("Point {name} is left out: {why}", WARNING)
# why a point is left out
POINT_WITHOUT_PLACE = Message("its place in the image or on the ground is missing.", INFO)
POINT_ROLE_UNKNOWN = Message("its role '{role}' is neither control nor check.", INFO)
POINT_WITHOUT_HEIGHT = Message("it has no height, and no terrain model has one there.", INFO)
# points that can't be what they are said to be
POINTS_NO_DEGREES = Message(
    "By their reference system the points are in degrees, but one is at {x:.10g}, {y:.10g}; set the reference system "
    "that their coordinates are in.")
PIXEL_IMPLAUSIBLE = Message(
    "According to the points a pixel measures {size:.2g} m on the ground; check that their reference system is the one "
    "that their coordinates are in.")
ROWS_NEGATIVE = Message(
    "The points' rows are negative, as QGIS's georeferencer shows them; give them from the upper edge downwards, all "
    "positive, or the .points file itself.")
COLUMNS_AND_ROWS_INTERCHANGED = Message(
    "According to the image or its RPC the points' columns and rows are swapped; swap the two fields.")
POINTS_OUTSIDE_IMAGE = Message(
    "{count} points lie outside the image of {columns} x {rows} pixels ({names}); correct or remove them, or choose "
    "their image.")
POINTS_BEYOND_RPC_HEIGHTS = Message(
    "{count} points ({names}) are {low:.0f} to {high:.0f} m high, and the image's RPC holds for {first:.0f} to "
    "{last:.0f} m; apart from a shift they miss the RPC by {missed:.3g} px. Errors and recommendation mean nothing if "
    "the heights are wrong, so check them and their unit.", WARNING)
POINTS_BEYOND_IMAGE = Message(
    "{count} points lie outside the image ({names}), where its RPC places them, too; they are used.", WARNING)
HEIGHTS_IN_FEET = Message(
    "According to the image's RPC the points' heights are in feet: as metres they miss it by {metres:.3g} px, as feet "
    "by {feet:.3g} px; give metres.")
RPC_SEES_NO_POINTS = Message(
    "The image's RPC sees the points {distance:.3g} px away from the image; check that x and y are not interchanged, "
    "their reference system and heights, and that it is the RPC of this image.")
RPC_SEES_TURNED = Message(
    "According to the image's RPC the points are measured in a mirrored or turned image; count columns and rows from "
    "the upper left corner of the image that the RPC belongs to.")
# points that do not determine a model
NO_HEIGHTS = Message(
    "Some points have no height, which the model {model} needs; add a field z or choose a terrain model, or take "
    "polynomial_2d.")
TOO_FEW_POINTS = Message(
    "There are {count} control points and the model {model} needs at least {fewest}; measure more, lower the share of "
    "check points, or choose a model with fewer unknowns.")
POINTS_ON_A_LINE = Message(
    "The control points lie on one line, so the model {model} can't be fitted; add points to both sides of it.")
POINTS_ON_A_PLANE = Message(
    "The control points lie on one plane, so the terms in Z of the model {model} can't be determined; add points of "
    "other heights, or take polynomial_2d or rpc_bias.")
TOO_MANY_BLUNDERS = Message(
    "{count} control points contradict the others, and too few are left to fit the model {model}; check the points, "
    "above all that columns and rows are not interchanged.")
# points that determine a model badly
BLUNDERS_FOUND = Message(
    "Blunders found and left out of fit and errors: {count} ({names}); check those points and measure them "
    "again.", WARNING)
CONTROL_LEAVES_OPEN = Message(
    "The control points leave {share:.0%} of the image outside their outline; what lies there is extrapolated, so add "
    "points towards the image's corners.", WARNING)
BLUNDERS_POSSIBLE = Message(
    "{count} points miss the model by far more than the others ({names}); check them, or look for blunders "
    "(ROBUST).", WARNING)
CHECK_POINTS_MISSING = Message(
    "There are no check points, so the errors given are those of the fit on its own points; set roles or a share of "
    "check points.", WARNING)
# the fit
NOT_CONVERGED = Message(
    "The fit did not converge within {iterations} iterations, so the points are too few or too noisy for it; add "
    "points or choose a model with fewer unknowns.", WARNING)
ILL_CONDITIONED = Message(
    "The points hardly determine the model (condition {condition:.0e}): between them it may oscillate, so trust the "
    "check points only or choose a lower order.", WARNING)
FIT_DIVERGED = Message(
    "The model can't be fitted to these points; check for interchanged coordinates or wrong heights, look for blunders "
    "(ROBUST), or choose a model with fewer unknowns.")
NOT_INVERTED = Message(
    "The model can't be inverted over the image, so it is unsound away from its points; check their places, heights "
    "and reference system, choose a lower order, or add points.")
# RPCs
NO_RPC = Message("The image has no RPC of its own; give the file that came with it, or choose a model that needs none.")
RPC_INCOMPLETE = Message("{name} holds no complete RPC; get the file again from the image's vendor.")
RPC_BIAS_FOUND = Message(
    "The RPC is off by {columns:.2f} columns and {rows:.2f} rows in the middle of the image, by {most:.2f} px where it "
    "is worst; the model corrects that.", INFO)
PLANE_MODEL_HAS_NO_RPC = Message(
    "The model polynomial_2d ignores heights and can't be written as RPC or used for orthorectification; fit a model "
    "in space.")
RPC_NOT_WRITTEN = Message("No RPC is written: {why}", WARNING)
RPC_FITTED = Message(
    "The RPC follows the model to {rms:.2g} px (root mean square) and {largest:.2g} px at most, over the whole image "
    "and heights of {low:.0f} to {high:.0f} m.", INFO)
RPC_IMAGE_WITHOUT_IMAGE = Message(
    "No image with the RPC is written, as there is no image to copy; choose the image.", WARNING)
RPC_OF_WHOLE_SCENE = Message(
    "The image is taken as a part of the scene that the RPC describes, from column {column:.0f} and row {row:.0f} "
    "on.", INFO)
# model files
NO_MODEL_FILE = Message("{name} is not a sensor model file; choose one that Fit sensor model has written.")
MODEL_FILE_VERSION = Message(
    "{name} is of version {version}, which this version of Seam Inspector does not read; fit the model again.")
SEVERAL_MODELS = Message(
    "Several of a model file, an RPC file and a photo's orientation are given; choose one of them.")
# frame cameras
NO_INTERIOR = Message(
    "{name} holds no camera that can be read; choose a file of orthority, OpenSfM, Metashape, Pix4D, Inpho "
    "or ContextCapture that does.")
INTERIOR_OF_ANOTHER_SHAPE = Message(
    "The camera of {name} has {width} x {height} pixels and the image {columns} x {rows}, which is another shape; "
    "choose the camera's own image, uncropped and not turned.")
YAML_MISSING = Message(
    "{name} is read by the Python package PyYAML, which is not installed; install it, or give a camera as JSON or XML.")
PIXELS_NOT_SQUARE = Message(
    "According to {name} a pixel is {ratio:.2g} times as wide as it is high; check whether the sensor's sides are "
    "interchanged.")
ANGLES_PERHAPS_OTHERS = Message(
    "Angles of {name} reach {angle:.6g} and are taken as degrees; if they are in {unit}, set their unit.", WARNING)
ROTATION_TAKEN = Message(
    "The rotation of {name} is read as {way} usually writes it, since no file states it; check the orthoimage's "
    "position.", INFO)
PLANE_TAKEN = Message(
    "{name} is read in the plane tangent to the Earth at its reference, as OpenSfM writes it. One that OpenDroneMap "
    "has put into UTM is read correctly only inside its project's folder.", INFO)
TOPOCENTRIC_TAKEN = Message("Photos are placed by {exact}, the exact reconstruction beside {name}.", INFO)
UTM_TAKEN = Message(
    "{name} is read in {system} with the offset of {offsets}, where OpenDroneMap puts it approximately: up to some "
    "decimetres off in a block of a kilometre.", INFO)
CAMERA_UNKNOWN = Message(
    "{name} holds several cameras ({names}) and the exterior orientation names none of them; leave one in the file.")
DISTORTION_UNKNOWN = Message(
    "The camera of {name} has a distortion that is not supported ({kind}); pinhole, Brown's, OpenCV's and fisheye "
    "lenses are.")
NO_EXTERIOR = Message(
    "{name} holds no exterior orientation that can be read; choose a table with the columns filename, x, y, z, omega, "
    "phi, kappa, or a file of OpenSfM, Metashape, Pix4D, Inpho, PATB, ContextCapture or orthority.")
IMAGE_NOT_ORIENTED = Message(
    "{name} does not name the image {image} exactly once; it names {names}. Choose the file of this image.")
ORIENTATION_INCOMPLETE = Message("An interior orientation needs an exterior one; give it, too.")
# blocks of photos
NO_BLOCK = Message(
    "Choose the folder of an OpenDroneMap project, with opensfm/reconstruction.json in it (PHOTOS), or the file of the "
    "photos' orientations (EXTERIOR).")
PHOTO_MISSING = Message("{name} is oriented and is not in {folder}; it is left out.", WARNING)
PHOTO_LEFT_OUT = Message("{name} is left out: {why}", WARNING)
NO_PHOTOS = Message("None of the photos that {name} names is in {folder}; choose their folder (PHOTOS).")
PROJECT_TERRAIN = Message("The terrain is that of the project: {name}.", INFO)
EXTERIOR_NOT_METRIC = Message(
    "The exterior orientation {name} is in no projected coordinate reference system in metres, which the camera's "
    "perspective needs; set one, with x, y and z in it.")
CAMERA_BELOW_TERRAIN = Message(
    "The camera of {name} is at {height:.0f} m, not above the terrain at {low:.0f} to {high:.0f} m; check the heights, "
    "their units and the reference system.")
ORTHO_APPROXIMATE = Message(
    "The orthoimage is up to {most:.1f} px off the exact model, since an RPC approximates it.", WARNING)
CAMERA_LOOKS_UP = Message(
    "The camera of {name} looks at the horizon or above it, so that a part of the image has no place on the ground; "
    "check omega, phi and kappa.")
LENS_FOLDS = Message(
    "The distortion of the camera is not valid at a part of the photo's edge; check its coefficients and the size of "
    "the image that they belong to.")
TERRAIN_EMPTY = Message("The terrain model {name} has no heights at all; choose another one.")
EXTERIOR_SYSTEM_TAKEN = Message("The exterior orientation is taken as in the image's own reference system.", INFO)
# heights and terrain
HEIGHTS_ASSUMED = Message(
    "{name} does not say what its heights refer to; they are taken as above the ellipsoid. Heights above sea level "
    "differ by up to 100 m: choose egm96 or egm2008 for these.", WARNING)
HEIGHTS_CONVERTED = Message(
    "The heights of {name} ({vertical}) are converted to the ellipsoid: {least:.1f} to {most:.1f} m are added.", INFO)
NO_GEOID = Message(
    "{name} is not a geoid grid (heights of sea level above the ellipsoid, m, rows from north to south); choose one, "
    "such as a .gtx or .tif of PROJ.")
GEOID_NOT_COVERING = Message("The grid {name} has no values at some of the places; choose one that covers them.")
GEOID_OR_NONE = Message("Heights that refer to geoid need a grid file (GEOID), and no others do; give both or neither.")
TERRAIN_OR_HEIGHT = Message("Give either a terrain model or, where the terrain is flat, a constant height.")
HEIGHTS_IMPLAUSIBLE = Message(
    "Heights from {low:.6g} to {high:.6g} m ({name}) are impossible on Earth; give metres, the lowest first, and set "
    "the nodata value of a terrain model.")
DEM_NOT_COVERING = Message(
    "The terrain model {name} does not cover the image, which lies at {west:.4f} to {east:.4f} degrees east, "
    "{south:.4f} to {north:.4f} degrees north; choose one that does.")
DEM_PARTLY_COVERING = Message(
    "The terrain model {name} has no heights under {share:.1%} of the image (holes, or it ends there); the orthoimage "
    "is empty there, so fill or extend the terrain model.", WARNING)
DEM_TOO_LARGE = Message(
    "The terrain model {name} has {count} million pixels under the image, but at most {most} million can be used; "
    "resample it, 10 to 30 m work best.")
MESH_UNUSUAL = Message(
    "The terrain model {name} has a grid spacing of {mesh:.1f} m; 10 to 30 m work best: a coarser grid loses relief, "
    "and a finer one may bend straight lines such as roads in a satellite image.", WARNING)
VIEW_TOLD = Message(
    "The image was taken {angle:.1f} degrees from the vertical (at most {largest:.1f} in its corners) from azimuth "
    "{azimuth:.0f}; an error of {error:g} m in the terrain's heights moves its middle by {shift:.2f} m.", INFO)
# orthorectification
PIXEL_SIZE_NOT_POSITIVE = Message("The pixel size is {size}; give a positive number of map units.")
EXTENT_WITHOUT_SYSTEM = Message("An extent is given but no reference system; choose the orthoimage's reference system.")
EXTENT_OUTSIDE = Message("The extent lies outside the image; choose one that overlaps it.")
ORTHO_TOO_LARGE = Message("The orthoimage would have {width} x {height} px; choose larger pixels or a smaller extent.")
WARP_FAILED = Message("The orthoimage could not be written ({error}); check the folder and the free space.")
# planning
PLAN_COUNTS_UNREADABLE = Message(
    "The numbers of control points are '{given}'; give whole numbers from 1 to {most}, such as 6, 10, 20.")
PLAN_IMAGE_WITHOUT_RPC = Message(
    "The image has no RPC to plan by; give the file that came with it, or leave the image out for a nominal scanner.")
PLAN_TOLD = Message(
    "With {count} control points expect {usual:.2f} m over the image; nine times in ten at most {most:.2f} m.", INFO)
PLAN_DRAWS_FAILED = Message("With {count} control points {failed} draws failed and count as the worst: {why}", WARNING)
# the recommendation
RECOMMENDED = Message(
    "Use {model}: {rmse:.2f} m on points not used in its fit (the best has {best:.2f} m). {why}", INFO)
RECOMMEND_PUSHBROOM = Message("A parametric model needs few points and does not oscillate between them.", INFO)
RECOMMEND_RPC_BIAS = Message("The vendor's RPC holds the image's geometry and a few points remove its offset.", INFO)
RECOMMEND_RATIONAL = Message(
    "Without a parametric basis, quotients are the soundest models, but they need many, well spread points.", INFO)
RECOMMEND_DLT = Message("It is the quotient of lowest order with one denominator and needs the fewest points.", INFO)
RECOMMEND_POLYNOMIAL_3D = Message(
    "Polynomials suit small areas only and oscillate between the points, so watch the check points.", INFO)
RECOMMEND_POLYNOMIAL_2D = Message(
    "The terrain is flat enough for a plane model, which serves for small areas only.", INFO)
NOTHING_TO_RECOMMEND = Message(
    "No model could be fitted and judged; the table says why for each, so measure more points or correct them.", INFO)
