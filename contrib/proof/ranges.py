"""What ranges and samples say of all states, compared with what their files prove.

The files have neither forces nor motions of the ends of ranges. It is checked that this state is
within them, that they are within the limits of joints, and that they fit each other: the force
at each end must be balanced by others on its block, or on the ground, within their ranges.
"""
import math
from collections import defaultdict
from itertools import zip_longest

from proof.arithmetic import ZERO, Structure, cross, dot, plus, times
from proof.forces import BALANCE
from proof.tables import Row, xyz

RANGE = 1e-8  # the distance of forces from their ranges that is none, over the largest load
LARGEST_WIDTH = 1e-3  # the most that proofs of forces which are far above the loads leave open
SPREAD = 1e-6  # the same of standard deviations, over the forces
AXES = (1., 0., 0.), (0., 1., 0.), (0., 0., 1.)


class Range:
    """The least and the greatest component of a force along a vector, and that of this state."""

    def __init__(self, vector, least, most, value):
        self.vector, self.value = vector, value
        self.least = -math.inf if least is None else least
        self.most = math.inf if most is None else most

    def has(self, value, error):
        return self.least - error <= value <= self.most + error

    def times(self, sign):
        """That of the opposite force, with the sign -1."""
        return Range(times(sign, self.vector), self.least, self.most, self.value)

    def along(self, direction):
        """What the force may have along a direction."""
        factor = dot(self.vector, direction)
        ends = factor * self.least, factor * self.most
        return sorted(ends) if abs(factor) > 1e-12 else [0., 0.]


def fit(ranges, load, direction, error):
    """Along a direction each end can be balanced by what the others may have."""
    ends, load = [of.along(direction) for of in ranges], dot(load, direction)

    def is_balanced(mine, k):
        others = sum(of[1 - k] for of in ends if of is not mine)
        return math.isinf(mine[k]) or (-1) ** k * (load + mine[k] + others) >= -error
    return all(is_balanced(mine, k) for mine in ends for k in (0, 1))


def of_interface(row, joint, in_space):
    """The ranges of the force on the first block; none where they were not asked for."""
    normal = joint.points[0].normal
    if in_space:
        columns = [(normal, "normal_force_min", "normal_force_max", "normal_force"),
                   *zip(AXES, xyz("shear_force_min"), xyz("shear_force_max"), xyz("shear_force"))]
        return [Range(vector, row.wide(least), row.wide(most), row[value])
                for vector, least, most, value in columns if row.has(least)]
    if not row.has("p_min"):
        return []
    return [Range(normal, -row.wide("p_max"), -row.wide("p_min"), row["normal_force"]),
            Range(cross(AXES[2], normal), row.wide("q_min"), row.wide("q_max"),
                  row["tangential_force"])]


def check_interface(proof, row, joint, ranges, error):
    """Its ranges are within its limits, and this state within them."""
    tension = sum(point.tension for point in joint.points)
    crushing = min(sum(point.crushing for point in joint.points), joint.section - tension)
    normal, *shear = ranges
    friction = sum(point.friction for point in joint.points) + \
        max(point.coefficient for point in joint.points) * (tension - normal.least)
    proof.expect(all(of.has(of.value, error) for of in ranges),
                 "a force of this state is beyond its range")
    proof.expect(normal.most <= tension + error and normal.least >= -crushing - error and
                 all(max(of.most, -of.least) <= friction + error for of in shear),
                 "a range is beyond the limits of its joint")
    proof.expect(not row["determined"] or max(of.most - of.least for of in ranges) <= 2. * error,
                 "a force that is determined has a range")
    # Where joints crush there are none.
    if proof.results.turns and not proof.results.in_space and math.isinf(joint.section) and \
            row.text("e_min"):
        least, most, here = row["e_min"], row["e_max"], row["eccentricity"]
        proof.expect(-0.5 - RANGE <= least <= most + RANGE <= 0.5 + 2. * RANGE and (
            row["normal_force"] >= -error or least - RANGE <= here <= most + RANGE),
            "an eccentricity is beyond its range")


def interfaces_and_ties(proof, ties, error):
    """The ranges of forces between blocks."""
    structure, of, rows = proof.structure, proof.summary["ranges"], proof.results.rows
    ranges = [of_interface(row, joint, proof.results.in_space) for joint, row in proof.joints()]
    asked = [k for k, found in enumerate(ranges) if found]
    for k in asked:
        check_interface(proof, rows[k], structure.joints[k], ranges[k], error)
    for name, found in (("interfaces", len(asked)),
                        ("determined", sum(rows[k]["determined"] for k in asked)),
                        ("unbounded", sum(any(math.isinf(end.most - end.least) for end in ranges[k])
                                          for k in asked))):
        proof.expect(of[name] == found, f"{name} with ranges are {found:g} and not {of[name]}")
    on_block, whole = defaultdict(list), set(structure.blocks)
    for joint, found in zip_longest(structure.joints, ranges + ties):
        for c, sign in zip(joint.blocks, (1., -1.)):
            on_block[c] += [end.times(sign) for end in found or []]
            whole -= set() if found else {c}
    for c in whole:
        mine, block = on_block[c], structure.blocks[c]
        proof.expect(block.fixed or all(fit(mine, block.load, end.vector, error * (1 + len(mine)))
                                        for end in mine),
                     f"the ranges of forces on block {c} do not fit each other")


def reactions(proof, ties, error):
    """The ranges of the forces of the ground, which carries all loads."""
    structure, summary = proof.structure, proof.summary
    supports = summary["reactions"] if proof.results.in_space else summary["ground"]["supports"]
    ranges = [Range(axis, *of[x], value) for of, here in
              zip(summary["ranges"]["reactions"], supports)
              for x, axis, value in zip("xyz", AXES, here["reaction"])]
    places = ["centroid"] if proof.results.in_space else ["from", "to"]
    proof.expect([[of[place] for place in places] for of in summary["ranges"]["reactions"]] ==
                 [[of[place] for place in places] for of in supports],
                 "ranges of reactions are of other supports")
    proof.expect(all(of.has(of.value, error) for of in ranges),
                 "a reaction of this state is beyond its range")
    for joint, tie in zip_longest(structure.joints[len(proof.results.rows):], ties):
        if structure.blocks[joint.blocks[1]].fixed:
            point = joint.points[0]
            ranges += tie or [Range(point.normal, -point.crushing, point.tension, 0.)]
    load = ZERO
    for block in structure.blocks.values():
        load = plus(load, block.load)
    proof.expect(all(fit(ranges, load, axis, error * (1 + len(ranges))) for axis in AXES),
                 "the ranges of reactions do not fit each other")


def check_ranges(proof):
    """Those of interfaces, of reactions and of ties."""
    structure, of, n = proof.structure, proof.summary["ranges"], len(proof.results.rows)
    width = of["width"] or 0.
    proof.expect(width <= LARGEST_WIDTH, f"ranges that are {width:.1e} wide are not proven")
    error = max(RANGE, width) * proof.reference
    ties = [[Range(joint.points[0].normal, *link["force"], row["force"])] for joint, row, link in
            zip(structure.joints[n:], proof.results.links, of.get("links", []))]
    proof.expect(all(tie.has(tie.value, error) for tie, in ties),
                 "the force of a tie is beyond its range")
    interfaces_and_ties(proof, ties, error)
    if of["reactions"]:
        reactions(proof, ties, error)
    proof.words.append("ranges have this state and fit each other; their ends are not proven")


def check_samples(proof):
    """
    The means of forces that balance, within convex limits, balance within these limits.
    """
    results, structure, of = proof.results, proof.structure, proof.summary["samples"]
    if not of["settled"]:
        proof.words.append("samples that have not settled")
        return
    mean = []
    for joint, row in proof.joints():
        half = -row["p_mean"] / 2.
        mean.append(results.joint_in_plane(Row({
            **row, "normal_force": 2. * half, "tangential_force": row["q_mean"],
            "normal_force_0": half, "normal_force_1": half})))
        for p in "pq":
            middle, deviation = row[f"{p}_mean"], row[f"{p}_deviation"]
            size = abs(middle) + deviation
            proof.expect(0. <= row[f"{p}_mean_error"] <= deviation + SPREAD * size,
                         "the error of a mean is larger than the deviation")
            if row.has(f"{p}_min"):
                # No distribution between two ends has a larger variance.
                most = (row.wide(f"{p}_max") - middle) * (middle - row.wide(f"{p}_min"))
                proof.expect(deviation ** 2 <= most + SPREAD * size ** 2,
                             "a mean or a deviation is beyond the range")
        proof.expect(abs(row["correlation"]) <= 1. + SPREAD, "a correlation is beyond one")
    balance, _, limits = Structure(structure.blocks, mean).errors(False)
    proof.words.append(f"mean of {of['number']} samples: balance {balance:.1e}, "
                       f"limits {limits:.1e}")
    proof.expect(max(balance, limits) <= BALANCE,
                 "the mean of the samples does not carry the loads")
    proof.near("largest_error", max(max(row["p_mean_error"], row["q_mean_error"])
                                    for row in results.rows), of["largest_error"],
               of["largest_error"])
