"""The experiment on the kernels: the bytes that they move against the bandwidth
of the memory.

Those of the libraries are timed and counted by kernel_probe.c inside the
program. The others are stages, with the bytes of a model:

- forces of the joints: for each joint its record of 64 bytes, its jump and
  force of 16 (the force also allocated), and of its two cells the forces read
  and written; the loads and forces of each cell once more.
- stress: for each joint the record and force, for each sub-cell 56 bytes of
  results, allocated and written.
- output: the bytes of the files, written to the buffer of the system from one
  of the program, and the results that are read.
"""
import csv
import os
import pathlib
import subprocess

import numpy as np

from bandwidth import machine
from common import DEVIATOR
from runs import SOLVED
from scenes import FORCES_ONLY, WAYS, random_cells

SOURCE = pathlib.Path(__file__).with_name("kernel_probe.c")
SIZES = (100000, 1000000)
JOINT, PAIR = 64, 16  # bytes of the record of a joint, and of a pair of numbers
SUB_CELL = 56  # bytes of the results of a sub-cell
MULTIGRID = {"Solver/least energy/Linear solver": "multigrid"}


def build_probe(bench):
    """Compile the library that times the kernels."""
    library = bench.scratch / "kernel_probe.so"
    subprocess.run(
        ["gcc", "-O2", "-shared", "-fPIC", "-I/usr/include/suitesparse", "-o",
         library, SOURCE, "-ldl"], check=True)
    return library


def probed(bench, library, parameters):
    """One run with the probe: the Run and its kernels by name."""
    report = bench.scratch / "kernels.txt"
    os.environ |= {"LD_PRELOAD": str(library), "KERNEL_PROBE": str(report)}
    try:
        run = bench.run(parameters)
    finally:
        del os.environ["LD_PRELOAD"], os.environ["KERNEL_PROBE"]
    names = ("kernel", "calls", "seconds", "bytes", "operations")
    with open(report, encoding="ascii") as file:
        rows = [dict(zip(names, line)) for line in csv.reader(file)]
    return run, {row.pop("kernel"): {name: float(value)
                                     for name, value in row.items()}
                 for row in rows}


def kernels(bench):
    """The kernels of least energy by the direct solver and by multigrid, and of
    the stages after it; before them the machine, without cells."""
    library = build_probe(bench)
    rows = [{"cells": "", "kernel": row["what"], "solver": "", "repeats": "",
             "calls": "", "seconds": "", "bytes": "", "operations": "",
             "bandwidth": row["value"], "fraction": ""} for row in machine()]
    limit = rows[0]["bandwidth"]
    for cells in bench.sizes(SIZES, (1000,)):
        scene = {**random_cells(cells, DEVIATOR), **WAYS["least energy"]}
        settings = {"direct": {**scene, "Output/Verbosity": 0},
                    "multigrid": {**scene, **MULTIGRID, **FORCES_ONLY,
                                  "Output/Files": "none"}}
        found = {}
        for repeat in range(bench.repeats):
            for solver, parameters in settings.items():
                run, counted = probed(bench, library, parameters)
                print(f"kernels: {repeat + 1}/{bench.repeats}, {cells} cells, "
                      f"{solver}: {run.outcome}, {run.elapsed:.2f} s",
                      flush=True)
                if run.status == SOLVED:
                    counted |= modelled(run, solver)
                    for name, kernel in counted.items():
                        found.setdefault((name, solver), []).append(kernel)
        rows += [row(cells, name, solver, samples, limit)
                 for (name, solver), samples in found.items()
                 if samples[0]["calls"]]
    return rows


def row(cells, name, solver, samples, limit):
    """The medians of the seconds of a kernel, and its part of the bandwidth."""
    first = samples[0]
    seconds = np.median([sample["seconds"] for sample in samples])
    bandwidth = first["bytes"] / seconds if first["bytes"] else ""
    return {"cells": cells, "kernel": name, "solver": solver,
            "repeats": len(samples), "calls": first["calls"],
            "seconds": seconds, "bytes": first["bytes"] or "",
            "operations": first["operations"] or "", "bandwidth": bandwidth,
            "fraction": bandwidth / limit if bandwidth else ""}


def modelled(run, solver):
    """The kernels that are stages or have a timing of their own in the
    summary."""
    joints = run.summary["packing"]["interfaces"]
    cells = run.summary["packing"]["cells"]
    evaluations = run.summary["solver"]["evaluations"]
    sub_cells = run.summary["stress"]["sub_cells"]
    files = sum(path.stat().st_size for path in run.directory.iterdir())
    found = {
        "statics, all": (1, "statics", 0),
        "forces of the joints": (
            evaluations, "forces of the joints",
            evaluations * (joints * (JOINT + 3 * PAIR + 4 * PAIR) +
                           cells * 3 * PAIR))}
    if solver == "direct":
        found |= {
            "packing": (1, "packing", 0),
            "stress": (1, "stress", joints * (JOINT + PAIR) +
                       2 * SUB_CELL * sub_cells),
            "output": (1, "output", 3 * files + joints * (JOINT + PAIR) +
                       SUB_CELL * sub_cells)}
    return {name: {"calls": calls, "seconds": run.stages[stage],
                   "bytes": moved, "operations": 0}
            for name, (calls, stage, moved) in found.items()
            if stage in run.stages}
