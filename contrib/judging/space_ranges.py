"""The ranges of forces and reactions of one scene in space, by the program and
by HiGHS."""
import numpy

from judging.space import columns
from judging.space_extremes import SpaceExtremes
from judging.space_questions import FurtherJudgement

# Of a scene so many pairs of cells are asked for, and ends compared, each of
# which takes some ten to forty programmes.
MOST_PAIRS, MOST_ENDS = 1, 3


class SpaceRangeJudgement(FurtherJudgement):
    """The least and the greatest value of forces over all states."""
    question = "ranges"
    # Of ends of ranges, over the largest load or themselves.
    largest_difference = 1e-7

    def lines(self):
        b, choice = self.blocks, self.choice
        named = sorted({(c, d) for c, d in zip(b.minus, b.plus)})
        pairs = choice.sample(named, min(len(named), MOST_PAIRS))
        words = [f"cell {c}, " + ("ground" if d < 0 else f"cell {d}")
                 for c, d in pairs]
        self.asked = {e for e in range(len(b.minus))
                      if (b.minus[e], b.plus[e]) in pairs}
        return ["subsection Ranges", "set Joints = " + " | ".join(words),
                f"set Reactions = {str((b.plus < 0).any()).lower()}", "end"]

    def compare(self, run, factor):
        self.judge_forces(run, factor)
        extremes = SpaceExtremes(self.programme, self.loads)
        ends = [*self.ends_of_joints(run), *self.ends_of_reactions(run)]
        for what, value, vectors in self.choice.sample(
                ends, min(len(ends), MOST_ENDS)):
            self.n_states += 1
            self.agree(run, what, value, extremes.greatest(vectors),
                       extremes.force)

    def ends_of(self, what, ends, vectors):
        """Both ends of a range, as greatest values of functions."""
        yield f"greatest {what}", ends[1], vectors
        yield f"minus the least {what}", -ends[0], -vectors

    def ends_of_joints(self, run):
        b = self.blocks
        rows = run.table("interfaces.csv")
        asked = {e for e, row in enumerate(rows) if row["normal_force_min"]}
        if asked != self.asked:
            self.report("fault", run, f"ranges of {asked}, not {self.asked}")
        for e in asked:
            at = (b.joint == e)[:, None]
            n = b.normal[e]
            yield from self.ends_of(
                f"normal force of {e}",
                [float(rows[e][f"normal_force_{end}"])
                 for end in ("min", "max")], at * n)
            for i, axis in enumerate("xyz"):
                ends = [float(rows[e][f"shear_force_{end}_{axis}"])
                        for end in ("min", "max")]
                yield from self.ends_of(
                    f"shear force {axis} of {e}", ends,
                    at * (numpy.eye(3)[i] - n[i] * n))

    def ends_of_reactions(self, run):
        b = self.blocks
        self.middle = columns(run.table("interfaces.csv"), "xyz")
        groups = self.supports()
        for of in run.summary["ranges"]["reactions"]:
            there = [group for group, centre in groups if numpy.abs(
                centre - of["centroid"]).max() < 1e-9 * b.length]
            if len(there) != 1:
                self.report("fault", run, f"no support at {of['centroid']}")
                continue
            at = numpy.isin(b.joint, there[0])[:, None]
            for i, axis in enumerate("xyz"):
                ends = [numpy.inf * sign if end is None else end
                        for sign, end in zip((-1., 1.), of[axis])]
                yield from self.ends_of(
                    f"reaction {axis} of {there[0]}", ends,
                    at * numpy.eye(3)[i])
        if len(run.summary["ranges"]["reactions"]) != len(groups) and \
                len(groups) > 0:
            self.report("fault", run, f"{len(groups)} supports are expected")

    def supports(self):
        """Of each group of supports in a plane the joints and the centroid."""
        b = self.blocks
        on_ground = numpy.nonzero(b.plus < 0)[0]
        middle = self.middle
        touching = {(min(c, d), max(c, d)) for c, d in zip(b.minus, b.plus)}
        group = {e: e for e in on_ground}

        def root(e):
            while group[e] != e:
                e = group[e]
            return e
        for e in on_ground:
            for f in on_ground:
                cells = sorted((b.minus[e], b.minus[f]))
                if numpy.dot(b.normal[e], b.normal[f]) > 1. - 1e-9 and \
                        abs(numpy.dot(b.normal[e], middle[e] - middle[f])) < \
                        1e-9 * b.length and (
                            cells[0] == cells[1] or tuple(cells) in touching):
                    group[root(max(e, f))] = root(min(e, f))
        joined = {}
        for e in on_ground:
            joined.setdefault(root(e), []).append(e)
        return [(of, numpy.average(middle[of], axis=0, weights=b.area[of]))
                for of in joined.values()]
