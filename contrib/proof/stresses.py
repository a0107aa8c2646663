"""The mean stress of a block: force times arm of all that acts on its sides, over its size."""
from proof.arithmetic import cross, dot, minus, plus, size_of, times
from proof.forces import SAME
from proof.inputs import weight
from proof.tables import xyz


def parts(results, structure):
    """All that acts: (block, force, arm)."""
    for joint in structure.joints:
        for point in joint.points:
            along = times(dot(point.force, point.normal), point.normal)
            # In the plane all friction acts at the middle, the last of the points.
            middle = point.places if results.in_space else joint.points[-1].places
            for c, place, centre, sign in zip(joint.blocks, point.places, middle, (1., -1.)):
                of = structure.blocks[c].place
                yield c, times(sign, along), minus(place, of)
                yield c, times(sign, minus(point.force, along)), minus(centre, of)
    for row in results.boundary:
        c = int(row.text("cell"))
        of = structure.blocks[c].place
        if results.in_space:
            yield c, row.vector(xyz("force"), False), minus(row.vector("xyz"), of)
        else:
            middle = times(0.5, plus(row.vector(["x0", "y0"]), row.vector(["x1", "y1"])))
            yield c, row.vector(["force_x", "force_y"]), minus(middle, of)
            # That of a traction which varies.
            yield c, row.vector(["moment_x", "moment_y"]), \
                cross((0., 0., 1.), row.vector(["nx", "ny"]))


def torques(proof):
    """In the plane the residual torque is the skew part of the mean stress, where sides close."""
    if proof.results.in_space or proof.gap > SAME:
        return
    for k, row in enumerate(proof.results.cells):
        size = proof.reference * proof.structure.blocks[k].length
        proof.near("torque", (row["syx"] - row["sxy"]) * row["area"], row["torque"], size)


def mean_stresses(proof):
    """
    An even body force has no part in it about the centroid, which is the centre but in Voronoi
    cells. Other forces inside blocks, tractions that vary along faces in space, and sides that do
    not close leave nothing to compare.
    """
    results, structure = proof.results, proof.structure
    body = weight(results)
    if body is None or proof.gap > SAME or \
            (size_of(body) > 0. and results.entries["Packing/Generator"] == "Voronoi") or \
            (results.in_space and any(size_of(row.vector(xyz("moment"), False)) > 0.
                                      for row in results.boundary)):
        return
    sums, size = {c: [0.] * 9 for c in structure.blocks}, 0.
    for c, force, arm in parts(results, structure):
        sums[c] = [s + f * a for s, (f, a) in zip(sums[c], [(f, a) for f in force for a in arm])]
        size = max(size, size_of(force) * size_of(arm))
    axes, error = "xyz" if results.in_space else "xy", 0.
    for k, row in enumerate(results.cells):
        if not structure.blocks[k].fixed:
            extent = row["volume" if results.in_space else "area"]
            for i, a in enumerate(axes):
                for j, b in enumerate(axes):
                    error = max(error, abs(sums[k][3 * i + j] - extent * row[f"s{a}{b}"]))
    proof.words.append(f"mean stresses {error / (size or 1.):.1e}")
    proof.expect(error <= SAME * size, "a mean stress is not that of the forces on the sides")
