"""Pictures of all scenes by render.py: their size and colours, and refusals.

    pvbatch check_pictures.py VOUSSOIR SOURCE_DIRECTORY
"""
import contextlib
import glob
import io
import os
import re
import shutil
import subprocess
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

PROGRAM, SOURCE = sys.argv[1:]
sys.path.insert(0, f"{SOURCE}/contrib/paraview")
import pictures  # noqa: E402
import render  # noqa: E402

WIDTH = 240
BLUE, RED = (23, 71, 153), (168, 18, 31)  # the ends of the colours
HALF_BLUE, WHITE = (115, 168, 217), (247, 247, 247)
MOST = (140, 8, 46)  # utilisation or displacement at its largest
STRESSES = {"sigma_xx", "sigma_xy", "sigma_yy", "von_mises"}
SOLVED = STRESSES | {"principal", "chains", "utilisation", "blocks", "displacement"}


def expect(what, condition):
    if not condition:
        sys.exit(f"{what}: not as expected")


def run(scene, name, *settings, status=0):
    """The directory of results."""
    command = [PROGRAM, f"{SOURCE}/prm/{scene}.prm",
               "--set", f"Output directory=pictures/{name}"]
    for setting in settings:
        command += ["--set", setting]
    done = subprocess.run(command, capture_output=True, text=True)
    expect(f"status of {name}, {done.stderr}", done.returncode == status)
    return f"pictures/{name}"


def pixels(file):
    """(height, width, 3)"""
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    return values.reshape(height, width, -1)[::-1].astype(int)


def view(name, *directories, width=WIDTH, options=()):
    file = f"pictures/{name}.png"
    expect(f"status of {name}", render.main(
        [name, file, *directories, "--width", str(width), *options]) == 0)
    image = pixels(file)
    expect(f"width of {name}", image.shape[1] == width)
    return image


def share(image, colour):
    """Of the pixels, those of a colour, to rounding."""
    return (np.abs(image - colour).max(axis=2) <= 1).mean()


def expect_views(directory, views):
    """That all of them are made, with something in the upper part of each."""
    folder = directory + "_pictures"
    expect(folder, render.main(["all", folder, directory, "--width", str(WIDTH)]) == 0)
    made = {os.path.splitext(name)[0] for name in os.listdir(folder)}
    expect(f"views of {directory}, {made}", made == views)
    for file in glob.glob(f"{folder}/*.png"):
        image = pixels(file)
        height, width, _ = image.shape
        expect(f"size of {file}", width == WIDTH and 60 < height < 2 * WIDTH)
        drawn = (image[:height // 2] != 255).any(axis=2).mean()
        expect(f"{file}: {drawn} drawn", drawn > 0.02)
        expect(f"corner of {file}", (image[0, 0] == 255).all())


def expect_refusal(arguments, message):
    with contextlib.redirect_stderr(io.StringIO()) as found:
        status = render.main(arguments)
    expect(f"status of {arguments}", status == 2)
    expect(f"{found.getvalue()!r}, not {message!r}",
           found.getvalue() == f"render.py: {message}\n")
    expect("nothing is written", not glob.glob("pictures/**/*refused*", recursive=True))


def check_scenes():
    for file in sorted(glob.glob(f"{SOURCE}/prm/*.prm")):
        scene = os.path.splitext(os.path.basename(file))[0]
        few = (["Packing/Voronoi/Number of points=100"]
               if scene == "million_cells" else [])
        expect_views(run(scene, scene, *few), SOLVED)
    collapse = run("arch", "collapse", "Friction/Strength=12.9", status=3)
    expect_views(collapse, {"mechanism", "animation"})
    expect("frames", os.path.getsize(
        "pictures/collapse_pictures/animation.ogv") > 10000)
    expect("frames as pictures", render.main(
        ["animation", "pictures/frame_%02d.png", collapse, "--width", "120"]) == 0)
    first, middle = (pixels(f"pictures/frame_{i:02d}.png") for i in (0, 12))
    expect("frames have one size", first.shape == middle.shape)
    expect("frames move", (first != middle).any(axis=2).mean() > 0.05)


def check_colours():
    uniform = "pictures/verification_1"
    image = view("sigma_xx", uniform, options=["--limit", "1"])
    expect("-1 of 1 is the end of the blue", share(image, BLUE) > 0.6)
    expect("red is in the bar alone", share(image, RED) < 0.01)
    image = view("sigma_xx", uniform, options=["--limit", "2"])
    expect("-1 of 2 is half of it", share(image, HALF_BLUE) > 0.6)
    image = view("sigma_xx", uniform, uniform, width=500, options=["--limit", "2"])
    expect("panels are beside each other", image.shape[0] < 350 and
           min(share(half, HALF_BLUE) for half in np.split(image, 2, axis=1)) > 0.5)
    image = view("von_mises", uniform)
    expect("what is not negative ends in the darkest, and has no blue",
           share(image, MOST) > 0.6 and share(image, BLUE) + share(image, RED) == 0)
    image = view("sigma_xy", "pictures/homogeneous_compression")
    expect("rounding is white", share(image, WHITE) > 0.3 and
           share(image, BLUE) + share(image, RED) < 0.01)
    image = view("principal", "pictures/homogeneous_compression", width=600)
    expect("pressure has blue crosses", share(image, BLUE) > 0.05 and
           share(image, RED) < 0.005)
    expect("no chains without normal forces",
           share(view("chains", "pictures/shear_wall"), BLUE) < 0.02)
    image = view("chains", "pictures/arch", width=600)
    expect("chains of the arch", share(image[:240], BLUE) > 0.01)
    image = view("utilisation", "pictures/arch", width=600)
    expect("joints that slide", share(image[:240], MOST) > 0.002)
    image = view("principal", "pictures/arch", width=600, options=["--sub-cells"])
    expect("crosses of sub-cells", share(image[:240], BLUE) > 0.003)
    image = view("mechanism", "pictures/collapse")
    expect("the middle falls", share(image, MOST) > 0.02)


def check_extremes():
    """Sizes of one block and of any unit look alike; a draft has its blocks."""
    one = run("shear_wall", "one", "Packing/wall/Courses=1",
              "Packing/wall/Bricks per course=1")
    expect_views(one, SOLVED)
    usual = view("sigma_xy", "pictures/shear_wall")
    for size in ("1e-6", "1e6"):
        other = run("shear_wall", size, f"Packing/wall/Width={size}",
                    f"Packing/wall/Height={size}")
        difference = np.abs(view("sigma_xy", other) - usual).mean()
        expect(f"lengths of {size}, {difference}", difference < 1)
    draft = run("verification_1", "draft", "Accuracy=draft")
    expect("draft", not os.path.exists(f"{draft}/stress.vtu"))
    expect("the means of a draft", share(view("sigma_xx", draft), BLUE) > 0.6)


def check_refusals():
    arch, collapse, to = "pictures/arch", "pictures/collapse", "pictures/refused.png"
    views, here = ", ".join(render.VIEWS), os.getcwd()
    os.makedirs("pictures/empty")
    os.makedirs("pictures/folder.png")
    for arguments, message in (
            ([["sigma_zz", to, arch]],
             f"There is no view 'sigma_zz'; choose one of {views}, or all."),
            ([["sigma_xx", to, "nowhere"]], "There is no directory 'nowhere'."),
            ([["sigma_xx", to, "pictures/empty"]],
             "'pictures/empty' holds no results of voussoir: it has no summary.json "
             "that can be read."),
            ([["mechanism", to, arch]],
             f"The view 'mechanism' needs mechanism.vtu, which '{arch}' does not "
             "have; its status is 'solved'."),
            ([["sigma_xx", to, arch, collapse]],
             f"The view 'sigma_xx' needs blocks.vtu, which '{collapse}' does not "
             "have; its status is 'collapse'."),
            ([["sigma_xx", to, arch, "--limit", "0"]], "The limit must be positive."),
            ([["sigma_xx", to, arch, "--titles", "one;two"]],
             "Give as many titles as directories."),
            ([["sigma_xx", "refused.jpg", arch]],
             "A picture is a .png, and 'refused.jpg' is not."),
            ([["sigma_xx", "refused.ogv", arch]],
             "A picture is a .png, and 'refused.ogv' is not."),
            ([["sigma_xx", f"{here}/nowhere/refused.png", arch]],
             f"There is no directory '{here}/nowhere' for the picture."),
            ([["all", f"{here}/nowhere/pictures", arch]],
             f"There is no directory '{here}/nowhere' for the picture."),
            ([["all", f"{arch}/summary.json", arch]],
             f"'{arch}/summary.json' is not a directory."),
            ([["sigma_xx", "pictures/folder.png", arch]],
             "'pictures/folder.png' is a directory."),
            ([["sigma_xx", "/proc/refused.png", arch]],
             "'/proc/refused.png' cannot be written."),
            ([["animation", "/proc/refused.ogv", collapse]],
             "'/proc/refused.ogv' cannot be written."),
            ([["sigma_xx", to]], "The following arguments are required: DIRECTORY; "
             "see --help.")):
        expect_refusal(*arguments, message)
    for name in ("", "%s", "%02d%02d", "%%02d", "100%", "%999999d"):
        file = f"pictures/refused{name}.png"
        expect_refusal(["animation", file, collapse], "An animation is an .ogv, or "
                       "frames with a number in their names, as NAME_%02d.png, and "
                       f"'{file}' is neither.")
    broken = shutil.copytree(arch, "pictures/broken")
    shutil.copy(f"{arch}/interfaces.vtu", f"{broken}/blocks.vtu")
    expect_refusal(["principal", to, broken], "The results have no 'stress'; make "
                   "them again with this version of voussoir.")
    with open(f"{broken}/blocks.vtu", "w") as file:
        file.write("no grid")
    expect_refusal(["principal", to, broken], f"'{broken}' has no blocks.vtu that "
                   "can be read; its status is 'solved'.")
    done = subprocess.run(["pvbatch", f"{SOURCE}/contrib/paraview/render.py",
                           "sigma_xx", to, "nowhere"], capture_output=True, text=True)
    expect(f"as a program: {done}", (done.returncode, done.stderr) == (
        2, "render.py: There is no directory 'nowhere'.\n"))


def check_macro():
    """The macro in a window's pipeline, from results.pvd, run as by its button."""
    from paraview.simple import (FindSource, GetActiveViewOrCreate, OpenDataFile,
                                 SaveScreenshot, SetActiveSource)
    with open(f"{SOURCE}/contrib/paraview/macro.py") as file:
        macro = compile(file.read(), "macro", "exec")
    as_button = {"__name__": "__vtkconsole__", "__file__": file.name}
    for directory, names in (("arch", {"Stress": 84, "Outlines": 21, "Crosses": 42,
                                       "Chains": 42}),
                             ("collapse", {"Mechanism": 21, "At rest": 21})):
        SetActiveSource(OpenDataFile(f"pictures/{directory}/results.pvd"))
        exec(macro, dict(as_button))
        if directory == "arch":  # again, from what it has made
            SetActiveSource(FindSource("Chains"))
            exec(macro, dict(as_button))
        for name, n_cells in names.items():
            found = FindSource(name).GetDataInformation().GetNumberOfCells()
            expect(f"{name} of {directory}, {found}", found == n_cells)
    SaveScreenshot("pictures/macro.png", GetActiveViewOrCreate("RenderView"))
    expect("the window is not blank", pixels("pictures/macro.png").std() > 5)


def check_documentation():
    """Pages and pictures know of each other, and contrib/pictures of the latter."""
    images, used = f"{SOURCE}/doc/images", set()
    for page in [f"{SOURCE}/README.md", *glob.glob(f"{SOURCE}/doc/*.md")]:
        with open(page) as file:
            used |= set(re.findall(r"images/(\w+)\.png", file.read()))
    there = {name[:-4] for name in os.listdir(images)}
    expect(f"pictures that no page shows or that are missing, {used ^ there}",
           used == there)
    made = {name for name in there if not name.startswith(("accuracy_", "cost_"))}
    defined = [picture[0] for picture in pictures.PICTURES]
    expect(f"pictures that contrib/pictures makes, {made ^ set(defined)}",
           made == set(defined) and len(defined) == len(made))
    for page in ("gallery", "tutorial"):
        with open(f"{SOURCE}/doc/{page}.md") as file:
            text = file.read()
        shown = set(re.findall(r"images/(\w+)\.png", text))
        named = set(re.findall(r"contrib/pictures\s+--only\s+(\w+)", text)) - {"NAME"}
        expect(f"pictures of the {page} and their commands, {named ^ shown}",
               named == shown)
    with open(f"{SOURCE}/doc/gallery.md") as file:
        text = file.read()
    missing = [scene for scene in os.listdir(f"{SOURCE}/prm")
               if scene.endswith(".prm") and f"../prm/{scene}" not in text]
    expect(f"scenes that the gallery lacks, {missing}", not missing)


shutil.rmtree("pictures", ignore_errors=True)
os.makedirs("pictures")
for check in (check_scenes, check_colours, check_extremes, check_refusals,
              check_macro, check_documentation):
    check()
print("The pictures are as they should be")
