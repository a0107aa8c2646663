"""What the experiments share. Their rows are dictionaries of the same keys, of
which `time_ratio` and `time_spread` are the median and half the interquartile
range, over the repeats, of the ratio of a time to that of a reference setting
in the same repeat; `seconds` is the median time.
"""
import functools

import numpy as np

from measures import State
from runs import SOLVED
from scenes import FORCES_ONLY, STRENGTH, WAYS, random_cells

DEVIATOR = 0.2  # of the scenes far from collapse
USUAL_TOLERANCE = 1e-8  # of load factors, by default
CLOSE = 0.99  # of the limit, in the scenes close to collapse


def statics(run):
    """The seconds of the solver, or of the whole run if it has no summary."""
    return run.stages.get("statics", run.elapsed)


def times(outcome, reference, seconds=statics):
    """The columns of time of an Outcome with respect to another one; empty if
    a run has no such time, which is then NaN."""
    own = np.array([seconds(run) for run in outcome.runs])
    ratio = own / np.array([seconds(run) for run in reference.runs])
    if np.isnan(ratio).any():
        return dict.fromkeys(("time_ratio", "time_spread", "seconds"), "")
    low, high = np.percentile(ratio, [25, 75])
    return {"time_ratio": np.median(ratio), "time_spread": (high - low) / 2,
            "seconds": np.median(own)}


def quality(outcome):
    """The columns of how it ended and of the balance of the forces, empty
    without an answer."""
    state = outcome.seen
    return {**ending(outcome),
            "residual": state.residual() if state else "",
            "violation": state.violation() if state else ""}


def ending(outcome):
    """The columns of how the runs and their solver ended."""
    solver = outcome.runs[0].summary.get("solver", {})
    return {"outcome": outcome.outcome,
            "iterations": solver.get("iterations", ""),
            "solver": solver.get("outcome", "")}


def compared(outcome, reference):
    """The columns of the distance to the State of a reference."""
    both = outcome.seen and reference.seen
    return {
        "distance":
            outcome.seen.distance(reference.seen) if both else "",
        "mean_stress_change":
            outcome.seen.change_of_mean_stress(reference.seen) if both else ""}


def forces(run):
    return State(run.directory)


def picked(outcomes, **labels):
    """The outcome with the given labels."""
    return next(outcome for outcome in outcomes
                if all(outcome.labels[name] == value
                       for name, value in labels.items()))


@functools.cache
def limit_of_random_cells(bench, cells):
    """The largest deviator that random cells carry, by a load factor; None if
    it is not found."""
    run = bench.run({**random_cells(cells, 0), **FORCES_ONLY,
                     "Analysis": "load factor",
                     "Live loads/Boundary load": "uniform stress",
                     "Live loads/Stress": "-1, 0; 0, 1"})
    if run.status != SOLVED:
        print(f"{cells} random cells: {run.outcome}", flush=True)
        return None
    limit = run.summary["load_factor"]["carried"]
    print(f"{cells} random cells carry a deviator of {limit:.9g}", flush=True)
    return limit


def close_to_collapse(bench, cells):
    """Random cells under 0.99 of the deviator that they carry."""
    return random_cells(cells, CLOSE * limit_of_random_cells(bench, cells))


def far_and_close(bench):
    """Random cells far from and close to collapse, by name."""
    cells = bench.sized(1000, 50)
    return {"far": random_cells(cells, DEVIATOR),
            "close": close_to_collapse(bench, cells)}


def tried_ways(bench):
    """All ways, or two in a quick study."""
    return {name: WAYS[name] for name in
            bench.sized(WAYS.keys(), ("compliant", "least energy"))}
