"""What forces prove, and sums of them: each function is one statement of a summary."""
import math

from proof.arithmetic import ZERO, cross, dot, minus, plus, size_of, times
from proof.tables import xyz

BALANCE = 1e-9  # the largest error of forces, over the largest load on a block
SAME = 1e-9  # the difference of other numbers that the summary repeats, over their size
PLANE = 1e-6  # the distance of places in one plane, over the size of their coordinates


class Proof:
    """Results, what is proven of them, what was compared with parameters.prm, and what is wrong."""

    def __init__(self, results):
        self.results, self.summary, self.structure = results, results.summary, results.structure
        self.words, self.given, self.faults = [], [], []
        self.reference = max(self.structure.references().values())

    def joints(self, rows=None):
        """The joints that are interfaces, each with its line of a table."""
        return list(zip(self.structure.joints, rows or self.results.rows))

    def expect(self, holds, what):
        if not holds:
            self.faults.append(what)

    def near(self, what, found, said, size, tolerance=SAME):
        """Numbers, or lists of them, are the same."""
        pairs = zip(found, said) if isinstance(said, list) else [(found, said)]
        self.expect(all(abs(a - b) <= tolerance * size for a, b in pairs),
                    f"{what} is {found}, and not {said}")


def forces(proof):
    """They balance the loads within all limits; and the certificate says so."""
    summary, certificate = proof.summary, proof.summary["certificate"]
    balance, moments, limits = proof.structure.errors(proof.results.turns)
    # Friction that is not associated has no theorem: such forces carry the loads, or may not.
    what = "a state without dilatancy" if proof.results.law == "Coulomb" else "carried"
    proof.words.append(f"{what}: balance {max(balance, moments):.1e}, limits {limits:.1e}")
    allowed = BALANCE
    if summary["status"] == "carried to within":
        allowed = max(BALANCE, summary["within"])
    proof.expect(max(balance, moments, limits) <= allowed, "the forces do not carry the loads")
    for name, found in (("equilibrium_residual", balance), ("moment_residual", moments),
                        ("admissibility_violation", limits)):
        proof.near(name, found, certificate.get(name, 0.), 1.)


def resultant(forces_at):
    """The sum of forces and that of their moments about the origin, of pairs (place, force)."""
    force, moment = ZERO, ZERO
    for place, of in forces_at:
        force, moment = plus(force, of), plus(moment, cross(place, of))
    return force, moment


def columns(proof):
    """The tables have the resultants of the forces on joints, and how much of friction they use."""
    size = max(size_of(point.force) for _, point in proof.structure.points())
    largest = 0.
    for joint, row in proof.joints():
        normal = joint.points[0].normal
        force, moment = resultant([(point.places[0], point.force) for point in joint.points])
        along = dot(force, normal)
        shear = plus(force, normal, -along)
        proof.near("normal_force", along, row["normal_force"], size)
        if proof.results.in_space:
            moment = minus(moment, cross(row.vector("xyz"), force))
            columns_in_space(proof, row, shear, moment, size)
        elif size_of(force) > SAME * size:
            columns_in_plane(proof, joint, row, along, size_of(shear))
        bears = sum(point.friction for point in joint.points) + joint.points[0].coefficient * \
            max(sum(point.tension for point in joint.points) - along, 0.)
        if min(size_of(shear), bears) > SAME * size:
            used = size_of(shear) / bears
            proof.near("utilisation", used, row["utilisation"], 1. + used)
        largest = max(largest, row.wide("utilisation"))
    said = proof.summary["certificate"]["max_utilisation"]
    proof.expect(math.isinf(largest) if said is None else abs(said - largest) <= SAME * largest,
                 f"max_utilisation is {largest}, and not {said}")


def columns_in_space(proof, row, shear, moment, size):
    """The resultant of a face, its moment about the centroid, and its place."""
    normal, along = row.vector(["nx", "ny", "nz"]), row["normal_force"]
    extent = math.sqrt(row["area"]) + size_of(row.vector("xyz"))
    proof.near("shear_force", shear, list(row.vector(xyz("shear_force"))), size)
    proof.near("moment", moment, list(row.vector(xyz("moment"))), size * extent)
    if along < -SAME * size:
        place = times(1. / along, cross(normal, moment))
        proof.near("eccentricity", place, list(row.vector(xyz("eccentricity"))),
                   extent * size / -along)


def columns_in_plane(proof, joint, row, along, shear):
    """The place and the angle of a force, and how much of the section it takes."""
    ends = [dot(point.force, point.normal) for point in joint.points[:2]]
    if proof.results.turns and along < -SAME * shear:
        proof.near("eccentricity", (ends[1] - ends[0]) / (2. * along), row["eccentricity"], 1.)
    if proof.results.law != "Tresca":
        proof.near("mobilised_angle", math.degrees(math.atan2(shear, -along)),
                   row["mobilised_angle"], 180.)
    if math.isfinite(joint.section) and abs(along) > SAME * shear:
        # The share u of both strengths with which N^2 = 2 f p of the lesser pressure p.
        u, tension = row["crushing_utilisation"], joint.points[0].tension
        proof.near("crushing_utilisation", (2. * u * tension - along) ** 2,
                   2. * u * joint.section * (u * tension - max(ends)),
                   along ** 2 + (u * tension) ** 2)


def reactions_said(proof, places):
    """Of each support a place, the normal, the force, and its moment about the origin."""
    scale = max(map(size_of, places), default=0.)
    for of in proof.summary.get("reactions", []):
        place, normal, force = of["centroid"], of["normal"], of["reaction"]
        along = dot(force, normal)
        if along < 0.:
            at = plus(place, cross(normal, of["moment"]), 1. / along)
            proof.near("the place of a reaction", at, of["at"], scale * size_of(force) / -along)
        yield place, normal, force, plus(of["moment"], cross(place, force))
    for of in proof.summary.get("ground", {}).get("supports", []):
        start, end, force = ((*of[name], 0.) for name in ("from", "to", "reaction"))
        for place in (start, end):
            proof.expect(min(size_of(minus(place, x)) for x in places) <= PLANE * scale,
                         "a support ends elsewhere")
        along = minus(end, start)
        normal = times(1. / size_of(along), cross(along, (0., 0., 1.)))
        yield start, normal, force, cross((*(of["at"] or of["from"]), 0.), force)


def reactions(proof):
    """In each plane, or on each line, the ground acts on blocks with what the summary says."""
    points = [point for joint, _ in proof.joints() for point in joint.points
              if proof.structure.blocks[joint.blocks[1]].fixed]
    places = [point.places[0] for point in points]
    scale = max(map(size_of, places), default=0.)
    said = list(reactions_said(proof, places))
    proof.expect(bool(said) or not points, "there are no reactions of the supports")
    size = max([size_of(force) for _, _, force, _ in said], default=0.)
    for place, normal, _, _ in said:
        def is_here(other, its_normal):
            return size_of(minus(normal, its_normal)) <= PLANE and \
                abs(dot(minus(other, place), normal)) <= PLANE * scale
        found = resultant([(point.places[0], point.force) for point in points
                           if is_here(point.places[0], point.normal)])
        here = [of for of in said if is_here(of[0], of[1])]
        for k, what in ((0, "a reaction"), (1, "the moment of a reaction")):
            of_summary = [sum(column) for column in zip(*(of[2 + k] for of in here))]
            proof.near(what, found[k], of_summary, size * (scale if k else 1.), 2. * SAME)


def packing(proof):
    """Numbers and sizes of blocks and supports."""
    results, summary, blocks = proof.results, proof.summary, proof.structure.blocks
    said, size = summary["packing"], "volume" if results.in_space else "area"
    supports = [row for joint, row in proof.joints() if blocks[joint.blocks[1]].fixed]
    proof.near("supports", len(supports), said["supports"], 1.)
    if results.in_space:
        proof.expect(sum(row["support"] for row in results.rows) == len(supports) ==
                     sum(row["support"] for row in supports), "other faces are supports")
    for group in said["groups"]:
        found = sum(row.text("group") == group["name"] for row in results.cells)
        proof.near(f"cells of {group['name']}", found, group["cells"], 1.)
    if not results.collapses:
        found = sum(row[size] for k, row in enumerate(results.cells) if not blocks[k].fixed)
        proof.near(size, found, said[size], found)
    if supports and not results.in_space:
        length = sum(row["length"] for row in supports)
        proof.near("length_of_supports", length, summary["loads"]["length_of_supports"], length)
        if "ground" in summary:
            normal = sum(row["normal_force"] for row in supports) / length
            proof.near("mean_normal_stress", normal, summary["ground"]["mean_normal_stress"],
                       abs(normal))


def totals(proof):
    """The sums of loads and of reactions are those in the summary."""
    blocks, summary = proof.structure.blocks, proof.summary
    force, moment = resultant([(block.place, block.load) for block in blocks.values()])
    moment = plus(moment, [sum(x) for x in zip(*(block.torque for block in blocks.values()))])
    size, loads = sum(size_of(block.load) for block in blocks.values()), summary["loads"]
    proof.near("the sum of the loads", force, loads.get("total") or loads["force"], size)
    if "moment_about_origin" in loads:
        scale = max(size_of(block.place) for block in blocks.values())
        proof.near("the moment of the loads", moment, loads["moment_about_origin"], size * scale)
    on_ground, _ = resultant([(point.places[0], point.force) for pair, point in
                              proof.structure.points() if blocks[pair[1]].fixed])
    if "force_on_ground" in summary:
        proof.near("force_on_ground", times(-1., on_ground), summary["force_on_ground"], size)
    if "ground" in summary:
        proof.near("the reaction of the ground", on_ground, summary["ground"]["reaction"], size)
        proof.near("the load on the ground", force, summary["ground"]["load"], size)


def ties(proof):
    """The sums of their forces and bounds by name, and how much of a bound is used."""
    rows, links = proof.results.links, proof.summary["links"]
    proof.expect({row.text("link") for row in rows} == {link["name"] for link in links} and
                 len(rows) == sum(link.get("edges", 1) for link in links), "ties are missing")
    for name in {link["name"] for link in links}:
        for column in ("force", "least", "most"):
            said = [link[column] for link in links if link["name"] == name]
            found = [row[column] for row in rows if row.text("link") == name]
            proof.near(f"{column} of {name}", sum(found), sum(said), sum(map(abs, said)))
    for of, used in [(row, row["utilisation"]) for row in rows] + \
            [(link, link["utilisation"]) for link in links]:
        bound = of["least" if of["force"] < 0. else "most"]
        proof.near("utilisation of a tie", of["force"], used * bound, abs(of["force"]))
