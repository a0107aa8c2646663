"""The forces in a packing as a linear program, as a user without this program
would state it.

Forces are divided by the largest load on a cell, so that the tolerances of the
solvers, which are absolute, mean the same in every packing. There are no
supports; cell 0 is left out, since it is balanced if all others are. Variables
and rows are in the order of cells and interfaces.

The forms:

- "motion" is the paper's problem, with v_e for the sliding: minimise
  sum_e s_e |e| v_e - sum_c F_c . u_c subject to [u]_e . n_e >= 0,
  v_e - [u]_e . t_e >= 0, v_e + [u]_e . t_e >= 0. The multipliers of the rows of
  e are p_e and the two parts of q_e.
- "forces" is its dual: p_e >= 0 and |q_e| <= s_e |e| with which each cell is
  balanced, and nothing to minimise.
- "least pressure" minimises sum_e p_e under these conditions.

There is always a solution, u = 0, in the scenes that they are given.
"""
import dataclasses

import numpy as np
import scipy.sparse as sp

FORMS = ("motion", "forces", "least pressure")


@dataclasses.dataclass
class LinearProgram:
    """Minimise cost . x where lower <= x <= upper and matrix x = right, or
    matrix x >= right if not `equal`."""
    cost: np.ndarray
    matrix: sp.csc_matrix
    equal: bool
    right: np.ndarray
    lower: np.ndarray
    upper: np.ndarray


def balance(joints, direction):
    """The matrix from forces along a direction on cell_minus to the sums of
    the forces on all cells but the first."""
    n_joints, n_cells = len(direction), len(joints["load"])
    rows, values = [], []
    for cell, sign in ((joints["minus"], 1.), (joints["plus"], -1.)):
        for i in range(2):
            rows.append(2 * cell + i)
            values.append(sign * direction[:, i])
    columns = np.tile(np.arange(n_joints), 4)
    whole = sp.csr_matrix(
        (np.concatenate(values), (np.concatenate(rows), columns)),
        shape=(2 * n_cells, n_joints))
    return whole[2:]


def linear_program(joints, form):
    """The LinearProgram of one of FORMS from arrays by name: `minus`, `plus`,
    `normal` (n, 2), `capacity` s_e |e| and `load` (cells, 2)."""
    normal = joints["normal"]
    push = -balance(joints, normal)
    drag = balance(joints, np.stack([-normal[:, 1], normal[:, 0]], axis=1))
    capacity, load = joints["capacity"], joints["load"][1:].ravel()
    zero, infinite = np.zeros(len(capacity)), np.full(len(capacity), np.inf)
    if form != "motion":
        cost = np.ones_like(zero) if form == "least pressure" else zero
        return LinearProgram(
            np.concatenate([cost, zero]), sp.hstack([push, drag], "csc"), True,
            -load, np.concatenate([zero, -capacity]),
            np.concatenate([infinite, capacity]))
    one = sp.identity(len(zero))
    free = np.full(len(load), np.inf)
    return LinearProgram(
        np.concatenate([-load, capacity]),
        sp.bmat([[push.T, None], [drag.T, one], [-drag.T, one]], "csc"),
        False, np.zeros(3 * len(zero)), -np.concatenate([free, infinite]),
        np.concatenate([free, infinite]))


def forces(form, x, multipliers):
    """p and q from the solution of a form and the multipliers of its rows,
    those of rows >= being positive."""
    if form != "motion":
        return np.split(x, 2)
    contact, forward, backward = np.split(multipliers, 3)
    return contact, forward - backward
