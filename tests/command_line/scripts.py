#!/usr/bin/env python3
"""What contrib/run does before it runs the program:

    scripts.py TOP DIRECTORY OF THE PROJECT

With stand-ins for CMake and make, which write down that they were called: it configures
once, builds a clone that was copied or moved anew, and shows progress as it comes.
"""
import os
import shutil
import subprocess
import sys
from pathlib import Path

STAND_INS = {
    "dpkg-query": "echo install ok installed",
    "cmake": """
options=()
while [ $# -gt 0 ]; do
  case $1 in
    -S) source=$2; shift ;;
    -B) build=$2; shift ;;
    -D*) option=${1#-D}; options+=("${option%%=*}:UNINITIALIZED=${option#*=}") ;;
  esac
  shift
done
mkdir -p "$build/CMakeFiles" "$build/tests/CMakeFiles"
echo "CMAKE_HOME_DIRECTORY:INTERNAL=$source" >"$build/CMakeCache.txt"
echo "CMAKE_CACHEFILE_DIR:INTERNAL=$build" >>"$build/CMakeCache.txt"
printf '%s\\n' "${options[@]}" >>"$build/CMakeCache.txt"
echo "configured" >>"$build/log"
touch "$build/Makefile"
""",
    # It goes on when its first line was seen.
    "make": """
while [ "$1" != -C ]; do shift; done
build=$2
echo "[  1%] Building CXX object of $build"
if [ -n "${SEEN:-}" ]; then
  for i in $(seq 200); do [ -e "$SEEN" ] && break; sleep 0.1; done
  [ -e "$SEEN" ] || { echo "*** nobody saw it"; exit 1; }
fi
touch "$build/CMakeFiles/object.o" "$build/tests/CMakeFiles/object.o"
echo "echo ran in $build" >"$build/voussoir"
chmod +x "$build/voussoir"
"""}
FIRST = "The first build of the program takes about three minutes on two cores"


def expect(what, holds, found=""):
    print(f"{what}: {'OK' if holds else 'FAILED'}", flush=True)
    if not holds:
        sys.exit(f"{what}: {found}")


def make_clone(top, clone):
    (clone / "contrib").mkdir(parents=True)
    (clone / "tests").mkdir()
    for name in ("run", "common.sh", "packages.txt"):
        shutil.copy(top / "contrib" / name, clone / "contrib")


def run(clone):
    ended = subprocess.run([clone / "contrib/run", "any.prm"], capture_output=True, text=True)
    expect(f"{clone.name} runs", ended.returncode == 0, ended.stderr)
    expect("  its own program", ended.stdout == f"ran in {clone / 'build/release'}\n",
           ended.stdout)
    return ended.stderr, (clone / "build/release/log").read_text().count("configured")


def moves(first, work):
    said, n_configured = run(first)
    expect("  which takes minutes at first", FIRST in said and n_configured == 1, said)
    said, n_configured = run(first)
    expect("  and is configured once", FIRST not in said and n_configured == 1, said)
    copied, moved, link = work / "copied", work / "moved", work / "link"
    shutil.copytree(first, copied)
    shutil.move(first, moved)
    for clone in (copied, moved):
        stale = clone / "build/release/tests/CMakeFiles/stale.o"
        stale.touch()
        said, n_configured = run(clone)
        expect("  built anew", FIRST in said and n_configured == 2 and not stale.exists()
               and f"{clone / 'build/release'} was copied or moved here, and is built anew\n"
               in said, said)
        said, n_configured = run(clone)
        expect("  and once", FIRST not in said and n_configured == 2, said)
    link.symlink_to(moved)
    ended = subprocess.run([link / "contrib/run", "any.prm"], capture_output=True, text=True)
    expect("By another path it is the same", "anew" not in ended.stderr, ended.stderr)


def progress(clone, seen):
    process = subprocess.Popen([clone / "contrib/run", "any.prm"], stderr=subprocess.PIPE,
                               stdout=subprocess.DEVNULL, text=True,
                               env={**os.environ, "SEEN": str(seen)})
    for line in process.stderr:
        if "Building" in line:
            seen.touch()
    expect("Progress is shown as it comes", process.wait() == 0)


def main(top):
    work = Path("scripts").resolve()
    shutil.rmtree(work, ignore_errors=True)
    (work / "bin").mkdir(parents=True)
    for name, content in STAND_INS.items():
        (work / "bin" / name).write_text("#!/bin/bash\n" + content)
        (work / "bin" / name).chmod(0o755)
    os.environ["PATH"] = f"{work / 'bin'}:{os.environ['PATH']}"
    make_clone(top, work / "first")
    moves(work / "first", work)
    progress(work / "moved", work / "seen")


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve())
