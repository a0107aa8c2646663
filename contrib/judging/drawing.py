"""Drawings: a rectangle that is cut again and again into convex polygons,
bricks with mortar between them or without, and arches.

Each cut goes through one polygon only, so that its ends are T-junctions.
"""
import dataclasses
import math

import numpy

from judging.packing import moments_of, number


def dissection(choice, width, height, most):
    """The polygons, 4 or more, of cuts of a rectangle."""
    upright = choice.random() < 0.3
    cells = [numpy.array([(0., 0.), (width, 0.), (width, height),
                          (0., height)])]
    wanted = choice.randint(4, most)
    while len(cells) < wanted:
        areas = [moments_of(cell)[0] for cell in cells]
        k = choice.choices(range(len(cells)), [area**2 for area in areas])[0]
        halves = cut(choice, cells[k], upright)
        if all(thickness_of(half) > 0.2 for half in halves):
            cells[k:k + 1] = halves
    return cells


def cut(choice, polygon, upright):
    """The two parts of a polygon on both sides of a random line."""
    _, centroid = moments_of(polygon)
    spread = numpy.linalg.eigh(numpy.cov((polygon - centroid).T))[1][:, 1]
    normal = spread
    if upright:
        normal = numpy.eye(2)[int(abs(spread[1]) > abs(spread[0]))]
    else:
        angle = choice.uniform(-0.6, 0.6)
        normal = numpy.array(
            (spread[0] * math.cos(angle) - spread[1] * math.sin(angle),
             spread[0] * math.sin(angle) + spread[1] * math.cos(angle)))
    side = (polygon - centroid) @ normal
    side = side - choice.uniform(-0.2, 0.2) * numpy.ptp(side)
    return [half(polygon, side), half(polygon, -side)]


def half(polygon, side):
    """The part of a polygon where the linear form with these values at its
    vertices is not negative."""
    points = []
    for k, (here, there) in enumerate(zip(side, numpy.roll(side, -1))):
        a, b = polygon[k], polygon[(k + 1) % len(polygon)]
        if here >= 0.:
            points.append(a)
        if (here >= 0.) != (there >= 0.):
            # Both halves compute the same point from the same end.
            if here > there:
                a, b, here, there = b, a, there, here
            points.append(a + (b - a) * (here / (here - there)))
    return numpy.array(points)


def rectangle(left, bottom, width, height):
    """An upright one."""
    right, top = left + width, bottom + height
    return numpy.array([(left, bottom), (right, bottom), (right, top),
                        (left, top)])


def running_bond(width, height, courses, bricks):
    """The bricks of a wall without gaps, with halves in each second course."""
    step, rise = width / bricks, height / courses
    polygons = []
    for course in range(courses):
        cuts = [k * step for k in range(bricks + 1)]
        if course % 2:
            cuts = [0., *(cut + 0.5 * step for cut in cuts[:-1]), width]
        polygons += [rectangle(left, course * rise, right - left, rise)
                     for left, right in zip(cuts, cuts[1:])]
    return polygons


def voussoirs(n, thickness):
    """A semicircular arch of radius 1 in its middle."""
    rays = [numpy.array((math.cos(angle), math.sin(angle)))
            for angle in numpy.linspace(0., math.pi, n + 1)]
    inner, outer = 1. - 0.5 * thickness, 1. + 0.5 * thickness
    return [numpy.array((inner * a, outer * a, outer * b, inner * b))
            for a, b in zip(rays, rays[1:])]


@dataclasses.dataclass
class BricksWithGaps:
    """The bricks of a wall, and the width of the joints between them."""
    polygons: list
    gap: float


def bricks_with_gaps(choice, width, height, courses, bricks):
    """A running bond on a rectangle, each brick smaller than its place."""
    step, rise = width / bricks, height / courses
    gap = min(step, rise) * choice.uniform(0.02, 0.15)
    polygons = []
    for course in range(courses):
        cuts = [k * step for k in range(bricks + 1)]
        if course % 2:
            cuts = [0., *(cut + 0.5 * step for cut in cuts[:-1]), width]
        cuts[-1] = width
        for left, right in zip(cuts, cuts[1:]):
            x0 = left + 0.5 * gap * (left > 0.)
            x1 = right - 0.5 * gap * (right < width)
            y0 = course * rise + 0.5 * gap * (course > 0)
            y1 = (course + 1) * rise - 0.5 * gap * (course + 1 < courses)
            polygons.append(numpy.array([(x0, y0), (x1, y0), (x1, y1),
                                         (x0, y1)]))
    return BricksWithGaps(polygons, gap)


def thickness_of(polygon):
    """Four times the area over the square of the diameter."""
    if len(polygon) < 3:
        return 0.
    diameter = max(numpy.hypot(*(a - b)) for a in polygon for b in polygon)
    return 4. * moments_of(polygon)[0] / diameter**2


def wkt_of(polygons):
    """One POLYGON a line."""
    return "".join(
        "POLYGON ((" + ", ".join(f"{number(x)} {number(y)}" for x, y in
                                 [*polygon, polygon[0]]) + "))\n"
        for polygon in polygons)
