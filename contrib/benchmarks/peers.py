"""The experiments on other solvers: functions from a Bench to the rows of a
table.

All get the same packing. The others are given the rigid problem of
rigid_program.py, each in the form in which it is fastest at the size that
forms() tries, in a process of its own. What they answer is judged by the
measures of the program's own results, from the forces alone.
"""
import dataclasses
import functools
import importlib.metadata
import pathlib
import platform
import re
import shutil
import subprocess
import sys

import numpy as np

from common import DEVIATOR
from measures import State
from peer import SOLVERS, answer
from rigid_program import FORMS
from runs import SOLVED, launch
from scenes import FORCES_ONLY, WAYS, random_cells

LEAST_ENERGY = "least energy"
NO_FILES = "least energy, no files"
OURS = {**{way: {**parameters, **FORCES_ONLY}
           for way, parameters in WAYS.items()},
        NO_FILES: {**WAYS[LEAST_ENERGY], **FORCES_ONLY, "Output/Files": "none"}}
DENSE = "cvxopt, dense"
SIZES = (100, 300, 1000, 3000, 10000, 30000, 100000, 300000, 1000000)
SHORT = 30  # seconds up to which a run is repeated
PEER = pathlib.Path(__file__).with_name("peer.py")


def versions():
    """The names and versions of the other solvers and of the library for dense
    matrices, which CHOLMOD and cvxopt use."""
    clp = subprocess.run(["clp", "-exit"], capture_output=True, text=True,
                         check=True).stdout
    blas = pathlib.Path(f"/usr/lib/{platform.machine()}-linux-gnu/libblas.so.3")
    return [*(f"{name} {importlib.metadata.version(name)}"
              for name in ("cvxopt", "scipy")),
            "Clp " + re.search(r"version (\S+),", clp)[1],
            blas.resolve().parent.name]


@dataclasses.dataclass
class Attempt:
    """The runs of one solver on one packing: their processes, the seconds of
    the solver and of building its model in each, and of the first the
    iterations, residual and violation."""
    processes: list
    solving: list
    building: list
    iterations: float = ""
    residual: float = ""
    violation: float = ""
    outcome: str = "solved"

    def is_short(self):
        return self.outcome == "solved" and self.processes[0].elapsed <= SHORT

    def add(self, other):
        """Add the times of a repeat."""
        self.processes += other.processes
        self.solving += other.solving
        self.building += other.building

    def row(self):
        """The columns of an attempt; empty without an answer."""
        solved = self.outcome == "solved"
        return {
            "outcome": self.outcome, "repeats": len(self.processes),
            "seconds": np.median(self.solving) if solved else "",
            "building": np.median(self.building) if solved else "",
            "elapsed": np.median([run.elapsed for run in self.processes]),
            "memory": np.median([run.memory for run in self.processes]),
            "iterations": self.iterations, "residual": self.residual,
            "violation": self.violation}


def judged(attempt, state):
    """An Attempt with the certificate of its forces, a State."""
    attempt.residual, attempt.violation = state.residual(), state.violation()
    return attempt


def ours(bench, cells, parameters):
    """One run of the program: an Attempt, and the State if it was written."""
    run = bench.run({**random_cells(cells, DEVIATOR), **parameters})
    if run.status != SOLVED:
        return Attempt([run], [], [], outcome=run.outcome), None
    attempt = Attempt([run], [run.stages["statics"]], [run.stages["packing"]],
                      run.summary["solver"]["iterations"])
    if not (run.directory / "interfaces.csv").exists():
        return attempt, None
    state = State(run.directory)
    return judged(attempt, state), state


def hand_over(directory, state):
    """Leave what the others need to know of a packing in a new directory, in
    units of the largest load."""
    shutil.rmtree(directory, ignore_errors=True)
    directory.mkdir()
    unit = state.largest_load
    np.savez(directory / "joints.npz", minus=state.minus, plus=state.plus,
             normal=state.normal, capacity=state.strength * state.length / unit,
             load=state.load / unit)


def theirs(bench, state, solver, form):
    """One run of another solver on the packing of a State that has been handed
    over: an Attempt."""
    directory = bench.scratch / "peer"
    for leftover in directory.glob("answer.npz"):
        leftover.unlink()
    process = launch([sys.executable, PEER, solver, form, directory],
                     bench.time_limit)
    found = (answer(directory, form, process.text)
             if process.status == SOLVED else None)
    if found is None:
        known = process.outcome in ("time limit", "out of memory")
        return Attempt([process], [], [],
                       outcome=process.outcome if known else "no answer")
    p, q, seen = found
    unit = state.largest_load
    return judged(Attempt([process], [seen["solving"]], [seen["building"]],
                          seen["iterations"]),
                  state.with_forces(-p * unit, q * unit))


def in_turn(bench, cells, solvers):
    """The Attempts of functions that make one, by solver and form: all are
    tried once before any is repeated, which only those are that are solved and
    short."""
    attempts = {}
    for repeat in range(bench.repeats):
        for name, solve in solvers.items():
            if repeat == 0:
                attempts[name] = solve()
            elif attempts[name].is_short():
                attempts[name].add(solve())
            else:
                continue
            print(f"{repeat + 1}/{bench.repeats}, {cells} cells, "
                  f"{' by '.join(filter(None, name))}: "
                  f"{attempts[name].outcome}, "
                  f"{attempts[name].processes[-1].elapsed:.2f} s", flush=True)
    return attempts


def by_others(bench, state, forms):
    """Functions that try other solvers on a packing, by the solver and the
    form that it is given."""
    hand_over(bench.scratch / "peer", state)
    return {pair: functools.partial(theirs, bench, state, *pair)
            for pair in forms}


@functools.cache
def forms(bench):
    """Each of the other solvers with each form of the problem; dense matrices
    are left out."""
    cells = bench.sized(1000, 50)
    _, state = ours(bench, cells, OURS[LEAST_ENERGY])
    attempts = in_turn(bench, cells, by_others(bench, state, [
        (solver, form) for solver in SOLVERS if solver != DENSE
        for form in FORMS]))
    return [{"solver": solver, "form": form, "cells": cells, **attempt.row()}
            for (solver, form), attempt in attempts.items()]


def best_forms(rows):
    """The form in which each solver is fastest; of those that solve any."""
    best = {}
    for row in sorted((row for row in rows if row["outcome"] == "solved"),
                      key=lambda row: row["seconds"]):
        best.setdefault(row["solver"], row["form"])
    if "cvxopt" in best:
        best[DENSE] = best["cvxopt"]
    return {solver: best[solver] for solver in SOLVERS if solver in best}


def peers(bench):
    """All solvers by the number of cells, each until it fails."""
    alive = {**dict.fromkeys(OURS, ""), **best_forms(forms(bench))}
    rows = []
    for cells in bench.sizes(SIZES, (50, 100)):
        first, state = ours(bench, cells, OURS[LEAST_ENERGY])
        if state is None:
            print(f"{cells} cells: {first.outcome}", flush=True)
            break
        solvers = {
            **{(way, ""): lambda way=way: ours(bench, cells, OURS[way])[0]
               for way in OURS if way in alive},
            **by_others(bench, state, [(name, form) for name, form in
                                       alive.items() if name not in OURS])}
        attempts = in_turn(bench, cells, solvers)
        rows += compared([{"cells": cells, "solver": solver, "form": form,
                           **attempt.row()}
                          for (solver, form), attempt in attempts.items()])
        for (name, _), attempt in attempts.items():
            if attempt.outcome != "solved":
                del alive[name]
    return rows


def compared(rows):
    """The rows of one packing with their times over that of least energy and
    over the best of ours that gives forces."""
    solved = {row["solver"]: row for row in rows if row["outcome"] == "solved"}
    given = [solved[way] for way in WAYS if way in solved]
    for row in rows:
        for time in ("seconds", "elapsed"):
            row[f"{time}_over_least_energy"] = row[f"{time}_over_best"] = ""
            if row["outcome"] == "solved" and LEAST_ENERGY in solved:
                row[f"{time}_over_least_energy"] = (
                    row[time] / solved[LEAST_ENERGY][time])
                row[f"{time}_over_best"] = (
                    row[time] / min(other[time] for other in given))
    return rows
