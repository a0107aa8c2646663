#!/usr/bin/env python3
"""Compare the time of the formulations, forces only, on random Voronoi cells.

    contrib/benchmarks/formulations.py [CELLS [STRESS]]

runs build/release/voussoir, built by contrib/run, once with each formulation on
CELLS cells (100000) under the uniform STRESS ("-1.2, 0; 0, -0.8") with the
strength 0.3, and prints a table: seconds, their ratio to those of smoothed
friction with hard contact in the same run, and the certificate.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

TOP = pathlib.Path(__file__).resolve().parents[2]
SCENE = """
set Output directory = {directory}
set Formulation = {formulation}
set Accuracy = draft
subsection Packing
  set Generator = Voronoi
  subsection Voronoi
    set Number of points = {cells}
  end
end
subsection Loads
  set Boundary load = uniform stress
  set Stress = {stress}
end
subsection Friction
  set Strength = 0.3
end
subsection Solver
  subsection {formulation}
    {setting}
  end
end
"""
REFERENCE = ("smoothed friction", "set Contact = hard")
FORMULATIONS = [
    REFERENCE,
    ("smoothed friction", "set Contact = compliant"),
    ("linear program", ""),
    ("least energy", ""),
    ("analytic centre", "set Barrier weights = edge area"),
    ("analytic centre", "set Barrier weights = equal"),
]


def run(formulation, setting, cells, stress):
    """The summary of one run, or None if the load is not carried."""
    with tempfile.TemporaryDirectory() as directory:
        scene = pathlib.Path(directory) / "scene.prm"
        scene.write_text(SCENE.format(
            directory=directory + "/results", formulation=formulation,
            setting=setting, cells=cells, stress=stress))
        program = TOP / "build" / "release" / "voussoir"
        status = subprocess.run([program, scene], stdout=subprocess.DEVNULL,
                                check=False).returncode
        if status not in (0, 3):
            sys.exit(f"voussoir ended with status {status}")
        return json.loads((scene.parent / "results/summary.json").read_text())


def main():
    cells = int(sys.argv[1]) if len(sys.argv) > 1 else 100000
    stress = sys.argv[2] if len(sys.argv) > 2 else "-1.2, 0; 0, -0.8"
    print(f"{cells} random cells, stress {stress}, strength 0.3")
    print("seconds  ratio  iterations  status    residual  violation  "
          "formulation")
    reference = None
    for formulation, setting in FORMULATIONS:
        summary = run(formulation, setting, cells, stress)
        seconds = summary["timings"]["statics"]
        reference = reference or seconds
        certificate = summary.get("certificate", {})
        print(f"{seconds:7.2f}  {seconds / reference:5.3f}  "
              f"{summary['solver']['iterations']:10d}  "
              f"{summary['status']:8s}  "
              f"{certificate.get('equilibrium_residual', 0):8.1e}  "
              f"{certificate.get('admissibility_violation', 0):9.1e}  "
              f"{formulation} {setting}", flush=True)


if __name__ == "__main__":
    main()
