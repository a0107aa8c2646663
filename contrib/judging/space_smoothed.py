"""The judgement of one state with smoothed friction in space, whose forces
follow from the motion."""
import numpy

from judging.space import columns
from judging.space_questions import FurtherJudgement, FurtherScene

# Of forces from those of the motion, over the largest.
LARGEST_DIFFERENCE = 1e-8
SMOOTHED = ["set Formulation = smoothed friction"]


class TrescaScene(FurtherScene):
    """A scene with Tresca's friction, and without tension."""
    laws = ("Tresca",)
    bears_tension = False


class SmoothedJudgement(FurtherJudgement):
    """Balance and limits of forces, and that they are those of the motion.

    The difference that a tally has is that of a force, over the largest."""
    question = "smoothed"
    scenes = TrescaScene

    def lines(self):
        return SMOOTHED

    def compare(self, run, factor):
        self.n_states += 1
        self.judge_forces(run, factor)
        if run.summary["formulation"] != "smoothed friction":
            self.report("fault", run, "it is " + run.summary["formulation"])
        elif "smoothed" not in run.summary["selection"]:
            self.report("other state", run, run.summary["selection"])
        else:
            self.compare_forces(run)

    def compare_forces(self, run):
        """With the springs and the smoothed friction of the jumps."""
        b = self.blocks
        jump, _ = self.jumps(run)
        normal = b.normal[b.joint]
        opening = (jump * normal).sum(axis=1)
        slip = jump - opening[:, None] * normal
        distance = columns(run.table("interfaces.csv"),
                           ["distance"])[b.joint, 0]
        size = b.share * b.area[b.joint]
        strength = self.scene.strength
        root = numpy.sqrt((slip**2).sum(axis=1) + (strength * distance)**2)
        expected = numpy.where(
            b.presses[:, None],
            (size / distance * numpy.minimum(opening, 0.))[:, None] * normal,
            (strength * size / root)[:, None] * slip)
        force = columns(run.table("interface_points.csv"),
                        ["force_x", "force_y", "force_z"])
        # Of rounding in large motions the stiffness makes forces.
        largest = max(numpy.abs(force).max(), 1e-300)
        self.difference = numpy.abs(force - expected).max() / largest
        if self.difference > LARGEST_DIFFERENCE:
            self.report("fault", run, f"forces differ by {self.difference:.1e} "
                        "of the largest from those of the motion")
