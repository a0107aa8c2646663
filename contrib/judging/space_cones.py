"""The factor of a scene in space by cvxopt: the circles of friction are cones.

A second judge beside the polygons of HiGHS, for small scenes: its systems are
dense, and it ends without an answer in some. Its answers are good to about
1e-7 of the factor.
"""
import cvxopt
import cvxopt.solvers
import numpy

from judging.space import SpaceJudgement

# The forces up to which it is asked, and of its factors the largest error.
MOST_FORCES = 1000
LARGEST_DIFFERENCE = 1e-6
TINY = 1e-11  # of the singular values of equations that are no others
KINDS = {"optimal": "bounded", "primal infeasible": "not carried",
         "dual infeasible": "unbounded"}
OPTIONS = {"show_progress": False, "abstol": 1e-11, "reltol": 1e-10,
           "feastol": 1e-10, "maxiters": 200}


def independent(matrix, right):
    """Equations with orthonormal rows that say the same, and whether they can
    hold at all."""
    u, sigma, v = numpy.linalg.svd(matrix, full_matrices=False)
    n = int((sigma > TINY * sigma[0]).sum())
    projected = u[:, :n].T @ right
    missed = numpy.abs(right - u[:, :n] @ projected).max()
    return v[:n], projected / sigma[:n], missed < 1e-9


def inequalities(programme, n, scale):
    """G and h of G x + s = h with s >= 0 for pressures and in cones of three,
    and how many there are of each."""
    signs = [k for k, least in enumerate(programme.signs) if least == 0.]
    rows = len(signs) + 3 * len(programme.limits)
    g, h = numpy.zeros((rows, n)), numpy.zeros(rows)
    for row, k in enumerate(signs):
        g[row, k] = -1.
    for k, (at, pressure, mu, cap) in enumerate(programme.limits):
        row = len(signs) + 3 * k
        if pressure >= 0:
            g[row, pressure] = -mu
        h[row] = cap / scale
        g[row + 1, at] = g[row + 2, at + 1] = -1.
    return g, h, {"l": len(signs), "q": [3] * len(programme.limits), "s": []}


def solve(programme, dead, live, sense):
    """The kind of the answer and the factor; None without an answer."""
    columns = [programme.reduced(c) for c in programme.columns]
    if len(columns) > MOST_FORCES:
        return None
    matrix = numpy.stack([*columns, programme.reduced(live)], axis=1)
    right = -programme.reduced(dead + programme.offset)
    scale = max(numpy.abs(right).max(), 1e-300)
    rows, values, may_hold = independent(matrix, right / scale)
    if not may_hold:
        return "not carried", numpy.nan
    n = matrix.shape[1]
    g, h, sizes = inequalities(programme, n, scale)
    cost = numpy.zeros(n)
    cost[-1] = -sense
    arguments = [cvxopt.matrix(part) for part in (cost, g, h)]
    equations = [cvxopt.matrix(part) for part in (rows, values)]
    try:
        # Its other ways to solve the systems answer half as often.
        found = cvxopt.solvers.conelp(*arguments, sizes, *equations,
                                      kktsolver="ldl", options=OPTIONS)
    except (ArithmeticError, ValueError):
        return None
    if found["status"] not in KINDS:
        return None
    kind = KINDS[found["status"]]
    return kind, (found["x"][n - 1] * scale if kind == "bounded"
                  else numpy.nan)


class ConeJudgement(SpaceJudgement):
    """Also by cvxopt, where it has an answer."""
    n_asked = n_answered = 0
    largest = 0.

    @classmethod
    def closing_words(cls):
        return (f"cvxopt answers {cls.n_answered} of {cls.n_asked}; the largest "
                f"difference is {cls.largest:.1e}")

    def judge_factor(self, found, kind, factor):
        sense = 1. if self.scene.sense == "greatest" else -1.
        ConeJudgement.n_asked += 1
        answer = solve(self.programme, self.dead, self.live, sense)
        if answer is None:
            return
        ConeJudgement.n_answered += 1
        if answer[0] != kind:
            self.report("fault", found, f"{kind}, where cvxopt has {answer}")
        elif kind == "bounded":
            size = max(abs(factor), 1e-3)
            difference = abs(answer[1] - factor) / size
            ConeJudgement.largest = max(ConeJudgement.largest, difference)
            if difference > LARGEST_DIFFERENCE:
                self.report("fault", found, f"{factor}, where cvxopt has "
                            f"{answer[1]}")
