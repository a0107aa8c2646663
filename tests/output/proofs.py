#!/usr/bin/env python3
"""contrib/check_proof proves the results of all scenes, and finds errors in them:

    proofs.py PROGRAM TOP DIRECTORY OF THE PROJECT

Every scene of prm/ and prm/space/ is run but the largest, and its files are proven; then
one thing after the other is made wrong in files that were right.
"""
import csv
import json
import shutil
import subprocess
import sys
from pathlib import Path

PROGRAM, TOP = sys.argv[1], Path(sys.argv[2])
LARGE = {"million_cells"}


def run(scene, name, *settings):
    words = [PROGRAM, str(scene), "--quiet", "--set", f"Output directory={name}"]
    for setting in settings:
        words += ["--set", setting]
    return subprocess.run(words, check=False).returncode


def proven(*directories):
    return subprocess.run([TOP / "contrib/check_proof", *directories], check=False, text=True,
                          stdout=subprocess.PIPE)


def fail(words):
    sys.exit(f"proofs: {words}")


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
    if len(names) < 35:
        fail(f"{len(names)} scenes")
    found = proven(*names)
    print(found.stdout)
    lines = found.stdout.splitlines()
    if found.returncode != 0 or len(lines) != len(names):
        fail("a scene is not proven")
    if sum("factor between" in line for line in lines) < 15:
        fail("factors are missing")
    if any("nothing to prove" in line for line in lines):
        fail("a scene has nothing to prove")


class Table:
    """A table of results that may be changed."""

    def __init__(self, directory, file):
        self.file = Path(directory) / file
        with open(self.file, newline="", encoding="utf-8") as lines:
            self.rows = list(csv.DictReader(lines))

    def write(self):
        with open(self.file, "w", newline="", encoding="utf-8") as out:
            writer = csv.DictWriter(out, self.rows[0])
            writer.writeheader()
            writer.writerows(self.rows)


def largest(rows, *columns):
    """The line with the largest number in these columns."""
    return max(rows, key=lambda row: max(abs(float(row[c])) for c in columns))


def in_table(file, column, change):
    """An error: a number of the line in which it is largest."""
    def plant(directory):
        of = Table(directory, file)
        row = largest(of.rows, column)
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
        of.rows.remove(largest(of.rows, column))
        of.write()
    return f"a line of {file}", plant


def in_summary(section, name, change):
    """An error: a number of summary.json."""
    def plant(directory):
        file = Path(directory) / "summary.json"
        summary = json.loads(file.read_text(encoding="utf-8"))
        summary[section][name] = change(summary[section][name])
        file.write_text(json.dumps(summary), encoding="utf-8")
    return f"{name} in summary.json", plant


def more(value):
    return value * (1. + 1e-6)


def less(value):
    return 0.9 * value


def moved(value):
    return value + 1e-3


PLANE = [in_table("interfaces.csv", "normal_force", more),
         in_table("interfaces.csv", "tangential_force", lambda value: -value),
         in_table("interfaces.csv", "normal_force_0", more),
         in_table("interfaces.csv", "x0", moved),
         everywhere("interfaces.csv", "coefficient", lambda value: 0.2 * value),
         everywhere("interfaces.csv", "compressive_strength", lambda value: 0.5 * value),
         without_line("interfaces.csv", "normal_force"),
         in_table("cells.csv", "load_y", more), in_table("cells.csv", "load_torque", moved),
         in_table("cells.csv", "x", moved),
         in_table("mechanism.csv", "ux", less), in_table("mechanism.csv", "rotation", less),
         in_table("mechanism.csv", "live_load_y", less),
         everywhere("mechanism_joints.csv", "compressive_strength", less),
         without_line("mechanism_joints.csv", "opening_0"),
         in_summary("load_factor", "carried", more), in_summary("load_factor", "bound", more)]
COLLAPSE = [everywhere("mechanism.csv", "load_x", lambda value: 0.5 * value),
            everywhere("mechanism.csv", "ux", lambda value: -value),
            in_table("mechanism.csv", "uy", lambda value: value - 0.1),
            everywhere("mechanism_joints.csv", "strength", lambda value: 2. * value)]
LINKS = [in_table("links.csv", "force", lambda value: 1.5 * value),
         everywhere("links.csv", "least", lambda value: 0.2 * value),
         in_table("links.csv", "y0", moved), in_table("links.csv", "dx", less),
         without_line("links.csv", "force"),
         everywhere("mechanism_links.csv", "least", lambda value: 0.9 * value),
         without_line("mechanism_links.csv", "elongation")]
SPACE = [in_table("interface_points.csv", "force_z", more),
         in_table("interface_points.csv", "x", moved),
         without_line("interface_points.csv", "force_z"),
         everywhere("interfaces.csv", "coefficient", lambda value: 0.5 * value),
         in_table("cells.csv", "load_z", more), in_table("cells.csv", "torque_y", moved),
         in_table("cells.csv", "displacement_x", less),
         in_table("cells.csv", "rotation_y", less), everywhere("cells.csv", "live_load_x", less),
         in_summary("load_factor", "carried", more), in_summary("load_factor", "bound", more)]


def check_unreadable():
    for directory in ("nowhere", "without"):
        found = proven(directory)
        if found.returncode != 1 or "cannot be read" not in found.stdout:
            fail(f"{directory} can be read: {found.stdout}")
        print(found.stdout.strip())
        shutil.copytree("prm_arch_bridge", "without", dirs_exist_ok=True)
        everything = Table("without", "cells.csv")
        for row in everything.rows:
            del row["load_x"]
        everything.write()


def check_errors(directory, errors):
    if proven(directory).returncode != 0:
        fail(f"{directory} is not proven")
    for words, plant in errors:
        shutil.rmtree("wrong", ignore_errors=True)
        shutil.copytree(directory, "wrong")
        plant("wrong")
        found = proven("wrong")
        if found.returncode != 1 or "WRONG" not in found.stdout:
            fail(f"{directory}: {words} is wrong, and is not found: {found.stdout}")
        print(f"{directory}: {words}: found")


def main():
    check_scenes()
    if run(TOP / "prm/shear_wall.prm", "collapse", "Friction/Strength=0.9") != 3:
        fail("no collapse")
    check_errors("prm_arch_bridge", PLANE)
    check_errors("collapse", COLLAPSE)
    check_errors("prm_bridge_with_fill", LINKS)
    check_errors("space_building", SPACE)
    check_unreadable()


main()
