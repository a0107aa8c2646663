"""The report of every scene in Chromium: each view by its pixels and its DOM.

    python3 check_reports.py VOUSSOIR SOURCE_DIRECTORY
"""
import csv
import glob
import io
import json
import os
import re
import shutil
import subprocess
import sys

import numpy as np
from PIL import Image
import report_tools as tools
import report_verdicts
from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By

PROGRAM, SOURCE = sys.argv[1:]
DIRECTORY = os.path.abspath("reports")
MARGIN, SIZE = 60, 1000  # of the picture, as the program draws it
DARKEST = (52, 18, 72)  # the end of the colours of one sign
# Without the scenes that take long and show nothing that others do not.
SCENES = sorted(os.path.basename(f)[:-4] for f in glob.glob(f"{SOURCE}/prm/*.prm")
                if not f.endswith("million_cells.prm"))
LARGEST_PAGE = 3e6  # bytes for 1000 blocks


def expect(what, condition):
    if not condition:
        sys.exit(f"{what}: not as expected")


def run(scene, name, *settings, status=0):
    """The directory of results."""
    command = [PROGRAM, f"{SOURCE}/prm/{scene}.prm",
               "--set", f"Output directory={DIRECTORY}/{name}"]
    for setting in settings:
        command += ["--set", setting]
    done = subprocess.run(command, capture_output=True, text=True)
    expect(f"status of {name}, {done.stderr}", done.returncode == status)
    return f"{DIRECTORY}/{name}"


def table(file):
    """The names of the columns, and the rows as texts."""
    with open(file, newline="") as lines:
        rows = list(csv.reader(lines))
    return rows[0], rows[1:]


def browser():
    options = webdriver.ChromeOptions()
    for argument in ("--headless=new", "--no-sandbox", "--disable-gpu",
                     "--disable-dev-shm-usage", "--window-size=1200,1000",
                     "--force-device-scale-factor=1"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    options.binary_location = shutil.which("chromium")
    return webdriver.Chrome(service=Service(shutil.which("chromedriver")),
                            options=options)


class Page:
    """A report in the browser, with the tables beside it."""

    def __init__(self, driver, directory):
        self.driver = driver
        self.file = f"{directory}/report.html"
        driver.get("about:blank")
        driver.get(f"file://{self.file}")
        self.summary = json.load(open(f"{directory}/summary.json"))
        self.collapsed = self.summary["status"] == "collapse"
        names = (("mechanism", "mechanism_joints") if self.collapsed
                 else ("cells", "interfaces"))
        self.blocks, self.joints = (table(f"{directory}/{n}.csv") for n in names)

    def js(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def expect(self, what, condition):
        expect(f"{self.file}: {what}", condition)

    def views(self):
        return self.js("return [...document.querySelectorAll('input[name=view]')]"
                       ".map(i => i.id.slice(5))")

    def show(self, view):
        self.js("document.querySelector(`label[for=view-${arguments[0]}]`).click()", view)

    def pixels(self):
        png = self.driver.find_element(By.ID, "drawing").screenshot_as_png
        return np.asarray(Image.open(io.BytesIO(png)).convert("RGB")).astype(int)

    def numbers(self):
        """The line of the table of a block or joint that is shown: names and values."""
        return self.js("return [...document.querySelectorAll('#numbers .raw tr')]"
                       ".map(r => [...r.cells].map(c => c.textContent))")


def check_page(page):
    """It is whole by itself, and its size."""
    text = open(page.file).read()
    page.expect("nothing from elsewhere",
                not re.search(r"(src|href)=\"(?!#)|url\((?!#)|@import", text))
    page.expect("no messages of the browser",
                not [m for m in page.driver.get_log("browser")
                     if "favicon" not in m["message"]])
    n = max(1000, len(page.blocks[1]))
    page.expect(f"size {len(text)}", len(text) < LARGEST_PAGE * n / 1000)
    page.expect("no value that is none", "nan" not in text.lower().replace("signan", "")
                .split("<script>")[0].split('id="table')[0])


def check_geometry(page):
    """Joints are where interfaces.csv has them, in the order of its rows."""
    paths = page.js("return [...document.querySelectorAll('#joints > path')]"
                    ".map(p => p.getAttribute('d'))")
    names, rows = page.joints
    columns = [names.index(n) for n in ("x0", "y0", "x1", "y1")]
    given = np.array([[float(r[k]) for k in columns] for r in rows]).reshape(-1, 2, 2)
    drawn = np.array([[float(v) for v in re.findall(r"-?[\d.]+", p)]
                      for p in paths]).reshape(-1, 2, 2)
    page.expect("number of joints", given.shape == drawn.shape)
    extent = max(page.summary["packing"]["extent"])
    scale = SIZE / extent
    if "links" in page.summary:  # which may be beside the blocks, and in the picture, too
        axis = np.argmax(np.ptp(given.reshape(-1, 2), axis=0))
        fitted = np.ptp(drawn[..., axis]) / np.ptp(given[..., axis])
        page.expect("scale with links", 0.3 * scale < fitted <= scale)
        scale = fitted
    # One shift for all of them.
    shift = (drawn - given * [scale, -scale]).reshape(-1, 2)
    page.expect("places of joints", np.ptp(shift, axis=0).max() < 0.03)
    n = page.js("return document.querySelectorAll('#blocks > polygon').length")
    page.expect("number of blocks", n == len(page.blocks[1]))
    box = [float(v) for v in page.js("return document.getElementById('drawing')"
                                     ".getAttribute('viewBox')").split()]
    around = [scale * e + 2 * MARGIN for e in page.summary["packing"]["extent"]]
    page.expect("corner of the view box", box[:2] == [-MARGIN, -MARGIN])
    page.expect("view box", np.all(np.array(box[2:]) >= np.array(around) - 0.02)
                if "links" in page.summary else np.allclose(box[2:], around, atol=0.02))


def check_views(page):
    """Each differs from the others, and shows its layers and its legend."""
    views = page.views()
    wanted = {"motion", "structure"} if page.collapsed else {
        "structure", "forces", "normal", "utilisation", "stress"}
    page.expect(f"views {views}", wanted <= set(views))
    pictures = {}
    for view in views:
        page.show(view)
        shown, legend = page.js(
            "const shown = e => getComputedStyle(e).display !== 'none',"
            " legend = document.querySelector('.legend.in-' + arguments[0]);"
            "return [[...document.querySelectorAll('.layer, .legend')].filter(shown)"
            ".every(e => e.id === 'supports' || e.classList.contains('in-' + arguments[0])),"
            " legend.checkVisibility() && legend.innerText.trim()]", view)
        page.expect(f"layers of {view}", shown)
        page.expect(f"legend of {view}", legend)
        picture = page.pixels()
        inked = (picture.min(axis=2) < 250).mean()
        page.expect(f"ink of {view}, {inked}", 0.005 < inked < 0.98)
        page.expect(f"colours of {view}", tools.n_colours(picture) > 4)
        for other, its in pictures.items():
            # A single joint is the darkest in whatever colours it.
            page.expect(f"{view} differs from {other}",
                        len(page.joints[1]) == 1 or (its != picture).any())
        pictures[view] = picture
    return pictures


def check_colours(page):
    """The largest normal force has the darkest and the widest line."""
    names, rows = page.joints
    force = np.array([float(r[names.index("normal_force")]) for r in rows])
    if force.max() > 1e-6 * -force.min():
        return  # both signs
    largest = int(np.argmin(force))
    page.show("normal")
    colour, width = page.js(
        "const s = getComputedStyle(document.querySelectorAll('#joints > path')"
        "[arguments[0]]); return [s.stroke, s.strokeWidth]", largest)
    page.expect(f"colour of the largest force {colour}",
                tuple(int(v) for v in re.findall(r"\d+", colour)) == DARKEST)
    page.expect(f"its width {width}", abs(float(width[:-2]) - 6.2) < 0.01)


def check_numbers(page):
    """What is pointed at is shown with the numbers of the tables."""
    for kind, (names, rows) in (("block", page.blocks), ("joint", page.joints)):
        for index in {0, len(rows) // 2, len(rows) - 1}:
            page.js("location.hash = arguments[0]", f"{kind}={index}")
            page.js("return 0")
            expected = [[n, v] for n, v in zip(names, rows[index]) if v != ""]
            page.expect(f"numbers of {kind} {index}", page.numbers() == expected)
    page.js("location.hash = 'view=structure'")


def check_pointing(page):
    """The mouse over the middle of a block shows it; zooming and back."""
    page.driver.get("about:blank")
    page.driver.get(f"file://{page.file}#view=structure")
    names, rows = page.blocks
    # The browser moves from the middle of what is seen of the drawing.
    page.js("document.getElementById('drawing').scrollIntoView({block: 'center'})")
    # The centre, and the area over the longer side: how thick it is; pixels.
    places = page.js(
        "return [...document.querySelectorAll('#blocks > polygon')].map(p => "
        "{const b = p.getBoundingClientRect(), q = [...p.points], s = p.getScreenCTM().a;"
        "let area = 0; q.forEach((a, i) => {const c = q[(i + 1) % q.length];"
        " area += (a.x * c.y - a.y * c.x) / 2});"
        "const x = q.reduce((t, a) => t + a.x, 0) / q.length,"
        " y = q.reduce((t, a) => t + a.y, 0) / q.length,"
        " at = new DOMPoint(x, y).matrixTransform(p.getScreenCTM());"
        "return [at.x, at.y, Math.abs(area) * s * s / Math.hypot(b.width, b.height)]})")
    index = int(np.argmax([p[2] for p in places]))
    if places[index][2] < 12:
        return  # joints are everywhere; the reader zooms in
    drawing = page.driver.find_element(By.ID, "drawing")
    box = page.js("const b = arguments[0].getBoundingClientRect();"
                  "return [b.x + b.width / 2, b.y + b.height / 2]", drawing)
    x, y = places[index][0] - box[0], places[index][1] - box[1]
    ActionChains(page.driver, duration=0).move_to_element_with_offset(
        drawing, round(x), round(y)).perform()
    shown = dict(page.numbers())
    page.expect(f"block {index} under the mouse", shown.get(names[0]) == rows[index][0])
    def seen():
        return page.js("return arguments[0].getAttribute('viewBox')", drawing)

    before = seen()
    page.js("arguments[0].dispatchEvent(new WheelEvent('wheel', {deltaY: -500,"
            "clientX: 300, clientY: 400, bubbles: true, cancelable: true}))", drawing)
    page.expect("zoomed", float(seen().split()[2]) < 0.6 * float(before.split()[2]))
    ActionChains(page.driver, duration=0).double_click(drawing).perform()
    page.expect("all of it again", seen() == before)


def check_text(page):
    """The verdict and the reactions are those of summary.json."""
    verdict = page.driver.find_element(By.CLASS_NAME, "verdict")
    kind = {"solved": "carried", "collapse": "collapse"}.get(page.summary["status"], "within")
    page.expect("kind of verdict", kind in verdict.get_attribute("class") and verdict.text)
    page.expect("the verdict first", page.js(
        "return document.querySelector('h1').nextElementSibling") == verdict)
    numbers = re.findall(r"\d[\d.]*", re.sub(r"e-?\d+", "", verdict.text))
    page.expect(f"at most four digits in {numbers}", all(
        len(n.replace(".", "").strip("0")) <= 4 for n in numbers))
    page.expect("one sentence", not re.search(r"[.] (?!The dead loads)", verdict.text))
    page.expect("its proof", page.driver.find_element(
        By.CSS_SELECTOR, "#certificate summary").is_displayed() and
        not page.js("return document.getElementById('certificate').open"))
    if "ground" not in page.summary:
        return
    rows = page.js("return [...document.querySelectorAll('#reactions tr')].slice(1, -1)"
                   ".map(r => r.cells[2].textContent)")
    supports = page.summary["ground"]["supports"]
    page.expect("number of reactions", len(rows) == len(supports))
    for row, support in zip(rows, supports):
        shown = [float(v) for v in row.strip("()").split(",")]
        page.expect("reactions", np.allclose(shown, support["reaction"], rtol=1e-5))


def check(driver, directory):
    page = Page(driver, directory)
    check_page(page)
    check_geometry(page)
    check_text(page)
    pictures = check_views(page)
    if not page.collapsed:
        check_colours(page)
        tools.check_forces_in_words(page)
    check_numbers(page)
    tools.check_mark(page)
    tools.check_legends(page)
    tools.check_names(page)
    if os.path.exists(f"{directory}/mechanism.csv"):
        tools.check_motion_in_words(page)
    check_pointing(page)
    return page, pictures


def main():
    shutil.rmtree(DIRECTORY, ignore_errors=True)
    driver = browser()
    try:
        for scene in SCENES:
            check(driver, run(scene, scene))
        check_others(driver)
    finally:
        driver.quit()
    print("OK")


def check_ranges(driver):
    """Ranges of reactions and of a tie stand in tables, to all digits that are shown."""
    page = Page(driver, f"{DIRECTORY}/tied_arch")
    page.expect("no view of ranges without those of joints", "ranges" not in page.views())
    of = page.summary["ranges"]
    shown = page.js("return ['reactions', 'links'].map(of => [...document.querySelectorAll("
                    "'#ranges-of-' + of + ' tr')].slice(1).map(r => [...r.cells].slice(-2)"
                    ".map(c => Number(c.textContent))))")
    page.expect("ranges of reactions", np.allclose(
        shown[0], [s[d] for s in of["reactions"] for d in "xy"], rtol=1e-5))
    page.expect("ranges of ties", np.allclose(
        shown[1], [link["force"] for link in of["links"]], rtol=1e-5))
    tools.check_links_in_words(page)


def check_verdicts(driver):
    def said(scene, *settings, status=0, selector="verdict"):
        page = Page(driver, run(scene, f"verdict_of_{scene}", *settings, status=status))
        return page.driver.find_element(By.CLASS_NAME, selector).text, page.summary

    report_verdicts.check_verdicts(said, expect)


def check_tools(driver):
    """What the reader can do, on pages of all kinds."""
    for scene, title in (("bridge_with_fill", "Bridge under fill"),
                         ("rocking_wall", None), ("spreading_arch", None)):
        page = Page(driver, f"{DIRECTORY}/{scene}")
        title = title or page.summary["title"]
        tools.check_motion(page)
        tools.check_scale(page)
        tools.check_saving(page, "forces", title)
        tools.check_widths(page)
    tools.check_saving(page, "stress", title)
    tools.check_links_in_words(Page(driver, f"{DIRECTORY}/bridge_with_fill"))
    for scene in ("tied_arch", "buttress", "portal", "semicircular_arch",
                  "wall_with_openings"):
        tools.check_widths(Page(driver, f"{DIRECTORY}/{scene}"))
    tools.check_without_script(page)


def check_others(driver):
    """What only some runs have."""
    page, _ = check(driver, run("shear_wall", "collapse", "Friction/Strength=0.01", status=3))
    page.expect("the mechanism first", page.views()[0] == "motion")
    tools.check_motion(page)
    tools.check_saving(page, "motion", "Shear wall")
    tools.check_widths(page)
    page, pictures = check(driver, run(
        "wall_with_openings", "units", "Units/Length=m", "Units/Stress=kPa",
        "Units/Force=kN/m", "Title=A <wall> & \"more\""))
    page.expect("title", driver.find_element(By.TAG_NAME, "h1").text == 'A <wall> & "more"')
    page.show("normal")
    page.expect("unit", "(kN/m)" in driver.find_element(
        By.CSS_SELECTOR, ".legend.in-normal").text)
    page.expect("a parameter", "Units/Stress" in driver.find_element(By.ID, "parameters").text)
    page.expect("a page to print", len(driver.print_page()) > 10000)
    tools.check_scale(page)
    page, _ = check(driver, run("rubble_wall", "ranges", "Ranges/Where=1"))
    page.expect("ranges", "ranges" in page.views())
    check_ranges(driver)
    check_verdicts(driver)
    check_tools(driver)
    directory = run("shear_wall", "never", "Output/Report=false")
    expect("no report", not os.path.exists(f"{directory}/report.html"))
    directory = run("shear_wall", "csv", "Output/Files=csv")
    expect("no report beside csv", not os.path.exists(f"{directory}/report.html"))


main()
