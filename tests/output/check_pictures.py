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
from macro import chains  # noqa: E402
from space_views import (  # noqa: E402
    LIGHT, SHADE, SUPPORT, cut, faces_of, following, half_space, sizes_of_motion)
from voussoir_views import (  # noqa: E402
    COMPRESSION, MIDDLE_THIRD, ONE_SIGN, Results, interpolate)

WIDTH = 240
BLUE, RED = (23, 71, 153), (168, 18, 31)  # the ends of the colours
WHITE = (247, 247, 247)
DARKEST = (51, 18, 71)  # the largest stress where all have one sign
HALF = tuple(np.round(255 * interpolate(ONE_SIGN, [0.5])[0]))
MOST = (140, 8, 46)  # utilisation or displacement at its largest
LOAD = (191, 41, 20)
STRESSES = {"sigma_xx", "sigma_xy", "sigma_yy", "von_mises"}
SOLVED = STRESSES | {"principal", "chains", "resultants", "loads", "utilisation",
                     "blocks", "displacement"}
PURE_SHEAR = SOLVED - {"chains"}
IN_SPACE = {"blocks", "volume", "joints"}
# Scenes with Rotations = true.
TURNING = {"arch_on_piers", "grains", "portal", "rocking_column", "semicircular_arch",
           "sinking_pier", "spreading_arch", "tied_arch"}
# Those of load factors, which turn, too, and have a state and a mechanism.
FACTORS = {"arch_bridge", "block_on_incline", "bridge_with_fill", "bridge_with_lorry",
           "arch_until_it_falls", "buttress", "compas_arch", "dry_arch", "dry_stone_wall", "facade",
           "ferris_tin_loi_1", "ferris_tin_loi_2", "floors_on_wall", "gateway", "rocking_wall",
           "through_stones", "two_leaf_wall", "two_ring_arch", "two_span_bridge"}
# Those whose supports move: a state and a motion.
MOVED = {"sinking_pier", "spreading_arch"}


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


def has_colour(image, colour):
    """Of each pixel, to rounding."""
    return np.abs(image - colour).max(axis=2) <= 1


def share(image, colour):
    return has_colour(image, colour).mean()


def above_legend(name, directory, *words, width=1000):
    """The pixels of a view, and where in the packing they are."""
    image = view(name, directory, width=width, options=words)
    options = render.parse([name, "", directory, "--width", str(width), *words])
    panel, = render.Picture(name, [render.Results(directory)], options).panels()
    layout = render.Layout([panel.bounds()], options, False)
    middle, scale = layout.place(0)
    x, y = np.meshgrid(np.arange(width) + 0.5, len(image) - np.arange(len(image)) - 0.5)
    places = (np.stack((x, y), axis=2) - middle) / scale + sum(panel.bounds()) / 2
    n_rows = len(image) - int(layout.legend)
    return image[:n_rows], places[:n_rows]


def places_of(colour, name, directory):
    image, places = above_legend(name, directory)
    return places[has_colour(image, colour)]


def dots(directory):
    """The middles of the dots of a mechanism that are not above each other."""
    places = places_of(BLUE, "mechanism", directory)
    places = places[places[:, 0].argsort()]
    gaps = np.flatnonzero(np.diff(places[:, 0]) > 0.05)
    return np.array([dot.mean(axis=0) for dot in np.split(places, gaps + 1)])


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
        views = set(PURE_SHEAR if scene == "shear_wall" else SOLVED)
        if scene in TURNING | FACTORS:
            views |= {"thrust", "eccentricity"}
        if scene in FACTORS | MOVED:
            views |= {"mechanism", "animation"}
        expect_views(run(scene, scene, *few), views)
    ranges = run("shear_wall", "ranges", "Ranges/Where=1")
    expect_views(ranges, PURE_SHEAR | {"ranges"})
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
    expect("-1 of 1 is the end of the colours", share(image, DARKEST) > 0.6)
    expect("one sign has no colours of two",
           share(image, BLUE) + share(image, RED) == 0)
    image = view("sigma_xx", uniform, options=["--limit", "2"])
    expect("-1 of 2 is half of it", share(image, HALF) > 0.6)
    image = view("sigma_xx", uniform, uniform, width=500, options=["--limit", "2"])
    expect("panels are beside each other", image.shape[0] < 350 and
           min(share(half, HALF) for half in np.split(image, 2, axis=1)) > 0.5)
    image = view("von_mises", uniform)
    expect("what is not negative ends in the darkest, and has no blue",
           share(image, DARKEST) > 0.6 and
           share(image, BLUE) + share(image, RED) == 0)
    both = view("sigma_xx", uniform, "pictures/arch", width=500)
    expect("panels of both signs have the colours of two", share(both, BLUE) > 0.001 and
           share(both, DARKEST) == 0)
    image = view("sigma_xy", "pictures/homogeneous_compression")
    expect("rounding is white", share(image, WHITE) > 0.3 and
           share(image, BLUE) + share(image, RED) < 0.01)
    image = view("principal", "pictures/homogeneous_compression", width=600)
    expect("pressure has blue crosses", share(image, BLUE) > 0.05 and
           share(image, RED) < 0.005)
    image = view("chains", "pictures/arch", width=600)
    expect("chains of the arch", share(image[:240], BLUE) > 0.01)
    image = view("utilisation", "pictures/arch", width=600)
    expect("joints that slide", share(image[:240], MOST) > 0.002)
    image = view("principal", "pictures/arch", width=600, options=["--sub-cells"])
    expect("crosses of sub-cells", share(image[:240], BLUE) > 0.003)
    image = view("mechanism", "pictures/collapse")
    expect("the middle falls", share(image, MOST) > 0.02)


def check_thrust():
    """Of the column, x = 0.25 + 0.099 (2.5 - y) from joint to joint: a push of 0.198
    of the weight above, at half its height. In its top block the line leaves the
    centre along the resultant. The arch is about as thin as can be."""
    column, arch = "pictures/rocking_column", "pictures/semicircular_arch"
    x, y = places_of(BLUE, "thrust", column).T
    below, top_block = 0.25 + 0.099 * (2.5 - y), 0.25 + 0.198 * (2.375 - y)
    off = x - np.where(y < 2.25, below, top_block)
    expect(f"the column's line of thrust, off by {np.abs(off).max()}",
           np.abs(off).max() < 0.017 and abs(off.mean()) < 0.002)
    expect("it goes from top to bottom", y.min() < 0.01 and y.max() > 2.36)
    image, places = above_legend("eccentricity", column)
    for k in range(1, 11):
        colour = interpolate(MIDDLE_THIRD, [2 * 0.099 * 0.25 * k / 0.5])[0]
        expect(f"blue in the middle third, {k}", (colour[2] > colour[0]) == (k <= 3))
        x, y = places[has_colour(image, np.round(255 * colour))].T
        expect(f"joint {k} has its colour", np.ptp(x) > 0.48 and
               np.abs(y - 2.5 + 0.25 * k).max() < 0.03)
    places = places_of(BLUE, "thrust", arch)
    radius = np.hypot(*places.T)
    from_crown = np.degrees(np.arctan2(np.abs(places[:, 0]), places[:, 1]))
    expect("the arch's line of thrust is in the arch", np.abs(radius - 1).max() < 0.06)
    for angle, at in ((0, 1.05375), (54, 0.94625), (90, 1.05375)):
        found = radius[np.abs(from_crown - angle) < 0.5]
        expect(f"at {angle} degrees it is at {at}, {found}",
               len(found) > 0 and np.abs(found - at).max() < 0.007)
    wall = run("tutorial_wall", "turning_wall", "Rotations=true")
    x, y = places_of(BLUE, "thrust", wall).T
    expect("lines of blocks with several joints", len(x) > 10000)
    for left, bottom, right, top in ((0.75, 0, 1.75, 2), (2.5, 0.8, 3.5, 1.6)):
        expect("they stay inside the blocks", not (
            (left < x) & (x < right) & (bottom < y) & (y < top)).any())


def check_forces():
    """Of the column, in whose joints the resultants are those of its thrust, and
    whose loads act at the centroids of its blocks, downwards and to the right."""
    column = "pictures/rocking_column"
    x, y = places_of(BLUE, "resultants", column).T
    for k in range(1, 10):
        at = np.abs(y - 0.25 * k) < 0.004
        off = x[at].mean() - 0.25 - 0.099 * (2.5 - 0.25 * k)
        expect(f"the resultant in joint {k}, off by {off}", abs(off) < 0.005)
    x, y = places_of(LOAD, "loads", column).T
    for k in range(10):
        head = (np.abs(x - 0.25) < 0.01) & (y > 0.25 * k + 0.1) & (y < 0.25 * k + 0.2)
        off = y[head].min() - 0.25 * k - 0.125
        expect(f"the load of block {k} ends off by {off}", abs(off) < 0.01)
    expect("and comes from the left", x.min() < 0.2 and x.max() < 0.3)
    wall = "pictures/wall_with_openings"
    x, y = places_of(LOAD, "loads", wall).T
    expect("the traction on top ends there", (y > 3.02).any() and y.max() < 3.6)


def check_hinges():
    """Crown, haunches and springings of the arch move as the two rigid parts of
    either half do: the haunch turns about the springing, the crown goes down, and
    to first order their distance stays."""
    thickness, n = 0.1074, 40
    arch = run("semicircular_arch", "hinges", f"Packing/arch/Voussoirs={n}",
               f"Packing/arch/Thickness={thickness}", status=3)
    found = dots(arch)
    expect(f"five hinges, {found}", len(found) == 5)
    inner, outer, angle = 1 - thickness / 2, 1 + thickness / 2, np.radians(36)
    foot, crown = np.array([outer, 0]), np.array([0, outer])
    haunch = inner * np.array([np.cos(angle), np.sin(angle)])
    turning = np.array([foot[1] - haunch[1], haunch[0] - foot[0]])
    chord = crown - haunch
    turn = -(crown[1] - found[2][1]) * chord[1] / (turning @ chord)
    haunch += turn * turning
    expected = [-foot, haunch * (-1, 1), found[2] * (0, 1), haunch, foot]
    expect(f"where they are, {found}, not {expected}", crown[1] - found[2][1] > 0.05 and
           np.abs(found - expected).max() < 0.005)
    expect_views(arch, {"mechanism", "animation"})
    expect("an animation of hinges", render.main(
        ["animation", "pictures/hinge_%02d.png", arch, "--width", "400"]) == 0)
    first, middle = (has_colour(pixels(f"pictures/hinge_{i:02d}.png"), BLUE)
                     for i in (0, 12))
    expect("dots move", first.any() and middle.any() and (first != middle).any())
    column = run("rocking_column", "overturns", "Loads/Body force=4.01; -20", status=3)
    found = dots(column)
    expect(f"the column's hinge, {found}", len(found) == 1 and
           np.abs(found - (0.5, 0)).max() < 0.005)
    joints = f"{column}/mechanism_joints.csv"
    with open(joints) as file:
        header, first, *others = file.read().splitlines()
    first = ",".join(first.split(",")[:-2] + ["1e-3", "0"])
    with open(joints, "w") as file:
        print(header, first, *others, sep="\n", file=file)
    expect("a joint that hardly opens has no hinge", len(dots(column)) == 1)
    with open("pictures/base.wkt", "w") as file:
        print("POLYGON ((0 0, 0.5 0, 1 0, 1 3, 0 3, 0 0))", file=file)
    pieces = run("rocking_column", "pieces", "Packing/Generator=polygons",
                 f"Packing/polygons/File={os.getcwd()}/pictures/base.wkt",
                 "Loads/Body force=10; -20", status=3)
    found = dots(pieces)
    expect(f"a base of two pieces alike turns about its corner, {found}",
           len(found) == 1 and found[0][0] > 0.99 and abs(found[0][1]) < 0.01)
    expect("nothing turns without rotations",
           share(view("mechanism", "pictures/collapse"), BLUE) == 0)
    options = render.parse(["mechanism", "", arch])
    for directory, words in ((arch, "; a dot is a hinge"), ("pictures/collapse", "")):
        title = render.Picture("mechanism", [render.Results(directory)],
                               options).legend_title()
        expect(title, title.endswith("scale of the picture" + words))


def check_extremes():
    """Sizes of one block and of any unit look alike; a draft has its blocks."""
    one = run("shear_wall", "one", "Packing/wall/Courses=1",
              "Packing/wall/Bricks per course=1")
    expect_views(one, PURE_SHEAR)
    usual = view("sigma_xy", "pictures/shear_wall")
    for size in ("1e-6", "1e6"):
        other = run("shear_wall", size, f"Packing/wall/Width={size}",
                    f"Packing/wall/Height={size}")
        difference = np.abs(view("sigma_xy", other) - usual).mean()
        expect(f"lengths of {size}, {difference}", difference < 1)
    draft = run("verification_1", "draft", "Accuracy=draft")
    expect("draft", not os.path.exists(f"{draft}/stress.vtu"))
    expect("the means of a draft", share(view("sigma_xx", draft), DARKEST) > 0.6)


def views_in_space(directory):
    """Of blocks, and of what was answered on loads."""
    summary = Results(directory).summary
    views = set(IN_SPACE)
    if "certificate" in summary:
        views |= {"principal_stress_min", "utilisation", "principal", "trajectories"}
    if not summary.get("load_factor", {}).get("unbounded", True):
        views.add("mechanism")
    return views


def check_space():
    """Scenes in space; a cube from above, cut, and taken apart; what is not convex."""
    of_answers = set()
    for file in glob.glob(f"{SOURCE}/prm/space/**/*.prm", recursive=True):
        scene = os.path.relpath(file, f"{SOURCE}/prm")[:-4]
        directory = run(scene, scene.replace("/", "_"))
        views = views_in_space(directory)
        of_answers |= views
        expect_views(directory, views)
    expect("answers in space are shown", len(of_answers - IN_SPACE) == 5)
    expect_fall()
    expect_tetrahedra()
    expect_bars()
    cube = run("space/grains", "cube", "Packing/Voronoi/Number of points=1")
    alone = run("space/grains", "alone", "Packing/Voronoi/Number of points=1",
                "Supports/Where=0")
    expect_views(alone, views_in_space(alone) - {"joints", "utilisation"})
    above = "--from=0,0,1"
    image = view("volume", cube, options=[above])
    lit = np.array(MOST) * (SHADE + (1 - SHADE) * LIGHT[2])
    expect("the top of a cube, in the light", share(image, np.round(lit)) > 0.6)
    image = view("volume", cube, options=[above, "--cut=z > 0.5"])
    expect("a cut, which has no shade", share(image, MOST) > 0.6)
    image = view("joints", cube, options=["--from=0,0,-1"])
    lit = 255 * np.array(SUPPORT) * (SHADE + (1 - SHADE) * LIGHT[2])
    expect("its support from below", share(image, np.round(lit)) > 0.6)
    expect_half_of_the_dome()
    grains = "pictures/space_models_tessellation"
    together, apart = (view("volume", grains, options=["--apart", factor])[:WIDTH]
                       for factor in ("0", "1"))
    expect("there is room between blocks that are apart",
           share(apart, (255, 255, 255)) > share(together, (255, 255, 255)) + 0.1)
    # The snake fills 0.23 of the rectangle around its side.
    image, _ = above_legend("blocks", "pictures/space_models_snake", "--from=0,-1,0")
    drawn = 1 - share(image, (255, 255, 255))
    expect(f"what is not convex is not filled, {drawn}", 0.2 < drawn < 0.3)


def expect_tetrahedra():
    """Those of the paper's stress fill the box; its skew part has no mean in a block."""
    directory = run("space/grains", "tetrahedra", "Accuracy=standard",
                    "Packing/Voronoi/Number of points=30")
    grid = Results(directory).read("stress.vtu")
    fields = {name: vtk_to_numpy(grid.GetCellData().GetArray(name))
              for name in ("stress", "skew", "principal_stress_1", "cell")}
    corners = vtk_to_numpy(grid.GetPoints().GetData()).reshape(-1, 4, 3)
    volume = np.linalg.det(corners[:, :3] - corners[:, 3:]) / 6
    expect("tetrahedra fill the box", (volume > 0).all() and abs(volume.sum() - 1) < 1e-12)
    sigma = fields["stress"].reshape(-1, 3, 3)
    half = (sigma - sigma.transpose(0, 2, 1)) / 2
    expect("skew parts", np.allclose(fields["skew"] ** 2, (half ** 2).sum((1, 2)) / 2) and
           fields["skew"].max() > 0)
    expect("the largest principal stress", np.allclose(
        fields["principal_stress_1"], np.linalg.eigvalsh(sigma - half)[:, 2]))
    for axis in ((0, 1), (1, 2), (2, 0)):
        of_blocks = np.bincount(fields["cell"], volume * half[:, axis[0], axis[1]])
        expect("means are symmetric", np.abs(of_blocks).max() < 1e-12)


def expect_fall():
    """A dome that collapses: one block is the fastest, and it spreads."""
    dome = run("space/dome", "fallen", "Analysis=state", "Packing/dome/Thickness=0.03",
               "Packing/dome/Bond=stack", status=3)
    expect("a mechanism", "mechanism" in Results(dome).summary)
    expect_views(dome, IN_SPACE | {"mechanism"})
    sizes = sizes_of_motion(Results(dome))
    expect("sizes of the motion", sizes.max() == 1 and sizes.min() < 0.9)

    def extent(name):
        options = render.parse([name, "", dome, "--from=0,0,1"])
        panel, = render.Picture(name, [Results(dome)], options).panels()
        return np.ptp(panel.bounds(), axis=0)
    expect("it spreads", (extent("mechanism") > 1.001 * extent("blocks")).all())


def expect_bars():
    """A column of ten blocks under its weight, from the front: in the middle of each an
    arm as long as its depth says, and a trajectory from top to bottom."""
    column = run("space/wall", "column", "Analysis=state", "Packing/wall/Bond=stack",
                 "Packing/wall/Length=0.4", "Packing/wall/Thickness=0.4",
                 "Packing/wall/Height=2", "Packing/wall/Openings=",
                 "Packing/wall/Brick length=0.4", "Packing/wall/Brick width=0.4",
                 "Packing/wall/Brick height=0.2", "Loads/Body force=0; 0; -20")
    front, size = ("--from=0,-1,0", "--limit=80"), np.cbrt(0.4 * 0.4 * 0.2)
    lit = np.round(np.array(COMPRESSION) * 255 * (SHADE + (1 - SHADE) * LIGHT[2]))

    def blue(*words):
        image, places = above_legend("principal", column, *front, *words)
        return places[has_colour(image, lit)].T
    x, y = blue()
    expect("arms are in the middle, and as wide as said",
           abs(np.ptp(x) - 0.09 * size) < 0.01 and abs(x.mean()) < 0.002)
    for k in range(10):
        depth = 1.9 - 0.2 * k
        found = y[np.abs(y + depth - 1) < 0.1]
        expected = size * 20 * depth / 80
        expect(f"the arm of block {k}, {np.ptp(found)}, not {expected}",
               abs(np.ptp(found) - expected) < 0.01)
    _, apart = blue("--apart=1")
    expect("arms move apart with their blocks", 1.8 < np.ptp(apart) / np.ptp(y) < 2.2)
    _, cut = blue("--cut=z > 1")
    expect(f"arms are cut with their blocks, {np.ptp(cut)}", 0.8 < np.ptp(cut) < 1)
    image, places = above_legend("trajectories", column, *front)
    x, y = places[image[:, :, 2] - image[:, :, 0] > 30].T
    expect("a straight line from the ground to the top", np.abs(x).max() < 0.02 and
           abs(np.ptp(y) - 2) < 0.03)


def expect_half_of_the_dome():
    """Half of the volume, of blocks that are closed: the vector areas of their faces
    add up to nothing."""
    dome = Results("pictures/space_dome")
    faces = cut(faces_of(dome.read("blocks.vtu")), *half_space("x < 0"))
    first = faces.offsets[:-1]
    x = faces.points - np.repeat(faces.points[first], np.diff(faces.offsets), 0)
    products = np.cross(x, x[following(faces.offsets)])
    areas = np.add.reduceat(products, first) / 2
    sums = [np.bincount(faces.block, area) for area in areas.T]
    expect("blocks that are cut are closed", np.abs(sums).max() < 1e-12)
    volume = (faces.points[first] * areas).sum() / 3
    expect(f"half of the dome, {volume}",
           abs(volume / dome.summary["packing"]["volume"] - 0.5) < 1e-6)


def check_refusals():
    arch, collapse, to = "pictures/arch", "pictures/collapse", "pictures/refused.png"
    views, here = ", ".join(render.NAMES), os.getcwd()
    dome = "pictures/space_dome"
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
            ([["thrust", to, arch]],
             f"The view 'thrust' needs results with Rotations = true, and those in "
             f"'{arch}' are without."),
            ([["chains", to, "pictures/shear_wall"]],
             "The view 'chains' shows normal forces, and 'pictures/shear_wall' has none "
             "but rounding."),
            ([["eccentricity", to, "pictures/hinges"]],
             "The view 'eccentricity' needs interfaces.vtu, which 'pictures/hinges' "
             "does not have; its status is 'collapse'."),
            ([["sigma_xx", to, arch, "--limit", "0"]], "The limit must be positive."),
            ([["sigma_xx", to, dome]],
             "There is no view 'sigma_xx' of packings in space; choose one of "
             "blocks, volume, joints, principal_stress_min, utilisation, mechanism, "
             "principal, trajectories, or all."),
            ([["mechanism", to, "pictures/cube"]],
             "The view 'mechanism' shows a mechanism, and 'pictures/cube' has none."),
            ([["utilisation", to, "pictures/fallen"]],
             "The view 'utilisation' needs loads that are carried, and "
             "'pictures/fallen' has none."),
            ([["trajectories", to, "pictures/fallen"]],
             "The view 'trajectories' needs loads that are carried, and "
             "'pictures/fallen' has none."),
            ([["trajectories", to, dome, "--spacing=-1"]],
             "The factor of --spacing must not be negative."),
            ([["blocks", to, dome, arch]],
             "Packings in the plane and in space have no view in common."),
            ([["blocks", to, dome, "--cut=z < 2"]],
             "Nothing is left of the packing by this --cut."),
            ([["joints", to, "pictures/alone"]],
             "The view 'joints' shows interfaces, and 'pictures/alone' has none but "
             "rounding."),
            ([["blocks", to, dome, "--cut=z = 2"]],
             "Argument --cut: invalid half_space value: 'z = 2'; see --help."),
            ([["blocks", to, dome, "--from=0,0,0"]],
             "Argument --from: invalid direction value: '0,0,0'; see --help."),
            ([["blocks", to, dome, "--apart=-1"]],
             "The factor of --apart must not be negative."),
            ([["blocks", to, arch, "--apart=1"]],
             "There is no --cut and no --apart of packings in the plane."),
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
                             ("rocking_column", {"Thrust": 19}),
                             ("collapse", {"Mechanism": 21, "At rest": 21})):
        SetActiveSource(OpenDataFile(f"pictures/{directory}/results.pvd"))
        exec(macro, dict(as_button))
        if directory == "arch":  # again, from what it has made
            SetActiveSource(FindSource("Chains"))
            exec(macro, dict(as_button))
        for name, n_cells in names.items():
            found = FindSource(name).GetDataInformation().GetNumberOfCells()
            expect(f"{name} of {directory}, {found}", found == n_cells)
    results = Results("pictures/shear_wall")  # pure shear: normal forces are rounding
    expect("no chains of rounding",
           not chains(results.blocks(), results.interfaces())[-1].size)
    SaveScreenshot("pictures/macro.png", GetActiveViewOrCreate("RenderView"))
    expect("the window is not blank", pixels("pictures/macro.png").std() > 5)


def check_macro_in_space():
    """What the button makes of a run in space: how many cells, and what is shown."""
    from paraview.simple import (GetActiveViewOrCreate, GetRepresentation, GetSources,
                                 Hide, OpenDataFile, SaveScreenshot, SetActiveSource)
    with open(f"{SOURCE}/contrib/paraview/macro.py") as file:
        macro = compile(file.read(), "macro", "exec")
    view = GetActiveViewOrCreate("RenderView")
    stress = {"Blocks": (10, 1), "Outlines": (10, 1), "Crosses": (60, 1),
              "Interfaces": (10, 0)}
    fallen = {"Blocks": (121, 0), "At rest": (121, 1), "Mechanism": (121, 1)}
    factor = {**fallen, "Crosses": (6 * 363, 0), "Interfaces": (384, 0)}
    groups = {"Blocks": (16, 1), "Outlines": (16, 1)}
    for directory, file, expected in (
            ("column", "results.pvd", stress), ("column", "interfaces.vtu", stress),
            ("fallen", "blocks.vtu", fallen), ("space_dome", "results.pvd", factor),
            ("space_models_bridge", "results.pvd", groups)):
        for source in GetSources().values():
            Hide(source, view)
        selected = OpenDataFile(f"pictures/{directory}/{file}")
        before = {*GetSources(), ("selected", selected)}
        SetActiveSource(selected)
        exec(macro, {"__name__": "__vtkconsole__",
                     "__file__": f"{SOURCE}/contrib/paraview/macro.py"})
        made = {name[0]: source for name, source in GetSources().items()
                if name not in before}
        found = {name: (source.GetDataInformation().GetNumberOfCells(),
                        GetRepresentation(source, view).Visibility)
                 for name, source in made.items()}
        expect(f"{file} of {directory}, {found}", found == expected)
        expect("it turns in space", view.InteractionMode == "3D")
        expect("crosses have values and blocks", "Crosses" not in made or
               {"value", "cell"} <= {*made["Crosses"].CellData.keys()})
        SaveScreenshot("pictures/macro_in_space.png", view)
        image = pixels("pictures/macro_in_space.png")
        expect(f"the window with {directory} is not blank", image.std() > 5)


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
    for page in ("gallery", "tutorial", "tutorial_in_space"):
        with open(f"{SOURCE}/doc/{page}.md") as file:
            text = file.read()
        shown = set(re.findall(r"images/(\w+)\.png", text))
        named = set(re.findall(r"contrib/pictures\s+--only\s+(\w+)", text)) - {"NAME"}
        expect(f"pictures of the {page} and their commands, {named ^ shown}",
               named == shown)
    with open(f"{SOURCE}/doc/gallery.md") as file:
        text = file.read()
    scenes = glob.glob(f"{SOURCE}/prm/**/*.prm", recursive=True)
    missing = [scene for scene in scenes
               if f"({os.path.relpath(scene, f'{SOURCE}/doc')})" not in text]
    expect(f"scenes that the gallery lacks, {missing}", not missing)


shutil.rmtree("pictures", ignore_errors=True)
os.makedirs("pictures")
for check in (check_scenes, check_colours, check_thrust, check_forces, check_hinges,
              check_extremes, check_space, check_refusals, check_macro,
              check_macro_in_space, check_documentation):
    check()
print("The pictures are as they should be")
