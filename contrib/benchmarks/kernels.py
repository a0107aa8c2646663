"""The experiment on the kernels: the bytes that they move against the bandwidth
of the memory.

Those of the libraries are timed and counted by kernel_probe.c inside the
program. The others are stages, with the bytes of a model:

- rest of statics, all but the kernels of the direct solver: the records of the
  joints, 64 bytes, are allocated and written; in each evaluation of the forces
  a joint has its record and jump read and its force of 16 bytes allocated and
  written, and each of its cells the forces read and written; a cell has its
  load read and its forces allocated and written.
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
                    counted |= modelled(run, counted)
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


def modelled(run, counted):
    """The stages as kernels, given those counted inside the program, those of
    the stress and the files if there are such files."""
    joints = run.summary["packing"]["interfaces"]
    cells = run.summary["packing"]["cells"]
    sub_cells = run.summary["stress"]["sub_cells"]
    files = sum(path.stat().st_size for path in run.directory.iterdir())

    def whole(stage, moved):
        return {"calls": 1, "seconds": run.stages[stage], "bytes": moved,
                "operations": 0}

    found = {"statics, all": whole("statics", 0)}
    if not sub_cells:
        return found
    evaluation = (joints * (JOINT + PAIR + 2 * PAIR + 2 * 2 * PAIR) +
                  cells * 3 * PAIR)
    rest = whole("statics", 2 * JOINT * joints +
                 run.summary["solver"]["evaluations"] * evaluation)
    rest["seconds"] -= sum(counted[name]["seconds"] for name in
                           ("analysis", "factorisation", "solution"))
    return {"rest of statics": rest, **found, "packing": whole("packing", 0),
            "stress": whole("stress", joints * (JOINT + PAIR) +
                            2 * SUB_CELL * sub_cells),
            "output": whole("output", 3 * files + joints * (JOINT + PAIR) +
                            SUB_CELL * sub_cells)}
