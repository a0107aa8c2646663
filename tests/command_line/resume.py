#!/usr/bin/env python3
"""What was killed goes on, and ends with the same files: resume.py VOUSSOIR [options]

Each computation is killed N times (1), and resumed after each: as soon as it has kept something,
then at random moments.
"""
import argparse
import csv
import json
import os
import random
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

from scene_text import prm

OPTIONS = argparse.ArgumentParser(description=__doc__)
OPTIONS.add_argument("program", type=lambda name: str(Path(name).resolve()))
OPTIONS.add_argument("--kills", type=int, default=1)
OPTIONS.add_argument("--seed", type=int, default=1)
OPTIONS.add_argument("--only", default="", metavar="REGEX",
                     help="of the computations those whose names match")
OPTIONS = OPTIONS.parse_args()
RESULTS = Path("results")
CHECKPOINT = RESULTS / "checkpoint.bin"
TIMES = re.compile(r"(?s)<h\d>Time</h\d>.*?</table>|\d+(\.\d+)?(e-\d+)? s\b")

CELLS = """set Packing/Generator = Voronoi
set Packing/Voronoi/Number of points = {n}
set Supports/Where = y < 0.02
set Loads/Body force = 0; -1
set Live loads/Body force = 1; 0
set Friction/Strength = 1
set Output directory = results
set Output/Checkpoint after = 0
"""
WALL = """set Rotations = true
set Packing/Generator = wall
set Packing/wall/Courses = {courses}
set Packing/wall/Bricks per course = {bricks}
set Friction/Law = associated Coulomb
set Friction/Coefficient = 0.6
set Loads/Body force = 0; -1
set Live loads/Body force = 1; 0
set Supports/Where = y < 1e-9
set Output directory = results
set Output/Checkpoint after = 0
"""
BOXES = """set Dimension = 3
set Packing/Generator = wall
set Packing/wall/Length = {n}
set Friction/Law = associated Coulomb
set Friction/Coefficient = 0.5
set Supports/Where = z < 1e-9
set Loads/Body force = 0; 0; -1
set Live loads/Body force = 1; 0.3; 0
set Accuracy = draft
set Output directory = results
set Output/Checkpoint after = 0
"""
# The scene, and the words of the command line.
COMPUTATIONS = {
    "load factor": (WALL.format(courses=30, bricks=24), ["--set", "Analysis=load factor"]),
    "load factor, Tresca": (CELLS.format(n=2500), ["--set", "Analysis=load factor"]),
    "load factor in space": (BOXES.format(n=3), ["--set", "Analysis=load factor"]),
    "ranges": (WALL.format(courses=7, bricks=8), ["--set", "Ranges/Where=1"]),
    "ranges without turning": (CELLS.format(n=150), ["--set", "Ranges/Where=1"]),
    "ranges in space": (BOXES.format(n=1), ["--set", "Ranges/Where=1"]),
    "sweep": (WALL.format(courses=12, bricks=8),
              ["--set", "Analysis=load factor", "--sweep", "Friction/Coefficient=0.3:0.9:24"]),
    "sweep with directories": (WALL.format(courses=8, bricks=6),
                               ["--directories", "--sweep", "Friction/Coefficient=0.1:0.9:16"]),
    "search": (WALL.format(courses=12, bricks=8),
               ["--set", "Loads/Body force=0.3; -1", "--find",
                "Friction/Coefficient=0.1:0.9:1e-4"]),
}
fails = []


def check(name, holds, found=""):
    if not holds:
        fails.append(name)
        print(f"{name}: WRONG", found, sep="\n")


def words(scene, more, *others):
    Path("scene.prm").write_text(prm(scene), encoding="utf-8")
    return [OPTIONS.program, "scene.prm", *more, *others]


def run(scene, more, *others):
    return subprocess.run(words(scene, more, *others), text=True, capture_output=True, check=False)


def content(file):
    """What is compared of a file."""
    text = file.read_bytes()
    if file.name == "summary.json":
        def without_times(tree):
            if isinstance(tree, list):
                return [without_times(node) for node in tree]
            return {name: without_times(node) for name, node in tree.items()
                    if name not in ("timings", "seconds")} if isinstance(tree, dict) else tree
        return without_times(json.loads(text))
    if file.name == "sweep.csv":
        return [{name: value for name, value in row.items() if name != "seconds"}
                for row in csv.DictReader(text.decode().splitlines())]
    if file.suffix == ".html":
        return TIMES.sub("", text.decode())
    return text


def files():
    return {str(file.relative_to(RESULTS)): content(file)
            for file in sorted(RESULTS.rglob("*")) if file.is_file()}


def wait_for_checkpoint(process):
    while process.poll() is None and not CHECKPOINT.exists():
        time.sleep(0.002)


def go_on(scene, more):
    """From what there is, or anew."""
    return words(scene, more, *(["--resume"] if CHECKPOINT.exists() else []))


def kill_and_resume(name, scene, more, whole, seconds, moments):
    n_kept = 0
    for kill in range(OPTIONS.kills):
        shutil.rmtree(RESULTS, ignore_errors=True)
        for _ in range(20):
            with subprocess.Popen(go_on(scene, more), stdout=subprocess.DEVNULL,
                                  stderr=subprocess.PIPE) as process:
                if kill == 0:
                    wait_for_checkpoint(process)
                else:
                    time.sleep(moments.uniform(0.1, 0.8) * seconds)
                process.kill()
                error = process.communicate()[1].decode()
            check(f"{name}: killed, or ended well", process.returncode in (-9, 0), error)
            if CHECKPOINT.exists() or process.returncode == 0:
                break
        n_kept += CHECKPOINT.exists()
        done = subprocess.run(go_on(scene, more), text=True, capture_output=True, check=False)
        check(f"{name}: it ends", done.returncode == 0, done.stdout + done.stderr)
        there = files()
        different = [file for file in whole.keys() | there.keys()
                     if whole.get(file) != there.get(file)]
        check(f"{name}: the same files, kill {kill + 1}", not different, different)
        check(f"{name}: nothing else is left", not list(RESULTS.rglob("checkpoint*")))
    return n_kept


def check_all(moments):
    for name, (scene, more) in COMPUTATIONS.items():
        if not re.search(OPTIONS.only, name):
            continue
        shutil.rmtree(RESULTS, ignore_errors=True)
        begin = time.monotonic()
        done = run(scene, more)
        seconds = time.monotonic() - begin
        check(f"{name}: it is solved", done.returncode == 0, done.stdout + done.stderr)
        whole = files()
        n_kept = kill_and_resume(name, scene, more, whole, seconds, moments)
        check(f"{name}: something was kept", n_kept > 0)
        if OPTIONS.kills > 1:
            print(f"{name}: {seconds:.1f} s, {OPTIONS.kills} kills, {n_kept} of them resumed")


def leave_checkpoint(scene, more):
    """Kill a computation when it has kept something, more than a moment before its end."""
    shutil.rmtree(RESULTS, ignore_errors=True)
    with subprocess.Popen(words(scene, more), stdout=subprocess.DEVNULL) as process:
        times = set()
        while process.poll() is None and len(times) < 6:
            if CHECKPOINT.exists():
                times.add(CHECKPOINT.stat().st_mtime_ns)
            time.sleep(0.002)
        process.kill()


def leave_sweep(scene, *words_of_sweep):
    """Kill a sweep when some of its runs are kept."""
    shutil.rmtree(RESULTS, ignore_errors=True)
    with subprocess.Popen(words(scene, words_of_sweep), stdout=subprocess.DEVNULL) as process:
        wait_for_checkpoint(process)
        process.kill()


def check_that_it_goes_on():
    """What is done is not done again, and what is cut off at its end is read."""
    scene, more = COMPUTATIONS["load factor"]
    leave_checkpoint(scene, more)
    done = run(scene, more, "--resume", "--verbosity", "2")
    first = re.search(r"iteration (\d+), factor", done.stdout)
    check("a load factor goes on in the middle", first and int(first.group(1)) > 1, done.stdout)
    scene, more = COMPUTATIONS["sweep"]
    leave_sweep(scene, *more)
    kept = CHECKPOINT.read_bytes()
    CHECKPOINT.write_bytes(kept[:-7])
    begin = time.monotonic()
    done = run(scene, more, "--resume")
    check("a record that is cut off is none", done.returncode == 0, done.stderr)
    seconds = time.monotonic() - begin
    times = [float(row["seconds"]) for row in
             csv.DictReader((RESULTS / "sweep.csv").read_text().splitlines())]
    check("the table has the times of all runs", len(times) == 24 and min(times) > 0 and
          seconds > 0)


def check_that_runs_are_told_apart():
    """Runs of another text or file with the same values are not those that were kept."""
    scene = WALL.format(courses=12, bricks=8)
    leave_sweep(scene, "--sweep", "Loads/Body force=0.01*a; -1 for a=0:9:40")
    done = run(scene, ["--sweep", "Loads/Body force=9*a; -1 for a=0:9:40", "--resume"])
    statuses = [row["status"] for row in
                csv.DictReader((RESULTS / "sweep.csv").read_text().splitlines())]
    check("another text is another run", done.returncode == 0 and
          statuses == ["solved"] + 39 * ["collapse"], (done.stderr, statuses))
    leave_sweep(scene, "--sweep", "Friction/Coefficient=0.3:0.9:40")
    done = run(scene, [], "--resume")
    check("a single run is no sweep", done.returncode == 2 and
          "of a run with another" in " ".join(done.stderr.split()), done.stderr)
    leave_checkpoint(*COMPUTATIONS["load factor"])
    done = run(COMPUTATIONS["load factor"][0], ["--set", "Analysis=load factor", "--sweep",
                                                "Friction/Coefficient=0.3 | 0.6", "--resume"])
    check("nor a sweep a single run", done.returncode == 2 and
          "of a run with another 'kind': none, now \"many runs\"" in
          " ".join(done.stderr.split()), done.stderr)


def check_messages():
    def refused(name, sentence, *others, scene=None):
        of_scene, more = COMPUTATIONS["load factor"]
        done = run(scene or of_scene, more, "--resume", *others)
        check(name, done.returncode == 2 and sentence in " ".join(done.stderr.split()),
              done.stdout + done.stderr)
    shutil.rmtree(RESULTS, ignore_errors=True)
    refused("nothing to resume", "--resume: 'results/checkpoint.bin' is not there: nothing was "
            "interrupted in this directory after 'Output/Checkpoint after', or its results are "
            "complete. Run without --resume.")
    check("nothing is written", not RESULTS.exists())
    scene, more = COMPUTATIONS["load factor"]
    leave_checkpoint(scene, more)
    kept = CHECKPOINT.read_bytes()
    refused("another scene", "--resume: 'results/checkpoint.bin' is of a run with another "
            "'parameters': ", "--set", "Friction/Coefficient=0.7")
    check("and it is kept", CHECKPOINT.read_bytes() == kept)
    refused("another title is another run", "is of a run with another 'parameters'",
            "--set", "Title=Another")
    CHECKPOINT.write_bytes(b"no checkpoint at all")
    refused("no checkpoint", "--resume: 'results/checkpoint.bin' cannot be read. Run without "
            "--resume.")
    done = run(scene, more)
    check("without --resume it begins anew", done.returncode == 0 and not CHECKPOINT.exists())
    # An interruption says that it can go on.
    shutil.rmtree(RESULTS, ignore_errors=True)
    with subprocess.Popen(words(scene, more), stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE, text=True) as process:
        wait_for_checkpoint(process)
        time.sleep(0.05)
        process.terminate()
        said = process.communicate()[1]
    check("an interruption says that it can go on", process.returncode == 143 and
          said == "voussoir: Interrupted by SIGTERM; no results were written; with --resume the "
          "run goes on from 'results/checkpoint.bin'.\n", said)
    done = run(scene, more, "--resume")
    check("and it can", done.returncode == 0, done.stderr)
    # Before the time is over nothing is written.
    shutil.rmtree(RESULTS, ignore_errors=True)
    with subprocess.Popen(words(scene, more, "--set", "Output/Checkpoint after=60"),
                          stdout=subprocess.DEVNULL) as process:
        time.sleep(0.3)
        process.kill()
    check("a short run keeps nothing", not CHECKPOINT.exists())


# Where no other test writes.
Path("resume").mkdir(exist_ok=True)
os.chdir("resume")
check_all(random.Random(OPTIONS.seed))
check_that_it_goes_on()
check_that_runs_are_told_apart()
check_messages()
print("FAILED: " + ", ".join(fails) if fails else "OK")
sys.exit(bool(fails))
