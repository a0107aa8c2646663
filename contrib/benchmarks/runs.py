"""Run voussoir with given parameters, in turn and repeatedly, and collect what
it answered and what that took.

Parameters are a dictionary from the path of an entry, such as
"Solver/Tolerance", to its value.
"""
import dataclasses
import json
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile

TIME_LIMIT = 600  # seconds a run
LAUNCH = pathlib.Path(__file__).with_name("launch.py")
SOLVED, BAD_INPUT, COLLAPSE, NO_ANSWER = 0, 2, 3, 4
STATUS = {SOLVED: "solved", COLLAPSE: "not carried", NO_ANSWER: "no answer",
          -signal.SIGALRM: "time limit"}


@dataclasses.dataclass
class Run:
    """One run: its exit status (negative: the signal that ended it), the
    seconds of its stages (empty if it wrote no summary), the seconds from start
    to end, the largest memory in MiB, and its summary and directory."""
    status: int
    stages: dict
    elapsed: float
    memory: float
    summary: dict
    directory: pathlib.Path

    @property
    def outcome(self):
        """The exit status in words."""
        return STATUS.get(self.status, "crash")


@dataclasses.dataclass
class Outcome:
    """The runs of one setting; `seen` is what was seen of the results of the
    first of them, if it was solved."""
    labels: dict
    runs: list
    seen: object = None

    @property
    def outcome(self):
        """How the runs ended; all in the same way, unless something is odd."""
        return "/".join(dict.fromkeys(run.outcome for run in self.runs))


def prm_text(parameters):
    """The parameters as the text of a .prm file."""
    lines = []
    for path, value in parameters.items():
        *sections, name = path.split("/")
        lines += [f"subsection {section}" for section in sections]
        lines.append(f"set {name} = {value}")
        lines += ["end"] * len(sections)
    return "\n".join(lines) + "\n"


class Bench:
    """A program, a directory for its results, and how often to repeat."""

    def __init__(self, program, repeats, quick):
        self.program = str(program)
        self.repeats = repeats
        self.quick = quick
        self.version = subprocess.run(
            [self.program, "--version"], capture_output=True, text=True,
            check=True).stdout.split()[-1]
        self.scratch = pathlib.Path(tempfile.mkdtemp(prefix="voussoir_study_"))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        shutil.rmtree(self.scratch, ignore_errors=True)

    def sized(self, full, quick):
        """The size for the full study, or that for a quick one."""
        return quick if self.quick else full

    def run(self, parameters):
        """One run; its results are lost at the next."""
        directory = self.scratch / "results"
        shutil.rmtree(directory, ignore_errors=True)
        scene = self.scratch / "scene.prm"
        scene.write_text(
            prm_text({"Output directory": directory, **parameters}))
        process = subprocess.run(
            [sys.executable, "-I", "-S", LAUNCH, str(TIME_LIMIT), self.program,
             scene], capture_output=True, text=True, check=True)
        status, elapsed, memory = map(float, process.stdout.split())
        if status in (1, BAD_INPUT):
            sys.exit(f"{self.program} ended with status {int(status)}:\n"
                     f"{process.stderr}\nThe parameters were\n"
                     f"{scene.read_text()}")
        summary = directory / "summary.json"
        summary = json.loads(summary.read_text()) if summary.exists() else {}
        return Run(int(status), summary.get("timings", {}), elapsed,
                   memory / 1024, summary, directory)

    def series(self, name, settings, see=None, repeats=None):
        """An Outcome for each of the settings, pairs of labels and parameters,
        of which all are run once before any is run again. `see` is called with
        the first run while its results are there."""
        outcomes = [Outcome(labels, []) for labels, _ in settings]
        repeats = repeats or self.repeats
        for repeat in range(repeats):
            for outcome, (labels, parameters) in zip(outcomes, settings):
                run = self.run(parameters)
                if see and repeat == 0 and run.status == SOLVED:
                    outcome.seen = see(run)
                outcome.runs.append(run)
                print(f"{name}: {repeat + 1}/{repeats}, "
                      f"{', '.join(str(label) for label in labels.values())}: "
                      f"{run.outcome}, {run.elapsed:.2f} s", flush=True)
        return outcomes
