"""Trajectories of the principal stresses in packings in space: lines that run along
the direction of the greatest compression, or of the greatest tension, through the
linear stress of each block, and from block to block."""
import numpy as np

# A step, as a part of the cube root of the volume of its block.
STEP = 0.2
# The least distance of a seed from a line before it, as a part of the mean block.
SPACING = 0.5
# Lines begin where the stress is at least this part of the mean of all blocks.
LEAST = 0.1
# Principal stresses whose difference is less than this part of the largest have no
# directions of their own; less than that part of it is no stress.
ALIKE, ROUNDING = 1e-6, 1e-9
# Lines end where blocks beside each other differ by more than 60 degrees.
LEAST_COSINE = 0.5
# How far beyond a face the next block is looked for, as a part of a block.
BEYOND = 1e-6
# So many steps in turn of less than this part of a whole one end a line: on either side
# of a joint, the direction leads back to it.
SHORT, SHORT_STEPS = 1e-2, 4
# The greatest length on either side of a seed, in diagonals of the packing: a ring, as
# of a dome, is followed over half of its length, and a little farther.
LONGEST = 1.2
COMPRESSION, TENSION = 0, 2  # the place of the principal stress, the least being first


def products(a, b):
    """Of vectors (n, number of triangles, 3)."""
    return np.einsum("ntk,ntk->nt", a, b)


class StressField:
    """The stress in blocks that move, and which of them a point is in."""

    def __init__(self, blocks):
        self.moves = np.flatnonzero(blocks.of_cells["fixed"] == 0)
        self.size = np.cbrt(blocks.of_cells["volume"])
        self.fit_stress(blocks)
        self.find_triangles(blocks)
        self.largest = np.abs(np.linalg.eigvalsh(self.at_points(blocks))).max(initial=0)
        self.mean = np.abs(np.linalg.eigvalsh(
            self.stress(self.origin, np.arange(blocks.size))[self.moves])).max(1).mean()

    def fit_stress(self, blocks):
        """value + gradient . (x - origin) of each block, from its vertices, which
        are more than the four that make it; without these the mean stress."""
        points, count = blocks.points[blocks.corners], np.diff(blocks.offsets)
        first = blocks.offsets[:-1]

        def sums(values):
            return np.add.reduceat(values, first, axis=0)
        self.origin = sums(points) / count[:, None]
        self.value = blocks.of_cells["mean_stress"]
        self.gradient = np.zeros((blocks.size, 3, 9))
        if "stress" in blocks.of_points:
            stress = blocks.of_points["stress"][blocks.corners]
            arm = points - np.repeat(self.origin, count, 0)
            self.value = sums(stress) / count[:, None]
            moments = sums(arm[:, :, None] * stress[:, None, :])
            self.gradient = np.linalg.solve(
                sums(arm[:, :, None] * arm[:, None, :]), moments)

    def at_points(self, blocks):
        """At all vertices of blocks that move."""
        block = np.repeat(np.arange(blocks.size), np.diff(blocks.offsets))
        chosen = np.isin(block, self.moves)
        return self.stress(blocks.points[blocks.corners][chosen], block[chosen])

    def find_triangles(self, blocks):
        """Of all faces of each block, filled up to one number by points."""
        block, triangles = blocks.triangles()
        count = np.bincount(block, minlength=blocks.size)
        first = blocks.points[blocks.corners[blocks.offsets[:-1]]]
        self.triangle = np.tile(first[:, None, None], (1, count.max(), 3, 1))
        order = np.argsort(block, kind="stable")
        place = np.arange(len(block)) - np.repeat(np.cumsum(count) - count, count)
        self.triangle[block[order], place] = triangles[order]
        a, b, c = self.triangle.transpose(2, 0, 1, 3)
        normal = np.cross(b - a, c - a)
        size = np.linalg.norm(normal, axis=2)[..., None]
        self.normal = normal / np.where(size > 0, size, 1)
        self.low = self.triangle.min(axis=(1, 2))
        self.high = self.triangle.max(axis=(1, 2))

    def stress(self, x, block):
        """Symmetric, (n, 3, 3)."""
        arm = x - self.origin[block]
        flat = self.value[block] + np.einsum("ni,nij->nj", arm, self.gradient[block])
        tensor = flat.reshape(-1, 3, 3)
        return (tensor + tensor.swapaxes(1, 2)) / 2

    def principal(self, x, block, family):
        """The principal stress of a family, its direction, and how far the next is."""
        values, vectors = np.linalg.eigh(self.stress(x, block))
        return (values[:, family], vectors[:, :, family],
                np.abs(values[:, 1] - values[:, family]))

    def directions(self, x, block, family, along):
        """Of the lines, on the side of another direction, which stays where they are
        far from it: where the stress ends or two principal ones change places."""
        value, direction, gap = self.principal(x, block, family)
        cosine = (direction * along).sum(1)
        found = self.runs(value, gap, family) & (np.abs(cosine) > LEAST_COSINE)
        return np.where(found[:, None], direction * np.sign(cosine)[:, None], along)

    def runs(self, value, gap, family):
        """Whether there is a stress with the sign of its family, and a direction."""
        sign = -1 if family == COMPRESSION else 1
        return ((sign * value > ROUNDING * self.largest) &
                (gap > ALIKE * self.largest))

    def heights(self, x, block):
        """Of points over the triangles of a block, (n, number of triangles)."""
        arm = x[:, None] - self.triangle[block][:, :, 0]
        return products(self.normal[block], arm)

    def inside(self, x, block):
        """Whether points are in blocks, convex or not: below all triangles, or else by
        the solid angle of these."""
        result = (self.heights(x, block) <= 0).all(axis=1)
        rest = np.flatnonzero(~result)
        corners = self.triangle[block[rest]] - x[rest, None, None]
        a, b, c = corners.transpose(2, 0, 1, 3)
        la, lb, lc = (np.sqrt(products(v, v)) for v in (a, b, c))
        ab, bc, ca = products(a, b), products(b, c), products(c, a)
        volume = products(a, np.cross(b, c))
        angle = np.arctan2(volume, la * lb * lc + ab * lc + bc * la + ca * lb)
        result[rest] = angle.sum(axis=1) > np.pi
        return result

    def exits(self, x, end, block):
        """At which part of the way from x to end it leaves the block."""
        first, last = self.heights(x, block), self.heights(end, block)
        crossed = (first <= 0) != (last <= 0)
        shares = np.where(crossed, first / np.where(crossed, first - last, 1), 1)
        shares = np.sort(np.clip(shares, 0, 1), axis=1)
        result, left = np.ones(len(x)), np.arange(len(x))
        for share in shares.T:
            if not len(left):
                break
            share = share[left]
            beyond = x[left] + (share + BEYOND)[:, None] * (end[left] - x[left])
            out = ~self.inside(beyond, block[left])
            result[left[out]] = share[out]
            left = left[~out & (share < 1)]
        return result

    def locate(self, x):
        """The blocks that points are in, or -1."""
        found = np.full(len(x), -1)
        near = ((self.low[self.moves] <= x[:, None]) &
                (x[:, None] <= self.high[self.moves])).all(-1)
        point, block = np.nonzero(near)
        block = self.moves[block]
        there = self.inside(x[point], block)
        found[point[there]] = block[there]
        return found


def runge_kutta(field, x, block, family, along, step):
    """The place after a step, and the direction there, in the stress of one block."""
    h = step[:, None]
    first = field.directions(x, block, family, along)
    second = field.directions(x + h / 2 * first, block, family, first)
    third = field.directions(x + h / 2 * second, block, family, second)
    fourth = field.directions(x + h * third, block, family, third)
    x = x + h / 6 * (first + 2 * second + 2 * third + fourth)
    return x, field.directions(x, block, family, fourth)


def trace(field, family, seed, block, along):
    """Follow lines from seeds, of which along has the sense: segments as line, begin,
    end, value, block."""
    line, x, made = np.arange(len(seed)), seed, []
    length, short = np.zeros(len(seed)), np.zeros(len(seed), int)
    longest = LONGEST * np.linalg.norm(field.high.max(0) - field.low.min(0))
    while len(line):
        step = STEP * field.size[block]
        end, turned = runge_kutta(field, x, block, family, along, step)
        leaves = np.flatnonzero(~field.inside(end, block))
        step[leaves] *= field.exits(x[leaves], end[leaves], block[leaves])
        end[leaves], turned[leaves] = runge_kutta(
            field, x[leaves], block[leaves], family, along[leaves], step[leaves])
        value, _, _ = field.principal((x + end) / 2, block, family)
        made.append((line, x, end, value, block))

        size = field.size[block]
        short = np.where(step < SHORT * STEP * size, short + 1, 0)
        # Short steps count as well, so that every line ends.
        length = length + np.maximum(step, SHORT * STEP * size)
        end, block = end.copy(), block.copy()
        end[leaves] += (BEYOND * size[leaves])[:, None] * turned[leaves]
        block[leaves] = field.locate(end[leaves])
        value, direction, gap = field.principal(end, block, family)
        cosine = (direction * turned).sum(1)
        goes_on = ((block >= 0) & field.runs(value, gap, family) &
                   (np.abs(cosine) > LEAST_COSINE) & (length < longest) &
                   (short < SHORT_STEPS))
        along = direction * np.where(cosine < 0, -1, 1)[:, None]
        line, x, block, along, length, short = (
            of[goes_on] for of in (line, end, block, along, length, short))
    return [np.concatenate(part) for part in zip(*made)]


def apart(seed, line, begin, end, distance):
    """Which lines to keep, the longest first: those whose seeds are no nearer than a
    distance to the lines that are kept."""
    order = np.argsort(line, kind="stable")
    at = np.searchsorted(line[order], np.arange(len(seed) + 1))
    of_line = np.split(order, at[1:-1])
    length = np.bincount(line, np.linalg.norm(end - begin, axis=1), len(seed))
    free, kept = np.ones(len(seed), bool), np.zeros(len(seed), bool)
    for i in np.argsort(-length, kind="stable"):
        if not free[i] or not length[i]:
            continue
        kept[i] = True
        places = (begin[of_line[i]] + end[of_line[i]]) / 2
        left = np.flatnonzero(free)
        off = np.linalg.norm(seed[left, None] - places, axis=2).min(axis=1)
        free[left[off < distance]] = False
    return kept


def family_lines(field, family, seed, block, spacing):
    """The segments of one family: begin, end, value, block."""
    value, direction, gap = field.principal(seed, block, family)
    there = field.runs(value, gap, family) & (np.abs(value) > LEAST * field.mean)
    seed, block, direction = seed[there], block[there], direction[there]
    if not len(seed):
        return [np.empty((0, 3)), np.empty((0, 3)), np.empty(0), np.empty(0, int)]
    both = (np.concatenate((of, of)) for of in (seed, block))
    line, *segments = trace(field, family, *both,
                            np.concatenate((direction, -direction)))
    line %= len(seed)
    kept = apart(seed, line, *segments[:2], spacing)[line]
    return [of[kept] for of in segments]


def trajectories(blocks, spacing=SPACING):
    """Those of compression, and of tension where there is any, from centroids of
    blocks: begin, end, width, value and block of their segments.

    They end with the packing, where the stress is rounding, where principal stresses
    coincide, and where blocks beside each other differ much in their direction."""
    field = StressField(blocks)
    centre = blocks.centroids()
    block = field.locate(centre)
    seed, block = centre[block >= 0], block[block >= 0]
    mean = field.size[field.moves].mean()
    families = [family_lines(field, family, seed, block, spacing * mean)
                for family in (COMPRESSION, TENSION)]
    begin, end, value, block = (np.concatenate(part) for part in zip(*families))
    return begin, end, np.full(len(value), 0.06 * mean), value, block
