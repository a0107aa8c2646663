// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_space_space_scene_h
#define voussoir_scene_space_space_scene_h

#include <voussoir/algebra/kinematics.h>
#include <voussoir/contact/face_points.h>
#include <voussoir/contact/strengths.h>
#include <voussoir/packing/polyhedra/packing.h>

#include <deal.II/base/tensor.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace Voussoir
{
struct FaceForces;
struct FaceFunction;
struct SpaceMotion;

/** Blocks in space and what their interfaces carry, in the user's units. */
struct SpaceBlocks
{
  /**
   * @param packing with its supports.
   * @param strengths of its interfaces.
   * @param kinematics of the blocks.
   * @param n_cuts of FacePoints::friction.
   */
  SpaceBlocks(Packing<3> packing,
              Strengths strengths,
              const Kinematics &kinematics,
              unsigned int n_cuts = 1);

  /** The blocks, with their supports. */
  Packing<3> packing;
  /** What the interfaces carry. */
  Strengths strengths;
  /** The motions of the blocks. */
  const Kinematics *kinematics;
  /** Of each interface; see face_points(). */
  std::vector<FacePoints> points;
  /** connected_groups() of the packing, n_cells + 1 numbers. */
  std::vector<unsigned int> group;

  /** s_e, or c_e with Coulomb's friction; S. */
  double strength(const unsigned int e) const
  {
    return strengths.of_interface[e];
  }
  /** mu_e. */
  double coefficient(const unsigned int e) const
  {
    return strengths.coefficient.empty() ? 0. : strengths.coefficient[e];
  }
  /** f_t; S. */
  double tensile(const unsigned int e) const
  {
    return strengths.tensile.empty() ? 0. : strengths.tensile[e];
  }
  /** c_e less what tension takes of it: the largest shear stress at f_t; S. */
  double strength_under_tension(unsigned int e) const;
  /** True if blocks turn, so that moments are balanced. */
  bool turns() const { return kinematics->turns(); }
};

/** The loads on the cells of a packing in space, in the user's units. */
struct SpaceLoads
{
  /** Nothing on that many cells. */
  explicit SpaceLoads(const unsigned int n_cells)
      : force(n_cells), torque(n_cells), first_moment(n_cells),
        size(n_cells, 0.)
  {}
  /** Add the force @p f on @p cell, at @p arm from its centre. */
  void add(unsigned int cell,
           const dealii::Tensor<1, 3> &f,
           const dealii::Tensor<1, 3> &arm);
  /**
   * Add what acts on a free face besides, as far as it is told apart from what
   * acts in the cell.
   *
   * @param face its number among Packing::boundary_faces(), of @p n_faces.
   * @param f its force.
   * @param moment of that about the centroid of the face.
   */
  void add_on_face(unsigned int face,
                   std::size_t n_faces,
                   const dealii::Tensor<1, 3> &f,
                   const dealii::Tensor<1, 3> &moment);
  /** Add @p factor times other loads on the same cells. */
  void add(double factor, const SpaceLoads &others);

  /** F_c, the sum of all; S L^2. */
  std::vector<dealii::Tensor<1, 3>> force;
  /** Their moment about x_c; S L^3. */
  std::vector<dealii::Tensor<1, 3>> torque;
  /** The sum of f (x) (x - x_c) over all forces f; S L^3. */
  std::vector<dealii::Tensor<2, 3>> first_moment;
  /** The sum of their sizes; S L^2. */
  std::vector<double> size;
  /** What acts on a free face, about its centroid. */
  struct OnFace
  {
    /** S L^2. */
    dealii::Tensor<1, 3> force;
    /** S L^3. */
    dealii::Tensor<1, 3> moment;
  };
  /** Of each of Packing::boundary_faces(); empty if no face is loaded. */
  std::vector<OnFace> on_faces;
};

/** Blocks in space under loads. */
struct SpaceScene
{
  /** @{ */
  /** What is found for it, and may be asked of that. */
  using Forces = FaceForces;
  using MotionOfBlocks = SpaceMotion;
  using Function = FaceFunction;
  /** @} */
  /**
   * @throws InputError if the forces on a connected group of cells without
   *   support, or where they turn the moments, are not balanced, or if a load
   *   is too large or too small to compute with.
   */
  SpaceScene(std::shared_ptr<const SpaceBlocks> blocks, SpaceLoads loads);

  /** The blocks, which several scenes may share. */
  std::shared_ptr<const SpaceBlocks> blocks;
  /** What acts on them. */
  SpaceLoads loads;

  /** The packing. */
  const Packing<3> &packing() const { return blocks->packing; }
  /** True if any load acts on a cell. */
  bool is_loaded() const;

private:
  void check_sizes() const;
  void check_balance() const;
};
} // namespace Voussoir

#endif
