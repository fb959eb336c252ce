"""RPCs, points and heights, written as GDAL and QGIS read them, and read as others write them."""
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal, osr
from seam_inspector.plugin.imagery.errors import RasterError, SensorModelError
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.sensors.measure.heights import Geoid, above_ellipsoid
from seam_inspector.plugin.sensors.measure.points import control_points, file_points, image_points, write_point_file
from seam_inspector.plugin.sensors.measure.rpc import open_image, read_rpc, to_metadata, write_rpc

from tests.numbers.sensors.sensor_scenes import made_rational


def image_file(path: Path) -> str:
    dataset = gdal.GetDriverByName("GTiff").Create(str(path), 30, 20, 2, gdal.GDT_UInt16)
    dataset.WriteArray(np.arange(1200, dtype=np.uint16).reshape(2, 20, 30))
    dataset.FlushCache()
    return str(path)


def assert_same_rpc(items: dict[str, str], expected: dict[str, str]) -> None:
    for name, value in expected.items():
        np.testing.assert_allclose(
            np.array(items[name].split(), float), np.array(value.split(), float), rtol=1e-9, atol=1e-12, err_msg=name
        )


@pytest.mark.parametrize("name", ["image.RPB", "image_RPC.TXT"])
def test_gdal_reads_an_rpc_beside_its_image(tmp_path: Path, name: str) -> None:
    rpc = made_rational(3, 4)
    write_rpc(rpc, tmp_path / name)
    assert_same_rpc(gdal.Open(image_file(tmp_path / "image.tif")).GetMetadata("RPC"), to_metadata(rpc))
    assert_same_rpc(to_metadata(read_rpc(tmp_path / name)), to_metadata(rpc))


@pytest.mark.parametrize("transform", [None, (500.0, 2.0, 0.1, 900.0, 0.2, -3.0), (0.0, 1.0, 0.0, 0.0, 0.0, 1.0)])
def test_points_come_back_from_the_georeferencers_file(
    tmp_path: Path, transform: tuple[float, ...] | None
) -> None:
    image, ground = np.array([[1.5, 2.25], [10.0, 7.0]]), np.array([[7.1, 43.6, 1.0], [7.2, 43.7, 2.0]])
    points, path = control_points(["1", "2"], image, ground, "EPSG:4326"), tmp_path / "image.points"
    write_point_file(path, points, np.array([True, True]), np.array([[3.0, -4.0], [0.0, 0.0]]), transform)
    points, notices = file_points(path, "", transform)
    np.testing.assert_allclose(points.image, image, atol=1e-9)
    np.testing.assert_array_equal(points.ground[:, :2], ground[:, :2])
    assert (points.wkt, notices) == ("EPSG:4326", [])
    lines = path.read_text().splitlines()
    assert lines[1] == "mapX,mapY,sourceX,sourceY,enable,dX,dY,residual"
    assert lines[2].split(",")[4:] == ["1", "3.0", "-4.0", "5.0"]


def test_points_inside_a_tiff(tmp_path: Path) -> None:
    path = tmp_path / "gcps.tif"
    dataset = gdal.GetDriverByName("GTiff").Create(str(path), 30, 20, 1)
    system = osr.SpatialReference()
    system.ImportFromEPSG(32632)
    dataset.SetGCPs([gdal.GCP(5e5, 4e6, 0, 1.5, 2.5), gdal.GCP(5.1e5, 4.1e6, 0, 10, 4)], system.ExportToWkt())
    dataset = None
    points = image_points(open_image(RasterRef(str(path))))
    np.testing.assert_allclose(points.image, [[1.5, 2.5], [10, 4]])
    np.testing.assert_allclose(points.ground[:, :2], [[5e5, 4e6], [5.1e5, 4.1e6]])
    assert np.isnan(points.ground[:, 2]).all()  # GDAL's 0 stands for a height that is not known
    with pytest.raises(SensorModelError, match="holds no sound ground control points"):
        image_points(open_image(RasterRef(image_file(tmp_path / "image.tif"))))


def egm96_file(path: Path, first: float = -180.0) -> str:
    """The undulation of EGM96 by PROJ on a grid of a degree."""
    longitude, latitude = np.meshgrid(first + np.arange(361.0), 85 - np.arange(171.0))
    places = np.column_stack([longitude.ravel(), latitude.ravel(), np.zeros(longitude.size)])
    places[:, 0] = (places[:, 0] + 180) % 360 - 180
    heights = above_ellipsoid(places, "EPSG:5773").reshape(longitude.shape)
    dataset = gdal.GetDriverByName("GTiff").Create(str(path), 361, 171, 1, gdal.GDT_Float32)
    dataset.SetGeoTransform((first - 0.5, 1, 0, 85.5, 0, -1))
    dataset.SetProjection('GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],'
                          'PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]]')
    dataset.GetRasterBand(1).WriteArray(heights)
    dataset.FlushCache()
    return str(path)


@pytest.mark.parametrize("first", [-180.0, 0.0])
def test_a_grid_of_ones_own_is_added(tmp_path: Path, first: float) -> None:
    """At the grid's own nodes it is what PROJ has, whichever longitude the file begins at."""
    nodes = np.array([[7, 43, 10.0], [-70, -12, 20.0], [179, 60, 0.0], [-180, 0, 0.0]])
    heights = above_ellipsoid(nodes, Geoid(RasterRef(egm96_file(tmp_path / "geoid.tif", first))))
    np.testing.assert_allclose(heights, above_ellipsoid(nodes, "EPSG:5773"), atol=1e-4)


def test_what_is_no_grid_of_the_geoid_says_so(tmp_path: Path) -> None:
    places = np.array([[7.1, 43.6, 0.0]])
    with pytest.raises(RasterError, match="is not a geoid grid"):
        above_ellipsoid(places, Geoid(RasterRef(image_file(tmp_path / "image.tif"))))
    west = gdal.Translate(str(tmp_path / "w.tif"), egm96_file(tmp_path / "g.tif"), projWin=(-90, 60, -60, 20))
    west = None
    assert west is None
    with pytest.raises(RasterError, match="has no values at some of the places"):
        above_ellipsoid(places, Geoid(RasterRef(str(tmp_path / "w.tif"))))
