// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/linear/joint_blocks.h>
#include <voussoir/algebra/linear/rotation_complement.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/index_set.h>
#include <deal.II/lac/solver_cg.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace Voussoir
{

namespace
{

/**
 * The residual of the conjugate gradients, relative to the right-hand side,
 * which Newton's refinement squares; and to the largest one since prepare().
 */
constexpr double tolerance_of_complement = 1e-9, least_tolerance = 1e-13;
/**
 * The iterations that take less time than a factorisation of all unknowns
 * would. Regular packings need some 30, uniform stress none, random Voronoi
 * packings under other loads up to 200.
 */
constexpr unsigned int n_max_complement_steps = 50;

} // namespace

RotationComplement::RotationComplement(
    const Structure &structure, std::unique_ptr<LinearMethod> translations)
    : structure(structure), translations(std::move(translations))
{
  Assert(structure.is_plane() && structure.kinematics().turns(),
         dealii::ExcInternalError());
  const unsigned int n_own = structure.n_own_bodies();
  dealii::IndexSet own(structure.processes().sum(n_own));
  own.add_range(structure.first_body(), structure.first_body() + n_own);
  diagonal.get_vector().reinit(own, structure.processes().communicator());
}

bool RotationComplement::prepare(const std::vector<double> &coefficients,
                                 const double new_shift)
{
  shift = new_shift;
  largest_right = 0.;
  const unsigned int n_own = structure.n_own_bodies();
  std::vector<double> stiffness(structure.n_bodies(), shift);
  const JointBlocks all(structure, false);
  JointBlocks::Blocks blocks;
  couplings.resize(structure.joints().size());
  for (unsigned int e = 0; e < couplings.size(); ++e)
  {
    const Structure::Joint &joint = structure.joints()[e];
    all.find(e, coefficients.data(), blocks);
    Coupling &coupling = couplings[e];
    for (unsigned int i = 0; i < 2; ++i)
    {
      coupling.minus[i] = blocks.minus[3 * i + 2];
      coupling.plus[i] = blocks.plus[3 * i + 2];
    }
    coupling.of_minus = blocks.minus[8];
    coupling.of_plus = blocks.plus[8];
    coupling.mixed = blocks.mixed[8];
    stiffness[joint.cell_minus] += coupling.of_minus;
    stiffness[joint.cell_plus] += coupling.of_plus;
  }
  for (unsigned int b = 0; b < n_own; ++b)
    diagonal.get_vector().local_element(b) = 1. / stiffness[b];
  return translations->prepare(coefficients, shift);
}

bool RotationComplement::is_direct() const
{
  return translations->is_direct();
}

void RotationComplement::solve_translations(std::vector<double> &v)
{
  const unsigned int n_own = structure.n_own_bodies();
  std::vector<double> r(2 * n_own);
  for (unsigned int b = 0; b < n_own; ++b)
    for (unsigned int i = 0; i < 2; ++i)
      r[2 * b + i] = v[structure.dof(b, i)];
  r = translations->solve(r, 1);
  for (unsigned int b = 0; b < n_own; ++b)
    for (unsigned int i = 0; i < 2; ++i)
      v[structure.dof(b, i)] = r[2 * b + i];
  structure.update_ghosts(v);
}

void RotationComplement::add_couples(const std::vector<double> &v,
                                     const double factor,
                                     Vector &m) const
{
  const unsigned int n_own = structure.n_own_bodies();
  for (unsigned int e = 0; e < couplings.size(); ++e)
  {
    const Structure::Joint &joint = structure.joints()[e];
    const double *minus = &v[structure.dof(joint.cell_minus, 0)];
    const double *plus = &v[structure.dof(joint.cell_plus, 0)];
    const double x = factor * (plus[0] - minus[0]);
    const double y = factor * (plus[1] - minus[1]);
    const Coupling &c = couplings[e];
    if (joint.cell_plus < n_own)
      m.local_element(joint.cell_plus) += c.plus[0] * x + c.plus[1] * y;
    if (joint.cell_minus < n_own)
      m.local_element(joint.cell_minus) -= c.minus[0] * x + c.minus[1] * y;
  }
}

/** The complement, D - C' L^{-1} C. */
class RotationComplement::Operator
{
public:
  explicit Operator(RotationComplement &of)
      : of(of), forces(of.structure.n_dofs())
  {}

  void vmult(Vector &m, const Vector &theta) const
  {
    turn(theta, m);
    of.solve_translations(forces);
    of.add_couples(forces, -1., m);
  }

  /** D @p theta in @p m. @return C theta, in the place of the translations. */
  std::vector<double> &turn(const Vector &theta, Vector &m) const
  {
    const Structure &structure = of.structure;
    const unsigned int n_own = structure.n_own_bodies();
    std::vector<double> &v = forces;
    for (unsigned int b = 0; b < n_own; ++b)
    {
      v[structure.dof(b, 2)] = theta.local_element(b);
      m.local_element(b) = of.shift * theta.local_element(b);
    }
    structure.update_ghosts(v);
    for (unsigned int b = 0; b < structure.n_bodies(); ++b)
      v[structure.dof(b, 0)] = v[structure.dof(b, 1)] = 0.;
    for (unsigned int e = 0; e < of.couplings.size(); ++e)
    {
      const Structure::Joint &joint = structure.joints()[e];
      double *minus = &v[structure.dof(joint.cell_minus, 0)];
      double *plus = &v[structure.dof(joint.cell_plus, 0)];
      const Coupling &c = of.couplings[e];
      for (unsigned int i = 0; i < 2; ++i)
      {
        const double force = c.plus[i] * plus[2] - c.minus[i] * minus[2];
        plus[i] += force;
        minus[i] -= force;
      }
      if (joint.cell_plus < n_own)
        m.local_element(joint.cell_plus) +=
            c.of_plus * plus[2] + c.mixed * minus[2];
      if (joint.cell_minus < n_own)
        m.local_element(joint.cell_minus) +=
            c.of_minus * minus[2] + c.mixed * plus[2];
    }
    return v;
  }

private:
  RotationComplement &of;
  /** Of one product, where it is not allocated again for the next. */
  mutable std::vector<double> forces;
};

std::vector<double> RotationComplement::solve(const std::vector<double> &r,
                                              const unsigned int n_columns)
{
  AssertDimension(n_columns, 1);
  (void)n_columns;
  const unsigned int n_own = structure.n_own_bodies();
  std::vector<double> u(r);
  u.resize(structure.n_dofs());
  solve_translations(u);
  Vector m, theta;
  m.reinit(diagonal.get_vector());
  theta.reinit(m);
  for (unsigned int b = 0; b < n_own; ++b)
    m.local_element(b) = r[structure.dof(b, 2)];
  add_couples(u, -1., m);

  const double square = std::inner_product(r.begin(), r.end(), r.begin(), 0.);
  const double right = std::sqrt(structure.processes().sum(square));
  largest_right = std::max(largest_right, right);
  dealii::SolverControl control(n_max_complement_steps,
                                std::max(tolerance_of_complement * right,
                                         least_tolerance * largest_right));
  const Operator complement(*this);
  try
  {
    dealii::SolverCG<Vector>(control).solve(complement, theta, m, diagonal);
  }
  catch (const dealii::SolverControl::NoConvergence &)
  {
    return {};
  }
  std::vector<double> &v = complement.turn(theta, m);
  solve_translations(v);
  for (unsigned int b = 0; b < n_own; ++b)
  {
    for (unsigned int i = 0; i < 2; ++i)
      u[structure.dof(b, i)] -= v[structure.dof(b, i)];
    u[structure.dof(b, 2)] = theta.local_element(b);
  }
  u.resize(structure.n_own_dofs());
  return u;
}

} // namespace Voussoir
