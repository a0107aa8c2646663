"""Scenes whose answer is known by construction, without another solver.

Forces within their limits are drawn first, and the loads are what they balance: these are
carried. Then some blocks are moved away so that no joint closes, and what pulls them that
way is made larger than what loads and joints hold back: that collapses.
"""
import dataclasses
import math

import numpy

from judging.joints import resistance
from judging.packing import number
from judging.programme import IntervalProgramme
from judging.sections import Sections
from judging.verdicts import FORMULATIONS, Judgement, settings_of

# Decades between the smallest and the largest pressure of a state, and of all of them.
MOST_DECADES, DECADES_OF_SIZE = 5., 3.
# Shares of the limits of friction that are used.
LARGEST_SHARE = 0.999
# Of that by which loads win, over what holds back: powers of ten.
LEAST_EXCESS, LARGEST_EXCESS = -4., 1.
# Motions that are tried.
MOST_MOTIONS = 40
# From its centroid to a vertex of a cell, where a couple acts.
ARM_OF_COUPLE = 0.2


@dataclasses.dataclass
class CellLoads:
    """A force and a torque about the centroid on each cell."""
    packing: object
    forces: numpy.ndarray
    torques: numpy.ndarray

    def entries(self):
        """Forces at centroids, and couples of two forces beside them."""
        words = []
        for cell, (force, torque) in enumerate(zip(self.forces, self.torques)):
            if numpy.any(force != 0.):
                words.append(f"cell {cell}: {number(force[0])}, {number(force[1])}")
            if torque != 0.:
                middle = self.packing.centroid[cell]
                arm = ARM_OF_COUPLE * (self.packing.polygons[cell][0] - middle)
                pull = 0.5 * torque / (arm @ arm) * numpy.array((-arm[1], arm[0]))
                words += [f"cell {cell}: {number(s * pull[0])}, {number(s * pull[1])}"
                          f" at {number(x)}, {number(y)}"
                          for s in (1., -1.) for x, y in (middle + s * arm,)]
        return ["set Cell forces = " + " | ".join(words)] if words else []

    def about_centres(self):
        """Rows of forces and torques about the centres of the cells."""
        arm = self.packing.centroid - self.packing.centre
        return numpy.column_stack([
            self.forces, self.torques + arm[:, 0] * self.forces[:, 1]
            - arm[:, 1] * self.forces[:, 0]])


class ConstructedJudgement(Judgement):
    """Loads of a state that is drawn, and of a motion that is."""
    kind = "refused"
    finds_limits = False

    def judge(self):
        if not self.has_packing():
            return
        self.kind = "constructed"
        self.matrix = self.joints.equilibrium(self.packing.centroid, 1.)
        self.sections = Sections(self.joints)
        self.forces = self.admissible_forces()
        self.state_of(self.loads_of(self.forces), "carried")
        if not self.scene.is_floating:
            moving = self.motion()
            if moving is not None:
                self.state_of(self.winning_loads(*moving), "collapse")

    def admissible_forces(self):
        """Joint by joint: pressures, some of them none, and friction."""
        choice, joints = self.choice, self.joints
        decades = choice.uniform(0., MOST_DECADES)
        size = 10. ** choice.uniform(-DECADES_OF_SIZE, DECADES_OF_SIZE) * joints.length.mean()
        least, most = (limit / joints.n_contacts for limit in (joints.tension, joints.crushing))
        pressures = numpy.array([
            [self.pressure(size, decades, *limits) for limits in zip(least, most)]
            for _ in range(joints.n_contacts)])
        limit = joints.strength * joints.length + joints.coefficient * pressures.sum(0)
        share = numpy.array([choice.choice((0., choice.uniform(-1., 1.))) for _ in limit])
        return joints.in_order(pressures, LARGEST_SHARE * share * limit)

    def pressure(self, size, decades, tension, crushing):
        choice = self.choice
        if tension > 0. and choice.random() < 0.3:
            return -LARGEST_SHARE * choice.random() * tension
        return min(size * 10. ** (-decades * choice.random()),
                   LARGEST_SHARE * crushing)

    def loads_of(self, forces):
        """What balances forces."""
        rotations = self.joints.rotations
        sums = -(self.matrix @ forces)
        sums = sums.reshape(len(self.packing), 3 if rotations else 2)
        return CellLoads(self.packing, sums[:, :2],
                         sums[:, 2] if rotations else numpy.zeros(len(sums)))

    def motion(self):
        """Blocks that move, and how: x -> displacement; none if some would always close."""
        for _ in range(MOST_MOTIONS):
            moving = self.some_blocks()
            u = numpy.zeros((len(self.packing), 3))
            angle = self.choice.uniform(-math.pi, math.pi)
            turn = 0.
            if self.joints.rotations and self.choice.random() < 0.5:
                turn = self.choice.uniform(-1., 1.) / self.packing.size
            middle = self.packing.centroid[moving].mean(0)
            arm = self.packing.centroid[moving] - middle
            u[moving, 0] = math.cos(angle) - turn * arm[:, 1]
            u[moving, 1] = math.sin(angle) + turn * arm[:, 0]
            u[moving, 2] = turn
            resisted, closing = self.resistance_to(u)
            if closing < 1e-13 and math.isfinite(resisted):
                return u, resisted
        return None

    def some_blocks(self):
        """One block, or those beyond a line."""
        choice, centroid = self.choice, self.packing.centroid
        if choice.random() < 0.5:
            return numpy.array([choice.randrange(len(self.packing))])
        angle = choice.uniform(-math.pi, math.pi)
        along = centroid @ (math.cos(angle), math.sin(angle))
        return numpy.nonzero(along >= choice.choice([*along]))[0]

    def resistance_to(self, u):
        """What joints take out of a motion, and by how much they close."""
        rows = u if self.joints.rotations else u[:, :2]
        jumps = (self.matrix.T @ rows.ravel()).reshape(len(self.joints), -1)
        return resistance(self.joints, self.sections, jumps[:, :-1].T, jumps[:, -1])

    def winning_loads(self, u, resisted):
        """Loads of the state, and what pulls along the motion by more than is held back."""
        loads = self.loads_of(self.forces)
        held = resisted - (loads.forces * u[:, :2]).sum() - loads.torques @ u[:, 2]
        excess = 10. ** self.choice.uniform(LEAST_EXCESS, LARGEST_EXCESS)
        work = held + excess * max(held, numpy.abs(loads.forces).max())
        pulled = numpy.nonzero(numpy.any(u != 0., 1))[0]
        of_force = (u[pulled, :2] ** 2).sum()
        loads.forces[pulled] += work / of_force * u[pulled, :2]
        return loads

    def state_of(self, loads, expected):
        """A run with loads whose verdict is known."""
        settings, way = [], "interior point"
        if self.scene.law == "Tresca":
            way = self.choice.choice([*FORMULATIONS])
            settings = settings_of(way)
        run = self.run(expected, self.scene.text(settings, loads))
        if run.verdict() == "clamped":
            run = self.run(expected, self.scene.text([], loads))
        self.n_states += 1
        words = f"{way}: {run.verdict()}, {expected} by construction"
        if run.verdict() != expected:
            self.report("fault", run, f"{words}; {run.message}")
            return
        rows = loads.about_centres()
        self.programme = IntervalProgramme(self.joints, self.packing, rows, rows)
        self.judge_proof(run, 0., words)
