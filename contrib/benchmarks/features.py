"""The experiment on the cost of features."""
import numpy as np

from common import DEVIATOR, ending, times
from scenes import WAYS, random_cells
from stress import fine

STRONG = 2  # a strength with which no joint slides, whatever is added


def total(run):
    """The seconds of all stages; NaN if there is no summary."""
    return sum(run.stages.values()) if run.stages else np.nan


def features(bench):
    """What each feature adds to the forces alone; those with many
    sub-cells a cell in a smaller packing."""
    stress = {name: {**parameters, "Output/Files": "vtu"}
              for name, parameters in
              (("standard", {"Accuracy": "standard"}), fine(0, 0), fine(0, 1),
               fine(1, 0))}
    supported = {"Supports/Where": "ny < -0.5 && y < 1e-9"}
    weight = {"Loads/Body force": "0; -0.1"}
    turning = {"Rotations": "true"}
    light = {
        ".csv files": {"Output/Files": "csv"},
        ".vtu of the interfaces": {"Output/Files": "vtu"},
        **{f"stress, {name}": stress[name] for name in list(stress)[:1]},
        "supports": supported,
        "supports and body force": {**supported, **weight},
        "rotations": turning,
        "rotations, supports": {**supported, **turning},
        "rotations, supports and body force":
            {**supported, **weight, **turning},
        "strength by expression":
            {"Friction/Strength": f"{STRONG} + 0.1*x*abs(ny)"},
        "Equilibrate": {"Solver/Equilibrate": "true"},
        "export of the packing": {"Output/Packing": "WKT"},
    }
    heavy = {f"stress, {name}": stress[name] for name in stress}
    return (features_of(bench, bench.sized(20000, 50), light) +
            features_of(bench, bench.sized(1000, 60), heavy))


def features_of(bench, cells, added):
    """The rows of some features in a number of random cells."""
    base = {**random_cells(cells, DEVIATOR), "Friction/Strength": STRONG,
            **WAYS["least energy"], "Accuracy": "draft", "Output/Files": "none"}
    outcomes = bench.series(
        "features", [({"cells": cells, "feature": name}, {**base, **parameters})
                     for name, parameters in
                     {"forces only": {}, **added}.items()])
    reference = outcomes[0]
    memory = median(reference, lambda run: run.memory)
    return [{**outcome.labels, **times(outcome, reference, total),
             **ending(outcome),
             "stage": slower_stage(outcome, reference),
             "memory_ratio": median(outcome, lambda run: run.memory) / memory,
             "memory": median(outcome, lambda run: run.memory)}
            for outcome in outcomes]


def median(outcome, value):
    return np.median([value(run) for run in outcome.runs])


def slower_stage(outcome, reference):
    """The stage that grows most in the median, if the total grows by more than
    2 per cent."""
    grown = {stage: median(outcome, lambda run: run.stages.get(stage, 0.)) -
             median(reference, lambda run: run.stages.get(stage, 0.))
             for stage in ("packing", "statics", "stress", "output")}
    if sum(grown.values()) < 0.02 * median(reference, total):
        return "none"
    return max(grown, key=grown.get)
