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
    expect("number of examples", len(examples) == 12)
    # They name files of the project.
    if not os.path.exists("prm"):
        os.symlink(f"{SOURCE}/prm", "prm")
    names = {}
    for example in examples:
        exec(compile(example.replace("build/release/voussoir", PROGRAM), "doc/python.md",
                     "exec"), names)
        if "mean_stress" in example:
            stress = names["statistics"].mean_stress(names["found"])
            expect("the mean stress", abs(stress + names["np"].eye(2)).max() < 1e-10)
    expect("the load factor", abs(names["found"].normal_force.min()) > 0)
    expect("the page and the files", os.path.getsize("page.html") > 10000 and
           os.path.exists("output/from_python/summary.json"))
    expect("the picture", os.path.getsize("wall.png") > 10000)
    mesh = names["mesh"]
    expect("the files", len(mesh.Points) > 0 and "stress" in mesh.CellData.keys())
    print("OK")


main()
