"""What the tests of the module of Python share."""
import csv
import subprocess
import sys

import numpy as np

SOURCE, PROGRAM = sys.argv[1:]


def expect(what, condition):
    if not condition:
        sys.exit(f"{what}: not as expected")


def raised(kind, message, action):
    """Expect an exception with exactly this message."""
    try:
        action()
    except kind as error:
        return expect(f"{error!r} instead of {message!r}", str(error).strip("\"") == message)
    sys.exit(f"{message}: nothing was raised")


def run_program(scene, directory, *settings):
    """Run the program, which writes its results; the status is its own."""
    command = [PROGRAM, scene, "--quiet", "--set", f"Output directory={directory}"]
    for setting in settings:
        command += ["--set", setting]
    return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode


def table(file):
    """The columns of a table, as texts."""
    with open(file, newline="") as lines:
        rows = list(csv.reader(lines))
    return {name: list(values) for name, values in zip(rows[0], zip(*rows[1:]))}


def numbers(texts):
    return np.array([float(text) if text else np.nan for text in texts])
