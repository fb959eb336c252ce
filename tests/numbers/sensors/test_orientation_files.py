"""Orientations as other programs write them: OpenCV sees the same places through the pose that was written."""
from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import cv2
import numpy as np
import pytest
from osgeo import osr
from seam_inspector.plugin.imagery.errors import SensorModelError
from seam_inspector.plugin.imagery.reference_systems import transform_points
from seam_inspector.plugin.sensors.measure.camera_files import document, orientation_file, read_cameras
from seam_inspector.plugin.sensors.measure.exterior_files import FrameExterior, read_exteriors
from seam_inspector.plugin.sensors.measure.frames import FrameCamera

SIZE = (4000, 3000)
MATRIX = np.array([[3000.0, 0, 2012], [0, 3000, 1493], [0, 0, 1]])
K1, K2, K3, P1, P2 = -0.1, 0.02, -0.003, 1e-3, -5e-4
ANGLES = (4.0, -7.0, 125.0)
PLACE = np.array([500_300.25, 5_540_700.5, 1850.75])
UTM = "EPSG:32633"
ORIGIN = (15.01, 50.01, 300.0)  # longitude, latitude and height of the plane that reconstructions are in
YAML = f"""cam:
  type: brown
  im_size: [4000, 3000]
  focal_len: 0.75
  cx: {12 / 4000}
  cy: {-7 / 4000}
  k1: {K1}
  k2: {K2}
  k3: {K3}
  p1: {P1}
  p2: {P2}
"""


def turned(omega: float, phi: float, kappa: float) -> np.ndarray:
    """Camera (x right, y up, z back) to ground, element by element (Kraus, Photogrammetry 1, appendix 2.1)."""
    (so, sp, sk), (co, cp, ck) = (trig(np.radians([omega, phi, kappa])) for trig in (np.sin, np.cos))
    return np.array([
        [cp * ck, -cp * sk, sp],
        [co * sk + so * sp * ck, co * ck - so * sp * sk, -so * cp],
        [so * sk - co * sp * ck, so * ck + co * sp * sk, co * cp],
    ])


PHOTO = turned(*ANGLES)
CAMERA = (PHOTO @ np.diag([1, -1, -1])).T  # ground to camera (x right, y down, z along the view)


def geocentric(places: np.ndarray, system: int = 32633) -> np.ndarray:
    """(n, 3) of a projected system and heights above the ellipsoid, by PROJ."""
    source, target = osr.SpatialReference(), osr.SpatialReference()
    source.ImportFromEPSG(system)
    source.PromoteTo3D()  # heights above the ellipsoid
    target.ImportFromEPSG(4978)
    for system in (source, target):
        system.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    return np.array(osr.CoordinateTransformation(source, target).TransformPoints(places.tolist()))


def local_axes(geographic: tuple[float, float, float]) -> np.ndarray:
    """(3, 3) rows east, north, up: differences of PROJ's geocentric coordinates."""
    step = 1e-5
    here = np.array([geographic, *(np.add(geographic, change) for change in np.diag([step, step, 1.0]))])
    steps = np.diff(geocentric(here, 4979)[[0, 1, 0, 2, 0, 3]], axis=0)[::2]
    return np.array(steps / np.linalg.norm(steps, axis=1, keepdims=True))


GROUND = PLACE + np.random.default_rng(4).uniform([-500, -500, -1600], [500, 500, -1300], (60, 3))


def opencv(ground: np.ndarray, turn: np.ndarray, place: np.ndarray, distorted: bool = True) -> np.ndarray:
    lens = np.array([K1, K2, P1, P2, K3]) if distorted else np.zeros(5)
    vector = cv2.Rodrigues(turn)[0]
    relative = (ground - place).astype(np.float64)
    return cv2.projectPoints(relative[:, None], vector, np.zeros(3), MATRIX, lens)[0][:, 0]


def exterior_of(path: Path, image: str = "IMG_2.jpg", angles: str = "auto") -> FrameExterior:
    return read_exteriors(document(path), path, angles).of(image)


def seen(exterior: Path, interior: Path | None = None, image: str = "IMG_2.jpg", angles: str = "auto") -> np.ndarray:
    path = orientation_file(exterior)
    exterior, interior = exterior_of(path, image, angles), interior or path
    lens = read_cameras(document(interior), interior).of(exterior.camera, SIZE)
    camera = FrameCamera(lens, exterior.position, exterior.axes, exterior.curvature)
    places = transform_points(GROUND, UTM, exterior.wkt or UTM)
    return camera.project(np.column_stack([places, GROUND[:, 2]]))


def rows(text: str, name: str = "IMG_2.jpg", factor: float = 1.0) -> str:
    """A template with the photo and one more."""
    values = dict(zip("xyzopk", (*PLACE, *(angle * factor for angle in ANGLES))))
    return text.format(n=name, **values) + "\n" + text.format(n="IMG_1.jpg", **dict(values, k=30 * factor)) + "\n"


COMMAS = rows("{n};{x};{y};{z};{o};{p};{k}", factor=1 / 0.9).replace(".", ",").replace(",jpg", ".jpg")
MATRIX_OF_PATB = " ".join(f"{value:16.12f}" for value in PHOTO.ravel()[:5]) + "\n" + " ".join(
    f"{value:16.12f}" for value in PHOTO.ravel()[5:])  # fmt: skip
TABLES = {
    "metashape": "# Cameras (2)\n# PhotoID, X, Y, Z, Omega, Phi, Kappa, r11, r12\n"
    + rows("{n}\t{x}\t{y}\t{z}\t{o}\t{p}\t{k}\t0.1\t0.2"),
    "pix4d": "imageName X Y Z Omega Phi Kappa\n" + rows("{n} {x} {y} {z} {o} {p} {k}"),
    "applanix": "POSEO\n(position in Meters, orientation in Degrees, lat, long in Deg)\nID\t# EVENT\tTIME(s)\tEASTING\t"
    "NORTHING\tELLIPSOID HEIGHT\tOMEGA\tPHI\tKAPPA\tLAT\tLONG\n"
    + rows("{n}\t3\t564155.65\t{x}\t{y}\t{z}\t{o}\t{p}\t{k}\t27.98\t-82.36"),
    "applanix aligned": "ID     # EVENT  TIME(s)   EASTING   NORTHING   ELLIPSOID HEIGHT  OMEGA  PHI   KAPPA\n"
    "               (s)  (m)  (m)\n" + rows("{n}  3  564155.65  {x}   {y}  {z}   {o}  {p}  {k}"),
    "applanix with units": "  ID  # EVENT   TIME (s)   EASTING (m)  NORTHING [m]   ELLIPSOID HEIGHT   OMEGA   PHI"
    "   KAPPA   LAT   LONG\n" + rows("  {n}  3  564155.65  {x}  {y}  {z}  {o}  {p}  {k}  27.98  -82.36"),
    "gon and decimal commas": "Photo;Easting;Northing;Altitude;Omega [gon];Phi [gon];Kappa [gon]\n" + COMMAS,
    "commas and blanks": "Image E N H Omega(deg) Phi(deg) Kappa(deg)\n"
    + rows("{n} {x} {y} {z} {o} {p} {k}").replace(".", ",").replace(",jpg", ".jpg"),
    "orthority": "'filename' 'easting' 'northing' 'altitude' 'omega' 'phi' 'kappa' 'camera'\n"
    + rows("'{n}' {x} {y} {z} {o} {p} {k} 'a camera'"),
    "no header": rows("{n}, {x}, {y}, {z}, {o}, {p}, {k}"),
    "another order": "kappa;phi;omega;z;y;x;filename\n" + rows("{k};{p};{o};{z};{y};{x};{n}"),
    "patb": "".join(f"{name} 153000.0 {PLACE[0]} {PLACE[1]} {PLACE[2]}\n{MATRIX_OF_PATB}\n" for name in
                    ("IMG_2", "IMG_1")) + "-99\n",
}  # fmt: skip


@pytest.mark.parametrize("name", TABLES)
def test_tables_of_orientations_are_read_with_their_units(tmp_path: Path, name: str) -> None:
    (tmp_path / "camera.yaml").write_text(YAML)
    (tmp_path / "places.txt").write_text(TABLES[name])
    np.testing.assert_allclose(
        seen(tmp_path / "places.txt", tmp_path / "camera.yaml"), opencv(GROUND, CAMERA, PLACE), atol=1e-6
    )


@pytest.mark.parametrize("text", [
    "#name latitude longitude altitude omega phi kappa\nIMG_2 50.1 15.2 1500 1 2 3\n",  # columns are not guessed
    "Photo Label X Y Z Omega Phi Kappa r11 r12\nIMG_2 500300.25 5540700.5 1850.75 4 -7 125 0.1 0.2\n",  # nor one off
    "Photo X Y Z Omega Phi Kappa r11\nIMG_2 500300.25 5540700.5 1850.75 4 -7 125 0.1 0.2\n",
    *("filename x y z omega phi kappa " + ending  # which patterns would look through for hours
      for ending in ("(" * 3_000_000, "omega" * 600_000, "PROJCS[" * 400_000)),
], ids=range(6))  # fmt: skip
def test_what_is_no_table_is_refused(tmp_path: Path, text: str) -> None:
    path = tmp_path / "places.txt"
    path.write_text(text)
    with pytest.raises(SensorModelError, match=r"places\.txt holds .* choose a table with the columns"):
        exterior_of(path)


@pytest.mark.parametrize("angles", ["auto", "gon"])
def test_gon_are_asked_for_where_a_file_does_not_name_them(tmp_path: Path, angles: str) -> None:
    path, turn = tmp_path / "places.csv", (4.0, -7.0, -179.1)
    gons = ",".join(str(angle / 0.9) for angle in turn)
    path.write_text(f"filename,x,y,z,omega,phi,kappa\nIMG_2,1,2,3,{gons}\n")
    exterior = exterior_of(path, "IMG_2.jpg", angles)
    assert bool(exterior.notices) == (angles == "auto")
    assert all("reach 199 and are taken as degrees" in str(notice) for notice in exterior.notices)
    if angles == "gon":
        np.testing.assert_allclose(exterior.axes, turned(*turn) @ np.diag([1, -1, -1]), atol=1e-12)


def pix4d(folder: Path) -> Path:
    offset = np.array([500_000.0, 5_540_000.0, 0.0])
    (folder / "block_offset.xyz").write_text("500000.000 5540000.000 0.000")
    lines = [
        "fileName imageWidth imageHeight", "camera matrix K [3x3]", "", "IMG_2.jpg 4000 3000",
        *(" ".join(map(repr, row.tolist())) for row in MATRIX), f"{K1} {K2} {K3}", f"{P1} {P2}",
        " ".join(map(repr, (PLACE - offset).tolist())), *(" ".join(map(repr, row.tolist())) for row in CAMERA),
    ]  # fmt: skip
    path = folder / "block_calibrated_camera_parameters.txt"
    path.write_text("\n".join(lines) + "\n")
    return path


def block(rotation: str, orientation: str, folder: Path) -> Path:
    x, y, z = PLACE
    path = folder / "block.xml"
    path.write_text(f"""<?xml version="1.0" encoding="utf-8"?><BlocksExchange version="2.1">
<SpatialReferenceSystems><SRS><Id>0</Id><Definition>{UTM}</Definition></SRS></SpatialReferenceSystems><Block><SRSId>0</SRSId><Photogroups><Photogroup>
<ImageDimensions><Width>4000</Width><Height>3000</Height></ImageDimensions>
<CameraModelType>Perspective</CameraModelType><FocalLength>24</FocalLength><SensorSize>32</SensorSize>
<CameraOrientation>{orientation}</CameraOrientation><PrincipalPoint><x>2012</x><y>1493</y></PrincipalPoint>
<Distortion><K1>{K1}</K1><K2>{K2}</K2><K3>{K3}</K3><P1>{P2}</P1><P2>{P1}</P2></Distortion><Photo><Id>0</Id>
<ImagePath>D:/photos/IMG_2.jpg</ImagePath><Pose><Rotation>{rotation}</Rotation><Center><x>{x}</x><y>{y}</y><z>{z}</z>
</Center></Pose></Photo></Photogroup></Photogroups></Block></BlocksExchange>""")
    return path


def block_of_elements(folder: Path) -> Path:
    elements = (f"<M_{row}{column}>{value}</M_{row}{column}>" for (row, column), value in np.ndenumerate(CAMERA))
    return block("".join(elements), "XRightYDown", folder)


def block_of_angles(folder: Path) -> Path:
    names = zip(("Omega", "Phi", "Kappa"), ANGLES)
    return block("".join(f"<{name}>{value}</{name}>" for name, value in names), "XRightYUp", folder)


def odm(folder: Path) -> Path:
    """A project whose reconstruction is in UTM, less an offset in a file of its own."""
    (folder / "opensfm").mkdir()
    (folder / "odm_georeferencing").mkdir()
    (folder / "odm_georeferencing" / "coords.txt").write_text("WGS84 UTM 33N\n500000 5540000\n0 0 0\n")
    offset = np.array([500_000.0, 5_540_000.0, 0.0])
    _reconstruction(folder / "opensfm" / "reconstruction.json", CAMERA, PLACE - offset)
    return folder


@pytest.mark.parametrize("make", [pix4d, block_of_elements, block_of_angles, odm])
def test_files_with_cameras_in_projected_coordinates(tmp_path: Path, make: Callable[[Path], Path]) -> None:
    np.testing.assert_allclose(seen(make(tmp_path)), opencv(GROUND, CAMERA, PLACE), atol=1e-6)


def test_a_block_that_says_no_model_is_perspective_and_a_fisheye_is_refused(tmp_path: Path) -> None:
    path = block_of_elements(tmp_path)
    text = path.read_text()
    path.write_text(text.replace("<CameraModelType>Perspective</CameraModelType>", ""))
    np.testing.assert_allclose(seen(path), opencv(GROUND, CAMERA, PLACE), atol=1e-6)
    path.write_text(text.replace(">Perspective<", ">Fisheye<"))
    with pytest.raises(SensorModelError, match="Fisheye"):
        seen(path)


@pytest.mark.parametrize("mount", [0, 90])
def test_an_inpho_project(tmp_path: Path, mount: int) -> None:
    """A camera of 5 um that is mounted straight, or turned so that its x is up in the image."""
    affine = {0: "200 0 2011.5 0 -200 1492.5", 90: "0 -200 2011.5 -200 0 1492.5"}[mount]
    # x right, y up of the camera as it is mounted, by those of the image
    mounted = np.eye(3) if mount == 0 else np.array([[0.0, 1, 0], [-1, 0, 0], [0, 0, 1]])
    rotation = "\n".join(" ".join(f"{element:.15f}" for element in row) for row in mounted @ PHOTO.T)
    path = tmp_path / "flight.prj"
    path.write_text(f"""$PROJECT 6.0.0
$END
$CAMERA_DEFINITION
  $ID : cam
  $CCD_COLUMNS : 4000
  $CCD_ROWS : 3000
  $PIXEL_REFERENCE : CenterTopLeft
  $CALIBRATION_SET :
    $CCD_INTERIOR_ORIENTATION :
      {affine}
    $FOCAL_LENGTH : 15
    $PRINCIPAL_POINT_PPA : 0 0
    $END
$END
$PHOTO
  $PHOTO_NUM : 2
  $PHOTO_FILE : D:\\photos\\IMG_2.jpg
  $CAMERA_ID : cam
  $EXT_ORI : 12:00:00 01/01/2026
    15 {PLACE[0]} {PLACE[1]} {PLACE[2]}
    {rotation}
$END
""")
    np.testing.assert_allclose(seen(path), opencv(GROUND, CAMERA, PLACE, distorted=False), atol=1e-5)


def _reconstruction(path: Path, turn: np.ndarray, place: np.ndarray) -> None:
    longitude, latitude, altitude = ORIGIN
    camera = {"projection_type": "brown", "width": 4000, "height": 3000, "focal_x": 0.75, "focal_y": 0.75,
              "c_x": 12 / 4000, "c_y": -7 / 4000, "k1": K1, "k2": K2, "k3": K3, "p1": P1, "p2": P2}  # fmt: skip
    shot = {"rotation": cv2.Rodrigues(turn)[0].ravel().tolist(), "translation": (-turn @ place).tolist(),
            "camera": "v2 dji"}  # fmt: skip
    path.write_text(json.dumps([{
        "cameras": {"v2 dji": camera}, "shots": {"IMG_2.jpg": shot},
        "reference_lla": {"longitude": longitude, "latitude": latitude, "altitude": altitude},
    }]))  # fmt: skip


def opensfm(folder: Path, turn: np.ndarray, place: np.ndarray) -> Path:
    axes, origin = local_axes(ORIGIN), geocentric(np.array([ORIGIN]), 4979)[0]
    _reconstruction(folder / "reconstruction.json", turn @ axes.T, axes @ (place - origin))
    return folder


def metashape(folder: Path, turn: np.ndarray, place: np.ndarray) -> Path:
    """A chunk in a system of its own, a tenth as large, turned and shifted."""
    to_earth, shift, scale = cv2.Rodrigues(np.array([0.4, -1.1, 0.7]))[0], place + [70.0, -40, 90], 10.0
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = to_earth.T @ turn.T, to_earth.T @ (place - shift) / scale
    path = folder / "cameras.xml"
    path.write_text(f"""<document version="1.5.0"><chunk label="1"><sensors><sensor id="0" type="frame">
<resolution width="4000" height="3000"/><calibration type="frame" class="adjusted">
<resolution width="4000" height="3000"/><f>3000</f><cx>12</cx><cy>-7</cy><k1>{K1}</k1><k2>{K2}</k2><k3>{K3}</k3>
<p1>{P2}</p1><p2>{P1}</p2></calibration></sensor></sensors><components><component id="0"><transform>
<rotation>{" ".join(map(str, to_earth.ravel()))}</rotation><translation>{" ".join(map(str, shift))}</translation>
<scale>{scale}</scale></transform></component></components><cameras>
<camera id="0" sensor_id="0" component_id="0" label="IMG_2"><transform>{" ".join(map(str, pose.ravel()))}</transform>
</camera><camera id="1" sensor_id="0" label="IMG_1"/></cameras></chunk></document>""")
    return path


@pytest.mark.parametrize("make", [opensfm, metashape])
def test_files_in_coordinates_of_space_are_seen_as_from_the_earth_s_middle(
    tmp_path: Path, make: Callable[[Path, np.ndarray, np.ndarray], Path]
) -> None:
    """1.5 km above ground, where the plane that touches the Earth is 4 cm off at the corners."""
    place, ground = geocentric(np.array([PLACE]))[0], geocentric(GROUND)
    longitude, latitude = transform_points(PLACE[None, :2], UTM, "EPSG:4326")[0].tolist()
    turn = CAMERA @ local_axes((longitude, latitude, float(PLACE[2])))
    np.testing.assert_allclose(seen(make(tmp_path, turn, place)), opencv(ground, turn, place), atol=2e-3)


def test_the_reading_of_a_reconstruction_is_told(tmp_path: Path) -> None:
    """Alone it is in the plane at its reference, in a project in UTM, and exact beside its topocentric form."""
    path = odm(tmp_path) / "opensfm" / "reconstruction.json"
    (notice,) = exterior_of(path).notices
    assert "is read in EPSG:32633 with the offset of coords.txt, where OpenDroneMap puts it" in str(notice)
    path.with_name("reconstruction.topocentric.json").write_text(path.read_text())
    assert "Photos are placed by reconstruction.topocentric.json" in str(exterior_of(path).notices[0])
    alone = tmp_path / "reconstruction.json"
    alone.write_text(path.read_text())
    assert "in the plane tangent to the Earth at its reference" in str(exterior_of(alone).notices[0])


@pytest.mark.parametrize("cameras", [False, True])
def test_each_part_of_a_reconstruction_has_its_own_reference_and_cameras(tmp_path: Path, cameras: bool) -> None:
    """The second part is 3 km away and its camera longer; OpenDroneMap's cameras.json names one for all."""
    place, ground = geocentric(np.array([PLACE]))[0], geocentric(GROUND)
    longitude, latitude = transform_points(PLACE[None, :2], UTM, "EPSG:4326")[0].tolist()
    turn = CAMERA @ local_axes((longitude, latitude, float(PLACE[2])))
    part = json.loads(opensfm(tmp_path, turn, place).joinpath("reconstruction.json").read_text())[0]
    other = json.loads(json.dumps(part).replace("IMG_2", "IMG_9"))
    other["reference_lla"]["latitude"] += 0.03
    other["cameras"]["v2 dji"]["focal_x"] = other["cameras"]["v2 dji"]["focal_y"] = 1.5
    path = tmp_path / "reconstruction.json"
    path.write_text(json.dumps([other, part]))
    known = {"dji": part["cameras"]["v2 dji"], "another": other["cameras"]["v2 dji"]}
    (tmp_path / "cameras.json").write_text(json.dumps(known))
    given = tmp_path / "cameras.json" if cameras else path
    np.testing.assert_allclose(seen(path, given), opencv(ground, turn, place), atol=2e-3)
    far = exterior_of(path, "IMG_9.jpg")
    assert float(far.wkt.split("lat_0=")[1].split()[0]) - latitude == pytest.approx(0.03, abs=1e-5)
    lens = read_cameras(document(given), given).of(far.camera, SIZE)
    assert lens.focal == pytest.approx(3000 if cameras else 6000)


def test_photos_that_are_not_aligned_are_not_oriented(tmp_path: Path) -> None:
    path = metashape(tmp_path, np.eye(3), geocentric(np.array([PLACE]))[0])
    with pytest.raises(SensorModelError, match="does not name the image IMG_1"):
        exterior_of(path, "IMG_1.jpg")
