"""Pictures of results, without a screen:

    xvfb-run -a pvbatch contrib/paraview/render.py VIEW PICTURE DIRECTORY...

See --help. In code: main(arguments) returns the exit status.
"""
import argparse
import os
import re
import sys
from copy import copy

import numpy as np
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkIOOggTheora import vtkOggTheoraWriter

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from figure import Figure, write_png
from space_stress_views import STRESS_VIEWS_IN_SPACE
from space_views import (BLOCK_VIEWS_IN_SPACE, JOINT, SUPPORT, direction, half_space,
                         named_groups)
from trajectories import SPACING
from voussoir_views import (COMPRESSION, DARK, GREY, GROUPS, RED, ROUNDING, TENSION,
                            VIEWS, NotThere, Results, block_size, interpolate, scale_of)

VIEWS_IN_SPACE = {**BLOCK_VIEWS_IN_SPACE, **STRESS_VIEWS_IN_SPACE}
NAMES = list(dict.fromkeys((*VIEWS, *VIEWS_IN_SPACE)))
FRAMES = 24
FIXED = [(GREY, "does not move")]
SWATCHES = {"chains": [(COMPRESSION, "compression")],
            "thrust": [(COMPRESSION, "line of thrust")],
            "resultants": [(COMPRESSION, "resultant")],
            "loads": [(RED, "load"), (DARK, "support")],
            "joints": [(JOINT, "joint"), (SUPPORT, "support")],
            "principal": [(COMPRESSION, "compression"), (TENSION, "tension")]}


class Parser(argparse.ArgumentParser):
    def error(self, message):
        raise NotThere(f"{message[0].upper()}{message[1:]}; see --help.")


def parse(arguments):
    parser = Parser(prog="render.py", description="Pictures of results of voussoir.")
    parser.add_argument("view", metavar="VIEW",
                        help=", ".join(VIEWS) + "; of packings in space " +
                        ", ".join(VIEWS_IN_SPACE) + "; or all: each one that the "
                        "results allow, in the directory PICTURE")
    parser.add_argument("picture", metavar="PICTURE",
                        help="a .png; of an animation also .ogv, or NAME_%%02d.png "
                        "for numbered frames")
    parser.add_argument("directories", metavar="DIRECTORY", nargs="+",
                        help="with results; several are shown side by side, "
                        "with the same colours")
    parser.add_argument("--limit", type=float, help="the value at the end of the "
                        "colours, of the longest cross or widest chain; default: "
                        "the largest")
    parser.add_argument("--width", type=int, default=800, help="in pixels")
    parser.add_argument("--columns", type=int, help="panels in a row")
    parser.add_argument("--titles", type=lambda text: text.split(";"), help="of the "
                        "panels, as 'one; two'; default: the selection, if there "
                        "are several panels")
    parser.add_argument("--sub-cells", action="store_true",
                        help="crosses of the sub-cells, not of the blocks")
    parser.add_argument("--fraction", type=float, default=0.5,
                        help="of the mean block that the largest displacement is "
                        "drawn as; default 0.5")
    space = parser.add_argument_group("packings in space")
    space.add_argument("--from", dest="viewer", type=direction, metavar="X,Y,Z",
                       default="1,-1,1", help="towards the viewer, as --from=-1,-2,1; "
                       "default 1,-1,1")
    space.add_argument("--cut", type=half_space, metavar="WHAT", help="what is cut "
                       "away, as 'y < 0.5', in the coordinates of the packing")
    space.add_argument("--apart", type=float, default=0.0, metavar="FACTOR",
                       help="moves blocks away from the middle of the packing, by "
                       "this times their distance from it")
    space.add_argument("--spacing", type=float, default=SPACING, metavar="FACTOR",
                       help="the least distance of the beginning of a trajectory, a "
                       "centroid, from those before it, in mean blocks; default "
                       f"{SPACING:g}, and 0 draws one from each block")
    return parser.parse_intermixed_args(arguments)


def check(options):
    if options.view not in NAMES and options.view != "all":
        raise NotThere(f"There is no view '{options.view}'; choose one of "
                       f"{', '.join(NAMES)}, or all.")
    if options.limit is not None and not 0 < options.limit < np.inf:
        raise NotThere("The limit must be positive.")
    if not 100 <= options.width <= 8000:
        raise NotThere("The width must be between 100 and 8000 pixels.")
    if options.columns is not None and options.columns < 1:
        raise NotThere("There must be at least one column.")
    if options.titles and len(options.titles) != len(options.directories):
        raise NotThere("Give as many titles as directories.")
    if not 0 <= options.apart < np.inf:
        raise NotThere("The factor of --apart must not be negative.")
    if not 0 <= options.spacing < np.inf:
        raise NotThere("The factor of --spacing must not be negative.")
    check_picture(options.view, options.picture)


def check_picture(view, file):
    if view == "animation":
        if not re.fullmatch(r".*\.ogv|[^%]*%(0\d)?d[^%]*\.png", file):
            raise NotThere("An animation is an .ogv, or frames with a number in their "
                           f"names, as NAME_%02d.png, and '{file}' is neither.")
    elif view != "all" and not file.endswith(".png"):
        raise NotThere(f"A picture is a .png, and '{file}' is not.")
    if os.path.exists(file) and os.path.isdir(file) != (view == "all"):
        raise NotThere(f"'{file}' is {'not ' if view == 'all' else ''}a directory.")
    folder = os.path.dirname(os.path.abspath(file))
    if not os.path.isdir(folder):
        raise NotThere(f"There is no directory '{folder}' for the picture.")


def number(value):
    text = f"{value + 0.0:.3g}"  # no minus before zero
    return f"{value:.0f}" if "e+" in text and abs(value) < 1e6 else text


def views_of(results):
    """The views that there are of packings in the plane, or in space."""
    in_space = {result.in_space() for result in results}
    if len(in_space) > 1:
        raise NotThere("Packings in the plane and in space have no view in common.")
    return VIEWS_IN_SPACE if in_space.pop() else VIEWS


class Picture:
    """A view of some results, with its scale and legend."""

    def __init__(self, name, results, options):
        views = views_of(results)
        if name not in views:
            where = "in space" if results[0].in_space() else "in the plane"
            raise NotThere(f"There is no view '{name}' of packings {where}; choose one "
                           f"of {', '.join(views)}, or all.")
        if views is VIEWS and (options.cut or options.apart):
            raise NotThere("There is no --cut and no --apart of packings in the plane.")
        self.name, self.view, self.results = name, views[name], results
        self.options = copy(options)
        for result in results:
            missing = self.view.missing(result)
            if missing:
                raise NotThere(f"The view '{name}' {missing}.")
        self.find_limit()

    def find_limit(self):
        self.low, self.high, self.limit = 0.0, 1.0, 1.0
        if self.view.values is None:
            return
        values = np.concatenate([self.view.values(r, self.options)
                                 for r in self.results])
        self.low, self.high = values.min(initial=np.inf), values.max(initial=-np.inf)
        largest = np.abs(values).max(initial=0)
        if self.view.reference:
            reference = max(np.abs(self.view.reference(r)).max(initial=0)
                            for r in self.results)
            if largest <= ROUNDING * reference:
                largest, self.low, self.high = reference, 0.0, 0.0
        self.limit = self.options.limit or largest or 1.0
        # Panels beside each other have the same colours.
        self.options.colours = scale_of(self.low, self.high)

    def bar(self):
        """The colours of the bar, and the value at 1."""
        if self.view.scale:
            return self.view.scale, self.limit
        scale, sign = self.options.colours
        return scale, sign * self.limit

    def panels(self):
        return [self.view.panel(r, self.limit, self.options) for r in self.results]

    def legend_title(self):
        limit = number(self.limit)
        if self.name == "principal":
            cell = "sub-cell" if self.options.sub_cells else "block"
            return f"principal stresses; an arm as long as its {cell} is wide: {limit}"
        if self.name == "trajectories":
            return "trajectories of the principal stresses, " + (
                f"from {number(self.low)} to {number(self.high)}")
        if self.name == "chains":
            return f"normal forces; the widest line: {limit}"
        if self.name == "thrust":
            return f"resultants through the joints; the widest line: {limit}"
        if self.name == "resultants":
            return f"resultant forces of the joints; the longest line: {limit}"
        if self.name == "loads":
            return f"loads and supports; the longest arrow: {limit}"
        if self.name == "eccentricity":
            return ("where the resultant passes through a joint; blue: in its middle "
                    "third")
        if self.name == "blocks":
            return "groups of blocks" if len(self.swatches()) > 1 else "blocks"
        if self.name == "joints":
            return "where blocks touch"
        if self.name == "utilisation":
            return "utilisation of friction; at 1 an interface slides"
        if self.name == "mechanism" and self.results[0].in_space():
            return "displacement in the mechanism, over the largest"
        if self.name in ("mechanism", "animation"):
            hinged = any(len(result.hinges()) for result in self.results)
            return ("displacement, on the scale of the picture" +
                    ("; a dot is a hinge" if hinged else ""))
        if self.name == "ranges":
            return ("how much the normal force differs between states, at most "
                    f"{number(self.high)}")
        if self.name == "displacement":
            factor = (self.options.fraction * block_size(self.results[0].blocks()) /
                      self.limit)
            return f"displacement, drawn {number(factor)} times as large"
        return f"{self.name}, from {number(self.low)} to {number(self.high)}"

    def swatches(self):
        """The colours and words of a legend that is not a bar."""
        if self.view.legend == "groups":
            names = {}
            for result in self.results:
                found = (named_groups(result) if result.in_space() else
                         np.unique(result.blocks().of_cells["group"]))
                names.update((i, result.groups()[i]) for i in found)
            held = any(result.summary["packing"].get("fixed_cells")
                       for result in self.results)
            return [(GROUPS[i % len(GROUPS)], name)
                    for i, name in sorted(names.items())] + FIXED * held
        pulls = self.view.legend == "chains" and self.high > 0
        return SWATCHES["principal" if pulls else self.view.legend]


class Layout:
    """Where in the picture the panels are, in pixels."""

    def __init__(self, bounds, options, titled):
        n, width = len(bounds), options.width
        self.bounds = bounds
        self.columns = min(n, options.columns or 3)
        self.rows = -(-n // self.columns)
        self.font = float(np.clip(width / 50, 11, 40))
        self.gap = round(max(6, width / 50))
        self.title = 2.0 * self.font if titled else 0
        self.legend = 4.2 * self.font
        self.width = (width - self.gap) / self.columns - self.gap
        extents = [high - low for low, high in bounds]
        self.height = min(self.width * max(y / x for x, y in extents), width)
        self.size = (width, round(self.rows * (self.height + self.title + self.gap) +
                                  self.gap + self.legend))

    def place(self, i):
        """The middle of panel i, and its pixels for a unit of length."""
        low, high = self.bounds[i]
        row, column = divmod(i, self.columns)
        in_row = min(self.columns, len(self.bounds) - row * self.columns)
        left = (self.size[0] - in_row * (self.width + self.gap) + self.gap) / 2
        x = left + column * (self.width + self.gap) + self.width / 2
        y = self.size[1] - self.gap - row * (self.height + self.title + self.gap)
        y -= self.title + self.height / 2
        scale = min(self.width / (high - low)[0], self.height / (high - low)[1])
        return np.array([x, y]), scale


def draw_bar(figure, picture, x, y, layout):
    """The colours between the ends, with the values below them."""
    font, width = layout.font, layout.size[0] * 0.45
    scale, end = picture.bar()
    low = scale[0][0]
    edges = np.linspace(0, 1, 257) * width + x - width / 2
    values = np.linspace(low, 1, 256)
    figure.rectangles(edges[:-1], edges[1:], y + 1.25 * font, y + 1.95 * font,
                      interpolate(scale, values))
    labels = picture.view.labels or [
        number(end * value)
        for value in np.linspace(low, 1, 5 if width > 20 * font else 3)]
    for part, words in zip(np.linspace(0, 1, len(labels)), labels):
        figure.text(x + (part - 0.5) * width, y, words, 0.9 * font,
                    0.9 * width / (len(labels) - 1))


def draw_swatches(figure, swatches, x, y, layout):
    if not swatches:
        return
    font = layout.font
    pitch = min(9 * font, layout.size[0] / len(swatches))
    middles = x + pitch * (np.arange(len(swatches)) - (len(swatches) - 1) / 2)
    figure.rectangles(middles - 1.5 * font, middles + 1.5 * font, y + 1.25 * font,
                      y + 1.95 * font, np.array([colour for colour, _ in swatches]))
    for at, (_, words) in zip(middles, swatches):
        figure.text(at, y, words, 0.9 * font, 0.95 * pitch)


def draw(picture, options, bounds=None):
    """The figure; with bounds, the panels are placed as if these were theirs."""
    panels = picture.panels()
    titles = options.titles or (
        [r.title() for r in picture.results] if len(panels) > 1 else [])
    layout = Layout(bounds or [p.bounds() for p in panels], options, bool(titles))
    figure = Figure(*layout.size)
    for i, panel in enumerate(panels):
        middle, scale = layout.place(i)
        low, high = layout.bounds[i]
        pixels = scale * np.sqrt(np.prod(high - low) / panel.n_blocks)
        line = float(np.clip(0.05 * pixels, 0.25, 1.5)) * max(1, options.width / 800)
        for layer in panel.layers:
            flat = (layer.points[:, :2] - (low + high) / 2) * scale + middle
            figure.add(np.hstack((flat, layer.points[:, 2:] * scale)), layer.offsets,
                       layer.corners, layer.colours, line * layer.line_width)
        if titles:
            figure.text(middle[0], middle[1] + layout.height / 2 + 0.4 * layout.font,
                        titles[i].strip(), layout.font, layout.width)
    x, y = layout.size[0] / 2, 0.5 * layout.font
    figure.text(x, y + 2.2 * layout.font, picture.legend_title(), layout.font,
                options.width - 2 * layout.gap)
    if picture.view.legend == "bar":
        draw_bar(figure, picture, x, y, layout)
    else:
        draw_swatches(figure, picture.swatches(), x, y, layout)
    return figure.image()


def swing(picture, options):
    """The images of one swing, from rest to the mechanism and back."""
    picture.options.swing = 1.0
    bounds = [panel.bounds() for panel in picture.panels()]
    for i in range(FRAMES):
        picture.options.swing = (1 - np.cos(2 * np.pi * i / FRAMES)) / 2
        yield draw(picture, options, bounds)


def write_movie(images, file):
    movie = vtkOggTheoraWriter()
    movie.SetFileName(file)
    movie.SetRate(FRAMES // 2)
    for i, image in enumerate(images):
        movie.SetInputData(image)
        if i == 0:
            movie.Start()
        movie.Write()
        if movie.GetError():
            raise OSError(f"'{file}' cannot be written.")
    movie.End()


def animate(picture, options, file):
    images = swing(picture, options)
    if file.endswith(".ogv"):
        write_movie(images, file)
        return
    for i, image in enumerate(images):
        write_png(image, file % i)


def render(name, file, results, options):
    picture = Picture(name, results, options)
    if name == "animation":
        animate(picture, options, file)
    else:
        write_png(draw(picture, options), file)


def render_all(folder, results, options):
    os.makedirs(folder, exist_ok=True)
    for name, view in views_of(results).items():
        if not any(view.missing(result) for result in results):
            ending = "ogv" if name == "animation" else "png"
            render(name, os.path.join(folder, f"{name}.{ending}"), results, options)


def main(arguments):
    vtkObject.GlobalWarningDisplayOff()
    try:
        options = parse(arguments)
        check(options)
        results = [Results(directory) for directory in options.directories]
        if options.view == "all":
            render_all(options.picture, results, options)
        else:
            render(options.view, options.picture, results, options)
    except (NotThere, OSError) as error:
        print(f"render.py: {error}", file=sys.stderr)
        return 2
    except KeyError as error:  # a field of a file, by its name
        print(f"render.py: The results have no {error}; make them again with this "
              "version of voussoir.", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
