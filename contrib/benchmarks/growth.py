"""The experiment on how time and memory grow with the number of cells."""
import numpy as np

from common import DEVIATOR
from runs import SOLVED
from scenes import STRENGTH, WAYS, random_cells

STAGES = ("packing", "statics", "stress", "output")
SIZES = (10000, 30000, 100000, 300000, 1000000)
RANKS = (1, 2)
SLIDING = 0.17  # s_T


def growth(bench):
    """The stages of least energy with the standard stress and all files, by the
    number of cells, on one process and on two."""
    return by_size(bench, STRENGTH)


def sliding_growth(bench):
    """The same where many joints slide."""
    return by_size(bench, SLIDING)


def by_size(bench, strength):
    rows = []
    for cells in bench.sizes(SIZES, (300, 1000)):
        scene = {**random_cells(cells, DEVIATOR), **WAYS["least energy"],
                 "Friction/Strength": strength, "Output/Verbosity": 0}
        runs = {ranks: [] for ranks in RANKS}
        for repeat in range(bench.repeats):
            for ranks, done in runs.items():
                done.append(bench.run(scene, ranks))
                print(f"growth, s_T = {strength}: {repeat + 1}/{bench.repeats}, {cells} cells, "
                      f"{ranks} processes: {done[-1].outcome}, "
                      f"{done[-1].elapsed:.2f} s", flush=True)
        rows += [row(cells, ranks, done) for ranks, done in runs.items()]
    return rows


def row(cells, ranks, runs):
    """The medians of some runs; the spread is half the interquartile range of
    the seconds of the whole process, over their median."""
    solved = all(run.status == SOLVED for run in runs)
    elapsed = [run.elapsed for run in runs]
    low, high = np.percentile(elapsed, [25, 75])
    size = runs[0].summary.get("packing", {})
    return {
        "cells": cells, "ranks": ranks,
        "outcome": "solved" if solved else runs[0].outcome,
        "repeats": len(runs),
        **{stage: np.median([run.stages[stage] for run in runs])
           if solved else "" for stage in STAGES},
        "elapsed": np.median(elapsed),
        "elapsed_spread": (high - low) / 2 / np.median(elapsed),
        "memory": np.median([run.memory for run in runs]),
        "interfaces": size.get("interfaces", ""),
        "iterations": runs[0].summary.get("solver", {}).get("iterations", "")}
