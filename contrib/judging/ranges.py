"""The ranges of the forces of one scene, by the program and by HiGHS."""
import numpy

from judging.extremes import Extremes
from judging.small_scenes import SmallJudgement

# Of ends of ranges, over the largest load on a row.
LARGEST_DIFFERENCE = 1e-8
# The same of the couple of a resultant about the end of its range, over the
# length of the joint; and by how much less far it has to get.
LARGEST_COUPLE, CLOSE = 1e-8, 1e-6
# Of a scene so many joints are compared, chosen at random.
MOST_JOINTS = 5


class RangeJudgement(SmallJudgement):
    """The least and the greatest value of forces over all states."""
    question = "ranges"
    extremes_of = Extremes
    largest_difference, largest_couple = LARGEST_DIFFERENCE, LARGEST_COUPLE

    def settings(self):
        method = self.choice.choice(("automatic", "simplex", "interior point"))
        where = self.choice.choice(("1", "1", "abs(ny) > 0.5123"))
        reactions = str(self.scene.supports != "0").lower()
        return ["subsection Ranges", f"set Where = {where}",
                f"set Reactions = {reactions}", f"set Method = {method}", "end"]

    def compare(self, run):
        self.extremes = self.extremes_of(self.programme)
        rows = run.table("interfaces.csv")
        asked = [joint for joint, row in enumerate(rows) if row["p_min"]]
        for joint in self.choice.sample(asked, min(len(asked), MOST_JOINTS)):
            self.compare_joint(run, joint, rows[joint])
        self.compare_reactions(run)

    def function(self):
        """Zero, to be filled in, and a view of it joint by joint."""
        zero = numpy.zeros(self.programme.matrix.shape[1])
        return zero, zero.reshape(len(self.joints), -1)

    def compare_joint(self, run, joint, row):
        """All ends of one interface."""
        n = self.joints.n_contacts
        for symbol, of in (("p", slice(0, n)), ("q", slice(n, n + 1))):
            function, rows = self.function()
            rows[joint, of] = 1.
            self.compare_ends(
                run, function, [float(row[f"{symbol}_{end}"])
                                for end in ("min", "max")],
                f"{symbol} of interface {joint}")
        if row.get("e_min"):
            for end, sign in (("e_min", -1.), ("e_max", 1.)):
                self.compare_place(run, joint, sign, float(row[end]),
                                   f"{end} of interface {joint}")

    def compare_reactions(self, run):
        """Both components of the reaction of each straight support."""
        joints = self.joints
        for of in run.summary["ranges"]["reactions"]:
            start, end = numpy.array(of["from"]), numpy.array(of["to"])
            along = (end - start) / numpy.hypot(*(end - start))
            middle = 0.5 * (joints.start + joints.end) - start
            place = middle @ along
            on_it = (joints.cells[:, 1] < 0) & (place > 0.) & \
                (place < numpy.hypot(*(end - start))) & \
                (numpy.abs(middle @ (-along[1], along[0])) <
                 1e-6 * self.cells.size) & \
                (numpy.abs(joints.tangent @ along) > 1. - 1e-6)
            for i, name in enumerate("xy"):
                function, rows = self.function()
                rows[on_it, :-1] = -joints.normal[on_it, i, None]
                rows[on_it, -1] = joints.tangent[on_it, i]
                ends = [sign * numpy.inf if value is None else value
                        for value, sign in zip(of[name], (-1., 1.))]
                self.compare_ends(run, function, ends,
                                  f"reaction {name} from {start}")

    def compare_ends(self, run, function, ends, name):
        """Both ends of a range."""
        for value, sign in zip(ends, (-1., 1.)):
            self.n_states += 1
            self.judge_end(run, sign * function, sign * value, name)

    def judge_end(self, run, function, value, name):
        """A greatest value."""
        # Relative to themselves where values are large.
        tolerance = self.largest_difference * max(
            1., abs(value) / self.extremes.force
            if numpy.isfinite(value) else 1.)
        away = self.extremes.difference(function, value)
        self.difference = max(self.difference, away or 0.)
        if away is None:
            self.report("doubtful", run, f"HiGHS has no answer on {name}")
        elif not away <= tolerance:
            self.report("fault", run, f"{name}: {value!r}, expected "
                        f"{self.extremes.greatest(function).value!r}")

    def compare_place(self, run, joint, sign, at, name):
        """The end of the places of a resultant: no couple about it, and one
        about a place that is a little less far."""
        self.n_states += 1
        about, rows = self.function()
        rows[joint, :2] = -0.5 - at, 0.5 - at
        couple = self.extremes.greatest(sign * about).value
        less, rows = self.function()
        rows[joint, :2] = -0.5 - (at - sign * CLOSE), 0.5 - (at - sign * CLOSE)
        attained = self.extremes.greatest(sign * less).value
        limit = self.largest_couple * self.extremes.force
        if numpy.isnan(couple + attained):
            self.report("doubtful", run, f"HiGHS has no answer on {name}")
        elif couple > limit or attained < -limit:
            self.report("fault", run, f"{name}: the couple about {at!r} is "
                        f"{couple!r}, about one closer {attained!r}")
