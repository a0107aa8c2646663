"""An arch whose support gives way, at any displacement, against statics of its own.

Two parts between three hinges turn as circles say, and HiGHS finds the greatest factor of
a horizontal acceleration, and the least thrust, with forces at all joints, of which those
that have opened touch at their hinges only; the program follows
prm/arch_until_it_falls.prm. Nothing is taken from it but the places of the support.
"""
import csv
import math
import subprocess
import sys
from pathlib import Path

import numpy
import scipy.optimize

PROGRAM, SCENE = sys.argv[1:3]
N, INNER, OUTER, WEIGHT, MU = 40, 1.8, 2.2, 20., 0.7

angles = [math.pi * (1 - k / N) for k in range(N + 1)]  # of joints, from the left
inner = numpy.array([(INNER * math.cos(a), INNER * math.sin(a)) for a in angles])
outer = numpy.array([(OUTER * math.cos(a), OUTER * math.sin(a)) for a in angles])


def area_and_centroid(corners):
    area, first = 0., numpy.zeros(2)
    for a, b in zip(corners, numpy.roll(corners, -1, axis=0)):
        twice = a[0] * b[1] - a[1] * b[0]
        area += twice / 2
        first += twice / 6 * (a + b)
    return abs(area), first / area


class Arch:
    """The voussoirs where hinges at joints have brought them; those of parts are rigid."""

    def __init__(self, hinges=(), spread=0.):
        """hinges: three of (joint, place on it), from the left."""
        self.hinges = dict(hinges)
        self.of_part = [(numpy.eye(2), numpy.zeros(2))]
        if hinges:
            (_, a), (_, b), (_, c) = hinges
            to = numpy.array((spread, 0.))
            moved_c = c + to
            # b is where two circles meet, above
            r, s, d = math.dist(a, b), math.dist(b, c), math.dist(a, moved_c)
            along = (r * r - s * s + d * d) / (2 * d)
            e = (moved_c - a) / d
            moved_b = a + along * e + math.sqrt(r * r - along ** 2) * numpy.array((-e[1], e[0]))
            for start, end, start_now, end_now in ((a, b, a, moved_b), (b, c, moved_b, moved_c)):
                before, now = end - start, end_now - start_now
                turn = math.atan2(now[1], now[0]) - math.atan2(before[1], before[0])
                R = numpy.array(((math.cos(turn), -math.sin(turn)),
                                 (math.sin(turn), math.cos(turn))))
                self.of_part.append((R, start_now - R @ start))
            self.of_part.append((numpy.eye(2), to))

    def part_of(self, voussoir):
        return sum(joint <= voussoir for joint in self.hinges)

    def at(self, voussoir, place):
        R, shift = self.of_part[self.part_of(voussoir)]
        return R @ place + shift

    def wrenches(self):
        """Of the forces at the joints on all voussoirs, a column each: pressures, shears."""
        columns, friction = [], []
        for k in range(N + 1):
            left, right = max(k - 1, 0), min(k, N - 1)
            faces = [(self.at(v, inner[k]), self.at(v, outer[k])) for v in (left, right)]
            along = sum((b - a) / numpy.linalg.norm(b - a) for a, b in faces)
            along /= numpy.linalg.norm(along)
            normal = numpy.array((along[1], -along[0]))  # on the voussoir to the right
            places = ([self.at(left, self.hinges[k])] if k in self.hinges
                      else [self.at(left, inner[k]), self.at(left, outer[k])])
            first = len(columns)
            for place, force in [(p, normal) for p in places] + [(places[0], along)]:
                column = numpy.zeros((N, 3))
                wrench = numpy.array((*force, place[0] * force[1] - place[1] * force[0]))
                if k < N:
                    column[k] += wrench
                if k > 0:
                    column[k - 1] -= wrench
                columns.append(column.ravel())
            friction.append((first, len(columns) - 1))
        return columns, friction

    def loads(self, direction):
        loads = numpy.zeros((N, 3))
        for k in range(N):
            area, centroid = area_and_centroid(
                numpy.array((inner[k], outer[k], outer[k + 1], inner[k + 1])))
            x, force = self.at(k, centroid), WEIGHT * area * numpy.array(direction)
            loads[k] = *force, x[0] * force[1] - x[1] * force[0]
        return loads.ravel()

    def extreme(self, what):
        """The greatest factor of the acceleration, or the least thrust; None: it falls."""
        columns, friction = self.wrenches()
        columns.append(self.loads((1., 0.)))
        rows = []
        for first, shear in friction:
            for sign in (1., -1.):
                row = numpy.zeros(len(columns))
                row[first:shear] = -MU
                row[shear] = sign
                rows.append(row)
        bounds = [(0., None)] * len(columns)
        for _, shear in friction:
            bounds[shear] = (None, None)
        bounds[-1] = (None, None) if what == "factor" else (0., 0.)
        # The thrust is what the last joint has along x, on the support.
        cost = numpy.zeros(len(columns))
        if what == "factor":
            cost[-1] = -1.
        else:
            first, shear = friction[-1]
            for i in range(first, shear + 1):
                cost[i] = -columns[i].reshape(N, 3)[-1][0]
        found = scipy.optimize.linprog(
            cost, A_eq=numpy.array(columns).T, b_eq=-self.loads((0., -1.)),
            A_ub=numpy.array(rows), b_ub=numpy.zeros(len(rows)), bounds=bounds,
            method="highs", options={"primal_feasibility_tolerance": 1e-10,
                                     "dual_feasibility_tolerance": 1e-10})
        if found.status != 0:
            return None
        return found.x[-1] if what == "factor" else found.fun


def hinges_at_rest():
    """Where the arch opens as soon as its support goes: the least thrust touches there."""
    best = None
    middle = N // 2
    for left in range(middle):
        for right in range(middle + 1, N + 1):
            hinges = ((left, inner[left]), (middle, outer[middle]), (right, inner[right]))
            arch = Arch(hinges)
            thrust = arch.extreme("thrust")
            if thrust is not None and (best is None or thrust < best[0]):
                best = thrust, hinges
    return best[1]


def largest(name, differences, most):
    worst = max(differences)
    print(f"{name}: largest difference {worst:.1e}")
    if not worst <= most:
        sys.exit(f"more than {most}")


def main():
    subprocess.run([PROGRAM, SCENE, "--quiet", "--set", "Output directory=arch", "--set",
                    "Output/Files=csv", "--set", "Output/Report=false"], check=True)
    with Path("arch/capacity.csv").open(encoding="utf-8") as lines:
        points = [{k: float(v) for k, v in line.items()} for line in csv.DictReader(lines)]
    hinges = hinges_at_rest()
    print("hinges at the joints", *(joint for joint, _ in hinges))
    # At rest none of them is open yet.
    arches = [Arch()] + [Arch(hinges, point["of_supports"]) for point in points[1:]]
    if len(points) < 21:
        sys.exit("there are fewer than 20 positions behind that at rest")
    factors = [arch.extreme("factor") for arch in arches]
    thrusts = [arch.extreme("thrust") for arch in arches]
    for name in ("carried", "bound"):
        largest(name, [abs(point[name] - factor)
                       for point, factor in zip(points, factors)], 1e-8)
    for name in ("support_force", "least_support_force"):
        largest(name, [abs(point[name] / thrust - 1.)
                       for point, thrust in zip(points, thrusts)], 1e-10)
    crown = numpy.array((0.05, 2.))
    largest("displacement", [abs(2. - arch.at(N // 2, crown)[1] - point["displacement"])
                             for point, arch in zip(points, arches)], 1e-12)
    if Arch(hinges, points[-1]["of_supports"] + 1e-6).extreme("thrust") is not None:
        sys.exit("the arch stands beyond the end")
    print("beyond the end the arch falls")


main()
