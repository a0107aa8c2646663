#!/usr/bin/env python3
"""The commands that the manual shows do what it shows beside them:

    quotations.py VOUSSOIR TOP DIRECTORY OF THE PROJECT [PAGE...]

Without pages: of README.md and all pages of doc/ but the tutorial. The blocks with commands are
run as they stand, one after the other, but for those in NOT_RUN. What is printed below a command,
in the same block or in one of its own, must be in its output, and the exit status must be what the
text behind says. Numbers are compared to five digits, and those below 1e-9 count as zero: they are
rounding.
"""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

NUMBER = re.compile(r"-?\d+\.?\d*(e[-+]?\d+)?")
# Commands that cannot be run here.
NOT_RUN = {
    r"git clone": "needs the address of the repository",
    r"sudo apt install": "changes the machine",
    r"cmake -S|make -C|cd build/debug && ctest": "builds the program, or the module of Python",
    r"cmake --install": "installs the module for the user",
    r"export PYTHONPATH=": "goes with them; the test python/examples runs what follows",
    r"xvfb-run -a pvbatch contrib/paraview/render.py|contrib/pictures$":
        "needs ParaView; the test output/pictures makes each kind of picture",
    r"mpirun -np 4": "takes a million cells; the tests mpi/ run on several processes",
    r"contrib/run FILE \[": "says what may follow",
    r"source <\(voussoir": "changes the shell; the test command_line/editors does it"}
# Blocks in the form of output that no command of the page prints.
NOT_PRINTED = {"voussoir: Interrupted by": "by a signal; the test command_line/interruption"}
# What stands in blocks with a language.
FENCED = {"doc/python.md": "the test python/examples runs it", "doc/citing.md": "for BibTeX",
          "doc/running.md": "a form; the test command_line/formats reads it"}
# Pages on which a block may also be a formula.
FORMULAS = ("doc/theory.md", "doc/selection.md", "doc/developers.md")
# How blocks begin: with a program,
PROGRAM = re.compile(r"(contrib/\w+|voussoir|awk|python3|cmake|make|git|sudo|export|mpirun|cd|"
                     r"xvfb-run|source)( |$)")
# a line of the output or a message on standard error,
OUTPUT = re.compile(r"voussoir: |(?=.{15}\S)[A-Z][a-z]+(?: [a-z]+)? {2,}")
# of samples: what is sampled, and the numbers,
SAMPLES = re.compile(r"Samples +(\d+ of all states, a set of \d+ dimensions), \d+ steps apart, worth "
                     r"at least (\d+) independent ones; standard error of a mean at most (\S+)$")
SAMPLED = re.compile(r"(.*): (\S+) kN \+- (\S+), give or take (\S+)$")
# or in a .prm file.
PARAMETERS = re.compile("set |subsection |#")
# Scenes that a page shows before it runs them, by how they begin.
SCENES = {"# A wall with a door": "my_wall.prm", "set Output directory": "my_packing.prm",
          "# A dome of stone": "my_dome.prm", "# A model of a dome": "my_model.prm"}
# FILE.prm of a page, and how the block that it also has begins.
ANY_SCENE = {"doc/running.md": ("prm/tutorial_wall.prm", None),
             "doc/scene.md": ("prm/tutorial_wall.prm", "set Analysis = load factor")}


class Block:
    """Indented lines of a page, and the text behind."""

    def __init__(self, page, number):
        self.place = f"{page}:{number}"
        self.lines = []
        self.text_behind = ""

    @property
    def first(self):
        return self.lines[0]

    def commands(self):
        """The lines up to an empty one; those that go on in the next are joined."""
        commands, unfinished = [], ""
        for line in self.lines[:self.lines.index("") if "" in self.lines else None]:
            unfinished += line + "\n"
            if not re.search(r"[\\|]$", line) and unfinished.count("'") % 2 == 0:
                commands.append(unfinished)
                unfinished = ""
        return commands

    def output(self):
        """What is printed below the commands."""
        return self.lines[self.lines.index("") + 1:] if "" in self.lines else []


def blocks_of(top, page):
    """In their order; those with a language are left out."""
    blocks, block, fenced, before = [], None, False, ""
    for number, line in enumerate((top / page).read_text("utf-8").splitlines(), 1):
        if line.startswith("```"):
            fenced = not fenced
            if fenced and page not in FENCED:
                sys.exit(f"{page}:{number}: a block with a language is not looked at; indent it")
        elif fenced:
            pass
        elif line.startswith("    ") and (block or not before):
            if not block:
                block = Block(page, number)
                blocks.append(block)
            block.lines.append(line[4:])
        elif not line and block:
            block.lines.append("")
        else:
            block = None
            if blocks:
                blocks[-1].text_behind += line + "\n"
        before = line
    for block in blocks:
        while not block.lines[-1]:
            block.lines.pop()
    return blocks


def is_run(command):
    return not any(re.match(pattern, command) for pattern in NOT_RUN)


def rounded(lines):
    def five_digits(number):
        value = float(number.group())
        return f"{0 if abs(value) < 1e-9 else value:.5g}"
    return [NUMBER.sub(five_digits, line) for line in lines]


class Shell:
    """Runs the commands of a page in a directory of its own, like a clone."""

    def __init__(self, program, top, page, blocks):
        self.top = top
        self.directory = Path("quotations") / Path(page).stem
        shutil.rmtree(self.directory, ignore_errors=True)
        for name in ("contrib", "bin"):
            (self.directory / name).mkdir(parents=True)
        for name in ("prm", "tests"):
            (self.directory / name).symlink_to(top / name)
        for name in ("contrib/run", "bin/voussoir"):
            (self.directory / name).write_text(f'#!/bin/sh\nexec {program} "$@"\n')
            (self.directory / name).chmod(0o755)
        checks = "contrib/check_proof"
        (self.directory / checks).symlink_to(top / checks)
        for block in blocks:
            for begin, name in SCENES.items():
                if block.first.startswith(begin):
                    (self.directory / name).write_text("\n".join(block.lines) + "\n", "utf-8")
        if page in ANY_SCENE:
            scene, begin = ANY_SCENE[page]
            more = [block.lines for block in blocks if begin and block.first.startswith(begin)]
            (self.directory / "FILE.prm").write_text(
                (top / scene).read_text("utf-8") + "\n".join(sum(more, [])) + "\n", "utf-8")
        self.printed = []

    def run(self, command):
        """Its exit status; what both streams have is in `printed`."""
        path = f"{(self.directory / 'bin').resolve()}:/usr/bin:/bin"
        ended = subprocess.run(["bash", "-c", command], capture_output=True,
                               text=True, cwd=self.directory,
                               env={**os.environ, "PATH": path, "LC_ALL": "C"})
        self.printed = ended.stdout.splitlines() + ended.stderr.splitlines()
        return ended.returncode


def expect(what, holds, quoted, found):
    if not holds:
        sys.exit("\n".join([f"{what} is quoted as", *quoted, "and is", *found]))


def expect_printed(place, quoted, printed, whole=False):
    """Quoted lines stand together in what is printed, or are all of it."""
    found, wanted = rounded(printed), rounded(quoted)
    n = len(wanted)
    expect(f"{place}: the output", found == wanted if whole else
           any(found[k:k + n] == wanted for k in range(len(found))), quoted, printed)


def expect_sampled(place, quoted, printed):
    """
    Samples, which are others where the last digits of a machine's functions are: a walk that is
    reflected over and over follows them. Means agree within four errors of their difference,
    errors and spreads within a quarter, and numbers of samples are worth the thousand asked for.
    """
    def agree(a, b):
        return abs(a - b) <= 0.05 + 0.25 * abs(b)

    forms = [form for form in (SAMPLES, SAMPLED) if form.match(quoted[0])]
    lines = [line for line in printed if forms and forms[0].match(line)]
    expect(f"{place}: the samples", len(lines) == len(quoted), quoted, printed)
    for line, wanted in zip(lines, quoted):
        (what, *found), (as_quoted, *numbers) = (
            forms[0].match(text).groups() for text in (line, wanted))
        found, numbers = [float(x) for x in found], [float(x) for x in numbers]
        if forms[0] is SAMPLES:
            holds = min(found[0], numbers[0]) >= 1000 and agree(found[1], numbers[1])
        else:
            holds = (abs(found[0] - numbers[0]) <= 0.05 + 4 * 2**0.5 * numbers[1]
                     and agree(found[1], numbers[1]) and agree(found[2], numbers[2]))
        expect(f"{place}: the samples", what == as_quoted and holds, [wanted], [line])


def expect_status(what, shell, command, status):
    found = shell.run(command)
    expect(what, found == status, [f"exit status {status}"],
           [f"exit status {found}", *shell.printed])


def check_commands(shell, block):
    """Run them; how many there were."""
    said = re.search(r"\bstatus (\d)", block.text_behind)
    printed = []
    commands = list(filter(is_run, block.commands()))
    for command in commands:
        status = int(said.group(1)) if said and command == commands[0] else 0
        expect_status(f"{block.place}: the end", shell, command, status)
        printed += shell.printed
    if block.output() and any(form.match(block.output()[0]) for form in (SAMPLES, SAMPLED)):
        expect_sampled(block.place, block.output(), printed)
    elif block.output():
        expect_printed(block.place, block.output(), printed,
                       whole=not re.match("contrib/(run|check_proof)|voussoir", commands[-1]))
    return len(commands)


def check_page(program, top, page):
    blocks = blocks_of(top, page)
    shell = Shell(program, top, page, blocks)
    n_run = 0
    for block in blocks:
        if PROGRAM.match(block.first):
            n_run += check_commands(shell, block)
        elif block.first.startswith(tuple(NOT_PRINTED)):
            pass
        elif OUTPUT.match(block.first):
            expect_printed(block.place, block.lines, shell.printed)
        elif not PARAMETERS.match(block.first) and page not in FORMULAS:
            sys.exit(f"{block.place}: neither commands nor their output nor parameters")
    print(f"{page}: {n_run} commands and their output are right")
    return shell


def check_lists(top):
    """What is in the lists of exceptions is somewhere in the manual."""
    pages = ["README.md", *(f"doc/{page.name}" for page in sorted((top / "doc").glob("*.md")))]
    firsts, commands = [], []
    for page in pages:
        for block in blocks_of(top, page):
            firsts.append(block.first)
            if PROGRAM.match(block.first):
                commands += block.commands()
    stale = [pattern for pattern in NOT_RUN if not any(re.match(pattern, c) for c in commands)]
    stale += [begin for begin in [*NOT_PRINTED, *SCENES]
              if not any(first.startswith(begin) for first in firsts)]
    expect("an exception", not stale, stale, ["nowhere in the manual"])
    return pages


def check_tutorial(shell):
    """What it says of runs that it does not show."""
    scene = (shell.top / "prm/tutorial_wall.prm").read_text("utf-8")
    shown = (shell.directory / "my_wall.prm").read_text("utf-8")
    expect("prm/tutorial_wall.prm", scene == shown, [shown], [scene])
    turning, strong = "Rotations=true", "Friction/Strength=1000"
    push = "Loads/Body force=4; -20"
    # No friction is needed under weight, 10.1 with the push; and the pushes with which it
    # overturns, slides and rocks, and only slides.
    for settings, status in (((turning, strong, "Loads/Body force=13.42; -20"), 0),
                             ((turning, "Loads/Body force=7.7; -20"), 0),
                             ((turning, "Loads/Body force=7.71; -20"), 3),
                             (("Loads/Body force=7.92; -20",), 0),
                             (("Loads/Body force=7.921; -20",), 3),
                             ((turning, push, "Friction/Strength=10.1001"), 0),
                             ((turning, push, "Friction/Strength=10.0999"), 3),
                             ((push, "Friction/Strength=10.1001"), 0),
                             ((push, "Friction/Strength=10.0999"), 3)):
        expect_status(f"the end with {settings}", shell,
                      "voussoir my_wall.prm " + " ".join(f"--set '{s}'" for s in settings), status)


def main(program, top, *pages):
    all_pages = check_lists(top)
    for page in pages or [page for page in all_pages if page != "doc/tutorial.md"]:
        shell = check_page(program, top, page)
        if page == "doc/tutorial.md":
            check_tutorial(shell)


if __name__ == "__main__":
    main(str(Path(sys.argv[1]).resolve()), Path(sys.argv[2]).resolve(), *sys.argv[3:])
