#!/usr/bin/env python3
"""What the load factor of Coulomb's friction without dilatancy says of itself:

    without_dilatancy.py VOUSSOIR

The factors that summary.json calls tried have states, or none, if they are asked
for one by one; the terminal and the report say what is proven and what is not.
"""
import json
import subprocess
import sys
from html import unescape
from pathlib import Path

PROGRAM = sys.argv[1]
SCENE = """set Output directory = without_dilatancy
set Rotations = true
set Accuracy = draft
subsection Packing
  set Generator = Voronoi
  subsection Voronoi
    set Number of points = 24
    set Seed = 2
    set Lloyd steps = 5
    set Upper right = 0.66, 0.9
  end
end
subsection Supports
  set Where = y < 1e-9
end
subsection Loads
  set Traction = 0; -0.7
  set Where = y > 0.9 - 1e-9
  set Body force = 0; -1
end
subsection Live loads
  set Traction = 0.1; -0.31
  set Where = y > 0.9 - 1e-9
end
subsection Friction
  set Law = Coulomb
  set Coefficient = 0.675
end
subsection Output
  set Report = true
end
"""
RESULTS = Path("without_dilatancy")


def expect(what, holds, found=""):
    print(f"{what}: {'OK' if holds else 'FAILED'}", flush=True)
    if not holds:
        sys.exit(f"{what}: {found!r}")


def run(*settings):
    words = [word for setting in settings for word in ("--set", setting)]
    return subprocess.run([PROGRAM, "without_dilatancy.prm", *words],
                          capture_output=True, text=True)


def state_at(factor):
    """The exit status of the state at a factor."""
    return run(f"Loads/Traction={0.1 * factor!r}; {-0.7 - 0.31 * factor!r}",
               "Output/Files=none", "Output/Report=false").returncode


def main():
    Path("without_dilatancy.prm").write_text(SCENE)
    found = run("Analysis=load factor")
    expect("a factor is found", found.returncode == 0, found.stderr)
    factor = json.loads((RESULTS / "summary.json").read_text())["load_factor"]
    carried, tried = factor["carried"], factor["tried"]
    with_state, without = tried["with_state"], tried["without_state"]
    expect("it is the greatest with a state", carried == with_state[-1])
    expect("factors are in order", with_state == sorted(with_state) and
           without == sorted(without) and carried < factor["bound"])
    smaller = [x for x in without if x < carried]
    expect("others were tried, up to the bound", len(with_state) > 4 and
           max(without) > 0.999 * factor["bound"])

    meaning = factor["meaning"]
    expect("it is called a collapse",
           "is a collapse without dilatancy" in meaning, meaning)
    n = len(smaller) + sum(x < carried for x in with_state)
    said = f"and the {n} smaller factors tried have states" if not smaller \
        else "but states are known up to"
    expect("what was tried is counted", said in meaning, meaning)
    for words in ("of others nothing is known", "collapses, with it or without,"
                  " which is proven"):
        expect(words, words in meaning, meaning)
    expect("the terminal has it", meaning in found.stdout, found.stdout)
    page = unescape((RESULTS / "report.html").read_text())
    expect("the report has it", meaning in page)

    own = factor["own_collapse"]
    expect("its mechanism is the one that is written",
           abs(own["factor"] - carried) < 1e-6 * carried and
           own["closing_violation"] < 1e-11 and
           (RESULTS / "mechanism.csv").exists(), own)

    # Close to the limit a state may be found or not, and where states end.
    far = [x for x in with_state if x < 0.9 * carried and
           not any(0.9 * end < x < end for end in without)][1:]
    expect("what has a state has it by itself", far and
           all(state_at(x) == 0 for x in far), [state_at(x) for x in far])
    beyond = [x for x in without if x > 1.2 * carried]
    expect("what has none has none", beyond and
           all(state_at(x) == 4 for x in beyond),
           [state_at(x) for x in beyond])
    expect("beyond the bound is a collapse",
           state_at(1.01 * factor["bound"]) == 3)


main()
