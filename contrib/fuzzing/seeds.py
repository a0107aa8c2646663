#!/usr/bin/env python3
"""Make the inputs that fuzzing begins with: contrib/fuzzing/seeds.py PROGRAM DIRECTORY

Files of prm/ and tests/, and what PROGRAM, the voussoir to be fuzzed, makes of them, are
put into DIRECTORY/TARGET for each target; and beside DIRECTORY dictionaries/TARGET, the
names and values of parameters, and scene.prm, the scene of the target earlier_run.
"""
import json
import re
import shlex
import struct
import subprocess
import sys
from pathlib import Path

TOP = Path(__file__).resolve().parent.parent.parent
PROGRAM, OUT = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()

LARGEST = 5000  # bytes of an input: long ones are slow, and show no more
SQUARES = [[(0, 0), (1, 0), (1, 1), (0, 1)], [(1, 0), (2, 0), (2, 1), (1, 1)]]
SCENE = """set Rotations = true
set Accuracy = draft
subsection Packing
  set Generator = wall
  subsection wall
    set Courses = 2
    set Bricks per course = 1
  end
end
subsection Supports
  set Where = y < 1e-9
end
subsection Loads
  set Body force = 0; -1
end
subsection Friction
  set Strength = 1
end
subsection Ties
  subsection rod
    set From = at 0.3, 0.2
    set To = at 0.3, 0.8
    set Yield force = 1
  end
end
"""


def add(target, name, content):
    content = content if isinstance(content, bytes) else content.encode()
    if len(content) <= LARGEST:
        (OUT / target).mkdir(parents=True, exist_ok=True)
        (OUT / target / name).write_bytes(content)


def ask(*words):
    return subprocess.run([PROGRAM, *words], check=True, text=True,
                          stdout=subprocess.PIPE, cwd=OUT.parent).stdout


def obj_blocks(text):
    """Vertices and faces of a file that draws blocks one after the other."""
    vertices, faces = [], []
    for words in map(str.split, text.splitlines()):
        if words[:1] == ["v"]:
            vertices.append([float(word) for word in words[1:4]])
        elif words[:1] == ["f"]:
            faces.append([int(word.split("/")[0]) - 1 for word in words[1:]])
    return vertices, faces


def triangles(faces):
    return [(face[0], face[i], face[i + 1])
            for face in faces for i in range(1, len(face) - 1)]


def off(vertices, faces):
    lines = ["OFF", f"{len(vertices)} {len(faces)} 0"]
    lines += [" ".join(map(str, vertex)) for vertex in vertices]
    lines += [" ".join(map(str, [len(face), *face])) for face in faces]
    return "\n".join(lines) + "\n"


def ply(vertices, faces, form):
    head = (f"ply\nformat {form} 1.0\nelement vertex {len(vertices)}\n"
            "property double x\nproperty double y\nproperty double z\n"
            f"element face {len(faces)}\nproperty list uchar int vertex_indices\n"
            "end_header\n").encode()
    if form == "ascii":
        return head + off(vertices, faces).split("\n", 2)[2].encode()
    order = "<" if "little" in form else ">"
    return head + b"".join(
        [struct.pack(order + "3d", *vertex) for vertex in vertices]
        + [struct.pack(f"{order}B{len(face)}i", len(face), *face) for face in faces])


def stl(vertices, faces):
    facets = "".join(
        "facet normal 0 0 0\nouter loop\n"
        + "".join(f"vertex {x} {y} {z}\n" for x, y, z in (vertices[v] for v in corners))
        + "endloop\nendfacet\n" for corners in triangles(faces))
    return f"solid block\n{facets}endsolid block\n"


def stl_bytes(vertices, faces):
    corners = triangles(faces)
    return bytes(80) + struct.pack("<I", len(corners)) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *sum((vertices[v] for v in of), []), 0)
        for of in corners)


def tess(vertices, faces):
    lines = ["***tess", " **format", "   3.4", " **general", "   3 standard",
             " **vertex", f"  {len(vertices)}"]
    lines += [f"  {v + 1} {x} {y} {z} 0" for v, (x, y, z) in enumerate(vertices)]
    lines += [" **face", f"  {len(faces)}"]
    for f, face in enumerate(faces):
        corners = " ".join(str(v + 1) for v in face)
        lines += [f"  {f + 1} {len(face)} {corners}", f"  {len(face)} {corners}",
                  "  0 0 0 1", "  0 0 0 0 0"]
    lines += [" **polyhedron", "  1",
              f"  1 {len(faces)} " + " ".join(str(f + 1) for f in range(len(faces))),
              "***end"]
    return "\n".join(lines) + "\n"


def add_drawings():
    for file in TOP.glob("prm/*.wkt"):
        lines = file.read_text().splitlines(keepends=True)
        add("wkt", file.stem, "".join(lines))
        add("wkt", file.stem + "_begun", "".join(lines[:8]))
    for file in TOP.glob("prm/*.dxf"):
        add("dxf", file.stem, file.read_text())
    corners = [(*corner, 0) for square in SQUARES for corner in square]
    add("plane_off", "squares", off(corners, [range(4), range(4, 8)]))
    rings = [[*square, square[0]] for square in SQUARES]
    texts = ["POLYGON ((" + ", ".join(f"{x} {y}" for x, y in ring) + "))" for ring in rings]
    add("csv", "squares", "WKT,name\n" + "".join(f'"{text}",pier\n' for text in texts))
    add("geojson", "squares", json.dumps(
        {"type": "FeatureCollection", "features": [
            {"type": "Feature", "properties": {"name": "pier"},
             "geometry": {"type": "Polygon", "coordinates": [ring]}} for ring in rings]}))


def add_models():
    for file in [*TOP.glob("prm/space/*.obj"), *TOP.glob("tests/packing/models/*.obj")]:
        add("obj", file.stem, file.read_text())
        if file.stat().st_size > LARGEST:
            continue
        blocks = obj_blocks(file.read_text())
        add("off", file.stem, off(*blocks))
        add("tess", file.stem, tess(*blocks))
        for form in ("ascii", "binary_little_endian", "binary_big_endian"):
            add("ply", f"{file.stem}_{form}", ply(*blocks, form))
        add("stl", file.stem, stl(*blocks))
        add("stl", file.stem + "_bytes", stl_bytes(*blocks))
        add("space_points", file.stem, "".join(
            f"{0.1 + 0.8 * k / len(blocks[0])} {abs(x) % 1} {abs(y) % 1}\n"
            for k, (x, y, z) in enumerate(blocks[0])))
    for file in TOP.glob("tests/packing/models/*.json"):
        add("compas", file.stem, file.read_text())
    for file in TOP.glob("prm/*.txt"):
        add("points", file.stem, file.read_text())


def add_scenes():
    expressions = set()
    for file in [*TOP.glob("prm/*.prm"), *TOP.glob("prm/space/*.prm"),
                 *TOP.glob("tests/scenes/*.prm")]:
        # Comments with command lines are of use; drawings are other targets'.
        lines = re.sub(r"\\\n# *", "", file.read_text())
        for match in re.finditer(r"^# +voussoir (\S+) (-.*)", lines, re.MULTILINE):
            words = shlex.split(match[2])
            add("arguments", f"{file.stem}_{match.start()}", "\n".join(words))
        settings = re.sub(r"#.*\n", "\n", lines)
        small = re.sub(r"(Courses|per course|Voussoirs|Columns|Rows|Number of points|"
                       r"Abutments|Sectors)( *=) *\d+", r"\1\2 2", settings)
        add("prm", file.stem, small)
        add("run", file.stem, small)
        if file.stem.startswith("arch"):
            for form in ("json", "xml"):
                add(form, file.stem, ask(file, "--print-settings", "--as", form))
        section, assignments = [], []
        for line in map(str.strip, small.splitlines()):
            words = line.split(None, 1)
            if words[:1] == ["subsection"]:
                section.append(words[1])
            elif words[:1] == ["end"]:
                section.pop()
            elif words[:1] == ["set"]:
                name, value = (word.strip() for word in words[1].split("=", 1))
                if section[:1] != ["Packing"]:
                    assignments.append("/".join([*section, name]) + "=" + value)
                expressions.update(part.strip() for part in re.split("[;|]", value)
                                   if re.search(r"\b[xy]\b", part))
        add("settings", file.stem, "\n".join(assignments))
    for k, expression in enumerate(sorted(expressions)):
        add("expression", str(k), expression)


def add_earlier_run():
    (OUT.parent / "scene.prm").write_text(SCENE)
    ask("scene.prm", "--set", "Output directory=earlier")
    results = OUT.parent / "earlier"
    add("earlier_run", "wall", "\f".join(
        (results / name).read_text()
        for name in ("summary.json", "interfaces.csv", "cells.csv", "links.csv")))


def add_dictionaries():
    words = set()
    for dimension in ("2", "3"):
        for line in ask("--print-parameters", "--set", f"Dimension={dimension}").splitlines():
            if match := re.match(r" *(set|subsection) +([^=#]*[^=# ])", line):
                words.add(match[2])
        completion = ask("--print-completion", "--set", f"Dimension={dimension}")
        words.update(re.findall(r"=([a-zA-Z][a-zA-Z -]*)$", completion, re.MULTILINE))
    words |= {"subsection ", "end\n", "set ", " = ", "nan", "1e308", "inf", "list "}
    lines = [json.dumps(word).replace("\\n", "\\x0a") for word in sorted(words)]
    directory = OUT.parent / "dictionaries"
    directory.mkdir(exist_ok=True)
    for target in ("prm", "json", "xml", "settings", "run"):
        (directory / target).write_text("\n".join(lines) + "\n")


add_drawings()
add_models()
add_scenes()
add_earlier_run()
add_dictionaries()
