"""The program's proofs, added up again from its files: what forces leave out
of balance, and which factor a mechanism allows."""
import dataclasses

import numpy

from judging.joints import resistance

# Imbalances over the largest load that are rounding of sums.
ROUNDING = 1e-13


@dataclasses.dataclass
class StateProof:
    """Errors of forces, over the largest load on a cell."""
    imbalance: float
    violation: float

    def error(self):
        return max(self.imbalance, self.violation)

    def agrees(self, certificate):
        """Whether the program's certificate has not understated the errors.

        It measures loads and torques a little differently.
        """
        admitted = max(certificate["equilibrium_residual"],
                       certificate["admissibility_violation"],
                       certificate.get("moment_residual", 0.))
        return self.error() < ROUNDING + 5. * admitted


@dataclasses.dataclass
class MechanismProof:
    """The largest factor, and by how much joints close, over the largest
    displacement; the works are for factor one."""
    dissipation: float
    dead_work: float
    live_work: float
    closing: float
    # The largest displacement.
    size: float

    def holds(self):
        return self.closing < 1e-11

    def factor(self):
        return (self.dissipation - self.dead_work) / self.live_work


def written_forces(run, joints):
    """The forces in interfaces.csv."""
    rows = run.table("interfaces.csv")
    names = ["normal_force_0", "normal_force_1"] if joints.rotations \
        else ["normal_force"]
    columns = [numpy.array([float(row[name]) for row in rows])
               for name in [*names, "tangential_force"]]
    return joints.in_order([-column for column in columns[:-1]], columns[-1])


def written_motion(run, programme, table):
    """The displacements and angles in a table of the cells, by rows."""
    keys = ["ux", "uy"] + ["rotation"] * programme.joints.rotations
    motion = numpy.array([[float(row[key]) for key in keys]
                          for row in run.table(table)])
    if programme.joints.rotations:
        motion[:, 2] *= programme.length
    return motion.ravel()


def state_proof(run, programme, loads):
    """Of the forces in interfaces.csv, for these loads in rows."""
    x = numpy.concatenate([written_forces(run, programme.joints),
                           programme.further_forces(run)])
    force = max(numpy.abs(loads).max(), programme.further_load) or 1.
    return StateProof(numpy.abs(programme.matrix @ x + loads).max() / force,
                      programme.violation(x) / force)


def mechanism_proof(run, programme):
    """Of the displacements and angles in mechanism.csv."""
    motion = written_motion(run, programme, "mechanism.csv")
    of_columns = programme.matrix.T @ motion
    n = len(programme.joints) * (programme.joints.n_contacts + 1)
    jumps = of_columns[:n].reshape(len(programme.joints), -1)
    dissipation, closing = resistance(programme.joints, programme.sections,
                                      jumps[:, :-1].T, jumps[:, -1])
    dissipation += programme.further_resistance(of_columns[n:])
    return MechanismProof(dissipation, programme.dead @ motion,
                          programme.live @ motion,
                          closing / numpy.abs(motion).max(),
                          numpy.abs(motion).max())
