#!/usr/bin/env python3
"""The pages of many runs: envelopes, plots and directories against closed forms.

    sweep_pages.py VOUSSOIR

Curves, envelopes and maps are read from the SVG of sweep.html; numbers of the scenes follow from
statics alone.
"""
import csv
import html
import json
import math
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from scene_text import prm

PROGRAM = str(Path(sys.argv[1]).resolve())
OUTPUT = Path("output")

# A beam of length 4 and weight 8 on a pier between -1/2 and 1/2, which axles tilt over either end.
BEAM = """set Analysis = load factor
set Rotations = true
set Packing/Generator = polygons
set Packing/polygons/File = beam.wkt
set Supports/Where = y < 1e-9
set Friction/Strength = 100
set Loads/Body force = 0; -2
set Live loads/Vehicle/Axles = 0: 2
set Live loads/Vehicle/Effective width = 2
"""
BEAM_WKT = ("POLYGON ((-0.5 0, 0.5 0, 0.5 1, -0.5 1, -0.5 0))\n"
            "POLYGON ((-2 1, 2 1, 2 2, -2 2, -2 1))\n")
VEHICLES = {"0: 2": [(0, 1)], "0: 2 | 0.5: 4": [(0, 1), (0.5, 2)]}
POSITION = "Live loads/Vehicle/Position"
# A block of weight 3 that is wider below, pushed by its live loads to either side.
LEANING = """set Analysis = load factor
set Rotations = true
set Packing/Generator = polygons
set Packing/polygons/File = leaning.wkt
set Supports/Where = y < 1e-9
set Friction/Strength = 100
set Loads/Body force = 0; -1
set Live loads/Body force = 1; 0
"""
LEANING_WKT = "POLYGON ((0 0, 2 0, 1 2, 0 2, 0 0))\n"
X_CENTRE, Y_CENTRE = 7 / 9, 8 / 9
# A block of width 1 and height 2, of weight 1 a unit of area, which slides if 2 H > s.
BLOCK = """set Formulation = least energy
set Packing/Generator = wall
set Packing/wall/Courses = 1
set Packing/wall/Bricks per course = 1
set Packing/wall/Width = 1
set Packing/wall/Height = 2
set Supports/Where = y < 1e-9
set Loads/Body force = 0.25; -1
set Friction/Strength = 10
"""
SCENES = {"beam": BEAM, "leaning": LEANING, "block": BLOCK}


def expect(what, holds, *details):
    if not holds:
        sys.exit("\n".join([f"{what}: not as expected", *map(str, details)]))


def write_scenes():
    Path("beam.wkt").write_text(BEAM_WKT)
    Path("leaning.wkt").write_text(LEANING_WKT)
    for name, text in SCENES.items():
        Path(f"{name}.prm").write_text(prm(text))


def run(scene, *arguments, status=0):
    """What the program prints; on standard error if it fails."""
    done = subprocess.run([PROGRAM, f"{scene}.prm", *arguments], capture_output=True, text=True)
    expect(f"status of {scene} {arguments}", done.returncode == status, done.stdout, done.stderr)
    return done.stderr if status else done.stdout


def sweep(scene, *axes, options=(), status=0):
    arguments = [word for axis in axes for word in ("--sweep", axis)]
    return run(scene, *arguments, *options, status=status)


def table():
    with open(OUTPUT / "sweep.csv", newline="") as lines:
        return list(csv.DictReader(lines))


def page():
    return (OUTPUT / "sweep.html").read_text("utf-8")


def summary(directory):
    return json.loads((OUTPUT / directory / "summary.json").read_text())


def plot(column="load_factor"):
    found = re.search(rf'<section class="plot-of" id="plot-{column}">.*?</section>', page(), re.S)
    return found.group() if found else ""


def circles(svg, kind):
    """The words, value and place of each point of a curve."""
    form = rf'<circle class="{kind}" cx="(\S+)" cy="(\S+)" r="\S+"><title>(.*?): (\S+)</title>'
    return [(html.unescape(words), float(value), float(x), float(y))
            for x, y, words, value in re.findall(form, svg)]


def paths(svg, kind):
    """The places of each line of the plot; the key has others."""
    svg = svg.split("</svg>")[0]
    return [[tuple(map(float, place.split())) for place in re.split("[ML]", d)[1:]]
            for d in re.findall(rf'<path class="{kind}" d="([^"]*)"', svg)]


def close(a, b, error=1e-8):
    return abs(a - b) <= error * max(abs(a), abs(b), 1e-300)


def heights(svg, kinds):
    """From a value to its height in the picture, by two points far apart."""
    scaled = math.log if ", logarithmic</text>" in svg else float
    points = sorted((p for kind in kinds for p in circles(svg, kind)), key=lambda p: p[1])
    (_, low, _, bottom), (_, high, _, top) = points[0], points[-1]
    return lambda value: bottom + ((scaled(value) - scaled(low)) / (scaled(high) - scaled(low))
                                   * (top - bottom))


def beam_factor(axles, is_reversed, position):
    places = [(position + (-x if is_reversed else x), force) for x, force in axles]
    places = [(x, force) for x, force in places if abs(x) < 2 + 1e-9]
    arms = [sum(force * (side * x - 0.5) for x, force in places) for side in (-1, 1)]
    return min((4 / arm for arm in arms if arm > 1e-9), default=math.inf)


def check_envelope():
    printed = sweep("beam", "Live loads/Vehicle/Axles=" + " || ".join(VEHICLES),
                    "Live loads/Vehicle/Reversed=false | true", f"{POSITION}=-1.9:1.9:39",
                    options=["--critical"])
    rows = table()
    least, place = {}, {}
    for k, row in enumerate(rows):
        curve = row["Live loads/Vehicle/Axles"], row["Live loads/Vehicle/Reversed"]
        position = float(row[POSITION])
        known = beam_factor(VEHICLES[curve[0]], curve[1] == "true", position)
        expect(f"factor of {curve} at {position}",
               close(float(row["load_factor"]), known) or known == float(row["load_factor"]), row)
        place.setdefault(round(position, 6), []).append(known)
        if known < least.get(curve, (math.inf,))[0] * (1 - 1e-6):
            least[curve] = known, k
    expect("all combinations", len(rows) == 4 * 39 and len(least) == 4)
    critical = min(least.values())[1]
    expect("the run of the least", close(summary("critical")["load_factor"]["carried"],
                                         min(least.values())[0]))
    words = ", ".join(f"{name} = {rows[critical][name]}" for name in list(rows[0])[:3])
    expect("the terminal", f"Envelope       of 4 curves over {POSITION}: least "
           f"{min(least.values())[0]:.6g} with {words}" in printed, printed)
    check_curves(place)
    check_least(rows, least, critical)


def check_curves(place):
    """The picture has the points of each curve, and the least of each place as envelope."""
    svg = plot()
    kinds = [f"tinted c{k}" for k in range(4)]
    for k in range(4):
        drawn = circles(svg, kinds[k])
        wanted = sum(math.isfinite(factors[k]) for factors in place.values())
        expect("points of a curve", len(drawn) == wanted, k, len(drawn), wanted)
    height = heights(svg, kinds)
    of_place = {round(float(words.rsplit("= ", 1)[1]), 6): x
                for kind in kinds for words, _, x, _ in circles(svg, kind)}
    wanted = {round(of_place[x], 2): height(min(factors)) for x, factors in place.items()
              if math.isfinite(min(factors))}
    drawn = {round(x, 2): y for path in paths(svg, "envelope") for x, y in path}
    expect("places of the envelope", drawn.keys() == wanted.keys(), drawn, wanted)
    expect("the envelope", all(abs(drawn[x] - wanted[x]) < 0.01 for x in drawn), drawn, wanted)
    for words in ("Axles = 0: 2, Reversed = false", "Axles = 0: 2 | 0.5: 4, Reversed = true",
                  "envelope: the least at each place"):
        expect("the key", f"</svg> {words}</li>" in svg, words, svg)
    expect("no bound is told", "load_factor has no bound in " in svg)
    expect("one ring", svg.count('class="ring"') == 1 and "\u25ef the least of all" in svg)
    expect("factors far apart", "load_factor, logarithmic" in svg)


def check_least(rows, least, critical):
    """The table of curves has the least of each, and the way to its run."""
    section = re.search(r'<section id="curves">.*?</section>', page(), re.S).group()
    found = re.findall(r"<tr[^>]*>((?:<td>.*?</td>)+)</tr>", section)
    cells = [[html.unescape(cell) for cell in re.findall("<td>(.*?)</td>", row)] for row in found]
    for row, (curve, (_, k)) in zip(cells, least.items()):
        link = "critical/report.html" if k == critical else f"#run-{k + 1}"
        expect("a line of the table", row[:2] == list(curve) and row[2] == rows[k][POSITION]
               and row[3] == rows[k]["load_factor"] and f'href="{link}"' in row[4], row, k)
    expect("its lines", len(cells) == 4)
    expect("its heading", "<h2>The least load factor of each curve</h2>" in section)
    expect("one stands out", section.count('<tr class="critical">') == 1)


def check_alone():
    """Values of the envelope are those of single runs, to the last digit."""
    for row in (table()[3], table()[-5]):
        settings = [word for name in list(row)[:3] for word in ("--set", f"{name}={row[name]}")]
        run("beam", *settings, "--set", "Output directory=alone")
        alone = json.loads(Path("alone/summary.json").read_text())["load_factor"]["carried"]
        expect("the run alone", alone == float(row["load_factor"]), row, alone)
        verdict = re.search(r'<p class="verdict carried">(.*?)</p>',
                            Path("alone/report.html").read_text("utf-8")).group(1)
        expect("its verdict", f"carried\" title=\"{verdict}\">{verdict}</td>" in page(), verdict)


def check_both_ways():
    """An earthquake both ways: tilting over the right end and over the left."""
    printed = sweep("leaning", "Load factor/Direction=greatest | least",
                    "Loads/Body force=0; -g for g=1:2:5", options=["--critical"])
    for row in table():
        g = float(row["g"])
        greatest = row["Load factor/Direction"] == "greatest"
        known = g * (2 - X_CENTRE if greatest else -X_CENTRE) / Y_CENTRE
        expect("both ends", close(float(row["load_factor"]), known), row, known)
    least = -X_CENTRE / Y_CENTRE
    expect("what is nearest to zero", close(summary("critical")["load_factor"]["carried"], least))
    expect("the terminal", "Load factor    the least at most -0.875 with Load factor/Direction = "
           "least, g = 1, the greatest at least 1.375 with Load factor/Direction = greatest, g = 1"
           in printed and "Envelope       of 2 curves over g: nearest to zero -0.875 with Load "
           "factor/Direction = least, g = 1" in printed, printed)
    envelopes = paths(plot(), "envelope")
    height = heights(plot(), ["tinted c0", "tinted c1"])
    for drawn, unit in zip(envelopes, (least, (2 - X_CENTRE) / Y_CENTRE)):
        expect("an end", len(drawn) == 5 and
               all(abs(y - height(unit * (1 + 0.25 * k))) < 0.01 for k, (_, y) in enumerate(drawn)),
               drawn)
    sweep("leaning", "Loads/Body force=0; -g for g=1:2:5",
          options=["--critical", "--set", "Load factor/Direction=least"])
    expect("of least ones the greatest", close(summary("critical")["load_factor"]["carried"], least)
           and "The greatest of the least load factors is -0.875, with g = 1" in page())


def check_texts():
    sweep("beam", "Live loads/Vehicle/Axles=0: 2 || 0: 2 | 0.5: 4 || 0: 3",
          options=["--set", f"{POSITION}=1.4"])
    svg = plot()
    shown = re.findall(r'<text class="(?:below|beside)"[^>]*>(0: [^<]*)<', svg)
    expect("the texts below", shown == ["0: 2", "0: 2 | 0.5: 4", "0: 3"], shown)
    expect("three points and no line", svg.count("<circle") == 3
           and 'path class="curve' not in svg, svg)
    # What carries no live loads at all has none, and no answer.
    printed = sweep("beam", f"{POSITION}=-3 | 1 | 1.5")
    expect("a run without live loads", "3 runs: 2 solved, 1 unloaded" in printed
           and table()[0]["status"] == "unloaded" and table()[0]["load_factor"] == ""
           and "no live loads in 1 of 3 runs" in plot()
           and ": 2 carried, 1 without live loads." in page()
           and plot().count('class="mark none"') == 1, printed)
    shutil.rmtree(OUTPUT)
    message = sweep("beam", f"{POSITION}=-3 | 3", status=2)
    expect("none with any", message.startswith(
        f"voussoir: With {POSITION} = -3: 'Analysis' is 'load factor', and there are no loads to be "
        "multiplied: ") and not OUTPUT.exists(), message)


def check_map():
    """Strength and push: twice the push is what the joint must bear."""
    sweep("block", "Friction/Strength=0.105:0.905:9", "Loads/Body force=h; -1 for h=0.05:0.45:9")
    svg = plot("max_utilisation")
    fields = re.findall(r'<rect class="field ?(\w*)"[^>]*><title>h = (\S+), Friction/Strength = '
                        r'(\S+): (.*?)</title>', svg)
    expect("a field for each run", len(fields) == 81, len(fields))
    for kind, push, strength, what in fields:
        slides = 2 * float(push) > float(strength)
        expect("a field", (kind, what) == ("collapse", "not carried") if slides
               else kind == "" and close(float(what), 2 * float(push) / float(strength), 1e-4),
               kind, strength, push, what)
    # As long as there are neighbours of which one slides.
    carried = {(round(float(s), 6), round(float(h), 6)) for kind, h, s, _ in fields if not kind}
    steps = [(a, b) for a in range(9) for b in range(9)]
    at = {(a, b): (round(0.105 + 0.1 * a, 6), round(0.05 + 0.05 * b, 6)) in carried
          for a, b in steps}
    n = sum((a + 1, b) in at and at[a, b] != at[a + 1, b] for a, b in steps)
    n += sum((a, b + 1) in at and at[a, b] != at[a, b + 1] for a, b in steps)
    expect("the contour", n > 0 and len(paths(svg, "contour")) == n, n, len(paths(svg, "contour")))
    expect("the key", f"not carried in {81 - len(carried)} of 81 runs" in svg, svg)


def check_two_numbers():
    """Few values in one of them: curves over the other, and marks of what collapses."""
    sweep("block", "Friction/Strength=0.35 | 0.55", "Loads/Body force=h; -1 for h=0.05:0.45:9")
    svg = plot("max_utilisation")
    expect("two curves", [len(circles(svg, f"tinted c{k}")) for k in range(3)] == [3, 5, 0], svg)
    expect("marks of those that slide", svg.count('class="mark collapse"') == 6
           and "not carried in 10 of 18 runs" in svg
           and "<title>Not carried: Strength = 0.35, h = 0.2</title>" in svg, svg)
    row = re.search(r'<td class="verdict-of collapse" title="([^"]*)">(.*?)</td>', page())
    expect("what is not carried", row.group(2) == "The loads are not carried."
           and row.group(1).startswith("The loads are not carried: along the mechanism"), row.groups())


def check_many_curves():
    sweep("block", "Friction/Strength=1 | 2 | 3 | 4", "Rotations=false | true",
          "Supports/Where=y < 1e-9 | y < 1e-8", "Loads/Body force=h; -1 for h=0.05:0.1:5")
    expect("no plot, and why", "<svg" not in page() and
           "There would be 16 curves over h, one for each combination of the others, and no more "
           "than 12 can be told apart: there is no plot" in page(), page()[-3000:])


def check_search():
    shutil.rmtree(OUTPUT)
    printed = run("block", "--find", "Friction/Strength=0:10:1e-4")
    found = re.search(r"= (\S+) is carried, (\S+) collapses", printed)
    for name, status, value in (("carried", "solved", found.group(1)),
                                ("collapses", "collapse", found.group(2))):
        expect(f"results of {name}", summary(name)["status"] == status
               and f"Strength = {value}\n" in re.sub(
                   " +", " ", (OUTPUT / name / "parameters.prm").read_text())
               and f'<a href="{name}/report.html">' in page(), name)
    expect("where it changes", "The answer changes at Friction/Strength = 0.5, known to " in page())
    files = {p.name: p.read_bytes() for p in (OUTPUT / "collapses").iterdir()}
    # With a directory for each they are copies.
    run("block", "--find", "Friction/Strength=0:10:1e-1", "--directories")
    ends = [k for k, row in enumerate(table(), 1) if Path(f"output/run_{k}").exists()]
    for name in ("carried", "collapses"):
        expect("a copy", any((OUTPUT / name / "summary.json").read_bytes()
                             == (OUTPUT / f"run_{k}" / "summary.json").read_bytes() for k in ends))
    expect("the same files", files.keys() == {p.name for p in (OUTPUT / "collapses").iterdir()})
    # What a search without an end leaves is its own table alone.
    (OUTPUT / "carried" / "notes.txt").write_text("mine")
    run("block", "--find", "Friction/Strength=2:10", status=2)
    expect("earlier results are removed", not (OUTPUT / "collapses").exists()
           and [p.name for p in (OUTPUT / "carried").iterdir()] == ["notes.txt"]
           and "report.html" not in page().replace('href="run_', ""))


def check_protection():
    for name, arguments in (("carried", ["--find", f"{POSITION}=0:1.9"]),
                            ("critical", ["--sweep", f"{POSITION}=0 | 1", "--critical"])):
        shutil.rmtree(OUTPUT, ignore_errors=True)
        (OUTPUT / name).mkdir(parents=True)
        (OUTPUT / name / "packing.wkt").write_text(BEAM_WKT)
        message = run("beam", *arguments, "--set",
                      f"Packing/polygons/File=output/{name}/packing.wkt", status=2)
        expect("an input", message == "voussoir: The results may overwrite "
               f"'./output/{name}/packing.wkt', which the packing is made from; copy it to another "
               "place, or change 'Output directory'.\n"
               and [p.name for p in (OUTPUT / name).iterdir()] == ["packing.wkt"], message)
    # A file where the directory would be.
    shutil.rmtree(OUTPUT)
    OUTPUT.mkdir()
    (OUTPUT / "collapses").write_text("")
    message = run("block", "--find", "Friction/Strength=0:10", status=2)
    expect("no directory", message == "voussoir: The output directory 'output/collapses' cannot take "
           "the results: 'DIRECTORY/output/collapses' is not a directory. Change 'Output "
           "directory'.\n".replace("DIRECTORY", str(Path.cwd())), message)
    shutil.rmtree(OUTPUT)


def check_critical_copy():
    sweep("beam", f"{POSITION}=1 | 1.5 | 1.2", options=["--critical", "--directories"])
    expect("a copy of its run", {p.name: p.read_bytes() for p in (OUTPUT / "critical").iterdir()}
           == {p.name: p.read_bytes() for p in (OUTPUT / "run_2").iterdir()})
    sweep("beam", f"{POSITION}=1 | 1.5")
    expect("it is removed by a sweep without", not (OUTPUT / "critical").exists()
           and (OUTPUT / "run_2").exists())


def check_numbers():
    """No number that is rounding is shown, and all digits of others."""
    sweep("beam", f"{POSITION}=1 | 1.3", options=["--result", "ground/reaction/0"])
    rows = re.findall(r'<tr><td id="run-\d+">.*?</tr>', page())
    cells = [re.sub("<[^>]*>", "", cell) for row in rows for cell in re.findall("<td.*?</td>", row)]
    numbers = [float(cell) for cell in cells if re.fullmatch(r"-?\d[\d.e+-]*", cell)]
    expect("no rounding", len(rows) == 2 and all(x == 0 or abs(x) >= 1e-12 for x in numbers)
           and table()[0]["load_factor"] in cells, cells)
    expect("it is told", ("rounding" in cells) == ("'rounding' stands for" in page()))


def main():
    shutil.rmtree("sweep_pages", ignore_errors=True)
    Path("sweep_pages").mkdir()
    os.chdir("sweep_pages")
    write_scenes()
    check_envelope()
    check_alone()
    check_both_ways()
    check_texts()
    check_map()
    check_two_numbers()
    check_many_curves()
    check_search()
    check_protection()
    check_critical_copy()
    check_numbers()
    print("All pages of sweeps are right.")


main()
