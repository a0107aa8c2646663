"""A semicircular bridge under fill against a linear programme of its own.

Voussoirs, weights, pressures of soil and what it spreads of a lorry are made here from
radii and angles alone, and HiGHS finds the greatest factor of the lorry; the program reads
prm/bridge_with_fill.prm. With the passive pressure and without, and with both laws of
spreading, at several places of the lorry.
"""
import json
import math
import subprocess
import sys
from pathlib import Path

import numpy
import scipy.integrate
import scipy.optimize

PROGRAM, SCENE = sys.argv[1:3]
N, INNER, OUTER, TOP, STONE, SOIL, MU = 40, 2., 2.4, 2.8, 22., 18., 0.6
AXLES, WIDTH, LIMIT = ((0., 120.), (1.2, 120.)), 2.5, math.radians(26.565)
K_A = math.tan(math.pi / 4 - math.radians(35.) / 2) ** 2
K_P = 0.5 / K_A

angles = [math.pi * k / N for k in range(N + 1)]  # of joints, from the right
inner = [INNER * numpy.array((math.cos(a), math.sin(a))) for a in angles]
outer = [OUTER * numpy.array((math.cos(a), math.sin(a))) for a in angles]


def moment_of(place, force):
    return place[0] * force[1] - place[1] * force[0]


def wrench(place, force):
    """A force with its moment about the origin."""
    return numpy.array((*force, moment_of(place, force)))


def weight_of(k):
    corners = [inner[k], outer[k], outer[k + 1], inner[k + 1]]
    area = first = 0.
    for a, b in zip(corners, corners[1:] + corners[:1]):
        twice = a[0] * b[1] - a[1] * b[0]
        area += twice / 2
        first += twice / 6 * (a[0] + b[0])
    return wrench((first / area, 0.), (0., -STONE * area))


def soil_on(k):
    """The weight on the back of a voussoir, and the unit of its push from the side."""
    a, b = outer[k], outer[k + 1]

    def integral(value):
        return scipy.integrate.quad(lambda s: value(a + s * (b - a)), 0., 1.)[0]

    def stress(x):
        return SOIL * (TOP - x[1])
    dx, dy = abs(b[0] - a[0]), abs(b[1] - a[1])
    down = numpy.array((0., -dx * integral(stress),
                        -dx * integral(lambda x: stress(x) * x[0])))
    side = -math.copysign(1., (a + b)[0]) * dy
    push = numpy.array((side * integral(stress), 0.,
                        -side * integral(lambda x: stress(x) * x[1])))
    return down, push


def spread(k, x, force, law):
    """What comes to the back of a voussoir of a force on the road at x."""
    a, b = outer[k], outer[k + 1]

    def angle(p):
        return math.atan2(p[0] - x, TOP - p[1])
    ends = max(angle(b), -LIMIT), min(angle(a), LIMIT)
    if ends[0] >= ends[1]:
        return numpy.zeros(3)

    def density(t):
        return 1. / math.cos(t) ** 2 if law == "uniform" else 2. * math.cos(t) ** 2

    def place(t):
        # x + depth tan(t) on the straight back
        slope = (b[1] - a[1]) / (b[0] - a[0])
        level = a[1] + slope * (x - a[0])
        return x + (TOP - level) / (1. + slope * math.tan(t)) * math.tan(t)
    whole = scipy.integrate.quad(density, -LIMIT, LIMIT)[0]
    share = scipy.integrate.quad(density, *ends)[0] / whole
    first = scipy.integrate.quad(lambda t: density(t) * place(t), *ends)[0] / whole
    return numpy.array((0., -force * share, -force * first))


def greatest_factor(position, with_push, law):
    """Unknowns: two pressures and a shear a joint, the push of soil over K_a, the factor."""
    loads = numpy.zeros((N, 3))
    lorry = numpy.zeros((N, 3))
    columns, bounds = [], []
    for k in range(N):
        down, push = soil_on(k)
        loads[k] = weight_of(k) + down
        for behind, force in AXLES:
            lorry[k] += spread(k, position + behind, force / WIDTH, law)
        if with_push:
            column = numpy.zeros((N, 3))
            column[k] = push
            columns.append(column.ravel())
            bounds.append((K_A, K_P))
    first_of_joints = len(columns)
    for k in range(N + 1):  # between voussoir k - 1 and voussoir k, or the ground
        along = numpy.array((math.cos(angles[k]), math.sin(angles[k])))
        normal = numpy.array((-along[1], along[0]))  # on voussoir k
        for place, force in ((inner[k], normal), (outer[k], normal), (inner[k], along)):
            column = numpy.zeros((N, 3))
            if k < N:
                column[k] += wrench(place, force)
            if k > 0:
                column[k - 1] -= wrench(place, force)
            columns.append(column.ravel())
        bounds += [(0., None), (0., None), (None, None)]
    columns.append(lorry.ravel())
    bounds.append((None, None))
    friction = []
    for k in range(N + 1):
        for sign in (1., -1.):
            row = numpy.zeros(len(columns))
            i = first_of_joints + 3 * k
            row[i:i + 3] = -MU, -MU, sign
            friction.append(row)
    cost = numpy.zeros(len(columns))
    cost[-1] = -1.
    found = scipy.optimize.linprog(
        cost, A_eq=numpy.array(columns).T, b_eq=-loads.ravel(), A_ub=numpy.array(friction),
        b_ub=numpy.zeros(len(friction)), bounds=bounds, method="highs",
        options={"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10})
    return found.x[-1] if found.status == 0 else math.nan


def factor_by_program(position, with_push, law):
    settings = [f"Live loads/Vehicle/Position={position}", f"Fill/soil/Spreading={law}",
                "Contact/Compressive strength=", "Output directory=bridge",
                "Output/Files=none", "Output/Report=false"]
    if not with_push:
        settings += ["Fill/soil/Passive coefficient=0", "Fill/soil/Active coefficient=0"]
    words = [word for setting in settings for word in ("--set", setting)]
    subprocess.run([PROGRAM, SCENE, "--quiet", *words], check=True)
    summary = json.loads(Path("bridge/summary.json").read_text(encoding="utf-8"))
    return summary["load_factor"]["carried"], summary["load_factor"]["bound"]


def main():
    worst = 0.
    for position in (-1.6, -0.6, 0.3):
        for with_push in (True, False):
            for law in ("uniform", "elastic"):
                expected = greatest_factor(position, with_push, law)
                carried, bound = factor_by_program(position, with_push, law)
                error = max(abs(carried - expected), abs(bound - expected)) / expected
                worst = max(worst, error)
                print(f"{position} {'with' if with_push else 'without'} push, {law}: "
                      f"{carried:.10g}, HiGHS {expected:.10g}")
                if not error <= 1e-7:
                    sys.exit("they differ")
    print(f"largest difference {worst:.1e}")


main()
