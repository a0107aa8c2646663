"""Crosses and trajectories of principal stresses in space against closed forms.

    python3 check_trajectories.py VOUSSOIR SOURCE_DIRECTORY
"""
import shutil
import subprocess
import sys

import numpy as np

PROGRAM, SOURCE = sys.argv[1:]
sys.path.insert(0, f"{SOURCE}/contrib/paraview")
from macro import bars, crosses_in_space  # noqa: E402
from trajectories import LEAST, StressField, trajectories  # noqa: E402
from voussoir_views import Results  # noqa: E402


def expect(what, condition):
    if not condition:
        sys.exit(f"{what}: not as expected")


def run(scene, name, *settings):
    """The blocks of a scene."""
    command = [PROGRAM, f"{SOURCE}/prm/space/{scene}.prm",
               "--set", f"Output directory=trajectories/{name}"]
    for setting in settings:
        command += ["--set", setting]
    done = subprocess.run(command, capture_output=True, text=True)
    expect(f"status of {name}, {done.stderr}", done.returncode == 0)
    return Results(f"trajectories/{name}").polyhedra()


def impose(blocks, stress, linear=True):
    """A stress (n, 3, 3) of places in all blocks; if it is not to be linear, its value
    at the centroids alone."""
    blocks.of_cells["mean_stress"] = stress(blocks.centroids()).reshape(-1, 9)
    blocks.of_points["stress"] = stress(blocks.points).reshape(-1, 9)
    if not linear:
        del blocks.of_points["stress"]


def rotation():
    axes, _ = np.linalg.qr(np.array([[2., 1, 0], [-1, 2, 1], [1, 0, 3]]))
    return axes


def check_column():
    """Ten blocks of 0.4 x 0.4 x 0.2 under 20 a volume."""
    blocks = run("wall", "column", "Analysis=state", "Packing/wall/Bond=stack",
                 "Packing/wall/Length=0.4", "Packing/wall/Thickness=0.4",
                 "Packing/wall/Height=2", "Packing/wall/Openings=",
                 "Packing/wall/Brick length=0.4", "Packing/wall/Brick width=0.4",
                 "Packing/wall/Brick height=0.2", "Loads/Body force=0; 0; -20")
    begin, end, width, value, block = crosses_in_space(blocks)
    depth = 2 - blocks.centroids()[:, 2]
    expect("one arm a block", sorted(block) == list(range(10)))
    expect("of its depth times the weight",
           np.abs(value + 20 * depth[block]).max() < 1e-5)
    arms = np.abs(end - begin)
    expect("arms are vertical", arms[:, :2].max() < 1e-6)
    length = np.cbrt(0.4 * 0.4 * 0.2) * depth[block] / depth.max()
    expect("their lengths", np.abs(arms[:, 2] - length).max() < 1e-6)
    expect("their widths", np.allclose(width, 0.09 * np.cbrt(0.4 * 0.4 * 0.2)))

    begin, end, width, value, block = trajectories(blocks)
    places = np.concatenate((begin, end)) - blocks.points.mean(0)
    expect("one line, in the middle", np.abs(places[:, :2]).max() < 1e-6)
    low, high = np.minimum(begin, end)[:, 2], np.maximum(begin, end)[:, 2]
    expect(f"from the ground to the top, once, {low.min()} {high.max()}",
           low.min() < 1e-6 and abs((high - low).sum() - 2) < 1e-4 and
           abs(high.max() - 2) < 1e-4)
    expect("its values", np.abs(value + 20 * (2 - (low + high) / 2)).max() < 1e-4)


def chords(places, direction):
    """Of the unit cube, through places."""
    with np.errstate(divide="ignore"):
        sides = np.stack(((0 - places) / direction, (1 - places) / direction))
    return sides.max(0).min(axis=1) - sides.min(0).max(axis=1)


def check_uniform(blocks):
    """Turned principal stresses: -3, -1 and 0.5, in random cells of the unit cube."""
    axes = rotation()
    for linear in (True, False):
        impose(blocks, lambda places: np.tile(
            axes @ np.diag([-3., -1, 0.5]) @ axes.T, (len(places), 1, 1)), linear)
        *_, value, block = crosses_in_space(blocks)
        expect("three arms a block", (np.bincount(block) == 3).all() and
               np.allclose(np.sort(value), np.repeat([-3, -1, 0.5], blocks.size)))
        begin, end, _, value, _ = trajectories(blocks, spacing=0)
        for of, axis in ((-3, 0), (0.5, 2)):
            chosen = np.abs(value - of) < 1e-9
            along = end[chosen] - begin[chosen]
            length = np.linalg.norm(along, axis=1)
            off = np.linalg.norm(np.cross(along, axes[:, axis]), axis=1)
            expect(f"lines along the axis of {of}", (off <= 1e-6 * length).all())
            expected = chords(blocks.centroids(), axes[:, axis]).sum()
            expect(f"through the cube, {length.sum()}, not {expected}",
                   abs(length.sum() / expected - 1) < 1e-4)
        expect("no others", np.isin(value.round(9), (-3, 0.5)).all())
    begin, end, _, value, _ = trajectories(blocks, spacing=1)
    total = np.linalg.norm(end - begin, axis=1).sum()
    expect("fewer lines are farther apart",
           0 < total < 0.5 * sum(chords(blocks.centroids(), axes[:, k]).sum()
                                 for k in (0, 2)))


def check_arms(blocks):
    """The arms of a cross make up its stress, symmetrised; no block that is fixed
    has any."""
    generator = np.random.default_rng(1)
    stress = generator.normal(size=(blocks.size, 3, 3))
    blocks.of_cells["mean_stress"] = stress.reshape(-1, 9)
    begin, end, _, value, block = crosses_in_space(blocks, limit=1e3)
    axis = (end - begin) / np.linalg.norm(end - begin, axis=1)[:, None]
    made = np.zeros_like(stress)
    np.add.at(made, block, value[:, None, None] * axis[:, :, None] * axis[:, None, :])
    expect("arms make up the stress",
           np.abs(made - (stress + stress.swapaxes(1, 2)) / 2).max() < 1e-9)
    middle = (begin + end) / 2 - blocks.centroids()[block]
    expect("they are in the middle", np.abs(middle).max() < 1e-12)
    expect("a limit shortens them", np.linalg.norm(end - begin, axis=1).max() <
           1e-2 * np.cbrt(blocks.of_cells["volume"]).max())
    blocks.of_cells["fixed"][:5] = 1
    expect("none in fixed blocks", crosses_in_space(blocks)[4].min() == 5)
    blocks.of_cells["fixed"][:5] = 0


def check_parabolas(blocks):
    """The stress [[x, y], [y, -x]] is linear, and its trajectories are the confocal
    parabolas of constant r - x, where it pulls by r, and r + x, where it presses."""
    focus = np.array([-0.3, 0.4])

    def stress(places):
        x, y = (places[:, :2] - focus).T
        zero = np.zeros(len(x))
        return np.stack((x, y, zero, y, -x, zero, zero, zero, zero),
                        axis=1).reshape(-1, 3, 3)
    impose(blocks, stress)
    begin, end, _, value, _ = trajectories(blocks, spacing=0)

    def constants(places, sign):
        x, y = (places[:, :2] - focus).T
        return np.hypot(x, y) - sign * x
    sign = np.sign(value)
    drift = constants(end, sign) - constants(begin, sign)
    size = np.linalg.norm(end - begin, axis=1)
    expect(f"parabolas, off by {np.abs(drift / size).max()} of their length",
           np.abs(drift).max() < 1e-5 and np.abs(drift).sum() < 1e-5 * size.sum())
    radius = np.hypot(*((begin + end) / 2)[:, :2].T - focus[:, None])
    expect("they press and pull by r", np.abs(np.abs(value) - radius).max() < 1e-9)
    expect("both families", (sign < 0).sum() > 1000 and (sign > 0).sum() > 1000)
    expect("in their planes", np.abs(end - begin)[:, 2].max() < 1e-9)


def check_ends(blocks):
    """Pressure that ends in a plane: lines along it end there. What is alike in all
    directions has no lines."""
    impose(blocks, lambda places: np.minimum(
        places[:, 0] - 0.5, 0)[:, None, None] * np.diag([1., 0, 0]), linear=False)
    begin, end, _, value, block = trajectories(blocks, spacing=0)
    expect("lines of compression alone", len(value) > 0 and value.max() < 0)
    expect("where there is any", blocks.centroids()[block][:, 0].max() < 0.5)
    pressure = np.maximum(0.5 - blocks.centroids()[:, 0], 0)
    begins = pressure > LEAST * pressure.mean()
    n_lines = len(np.unique(begin[:, 1:].round(6), axis=0))
    expect(f"{n_lines} lines begin where it is not weak, not {begins.sum()}",
           n_lines == begins.sum() < (pressure > 0).sum())
    impose(blocks, lambda places: np.tile(-np.eye(3), (len(places), 1, 1)))
    expect("none without a direction", not len(trajectories(blocks)[3]))


def check_insides(blocks):
    """Random points of the box around blocks that are not convex: as many as their
    volumes say, and in one block alone."""
    field = StressField(blocks)
    low, high = blocks.points.min(0), blocks.points.max(0)
    places = low + (high - low) * np.random.default_rng(1).random((5000, 3))
    share = blocks.of_cells["volume"] / np.prod(high - low)
    for block in range(blocks.size):
        inside = field.inside(places, np.full(len(places), block))
        error = 5 * np.sqrt(share[block] * (1 - share[block]) / len(places))
        expect(f"points in block {block}", abs(inside.mean() - share[block]) < error)
        expect("they are located", (field.locate(places[inside]) == block).all())


def check_hoops():
    """A dome under its weight: below, hoops pull at one height."""
    blocks = run("dome", "dome", "Analysis=state")
    begin, end, _, value, _ = trajectories(blocks)
    pulls = value > 0
    expect("hoops and meridians", pulls.any() and (value < 0).any())
    slope = np.abs(end - begin)[pulls, 2].sum() / np.linalg.norm(
        (end - begin)[pulls], axis=1).sum()
    expect(f"hoops are level, {slope}", slope < 0.02)
    places = (begin + end)[pulls] / 2
    expect("around the dome, below", places[:, 2].max() < 0.7 and
           np.ptp(np.hypot(places[:, 0], places[:, 1])) < 0.4)
    fall = np.abs(end - begin)[~pulls, 2].sum() / np.linalg.norm(
        (end - begin)[~pulls], axis=1).sum()
    expect(f"meridians descend, {fall}", fall > 0.5)


def check_bars():
    """Closed, outwards, and of the volume of a bar."""
    begin, end = np.array([[0., 0, 0], [1, 2, 3]]), np.array([[0., 0, 2], [4, 6, 3]])
    width = np.array([0.5, 0.1])
    sides = bars(begin, end, width).reshape(2, 6, 4, 3)
    one, other = sides[:, :, 2] - sides[:, :, 0], sides[:, :, 3] - sides[:, :, 1]
    areas = np.cross(one, other) / 2
    expect("sides close", np.abs(areas.sum(axis=1)).max() < 1e-12)
    volume = (sides.mean(axis=2) * areas).sum(axis=(1, 2)) / 3
    expect("volumes", np.allclose(volume, (2 * 0.25, 5 * 0.01)))


shutil.rmtree("trajectories", ignore_errors=True)
cells = run("grains", "grains", "Packing/Voronoi/Number of points=150")
check_bars()
check_column()
for check in (check_uniform, check_parabolas, check_ends, check_arms):
    check(cells)
check_insides(run("cross_vault", "cross_vault", "Analysis=state"))
check_hoops()
print("Crosses and trajectories are those of closed forms")
