"""The page of the cost: what the tables of the measurements say, and how they
were measured."""
import tables
from command import measured_table
from cost_plots import PLOTS
from growth import SLIDING, STAGES
from peers import SHORT
from peers_page import forms, peers, sliding
from projection import (DISTRIBUTED, TARGET, cycles, exponent, projected,
                        solved, speedup, steps)
from runs import MEMORY_LIMIT
from tables import listed, markdown, number, where

def growth(rows):
    return ["The same packings with the standard stress and all files, least "
            "energy, on one process. No joint slides.", *by_size(rows)]


def sliding_growth(rows):
    return [f"The same with s_T = {SLIDING}: many joints slide.",
            *by_size(rows)]


def by_size(rows):
    alone = solved(rows)
    measures = {**{stage: f"{stage}, s" for stage in STAGES},
                "elapsed": "process, s", "memory": "MiB"}
    table = [[number(row["cells"]), *(number(row[key]) for key in measures)]
             for row in alone]
    powers = [[f"from {number(one['cells'])} to {number(two['cells'])}",
               *(number(steps(alone, key)[k]) for key in measures)]
              for k, (one, two) in enumerate(zip(alone[:-1], alone[1:]))]
    powers.append(["whole range", *(number(exponent(alone, key))
                                    for key in measures)])
    both = [[number(row["cells"]), *(
        number(where(alone, cells=row["cells"])[0][key] / row[key])
        for key in measures)] for row in solved(rows, 2)
            if where(alone, cells=row["cells"])]
    gains = {stage: speedup(rows, stage) for stage in STAGES}
    best = max((stage for stage in gains if gains[stage] != ""),
               key=gains.get, default=None)
    return [
        markdown(["cells", *measures.values()], table),
        "The power of the number of cells with which they grow:",
        markdown(["", *measures], powers),
        "On two processes on the same machine: what one process takes over "
        "what two take, above 1 where two are faster; memory is that of the "
        "largest process. "
        + (f"At the largest size the ratio is largest for {best}, "
           f"{number(gains[best])}." if best else ""),
        markdown(["cells", *measures], both)]


def kernels(rows):
    machine = {row["kernel"]: row["bandwidth"]
               for row in rows if row["cells"] == ""}
    own = [row for row in rows if row["cells"] != ""]
    streams = [f"{number(value / 1e9)} GB/s ({what.split(', ')[1]})"
               for what, value in machine.items() if "bandwidth" in what]
    product = machine["product of matrices"]

    def rate(key, unit):
        return lambda row: (number(row[key] / row["seconds"] / unit)
                            if row[key] != "" else "-")

    def percent(row):
        return (f"{number(100 * row['fraction'])} %"
                if row["fraction"] != "" else "-")

    def intensity(row):
        both = row["bytes"] != "" and row["operations"] != ""
        return number(row["operations"] / row["bytes"]) if both else "-"

    return [
        "The bandwidth of the memory, by the triad a = b + s c on arrays far "
        f"larger than the cache: {' and '.join(streams)}; a product of dense "
        f"matrices runs at {number(product / 1e9)} Gflop/s. A kernel is "
        "limited by the memory if it moves its bytes at a large part of the "
        "bandwidth of one thread, and by arithmetic if not and its Gflop/s "
        "come close to those of the product; what is far from both spends its "
        "time on decisions, small blocks or the conversion of numbers. More "
        "than 100 % means that the operands are in the cache. Bytes are those "
        "that must at least be moved: for the kernels of libraries, which are "
        "counted inside the program, by the sizes of their operands, and for "
        "stages by the sizes of what they read and write "
        "([kernel_probe.c](../contrib/benchmarks/kernel_probe.c), "
        "[kernels.py](../contrib/benchmarks/kernels.py)). A cycle is one of "
        "multigrid, one for each iteration of the conjugate gradients; its "
        "bytes are those of its products with the finest matrix, and its "
        "products are also among those of the row above.",
        listed(own, {
            "cells": "cells", "linear solver": "solver", "kernel": "kernel",
            "calls": "calls", "seconds": "seconds",
            "GB": lambda row: (number(row["bytes"] / 1e9)
                               if row["bytes"] != "" else "-"),
            "GB/s": rate("bytes", 1e9), "of the bandwidth": percent,
            "flop / byte": intensity, "Gflop/s": rate("operations", 1e9)},
               left=1)]


def projection(growth_rows, kernel_rows):
    """What the measurements say of TARGET cells."""
    rows = solved(growth_rows)
    if len(rows) < 2:
        return []
    lines = projected(growth_rows, kernel_rows)
    largest = rows[-1]
    ranks = TARGET / largest["cells"]
    per_cell = ((largest["memory"] - rows[-2]["memory"]) * 2**20 /
                (largest["cells"] - rows[-2]["cells"]))
    serial = [line["stage"] for line in lines if not line["distributed"]]
    counts = cycles(kernel_rows)
    growth_of_cycles = (
        f"; its cycles, {' and '.join(number(row['calls']) for row in counts)} "
        f"at {' and '.join(number(row['cells']) for row in counts)} cells, go "
        "on growing with the power that they have between these sizes"
        if len(counts) > 1 else "")
    return [
        f"What {tables.power(TARGET)} cells would take, if the growth measured "
        f"here went on: on one process; on {number(ranks)} processes of a "
        f"cluster, each with {number(largest['cells'])} cells and a core and "
        "bandwidth like those measured with, where what is not distributed "
        "stays on the first process; and if everything were distributed. The "
        "assumptions:",
        "- On one process a stage grows with the power of the whole range, at "
        "least 1; distributed, its time depends on the cells of a process. "
        "Statics "
        "is solved by multigrid, since a factorisation neither fits nor is "
        f"distributed{growth_of_cycles}.\n"
        "- A stage counts as distributed if two processes take at most "
        f"{number(DISTRIBUTED)} of the time of one, and has then the "
        "efficiency measured with two. "
        + (f"Not distributed: {', '.join(serial)}. " if serial else "")
        + "The cost of messages between more than two is left out.\n"
        f"- Memory grows by {number(per_cell)} bytes a cell, as between the "
        f"two largest sizes: {number(per_cell * TARGET / 2**30)} GiB in all, which "
        "the first process must hold as long as any stage stays on it, and "
        f"{number(largest['memory'] / 1024)} GiB a process once none does.\n"
        "- No joint slides; where many do, the time of statics is that times "
        "the number of Newton's steps.",
        markdown(["stage", "power", f"s at {number(largest['cells'])}",
                  "gain by two", "one process, h",
                  f"{number(ranks)} processes, h", "all distributed, s"],
                 [[line["stage"], number(line["exponent"]),
                   number(line["seconds"]), number(line["speedup"]),
                   number(line["alone"] / 3600), number(line["now"] / 3600),
                   number(line["shared"])] for line in lines] +
                 [["all", "", number(sum(line["seconds"] for line in lines)),
                   "", number(sum(line["alone"] for line in lines) / 3600),
                   number(sum(line["now"] for line in lines) / 3600),
                   number(sum(line["shared"] for line in lines))]])]


SECTIONS = {"peers": ("Beside other solvers", peers),
            "sliding": ("Beside other solvers where blocks slide", sliding),
            "forms": ("The form of the problem", forms),
            "growth": ("Growth", growth),
            "sliding_growth": ("Growth where blocks slide", sliding_growth),
            "kernels": ("Kernels and the memory", kernels)}


def measured(rows):
    return [
        "Times are medians over repeats that go through all settings in turn; "
        f"of the solvers, those that take more than {SHORT} s are run once. A "
        "solver that ends without an answer, or is stopped by the limit of "
        "time, is not asked for larger packings. Each run is a process of its "
        f"own with at most {MEMORY_LIMIT} GiB of addresses; memory is the "
        "largest that it held. Residual and violation are computed from the "
        "forces alone by one code for all solvers, over the largest load on a "
        "cell.",
        measured_table(rows)]


def write(directory):
    """Write cost.md and its plots from cost/*.csv in a directory."""
    rows = {name: tables.read(directory / "cost" / f"{name}.csv")
            for name in SECTIONS}
    (directory / "images").mkdir(parents=True, exist_ok=True)
    text = ["<!-- Generated by contrib/cost; do not edit. -->",
            "# What it costs",
            "The time and memory of Voussoir beside other solvers of the same "
            "problem, how both grow with the packing, and what limits them."]
    for name, (title, section) in SECTIONS.items():
        if rows[name]:
            text += [f"## {title}", *section(rows[name])]
            if name in PLOTS:
                picture = f"images/cost_{name}.png"
                PLOTS[name](rows[name], directory / picture)
                shown = " ".join(PLOTS[name].__doc__.split())
                text.append(f"*{shown}*\n\n![{title}]({picture})")
            text.append(f"All numbers: [{name}.csv](cost/{name}.csv).")
    further = projection(rows["growth"], rows["kernels"])
    if further:
        text += ["## A hundred million cells", *further]
    text += ["## How it was measured",
             *measured(tables.read(directory / "cost" / "measured.csv"))]
    page = directory / "cost.md"
    page.write_text("\n\n".join(part.strip() for part in text) + "\n",
                    encoding="utf-8")
    return page
