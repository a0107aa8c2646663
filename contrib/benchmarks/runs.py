"""Run voussoir with given parameters, in turn and repeatedly, and collect what
it answered and what that took.

Parameters are a dictionary from the path of an entry, such as
"Solver/Tolerance", to its value.
"""
import dataclasses
import json
import math
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile

TIME_LIMIT = 600  # seconds a run
MEMORY_LIMIT = 16  # GiB a process
LAUNCH = pathlib.Path(__file__).with_name("launch.py")
SOLVED, BAD_INPUT, COLLAPSE, NO_ANSWER = 0, 2, 3, 4
STATUS = {SOLVED: "solved", COLLAPSE: "not carried", NO_ANSWER: "no answer",
          -signal.SIGALRM: "time limit", -signal.SIGKILL: "out of memory"}
NO_MEMORY = re.compile("bad_alloc|not enough memory|out of memory|"
                       "cannot allocate memory", re.I)


@dataclasses.dataclass
class Process:
    """How a process ended: its exit status (negative: the signal that ended
    it), the seconds from start to end, the largest memory in MiB, and what it
    printed."""
    status: int
    elapsed: float
    memory: float
    text: str

    @property
    def outcome(self):
        """The exit status in words."""
        if self.status != SOLVED and NO_MEMORY.search(self.text):
            return "out of memory"
        return STATUS.get(self.status, "crash")


def launch(command, time_limit):
    """Run a command, alone in its own memory."""
    launcher = subprocess.run(
        [sys.executable, "-I", "-S", LAUNCH, str(time_limit),
         str(MEMORY_LIMIT), *command], capture_output=True, text=True,
        check=True)
    status, elapsed, memory = map(float, launcher.stdout.split())
    return Process(int(status), elapsed, memory / 1024, launcher.stderr)


@dataclasses.dataclass
class Run(Process):
    """One run of the program: also the seconds of its stages (empty if it wrote
    no summary), its summary and directory."""
    stages: dict
    summary: dict
    directory: pathlib.Path


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


def on_ranks(ranks):
    """The beginning of a command that runs on a number of processes."""
    if ranks == 1:
        return []
    as_root = ["--allow-run-as-root"] * (os.geteuid() == 0)
    return ["mpirun", "-np", str(ranks), *as_root]


class Bench:
    """A program, a directory for its results, how often to repeat, how many
    seconds a run may take, and how many cells there may be."""

    def __init__(self, program, repeats, quick, time_limit=TIME_LIMIT,
                 largest=math.inf):
        self.program = str(program)
        self.repeats = repeats
        self.quick = quick
        self.time_limit = time_limit
        self.largest = largest
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

    def sizes(self, full, quick):
        """The numbers of cells for the full study, or those for a quick one."""
        return [cells for cells in self.sized(full, quick)
                if cells <= self.largest]

    def run(self, parameters, ranks=1):
        """One run, on a number of processes; its results are lost at the
        next."""
        directory = self.scratch / "results"
        shutil.rmtree(directory, ignore_errors=True)
        scene = self.scratch / "scene.prm"
        scene.write_text(
            prm_text({"Output directory": directory, **parameters}))
        process = launch([*on_ranks(ranks), self.program, scene],
                         self.time_limit)
        if process.status in (1, BAD_INPUT):
            sys.exit(f"{self.program} ended with status {process.status}:\n"
                     f"{process.text}\nThe parameters were\n"
                     f"{scene.read_text()}")
        summary = directory / "summary.json"
        summary = json.loads(summary.read_text()) if summary.exists() else {}
        return Run(**vars(process), stages=summary.get("timings", {}),
                   summary=summary, directory=directory)

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
