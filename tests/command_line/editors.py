#!/usr/bin/env python3
"""What editors and shells complete and check by:

    editors.py PROGRAM TOP DIRECTORY OF THE PROJECT

The JSON schema accepts each scene of prm/, as what it sets and as a listing, and finds
faults; and bash completes options, entries, values and files.
"""
import json
import os
import subprocess
import sys
from pathlib import Path

import jsonschema

PROGRAM, TOP = sys.argv[1], Path(sys.argv[2])


def output(*words):
    return subprocess.run([PROGRAM, *words], check=True, text=True,
                          stdout=subprocess.PIPE).stdout


def expect(what, condition):
    if not condition:
        sys.exit(f"{what}: not as expected")


def check_schema():
    schema = json.loads(output("--print-schema"))
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    scenes = sorted((TOP / "prm").glob("*.prm"))
    expect("scenes", len(scenes) > 20)
    for scene in scenes:
        for what in ("--print-settings", "--print-parameters"):
            validator.validate(json.loads(output(str(scene), what, "--as", "json")))

    def faults(text):
        return len(list(validator.iter_errors(json.loads(text))))
    for text in ('{"$schema": "voussoir.schema.json"}', '{"Rotations": true}',
                 '{"Rotations": "false"}', '{"Friction": {"Strength": 2}}',
                 '{"Packing": {"wall": {"Courses": 3, "Height": "1e-3"}}}',
                 '{"Load cases": {"wind": {"Traction": "nx; 0"}}}',
                 '{"Variables": {"h": 3, "b": "2 * h"}, "Rotations": "$h"}',
                 '{"Packing": {"wall": {"Height": "$(2 * h)"}}}'):
        expect(text, faults(text) == 0)
    for text in ('{"Rotation": true}', '{"Rotations": 1}', '{"Packing": 3}',
                 '{"Friction": {"Law": "Columb"}}', '{"Friction": {"Strength": [1, 2]}}',
                 '{"Packing": {"wall": {"Courses": 0}}}',
                 '{"Packing": {"wall": {"Courses": 2.5}}}',
                 '{"Packing": {"wall": {"Height": "high"}}}',
                 '{"Load cases": {"wind": {"Tractoin": "nx; 0"}}}',
                 '{"Variables": {"h": {"b": 3}}}'):
        expect(text, faults(text) > 0)


def completed(line):
    """The words that bash offers at the end of a line."""
    script = """
        eval "$1"
        COMP_LINE=$2 COMP_POINT=${#2}
        read -ra COMP_WORDS <<<"$2"
        case $2 in *' ') COMP_WORDS+=("") ;; esac
        COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
        _voussoir
        printf '%s\\n' "${COMPREPLY[@]}"
    """
    words = subprocess.run(["bash", "-c", script, "bash", output("--print-completion"), line],
                           check=True, text=True, stdout=subprocess.PIPE).stdout
    return sorted(filter(None, words.split("\n")))


def check_completion():
    expect("options", completed("voussoir --print-s") == ["--print-schema", "--print-settings"])
    expect("entries", completed("voussoir a.prm --set Friction/Str") == ["Friction/Strength="])
    expect("blanks", completed("voussoir --set Outp") ==
           [*completed("voussoir --set Output/"), r"Output\ directory="])
    expect("quoted", completed('voussoir --set "Load factor/Fac') ==
           [f"Load factor/Factor={word}" for word in ("all loads", "live loads", "strength")])
    expect("escaped", completed("voussoir --set Load\\ factor/Fac") ==
           [rf"Load\ factor/Factor={word}" for word in (r"all\ loads", r"live\ loads", "strength")])
    # Readline has a break behind the equals sign, and replaces what follows.
    expect("values", completed("voussoir --set Packing/Generator=w") == ["wall"])
    expect("sweeps", completed("voussoir a.prm --sweep Rotations=") == ["false", "true"])
    expect("formats", completed("voussoir --as j") == ["json"])
    expect("sections", completed("voussoir --print-parameters=Packing/w") == ["Packing/wall"])
    for name in ("scene.prm", "scene.json", "scene.xml", "scene.csv"):
        Path(name).touch()
    expect("files", completed("voussoir scene") == ["scene.json", "scene.prm", "scene.xml"])


os.makedirs("editors", exist_ok=True)
os.chdir("editors")
check_schema()
check_completion()
print("OK")
