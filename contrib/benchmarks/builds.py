#!/usr/bin/python3
"""Compare two builds of voussoir in one run: time, memory and forces.

Prints a table of the later build over the earlier one, as Markdown. Ends with
status 1 if a ratio of the statics or of the memory is above the allowed one,
or a force differs by more than 1e-10 of the largest. Nothing else should run
beside it.
"""
import argparse
import pathlib
import sys

import numpy as np

from command import TOP
from common import DEVIATOR
from measures import State
from runs import SOLVED, Bench
from scenes import FORCES_ONLY, WAYS, random_cells
from tables import markdown, number

SIZES = (1000, 10000, 100000)
STRENGTHS = (0.3, 0.19, 0.17)  # nothing slides, some, most
TRIED = ("least energy", "compliant", "centre (edge area)")
SAME = 1e-10  # of the largest force
NOTABLE = 0.05  # seconds below which a ratio of times is noise


def compared(before, after, parameters, repeats):
    """The ratios of statics and memory, the seconds of the later build, and the
    largest difference of a force over the largest force; nothing if one of the
    builds has no answer."""
    seconds, memory, difference = [], [], 0.
    for _ in range(repeats):
        runs, found = [], []
        for bench in (before, after):
            runs.append(bench.run(parameters))
            if runs[-1].status != SOLVED:
                return None, [run.outcome for run in runs]
            found.append(State(runs[-1].directory).force)
        seconds.append([run.stages["statics"] for run in runs])
        memory.append([run.memory for run in runs])
        difference = max(difference, np.abs(found[1] - found[0]).max() /
                         np.abs(found[0]).max())
    seconds, memory = np.array(seconds), np.array(memory)
    return {"seconds": np.median(seconds[:, 1]),
            "time": np.median(seconds[:, 1] / seconds[:, 0]),
            "memory": np.median(memory[:, 1] / memory[:, 0]),
            "difference": difference}, None


def main():
    parser = argparse.ArgumentParser(
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before", type=pathlib.Path, metavar="PROGRAM",
                        help="the earlier build")
    parser.add_argument("--program", type=pathlib.Path, metavar="PROGRAM",
                        default=TOP / "build/release/voussoir",
                        help="the later build; default: build/release/voussoir")
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--largest", type=int, default=max(SIZES),
                        metavar="CELLS", help="no larger packings")
    parser.add_argument("--allowed", type=float, default=1.25, metavar="RATIO",
                        help="of time or memory, 1.25")
    options = parser.parse_args()
    rows, failures = [], 0
    with Bench(options.before.resolve(), 1, False) as before, \
            Bench(options.program.resolve(), 1, False) as after:
        for cells in [size for size in SIZES if size <= options.largest]:
            for strength in STRENGTHS:
                for way in TRIED:
                    found, outcomes = compared(
                        before, after,
                        {**random_cells(cells, DEVIATOR), **WAYS[way],
                         **FORCES_ONLY, "Friction/Strength": strength},
                        options.repeats)
                    labels = [number(cells), number(strength), way]
                    print(*labels, outcomes or number(found["time"]),
                          file=sys.stderr, flush=True)
                    if found is None:
                        rows.append([*labels, *["-"] * 3, " / ".join(outcomes)])
                        failures += 1
                        continue
                    slower = (found["seconds"] > NOTABLE and
                              found["time"] > options.allowed)
                    failures += (slower or found["memory"] > options.allowed or
                                 not found["difference"] <= SAME)
                    rows.append([*labels, *(number(found[key]) for key in (
                        "seconds", "time", "memory", "difference"))])
    print(markdown(["cells", "s_T", "way", "statics, s", "/ before",
                    "memory / before", "difference of forces"], rows, 3))
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
