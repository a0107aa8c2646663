"""What the questions about all states of a scene begin with: its packing, and
loads that it carries."""
import random

import numpy

from judging.program import SOLVED
from judging.programme import Programme
from judging.scenes import SmallScene, draw_loads

# Of a load factor that is bounded, the share that is asked for.
SHARES = (0., 0., 0.3, 0.9, 0.999)


class SmallJudgement:
    """One scene on its way through the program and HiGHS.

    Has what a Tally counts: of the kinds "bounded" are scenes that are
    compared, and "not carried" the others. What is wrong goes to report(kind,
    run, words), where kind is "fault" or a word of what is tolerated.
    """
    # The word for it in names of files, and the scenes that it is asked of.
    question = ""
    scenes = SmallScene
    programme_of = Programme

    def __init__(self, program, scene, report):
        self.program = program
        self.scene = scene
        self.choice = random.Random(f"{scene.name} {self.question}")
        self.report = report
        self.n_states = 0
        self.kind = "not carried"
        self.difference = self.miss = 0.

    def judge(self):
        """All of it."""
        name = f"{self.scene.name}_{self.question}"
        if self.scene.drawing:
            self.program.write(f"{self.scene.name}.wkt", self.scene.drawing)
        packing = self.program.run(f"{name}_packing", self.scene.text())
        if packing.status != SOLVED:
            self.report("fault", packing, "the packing is refused")
            return
        self.joints, self.cells = packing.packing()
        loads = self.draw()
        written = loads.on(self.cells)
        # Of live loads there is no question.
        self.programme = self.programme_of(self.joints, self.cells, written,
                                           numpy.ones_like(written))
        settings = ["set Formulation = least energy"] \
            if self.scene.law == "Tresca" else []
        run = self.program.run(
            name, self.scene.text([*settings, *self.settings()], loads))
        if run.status not in (0, 2, 3, 4):
            self.report("fault", run, f"status {run.status}: {run.message}")
        elif run.verdict() == "carried":
            self.kind = "bounded"
            self.compare(run)
        else:
            self.judge_refusal(run)

    def judge_given(self):
        """The same of a GivenScene, with the loads that the program finds."""
        for name, text in self.scene.drawings.items():
            self.program.write(name, text)
        run = self.program.run(self.scene.name, self.scene.text)
        if run.status != SOLVED:
            self.report("fault", run, f"status {run.status}: {run.message}")
            return
        self.joints, self.cells = run.packing()
        loads = run.loads()
        self.programme = self.programme_of(self.joints, self.cells, loads,
                                   numpy.ones_like(loads))
        self.kind = "bounded"
        self.take(self.scene.text)
        self.compare(run)

    def take(self, text):
        """What a given scene asks for."""

    def draw(self):
        """Dead loads and a share of the live loads that they bear besides."""
        dead, live = draw_loads(self.scene, self.cells)
        share = self.choice.choice(SHARES)
        if share == 0.:
            return dead
        programme = self.programme_of(
            self.joints, self.cells, dead.on(self.cells), live.on(self.cells))
        limit = programme.judge(1.)
        if limit.kind == "bounded" and limit.factor > 0.:
            return dead.plus(share * limit.factor, live)
        if limit.kind == "unbounded":
            return dead.plus(share * programme.unit, live)
        return dead

    def judge_refusal(self, run):
        """A run without an answer, where loads may be none that are carried."""
        if run.status == 2 or "programme" in run.message or \
                "proven" in run.message:
            self.report("undecided", run, run.message)

    def settings(self):
        """The lines of the question."""
        raise NotImplementedError

    def compare(self, run):
        """The answer of a run with HiGHS's."""
        raise NotImplementedError
