"""Runs of the program, and what they leave."""
import csv
import dataclasses
import json
import pathlib
import subprocess

import numpy

from judging.joints import Joints
from judging.packing import Packing

SOLVED, COLLAPSE, NO_ANSWER = 0, 3, 4


@dataclasses.dataclass
class Run:
    """The end of a run: its exit status, summary.json and last words."""
    prm: pathlib.Path
    results: pathlib.Path
    status: int
    message: str
    summary: dict

    def table(self, name):
        with open(self.results / name) as file:
            return list(csv.DictReader(file))

    def verdict(self):
        """"carried", "collapse", "undecided", "clamped" or "refused"."""
        if self.status == SOLVED:
            return "carried" if self.summary["status"] == "solved" \
                else "undecided"
        if self.status == COLLAPSE:
            return "collapse"
        if self.status == NO_ANSWER or self.status is None:
            return "undecided"
        return "clamped" if " clamp" in self.message else "refused"

    def packing(self):
        """The joints and the cells, with nothing but their geometry."""
        rotations = self.summary.get("rotations", False)
        joints = Joints(self.table("interfaces.csv"), rotations)
        wkt = (self.results / "packing.wkt").read_text()
        return joints, Packing(wkt, self.table("cells.csv"), joints)

    def loads(self):
        """The force and torque on each cell that the program has found."""
        rows = self.table("cells.csv")
        keys = ("load_x", "load_y", "load_torque")
        return numpy.array([[float(row.get(key, 0.)) for key in keys]
                            for row in rows])


class Program:
    """The program, run in a directory of its own."""

    def __init__(self, path, directory, seconds=300, environment=None):
        self.path = pathlib.Path(path).resolve()
        self.directory = pathlib.Path(directory)
        self.seconds = seconds
        self.environment = environment

    def write(self, name, text):
        """A file that a .prm file names."""
        (self.directory / name).write_text(text)

    def run(self, name, text):
        """Run the text of a .prm file."""
        prm = self.directory / f"{name}.prm"
        prm.write_text(text)
        return self.run_file(prm)

    def run_file(self, prm, settings=()):
        """Run a .prm file, with settings "Section/Entry=value" beside it."""
        results = self.directory / f"results_{prm.stem}"
        words = [word for setting in (f"Output directory={results}", *settings)
                 for word in ("--set", setting)]
        try:
            done = subprocess.run(
                [self.path, prm, "--quiet", *words], capture_output=True,
                text=True, timeout=self.seconds, env=self.environment)
        except subprocess.TimeoutExpired:
            return Run(prm, results, None, "not done in time", {})
        summary = {}
        if done.returncode in (SOLVED, COLLAPSE):
            summary = json.loads((results / "summary.json").read_text())
        return Run(prm, results, done.returncode, done.stderr.strip(), summary)
