"""The experiment on packings in which blocks slide: all solvers close to the
limit of the load."""
from common import DEVIATOR
from peers import (LEAST_ENERGY, NO_FILES, OURS, best_forms, by_others,
                   compared, forms, in_turn, ours)
from runs import SOLVED
from scenes import FORCES_ONLY, STRENGTH, random_cells

SIZES = (1000, 10000, 100000)
SHARES = (0.9, 0.99, 0.999)  # of the limit load
TRIED = (LEAST_ENERGY, "compliant", NO_FILES)  # of ours


def limit_strength(bench, cells):
    """The strength below which random cells do not carry the load: with
    Tresca's friction that of the scene over its load factor."""
    run = bench.run({**random_cells(cells, DEVIATOR), **FORCES_ONLY,
                     "Analysis": "load factor",
                     "Load factor/Factor": "all loads"})
    return (STRENGTH / run.summary["load_factor"]["carried"]
            if run.status == SOLVED else None)


def sliding(bench):
    """The solvers by the number of cells and the share of the limit load, at
    each share until it fails, or until it takes too long at any; also over the
    time of least energy where nothing slides, which is that of one linear
    system."""
    tried = {**dict.fromkeys(TRIED, ""), **best_forms(forms(bench))}
    failed, rows = set(), []
    for cells in bench.sizes(SIZES, (50, 100)):
        limit = limit_strength(bench, cells)
        if limit is None:
            print(f"{cells} cells: no load factor", flush=True)
            break
        for share in bench.sized(SHARES, SHARES[:1]):
            strength = {"Friction/Strength": limit / share}
            _, state = ours(bench, cells, {**OURS[LEAST_ENERGY], **strength})
            if state is None:
                print(f"{cells} cells at {share}: no state", flush=True)
                continue
            solvers = {
                ("linear", ""): lambda: ours(
                    bench, cells, OURS[LEAST_ENERGY])[0],
                **{(way, ""): lambda way=way: ours(
                    bench, cells, {**OURS[way], **strength})[0]
                   for way in TRIED},
                **by_others(bench, state, [
                    (name, form) for name, form in tried.items()
                    if name not in OURS and (name, share) not in failed])}
            attempts = in_turn(bench, f"{share} of the limit, {cells}",
                               solvers)
            linear = attempts.pop(("linear", "")).row()["seconds"]
            rows += [{**row, "seconds_over_linear": row["seconds"] / linear
                      if row["outcome"] == "solved" else ""}
                     for row in compared([
                         {"cells": cells, "share": share, "strength":
                          limit / share, "solver": solver, "form": form,
                          **attempt.row()}
                         for (solver, form), attempt in attempts.items()])]
            for (name, _), attempt in attempts.items():
                if attempt.outcome == "time limit":
                    failed |= {(name, any_share) for any_share in SHARES}
                elif attempt.outcome != "solved":
                    failed.add((name, share))
    return rows
