"""What forces on blocks and motions of them prove, by arithmetic alone.

A structure is one list of joints between blocks, in the plane as in space: the plane is z = 0.
A joint is contact points. At each of them a force acts on the first of its two blocks, and the
opposite one on the second, with N along the normal from the first to the second, T across it, and

    -crushing <= N <= tension,  |T| <= friction + coefficient * (tension - N).             (1)

The largest work that such forces take out of a jump that opens by o and slides by s is

    friction * s + tension * o + (tension + crushing) * max(coefficient * s - o, 0);       (2)

where nothing crushes the jump must not close, o >= coefficient * s. A tie is a point with a place
on either block, whose normal is along it.
"""
import math
from dataclasses import dataclass, replace

ZERO = (0., 0., 0.)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def plus(a, b, factor=1.):
    return a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]


def minus(a, b):
    return plus(a, b, -1.)


def times(factor, a):
    return factor * a[0], factor * a[1], factor * a[2]


def size_of(a):
    return math.hypot(*a)


@dataclass
class Block:
    """A block, or the ground, which is fixed and takes any force."""
    place: tuple = ZERO
    length: float = 1.  # the root of its area or the cube root of its volume
    fixed: bool = True
    load: tuple = ZERO
    torque: tuple = ZERO
    live_load: tuple = ZERO
    live_torque: tuple = ZERO
    displacement: tuple = ZERO
    rotation: tuple = ZERO

    def at(self, place):
        """The displacement of a point of it."""
        return plus(self.displacement, cross(self.rotation, minus(place, self.place)))


@dataclass
class Point:
    """One place of a joint, on either block, with the limits (1)."""
    places: tuple
    normal: tuple
    force: tuple
    tension: float
    crushing: float
    coefficient: float
    friction: float
    share: float = 1.  # of the joint's stiffness
    ground: tuple = ZERO  # the displacement of a support that moves

    def pressure(self):
        return self.tension - dot(self.force, self.normal)

    def presses(self):
        return self.tension > 0. or self.crushing > 0.

    def sliding(self, of):
        return size_of(plus(of, self.normal, -dot(of, self.normal)))

    def excess(self):
        p = self.pressure()
        return max(0., -p, p - self.tension - self.crushing, self.sliding(self.force) -
                   self.friction - self.coefficient * max(p, 0.))

    def rest(self):
        """The force along the normal that is nearest to zero."""
        return min(max(-self.crushing, 0.), self.tension)

    def with_own_friction(self):
        """With the friction that its own pressure gives it."""
        own = self.friction + self.coefficient * max(self.pressure(), 0.)
        return replace(self, friction=own, coefficient=0.)

    def with_share(self, share):
        """With a share of its strength against sliding."""
        return replace(self, friction=share * self.friction, coefficient=share * self.coefficient)


@dataclass
class Joint:
    """What two blocks, or a block and the ground, have in common."""
    blocks: tuple
    points: list
    section: float = math.inf  # f_t + f_c times its length, where both ends crush together

    def excess(self):
        """How far its forces are beyond (1), or N^2 <= 2 f p_k of a section with N = p_0 + p_1."""
        beyond = max(point.excess() for point in self.points)
        if math.isfinite(self.section):
            ends = [point.pressure() for point in self.points[:2]]
            most = 2. * self.section * max(min(ends), 0.)
            beyond = max(beyond, sum(ends) - most / sum(ends) if sum(ends) > 0. else 0.)
        return beyond

    def jumps(self, blocks):
        """How far the second block goes away from the first at each point."""
        first, second = (blocks[c] for c in self.blocks)
        return [minus(plus(second.at(point.places[1]), point.ground), first.at(point.places[0]))
                for point in self.points]

    def resistance(self, blocks):
        """By how much it closes, and the work (2)."""
        work, closing, closes = 0., 0., []
        for point, jump in zip(self.points, self.jumps(blocks)):
            sliding, opening = point.sliding(jump), dot(jump, point.normal)
            work += point.friction * sliding + point.tension * opening
            closes.append(point.coefficient * sliding - opening)
            if math.isfinite(point.crushing):
                work += (point.tension + point.crushing) * max(closes[-1], 0.)
            else:
                closing = max(closing, closes[-1])
        if math.isinf(self.section):
            return closing, work
        # A stress block, which ends where the joint neither opens nor closes.
        middle, turning = (closes[0] + closes[1]) / 2., abs(closes[0] - closes[1])
        part = min(max(0.5 + middle / turning, 0.), 1.) if turning > 0. else float(middle > 0.)
        return 0., work + self.section * part * (middle + turning * (1. - part) / 2.)


@dataclass
class Structure:
    """Blocks by number, -1 the ground, and what is between them."""
    blocks: dict
    joints: list

    def points(self):
        return [(joint.blocks, point) for joint in self.joints for point in joint.points]

    def changed(self, change):
        return replace(self, joints=[replace(joint, points=list(map(change, joint.points)))
                                     for joint in self.joints])

    def references(self):
        """Of each block the largest load on one of those that it touches, directly or not."""
        group = {c: c for c in self.blocks}

        def first_of(c):
            while group[c] != c:
                group[c] = c = group[group[c]]
            return c
        for joint in self.joints:
            if not any(self.blocks[c].fixed for c in joint.blocks):
                group[first_of(joint.blocks[0])] = first_of(joint.blocks[1])
        load = dict.fromkeys(self.blocks, 0.)
        for c, block in self.blocks.items():
            load[first_of(c)] = max(load[first_of(c)], size_of(block.load),
                                    size_of(block.torque) / block.length)
        for blocks, point in self.points():
            load[first_of(blocks[0])] = max(load[first_of(blocks[0])], abs(point.rest()))
        largest = max(load.values())
        of_forces = max((size_of(point.force) for _, point in self.points()), default=0.)
        return {c: load[first_of(c)] if load[first_of(c)] > 1e-12 * largest
                else largest or of_forces or 1. for c in self.blocks}

    def errors(self, turns):
        """The largest errors of balance, moments and limits, over the reference of a block."""
        force = {c: block.load for c, block in self.blocks.items()}
        torque = {c: block.torque for c, block in self.blocks.items()}
        for blocks, point in self.points():
            for c, place, sign in zip(blocks, point.places, (1., -1.)):
                force[c] = plus(force[c], point.force, sign)
                arm = minus(place, self.blocks[c].place)
                torque[c] = plus(torque[c], cross(arm, point.force), sign)
        size = self.references()
        free = [c for c, block in self.blocks.items() if not block.fixed]
        return (max(size_of(force[c]) / size[c] for c in free),
                max(size_of(torque[c]) / size[c] / self.blocks[c].length for c in free) * turns,
                max((joint.excess() / size[joint.blocks[0]] for joint in self.joints), default=0.))

    def work(self, load="load", torque="torque"):
        """Of the loads on the motion."""
        return sum(dot(getattr(block, load), block.displacement) +
                   dot(getattr(block, torque), block.rotation) for block in self.blocks.values())

    def work_of_ground(self):
        """Of its forces on the blocks, on the displacements of supports."""
        return sum(dot(point.force, point.ground) for _, point in self.points())

    def work_of_rest(self):
        """Of the forces that ties have at least."""
        return -sum(point.rest() * dot(jump, point.normal) for joint in self.joints
                    for point, jump in zip(joint.points, joint.jumps(self.blocks)) if point.rest())

    def largest(self):
        """The largest displacement."""
        return max([size_of(block.displacement) for block in self.blocks.values()] +
                   [size_of(point.ground) for _, point in self.points()]) or 1.

    def resistance(self):
        """By how much joints close, over the largest displacement, and the work (2) of all."""
        found = [joint.resistance(self.blocks) for joint in self.joints]
        closing = max((closing for closing, _ in found), default=0.)
        return closing / self.largest(), sum(work for _, work in found)
