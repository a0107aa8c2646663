#!/usr/bin/env python3
"""What a user sees on a terminal, and a file or a pipe gets:

    terminal.py VOUSSOIR MPIRUN...

Progress and colours go to a terminal only, also under mpirun; a run whose output
nobody reads any more still writes its results.
"""
import os
import pty
import signal
import subprocess
import sys
import time
from pathlib import Path

PATIENCE = 60  # seconds
PROGRAM, MPIRUN = sys.argv[1], sys.argv[2:]
# Long enough for a line of progress, and shorter than the test's time.
LONG = ["long.prm", "--set", "Packing/Voronoi/Number of points=20000",
        "--set", "Packing/Voronoi/Lloyd steps=10000"]


def expect(what, holds, found=""):
    print(f"{what}: {'OK' if holds else 'FAILED'}", flush=True)
    if not holds:
        sys.exit(f"{what}: {found!r}")


def environment(**more):
    return {**os.environ, "TERM": "xterm", "OMPI_ALLOW_RUN_AS_ROOT": "1",
            "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", **more}


def on_terminal(words, until=None, **more):
    """The exit status, and what a terminal gets; Ctrl-C once it has `until`."""
    controller, terminal = pty.openpty()
    process = subprocess.Popen(
        [PROGRAM] + words, stdin=terminal, stdout=terminal, stderr=terminal,
        env=environment(**more), start_new_session=True)
    os.close(terminal)
    shown, end = b"", time.monotonic() + PATIENCE
    while time.monotonic() < end:
        try:
            piece = os.read(controller, 4096)
        except OSError:  # the last one has closed it
            break
        if not piece:
            break
        shown += piece
        if until and until in shown:
            process.send_signal(signal.SIGINT)
            until = None
    os.close(controller)
    return process.wait(PATIENCE), shown.decode()


def into_closed_pipe(words):
    """The exit status and the errors of a run whose output nobody reads."""
    reader, writer = os.pipe()
    os.close(reader)
    run = subprocess.run([PROGRAM] + words, stdout=writer, text=True,
                         stderr=subprocess.PIPE)
    os.close(writer)
    return run.returncode, run.stderr


for name in ("short", "long"):
    Path(f"{name}.prm").write_text(
        f"set Output directory = {name}\nset Formulation = least energy\n"
        "subsection Loads\n  set Traction = -nx; -ny\nend\n")

status, shown = on_terminal(["short.prm"])
expect("colours on a terminal", status == 0 and "\033[32msolved\033[0m" in shown,
       shown)
status, shown = on_terminal(["short.prm"], NO_COLOR="1")
expect("NO_COLOR", status == 0 and "\033" not in shown and "solved" in shown, shown)

status, shown = on_terminal(LONG, until=b" a second, ")
expect("progress on a terminal", "\r\033[K  Packing: " in shown, shown)
expect("its rate and the time left",
       " of 10000 Lloyd steps, " in shown and " left" in shown, shown)
last = shown.split("\r\033[K")[-1]
expect("Ctrl-C ends it with 130, on a line of its own",
       status == 130 and last.startswith("voussoir: Interrupted by SIGINT"), shown)

for words in ([PROGRAM], MPIRUN + [PROGRAM]):
    with open("out.txt", "w") as file:
        status = subprocess.run(words + ["short.prm"], stdout=file,
                                env=environment()).returncode
    written = Path("out.txt").read_text()
    expect("neither in a file",
           status == 0 and "solved" in written and
           not set("\r\033") & set(written), written)

Path("short/summary.json").unlink()
status, errors = into_closed_pipe(["short.prm"])
expect("results though nobody reads",
       status == 0 and Path("short/summary.json").exists(), errors)
for option in ("--print-parameters", "--print-reference", "--help", "--version"):
    status, errors = into_closed_pipe([option])
    expect(option, status == 2 and errors ==
           "voussoir: The output cannot be written; is the disk full, or has its "
           "reader gone?\n", errors)
