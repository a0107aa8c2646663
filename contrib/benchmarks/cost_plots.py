"""The plots of the cost, from the rows of the tables."""
from growth import STAGES
from plots import COLOURS, axes, save
from projection import solved
from scenes import WAYS
from tables import distinct, where

OTHERS = {"cvxopt": "o", "cvxopt, dense": "v", "HiGHS interior point": "s",
          "HiGHS interior point, no crossover": "D", "HiGHS dual simplex": "^",
          "Clp dual simplex": "<", "Clp barrier": ">"}


def peers(rows, path):
    """Time by the number of cells, of the solver and of the whole process;
    other solvers dashed."""
    figure, panels = axes(2, ("cells", "seconds"),
                          ["Solver", "Whole process"])
    for panel, time in zip(panels, ("seconds", "elapsed")):
        for solver in distinct(rows, "solver"):
            own = where(rows, solver=solver, outcome="solved")
            points = ([row["cells"] for row in own],
                      [row[time] for row in own])
            if solver in WAYS:
                panel.plot(*points, "o-", markersize=4,
                           color=COLOURS[solver], label=solver)
            elif solver in OTHERS:
                panel.plot(*points, OTHERS[solver] + "--", markersize=4,
                           color="#444444", linewidth=1,
                           markerfacecolor="white", label=solver)
    save(figure, panels[0], path)


def growth(rows, path):
    """The time of each stage and the memory by the number of cells, on one
    process; dashed on two."""
    figure, panels = axes(2, ("cells", "seconds; MiB"), ["Time", "Memory"])
    for ranks, line in ((1, "o-"), (2, "o--")):
        own = solved(rows, ranks)
        cells = [row["cells"] for row in own]
        for k, stage in enumerate(STAGES):
            panels[0].plot(cells, [row[stage] for row in own], line,
                           markersize=4, color=f"C{k}",
                           label=stage if ranks == 1 else None)
        panels[1].plot(cells, [row["memory"] for row in own], line,
                       markersize=4, color="black",
                       label="memory" if ranks == 1 else None)
    save(figure, panels[0], path)


PLOTS = {"peers": peers, "growth": growth, "sliding_growth": growth}
