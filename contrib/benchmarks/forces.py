"""Experiments on the forces: functions from a Bench to the rows of a table."""
from common import (DEVIATOR, compared, far_and_close, forces,
                    limit_of_random_cells, picked, quality, times, tried_ways)
from scenes import (FORCES_ONLY, STRENGTH, WAYS, random_cells, shear_wall,
                    turned_squares)

DEFAULT_TOLERANCE, TIGHTEST_TOLERANCE = 1e-10, 1e-14


def formulations(bench):
    """The six ways under a uniform stress, by the number of cells."""
    rows = []
    for cells in bench.sized((100, 1000, 10000, 100000), (50,)):
        scene = random_cells(cells, DEVIATOR)
        outcomes = bench.series(
            "formulations",
            [({"cells": cells, "way": way}, {**scene, **parameters,
                                             **FORCES_ONLY})
             for way, parameters in WAYS.items()], forces)
        reference = picked(outcomes, way="least energy")
        stress = ((-1 - DEVIATOR, 0), (0, -1 + DEVIATOR))
        for outcome in outcomes:
            rows.append({
                **outcome.labels, **times(outcome, reference),
                **quality(outcome),
                "patch_error": (outcome.seen.patch_error(stress)
                                if outcome.seen else "")})
    return rows


def tolerance(bench):
    """Each way with each tolerance, with and without Equilibrate."""
    tolerances = bench.sized((1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12),
                             (1e-2, DEFAULT_TOLERANCE))
    settings = [
        ({"scene": name, "way": way, "tolerance": value,
          "equilibrate": equilibrate},
         {**scene, **parameters, **FORCES_ONLY, "Solver/Tolerance": value,
          "Solver/Equilibrate": equilibrate})
        for name, scene in far_and_close(bench).items()
        for way, parameters in tried_ways(bench).items()
        for value in tolerances for equilibrate in ("false", "true")]
    outcomes = bench.series("tolerance", settings, forces)
    rows = []
    for outcome in outcomes:
        same = {name: outcome.labels[name] for name in ("scene", "way")}
        plain = {**same, "equilibrate": "false"}
        rows.append({
            **outcome.labels,
            **times(outcome, picked(outcomes, tolerance=DEFAULT_TOLERANCE,
                                    **plain)),
            **quality(outcome),
            **compared(outcome, picked(outcomes, tolerance=tolerances[-1],
                                       **plain))})
    return rows


def barrier(bench):
    """The point where hard contact stops, with two tolerances, and the
    smoothing length. Times are over those of the default; the canonical state
    is that of the point 1e-10 with the tightest tolerance, and of the default
    smoothing length."""
    points = bench.sized((1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12), (1e-8, 1e-10))
    lengths = bench.sized((1e-6, 1., 1e6), (1., 1e6))
    default, tight = DEFAULT_TOLERANCE, TIGHTEST_TOLERANCE
    variants = [("hard", "Barrier parameter", value, tolerance,
                 (1e-8, default), (1e-10, tight))
                for tolerance in (default, tight) for value in points]
    variants += [(way, "Smoothing length", value, default,
                  (1., default), (1., default))
                 for way in ("hard", "compliant") for value in lengths]
    rows = []
    for name, scene in far_and_close(bench).items():
        outcomes = bench.series("barrier", [
            ({"scene": name, "way": way, "parameter": parameter, "value": value,
              "tolerance": tolerance},
             {**scene, **WAYS[way], **FORCES_ONLY,
              "Solver/Tolerance": tolerance,
              f"Solver/smoothed friction/{parameter}": value})
            for way, parameter, value, tolerance, _, _ in variants], forces)
        for outcome, (way, parameter, _, _, usual, exact) in zip(outcomes,
                                                                 variants):
            timed, canonical = (
                picked(outcomes, way=way, parameter=parameter, value=value,
                       tolerance=tolerance)
                for value, tolerance in (usual, exact))
            rows.append({**outcome.labels, **times(outcome, timed),
                         **quality(outcome), **compared(outcome, canonical)})
    return rows


def rigidity(bench):
    """Each way at loads that approach the limit."""
    rows = []
    for structure, scene_at in rigid_structures(bench).items():
        settings = [
            ({"structure": structure, "distance_to_collapse": distance,
              "way": way},
             {**scene_at(1 - distance), **parameters, **FORCES_ONLY})
            for distance in bench.sized((1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6),
                                        (1e-1, 1e-3))
            for way, parameters in tried_ways(bench).items()]
        outcomes = bench.series("rigidity", settings, forces)
        for outcome in outcomes:
            reference = picked(
                outcomes, **{**outcome.labels, "way": "least energy"})
            rows.append({**outcome.labels, **times(outcome, reference),
                         **quality(outcome)})
    return rows


def rigid_structures(bench):
    """Scenes as functions of the load over its limit, by name."""
    courses, bricks = bench.sized((20, 10), (6, 3))
    side = bench.sized(46, 12)
    cells = bench.sized(1000, 50)
    limit = limit_of_random_cells(bench, cells)
    return {
        f"shear wall, {courses} x {bricks} bricks":
            lambda load: shear_wall(load, courses, bricks),
        f"{side * side // 2} turned squares":
            lambda load: turned_squares(load * STRENGTH, side, bench.scratch),
        f"{cells} random cells":
            lambda load: random_cells(cells, load * limit)}
