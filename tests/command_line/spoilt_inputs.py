#!/usr/bin/env python3
"""Spoilt inputs are answered or refused: spoilt_inputs.py VOUSSOIR PROGRAM SOURCE [TARGET...]

What contrib/fuzz does with libFuzzer for hours is done here for a minute or two, under the
sanitizers of this build, with a number of inputs for each target that takes about as long.
"""
import os
import shutil
import subprocess
import sys
from pathlib import Path

VOUSSOIR, PROGRAM, SOURCE = (Path(word).resolve() for word in sys.argv[1:4])
WANTED = sys.argv[4:]
SEEDS = Path("spoilt/seeds").resolve()
# Inputs made of the good ones.
NUMBERS = {"run": 25, "earlier_run": 100, "prm": 60, "settings": 60, "json": 200, "xml": 200,
           "dxf": 1000, "wkt": 1000}
ELSE = 1000
# Leaks are those of foreign libraries, which contrib/sanitize looks for.
ENVIRONMENT = {"ASAN_OPTIONS": "detect_leaks=0:detect_container_overflow=0",
               "UBSAN_OPTIONS": "print_stacktrace=1", "OMP_NUM_THREADS": "1"}


def main():
    shutil.rmtree("spoilt", ignore_errors=True)
    SEEDS.parent.mkdir()
    subprocess.run([sys.executable, SOURCE / "contrib/fuzzing/seeds.py", VOUSSOIR, SEEDS],
                   check=True)
    targets = sorted(file.stem for file in SEEDS.iterdir())
    if len(targets) < 20:
        sys.exit(f"targets: {targets}")
    fails = []
    for target in WANTED or targets:
        scratch = SEEDS.parent / "scratch" / target
        scratch.mkdir(parents=True)
        shutil.copy(SEEDS.parent / "scene.prm", scratch)
        number = NUMBERS.get(target, ELSE)
        done = subprocess.run([PROGRAM, SEEDS / target, str(number)], cwd=scratch, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False,
                              env={**os.environ, **ENVIRONMENT, "VOUSSOIR_FUZZ_TARGET": target})
        if done.returncode != 0:
            fails.append(f"{target}: status {done.returncode}, with {scratch / 'input'}:\n"
                         + done.stdout[-5000:])
    print("\n".join(fails) or "OK")
    return bool(fails)


sys.exit(main())
