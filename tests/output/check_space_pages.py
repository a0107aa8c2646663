"""The pages of packings in space in Chromium: what a click finds, what is drawn,
and that nothing is loaded.

    python3 check_space_pages.py WRITE_SPACE_PAGES
"""
import base64
import io
import os
import re
import shutil
import subprocess
import sys

import numpy as np
from PIL import Image
from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

DIRECTORY = os.path.abspath("space_pages")
DARKEST, STONE, FIXED = (52, 18, 72), (239, 236, 229), (180, 184, 188)
LARGEST_PAGE = 1e4  # bytes a block, beside those that every page has
PAGE_WITHOUT_BLOCKS = 5e4  # bytes
# The wall: x and z of its slab, and of what stands on it.
SLAB, WALL = ((-0.5, 4.5), (-0.25, 0.)), ((0., 4.), (0., 3.))


def expect(what, condition):
    if not condition:
        sys.exit(f"{what}: not as expected")


def browser(*arguments):
    for program in ("chromium", "chromedriver"):
        expect(f"{program}, of the packages chromium and chromium-driver",
               shutil.which(program))
    options = webdriver.ChromeOptions()
    for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage",
                     "--window-size=1200,1000", "--force-device-scale-factor=1",
                     *arguments):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    options.binary_location = shutil.which("chromium")
    return webdriver.Chrome(service=Service(shutil.which("chromedriver")),
                            options=options)


class Page:
    """A page in the browser."""

    def __init__(self, driver, name, place=""):
        self.driver, self.name = driver, name
        driver.get("about:blank")
        driver.get(f"file://{DIRECTORY}/{name}.html{place}")

    def expect(self, what, condition):
        expect(f"{self.name}: {what}", condition)

    def js(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def settle(self):
        """Wait until what was asked for is drawn."""
        self.driver.execute_async_script(
            "const done = arguments[0]; requestAnimationFrame(() =>"
            " requestAnimationFrame(() => done()))")

    def set(self, name, value):
        self.js("const e = document.getElementById(arguments[0]);"
                "if (e.type === 'checkbox') e.checked = arguments[1];"
                "else e.value = arguments[1]; e.dispatchEvent(new Event('input'))",
                name, value)
        self.settle()

    def turn(self, name):
        self.driver.find_element(By.XPATH, f"//button[text()='{name}']").click()
        self.settle()

    def pixels(self):
        """What the canvas has drawn."""
        png = self.js("return document.getElementById('view').toDataURL()")
        picture = Image.open(io.BytesIO(base64.b64decode(png.split(",")[1])))
        return np.asarray(picture.convert("RGB")).astype(int)

    def click(self, x, y):
        canvas = self.driver.find_element(By.ID, "view")
        size = self.js("return [arguments[0].offsetWidth, arguments[0].offsetHeight,"
                       " arguments[0].clientLeft, arguments[0].clientTop]", canvas)
        ActionChains(self.driver).move_to_element_with_offset(
            canvas, round(x + size[2] - size[0] / 2), round(y + size[3] - size[1] / 2)
        ).click().perform()
        self.settle()
        return self.chosen()

    def chosen(self):
        """The title and the rows of what is chosen."""
        title = self.js("const h = document.querySelector('#numbers h3');"
                        "return h && h.textContent")
        rows = self.js("return [...document.querySelectorAll('#numbers tr')]"
                       ".map(r => [...r.cells].map(c => c.textContent))")
        return title, dict(rows)

    def check_whole(self):
        text = open(f"{DIRECTORY}/{self.name}.html").read()
        self.expect("nothing from elsewhere", not re.search(
            r"(src|href)=\"(?!#|data:,)|url\((?!#)|@import|https?:", text))
        self.expect("nothing loaded", self.js(
            "return performance.getEntriesByType('resource').length") == 0)
        messages = self.driver.get_log("browser")
        # A software renderer says that reading pixels makes it wait.
        messages = [m["message"] for m in messages if "ReadPixels" not in m["message"]]
        self.expect(f"messages of the browser, {messages}", not messages)
        blocks = self.js("return JSON.parse(document.getElementById('data')"
                         ".textContent).cells")
        self.expect(f"size {len(text)}",
                    len(text) < PAGE_WITHOUT_BLOCKS + LARGEST_PAGE * blocks)


def ink(pixels):
    """Where it is not white: the ends along x and y."""
    drawn = (pixels < 250).any(axis=2)
    columns, rows = np.flatnonzero(drawn.any(axis=0)), np.flatnonzero(drawn.any(axis=1))
    return columns[0], columns[-1] + 1, rows[0], rows[-1] + 1


def near(colour, other):
    return np.abs(np.array(colour) - other).max() <= 4


def bricks():
    """The middle of each block of the wall in (x, z), as the program makes it."""
    middles = []
    for course in range(6):
        for b in range(4 + course % 2):
            ends = [min(max(b + k - 0.5 * (course % 2), 0), 4) for k in (0, 1)]
            middles.append((sum(ends) / 2, 0.5 * course + 0.25))
    return middles + [(2., -0.125)]


def check_picks(page):
    """From the front, each block is found in its middle, with its numbers."""
    page.turn("front")
    left, right, top, bottom = ink(page.pixels())
    (x0, x1), (z0, z1) = SLAB[0], (SLAB[1][0], WALL[1][1])
    page.expect("one scale", abs((right - left) / (x1 - x0) - (bottom - top) / (z1 - z0)) < 1.)
    for number, (x, z) in enumerate(bricks()):
        title, rows = page.click(left + (x - x0) / (x1 - x0) * (right - left),
                                 bottom - (z - z0) / (z1 - z0) * (bottom - top))
        page.expect(f"block {number} in its middle, {title}", title == f"Block {number}")
        page.expect(f"numbers of block {number}, {rows}",
                    rows["group"] == ("slab" if number == 27 else "bricks") and
                    float(rows["Number"]) == number and
                    abs(float(rows["centroid x"]) - x) < 1e-5 and
                    abs(float(rows["centroid z"]) - z) < 1e-5 and
                    abs(float(rows["Height (m)"]) - z) < 1e-5)
    page.expect("nothing beside it", page.click(2, 2) == (None, {}))


def check_colours(page):
    """The light falls on the top as it is: the colours of values are seen."""
    page.turn("top")
    for button, wanted in (("Blocks", STONE), ("Height", DARKEST)):
        page.driver.find_element(By.XPATH, f"//label[text()='{button}']").click()
        page.settle()
        pixels = page.pixels()
        left, right, top, bottom = ink(pixels)
        # The middle of the top of the wall, and of the slab beside it.
        on_wall = pixels[(top + bottom) // 2 + 3, (left + right) // 2 + 9]
        on_slab = pixels[top + (bottom - top) // 8, (left + right) // 2 + 9]
        share = on_slab.mean() / np.mean(FIXED)  # of the light
        page.expect(f"light {share}", 0.8 < share <= 1.)
        page.expect(f"colour {on_wall} of {button}", near(on_wall, share * np.array(wanted)))
        page.expect("fixed blocks are grey", near(on_slab, share * np.array(FIXED)))


def check_section(page):
    """A section leaves what is on one side of it, or on the other."""
    page.turn("front")
    left, right, top, bottom = ink(page.pixels())
    scale = (right - left) / 5.
    page.set("axis", "0")
    place = float(page.driver.find_element(By.ID, "cut-at").text.split("=")[1])
    cut = ink(page.pixels())
    page.expect(f"the left of {place}",
                abs(cut[0] - left) < 3 and abs(cut[1] - left - scale * (place + 0.5)) < 3)
    page.set("other", True)
    cut = ink(page.pixels())
    page.expect(f"the right of {place}",
                abs(cut[1] - right) < 3 and abs(cut[0] - left - scale * (place + 0.5)) < 3)
    page.set("other", False)
    # From the right, what is cut is hatched, and belongs to its block.
    page.set("cut", "0.45")
    page.turn("right")
    left, right, top, bottom = ink(page.pixels())
    title, rows = page.click((left + right) / 2, top + (bottom - top) * 0.25 / 3.25)
    page.expect(f"the block that is cut at the top, {title}", title == "Block 24")
    page.set("axis", "")


def check_apart(page):
    """Blocks that lie apart leave gaps in which there are joints."""
    page.turn("front")
    page.set("joints", False)
    whole = page.pixels()
    page.set("apart", "1")
    page.turn("front")
    pixels = page.pixels()
    # The middles are twice as far from that of all, at (2, 1.375).
    wide, high = 4 + 2 * 1.75, 3.25 + 1.375 + 1.5
    left, right, top, bottom = ink(pixels)
    page.expect("twice as far", abs((right - left) / (bottom - top) - wide / high) < 0.01)
    gap = pixels[round(top + (bottom - top) * 0.25 / high), left:right]  # in the top course
    page.expect("gaps", abs((gap == 255).all(axis=1).mean() - 3.5 / wide) < 0.02)
    page.set("joints", True)
    page.expect("joints in them", (page.pixels() != pixels).any())
    page.set("apart", "0")
    page.turn("front")
    page.expect("together again", (page.pixels() == whole).all())


def check_joints(page):
    """A joint is found through clear blocks, and leads to its blocks."""
    page.driver.find_element(By.XPATH, "//label[text()='Normal force']").click()
    page.settle()
    page.expect("blocks let the joints through",
                page.js("return document.getElementById('blocks').value") == "clear")
    page.turn("top")
    left, right, top, bottom = ink(page.pixels())
    title, rows = page.click((left + right) / 2 + 0.3 * (right - left) / 5,
                             (top + bottom) / 2)
    # The highest bed joint at x = 2.3: of the blocks 20 and 24.
    page.expect(f"the joint, {title} {rows}", title.startswith("Joint ") and
                (rows["between block"], rows["and block"]) == ("20", "24") and
                float(rows["area"]) == 0.25 and
                float(rows["Normal force (kN)"]) == -float(title.split()[1]))
    page.driver.find_element(By.XPATH, "//td/button[text()='24']").click()
    title, rows = page.chosen()
    page.expect("its block", title == "Block 24" and "joint with block 20" in rows)
    page.driver.find_element(By.XPATH, "//label[text()='Blocks']").click()
    page.set("blocks", "solid")


def check_motions(page):
    """The view turns, moves and zooms by mouse, wheel and keys, and back."""
    page.turn("oblique")
    before = page.pixels()
    canvas = page.driver.find_element(By.ID, "view")
    seen = {}
    for name, action in (
            ("turned", lambda chain: chain.drag_and_drop_by_offset(canvas, 60, 20)),
            ("moved", lambda chain: chain.key_down(Keys.SHIFT).drag_and_drop_by_offset(
                canvas, 60, 20).key_up(Keys.SHIFT)),
            ("turned by keys", lambda chain: chain.send_keys(Keys.ARROW_LEFT)),
            ("moved by keys", lambda chain: chain.key_down(Keys.SHIFT).send_keys(
                Keys.ARROW_UP).key_up(Keys.SHIFT)),
            ("zoomed by keys", lambda chain: chain.send_keys("+"))):
        page.js("arguments[0].focus()", canvas)
        action(ActionChains(page.driver)).perform()
        page.settle()
        seen[name] = page.pixels()
        page.expect(name, (seen[name] != before).any())
        page.turn("oblique")
        page.expect(f"{name} and back", (page.pixels() == before).all())
    page.expect("moved and turned differ", (seen["moved"] != seen["turned"]).any())
    page.js("arguments[0].dispatchEvent(new WheelEvent('wheel', {deltaY: 400,"
            "clientX: 300, clientY: 400, bubbles: true, cancelable: true}))", canvas)
    page.settle()
    smaller, full = ink(page.pixels()), ink(before)
    page.expect("smaller", smaller[1] - smaller[0] < 0.6 * (full[1] - full[0]))
    page.js("arguments[0].dispatchEvent(new MouseEvent('dblclick'))", canvas)
    page.settle()
    page.expect("all of it again", (page.pixels() == before).all())
    page.set("perspective", True)
    page.expect("perspective", (page.pixels() != before).any())
    page.set("perspective", False)


def check_texts(page):
    page.expect("title", page.driver.find_element(By.TAG_NAME, "h1").text
                == 'A <wall> & "more"')
    page.expect("summary", "27 & 1" in page.driver.find_element(By.ID, "summary").text)
    page.expect("warnings", "Brick 3 is <thin>." in
                page.driver.find_element(By.ID, "warnings").text)
    defects = page.driver.find_element(By.ID, "defects").text
    page.expect("defects", "faces listed <twice>" in defects and
                "taken once" in defects and "and 3 more blocks" in defects)
    page.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    page.expect("the picture in print", page.js(
        "return ['drawing', 'view', 'controls'].map(i => getComputedStyle("
        "document.getElementById(i)).display)") == ["block", "none", "none"])
    page.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
    page.expect("a page to print", len(page.driver.print_page()) > 10000)


def check_with_view(driver):
    page = Page(driver, "wall")
    page.expect("a view in space", page.js(
        "return document.body.classList.contains('in-space')"))
    page.settle()
    for check in (check_picks, check_colours, check_section, check_apart, check_joints,
                  check_motions, check_texts):
        check(page)
    page.check_whole()
    page = Page(driver, "wall", "#block=12&colour=2")
    page.expect("a block by the address", page.chosen()[0] == "Block 12" and
                page.js("return document.getElementById('colour-2').checked"))
    page = Page(driver, "notched")
    page.turn("front")
    left, right, top, bottom = ink(page.pixels())
    third = (right - left) / 3
    for x, z, block in ((0.5, 2.5, 0), (1.5, 1.5, 1), (2.5, 0.5, 0)):
        title, _ = page.click(left + x * third, bottom - z * third)
        page.expect(f"block {block} at {x}, {z}", title == f"Block {block}")
    for x, z in ((2.5, 1.5), (1.15, 2.5)):
        page.expect("nothing above the notch",
                    page.click(left + x * third, bottom - z * third)[0] is None)
    page.check_whole()
    page = Page(driver, "empty")
    page.expect("no view of nothing", "There are no blocks." in
                page.driver.find_element(By.ID, "stage").text)
    page.check_whole()
    page = Page(driver, "many", "#block=777")
    title = page.chosen()[0]
    page.expect(f"one of many blocks, {title}", title == "Block 777")
    page.check_whole()


def check_without_view(driver):
    """Where there is no WebGL the picture is there, and tells numbers, too."""
    page = Page(driver, "wall", "#colour=1")
    page.expect("the picture alone", page.js(
        "return ['drawing', 'view', 'controls'].map(i => getComputedStyle("
        "document.getElementById(i)).display)") == ["block", "none", "none"])
    page.expect("no choice that shows nothing", not page.driver.find_element(
        By.XPATH, "//label[text()='Normal force']").is_displayed())
    top = page.driver.find_elements(By.CSS_SELECTOR, "[data-cell='26'] polygon")[-1]
    top.click()
    page.expect("a block of the picture", page.chosen()[0] == "Block 26")
    fill = page.js("return [...document.querySelectorAll('.cell')].map(g =>"
                   " getComputedStyle(g).getPropertyValue('--colour'))")
    page.expect("the darkest", fill.count("#341248") >= 1)
    fixed = page.js("return getComputedStyle(document.querySelector('.fixed'))"
                    ".getPropertyValue('--colour')")
    page.expect("the fixed one", fixed.strip() == "#b4b8bc")
    page = Page(driver, "many")
    page.expect("why there is no picture", "18000 faces" in
                page.driver.find_element(By.ID, "stage").text)


def main():
    shutil.rmtree(DIRECTORY, ignore_errors=True)
    subprocess.run([sys.argv[1], DIRECTORY], check=True)
    for check, arguments in (
            (check_with_view, ("--use-angle=swiftshader", "--enable-unsafe-swiftshader")),
            (check_without_view, ("--disable-gpu", "--disable-3d-apis"))):
        driver = browser(*arguments)
        try:
            driver.set_script_timeout(120)  # software draws slowly
            check(driver)
        finally:
            driver.quit()
    print("OK")


main()
