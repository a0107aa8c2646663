"""What supports do that move in one scene in space, by the program and by
HiGHS."""
import numpy

from judging.space import columns
from judging.space_extremes import SpaceExtremes
from judging.space_questions import FurtherJudgement, FurtherScene

# Of what is added up again, over the largest load and the largest displacement.
LARGEST_ERROR = 1e-9
# Of displacements over the size of a cell, and of angles.
SIZE = 0.01


class SupportedScene(FurtherScene):
    """A scene with supports."""
    can_float = False


class SpaceSettlementJudgement(FurtherJudgement):
    """The greatest work of the ground, and the proofs of it."""
    question = "settlements"
    scenes = SupportedScene
    # Of the work, over the largest load and displacement or itself.
    largest_difference = 1e-7

    def lines(self):
        b, choice = self.blocks, self.choice
        turns = self.scene.rotations and choice.random() < 0.5
        size = SIZE * b.length
        self.motions = {}
        for part in ("one side", "other side", "cell"):
            motion = [size * choice.uniform(-1., 1.) for _ in range(3)]
            motion += [SIZE * choice.uniform(-1., 1.) if turns else 0.
                       for _ in range(3)]
            self.motions[part] = motion
        if choice.random() < 0.3:
            self.motions["one side"] = [0.] * 6
        on_ground = b.minus[b.plus < 0]
        self.cell = choice.choice(list(on_ground)) \
            if choice.random() < 0.3 else None
        self.axis = choice.randrange(2)
        at = self.middle[b.plus < 0, self.axis]
        self.cut = at.min() + choice.uniform(0.2, 0.8) * numpy.ptp(at)
        n = 6 if turns else 3
        sides = "; ".join(
            f"{'xy'[self.axis]} > {self.cut:.17g} ? {one:.17g} : {other:.17g}"
            for one, other in zip(self.motions["one side"][:n],
                                  self.motions["other side"][:n]))
        lines = ["subsection Supports", f"set Displacement = {sides}"]
        if self.cell is not None:
            motion = "; ".join(f"{value:.17g}"
                               for value in self.motions["cell"][:n])
            lines.append(f"set Group displacements = cell {self.cell}: {motion}")
        return [*lines, "end"]

    def take(self, run):
        super().take(run)
        self.middle = columns(run.table("interfaces.csv"), "xyz")

    def of_ground(self):
        """The displacement of the ground at each point, where it is."""
        b = self.blocks
        moved = numpy.zeros_like(b.place)
        for e in numpy.nonzero(b.plus < 0)[0]:
            part = "cell" if b.minus[e] == self.cell else "one side" \
                if self.middle[e, self.axis] > self.cut else "other side"
            motion = numpy.array(self.motions[part])
            at = b.joint == e
            moved[at] = motion[:3] + numpy.cross(
                motion[3:], b.place[at] - self.middle[e])
        return moved

    def jumps(self, run):
        jump, motion = super().jumps(run)
        return jump + self.of_ground(), motion

    def compare(self, run, factor):
        moved = self.of_ground()
        extremes = SpaceExtremes(self.programme, self.loads)
        largest = numpy.linalg.norm(moved, axis=1).max()
        scale = extremes.force * largest
        work = run.summary["settlement"]["work"]
        self.n_states += 1
        self.agree(run, "the work", work, extremes.greatest(moved), scale)
        self.judge_forces(run, factor)
        for words in self.faults_of_proofs(run, moved, work, scale, largest):
            self.report("fault", run, words)

    def faults_of_proofs(self, run, moved, work, scale, largest):
        """What is wrong with the forces and the motion."""
        force = columns(run.table("interface_points.csv"),
                        ["force_x", "force_y", "force_z"])
        own = (force * moved).sum()
        if abs(own - work) > LARGEST_ERROR * max(scale, abs(work)):
            yield f"the forces do the work {own!r}, not {work!r}"
        dissipated, closing, motion = self.resisted(run)
        closing *= numpy.abs(motion).max()
        if closing > LARGEST_ERROR * largest:
            yield f"the motion closes joints by {closing / largest:.1e}"
        more = (dissipated - (self.loads * motion).sum() - work) / scale
        room = self.largest_difference * max(1., abs(work) / scale)
        self.miss = max(self.miss, more)
        if more > room:
            yield f"the motion has {more:.1e} more energy than said"
        if more < -1e-9:
            yield f"the motion proves {-more:.1e} less than the work"

    def judge_refusal(self, run):
        if run.status != 2 or "cannot follow" not in run.message:
            super().judge_refusal(run)
            return
        self.kind = "unbounded"
        self.agree(run, "the work", numpy.inf, SpaceExtremes(
            self.programme, self.loads).greatest(self.of_ground()), 1.)
