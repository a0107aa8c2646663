#!/usr/bin/python3
"""Measure what the settings of voussoir cost and how accurate they are.

Writes DIR/accuracy.md, a page of advice, tables and plots, with the tables in
DIR/accuracy/*.csv and the plots in DIR/images/accuracy_*.png. The program must
have been built; contrib/study does that first. The full study takes an hour.
"""
import argparse
import os
import pathlib
import re
import sys

TOP = pathlib.Path(__file__).resolve().parents[2]
try:
    import features
    import forces
    import page
    import stress
    import tables
    from runs import Bench
except ImportError as error:
    packages = re.findall(r"^([^#\s]\S*)\s.*\bbenchmark\b",
                          (TOP / "contrib/packages.txt").read_text(), re.M)
    sys.exit(f"study.py: {error}; install the packages {' '.join(packages)} "
             "and run it with /usr/bin/python3.")

EXPERIMENTS = {"formulations": forces.formulations,
               "tolerance": forces.tolerance,
               "barrier": forces.barrier,
               "reconstruction": stress.reconstruction,
               "rigidity": forces.rigidity,
               "features": features.features}


def arguments():
    """The options of the command line."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    names = list(EXPERIMENTS)
    parser.add_argument("--program", type=pathlib.Path,
                        default=TOP / "build/release/voussoir")
    parser.add_argument("--quick", action="store_true",
                        help="small sizes: does the study run at all?")
    parser.add_argument("--repeats", type=int,
                        help="of each run: 5, or 1 with --quick")
    parser.add_argument("--only", type=lambda text: text.split(","),
                        default=names, metavar="NAME[,NAME]",
                        help="of " + ", ".join(names) +
                        ";\nthe page takes the others from their tables")
    parser.add_argument("--page-only", action="store_true",
                        help="make the page from the tables")
    parser.add_argument("--output", type=pathlib.Path, metavar="DIR",
                        help="default: doc/, or build/study/ with --quick")
    options = parser.parse_args()
    options.output = options.output or TOP / (
        "build/study" if options.quick else "doc")
    options.repeats = options.repeats or (1 if options.quick else 5)
    for name in set(options.only) - set(names):
        parser.error(f"there is no experiment '{name}'")
    if not options.page_only and not options.program.exists():
        parser.error(f"there is no program {options.program}; build it with "
                     "contrib/run")
    return options


def processor():
    """The name of the processor."""
    found = re.search(r"model name\s*: (.*)",
                      pathlib.Path("/proc/cpuinfo").read_text())
    return found[1] if found else "unknown"


def note(directory, name, options, version):
    """Put how an experiment was measured in measured.csv."""
    path = directory / "measured.csv"
    others = [row for row in tables.read(path) if row["experiment"] != name]
    command = "contrib/study" + " --quick" * options.quick
    if options.repeats != (1 if options.quick else 5):
        command += f" --repeats {options.repeats}"
    if len(options.only) < len(EXPERIMENTS):
        command += f" --only {','.join(options.only)}"
    tables.write(path, others + [{
        "experiment": name, "repeats": options.repeats, "command": command,
        "processor": processor(), "cores": os.cpu_count(),
        "program": f"voussoir {version}"}])


def main():
    options = arguments()
    directory = options.output / "accuracy"
    if not options.page_only:
        with Bench(options.program.resolve(), options.repeats,
                   options.quick) as bench:
            for name in options.only:
                rows = EXPERIMENTS[name](bench)
                tables.write(directory / f"{name}.csv", rows)
                note(directory, name, options, bench.version)
    print(f"The page is {page.write(options.output)}")


if __name__ == "__main__":
    main()
