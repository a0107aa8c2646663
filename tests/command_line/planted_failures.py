#!/usr/bin/env python3
"""What the program does where a library fails under it:

    planted_failures.py VOUSSOIR LIBRARY SOURCE_DIRECTORY [MPIRUN ...] [--only WORDS]

The failures are planted from outside, by LIBRARY, which is loaded before all others; see
planted/plant.h. In each case below the run still has the right answer, which
contrib/check_proof finds right from its files alone, or it ends with one message and the
exit status that the table says, and leaves the results of an earlier run as they were.
"""
import json
import os
import re
import subprocess
import sys
import time
from hashlib import sha256
from pathlib import Path

PROGRAM, LIBRARY, TOP, *MPIRUN = sys.argv[1:]
ONLY = MPIRUN[MPIRUN.index("--only") + 1:] if "--only" in MPIRUN else []
MPIRUN = MPIRUN[:MPIRUN.index("--only")] if "--only" in MPIRUN else MPIRUN
RESULTS, MARK = Path("results"), Path("planted")
EARLIER = ("summary.json", "interfaces.csv", "cells.csv", "notes.txt")

COULOMB = ("Friction/Law=associated Coulomb", "Friction/Coefficient=0.6")
WALL = ("Rotations=true", "Packing/Generator=wall", "Packing/wall/Courses=5",
        "Packing/wall/Bricks per course=4", "Supports/Where=y < 1e-9",
        "Loads/Body force=0; -1", *COULOMB)
CELLS = ("Packing/Generator=Voronoi", "Packing/Voronoi/Number of points=30",
         "Supports/Where=y < 1e-9", "Loads/Body force=0; -1", "Friction/Strength=3")
MANY = ("Packing/Voronoi/Number of points=3000", "Accuracy=draft",
        "Solver/least energy/Linear solver=direct")
BRICKS = ("Dimension=3", "Rotations=true", "Packing/Generator=wall",
          "Packing/wall/Length=1", "Packing/wall/Height=0.3", "Supports/Where=z < 1e-9",
          "Loads/Body force=0; 0; -1", "Accuracy=draft", *COULOMB)
FACTOR = ("Analysis=load factor", "Live loads/Body force=1; 0")
SCENES = {
    "least energy": (*CELLS, "Formulation=least energy"),
    "many cells": (*CELLS, *MANY, "Formulation=least energy"),
    "multigrid": (*CELLS, "Formulation=least energy",
                  "Solver/least energy/Linear solver=multigrid"),
    "stress": (*CELLS, "Formulation=least energy", "Accuracy=fine"),
    "any state": WALL,
    "collapse": (*WALL, "Loads/Body force=2; -1"),
    "smoothed": (*CELLS, "Formulation=smoothed friction"),
    "hard": (*CELLS, "Formulation=smoothed friction",
             "Solver/smoothed friction/Contact=hard"),
    "programme": (*CELLS, "Formulation=linear program"),
    "centre": (*CELLS, "Formulation=analytic centre"),
    "factor": (*WALL, *FACTOR),
    "Coulomb": (*WALL, *FACTOR, "Friction/Law=Coulomb"),
    "strength": (*CELLS, "Analysis=load factor", "Load factor/Factor=strength"),
    "ranges": (*WALL, "Ranges/Where=1"),
    "samples": (*WALL, "Ranges/Samples=100"),
    "settlement": (*WALL, "Supports/Displacement=if(x < 0.5, 0.01, 0); 0"),
    "capacity": ("Rotations=true", "Analysis=capacity", "Packing/Generator=wall",
                 "Packing/wall/Courses=3", "Packing/wall/Bricks per course=1",
                 "Packing/wall/Height=3", "Supports/Where=y < 1e-9",
                 "Loads/Body force=0; -1", "Live loads/Body force=1; 0",
                 "Capacity/Point=0.5, 2.5", *COULOMB),
    "space": BRICKS,
    "space, factor": (*BRICKS, "Analysis=load factor", "Live loads/Body force=1; 0.3; 0"),
    "space, ranges": (*BRICKS, "Ranges/Where=1"),
    "space, stress": (*BRICKS, "Accuracy=fine"),
    "drawing": ()}
FILES = {"drawing": str(Path(TOP, "prm", "portal.prm"))}


class Answer:
    """The run has the answer that it has without the failure."""
    status = 0


class Collapse(Answer):
    status = 3


class Message:
    """It ends with this status, and with these words in the one message."""
    def __init__(self, status, words):
        self.status, self.words = status, words


FAILED = "The program, or a library that it uses, has failed by "
ANSWER, COLLAPSE = Answer(), Collapse()
ABORT = Message(4, FAILED + "abort(); nothing was written")
FAULT = Message(4, FAILED + "an invalid address (SIGSEGV)")
EXIT = Message(4, FAILED + "exit()")
NO_WORDS = Message(4, "an exception without words")
MEMORY = Message(4, "There is not enough memory for this packing.")
SYSTEM = Message(4, "A linear system of Newton's method cannot be solved")
STATUS = Message(4, "CHOLMOD, which solves the linear systems, has failed with the status")
NO_STATE = Message(4, "Neither forces that carry the loads nor a mechanism were found")
NO_FACTOR = Message(4, "The load factor was not found")
CLP = Message(4, "Clp, which solves the linear programmes of all states, has failed.")
NOT_PROVEN = Message(4, "The greatest value of a force is not proven")
NO_ANSWER = Message(4, "A linear programme of all states has no answer")
REJECTED = Message(4, "without forces that balance the load: the certificate finds")
BEFORE = Message(4, "before its first iteration. Try 'Formulation = least energy'")
NO_GDAL = Message(2, "GDAL, which reads all polygons but .wkt and .off, cannot be loaded")
DIRECTORY = Message(2, "The output directory 'results' cannot take the results")
NO_THREAD = Message(4, "The program cannot begin")
MPI = Message(4, "MPI, which Ipopt and multigrid need, cannot begin")
CASES = [
    # CHOLMOD: what its calls return, and what comes out of them.
    ("least energy", "cholmod_factorize:2:abort", ABORT),
    ("least energy", "cholmod_factorize:2:fault", FAULT),
    ("least energy", "cholmod_factorize:2:exit", EXIT),
    ("least energy", "cholmod_factorize:2:throw_int", NO_WORDS),
    ("least energy", "cholmod_factorize:2:status=-4", STATUS),
    ("least energy", "cholmod_factorize:2+:status=1", SYSTEM),
    ("least energy", "cholmod_factorize:2+:nan", SYSTEM),
    ("least energy", "cholmod_factorize:2+:wrong", ANSWER),
    ("least energy", "cholmod_analyze:1:null", MEMORY),
    ("least energy", "cholmod_analyze_p:1:status=-4", STATUS),
    ("least energy", "cholmod_allocate_sparse:1:null", MEMORY),
    ("least energy", "cholmod_solve:3:nan", ANSWER),
    ("least energy", "cholmod_solve:4:inf", ANSWER),
    ("least energy", "cholmod_solve:1+:wrong", ANSWER),
    ("least energy", "cholmod_solve:1+:zero", SYSTEM),
    ("least energy", "cholmod_solve:2:null", MEMORY),
    ("centre", "cholmod_solve:2:nan", ANSWER),
    ("any state", "cholmod_solve:4:nan", ANSWER),
    ("any state", "cholmod_factorize:3+:nan", NO_STATE),
    ("collapse", "cholmod_solve:1+:wrong", COLLAPSE),
    ("collapse", "cholmod_factorize:2+:nan", NO_STATE),
    ("factor", "cholmod_solve:5:nan", ANSWER),
    ("factor", "cholmod_solve:1+:wrong", ANSWER),
    ("factor", "cholmod_factorize:4+:status=1", NO_FACTOR),
    ("Coulomb", "cholmod_solve:9:nan", ANSWER),
    ("strength", "cholmod_solve:6:nan", NO_FACTOR),
    ("capacity", "cholmod_solve:7:nan", ANSWER),
    ("space", "cholmod_solve:2:nan", ANSWER),
    ("space", "cholmod_factorize:1:abort", ABORT),
    ("space, factor", "cholmod_solve:5:wrong", ANSWER),
    ("space, factor", "cholmod_factorize:5+:nan", NO_FACTOR),
    # BLAS and LAPACK, below CHOLMOD and for the stress.
    ("many cells", "dpotrf:1:nan", ANSWER),
    ("many cells", "dpotrf:1+:info=1", SYSTEM),
    ("many cells", "dtrsm:5:inf", ANSWER),
    ("many cells", "dgemm:2:abort", ABORT),
    ("many cells", "dsyrk:3+:wrong", SYSTEM),
    ("space, stress", "dgetrf:1:nan", ANSWER),
    # Clp.
    ("ranges", "primal:1:abort", CLP),
    ("ranges", "primal:3:fault", CLP),
    ("ranges", "primal:2:exit", CLP),
    ("ranges", "primal:2:error", ANSWER),
    ("ranges", "primal:2:throw_int", ANSWER),
    ("ranges", "primal:2+:throw", NO_ANSWER),
    ("ranges", "primal:2:bad_alloc", MEMORY),
    ("ranges", "primal:3:nan", ANSWER),
    ("ranges", "primal:3+:wrong", NOT_PROVEN),
    ("ranges", "primal:3+:no_multipliers", NOT_PROVEN),
    ("ranges", "primal:3:status=1", ANSWER),
    ("ranges", "primal:3+:status=3", NO_ANSWER),
    ("ranges", "primal:3:status=2", NO_ANSWER),
    ("ranges", "dual:1:status=1", ANSWER),
    ("samples", "primal:3+:wrong", NOT_PROVEN),
    ("settlement", "primal:1+:nan", NOT_PROVEN),
    ("space, ranges", "cholmod_solve:40+:wrong", NOT_PROVEN),
    # Ipopt, and MUMPS below it.
    ("smoothed", "IpoptApplicationFactory:1:abort", ABORT),
    ("smoothed", "IpoptApplicationFactory:1:throw", Message(4, "a planted exception")),
    ("smoothed", "solve:1:throw_int", NO_WORDS),
    ("smoothed", "solve:1:at_once=-10", BEFORE),
    ("smoothed", "solve:1:at_once=0", BEFORE),
    ("smoothed", "solve:1:at_once=-102", MEMORY),
    ("smoothed", "solve:1:wrong", ANSWER),
    ("programme", "solve:1:nan", REJECTED),
    ("programme", "solve:1:wrong", REJECTED),
    ("programme", "solve:1:no_unknowns", ANSWER),
    ("programme", "solve:1:no_multipliers", REJECTED),
    ("hard", "solve:1:no_unknowns", REJECTED),
    ("hard", "solve:1:no_multipliers", ANSWER),
    ("hard", "solve:1:nan", REJECTED),
    ("hard", "dmumps_factorise:3+:status=-13", ANSWER),
    ("hard", "dmumps_solve:3:nan", ANSWER),  # by its second start
    ("hard", "dmumps_solve:3+:nan", REJECTED),
    ("programme", "dmumps_factorise:3+:status=-13", ANSWER),
    ("programme", "dmumps_solve:3:nan", ANSWER),
    ("programme", "dmumps_solve:2+:wrong", ANSWER),
    ("programme", "dmumps_factorise:3:abort", ABORT),
    # GDAL.
    ("drawing", "dlopen_gdal:1:none", NO_GDAL),
    ("drawing", "dlsym_gdal:5:none", NO_GDAL),
    ("drawing", "GDALOpenEx:1:null", Message(2, "is of none of the formats that are read")),
    ("drawing", "GDALOpenEx:1:abort", ABORT),
    ("drawing", "GDALAllRegister:1:exit", EXIT),
    # A feature is read three times, with GDAL's chords of its arcs, with few and with many.
    ("drawing", "OGR_F_GetGeometryRef:4:null", Message(2, "has no geometry; delete it.")),
    ("drawing", "OGR_F_GetGeometryRef:2:null", ANSWER),
    ("drawing", "OGR_G_GetPointCount:1+:zero", Message(2, "has no points")),
    ("drawing", "OGR_G_GetX:2:nan", Message(2, "coordinates must be finite")),
    ("drawing", "OGR_G_GetX:7:nan", ANSWER),
    # The system: memory, threads, files.
    ("many cells", "malloc:10:none@100000", MEMORY),
    ("many cells", "malloc:2+:none@500000", MEMORY),
    ("any state", "pthread_create:2:none", NO_THREAD),
    ("any state", "pthread_create:3+:none", ANSWER),
    ("any state", "writev:1+:full", DIRECTORY),
    ("any state", "rename:1:full", DIRECTORY),
    ("any state", "rename:3:full", DIRECTORY),
    ("any state", "mkdtemp:2:full", DIRECTORY),
    # MPI, of one process and of two, of which the second one fails.
    ("multigrid", "MPI_Init_thread:1:error", MPI),
    ("multigrid", "MPI_Init_thread:1:abort", ABORT)]
CASES_OF_TWO = [
    ("many cells", "cholmod_factorize:1:abort", ABORT),
    ("many cells", "MPI_Allreduce:9:exit", EXIT),
    ("many cells", "MPI_Init_thread:1:fault", FAULT),
    ("many cells", "cholmod_solve:1:nan", ANSWER),
    ("many cells", "cholmod_factorize:1:bad_alloc", MEMORY),
    ("many cells", "cholmod_factorize:1:throw_int", Message(4, "A library has failed."))]
fails = []


def command(scene):
    Path("empty.prm").write_text("", encoding="utf-8")
    words = [PROGRAM, FILES.get(scene, "empty.prm")]
    for setting in (*SCENES[scene], "Output directory=results"):
        words += ["--set", setting]
    return words


def run(scene, planted="", processes=1):
    planted, _, size = planted.partition("@")
    words = ["env", f"LD_PRELOAD={LIBRARY}", f"PLANT={planted}", f"PLANT_MARK={MARK}",
             *([f"PLANT_SIZE={size}"] if size else []),
             *(["PLANT_RANK=1"] if processes > 1 else []), *command(scene)]
    return subprocess.run([*(MPIRUN if processes > 1 else []), *words], text=True,
                          errors="replace", capture_output=True, timeout=200, check=False)


def earlier_results():
    """What is there before a run; and nothing else."""
    subprocess.run(["rm", "-rf", RESULTS], check=True)
    RESULTS.mkdir()
    for name in EARLIER:
        (RESULTS / name).write_text("earlier", encoding="utf-8")


def contents():
    """But for what shows the faults of a drawing."""
    return {str(file): sha256(file.read_bytes()).hexdigest() if file.is_file() else "directory"
            for file in RESULTS.rglob("*") if not file.name.startswith("drawing_check.")}


def numbers_of(summary):
    """Those that do not depend on which of many states is taken."""
    factor = summary.get("load_factor") or {}
    return {name: factor[name] for name in ("carried", "bound") if name in factor}


def files_with_nan():
    return [file.name for file in RESULTS.rglob("*") if file.suffix in (".csv", ".json")
            and re.search(r"(?i)(?<![a-z_])-?nan(?![a-z_])", file.read_text("utf-8"))]


def faults_of_answer(scene, without):
    faults = [f"nan in {name}" for name in files_with_nan()]
    proof = subprocess.run([sys.executable, str(Path(TOP, "contrib", "check_proof")), RESULTS],
                           text=True, capture_output=True, check=False)
    if proof.returncode != 0:
        faults.append(proof.stdout + proof.stderr)
    found = json.loads((RESULTS / "summary.json").read_text("utf-8"))
    if found["status"] != without["status"]:
        faults.append(f"{found['status']!r} instead of {without['status']!r}")
    # Without dilatancy no theorem says that the search ends at the same factor.
    tolerance = 1e-3 if scene == "Coulomb" else 1e-6
    for name, value in numbers_of(without).items():
        if not abs(numbers_of(found)[name] - value) <= tolerance * abs(value):
            faults.append(f"{name}: {numbers_of(found)[name]} instead of {value}")
    return faults


def faults_of_end(outcome, wanted):
    """The libraries may say more, before the message."""
    lines = [line for line in outcome.stderr.splitlines() if line.startswith("voussoir:")
             and "Interrupted by SIGTERM" not in line]  # by mpirun
    faults = [] if len(lines) == 1 else [f"{len(lines)} messages"]
    if wanted.words not in " ".join(outcome.stderr.split()):
        faults.append(f"without {wanted.words!r}")
    if re.search(r"terminate called|Signal: |\[ *[0-9]+\] .*\.so|backtrace", outcome.stderr):
        faults.append("a trace of the stack")
    return faults


def check(scene, planted, wanted, processes=1):
    if ONLY and not any(word in f"{scene} {planted}" for word in ONLY):
        return
    if scene not in ANSWERS:
        earlier_results()
        whole = run(scene)
        if whole.returncode not in (0, 3):
            sys.exit(f"{scene}: {whole.stderr}")
        ANSWERS[scene] = json.loads((RESULTS / "summary.json").read_text("utf-8"))
    earlier_results()
    MARK.unlink(missing_ok=True)
    before, begin = contents(), time.monotonic()
    outcome = run(scene, planted, processes)
    seconds = time.monotonic() - begin
    faults = [] if MARK.exists() else ["nothing has failed"]
    if outcome.returncode != wanted.status:
        faults.append(f"the exit status {outcome.returncode}, not {wanted.status}")
    elif isinstance(wanted, Answer):
        faults += faults_of_answer(scene, ANSWERS[scene])
    if isinstance(wanted, Message):
        faults += faults_of_end(outcome, wanted)
    if outcome.returncode not in (0, 3) and contents() != before:
        faults.append("the earlier results are others")
    print(f"{'WRONG' if faults else 'OK':5} {seconds:5.1f} s  {scene}: {planted}", flush=True)
    if faults:
        fails.append(planted)
        print(*faults, outcome.stderr[-2000:], sep="\n", flush=True)


ANSWERS = {}
os.environ.pop("LD_PRELOAD", None)
for case in CASES:
    check(*case)
for case in CASES_OF_TWO if MPIRUN else []:
    check(*case, processes=2)
print(f"{len(CASES) + len(CASES_OF_TWO)} failures, {len(fails)} of them not as they should be")
sys.exit(bool(fails))
