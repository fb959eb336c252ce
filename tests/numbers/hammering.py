"""Compiled functions that the plugin calls, by two threads at once, as scans, windows and tasks call them."""
from __future__ import annotations

import time
from collections.abc import Callable
from threading import Thread

import numpy as np
import pywt
import scipy
from scipy import fft, interpolate, ndimage, optimize, signal, sparse, spatial, special
from scipy.linalg import blas
from scipy.sparse import csgraph
from scipy.sparse.linalg import spsolve
from scipy.spatial.transform import Rotation

CALLS = 20_000
DEADLOCK_S = 20  # without a call made; one takes milliseconds

random = np.random.default_rng(1)
MANY = 600  # numpy holds Python's lock over fewer than 500 values
VALUES, SHARES, POSITIVE = random.normal(size=MANY), random.uniform(0.01, 0.99, MANY), random.uniform(1, 100, MANY)
PIXELS, MASK = random.normal(size=(24, 24)), random.random((24, 24)) < 0.4
SQUARE, SYMMETRIC = random.normal(size=(8, 8)), np.cov(random.normal(size=(8, 20)))
PARTS = ndimage.label(MASK)[0]
POINTS = random.random((60, 2))
ENDS = random.integers(0, 60, (2, 100))
GRAPH = sparse.coo_matrix((random.random(100), tuple(ENDS)), (60, 60)).tocsr()
KNOTS = np.concatenate([[0.0] * 3, np.linspace(0, 1, 8), [1.0] * 3])
NORMAL = sparse.csc_matrix(SYMMETRIC + np.eye(8))


def near(tree: spatial.cKDTree) -> np.ndarray:
    """What the plugin asks a tree."""
    return np.concatenate([
        tree.query(POINTS, 3, distance_upper_bound=0.5)[0].ravel(), sorted(tree.query_pairs(0.1)),
    ], None)  # fmt: skip


HAMMERED: dict[str, Callable[[], object]] = {
    "numpy.fft.fftfreq": lambda: np.fft.fftfreq(64),
    "numpy.linalg.det": lambda: np.linalg.det(SQUARE),
    "numpy.linalg.eigh": lambda: np.linalg.eigh(SYMMETRIC)[1],
    "numpy.linalg.eigvalsh": lambda: np.linalg.eigvalsh(SYMMETRIC),
    "numpy.linalg.inv": lambda: np.linalg.inv(SQUARE),
    "numpy.linalg.lstsq": lambda: np.linalg.lstsq(PIXELS[:, :8], PIXELS[:, 9], rcond=None)[0],
    "numpy.linalg.norm": lambda: np.linalg.norm(PIXELS, axis=0),
    "numpy.linalg.pinv": lambda: np.linalg.pinv(PIXELS[:, :8]),
    "numpy.linalg.qr": lambda: np.linalg.qr(PIXELS[:, :8])[0],
    "numpy.linalg.solve": lambda: np.linalg.solve(SQUARE, VALUES[:8]),
    "numpy.linalg.svd": lambda: np.linalg.svd(SQUARE)[1],
    "pywt.Wavelet": lambda: pywt.Wavelet("coif3").dec_lo,
    "scipy.fft.dct": lambda: fft.dct(PIXELS, axis=0, norm="ortho"),
    "scipy.fft.fft": lambda: fft.fft(PIXELS, axis=0),
    "scipy.fft.irfft2": lambda: fft.irfft2(PIXELS, (24, 46)),
    "scipy.fft.next_fast_len": lambda: fft.next_fast_len(1031, real=True),
    "scipy.fft.rfft": lambda: fft.rfft(PIXELS, axis=1),
    "scipy.fft.rfft2": lambda: fft.rfft2(PIXELS, (27, 27)),
    "scipy.interpolate.BSpline": lambda: interpolate.BSpline(KNOTS, VALUES[:10], 3)(SHARES),
    "scipy.interpolate.BSpline.design_matrix": lambda: interpolate.BSpline.design_matrix(SHARES, KNOTS, 3).data,
    "scipy.linalg.blas.dgemm": lambda: blas.dgemm(1.0, PIXELS, PIXELS),
    "scipy.linalg.blas.sgemm": lambda: blas.sgemm(1.0, PIXELS, PIXELS),
    "scipy.ndimage.binary_dilation": lambda: ndimage.binary_dilation(MASK, iterations=2),
    "scipy.ndimage.binary_erosion": lambda: ndimage.binary_erosion(~MASK, iterations=2, border_value=1),
    "scipy.ndimage.binary_propagation": lambda: ndimage.binary_propagation(MASK & (PIXELS > 1), mask=MASK),
    "scipy.ndimage.convolve1d": lambda: ndimage.convolve1d(PIXELS, (0.25, 0.5, 0.25), axis=0),
    "scipy.ndimage.correlate": lambda: ndimage.correlate(PIXELS, np.ones((3, 3)) / 9, mode="mirror"),
    "scipy.ndimage.distance_transform_edt": lambda: ndimage.distance_transform_edt(MASK, return_indices=True)[1],
    "scipy.ndimage.find_objects": lambda: [(place.start, place.stop) for box in ndimage.find_objects(PARTS)
                                           for place in box],
    "scipy.ndimage.gaussian_filter": lambda: ndimage.gaussian_filter(PIXELS, 1.5),
    "scipy.ndimage.gaussian_filter1d": lambda: ndimage.gaussian_filter1d(PIXELS, 1.5, mode="wrap"),
    "scipy.ndimage.grey_opening": lambda: ndimage.grey_opening(PIXELS, 5),
    "scipy.ndimage.label": lambda: ndimage.label(MASK)[0],
    "scipy.ndimage.laplace": lambda: ndimage.laplace(PIXELS),
    "scipy.ndimage.map_coordinates": lambda: ndimage.map_coordinates(PIXELS, POINTS.T * 24, order=3),
    "scipy.ndimage.maximum_filter": lambda: ndimage.maximum_filter(PIXELS, 5),
    "scipy.ndimage.mean": lambda: ndimage.mean(PIXELS, PARTS, [1, 2, 3]),
    "scipy.ndimage.minimum_filter": lambda: ndimage.minimum_filter(PIXELS > 0, 3, mode="nearest"),
    "scipy.ndimage.rotate": lambda: ndimage.rotate(PIXELS, 7.0, reshape=False, order=1, mode="nearest"),
    "scipy.ndimage.sobel": lambda: ndimage.sobel(PIXELS, axis=0),
    "scipy.ndimage.spline_filter": lambda: ndimage.spline_filter(PIXELS),
    "scipy.ndimage.spline_filter1d": lambda: ndimage.spline_filter1d(PIXELS, 3, 0, mode="mirror"),
    "scipy.ndimage.uniform_filter": lambda: ndimage.uniform_filter(PIXELS, 5),
    "scipy.ndimage.zoom": lambda: ndimage.zoom(PIXELS, 2, order=1, mode="nearest", grid_mode=True),
    "scipy.optimize.least_squares": lambda: optimize.least_squares(lambda x: SQUARE @ x - VALUES[:8], SHARES[:8]).x,
    "scipy.optimize.minimize_scalar": lambda: optimize.minimize_scalar(
        lambda x: float(np.abs(VALUES - x).sum()), bounds=(-3, 3), method="bounded").x,
    "scipy.signal.find_peaks": lambda: signal.find_peaks(VALUES, prominence=0.5)[0],
    "scipy.sparse.coo_matrix": lambda: sparse.coo_matrix((POINTS[:, 0], (ENDS[0][:60], ENDS[1][:60]))).tocsr().data,
    "scipy.sparse.csc_matrix": lambda: GRAPH.tocsc() @ POINTS,
    "scipy.sparse.csgraph.connected_components": lambda: csgraph.connected_components(GRAPH, directed=False)[1],
    "scipy.sparse.csgraph.dijkstra": lambda: csgraph.dijkstra(GRAPH, directed=False, indices=[0, 7], limit=2.0),
    "scipy.sparse.diags": lambda: sparse.diags([-1.0, 3.0, -3.0, 1.0], [0, 1, 2, 3], shape=(20, 23)).toarray(),
    "scipy.sparse.linalg.spsolve": lambda: spsolve(NORMAL, VALUES[:8]),
    "scipy.spatial.cKDTree": lambda: near(spatial.cKDTree(POINTS)),
    "scipy.spatial.distance.cdist": lambda: spatial.distance.cdist(POINTS, POINTS),
    "scipy.spatial.transform.Rotation.from_euler": lambda: Rotation.from_euler("XYZ", VALUES[:3]).as_matrix(),
    "scipy.spatial.transform.Rotation.from_rotvec": lambda: Rotation.from_rotvec(VALUES.reshape(-1, 3)).as_matrix(),
    "scipy.special.betaincinv": lambda: special.betaincinv(0.5, POSITIVE, 0.95),
    "scipy.special.chdtr": lambda: special.chdtr(24.0, POSITIVE),
    "scipy.special.erfc": lambda: special.erfc(VALUES),
    "scipy.special.gammaincinv": lambda: special.gammaincinv(24.0, SHARES),
    "scipy.special.ndtr": lambda: special.ndtr(VALUES),
}


def fault_in_threads(call: Callable[[], object], calls: int, seconds: float) -> str | None:
    """What goes wrong where two threads call a function so many times together, or for so long."""
    expected, end = np.asarray(call()), time.monotonic() + seconds
    made, ended, wrong = [0, 0], [], []

    def hammer(number: int) -> None:
        while made[number] < calls // 2 and not wrong and time.monotonic() < end:
            result = np.asarray(call())
            made[number] += 1
            if not (np.array_equal(result, expected) or np.allclose(result, expected, rtol=1e-9)):
                wrong.append(result)
        ended.append(number)

    threads = [Thread(target=hammer, args=(number,), daemon=True) for number in range(2)]
    for thread in threads:
        thread.start()
    before: list[int] = []
    while made != before:
        before = made.copy()
        for thread in threads:
            thread.join(DEADLOCK_S)
    if wrong:
        return f"another result in call {sum(made)}"
    return None if len(ended) == len(threads) else "a call failed, or never came back"


def main() -> int:
    """All functions, as often as ``CALLS``; 1 where one of them is at fault."""
    print(f"numpy {np.__version__}, scipy {scipy.__version__}, PyWavelets {pywt.__version__}")
    faulty = False
    for name, call in HAMMERED.items():
        fault = fault_in_threads(call, CALLS, np.inf)
        print(f"{name}: {fault or 'as in a single thread'}", flush=True)
        faulty |= fault is not None
    return int(faulty)


if __name__ == "__main__":
    raise SystemExit(main())
