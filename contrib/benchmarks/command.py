"""What the commands of the measurements share: options, and a note of how each
table was measured."""
import argparse
import dataclasses
import datetime
import os
import pathlib
import re
import subprocess

import tables

TOP = pathlib.Path(__file__).resolve().parents[2]


@dataclasses.dataclass
class Study:
    """A command: its name, the experiments by name, the directory of its
    tables, and how often each run is repeated by default."""
    command: str
    experiments: dict
    tables: str
    repeats: int
    quick_output: str

    def parser(self, description):
        """The options that all commands have."""
        parser = argparse.ArgumentParser(
            description=description,
            formatter_class=argparse.RawTextHelpFormatter)
        names = list(self.experiments)
        parser.add_argument("--program", type=pathlib.Path,
                            default=TOP / "build/release/voussoir")
        parser.add_argument("--quick", action="store_true",
                            help="small sizes: does it run at all?")
        parser.add_argument("--repeats", type=int, help="of each run: "
                            f"{self.repeats}, or 1 with --quick")
        parser.add_argument("--only", type=lambda text: text.split(","),
                            default=names, metavar="NAME[,NAME]",
                            help="of " + ", ".join(names) +
                            ";\nthe page takes the others from their tables")
        parser.add_argument("--page-only", action="store_true",
                            help="make the page from the tables")
        parser.add_argument("--output", type=pathlib.Path, metavar="DIR",
                            help="default: doc/, or "
                            f"{self.quick_output}/ with --quick")
        return parser

    def options(self, parser):
        """The options, checked."""
        options = parser.parse_args()
        options.output = options.output or TOP / (
            self.quick_output if options.quick else "doc")
        options.repeats = options.repeats or (
            1 if options.quick else self.repeats)
        for name in set(options.only) - set(self.experiments):
            parser.error(f"there is no experiment '{name}'")
        if not options.page_only and not options.program.exists():
            parser.error(f"there is no program {options.program}; build it "
                         "with contrib/run")
        return options

    def measure(self, options, bench, extra="", programs=()):
        """Write the tables of the chosen experiments; `extra` are further
        options of the command, and `programs` what else was measured."""
        programs = ", ".join([f"voussoir {bench.version}", *programs])
        directory = options.output / self.tables
        for name in options.only:
            tables.write(directory / f"{name}.csv",
                         self.experiments[name](bench))
            self.note(directory, name, options, extra, programs)

    def note(self, directory, name, options, extra, programs):
        """Put how an experiment was measured in measured.csv."""
        path = directory / "measured.csv"
        others = [{**row, "date": row.get("date", ""),
                   "commit": row.get("commit", "")}
                  for row in tables.read(path) if row["experiment"] != name]
        command = self.command + " --quick" * options.quick + extra
        if options.repeats != (1 if options.quick else self.repeats):
            command += f" --repeats {options.repeats}"
        if len(options.only) < len(self.experiments):
            command += f" --only {','.join(options.only)}"
        tables.write(path, others + [{
            "experiment": name, "repeats": options.repeats, "command": command,
            "processor": processor(), "cores": os.cpu_count(),
            "program": programs, "date": datetime.date.today().isoformat(),
            "commit": commit()}])


def measured_table(rows):
    """How the tables of a page were measured."""
    def text(name):
        return lambda row: str(row.get(name) or "-")
    columns = {"experiment": "experiment", "repeats": "repeats",
               "command": lambda row: f"`{row['command']}`",
               "processor": "processor", "cores": "cores",
               "programs": "program", "date": text("date"),
               "commit": text("commit")}
    return tables.listed(rows, columns, left=len(columns))


def commit():
    """The commit that is checked out, "?" if that is not known."""
    found = subprocess.run(["git", "-C", TOP, "rev-parse", "--short", "HEAD"],
                           capture_output=True, text=True)
    return found.stdout.strip() or "?"


def processor():
    """The name of the processor."""
    found = re.search(r"model name\s*: (.*)",
                      pathlib.Path("/proc/cpuinfo").read_text())
    return found[1] if found else "unknown"


def missing(script, error):
    """What to say if a module cannot be imported."""
    packages = re.findall(r"^([^#\s]\S*)\s.*\bbenchmark\b",
                          (TOP / "contrib/packages.txt").read_text(), re.M)
    return (f"{script}: {error}; install the packages {' '.join(packages)} "
            "and run it with /usr/bin/python3.")
