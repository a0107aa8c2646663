#!/usr/bin/python3
"""Give the linear program of a packing to one solver.

    peer.py SOLVER FORM DIRECTORY

reads joints.npz in the directory and leaves the solver's answer there:
answer.npz with the solution `x`, the `multipliers` of the rows, the seconds of
`building` the model and `solving` it, and `iterations`. Clp takes the place of
this process; answer() reads what it leaves. The exit status is not 0 if there
is no answer.
"""
import os
import pathlib
import re
import sys
import time

import numpy as np
import scipy.sparse as sp

from mps import write_mps
from rigid_program import forces, linear_program

NO_ANSWER, NO_MEMORY = 4, 5


def highs(method, crossover=True):
    """HiGHS by SciPy's linprog, with its default tolerances, 1e-7. SciPy has no
    option for the crossover to a basis that follows the interior point."""
    from scipy.optimize import _linprog_highs, linprog
    wrapper = _linprog_highs._highs_wrapper

    def without_crossover(*arguments):
        arguments[-1]["run_crossover"] = False
        return wrapper(*arguments)

    def prepare(program):
        bounds = np.stack([program.lower, program.upper], axis=1)
        rows = ({"A_eq": program.matrix, "b_eq": program.right}
                if program.equal else
                {"A_ub": -program.matrix, "b_ub": -program.right})
        return {"c": program.cost, "bounds": bounds, "method": method, **rows}

    def solve(model):
        if not crossover:
            _linprog_highs._highs_wrapper = without_crossover
        found = linprog(**model)
        if found.status != 0:
            sys.exit(f"{found.message}")
        return found.x, -found.ineqlin.marginals, found.nit

    return prepare, solve


def cvxopt(dense):
    """conelp of cvxopt, with its default tolerances, 1e-7 and 1e-6."""
    import cvxopt as co
    from cvxopt import solvers

    def matrix(entries):
        entries = entries.tocoo()
        made = co.spmatrix(entries.data, entries.row.astype(int),
                           entries.col.astype(int), entries.shape)
        return co.matrix(made) if dense else made

    def prepare(program):
        one = sp.identity(len(program.cost), format="csr")
        below, above = np.isfinite(program.lower), np.isfinite(program.upper)
        parts = [(-one[below], -program.lower[below]),
                 (one[above], program.upper[above])]
        model = {}
        if program.equal:
            model = {"A": matrix(program.matrix), "b": co.matrix(program.right)}
        else:
            parts.insert(0, (-program.matrix, -program.right))
        return {"c": co.matrix(program.cost),
                "G": matrix(sp.vstack([part[0] for part in parts])),
                "h": co.matrix(np.concatenate([part[1] for part in parts])),
                **model}

    def solve(model):
        solvers.options["show_progress"] = False
        found = solvers.lp(**model)
        if found["status"] != "optimal":
            sys.exit(found["status"])
        # The multipliers of >= come first; those of balance are not needed.
        return (np.array(found["x"]).ravel(), np.array(found["z"]).ravel(),
                found["iterations"])

    return prepare, solve


def clp(method, program, directory, building):
    """Write the program as an MPS file and become Clp, with its default
    tolerances, 1e-7; the solution is kept in full precision."""
    write_mps(directory / "model.mps", program)
    np.savez(directory / "answer.npz", building=building())
    os.chdir(directory)
    os.execvp("clp", ["clp", "model.mps", f"-{method}",
                      "-saveSolution", "clp.solution"])


CLP = {"Clp dual simplex": "dualsimplex", "Clp barrier": "barrier"}
SOLVERS = {
    "cvxopt": lambda: cvxopt(dense=False),
    "cvxopt, dense": lambda: cvxopt(dense=True),
    "HiGHS interior point": lambda: highs("highs-ipm"),
    "HiGHS interior point, no crossover":
        lambda: highs("highs-ipm", crossover=False),
    "HiGHS dual simplex": lambda: highs("highs-ds"),
    **CLP}


def answer(directory, form, text):
    """What a solver has found: p, q, the seconds of building and solving, and
    the iterations; `text` is what it printed. None if it has found nothing."""
    found = dict(np.load(directory / "answer.npz"))
    if "x" not in found:
        ended = re.search(
            r"Optimal objective \S+ - (\d+) iterations time ([\d.]+)", text)
        if not ended:
            return None
        found |= {"iterations": int(ended[1]), "solving": float(ended[2]),
                  **clp_solution(directory / "clp.solution")}
    p, q = forces(form, found["x"], found["multipliers"])
    return p, q, {name: float(found[name])
                  for name in ("building", "solving", "iterations")}


def clp_solution(path):
    """The solution that Clp saves: the numbers of rows and columns, the
    objective, and of rows and columns each their values and multipliers."""
    raw = path.read_bytes()
    n_rows, n_columns = np.frombuffer(raw, np.int32, 2)
    values = np.frombuffer(raw, float, -1, 16)
    return {"x": values[2 * n_rows:2 * n_rows + n_columns],
            "multipliers": values[n_rows:2 * n_rows]}


def main():
    solver, form, directory = sys.argv[1:]
    directory = pathlib.Path(directory)
    start = time.perf_counter()
    joints = np.load(directory / "joints.npz")
    program = linear_program(joints, form)
    if solver in CLP:
        clp(CLP[solver], program, directory,
            lambda: time.perf_counter() - start)
    prepare, solve = SOLVERS[solver]()
    model = prepare(program)
    built = time.perf_counter()
    x, multipliers, iterations = solve(model)
    solved = time.perf_counter()
    np.savez(directory / "answer.npz", x=x, multipliers=multipliers,
             building=built - start, solving=solved - built,
             iterations=iterations)


if __name__ == "__main__":
    try:
        main()
    except MemoryError:
        print("out of memory", file=sys.stderr)
        sys.exit(NO_MEMORY)
    except (ArithmeticError, ValueError) as error:
        print(error, file=sys.stderr)
        sys.exit(NO_ANSWER)
