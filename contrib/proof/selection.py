"""That a state is the one of least energy of elastic joints, by the displacements in cells.csv.

Of all forces f_i within convex limits C_i that balance the loads, those with the least sum of
|f_i|^2 / (2 k_i) are the ones of which each is the force of C_i nearest to k_i j_i, with the jumps
j_i of some displacements of the blocks: these are the multipliers of the balance. Without dilatancy
the limits of friction are those that the pressures of these forces give.
"""
from collections import defaultdict
from dataclasses import replace

from proof.arithmetic import ZERO, dot, minus, plus, size_of, times
from proof.inputs import normals_and_extents

LEAST = 1e-5  # the distance of forces from those of least energy, over the largest,
SOLVED = 100.  # or in tolerances of the solver


def nearest(point, elastic, part):
    """
    The force without tension and within friction that is nearest to an elastic one, where squares
    along the joint count over `part`, its share of the stiffness.
    """
    along = dot(elastic, point.normal)
    across = times(part, plus(elastic, point.normal, -along))
    slides, mu = size_of(across), point.coefficient
    if not point.presses():
        along = 0.
    elif along > 0. or slides > -mu * along:
        along = -max((mu / part * slides - along) / (1. + mu * mu / part), 0.)
    return plus(times(along, point.normal), across,
                min((point.friction - mu * along) / slides, 1.) if slides > 0. else 0.)


def stiffnesses(results, structure):
    """Of each joint its area or length over the distance of the centres of its blocks from it."""
    if results.in_space:
        return [row["area"] / row["distance"] for row in results.rows]
    round_c, sides = defaultdict(float), defaultdict(list)
    for c, normal, length, middle in normals_and_extents(results, structure):
        round_c[c] += length
        sides[c].append(dot(minus(middle, structure.blocks[c].place), normal))

    def part(c, joint):
        if structure.blocks[c].fixed:
            return 0.
        if min(sides[c]) > 0.:
            arm = minus(joint.points[-1].places[0], structure.blocks[c].place)
            return abs(dot(arm, joint.points[0].normal))
        return 2. * results.cells[c]["area"] / round_c[c]  # not all of it is seen from its centre
    modulus = float(results.entries["Solver/least energy/Modulus"])
    return [modulus * row["length"] / sum(part(c, joint) for c in joint.blocks)
            for joint, row in zip(structure.joints, results.rows)]


def elements(results, joint):
    """Its points; those in the plane with all friction at the middle, where it has a stiffness."""
    if results.in_space:
        return joint.points
    middle, force, friction = joint.points[-1], ZERO, 0.
    ends = []
    for point in joint.points:
        along = times(dot(point.force, point.normal), point.normal)
        force, friction = plus(force, minus(point.force, along)), friction + point.friction
        ends.append(replace(point, force=along, friction=0.))
    return ends[:-1] + [replace(middle, force=force, friction=friction)]


def least_energy(proof):
    """Of joints that neither bear tension nor crush."""
    results, structure, summary = proof.results, proof.structure, proof.summary
    if not summary.get("formulation", "").endswith("least energy") or results.links or \
            "least energy" not in summary["selection"] or \
            {"tensile_strength", "compressive_strength"} & results.rows[0].keys():
        return
    if results.law == "Coulomb":
        structure = structure.changed(lambda point: point.with_own_friction())
    largest, error = 0., 0.
    for joint, stiffness in zip(structure.joints, stiffnesses(results, structure)):
        # In space two kinds of friction share the stiffness along a joint.
        kinds = {point.presses() for point in joint.points
                 if results.in_space and (point.friction or point.coefficient)}
        for point, jump in zip(elements(results, joint), joint.jumps(structure.blocks)):
            elastic = nearest(point, times(stiffness * point.share, jump), 1. / len(kinds or "1"))
            error = max(error, size_of(minus(point.force, elastic)))
            largest = max(largest, size_of(point.force))
    error /= largest or 1.
    proof.words.append(f"least energy {error:.1e}")
    proof.expect(error <= max(LEAST, SOLVED * float(results.entries["Solver/Tolerance"])),
                 "the state is not that of least energy")
