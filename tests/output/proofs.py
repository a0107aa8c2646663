#!/usr/bin/env python3
"""contrib/check_proof proves the results of all scenes, and finds errors in them:

    proofs.py PROGRAM TOP DIRECTORY OF THE PROJECT

Every scene of prm/ and prm/space/ is run but the largest, and others for what these do not ask;
their files are proven. Then one thing after the other is made wrong in files that were right.
"""
import csv
import json
import shutil
import subprocess
import sys
from pathlib import Path

PROGRAM, TOP = sys.argv[1], Path(sys.argv[2])
LARGE = {"million_cells"}  # takes minutes, and its tables some gigabytes of Python

# What no scene asks: a name, a scene, its settings, and what must be proven of it.
CASES = (
    ("slides", "shear_wall", ["Friction/Strength=0.9"], "collapse: closing"),
    ("overturns", "tutorial_wall", ["Rotations=true", "Loads/Body force=7.71; -20"],
     "collapse: closing"),
    ("snaps", "tied_arch", ["Ties/rod/Yield force=1"], "collapse: closing"),
    ("falls", "space/arch", ["Friction/Coefficient=0.1"], "collapse: closing"),
    ("crushes", "arch_bridge", ["Contact/Compressive strength=2000", "Contact/Tensile strength=1",
                                "Friction/Cohesion=2"], "factor between 137.7"),
    ("crushes_in_space", "space/building", ["Contact/Compressive strength=1000",
                                            "Contact/Tensile strength=1", "Friction/Cohesion=2"],
     "factor between 0.43"),
    ("all_loads", "arch", ["Analysis=load factor", "Load factor/Factor=all loads"],
     "factor between 1.5"),
    ("least", "sinking_pier", ["Supports/Displacement=", "Analysis=load factor",
                               "Load factor/Direction=least", "Live loads/Body force=1; 0"],
     "factor between -"),
    ("strength", "shear_wall", ["Analysis=load factor", "Load factor/Factor=strength"],
     "collapse with strengths over 10"),
    ("pair", "ferris_tin_loi_1", ["Friction/Law=Coulomb"], "collapse without dilatancy at 0.6428"),
    ("pair_in_space", "space/columns", ["Friction/Law=Coulomb"],
     "collapse without dilatancy at 0.18"),
    ("rests", "tutorial_wall", ["Rotations=true", "Friction/Law=Coulomb"],
     "a state without dilatancy: balance"),
    ("rests_in_space", "space/arch", ["Friction/Law=Coulomb", "Friction/Cohesion=3"],
     "a state without dilatancy: balance"),
    ("centre", "shear_wall", ["Formulation=analytic centre"], "mean stresses"),
    ("ranges", "spreading_arch", ["Ranges/Where=1", "Ranges/Reactions=true"],
     "ranges have this state"),
    ("ranges_in_space", "space/incline", ["Analysis=state", "Ranges/Where=1",
                                          "Ranges/Reactions=true"], "ranges have this state"),
    ("samples", "arch", ["Ranges/Samples=400", "Ranges/Where=1"], "samples: balance"),
    ("sinks", "space/arch", ["Supports/Displacement=0; 0; -0.01; 0.01; 0; 0"],
     "settlement: work -0.0135"),
    ("opens", "space/arch", ["Clamping=true"], "not clamped: a motion opens"),
)


def run(scene, name, *settings):
    words = [PROGRAM, str(scene), "--quiet"]
    for setting in (f"Output directory={name}", "Output/Report=false", *settings):
        words += ["--set", setting]
    if "space" not in str(scene.parent):
        words += ["--set", "Output/Files=csv"]
    return subprocess.run(words, check=False).returncode


def proven(*directories, by=(TOP / "contrib/check_proof",)):
    return subprocess.run([*by, *directories], check=False, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE)


def fail(words):
    sys.exit(f"proofs: {words}")


def check_lines(names, statements):
    """All are proven, and what is said of them is there."""
    found = proven(*names)
    print(found.stdout, found.stderr)
    if proven(*names, by=(PROGRAM, "--check")).stdout != found.stdout:
        fail("the program's --check says something else")
    lines = found.stdout.splitlines()
    if found.returncode != 0 or len(lines) != len(names):
        fail("a scene is not proven")
    for line, statement in zip(lines, statements):
        if statement not in line:
            fail(f"'{statement}' is missing in '{line}'")
    return lines


def check_scenes():
    scenes = sorted((TOP / "prm").glob("*.prm")) + sorted((TOP / "prm/space").glob("*.prm"))
    names = []
    for scene in scenes:
        if scene.stem in LARGE:
            continue
        name = f"{scene.parent.name}_{scene.stem}"
        if run(scene, name) not in (0, 3):
            fail(f"{scene} did not run")
        names.append(name)
    if len(names) < 50:
        fail(f"{len(names)} scenes")
    lines = check_lines(names, ["balance"] * len(names))
    for words, least in (("factor between", 25), ("settlement: work", 2), ("ranges have", 3),
                         ("mean stresses", 35), ("least energy", 9), ("loads", 30)):
        if sum(words in line for line in lines) < least:
            fail(f"'{words}' is said less than {least} times")


def check_cases():
    for name, scene, settings, _ in CASES:
        if run(TOP / "prm" / f"{scene}.prm", name, *settings) not in (0, 3):
            fail(f"{name} did not run")
    check_lines([name for name, *_ in CASES], [statement for *_, statement in CASES])


class Table:
    """A table of results that may be changed."""

    def __init__(self, directory, file):
        self.file = Path(directory) / file
        with open(self.file, newline="", encoding="utf-8") as lines:
            self.rows = list(csv.DictReader(lines))

    def largest(self, column):
        """The line with the largest number in this column."""
        return max((row for row in self.rows if row[column] not in ("", "inf", "-inf")),
                   key=lambda row: abs(float(row[column])))

    def write(self):
        with open(self.file, "w", newline="", encoding="utf-8") as out:
            writer = csv.DictWriter(out, self.rows[0], lineterminator="\n")
            writer.writeheader()
            writer.writerows(self.rows)


def in_table(file, column, change):
    """An error: a number of the line in which it is largest."""
    def plant(directory):
        of = Table(directory, file)
        row = of.largest(column)
        row[column] = repr(change(float(row[column])))
        of.write()
    return f"{column} in {file}", plant


def everywhere(file, column, change):
    """An error: a number of all lines."""
    def plant(directory):
        of = Table(directory, file)
        for row in of.rows:
            row[column] = repr(change(float(row[column])))
        of.write()
    return f"all {column} in {file}", plant


def without_line(file, column):
    """An error: the line with the largest number is missing."""
    def plant(directory):
        of = Table(directory, file)
        of.rows.remove(of.largest(column))
        of.write()
    return f"a line of {file}", plant


def without_column(file, column):
    """An error: a column is missing."""
    def plant(directory):
        of = Table(directory, file)
        for row in of.rows:
            del row[column]
        of.write()
    return f"{column} missing in {file}", plant


def cut_off(file):
    """An error: the last bytes of a file are missing."""
    def plant(directory):
        path = Path(directory) / file
        path.write_bytes(path.read_bytes()[:-3])
    return f"{file} cut off", plant


def without(file):
    """An error: a file is missing."""
    def plant(directory):
        (Path(directory) / file).unlink()
    return f"{file} missing", plant


def without_tables():
    """An error: all tables are missing."""
    def plant(directory):
        for file in Path(directory).glob("*.csv"):
            file.unlink()
    return "all tables missing", plant


def out_of_balance_within():
    """An error: forces out of balance, of a state that says it is solved, within that."""
    def plant(directory):
        in_table("interfaces.csv", "normal_force", more)[1](directory)
        file = Path(directory) / "summary.json"
        summary = json.loads(file.read_text(encoding="utf-8"))
        summary["within"] = 1.
        file.write_text(json.dumps(summary), encoding="utf-8")
    return "forces within 1", plant


def in_summary(path, change):
    """An error: a number of summary.json, whose place is `path`."""
    def plant(directory):
        file = Path(directory) / "summary.json"
        summary = json.loads(file.read_text(encoding="utf-8"))
        *keys, last = [int(key) if key.isdigit() else key for key in path.split("/")]
        at = summary
        for key in keys:
            at = at[key]
        at[last] = change(at[last])
        file.write_text(json.dumps(summary), encoding="utf-8")
    return f"{path} in summary.json", plant


def in_parameters(entry, value):
    """An error: another value is in parameters.prm."""
    def plant(directory):
        file = Path(directory) / "parameters.prm"
        lines = file.read_text(encoding="utf-8").splitlines()
        at = [k for k, line in enumerate(lines) if line.split("=")[0].strip() == f"set {entry}"]
        lines[at[0]] = f"set {entry} = {value}"
        file.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return f"{entry} in parameters.prm", plant


def more(value):
    return value * (1. + 1e-6)


def less(value):
    return 0.9 * value


def moved(value):
    return value + 1e-3


def opposite(value):
    return -value


def nothing(_):
    return float("nan")


# What is wrong in which results.
ERRORS = {
    "prm_arch_bridge": [
        in_table("interfaces.csv", "normal_force", more),
        in_table("interfaces.csv", "tangential_force", opposite),
        in_table("interfaces.csv", "normal_force_0", more),
        in_table("interfaces.csv", "normal_force_1", nothing),
        in_table("interfaces.csv", "x0", moved),
        everywhere("interfaces.csv", "nx", opposite),
        everywhere("interfaces.csv", "coefficient", lambda value: 0.2 * value),
        everywhere("interfaces.csv", "compressive_strength", lambda value: 0.5 * value),
        in_table("interfaces.csv", "utilisation", less),
        in_table("interfaces.csv", "crushing_utilisation", less),
        in_table("interfaces.csv", "eccentricity", less),
        in_table("interfaces.csv", "mobilised_angle", less),
        in_table("interfaces.csv", "cell_plus", lambda value: int(value) - 1),
        in_table("interfaces.csv", "branch_x", moved),
        without_line("interfaces.csv", "normal_force"),
        without_column("interfaces.csv", "compressive_strength"),
        without_column("interfaces.csv", "normal_force_0"),
        cut_off("interfaces.csv"), without("interfaces.csv"), without_tables(),
        out_of_balance_within(),
        in_table("cells.csv", "load_y", more), in_table("cells.csv", "load_torque", moved),
        in_table("cells.csv", "x", moved), in_table("cells.csv", "area", less),
        without_column("cells.csv", "load_x"),
        in_table("boundary.csv", "nx", opposite), in_table("boundary.csv", "length", less),
        without_line("boundary.csv", "length"),
        in_table("mechanism.csv", "ux", less), in_table("mechanism.csv", "rotation", less),
        in_table("mechanism.csv", "live_load_y", less),
        in_table("mechanism.csv", "load_y", more),
        everywhere("mechanism_joints.csv", "compressive_strength", less),
        in_table("mechanism_joints.csv", "opening_0", less),
        in_table("mechanism_joints.csv", "dissipation", less),
        without_line("mechanism_joints.csv", "opening_0"), without("mechanism_joints.csv"),
        in_summary("load_factor/carried", more), in_summary("load_factor/bound", more),
        in_summary("load_factor/width", lambda value: value + 1e-6),
        in_summary("load_factor/closing_violation", moved),
        in_summary("certificate/equilibrium_residual", moved),
        in_summary("certificate/max_utilisation", less),
        in_summary("ground/supports/0/reaction/1", more),
        in_summary("ground/supports/1/at/0", moved),
        in_summary("ground/supports/1/to/0", moved),
        in_summary("ground/mean_normal_stress", more),
        in_summary("loads/total/1", more), in_summary("packing/area", more),
        in_summary("rotations", lambda _: False), cut_off("summary.json"),
        in_parameters("Coefficient", 0.8), in_parameters("Compressive strength", 6000),
        in_parameters("Body force", "0; -25")],
    "slides": [
        everywhere("mechanism.csv", "load_x", lambda value: 0.5 * value),
        everywhere("mechanism.csv", "ux", opposite),
        in_table("mechanism.csv", "uy", lambda value: value - 0.1),
        everywhere("mechanism_joints.csv", "strength", lambda value: 2. * value),
        in_table("mechanism_joints.csv", "sliding", opposite),
        without_line("mechanism_joints.csv", "sliding"),
        in_summary("mechanism/work_over_dissipation", more),
        in_summary("mechanism/work_of_loads/0/work", more)],
    "overturns": [in_table("mechanism.csv", "rotation", opposite),
                  without_column("mechanism.csv", "rotation")],
    "prm_bridge_with_fill": [
        in_table("links.csv", "force", lambda value: 1.5 * value),
        everywhere("links.csv", "least", lambda value: 0.2 * value),
        in_table("links.csv", "y0", moved), in_table("links.csv", "dx", less),
        in_table("links.csv", "utilisation", less), without_line("links.csv", "force"),
        everywhere("mechanism_links.csv", "least", less),
        in_table("mechanism_links.csv", "elongation", less),
        without_line("mechanism_links.csv", "elongation"), without("links.csv"),
        in_summary("links/0/force", more), in_summary("links/1/utilisation", less)],
    "snaps": [in_table("mechanism_links.csv", "most", lambda value: 10. * value),
              in_table("mechanism_links.csv", "dissipation", less),
              without("mechanism_links.csv")],
    "space_building": [
        in_table("interface_points.csv", "force_z", more),
        in_table("interface_points.csv", "force_x", nothing),
        in_table("interface_points.csv", "x", moved),
        in_table("interface_points.csv", "share", less),
        in_table("interface_points.csv", "pressure", lambda value: 1. - value),
        without_line("interface_points.csv", "force_z"),
        everywhere("interfaces.csv", "coefficient", lambda value: 0.5 * value),
        in_table("interfaces.csv", "shear_force_x", less),
        in_table("interfaces.csv", "moment_x", less), in_table("interfaces.csv", "opening", less),
        in_table("interfaces.csv", "area", less), in_table("interfaces.csv", "nz", opposite),
        in_table("cells.csv", "load_z", more), in_table("cells.csv", "torque_y", moved),
        in_table("cells.csv", "displacement_x", less), in_table("cells.csv", "rotation_y", less),
        everywhere("cells.csv", "live_load_x", less), in_table("cells.csv", "sxx", less),
        in_table("cells.csv", "volume", less), without_column("cells.csv", "live_load_x"),
        without_line("boundary.csv", "area"),
        in_summary("load_factor/carried", more), in_summary("load_factor/bound", more),
        in_summary("reactions/0/reaction/2", more), in_summary("reactions/0/moment/0", moved),
        in_summary("reactions/0/at/0", moved), in_summary("force_on_ground/2", more),
        in_summary("loads/moment_about_origin/0", more)],
    "falls": [everywhere("cells.csv", "displacement_z", opposite),
              everywhere("interfaces.csv", "coefficient", lambda value: 20. * value)],
    "crushes_in_space": [everywhere("interfaces.csv", "tensile_strength", less),
                         everywhere("interfaces.csv", "compressive_strength", less)],
    "strength": [in_summary("load_factor/carried", more),
                 everywhere("interfaces.csv", "strength", less)],
    "all_loads": [everywhere("mechanism.csv", "live_load_y", more)],
    "pair": [in_summary("load_factor/carried", moved),
             in_summary("load_factor/own_collapse/factor", moved),
             in_table("mechanism.csv", "uy", moved), in_table("mechanism.csv", "ux", less),
             in_table("interfaces.csv", "normal_force", more)],
    "pair_in_space": [in_table("cells.csv", "rotation_y", less),
                      in_table("interface_points.csv", "force_x", opposite)],
    "rests": [in_table("cells.csv", "ux", lambda value: 1.01 * value),
              in_table("cells.csv", "rotation", opposite),
              in_table("cells.csv", "sxy", less), in_table("cells.csv", "torque", moved)],
    "rests_in_space": [in_table("cells.csv", "displacement_z", less)],
    "prm_shear_wall": [in_table("boundary.csv", "force_x", more),
                       in_table("boundary.csv", "x0", moved), in_table("cells.csv", "sxy", more),
                       in_table("boundary.csv", "cell", lambda value: int(value) - 1)],
    "prm_spreading_arch": [
        in_table("mechanism.csv", "uy", more), in_table("mechanism_joints.csv", "opening", less),
        everywhere("mechanism_joints.csv", "sliding", moved),
        in_summary("settlement/work", more), in_summary("settlement/width", moved),
        in_summary("settlement/largest_displacement", more),
        in_summary("settlement/hinges", lambda value: value + 1)],
    "sinks": [in_table("cells.csv", "displacement_z", moved),
              in_summary("settlement/work", more),
              in_parameters("Displacement", "0; 0; -0.01")],
    "prm_rocking_wall": [
        in_table("capacity.csv", "carried", less), without_line("capacity.csv", "carried"),
        in_summary("capacity/points/0/carried", more), in_summary("capacity/points/3/bound", less),
        in_summary("capacity/participation", more),
        in_summary("capacity/ultimate_displacement", more), without("capacity.csv")],
    "ranges": [
        in_table("interfaces.csv", "p_min", lambda value: 1.2 * value),
        in_table("interfaces.csv", "p_max", lambda value: 0.8 * value),
        in_table("interfaces.csv", "p_max", lambda value: 1.2 * value),
        in_table("interfaces.csv", "q_min", lambda value: 1.2 * value),
        in_table("interfaces.csv", "e_max", lambda value: 0.6),
        everywhere("interfaces.csv", "determined", lambda value: 1),
        in_table("interfaces.csv", "q_max", nothing),
        without_column("interfaces.csv", "e_min"),
        in_summary("ranges/reactions/0/x/0", lambda value: value + 1.),
        in_summary("ranges/reactions/0/y/1", lambda value: value + 1.),
        in_summary("ranges/interfaces", lambda value: value - 1)],
    "ranges_in_space": [in_table("interfaces.csv", "normal_force_min", less),
                        in_table("interfaces.csv", "shear_force_max_x", moved),
                        in_summary("ranges/reactions/0/z/1", less)],
    "prm_tied_arch": [in_summary("ranges/links/0/force/0", lambda value: value + 20.),
                      in_summary("ranges/reactions/1/x/0", lambda value: value + 1.)],
    "samples": [
        in_table("interfaces.csv", "p_mean", more), in_table("interfaces.csv", "q_mean", opposite),
        in_table("interfaces.csv", "p_mean_error", lambda value: 100. * value),
        in_table("interfaces.csv", "correlation", lambda value: 1.1),
        in_summary("samples/largest_error", less)],
    "opens": [in_table("cells.csv", "opening_displacement_x", opposite),
              in_summary("clamping/least_opening", more),
              in_summary("clamping/clamped", lambda _: True)],
}


def check_errors():
    n = 0
    for directory, errors in ERRORS.items():
        if proven(directory).returncode != 0:
            fail(f"{directory} is not proven")
        shutil.rmtree("wrong", ignore_errors=True)
        copies = [f"wrong/{k}" for k in range(len(errors))]
        for copy, (_, plant) in zip(copies, errors):
            shutil.copytree(directory, copy, ignore=shutil.ignore_patterns("*.vtu", "*.html"))
            plant(copy)
        found = proven(*copies)
        lines = found.stdout.splitlines()
        if found.returncode != 1 or len(lines) != len(errors):
            fail(f"{directory}: of {len(errors)} errors {len(lines)} have a line, and the exit "
                 f"status is {found.returncode}")
        for line, copy, (words, _) in zip(lines, copies, errors):
            if not line.startswith(f"{copy}: ") or "WRONG" not in line:
                fail(f"{directory}: {words} is wrong, and is not found: {line}")
            print(f"{directory}: {words}: found")
        n += len(errors)
    print(f"{n} errors were planted and found")


def check_unreadable():
    found = proven("nowhere")
    if found.returncode != 1 or "cannot be read" not in found.stdout:
        fail(f"a directory that is not there can be read: {found.stdout}")
    print(found.stdout.strip())


def main():
    check_scenes()
    check_cases()
    check_errors()
    check_unreadable()


main()
