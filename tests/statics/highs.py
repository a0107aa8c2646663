#!/usr/bin/env python3
"""Verdicts on loads against HiGHS: highs.py VOUSSOIR [N]

The program generates random packings of blocks that turn and writes their
interfaces; HiGHS finds, from these alone, the largest factor on the load that
admissible forces balance. With strengths a little above and below what that
factor asks for, the program must say carried and collapse. Within 1e-6 of the
limit it may also say, of few, that the load is carried to within a small error.
"""
import csv
import json
import pathlib
import random
import subprocess
import sys
import tempfile

import numpy
import scipy.optimize
import scipy.sparse

SCENE = """set Output directory = {directory}
set Formulation = {formulation}
set Rotations = true
set Accuracy = draft
subsection Packing
  set Generator = Voronoi
  subsection Voronoi
    set Number of points = {n}
    set Seed = {seed}
    set Upper right = {width}, {height}
  end
end
subsection Supports
  set Where = {supports}
end
subsection Loads
  set Body force = {body}
  set Boundary load = uniform stress
  set Stress = {stress}
end
subsection Friction
  set Strength = {strength!r}
end
subsection Output
  set Files = csv
end
"""

SOLVED, COLLAPSE = 0, 3


def table(path):
    with open(path) as file:
        return list(csv.DictReader(file))


class Scene:
    def __init__(self, program, directory, seed):
        choice = random.Random(seed)
        self.program = program
        self.directory = pathlib.Path(directory)
        self.values = {
            "directory": directory, "seed": seed,
            "n": choice.randint(4, 60),
            "width": choice.uniform(0.3, 3.), "height": choice.uniform(0.3, 3.),
            "formulation": "least energy"}
        if seed % 2 == 0:
            self.values.update(
                supports="y < 1e-9", stress="{}, 0; 0, {}".format(
                    -choice.uniform(0.1, 1.), -choice.uniform(0., 1.)),
                body="{}; -1".format(choice.uniform(-0.5, 0.5)))
        else:
            shear = choice.uniform(-0.8, 0.8)
            self.values.update(
                supports="0", body="0; 0", stress="{}, {}; {}, {}".format(
                    -choice.uniform(0.2, 2.), shear, shear, -1.))

    def run(self, strength, formulation="least energy"):
        text = SCENE.format(**{**self.values, "strength": strength,
                               "formulation": formulation})
        path = self.directory.with_suffix(".prm")
        path.write_text(text)
        return subprocess.run([self.program, path], capture_output=True,
                              text=True)

    def largest_factor(self):
        """The largest multiple of the load that a strength of one carries."""
        interfaces = table(self.directory / "interfaces.csv")
        cells = table(self.directory / "cells.csv")
        n = len(cells)
        centre = numpy.array([[float(c["x"]), float(c["y"])] for c in cells])
        load = numpy.array([[float(c[k]) for k in
                             ("load_x", "load_y", "load_torque")]
                            for c in cells])
        rows, columns, values = [], [], []

        def add(column, force, at, interface):
            for name, sign in (("cell_minus", 1.), ("cell_plus", -1.)):
                c = int(interface[name])
                if c < 0:
                    continue
                arm = at - centre[c]
                for i, value in enumerate(
                        (force[0], force[1],
                         arm[0] * force[1] - arm[1] * force[0])):
                    rows.append(3 * c + i)
                    columns.append(column)
                    values.append(sign * value)

        bounds = []
        for e, interface in enumerate(interfaces):
            start, end, normal = (
                numpy.array([float(interface[k]) for k in keys]) for keys in
                (("x0", "y0"), ("x1", "y1"), ("nx", "ny")))
            add(3 * e, -normal, start, interface)
            add(3 * e + 1, -normal, end, interface)
            add(3 * e + 2, numpy.array([-normal[1], normal[0]]), start,
                interface)
            length = float(interface["length"])
            bounds += [(0, None), (0, None), (-length, length)]
        factor = 3 * len(interfaces)
        for c in range(n):
            for i in range(3):
                rows.append(3 * c + i)
                columns.append(factor)
                values.append(load[c][i])
        bounds.append((0, None))
        matrix = scipy.sparse.coo_matrix((values, (rows, columns)),
                                         shape=(3 * n, factor + 1)).tocsr()
        cost = numpy.zeros(factor + 1)
        cost[factor] = -1.
        found = scipy.optimize.linprog(
            cost, A_eq=matrix, b_eq=numpy.zeros(3 * n), bounds=bounds,
            method="highs",
            options={"primal_feasibility_tolerance": 1e-10,
                     "dual_feasibility_tolerance": 1e-10})
        return found.x[factor] if found.status == 0 else None


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    n_scenes = int(sys.argv[2]) if len(sys.argv) > 2 else 100
    n_judged = n_undecided = 0
    faults = []
    with tempfile.TemporaryDirectory() as directory:
        for seed in range(1, n_scenes + 1):
            scene = Scene(program, directory + "/of_scene", seed)
            if scene.run(1e6).returncode != SOLVED:
                # It overturns whatever the friction: there are no forces.
                continue
            factor = scene.largest_factor()
            if factor is None or factor < 1e-6:
                continue
            n_judged += 1
            for margin in (1e-6, 0.3) if seed % 5 == 0 else (1e-6,):
                for strength, expected in (((1. + margin) / factor, SOLVED),
                                           ((1. - margin) / factor, COLLAPSE)):
                    run = scene.run(strength)
                    status = (scene.directory / "summary.json")
                    word = json.loads(status.read_text())["status"] \
                        if run.returncode in (SOLVED, COLLAPSE) else run.stderr
                    if word == "carried to within" and margin < 1e-3:
                        n_undecided += 1
                    elif run.returncode != expected or \
                            (expected == SOLVED and word != "solved"):
                        faults.append("scene {}: strength {!r} of the limit "
                                      "{!r}: status {}, {}".format(
                                          seed, strength, 1. / factor,
                                          run.returncode, word))
    for fault in faults:
        print(fault)
    print(n_judged, "scenes judged,", len(faults), "faults,", n_undecided,
          "undecided within 1e-6 of the limit")
    if faults or n_judged < n_scenes // 2 or n_undecided > n_judged // 10:
        sys.exit(1)


if __name__ == "__main__":
    main()
