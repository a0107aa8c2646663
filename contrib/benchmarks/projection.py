"""How time and memory grow, and what follows for a much larger packing: all
computed from the tables of growth and kernels."""
import numpy as np

from growth import STAGES
from tables import where

TARGET = 1e8  # cells
DISTRIBUTED = 0.75  # time on two processes over that on one, at most


def solved(rows, ranks=1):
    return where(rows, ranks=ranks, outcome="solved")


def exponent(rows, key):
    """The power of the number of cells with which a column grows over all rows,
    by least squares of logarithms; empty for one row."""
    if len(rows) < 2:
        return ""
    cells, values = (np.log([row[name] for row in rows])
                     for name in ("cells", key))
    return np.polyfit(cells, values, 1)[0]


def steps(rows, key):
    """The powers between successive rows."""
    return [exponent(list(pair), key) for pair in zip(rows[:-1], rows[1:])]


def speedup(rows, key):
    """The time on one process over that on two at the largest size that both
    have solved; empty if there is none."""
    sizes = [row["cells"] for row in solved(rows, 2)]
    both = [row for row in solved(rows) if row["cells"] in sizes]
    if not both:
        return ""
    largest = both[-1]
    other = where(solved(rows, 2), cells=largest["cells"])[0]
    return largest[key] / other[key]


def is_distributed(rows, key):
    """Whether two processes do it in at most DISTRIBUTED of the time of one."""
    gain = speedup(rows, key)
    return gain != "" and 1 / gain <= DISTRIBUTED


def cycles(kernels):
    """The rows of the cycles of multigrid, which is one for each iteration."""
    return where(kernels, kernel="cycle", solver="multigrid")


def projected(growth, kernels):
    """For each stage the seconds at TARGET cells: alone, on one process; now,
    on a cluster where what is not distributed stays on one; and shared, with
    all distributed, where only the cycles of multigrid grow in number. The statics
    is that of multigrid, if that was measured, since the factorisation is not
    distributed."""
    rows = solved(growth)
    largest = rows[-1]
    ranks = TARGET / largest["cells"]
    lines = []
    for stage in STAGES:
        power = max(exponent(rows, stage), 1)
        here, name, more = largest[stage], stage, 1.
        multigrid = where(kernels, kernel="statics, all", solver="multigrid")
        if stage == "statics" and multigrid:
            here = multigrid[-1]["seconds"] * (largest["cells"] /
                                               multigrid[-1]["cells"])
            power = 1 + max(exponent(cycles(kernels), "calls") or 0, 0)
            name, more = "statics, by multigrid", ranks**(power - 1)
        alone = here * ranks**power
        shared = here * more
        gain = speedup(growth, stage)
        spread = is_distributed(growth, stage)
        lines.append({"stage": name, "exponent": power, "seconds": here,
                      "speedup": gain, "distributed": spread, "alone": alone,
                      "now": shared * 2 / gain if spread else alone,
                      "shared": shared})
    return lines
