"""What files have, Python has: each column in an attribute, and the files themselves.

    python3 check_files.py SOURCE_DIRECTORY PROGRAM
"""
import filecmp
import glob
import json
import os

import numpy as np
import voussoir
from checks import SOURCE, expect, numbers, raised, run_program, table

# The scenes, with settings; with them all kinds of tables are written.
SCENES = [
    ("prm/portal.prm", {"Ranges/Samples": 400}),
    ("prm/homogeneous_compression.prm", {}),
    ("prm/tied_arch.prm", {}),
    ("prm/bridge_with_fill.prm", {}),
    ("prm/rocking_wall.prm", {}),
    ("prm/shear_wall.prm", {"Friction/Strength": 0.9}),
    ("prm/semicircular_arch.prm", {"Friction/Law": "associated Coulomb",
                                   "Contact/Compressive strength": 100}),
    ("prm/retaining_wall.prm", {}),
    ("prm/space/dome.prm", {}),
    ("prm/space/grains.prm", {}),
    ("prm/space/building.prm", {}),
]
# The displacements of a state stand in cells.csv beside a mechanism, which Python has.
BESIDE_MECHANISM = {("cells.csv", "ux"), ("cells.csv", "uy"), ("cells.csv", "rotation")}


def columns_of(found):
    """All columns of numbers, and lists of texts, by the attributes that have them."""
    columns = {}
    for name in dir(found):
        try:
            value = getattr(found, name)
        except AttributeError:
            continue
        if isinstance(value, np.ndarray):
            for k, column in enumerate(value.reshape(len(value), -1).T if len(value) else []):
                columns[f"{name}[{k}]"] = column.astype(float)
        elif isinstance(value, list) and value and isinstance(value[0], str):
            columns[name] = value
    return columns


def has(columns, texts):
    """Whether an attribute has this column of a table."""
    try:
        column = numbers(texts)
    except ValueError:
        return any(isinstance(of, list) and of == texts for of in columns.values())
    if np.isnan(column).all() or np.array_equal(column, np.arange(len(column))):
        return True
    return any(isinstance(of, np.ndarray) and np.array_equal(of, column, equal_nan=True)
               for of in columns.values())


def check_columns():
    kinds = set()
    for k, (file, settings) in enumerate(SCENES):
        directory = f"columns_{k}"
        status = run_program(f"{SOURCE}/{file}", directory,
                             *(f"{name}={value}" for name, value in settings.items()))
        expect(f"{file}: status {status}", status in (0, 3))
        found = voussoir.Scene(f"{SOURCE}/{file}", settings=settings).solve()
        columns = columns_of(found)
        for path in glob.glob(f"{directory}/*.csv"):
            name = os.path.basename(path)
            kinds.add(name)
            beside = os.path.exists(f"{directory}/mechanism.csv")
            for column, texts in table(path).items():
                if not (beside and (name, column) in BESIDE_MECHANISM):
                    expect(f"{file}: {column} of {name}", has(columns, texts))
        missing = read(f"{directory}/summary.json", json.load).keys() - found.summary.keys()
        expect(f"{file}: {missing} of summary.json", missing <= {"title", "processes"})
    expect(f"{kinds}", kinds == {
        "interfaces.csv", "cells.csv", "boundary.csv", "links.csv", "capacity.csv",
        "mechanism.csv", "mechanism_joints.csv", "mechanism_links.csv", "interface_points.csv"})


def check_names():
    """The names of what the tables of the boundary and of capacity have."""
    found = voussoir.Scene(f"{SOURCE}/prm/rocking_wall.prm").solve()
    expect("a curve", found.capacity_displacement[0] == 0. and
           abs(found.capacity_carried[0] - 1 / 6) < 1e-7 and
           (found.capacity_bound >= found.capacity_carried).all() and
           len(found.capacity_error_of_state) == len(found.summary["capacity"]["points"]))
    expect("live loads", np.allclose(found.live_load[:, 0], 18 * found.areas) and
           np.allclose(found.live_load_torque, 0., atol=1e-12))
    expect("help", type(found).capacity_displacement.__doc__ ==
           "the displacement of the point, in its direction; L.")
    found = voussoir.Scene(f"{SOURCE}/prm/homogeneous_compression.prm").solve()
    expect("a pressure of one", np.allclose(
        found.boundary_forces, -found.boundary_normals * found.boundary_lengths[:, None]))
    expect("its edges", np.allclose((found.boundary_ends - found.boundary_starts) @ [[0, -1], [1, 0]],
                                    found.boundary_normals * found.boundary_lengths[:, None]) and
           np.allclose(found.boundary_moments, 0., atol=1e-15) and len(found.boundary_cells))
    middles = (found.boundary_starts + found.boundary_ends) / 2
    expect("branches", np.allclose(middles - found.centres[found.boundary_cells],
                                   found.boundary_branches))
    raised(AttributeError, "there is no 'capacity_carried': it is there with `Analysis = capacity` "
           "only", lambda: found.capacity_carried)


def read(path, reader):
    with open(path) as file:
        return reader(file)


def same_files(program, python):
    """The files of two directories but for times and the name of the directory."""
    names = sorted(os.listdir(program))
    expect(f"{names} and {os.listdir(python)}", names == sorted(os.listdir(python)))
    for name in names:
        if name == "report.html":  # with times
            expect(name, os.path.getsize(f"{python}/{name}") > 10000)
        elif name == "summary.json":
            summaries = [read(f"{directory}/{name}", json.load) for directory in (program, python)]
            times = [summary.pop("timings") for summary in summaries]
            expect(f"{times}", times[0].keys() == times[1].keys())
            expect(f"{program}/{name}", summaries[0] == summaries[1])
        elif name == "parameters.prm":
            texts = [read(f"{directory}/{name}", lambda file: file.read().replace(
                f"= {directory}\n", "= DIRECTORY\n")) for directory in (program, python)]
            expect(f"{program}/{name}", texts[0] == texts[1])
        else:
            expect(f"{program}/{name}",
                   filecmp.cmp(f"{program}/{name}", f"{python}/{name}", shallow=False))


def check_write():
    """write() makes the files of the program, of a solution, a collapse, and in space."""
    for k, (file, settings) in enumerate(SCENES[1:3] + SCENES[5:6] + SCENES[9:10]):
        path = f"{SOURCE}/{file}"
        run_program(path, f"program_{k}", *(f"{n}={v}" for n, v in settings.items()))
        scene = voussoir.Scene(path, settings=settings)
        found = scene.solve()
        if found.status == "solved" and k == 0:
            # Later settings belong to later results; arrays stay where they are.
            scene["Friction/Strength"] = 5
            stress = found.stress
            before = stress.copy()
        found.write(f"python_{k}")
        if k == 0:
            expect("views", np.array_equal(stress, before)
                   and stress.ctypes.data == found.stress.ctypes.data)
        same_files(f"program_{k}", f"python_{k}")
    found.write("python_3")  # again
    raised(voussoir.InputError, "The page 'nowhere/page.html' cannot be written; is there such a "
           "directory, and may you write there?", lambda: found.report("nowhere/page.html"))


def check_pages():
    """report() writes the page of the program, and notebooks show it in a frame."""
    for file in ("prm/shear_wall.prm", "prm/space/wall.prm"):
        scene = voussoir.Scene(f"{SOURCE}/{file}", settings={"Title": "A <test>"})
        found = scene.solve()
        found.report("page.html")
        text = read("page.html", lambda page: page.read())
        expect(file, text.startswith("<!DOCTYPE html>") and "A &lt;test&gt;" in text)
        frame = found._repr_html_()
        expect("a frame", frame.startswith('<iframe srcdoc="&lt;!DOCTYPE html&gt;') and
               frame.endswith("</iframe>") and frame.count('"') == 8 and
               "A &amp;lt;test&amp;gt;" in frame)
    many = voussoir.Scene(settings={
        "Packing/Generator": "wall", "Packing/wall/Courses": 50,
        "Packing/wall/Bricks per course": 50, "Supports/Where": "y < 1e-9",
        "Formulation": "least energy"}).solve()
    expect("many blocks", many._repr_html_() == (
        f"<p>solved: {many.n_blocks} blocks, too many to be shown here; "
        "<code>report(\"page.html\")</code> writes the page.</p>"))


check_columns()
check_names()
check_write()
check_pages()
print("OK")
