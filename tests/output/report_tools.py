"""What the reader of a report can do, for check_reports.py: the numbers in words, the
scale, the motion, the pictures that are saved, and narrow windows.
"""
import base64
import csv
import io
import os
import re
import time
import xml.etree.ElementTree as ElementTree

import numpy as np
from PIL import Image

SVG = "{http://www.w3.org/2000/svg}"
PLACE = 0.02  # what places in the picture may be off: they have two digits behind the point
# What each swatch of a legend stands for, by selectors; more than one where any will do.
MARKS = {"of-support": ".support", "of-load": ".load", "of-gap": ".gap",
         "of-resultant": ".resultant", "of-thrust": ".thrust", "of-opens": ".opens",
         "of-slides": ".slides", "of-hinge": ".hinge", "of-fill": ".fill", "of-link": ".link",
         "of-pulls": ".pulls, .resultant.tension", "of-pushes": ".pushes",
         "of-cross": ".cross:not(.tension)", "of-tension": ".cross.tension"}
# Words that are in several rectangles: broken between letters.
BROKEN_WORDS = """
const broken = [], walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
for (let node; (node = walker.nextNode());) {
  if (node.parentElement.closest('script, style, svg')) continue;
  for (const word of node.textContent.matchAll(/[\\p{L}\\p{N}_.-]+/gu)) {
    const range = document.createRange();
    range.setStart(node, word.index);
    range.setEnd(node, word.index + word[0].length);
    const tops = new Set([...range.getClientRects()].map(r => Math.round(r.top)));
    if (tops.size > 1 && !word[0].includes('-')) broken.push(word[0]);
  }
}
return broken;"""


def n_colours(pixels):
    """How many differ, of (rows, columns, 3) integers."""
    return len(np.unique(pixels @ (1 << 16, 1 << 8, 1)))


def rows_of(directory, name):
    """A table as a list of dictionaries; empty if there is no such file."""
    file = f"{directory}/{name}.csv"
    if not os.path.exists(file):
        return []
    with open(file, newline="") as lines:
        return list(csv.DictReader(lines))


def directory_of(page):
    return os.path.dirname(page.file)


def words(page, **wanted):
    """The panel of what the address asks for, as a dictionary."""
    page.js("location.hash = arguments[0]",
            "&".join(f"{name}={value}" for name, value in wanted.items()))
    page.js("return 0")
    return dict(page.js("return [...document.querySelectorAll('#numbers .words tr')]"
                        ".map(r => [...r.cells].map(c => c.textContent))"))


def numbers_in(text):
    return [float(v) for v in re.findall(r"-?\d+\.?\d*(?:e[-+]?\d+)?", text)]


def is_shown(text, value, largest):
    """True if the first number of the text is the value with four digits, or 0."""
    if abs(value) <= 1e-10 * largest:
        return text.split(",")[0] == "0"
    return abs(numbers_in(text)[0] - abs(value)) <= 6e-4 * abs(value)


def check_forces_in_words(page):
    """N, V, e/h and the linear normal stress, recomputed from interfaces.csv."""
    joints = rows_of(directory_of(page), "interfaces")
    of = {name: np.array([float(j[name]) for j in joints]) for name in joints[0]
          if name in ("normal_force", "tangential_force", "normal_force_0",
                      "normal_force_1", "utilisation")}
    largest = max(np.abs(of[name]).max() for name in of if "force" in name)
    for e in {0, len(joints) // 3, len(joints) // 2, int(np.argmin(of["normal_force"]))}:
        panel = words(page, view="forces", joint=e)
        normal = of["normal_force"][e]
        page.expect(f"N of {e}", is_shown(panel["Normal force N"], normal, largest) and
                    ("pressure" in panel["Normal force N"]) == (normal < -1e-10 * largest))
        page.expect(f"V of {e}", is_shown(panel["Shear force V"],
                                          of["tangential_force"][e], largest))
        used = of["utilisation"][e]
        page.expect(f"friction of {e}", not np.isfinite(used) or
                    np.isclose(numbers_in(panel["Friction used"])[0], 100 * used,
                               rtol=6e-3, atol=1e-300))
        if normal > -1e-6 * largest or "normal_force_0" not in of or (
                float(joints[e].get("tensile_strength") or 0) > 0):
            continue
        check_place_of_force(page, panel, e, joints[e])


def check_place_of_force(page, panel, e, joint):
    """By the two parts of the normal force of a joint that bears no tension."""
    start, end, size = (float(joint[n]) for n in ("normal_force_0", "normal_force_1", "length"))
    normal = start + end
    off = (end - start) / (2 * normal)  # over the length, from the middle
    shown = 0. if "middle, e/h" in panel["Acts at"] else float(
        re.search(r"e/h = ([\d.e-]+)", panel["Acts at"]).group(1))
    page.expect(f"e/h of {e}", abs(shown - abs(off)) <= 6e-4 * abs(off) + 1e-9)
    page.expect(f"third of {e}", ("outside" in panel["Acts at"]) == (abs(off) > 1 / 6))
    stress = panel["Normal stress, if linear"]
    if abs(off) > 0.5 - 1e-6:
        page.expect(f"stress of {e}", "no finite stress" in stress or
                    numbers_in(stress)[0] > 1e5 * abs(normal) / size)
        return
    # A trapezium, or a triangle, with the resultant through its centroid.
    largest = (abs(normal) / size * (1 + 6 * abs(off)) if abs(off) <= 1 / 6
               else 2 * abs(normal) / (3 * (0.5 - abs(off)) * size))
    # "12 kPa, pressure at (0, 1); 3 kPa, pressure at (2, 1)"
    ends = [numbers_in(part) for part in re.sub(r", pressure| kPa", "", stress).split(";")[:2]]
    most = max(ends)
    page.expect(f"stress of {e}: {stress}", abs(most[0] - largest) <= 1e-3 * largest)
    place = [float(joint[n]) for n in (("x0", "y0") if off < 0 else ("x1", "y1"))]
    page.expect(f"end of {e}: {stress}", abs(off) < 1e-3 or
                np.allclose(most[1:3], place, rtol=1e-3, atol=1e-9))


def check_motion_in_words(page):
    """Displacements, openings and sliding, by the files of the mechanism."""
    joints = rows_of(directory_of(page), "mechanism_joints")
    blocks = rows_of(directory_of(page), "mechanism")
    largest = max(abs(float(b[n])) for b in blocks for n in ("ux", "uy"))
    moves = [float(j["sliding"]) for j in joints]
    names = ("opening_0", "opening_1") if "opening_0" in joints[0] else ("opening",)
    opens = [max(float(j[n]) for n in names) for j in joints]
    for e in {0, len(joints) // 2, int(np.argmax(np.abs(moves))), int(np.argmax(opens))}:
        panel = words(page, view="motion", joint=e)
        for name, part in zip(names, panel["Opening"].split(";")):
            page.expect(f"{name} of {e}", is_near(part, float(joints[e][name]), largest))
        page.expect(f"sliding of {e}", is_near(panel["Sliding"], abs(moves[e]), largest))
    for c in {0, len(blocks) // 2, len(blocks) - 1}:
        panel = words(page, view="motion", block=c)
        u = np.hypot(*(float(blocks[c][n]) for n in ("ux", "uy")))
        size = panel["Displacement"].split("size")[1]
        page.expect(f"displacement of {c}", is_near(size, u, largest))


def is_near(text, value, largest):
    shown = numbers_in(text)[0]
    return (abs(shown - value) <= 6e-4 * abs(value) + 1e-9 * largest and
            not 0 < abs(shown) <= 1e-10 * largest)


def check_links_in_words(page):
    links = rows_of(directory_of(page), "links")
    for k in {0, len(links) - 1}:
        panel = words(page, view="forces", link=k)
        force = float(links[k]["force"])
        page.expect(f"link {k}", panel["Name"] == links[k]["link"] and
                    is_shown(panel["Force"], force, abs(force)) and
                    ("tension" in panel["Force"]) == (force > 0))
        page.expect(f"use of link {k}", np.isclose(
            numbers_in(panel["Used"])[0], 100 * float(links[k]["utilisation"]), rtol=6e-3))
        chosen = page.js("return document.querySelectorAll('#drawing .chosen[data-link=\"' +"
                         " arguments[0] + '\"]').length", str(k))
        page.expect(f"mark of link {k}", chosen > 0)


def check_mark(page):
    """What is chosen has an outline of its own at its place."""
    middle = len(page.joints[1]) // 2
    words(page, view="structure", joint=middle)
    drawn, marked, colour = page.js(
        "const m = document.getElementById('mark');"
        "return [document.getElementById('joints').children[arguments[0]].getAttribute('d'),"
        " m.getAttribute('d'), getComputedStyle(m).stroke]", middle)
    page.expect("outline of the chosen joint", drawn == marked and colour == "rgb(194, 0, 122)")
    page.expect("numbers in full behind a summary", page.js(
        "const d = document.querySelector('#numbers details');"
        "return !d.open && d.querySelector('summary').textContent !== ''"))


def bar_of_scale(page):
    """Its length in the picture and in the user's unit, and in pixels."""
    return page.js(
        "const [line, words] = document.getElementById('scale').children;"
        "const svg = document.getElementById('drawing'), length = line.getBBox().width;"
        "return [length, parseFloat(words.textContent), length * svg.getScreenCTM().a,"
        " words.textContent]")


def check_scale(page):
    """A round length as long as it says, also when the reader zooms in."""
    data = page.js("return JSON.parse(document.getElementById('page-data').textContent)")
    drawing = page.driver.find_element("id", "drawing")
    for zoom in (0, -700, -1400):
        page.js("arguments[0].dispatchEvent(new WheelEvent('wheel', {deltaY: arguments[1],"
                "clientX: 300, clientY: 400, bubbles: true, cancelable: true}))", drawing, zoom)
        drawn, says, pixels, text = bar_of_scale(page)
        page.expect(f"length of the scale, {text}",
                    abs(drawn * data["length"] - says) <= 1e-3 * says)
        mantissa = says / 10 ** np.floor(np.log10(says * (1 + 1e-9)))
        page.expect(f"a round length, {text}", min(abs(mantissa - m) for m in (1, 2, 5)) < 1e-6)
        page.expect(f"pixels of the scale, {pixels}", 40 < pixels < 125)
        page.expect(f"unit of the scale, {text}", text.endswith(data["units"]["length"]))
    page.js("arguments[0].dispatchEvent(new MouseEvent('dblclick', {bubbles: true}))", drawing)


def corners_of_moved(page):
    """All corners of all moved blocks in units of the picture."""
    return np.array(page.js(
        "const all = [], svg = document.getElementById('drawing'),"
        " back = svg.getScreenCTM().inverse();"
        "for (const p of document.querySelectorAll('#moved > polygon'))"
        " for (const q of p.points) {"
        "  const at = q.matrixTransform(back.multiply(p.getScreenCTM()));"
        "  all.push([at.x, at.y]); }"
        "return all"))


def expected_corners(page, factor):
    """The same by the files: u and the whole angle about the centre of each block."""
    data = page.js("return JSON.parse(document.getElementById('page-data').textContent)")
    rows = rows_of(directory_of(page), "mechanism") or rows_of(directory_of(page), "cells")
    polygons = page.js("return [...document.querySelectorAll('#blocks > polygon')]"
                       ".map(p => [...p.points].map(q => [q.x, q.y]))")
    corners = []
    for polygon, row in zip(polygons, rows):
        value = {n: float(row.get(n) or 0) for n in ("x", "y", "ux", "uy", "rotation")}
        x = np.array(data["origin"]) + np.array(polygon) * data["length"] * [1, -1]
        arm = x - [value["x"], value["y"]]
        c, s = np.cos(factor * value["rotation"]), np.sin(factor * value["rotation"])
        moved = (np.array([value["x"], value["y"]]) +
                 factor * np.array([value["ux"], value["uy"]]) +
                 arm @ np.array([[c, s], [-s, c]]))
        corners.extend((moved - data["origin"]) / data["length"] * [1, -1])
    return np.array(corners)


def set_slider(page, value):
    page.js("const s = document.getElementById('enlargement'); s.value = arguments[0];"
            "s.dispatchEvent(new Event('input'))", value)


def check_motion(page):
    """The slider moves blocks as the files say, and the button plays until it is pressed."""
    page.show("motion")
    drawn = page.js("return JSON.parse(document.getElementById('page-data').textContent)"
                    ".motion")
    page.expect("nothing moves by itself", np.array_equal(
        corners_of_moved(page), (time.sleep(0.3), corners_of_moved(page))[1]))
    for factor in (drawn["factor"], 0, drawn["most"], 0.3 * drawn["most"]):
        if factor != drawn["factor"]:
            set_slider(page, factor)
        error = np.abs(corners_of_moved(page) - expected_corners(page, factor)).max()
        page.expect(f"blocks moved {factor} times, error {error}", error < 3 * PLACE)
        says = page.js("return document.getElementById('enlarged').textContent")
        page.expect(f"the factor in words, {says}",
                    abs(numbers_in(says)[0] - factor) <= 6e-4 * factor)
    button = page.driver.find_element("id", "play")
    button.click()
    places = [corners_of_moved(page)]
    for _ in range(3):
        time.sleep(0.25)
        places.append(corners_of_moved(page))
    page.expect("it plays", all((a != b).any() for a, b in zip(places, places[1:])) and
                button.text == "Stop")
    button.click()
    stopped = corners_of_moved(page)
    time.sleep(0.3)
    page.expect("it stops at once", np.array_equal(stopped, corners_of_moved(page)) and
                button.text != "Stop")
    set_slider(page, drawn["factor"])


def check_legends(page):
    """Each swatch of a view stands for something that the view shows."""
    for view in page.views():
        page.show(view)
        swatches = page.js(
            "return [...document.querySelectorAll('.legend.in-' + arguments[0] + ' .line')]"
            ".map(s => [...s.classList].find(c => c.startsWith('of-')))", view)
        for swatch in swatches:
            page.expect(f"{swatch} of {view}", page.js(
                "return [...document.querySelectorAll(arguments[0])].some(e =>"
                " e.closest('svg') && e.getClientRects().length > 0)", MARKS[swatch]))


SAVED = """
const done = arguments[0], make = URL.createObjectURL, click = HTMLAnchorElement.prototype.click;
let saved = null;
URL.createObjectURL = blob => { saved = blob; return make.call(URL, blob); };
HTMLAnchorElement.prototype.click = function () {
  URL.createObjectURL = make;
  HTMLAnchorElement.prototype.click = click;
  const reader = new FileReader();
  reader.onload = () => done([this.download, reader.result.split(',')[1]]);
  reader.readAsDataURL(saved);
};
document.getElementById(arguments[1]).click();""".replace(
    "arguments[0]", "arguments[arguments.length - 1]").replace("arguments[1]", "arguments[0]")


def check_saving(page, view, title):
    """A file of SVG that stands alone, and a picture of twice its size."""
    page.show(view)
    legend = page.js("return document.querySelector('.legend.in-' + arguments[0] + ' p')"
                     ".textContent.trim()", view)
    name, content = page.driver.execute_async_script(SAVED, "save-svg")
    letters = re.sub(r"\W+", "-", title.lower()).strip("-")
    page.expect(f"name of the file, {name}", name == f"{letters}-{view}.svg")
    text = base64.b64decode(content).decode()
    root = ElementTree.fromstring(text)
    page.expect("root of the file", root.tag == f"{SVG}svg")
    elements = list(root.iter())
    page.expect("no styles from elsewhere", not any(
        e.get("class") or e.get("style") or e.tag.endswith("style") for e in elements))
    texts = [e.text for e in elements if e.tag == f"{SVG}text"]
    page.expect(f"title of the legend in {texts}", legend in texts)
    page.expect("title of the picture", title in texts[0])
    shapes = [e for e in elements if e.tag in (f"{SVG}path", f"{SVG}polygon")]
    page.expect("styles of all shapes", shapes and all(e.get("fill") for e in shapes))
    hidden = page.js("return [...document.querySelectorAll('#drawing .layer')]"
                     ".filter(e => getComputedStyle(e).display === 'none').map(e => e.id)")
    page.expect("what is hidden is left out", not any(e.get("id") in hidden for e in elements))
    name, content = page.driver.execute_async_script(SAVED, "save-png")
    picture = Image.open(io.BytesIO(base64.b64decode(content)))
    size = [2 * float(root.get(n)) for n in ("width", "height")]
    page.expect("name of the picture", name == f"{letters}-{view}.png")
    page.expect("twice the size", np.abs(np.array(picture.size) - size).max() <= 1)
    colours = n_colours(np.asarray(picture.convert("RGB")).astype(int))
    page.expect(f"colours of the picture, {colours}", colours > 4)


def check_widths(page):
    """No view is wider than the window, and no word is broken."""
    joint = len(page.joints[1]) // 2
    for width in (1600, 1000, 420):
        page.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": 900, "deviceScaleFactor": 1, "mobile": False})
        for view in page.views():
            words(page, view=view, joint=joint)
            page.js("for (const d of document.querySelectorAll('details')) d.open = true")
            wide = page.js("return document.documentElement.scrollWidth")
            page.expect(f"{view} within {width}, {wide}", wide <= width)
            broken = page.js(BROKEN_WORDS)
            page.expect(f"whole words in {view} at {width}, {broken}", not broken)
    page.driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})


def check_without_script(page):
    """The page is there without its script, but for what does nothing then."""
    page.driver.execute_cdp_cmd("Emulation.setScriptExecutionDisabled", {"value": True})
    page.driver.get("about:blank")
    page.driver.get(f"file://{page.file}")
    page.expect("verdict without a script",
                page.driver.find_element("class name", "verdict").is_displayed())
    page.expect("no tools without a script", not any(
        e.is_displayed() for e in page.driver.find_elements("css selector", ".tools, .tools *")))
    label = page.driver.find_element("css selector", "label[for=view-structure]")
    label.click()
    page.expect("views without a script", page.driver.find_element(
        "css selector", ".legend.in-structure").is_displayed())
    says = page.driver.find_element("css selector", "#scale text").text
    page.expect(f"a scale without a script, {says}", numbers_in(says)[0] > 0)
    page.driver.execute_cdp_cmd("Emulation.setScriptExecutionDisabled", {"value": False})
    page.driver.get("about:blank")
    page.driver.get(f"file://{page.file}")


def check_names(page):
    """What can be pressed or moved has a name that a reader of screens says."""
    unnamed = page.js(
        "return [...document.querySelectorAll('button, input')].filter(e =>"
        " !(e.textContent.trim() || e.getAttribute('aria-label') ||"
        " (e.labels && e.labels.length && e.labels[0].textContent.trim())))"
        ".map(e => e.id)")
    page.expect(f"names of {unnamed}", not unnamed)
