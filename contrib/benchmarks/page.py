"""The page: advice, tables with what they show, plots, and how it was
measured."""
import tables
from advice import (MEASURES, beats, equilibrate_choices, lines,
                    stress_error, stress_time)
from plots import PLOTS
from tables import distinct, listed, number, pivot, power, ratio, where

SHORT = 0.05  # seconds below which a time is mostly noise


def outcome_or(text):
    """An entry that says how the run ended if there is no answer."""
    def entry(row):
        return text(row) if row["outcome"] == "solved" else row["outcome"]
    return entry


def iterations(row):
    """The iterations of the solver, with a star if it did not converge."""
    return number(row["iterations"]) + "*" * (row["solver"] != "converged")


def not_converged(rows):
    """A sentence on the stars of a table, if there are any."""
    stars = [row for row in rows if row["outcome"] == "solved" and
             row["solver"] != "converged"]
    return ("A star marks a solver that did not converge, whose forces pass "
            "the certificate all the same. " if stars else "")


def power_of(key):
    return lambda row: power(row[key])


def spread(rows):
    """A sentence on the noise of the times that a table gives without it."""
    noise = sorted(row["time_spread"] / row["time_ratio"] for row in rows
                   if row["time_ratio"])
    return ("The spread of the times is "
            f"{number(100 * noise[len(noise) // 2])} per cent in the median "
            f"and {number(100 * noise[-1])} at most. ")


def seconds_at(**labels):
    """The seconds of the one row of a line with the given labels."""
    return lambda line: number(where(line, **labels)[0]["seconds"])


def short_times(rows):
    """A sentence on the rows whose time is very short."""
    short = [row for row in rows if row["seconds"] != "" and
             row["seconds"] < SHORT]
    return (f"In {len(short)} of the {len(rows)} rows the time is below "
            f"{SHORT} s, where its spread says more than the ratio."
            if short else "")


def formulations(rows):
    return [
        "Random Voronoi cells under the uniform stress diag(-1.2, -0.8) with "
        "s_T = 0.3; forces only. The patch error is the distance of the forces "
        "from those of that stress, which is admissible. "
        + not_converged(rows) + short_times(rows),
        listed(rows, {
            "formulation": "way", "cells": "cells",
            "time / least energy": ratio, "seconds": "seconds",
            "iterations": outcome_or(iterations),
            "residual": "residual", "violation": "violation",
            "patch error": "patch_error"})]


def tolerance(rows):
    def entry(row):
        return f"{number(row['distance'])} ({number(row['time_ratio'])})"

    def balance(row):
        change = number(row["mean_stress_change"])
        return f"{number(row['residual'])} / {change}"

    keys = {"scene": "scene", "formulation": "way",
            "Equilibrate": "equilibrate"}
    worst = max(rows, key=lambda row: row["violation"] or 0)
    reference = power(min(row["tolerance"] for row in rows))
    return [
        "`Solver/Tolerance` from left to right, for random cells far from "
        "collapse and at 0.99 of the limit. An entry is the distance to the "
        f"canonical state, which is that with the tolerance {reference}, and "
        "in brackets the time over that of the same formulation with 1e-10. "
        + spread(rows) + short_times(rows),
        pivot(rows, keys, "tolerance", outcome_or(entry),
              ("seconds at 1e-10", seconds_at(tolerance=1e-10))),
        "The residual, and the change of the mean stresses of the cells from "
        "those of the canonical state. The largest violation of all is "
        f"{number(worst['violation'])} ({worst['way']}, "
        f"{power(worst['tolerance'])}).",
        pivot(rows, keys, "tolerance", outcome_or(balance)),
        "The cheapest tolerance for a given accuracy without and with "
        "`Equilibrate`, and in brackets its time. Bold: less time than the "
        "other, beyond the spread of both.",
        *(derived(rows, measure) for measure in MEASURES)]


def derived(rows, measure):
    """The cheapest settings for each accuracy by one measure."""
    def setting(row, bold):
        text = (f"{power(row['tolerance'])} ({number(row['time_ratio'])})"
                if row else "-")
        return f"**{text}**" if bold else text

    def entry(choice):
        one, other = choice["without"], choice["with"]
        return (setting(one, beats(one, other)) + " / " +
                setting(other, beats(other, one)))

    return pivot(where(equilibrate_choices(rows), measure=measure),
                 {"scene": "scene", f"{MEASURES[measure]} at most": "way"},
                 "accuracy", entry)


def barrier(rows):
    return [
        "Hard contact by the point of the central path where the solver stops, "
        "and both contacts by the smoothing length; random cells far from and "
        "close to collapse. Times are over those of the defaults. The "
        "canonical state of hard contact is that of the point 1e-10 with the "
        "tolerance 1e-14. " + not_converged(rows) + short_times(rows),
        listed(rows, {
            "scene": "scene", "contact": "way", "parameter": "parameter",
            "value": power_of("value"), "tolerance": power_of("tolerance"),
            "time / default": ratio, "seconds": "seconds",
            "iterations": outcome_or(iterations),
            "residual": "residual", "violation": "violation",
            "distance to the canonical state": "distance",
            "change of mean stress": "mean_stress_change"}, left=3)]


def reconstruction(rows):
    def error(measure, load):
        return lambda row: number(stress_error(rows, row["setting"], load,
                                               measure))

    def distance(structure):
        return lambda row: number(where(
            rows, structure=structure, setting=row["setting"])[0]["distance"])

    def time(row):
        timed = stress_time(rows, row["setting"])
        return ratio(timed) if timed["seconds"] != "" else "-"

    def microseconds(row):
        seconds = stress_time(rows, row["setting"])["seconds"]
        return number(1e6 * seconds if seconds != "" else "")

    even, calm, torque = "uniform stress", "uneven, no torque", "uneven, torque"
    settings = [where(rows, setting=setting)[0]
                for setting in distinct(rows, "setting")]
    sides = [number(side) for side in
             distinct(where(rows, structure="polygon"), "sides") if side > 3]
    return [
        "The time of the stress stage in random cells close to collapse, and "
        "the L2 distance to the finest stress, relative to it: in regular "
        f"polygons of {', '.join(sides)} sides (root mean square) under uneven "
        "tractions without and with a torque, in a wall under its weight, and "
        "in random cells close to collapse. That includes the change of the "
        "stress within a sub-cell, for which the files have one value; the "
        "columns of means compare it with the mean of the finest stress over "
        "the sub-cell. `draft` stands for the mean stress of each cell.",
        listed(settings, {
            "setting": "setting", "time / standard": time,
            "µs a cell": microseconds,
            "no torque": error("distance", calm),
            "means, no torque": error("distance_of_means", calm),
            "torque": error("distance", torque),
            "means, torque": error("distance_of_means", torque),
            "wall": distance("wall"), "random cells": distance("random cells"),
            "uniform stress": error("patch_error", even)}),
        "What is left of the equations in the same polygons: div sigma + b, "
        "times the root of the cell's area, and the skew part, both in L2 and "
        "over sigma. With a torque a rigid acceleration must remain; the "
        "fourth column is without it.",
        listed(settings, {
            "setting": "setting", "div, no torque": error("imbalance", calm),
            "div, torque": error("imbalance", torque),
            "div but rigid, torque": error("imbalance_not_rigid", torque),
            "skew, no torque": error("asymmetry", calm),
            "skew, torque": error("asymmetry", torque)})]


def rigidity(rows):
    def entry(row):
        return f"{number(row['time_ratio'])} ({iterations(row)})"

    def balance(row):
        return f"{number(row['residual'])} / {number(row['violation'])}"

    keys = {"structure": "structure", "formulation": "way"}
    farthest = max(row["distance_to_collapse"] for row in rows)
    return [
        "Loads at 1 less the given distance of the limit load. An entry is the "
        "time over that of least energy and in brackets the iterations, or how "
        "the run ended. " + not_converged(rows) + spread(rows)
        + short_times(rows),
        pivot(rows, keys, "distance_to_collapse", outcome_or(entry),
              (f"seconds at {power(farthest)}",
               seconds_at(distance_to_collapse=farthest))),
        "Residual and violation of the same runs.",
        pivot(rows, keys, "distance_to_collapse", outcome_or(balance))]


def features(rows):
    return [
        "What each feature adds to the forces alone, which write no file but "
        "the summary: random cells under a uniform stress, least energy. Time "
        "is the sum of all stages; the stage is the one that grows most. "
        "Memory is the largest that the process held.",
        listed(rows, {
            "feature": "feature", "cells": "cells", "time / forces only": ratio,
            "seconds": "seconds",
            "iterations": outcome_or(iterations),
            "stage": "stage", "memory / forces only": "memory_ratio",
            "MiB": "memory"})]


# The sections by the names of the experiments.
SECTIONS = {"formulations": ("Formulations", formulations),
            "tolerance": ("Tolerance and Equilibrate", tolerance),
            "barrier": ("Barrier parameter and smoothing length", barrier),
            "reconstruction": ("Stress inside the cells", reconstruction),
            "rigidity": ("Close to collapse", rigidity),
            "features": ("What a feature costs", features)}


def measured(rows):
    """How the tables were measured."""
    return [
        "Times are medians over repeats that go through all settings in turn; "
        "they are given over those of a reference setting in the same repeat, "
        "± half the interquartile range, so that the noise of the machine hits "
        "all alike. Times are those of the stages in `summary.json`, without "
        "the start of the process; of a run without an answer, that of the "
        "whole process. All other numbers are computed from the .csv and .vtu "
        "files.",
        listed(rows, {"experiment": "experiment", "repeats": "repeats",
                      "command": lambda row: f"`{row['command']}`",
                      "processor": "processor", "cores": "cores",
                      "program": "program"}, left=5)]


def write(directory):
    """Write accuracy.md and its plots from accuracy/*.csv in a directory."""
    rows = {name: tables.read(directory / "accuracy" / f"{name}.csv")
            for name in SECTIONS}
    runs = tables.read(directory / "accuracy" / "measured.csv")
    (directory / "images").mkdir(parents=True, exist_ok=True)
    text = ["<!-- Generated by contrib/study; do not edit. -->",
            "# Which setting when",
            "\n".join(f"- {line}" for line in lines(rows))]
    for name, (title, section) in SECTIONS.items():
        if rows[name]:
            text += [f"## {title}", *section(rows[name]),
                     f"All numbers: [{name}.csv](accuracy/{name}.csv)."]
    text.append("## Plots")
    for name, plot in PLOTS.items():
        if rows[name]:
            picture = f"images/accuracy_{name}.png"
            plot(rows[name], directory / picture)
            shown = " ".join(plot.__doc__.split())
            text.append(f"*{shown}*\n\n![{SECTIONS[name][0]}]({picture})")
    text += ["## How it was measured", *measured(runs)]
    page = directory / "accuracy.md"
    page.write_text("\n\n".join(part.strip() for part in text) + "\n",
                    encoding="utf-8")
    return page
