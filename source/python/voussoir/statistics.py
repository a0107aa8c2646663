# SPDX-License-Identifier: LGPL-2.1-or-later
"""Statistics of the forces in a packing, as those of granular media, by numpy alone.

Each function takes results that have forces, of blocks in the plane or in space, and returns new
numbers; d is 2 or 3. The conventions are those of the results: n_e points from the block c- to c+,
the force f_e of a joint acts on c-, tension is positive, and p_e = -f_e . n_e is its pressure. A
supported side is a joint with the ground. The branch vector b_e runs from the centre of c- to
that of c+, at a support to the middle of the joint. A joint bears if the size of its force is
more than 1e-12 of the largest; what is less is rounding.

    found = voussoir.Scene("prm/homogeneous_compression.prm").solve()
    density, edges = voussoir.statistics.force_distribution(found)
    print(voussoir.statistics.force_fabric(found).deviator)
"""
from typing import NamedTuple

import numpy as np

__all__ = ["Chain", "Fabric", "bearing", "branch_vectors", "chains", "fabric",
           "force_distribution", "force_fabric", "forces", "mean_stress"]

ROUNDING = 1e-12  # of the largest force, as for utilisations


class Fabric(NamedTuple):
    """A fabric tensor with its anisotropy.

    tensor     F, of shape (d, d), symmetric, with the trace 1; if isotropic, 1/d on the diagonal.
    deviator   In the plane F_1 - F_2 of the principal values, half of the coefficient a in the
               density (1 + a cos 2 (theta - theta_0)) / 2 pi of directions; in space
               sqrt(3/2 F' : F') with F' = F - 1/3, so the difference of the principal values where
               two of them are the same.
    direction  The unit vector of the largest principal value, its last component not negative.
    angle      In the plane that of the direction from the x axis, counterclockwise, in radians
               from 0 to below pi; any if the deviator is zero.
    """
    tensor: np.ndarray
    deviator: float
    direction: np.ndarray

    @property
    def angle(self):
        """Of the direction, in radians."""
        return float(np.arctan2(self.direction[1], self.direction[0]) % np.pi)


class Chain(NamedTuple):
    """Strong joints that hang together.

    joints  Their numbers, ascending.
    blocks  The numbers of the blocks that move and that they touch, ascending.
    length  The sum of the lengths of their branch vectors; L.
    """
    joints: np.ndarray
    blocks: np.ndarray
    length: float


def forces(found):
    """The force on c- of each joint, of shape (n, d); S L, in space S L^2."""
    if _in_space(found):
        return found.normal_force[:, None] * found.normals + found.shear_force
    return np.array(found.force)


def bearing(found):
    """Whether each joint bears, of shape (n)."""
    sizes = np.linalg.norm(forces(found), axis=1)
    return sizes > ROUNDING * sizes.max(initial=0.)


def branch_vectors(found):
    """b_e of each joint, of shape (n, d); L."""
    if not _in_space(found):
        return np.array(found.branch)
    return (np.where(found.support[:, None], found.centroids, found.centres[found.cell_plus]) -
            found.centres[found.cell_minus])


def force_distribution(found, bins=20, part="normal"):
    """The probability density P(f) of forces over their mean.

    part is "normal" for the pressures p_e of the joints that press, "tangential" for the sizes
    of the tangential forces or "total" for those of the forces, both of the joints that bear.
    f is such a number over the mean of all of them. bins are a number or edges of f, as of
    numpy.histogram.

    Returns density and edges: density[k] is the share of the joints whose f is from edges[k] to
    edges[k + 1], among those within the edges, over the width of the bin, so that the density
    integrates to 1. The exponential tail of P(f) beyond the mean was seen by Liu et al.,
    Science 269 (1995) 513-515; Radjai et al., Phys. Rev. Lett. 77 (1996) 274-277 have P(f) of
    both components in the plane. Without such forces there is none, a ValueError.
    """
    bears = bearing(found)
    pressure = -found.normal_force
    if part == "normal":
        numbers = pressure[bears & (pressure > 0.)]
    elif part == "tangential":
        along = forces(found) + pressure[:, None] * found.normals
        numbers = np.linalg.norm(along, axis=1)[bears]
    elif part == "total":
        numbers = np.linalg.norm(forces(found), axis=1)[bears]
    else:
        raise ValueError(f"part is {part!r}; 'normal', 'tangential' or 'total' are parts")
    if not numbers.sum() > 0.:
        raise ValueError(f"there are no {part} forces to be distributed")
    return np.histogram(numbers / numbers.mean(), bins=bins, density=True)


def fabric(found, weights=None):
    """The fabric tensor F = sum_e w_e n_e (x) n_e / sum_e w_e of the directions of joints.

    weights are w_e, numbers that are not negative, of shape (n), such as found.lengths or a mask
    of joints; all are 1 if there are none. F does not depend on the direction of n_e.
    Satake, in Deformation and Failure of Granular Materials, Balkema 1982, 63-68; Oda, Soils and
    Foundations 22 (4) (1982) 96-108. The deviator is half of the coefficient of anisotropy of
    Rothenburg & Bathurst, Geotechnique 39 (1989) 601-614.
    """
    normals = np.asarray(found.normals)
    of_joints = np.ones(len(normals)) if weights is None else np.asarray(weights, float)
    if of_joints.shape != (len(normals),):
        raise ValueError(f"weights has the shape {of_joints.shape}, and there are "
                         f"{len(normals)} joints; give a number for each")
    if not of_joints.min(initial=0.) >= 0. or not 0. < of_joints.sum() < np.inf:
        raise ValueError("weights must be finite and not negative, and not all be zero")
    tensor = np.einsum("e,ei,ej->ij", of_joints, normals, normals) / of_joints.sum()
    d = len(tensor)
    deviatoric = tensor - np.eye(d) / d
    deviator = np.sqrt((2. if d == 2 else 1.5) * (deviatoric**2).sum())
    direction = np.linalg.eigh(tensor)[1][:, -1]
    return Fabric(tensor, float(deviator), direction * (-1. if direction[-1] < 0. else 1.))


def force_fabric(found):
    """The fabric of the directions in which joints press: fabric() with the weights p_e.

    Joints that are pulled have the weight 0. Of a mean stress that the normal forces alone bear,
    between discs of one size, it is the stress over its trace.
    """
    return fabric(found, np.maximum(-found.normal_force, 0.))


def chains(found, threshold=1.):
    """The chains of strong joints, a list of Chain, those with most joints first.

    A joint is strong if the size of its force is more than threshold times the mean of all that
    bear. Two strong joints belong to one chain if they touch the same block, or if a way from
    strong joint to strong joint through blocks leads from one to the other; the ground joins
    none. That forces above and below the mean play different parts is due to Radjai et al.,
    Phys. Rev. Lett. 80 (1998) 61-64. These chains may branch, other than those of Peters et al.,
    Phys. Rev. E 72 (2005) 041307, which follow the stress of blocks.
    """
    sizes = np.linalg.norm(forces(found), axis=1)
    bears = bearing(found)
    mean = sizes[bears].mean() if bears.any() else 0.
    strong = np.flatnonzero(bears & (sizes > threshold * mean))
    sides = np.stack([found.cell_minus, found.cell_plus], axis=1)[strong]
    moves = (sides >= 0) & (sides < found.n_blocks)
    lengths = np.linalg.norm(branch_vectors(found), axis=1)
    found_chains = []
    for members in _connected(sides, moves, found.n_blocks):
        joints = strong[members]
        blocks = np.unique(sides[members][moves[members]])
        found_chains.append(Chain(joints, blocks, float(lengths[joints].sum())))
    return sorted(found_chains, key=lambda chain: (-len(chain.joints), chain.joints[0]))


def mean_stress(found):
    """The mean stress of all blocks from forces and branch vectors, of shape (d, d); S.

    By Love and Weber it is

        sigma_ij = (sum_e f_i b_j + sum_b F_i b_j + sum_b M_i t_j) / V

    over the joints e and the free edges b, in space faces, with the force F of the traction on
    each, its branch vector from the centre of the block to the middle of the edge, in the plane
    its first moment M along the unit vector t of the edge, and the area or volume V of all blocks
    (Love, Treatise on the Mathematical Theory of Elasticity, 1927; Weber, Bulletin de liaison des
    ponts et chaussees 20 (1966) 1-20; Christoffersen, Mehrabadi & Nemat-Nasser, J. Appl. Mech.
    48 (1981) 339-344). Forces on the ground act where they are. It is symmetric where
    torques are balanced. Of a uniform stress on all of the
    boundary it is that stress, whatever the forces are.

    Ties are forces at two places. Forces inside blocks have no part in it: weight would add
    nothing where the centroids are the centres of the results, and forces at places, as those of
    vehicles and fill, would; the stresses of the blocks, whose mean weighed by areas this is
    otherwise, have it all. In space a traction counts as uniform on each face.
    """
    moment = np.einsum("ei,ej->ij", forces(found), branch_vectors(found))
    if _in_space(found):
        moment += _moment_in_space(found)
        return moment / found.volumes[:found.n_blocks].sum()
    moment += _moment_in_plane(found) + _moment_of_links(found)
    return moment / found.areas.sum()


def _in_space(found):
    return found.normals.shape[1] == 3


def _connected(sides, moves, n_blocks):
    """The numbers of joints, of which sides has two blocks each, that hang together."""
    parent = list(range(n_blocks))

    def root(block):
        while parent[block] != block:
            parent[block] = parent[parent[block]]
            block = parent[block]
        return block

    for both in sides[moves.all(axis=1)]:
        parent[root(both[0])] = root(both[1])
    roots = np.array([root(side[move][0]) for side, move in zip(sides, moves)], int)
    return [np.flatnonzero(roots == of) for of in np.unique(roots)]


def _moment_in_plane(found):
    """What the boundary adds, and forces on the ground that are not in the middle."""
    sides = (found.boundary_ends - found.boundary_starts) / found.boundary_lengths[:, None]
    moment = (np.einsum("bi,bj->ij", found.boundary_forces, found.boundary_branches) +
              np.einsum("bi,bj->ij", found.boundary_moments, sides))
    ends = found.end_forces
    if len(ends) == len(found.normals):  # if blocks turn
        ground = found.cell_plus < 0
        half = (ends[ground, 1] - ends[ground, 0])[:, None] / 2.
        moment += np.einsum("ei,ej->ij", half * found.normals[ground],
                            (found.ends - found.starts)[ground])
    return moment


def _moment_of_links(found):
    """What ties and fill add, which are no sides of blocks."""
    centres = found.centres
    moment = np.zeros((2, 2))
    for force, along, c, d, x, y in zip(
            found.link_forces, found.link_directions, found.link_cell_minus,
            found.link_cell_plus, found.link_starts, found.link_ends):
        arm = x - centres[c] - (y - centres[d] if d >= 0 else 0.)
        moment += np.outer(force * along, arm)
    return moment


def _moment_in_space(found):
    """What the boundary adds, and the moments of forces on the ground."""
    moment = np.zeros((3, 3))
    on_ground = found.support[found.point_interface]
    arms = found.points - found.centroids[found.point_interface]
    moment += np.einsum("pi,pj->ij", found.point_forces[on_ground], arms[on_ground])
    if hasattr(found, "boundary_forces"):
        arms = found.boundary_centroids - found.centres[found.boundary_cells]
        moment += np.einsum("bi,bj->ij", found.boundary_forces, arms)
    return moment
