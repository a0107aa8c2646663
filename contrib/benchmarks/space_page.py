"""The sections of the page, with their advice and plots, on load factors and
on blocks in space."""
import math

from advice import root_mean_square, sentence, solved
from common import USUAL_TOLERANCE as USUAL
from plots import FLOOR, axes, close, save
from tables import distinct, listed, number, pivot, power, ratio, where


def answered(rows, key):
    """The rows that have a value."""
    return [row for row in solved(rows) if row[key] != ""]


def factors(rows):
    def entry(row):
        if row["outcome"] != "solved":
            return row["outcome"]
        return f"{number(row['width'])} ({number(row['time_ratio'])})"

    return [
        "`Solver/Tolerance of the load factor` from left to right: the width "
        "between the forces that carry a factor and the mechanism that bounds "
        "it, over the factor, and in brackets the time over that with "
        f"{power(USUAL)}, the default. Walls and domes have Coulomb's friction, "
        "turn and are pushed sideways; random cells have Tresca's, and carry a "
        "deviator.",
        pivot(rows, {"structure": "structure"}, "tolerance", entry,
              (f"seconds at {power(USUAL)}", lambda line: number(
                  where(line, tolerance=USUAL)[0]["seconds"])))]


def factors_plot(rows, path):
    """The width between both proofs of a load factor by the time that it
    takes, over the time with the default tolerance."""
    names = ("plane", "space")
    figure, panels = axes(2, ("time / default", "width"),
                          ["In the plane", "In space"])
    for panel, name in zip(panels, names):
        for structure in distinct(rows, "structure"):
            kind, _, title = structure.partition(": ")
            own = answered(where(rows, structure=structure), "width")
            if kind == name:
                panel.plot([row["time_ratio"] for row in own],
                           [max(row["width"], FLOOR) for row in own], "o-",
                           markersize=4, label=title)
        panel.set(xscale="linear")
        panel.legend(frameon=False, fontsize=8)
    close(figure, path)


def factors_advice(rows):
    """What a certified factor of a few digits saves."""
    loose = [row["time_ratio"] for row in
             answered(where(rows, tolerance=1e-3), "width")]
    usual = answered(where(rows, tolerance=USUAL), "width")
    if not loose or not usual:
        return ""
    widest = max(row["width"] for row in usual)
    return (f"both proofs within 1e-3 take {number(min(loose))} to "
            f"{number(max(loose))} of the time of the default, which leaves at "
            f"most {number(widest)} between them: there is little to save")


def friction_cells(rows):
    return [
        "Joints in space with Tresca's strength that turn, by `Contact/Friction "
        "cells` n, which cuts each kite of a face into n x n. The bracket is "
        "the distance from the factor that is carried to the bound for the "
        "continuous face, over the former; the proofs of the cells themselves "
        "are as close as without. Times are over those with one.",
        listed(rows, {
            "structure": "structure", "friction cells": "friction_cells",
            "carried": lambda row: digits(row["carried"]),
            "bound of the continuous face": lambda row: digits(row["bound"]),
            "bracket": "bracket", "time / 1 cell": ratio,
            "seconds": "seconds"})]


def digits(value):
    """A factor with six digits."""
    return "-" if value == "" else f"{value:.6g}"


def friction_cells_plot(rows, path):
    """The bracket of the factor of continuous faces by the time, over that
    with one friction cell; cells are beside the points."""
    figure, (panel,) = axes(1, ("time / 1 friction cell", "bracket"),
                            ["Tresca's strength, blocks turn"])
    for structure in distinct(rows, "structure"):
        own = answered(where(rows, structure=structure), "bracket")
        panel.plot([row["time_ratio"] for row in own],
                   [max(row["bracket"], FLOOR) for row in own], "o-",
                   markersize=4, label=structure)
        for row in own:
            panel.annotate(number(row["friction_cells"]),
                           (row["time_ratio"], max(row["bracket"], FLOOR)),
                           textcoords="offset points", xytext=(4, 3),
                           fontsize=7)
    save(figure, panel, path)


def friction_cells_advice(rows):
    """What friction cells gain."""
    parts = []
    for cells in distinct(rows, "friction_cells")[:3]:
        own = answered(where(rows, friction_cells=cells), "bracket")
        if own:
            widest = max(row["bracket"] for row in own)
            slowest = max(row["time_ratio"] for row in own)
            parts.append(f"{number(100 * widest)} per cent with "
                         + ("`Friction cells` = " if not parts else "")
                         + number(cells)
                         + (f", in up to {number(slowest)} times the time"
                            if cells > 1 else ""))
    return ("the factor of the continuous face with Tresca's strength is known "
            "to " + ", ".join(parts)) if parts else ""


def questions(rows):
    return [
        "What is asked of a structure with Coulomb's friction whose blocks "
        "turn, and the time over that of its state of least energy; without "
        "the packing and the files. The ranges of some joints are those of the "
        "lowest course of the wall, and of one side of the foot of the dome. "
        "The settlement is that of one half of the ground, with the state.",
        listed(rows, {
            "structure": "structure", "question": "question",
            "time / state": ratio, "seconds": "seconds",
            "outcome": "outcome"}, left=2)]


def extruded(rows):
    return [
        "Structures in the plane, and the same with a thickness in space: "
        "states of least energy of joints that do not slide, and factors with "
        "Coulomb's friction of blocks that turn. The difference is the largest "
        "one of the normal forces over the thickness, or that of the factors, "
        "over the largest value.",
        listed(rows, {
            "structure": "structure", "question": "question",
            "plane, seconds": "plane_seconds", "space, seconds": "seconds",
            "space / plane": ratio, "difference": "difference"}, left=2)]


def rate(rows, key):
    """The power of the inradius with which an error falls over the three smallest
    blocks; empty where it is rounding."""
    last = sorted(rows, key=lambda row: row["inradius"])[:3]
    if len(last) < 2 or any(row[key] == "" or row[key] < 1e-9 for row in last):
        return ""
    return (math.log(last[-1][key] / last[0][key]) /
            math.log(last[-1]["inradius"] / last[0]["inradius"]))


def space_stress(rows):
    def entry(row):
        return number(row["distance"])

    def last(line):
        return number(rate(line, "distance"))

    return [
        "The stress inside one block under the tractions of a stress in closed "
        "form, and its body force: a column under its weight, a bar in bending, "
        "and the ring between the radii 1 and 2 with a pressure inside (Lamé), "
        "of which the block is cut at the radius 1.45. The columns are the "
        "inradius of the block. An entry is the L2 distance of the stress from "
        "the closed form, over its largest component, and the last column the "
        "power of the inradius with which it falls over the three smallest "
        "blocks; a dash where it is rounding.",
        pivot(rows, {"field": "field", "block": "shape",
                     "Accuracy": "accuracy"}, "inradius", entry,
              ("power", last)),
        "The same of the mean stress of the block.",
        pivot(rows, {"field": "field", "block": "shape",
                     "Accuracy": "accuracy"}, "inradius",
              lambda row: number(row["distance_of_means"]),
              ("power", lambda line: number(rate(line, "distance_of_means"))))]


def space_stress_plot(rows, path):
    """The error of the stress inside one block by its size: in a thick ring;
    of linear stresses `fine` has rounding alone."""
    shapes = distinct(rows, "shape")
    figure, panels = axes(len(shapes), ("inradius over that of the ring",
                                        "L2 error"),
                          [f"{shape.capitalize()}" for shape in shapes])
    for panel, shape in zip(panels, shapes):
        for field, style in (("thick ring", "o-"), ("bar in bending", "s--")):
            for accuracy, colour in zip(("draft", "standard", "fine"),
                                        ("#7f7f7f", "#1f77b4", "#d62728")):
                own = answered(where(rows, shape=shape, field=field,
                                     accuracy=accuracy), "distance")
                panel.plot([row["inradius"] for row in own],
                           [max(row["distance"], FLOOR) for row in own], style,
                           markersize=4, color=colour,
                           label=f"{field}, {accuracy}")
    save(figure, panels[0], path)


def space_stress_advice(rows):
    """Which accuracy is worth it in space."""
    def error(accuracy):
        smallest = min(distinct(rows, "inradius"))
        return root_mean_square(row["distance"] for row in answered(
            where(rows, field="thick ring", accuracy=accuracy,
                  inradius=smallest), "distance"))

    def power_of(accuracy):
        rates = [rate(where(rows, field="thick ring", accuracy=accuracy,
                            shape=shape), "distance")
                 for shape in distinct(rows, "shape")]
        return number(round(sum(rates) / len(rates), 1))

    return ("in space `fine` is exact where the stress is linear; in a curved "
            f"one its error falls with the power {power_of('fine')} of the size "
            f"of the blocks, that of `standard` with {power_of('standard')} "
            f"and of `draft` with {power_of('draft')} "
            f"({number(error('fine'))}, {number(error('standard'))} and "
            f"{number(error('draft'))} in the smallest blocks tried)")


def extruded_advice(rows):
    """What space costs where the plane would do."""
    times = [[row["time_ratio"] for row in solved(where(rows, question=question))]
             for question in ("state", "load factor")]
    if not all(times):
        return ""
    (least, most), (least_of_factor, most_of_factor) = (
        (min(t), max(t)) for t in times)
    return (f"what can be extruded is better asked in the plane: a state in "
            f"space takes {number(least)} to {number(most)} and a load factor "
            f"{number(least_of_factor)} to {number(most_of_factor)} times as "
            "long")


def lines(tables):
    """The advice on load factors and on space, from the rows of all tables."""
    def said(name, advice):
        return advice(tables[name]) if tables[name] else ""
    return ["**Load factor.** " + sentence([
        said("factors", factors_advice),
        said("friction_cells", friction_cells_advice)]),
        "**Space.** " + sentence([said("space_stress", space_stress_advice),
                                  said("extruded", extruded_advice)])]


SECTIONS = {"factors": ("Load factors", factors),
            "friction_cells": ("Friction cells", friction_cells),
            "questions": ("What a question costs", questions),
            "space_stress": ("Stress inside blocks in space", space_stress),
            "extruded": ("In the plane and extruded", extruded)}
PLOTS = {"factors": factors_plot, "friction_cells": friction_cells_plot,
         "space_stress": space_stress_plot}
