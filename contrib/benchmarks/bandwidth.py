"""What the machine can do: the bandwidth of its memory and its floating-point
operations."""
import concurrent.futures
import os
import time

import numpy as np

LENGTH = 2**25  # numbers in an array: 256 MiB, beyond any cache
ORDER = 1500  # of the matrices that are multiplied
TRIALS = 5


def fastest(action):
    """The least seconds of some trials."""
    seconds = []
    for _ in range(TRIALS):
        start = time.perf_counter()
        action()
        seconds.append(time.perf_counter() - start)
    return min(seconds)


def triad(threads):
    """The bandwidth of a = b + s c on a number of threads, in bytes a second.

    It is done in two sweeps without a temporary: a = s c reads c, allocates a
    in the cache and writes it; a = a + b reads both and writes a. So six
    numbers are moved for each entry."""
    a, b, c = (np.full(LENGTH, value) for value in (0., 1., 2.))
    bounds = np.linspace(0, LENGTH, threads + 1).astype(int)
    parts = [slice(*pair) for pair in zip(bounds[:-1], bounds[1:])]

    def sweep(part):
        np.multiply(c[part], 3., out=a[part])
        np.add(a[part], b[part], out=a[part])

    with concurrent.futures.ThreadPoolExecutor(threads) as pool:
        seconds = fastest(lambda: list(pool.map(sweep, parts)))
    return 6 * 8 * LENGTH / seconds


def operations():
    """The floating-point operations a second of a product of matrices, by the
    library that CHOLMOD uses too, on as many threads as it chooses."""
    a = np.ones((ORDER, ORDER))
    c = np.empty_like(a)
    return 2 * ORDER**3 / fastest(lambda: np.matmul(a, a, out=c))


def machine():
    """The rows of the machine."""
    cores = os.cpu_count()
    return [{"what": "bandwidth, one thread", "value": triad(1)},
            {"what": f"bandwidth, {cores} threads", "value": triad(cores)},
            {"what": "product of matrices", "value": operations()}]
