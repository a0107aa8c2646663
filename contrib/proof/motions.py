"""What motions of blocks prove: collapses, bounds of factors, and settlements."""
import math
from dataclasses import replace

from proof.arithmetic import ZERO, Block, Point, cross, dot, plus, size_of
from proof.forces import BALANCE, SAME
from proof.tables import numbers, xyz

CLOSING = 1e-12  # the largest closing of joints, over the largest displacement
FACTOR = 1e-12  # the difference of a factor from the summary's, over the factor,
WIDTH = 1e-2  # and over the distance of both bounds besides
FRICTIONLESS = 1e6 * (1. - SAME)  # the ratio of work to dissipation from which on it is null
JUMP = 1e-6  # the opening or sliding, over the largest displacement, that counts as one
PAIR = 1e-3  # the distance of the two factors of a collapse without dilatancy, over the bound


def jumps(proof):
    """The tables have the jumps of the motion, and what joints and ties take out of it."""
    structure, results, largest = proof.structure, proof.results, proof.structure.largest()
    force = largest * proof.reference
    for joint, row in proof.joints(results.moved):
        of = [(point, jump) for point, jump in zip(joint.points, joint.jumps(structure.blocks))]
        opens = [dot(jump, point.normal) for point, jump in of if point.presses()]
        if results.in_space:
            if row["support"] and results.moves and not results.displacement:
                continue
            slides = [point.sliding(jump) for point, jump in of if point.presses()]
            # Where joints crush the points of pressure are within the face.
            found = {"opening": min(opens), "sliding": max(slides)}
            if math.isfinite(joint.points[0].crushing):
                found = {"opening": min(min(opens), row["opening"]),
                         "sliding": max(max(slides), row["sliding"])}
        else:
            along = cross((0., 0., 1.), joint.points[2].normal)
            found = {"opening": sum(opens) / 2., "sliding": dot(of[2][1], along)}
            if results.turns:
                found.update({"opening_0": opens[0], "opening_1": opens[1]})
            taken = joint.resistance(structure.blocks)[1]
            proof.near("dissipation", taken, row["dissipation"], abs(taken) + force)
        for name, value in found.items():
            proof.near(name, value, row[name], largest)
    for joint, row in zip(structure.joints[len(results.rows):], results.moved_links):
        longer = dot(joint.jumps(structure.blocks)[0], joint.points[0].normal)
        taken = joint.resistance(structure.blocks)[1] - joint.points[0].rest() * longer
        proof.near("elongation", longer, row["elongation"], largest)
        proof.near("dissipation of a tie", taken, row["dissipation"], abs(taken) + force)


def closes(proof, structure, said):
    """By how much joints close, which is rounding, and the work that they take of the motion."""
    closing, taken = structure.resistance()
    proof.expect(closing <= CLOSING, f"joints close by {closing:.1e}")
    proof.near("closing_violation", closing, said.get("closing_violation", closing), 1., CLOSING)
    return closing, taken


def collapse(proof):
    """The loads do more work than joints and ties can take out of the motion."""
    structure, of = proof.structure, proof.summary["mechanism"]
    closing, taken = closes(proof, structure, of)
    rest, work, said = structure.work_of_rest(), structure.work(), of["work_over_dissipation"]
    ratio = (work + rest) / (taken + rest) if taken + rest > 0. else math.inf * (work + rest)
    proof.words.append(f"collapse: closing {closing:.1e}, work over dissipation {ratio:.12g}")
    proof.expect(ratio > 1., "the loads do no more work than joints take")
    proof.expect(ratio > FRICTIONLESS if said is None else abs(ratio - said) <= SAME * ratio,
                 f"work over dissipation is not {said}")
    if "work_of_loads" in of:
        parts = [part["work"] for part in of["work_of_loads"]]
        proof.near("the work of the loads", sum(parts), work, sum(map(abs, parts)))


def bound_of_factor(proof, structure):
    """What joints take beyond the work of the loads at the factor, over that of the live loads."""
    of = proof.results.factor
    closing, taken = closes(proof, structure, of.get("own_collapse", of))
    live = structure.work("live_load", "live_torque")
    is_least = proof.results.entries["Load factor/Direction"] == "least"
    proof.expect((live < 0.) == is_least, "the live loads do work of the wrong sign")
    return closing, of["carried"] + (taken - structure.work()) / live if live else math.inf


def is_bound(proof, found, said):
    """A bound is what the summary says, to rounding and to a part of its distance."""
    carried = proof.results.factor["carried"]
    proof.expect(abs(found - said) <= FACTOR * max(abs(found), abs(carried)) +
                 WIDTH * abs(said - carried), f"the bound is not {said}")


def factor(proof):
    """By the motion no factor beyond the bound is carried."""
    of = proof.results.factor
    closing, bound = bound_of_factor(proof, proof.structure)
    what = "state at {} and collapse at {}" if proof.results.law == "Coulomb" else \
        "factor between {} and {}"
    proof.words.append(what.format(f"{of['carried']:.12g}", f"{bound:.12g}") +
                       f", closing {closing:.1e}")
    is_bound(proof, bound, of["bound"])


def pair_without_dilatancy(proof):
    """
    The motion bounds the factor for friction with the pressures of these forces by that of the
    forces: what is between is the work of pressure where joints open, and that of friction which
    is not used up, or not against the sliding.
    """
    of = proof.results.factor
    closing, own = bound_of_factor(proof, proof.structure.changed(Point.with_own_friction))
    proof.words.append(f"collapse without dilatancy at {of['carried']:.12g}, by its own motion at "
                       f"{own:.12g}, closing {closing:.1e}; the bound {of['bound']:.12g} is not "
                       "proven")
    is_bound(proof, own, of["own_collapse"]["factor"])
    proof.expect(abs(own - of["carried"]) <= PAIR * abs(of["bound"]) and
                 of["carried"] in of["tried"]["with_state"],
                 "forces and motion do not belong to each other")


def strength_factor(proof):
    """With strengths over the bound, a share of those in the files, the loads are not carried."""
    of = proof.results.factor
    structure = proof.structure.changed(lambda point: point.with_share(of["carried"] / of["bound"]))
    closing, taken = closes(proof, structure, of)
    ratio = structure.work() / taken if taken > 0. else math.inf
    proof.words.append(f"collapse with strengths over {of['bound']:.12g}: closing {closing:.1e}, "
                       f"work over dissipation {ratio:.12g}")
    proof.expect(ratio > 1. - CLOSING, "the loads do no more work than joints take")


def width(proof):
    """What the summary says of a factor fits together; without a bound there is none to prove."""
    of = proof.summary["load_factor"]
    proof.expect(of["unbounded"] == (of["carried"] is None), "a factor is carried and unbounded")
    if of["bound"] is None:
        proof.words.append("that any factor is carried is not proven" if of["unbounded"] else
                           "a factor without a bound")
    elif max(abs(of["carried"]), abs(of["bound"])) > SAME:
        size = max(abs(of["carried"]), abs(of["bound"]))
        proof.near("width", abs(of["carried"] - of["bound"]) / size, of["width"], 1., FACTOR)


def settlement(proof):
    """
    No forces let the ground do more work on the supports than joints take out of the motion beyond
    the work of the loads: what these forces lack of that is the gap, and not negative.
    """
    structure, of = proof.structure, proof.summary["settlement"]
    if proof.results.in_space and not proof.results.displacement:
        proof.words.append("the work of a settlement is not proven: the supports move by a formula")
        return
    closing, taken = closes(proof, structure, of)
    work, size = structure.work_of_ground(), proof.reference * structure.largest()
    gap = taken - structure.work() - work
    proof.words.append(f"settlement: work {work:.12g}, gap {gap:.1e}, closing {closing:.1e}")
    proof.near("the work of the ground", work, of["work"], size)
    proof.near("the gap", gap, of["width"], size)
    proof.expect(gap >= -SAME * size, "the work of the ground is more than the motion allows")
    moves = max(size_of(point.ground) for _, point in structure.points())
    proof.near("the largest displacement", moves, of["largest_displacement"], moves)
    jumps_of = [[(dot(jump, point.normal), point.sliding(jump)) for point, jump in
                 zip(joint.points, joint.jumps(structure.blocks)) if point.presses()]
                for joint, _ in proof.joints()]
    opens = [[opening > JUMP * moves for opening, _ in joint] for joint in jumps_of]
    slides = [any(sliding > JUMP * moves for _, sliding in joint) for joint in jumps_of]
    for name, found in (("open", sum(map(all, opens))), ("sliding", sum(slides)),
                        ("hinges", sum(any(joint) and not all(joint) for joint in opens))):
        proof.near(name, found, of[name], 1.)


def capacity(proof):
    """At rest it is a factor; of other positions the files have numbers, which must make sense."""
    of, structure = proof.summary["capacity"], proof.structure
    rows, points = proof.results.table("capacity"), of["points"]
    proof.expect(len(rows) == len(points) and all(
        row[name] == value for row, point in zip(rows, points) for name, value in point.items()),
        "capacity.csv is not what the summary has")
    proof.expect(all(a["displacement"] < b["displacement"] for a, b in zip(points, points[1:])),
                 "displacements do not grow")
    for point in points:
        size = FACTOR * abs(points[0]["carried"])
        proof.expect(point["bound"] - point["carried"] >= -size and
                     point["error_of_state"] <= BALANCE, "bounds of a position are no bounds")
        if "support_force" in point:
            force = point["support_force"]
            proof.expect(point["least_support_force"] - force <= SAME * abs(force),
                         "bounds of the force of a support are no bounds")
    if of["ultimate_displacement"] is not None:
        proof.near("the ultimate displacement", points[-1]["displacement"],
                   of["ultimate_displacement"], points[-1]["displacement"])
    if of["participation"] is not None:
        along = numbers(proof.results.entries["Capacity/Direction"], ",")
        dead = [(size_of(plus(block.load, block.live_load, -points[0]["carried"])),
                 dot(block.displacement, along)) for block in structure.blocks.values()]
        first, second = (sum(p * d ** k for p, d in dead) for k in (1, 2))
        proof.near("the participation", first ** 2 / (second * sum(p for p, _ in dead)),
                   of["participation"], 1.)
    proof.words.append(f"{len(points) - 1} more positions are not proven")


def clamping(proof):
    """A motion opens all joints; or pressures balance by themselves, which are known as forces."""
    of, structure, results = proof.summary["clamping"], proof.structure, proof.results
    if of["clamped"] is False:
        blocks = {-1: Block(), **{k: replace(
            structure.blocks[k], displacement=row.vector(xyz("opening_displacement")),
            rotation=row.vector(xyz("opening_rotation"))) for k, row in enumerate(results.cells)}}
        least = min(dot(jump, point.normal) for joint in structure.joints
                    for point, jump in zip(joint.points, joint.jumps(blocks)) if point.presses())
        proof.words.append(f"not clamped: a motion opens all joints by {least:.3g}")
        proof.expect(least > 0., "the motion does not open all joints")
        proof.near("least_opening", least, of["least_opening"], least)
    elif of["clamped"]:
        left = dict.fromkeys(structure.blocks, ZERO)
        for joint, row in proof.joints():
            for c, sign in zip(joint.blocks, (1., -1.)):
                left[c] = plus(left[c], joint.points[0].normal, sign * row["self_stress"])
        error = max(size_of(left[c]) for c, block in structure.blocks.items() if not block.fixed)
        pressures = [-row["self_stress"] for row in results.rows]
        proof.words.append(f"clamped by forces that balance to {error:.1e}; moments are not proven")
        proof.expect(error <= BALANCE and min(pressures) >= -BALANCE and
                     abs(max(pressures) - 1.) <= SAME and
                     sum(p > BALANCE for p in pressures) == of["self_stress"]["interfaces"],
                     "the pressures do not clamp the packing")
