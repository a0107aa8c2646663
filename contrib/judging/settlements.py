"""What supports do that move in one scene, by the program and by HiGHS."""
import re

import numpy

from judging.extremes import Extremes
from judging.joints import resistance
from judging.packing import number
from judging.proofs import state_proof, written_forces, written_motion
from judging.scenes import StandingScene
from judging.small_scenes import SmallJudgement

# Of the work, over the largest load and the largest displacement, and of what
# is added up again.
LARGEST_DIFFERENCE, LARGEST_ERROR = 1e-8, 1e-9
NUMBER = r"[-+.\de]+"


class SettlementJudgement(SmallJudgement):
    """The greatest work of the ground, and the proofs of it."""
    question = "settlement"
    extremes_of = Extremes
    largest_difference = LARGEST_DIFFERENCE
    scenes = StandingScene

    def settings(self):
        choice = self.choice
        self.by_part = []
        points = numpy.concatenate(self.cells.polygons)
        # Arches have supports at their ends, others at the foot.
        self.cut = points[:, 0].min() + \
            choice.uniform(0.2, 0.8) * numpy.ptp(points[:, 0])
        turns = self.scene.rotations and choice.random() < 0.5
        size = 0.01 * self.cells.size
        for _ in range(2):
            motion = [size * choice.uniform(-1., 1.) for _ in range(2)]
            motion.append(0.01 * choice.uniform(-1., 1.) if turns else 0.)
            self.by_part.append(motion)
        on_ground = self.joints.cells[:, 1] < 0
        middle = 0.5 * (self.joints.start + self.joints.end)
        if numpy.any(middle[on_ground, 0] > self.cut) and \
                choice.random() < 0.5:
            self.by_part[0] = [0., 0., 0.]
        expressions = [f"x > {number(self.cut)} ? {number(right)} : "
                       f"{number(left)}"
                       for left, right in zip(*self.by_part)]
        return ["subsection Supports", "set Displacement = " +
                "; ".join(expressions[:3 if turns else 2]), "end"]

    def take(self, text):
        displacement = re.search(r"Displacement = (.*)", text).group(1)
        parts = re.findall(rf"x > ({NUMBER}) \? ({NUMBER}) : ({NUMBER})|"
                           rf"({NUMBER})", displacement)
        self.cut = max(float(part[0]) for part in parts if part[0])
        self.by_part = [[float(part[k] or part[3]) for part in parts] + [0.]
                        for k in (2, 1)]

    def jumps_at_rest(self):
        """The opening at each contact and the sliding of each joint where
        blocks stay and supports move; and the largest displacement."""
        joints = self.joints
        openings = numpy.zeros((joints.n_contacts, len(joints)))
        sliding = numpy.zeros(len(joints))
        largest = 0.
        middle = 0.5 * (joints.start + joints.end)
        for joint in numpy.nonzero(joints.cells[:, 1] < 0)[0]:
            *shift, angle = \
                self.by_part[int(middle[joint, 0] > self.cut)][:3]
            sliding[joint] = joints.tangent[joint] @ shift
            for k, point in enumerate(joints.contacts()):
                arm = point[joint] - middle[joint]
                u = shift + angle * numpy.array((-arm[1], arm[0]))
                openings[k, joint] = joints.normal[joint] @ u
                largest = max(largest, numpy.hypot(*u))
        return openings, sliding, largest

    def compare(self, run):
        openings, sliding, largest = self.jumps_at_rest()
        work = self.joints.in_order(-openings, sliding)
        self.extremes = self.extremes_of(self.programme)
        scale = self.extremes.force * largest
        found = run.summary["settlement"]
        self.n_states += 1
        work_of = work / largest
        away = self.extremes.difference(work_of, found["work"] / largest)
        if away is None:
            self.report("doubtful", run, "HiGHS has no answer")
            return
        self.difference = away
        if away > self.largest_difference:
            expected = self.extremes.greatest(work_of).value * largest
            self.report("fault", run, f"the work is {found['work']!r}, "
                        f"expected {expected!r}")
        for words in self.faults_of_proofs(run, work, openings, sliding, scale):
            self.report("fault", run, words)

    def faults_of_proofs(self, run, work, openings, sliding, scale):
        """What is wrong with the forces and the motion."""
        programme = self.programme
        found = run.summary["settlement"]
        state = written_forces(run, self.joints)
        proof = state_proof(run, programme, programme.dead)
        if proof.error() > LARGEST_ERROR:
            yield f"the forces prove nothing: {proof}"
        if abs(work @ state - found["work"]) > LARGEST_ERROR * scale:
            yield f"the forces do the work {work @ state!r}, not " \
                f"{found['work']!r}"
        motion = written_motion(run, programme, "cells.csv")
        jumps = (programme.matrix.T @ motion).reshape(len(self.joints), -1)
        energy, closing = resistance(
            self.joints, programme.sections, jumps[:, :-1].T + openings,
            sliding - jumps[:, -1])
        energy -= programme.dead @ motion
        more = (energy - found["work"]) / scale
        self.miss = max(self.miss, more)
        if more > self.largest_difference:
            yield f"the motion has {more:.1e} more energy than said"
        if closing > LARGEST_ERROR * scale / self.extremes.force:
            yield f"the motion closes joints by {closing:.1e}"

    def judge_refusal(self, run):
        if run.status != 2 or "cannot follow" not in run.message:
            super().judge_refusal(run)
            return
        openings, sliding, largest = self.jumps_at_rest()
        work = self.joints.in_order(-openings, sliding)
        self.n_states += 1
        away = self.extremes_of(self.programme).difference(work / largest, numpy.inf)
        if away is None:
            self.report("doubtful", run, "HiGHS has no answer")
        elif away > 0.:
            self.report("fault", run, run.message)
