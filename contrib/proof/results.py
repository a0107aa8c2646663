"""What a run has written, in the plane or in space, as one structure."""
import json
import math

from proof.arithmetic import (ZERO, Block, Joint, Point, Structure, cross, dot, minus, plus,
                              size_of, times)
from proof.tables import (Unreadable, check_near, check_number, check_same, entries_of, numbers,
                          table, xyz)

# What two tables of blocks, joints and ties must both have.
OF_CELLS = ("id", "x", "y", "load_x", "load_y")
OF_JOINTS = ("cell_minus", "cell_plus", "x0", "y0", "x1", "y1", "nx", "ny", "length", "strength")
OF_LINKS = ("cell_minus", "cell_plus", "x0", "y0", "x1", "y1", "dx", "dy", "least", "most")


class Results:
    """What a run has written into a directory."""

    def __init__(self, directory):
        self.directory = directory
        self.summary = json.loads((directory / "summary.json").read_text(encoding="utf-8"))
        self.entries = entries_of(directory / "parameters.prm")
        self.turns = self.entries["Rotations"] == "true"
        if self.turns != self.summary.get("rotations", False) and "loads" in self.summary:
            raise Unreadable("parameters.prm and the summary differ in whether blocks turn")
        self.collapses = self.summary["status"] == "collapse"
        self.moves = "settlement" in self.summary
        # Of a capacity curve that at rest.
        self.factor = self.summary.get("load_factor") or \
            self.summary.get("capacity", {"points": [{}]})["points"][0]
        self.has_motion = self.collapses or self.moves or self.factor.get("bound") is not None
        self.is_live = bool(self.factor) and self.has_motion and \
            self.entries.get("Load factor/Factor") != "strength"
        self.law = self.summary.get("friction_law", "Tresca")
        self.in_space = self.summary.get("dimension") == 3
        # How all supports move, if that is said in numbers: a displacement and an angle.
        self.displacement = self.moves and not self.entries["Supports/Group displacements"] and \
            numbers(self.entries["Supports/Displacement"])
        self.structure, self.boundary = None, []
        has_tables = self.entries.get("Output/Files", "all") in ("all", "csv") or \
            any(directory.glob("*.csv"))
        if has_tables and self.summary["status"] != "packing":
            if not self.collapses:
                self.boundary = self.table("boundary", "boundary_faces" if self.in_space else
                                           "boundary_edges")
            (self.read_space if self.in_space else self.read_plane)()

    def table(self, name, of=None):
        return table(self.directory / f"{name}.csv", self.summary["packing"][of] if of else None)

    def gives(self, *names):
        """True if an entry of Contact is neither empty nor zero."""
        return any(self.entries.get("Contact/" + name, "").strip("0.") for name in names)

    def limits_of(self, row, extent):
        """Tension, crushing, the coefficient, and what is left of friction at full tension."""
        tension = extent * row.get("tensile_strength", self.gives(
            "Tensile strength", "Pair tensile strengths"))
        crushing = extent * row.wide("compressive_strength", self.gives(
            "Compressive strength", "Pair compressive strengths"))
        mu = row.get("coefficient", self.law != "Tresca")
        return tension, crushing, mu, max(row["strength"] * extent - mu * tension, 0.)

    def read_plane_tables(self):
        """The lines of blocks and joints, and those with a motion, which say the same else."""
        moving, self.moved = [], []
        if self.has_motion:
            moving = self.table("mechanism", "cells")
            self.moved = self.table("mechanism_joints", "interfaces")
        self.cells, self.rows = moving, self.moved
        if not self.collapses:
            self.cells = self.table("cells", "cells")
            self.rows = self.table("interfaces", "interfaces")
        if self.has_motion:
            motion = ("ux", "uy") + ("rotation",) * self.turns
            check_same(self.cells, moving, OF_CELLS + ("load_torque",) * self.turns +
                       motion * self.moves, () if self.moves else motion)
            check_same(self.rows, self.moved, OF_JOINTS)
        return moving or self.cells

    def read_plane(self):
        blocks = {-1: Block()}
        moving = self.read_plane_tables()
        for k, (row, motion) in enumerate(zip(self.cells, moving)):
            check_number(row, k)
            blocks[k] = Block(
                row.vector("xy"), math.sqrt(row.get("area", not self.collapses, 1.)), False,
                row.vector(["load_x", "load_y"]), (0., 0., row.get("load_torque", self.turns)),
                motion.vector(["live_load_x", "live_load_y"], self.is_live),
                (0., 0., motion.get("live_load_torque", self.is_live and self.turns)),
                motion.vector(["ux", "uy"]), (0., 0., motion.get("rotation", self.turns)))
        joints = [self.joint_in_plane(row) for row in self.rows]
        for joint, row in zip(joints, self.moved):
            if self.moves and joint.blocks[1] < 0:
                self.move_support(blocks[joint.blocks[0]], joint, row)
        self.links, self.moved_links = self.link_rows()
        self.structure = Structure(blocks, joints + list(map(self.joint_of_link, self.links)))

    def joint_in_plane(self, row):
        """The ends and the middle, at which what is left of friction at the ends acts."""
        start, end = row.vector(["x0", "y0"]), row.vector(["x1", "y1"])
        normal, length = row.vector(["nx", "ny"]), row["length"]
        along = (-normal[1], normal[0], 0.)
        check_near("a normal", (size_of(normal), 0., 0.), (1., 0., 0.), 1.)
        check_near("an interface", minus(end, start), times(length, along),
                   length + size_of(start))
        tension, crushing, mu, friction = self.limits_of(row, length)
        N, T = (row.get(name, not self.collapses) for name in
                ("normal_force", "tangential_force"))
        ends = [row.get(f"normal_force_{k}", self.turns and not self.collapses, N / 2.)
                for k in (0, 1)]
        bears = [mu * max(tension / 2. - n, 0.) for n in ends]
        share = min(abs(T) / sum(bears), 1.) if sum(bears) > 0. else 0.
        slides = [math.copysign(share * of, T) for of in bears]
        check_near("a normal force", (sum(ends), 0., 0.), (N, 0., 0.), abs(ends[0]) + abs(ends[1]))
        points = [Point((place, place), normal, plus(times(n, normal), times(t, along)),
                        tension / 2., math.inf, mu, 0., 0.5)
                  for place, n, t in zip((start, end), ends, slides)]
        middle = times(0.5, plus(start, end))
        points.append(Point((middle, middle), normal, times(T - sum(slides), along), 0., 0., 0.,
                            friction))
        return Joint(row.cells(), points, tension + crushing)

    def move_support(self, block, joint, row):
        """What the opening and the sliding of a support have beside the motion of its block."""
        for point, name in zip(joint.points, ("opening_0", "opening_1", "opening")):
            along, at = (-point.normal[1], point.normal[0], 0.), block.at(point.places[0])
            opening = row.get(name, self.turns, row["opening"])
            point.ground = plus(times(dot(at, point.normal) + opening, point.normal),
                                times(dot(at, along) + row["sliding"], along))

    def link_rows(self):
        """Those of links.csv and of mechanism_links.csv, where there are any."""
        ties = {name.split("/")[1] for name in self.entries if name.startswith("Ties/")}
        there = "links" in self.summary or ties
        state, moved = (
            self.table(name) if has and (there or (self.directory / f"{name}.csv").exists()) else []
            for name, has in (("links", not self.collapses), ("mechanism_links", self.has_motion)))
        if state and moved:
            check_same(state, moved, OF_LINKS)
        if ties - {row.text("link") for row in state or moved}:
            raise Unreadable("a tie of parameters.prm is missing")
        return state or moved, moved

    def joint_of_link(self, row):
        along, force = row.vector(["dx", "dy"]), row.get("force", not self.collapses)
        places = row.vector(["x0", "y0"]), row.vector(["x1", "y1"])
        between = minus(places[1], places[0])
        check_near("the direction of a tie", times(size_of(between), along), between,
                   size_of(between) + size_of(places[0]))
        check_near("a direction", (size_of(along), 0., 0.), (1., 0., 0.), 1.)
        return Joint(row.cells(), [Point(places, along, times(force, along), row["most"],
                                         -row["least"], 0., 0.)])

    def read_space(self):
        packing = self.summary["packing"]
        self.cells = table(self.directory / "cells.csv", packing["cells"] + packing["fixed_cells"])
        self.rows = self.moved = self.table("interfaces", "interfaces")
        self.links, self.moved_links = [], []
        points = [[] for _ in self.rows]
        for row in self.table("interface_points"):
            points[int(row.text("interface"))].append(row)
        blocks = {-1: Block()}
        for k, row in enumerate(self.cells):
            check_number(row, k)
            blocks[k] = Block(
                row.vector("xyz"), row["volume"] ** (1 / 3), row["fixed"] != 0.,
                *(row.vector(xyz(name), needed) for name, needed in (
                    ("load", True), ("torque", True), ("live_load", self.is_live),
                    ("live_torque", self.is_live), ("displacement", self.has_motion),
                    ("rotation", self.has_motion))))
        joints = [self.joint_in_space(*of) for of in zip(self.rows, points)]
        for joint, row in zip(joints, self.rows):
            for point in joint.points if self.displacement and row["support"] else ():
                arm, angle = minus(point.places[0], row.vector("xyz")), self.displacement[3:]
                point.ground = plus(self.displacement[:3], cross(angle or ZERO, arm))
        self.structure = Structure(blocks, joints)

    def joint_in_space(self, row, points):
        """The vertices, which bear pressure, and the middles of cells of friction."""
        normal, area, place = row.vector(["nx", "ny", "nz"]), row["area"], row.vector("xyz")
        check_near("a normal", (size_of(normal), 0., 0.), (1., 0., 0.), 1.)
        tension, crushing, mu, friction = self.limits_of(row, area)
        found, middle = [], {1.: ZERO, 0.: ZERO}
        for point in points:
            share, presses, at = point["share"], point["pressure"], point.vector("xyz")
            middle[presses] = plus(middle[presses], times(share, at))
            found.append(Point((at, at), normal, point.vector(xyz("force"), not self.collapses), *(
                (share * tension, share * crushing, mu, 0., share) if presses else
                (0., 0., 0., share * friction, share))))
        for mean in middle.values():
            check_near("the middle of the points of an interface", mean, place,
                       size_of(place) + math.sqrt(area))
        return Joint(row.cells(), found)
