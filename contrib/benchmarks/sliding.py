"""The experiment on packings in which blocks slide: all solvers close to the
limit of the load."""
from common import limit_of_random_cells
from peers import (LEAST_ENERGY, NO_FILES, OURS, best_forms, by_others,
                   compared, forms, in_turn, ours)
from scenes import stress

SIZES = (1000, 10000, 100000)
SHARES = (0.9, 0.99, 0.999)  # of the largest deviator
TRIED = (LEAST_ENERGY, "compliant", NO_FILES)  # of ours


def sliding(bench):
    """The solvers by the number of cells and the share of the limit, at each
    share until it fails, or until it takes too long at any; also over the
    time of least energy where nothing slides, which is that of one linear
    system."""
    tried = {**dict.fromkeys(TRIED, ""), **best_forms(forms(bench))}
    failed, rows = set(), []
    for cells in bench.sizes(SIZES, (50, 100)):
        limit = limit_of_random_cells(bench, cells)
        if limit is None:
            break
        for share in bench.sized(SHARES, SHARES[:1]):
            close = {"Loads/Stress": stress(share * limit)}
            _, state = ours(bench, cells, {**OURS[LEAST_ENERGY], **close})
            if state is None:
                print(f"{cells} cells at {share}: no state", flush=True)
                continue
            solvers = {
                ("linear", ""): lambda: ours(
                    bench, cells, OURS[LEAST_ENERGY])[0],
                **{(way, ""): lambda way=way: ours(
                    bench, cells, {**OURS[way], **close})[0]
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
                         {"cells": cells, "share": share, "deviator":
                          share * limit, "solver": solver, "form": form,
                          **attempt.row()}
                         for (solver, form), attempt in attempts.items()])]
            for (name, _), attempt in attempts.items():
                if attempt.outcome == "time limit":
                    failed |= {(name, any_share) for any_share in SHARES}
                elif attempt.outcome != "solved":
                    failed.add((name, share))
    return rows
