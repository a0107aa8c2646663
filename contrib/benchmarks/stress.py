"""The experiment on the stress inside the cells."""
import math

from common import close_to_collapse, picked, times
from measures import MeanStress, StressField
from scenes import (TRACTIONS, UNIFORM_STRESS, WAYS, regular_polygon,
                    wall_under_weight)

ERRORS = ("distance", "distance_of_means", "imbalance", "imbalance_not_rigid",
          "asymmetry", "patch_error")


def fine(refinements, degree):
    """Name and parameters of a fine reconstruction."""
    return (f"fine, {refinements} refinements, degree {degree}",
            {"Accuracy": "fine", "Stress/Refinements": refinements,
             "Stress/Raviart-Thomas degree": degree})


def reconstructions(bench):
    """The parameters of the ways to find the stress inside the cells, and in
    how many random cells each is timed, by name: fewer where a cell takes
    seconds."""
    draft = {"Accuracy": "draft"}, bench.sized(10000, 50)
    standard = {"Accuracy": "standard"}, bench.sized(10000, 50)
    ways = {"draft": draft, "standard": standard}
    cells = ((10000, 1000), (1000, 200), (200, 20))
    for refinements in bench.sized((0, 1, 2), (0,)):
        for degree in (0, 1):
            name, parameters = fine(refinements, degree)
            ways[name] = parameters, bench.sized(cells[refinements][degree], 50)
    return ways


def reconstruction(bench):
    """The time of the stress inside random cells close to collapse, and its
    error there, in a wall and in single blocks."""
    rows = reconstruction_times(bench)
    for labels, scene, finest in reconstructed(bench):
        rows += reconstruction_errors(bench, labels, scene, finest)
    return rows


def reconstruction_times(bench):
    """The time of the stress stage per cell."""
    ways = reconstructions(bench)
    scenes = {cells: close_to_collapse(bench, cells)
              for cells in {cells for _, cells in ways.values()}}
    outcomes = bench.series(
        "reconstruction",
        [({"setting": name, "cells": cells},
          {**scenes[cells], **WAYS["least energy"], **parameters})
         for name, (parameters, cells) in ways.items()])

    def seconds_of_cell(run):
        packing = run.summary.get("packing", {"cells": math.nan})
        return run.stages.get("stress", 0.) / packing["cells"]

    reference = picked(outcomes, setting="standard")
    return [{"structure": "timed random cells", "sides": "",
             "load": "close to collapse", **outcome.labels,
             **times(outcome, reference, seconds_of_cell),
             **dict.fromkeys(ERRORS, "")} for outcome in outcomes]


def reconstructed(bench):
    """Labels, parameters, and the refinements of the reference, of structures
    in which the stress is compared."""
    finest = bench.sized(3, 1)
    polygons = [({"structure": "polygon", "sides": sides, "load": load},
                 regular_polygon(sides, traction, bench.scratch),
                 finest)
                for sides in bench.sized((3, 4, 5, 6, 8, 12), (5,))
                for load, traction in TRACTIONS.items()]
    wall = wall_under_weight(*bench.sized((6, 3), (4, 2)))
    random = close_to_collapse(bench, bench.sized(30, 20))
    return polygons + [
        ({"structure": "wall", "sides": "", "load": "weight"}, wall, finest),
        ({"structure": "random cells", "sides": "",
          "load": "close to collapse"}, random, finest)]


def reconstruction_errors(bench, labels, scene, finest):
    """The rows of one structure; the reference is `finest` times refined and
    of degree 1."""
    ways = {name: parameters
            for name, (parameters, _) in reconstructions(bench).items()}
    name, parameters = fine(finest, 1)
    body_force = (0, -1) if labels["load"] == "weight" else (0, 0)
    outcomes = bench.series(
        "reconstruction",
        [({**labels, "setting": setting},
          {**scene, **WAYS["least energy"], **parameters})
         for setting, parameters in {**ways, name: parameters}.items()],
        field, repeats=1)
    rows = []
    for outcome in outcomes[:len(ways)]:
        rows.append({**outcome.labels, "cells": "", "time_ratio": "",
                     "time_spread": "", "seconds": "",
                     **errors(outcome.seen, outcomes[-1].seen, body_force)})
        if labels["load"] == "uniform stress" and outcome.seen:
            rows[-1]["patch_error"] = outcome.seen.patch_error(UNIFORM_STRESS)
    return rows


def field(run):
    """The stress inside the cells, or the mean stress if there is no other."""
    written = (run.directory / "stress.vtu").exists()
    return (StressField if written else MeanStress)(run.directory)


def errors(found, reference, body_force):
    """The columns ERRORS of a Field; the mean stress has no divergence."""
    row = dict.fromkeys(ERRORS, "")
    if found and reference:
        row["distance"], row["distance_of_means"] = found.distances(reference)
    if isinstance(found, StressField):
        row["imbalance"], row["imbalance_not_rigid"] = found.imbalance(
            body_force)
        row["asymmetry"] = found.asymmetry()
    return row
