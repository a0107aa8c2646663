#!/usr/bin/env python3
"""What README.md and the tutorial quote is what the program prints:

    quotations.py VOUSSOIR TOP DIRECTORY OF THE PROJECT

Numbers are compared to five digits, and those below 1e-9 count as zero: they are
rounding.
"""
import csv
import re
import subprocess
import sys
from pathlib import Path

NUMBER = re.compile(r"-?\d+\.?\d*(e[-+]?\d+)?")


def rounded(text):
    def five_digits(number):
        value = float(number.group())
        return f"{0 if abs(value) < 1e-9 else value:.5g}"
    text = re.sub(r"written to [^;]*;", "written to ...;", text)
    return NUMBER.sub(five_digits, text)


def quotation(page, begin):
    """The indented block of a page that begins so, without the indentation."""
    found = re.search(rf"^    {begin}.*(?:\n(?:    .*|)$)*", page, re.MULTILINE)
    if not found:
        sys.exit(f"no block begins with '{begin}'")
    lines = [line[4:] for line in found.group().splitlines()]
    return "\n".join(lines).rstrip() + "\n"


def run(program, file, *settings):
    words = [program, str(file), "--set", "Output directory=quotations"]
    for setting in settings:
        words += ["--set", setting]
    return subprocess.run(words, capture_output=True, text=True)


def expect(what, found, quoted, ended=None):
    """With how the run ended, if it is of one."""
    if found != quoted:
        print(f"{what} is quoted as\n{quoted}\nand is\n{found}")
        if ended:
            print(f"The exit status is {ended.returncode}, and standard error\n{ended.stderr}")
        sys.exit(1)


def expect_samples(program, scene, tutorial):
    """
    The samples in the tutorial. A walk that is reflected over and over follows the last
    digits of a machine's functions: means must agree within four errors of their difference,
    errors and spreads within a quarter.
    """
    ended = run(program, scene, "Ranges/Samples=1000")
    line = re.compile(r"Samples +(\d+) of all states, a set of (\d+) dimensions, \d+ steps "
                      r"apart, worth at least (\d+) independent ones; standard error of a mean "
                      r"at most ([\d.]+)\n")
    printed, quoted = (line.search(text) for text in
                       (ended.stdout, quotation(tutorial, "Samples        2000 of all")))
    if not printed or not quoted:
        sys.exit(f"samples are not quoted as printed:\n{ended.stdout}{ended.stderr}")
    expect("the samples in the tutorial", printed.group(1, 2), quoted.group(1, 2), ended)
    expect("what they are worth", int(printed.group(3)) >= 1000, True)
    expect("what they are quoted to be worth", int(quoted.group(3)) >= 1000, True)
    expect("their largest error",
           abs(float(printed.group(4)) / float(quoted.group(4)) - 1) < 0.25, True)
    quoted = re.findall(r"^(\S+) to (\S+): (\S+) kN \+- (\S+), give or take (\S+)$",
                        quotation(tutorial, r"0.00 to 0.50: .* give or take"), re.MULTILINE)
    with open("quotations/interfaces.csv") as file:
        found = [joint for joint in csv.DictReader(file) if joint["cell_plus"] == "-1"]
    expect("the number of means in the tutorial", len(quoted), len(found))
    for (start, end, mean, error, deviation), joint in zip(quoted, found):
        expect("the place", (start, end), (f"{float(joint['x0']):.2f}", f"{float(joint['x1']):.2f}"))
        own_error = float(joint["p_mean_error"])
        difference = abs(float(joint["p_mean"]) - float(mean))
        expect(f"{joint['p_mean']} as {mean}", difference < 0.05 + 4 * 2**0.5 * own_error, True)
        expect(f"{own_error} as {error}", abs(own_error - float(error)) < 0.05 + own_error / 4,
               True)
        own_deviation = float(joint["p_deviation"])
        expect(f"{own_deviation} as {deviation}",
               abs(own_deviation / float(deviation) - 1) < 0.25, True)


def main(program, top):
    readme = (top / "README.md").read_text("utf-8")
    tutorial = (top / "doc/tutorial.md").read_text("utf-8")
    scene = top / "prm/tutorial_wall.prm"
    expect("prm/tutorial_wall.prm", scene.read_text("utf-8"),
           quotation(tutorial, "# A wall with a door"))
    for name, page, file in (("README.md", readme, top / "prm/shear_wall.prm"),
                             ("the tutorial", tutorial, scene)):
        ended = run(program, file)
        expect(f"the output in {name}", rounded(ended.stdout),
               rounded(quotation(page, "Packing  ")), ended)

    turning = "Rotations=true"
    ended = run(program, scene, turning)
    expect("the end of the output with rotations in the tutorial",
           rounded("\n".join(ended.stdout.splitlines()[-3:]) + "\n"),
           rounded(quotation(tutorial, "Friction       largest utilisation 0.45")), ended)

    push = "Loads/Body force=4; -20"
    ended = run(program, scene, push, "Friction/Strength=10.09")
    expect("the collapse in the tutorial", rounded(ended.stderr),
           rounded(quotation(tutorial, "voussoir: The load is not carried")), ended)
    # Its answers: no friction is needed under weight, 10.1 with the push, and the
    # pushes with which it overturns, slides and rocks, and only slides.
    strong = "Friction/Strength=1000"
    for settings, status in ((("Friction/Strength=0",), 0),
                             ((turning, strong, "Loads/Body force=13.42; -20"), 0),
                             ((turning, strong, "Loads/Body force=13.5; -20"), 3),
                             ((turning, "Loads/Body force=7.7; -20"), 0),
                             ((turning, "Loads/Body force=7.71; -20"), 3),
                             (("Loads/Body force=7.92; -20",), 0),
                             (("Loads/Body force=7.921; -20",), 3),
                             ((turning, push, "Friction/Strength=10.1001"), 0),
                             ((turning, push, "Friction/Strength=10.0999"), 3),
                             ((push, "Friction/Strength=10.1001"), 0),
                             ((push, "Friction/Strength=10.0999"), 3)):
        ended = run(program, scene, *settings)
        expect(f"the status with {settings}", ended.returncode, status, ended)
    ended = run(program, scene, "Ranges/Where=1", "Ranges/Reactions=true")
    expect("the ranges in the tutorial",
           [line for line in ended.stdout.splitlines() if line.startswith("Ranges")][-1:],
           quotation(tutorial, "Ranges         forces of").splitlines(), ended)
    with open("quotations/interfaces.csv") as file:
        found = [f"{float(joint['x0']):.2f} to {float(joint['x1']):.2f}: "
                 f"{-float(joint['normal_force']):.1f} kN, between "
                 f"{float(joint['p_min']):.1f} and {float(joint['p_max']):.1f}"
                 for joint in csv.DictReader(file) if joint["cell_plus"] == "-1"]
    expect("the forces on the ground in the tutorial", found,
           quotation(tutorial, "0.00 to 0.50").splitlines())
    expect_samples(program, scene, tutorial)
    own = readme[readme.index("## Write your own scene"):]
    Path("readme.prm").write_text(quotation(own, "set Output directory"), "utf-8")
    ended = run(program, "readme.prm")
    expect("the status of the scene in README.md", ended.returncode, 0, ended)
    print("The quotations are right")


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]))
