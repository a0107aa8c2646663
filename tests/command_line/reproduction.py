#!/usr/bin/env python3
"""Results say what they are made of, and are made again: reproduction.py VOUSSOIR"""
import json
import os
import shutil
import subprocess
import sys
import uuid
from pathlib import Path

from scene_text import prm

PROGRAM = str(Path(sys.argv[1]).resolve())
WALL = """set Title = A wall
set Rotations = true
set Output directory = ../results
set Packing/Generator = polygons
set Packing/polygons/File = blocks.wkt
set Supports/Where = y < 1e-9
set Friction/Law = Coulomb
set Friction/Coefficient = 0.6
set Loads/Body force = 0; -1
set Live loads/Body force = 1; 0
"""
BLOCKS = ("POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))\nPOLYGON ((2 0, 4 0, 4 1, 2 1, 2 0))\n"
          "POLYGON ((1 1, 3 1, 3 2, 1 2, 1 1))\n")
CUBES = """set Dimension = 3
set Output directory = ../cubes
set Packing/Generator = wall
set Packing/wall/Length = 0.4
set Supports/Where = z < 1e-9
set Friction/Strength = 10
set Loads/Body force = 0; 0; -1
"""
fails = []


def check(name, holds, found=""):
    if not holds:
        fails.append(name)
        print(f"{name}: WRONG", found, sep="\n")


def run(*words, directory=".", env=None):
    done = subprocess.run([PROGRAM, *words], cwd=directory, text=True, capture_output=True,
                          env={**os.environ, **(env or {})}, check=False)
    return done.returncode, done.stdout, done.stderr


def lines(text):
    return {line.split(maxsplit=1)[0]: line.split(maxsplit=1)[1]
            for line in text.splitlines() if len(line.split()) > 1}


def name_of(content):
    return str(uuid.uuid5(uuid.NAMESPACE_OID, content))


def fresh():
    """The scenes in a directory of their own, with results beside it."""
    shutil.rmtree("here", ignore_errors=True)
    Path("here/scenes").mkdir(parents=True)
    for name, text in (("wall.prm", prm(WALL)), ("blocks.wkt", BLOCKS), ("cubes.prm", prm(CUBES))):
        Path("here/scenes", name).write_text(text, encoding="utf-8")


def summary(results="here/results"):
    return json.loads(Path(results, "summary.json").read_text(encoding="utf-8"))


def change(edit, results="here/results"):
    """Change the summary; what stood there."""
    file = Path(results, "summary.json")
    before = file.read_text(encoding="utf-8")
    tree = json.loads(before)
    edit(tree)
    file.write_text(json.dumps(tree), encoding="utf-8")
    return before


def refused(name, status, error, words):
    check(name, status == 2 and " ".join(words.split()) in " ".join(error.split()),
          f"{status} {error}")


# What it says of itself.
fresh()
setting = "Live loads/Body force=1; 0"
status, _, error = run("wall.prm", "--set", "Analysis=load factor", "--set", setting,
                       directory="here/scenes")
check("a wall is solved", status == 0, error)
origin = summary()["provenance"]
check("the command has quotes where a shell needs them", origin["command"] ==
      "voussoir wall.prm --set 'Analysis=load factor' --set 'Live loads/Body force=1; 0'", origin)
check("paths begin at the file", origin["directory"] == "../scenes", origin)
check("files have the names of their contents",
      origin["files"] == {"../scenes/blocks.wkt": name_of(BLOCKS)}, origin)
check("there are the commit, the kernel, and threads",
      isinstance(origin["commit"], str) and isinstance(origin["kernel"], str) and
      origin["threads"] >= 1, origin)

# The command does the same in a shell.
before = {file.name: file.read_bytes() for file in Path("here/results").glob("*.csv")}
shutil.rmtree("here/results")
subprocess.run(origin["command"].replace("voussoir", f"'{PROGRAM}'", 1), shell=True, check=True,
               cwd="here/scenes", stdout=subprocess.DEVNULL)
after = {file.name: file.read_bytes() for file in Path("here/results").glob("*.csv")}
check("the command makes the same files", len(before) >= 3 and before == after)
check("and says the same", summary()["provenance"] == origin)

# Another output or title is the same input, another strength is not.
run("wall.prm", "--set", "Analysis=load factor", "--set", "Output directory=../other",
    "--set", "Output/Verbosity=0", directory="here/scenes")
check("the output is no input",
      summary("here/other")["provenance"]["parameters"] == origin["parameters"])
run("wall.prm", "--set", "Analysis=load factor", "--set", "Output directory=../other",
    "--set", "Friction/Coefficient=0.61", directory="here/scenes")
check("a coefficient is",
      summary("here/other")["provenance"]["parameters"] != origin["parameters"])

# Made again, from wherever.
for directory, file in (("here", "results/summary.json"), ("here/results", "summary.json"),
                        ("/", str(Path("here/results/summary.json").resolve()))):
    status, out, error = run("--reproduce", file, directory=directory)
    said = lines(out)
    check(f"made again from {directory}", status == 0 and
          said["Reproduced"] == "the answer is the same" and
          said["Summary"].endswith("members, the same to the last digit") and
          said["Tables"] == f"{len(after)}, the same to the last byte" and "Made" not in said,
          out + error)
check("nothing is left or changed",
      {file.name: file.read_bytes() for file in Path("here/results").glob("*.csv")} == after)

# What differs is told.
factor = summary()["load_factor"]["carried"]
text = change(lambda tree: tree["certificate"].update(max_utilisation=0.5))
status, out, _ = run("--reproduce", "here/results/summary.json")
used = json.loads(text)["certificate"]["max_utilisation"]
check("another number is told", status == 0 and
      lines(out)["Summary"].split(" ", 1)[0] == "1" and
      "members differ, most 'certificate/max_utilisation', by " in out, out)
share = float(out.split("max_utilisation', by ")[1].split()[0])
check("and by how much", abs(share - abs(used - 0.5) / max(used, 0.5)) < 1e-5 * share, out)
Path("here/results/summary.json").write_text(text, encoding="utf-8")

table = Path("here/results/interfaces.csv")
table.write_text(table.read_text(encoding="utf-8").replace("0", "1", 1), encoding="utf-8")
status, out, _ = run("--reproduce", "here/results/summary.json")
check("another table is told",
      status == 0 and lines(out)["Tables"] == f"interfaces.csv differ, of {len(after)}", out)
table.write_bytes(after["interfaces.csv"])

text = change(lambda tree: tree["load_factor"].update(carried=1.1 * factor, bound=1.1 * factor))
status, out, _ = run("--reproduce", "here/results/summary.json")
check("another factor is another answer",
      status == 1 and lines(out)["Reproduced"] == "ANOTHER ANSWER", out)
Path("here/results/summary.json").write_text(text, encoding="utf-8")
text = change(lambda tree: tree["load_factor"].update(unbounded=True, carried=None, bound=None))
status, out, _ = run("--reproduce", "here/results/summary.json")
check("a factor without bound is another one", status == 1, out)
Path("here/results/summary.json").write_text(text, encoding="utf-8")
Path("here/results/capacity.csv").write_text("a table of its own\n", encoding="utf-8")
status, out, _ = run("--reproduce", "here/results/summary.json")
check("a table that is not made again is told", status == 0 and
      lines(out)["Tables"] == f"capacity.csv differ, of {len(after) + 1}", out)
Path("here/results/capacity.csv").unlink()
text = change(lambda tree: tree.update(status="collapse"))
status, out, _ = run("--reproduce", "here/results/summary.json")
check("and another status", status == 1, out)
Path("here/results/summary.json").write_text(text, encoding="utf-8")

text = change(lambda tree: tree["provenance"].update(kernel="Another", threads=77))
status, out, _ = run("--reproduce", "here/results/summary.json")
check("another machine is told", status == 0 and 'the kernel "Another", now with "' in out and
      "threads: 77, now with " in out, out)
Path("here/results/summary.json").write_text(text, encoding="utf-8")

# Proven again from the files, without being made.
status, out, error = run("--check", "here/results")
check("results are proven", status == 0 and not error and
      out.startswith("here/results: a state without dilatancy: balance "), out + error)
table.write_text(table.read_text(encoding="utf-8").replace(".", ".9", 1), encoding="utf-8")
status, out, error = run("--check", "here/results", "here/other", "--quiet")
check("one that is not is told", status == 1 and not out and
      error.startswith("here/results: ") and ": WRONG, " in error and
      error.count("\n") == 1, out + error)
table.write_bytes(after["interfaces.csv"])
status, out, error = run("--check", "here/none")
check("no results are not proven", status == 1 and "here/none: " in out, out + error)
status, _, error = run("--check", "here/results", "--set", "Title=Another")
refused("more than a check", status, error, "--check takes directories of results; give it "
        "without a file of parameters and other options than --quiet.")

# A collapse, and blocks in space.
run("wall.prm", "--set", "Loads/Body force=9; -1", directory="here/scenes")
check("a collapse", summary()["status"] == "collapse")
status, out, error = run("--reproduce", "here/results/summary.json")
check("a collapse is made again", status == 0 and "the same to the last byte" in out, out + error)
run("cubes.prm", directory="here/scenes")
status, out, error = run("--reproduce", "here/cubes/summary.json")
check("blocks in space are made again", status == 0 and "last digit" in out and
      "the same to the last byte" in out, out + error)

# Forces of an earlier run are input, too.
run("wall.prm", directory="here/scenes")
run("wall.prm", "--set", "Forces from=../results", "--set", "Output directory=../other",
    directory="here/scenes")
origin = summary("here/other")["provenance"]
check("the files of forces are named", "../results/interfaces.csv" in origin["files"] and
      origin["files"]["../scenes/blocks.wkt"] == name_of(BLOCKS), origin)

# What cannot be made again.
status, _, error = run("--reproduce", "here/none.json")
refused("no file", status, error,
        "'here/none.json' cannot be read; name the summary.json that a run of this version has "
        "written.")
Path("here/text.json").write_text("[1, 2", encoding="utf-8")
status, _, error = run("--reproduce", "here/text.json")
refused("no JSON", status, error, "'here/text.json' does not say what the results are made of (")
text = change(lambda tree: tree.pop("provenance"))
status, _, error = run("--reproduce", "here/results/summary.json")
refused("an earlier version", status, error, "does not say what the results are made of (")
Path("here/results/summary.json").write_text(text, encoding="utf-8")
Path("here/scenes/blocks.wkt").write_text(BLOCKS.replace("2 0", "2.5 0"), encoding="utf-8")
status, _, error = run("--reproduce", "here/results/summary.json")
refused("another drawing", status, error,
        "The file 'here/scenes/blocks.wkt' is not the one that the results of "
        "'here/results/summary.json' are made of; bring that back, or run the scene itself.")
Path("here/scenes/blocks.wkt").unlink()
status, _, error = run("--reproduce", "here/results/summary.json")
refused("no drawing", status, error,
        "The results of 'here/results/summary.json' are made of 'here/scenes/blocks.wkt', which "
        "is not there; bring it back, or run the scene itself.")
Path("here/scenes/blocks.wkt").write_text(BLOCKS, encoding="utf-8")
parameters = Path("here/results/parameters.prm")
written = parameters.read_text(encoding="utf-8")
check("there is a coefficient to change", "= 0.6\n" in written)
parameters.write_text(written.replace("= 0.6\n", "= 0.7\n"), encoding="utf-8")
status, _, error = run("--reproduce", "here/results/summary.json")
refused("other parameters", status, error,
        "'here/results/parameters.prm' is not the file that was written with "
        "'here/results/summary.json': its entries differ; bring it back, or run the scene itself.")
parameters.write_text(written, encoding="utf-8")
for words in (("here/scenes/wall.prm",), ("--set", "Rotations=false"), ("--validate",),
              ("--resume",), ("--sweep", "Friction/Coefficient=0.5 | 0.6")):
    status, _, error = run(*words, "--reproduce", "here/results/summary.json")
    refused("with parameters", status, error,
            "--reproduce takes the parameters beside the summary; give it without a file of "
            "parameters and other options than --quiet.")
status, _, error = run("--reproduce", "here/results/summary.json", env={"TMPDIR": "/proc"})
refused("no place for files", status, error,
        "No directory can be made in '/proc'; set TMPDIR to one that can be written to.")

print("FAILED: " + ", ".join(fails) if fails else "OK")
sys.exit(bool(fails))
