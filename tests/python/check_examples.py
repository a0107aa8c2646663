"""The examples of doc/python.md, one after the other.

    python3 check_examples.py SOURCE_DIRECTORY PROGRAM
"""
import os
import re
import sys

SOURCE, PROGRAM = sys.argv[1:]


def expect(what, condition):
    if not condition:
        sys.exit(f"{what}: not as expected")


def main():
    page = open(f"{SOURCE}/doc/python.md").read()
    examples = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    expect("number of examples", len(examples) == 9)
    # They name files of the project.
    if not os.path.exists("prm"):
        os.symlink(f"{SOURCE}/prm", "prm")
    names = {}
    for example in examples:
        exec(compile(example.replace("build/release/voussoir", PROGRAM), "doc/python.md",
                     "exec"), names)
    expect("the load factor", abs(names["found"].normal_force.min()) > 0)
    expect("the picture", os.path.getsize("wall.png") > 10000)
    mesh = names["mesh"]
    expect("the files", len(mesh.Points) > 0 and "stress" in mesh.CellData.keys())
    print("OK")


main()
