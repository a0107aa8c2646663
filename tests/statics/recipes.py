"""The scenes of doc/recipes.md against statics of their own:

    recipes.py VOUSSOIR DIRECTORY OF THE SCENES

Arches, also of two rings, are made here from radii and angles, and HiGHS finds the greatest factor of
their loads; that on piers is a linear programme of two unknowns, its thrust at the crown and
the moment of it. Walls that rock have closed forms. A pier that sinks has the least reaction
that HiGHS finds over the joints that the program writes, which is its weight.
"""
import csv
import json
import math
import subprocess
import sys
from pathlib import Path

import numpy
import scipy.optimize

PROGRAM, SCENES = sys.argv[1:3]
CLOSE = {"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10}


def run(scene, *settings, files="none", status=0):
    """The summary of a run."""
    words = [word for setting in ("Output directory=recipe", f"Output/Files={files}",
                                  "Output/Report=false", *settings)
             for word in ("--set", setting)]
    done = subprocess.run([PROGRAM, f"{SCENES}/{scene}.prm", "--quiet", *words], check=False)
    if done.returncode != status:
        sys.exit(f"{scene} ends with {done.returncode}")
    return json.loads(Path("recipe/summary.json").read_text(encoding="utf-8"))


def expect(what, found, expected, tolerance=1e-8):
    error = max(abs(value - expected) for value in found) / abs(expected)
    print(f"{what}: {found[0]:.10g}, by its own statics {expected:.10g}")
    if not error <= tolerance:
        sys.exit(f"they differ by {error:.1e}")


def factor(scene, *settings):
    found = run(scene, *settings)["load_factor"]
    return found["carried"], found["bound"]


def wrench(place, force):
    """A force with its moment about the origin."""
    return numpy.array((*force, place[0] * force[1] - place[1] * force[0]))


class Statics:
    """The forces of joints that balance blocks: columns of a linear programme."""

    def __init__(self, n_blocks):
        self.n_blocks = n_blocks
        self.columns, self.bounds, self.limits = [], [], []

    def column(self, wrenches, low, high):
        column = numpy.zeros((self.n_blocks, 3))
        for block, value in wrenches:
            if block >= 0:
                column[block] += value
        self.columns.append(column.ravel())
        self.bounds.append((low, high))

    def joint(self, minus, plus, ends, normal, friction, is_glued=False):
        """Pressures at both ends and a shear, on the block `plus` along the normal."""
        along = numpy.array((-normal[1], normal[0]))
        first = len(self.columns)
        for place, force in ((ends[0], normal), (ends[1], normal), (ends[0], along)):
            on_plus = wrench(place, force)
            free = is_glued or force is along
            self.column([(plus, on_plus), (minus, -on_plus)], None if free else 0., None)
        if not is_glued:
            self.limits += [(first, friction, 1.), (first, friction, -1.)]

    def greatest(self, dead, live):
        """The greatest factor of the live loads, of one wrench a block."""
        columns = numpy.array([*self.columns, numpy.ravel(live)]).T
        rows = numpy.zeros((len(self.limits), columns.shape[1]))
        for row, (first, friction, sign) in zip(rows, self.limits):
            row[first:first + 3] = -friction, -friction, sign
        cost = numpy.zeros(columns.shape[1])
        cost[-1] = -1.
        found = scipy.optimize.linprog(
            cost, A_eq=columns, b_eq=-numpy.ravel(dead), A_ub=rows, b_ub=numpy.zeros(len(rows)),
            bounds=[*self.bounds, (None, None)], method="highs", options=CLOSE)
        return found.x[-1] if found.status == 0 else math.nan


def area_and_centre(corners):
    area = first = second = 0.
    for a, b in zip(corners, corners[1:] + corners[:1]):
        twice = a[0] * b[1] - a[1] * b[0]
        area += twice / 2
        first += twice / 6 * (a[0] + b[0])
        second += twice / 6 * (a[1] + b[1])
    return area, (first / area, second / area)


class Arch:
    """Rings of n blocks each between circles, block k of ring r being number k rings + r."""

    def __init__(self, radii, embrace, n):
        self.n, self.n_rings = n, len(radii) - 1
        angles = [math.pi / 2 + embrace * (0.5 - k / n) for k in range(n + 1)]  # from the left
        self.points = [[r * numpy.array((math.cos(a), math.sin(a))) for r in radii]
                       for a in angles]

    def corners(self, k, r):
        a, b = self.points[k], self.points[k + 1]
        return [a[r], b[r], b[r + 1], a[r + 1]]

    def body_force(self, x, y):
        wrenches = []
        for k in range(self.n):
            for r in range(self.n_rings):
                area, centre = area_and_centre(self.corners(k, r))
                wrenches.append(wrench(centre, (x * area, y * area)))
        return wrenches

    def axles(self, axles):
        """Forces downwards, on the outermost ring: which block, and its place there."""
        wrenches = [numpy.zeros(3) for _ in range(self.n * self.n_rings)]
        for x, force in axles:
            k, = (k for k in range(self.n)
                  if self.points[k][-1][0] < x < self.points[k + 1][-1][0])
            wrenches[(k + 1) * self.n_rings - 1] += wrench((x, 0.), (0., -force))
        return wrenches

    def statics(self, friction, between, is_glued=False):
        statics = Statics(self.n * self.n_rings)
        for k in range(self.n + 1):
            for r in range(self.n_rings):
                ends = self.points[k][r], self.points[k][r + 1]
                across = (ends[1] - ends[0]) / numpy.linalg.norm(ends[1] - ends[0])
                plus = k * self.n_rings + r if k < self.n else -1
                minus = (k - 1) * self.n_rings + r if k > 0 else -1
                statics.joint(minus, plus, ends, numpy.array((across[1], -across[0])), friction)
        for k in range(self.n):
            for r in range(1, self.n_rings):
                ends = self.points[k][r], self.points[k + 1][r]
                along = (ends[1] - ends[0]) / numpy.linalg.norm(ends[1] - ends[0])
                outwards = numpy.array((-along[1], along[0]))
                block = k * self.n_rings + r
                statics.joint(block - 1, block, ends, outwards, between, is_glued)
        return statics


def check_rings():
    """Two rings between which there is friction, none, or mortar; one of the whole thickness."""
    inner, outer, embrace = 5.9, 6.6, math.radians(106.26)
    lorry = ((-3.4, 60.), (-2.2, 60.))
    pair = Arch((inner, 6.25, outer), embrace, 98)
    loads = pair.body_force(0., -22.), pair.axles(lorry)
    for between in (0.3, 0., 1.):
        expect(f"two rings, friction {between}",
               factor("two_ring_arch", f"Friction/Pair coefficients=ring 1, ring 2: {between}"),
               pair.statics(0.6, between).greatest(*loads))
    whole = Arch((inner, outer), embrace, 98)
    of_whole = whole.statics(0.6, 0.).greatest(whole.body_force(0., -22.), whole.axles(lorry))
    glue = ("Friction/Pair cohesions=ring 1, ring 2: 1e4",
            "Contact/Pair tensile strengths=ring 1, ring 2: 1e4")
    one = ("Packing/arch/Rings=1", "Friction/Pair coefficients=")
    expect("two rings that hold together", factor("two_ring_arch", *glue),
           pair.statics(0.6, 0., is_glued=True).greatest(*loads))
    expect("  are one", factor("two_ring_arch", *glue), of_whole)
    expect("  as it is", factor("two_ring_arch", *one), of_whole)
    # The halves of a section that crush bear what the whole does.
    crushing = "Contact/Compressive strength=2000"
    expect("  also where stone crushes", factor("two_ring_arch", crushing, *glue),
           factor("two_ring_arch", crushing, *one)[0])


def check_model():
    """The circle through (-5, 0), (0, 3) and (5, 0)."""
    radius = 17 / 3
    arch = Arch((radius, radius + 0.3), 2 * math.asin(5 / radius), 30)
    expected = arch.statics(0.7, 0.).greatest(arch.body_force(0., -20.),
                                              arch.body_force(20., 0.))
    expect("the arch of compas_assembly", factor("compas_arch"), expected)


def is_stable_on_piers(width):
    """
    Whether a thrust H at the crown and its height leave the resultant inside all joints of a half.
    With H and M = H y, the moment of the thrust about the springing line, the moments about
    both ends of each joint are linear.
    """
    n, inner, outer, weight = 40, 2.75, 3.25, 22.
    half = Arch((inner, outer), math.pi, n)
    blocks = [area_and_centre(half.corners(k, 0)) for k in range(n // 2, n)]  # from the crown
    joints = [(tuple(half.points[k][0]), tuple(half.points[k][1]))
              for k in range(n // 2, n + 1)]
    for course in range(8):
        y = -0.5 * (course + 1)
        blocks.append((0.5 * width, (inner + width / 2, y + 0.25)))
        joints.append(((inner, y), (inner + width, y)))
    # The thrust pushes to the right. About the inner end what is above turns clockwise, and about the
    # outer end counterclockwise: then the joint is pressed.
    rows, limits, load, moment = [], [], 0., 0.
    for j, (inside, outside) in enumerate(joints):
        if j > 0:
            area, centre = blocks[j - 1]
            load += weight * area
            moment += weight * area * centre[0]
        for end, sign in ((inside, -1.), (outside, 1.)):
            # sign (load x_end - moment - (M - H y_end)) >= 0
            rows.append((-sign * end[1], sign))
            limits.append(sign * (load * end[0] - moment))
    found = scipy.optimize.linprog((0., 0.), A_ub=rows, b_ub=limits, bounds=[(0., None)] * 2,
                                   method="highs", options=CLOSE)
    return found.status == 0


def check_piers():
    unstable, stable = 0.5, 3.
    while stable - unstable > 1e-9:
        middle = 0.5 * (stable + unstable)
        if is_stable_on_piers(middle):
            stable = middle
        else:
            unstable = middle
    print(f"piers of {stable:.10g} stand")
    quick = "Ranges/Reactions=false"
    run("arch_on_piers", quick, f"Packing/arch/Abutment width={stable * (1 + 1e-6)}")
    run("arch_on_piers", quick, f"Packing/arch/Abutment width={stable * (1 - 1e-6)}", status=3)


def check_leaves():
    weight, height, leaves = 20., 2., (0.1, 0.14)
    slack = [f"Ties/{tie}/Compressive strength=0" for tie in ("low", "high")]
    expect("leaves with ties", factor("two_leaf_wall"),
           weight * sum(b**2 for b in leaves) / height)
    expect("one leaf", factor("two_leaf_wall", *slack), weight * leaves[0] ** 2 / height)
    expect("through stones", factor("through_stones"), weight * 0.34**2 / height)
    expect("none", factor("through_stones", "Packing/wall/Bond=stack",
                          "Packing/wall/Bricks per course=2",
                          "Friction/Coefficient=abs(nx) > 0.5 ? 0 : 0.6"),
           2 * weight * 0.17**2 / height)


def check_floors():
    """The least of all beds, each with its own weight and floors above."""
    weight, width, height, crushing, place = 18., 0.5, 9., 2000., 0.4
    floors = ((30., 3.), (30., 6.), (20., 9.))
    factors = {1: [], -1: []}
    for bed in numpy.arange(18) * 0.5:
        above = [(force, y - bed) for force, y in floors if y > bed]
        own = weight * width * (height - bed)
        normal = own + sum(force for force, _ in above)
        moment = own * (height - bed) / 2 + sum(force * y for force, y in above)
        about_left = own * width / 2 + sum(force for force, _ in above) * place
        lost = normal**2 / (2 * crushing)
        factors[1].append((normal * width - about_left - lost) / moment)
        factors[-1].append((about_left - lost) / moment)
    expect("floors, to the right", factor("floors_on_wall"), min(factors[1]))
    expect("floors, to the left", factor("floors_on_wall", "Load factor/Direction=least"),
           -min(factors[-1]))


def rows_of(name):
    with open(f"recipe/{name}.csv", newline="", encoding="utf-8") as lines:
        return [{key: float(value) for key, value in row.items()
             if value and key != "group"}
                for row in csv.DictReader(lines)]


def check_sinking_pier():
    """The work of a reaction on a support that sinks is least with the least reaction."""
    summary = run("sinking_pier", files="csv")
    reaction_of_state = summary["ground"]["supports"][1]["reaction"][1]
    ranges = summary["ranges"]["reactions"][1]["y"]
    loads = [wrench((row["x"], row["y"]), (row["load_x"], row["load_y"])) for row in rows_of("cells")]
    statics = Statics(len(loads))
    reaction = []
    for row in rows_of("interfaces"):
        normal = numpy.array((row["nx"], row["ny"]))
        statics.joint(int(row["cell_minus"]), int(row["cell_plus"]),
                      ((row["x0"], row["y0"]), (row["x1"], row["y1"])), normal, 0.6)
        in_it = min(row["cell_minus"], row["cell_plus"]) < 0 and 2. < row["x0"] < 4.
        reaction += [in_it, in_it, False]
    limits = numpy.zeros((len(statics.limits), len(statics.columns)))
    for row, (first, friction, sign) in zip(limits, statics.limits):
        row[first:first + 3] = -friction, -friction, sign
    ends = []
    for sign in (1., -1.):
        found = scipy.optimize.linprog(
            sign * numpy.array(reaction), A_eq=numpy.array(statics.columns).T,
            b_eq=-numpy.ravel(loads), A_ub=limits, b_ub=numpy.zeros(len(limits)),
            bounds=statics.bounds, method="highs", options=CLOSE)
        ends.append(sign * found.fun)
    expect("the reaction of the pier that sinks", [reaction_of_state], 36.)
    expect("  the least of all", [ranges[0], ends[0]], 36.)
    expect("  and the greatest", [ranges[1]], ends[1])


def check_grains():
    """Forces and branch vectors add up to the stress, in the state of the scene and in another."""
    for weights in ("equal", "edge area"):
        run("grains", f"Solver/analytic centre/Barrier weights={weights}", files="csv")
        stress = numpy.zeros((2, 2))
        for row in rows_of("interfaces"):
            normal = numpy.array((row["nx"], row["ny"]))
            along = numpy.array((row["x1"] - row["x0"], row["y1"] - row["y0"])) / row["length"]
            force = row["normal_force"] * normal + row["tangential_force"] * along
            stress += numpy.outer(force, (row["branch_x"], row["branch_y"]))
        for row in rows_of("boundary"):
            stress += numpy.outer((row["force_x"], row["force_y"]),
                                  (row["branch_x"], row["branch_y"]))
        error = abs(stress - numpy.diag((-1., -2.))).max()
        print(f"the stress of the grains, {weights}: error {error:.1e}")
        if not error <= 1e-9:
            sys.exit("it is not that of the boundary")


for check in (check_rings, check_model, check_piers, check_leaves, check_floors,
              check_sinking_pier, check_grains):
    check()
