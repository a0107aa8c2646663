"""What the tables of the solvers say, as parts of the page of the cost."""
import tables
from page import outcome_or
from peers import LEAST_ENERGY, NO_FILES
from scenes import WAYS
from tables import distinct, listed, markdown, number, where

INTERIOR_POINT = "HiGHS interior point"
COMPARED_AT = 10000  # cells
BALANCED = 1e-6  # residual or violation that the program itself accepts


def times(value):
    return f"{number(value)} times"


def others(rows):
    """The rows of solvers that are not ours."""
    return [row for row in rows if row["solver"] not in (*WAYS, NO_FILES)]


def headline(rows):
    """HiGHS' interior point against least energy, and the nearest of all other
    solvers, at the size of the comparison or the largest below it."""
    sizes = [row["cells"] for row in
             where(rows, solver=INTERIOR_POINT, outcome="solved")
             if row["cells"] <= COMPARED_AT]
    if not sizes:
        return ["HiGHS' interior point has no answer to compare with."]
    here = where(rows, cells=max(sizes), outcome="solved")
    other = where(here, solver=INTERIOR_POINT)[0]
    nearest = min(others(here), key=lambda row:
                  row["seconds_over_least_energy"])
    whole = min(others(here), key=lambda row:
                row["elapsed_over_least_energy"])
    return [
        f"- At {number(max(sizes))} cells HiGHS' interior point takes "
        f"{times(other['seconds_over_least_energy'])} the time of least "
        f"energy, {times(other['elapsed_over_least_energy'])} with the whole "
        "process on both sides.\n"
        f"- Of the other solvers, {nearest['solver']} is the nearest there: "
        f"{times(nearest['seconds_over_least_energy'])} the time of least "
        f"energy and {times(nearest['seconds_over_best'])} that of the best "
        "formulation; with the whole process it is "
        f"{whole['solver']}, {times(whole['elapsed_over_least_energy'])} and "
        f"{times(whole['elapsed_over_best'])}.\n" + ahead(rows)]


def ahead(rows):
    """Up to where other solvers are faster than the best of ours."""
    lines = []
    for time, what in (("seconds", "solver"), ("elapsed", "whole process")):
        faster = {row["solver"]: row for row in others(rows)
                  if row["outcome"] == "solved" and
                  row[f"{time}_over_best"] < 1}
        cases = ", ".join(f"{solver} up to {number(row['cells'])} cells"
                          for solver, row in faster.items())
        lines.append(f"- By the time of the {what} "
                     + (f"faster than the best formulation: {cases}."
                        if cases else "no other solver is faster than the best "
                        "formulation at any size."))
    first = where(rows, solver=NO_FILES)[0]
    start = first["elapsed"] - first["seconds"] - first["building"]
    return "\n".join(lines) + (
        f" Of the whole process of this program {number(start)} s go into "
        "starting it, whatever the packing.")


def farthest(rows):
    """For each solver the largest packing, and what ended the series."""
    lines = []
    for solver in distinct(rows, "solver"):
        own = where(rows, solver=solver)
        good = where(own, outcome="solved")
        last = good[-1] if good else None
        end = "-" if own[-1]["outcome"] == "solved" else (
            f"{own[-1]['outcome']} at {number(own[-1]['cells'])}")
        lines.append([solver, own[-1]["form"] or "-", *(
            [number(last[key]) for key in
             ("cells", "seconds", "seconds_over_least_energy",
              "seconds_over_best", "elapsed", "elapsed_over_least_energy",
              "elapsed_over_best", "memory")] if last else ["-"] * 8), end])
    return markdown(["solver", "form", "largest packing", "seconds",
                     "/ least energy", "/ best", "process, s",
                     "/ least energy", "/ best", "MiB", "then"], lines, left=2)


def starred(rows):
    """A sentence on the answers that the program would not accept."""
    loose = [row for row in rows if row["outcome"] == "solved" and
             row["residual"] != "" and
             max(row["residual"], row["violation"]) > BALANCED]
    names = ", ".join(dict.fromkeys(
        f"{row['solver']} at {number(row['cells'])} cells" for row in loose))
    return (f"Residual or violation above {tables.power(BALANCED)}, with which "
            "this program would not report a state, have the answers of "
            f"{names}." if loose else
            "The forces of all answers are balanced and admissible to "
            f"{tables.power(BALANCED)}.")


def forms(rows):
    return [
        "The rigid problem is given to the other solvers as a linear program "
        "in one of three forms: *motion*, the paper's problem in the "
        "displacements, whose multipliers are the forces; *forces*, its dual, "
        "any balanced forces within their limits; *least pressure*, those with "
        "the least sum of p. Each solver is compared in the form in which it "
        "is the fastest here. Dense matrices get that of sparse ones.",
        listed(rows, {
            "solver": "solver", "form": "form", "cells": "cells",
            "seconds": outcome_or(lambda row: number(row["seconds"])),
            "iterations": "iterations", "residual": "residual",
            "violation": "violation"}, left=2)]


def peers(rows):
    return [
        "Random Voronoi cells under the uniform stress diag(-1.2, -0.8) with "
        "s_T = 0.3, forces only: the joints of one packing, in the order in "
        "which the program writes them, go to all solvers, with their default "
        "settings. Tolerances are 1e-7 for feasibility with forces in units of "
        "the largest load, and 1e-10 for this program. Under this load no "
        "joint slides in the state of least energy, which is found by one "
        "linear system; [the next table](#beside-other-solvers-where-blocks-"
        "slide) has those close to the limit of the load.",
        *headline(rows),
        "The largest packing that each has solved, its times there and those "
        f"over the times of `{LEAST_ENERGY}`, and of the fastest formulation, "
        "in the same packing:",
        farthest(rows),
        "All sizes. *Seconds* are those of the solver: of other solvers the "
        "call that solves, or what Clp reports, in steps of 0.01; of this "
        "program the stage `statics`. *Building* is the time to state the "
        "problem: the linear program from the joints, for Clp also its file; "
        "for this program the stage `packing`. *Process* is the time from "
        "start to end, which for other solvers includes reading the joints, "
        "and for this program making the packing and writing .csv files, "
        "except in "
        f"`{NO_FILES}`. " + starred(rows),
        listed(rows, {
            "cells": "cells", "solver": "solver", "form": lambda row:
            row["form"] or "-", "seconds": outcome_or(lambda row:
                                                      number(row["seconds"])),
            "/ least energy": "seconds_over_least_energy",
            "/ best": "seconds_over_best", "building": "building",
            "process, s": "elapsed",
            "process / least energy": "elapsed_over_least_energy",
            "process / best": "elapsed_over_best", "MiB": "memory",
            "iterations": "iterations", "residual": "residual",
            "violation": "violation"}, left=1)]


def sliding(rows):
    ours = where(rows, solver=LEAST_ENERGY, outcome="solved")
    worst = max(ours, key=lambda row: row["seconds_over_linear"])
    nearest = min((row for row in others(rows) if row["outcome"] == "solved"),
                  key=lambda row: row["seconds_over_least_energy"])
    compliant = where(rows, solver="compliant", outcome="solved")
    default = max(where(compliant, cells=compliant[-1]["cells"]),
                  key=lambda row: row["seconds_over_least_energy"])
    return [
        "The same packings with the same strength, under shares of the largest "
        "deviator d that they carry in the stress diag(-1 - d, -1 + d), found "
        "as a load factor.",
        "- Least energy takes at most "
        f"{times(worst['seconds_over_linear'])} the time of the one linear "
        "system that it needs where nothing slides: at "
        f"{number(worst['cells'])} cells and {worst['share']} of the limit.\n"
        "- The compliant formulation, the default, takes at most "
        f"{times(default['seconds_over_least_energy'])} the time of least "
        f"energy in the largest packing, {number(default['cells'])} cells, at "
        f"{default['share']} of the limit.\n"
        f"- Of the other solvers the nearest is {nearest['solver']} at "
        f"{number(nearest['cells'])} cells and {nearest['share']} of the "
        f"limit: {times(nearest['seconds_over_least_energy'])} the time of "
        f"least energy, {times(nearest['elapsed_over_least_energy'])} with the "
        "whole process.",
        starred(rows),
        listed(rows, {
            "cells": "cells", "of the limit": lambda row: f"{row['share']}",
            "d": "deviator", "solver": "solver",
            "form": lambda row: row["form"] or "-",
            "seconds": outcome_or(lambda row: number(row["seconds"])),
            "/ linear system": "seconds_over_linear",
            "/ least energy": "seconds_over_least_energy",
            "process, s": "elapsed",
            "process / least energy": "elapsed_over_least_energy",
            "MiB": "memory", "iterations": "iterations",
            "residual": "residual", "violation": "violation"}, left=2)]
