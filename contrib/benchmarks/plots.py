"""The plots, from the rows of the tables."""
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from advice import solved, stress_error, stress_time  # noqa: E402
from tables import distinct, where  # noqa: E402

COLOURS = {"compliant": "#1f77b4", "hard": "#d62728",
           "linear program": "#7f7f7f", "least energy": "#2ca02c",
           "centre (edge area)": "#9467bd", "centre (equal)": "#ff7f0e"}
FLOOR = 1e-16  # where a value of zero is drawn


def axes(panels, labels, title):
    """A figure with panels side by side, on logarithmic axes; labels of x and
    y, and the titles of the panels."""
    figure, row = plt.subplots(1, panels, figsize=(4.4 * panels + 1.2, 4),
                               squeeze=False, sharey=True)
    for panel, name in zip(row[0], title):
        panel.set(xscale="log", yscale="log", xlabel=labels[0], title=name)
        panel.grid(alpha=0.3)
    row[0][0].set_ylabel(labels[1])
    return figure, row[0]


def save(figure, panel, path):
    """Write a figure with the legend of a panel to its right."""
    figure.legend(*panel.get_legend_handles_labels(), loc="center left",
                  bbox_to_anchor=(1, 0.5), frameon=False)
    close(figure, path)


def close(figure, path):
    """Write a figure that has its legends."""
    figure.tight_layout()
    figure.savefig(path, dpi=100, bbox_inches="tight")
    plt.close(figure)


def curves(panel, rows, x, y, **style):
    """A curve for each formulation."""
    for way in distinct(rows, "way"):
        own = [row for row in solved(where(rows, way=way)) if row[y] != ""]
        panel.plot([row[x] for row in own],
                   [max(row[y], FLOOR) for row in own],
                   **{"marker": "o", "markersize": 4, "color": COLOURS[way],
                      "label": way, **style})


def formulations(rows, path):
    """The time by the number of cells."""
    figure, (panel,) = axes(1, ("cells", "time / least energy"),
                            ["Uniform stress, far from collapse"])
    curves(panel, rows, "cells", "time_ratio")
    save(figure, panel, path)


def tolerance(rows, path):
    """The distance to the canonical state by the tolerance; hollow with
    Equilibrate. Distances below 1e-16 are drawn there."""
    scenes = distinct(rows, "scene")
    figure, panels = axes(
        len(scenes), ("tolerance", "distance to the canonical state"),
        [f"{scene.capitalize()} {'from' if scene == 'far' else 'to'} collapse"
         for scene in scenes])
    for panel, scene in zip(panels, scenes):
        here = where(rows, scene=scene)
        curves(panel, where(here, equilibrate="false"), "tolerance", "distance")
        curves(panel, where(here, equilibrate="true"), "tolerance", "distance",
               linestyle="--", linewidth=1, markerfacecolor="white", label=None)
        panel.invert_xaxis()
    save(figure, panels[0], path)


def reconstruction(rows, path):
    """The error in the polygons by the time of the stress stage."""
    loads = {"uneven, no torque": "Blocks without residual torque",
             "uneven, torque": "Blocks with residual torque"}
    figure, panels = axes(2, ("time of the stress / standard",
                              "distance to the finest stress"), loads.values())
    for panel, load in zip(panels, loads):
        for setting in distinct(rows, "setting"):
            time = stress_time(rows, setting)["time_ratio"]
            error = stress_error(rows, setting, load)
            if time and error:
                marker = "s" if "degree 1" in setting else "o"
                panel.plot([time], [error], marker, label=setting)
    save(figure, panels[0], path)


def rigidity(rows, path):
    """The time by the distance to collapse."""
    names = distinct(rows, "structure")
    figure, panels = axes(len(names), ("distance to collapse",
                                       "time / least energy"), names)
    for panel, name in zip(panels, names):
        curves(panel, where(rows, structure=name), "distance_to_collapse",
               "time_ratio")
        panel.invert_xaxis()
    save(figure, panels[0], path)


PLOTS = {function.__name__: function
         for function in (formulations, tolerance, reconstruction, rigidity)}
