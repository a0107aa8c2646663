"""Views of the stress inside packings in space: crosses and trajectories of the
principal stresses, as bars in blocks of which the viewer sees the far sides."""
from functools import lru_cache

import numpy as np

from macro import DIVERGING, bars, crosses_in_space
from space_views import Eye, Faces, SpaceView, faces_in, faces_shown, volumes
from trajectories import SPACING, trajectories
from voussoir_views import PALE, Panel, interpolate, mark_colours

# The sides of blocks behind the bars, farther away than they are by so many mean
# blocks, so that they do not cut the ends of bars.
OUTLINE, BEHIND = (0.72, 0.72, 0.72), 1.0
# Of trajectories: blue where they press and red where they pull, and never white.
LINES = [DIVERGING[0], (-1e-6, 0.62, 0.78, 0.92), (1e-6, 0.97, 0.74, 0.58),
         DIVERGING[-1]]


def bars_in_blocks(results, lines, colours, options):
    """Bars, of which lines has begin, end, width and block, in the blocks that are
    left by a cut, and moved apart with them."""
    begin, end, width, block = lines
    blocks = faces_shown(results, "blocks.vtu", options)
    away = options.apart * moves_apart(results)[block]
    shown = np.isin(block, blocks.block)
    if options.cut:
        normal, offset = options.cut
        shown &= np.maximum(begin @ normal, end @ normal) < offset
    sides = bars(begin[shown] + away[shown], end[shown] + away[shown], width[shown])
    n = len(sides)
    corners = Faces(sides.reshape(-1, 3), np.arange(4 * n), np.arange(0, 4 * n + 1, 4),
                    np.repeat(np.flatnonzero(shown), 6), np.zeros(n, bool))
    eye = Eye(blocks, options.viewer)
    far = blocks.some(eye.facing(blocks) < 0)
    layers = [eye.fill(far, PALE), eye.outline(far, OUTLINE, 0.7)]
    for layer in layers:
        layer.points[:, 2] -= BEHIND * np.cbrt(volumes(results).mean())
    if n:
        near = corners.some(eye.facing(corners) > 0)
        light = eye.light(near.normals())
        layers.append(eye.fill(near, colours[near.block] * light[:, None]))
    return Panel(results.blocks(), *layers)


def moves_apart(results):
    """How far each block is away from the middle of the packing."""
    middles = faces_in(results, "blocks.vtu").middles()
    return middles - (middles.min(0) + middles.max(0)) / 2


def principal_values(results, options=None):
    return crosses_in_space(results.polyhedra())[3]


def principal_panel(results, limit, options):
    *lines, value, block = crosses_in_space(results.polyhedra(), limit)
    return bars_in_blocks(results, (*lines, block), mark_colours(value), options)


@lru_cache(maxsize=None)
def lines_of(results, spacing):
    return trajectories(results.polyhedra(), spacing)


def line_values(results, options=None):
    return lines_of(results, options.spacing if options else SPACING)[3]


def trajectory_panel(results, limit, options):
    *lines, value, block = lines_of(results, options.spacing)
    return bars_in_blocks(results, (*lines, block), interpolate(LINES, value / limit),
                          options)


def mean_stress(results):
    return results.blocks().of_cells["mean_stress"]


STRESS_VIEWS_IN_SPACE = {
    "principal": SpaceView("blocks.vtu", principal_panel, principal_values, mean_stress,
                           legend="principal", field="mean_stress"),
    "trajectories": SpaceView("blocks.vtu", trajectory_panel, line_values, mean_stress,
                              scale=LINES, field="mean_stress",
                              shows="lines of principal stress")}
