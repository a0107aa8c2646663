"""What the tables begin with, compared with parameters.prm where that has numbers.

Blocks, joints, loads and strengths are in the tables as the program understood them. What is given
by formulas, names or places is not compared.
"""
import math

from proof.arithmetic import ZERO, cross, dot, minus, plus, size_of, times
from proof.forces import SAME
from proof.tables import check_near, numbers, xyz

OF_DRAWINGS = 1e-2  # the gap of the sides of a block, over their length, in drawings and models


def normals_and_extents(results, structure):
    """Those of the joints and free sides of each block, outwards, with their middles."""
    of_space = results.in_space
    for row in results.rows + results.boundary:
        normal = row.vector(["nx", "ny", "nz"] if of_space else ["nx", "ny"])
        cells = (int(row.text("cell")),) if "cell" in row else row.cells()
        if of_space:
            middle, extent = row.vector("xyz"), row["area"]
        else:
            middle, extent = check_side(structure, cells, normal, row), row["length"]
        for c, sign in zip(cells, (1., -1.)):
            if not structure.blocks[c].fixed:
                yield c, times(sign, normal), extent, middle


def check_side(structure, cells, normal, row):
    """The middle of a side in the plane, whose branch vector leads to it or to the other block."""
    start, end = row.vector(["x0", "y0"]), row.vector(["x1", "y1"])
    middle = times(0.5, plus(start, end))
    there = middle if structure.blocks[cells[-1]].fixed or len(cells) == 1 else \
        structure.blocks[cells[1]].place
    size = row["length"] + size_of(start)
    along = cross((0., 0., 1.), normal)
    check_near("a side", minus(end, start), times(row["length"], along), size)
    check_near("a branch vector", minus(there, structure.blocks[cells[0]].place),
               row.vector(["branch_x", "branch_y"]), size)
    return middle


def sides(proof):
    """
    They close, so that no joint is missing, and have the area or volume of their block inside.
    Those of drawings match to a tolerance, and may have joints of some width between them.
    """
    results, structure = proof.results, proof.structure
    left, length, inside = ({c: zero for c, block in structure.blocks.items() if not block.fixed}
                            for zero in (ZERO, 0., 0.))
    for c, normal, extent, middle in normals_and_extents(results, structure):
        left[c], length[c] = plus(left[c], normal, extent), length[c] + extent
        arm = minus(middle, structure.blocks[c].place)
        inside[c] += dot(arm, normal) * extent / (3. if results.in_space else 2.)
    proof.gap = max(size_of(left[c]) / length[c] for c in left if length[c] > 0.)
    is_drawn = results.entries["Packing/Generator"] in ("polygons", "model")
    proof.expect(proof.gap <= (OF_DRAWINGS if is_drawn else SAME),
                 f"the sides of a block do not close by {proof.gap:.1e} of their length")
    for c, found in inside.items():
        said = results.cells[c]["volume" if results.in_space else "area"]
        proof.expect(is_drawn or abs(found - said) <= SAME * said,
                     f"block {c} has another area or volume")


def loads_of(results):
    """The shares of both sections in the loads of the tables."""
    if not results.factor:
        return {"Loads": 1., "Live loads": 0.}
    carried = results.factor.get("forces_at") or results.factor["carried"]
    of = results.entries["Load factor/Factor"] if "load_factor" in results.summary else "live loads"
    return {"Loads": carried if of == "all loads" else 1.,
            "Live loads": 1. if of == "strength" else carried}


def body_force(entries, section):
    """That of all blocks; None if it is a formula, or if other forces act inside blocks."""
    others = [entries.get(f"{section}/{other}") for other in
              ("Group body forces", "Cell forces", "Combination", "Vehicle/Axles")]
    if any(others) or entries.get(f"{section}/Earthquake/Pattern", "none") != "none" or \
            any(name.startswith("Fill/") for name in entries):
        return None
    return numbers(entries[f"{section}/Body force"])


def weight(results):
    """The force of all loads inside blocks over their area or volume; None if it is not even."""
    found = ZERO
    for section, share in loads_of(results).items():
        body = body_force(results.entries, section)
        if share and body is None:
            return None
        found = plus(found, body, share) if share else found
    return found


def is_bare(entries, section):
    """Nothing acts on free sides."""
    of_sides = [entries[f"{section}/Traction"], entries.get(f"{section}/Segment tractions", "")] \
        if entries[f"{section}/Boundary load"] == "traction" else [entries[f"{section}/Stress"]]
    return not any(text.strip("0.;, ") for text in of_sides)


def check_loads(proof, what, load, weight_of_all):
    """Of each block."""
    size = max(max(map(size_of, load.values())),
               max(size_of(block.load) for block in proof.structure.blocks.values()))
    for k, row in enumerate(proof.results.cells):
        if not proof.structure.blocks[k].fixed:
            extent = row["volume" if proof.results.in_space else "area"]
            proof.near(f"{what} of block {k}", load[k], list(times(extent, weight_of_all)), size)
    proof.given.append(what)


def loads(proof):
    """The load of a block is what acts on its free sides, and its weight."""
    results, structure = proof.results, proof.structure
    of_all, load = weight(results), {c: block.load for c, block in structure.blocks.items()}
    for row in results.boundary:
        c = int(row.text("cell"))
        load[c] = minus(load[c], row.vector(xyz("force"), False) if results.in_space else
                        row.vector(["force_x", "force_y"]))
    if of_all is not None:
        check_loads(proof, "loads", load, of_all)


def parts_of_loads(proof):
    """The dead and the live loads of a factor, where they are weights alone."""
    entries, blocks = proof.results.entries, proof.structure.blocks
    all_live = loads_of(proof.results)["Loads"] != 1.
    live = {c: block.live_load for c, block in blocks.items()}
    dead = {c: plus(block.load, block.live_load, -proof.results.factor["carried"])
            for c, block in blocks.items()}
    for what, load, sections in (
            ("dead loads", dead, [] if all_live else ["Loads"]),
            ("live loads", live, ["Loads", "Live loads"] if all_live else ["Live loads"])):
        bodies = [body_force(entries, name) if is_bare(entries, name) else None
                  for name in sections]
        if None not in bodies:
            check_loads(proof, what, load, tuple(map(sum, zip(ZERO, *bodies))))


def strengths(proof):
    """Those of all joints, over a factor of strength."""
    entries, factor = proof.results.entries, proof.results.factor
    divisor = factor["carried"] if entries.get("Load factor/Factor") == "strength" and \
        "load_factor" in proof.summary and factor["carried"] else 1.
    law = entries["Friction/Law"]
    kinds = [("Friction/Strength", "strength", divisor)] if law == "Tresca" else \
        [("Friction/Cohesion", "strength", divisor),
         ("Friction/Friction angle" if law == "Mohr-Coulomb" else "Friction/Coefficient",
          "coefficient", divisor)]
    kinds += [("Contact/Tensile strength", "tensile_strength", 1.),
              ("Contact/Compressive strength", "compressive_strength", 1.)]
    for entry, column, over in kinds:
        section, name = entry.lower().split("/")
        plural = name[:-1] + "ies" if name.endswith("y") else name + "s"
        value = numbers(entries.get(entry, ""))
        if value is None or math.isinf(value[0]) or column not in proof.results.rows[0] or \
                entries.get(f"{section.capitalize()}/Pair {plural}"):
            continue
        of_all = math.tan(math.radians(value[0])) if name == "friction angle" else value[0]
        for row in proof.results.rows:
            proof.near(column, row[column] * over, of_all, abs(of_all))
        proof.given.append(name)


def supports(proof):
    """They move as they are told to, where that is the same for all."""
    of = proof.results.displacement
    if of and not proof.results.in_space:
        for joint, _ in proof.joints():
            for point in joint.points if joint.blocks[1] < 0 else ():
                arm = minus(point.places[0], joint.points[2].places[0])
                told = plus((of[0], of[1], 0.), cross((0., 0., of[2]), arm))
                proof.near("the displacement of a support", point.ground, list(told), size_of(of))
    if of:
        proof.given.append("displacement of supports")
