"""The judgement of one scene in space, by HiGHS and by proofs.

HiGHS has two linear programmes with polygons inside and around the circles of
friction, which tell what is carried and have the factor between them; to its
last digits the factor is known by forces and a mechanism, which are added up.
From the tables of the program come the points of the joints with their normals,
and the volumes and faces of the blocks; the loads, the balance of forces and
moments, the limits, and whatever follows are written anew.
"""
import random

import numpy
import scipy.optimize
import scipy.sparse

from judging.blocks_in_space import SpaceScene
from judging.program import SOLVED

# The sides of the polygons, and the errors of HiGHS's factors.
SIDES = 16
LARGEST_DIFFERENCE = 1e-6
# Of what is added up again from files.
LARGEST_ERROR = 1e-9
DISTANCES, NEAR = (1e-2, 1e-4, 1e-6, 1e-8), 1.001e-6

def columns(table, names):
    return numpy.array([[float(row[name]) for name in names] for row in table])


def frame(normal):
    axis = numpy.eye(3)[numpy.argmin(numpy.abs(normal))]
    first = numpy.cross(normal, axis)
    first /= numpy.linalg.norm(first)
    return first, numpy.cross(normal, first)


class Blocks:
    """What the files say of the geometry."""

    def __init__(self, run):
        cells, joints = run.table("cells.csv"), run.table("interfaces.csv")
        self.centre = columns(cells, "xyz")
        self.volume = columns(cells, ["volume"])[:, 0]
        self.n = len(cells)
        self.length = (self.volume.sum() / self.n)**(1. / 3.)
        self.minus = columns(joints, ["cell_minus"])[:, 0].astype(int)
        self.plus = columns(joints, ["cell_plus"])[:, 0].astype(int)
        self.normal = columns(joints, ["nx", "ny", "nz"])
        self.area = columns(joints, ["area"])[:, 0]
        points = run.table("interface_points.csv")
        self.joint = columns(points, ["interface"])[:, 0].astype(int)
        self.presses = columns(points, ["pressure"])[:, 0] > 0.5
        self.share = columns(points, ["share"])[:, 0]
        self.place = columns(points, "xyz")
        boundary = run.table("boundary.csv")
        self.face_cell = columns(boundary, ["cell"])[:, 0].astype(int)
        self.face_place = columns(boundary, "xyz")
        self.face_vector = columns(boundary, ["nx", "ny", "nz"]) * \
            columns(boundary, ["area"])

    def check(self):
        """The largest error of the shares, which add up to one."""
        sums = numpy.zeros((len(self.area), 2))
        numpy.add.at(sums, (self.joint, self.presses.astype(int)), self.share)
        return numpy.abs(sums - 1.).max()

    def loads(self, load):
        """Force and moment over the length on each cell, 6 columns."""
        total = numpy.zeros((self.n, 6))
        if load.ndim == 1:
            total[:, :3] = self.volume[:, None] * load
            return total
        force = self.face_vector @ load.T
        arm = self.face_place - self.centre[self.face_cell]
        numpy.add.at(total[:, :3], self.face_cell, force)
        numpy.add.at(total[:, 3:], self.face_cell,
                     numpy.cross(arm, force) / self.length)
        return total

    def held(self):
        """One cell of each group that no ground holds."""
        parent = list(range(self.n + 1))

        def root(c):
            while parent[c] != c:
                c = parent[c]
            return c
        for a, b in zip(self.minus, self.plus):
            # The ground, number n, is the root of its group.
            a, b = sorted((root(a), root(self.n if b < 0 else b)))
            parent[a] = b
        return {root(c) for c in range(self.n)} - {root(self.n)}


class PolygonProgramme:
    """Forces that balance dead and alpha times live loads, whose friction is in
    polygons inside or around the circles that limit it."""

    def __init__(self, scene, blocks):
        self.scene, self.blocks = scene, blocks
        self.n = 6 if scene.rotations else 3
        held = blocks.held()
        self.free = [c for c in range(blocks.n) if c not in held]
        # Of each column the least value; its point, and the force on c-.
        self.columns, self.signs, self.limits = [], [], []
        self.places, self.directions = [], []
        b = blocks
        tension = scene.tension
        strength = max(scene.strength - scene.coefficient * tension, 0.)
        self.offset = numpy.zeros((b.n, 6))
        for k, e in enumerate(b.joint):
            tangents = frame(b.normal[e])
            size = b.share[k] * b.area[e]
            at = len(self.columns)
            if b.presses[k]:
                pressure = self.column(k, -b.normal[e])
                self.offset -= tension * size * pressure
                self.columns.append(pressure)
                self.signs.append(0.)
                if scene.coefficient > 0.:
                    self.add(k, tangents)
                    self.limits.append((at + 1, at, scene.coefficient, 0.))
            elif strength > 0.:
                self.add(k, tangents)
                self.limits.append((at, -1, 0., strength * size))

    def add(self, k, tangents):
        """Tangential forces at a point."""
        self.columns += [self.column(k, t) for t in tangents]
        self.signs += [-numpy.inf, -numpy.inf]

    def column(self, k, direction):
        """A unit force on c- at a point, on all cells."""
        b = self.blocks
        e = b.joint[k]
        self.places.append(k)
        self.directions.append(direction)
        column = numpy.zeros((b.n, 6))
        for cell, sign in ((b.minus[e], 1.), (b.plus[e], -1.)):
            if cell >= 0:
                column[cell, :3] += sign * direction
                column[cell, 3:] += sign * numpy.cross(
                    b.place[k] - b.centre[cell], direction) / b.length
        return column

    def reduced(self, loads):
        """The equations of cells that are not held, as a vector."""
        return loads[self.free][:, :self.n].ravel()

    def solve(self, dead, live, sense, radius):
        """"bounded" with a value, "unbounded", "not carried" or "doubtful".

        A radius of one is around the circles, and cos(pi / SIDES) inside."""
        matrix = scipy.sparse.csc_matrix(numpy.stack(
            [self.reduced(c) for c in self.columns] + [self.reduced(live)],
            axis=1))
        right = -self.reduced(dead + self.offset)
        scale = max(numpy.abs(right).max(), 1e-300)
        n = matrix.shape[1]
        angles = 2. * numpy.pi * (numpy.arange(SIDES) + 0.5) / SIDES
        rows, cols, values, most = [], [], [], []
        for at, pressure, mu, cap in self.limits:
            for angle in angles:
                row = len(most)
                rows += [row, row]
                cols += [at, at + 1]
                values += [numpy.cos(angle), numpy.sin(angle)]
                if pressure >= 0:
                    rows.append(row)
                    cols.append(pressure)
                    values.append(-mu * radius)
                most.append(cap * radius / scale)
        cost = numpy.zeros(n)
        cost[-1] = -sense
        found = scipy.optimize.linprog(
            cost, A_ub=scipy.sparse.csc_matrix((values, (rows, cols)),
                                               (len(most), n)) if most else None,
            b_ub=most or None, A_eq=matrix, b_eq=right / scale,
            bounds=[(low, None) for low in self.signs] + [(None, None)],
            method="highs", options={"primal_feasibility_tolerance": 1e-9,
                                     "dual_feasibility_tolerance": 1e-9})
        if found.status == 0:
            return "bounded", -sense * found.fun * scale
        return {2: "not carried", 3: "unbounded"}.get(found.status,
                                                      "doubtful"), numpy.nan


class SpaceJudgement:
    """One scene on its way through the program and HiGHS."""
    scenes = SpaceScene
    n_distances = len(DISTANCES)

    def __init__(self, program, scene, report):
        self.program, self.scene, self.report = program, scene, report
        self.choice = random.Random(f"{scene.name} runs")
        self.n_states = 0
        self.kind = "refused"
        self.difference = self.miss = 0.

    def run(self, name, factor=None):
        return self.program.run(f"{self.scene.name}_{name}",
                                self.scene.text(factor))

    def judge(self):
        found = self.run("factor")
        state = self.run("dead", 0.)
        if state.status not in (0, 3):
            self.report("undecided" if state.status == 4 else "fault", state,
                        state.message)
            return
        self.blocks = Blocks(state)
        if self.blocks.check() > LARGEST_ERROR:
            self.report("fault", state, "shares do not add up to one")
        self.programme = PolygonProgramme(self.scene, self.blocks)
        self.dead = self.blocks.loads(self.scene.dead)
        self.live = self.blocks.loads(self.scene.live)
        sense = 1. if self.scene.sense == "greatest" else -1.
        inside, around = self.limits(sense)
        self.kind = inside[0] if inside[0] == around[0] else "doubtful"
        if found.status not in (0, 3):
            self.report("undecided" if found.status in (4, None) else "fault",
                        found, found.message)
            return
        factor = found.summary.get("load_factor")
        kind = "not carried" if factor is None else \
            "unbounded" if factor["unbounded"] else "bounded"
        if self.kind not in ("doubtful", kind):
            self.report("fault", found, f"{kind}, where HiGHS has {inside}")
            return
        self.judge_factor(found, kind, factor and factor["carried"])
        self.judge_state(state, 0.)
        if kind != "bounded":
            return
        carried, bound = factor["carried"], float(factor["bound"])
        size = max(abs(carried), 1e-3)
        if self.kind == "bounded":
            room = LARGEST_DIFFERENCE * size
            if sense * (inside[1] - bound) > room or \
                    sense * (carried - around[1]) > room:
                self.report("fault", found, f"{carried} to {bound}, where "
                            f"HiGHS has {inside[1]} to {around[1]}")
        self.judge_forces(found, carried)
        self.judge_mechanism(found, bound)
        self.difference = abs(bound - carried) / size
        if self.difference > LARGEST_DIFFERENCE:
            self.report("overruled", found, f"{carried} to {bound}")
            return
        for distance in DISTANCES[:self.n_distances]:
            for side in (1., -1.):
                # Beyond the greatest factor, or the least one, and within.
                factor = bound + sense * side * distance * size if side > 0. \
                    else carried - sense * distance * size
                run = self.run(f"{'beyond' if side > 0. else 'within'}_"
                               f"{distance:g}", factor)
                self.n_states += 1
                wanted = "collapse" if side > 0. else "carried"
                verdict = run.verdict()
                if verdict == wanted or (side < 0. and self.lies_below(factor)):
                    self.judge_state(run, factor)
                elif verdict == "undecided":
                    if distance > NEAR:
                        self.report("undecided", run, f"{wanted} at "
                                    f"{distance}: {run.message}")
                else:
                    self.report("fault", run, f"{verdict}, not {wanted} at "
                                f"{distance} from the limit")

    def judge_factor(self, found, kind, carried):
        """By a further judge; there is none."""

    def limits(self, sense):
        """The answers with polygons inside the circles and around them."""
        return [self.programme.solve(self.dead, self.live, sense, radius)
                for radius in (numpy.cos(numpy.pi / SIDES), 1.)]

    def lies_below(self, factor):
        """Whether a factor is not carried since more is needed."""
        sense = 1. if self.scene.sense == "greatest" else -1.
        inside = self.limits(-sense)[0]
        return inside[0] == "bounded" and \
            sense * (factor - inside[1]) < 1e-6 * max(abs(factor), 1.)

    def judge_state(self, run, factor):
        if run.verdict() == "carried":
            self.judge_forces(run, factor)
        elif run.verdict() == "collapse":
            self.judge_collapse(run, factor)

    def judge_forces(self, run, factor):
        """Balance and limits of the forces at the points."""
        b, scene = self.blocks, self.scene
        force = columns(run.table("interface_points.csv"),
                        ["force_x", "force_y", "force_z"])
        total = self.dead + factor * self.live
        reference = max(numpy.abs(total).max(), 1e-300)
        for ends, sign in ((b.minus, 1.), (b.plus, -1.)):
            cell = ends[b.joint]
            on = cell >= 0
            arm = b.place[on] - b.centre[cell[on]]
            numpy.add.at(total[:, :3], cell[on], sign * force[on])
            numpy.add.at(total[:, 3:], cell[on],
                         sign * numpy.cross(arm, force[on]) / b.length)
        error = numpy.abs(total[:, :self.programme.n]).max()
        normal = b.normal[b.joint]
        size = b.share * b.area[b.joint]
        pressure = scene.tension * size - (force * normal).sum(axis=1)
        shear = numpy.linalg.norm(
            force - (force * normal).sum(axis=1)[:, None] * normal, axis=1)
        strength = max(scene.strength - scene.coefficient * scene.tension, 0.)
        excess = numpy.where(
            b.presses,
            numpy.maximum(-pressure, shear - scene.coefficient *
                          numpy.maximum(pressure, 0.)),
            shear - strength * size)
        # Forces that are carried "to within" may be that much beyond limits.
        within = LARGEST_ERROR + 2. * run.summary.get("within", 0.)
        if error > LARGEST_ERROR * reference or \
                excess.max() > within * reference:
            self.report("fault", run, f"forces are off by {error / reference}"
                        f", and {excess.max() / reference} beyond limits")

    def jumps(self, run):
        """Of c+ relative to c- at the points, and the motion of the cells."""
        b = self.blocks
        cells = run.table("cells.csv")
        u = columns(cells, ["displacement_x", "displacement_y",
                            "displacement_z"])
        w = columns(cells, ["rotation_x", "rotation_y", "rotation_z"])
        jump = numpy.zeros_like(b.place)
        for ends, sign in ((b.minus, -1.), (b.plus, 1.)):
            cell = ends[b.joint]
            on = cell >= 0
            arm = b.place[on] - b.centre[cell[on]]
            jump[on] += sign * (u[cell[on]] + numpy.cross(w[cell[on]], arm))
        return jump, numpy.hstack([u, w * b.length])

    def resisted(self, run):
        """What a motion dissipates, and by how much joints close in it."""
        b, scene = self.blocks, self.scene
        jump, motion = self.jumps(run)
        normal = b.normal[b.joint]
        size = b.share * b.area[b.joint]
        opening = (jump * normal).sum(axis=1)
        slip = numpy.linalg.norm(jump - opening[:, None] * normal, axis=1)
        strength = max(scene.strength - scene.coefficient * scene.tension, 0.)
        dissipated = numpy.where(b.presses, scene.tension * size * opening,
                                 strength * size * slip).sum()
        closing = numpy.where(b.presses, scene.coefficient * slip - opening, 0.)
        return dissipated, closing.max() / numpy.abs(motion).max(), motion

    def judge_mechanism(self, run, bound):
        dissipated, closing, motion = self.resisted(run)
        work = (self.live * motion).sum()
        proven = (dissipated - (self.dead * motion).sum()) / work
        sense = 1. if self.scene.sense == "greatest" else -1.
        if not (sense * work > 0. and closing <= 1e-11 and
                abs(proven - bound) <= LARGEST_ERROR * max(abs(bound), 1e-3)):
            self.report("fault", run, f"the mechanism proves {proven}, not "
                        f"{bound}, and closes by {closing}")

    def judge_collapse(self, run, factor):
        dissipated, closing, motion = self.resisted(run)
        work = ((self.dead + factor * self.live) * motion).sum()
        if not (work > dissipated and closing <= 1e-11):
            self.report("fault", run, f"the mechanism does the work {work}, "
                        f"dissipates {dissipated}, and closes by {closing}")
